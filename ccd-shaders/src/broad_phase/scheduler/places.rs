//! Places of what the threads of a worker find in a turn, one behind the other: by counters in
//! workgroup memory to which each thread adds, or by prefix sums of their counts, algorithm 3.8 of
//! [da Silva 2013].
//!
//! ```text
//!   found         2   0   3   1           by a thread each: inner pairs, pairs of leaves, ends
//!   by counters   1   -   3   0           whoever adds first is first
//!   by scan       0   2   2   5   | 6     seven steps, each with a barrier
//! ```

use super::shared::{ENDED, LEAVES, NODES};
use super::worker::{PairTree, Worker};
use crate::scan::scan;
use crate::workgroup::{add_shared, get};
use ccd_core::backend::broad_phase::pair_workers::THREADS;

/// Sums of a scan by the threads of a worker, in two halves.
pub(super) type Sums = [u32; 2 * THREADS as usize];
/// Log2 of these threads: an odd number of steps, after which the total is in the second half.
const STEPS: u32 = THREADS.trailing_zeros();
const TOTAL: u32 = 2 * THREADS - 1;
const _: () = assert!(STEPS % 2 == 1);

impl<T: PairTree> Worker<'_, T> {
    /// By counters.
    #[inline(always)]
    pub(super) fn claim(&mut self, found: T::Found) -> T::Places {
        let n = T::counts(found, self.args.capacity_front);
        let mut first = [0, 0, 0];
        if n[0] > 0 {
            first[0] = add_shared(self.shared, NODES, n[0]);
        }
        if n[1] > 0 {
            first[1] = add_shared(self.shared, LEAVES, n[1]);
        }
        if n[2] > 0 {
            first[2] = add_shared(self.shared, ENDED, n[2]);
        }
        T::places(found, first)
    }

    /// By prefix sums: of inner pairs and of pairs of leaves at once, 16 bits each. All threads of
    /// the worker call it.
    #[inline(always)]
    pub(super) fn claim_by_scan(&mut self, found: T::Found, sums: &mut Sums) -> T::Places {
        let n = T::counts(found, self.args.capacity_front);
        let both = n[0] | n[1] << 16;
        let before = scan(self.lane, STEPS, THREADS, both, sums) - both;
        if self.lane == 0 {
            let total = get(sums, TOTAL);
            self.set(NODES, total & 0xffff);
            self.set(LEAVES, total >> 16);
        }
        let mut ended = 0;
        if self.args.capacity_front > 0 {
            ended = scan(self.lane, STEPS, THREADS, n[2], sums) - n[2];
            if self.lane == 0 {
                self.set(ENDED, get(sums, TOTAL));
            }
        }
        T::places(found, [before & 0xffff, before >> 16, ended])
    }
}
