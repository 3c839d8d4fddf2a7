//! What a backend does for its sessions: the few operations that all calls come down to.

use super::{Intersection, Kept, Moved};
use crate::model::bodies::Bodies;
use crate::model::cancel::CancelToken;
use crate::model::contact::Kind;
use crate::model::error::Error;
use crate::model::mesh::Mesh;
use crate::model::options::Options;
use crate::model::precision::Given;
use crate::model::report::Report;
use alloc::sync::Arc;
use alloc::vec::Vec;

/// The work of a [`Session`](super::Session) on a backend.
pub trait Engine: Sized {
    /// What an engine is opened on: a device, or nothing.
    type On;
    /// Why something was not done.
    type Error: From<Error>;
    /// Candidates as the backend lists them.
    type Candidates<'a>
    where
        Self: 'a;

    /// An engine for a mesh and options that fit it.
    ///
    /// # Errors
    /// What the backend lacks or refuses.
    fn new(on: &Self::On, state: State) -> Result<Self, Self::Error>;

    /// What every engine has of its session.
    fn state(&self) -> &State;

    /// Where the bodies of its session are. It is with the engine, not with the session, so that
    /// all sessions over one engine know of each other's calls.
    fn kept(&mut self) -> &mut Kept;

    /// Empties the report, after a call has failed.
    fn clear(&mut self);

    /// Finds what is asked for, and leaves it in the report. `given`: a position for every vertex;
    /// `moved`: which of them differ from those of the call before, if that is known.
    ///
    /// # Errors
    /// Those of [`Session::step`](super::Session::step).
    fn find(&mut self, given: Given, moved: Option<Moved>, ask: Ask) -> Result<(), Self::Error>;

    /// Lists candidates.
    ///
    /// # Errors
    /// Those of [`Session::step`](super::Session::step).
    fn candidates(&mut self, given: Given) -> Result<Self::Candidates<'_>, Self::Error>;

    /// Changes what the next step is of: all of it or, after an error, nothing.
    ///
    /// # Errors
    /// What the backend lacks or refuses; never [`Change::Filter`] of none.
    fn change(&mut self, change: Change) -> Result<(), Self::Error>;

    /// Takes what ends calls.
    fn set_cancel_token(&mut self, token: Option<CancelToken>);

    /// What ends calls.
    fn cancel_token(&self) -> Option<&CancelToken>;
}

/// An engine that finds where a mesh goes through itself.
pub trait Intersects: Engine {
    /// Intersections at the first positions of `given`, sorted; `first`: some, if there are any,
    /// found no later than the first one ends the search.
    ///
    /// # Errors
    /// Those of [`Session::step`](super::Session::step).
    fn intersections(&mut self, given: Given, first: bool) -> Result<Vec<Intersection>, Error>;
}

/// What every engine has of its session.
#[derive(Debug)]
pub struct State {
    /// The mesh of the next step.
    pub mesh: Arc<Mesh>,
    /// The options, which fit the mesh.
    pub options: Options,
    /// What the last call found.
    pub report: Report,
    /// Where bodies are, of calls that say which of them move.
    pub kept: Kept,
}

impl State {
    /// Before the first step.
    pub fn new(mesh: Arc<Mesh>, options: Options) -> Self {
        Self { mesh, options, report: Report::default(), kept: Kept::default() }
    }
}

/// What is asked of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ask {
    /// Every contact that exists at some time in a window of the step.
    Contacts {
        /// The first and the last time.
        window: [f64; 2],
    },
    /// The earliest time of impact, and no list of contacts.
    Earliest {
        /// Whether it is asked whose time it is, which a CPU tells.
        whose: bool,
    },
    /// The contact of the earliest time, by one search: that of [`Ask::Earliest`] where this tells
    /// whose time it is, else that of all contacts.
    First,
}

impl Ask {
    /// The times that are looked at.
    pub fn window(self) -> [f64; 2] {
        match self {
            Self::Contacts { window } => window,
            Self::Earliest { .. } | Self::First => [0.0, 1.0],
        }
    }
}

/// Whether a pair of features is wanted: by its kind and ids, of edges the lesser first.
pub type Filter = dyn Fn(Kind, u32, u32) -> bool + Send + Sync;

/// What changes between steps, checked as far as a mesh and options say.
#[derive(Clone)]
pub enum Change {
    /// The mesh and the options, of which what differs counts.
    Mesh(Arc<Mesh>, Options),
    /// The bodies of the options, which are others.
    Bodies(Option<Bodies>),
    /// The minimum distance of the options.
    MinDistance(f64),
    /// What selects pairs one by one.
    Filter(Option<Arc<Filter>>),
}
