//! Block trees over boxes on the device: sort, fit, descent to pairs of blocks.

use super::block_levels::Levels;
use super::block_workers;
use super::pair_source::boxes;
use super::scheduled::Scheduled;
use super::scheduler;
use super::worlds::Worlds;
use crate::bind::{
    CurveKeys, FitBoxes, FitLeaves, FitLevel, HalveRuns, NodePairs, NodePairsOfWorlds, PlaceLeaves,
    SceneBounds,
};
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use crate::recorder::Recorder;
use crate::sort::Sort;
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::morton_key::{self, Curve};
use ccd_core::backend::kernel::Id;
use ccd_core::backend::layout::{Blocks, Dispatch, Frame, Leaf, Params, Plain, VERTEX_FACE};
use ccd_core::model::scheduling::Scheduling;
use std::ops::Range;
use wgpu::BufferUsages as U;

/// Pairs of nodes that one dispatch takes at most: some milliseconds of a small device, so that no
/// driver thinks that it hangs.
pub const DISPATCH_LIMIT: u32 = 1 << 20;

/// Pairs of blocks that one dispatch takes at most: if all boxes of all of them overlap, it looks
/// at 2^28 pairs, some tenths of a second of a small device; on real scenes a thirtieth of that.
const BLOCK_LIMIT: u32 = 1 << 18;

/// The same of a discrete GPU: each dispatch makes the next one wait for its last workgroup. If all
/// boxes overlap, `list_overlaps` takes an NVIDIA H200 some 19 ms (a quarter as many took 4.8), and
/// a GPU that is sixty times slower a second; kernels over meshes take a quarter of that.
const BLOCK_LIMIT_OF_DISCRETE: u32 = 1 << 19;

/// Pairs of nodes that a workgroup takes at most: each takes a thread up to a hundred rounds of its
/// loops, see [`Device::groups`].
const PAIRS_A_GROUP: u32 = 512;

/// Pairs of blocks that a workgroup takes at most. Four at a time take a thread some 1,300 rounds:
/// if all boxes overlap it has 32 candidates of them, each of which is looked for among excluded
/// features in up to 32 rounds, in eleven passes of three shares with rounds of their own.
const BLOCK_PAIRS_A_GROUP: u32 = 96;

/// What nodes are fitted to besides boxes.
#[derive(Clone, Copy)]
pub struct Features<'a> {
    pub bodies: &'a wgpu::Buffer,
    pub paths: &'a wgpu::Buffer,
    /// Whether leaves are to have boxes at both ends of paths.
    pub ends: bool,
}

/// A pass over a list of pairs of nodes.
#[derive(Clone, Debug)]
pub struct Pass {
    /// 0: vertices against faces, 1: edges against edges.
    pub kind: u32,
    /// Level of the nodes.
    pub level: u32,
    /// Every so many-th pair is looked at.
    pub step: u32,
    /// Of those that are looked at, which.
    pub range: Range<u32>,
}

/// All of them.
pub const ALL: Range<u32> = 0..u32::MAX;

/// Trees over up to three sets of boxes, which one sort orders.
pub struct Tree {
    pub levels: Levels,
    pub boxes: wgpu::Buffer,
    pub nodes: wgpu::Buffer,
    pub leaves: wgpu::Buffer,
    bounds: wgpu::Buffer,
    curve: Curve,
    sort: Sort,
    /// Most workgroups of a kernel that loops over a list.
    pub groups: u32,
    /// Most pairs of blocks of a dispatch, see [`block_limit`].
    block_limit: u32,
    /// By kind: all pairs of nodes where the descent starts.
    start: [List; 2],
    /// By kind and level below the start: pairs of nodes; where workers descend, those of blocks
    /// alone.
    pub pairs: [Vec<List>; 2],
    /// If boxes are of several worlds.
    pub worlds: Option<Worlds>,
    /// Boxes of leaves at both ends of a step.
    ends: Option<wgpu::Buffer>,
    /// The workers that descend, if a scheduler was chosen that has some.
    pub(super) descent: Option<Scheduled>,
}

