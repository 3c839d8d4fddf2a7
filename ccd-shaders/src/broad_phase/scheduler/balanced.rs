//! What workers have left is dealt out again; see `ccd_core::backend::broad_phase::balanced`.

use crate::broad_phase::pair_descent::reserve;
use crate::entry::kernel;
use crate::scan::scan;
use crate::workgroup::{get, raise, read_pair, write_pair};
use ccd_core::backend::broad_phase::balanced::{first, left, owner, part, saved};
use ccd_core::backend::broad_phase::pair_workers::{LEFT, THREADS, listed};
use ccd_core::backend::kernel::Id;
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::layout::Pair;

const SCANNERS: u32 = Id::BalanceCounts.threads();

/// Pairs that a worker has left.
#[inline(always)]
fn count(control: &[u32], workers: u32, me: u32) -> u32 {
    let word = left(workers, me);
    at(control, word) + at(control, word + 1)
}

kernel! {
    /// One workgroup, after round `dispatch.first`: the places of what each worker has left among
    /// the tasks of the next round, behind those that are there. A thread has as many workers that
    /// follow each other as it takes.
    balance_counts[256](t; params: NodeDescent; sums: [u32; 512]; mut control: [u32],
        mut nodes: [u32]) {
        let (args, next_round) = (params.args, listed(params.dispatch.first + 1));
        let n = 1 << args.workers;
        // The first thread alone reads the word, which it changes below: a barrier orders workgroup
        // memory only.
        let begin = if t.lane == 0 { at(control, next_round) } else { 0 };
        let of_thread = (n + SCANNERS - 1) / SCANNERS;
        let mut sum = 0;
        for k in 0..of_thread {
            let worker = t.lane * of_thread + k;
            if worker < n {
                sum += count(control, args.workers, worker);
            }
        }
        let mut place = scan(t.lane, 8, SCANNERS, begin + sum, sums) - sum;
        let end = get(sums, SCANNERS - 1);
        for k in 0..of_thread {
            let worker = t.lane * of_thread + k;
            if worker < n {
                put(control, first(args.workers, worker), place);
                place += count(control, args.workers, worker);
            }
        }
        if t.lane == 0 {
            put(control, first(args.workers, n), end);
            if end > begin {
                reserve(control, next_round, nodes, end - begin);
                if args.last != 0 {
                    raise(control, LEFT, u32::MAX);
                }
            }
        }
    }
}

kernel! {
    /// Workgroup `i` fills the part of worker `i` of the pairs that are dealt out again after round
    /// `dispatch.first`; places beyond the capacity of the list stay as they are.
    balance_pairs[128](t; params: NodeDescent;; control: [u32], mut nodes: [u32]) {
        let (args, round) = (params.args, params.dispatch.first);
        let (workers, capacity) = (args.workers, args.capacity_nodes);
        let tasks = at(control, listed(round)).min(capacity);
        let [input, output] = [round % 2 * capacity, (1 - round % 2) * capacity];
        let begin = at(control, first(workers, 0));
        let [from, n] = part(at(control, first(workers, 1 << workers)) - begin, t.group, workers);
        for k in 0..n.div_ceil(THREADS) {
            let i = k * THREADS + t.lane;
            let place = begin + from + i;
            if i < n && place < capacity {
                let owner = owner(control, workers, place);
                let i = place - at(control, first(workers, owner));
                let on_stack = at(control, left(workers, owner));
                let mut pair = Pair { a: 0, b: 0 };
                if i < on_stack {
                    let word = saved(workers, owner) + 2 * i as usize;
                    pair.a = at(control, word);
                    pair.b = at(control, word + 1);
                } else {
                    // The rest of a part is its end.
                    let rest = at(control, left(workers, owner) + 1);
                    let [first, of_part] = part(tasks, owner, workers);
                    pair = read_pair(nodes, input + first + of_part - rest + i - on_stack);
                }
                write_pair(nodes, u32::MAX, output + place, pair);
            }
        }
    }
}
