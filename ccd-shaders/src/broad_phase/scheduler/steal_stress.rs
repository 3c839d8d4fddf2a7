//! Workgroups that steal from each other: a worker's own stack in workgroup memory, its deque and
//! the ranges that it has stolen in buffers, and what it does when it looks for work.
//!
//! Levels 1 to 4 of `ccd_core::backend::scheduling::stealing`, with the threads of a workgroup as
//! one worker: its first thread exchanges words of deques, all threads read and write items, one
//! each, and a hand a thread steals.

use crate::entry::kernel;
use crate::workgroup::{
    DeviceWords, add, add_shared, barrier, barrier_of_buffers, get, lower_shared, set,
};
use ccd_core::backend::broad_phase::pair_workers::victim;
use ccd_core::backend::kernel::Id;
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::scheduling::stealing::{HANDS, Workers};

const THREADS: u32 = Id::StealStress.threads();
/// Items of a worker's own stack, at most: what is left of one look for work and what the next
/// makes.
const STACK: u32 = 2 * THREADS;
/// Words that a worker's stack takes in a buffer between dispatches: how many, then items.
const SAVED: u32 = 1 + 2 * STACK;

/// What the threads of a worker share: items on the stack; from where items are taken; how many;
/// whose deque; which slot; the first hand that holds something; where a batch is pushed to; how
/// often nothing was found.
const ON_STACK: u32 = 0;
const SOURCE: u32 = 1;
const N_TAKEN: u32 = 2;
const OWNER: u32 = 3;
const SLOT: u32 = 4;
const HAND: u32 = 5;
const TO_PUSH: u32 = 6;
const FRUITLESS: u32 = 7;
/// Sources of items.
const NOTHING: u32 = 0;
const FROM_STACK: u32 = 1;
const FROM_OWN: u32 = 2;
const STOLEN: u32 = 3;
/// The worker looks for work no more.
const RETIRED: u32 = 4;
/// No slot.
const FULL: u32 = u32::MAX;

/// Words of the status, which all workers add to: batches that were popped, stolen; pushes that
/// found a full deque; takes from stacks; workers that have work left.
const STATUS_LEFT: usize = 4;

/// The first thread notes which batch is taken.
#[inline(always)]
fn note(
    shared: &mut [u32; 8],
    workers: Workers,
    words: &DeviceWords,
    source: u32,
    owner: u32,
    slot: u32,
) {
    set(shared, SOURCE, source);
    set(shared, OWNER, owner);
    set(shared, SLOT, slot);
    set(shared, N_TAKEN, workers.deque(owner).items(words, slot));
}