impl Tree {
    /// For these numbers of boxes, with the buffers of another tree as far as they are large
    /// enough. That one may be used again, if this fails. `of_paths`: boxes are those of features
    /// and their paths, which leaves stand for.
    pub fn new(
        device: &Device,
        scheduling: Scheduling,
        count: [u32; 3],
        of_paths: bool,
        old: Option<&Self>,
    ) -> Result<Self, Error> {
        let mut tree = Self::sorted_only(device, Curve::Hilbert, count, of_paths, old)?;
        if !scheduler::is_by_levels(scheduling) {
            tree.descent = Some(block_workers::scheduled(device, scheduling, count)?);
        }
        let (levels, by_levels) = (&tree.levels, tree.descent.is_none());
        let pairs = |kind: u32| -> Result<Vec<List>, Error> {
            // A node overlaps some tens of others on real scenes; what does not fit makes the list
            // grow. Fewer for boxes alone: dispatches over entries that are not there take time.
            let others = if of_paths { 40 } else { 24 };
            (1..if by_levels { levels.start(kind) } else { 2 })
                .map(|level| {
                    let old = old.and_then(|old| old.pairs[kind as usize].get(level as usize - 1));
                    List::reusing(
                        device,
                        old,
                        "pairs of nodes",
                        2,
                        levels
                            .nodes(level, if kind == VERTEX_FACE { 2 } else { 1 })
                            .saturating_mul(others)
                            .max(4096),
                    )
                })
                .collect()
        };
        tree.pairs = [pairs(0)?, pairs(1)?];
        Ok(tree)
    }

    /// As [`Tree::new`], without lists for a descent.
    pub fn sorted_only(
        device: &Device,
        curve: Curve,
        count: [u32; 3],
        of_paths: bool,
        old: Option<&Self>,
    ) -> Result<Self, Error> {
        let n: u64 = count.iter().map(|&c| c as u64).sum();
        let limit = device.info().limits.max_storage_buffer_binding_size;
        let too_large = Error::TooLarge {
            what: "nodes of the tree",
            bytes: n * size_of::<Aabb>() as u64,
            limit,
        };
        let levels = Levels::new(count).ok_or(too_large)?;
        let all = levels.total() as u64;
        let bytes = |boxes: u64| boxes * size_of::<Aabb>() as u64;
        let nodes = device.buffer_or(
            old.map(|old| &old.nodes),
            "nodes of the tree",
            bytes(all),
            U::STORAGE | U::COPY_DST | U::COPY_SRC,
        )?;
        // Where a device binds less or has no memory for them, the filters read paths.
        let of_ends = bytes(2 * levels.padded(0) as u64);
        let ends = (of_paths && of_ends <= limit).then(|| {
            let old = old.and_then(|old| old.ends.as_ref());
            device.buffer_or(old, "boxes of leaves", of_ends, U::STORAGE)
        });
        let ends = match ends.transpose() {
            Err(e) if e.is_of_memory() => None,
            other => other?,
        };
        // Nodes that only fill up a block stay as they are now.
        let empty = vec![Aabb::EMPTY; 1 << 16];
        for first in (0..all).step_by(empty.len()) {
            let n = (all - first).min(empty.len() as u64) as usize;
            let at = bytes(first);
            device.write("nodes of the tree", &nodes, at, bytemuck::cast_slice(&empty[..n]))?;
        }
        let start =
            |kind: u32| List::of_pairs(device, "first pairs of nodes", &levels.start_pairs(kind));
        Ok(Self {
            boxes: boxes(device, count, old.map(|old| &old.boxes))?,
            leaves: device.buffer_or(
                old.map(|old| &old.leaves),
                "leaves",
                if of_paths { levels.padded(0) as u64 } else { 1 } * size_of::<Leaf>() as u64,
                U::STORAGE,
            )?,
            bounds: device.buffer("bounds", 32, U::STORAGE | U::COPY_DST)?,
            curve,
            sort: Sort::new(device, n as u32, old.map(|old| &old.sort))?,
            start: [start(0)?, start(1)?],
            pairs: [Vec::new(), Vec::new()],
            descent: None,
            groups: device.groups(),
            block_limit: block_limit(device),
            levels,
            nodes,
            worlds: None,
            ends,
        })
    }

    /// Where the nodes of the trees are, for kernels; the caller sets the rest.
    pub fn record(&self) -> Blocks {
        Blocks { slots: self.levels.slots, kind: 0, level: 0, step: 1, limit: DISPATCH_LIMIT }
    }

