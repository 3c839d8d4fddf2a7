//! Pairs of nearest nodes, bottom up: on every level the first node that is free is joined with the
//! nearest of the others that are [Tian and Wan].
//!
//! Targets come one after the other, so one workgroup pairs a level: its threads look at every
//! 256th place each, and what they find is compared in its memory. Levels, and parts of levels in
//! which at most [`DISTANCES`] are looked at, are dispatches of their own; where each is in the
//! array of nodes is known beforehand. The tree is that of a CPU.
//!
//! Cost: `n^2 / 3` distances by 256 threads, and five barriers a pair, while all other parts of the
//! device stand still. When to choose it: to learn from it; [`super::ploc`] does the same among
//! neighbours along a curve, all at once.

use super::TreeBuilder;
use super::bottom_up::Joins;
use crate::bind::{PairJoin, PairLeaves, PairNearest};
use crate::broad_phase::block_bvh::Tree;
use crate::device::Device;
use crate::error::Error;
use crate::recorder::Recorder;
use ccd_core::backend::broad_phase::nearest_pair::parents;
use ccd_core::backend::layout::{Building, Cluster, Dispatch, Frame, Params};
use wgpu::BufferUsages as U;

/// Distances that one dispatch looks at, at most, if one target has not more: some milliseconds of
/// a workgroup of a small device, so that no driver thinks that it hangs.
const DISTANCES: u32 = 1 << 24;

/// Most boxes on a device, whatever limit the caller allows: some 400 dispatches, of the 2048 that
/// one recording takes.
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
        let Self { joins, clusters, items } = self;
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
            let part = (DISTANCES / n).max(1);
            for target in (0..n / 2).step_by(part as usize) {
                let p = params(n, 2 * target, part.min(n / 2 - target), 0);
                recorder.dispatch(&PairNearest { items: &items[from] }, &p, 1);
            }
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
