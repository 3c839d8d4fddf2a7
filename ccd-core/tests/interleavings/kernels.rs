//! Workers as the kernels that steal are: what `stealing` of ccd-shaders does with deques, by
//! the same functions of the core, with one pair a turn and the threads of a workgroup one after
//! the other, as its barriers order them; and the same with a fault each.

use super::models::{EXECUTIONS, read};
use super::words::{self, Traced};
use ccd_core::backend::broad_phase::pair_workers::victim;
use ccd_core::backend::kernel::Words;
use ccd_core::backend::scheduling::deque::Item;
use ccd_core::backend::scheduling::stealing::{HANDS, Taken, Workers};
use std::sync::atomic::Ordering;

/// Fault of a kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// Who drains its deque takes a pop that failed for an empty one.
    DrainsUnseen,
    /// Who has found work is still counted as idle.
    StaysIdle,
    /// Where nobody has anything, the thread behind the last hand takes a task.
    BehindHands,
}

/// A round of workers; the last one begins with an item of so many levels.
#[derive(Clone, Copy, Debug)]
pub struct Round {
    pub workers: Workers,
    pub depth: u32,
    /// Batches that a thread steals at once; 0: of tasks, one thread one.
    pub most: u32,
    /// Looks in vain after which a worker retires; turns after which it ends whatever it has.
    pub patience: u32,
    pub turns: u32,
    pub fault: Option<Fault>,
}

/// Turns that are enough for all work.
pub const ENOUGH: u32 = 1000;

/// One execution.
pub fn kernel(round: Round) {
    EXECUTIONS.fetch_add(1, Ordering::Relaxed);
    words::begin();
    let n = round.workers.n;
    // The last word counts who is idle.
    let words = Traced::new(round.workers.words() + 1, |_| "", false).gated();
    let worker = |me: u32, words: Traced| {
        let stack = if me + 1 == n { vec![[round.depth, 1]] } else { Vec::new() };
        Worker { round, words, me, stack, fruitless: 0, leaves: Vec::new() }
    };
    let spawn = |me: u32| {
        let worker = worker(me, words.of(["thief", "owner"][me as usize]));
        loom::thread::spawn(move || worker.run())
    };
    let others: Vec<_> = (1..n).map(spawn).collect();
    let (mut leaves, mut left) = worker(0, words.of("thief")).run();
    for other in others {
        let (of_other, left_by_it) = other.join().unwrap_or_default();
        leaves.extend(of_other);
        left.extend(left_by_it);
    }
    let only_retired = round.turns == ENOUGH;
    assert!(!only_retired || left.is_empty(), "who retired had work: {left:?}");
    // The next round's.
    leaves.extend(left.iter().flat_map(|&[depth, i]| i << depth..(i + 1) << depth));
    leaves.sort_unstable();
    let want: Vec<u32> = (1 << round.depth..2 << round.depth).collect();
    assert_eq!(leaves, want, "leaves were taken twice or lost");
}

/// A workgroup.
struct Worker {
    round: Round,
    words: Traced,
    me: u32,
    stack: Vec<Item>,
    fruitless: u32,
    leaves: Vec<u32>,
}

impl Worker {
    /// The leaves that it met, and what it leaves to the next round.
    fn run(mut self) -> (Vec<u32>, Vec<Item>) {
        for turn in 0..self.round.turns {
            if !self.turn(turn) {
                break;
            }
        }
        let Self { round: Round { workers, most, .. }, me, .. } = self;
        for _ in 0..workers.drain_turns(most) {
            if let Some(taken) = self.pop().or_else(|| self.take_held(self.first_held())) {
                self.stack.extend(read(workers.deque(taken.owner), &self.words, taken.slot));
                workers.done(&self.words, taken);
            } else if self.has(Fault::DrainsUnseen) || workers.deque(me).is_empty(&self.words) {
                break;
            }
        }
        (self.leaves, self.stack)
    }

    /// Whether it did something; else it retires.
    fn turn(&mut self, turn: u32) -> bool {
        let Round { workers, patience, .. } = self.round;
        let mut items = Vec::from_iter(self.stack.pop());
        let mut taken = if items.is_empty() { self.pop() } else { None };
        if items.is_empty() && taken.is_none() {
            let idle = self.words.load(self.idle());
            if workers.retires(&self.words, self.me, self.fruitless, patience, idle) {
                return false;
            }
            self.fruitless += 1;
            if self.fruitless == 1 {
                self.words.add(self.idle(), 1);
            }
            taken = self.seek(turn);
        }
        if let Some(taken) = taken {
            items = read(workers.deque(taken.owner), &self.words, taken.slot);
        }
        if !items.is_empty() && self.fruitless > 0 {
            self.fruitless = 0;
            if !self.has(Fault::StaysIdle) {
                self.words.add(self.idle(), u32::MAX);
            }
        }
        for [depth, number] in items {
            match depth.checked_sub(1) {
                Some(depth) => self.stack.extend([[depth, 2 * number], [depth, 2 * number + 1]]),
                None => self.leaves.push(number),
            }
        }
        if let Some(taken) = taken {
            workers.done(&self.words, taken);
        }
        // All above one item go to the deque, if it has capacity.
        if self.stack.len() > 1
            && let Some(slot) = workers.deque(self.me).reserve(&self.words)
        {
            workers.deque(self.me).write(&self.words, slot, 0, self.stack.remove(0));
            workers.deque(self.me).publish(&self.words, slot, 1);
        }
        true
    }

    /// Looks at its hands, then at other workers.
    fn seek(&mut self, turn: u32) -> Option<Taken> {
        let Round { workers, most, .. } = self.round;
        let held = self.first_held();
        let mut first = held;
        if held == HANDS {
            let victim = |lane: u32| victim(workers.n, self.me, turn, lane);
            let reaches =
                |&lane: &u32| workers.reach_out(&self.words, self.me, lane, victim(lane), most);
            first = self.lanes().filter(reaches).min().unwrap_or(HANDS);
            for lane in self.lanes().filter(|_| most == 0) {
                let wrong = self.has(Fault::BehindHands) && lane == first;
                if Workers::takes_task(lane, first) || wrong {
                    workers.steal_to_hand(&self.words, self.me, lane, victim(lane), 1);
                }
            }
        }
        self.take_held(first)
    }

    /// Threads: of those with a hand as many as look at different workers, and the first without.
    fn lanes(&self) -> impl Iterator<Item = u32> + use<> {
        (0..self.round.workers.n).chain([HANDS])
    }

    fn first_held(&self) -> u32 {
        let holds =
            |&lane: &u32| lane < HANDS && self.round.workers.holds(&self.words, self.me, lane);
        self.lanes().filter(holds).min().unwrap_or(HANDS)
    }

    fn take_held(&self, hand: u32) -> Option<Taken> {
        if hand < HANDS {
            self.round.workers.next_in_hand(&self.words, self.me, hand)
        } else {
            None
        }
    }

    fn pop(&self) -> Option<Taken> {
        let slot = self.round.workers.deque(self.me).try_pop(&self.words)?;
        Some(Taken { owner: self.me, slot, stolen: false })
    }

    fn idle(&self) -> usize {
        self.round.workers.words()
    }

    fn has(&self, fault: Fault) -> bool {
        self.round.fault == Some(fault)
    }
}
