//! A contact between two features: which, how certain, when; and numbers by kind of pair.

use crate::layout::VERTEX_FACE;
use crate::layout::{Pair, Touch, join};
pub use crate::narrow_phase::approach::Approach;
use crate::narrow_phase::query::Verdict;
use crate::narrow_phase::relative_motion::Patch;
use crate::narrow_phase::search::Answer;
use core::cmp::Ordering;

/// Which features touch.
///
/// ```
/// use ccd::Kind;
///
/// // In this order contacts come.
/// assert!(Kind::VertexFace < Kind::EdgeEdge);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Kind {
    /// Vertex `a`, face `b`.
    VertexFace,
    /// Edges `a < b`.
    EdgeEdge,
    /// Vertex `a` of no edge, edge `b` of no face: a particle and a rod.
    VertexEdge,
    /// Vertices `a < b` of no edge: two particles.
    VertexVertex,
}

impl Kind {
    /// All of them, in the order in which contacts are sorted.
    pub const ALL: [Self; 4] =
        [Kind::VertexFace, Kind::EdgeEdge, Kind::VertexEdge, Kind::VertexVertex];

    /// The region in which such features touch: an edge and a vertex are faces without an area,
    /// with their last vertex repeated.
    #[inline(always)]
    pub fn patch(self) -> Patch {
        if matches!(self, Kind::EdgeEdge) { Patch::Parallelogram } else { Patch::Triangle }
    }

    /// How many of the four vertices of a pair are those of its first feature, `a`: 1 or 2.
    #[inline(always)]
    pub fn n_first(self) -> usize {
        if matches!(self, Kind::EdgeEdge) { 2 } else { 1 }
    }
}

/// How certain a contact is.
///
/// ```
/// use ccd::{Contact, Kind, State};
///
/// // Either ends a step; only a hit certainly is a contact.
/// let contacts = [(0.5, State::Hit), (0.25, State::Undecided)]
///     .map(|(toi, state)| Contact::new(Kind::EdgeEdge, state, 3, 7, toi));
/// assert_eq!(contacts.iter().filter(|c| c.state == State::Hit).count(), 1);
/// assert_eq!(contacts.iter().map(|c| c.toi).fold(1.0, f64::min), 0.25);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum State {
    /// Certainly a contact; the time of impact is at most the tolerance of the options early,
    /// [`crate::TOI_TOLERANCE`] by default.
    Hit,
    /// Not decided: to be treated as a contact, may be none; certainly none before its time of
    /// impact. With a minimum distance only: see [`Mode`](super::options::Mode).
    Undecided,
}

/// A contact between two features.
///
/// ```
/// use ccd::{Approach, Contact, Kind, State};
///
/// let edges = Contact::new(Kind::EdgeEdge, State::Hit, 3, 7, 0.25);
/// let face = Contact::new(Kind::VertexFace, State::Undecided, 9, 0, 0.5);
/// assert_eq!(edges.approach, Approach::Unknown);
/// // A report is sorted by kind and ids.
/// let mut contacts = [edges, face];
/// contacts.sort_by_key(|c| (c.kind, c.a, c.b));
/// assert_eq!(contacts, [face, edges]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Contact {
    /// Which features touch.
    pub kind: Kind,
    /// Whether it is certain.
    pub state: State,
    /// The vertex of a vertex-face or vertex-edge pair; else the lesser edge or vertex.
    pub a: u32,
    /// The face or edge that the vertex `a` touches; else the greater edge or vertex.
    pub b: u32,
    /// Time of impact in `[0, 1]`; never later than the first contact of the two features.
    pub toi: f64,
    /// Whether the features come nearer there; certain unless unknown. By no means always known;
    /// backends may differ in what they know.
    pub approach: Approach,
}

impl Contact {
    /// A contact of features `a` and `b`, as the fields of this type say, of which nothing is known
    /// about how they approach each other.
    pub const fn new(kind: Kind, state: State, a: u32, b: u32, toi: f64) -> Self {
        Self { kind, state, a, b, toi, approach: Approach::Unknown }
    }

    /// With this [`Contact::approach`].
    #[must_use]
    pub const fn with_approach(mut self, approach: Approach) -> Self {
        self.approach = approach;
        self
    }

    /// The order in time; of contacts with the same time that by kind and ids.
    #[doc(hidden)]
    pub fn by_time(&self, other: &Self) -> Ordering {
        let ids = |of: &Self| (of.kind, of.a, of.b);
        self.toi.total_cmp(&other.toi).then_with(|| ids(self).cmp(&ids(other)))
    }

    /// The contact that an answer for a pair means; `None` for a miss.
    #[inline]
    pub fn of(kind: Kind, pair: Pair, answer: impl Into<Answer<f64>>) -> Option<Self> {
        let answer = answer.into();
        let (state, toi) = match answer.verdict {
            Verdict::Miss => return None,
            Verdict::Hit { toi } => (State::Hit, toi),
            Verdict::Undecided { toi } => (State::Undecided, toi),
        };
        Some(Self::new(kind, state, pair.a, pair.b, toi).with_approach(answer.approach))
    }
}

/// From what a device writes.
impl From<&Touch> for Contact {
    fn from(touch: &Touch) -> Self {
        let kind = if touch.kind == VERTEX_FACE { Kind::VertexFace } else { Kind::EdgeEdge };
        let state = if touch.state == 0 { State::Hit } else { State::Undecided };
        let approach = Approach::from_word(touch.approach);
        Self::new(kind, state, touch.a, touch.b, join(touch.toi)).with_approach(approach)
    }
}

/// A number for each kind of pair.
///
/// ```
/// use ccd::PerKind;
///
/// let sum = PerKind::new(3, 4).plus(PerKind::new(1, 1));
/// assert_eq!((sum.vf, sum.ee, sum.total()), (4, 5, 9));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct PerKind {
    /// Vertex-face.
    pub vf: u64,
    /// Edge-edge.
    pub ee: u64,
    /// Vertex-edge, of vertices of no edge and edges of no face.
    pub ve: u64,
    /// Vertex-vertex, of vertices of no edge.
    pub vv: u64,
}

impl PerKind {
    /// Numbers for vertex-face and edge-edge, and none for the others.
    pub const fn new(vf: u64, ee: u64) -> Self {
        Self { vf, ee, ve: 0, vv: 0 }
    }

    /// All together.
    pub fn total(&self) -> u64 {
        self.vf + self.ee + self.ve + self.vv
    }

    /// Added kind by kind.
    pub fn plus(self, other: Self) -> Self {
        Self {
            vf: self.vf + other.vf,
            ee: self.ee + other.ee,
            ve: self.ve + other.ve,
            vv: self.vv + other.vv,
        }
    }

    /// The number for one kind.
    pub fn of(&mut self, kind: Kind) -> &mut u64 {
        match kind {
            Kind::VertexFace => &mut self.vf,
            Kind::EdgeEdge => &mut self.ee,
            Kind::VertexEdge => &mut self.ve,
            Kind::VertexVertex => &mut self.vv,
        }
    }
}
