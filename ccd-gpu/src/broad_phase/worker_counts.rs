//! What workers counted in a search: how busy their threads were.

use super::pair_source::PairSource;
use crate::device::Device;
use crate::error::Error;
use crate::readback::{Plan, Readback};
use crate::recorder::{Bench, submit};
use ccd_core::broad_phase::pair_workers::THREADS;

/// What a worker of a device, a workgroup, did in the last search.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WorkerCounts {
    /// Turns in which it expanded pairs of nodes, each of at most [`WorkerCounts::THREADS`]; of
    /// workers that steal also those in which it looked for some in vain.
    pub turns: u32,
    /// Pairs of nodes that it expanded.
    pub expanded: u32,
}

impl WorkerCounts {
    /// Threads of a worker: the pairs that it can expand in a turn.
    pub const THREADS: u32 = THREADS;
}

/// What the workers of a source counted in the last search, those of one kind of pairs after those
/// of the other; none where no worker counts.
pub fn read(
    device: &Device,
    bench: &mut Bench,
    readback: &mut Readback,
    source: &dyn PairSource,
) -> Result<Vec<WorkerCounts>, Error> {
    let counts = source.worker_counts();
    let mut plan = Plan::default();
    let parts: Vec<_> = counts.iter().map(|of| plan.part(8 * of.2 as u64)).collect();
    let reading = readback.prepare(device, plan)?;
    submit(device, bench, |recorder| {
        for (part, (buffer, first, _)) in parts.iter().zip(&counts) {
            recorder.read(&reading, *part, buffer, *first);
        }
    })?;
    reading.with(device, |bytes| {
        let words = parts.iter().flat_map(|part| part.of(bytes).chunks_exact(8));
        let of = |w: &[u8]| bytemuck::pod_read_unaligned::<[u32; 2]>(w);
        words.map(of).map(|[turns, expanded]| WorkerCounts { turns, expanded }).collect()
    })
}
