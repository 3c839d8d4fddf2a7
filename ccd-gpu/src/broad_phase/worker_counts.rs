//! What workers counted in a search: how busy their threads were.
//!
//! Twin: none; a CPU takes the time of descents instead (`descent_times.rs`).

use crate::device::Device;
use crate::error::Error;
use crate::readback::{Plan, Readback};
use crate::recorder::{Bench, submit};

/// What a worker of a device, a workgroup, did in the last search.
///
/// ```
/// use ccd::gpu::WorkerCounts;
///
/// /// The part of their threads that expanded a pair, over all turns.
/// fn busy(all: &[WorkerCounts]) -> f64 {
///     let (done, capacity) = all.iter().fold((0, 0), |(done, capacity), worker| {
///         let turns = u64::from(worker.turns) * u64::from(worker.width);
///         (done + u64::from(worker.expanded), capacity + turns)
///     });
///     done as f64 / capacity.max(1) as f64
/// }
/// assert_eq!(busy(&[WorkerCounts { turns: 3, expanded: 6, width: 4 }]), 0.5);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WorkerCounts {
    /// Turns in which it expanded pairs of nodes, each of at most [`WorkerCounts::width`]; of
    /// workers that steal also those in which it looked for some in vain.
    pub turns: u32,
    /// Pairs of nodes that it expanded.
    pub expanded: u32,
    /// Pairs that it can expand in a turn: of binary trees one a thread, 128; of blocks 4.
    pub width: u32,
}

/// Where workers count: two words each, [`WorkerCounts::turns`] and [`WorkerCounts::expanded`].
#[derive(Clone, Copy, Debug)]
pub struct Counted<'a> {
    pub buffer: &'a wgpu::Buffer,
    /// First byte.
    pub first: u64,
    pub workers: u32,
    /// As [`WorkerCounts::width`].
    pub width: u32,
}

/// What the workers of a source counted in the last search, those of one kind of pairs after those
/// of the other; none where no worker counts.
pub fn read(
    device: &Device,
    bench: &mut Bench,
    readback: &mut Readback,
    counts: &[Counted],
) -> Result<Vec<WorkerCounts>, Error> {
    let mut plan = Plan::default();
    let parts: Vec<_> =
        counts.iter().map(|counted| plan.part(8 * counted.workers as u64)).collect();
    let reading = readback.prepare(device, plan)?;
    submit(device, bench, |recorder| {
        for (part, counted) in parts.iter().zip(counts) {
            recorder.read(&reading, *part, counted.buffer, counted.first);
        }
    })?;
    reading.wait_with(device, |bytes| {
        let mut all = Vec::new();
        for (part, counted) in parts.iter().zip(counts) {
            all.extend(part.of(bytes).chunks_exact(8).map(|words| {
                let [turns, expanded] = bytemuck::pod_read_unaligned(words);
                WorkerCounts { turns, expanded, width: counted.width }
            }));
        }
        all
    })
}
