//! A contact between two features: which, how certain, when; and numbers by kind of pair.

use crate::layout::{Pair, Touch, join};
use crate::narrow_phase::query::Verdict;
use crate::narrow_phase::relative_motion::Patch;

/// Which features touch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// Vertex `a`, face `b`.
    VertexFace,
    /// Edges `a < b`.
    EdgeEdge,
}

impl Kind {
    /// The region in which such features touch.
    #[inline(always)]
    pub fn patch(self) -> Patch {
        match self {
            Kind::VertexFace => Patch::Triangle,
            Kind::EdgeEdge => Patch::Parallelogram,
        }
    }
}

/// How certain a contact is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum State {
    /// Certainly a contact; the time of impact is at most [`crate::TOI_TOLERANCE`] early.
    Hit,
    /// Not decided: to be treated as a contact, may be none; certainly none before its time of
    /// impact.
    Undecided,
}

/// A contact between two features.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Contact {
    /// Vertex-face or edge-edge.
    pub kind: Kind,
    /// Whether it is certain.
    pub state: State,
    /// Vertex id, or the lesser edge id.
    pub a: u32,
    /// Face id, or the greater edge id.
    pub b: u32,
    /// Time of impact in `[0, 1]`; never later than the first contact of the two features.
    pub toi: f64,
}

impl Contact {
    /// A contact of features `a` and `b`, as the fields of this type say.
    pub const fn new(kind: Kind, state: State, a: u32, b: u32, toi: f64) -> Self {
        Self { kind, state, a, b, toi }
    }

    /// The contact that a verdict on a pair means; `None` for a miss.
    #[inline]
    pub fn of(kind: Kind, pair: Pair, verdict: Verdict<f64>) -> Option<Self> {
        let (state, toi) = match verdict {
            Verdict::Miss => return None,
            Verdict::Hit { toi } => (State::Hit, toi),
            Verdict::Undecided { toi } => (State::Undecided, toi),
        };
        Some(Self::new(kind, state, pair.a, pair.b, toi))
    }
}

/// From what a device writes.
impl From<&Touch> for Contact {
    fn from(touch: &Touch) -> Self {
        let kind = if touch.kind == 0 { Kind::VertexFace } else { Kind::EdgeEdge };
        let state = if touch.state == 0 { State::Hit } else { State::Undecided };
        Self::new(kind, state, touch.a, touch.b, join(touch.toi))
    }
}

/// A number for each kind of pair.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct PerKind {
    /// Vertex-face.
    pub vf: u64,
    /// Edge-edge.
    pub ee: u64,
}

impl PerKind {
    /// Numbers for vertex-face and edge-edge.
    pub const fn new(vf: u64, ee: u64) -> Self {
        Self { vf, ee }
    }

    /// Both together.
    pub fn total(&self) -> u64 {
        self.vf + self.ee
    }

    /// Added kind by kind.
    pub fn plus(self, other: Self) -> Self {
        Self { vf: self.vf + other.vf, ee: self.ee + other.ee }
    }

    /// The number for one kind.
    pub fn of(&mut self, kind: Kind) -> &mut u64 {
        match kind {
            Kind::VertexFace => &mut self.vf,
            Kind::EdgeEdge => &mut self.ee,
        }
    }
}
