//! What a step found, and where its time went.

use super::bodies::Bodies;
use super::contact::{Contact, Kind, PerKind, State};
use super::mesh::Mesh;
use alloc::sync::Arc;
use alloc::vec;
use alloc::vec::Vec;

/// Where the time of a step went, in milliseconds of wall clock.
///
/// ```
/// use ccd::Report;
///
/// /// The part of a step that went into deciding pairs.
/// fn deciding(report: &Report) -> f64 {
///     report.times.narrow / report.times.total.max(1e-9)
/// }
/// assert_eq!(deciding(&Report::default()), 0.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Times {
    /// Checking input, boxes, and the table that filters read.
    pub boxes: f64,
    /// Sorting and building trees, or refitting them.
    pub build: f64,
    /// Finding candidates.
    pub traverse: f64,
    /// Deciding them; the work of all threads divided by their number.
    pub narrow: f64,
    /// All of the step.
    pub total: f64,
}

/// How many tests of features come from pairs of triangles, before and after each stage that takes
/// some away. What is left are [`Report::candidates`], whose own boxes overlap, and of these
/// [`Report::filtered`]. The numbers but `separated` are the same on every backend and by every
/// method; where only the earliest time was asked for, a CPU counts its last pass, which may be
/// over a shorter time, a GPU all of the step.
///
/// ```
/// use ccd::method::TriangleCounts;
///
/// let mut counts = TriangleCounts::default();
/// (counts.pairs, counts.represented, counts.orphans) = (4, 20, 2);
/// assert_eq!((counts.all_tests(), counts.box_tests()), (60, 22));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct TriangleCounts {
    /// Pairs of triangles whose swept boxes overlap, of bodies that are looked at.
    pub pairs: u64,
    /// Those of them that were skipped because they share a vertex.
    pub adjacent: u64,
    /// Those of the others that were skipped because both are in a region that certainly does not
    /// touch itself.
    pub free: u64,
    /// Those of the others whose oriented boxes are apart, so that of their candidates, which are
    /// counted, none goes on; by `Volume::Obb` on a CPU.
    pub separated: u64,
    /// Tests of features that all but the skipped ones were expanded to: 15 a pair without
    /// representatives.
    pub represented: u64,
    /// Tests of features that only pairs with a common vertex have: orphans, listed once per mesh.
    pub orphans: u64,
}

impl TriangleCounts {
    /// Tests of features without any culling: 15 for each pair of triangles.
    pub fn all_tests(&self) -> u64 {
        self.pairs * 15
    }

    /// Tests of features whose boxes were compared.
    pub fn box_tests(&self) -> u64 {
        self.represented + self.orphans
    }

    /// Added number by number.
    pub fn plus(self, other: Self) -> Self {
        Self {
            pairs: self.pairs + other.pairs,
            adjacent: self.adjacent + other.adjacent,
            free: self.free + other.free,
            separated: self.separated + other.separated,
            represented: self.represented + other.represented,
            orphans: self.orphans + other.orphans,
        }
    }
}

/// Fronts that a step left: pairs of nodes where its descents ended, with which the next begins.
///
/// ```
/// use ccd::method::FrontCounts;
///
/// let both = FrontCounts::new(100, 90, 1600).plus(FrontCounts::new(50, 0, 800));
/// assert_eq!((both.pairs, both.begun, both.bytes), (150, 90, 2400));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct FrontCounts {
    /// Pairs of nodes that are kept; 0: the next step begins at the roots.
    pub pairs: u64,
    /// Pairs of nodes with which the step itself began; 0: it began at the roots.
    pub begun: u64,
    /// Memory that fronts take.
    pub bytes: u64,
}

impl FrontCounts {
    /// Numbers of pairs kept and begun with, and bytes.
    pub const fn new(pairs: u64, begun: u64, bytes: u64) -> Self {
        Self { pairs, begun, bytes }
    }

    /// Added number by number.
    pub fn plus(self, other: Self) -> Self {
        Self::new(self.pairs + other.pairs, self.begun + other.begun, self.bytes + other.bytes)
    }
}

