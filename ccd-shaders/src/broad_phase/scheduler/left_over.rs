//! What a worker leaves when it ends: it goes to the tasks of the next round, or, if workers are
//! balanced, to memory of its own.

use super::shared::{EXPANDED, NEXT, REST, REST_BASE, Stack, TOP, TURNS};
use super::worker::{PairTree, Worker};
use crate::workgroup::{add, get, read_pair};
use ccd_core::backend::broad_phase::balanced::{left, part, saved};
use ccd_core::backend::broad_phase::pair_workers::{STACK, THREADS, counts, share, taken};
use ccd_core::backend::kernel::memory::put;
use ccd_core::backend::layout::NodeDescent;

impl<T: PairTree> Worker<'_, T> {
    #[inline(always)]
    fn is_balanced(&self) -> bool {
        self.args.tasks == NodeDescent::TASKS_BALANCED
    }

    /// The first thread, when the worker has ended: places among the tasks of the next round for
    /// its stack and for the rest of its part; or, balanced, how many these are.
    #[inline(always)]
    pub(super) fn reserve_rest(&mut self) {
        let mut rest = 0;
        if self.args.tasks == NodeDescent::TASKS_DEALT {
            rest = share(self.tasks, self.me, self.args.workers) - self.get(NEXT);
        }
        self.set(REST, rest);
        let n = self.get(TOP) + rest;
        if self.is_balanced() {
            let workers = self.args.workers;
            let [_, of_part] = part(self.tasks, self.me, workers);
            let word = left(workers, self.me);
            put(self.control, word, get(self.shared, TOP));
            put(self.control, word + 1, of_part - get(self.shared, NEXT));
        } else if n > 0 {
            let base = self.spill(n);
            self.set(REST_BASE, base);
        }
        add(self.control, counts(self.me), get(self.shared, TURNS));
        add(self.control, counts(self.me) + 1, get(self.shared, EXPANDED));
    }

    /// Leaves what the worker has on its stack, and what is left of its part, to the next round; of
    /// tasks by a counter, all that nobody takes any more. Balanced, it saves its stack.
    #[inline(always)]
    pub(super) fn leave_rest(&mut self, stack: &Stack) {
        let (top, base, rest) = (self.get(TOP), self.get(REST_BASE), self.get(REST));
        for k in 0..STACK / THREADS {
            let i = k * THREADS + self.lane;
            if i < top {
                let pair = [get(stack, 2 * i), get(stack, 2 * i + 1)];
                if self.is_balanced() {
                    let word = saved(self.args.workers, self.me) + 2 * i as usize;
                    put(self.control, word, pair[0]);
                    put(self.control, word + 1, pair[1]);
                } else {
                    self.write_task(self.output, base + i, pair);
                }
            }
        }
        let next = self.get(NEXT);
        for k in 0..rest.div_ceil(THREADS) {
            let i = k * THREADS + self.lane;
            if i < rest {
                let task = self.input + self.me + ((next + i) << self.args.workers);
                let pair = read_pair(self.nodes, task);
                self.write_task(self.output, base + top + i, [pair.a, pair.b]);
            }
        }
        if self.args.tasks == NodeDescent::TASKS_COUNTED && next == 0 {
            // Each thread for itself, a task at a time: that is rare.
            for _ in 0..self.tasks {
                let i = add(self.control, taken(self.round), 1);
                if i >= self.tasks {
                    break;
                }
                let pair = read_pair(self.nodes, self.input + i);
                let to = self.spill(1);
                self.write_task(self.output, to, [pair.a, pair.b]);
            }
        }
    }
}
