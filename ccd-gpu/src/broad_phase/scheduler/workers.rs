//! Workers: workgroups with a stack each, which go on until they find nothing more; see
//! [`ccd_core::broad_phase::pair_workers`].
//!
//! ```text
//!   round 0   worker 0  ######..         .  has ended     static: whose part is done, is done
//!             worker 1  ############     #  expands       self-scheduling: takes the next piece
//!             worker 2  #####...                          balanced: at so many idle ones all
//!   round 1   worker 0  ####                              stop, and what is left is dealt out
//! ```
//!
//! What a stack has no room for, and what a worker has that ends early, are tasks of the next
//! round, a dispatch. There are a few rounds; if pairs are left after the last one, the search runs
//! again with twice as many, and then with more turns a worker.
//!
//! Cost: pairs stay in workgroup memory, and there are a few dispatches rather than one a level;
//! but a worker with few pairs leaves most of its threads idle. [`Schedule::counts`] says how many
//! were busy.

use super::{Descended, Schedule};
use crate::bind::{PairWorkers, PairWorkersOriented};
use crate::broad_phase::front::Written;
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use crate::recorder::Recorder;
use ccd_core::broad_phase::pair_workers::{COUNTS, LEFT, ROUNDS, STACK, THREADS, words};
use ccd_core::layout::NodeDescent;
use wgpu::BufferUsages as U;

/// How workers find tasks, and when they end.
#[derive(Clone, Copy, Debug)]
pub struct Rule {
    /// A `TASKS_` constant of [`NodeDescent`].
    pub tasks: u32,
    /// Tasks that are taken at once from the counter, at least.
    pub piece: u32,
    /// When of all so many percent are idle, the others stop; 0: never.
    pub idle: u32,
    /// Pairs that a stack may hold, at most [`STACK`].
    pub stack: u32,
    /// Turns of a worker in a round.
    pub turns: u32,
    /// Rounds from the beginning.
    pub rounds: u32,
}

impl Rule {
    /// Every worker has a part of its own.
    pub const STATIC: Self = Self {
        tasks: NodeDescent::TASKS_DEALT,
        piece: 1,
        idle: 0,
        stack: STACK,
        turns: 4096,
        rounds: 8,
    };
    /// The same, in more rounds, with `idle` as it was chosen.
    pub const BALANCED: Self = Self { rounds: 16, ..Self::STATIC };
    /// Workers take the next tasks from a counter.
    pub const SELF_SCHEDULING: Self = Self { tasks: NodeDescent::TASKS_COUNTED, ..Self::STATIC };
    /// Nothing stays on a stack, so that a round is a level.
    pub const FRONTIER: Self =
        Self { piece: THREADS, stack: 0, rounds: 16, ..Self::SELF_SCHEDULING };
}

/// The tasks of two rounds, and what all rounds count.
pub struct Workers {
    rule: Rule,
    control: wgpu::Buffer,
    /// Tasks of two rounds, used in turn: of each entry that there is room for, a pair each.
    nodes: List,
    /// Has no entries: wants more than there is room for if pairs were left after the last round.
    left: List,
    /// Of the number of workers, the power of two.
    workers: u32,
}

/// Of the number of workgroups, the power of two: about as many as a device runs at the same time.
fn workers(device: &Device) -> u32 {
    if device.info().adapter.device_type == wgpu::DeviceType::Cpu { 4 } else { 11 }
}

impl Workers {
    /// Room for `n` tasks a round.
    pub fn new(device: &Device, rule: Rule, n: u32) -> Result<Self, Error> {
        let (workers, usage) = (workers(device), U::STORAGE | U::COPY_DST | U::COPY_SRC);
        let bytes = 4 * words(1 << workers) as u64;
        Ok(Self {
            rule,
            control: device.buffer("counters of workers", bytes, usage)?,
            nodes: List::new(device, "pairs of nodes", 4, n)?,
            left: List::new(device, "pairs that are left", 0, 0)?,
            workers,
        })
    }
}

impl Schedule for Workers {
    fn tasks(&self) -> (&wgpu::Buffer, &List) {
        (&self.control, &self.nodes)
    }

    fn clear(&self, recorder: &mut Recorder) {
        recorder.clear(&self.control, 4 * words(1 << self.workers) as u64);
    }

    fn run(&self, recorder: &mut Recorder, of: &Descended, written: Written) {
        let Self { rule, control, nodes, left, workers } = self;
        let Rule { tasks, piece, idle, stack, turns, rounds } = *rule;
        let (a_nodes, b_nodes, front) = (of.a_nodes, of.b_nodes, written.front);
        let (list, pairs) = (nodes.buffer(), of.pairs.buffer());
        for round in 0..rounds {
            let last = (round + 1 == rounds) as u32;
            let own = NodeDescent { room_nodes: nodes.room(), ..written.record() };
            let own = NodeDescent { tasks, piece, idle, stack, turns, last, ..own };
            let own = NodeDescent { workers: *workers, ..own };
            let p = of.params(own, round, 0);
            let nodes = list;
            match of.oriented {
                None => {
                    let kernel = PairWorkers { a_nodes, b_nodes, control, nodes, pairs, front };
                    recorder.dispatch(&kernel, &p, 1 << workers);
                }
                Some(oriented) => {
                    let kernel = PairWorkersOriented {
                        a_nodes,
                        b_nodes,
                        oriented,
                        control,
                        nodes,
                        pairs,
                        front,
                    };
                    recorder.dispatch(&kernel, &p, 1 << workers);
                }
            }
        }
        recorder.copy(control, 4 * LEFT as u64, left.buffer(), 0, 4);
    }

    fn lists(&self) -> Vec<&List> {
        vec![&self.nodes, &self.left]
    }

    fn lists_mut(&mut self) -> Vec<&mut List> {
        vec![&mut self.nodes, &mut self.left]
    }

    fn settle(&mut self, device: &Device, complete: bool) -> Result<(), Error> {
        if !complete && self.left.room() == u32::MAX {
            self.left = self.left.resized(device, 0)?;
            if self.rule.rounds < ROUNDS / 2 {
                self.rule.rounds *= 2;
            } else {
                self.rule.turns = self.rule.turns.saturating_mul(2);
            }
        }
        Ok(())
    }

    fn counts(&self) -> Option<(&wgpu::Buffer, u64, u32)> {
        Some((&self.control, 4 * COUNTS as u64, 1 << self.workers))
    }
}
