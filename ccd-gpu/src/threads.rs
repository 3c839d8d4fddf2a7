//! The host's part of a step by several threads, which are kept.
//!
//! To start one takes longer than many a stage does. They are this crate's own, so that no step
//! waits for what a program does in rayon's pool.
//! Twin: the file of this name of ccd-cpu, whose work is all of a step.

use rayon::{ThreadPool, ThreadPoolBuilder};
use std::iter::repeat_n;
use std::process;
use std::sync::{Mutex, OnceLock};

/// Threads that copy: more wait for memory, or for the one that wakes them.
const MOST: usize = 12;

/// How many threads there are for a step, the calling one too.
fn available() -> usize {
    pool().map_or(1, |pool| pool.current_num_threads() + 1)
}

/// Calls `work`, which mostly copies, with each part, on this thread and others. A part is worth
/// the time to wake a thread: some tens of microseconds.
pub fn copy<P: Send>(parts: impl ExactSizeIterator<Item = P> + Send, work: impl Fn(P) + Sync) {
    on_threads(MOST.min(available()), parts, work);
}

/// How many of `n` things make a part, so that there are eight parts for each thread: where there
/// are thousands, threads wait for each other to take the next one longer than they work.
pub fn share(n: usize) -> usize {
    n.div_ceil(8 * available()).max(1)
}

/// As [`copy`], for work that mostly computes: by all threads.
pub fn each<P: Send>(parts: impl ExactSizeIterator<Item = P> + Send, work: impl Fn(P) + Sync) {
    on_threads(available(), parts, work);
}

fn on_threads<P: Send>(
    n: usize,
    parts: impl ExactSizeIterator<Item = P> + Send,
    work: impl Fn(P) + Sync,
) {
    let others = n.min(parts.len()).saturating_sub(1);
    let parts = Mutex::new(parts);
    let next = || parts.lock().unwrap_or_else(|e| e.into_inner()).next();
    let work = || {
        while let Some(part) = next() {
            work(part);
        }
    };
    match pool().filter(|_| others > 0) {
        Some(pool) => pool.in_place_scope(|scope| {
            repeat_n(&work, others).for_each(|work| scope.spawn(|_| work()));
            work();
        }),
        None => work(),
    }
}

/// The other threads, if there are any: none in a process forked from that of the pool.
fn pool() -> Option<&'static ThreadPool> {
    static POOL: OnceLock<Option<(u32, ThreadPool)>> = OnceLock::new();
    let start = || {
        let others = std::thread::available_parallelism().map_or(1, |n| n.get()) - 1;
        let threads = ThreadPoolBuilder::new().num_threads(others);
        let named = threads.thread_name(|i| format!("ccd-gpu {i}"));
        // Without them this thread does everything.
        let pool = (others > 0).then(|| named.build().ok()).flatten();
        pool.map(|pool| (process::id(), pool))
    };
    let here = |&(of, _): &&(u32, _)| *of == process::id();
    POOL.get_or_init(start).as_ref().filter(here).map(|(_, pool)| pool)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_part_is_worked_on_once() {
        for n in [0, 1, 2, 3, 1000] {
            let mut counts = vec![0; n];
            each(counts.iter_mut(), |count| *count += 1);
            assert!(counts.iter().all(|&count| count == 1), "{n}");
        }
    }

    #[test]
    fn a_panic_comes_back() {
        let panics = || each(0..100usize, |i| assert!(i != 77));
        assert!(std::panic::catch_unwind(panics).is_err());
    }
}
