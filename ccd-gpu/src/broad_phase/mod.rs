//! Boxes in, overlapping pairs out, on a device.

mod binary_tree;
pub mod block_bvh;
mod block_levels;
mod block_pairs;
mod block_workers;
mod box_check;
mod builder;
mod descended;
mod front;
mod key_intervals;
pub mod method;
mod oriented;
mod pair_descent;
pub mod pair_source;
mod pair_stacks;
pub mod scheduled;
mod scheduler;
mod stages;
mod sweep_by_end_points;
mod tree;
pub mod worker_counts;
pub mod worlds;

use crate::device::Device;
use crate::error::Error;
use crate::growable_list::{HEADER_BYTES, Header, List, Runs, read_header, read_pairs};
use crate::readback::{Part, Plan, Readback};
use crate::recorder::{Bench, Timing, submit, submit_frame};
use crate::staging::{Staging, Write, is_staged};
use box_check::Checked;
use ccd_core::Aabb;
use ccd_core::backend::layout::Pair;
use ccd_core::model::method::BroadPhaseMethod;
use ccd_core::model::scheduling::Scheduling;
use method::source;
use pair_source::{PairSource, Search, frame_of};
use scheduled::kinds_of;
use worker_counts::WorkerCounts;

/// Finds overlapping pairs of boxes; buffers are kept from call to call.
///
/// Boxes are `f32`, closed, and each bound is at most 2.9e38 in size. A device may take a bound
/// that is smaller than 1.2e-38 for zero, and find more pairs there. Pairs come in no order.
///
/// ```no_run
/// use ccd::{Aabb, method::BroadPhaseMethod};
/// use ccd::gpu::{BroadPhase, Device, DeviceOptions};
///
/// let device = Device::open(&DeviceOptions::default())?;
/// let mut broad_phase = BroadPhase::new(&device, BroadPhaseMethod::default())?;
/// let unit = Aabb { min: [0.0; 3], max: [1.0; 3] };
/// assert_eq!(broad_phase.self_pairs(&[unit, unit])?.len(), 1);
/// # Ok::<(), ccd::gpu::Error>(())
/// ```
pub struct BroadPhase {
    device: Device,
    method: BroadPhaseMethod,
    scheduling: Scheduling,
    bench: Bench,
    readback: Readback,
    buffers: Option<Buffers>,
    staging: Staging,
    /// Whether the boxes of a call are on the device, all of them.
    is_sent: bool,
    pairs: List,
    stages: Vec<(&'static str, f64)>,
}

/// The goal of all frames, see [`submit_frame`].
const SEARCH: u32 = 0;

/// A source for certain numbers of boxes.
struct Buffers {
    /// Boxes of the sets that a call has.
    count: [u32; 3],
    source: Box<dyn PairSource>,
}

impl BroadPhase {
    /// A broad phase on `device`.
    ///
    /// # Errors
    /// Those of [`BroadPhase::scheduled`].
    pub fn new(device: &Device, method: BroadPhaseMethod) -> Result<Self, Error> {
        Self::scheduled(device, method, Scheduling::default())
    }

    /// The same with work shared out in a way of its own. A front is written and never read: every
    /// call builds anew.
    ///
    /// # Errors
    /// [`Error::Input`] for what a GPU does not have; [`Error::Unavailable`]
    /// for a scheduler that needs another path of the device; what the device refuses.
    pub fn scheduled(
        device: &Device,
        method: BroadPhaseMethod,
        scheduling: Scheduling,
    ) -> Result<Self, Error> {
        Self::of_session(&device.limited(None), method, scheduling)
    }

    /// The same of a session, which counts its buffers.
    pub(crate) fn of_session(
        device: &Device,
        method: BroadPhaseMethod,
        scheduling: Scheduling,
    ) -> Result<Self, Error> {
        method::check(method)?;
        method::check_scheduling(method, scheduling)?;
        Ok(Self {
            method,
            scheduling,
            bench: Bench::new(device)?,
            readback: Readback::default(),
            buffers: None,
            staging: Staging::default(),
            is_sent: false,
            pairs: List::new(device, "pairs", 2, 1 << 16)?,
            stages: Vec::new(),
            device: device.clone(),
        })
    }

    /// What each call times on the device from now on.
    ///
    /// # Errors
    /// What the device refuses.
    pub fn set_timing(&mut self, timing: Timing) -> Result<(), Error> {
        self.bench.set_timing(timing)
    }

