//! Results as C sees them: contacts, reports, the first contact, geometry, lists of pairs.

use ccd::any::{Candidates, Pairs};
use ccd::{Approach, Contact, ContactGeometry, Hit, Kind, PerKind, Report, State};
use std::ptr::null;

/// Which features touch: `a` and `b` of a contact.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CcdKind {
    /// Vertex `a`, triangle `b`.
    VertexFace = 0,
    /// Edges `a < b`, by the ids of ccd_mesh_edges.
    EdgeEdge = 1,
    /// Vertex `a` of no edge, edge `b` of no triangle: a particle and a rod.
    VertexEdge = 2,
    /// Vertices `a < b` of no edge: two particles.
    VertexVertex = 3,
}

/// How certain a contact is.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CcdState {
    /// Certainly a contact; its time of impact is at most the tolerance early.
    Hit = 0,
    /// Neither certainly a contact nor certainly none, with a minimum distance: treat it as a
    /// contact. There is certainly none before its time of impact.
    Undecided = 1,
}

/// Whether the features of a contact come nearer there.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CcdApproach {
    /// Neither of the others, or not certain.
    Unknown = 0,
    /// Certainly nearer.
    Approaching = 1,
    /// In contact at the start, and certainly apart from then on for a while.
    Separating = 2,
}

/// Two ids.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CcdPair {
    /// The first.
    pub a: u32,
    /// The second.
    pub b: u32,
}

/// An array of pairs.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct CcdPairs {
    /// The first pair; not to be read if there is none.
    pub data: *const CcdPair,
    /// Number of pairs.
    pub count: usize,
}

/// A contact between two features.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct CcdContact {
    /// Time of impact in [0, 1]; never later than the first contact of the two features.
    pub toi: f64,
    /// Which features touch.
    pub kind: CcdKind,
    /// Whether it is certain that they do.
    pub state: CcdState,
    /// Whether they come nearer there.
    pub approach: CcdApproach,
    /// The vertex of a vertex-face or vertex-edge pair; else the lesser edge or vertex.
    pub a: u32,
    /// The triangle or edge that the vertex `a` touches; else the greater edge or vertex.
    pub b: u32,
    /// The vertices: `v f0 f1 f2` of a vertex and a triangle, `ea0 ea1 eb0 eb1` of two edges,
    /// `v e0 e1 e1` and `v w w w` of particles and rods.
    pub vertices: [u32; 4],
}

/// Numbers by kind of pair.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct CcdCounts {
    /// Vertex and triangle.
    pub vertex_face: u64,
    /// Two edges.
    pub edge_edge: u64,
    /// Vertex of no edge and edge of no triangle.
    pub vertex_edge: u64,
    /// Two vertices of no edge.
    pub vertex_vertex: u64,
}

/// What a step found. The library makes it; later versions may have more fields at the end.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct CcdReport {
    /// All contacts, sorted by kind, then a, then b.
    pub contacts: *const CcdContact,
    /// Number of contacts.
    pub contact_count: usize,
    /// Least time of impact; INFINITY without contact.
    pub toi: f64,
    /// Contacts in CCD_STATE_UNDECIDED.
    pub undecided_count: u64,
    /// Contacts by kind.
    pub contacts_by_kind: CcdCounts,
    /// Pairs of features whose swept boxes overlap.
    pub candidates: CcdCounts,
    /// Wall clock of the step in milliseconds.
    pub milliseconds: f64,
}

/// The first contact of a step, and how its features meet. The library makes it; later versions may
/// have more fields at the end.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct CcdHit {
    /// The contact.
    pub contact: CcdContact,
    /// Where its features meet at that time.
    pub geometry: CcdGeometry,
    /// The bodies of its features; both 0 without bodies.
    pub bodies: [u32; 2],
}

/// How two features meet at their time of impact.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct CcdGeometry {
    /// Halfway between the nearest points of the features.
    pub point: [f64; 3],
    /// Unit vector from the second feature towards the first: pushed along it, the first parts.
    pub normal: [f64; 3],
    /// Of each of the vertices, in the nearest point of its feature.
    pub weights: [f64; 4],
    /// Distance of the features.
    pub distance: f64,
}

/// Candidates of a step: pairs of features whose swept boxes overlap, without those that share a
/// vertex or that the bodies rule out. In no order. The library makes it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct CcdCandidates {
    /// Vertex, triangle.
    pub vertex_face: CcdPairs,
    /// Two edges, the lesser id first.
    pub edge_edge: CcdPairs,
    /// A vertex of no edge, an edge of no triangle.
    pub vertex_edge: CcdPairs,
    /// Two vertices of no edge, the lesser id first.
    pub vertex_vertex: CcdPairs,
}

/// Buffers of what a session gives out, kept from call to call.
pub(crate) struct Results {
    contacts: Vec<CcdContact>,
    report: CcdReport,
    hit: Option<CcdHit>,
    geometry: Vec<CcdGeometry>,
    pairs: [Vec<CcdPair>; 4],
    candidates: CcdCandidates,
}

