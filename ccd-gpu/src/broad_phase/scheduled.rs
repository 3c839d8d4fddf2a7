//! A schedule and a front for each kind of pairs, of binary trees or of blocks.

use super::descended::{self, Buffers, Descended, Written};
use super::front::{COUNTERS, Front};
use super::scheduler::{self, Schedule};
use super::stages::{FRONT, PAIRS};
use super::worker_counts::Counted;
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use crate::recorder::Recorder;
use ccd_core::backend::broad_phase::block_bvh::sets;
use ccd_core::backend::layout::NodeDescent;
use ccd_core::model::report::FrontCounts;
use ccd_core::model::scheduling::{self, Scheduling};
use std::ops::Range;
use wgpu::BufferUsages as U;

/// Schedules and fronts by kind.
pub struct Scheduled {
    of_kind: [Option<OfKind>; 2],
    none: wgpu::Buffer,
}

struct OfKind {
    schedule: Box<dyn Schedule>,
    front: Option<Front>,
}

impl Scheduled {
    /// For the kinds of pairs between sets of so many boxes. `width`: pairs that a worker expands
    /// in a turn; `capacity`: tasks of a round, by the boxes of the second side; `front`: the
    /// least capacity of a front at first.
    pub fn new(
        device: &Device,
        scheduling: Scheduling,
        width: u32,
        count: [u32; 3],
        capacity: impl Fn(u32) -> u32,
        front: u32,
    ) -> Result<Self, Error> {
        let mut of_kind = [None, None];
        for kind in kinds_of(count) {
            let n = capacity(count[sets(kind)[1]]);
            let front = match scheduling.front {
                scheduling::Front::On(options) => {
                    Some(Front::new(device, options, n.saturating_mul(2).max(front))?)
                }
                _ => None,
            };
            let schedule = scheduler::new(device, scheduling, width, n)?;
            of_kind[kind as usize] = Some(OfKind { schedule, front });
        }
        Ok(Self { of_kind, none: device.buffer("no front", 0, U::STORAGE)? })
    }

    pub fn clear(&self, recorder: &mut Recorder) {
        self.of_kind.iter().flatten().for_each(|kind| kind.schedule.clear(recorder));
    }

    /// Lists all pairs of leaves. A search begins with the pairs of a front where one is kept
    /// (`keeps_order`: the trees are those of the search before, refitted), and else with those
    /// that `first` makes tasks of, or pairs, or the beginning of a front.
    pub fn run(
        &self,
        recorder: &mut Recorder,
        descent: &Descended,
        keeps_order: bool,
        first: impl FnOnce(&mut Recorder, Written, (&wgpu::Buffer, &List)),
    ) {
        let Some(OfKind { schedule, front }) = &self.of_kind[descent.kind as usize] else { return };
        let (begun, written) = match front {
            Some(front) => front.begin(keeps_order),
            None => (0, Written { front: &self.none, args: NodeDescent::default() }),
        };
        let ((control, tasks), kind) = (schedule.tasks(), descent.kind as usize);
        recorder.stage(if begun > 0 { FRONT[kind] } else { PAIRS[kind] });
        if begun > 0 {
            let args = NodeDescent { capacity_nodes: tasks.capacity(), ..written.args };
            let buffers = Buffers { control, nodes: tasks.buffer(), front: written.front };
            descended::resume(recorder, descent, buffers, &descent.params(args, 0, begun));
            recorder.stage(PAIRS[kind]);
        } else {
            first(recorder, written, (control, tasks));
        }
        schedule.run(recorder, descent, written);
    }

    pub fn lists(&self) -> Vec<&List> {
        self.of_kind.iter().flatten().flat_map(|kind| kind.schedule.lists()).collect()
    }

    pub fn lists_mut(&mut self) -> Vec<&mut List> {
        self.of_kind.iter_mut().flatten().flat_map(|kind| kind.schedule.lists_mut()).collect()
    }

    /// Bytes of buffers that [`Scheduled::settle`] wants to see.
    pub fn counters(&self) -> Vec<(&wgpu::Buffer, Range<u64>)> {
        let with_front = self.of_kind.iter().flatten().filter(|kind| kind.front.is_some());
        with_front.map(|kind| (kind.schedule.tasks().0, COUNTERS)).collect()
    }

    /// The results of a search were seen; see `PairSource::settle`.
    pub fn settle(
        &mut self,
        device: &Device,
        counted: &[Vec<u32>],
        complete: bool,
    ) -> Result<bool, Error> {
        let mut used: u64 = self.fronts().map(Front::bytes).sum();
        let (mut replaced, mut counted) = (Ok(false), counted.iter());
        // Both kinds, also if one fails: each has to know what became of its search.
        for OfKind { schedule, front } in self.of_kind.iter_mut().flatten() {
            schedule.settle(complete);
            if let Some((front, words)) = front.as_mut().zip(counted.next()) {
                used -= front.bytes();
                let settled = front.settle(device, [words[0], words[1]], complete, used);
                replaced = replaced.and_then(|replaced| Ok(replaced | settled?));
                used += front.bytes();
            }
        }
        replaced
    }

    fn fronts(&self) -> impl Iterator<Item = &Front> {
        self.of_kind.iter().flatten().filter_map(|kind| kind.front.as_ref())
    }

    /// What fronts the last search left, if any are kept.
    pub fn front(&self) -> Option<FrontCounts> {
        self.fronts().map(Front::counts).reduce(FrontCounts::plus)
    }

    /// What workers counted, by kind; see [`Schedule::counts`].
    pub fn worker_counts(&self) -> Vec<Counted<'_>> {
        self.of_kind.iter().flatten().filter_map(|kind| kind.schedule.counts()).collect()
    }
}

/// The kinds of pairs that there can be between sets of so many boxes.
pub fn kinds_of(count: [u32; 3]) -> impl Iterator<Item = u32> {
    let some = [count[0] > 0 && count[2] > 0, count[1] > 1];
    (0..2).filter(move |&kind| some[kind as usize])
}