    /// What must be zero before [`Tree::descend`] besides the headers of lists.
    pub fn clear_descent(&self, recorder: &mut Recorder) {
        if let Some(descent) = &self.descent {
            descent.clear(recorder);
        }
    }

    /// What must be zero before [`Tree::sort`].
    pub fn clear_bounds(&self, recorder: &mut Recorder) {
        match &self.worlds {
            Some(worlds) => worlds.clear(recorder),
            None => recorder.clear(&self.bounds, 32),
        }
    }

    /// Sorts all boxes by set, by world, and along the tree's curve. Of the bounds of all boxes,
    /// those of the first `n_bounding` are enough.
    pub fn sort(&self, recorder: &mut Recorder, frame: &Frame, n_bounding: u32) {
        let (boxes, bounds, n) = (&self.boxes, &self.bounds, frame.start[3]);
        let [keys, order] = self.sorted();
        if let Some(worlds) = &self.worlds {
            worlds.keys(recorder, frame, boxes, n_bounding, [keys, order]);
        } else {
            let dispatch = Dispatch { n: n_bounding, ..Dispatch::default() };
            let flag = if self.curve == Curve::Hilbert { Frame::FLAG_HILBERT } else { 0 };
            let frame = Frame { flags: frame.flags | flag, ..*frame };
            let p = Params { frame, dispatch, args: Plain::default() };
            let groups = n_bounding.div_ceil(Id::SceneBounds.threads() * morton_key::CHUNK as u32);
            recorder.dispatch(&SceneBounds { boxes, bounds }, &p, groups);
            recorder.each(&CurveKeys { boxes, bounds, keys, order }, &p, n);
        }
        recorder.stage("sort");
        self.sort.run(recorder, n);
    }

    /// Keys and numbers of all boxes, in order after the sort.
    pub fn sorted(&self) -> [&wgpu::Buffer; 2] {
        self.sort.half(0)
    }

    /// A buffer for another order of the boxes, until the next sort.
    pub fn spare_order(&self) -> &wgpu::Buffer {
        self.sort.half(1)[1]
    }

    /// The bounds of all boxes, as [`morton_key::merged`] reads them.
    pub fn bounds(&self) -> &wgpu::Buffer {
        &self.bounds
    }

    /// Leaves of features in the order of the last sort, which is kept for many steps: runs of it
    /// are put in order by halves, where they are all of one world.
    pub fn place(&self, recorder: &mut Recorder, frame: &Frame, elements: &wgpu::Buffer) {
        let (boxes, leaves, [_, order]) = (&self.boxes, &self.leaves, self.sorted());
        let (p, n) = (self.all(frame), self.levels.padded(0));
        if self.worlds.is_none() {
            recorder.each(&HalveRuns { boxes, order }, &p, n);
        }
        recorder.each(&PlaceLeaves { order, elements, leaves }, &p, n);
    }

    /// Boxes of all nodes, where boxes are all that there is, in the order of the last sort or of a
    /// builder after it.
    pub fn fit_boxes(&self, recorder: &mut Recorder, frame: &Frame) {
        let (boxes, nodes, [_, order]) = (&self.boxes, &self.nodes, self.sorted());
        recorder.each(&FitBoxes { boxes, order, nodes }, &self.all(frame), self.levels.padded(0));
        self.fit_levels(recorder, frame);
    }

    /// Parameters of a kernel with a thread for each node of a level.
    fn all(&self, frame: &Frame) -> Params<Blocks> {
        Params { frame: *frame, dispatch: Dispatch::default(), args: self.record() }
    }

    /// Boxes of all nodes over leaves that were placed, and of leaves at both ends of the step if
    /// these are wanted. Returns what a frame then says.
    ///
    /// No ends where a level stands still, of which few leaves are read at all.
    pub fn fit(&self, recorder: &mut Recorder, frame: &Frame, features: Features) -> Frame {
        let Self { boxes, nodes, leaves, .. } = self;
        let Features { bodies, paths, ends } = features;
        let wanted = ends && !frame.has(Frame::FLAG_STILL);
        let ends = self.ends.as_ref().filter(|_| wanted);
        let flag = ends.map_or(0, |_| Frame::FLAG_ENDS);
        let ends = ends.unwrap_or(&self.bounds);
        let with_ends = Frame { flags: frame.flags | flag, ..*frame };
        let kernel = FitLeaves { boxes, leaves, paths, bodies, nodes, ends };
        recorder.each(&kernel, &self.all(&with_ends), self.levels.padded(0));
        self.fit_levels(recorder, &with_ends);
        with_ends
    }