    /// Milliseconds on the device, from the first kernel to the last: of each stage or of all
    /// together.
    pub fn stages(&self) -> &[(&'static str, f64)] {
        &self.stages
    }

    /// What each worker did in the last call, those of one kind of pairs after those of the other;
    /// empty where the scheduler has no workers.
    ///
    /// # Errors
    /// What the device refuses.
    pub fn worker_counts(&mut self) -> Result<Vec<WorkerCounts>, Error> {
        let Self { device, bench, readback, buffers, .. } = self;
        let Some(Buffers { source, .. }) = buffers else { return Ok(Vec::new()) };
        worker_counts::read(device, bench, readback, &source.worker_counts())
    }

    /// All pairs of boxes that overlap, each once, the lesser index first.
    ///
    /// # Errors
    /// [`Error::Input`] with a bad box, or with too many boxes or pairs; what the device refuses,
    /// as [`Error::TooLarge`] and [`Error::Lost`].
    pub fn self_pairs(&mut self, boxes: &[Aabb<f32>]) -> Result<Vec<Pair>, Error> {
        self.device.clone().block_on(self.self_pairs_async(boxes))
    }

    /// As [`BroadPhase::self_pairs`], without blocking. Dropped before it is done, it leaves a
    /// broad phase that finds what a new one does.
    ///
    /// # Errors
    /// Those of [`BroadPhase::self_pairs`].
    pub async fn self_pairs_async(&mut self, boxes: &[Aabb<f32>]) -> Result<Vec<Pair>, Error> {
        let n = self.find([&[], boxes, &[]]).await?;
        self.read(n).await
    }

    /// All pairs of a box of `a` with a box of `b` that overlap.
    ///
    /// # Errors
    /// [`Error::Input`] with a bad box, or with too many boxes or pairs; what the device refuses,
    /// as [`Error::TooLarge`] and [`Error::Lost`].
    pub fn pairs(&mut self, a: &[Aabb<f32>], b: &[Aabb<f32>]) -> Result<Vec<Pair>, Error> {
        self.device.clone().block_on(self.pairs_async(a, b))
    }

    /// As [`BroadPhase::pairs`], without blocking; see [`BroadPhase::self_pairs_async`].
    ///
    /// # Errors
    /// Those of [`BroadPhase::pairs`].
    pub async fn pairs_async(
        &mut self,
        a: &[Aabb<f32>],
        b: &[Aabb<f32>],
    ) -> Result<Vec<Pair>, Error> {
        let n = self.find([a, &[], b]).await?;
        self.read(n).await
    }

    /// As [`BroadPhase::self_pairs`], but leaves the pairs on the device: returns their number, and
    /// the list that holds them until the next call.
    ///
    /// # Errors
    /// [`Error::Input`] with a bad box, or with too many boxes or pairs; what the device refuses,
    /// as [`Error::TooLarge`] and [`Error::Lost`].
    pub fn self_pairs_on_device(&mut self, boxes: &[Aabb<f32>]) -> Result<(u32, &List), Error> {
        let n = self.device.clone().block_on(self.find([&[], boxes, &[]]))?;
        Ok((n, &self.pairs))
    }

    /// Fills the list of pairs; returns their number.
    async fn find(&mut self, sets: [&[Aabb<f32>]; 3]) -> Result<u32, Error> {
        self.send(sets)?;
        self.search().await
    }

    /// Checks boxes and sends them to the device, by all threads of the host, and waits until they
    /// are there: [`BroadPhase::again`] then finds their pairs.
    ///
    /// # Errors
    /// Those of [`BroadPhase::self_pairs`].
    pub fn send_boxes(&mut self, boxes: &[Aabb<f32>]) -> Result<(), Error> {
        self.send([&[], boxes, &[]])?;
        self.device.queue().submit([]);
        self.device.wait()
    }

    fn send(&mut self, sets: [&[Aabb<f32>]; 3]) -> Result<(), Error> {
        let [a, b, c] = sets.map(Checked::new);
        let items = [a?, b?, c?];
        // Boxes that are not staged could not be forgotten if another one is bad.
        if !sets.iter().all(|&boxes| boxes.is_empty() || is_staged(size_of_val(boxes) as u64)) {
            items.iter().try_for_each(Checked::check_all)?;
        }
        let count = sets.map(|boxes| boxes.len() as u32);
        let was_sent = std::mem::take(&mut self.is_sent);
        let device = &self.device.clone();
        device.mend(|| {
            let mut bench = Bench::new(device)?;
            bench.set_timing(self.bench.timing())?;
            self.pairs = List::new(device, "pairs", 2, self.pairs.capacity())?;
            (self.bench, self.buffers) = (bench, None);
            self.readback = Readback::default();
            Ok(())
        })?;
        let are_others = self.buffers.as_ref().is_none_or(|b| b.count != count);
        if are_others {
            self.buffers = None;
            self.bench.forget();
        }
        let buffers = match &mut self.buffers {
            Some(buffers) => buffers,
            slot => {
                let source = source(device, self.method, self.scheduling, count)?;
                slot.insert(Buffers { count, source })
            }
        };
        let mut at = 0;
        let writes = [0, 1, 2].map(|k| {
            let to = (buffers.source.boxes(), at);
            at += size_of_val(sets[k]) as u64;
            Write { what: "boxes", to, numbers: 0..sets[k].len(), items: &items[k] }
        });
        let written = self.staging.write(device, &writes);
        let checked = items.iter().try_for_each(Checked::result);
        if written.is_err() || checked.is_err() {
            self.staging.forget();
            written?;
            // Nothing was written: the boxes of the call before are still there.
            self.is_sent = was_sent && !are_others;
            return Ok(checked?);
        }
        self.staging.submit(device)?;
        self.is_sent = true;
        Ok(())
    }

    /// The last call once more, with the boxes as they are on the device; returns the number of
    /// pairs.
    ///
    /// # Errors
    /// [`Error::NoBoxes`] before the first call, and after one whose boxes did not get there; those
    /// of [`BroadPhase::self_pairs`].
    pub fn again(&mut self) -> Result<u32, Error> {
        self.device.clone().block_on(self.search())
    }

    async fn search(&mut self) -> Result<u32, Error> {
        let Self { device, bench, readback, buffers, is_sent, pairs, .. } = self;
        let Some(Buffers { count, source }) = buffers.as_mut().filter(|_| *is_sent) else {
            return Err(Error::NoBoxes);
        };
        let frame = frame_of(*count);
        let kinds: Vec<u32> = kinds_of(*count).collect();
        let mut runs = Runs::default();
        loop {
            runs.another()?;
            let mut plan = Plan::default();
            let of_source: Vec<_> =
                source.lists().iter().map(|_| plan.part(HEADER_BYTES)).collect();
            let of_pairs = plan.part(HEADER_BYTES);
            let counters = source.counters();
            let of_counters: Vec<_> =
                counters.iter().map(|(_, range)| plan.part(range.end - range.start)).collect();
            let reading = readback.prepare(device, plan)?;
            let stages = submit_frame(device, bench, SEARCH, |recorder| {
                let lists = source.lists();
                for list in lists.iter().chain([&&*pairs]) {
                    recorder.clear(list.buffer(), HEADER_BYTES);
                }
                source.clear(recorder);
                let (n_bounding, pairs) = (frame.start[3], [&*pairs; 2]);
                let search =
                    Search { frame: &frame, kinds: &kinds, n_bounding, pairs, keeps_order: false };
                source.find(recorder, &search);
                recorder.end_of_work();
                for (part, list) in of_source.iter().zip(lists) {
                    recorder.read(&reading, *part, list.buffer(), 0);
                }
                recorder.read(&reading, of_pairs, pairs[0].buffer(), 0);
                for (part, (counters, range)) in of_counters.iter().zip(&counters) {
                    recorder.read(&reading, *part, counters, range.start);
                }
            })?;
            let read = reading.with(device, |bytes| {
                let headers = of_source.iter().map(|part| read_header(part.of(bytes)));
                let headers = headers.collect::<Result<Vec<Header>, Error>>()?;
                let words = |part: &Part| bytemuck::pod_collect_to_vec(part.of(bytes));
                let counted: Vec<Vec<u32>> = of_counters.iter().map(words).collect();
                Ok::<_, Error>((headers, read_header(of_pairs.of(bytes))?, counted))
            });
            let (of_source, found, counted) = read.await??;
            self.stages = bench.begin_times(stages)?.read().await?;
            let lists = source.lists_mut().into_iter().zip(of_source);
            let lists = lists.chain([(&mut *pairs, found)]);
            let grown = List::grow_all(device, lists.map(|(list, header)| (list, header.wanted)));
            let complete = matches!(grown, Ok(false));
            // Also where a list cannot grow: the source learns that the search was not complete.
            let settled = source.settle(device, &counted, complete);
            if !complete || !matches!(settled, Ok(false)) {
                bench.forget();
            }
            let grown = grown?;
            settled?;
            if !grown {
                return Ok(found.wanted);
            }
        }
    }

    async fn read(&mut self, n: u32) -> Result<Vec<Pair>, Error> {
        let Self { device, bench, readback, pairs, .. } = self;
        let mut plan = Plan::default();
        let part = plan.part(pairs.bytes(n));
        let reading = readback.prepare(device, plan)?;
        submit(device, bench, |recorder| recorder.read(&reading, part, pairs.buffer(), 0))?;
        reading.with(device, |bytes| read_pairs(part.of(bytes))).await
    }
}
