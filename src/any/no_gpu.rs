//! What stands for the GPU where this crate is built without it: types that have no value, so that
//! nothing of them ever runs.

use crate::{
    Aabb, AsPositions, Bodies, BroadPhaseMethod, CancelToken, Mesh, Options, Pair, Report,
    Scheduling,
};
use std::sync::Arc;

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

pub enum Session {}

pub struct Candidates {
    pub vf: Vec<Pair>,
    pub ee: Vec<Pair>,
    pub ve: Vec<Pair>,
    pub vv: Vec<Pair>,
}

impl Session {
    pub fn new(device: &Device, _: Arc<Mesh>, _: Options) -> Result<Self, Error> {
        match *device {}
    }

    pub fn earliest_toi<A: AsPositions>(&mut self, _: &A, _: &A) -> Result<Option<f64>, Error> {
        match *self {}
    }

    pub fn step_window<A: AsPositions>(
        &mut self,
        _: &A,
        _: &A,
        _: [f64; 2],
    ) -> Result<&Report, Error> {
        match *self {}
    }

    pub fn candidates<A: AsPositions>(&mut self, _: &A, _: &A) -> Result<Candidates, Error> {
        match *self {}
    }

    pub fn set_mesh_and_bodies(&mut self, _: Arc<Mesh>, _: Option<Bodies>) -> Result<(), Error> {
        match *self {}
    }

    pub fn set_min_distance(&mut self, _: f64) -> Result<(), Error> {
        match *self {}
    }

    pub fn set_options(&mut self, _: Options) -> Result<(), Error> {
        match *self {}
    }

    pub fn set_bodies(&mut self, _: Option<Bodies>) -> Result<(), Error> {
        match *self {}
    }

    pub fn set_sleeping(&mut self, _: u32, _: bool) -> Result<(), Error> {
        match *self {}
    }

    pub fn set_fixed(&mut self, _: u32, _: bool) -> Result<(), Error> {
        match *self {}
    }

    pub fn set_fixed_motion(&mut self, _: bool) -> Result<(), Error> {
        match *self {}
    }

    pub fn set_cancel_token(&mut self, _: impl Into<Option<CancelToken>>) {
        match *self {}
    }

    pub fn cancel_token(&self) -> Option<&CancelToken> {
        match *self {}
    }

    pub fn report(&self) -> &Report {
        match *self {}
    }

    pub fn mesh(&self) -> &Arc<Mesh> {
        match *self {}
    }

    pub fn options(&self) -> &Options {
        match *self {}
    }

    pub fn device(&self) -> &Device {
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
