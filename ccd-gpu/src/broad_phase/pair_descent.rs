//! Simultaneous traversal of binary trees from a cut on: pairs of nodes, which a scheduler shares
//! out among workgroups.
//!
//! ```text
//!   cut a  cut b          pairs of nodes: tasks of the scheduler
//!     all pairs   ------>      |
//!   that overlap           pairs of leaves: found
//! ```
//!
//! A cut is there because one pair of roots is no work for a thousand workgroups. With a front it
//! is made only where none is kept.

use super::binary_tree::BinaryTree;
use super::front::{COUNTERS, Front, Written};
use super::pair_source::kinds_of;
use super::scheduler::{self, Descended, Schedule};
use crate::bind::{CutNodes, CutPairs, CutPairsOriented};
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use crate::recorder::Recorder;
use ccd_core::broad_phase::block_bvh::sets;
use ccd_core::layout::{Frame, LIST_HEADER, NodeDescent};
use ccd_core::model::method::{Descent, Traversal};
use ccd_core::model::report::FrontCounts;
use ccd_core::model::scheduling::{self, Scheduling};
use std::ops::Range;
use wgpu::BufferUsages as U;

/// The cuts, and what expands pairs of nodes, by kind.
pub struct PairDescent {
    nodes: u32,
    rule: Descent,
    cuts: wgpu::Buffer,
    of_kind: [Option<OfKind>; 2],
    none: wgpu::Buffer,
}

struct OfKind {
    schedule: Box<dyn Schedule>,
    front: Option<Front>,
}

impl PairDescent {
    /// From cuts of so many nodes on, between sets of so many boxes.
    pub fn new(
        device: &Device,
        nodes: u32,
        rule: Descent,
        scheduling: Scheduling,
        count: [u32; 3],
    ) -> Result<Self, Error> {
        let words = 2 * (LIST_HEADER as u64 + Traversal::MAX_CUT as u64);
        let mut of_kind = [None, None];
        for kind in kinds_of(count) {
            // About as many as pairs that overlap; a list that is too short grows.
            let n = count[sets(kind)[1]].saturating_mul(4).max(4096);
            let front = match scheduling.front {
                scheduling::Front::On(options) => {
                    Some(Front::new(device, options, (2 * n).max(nodes * nodes))?)
                }
                _ => None,
            };
            let schedule = scheduler::new(device, scheduling, n)?;
            of_kind[kind as usize] = Some(OfKind { schedule, front });
        }
        let cuts = device.buffer("nodes of cuts", 4 * words, U::STORAGE)?;
        Ok(Self { nodes, rule, cuts, of_kind, none: device.buffer("no front", 0, U::STORAGE)? })
    }

    pub fn clear(&self, recorder: &mut Recorder) {
        self.of_kind.iter().flatten().for_each(|of| of.schedule.clear(recorder));
    }

    /// Lists all pairs of leaves of two trees, or of one given twice; by their oriented boxes, too,
    /// if there are. `keeps_order`: the trees are those of the search before, refitted.
    pub fn run(
        &self,
        recorder: &mut Recorder,
        (frame, kind, keeps_order): (&Frame, u32, bool),
        trees: [&BinaryTree; 2],
        oriented: Option<&wgpu::Buffer>,
        pairs: &List,
    ) {
        let Some(OfKind { schedule, front }) = &self.of_kind[kind as usize] else { return };
        let [a_nodes, b_nodes] = trees.map(|tree| &tree.nodes);
        let n_levels = self.n_levels(trees);
        let larger = (self.rule == Descent::Larger) as u32;
        let of = Descended { frame, kind, a_nodes, b_nodes, oriented, n_levels, larger, pairs };
        let (begun, written) = match front {
            Some(front) => front.begin(keeps_order),
            None => (0, Written::none(&self.none)),
        };
        match front {
            Some(front) if begun > 0 => front.resume(recorder, &of, begun, schedule.tasks()),
            _ => self.cut(recorder, &of, trees, written, schedule.tasks()),
        }
        schedule.run(recorder, &of, written);
    }

