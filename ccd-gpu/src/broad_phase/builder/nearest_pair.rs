//! Pairs of nearest nodes, bottom up: on every level the first node that is free is joined with the
//! nearest of the others that are [Tian and Wan].
//!
//! ```text
//! pair_search   [t| a b c ..] [.. d e f ..] [.. g h]   a thread a node, a workgroup its nearest
//!                     \            |          /
//! pair_swap     [t x|    the nearest of those   ]      it comes after t; the next target
//! ```
//!
//! Targets come one after the other, and a dispatch sees only what an earlier one has written, so a
//! target is two dispatches; which target it is stands on the device, so that they are recorded
//! once. Of the last [`FEW`] nodes of a level one workgroup pairs many targets in a dispatch
//! (`pair_nearest`): its threads look at every 256th place each. The tree is that of a CPU.
//!
//! Cost: `n^2 / 3` distances, and two dispatches for each of nearly `n` targets, each as long as a
//! device takes to begin one. When to choose it: to learn from it; [`super::ploc`] does the same
//! among neighbours along a curve, all at once.

use super::TreeBuilder;
use super::bottom_up::Joins;
use crate::bind::{PairJoin, PairLeaves, PairNearest, PairSearch, PairSwap};
use crate::broad_phase::block_bvh::Tree;
use crate::device::Device;
use crate::error::Error;
use crate::recorder::Recorder;
use ccd_core::backend::broad_phase::nearest_pair::{FEW, GROUP, parents, wide_targets, words};
use ccd_core::backend::layout::{Building, Cluster, Dispatch, Frame, Params};
use wgpu::BufferUsages as U;

/// Targets with the same number of workgroups: those of the last ones have a node or two less for
/// each target before.
const PART: u32 = 1024;

/// Most boxes on a device, whatever limit the caller allows: some 200,000 dispatches in one
/// recording, with the parameters of some 200.
const MAX_BOXES: u32 = 100_000;

/// Refuses more boxes.
pub fn check(n: u32) -> Result<(), Error> {
    if n <= MAX_BOXES {
        return Ok(());
    }
    let element = "boxes in the quadratic builder `nearest-pair` on a GPU (`ploc` has no limit)";
    let (count, limit) = (n as u64, MAX_BOXES as u64);
    Err(ccd_core::Error::TooMany { element, count, limit }.into())
}

/// The nodes of a level and of that above.
pub struct NearestPair {
    joins: Joins,
    clusters: [wgpu::Buffer; 2],
    items: [wgpu::Buffer; 2],
    found: wgpu::Buffer,
}

impl NearestPair {
    pub fn new(device: &Device, set: usize, n: u32) -> Result<Self, Error> {
        let clusters = || {
            device.buffer("nodes of a level", n as u64 * size_of::<Cluster>() as u64, U::STORAGE)
        };
        let items = || device.buffer("centres of a level", n as u64 * 16, U::STORAGE);
        Ok(Self {
            joins: Joins::new(device, set, n)?,
            clusters: [clusters()?, clusters()?],
            items: [items()?, items()?],
            found: device.buffer("nearest nodes", 4 * words(n) as u64, U::STORAGE | U::COPY_DST)?,
        })
    }
}

impl TreeBuilder for NearestPair {
    fn height(&self) -> u32 {
        32 - self.joins.n.leading_zeros()
    }

    fn build(
        &self,
        recorder: &mut Recorder,
        frame: &Frame,
        sorted: &Tree,
        branches: &wgpu::Buffer,
    ) {
        let Self { joins, clusters, items, found } = self;
        let set = joins.set as u32;
        let params = |n: u32, first: u32, rounds: u32, made: u32| Params {
            frame: *frame,
            dispatch: Dispatch { n, first, ..Dispatch::default() },
            args: Building { set, rounds, made, ..Building::default() },
        };
        let (mut n, mut made, mut from) = (joins.n, 0, 0);
        if n < 2 {
            return;
        }
        let (boxes, bounds) = (&sorted.boxes, sorted.bounds());
        let kernel = PairLeaves { boxes, bounds, clusters: &clusters[0], items: &items[0] };
        recorder.each(&kernel, &params(n, 0, 0, 0), n);
        while n > 1 {
            let (items_in, wide) = (&items[from], wide_targets(n, FEW));
            if wide > 0 {
                // The place of the first target.
                recorder.clear(found, 4);
            }
            for target in (0..wide).step_by(PART as usize) {
                let p = params(n, 0, 0, 0);
                recorder.repeat(PART.min(wide - target), |recorder| {
                    let groups = (n - 2 * target - 1).div_ceil(GROUP);
                    recorder.dispatch(&PairSearch { items: items_in, found }, &p, groups);
                    recorder.dispatch(&PairSwap { items: items_in, found }, &p, 1);
                });
            }
            let p = params(n, 2 * wide, n / 2 - wide, 0);
            recorder.dispatch(&PairNearest { items: items_in }, &p, 1);
            let kernel = PairJoin {
                clusters: &clusters[from],
                items: &items[from],
                clusters_out: &clusters[1 - from],
                items_out: &items[1 - from],
                joins: &joins.words,
            };
            let above = parents(n as usize) as u32;
            recorder.each(&kernel, &params(n, 0, 0, made), above);
            (made, n, from) = (made + n / 2, above, 1 - from);
        }
        joins.finish(recorder, frame, sorted, false, branches);
    }
}
