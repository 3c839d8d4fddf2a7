//! What a session lists besides contacts: candidates of a step, intersections at one moment.

use crate::model::contact::State;

/// Candidates of a step: pairs of features whose swept boxes overlap, without those that share a
/// vertex or that the bodies rule out. `P` and `Q` are lists as a backend has them: on a CPU they
/// are lent by the session, on a GPU they are vectors in no order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Candidates<P, Q = P> {
    /// Vertex, face.
    pub vf: P,
    /// Two edges, the lesser id first.
    pub ee: P,
    /// A vertex of no edge, an edge of no face.
    pub ve: Q,
    /// Two vertices of no edge, the lesser id first.
    pub vv: Q,
}

impl<P, Q> Candidates<P, Q> {
    /// Lists in the order of [`Kind`](crate::model::contact::Kind).
    pub fn new([vf, ee]: [P; 2], [ve, vv]: [Q; 2]) -> Self {
        Self { vf, ee, ve, vv }
    }
}

/// An edge and a face without a common vertex that have a point in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Intersection {
    /// The edge.
    pub edge: u32,
    /// The face.
    pub face: u32,
    /// [`State::Undecided`]: not certainly apart, with coordinates beyond 2^200, or below 2^-200
    /// and not zero, for which nothing is calculated exactly.
    pub state: State,
}

impl Intersection {
    /// Of an edge and a face.
    pub fn new(edge: u32, face: u32, state: State) -> Self {
        Self { edge, face, state }
    }
}
