//! Workers: workgroups with a stack each, which go on until they find nothing more; see
//! [`ccd_core::backend::broad_phase::pair_workers`].
//!
//! ```text
//!   round 0   worker 0  ######..        .  has ended        static: whose part is done, is done
//!             worker 1  ############    #  expands          self-scheduling: takes the next piece
//!             worker 2  #####...                            balanced: at so many idle ones all
//!   balancing ----------------                              stop, what is left is dealt out
//!   round 1   worker 0  ####
//! ```
//!
//! Workers that are balanced ([`ccd_core::backend::broad_phase::balanced`]) save their stacks, a
//! kernel makes prefix sums of how many pairs there are, and another copies them to even parts.
//!
//! Workers that steal (`ccd_core::backend::scheduling::stealing`) take tasks by the counter until
//! there are no more, and then batches of each other's deques. That needs an order between
//! workgroups, which the native path alone has. Idle workers look around a bounded number of times
//! and retire.
//!
//! Pairs beyond the capacity of a stack, and those of a worker that ends early, are tasks of the
//! next round, a dispatch. There are a few rounds; if pairs are left after the last one, the search
//! runs again with twice as many, then with stacks, and then with more turns a worker.
//!
//! Cost: pairs stay in workgroup memory, and there are a few dispatches rather than one a level;
//! but a worker with few pairs leaves most of its threads idle. [`Schedule::counts`] says how many
//! were busy.

use super::Schedule;
use crate::bind::{BalanceCounts, BalancePairs};
use crate::broad_phase::descended::{self, Buffers, Descended, Written};
use crate::broad_phase::stages::BALANCING;
use crate::broad_phase::worker_counts::Counted;
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use crate::recorder::Recorder;
use ccd_core::backend::broad_phase::balanced;
use ccd_core::backend::broad_phase::pair_workers::{
    COUNTS, LEFT, ROUNDS, STACK, THREADS, words, words_with_deques,
};
use ccd_core::backend::layout::NodeDescent;
use ccd_core::backend::scheduling::stealing;
use ccd_core::model::error::check_setting;
use ccd_core::model::scheduling::WorkerOptions;
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
    /// Whether what a turn finds has its places by prefix sums.
    pub scans: bool,
    /// Turns of a worker in a round.
    pub turns: u32,
    /// Rounds from the beginning.
    pub rounds: u32,
    /// How workers steal, if they do.
    pub steal: Option<Steal>,
    /// Workers, a power of two; 0: about as many as a device runs at the same time.
    pub workers: u32,
}

/// How workers steal from each other.
#[derive(Clone, Copy, Debug)]
pub struct Steal {
    /// Batches that fit in a deque.
    pub batches: u32,
    /// Pairs of a batch, at most as many as a worker expands in a turn.
    pub batch: u32,
    /// Batches that are stolen from one deque at once, at most; 0: one, of one worker alone.
    pub most: u32,
    /// Pairs of a stack from which on a batch is pushed, at least two batches.
    pub push: u32,
    /// Looks for work in vain after which a worker retires.
    pub patience: u32,
}

impl Steal {
    /// One batch at a time; what a turn does not need is there to be stolen.
    pub const TASKS: Self =
        Self { batches: 16, batch: THREADS / 2, most: 0, push: THREADS, patience: 32 };
    /// Ranges of many workers at once; more stays on the stack.
    pub const LAZY: Self = Self { most: 2, push: 2 * THREADS, ..Self::TASKS };
}

impl Rule {
    /// Every worker has a part of its own.
    pub const STATIC: Self = Self {
        tasks: NodeDescent::TASKS_DEALT,
        piece: 1,
        idle: 0,
        stack: STACK,
        scans: false,
        turns: 4096,
        rounds: 8,
        steal: None,
        workers: 0,
    };
    /// The same by prefix sums.
    pub const PREFIX_SUMS: Self = Self { scans: true, ..Self::STATIC };
    /// As static, in more rounds, with `idle` as it was chosen: between two all is dealt out again.
    pub const BALANCED: Self =
        Self { tasks: NodeDescent::TASKS_BALANCED, rounds: 16, ..Self::STATIC };
    /// Workers take the next tasks from a counter.
    pub const SELF_SCHEDULING: Self = Self { tasks: NodeDescent::TASKS_COUNTED, ..Self::STATIC };
    /// Nothing stays on a stack, so that a round is a level.
    pub const FRONTIER: Self =
        Self { piece: THREADS, stack: 0, rounds: 16, ..Self::SELF_SCHEDULING };
    /// Workers steal when there are no more tasks.
    pub const STEALING: Self = Self { steal: Some(Steal::TASKS), ..Self::SELF_SCHEDULING };
    /// The same, lazily.
    pub const LAZY_STEALING: Self = Self { steal: Some(Steal::LAZY), ..Self::SELF_SCHEDULING };
}

impl Rule {
    /// The same with what was chosen of workers.
    ///
    /// # Errors
    /// [`ccd_core::Error::Setting`] for fewer than 16 workers.
    pub fn with(self, options: WorkerOptions) -> Result<Self, Error> {
        let WorkerOptions { workers, stack, batch, threshold, .. } = options;
        if workers > 0 {
            check_setting("workers of a GPU", workers, MIN_WORKERS, WorkerOptions::MAX_WORKERS)?;
        }
        let or = |chosen: u32, default: u32| if chosen > 0 { chosen } else { default };
        let steal = self.steal.map(|steal| Steal {
            batch: or(batch, steal.batch),
            push: or(threshold, steal.push),
            ..steal
        });
        // Without stacks there is nothing to choose.
        let stack = if self.stack > 0 { or(stack, self.stack) } else { 0 };
        let workers = if workers > 0 { workers.next_power_of_two() } else { 0 };
        Ok(Self { steal, stack, workers, ..self })
    }

