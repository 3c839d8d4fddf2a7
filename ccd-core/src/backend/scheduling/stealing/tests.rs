//! Deques and workers in threads: every item once, none lost, under room for few batches.

use super::*;
use crate::kernel::test_words::Atomics;
use crate::scheduling::deque::{Full, Item};
use std::sync::atomic::{AtomicU32, Ordering};
use std::vec::Vec;

fn items(deque: Deque, words: &Atomics, slot: u32) -> Vec<Item> {
    (0..deque.items(words, slot)).map(|i| deque.read(words, slot, i)).collect()
}

fn deque(batches: u32, batch: u32) -> (Deque, Atomics) {
    let words = Atomics::new(3 + Deque::words(batches, batch), 0xdead_beef);
    let deque = Deque { base: 3, batches, batch };
    deque.clear(&words);
    (deque, words)
}

#[test]
fn owners_take_the_last_and_thieves_the_first() {
    let (deque, words) = deque(4, 2);
    assert_eq!(deque.pop(&words), None);
    assert_eq!(deque.steal(&words, 3), Steal::Empty);
    for k in 0..4 {
        let batch = [[k, 10], [k, 11]];
        deque.push(&words, &batch[..1 + k as usize % 2]).unwrap();
    }
    assert_eq!(deque.push(&words, &[[9, 9]]), Err(Full));
    assert_eq!(deque.len(&words), 4);
    let Steal::Stolen(range) = deque.steal(&words, 2) else { panic!("nothing stolen") };
    assert_eq!(range, Range { first: 0, n: 2 });
    assert_eq!(Range::unpacked(range.packed()), range);
    let slot = deque.pop(&words).unwrap();
    assert_eq!(items(deque, &words, slot), [[3, 10], [3, 11]]);
    // There is one slot that was popped; the two that were stolen have not been read.
    deque.push(&words, &[[4, 4]]).unwrap();
    assert_eq!(deque.push(&words, &[[9, 9]]), Err(Full));
    assert_eq!(items(deque, &words, deque.slot_of(range, 0)), [[0, 10]]);
    deque.give_back(&words, 1);
    assert_eq!(deque.push(&words, &[[9, 9]]), Err(Full), "one range is half read");
    assert_eq!(items(deque, &words, deque.slot_of(range, 1)), [[1, 10], [1, 11]]);
    deque.give_back(&words, 1);
    deque.push(&words, &[[5, 5]]).unwrap();
    deque.push(&words, &[[6, 6]]).unwrap();
    assert_eq!(deque.push(&words, &[[9, 9]]), Err(Full));
    for want in [6, 5, 4, 2] {
        let slot = deque.pop(&words).unwrap();
        assert_eq!(items(deque, &words, slot)[0][0], want);
    }
    assert!(deque.is_empty(&words) && deque.pop(&words).is_none());
}

#[test]
fn counts_wrap_around() {
    let (deque, words) = deque(2, 1);
    for k in 0..200_000 {
        deque.push(&words, &[[k, 0]]).unwrap();
        deque.push(&words, &[[k, 1]]).unwrap();
        assert_eq!(deque.push(&words, &[[k, 2]]), Err(Full));
        let Steal::Stolen(range) = deque.steal(&words, 1) else { panic!("nothing stolen") };
        assert_eq!(items(deque, &words, deque.slot_of(range, 0)), [[k, 0]]);
        deque.give_back(&words, 1);
        if k % 3 == 0 {
            let slot = deque.pop(&words).unwrap();
            assert_eq!(items(deque, &words, slot), [[k, 1]]);
        } else {
            let Steal::Stolen(range) = deque.steal(&words, 9) else { panic!("nothing stolen") };
            assert_eq!(items(deque, &words, deque.slot_of(range, 0)), [[k, 1]]);
            deque.give_back(&words, range.n);
        }
    }
}

/// A worker of a tree in which `[depth, number]` has the children `2 * number` and one more; counts
/// the leaves that it meets. Returns how often the deque was full.
fn work(
    workers: Workers,
    words: &Atomics,
    me: u32,
    lazy: Option<u32>,
    leaves: &[AtomicU32],
) -> u32 {
    let (mut stack, mut fruitless, mut full) = (Vec::<Item>::new(), 0, 0);
    while fruitless < 50 {
        if let Some([depth, number]) = stack.pop() {
            if depth == 0 {
                leaves[number as usize].fetch_add(1, Ordering::Relaxed);
            } else {
                stack.extend([[depth - 1, 2 * number], [depth - 1, 2 * number + 1]]);
            }
            let batch = workers.batch as usize;
            if stack.len() > 2 * batch {
                match workers.deque(me).push(words, &stack[..batch]) {
                    Ok(()) => drop(stack.drain(..batch)),
                    Err(Full) => full += 1,
                }
            }
            continue;
        }
        let taken = match lazy {
            None => workers.take_task(words, me, me + 1),
            Some(most) => workers.take_lazily(words, me, most),
        };
        if let Some(taken) = taken {
            stack.extend(items(workers.deque(taken.owner), words, taken.slot));
            workers.done(words, taken);
            fruitless = 0;
        } else {
            fruitless += 1;
            std::thread::yield_now();
        }
    }
    full
}

fn check_workers(n: u32, batches: u32, batch: u32, lazy: Option<u32>) -> u32 {
    const DEPTH: u32 = 14;
    let workers = Workers { n, batches, batch };
    let words = Atomics::new(workers.words(), 0xdead_beef);
    workers.clear(&words);
    let leaves: Vec<AtomicU32> = (0..1 << DEPTH).map(|_| AtomicU32::new(0)).collect();
    workers.deque(0).push(&words, &[[DEPTH, 0]]).unwrap();
    let full = std::thread::scope(|scope| {
        let work = |me| {
            scope.spawn({
                let (words, leaves) = (&words, &leaves);
                move || work(workers, words, me, lazy, leaves)
            })
        };
        let threads: Vec<_> = (0..n).map(work).collect();
        threads.into_iter().map(|thread| thread.join().unwrap()).sum()
    });
    for (i, leaf) in leaves.iter().enumerate() {
        let times = leaf.load(Ordering::Relaxed);
        assert_eq!(times, 1, "leaf {i}, {workers:?}, {lazy:?}");
    }
    full
}

#[test]
fn every_item_once_by_either_scheme_and_in_little_room() {
    let mut full = 0;
    for lazy in [None, Some(1), Some(3)] {
        for (n, batches, batch) in [(1, 2, 1), (2, 2, 4), (3, 8, 1), (4, 4, 3), (5, 64, 16)] {
            full += check_workers(n, batches, batch, lazy);
        }
    }
    assert!(full > 0, "no deque was ever full");
}
