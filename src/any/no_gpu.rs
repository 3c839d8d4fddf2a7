//! Stand-ins for the types of the GPU without the feature `gpu`: they have no values, so their
//! methods never run.

use crate::method::{BroadPhaseMethod, Scheduling};
use crate::{Aabb, CancelToken, Pair, Report};
use ccd_core::model::precision::Given;
use ccd_core::model::session::{self, Ask, Change, Kept, Moved, On, State};

/// Why the work was not done. With the feature `gpu` this is `ccd::gpu::Error`, which has more
/// variants and these two.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Error {
    /// The input was refused; nothing was computed from it.
    Input(crate::Error),
    /// There is no GPU backend.
    Unavailable {
        /// Why there is none.
        why: String,
    },
}

impl std::fmt::Display for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Error::Input(e) => e.fmt(f),
            Error::Unavailable { why } => write!(f, "no GPU: {why}"),
        }
    }
}

impl std::error::Error for Error {}

impl From<crate::Error> for Error {
    fn from(e: crate::Error) -> Self {
        Error::Input(e)
    }
}

#[derive(Default)]
pub struct DeviceOptions {
    pub adapter: Option<String>,
}

#[derive(Clone)]
pub enum Device {}

impl Device {
    pub fn open(_: &DeviceOptions) -> Result<Self, Error> {
        Err(Error::Unavailable { why: "built without the feature `gpu`".into() })
    }
}

pub fn name(device: &Device) -> &str {
    match *device {}
}

pub fn is_emulated(device: &Device) -> bool {
    match *device {}
}

pub type Session = session::Session<Engine, On<Device>>;

pub enum Engine {}

impl Engine {
    pub fn device(&self) -> &Device {
        match *self {}
    }

    #[doc(hidden)]
    pub fn report_mut(&mut self) -> &mut Report {
        match *self {}
    }
}

impl session::Engine for Engine {
    type On = Device;
    type Error = Error;
    type Candidates<'a> = session::Candidates<Vec<Pair>>;

    fn new(device: &Device, _: State) -> Result<Self, Error> {
        match *device {}
    }

    fn state(&self) -> &State {
        match *self {}
    }

    fn kept(&mut self) -> &mut Kept {
        match *self {}
    }

    fn clear(&mut self) {
        match *self {}
    }

    fn find(&mut self, _: Given, _: Option<Moved>, _: Ask) -> Result<(), Error> {
        match *self {}
    }

    fn candidates(&mut self, _: Given) -> Result<session::Candidates<Vec<Pair>>, Error> {
        match *self {}
    }

    fn change(&mut self, _: Change) -> Result<(), Error> {
        match *self {}
    }

    fn set_cancel_token(&mut self, _: Option<CancelToken>) {
        match *self {}
    }

    fn cancel_token(&self) -> Option<&CancelToken> {
        match *self {}
    }
}

pub enum BroadPhase {}

impl BroadPhase {
    pub fn scheduled(device: &Device, _: BroadPhaseMethod, _: Scheduling) -> Result<Self, Error> {
        match *device {}
    }

    pub fn self_pairs(&mut self, _: &[Aabb<f32>]) -> Result<Vec<Pair>, Error> {
        match *self {}
    }

    pub fn pairs(&mut self, _: &[Aabb<f32>], _: &[Aabb<f32>]) -> Result<Vec<Pair>, Error> {
        match *self {}
    }
}
