//! Where the time of descents goes that a scheduler shares out: what its workers do, and for how
//! long they wait for one another.

use crate::broad_phase::scheduler::Job;
use crate::broad_phase::scheduler::hand::{Expand, Hand};
use ccd_core::broad_phase::pair_descent::NodePair;
use std::time::{Duration, Instant};

/// Where the time of descents went, in milliseconds.
///
/// ```text
///              split or front      shared out                front
///   worker 0   ##############|#####..###.######|            |######|     #  expanding
///   worker 1                 |###.#####........|------------|            .  scheduling
///                                                                       -  waiting
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DescentTimes {
    /// By the clock: expanding the upper levels into tasks.
    pub split: f64,
    /// By the clock: testing the front of the step before, and keeping or dropping this step's.
    pub front: f64,
    /// By the clock: from the first task to the end of the last worker.
    pub shared_out: f64,
    /// Of that, summed over workers: expanding pairs, with whatever takes the rows that are found.
    pub expanding: f64,
    /// Of that, summed over workers: what the scheduler does itself, looking for pairs in vain
    /// included.
    pub scheduling: f64,
    /// Of that, summed over workers: before a worker begins and after it has retired.
    pub waiting: f64,
}

impl DescentTimes {
    /// Adds what the workers of a descent did. What is left of their time is waiting.
    pub fn add_workers(&mut self, all: impl ExactSizeIterator<Item = WorkerTimes>) {
        let n_workers = all.len() as f64;
        for WorkerTimes { working, expanding } in all {
            self.expanding += expanding.as_secs_f64() * 1e3;
            self.scheduling += working.saturating_sub(expanding).as_secs_f64() * 1e3;
        }
        let busy = self.expanding + self.scheduling;
        self.waiting = (n_workers * self.shared_out - busy).max(0.0);
    }
}

/// The time of one worker.
#[derive(Clone, Copy, Debug, Default)]
pub struct WorkerTimes {
    working: Duration,
    expanding: Duration,
}

impl WorkerTimes {
    /// Does a job, and adds how long it took, and how much of that was expanding.
    pub fn job(&mut self, worker: usize, job: Job, expand: Expand) {
        let start = Instant::now();
        let expanding = &mut self.expanding;
        let mut timed = |pairs: &[NodePair], out: &mut Vec<NodePair>| {
            let start = Instant::now();
            expand(pairs, out);
            *expanding += start.elapsed();
        };
        job(&mut Hand::new(worker, &mut timed));
        self.working += start.elapsed();
    }
}
