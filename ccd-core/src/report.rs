//! What a step is asked and what it returns: options, contacts, counts, times.

use crate::error::{Error, check_min_distance};
use crate::layout::Pair;
use crate::query::Verdict;
use crate::topology::{Bodies, Mesh};
use alloc::vec::Vec;

/// What a step looks for and how.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// Contact means a distance of at most this, in the unit of the coordinates; 0 (touching) or more.
    pub min_distance: f64,
    /// Threads of work on a CPU: 0 for those of rayon's current pool, 1 for the calling one alone, more for a pool of the session's own.
    pub threads: usize,
    /// Which pairs of bodies are looked at; `None`: all pairs of features that share no vertex.
    pub bodies: Option<Bodies>,
}

impl Options {
    /// Checks the options for steps of `mesh`.
    pub fn check(&self, mesh: &Mesh) -> Result<(), Error> {
        check_min_distance(self.min_distance)?;
        self.bodies.as_ref().map_or(Ok(()), |bodies| bodies.check(mesh))
    }
}

/// Which features touch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// Vertex `a`, face `b`.
    VertexFace,
    /// Edges `a < b`.
    EdgeEdge,
}

/// How certain a contact is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum State {
    /// Certainly a contact; the time of impact is at most [`crate::TOI_TOLERANCE`] early.
    Hit,
    /// Not decided: to be treated as a contact, may be none; certainly none before its time of impact.
    Undecided,
}

/// A contact between two features.
#[derive(Clone, Copy, Debug, PartialEq)]
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
    /// The contact that a verdict on a pair means; `None` for a miss.
    #[inline]
    pub fn of(kind: Kind, pair: Pair, verdict: Verdict<f64>) -> Option<Self> {
        let (state, toi) = match verdict {
            Verdict::Miss => return None,
            Verdict::Hit { toi } => (State::Hit, toi),
            Verdict::Undecided { toi } => (State::Undecided, toi),
        };
        Some(Self { kind, state, a: pair.a, b: pair.b, toi })
    }
}

/// A number for each kind of pair.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PerKind {
    /// Vertex-face.
    pub vf: u64,
    /// Edge-edge.
    pub ee: u64,
}

impl PerKind {
    /// Both together.
    pub fn total(&self) -> u64 {
        self.vf + self.ee
    }

    /// The number for one kind.
    pub fn of(&mut self, kind: Kind) -> &mut u64 {
        match kind {
            Kind::VertexFace => &mut self.vf,
            Kind::EdgeEdge => &mut self.ee,
        }
    }
}

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
    /// All contacts, sorted by kind, then `a`, then `b`; empty if only the earliest time was asked for.
    pub contacts: Vec<Contact>,
    /// Least time of impact; `None` without contact.
    pub toi: Option<f64>,
    /// Pairs of features whose swept boxes overlap.
    pub candidates: PerKind,
    /// Candidates that the filters in `f32` could not reject.
    pub filtered: PerKind,
    /// Contacts in [`State::Undecided`].
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
