//! Static lists with balancing: tasks are dealt out, and as soon as too many workers are idle all
//! stop, and what is left on their stacks is dealt out again [Lauterbach 2010], as in algorithms
//! 3.1 to 3.4 of [da Silva 2013].
//!
//! ```text
//!   a  ######..         .  nothing left: idle         at half of the workers idle all stop,
//!   b  ############     #  expands                    and begin again with equal lists
//!   c  #####...
//!   d  ############
//! ```
//!
//! Cost: all wait for each other in every round, so that rounds should be few; and those that still
//! have work are stopped for those that have none. Where workers cannot talk to each other while
//! they run, as on a GPU through WebGPU, it is one of two ways to balance at all; the other is
//! [`super::frontier`].
//!
//! Static lists are the same where nobody is ever stopped ([`NEVER`]) [Cederman 2009], [da Silva
//! 2013], section 3.1: nothing is dealt out again, and all wait for the worker whose tasks turn out
//! to be the longest. What the other schedulers are compared with.
//!
//! Every worker expands some batches in every round before it looks at the others, so that a round
//! always gets on, however few pairs there are.

use super::{Launch, Lists, Schedule, drain};
use crate::stop::Stop;
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// Batches that a worker expands before it looks whether too many are idle.
const QUANTUM: usize = 16;

/// More workers in a hundred than there can be.
pub const NEVER: u32 = 101;

/// A stack a worker.
#[derive(Debug)]
pub struct Balanced {
    idle: usize,
    stacks: Lists,
}

impl Balanced {
    /// A round ends when so many workers in a hundred are idle.
    pub fn new(idle: u32) -> Self {
        Self { idle: idle as usize, stacks: Lists::default() }
    }
}

impl Schedule for Balanced {
    fn run(&mut self, n_workers: usize, tasks: &mut Vec<NodePair>, stop: &Stop, launch: Launch) {
        self.stacks.prepare(n_workers);
        while !tasks.is_empty() {
            self.stacks.deal(tasks);
            let (stacks, n_idle) = (&self.stacks, AtomicUsize::new(0));
            launch(&|hand| {
                let mut stack = stacks.of(hand.worker);
                loop {
                    drain(hand, &mut stack, QUANTUM);
                    if stack.is_empty() {
                        n_idle.fetch_add(1, Relaxed);
                        break;
                    }
                    if n_idle.load(Relaxed) * 100 >= self.idle * n_workers {
                        break;
                    }
                }
            });
            self.stacks.gather(tasks, stop);
        }
    }
}