    /// Pairs were left after the last round.
    fn lengthen(&mut self) {
        if self.rounds < ROUNDS / 2 {
            self.rounds *= 2;
        } else if self.stack == 0 {
            // A round is a level, and there are more levels than rounds: more turns do not help,
            // but workers that descend within a round do.
            self.stack = STACK;
        } else {
            self.turns = self.turns.saturating_mul(2);
        }
    }
}

impl Steal {
    /// The same in parts of a turn, for workers that expand so many pairs in one.
    fn of_width(self, width: u32) -> Self {
        let part = |n: u32| (n * width / THREADS).max(1);
        let batch = part(self.batch);
        Self { batch, push: part(self.push).max(2 * batch), ..self }
    }
}

/// The tasks of two rounds, and what all rounds count.
pub struct Workers {
    rule: Rule,
    /// Pairs that a worker expands in a turn.
    width: u32,
    control: wgpu::Buffer,
    /// Tasks of two rounds, used in turn: an entry has a pair of each.
    nodes: List,
    /// A list without entries: some are wanted if pairs were left after the last round, and then
    /// the search is not complete.
    left: List,
    /// log2 of the number of workers.
    workers: u32,
}

/// Fewest workers that can be chosen.
const MIN_WORKERS: u32 = 16;

/// log2 of the number of workgroups: about as many as a device runs at the same time.
fn workers(device: &Device) -> u32 {
    if device.info().adapter.device_type == wgpu::DeviceType::Cpu { 4 } else { 11 }
}

/// Bytes of what `2^workers` workers count, and of their deques: what a search clears.
fn bytes(rule: Rule, workers: u32) -> u64 {
    let words = match rule.steal {
        None => words(1 << workers),
        Some(Steal { batches, batch, .. }) => {
            words_with_deques(stealing::Workers { n: 1 << workers, batches, batch })
        }
    };
    4 * words as u64
}

impl Workers {
    /// For `n` tasks a round. `width`: pairs that a worker expands in a turn.
    pub fn new(device: &Device, rule: Rule, width: u32, n: u32) -> Result<Self, Error> {
        if rule.steal.is_some() {
            device.check_native()?;
        }
        let rule = Rule { steal: rule.steal.map(|steal| steal.of_width(width)), ..rule };
        let short = device.faults().short_rounds;
        let rule = if short { Rule { rounds: 1, turns: 1, ..rule } } else { rule };
        let workers = match rule.workers.checked_ilog2() {
            _ if short => 1,
            Some(chosen) => chosen,
            None => workers(device),
        };
        let usage = U::STORAGE | U::COPY_DST | U::COPY_SRC;
        let bytes = match rule.tasks {
            // Stacks are saved behind the counters, and written before they are read.
            NodeDescent::TASKS_BALANCED => 4 * balanced::words(workers) as u64,
            _ => bytes(rule, workers),
        };
        Ok(Self {
            rule,
            width,
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
        recorder.clear(&self.control, bytes(self.rule, self.workers));
    }

    fn run(&self, recorder: &mut Recorder, descent: &Descended, written: Written) {
        let Self { rule, control, nodes, left, workers, .. } = self;
        let Rule { tasks, piece, idle, stack, scans, turns, rounds, steal, .. } = *rule;
        let mut args = NodeDescent {
            capacity_nodes: nodes.capacity(),
            workers: *workers,
            tasks,
            piece,
            idle,
            stack,
            scans: scans as u32,
            turns,
            ..written.args
        };
        if let Some(Steal { batches, batch, most, push, patience }) = steal {
            args = NodeDescent { batches, batch, most, push, patience, ..args };
        }
        let buffers = Buffers { control, nodes: nodes.buffer(), front: written.front };
        let (stage, nodes) = (recorder.current_stage(), buffers.nodes);
        for round in 0..rounds {
            // Without stacks a round is a level, and nothing of it is balancing; where a kernel of
            // its own balances, that alone is.
            if round == 1 && stack > 0 && tasks != NodeDescent::TASKS_BALANCED {
                recorder.stage(BALANCING[descent.kind as usize]);
            }
            args.last = (round + 1 == rounds) as u32;
            let p = descent.params(args, round, 0);
            descended::round(recorder, descent, buffers, &p, 1 << workers);
            if tasks == NodeDescent::TASKS_BALANCED {
                recorder.stage(BALANCING[descent.kind as usize]);
                recorder.dispatch(&BalanceCounts { control, nodes }, &p, 1);
                recorder.dispatch(&BalancePairs { control, nodes }, &p, 1 << workers);
                stage.filter(|_| args.last == 0).into_iter().for_each(|name| recorder.stage(name));
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

    fn settle(&mut self, complete: bool) {
        if !complete && self.left.was_short() {
            self.rule.lengthen();
        }
    }

    fn counts(&self) -> Option<Counted<'_>> {
        let (buffer, width) = (&self.control, self.width);
        Some(Counted { buffer, first: 4 * COUNTS as u64, workers: 1 << self.workers, width })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_levels_than_rounds_need_a_stack() {
        let mut rule = Rule::FRONTIER;
        let lengths = [(); 6].map(|()| {
            rule.lengthen();
            (rule.rounds, rule.stack, rule.turns)
        });
        let turns = Rule::FRONTIER.turns;
        assert_eq!(lengths[2..5], [(128, 0, turns), (256, 0, turns), (256, STACK, turns)]);
        assert_eq!(lengths[5], (256, STACK, 2 * turns));
    }
}
