//! From pairs of ids, which any source lists, to candidates and to candidates that pass the
//! filters: one pair a thread, appended by the workgroup.
//!
//! Twin: of ccd-cpu `step/candidates.rs`, for pairs that another kernel has listed.

use crate::entry::kernel;
use crate::records::PathWords;
use crate::workgroup::{add_shared, barrier, count, get, part, read_pair, set, write_pair};
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::candidate::wanted;
use ccd_core::backend::kernel::Id;
use ccd_core::backend::kernel::memory::at;
use ccd_core::backend::layout::{Frame, Leaf, Pair, VERTEX_FACE};
use ccd_core::narrow_phase::relative_motion::Patch;
use ccd_core::narrow_phase::{cascade, decide};

const THREADS: u32 = Id::FilterListed.threads();

/// Words of `counters`: pairs that are kept, candidates, where the kept ones go.
const KEPT: u32 = 0;
const WANTED: u32 = 1;
const BASE: u32 = 2;

macro_rules! listed {
    ($(#[$doc:meta])* $name:ident, $may_touch:ident [$($paths:ident)?]) => {
        kernel! {
            $(#[$doc])*
            $name[128](t; params: Decision; counters: [u32; 4]; boxes: [Aabb], elements: [u32],
                bodies: [u32], keys: [[[u32; 2]; 6]], $($paths: [PathWords],)? input: [u32],
                mut output: [u32]) {
                let (frame, dispatch, kind) = (&params.frame, &params.dispatch, params.args.kind);
                let len = part(input, dispatch);
                for round in 0..decide::rounds(len, t.group, t.groups, THREADS) {
                    let i = (t.group + round * t.groups) * THREADS + t.lane;
                    if t.lane == 0 {
                        set(counters, KEPT, 0);
                        set(counters, WANTED, 0);
                    }
                    barrier();
                    let mut pair = Pair { a: 0, b: 0 };
                    let (mut keeps, mut to) = (false, 0);
                    if i < len {
                        pair = read_pair(input, dispatch.first + i);
                        let (patch, ids) = decide::words_of_pair(kind, pair, elements);
                        let [a, b] = leaves(kind, pair, ids);
                        let [p, q] = places(kind, frame, pair);
                        let both = [&at(boxes, p as usize), &at(boxes, q as usize)];
                        if wanted(frame, kind, &a, &b, both, bodies, keys) {
                            add_shared(counters, WANTED, 1);
                            keeps = $may_touch(patch, ids, frame, $($paths)?);
                            if keeps {
                                to = add_shared(counters, KEPT, 1);
                            }
                        }
                    }
                    barrier();
                    if t.lane == 0 {
                        let (n_kept, n_wanted) = (get(counters, KEPT), get(counters, WANTED));
                        if n_kept > 0 {
                            set(counters, BASE, count(output, 0, n_kept));
                        }
                        if n_wanted > 0 {
                            count(output, 1, n_wanted);
                        }
                    }
                    barrier();
                    if keeps {
                        write_pair(output, dispatch.capacity_out, get(counters, BASE) + to, pair);
                    }
                }
            }
        }
    };
}

listed!(
    /// Thread `i` looks at the `i`-th pair: is it a candidate? `elements`: of faces, or of edges,
    /// as the kind has them.
    list_listed, all []
);
listed!(
    /// The same: is it a candidate that may touch?
    filter_listed, may_touch [paths]
);

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

#[inline(always)]
fn all(_: Patch, _: [u32; 4], _: &Frame) -> bool {
    true
}

/// The lesser edge is the first of a listed pair.
#[inline(always)]
fn may_touch(patch: Patch, ids: [u32; 4], frame: &Frame, paths: &[PathWords]) -> bool {
    cascade::may_touch(patch, ids, paths, frame.path_error, frame.min_distance)
}
