//! Static lists: tasks are dealt out before anybody starts, and nobody takes another's
//! [Cederman 2009], [da Silva 2013], section 3.1.
//!
//! ```text
//!   tasks    0  1  2  3  4  5  6  7 ..
//!   worker   a  b  c  a  b  c  a  b
//! ```
//!
//! Cost: none for sharing out; but all wait for the worker whose tasks turn out to be the longest,
//! or whose processor has other things to do. What the other schedulers are compared with.

use super::{Launch, Lists, Schedule, drain};
use crate::stop::Stop;
use ccd_core::broad_phase::pair_descent::NodePair;

/// A stack a worker.
#[derive(Debug, Default)]
pub struct StaticLists {
    stacks: Lists,
}

impl Schedule for StaticLists {
    fn run(&mut self, n_workers: usize, tasks: &mut Vec<NodePair>, _stop: &Stop, launch: Launch) {
        self.stacks.prepare(n_workers);
        self.stacks.deal(tasks);
        let stacks = &self.stacks;
        launch(&|hand| drain(hand, &mut stacks.of(hand.worker()), usize::MAX));
    }
}