kernel! {
    /// For tests: worker `i` takes items `[tag, lives]`, counts each, and keeps those that have
    /// lives left with one less; all that it keeps goes through its deque unless that is full.
    /// The number of workers is a power of two.
    ///
    /// `words`: [`Workers`] of the record; `stacks`: of each worker, what it had when it ended.
    /// Each worker looks for work `args.rounds` times at most; it retires after `args.patience`
    /// times in vain.
    steal_stress[64](t; params: Stealing; shared: [u32; 8], stack: [u32; 256]; mut words: [u32],
        mut stacks: [u32], mut counts: [u32], mut status: [u32]) {
        let me = t.group;
        let args = params.args;
        let workers = Workers { n: args.workers, batches: args.batches, batch: args.batch };
        let words = DeviceWords::new(words);
        let saved = (me * SAVED) as usize;
        if t.lane == 0 {
            set(shared, ON_STACK, at(stacks, saved));
            set(shared, FRUITLESS, 0);
        }
        for k in 0..STACK / THREADS {
            let i = k * THREADS + t.lane;
            set(stack, 2 * i, at(stacks, saved + 1 + 2 * i as usize));
            set(stack, 2 * i + 1, at(stacks, saved + 2 + 2 * i as usize));
        }
        let (mut popped, mut stolen, mut full, mut kept) = (0, 0, 0, 0);
        for round in 0..args.rounds {
            barrier();
            let works = get(shared, FRUITLESS) <= args.patience;
            // Levels 1 and 2.
            if t.lane == 0 {
                let n_items = get(shared, ON_STACK);
                set(shared, SOURCE, NOTHING);
                set(shared, N_TAKEN, 0);
                set(shared, HAND, HANDS);
                set(shared, TO_PUSH, FULL);
                if !works {
                    set(shared, SOURCE, RETIRED);
                } else if n_items > 0 {
                    set(shared, SOURCE, FROM_STACK);
                    set(shared, N_TAKEN, n_items.min(THREADS));
                    kept += 1;
                } else if let Some(slot) = workers.deque(me).try_pop(&words) {
                    note(shared, workers, &words, FROM_OWN, me, slot);
                }
            }
            barrier();
            // Levels 3 and 4: a hand a thread.
            if get(shared, SOURCE) == NOTHING && t.lane < HANDS {
                if workers.holds(&words, me, t.lane) {
                    lower_shared(shared, HAND, t.lane);
                }
            }
            barrier();
            let seeks = get(shared, SOURCE) == NOTHING && get(shared, HAND) == HANDS;
            let victim = victim(args.workers, me, round, t.lane);
            barrier();
            if seeks && workers.reach_out(&words, me, t.lane, victim, args.most) {
                lower_shared(shared, HAND, t.lane);
            }
            barrier();
            if seeks && args.most == 0 && Workers::takes_task(t.lane, get(shared, HAND)) {
                workers.steal_to_hand(&words, me, t.lane, victim, 1);
            }
            barrier_of_buffers();
            if t.lane == 0 && get(shared, SOURCE) == NOTHING {
                let hand = get(shared, HAND);
                if hand < HANDS && workers.holds(&words, me, hand) {
                    let owner = workers.victim(&words, me, hand);
                    let slot = workers.next_slot(&words, me, hand);
                    note(shared, workers, &words, STOLEN, owner, slot);
                }
            }
            barrier_of_buffers();
            // Items, one a thread.
            let (source, n_taken) = (get(shared, SOURCE), get(shared, N_TAKEN));
            let (mut tag, mut lives) = (0, 0);
            if t.lane < n_taken {
                if source == FROM_STACK {
                    let i = get(shared, ON_STACK) - 1 - t.lane;
                    tag = get(stack, 2 * i);
                    lives = get(stack, 2 * i + 1);
                } else {
                    let item =
                        workers.deque(get(shared, OWNER)).read(&words, get(shared, SLOT), t.lane);
                    tag = item[0];
                    lives = item[1];
                }
                add(counts, tag as usize, 1);
            }
            barrier_of_buffers();
            if t.lane == 0 {
                if source == FROM_STACK {
                    set(shared, ON_STACK, get(shared, ON_STACK) - n_taken);
                } else if source == NOTHING {
                    set(shared, FRUITLESS, get(shared, FRUITLESS) + 1);
                } else if source != RETIRED {
                    set(shared, FRUITLESS, 0);
                    if source == STOLEN {
                        workers.deque(get(shared, OWNER)).give_back(&words, 1);
                        stolen += 1;
                    } else {
                        popped += 1;
                    }
                }
                if works && let Some(slot) = workers.deque(me).reserve(&words) {
                    set(shared, TO_PUSH, slot);
                }
            }
            barrier();
            if t.lane < n_taken && lives > 0 {
                let i = add_shared(shared, ON_STACK, 1);
                set(stack, 2 * i, tag);
                set(stack, 2 * i + 1, lives - 1);
            }
            barrier();
            // A batch from the top of the stack to the deque.
            let (n_items, slot) = (get(shared, ON_STACK), get(shared, TO_PUSH));
            let n_pushed = if slot == FULL { 0 } else { n_items.min(args.batch) };
            if t.lane < n_pushed {
                let i = n_items - n_pushed + t.lane;
                workers.deque(me).write(
                    &words,
                    slot,
                    t.lane,
                    [get(stack, 2 * i), get(stack, 2 * i + 1)],
                );
            }
            barrier_of_buffers();
            if t.lane == 0 {
                if n_pushed > 0 {
                    workers.deque(me).publish(&words, slot, n_pushed);
                    set(shared, ON_STACK, n_items - n_pushed);
                } else if n_items > 0 {
                    full += 1;
                }
            }
        }
        barrier();
        for k in 0..STACK / THREADS {
            let i = k * THREADS + t.lane;
            put(stacks, saved + 1 + 2 * i as usize, get(stack, 2 * i));
            put(stacks, saved + 2 + 2 * i as usize, get(stack, 2 * i + 1));
        }
        if t.lane == 0 {
            let n_items = get(shared, ON_STACK);
            put(stacks, saved, n_items);
            add(status, 0, popped);
            add(status, 1, stolen);
            add(status, 2, full);
            add(status, 3, kept);
            let mut left = n_items > 0 || !workers.deque(me).is_empty(&words);
            for hand in 0..HANDS {
                left |= workers.holds(&words, me, hand);
            }
            if left {
                add(status, STATUS_LEFT, 1);
            }
        }
    }
}