    /// Makes tasks of the pairs of two cuts that meet.
    fn cut(
        &self,
        recorder: &mut Recorder,
        of: &Descended,
        trees: [&BinaryTree; 2],
        written: Written,
        (control, tasks): (&wgpu::Buffer, &List),
    ) {
        let (a_nodes, b_nodes, front) = (of.a_nodes, of.b_nodes, written.front);
        let (cuts, room_nodes) = (&self.cuts, tasks.room());
        let own = NodeDescent { nodes: self.nodes, room_nodes, ..written.record() };
        // The order of a cut is that of the threads that were first: another cut through the same
        // tree has another one, so that pairs within a tree need one cut for both sides.
        let sides = (0..).zip(trees.into_iter().zip(sets(of.kind)));
        for (side, (tree, set)) in sides.take(if of.kind == 1 { 1 } else { 2 }) {
            let mut p = of.params(own, side, 0);
            p.own.kind = set as u32;
            recorder.dispatch(&CutNodes { branches: &tree.branches, cuts }, &p, 1);
        }
        let (output, p, n) = (tasks.buffer(), of.params(own, 0, 0), self.nodes * self.nodes);
        match of.oriented {
            None => {
                let kernel = CutPairs { a_nodes, b_nodes, cuts, control, output, front };
                recorder.each(&kernel, &p, n);
            }
            Some(oriented) => {
                let kernel =
                    CutPairsOriented { a_nodes, b_nodes, cuts, oriented, control, output, front };
                recorder.each(&kernel, &p, n);
            }
        }
    }

    /// Levels that there can be: with every step either both sides go down, or the larger one.
    fn n_levels(&self, trees: [&BinaryTree; 2]) -> u32 {
        let [a, b] = trees.map(BinaryTree::height);
        1 + if self.rule == Descent::Larger { a + b } else { a.max(b) }
    }

    pub fn lists(&self) -> Vec<&List> {
        self.of_kind.iter().flatten().flat_map(|of| of.schedule.lists()).collect()
    }

    pub fn lists_mut(&mut self) -> Vec<&mut List> {
        self.of_kind.iter_mut().flatten().flat_map(|of| of.schedule.lists_mut()).collect()
    }

    /// Bytes of buffers that [`PairDescent::settle`] wants to see.
    pub fn counters(&self) -> Vec<(&wgpu::Buffer, Range<u64>)> {
        let with_front = self.of_kind.iter().flatten().filter(|of| of.front.is_some());
        with_front.map(|of| (of.schedule.tasks().0, COUNTERS)).collect()
    }

    /// The results of a search were seen; see `PairSource::settle`.
    pub fn settle(
        &mut self,
        device: &Device,
        counted: &[Vec<u32>],
        complete: bool,
    ) -> Result<bool, Error> {
        let mut used: u64 = self.fronts().map(Front::bytes).sum();
        let (mut replaced, mut counted) = (false, counted.iter());
        for OfKind { schedule, front } in self.of_kind.iter_mut().flatten() {
            schedule.settle(device, complete)?;
            if let Some((front, words)) = front.as_mut().zip(counted.next()) {
                used -= front.bytes();
                replaced |= front.settle(device, [words[0], words[1]], complete, used)?;
                used += front.bytes();
            }
        }
        Ok(replaced)
    }

    fn fronts(&self) -> impl Iterator<Item = &Front> {
        self.of_kind.iter().flatten().filter_map(|of| of.front.as_ref())
    }

    /// What fronts the last search left, if any are kept.
    pub fn front(&self) -> Option<FrontCounts> {
        self.fronts().map(Front::counts).reduce(FrontCounts::plus)
    }

    /// What workers counted, by kind; see [`Schedule::counts`].
    pub fn worker_counts(&self) -> Vec<(&wgpu::Buffer, u64, u32)> {
        self.of_kind.iter().flatten().filter_map(|of| of.schedule.counts()).collect()
    }
}