/// What a step found.
///
/// A report holds on to the mesh of its step, so that what its contacts mean can be looked up while
/// the session is borrowed, and after it has gone on to another mesh.
///
/// ```
/// # use ccd::{Kind, Report};
/// fn wake(report: &Report, mut wake_vertex: impl FnMut(u32)) {
///     for c in &report.contacts {
///         match c.kind {
///             Kind::VertexFace => report.mesh().faces()[c.b as usize].map(&mut wake_vertex),
///             _ => continue,
///         };
///         wake_vertex(c.a);
///     }
/// }
/// # wake(&Report::default(), |_| unreachable!());
/// ```
#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Report {
    /// All contacts, sorted by kind, then `a`, then `b`; empty if only the earliest time was asked
    /// for.
    pub contacts: Vec<Contact>,
    /// Least time of impact; `None` without contact.
    pub toi: Option<f64>,
    /// Pairs of features whose swept boxes overlap. After a search for the earliest time on a CPU,
    /// of vertices in faces and of edges: those that its last pass looked at, which may be over a
    /// shorter time or, where something touches at the start, over a sample.
    pub candidates: PerKind,
    /// Candidates that the filters in `f32` could not reject; after such a search, in the part of
    /// the step that the last pass looked at.
    pub filtered: PerKind,
    /// Contacts in [`State::Undecided`].
    pub undecided: u64,
    /// Pairs of triangles and what they were expanded to; `None` if features were paired at once.
    pub triangles: Option<TriangleCounts>,
    /// The fronts that are kept; `None` if none are.
    pub front: Option<FrontCounts>,
    /// Whether trees were built anew rather than refitted.
    pub rebuilt: bool,
    /// Where the time went.
    pub times: Times,
    #[cfg_attr(feature = "serde", serde(skip))]
    first: Option<Contact>,
    #[cfg_attr(feature = "serde", serde(skip))]
    mesh: Option<Arc<Mesh>>,
}

/// What a report has whose step is not known.
static NO_MESH: Mesh = Mesh::EMPTY;

impl Report {
    /// Takes a contact that comes after all others in their order: keeps it, or only its time and
    /// whether it is the first.
    pub fn add(&mut self, contact: Contact, keep: bool) {
        // Beside a time whose contact is not known, nobody knows which is the first.
        let known = self.first.is_some() || self.toi.is_none();
        let first = self.first.into_iter().chain([contact]).min_by(Contact::by_time);
        self.first = first.filter(|_| known);
        self.toi = Some(self.toi.map_or(contact.toi, |toi| toi.min(contact.toi)));
        if keep {
            self.undecided += (contact.state == State::Undecided) as u64;
            self.contacts.push(contact);
        }
    }

    /// Takes the first contact by time, kind and ids, and its time.
    #[doc(hidden)]
    pub fn begin_with(&mut self, first: Option<Contact>) {
        (self.first, self.toi) = (first, first.map(|first| first.toi));
    }

    /// The contact of the earliest time, the first by kind and ids, if the backend says which it
    /// is. Its time is [`Report::toi`], or that before it was rounded to an `f32`.
    #[doc(hidden)]
    pub fn first(&self) -> Option<&Contact> {
        self.first.as_ref()
    }

    /// The mesh of the step, to which the ids of [`Report::contacts`] refer. One without vertices
    /// if no session made the report, as where it was read as data.
    pub fn mesh(&self) -> &Mesh {
        self.mesh.as_deref().unwrap_or(&NO_MESH)
    }

    /// From now on a report of steps of this mesh.
    #[doc(hidden)]
    pub fn set_mesh(&mut self, mesh: &Arc<Mesh>) {
        self.mesh = Some(mesh.clone());
    }

    /// Empties the report, which keeps its buffer.
    #[doc(hidden)]
    pub fn clear(&mut self) {
        let mut contacts = core::mem::take(&mut self.contacts);
        contacts.clear();
        *self = Self { contacts, ..Self::default() };
    }

    /// The least time of impact in each world of these bodies, those of the step; `None`: no
    /// contact in it. By its number, as many as the greatest one says. Of contacts that are listed:
    /// there are none after [`Session::earliest_toi`](super::session::Session::earliest_toi).
    ///
    /// ```
    /// use ccd::{Bodies, Report};
    ///
    /// let bodies = Bodies::new(&[0, 1]).with_worlds(&[0, 2]);
    /// assert_eq!(Report::default().toi_of_worlds(&bodies), [None; 3]);
    /// ```
    ///
    /// # Panics
    /// If the bodies are those of another mesh.
    pub fn toi_of_worlds(&self, bodies: &Bodies) -> Vec<Option<f64>> {
        let n_worlds = bodies.all().iter().map(|rules| rules.world + 1).max().unwrap_or(0);
        let mut all = vec![None; n_worlds as usize];
        for contact in &self.contacts {
            let world = bodies.world(contact.vertices(self.mesh())[0]);
            let toi = &mut all[world as usize];
            *toi = Some(toi.map_or(contact.toi, |toi: f64| toi.min(contact.toi)));
        }
        all
    }

    /// Contacts by kind.
    pub fn n_contacts(&self) -> PerKind {
        let mut counts = PerKind::default();
        let mut before = 0;
        for kind in Kind::ALL {
            let end = self.contacts.partition_point(|c| c.kind <= kind) as u64;
            *counts.of(kind) = end - before;
            before = end;
        }
        counts
    }
}
