//! Boxes in, overlapping pairs out, on a device.

pub mod block_bvh;
mod block_levels;
mod radix_tree;
mod upload;

use crate::bind::ListCandidates;
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::{HEADER_BYTES, Header, List, read_header, read_pairs};
use crate::readback::{Plan, Readback};
use crate::recorder::{Bench, Recorder, Timing, submit};
use block_bvh::{Pass, Tree};
use ccd_core::Aabb;
use ccd_core::layout::Pair;
use ccd_core::model::method::BroadPhaseMethod;
use radix_tree::RadixTree;
use wgpu::BufferUsages as U;

/// Finds overlapping pairs of boxes; buffers are kept from call to call.
///
/// Boxes are `f32`, closed, and each bound is at most 2.9e38 in size. Pairs come in no order.
pub struct BroadPhase {
    device: Device,
    method: BroadPhaseMethod,
    bench: Bench,
    readback: Readback,
    buffers: Option<Buffers>,
    pairs: List,
    none: wgpu::Buffer,
    stages: Vec<(&'static str, f64)>,
}

/// What is made for certain numbers of boxes.
struct Buffers {
    /// Boxes of the sets that a call has.
    count: [u32; 3],
    blocks: Tree,
    tree: Option<Binary>,
}

/// The binary tree over one set, and the boxes of the other, which stay loose.
struct Binary {
    tree: RadixTree,
    loose: Option<wgpu::Buffer>,
}

impl BroadPhase {
    /// A broad phase on `device`. A [`BroadPhaseMethod::Tree`] needs two boxes; fewer are done by
    /// blocks.
    pub fn new(device: &Device, method: BroadPhaseMethod) -> Result<Self, Error> {
        method.check()?;
        if let Some(name) = method.lacking("gpu") {
            return Err(ccd_core::Error::Method { name, backend: "gpu" }.into());
        }
        Ok(Self {
            method,
            bench: Bench::new(device)?,
            readback: Readback::default(),
            buffers: None,
            pairs: List::new(device, "pairs", 2, 1 << 16)?,
            none: device.buffer("nothing", 0, U::STORAGE)?,
            stages: Vec::new(),
            device: device.clone(),
        })
    }

    /// What each call times on the device from now on.
    pub fn set_timing(&mut self, timing: Timing) -> Result<(), Error> {
        self.bench.set_timing(timing)
    }

