//! Self-scheduling: workers take tasks from a shared counter, and finish each before they take the
//! next [Tang 1986].
//!
//! ```text
//!   tasks    0  1  2  3  4  5  6  7 ..          counter: 5
//!   worker   a  b  a  c  b                      whoever is done next takes task 5
//! ```
//!
//! Cost: one atomic addition a task, and at the end workers are idle for at most as long as the
//! longest task takes. Choose it where there are many more tasks than workers and none is most of
//! the work. By blocks it is the default, in a form that is compiled into what takes the pairs, and
//! that has neighbours done by one worker ([`crate::broad_phase::tasks`]).

use super::{Launch, Lists, Schedule, drain};
use crate::stop::Stop;
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// A stack a worker.
#[derive(Debug, Default)]
pub struct SelfScheduling {
    stacks: Lists,
}

impl Schedule for SelfScheduling {
    fn run(&mut self, n_workers: usize, tasks: &mut Vec<NodePair>, _stop: &Stop, launch: Launch) {
        self.stacks.prepare(n_workers);
        let (stacks, counter, all) = (&self.stacks, AtomicUsize::new(0), &*tasks);
        launch(&|hand| {
            let mut stack = stacks.of(hand.worker);
            while let Some(&task) = all.get(counter.fetch_add(1, Relaxed)) {
                stack.push(task);
                drain(hand, &mut stack, usize::MAX);
            }
        });
        tasks.clear();
    }
}
