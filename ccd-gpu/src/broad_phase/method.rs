//! The chosen method: the one place where a choice becomes code.

use super::block_pairs::BlockSource;
use super::pair_source::PairSource;
use super::tree::TreeSource;
use crate::device::Device;
use crate::error::Error;
use ccd_core::model::catalogue::Catalogued;
use ccd_core::model::method::BroadPhaseMethod;

/// Refuses a choice that this backend does not have.
pub fn check(choice: BroadPhaseMethod) -> Result<(), Error> {
    choice.check()?;
    match choice.lacking("gpu") {
        Some(name) => Err(ccd_core::Error::Method { name, backend: "gpu" }.into()),
        None => Ok(()),
    }
}

/// The source of a choice, with room for sets of so many boxes.
pub fn source(
    device: &Device,
    choice: BroadPhaseMethod,
    count: [u32; 3],
) -> Result<Box<dyn PairSource>, Error> {
    check(choice)?;
    Ok(match choice {
        BroadPhaseMethod::Blocks => Box::new(BlockSource::new(device, count)?),
        BroadPhaseMethod::Tree(options) => Box::new(TreeSource::new(device, options, count)?),
        other => {
            let name = other.row().name;
            return Err(ccd_core::Error::Method { name, backend: "gpu" }.into());
        }
    })
}
