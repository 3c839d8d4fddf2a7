//! Candidates to those that may touch, one a thread.
//!
//! What the cheap filters leave is gathered before the costly one, so that no thread waits for a
//! neighbour with more to do.

use crate::entry::kernel;
use crate::records::PathWords;
use crate::workgroup::{add_shared, barrier, count, get, part, read_pair, set, write_pair};
use ccd_core::backend::kernel::Id;
use ccd_core::backend::layout::{Frame, Pair};
use ccd_core::narrow_phase::cascade::{self, PAIRS_A_THREAD};
use ccd_core::narrow_phase::decide;

const THREADS: u32 = Id::FilterPairs.threads();
/// Pairs that a workgroup takes at once.
const POOL: u32 = PAIRS_A_THREAD * THREADS;

/// Words of `counters`: pairs that the cheap filters leave, pairs that are kept, where these go.
const LEFT: u32 = 0;
const KEPT: u32 = 1;
const BASE: u32 = 2;

kernel! {
    /// Thread `i` filters the `i`-th candidate from `dispatch.first` on. `elements`: of faces, or
    /// of edges, as the kind has them. With `FLAG_ENDS` no axis keeps a candidate apart.
    filter_pairs[128](t; params: Decision; counters: [u32; 3], left: [Pair; 512],
        kept: [Pair; 512]; elements: [u32], paths: [PathWords], input: [u32],
        mut output: [u32]) {
        let (frame, kind) = (&{ params.frame }, params.args.kind);
        let (error, min_distance) = (frame.path_error, frame.min_distance);
        let ends = frame.has(Frame::FLAG_ENDS);
        let len = part(input, &params.dispatch);
        for round in 0..decide::rounds(len, t.group, t.groups, POOL) {
            let first = (t.group + round * t.groups) * POOL;
            if t.lane <= KEPT {
                set(counters, t.lane, 0);
            }
            barrier();
            for share in 0..POOL / THREADS {
                let i = first + share * THREADS + t.lane;
                if i >= len {
                    break;
                }
                let pair = read_pair(input, params.dispatch.first + i);
                let (patch, ids) = decide::words_of_pair(kind, pair, elements);
                if ends || cascade::near_on_axes(patch, ids, paths, error, min_distance) {
                    let motion = cascade::motion(patch, ids, paths, error);
                    if !cascade::apart_throughout(&motion, patch, min_distance) {
                        set(left, add_shared(counters, LEFT, 1), pair);
                    }
                }
            }
            barrier();
            let n = get(counters, LEFT);
            for share in 0..POOL / THREADS {
                let h = share * THREADS + t.lane;
                if h >= n {
                    break;
                }
                let pair = get(left, h);
                let (patch, ids) = decide::words_of_pair(kind, pair, elements);
                let motion = cascade::motion(patch, ids, paths, error);
                if !cascade::apart_in_halves(&motion, patch, min_distance) {
                    set(kept, add_shared(counters, KEPT, 1), pair);
                }
            }
            barrier();
            let n = get(counters, KEPT);
            if t.lane == 0 && n > 0 {
                set(counters, BASE, count(output, 0, n));
            }
            barrier();
            let base = get(counters, BASE);
            for share in 0..POOL / THREADS {
                let h = share * THREADS + t.lane;
                if h >= n {
                    break;
                }
                write_pair(output, params.dispatch.capacity_out, base + h, get(kept, h));
            }
            barrier();
        }
    }
}
