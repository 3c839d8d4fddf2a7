//! Builders of binary trees on a device: boxes in, an order of leaves and the branches over them
//! out, in the numbering of [`ccd_core::backend::broad_phase::node_numbering`]; so what fits boxes
//! to a tree and what traverses it serve every builder. A new one is a file and an arm.

mod bottom_up;
mod lbvh;
mod nearest_pair;
mod ploc;
mod split_lists;

use super::block_bvh::Tree;
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use crate::recorder::Recorder;
use ccd_core::backend::layout::Frame;
use ccd_core::model::catalogue::Catalogued;
use ccd_core::model::method::Builder;

/// Bits of a Morton code on a device: levels that it decides.
const CODE_BITS: u32 = 30;

/// Builds trees over one set.
pub trait TreeBuilder: Send + Sync {
    /// Levels of internal nodes that a tree may have, for any boxes.
    fn height(&self) -> u32;

    /// Clears everything to which kernels of the builder add.
    fn clear(&self, _recorder: &mut Recorder) {}

    /// Records the kernels that fill `branches`, one fewer than boxes of the set, from boxes that
    /// `sorted` has in order; they may put the leaves of the set into another one. Every dispatch
    /// has a bounded part of the work.
    fn build(&self, recorder: &mut Recorder, frame: &Frame, sorted: &Tree, branches: &wgpu::Buffer);

    /// A list between the kernels, which may have to grow; as long as it is too short, the branches
    /// are nevertheless those of a tree.
    fn list(&self) -> Option<&List> {
        None
    }

    /// The same, to be replaced by a larger one.
    fn list_mut(&mut self) -> Option<&mut List> {
        None
    }
}

/// Refuses more boxes than a builder takes.
pub fn check(choice: Builder, n: u32) -> Result<(), Error> {
    choice.check(n as u64)?;
    match choice {
        Builder::NearestPair { .. } => nearest_pair::check(n),
        _ => Ok(()),
    }
}

/// The builder of a choice, over `n` boxes of a set, at least one.
pub fn new(
    device: &Device,
    choice: Builder,
    set: usize,
    n: u32,
) -> Result<Box<dyn TreeBuilder>, Error> {
    check(choice, n)?;
    Ok(match choice {
        Builder::Lbvh => Box::new(lbvh::Lbvh { set, n }),
        Builder::SplitLists => Box::new(split_lists::SplitLists::new(device, set, n)?),
        Builder::NearestPair { .. } => Box::new(nearest_pair::NearestPair::new(device, set, n)?),
        Builder::Ploc { radius } => Box::new(ploc::Ploc::new(device, set, n, radius)?),
        other => {
            let name = other.row().name;
            return Err(ccd_core::Error::Method { name, backend: "gpu" }.into());
        }
    })
}

/// Levels of a tree from sorted codes over `n` boxes: a node on a way down decides a bit of the
/// code, or of the number of a leaf.
fn height_of_codes(n: u32) -> u32 {
    CODE_BITS + 32 - n.leading_zeros()
}
