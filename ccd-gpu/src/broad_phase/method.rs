//! The chosen method: the one place where a choice becomes code.

use super::block_bvh::Tree;
use super::key_intervals::IntervalSource;
use super::pair_source::PairSource;
use super::scheduler::is_by_levels;
use super::sweep_by_end_points::EndPointSource;
use super::tree::TreeSource;
use crate::device::Device;
use crate::error::Error;
use ccd_core::backend::broad_phase::key_intervals::{BRUTE_FORCE, SWEEP_AND_PRUNE, UNIFORM_GRID};
use ccd_core::model::catalogue::Catalogued;
use ccd_core::model::method::{BroadPhaseMethod, TreeOptions};
use ccd_core::model::scheduling::Scheduling;

/// Refuses a choice that this backend does not have.
pub fn check(choice: BroadPhaseMethod) -> Result<(), Error> {
    choice.check()?;
    if let Some(name) = choice.lacking("gpu") {
        return Err(ccd_core::Error::Method { name, backend: "gpu" }.into());
    }
    check_compiled(match choice {
        BroadPhaseMethod::Tree(TreeOptions { builder, volume, traversal, .. }) => {
            added(builder).or(added(volume)).or(added(traversal))
        }
        _ => added(choice),
    })
}

/// The name of a choice that only the feature `catalogue` has.
fn added<T: Catalogued>(choice: T) -> Option<&'static str> {
    let name = choice.row().name;
    (!T::ALWAYS.contains(&name)).then_some(name)
}

/// Refuses what only the feature `catalogue` has, in a build without it.
fn check_compiled(added: Option<&'static str>) -> Result<(), Error> {
    match added {
        Some(name) if !cfg!(feature = "catalogue") => {
            Err(ccd_core::Error::NotCompiled { name, backend: "gpu" }.into())
        }
        _ => Ok(()),
    }
}

/// Refuses a way to share out pairs of nodes that the method or this backend does not have.
///
/// # Errors
/// [`Error::Input`].
pub fn check_scheduling(method: BroadPhaseMethod, choice: Scheduling) -> Result<(), Error> {
    choice.check(method)?;
    if let Some(name) = choice.lacking("gpu") {
        return Err(ccd_core::Error::Method { name, backend: "gpu" }.into());
    }
    let name = choice.scheduler.map_or("front", |scheduler| scheduler.row().name);
    check_compiled((!is_by_levels(choice)).then_some(name))
}

/// The source of a choice, over sets of so many boxes.
pub fn source(
    device: &Device,
    choice: BroadPhaseMethod,
    scheduling: Scheduling,
    count: [u32; 3],
) -> Result<Box<dyn PairSource>, Error> {
    check(choice)?;
    check_scheduling(choice, scheduling)?;
    let by_keys = |method| IntervalSource::new(device, method, count);
    Ok(match choice {
        BroadPhaseMethod::BruteForce => Box::new(by_keys(BRUTE_FORCE)?),
        BroadPhaseMethod::SweepAndPrune => Box::new(by_keys(SWEEP_AND_PRUNE)?),
        BroadPhaseMethod::UniformGrid => Box::new(by_keys(UNIFORM_GRID)?),
        BroadPhaseMethod::SweepByEndPoints => Box::new(EndPointSource::new(device, count)?),
        BroadPhaseMethod::Blocks => Box::new(Tree::new(device, scheduling, count, false, None)?),
        BroadPhaseMethod::Tree(options) => {
            Box::new(TreeSource::new(device, options, scheduling, count)?)
        }
        other => {
            let name = other.row().name;
            return Err(ccd_core::Error::Method { name, backend: "gpu" }.into());
        }
    })
}
