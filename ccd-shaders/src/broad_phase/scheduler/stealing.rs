//! Workers that descend pairs of nodes and steal them from each other; natively alone. As
//! `workers`, with levels 2 to 4 of `ccd_core::backend::scheduling::stealing`: the threads of a
//! workgroup are one worker, of which the first exchanges words of deques, all read and write the
//! pairs of a batch, and each has a hand.
//!
//! A turn: pairs come from the stack and from the tasks; if a batch fits beside them, one comes
//! from the worker's own deque; if there are none at all, from a range that it has stolen, before
//! or just now. What was found is put away as by any worker. Then, if the stack has many pairs, a
//! batch of its bottom goes to the deque: these are the oldest, with most below them; what is at
//! the top takes their place. Where the deque is full, they stay.
//!
//! A worker that ends has an empty stack, deque and hands, or leaves the rest to the next round.

use super::shared::{EXPANDED, FROM_STACK, FROM_TASKS, SPILL_BASE, Stack, TOP};
use super::stolen_batches::{
    Batch, FRUITLESS, FULL, HAND, N_TAKEN, NO_SLOT, POPPED, SEEKS, SOURCE, STOLEN, TO_PUSH,
};
use super::worker::{ENDS, PairTree, STOPS, WORKS, Worker};
use crate::workgroup::{barrier, barrier_of_buffers, get, get_uniform, set};
use ccd_core::backend::broad_phase::pair_workers::victim;
use ccd_core::backend::scheduling::stealing::{HANDS, Workers};

impl<T: PairTree> Worker<'_, T> {
    /// What the worker does in its round.
    #[inline(always)]
    pub(super) fn steal(mut self, state: &mut [u32; 1], batch: &mut Batch, stack: &mut Stack) {
        let (me, lane, args, workers) = (self.me, self.lane, self.args, self.workers);
        if lane == 0 {
            self.clear();
            set(batch, FRUITLESS, 0);
            set(batch, POPPED, 0);
            set(batch, STOLEN, 0);
            set(batch, FULL, 0);
        }
        for turn in 0..args.turns {
            if lane == 0 {
                set(state, 0, self.look(turn, batch));
            }
            let next = get_uniform(state, 0);
            if next == ENDS || next == STOPS {
                break;
            }
            if next == SEEKS {
                self.look_at_hands(batch);
                barrier();
                let held = get(batch, HAND);
                barrier();
                if held == HANDS && lane < HANDS {
                    self.reach_out(batch, victim(workers.n, me, turn, lane));
                }
                barrier();
                let takes = Workers::takes_task(lane, get(batch, HAND));
                if args.most == 0 && held == HANDS && takes {
                    let victim = victim(workers.n, me, turn, lane);
                    workers.steal_to_hand(&self.deques(), me, lane, victim, 1);
                }
                barrier_of_buffers();
                if lane == 0 {
                    self.take_from_hand(batch);
                    if get(batch, N_TAKEN) > 0 {
                        self.found_work(batch);
                    }
                }
            }
            // What was taken is seen by all threads.
            barrier_of_buffers();
            let i = T::index(lane);
            let mut pair = self.take(i, stack);
            let busy = self.get(FROM_STACK) + self.get(FROM_TASKS);
            let n_taken = get(batch, N_TAKEN);
            if i >= busy && i < busy + n_taken {
                pair = self.read_batch(i - busy, batch);
            }
            let found = self.trees.expand(lane, pair, self.shared);
            let to = self.claim(found);
            // All have read the batch.
            barrier_of_buffers();
            if lane == 0 {
                self.reserve_results();
                self.set(EXPANDED, self.get(EXPANDED) + n_taken);
                self.give_back(batch);
                self.reserve_slot(batch);
            }
            // Also for the slot, which others may just have read.
            barrier_of_buffers();
            T::put_away(&mut self, found, to, stack);
            barrier();
            let pushes = get(batch, TO_PUSH) != NO_SLOT;
            if pushes && lane < args.batch {
                self.copy_batch(batch, stack);
            }
            // The batch is there for whoever sees that it is published.
            barrier_of_buffers();
            if pushes && lane == 0 {
                workers.deque(me).publish(&self.deques(), get(batch, TO_PUSH), args.batch);
                self.set(TOP, self.get(TOP) - args.batch);
            }
        }
        // What the worker has in its deque and its hands goes to the next round: nothing, but after
        // too many turns. A pop that fails may have lost a batch to a thief.
        for _ in 0..workers.drain_turns(args.most) {
            if lane == 0 {
                set(batch, N_TAKEN, 0);
                set(batch, SOURCE, 0);
                set(batch, HAND, HANDS);
                self.pop(batch);
            }
            barrier();
            self.look_at_hands(batch);
            barrier_of_buffers();
            if lane == 0 {
                if get(batch, N_TAKEN) == 0 {
                    self.take_from_hand(batch);
                }
                let n_taken = get(batch, N_TAKEN);
                let mut next = WORKS;
                if n_taken > 0 {
                    let base = self.spill(n_taken);
                    self.set(SPILL_BASE, base);
                } else if workers.deque(me).is_empty(&self.deques()) {
                    next = ENDS;
                }
                set(state, 0, next);
            }
            if get_uniform(state, 0) == ENDS {
                break;
            }
            barrier_of_buffers();
            if lane < get(batch, N_TAKEN) {
                let pair = self.read_batch(lane, batch);
                self.write_task(self.output, self.get(SPILL_BASE) + lane, pair);
            }
            barrier_of_buffers();
            if lane == 0 {
                self.give_back(batch);
            }
        }
        if lane == 0 {
            self.reserve_rest();
            self.count_batches(batch);
        }
        barrier();
        self.leave_rest(stack);
    }
}
