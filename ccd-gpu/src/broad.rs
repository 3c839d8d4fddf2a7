//! Boxes in, overlapping pairs out, on a device.

use crate::device::Device;
use crate::error::Error;
use crate::list::{HEADER_BYTES, List};
use crate::readback::Readback;
use crate::recorder::{Bench, submit};
use crate::tree::{Tree, check_countable};
use ccd_core::Aabb;
use ccd_core::aabb::GREATEST;
use ccd_core::error::check_boxes;
use ccd_core::kernel::Id;
use ccd_core::layout::{Pair, Params};
use wgpu::BufferUsages as U;

/// Finds overlapping pairs of boxes; buffers are kept from call to call.
///
/// Boxes are `f32`, closed, and each bound is at most 2.9e38 in size. Pairs come in no order.
pub struct BroadPhase {
    device: Device,
    bench: Bench,
    readback: Readback,
    tree: Option<Tree>,
    count: [u32; 3],
    pairs: List,
    none: wgpu::Buffer,
    stages: Vec<(&'static str, f64)>,
    kind: u32,
}

impl BroadPhase {
    /// A broad phase on `device`.
    pub fn new(device: &Device) -> Result<Self, Error> {
        Ok(Self {
            bench: Bench::new(device)?,
            readback: Readback::new(),
            tree: None,
            count: [0; 3],
            pairs: List::new(device, "pairs", 2, 1 << 16)?,
            none: device.buffer("nothing", 0, U::STORAGE)?,
            stages: Vec::new(),
            kind: 1,
            device: device.clone(),
        })
    }

    /// Starts or stops timing stages, see [`crate::Session::time_stages`].
    pub fn time_stages(&mut self, on: bool) -> Result<(), Error> {
        self.bench.time_stages(on)
    }

