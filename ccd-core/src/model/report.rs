//! What a step found, and where its time went.

use super::contact::{Contact, Kind, PerKind};
use alloc::vec::Vec;

/// Where the time of a step went, in milliseconds of wall clock.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
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

/// What a step found.
#[derive(Clone, Debug, Default)]
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
    /// Whether trees were built anew rather than refitted.
    pub rebuilt: bool,
    /// Where the time went.
    pub times: Times,
}

impl Report {
    /// Contacts by kind.
    pub fn n_contacts(&self) -> PerKind {
        let vf = self.contacts.partition_point(|c| c.kind == Kind::VertexFace) as u64;
        PerKind { vf, ee: self.contacts.len() as u64 - vf }
    }
}