    /// Milliseconds on the device, from the first kernel to the last: of each stage or of all
    /// together.
    pub fn stages(&self) -> &[(&'static str, f64)] {
        &self.stages
    }

    /// All pairs of boxes that overlap, each once, the lesser index first.
    pub fn self_pairs(&mut self, boxes: &[Aabb<f32>]) -> Result<Vec<Pair>, Error> {
        let n = self.find([&[], boxes, &[]])?;
        self.read(n)
    }

    /// All pairs of a box of `a` with a box of `b` that overlap.
    pub fn pairs(&mut self, a: &[Aabb<f32>], b: &[Aabb<f32>]) -> Result<Vec<Pair>, Error> {
        let n = self.find([a, &[], b])?;
        self.read(n)
    }

    /// As [`BroadPhase::self_pairs`], but leaves the pairs on the device: returns their number, and
    /// the list that holds them until the next call.
    pub fn self_pairs_on_device(&mut self, boxes: &[Aabb<f32>]) -> Result<(u32, &List), Error> {
        let n = self.find([&[], boxes, &[]])?;
        Ok((n, &self.pairs))
    }

    /// Fills the list of pairs; returns their number.
    fn find(&mut self, sets: [&[Aabb<f32>]; 3]) -> Result<u32, Error> {
        self.send(sets)?;
        self.again()
    }

    /// Checks boxes and sends them to the device, by all threads of the host, and waits until they
    /// are there: [`BroadPhase::again`] then finds their pairs.
    pub fn send_boxes(&mut self, boxes: &[Aabb<f32>]) -> Result<(), Error> {
        self.send([&[], boxes, &[]])?;
        self.device.queue().submit([]);
        self.device.wait()
    }

    fn send(&mut self, sets: [&[Aabb<f32>]; 3]) -> Result<(), Error> {
        for boxes in sets {
            upload::check(boxes)?;
        }
        let count = sets.map(|boxes| boxes.len() as u32);
        let device = &self.device;
        if self.buffers.as_ref().is_none_or(|b| b.count != count) {
            self.buffers = None;
            self.bench.forget();
        }
        let buffers = match &mut self.buffers {
            Some(buffers) => buffers,
            slot => slot.insert(Buffers::new(device, self.method, count)?),
        };
        let send = |to, at, boxes| upload::send(device, to, at, boxes);
        match &buffers.tree {
            None => {
                let mut at = 0;
                for boxes in sets {
                    send(&buffers.blocks.boxes, at, boxes);
                    at += size_of_val(boxes) as u64;
                }
            }
            Some(Binary { loose: None, .. }) => send(&buffers.blocks.boxes, 0, sets[1]),
            Some(Binary { loose: Some(loose), .. }) => {
                send(loose, 0, sets[0]);
                send(&buffers.blocks.boxes, 0, sets[2]);
            }
        }
        Ok(())
    }

    /// The last call once more, with the boxes as they are on the device; returns the number of
    /// pairs.
    pub fn again(&mut self) -> Result<u32, Error> {
        let Self { device, bench, readback, buffers, pairs, none, .. } = self;
        let Some(buffers) = buffers else { return Ok(0) };
        loop {
            let mut plan = Plan::default();
            let of_descent: Vec<_> =
                buffers.blocks.lists().map(|_| plan.part(HEADER_BYTES)).collect();
            let of_pairs = plan.part(HEADER_BYTES);
            let reading = readback.prepare(device, plan)?;
            let stages = submit(device, bench, |recorder| {
                for list in buffers.blocks.lists().chain([&*pairs]) {
                    recorder.clear(list.buffer(), HEADER_BYTES);
                }
                buffers.record(recorder, pairs, none);
                recorder.end_of_work();
                for (part, list) in of_descent.iter().zip(buffers.blocks.lists()) {
                    recorder.read(&reading, *part, list.buffer(), 0);
                }
                recorder.read(&reading, of_pairs, pairs.buffer(), 0);
            })?;
            let (of_descent, found) =
                reading.with(device, |bytes| -> Result<(Vec<Header>, Header), Error> {
                    let of_descent = of_descent
                        .iter()
                        .map(|part| read_header(part.of(bytes)))
                        .collect::<Result<_, _>>()?;
                    Ok((of_descent, read_header(of_pairs.of(bytes))?))
                })??;
            self.stages = bench.times(&stages)?;
            let mut grown = pairs.grow(device, found.wanted)?;
            for (list, header) in buffers.blocks.pairs.iter_mut().flatten().zip(&of_descent) {
                grown |= list.grow(device, header.wanted)?;
            }
            if !grown {
                return Ok(found.wanted);
            }
            bench.forget();
        }
    }

    fn read(&mut self, n: u32) -> Result<Vec<Pair>, Error> {
        let Self { device, bench, readback, pairs, .. } = self;
        let mut plan = Plan::default();
        let part = plan.part(pairs.bytes(n));
        let reading = readback.prepare(device, plan)?;
        submit(device, bench, |recorder| recorder.read(&reading, part, pairs.buffer(), 0))?;
        reading.with(device, |bytes| read_pairs(part.of(bytes)))
    }
}

impl Buffers {
    fn new(device: &Device, method: BroadPhaseMethod, count: [u32; 3]) -> Result<Self, Error> {
        let [a, within, b] = count;
        // The tree is over the one set there is, or over the second of two.
        let n = within.max(b);
        if method == BroadPhaseMethod::Blocks || n < 2 {
            return Ok(Self { count, blocks: Tree::new(device, count)?, tree: None });
        }
        let usage = U::STORAGE | U::COPY_DST;
        let loose = (within == 0)
            .then(|| device.buffer("loose boxes", a as u64 * size_of::<Aabb>() as u64, usage))
            .transpose()?;
        Ok(Self {
            count,
            blocks: Tree::new(device, [0, n, 0])?,
            tree: Some(Binary { tree: RadixTree::new(device, n)?, loose }),
        })
    }

    /// Everything from boxes to pairs.
    fn record(&self, recorder: &mut Recorder, pairs: &List, none: &wgpu::Buffer) {
        let Self { count, blocks, tree } = self;
        let kind = if count[1] > 0 { 1 } else { 0 };
        let frame = blocks.frame();
        blocks.clear_bounds(recorder);
        if let Some(Binary { tree, .. }) = tree {
            tree.clear(recorder);
        }
        recorder.stage("codes");
        blocks.sort(recorder, &frame, frame.start[3]);
        recorder.stage("build");
        blocks.fit(recorder, &frame, none, none);
        if let Some(Binary { tree, loose }) = tree {
            tree.build(recorder, &frame, blocks);
            recorder.stage("pairs");
            match loose {
                None => tree.self_pairs(recorder, &frame, blocks, pairs),
                Some(loose) => tree.pairs_with(recorder, &frame, blocks, (loose, count[0]), pairs),
            }
            return;
        }
        recorder.stage("block pairs");
        blocks.descend(recorder, &frame, &[kind]);
        recorder.stage("pairs");
        let input = blocks.block_pairs(kind as usize);
        let kernel = ListCandidates {
            nodes: &blocks.nodes,
            leaves: &blocks.leaves,
            bodies: none,
            keys: none,
            input: input.buffer(),
            output: pairs.buffer(),
        };
        blocks.each_part(&frame, Pass { kind, level: 1, step: 1 }, input, pairs, |p| {
            recorder.dispatch(&kernel, p, blocks.groups.min(input.room()));
        });
    }
}
