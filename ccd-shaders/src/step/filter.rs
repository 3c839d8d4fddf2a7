//! Candidates of both kinds to those that may touch, one a thread.
//!
//! What the cheap filters leave is gathered before the costly one, so that no thread waits for a
//! neighbour with more to do.

use crate::entry::kernel;
use crate::records::PathWords;
use crate::workgroup::{add_shared, barrier, count, get, length, read_pair, set, write_pair};
use ccd_core::backend::kernel::Id;
use ccd_core::backend::layout::elements::with_kind;
use ccd_core::backend::layout::{EDGE_EDGE, Frame, Pair, VERTEX_FACE};
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
    /// A workgroup filters a pool of candidates after the other, of one kind each, from pool
    /// `dispatch.first` on: first those of vertices and faces. With `FLAG_ENDS` no axis keeps a
    /// candidate apart. The second word of `output` counts pairs of edges.
    filter_pairs[128](t; params: Filtering; counters: [u32; 3], left: [Pair; 512],
        kept: [Pair; 512]; elements: [u32], paths: [PathWords], vf: [u32], ee: [u32],
        mut output: [u32]) {
        let (frame, dispatch) = (&{ params.frame }, &params.dispatch);
        let (error, min_distance) = (frame.path_error, frame.min_distance);
        let ends = frame.has(Frame::FLAG_ENDS);
        let n_vf = length(vf, dispatch.capacity_in);
        let n_ee = length(ee, params.args.capacity_ee);
        let pools_vf = n_vf.div_ceil(POOL);
        let n_pools = pools_vf + n_ee.div_ceil(POOL);
        let n_pools = if n_pools > dispatch.first { n_pools - dispatch.first } else { 0 };
        for round in 0..decide::rounds(n_pools.min(dispatch.n), t.group, t.groups, 1) {
            let pool = dispatch.first + t.group + round * t.groups;
            let of_edges = pool >= pools_vf;
            let kind = if of_edges { EDGE_EDGE } else { VERTEX_FACE };
            let len = if of_edges { n_ee } else { n_vf };
            let first = POOL * if of_edges { pool - pools_vf } else { pool };
            if t.lane <= KEPT {
                set(counters, t.lane, 0);
            }
            barrier();
            for share in 0..POOL / THREADS {
                let i = first + share * THREADS + t.lane;
                if i >= len {
                    break;
                }
                let pair = if of_edges { read_pair(ee, i) } else { read_pair(vf, i) };
                let (patch, ids) = decide::words_of_pair(kind, pair, frame, elements);
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
                let (patch, ids) = decide::words_of_pair(kind, pair, frame, elements);
                let motion = cascade::motion(patch, ids, paths, error);
                if !cascade::apart_where_coplanar(&motion, patch, min_distance) {
                    set(kept, add_shared(counters, KEPT, 1), pair);
                }
            }
            barrier();
            let n = get(counters, KEPT);
            if t.lane == 0 && n > 0 {
                set(counters, BASE, count(output, 0, n));
                if of_edges {
                    count(output, 1, n);
                }
            }
            barrier();
            let base = get(counters, BASE);
            for share in 0..POOL / THREADS {
                let h = share * THREADS + t.lane;
                if h >= n {
                    break;
                }
                let pair = with_kind(kind, get(kept, h));
                write_pair(output, dispatch.capacity_out, base + h, pair);
            }
            barrier();
        }
    }
}
