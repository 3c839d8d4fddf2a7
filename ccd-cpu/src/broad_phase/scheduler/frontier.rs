//! Frontier queues: all pairs of one level are expanded, then all that they left, and so on.
//!
//! ```text
//!   queue 0   ##                      a pass takes its queue in pieces from a shared counter
//!   queue 1   ######                  and fills the next; between two passes all wait
//!   queue 2   ###############
//!   queue 3   ####
//! ```
//!
//! Cost: as many waits as the tree of pairs has levels below the tasks, and memory for the widest
//! of them; within a level nobody needs to know of anybody. That is all that WebGPU lets the
//! workgroups of a dispatch do, so it is the way that works on every GPU. Pairs of leaves are done
//! where they are found and never queued.

use super::{Launch, Lists, Schedule};
use crate::stop::Stop;
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// Pairs that a worker takes from the queue at once.
const PIECE: usize = 64;

/// What each worker appends to the next queue.
#[derive(Debug, Default)]
pub struct Frontier {
    next: Lists,
}

impl Schedule for Frontier {
    fn run(&mut self, n_workers: usize, tasks: &mut Vec<NodePair>, stop: &Stop, launch: Launch) {
        self.next.prepare(n_workers);
        while !tasks.is_empty() {
            let (next, counter, queue) = (&self.next, AtomicUsize::new(0), &*tasks);
            launch(&|hand| {
                let mut next = next.of(hand.worker);
                loop {
                    let from = counter.fetch_add(PIECE, Relaxed);
                    if from >= queue.len() {
                        break;
                    }
                    (hand.expand)(&queue[from..(from + PIECE).min(queue.len())], &mut next);
                }
            });
            tasks.clear();
            self.next.gather(tasks, stop);
        }
    }
}
