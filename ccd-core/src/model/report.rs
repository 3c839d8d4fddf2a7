//! What a step found, and where its time went.

use super::contact::{Contact, Kind, PerKind};
use alloc::vec::Vec;

/// Where the time of a step went, in milliseconds of wall clock.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
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

/// Tests of features that pairs of triangles are, before and after each step that takes some away.
/// What is left then are [`Report::candidates`], whose own boxes overlap, and of these
/// [`Report::filtered`]. The numbers are the same on every backend and by every method; where only
/// the earliest time was asked for, a CPU counts its last pass, over a shorter time, a GPU all of
/// the step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct TriangleCounts {
    /// Pairs of triangles whose swept boxes overlap, of bodies that are looked at.
    pub pairs: u64,
    /// Those of them that were skipped because they share a vertex.
    pub adjacent: u64,
    /// Those of the others that were skipped because both are in a region that certainly does not
    /// touch itself.
    pub free: u64,
    /// Tests of features that the others were expanded to: 15 a pair without representatives.
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
            represented: self.represented + other.represented,
            orphans: self.orphans + other.orphans,
        }
    }
}

/// Fronts that a step left: pairs of nodes where its descents ended, with which the next begins.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
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
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct Report {
    /// All contacts, sorted by kind, then `a`, then `b`; empty if only the earliest time was asked
    /// for.
    pub contacts: Vec<Contact>,
    /// Least time of impact; `None` without contact.
    pub toi: Option<f64>,
    /// Pairs of features whose swept boxes overlap.
    pub candidates: PerKind,
    /// Candidates that the filters in `f32` could not reject.
    pub filtered: PerKind,
    /// Contacts in [`State::Undecided`](super::contact::State::Undecided).
    pub undecided: u64,
    /// Pairs of triangles and what they were expanded to; `None` if features were paired at once.
    pub triangles: Option<TriangleCounts>,
    /// The fronts that are kept; `None` if none are.
    pub front: Option<FrontCounts>,
    /// Whether trees were built anew rather than refitted.
    pub rebuilt: bool,
    /// Where the time went.
    pub times: Times,
}

impl Report {
    /// Contacts by kind.
    pub fn n_contacts(&self) -> PerKind {
        let vf = self.contacts.partition_point(|c| c.kind == Kind::VertexFace) as u64;
        PerKind::new(vf, self.contacts.len() as u64 - vf)
    }
}
