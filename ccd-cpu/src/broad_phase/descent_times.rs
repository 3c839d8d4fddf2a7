//! Where the time of descents goes that a scheduler shares out: what its workers do, and for how
//! long they wait for one another.
//!
//! Twin: none; a GPU counts turns of workers instead (`worker_counts.rs`).

use crate::broad_phase::scheduler::Job;
use crate::broad_phase::scheduler::hand::{Expand, Hand};
use crate::clock::Instant;
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Where the time of descents went, in milliseconds.
///
/// ```text
///             split    shared out                       keep
///   worker 0  ########|ffrrffr|eeeere..erer...eeerr    |####|   f  front       e  expanding
///   worker 1          |ffffrr |eerrer.......-----------|        r  rows        .  scheduling
///                                                               -  waiting
/// ```
///
/// ```
/// use ccd_core::model::mesh::Mesh;
/// use ccd_core::model::options::Options;
/// use ccd_core::model::scheduling::{Scheduler, Scheduling};
/// use ccd_cpu::Session;
///
/// let stealing = Scheduling::default().scheduler(Scheduler::Stealing);
/// let options = Options::default().with_scheduling(stealing).with_threads(1);
/// let mut session = Session::new(Mesh::new(4, &[[0, 1, 2], [2, 1, 3]])?, options)?;
/// session.set_timed(true);
/// session.step(&[[0.0; 3]; 4], &[[0.0; 3]; 4])?;
/// assert!(session.descent_times().is_some());
/// # Ok::<(), ccd_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DescentTimes {
    /// By the clock: expanding the upper levels into tasks.
    pub split: f64,
    /// By the clock: workers at the front of the step before, if it begins there, and at tasks.
    pub shared_out: f64,
    /// By the clock: keeping the front of this step, or dropping it.
    pub keep: f64,
    /// Of `shared_out`, summed over workers: testing pairs of the front of the step before.
    pub front: f64,
    /// Of `shared_out`, summed over workers: expanding pairs.
    pub expanding: f64,
    /// Of `shared_out`, summed over workers: whatever takes the rows of leaves that are found.
    pub rows: f64,
    /// Of `shared_out`, summed over workers: what the scheduler does itself, looking for pairs in
    /// vain included.
    pub scheduling: f64,
    /// Of `shared_out`, summed over workers: what is left, before a worker begins and after it is
    /// done.
    pub waiting: f64,
}

impl DescentTimes {
    /// Adds what the workers of a descent did; after its part by the clock.
    pub fn add_workers<'w>(&mut self, all: impl ExactSizeIterator<Item = &'w WorkerTimes>) {
        let n_workers = all.len() as f64;
        let ms = |ns: &AtomicU64| ns.load(Relaxed) as f64 * 1e-6;
        for times in all {
            self.front += ms(&times.front);
            self.expanding += ms(&times.expanding);
            self.scheduling += ms(&times.scheduling);
            self.rows += ms(&times.rows);
        }
        let busy = self.front + self.expanding + self.rows + self.scheduling;
        self.waiting = (n_workers * self.shared_out - busy).max(0.0);
    }
}

/// The time of one worker in a descent, in nanoseconds. No other thread adds to it; what adds to
/// one of the sums is called by what adds to another.
#[derive(Debug, Default)]
pub struct WorkerTimes {
    front: AtomicU64,
    expanding: AtomicU64,
    scheduling: AtomicU64,
    rows: AtomicU64,
}

impl WorkerTimes {
    /// Tests pairs of a front.
    pub fn front(&self, resume: impl FnOnce()) {
        add(&self.front, &[&self.rows], resume);
    }

    /// Hands rows on.
    pub fn rows(&self, hand_on: impl FnOnce()) {
        add(&self.rows, &[], hand_on);
    }

    /// Does a scheduler's job.
    pub fn job(&self, worker: usize, job: Job, expand: Expand) {
        let mut timed = |pairs: &[NodePair], out: &mut Vec<NodePair>| {
            add(&self.expanding, &[&self.rows], || expand(pairs, out));
        };
        let within = [&self.expanding, &self.rows];
        add(&self.scheduling, &within, || job(&mut Hand::new(worker, &mut timed)));
    }
}

/// Adds how long something takes, without what is added to other sums meanwhile.
fn add(sum: &AtomicU64, others: &[&AtomicU64], do_it: impl FnOnce()) {
    let counted = || others.iter().map(|other| other.load(Relaxed)).sum::<u64>();
    let (start, before) = (Instant::now(), counted());
    do_it();
    let own = (start.elapsed().as_nanos() as u64).saturating_sub(counted() - before);
    sum.fetch_add(own, Relaxed);
}
