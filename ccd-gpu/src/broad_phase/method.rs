//! The chosen method: the one place where a choice becomes code.

use super::block_pairs::BlockSource;
use super::key_intervals::IntervalSource;
use super::pair_source::PairSource;
use super::scheduler::is_by_levels;
use super::tree::TreeSource;
use crate::device::Device;
use crate::error::Error;
use ccd_core::broad_phase::key_intervals::{BRUTE_FORCE, SWEEP_AND_PRUNE, UNIFORM_GRID};
use ccd_core::model::catalogue::Catalogued;
use ccd_core::model::method::{BroadPhaseMethod, Builder, Traversal, TreeOptions, Volume};
use ccd_core::model::scheduling::Scheduling;

/// Refuses a choice that this backend does not have.
pub fn check(choice: BroadPhaseMethod) -> Result<(), Error> {
    choice.check()?;
    match choice.lacking("gpu") {
        Some(name) => Err(ccd_core::Error::Method { name, backend: "gpu" }.into()),
        None if is_default(choice) => Ok(()),
        None => check_catalogue(choice.row().name),
    }
}

/// Whether a method needs no feature: blocks, and trees by LBVH that each box queries.
fn is_default(choice: BroadPhaseMethod) -> bool {
    match choice {
        BroadPhaseMethod::Blocks => true,
        BroadPhaseMethod::Tree(TreeOptions { builder, volume, traversal, .. }) => {
            let is_cut = matches!(traversal, Traversal::Cut { .. });
            builder == Builder::Lbvh && volume == Volume::Aabb && !is_cut
        }
        _ => false,
    }
}

/// Refuses a choice outside of the default ones where no others are compiled in.
fn check_catalogue(name: &str) -> Result<(), Error> {
    if cfg!(feature = "catalogue") {
        return Ok(());
    }
    let why = format!("`{name}`, so chosen, is not compiled in: feature `catalogue` of ccd-gpu");
    Err(Error::Unavailable { why })
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
    if is_by_levels(choice) { Ok(()) } else { check_catalogue("scheduling") }
}

/// The source of a choice, with room for sets of so many boxes.
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
        BroadPhaseMethod::Blocks => Box::new(BlockSource::new(device, scheduling, count)?),
        BroadPhaseMethod::Tree(options) => {
            Box::new(TreeSource::new(device, options, scheduling, count)?)
        }
        other => {
            let name = other.row().name;
            return Err(ccd_core::Error::Method { name, backend: "gpu" }.into());
        }
    })
}
