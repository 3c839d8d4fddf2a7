//! Every pair once, by every scheduler, on any number of workers, in deques of any capacity.

use super::abp_stealing::abp_stealing;
use super::balanced::{Balanced, NEVER};
use super::lazy_stealing::LazyStealing;
use super::self_scheduling::SelfScheduling;
use super::shared_queue::{blocking, lock_free};
use super::stealing::stealing;
use super::*;
use crate::broad_phase::scheduled::scheduler_of;
use crate::threads::Threads;
use ccd_core::model::catalogue::Catalogued;
use ccd_core::model::scheduling::{Scheduler, WorkerOptions};
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

/// A tree of pairs of which nobody can see beforehand what is below a pair: `[depth, number]` has
/// up to four children, by the bits of a hash; most pairs have one or none, a few have all.
fn children([depth, number]: NodePair) -> impl Iterator<Item = NodePair> {
    let hash = (number ^ depth << 20).wrapping_mul(747_796_405).rotate_left(13) ^ number >> 3;
    let n = if depth == 0 { 0 } else { [4, 1, 2, 3, 1, 2, 4, 1][hash as usize % 8] };
    (0..n).map(move |k| [depth - 1, (4 * number + k) % N_PAIRS])
}

const N_PAIRS: u32 = 1 << 14;

/// How often each pair is met below the tasks, summed over all depths.
fn walk(tasks: &[NodePair]) -> Vec<u32> {
    let (mut seen, mut stack) = (vec![0; N_PAIRS as usize], tasks.to_vec());
    while let Some(pair) = stack.pop() {
        seen[pair[1] as usize] += 1;
        stack.extend(children(pair));
    }
    seen
}

/// The same by a scheduler.
fn run(schedule: &mut dyn Schedule, n_workers: usize, tasks: &[NodePair]) -> Vec<u32> {
    let seen: Vec<AtomicU32> = (0..N_PAIRS).map(|_| AtomicU32::new(0)).collect();
    let threads = Threads::new(n_workers).expect("threads");
    let mut workers: Vec<()> = vec![(); n_workers];
    let mut list = tasks.to_vec();
    threads.enter(|| {
        schedule.run(n_workers, &mut list, &threads.stop, &mut |job| {
            threads.each(&mut workers, &|worker, ()| {
                let mut expand = |pairs: &[NodePair], out: &mut Vec<NodePair>| {
                    for &pair in pairs {
                        seen[pair[1] as usize].fetch_add(1, Relaxed);
                        out.extend(children(pair));
                    }
                };
                job(&mut Hand { worker, expand: &mut expand });
            });
        });
    });
    assert!(list.is_empty(), "tasks are left");
    seen.into_iter().map(AtomicU32::into_inner).collect()
}

/// All schedulers, and those with deques that hold hardly anything.
fn schedulers() -> Vec<(String, Box<dyn Schedule>)> {
    let rows = Scheduler::ROWS.iter().filter(|row| row.backends.contains(&"cpu"));
    let of = |row: &ccd_core::model::catalogue::Row<Scheduler>| {
        (
            row.name.to_string(),
            scheduler_of(row.value, WorkerOptions::default()).expect("a scheduler that is here"),
        )
    };
    let mut all: Vec<_> = rows.map(of).collect();
    for capacity in [2, 8] {
        all.push((format!("stealing, capacity {capacity}"), Box::new(stealing(capacity))));
        all.push((format!("as printed, capacity {capacity}"), Box::new(abp_stealing(capacity))));
        all.push((format!("blocking queue, capacity {capacity}"), Box::new(blocking(capacity))));
        all.push((format!("lock-free queue, capacity {capacity}"), Box::new(lock_free(capacity))));
        all.push((
            format!("lazy stealing, capacity {capacity}"),
            Box::new(LazyStealing::new(capacity, WorkerOptions::default())),
        ));
    }
    let least = WorkerOptions::default().batch(1).threshold(1);
    for options in [least, least.batch(64).threshold(1024)] {
        let lazy = Box::new(LazyStealing::new(4, options));
        all.push((format!("lazy stealing, {options:?}"), lazy));
    }
    for idle in [1, 100] {
        all.push((format!("balanced at {idle} %"), Box::new(Balanced::new(idle))));
    }
    all
}

#[test]
fn every_pair_is_expanded_once() {
    let tasks = |n: u32, depth| Vec::from_iter((0..n).map(|k| [depth, 17 * k % N_PAIRS]));
    let mut most = 0;
    // Many tasks, one that is all the work, a few, none.
    for tasks in [tasks(1000, 6), tasks(1, 14), tasks(3, 11), tasks(0, 1), tasks(5, 0)] {
        let want = walk(&tasks);
        most = want.iter().sum::<u32>().max(most);
        for (name, mut schedule) in schedulers() {
            for n_workers in [1, 2, 8] {
                // Twice, so that nothing is left over from the first time.
                for _ in 0..2 {
                    let found = run(&mut *schedule, n_workers, &tasks);
                    assert!(found == want, "{name}, {} tasks, {n_workers} workers", tasks.len());
                }
            }
        }
    }
    assert!(most > 10_000, "{most} pairs show nothing");
}

/// The control: what loses a pair, or expands one twice, is seen.
#[test]
fn a_pair_more_or_less_is_seen() {
    #[derive(Debug)]
    struct Wrong(SelfScheduling, bool);
    impl Schedule for Wrong {
        fn run(&mut self, n: usize, tasks: &mut Vec<NodePair>, stop: &Stop, launch: Launch) {
            let last = tasks.pop().expect("a task");
            if self.1 {
                tasks.extend([last, last]);
            }
            self.0.run(n, tasks, stop, launch);
        }
    }
    let tasks = Vec::from_iter((0..100).map(|k| [5, k]));
    for doubles in [false, true] {
        let found = run(&mut Wrong(SelfScheduling::default(), doubles), 2, &tasks);
        assert!(found != walk(&tasks), "doubles: {doubles}");
    }
}

/// Where lists are dealt out again, what one worker finds is for all; else it is for itself. By one
/// thread after the other, so that it does not depend on the machine.
#[test]
fn workers_without_pairs_are_helped() {
    let helping: [Box<dyn Schedule>; 2] = [Box::new(Balanced::new(1)), Box::new(Balanced::new(50))];
    let alone: [Box<dyn Schedule>; 2] =
        [Box::new(Balanced::new(NEVER)), Box::new(SelfScheduling::default())];
    let all = helping.into_iter().map(|s| (true, s)).chain(alone.map(|s| (false, s)));
    for (helps, mut schedule) in all {
        let by_worker: Vec<AtomicU32> = (0..4).map(|_| AtomicU32::new(0)).collect();
        let mut list = vec![[14, 0]];
        schedule.run(4, &mut list, &Stop::default(), &mut |job| {
            // The one with the task comes last, so that it sees that the others are idle.
            for worker in (0..4).rev() {
                let mut expand = |pairs: &[NodePair], out: &mut Vec<NodePair>| {
                    by_worker[worker].fetch_add(pairs.len() as u32, Relaxed);
                    pairs.iter().for_each(|&pair| out.extend(children(pair)));
                };
                job(&mut Hand { worker, expand: &mut expand });
            }
        });
        let busy = by_worker.iter().filter(|n| n.load(Relaxed) > 0).count();
        assert_eq!(busy > 1, helps, "{schedule:?}: {by_worker:?}");
    }
}