impl CcdPairs {
    pub(crate) const EMPTY: Self = Self { data: null(), count: 0 };

    fn new(pairs: &[CcdPair]) -> Self {
        Self { data: pairs.as_ptr(), count: pairs.len() }
    }
}

impl From<Kind> for CcdKind {
    fn from(kind: Kind) -> Self {
        match kind {
            Kind::VertexFace => Self::VertexFace,
            Kind::EdgeEdge => Self::EdgeEdge,
            Kind::VertexEdge => Self::VertexEdge,
            Kind::VertexVertex => Self::VertexVertex,
        }
    }
}

impl From<State> for CcdState {
    fn from(state: State) -> Self {
        match state {
            State::Hit => Self::Hit,
            State::Undecided => Self::Undecided,
        }
    }
}

impl From<Approach> for CcdApproach {
    fn from(approach: Approach) -> Self {
        match approach {
            Approach::Approaching => Self::Approaching,
            Approach::Separating => Self::Separating,
            _ => Self::Unknown,
        }
    }
}

impl From<PerKind> for CcdCounts {
    fn from(PerKind { vf, ee, ve, vv, .. }: PerKind) -> Self {
        Self { vertex_face: vf, edge_edge: ee, vertex_edge: ve, vertex_vertex: vv }
    }
}

impl From<ContactGeometry> for CcdGeometry {
    fn from(of: ContactGeometry) -> Self {
        let ContactGeometry { point, normal, weights, distance, .. } = of;
        Self { point, normal, weights, distance }
    }
}

impl From<Hit> for CcdHit {
    fn from(hit: Hit) -> Self {
        let Hit { toi, point, normal, weights, distance, bodies, vertices, .. } = hit;
        let [a, b] = hit.features;
        let (kind, state) = (hit.kind.into(), hit.state.into());
        let approach = CcdApproach::Unknown;
        let contact = CcdContact { toi, kind, state, approach, a, b, vertices };
        Self { contact, geometry: CcdGeometry { point, normal, weights, distance }, bodies }
    }
}

impl Results {
    pub fn new() -> Self {
        let none = CcdPairs::EMPTY;
        Self {
            contacts: Vec::new(),
            report: report(&Report::default(), &[]),
            hit: None,
            geometry: Vec::new(),
            pairs: Default::default(),
            candidates: CcdCandidates {
                vertex_face: none,
                edge_edge: none,
                vertex_edge: none,
                vertex_vertex: none,
            },
        }
    }

    /// The report of a step.
    pub fn report(&mut self, of: &Report) -> *const CcdReport {
        let contact = |of: &Contact, vertices| CcdContact {
            toi: of.toi,
            kind: of.kind.into(),
            state: of.state.into(),
            approach: of.approach.into(),
            a: of.a,
            b: of.b,
            vertices,
        };
        let mesh = of.mesh();
        self.contacts.clear();
        self.contacts.extend(of.contacts.iter().map(|of| contact(of, of.vertices(mesh))));
        self.report = report(of, &self.contacts);
        &self.report
    }

    /// The first contact; NULL if there is none.
    pub fn hit(&mut self, hit: Option<Hit>) -> *const CcdHit {
        self.hit = hit.map(CcdHit::from);
        self.hit.as_ref().map_or(null(), std::ptr::from_ref)
    }

    /// Geometry of contacts.
    pub fn geometry(
        &mut self,
        of: impl Iterator<Item = ContactGeometry>,
    ) -> (*const CcdGeometry, usize) {
        self.geometry.clear();
        self.geometry.extend(of.map(CcdGeometry::from));
        (self.geometry.as_ptr(), self.geometry.len())
    }

    /// One list of pairs.
    pub fn pairs(&mut self, of: impl Iterator<Item = [u32; 2]>) -> CcdPairs {
        let [list, ..] = &mut self.pairs;
        list.clear();
        list.extend(of.map(|[a, b]| CcdPair { a, b }));
        CcdPairs::new(list)
    }

    /// Candidates of a step.
    pub fn candidates(&mut self, of: Candidates<'_>) -> *const CcdCandidates {
        let lists: [Pairs; 4] = [of.vf, of.ee, of.ve, of.vv];
        for (to, from) in self.pairs.iter_mut().zip(lists) {
            to.clear();
            to.extend(from.iter().map(|pair| CcdPair { a: pair.a, b: pair.b }));
        }
        let [vertex_face, edge_edge, vertex_edge, vertex_vertex] =
            self.pairs.each_ref().map(|list| CcdPairs::new(list));
        self.candidates = CcdCandidates { vertex_face, edge_edge, vertex_edge, vertex_vertex };
        &self.candidates
    }
}

fn report(of: &Report, contacts: &[CcdContact]) -> CcdReport {
    CcdReport {
        contacts: contacts.as_ptr(),
        contact_count: contacts.len(),
        toi: of.toi.unwrap_or(f64::INFINITY),
        undecided_count: of.undecided,
        contacts_by_kind: of.n_contacts().into(),
        candidates: of.candidates.into(),
        milliseconds: of.times.total,
    }
}
