//! Block trees over boxes on the device: sort, fit, descent to pairs of blocks.

use crate::device::Device;
use crate::error::Error;
use crate::levels::Levels;
use crate::list::List;
use crate::recorder::Recorder;
use crate::sort::Sort;
use ccd_core::Aabb;
use ccd_core::broad_phase::morton_key;
use ccd_core::kernel::Id;
use ccd_core::layout::{Leaf, Params};
use wgpu::BufferUsages as U;

/// Workgroups of kernels that take one item after another: enough for the largest GPUs; few where a CPU plays one, because each costs it some time to start.
pub fn groups(device: &Device) -> u32 {
    if device.info().adapter.device_type == wgpu::DeviceType::Cpu { 64 } else { 8192 }
}

/// Pairs of nodes that one dispatch takes at most: some milliseconds of a small device, so that no driver thinks that it hangs.
pub const DISPATCH_LIMIT: u32 = 1 << 20;

/// Trees over up to three sets of boxes, which one sort orders.
pub struct Tree {
    pub levels: Levels,
    count: [u32; 3],
    pub boxes: wgpu::Buffer,
    pub nodes: wgpu::Buffer,
    pub leaves: wgpu::Buffer,
    bounds: wgpu::Buffer,
    sort: Sort,
    /// Most workgroups of a kernel that loops over a list.
    pub groups: u32,
    /// By kind: all pairs of nodes where the descent starts.
    start: [List; 2],
    /// By kind and level below the start: pairs of nodes.
    pub pairs: [Vec<List>; 2],
}

impl Tree {
    /// Makes room for these numbers of boxes.
    pub fn new(device: &Device, count: [u32; 3]) -> Result<Self, Error> {
        let n: u64 = count.iter().map(|&c| c as u64).sum();
        let limit = device.info().limits.max_storage_buffer_binding_size;
        let too_large = Error::TooLarge { what: "nodes of the tree", bytes: n * size_of::<Aabb>() as u64, limit };
        let levels = Levels::new(count).ok_or(too_large)?;
        let nodes =
            device.buffer("nodes of the tree", levels.total() as u64 * size_of::<Aabb>() as u64, U::STORAGE | U::COPY_DST | U::COPY_SRC)?;
        // Nodes that only fill up a block stay as they are now.
        let empty = vec![Aabb::EMPTY; 1 << 16];
        let all = nodes.size() / size_of::<Aabb>() as u64;
        for first in (0..all).step_by(empty.len()) {
            let n = (all - first).min(empty.len() as u64) as usize;
            device.queue().write_buffer(&nodes, first * size_of::<Aabb>() as u64, bytemuck::cast_slice(&empty[..n]));
        }
        let start = |kind: u32| List::of_pairs(device, "first pairs of nodes", &levels.start_pairs(kind));
        let pairs = |kind: u32| -> Result<Vec<List>, Error> {
            // A node overlaps some tens of others on real scenes; what does not fit makes the list grow.
            (1..levels.start(kind))
                .map(|level| {
                    List::new(device, "pairs of nodes", 2, levels.nodes(level, if kind == 0 { 2 } else { 1 }).saturating_mul(40).max(4096))
                })
                .collect()
        };
        Ok(Self {
            boxes: device.buffer("boxes", n * size_of::<Aabb>() as u64, U::STORAGE | U::COPY_DST | U::COPY_SRC)?,
            leaves: device.buffer("leaves", levels.padded(0) as u64 * size_of::<Leaf>() as u64, U::STORAGE)?,
            bounds: device.buffer("bounds", 32, U::STORAGE | U::COPY_DST)?,
            sort: Sort::new(device, n as u32)?,
            start: [start(0)?, start(1)?],
            pairs: [pairs(0)?, pairs(1)?],
            groups: groups(device),
            levels,
            count,
            nodes,
        })
    }

    /// Parameters that say where things are; the caller sets the rest.
    pub fn params(&self) -> Params {
        let [v, e, f] = self.count;
        Params {
            count: self.count,
            start: [0, v, v + e, v + e + f],
            slots: self.levels.slots,
            step: 1,
            limit: DISPATCH_LIMIT,
            ..Params::default()
        }
    }

    /// Lists whose headers must be zero before [`Tree::descend`].
    pub fn lists(&self) -> impl Iterator<Item = &List> {
        self.pairs.iter().flatten()
    }

    /// What must be zero before [`Tree::sort`].
    pub fn clear_bounds(&self, recorder: &mut Recorder) {
        recorder.clear(&self.bounds, 32);
    }

    /// Sorts all boxes by set and along the Morton curve. Of the bounds of all boxes, those of the first `n_bounding` are enough.
    pub fn sort(&self, recorder: &mut Recorder, params: &Params, n_bounding: u32) {
        let n = params.start[3];
        let p = Params { n: n_bounding, ..*params };
        recorder.dispatch(Id::SceneBounds, &p, &[&self.boxes, &self.bounds], n_bounding.div_ceil(256 * morton_key::CHUNK as u32));
        let [keys, order] = self.sorted();
        recorder.each(Id::Morton, params, &[&self.boxes, &self.bounds, keys, order], n);
        recorder.stage("sort");
        self.sort.run(recorder, n, 32, 0);
    }

    /// Keys and numbers of all boxes; four passes of a sort end where they began.
    pub fn sorted(&self) -> [&wgpu::Buffer; 2] {
        self.sort.half(0)
    }

    /// Boxes of all nodes, in the order of the last sort.
    pub fn fit(&self, recorder: &mut Recorder, params: &Params, edges: &wgpu::Buffer, faces: &wgpu::Buffer) {
        let buffers = [&self.boxes, self.sorted()[1], edges, faces, &self.nodes, &self.leaves];
        recorder.each(Id::FitLeaves, params, &buffers, self.levels.padded(0));
        for level in 1..self.levels.top() {
            let p = Params { level, ..*params };
            recorder.each(Id::FitLevel, &p, &[&self.nodes], self.levels.padded(level));
        }
    }

    /// Pairs of blocks of these kinds that overlap; the result is in [`Tree::block_pairs`]. Level by level for all kinds, so that a device works on both at once.
    pub fn descend(&self, recorder: &mut Recorder, params: &Params, kinds: &[u32]) {
        for level in (2..=self.levels.top()).rev() {
            for &kind in kinds.iter().filter(|&&kind| level <= self.levels.start(kind)) {
                let lists = &self.pairs[kind as usize];
                let input = lists.get(level as usize - 1).unwrap_or(&self.start[kind as usize]);
                let output = &lists[level as usize - 2];
                self.each_part(&Params { kind, ..*params }, level, input, output.room(), 1, |p| {
                    recorder.dispatch(Id::NodePairs, p, &[&self.nodes, input.buffer(), output.buffer()], self.groups.min(input.room()));
                });
            }
        }
    }

    /// Pairs of nodes of level 1.
    pub fn block_pairs(&self, kind: usize) -> &List {
        self.pairs[kind].first().unwrap_or(&self.start[kind])
    }

    /// Calls `run` with the parameters of each dispatch over the pairs of `input`.
    pub fn each_part(&self, params: &Params, level: u32, input: &List, room_out: u32, step: u32, mut run: impl FnMut(&Params)) {
        let room_in = input.room();
        for part in 0..room_in.div_ceil(step).div_ceil(DISPATCH_LIMIT) {
            run(&Params { level, first: part * DISPATCH_LIMIT * step, step, limit: DISPATCH_LIMIT, room_in, room_out, ..*params });
        }
    }
}