    /// Milliseconds on the device by stage, if they are timed.
    pub fn stages(&self) -> &[(&'static str, f64)] {
        &self.stages
    }

    /// All pairs of boxes that overlap, each once, the lesser index first.
    pub fn self_pairs(&mut self, boxes: &[Aabb<f32>]) -> Result<Vec<Pair>, Error> {
        let n = self.find(1, [&[], boxes, &[]])?;
        self.read(n)
    }

    /// All pairs of a box of `a` with a box of `b` that overlap.
    pub fn pairs(&mut self, a: &[Aabb<f32>], b: &[Aabb<f32>]) -> Result<Vec<Pair>, Error> {
        let n = self.find(0, [a, &[], b])?;
        self.read(n)
    }

    /// As [`BroadPhase::self_pairs`], but leaves the pairs on the device: returns their number, and the list that holds them until the next call.
    pub fn self_pairs_on_device(&mut self, boxes: &[Aabb<f32>]) -> Result<(u32, &List), Error> {
        let n = self.find(1, [&[], boxes, &[]])?;
        Ok((n, &self.pairs))
    }

    /// Fills the list of pairs; returns their number.
    fn find(&mut self, kind: u32, sets: [&[Aabb<f32>]; 3]) -> Result<u32, Error> {
        for boxes in sets {
            check_boxes(boxes, GREATEST as f64)?;
        }
        let count = sets.map(|boxes| boxes.len() as u32);
        let Self { device, bench, .. } = self;
        if self.tree.is_none() || self.count != count {
            self.tree = None;
            bench.forget();
        }
        self.count = count;
        let tree = match &mut self.tree {
            Some(tree) => tree,
            slot => slot.insert(Tree::new(device, count)?),
        };
        let mut at = 0;
        for boxes in sets {
            device.queue().write_buffer(&tree.boxes, at, bytemuck::cast_slice(boxes));
            at += size_of_val(boxes) as u64;
        }
        self.kind = kind;
        self.again()
    }

    /// The last call once more, with the boxes as they are on the device; returns the number of pairs.
    pub fn again(&mut self) -> Result<u32, Error> {
        let Self { device, bench, readback, pairs, none, tree, kind, .. } = self;
        let (kind, Some(tree)) = (*kind, tree) else { return Ok(0) };
        loop {
            let params = Params { kind, ..tree.params() };
            let heads: Vec<List> = tree.lists().chain([&*pairs]).cloned().collect();
            let parts = readback.plan(device, &vec![HEADER_BYTES; heads.len()])?;
            let stages = submit(device, bench, |recorder| {
                for list in &heads {
                    recorder.clear(list.buffer(), HEADER_BYTES);
                }
                tree.clear_bounds(recorder);
                recorder.stage("codes");
                tree.sort(recorder, &params, params.start[3]);
                recorder.stage("build");
                tree.fit(recorder, &params, none, none);
                recorder.stage("block pairs");
                tree.descend(recorder, &params);
                recorder.stage("pairs");
                let input = tree.block_pairs(kind as usize);
                tree.each_part(&params, 1, input, pairs.room(), 1, |p| {
                    let buffers = [&tree.nodes, &tree.leaves, none, none, input.buffer(), pairs.buffer()];
                    recorder.dispatch(Id::ListCandidates, p, &buffers, tree.groups.min(input.room()));
                });
                recorder.stage("read back");
                for (part, list) in parts.iter().zip(&heads) {
                    readback.copy(recorder, *part, list.buffer());
                }
            })?;
            let read = readback.read(device, &parts)?;
            self.stages = bench.times(&stages)?;
            let wanted: Vec<u32> = read.iter().map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect();
            wanted[..wanted.len() - 1].iter().try_for_each(|&n| check_countable(n))?;
            let mut grown = false;
            for (list, &wanted) in tree.pairs.iter_mut().flatten().chain([&mut *pairs]).zip(&wanted) {
                grown |= list.grow(device, wanted)?;
            }
            if !grown {
                return Ok(wanted.last().copied().unwrap_or(0));
            }
            bench.forget();
        }
    }

    fn read(&mut self, n: u32) -> Result<Vec<Pair>, Error> {
        let Self { device, bench, readback, pairs, .. } = self;
        let parts = readback.plan(device, &[pairs.bytes(n)])?;
        submit(device, bench, |recorder| readback.copy(recorder, parts[0], pairs.buffer()))?;
        let bytes = readback.read(device, &parts)?.into_iter().next().unwrap_or_default();
        Ok(bytemuck::pod_collect_to_vec(&bytes[HEADER_BYTES as usize..]))
    }
}

/// Sorts keys with their values on a device, for tests and benches.
pub struct Sorter {
    device: Device,
    bench: Bench,
    tree: Tree,
    source: [wgpu::Buffer; 2],
    n: u32,
}

impl Sorter {
    /// Room for `n` pairs.
    pub fn new(device: &Device, n: u32) -> Result<Self, Error> {
        let source = |what| device.buffer(what, 4 * n as u64, U::STORAGE | U::COPY_SRC | U::COPY_DST);
        let mut bench = Bench::new(device)?;
        bench.time_stages(true)?;
        bench.details = true;
        Ok(Self { bench, tree: Tree::new(device, [0, n, 0])?, source: [source("keys")?, source("values")?], device: device.clone(), n })
    }

    /// Sorts; returns the sorted keys and values.
    pub fn sort(&mut self, keys: &[u32], values: &[u32]) -> Result<(Vec<u32>, Vec<u32>), Error> {
        assert!(keys.len() == self.n as usize && values.len() == keys.len(), "another number of pairs than room was made for");
        self.device.queue().write_buffer(&self.source[0], 0, bytemuck::cast_slice(keys));
        self.device.queue().write_buffer(&self.source[1], 0, bytemuck::cast_slice(values));
        self.again()?;
        let mut readback = Readback::new();
        let parts = readback.plan(&self.device, &[4 * self.n as u64; 2])?;
        let (keys, values) = self.tree.sorted();
        submit(&self.device, &mut self.bench, |recorder| {
            readback.copy(recorder, parts[0], keys);
            readback.copy(recorder, parts[1], values);
        })?;
        let mut read = readback.read(&self.device, &parts)?.into_iter().map(|b| bytemuck::pod_collect_to_vec(&b));
        Ok((read.next().unwrap_or_default(), read.next().unwrap_or_default()))
    }

    /// Sorts the last input once more; milliseconds by kernel, if the device has timestamps.
    pub fn again(&mut self) -> Result<Vec<(&'static str, f64)>, Error> {
        let Self { device, bench, tree, source, n } = self;
        let (keys, values) = tree.sorted();
        let stages = submit(device, bench, |recorder| {
            recorder.copy(&source[0], 0, keys, 0, 4 * *n as u64);
            recorder.copy(&source[1], 0, values, 0, 4 * *n as u64);
            recorder.stage("sort");
            tree.sort_keys(recorder, *n);
        })?;
        device.wait()?;
        bench.times(&stages)
    }
}
