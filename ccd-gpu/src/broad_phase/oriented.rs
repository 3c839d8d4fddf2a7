//! Oriented boxes of binary trees on a device: fitted a tile of leaves a workgroup, then a level a
//! dispatch, and looked at by traversals; see [`ccd_core::backend::broad_phase::oriented_nodes`].

use super::binary_tree::BinaryTree;
use super::block_bvh::Tree;
use crate::bind::{OrientFar, OrientNear};
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::HEADER_BYTES;
use crate::recorder::Recorder;
use ccd_core::backend::broad_phase::oriented_nodes::{FIRST_ROUND, WORDS, n_rounds};
use ccd_core::backend::kernel::Id;
use ccd_core::backend::layout::{Dispatch, Frame, Params};
use wgpu::BufferUsages as U;

/// Oriented boxes of the internal nodes of the trees over all sets: that of node `i` of a set's
/// tree stands at the place of the set's box `i`, so that a kernel reads two trees from one buffer.
pub struct OrientedBoxes {
    pub boxes: wgpu::Buffer,
    /// By node: the round in which it was fitted, 0 before that.
    stamps: wgpu::Buffer,
    /// By set that has a tree: a list of the nodes across tiles, of which it holds all.
    far: [Option<wgpu::Buffer>; 3],
}

impl OrientedBoxes {
    /// For the trees over those sets of so many boxes that `has_tree`.
    pub fn new(device: &Device, count: [u32; 3], has_tree: [bool; 3]) -> Result<Self, Error> {
        let n: u64 = count.iter().map(|&c| c as u64).sum();
        let mut far = [None, None, None];
        for set in (0..3).filter(|&set| has_tree[set]) {
            let bytes = HEADER_BYTES + 4 * count[set] as u64;
            let usage = U::STORAGE | U::COPY_DST;
            far[set] = Some(device.buffer("nodes across tiles", bytes, usage)?);
        }
        Ok(Self {
            boxes: device.buffer("oriented boxes", 4 * WORDS as u64 * n, U::STORAGE)?,
            stamps: device.buffer("rounds of oriented boxes", 4 * n, U::STORAGE)?,
            far,
        })
    }

    /// What must be zero before [`OrientedBoxes::fit`].
    pub fn clear(&self, recorder: &mut Recorder) {
        self.far.iter().flatten().for_each(|far| recorder.clear(far, HEADER_BYTES));
    }

    /// Boxes of all internal nodes of a tree, from those of the leaves of a block tree.
    pub fn fit(&self, recorder: &mut Recorder, frame: &Frame, blocks: &Tree, tree: &BinaryTree) {
        let Some(far) = &self.far[tree.set] else { return };
        let (branches, block_nodes) = (&tree.branches, &blocks.nodes);
        let (oriented, stamps) = (&self.boxes, &self.stamps);
        let p = tree.params(frame, blocks);
        let kernel = OrientNear { branches, block_nodes, oriented, stamps, far };
        recorder.each(&kernel, &p, tree.n);
        let groups = blocks.groups.min(tree.n.div_ceil(Id::OrientFar.threads()));
        let kernel = OrientFar { branches, block_nodes, far, oriented, stamps };
        for first in (FIRST_ROUND..).take(n_rounds(tree.n, tree.height()) as usize) {
            let dispatch = Dispatch { first, ..p.dispatch };
            recorder.dispatch(&kernel, &Params { dispatch, ..p }, groups);
        }
    }
}
