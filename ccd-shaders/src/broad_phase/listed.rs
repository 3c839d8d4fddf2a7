//! From pairs of ids, which any source lists, to candidates: one pair a thread, appended by the
//! workgroup.
//!
//! Twin: of ccd-cpu `step/candidates.rs`, for pairs that another kernel has listed.

use crate::entry::kernel;
use crate::workgroup::{
    add_shared, barrier, count, get, part, read_pair, reserve, set, write_pair,
};
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::candidate::wanted;
use ccd_core::backend::kernel::Id;
use ccd_core::backend::kernel::memory::at;
use ccd_core::backend::layout::{Frame, Leaf, Pair, VERTEX_FACE};
use ccd_core::narrow_phase::decide;

const THREADS: u32 = Id::ListListed.threads();

/// Words of `counters`: pairs that are kept, where these go.
const KEPT: u32 = 0;
const BASE: u32 = 1;

kernel! {
    /// Thread `i` looks at the `i`-th pair: is it a candidate?
    list_listed[128](t; params: Listing; counters: [u32; 2]; boxes: [Aabb], elements: [u32],
        bodies: [u32], keys: [u32], input: [u32], mut output: [u32]) {
        let (frame, dispatch, kind) = (&params.frame, &params.dispatch, params.args.kind);
        let len = part(input, dispatch);
        for round in 0..decide::rounds(len, t.group, t.groups, THREADS) {
            let i = (t.group + round * t.groups) * THREADS + t.lane;
            if t.lane == 0 {
                set(counters, KEPT, 0);
            }
            barrier();
            let mut pair = Pair { a: 0, b: 0 };
            let (mut keeps, mut to) = (false, 0);
            if i < len {
                pair = read_pair(input, dispatch.first + i);
                let (_, ids) = decide::words_of_pair(kind, pair, frame, elements);
                let [a, b] = leaves(kind, pair, ids);
                let [p, q] = places(kind, frame, pair);
                let both = [&at(boxes, p as usize), &at(boxes, q as usize)];
                keeps = wanted(frame, kind, &a, &b, both, bodies, keys);
                if keeps {
                    to = add_shared(counters, KEPT, 1);
                }
            }
            barrier();
            if t.lane == 0 {
                let n = get(counters, KEPT);
                if n > 0 {
                    set(counters, BASE, reserve(output, n, params));
                    count(output, 1, n);
                }
            }
            barrier();
            if keeps {
                write_pair(output, dispatch.capacity_out, get(counters, BASE) + to, pair);
            }
        }
    }
}

/// Where the boxes of a pair are among all boxes.
#[inline(always)]
fn places(kind: u32, frame: &Frame, pair: Pair) -> [u32; 2] {
    if kind == VERTEX_FACE {
        [pair.a, frame.start[2] + pair.b]
    } else {
        [frame.start[1] + pair.a, frame.start[1] + pair.b]
    }
}

#[inline(always)]
fn leaves(kind: u32, pair: Pair, ids: [u32; 4]) -> [Leaf; 2] {
    let [v0, v1, v2, v3] = ids;
    let (a, b) =
        if kind == VERTEX_FACE { ([v0; 3], [v1, v2, v3]) } else { ([v0, v1, v1], [v2, v3, v3]) };
    [Leaf { vertices: a, id: pair.a }, Leaf { vertices: b, id: pair.b }]
}
