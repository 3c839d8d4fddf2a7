//! Time of descents that a scheduler shares out: what its workers do, and what is left for the
//! scheduler itself and for waiting.
//!
//! Twin: none; a GPU counts turns of workers instead (`worker_counts.rs`).

use crate::clock::Instant;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Times of descents in milliseconds.
///
/// ```text
///             split    shared out                       keep
///   worker 0  ########|ffrrffr|eeeere..erer...eeerr....|####|   f  front       e  expanding
///   worker 1          |ffffrr |eerrer..................|        r  rows        .  balancing
/// ```
///
/// ```
/// use ccd::{Mesh, Options, Session, method::{Scheduler, Scheduling}};
///
/// let stealing = Scheduling::default().scheduler(Scheduler::Stealing);
/// let options = Options::default().with_scheduling(stealing).with_threads(1);
/// let mut session = Session::new(Mesh::new(4, &[[0, 1, 2], [2, 1, 3]])?, options)?;
/// session.set_timed(true);
/// session.step(&[[0.0; 3]; 4], &[[0.0; 3]; 4])?;
/// assert!(session.descent_times().is_some());
/// # Ok::<(), ccd::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DescentTimes {
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
}

impl DescentTimes {
    /// Adds what the workers of a descent did.
    pub fn add_workers<'w>(&mut self, all: impl Iterator<Item = &'w WorkerTimes>) {
        let ms = |ns: &AtomicU64| ns.load(Relaxed) as f64 * 1e-6;
        for times in all {
            self.front += ms(&times.front);
            self.expanding += ms(&times.expanding);
            self.rows += ms(&times.rows);
        }
    }

    /// Of `shared_out`, summed over `n_workers`: the scheduler itself, looking for pairs in vain
    /// included, and waiting before a worker begins and after it is done.
    pub fn balancing(&self, n_workers: usize) -> f64 {
        let busy = self.front + self.expanding + self.rows;
        (n_workers as f64 * self.shared_out - busy).max(0.0)
    }
}

/// The time of one worker in a descent, in nanoseconds. No other thread adds to it. Rows are handed
/// on by what tests or expands pairs.
#[derive(Debug, Default)]
pub struct WorkerTimes {
    front: AtomicU64,
    expanding: AtomicU64,
    rows: AtomicU64,
}

impl WorkerTimes {
    /// Tests pairs of a front.
    pub fn front(&self, resume: impl FnOnce()) {
        self.add(&self.front, resume);
    }

    /// Expands pairs.
    pub fn expanding(&self, expand: impl FnOnce()) {
        self.add(&self.expanding, expand);
    }

    /// Hands rows on.
    pub fn rows(&self, hand_on: impl FnOnce()) {
        let start = Instant::now();
        hand_on();
        self.rows.fetch_add(start.elapsed().as_nanos() as u64, Relaxed);
    }

    /// Adds how long something takes, without the rows that it hands on.
    fn add(&self, sum: &AtomicU64, work: impl FnOnce()) {
        let (start, before) = (Instant::now(), self.rows.load(Relaxed));
        work();
        let rows = self.rows.load(Relaxed) - before;
        sum.fetch_add((start.elapsed().as_nanos() as u64).saturating_sub(rows), Relaxed);
    }
}