    /// Boxes of the nodes from level 2 on.
    fn fit_levels(&self, recorder: &mut Recorder, frame: &Frame) {
        let mut p = self.all(frame);
        for level in 1..self.levels.top() {
            p.args.level = level;
            recorder.each(&FitLevel { nodes: &self.nodes }, &p, self.levels.padded(level));
        }
    }

    /// Boxes of leaves at both ends; where a frame has none, any buffer.
    pub fn ends(&self) -> &wgpu::Buffer {
        self.ends.as_ref().unwrap_or(&self.leaves)
    }

    /// Pairs of blocks of these kinds that overlap; the result is in [`Tree::block_pairs`]. By
    /// workers, or level by level for all kinds, so that a device works on both at once.
    /// `keeps_order`: the order is that of the search before, whose results the host has seen.
    pub fn descend(
        &self,
        recorder: &mut Recorder,
        frame: &Frame,
        kinds: &[u32],
        keeps_order: bool,
    ) {
        if let Some(descent) = &self.descent {
            for &kind in kinds {
                let (first, pairs) = (&self.start[kind as usize], self.block_pairs(kind as usize));
                let (what, nodes) = ((frame, kind, keeps_order), (&self.levels, &self.nodes));
                block_workers::run(descent, recorder, what, nodes, first, pairs);
            }
            return;
        }
        for level in (2..=self.levels.top()).rev() {
            for &kind in kinds.iter().filter(|&&kind| level <= self.levels.start(kind)) {
                let lists = &self.pairs[kind as usize];
                let input = lists.get(level as usize - 1).unwrap_or(&self.start[kind as usize]);
                let output = &lists[level as usize - 2];
                let (nodes, groups) = (&self.nodes, self.groups.min(input.capacity()));
                let pass = Pass { kind, level, step: 1, range: ALL };
                self.each_part(frame, &pass, input, output, |p| {
                    let (input, output) = (input.buffer(), output.buffer());
                    match &self.worlds {
                        Some(Worlds { of_leaves: worlds, .. }) => recorder.dispatch(
                            &NodePairsOfWorlds { nodes, worlds, input, output },
                            p,
                            groups,
                        ),
                        None => recorder.dispatch(&NodePairs { nodes, input, output }, p, groups),
                    }
                });
            }
        }
    }

    /// Pairs of nodes of level 1.
    pub fn block_pairs(&self, kind: usize) -> &List {
        self.pairs[kind].first().unwrap_or(&self.start[kind])
    }

    /// Calls `run` with the parameters of each dispatch over the pairs of `input` that a pass looks
    /// at.
    pub fn each_part(
        &self,
        frame: &Frame,
        pass: &Pass,
        input: &List,
        output: &List,
        mut run: impl FnMut(&Params<Blocks>),
    ) {
        let &Pass { kind, level, step, ref range } = pass;
        let most = if level == 1 {
            self.block_limit.min(self.groups * BLOCK_PAIRS_A_GROUP)
        } else {
            DISPATCH_LIMIT.min(self.groups * PAIRS_A_GROUP)
        };
        let (capacity_in, capacity_out) = (input.capacity(), output.capacity());
        let end = range.end.min(capacity_in.div_ceil(step));
        for first in (range.start..end).step_by(most as usize) {
            let limit = most.min(end - first);
            let args = Blocks { kind, level, step, limit, ..self.record() };
            let dispatch = Dispatch { n: 0, first: first * step, capacity_in, capacity_out };
            run(&Params { frame: *frame, dispatch, args });
        }
    }
}

/// Pairs of blocks that one dispatch takes at most, whatever the number of workgroups.
fn block_limit(device: &Device) -> u32 {
    let is_discrete = device.info().adapter.device_type == wgpu::DeviceType::DiscreteGpu;
    if is_discrete { BLOCK_LIMIT_OF_DISCRETE } else { BLOCK_LIMIT }
}
