//! From pairs of ids, which any source lists, to candidates and to candidates that pass the
//! filters: one pair a thread, appended by the workgroup.

use crate::workgroup::{
    add_shared, barrier, count, get, group, length, read_pair, set, write_pair,
};
use ccd_core::Aabb;
use ccd_core::broad_phase::candidate::wanted;
use ccd_core::kernel::Id;
use ccd_core::kernel::memory::at;
use ccd_core::layout::{Frame, Leaf, Pair, Params, Path};
use ccd_core::narrow_phase::{cascade, decide};
use spirv_std::glam::UVec3;
use spirv_std::spirv;

const THREADS: u32 = Id::FilterListedEdgeEdge.threads();

/// Words of `counters`: pairs that are kept, candidates, where the kept ones go.
const KEPT: u32 = 0;
const WANTED: u32 = 1;
const BASE: u32 = 2;

macro_rules! listed_entry {
    (
        $(#[$doc:meta])* $name:ident, $kind:literal, $element:ty, $leaves:ident, $may_touch:ident,
        [$($paths:ident)?], $input:literal, $output:literal
    ) => {
        $(#[$doc])*
        #[spirv(compute(threads(128)))]
        pub fn $name(
            #[spirv(workgroup_id)] id: UVec3,
            #[spirv(num_workgroups)] n: UVec3,
            #[spirv(local_invocation_index)] lane: u32,
            #[spirv(workgroup)] counters: &mut [u32; 4],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] boxes: &[Aabb],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] elements: &[$element],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] bodies: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] keys: &[[[u32; 2]; 6]],
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = 5)] $paths: &[Path],)?
            #[spirv(storage_buffer, descriptor_set = 0, binding = $input)] input: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $output)] output: &mut [u32],
        ) {
            let (own, groups) = (group(id, n), n.x * n.y);
            let (frame, dispatch) = (&params.frame, &params.dispatch);
            let there = length(input, dispatch.room_in);
            let left = if there > dispatch.first { there - dispatch.first } else { 0 };
            let there = left.min(dispatch.n);
            for round in 0..decide::rounds(there, own, groups, THREADS) {
                let i = (own + round * groups) * THREADS + lane;
                if lane == 0 {
                    set(counters, KEPT, 0);
                    set(counters, WANTED, 0);
                }
                barrier();
                let mut pair = Pair { a: 0, b: 0 };
                let (mut keeps, mut to) = (false, 0);
                if i < there {
                    pair = read_pair(input, dispatch.first + i);
                    let [a, b] = $leaves(pair, elements);
                    let [p, q] = places($kind, frame, pair);
                    let both = [&at(boxes, p as usize), &at(boxes, q as usize)];
                    if wanted(frame, $kind, &a, &b, both, bodies, keys) {
                        add_shared(counters, WANTED, 1);
                        keeps = $may_touch(&a, &b, frame, $($paths)?);
                        if keeps {
                            to = add_shared(counters, KEPT, 1);
                        }
                    }
                }
                barrier();
                if lane == 0 {
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
                    write_pair(output, dispatch.room_out, get(counters, BASE) + to, pair);
                }
            }
        }
    };
}

listed_entry!(
    /// Thread `i` looks at the `i`-th pair of a vertex and a face: is it a candidate?
    list_listed_vertex_face,
    0,
    [u32; 3],
    vertex_and_face,
    all,
    [],
    5,
    6
);
listed_entry!(
    /// Thread `i` looks at the `i`-th pair of edges: is it a candidate?
    list_listed_edge_edge,
    1,
    [u32; 2],
    two_edges,
    all,
    [],
    5,
    6
);
listed_entry!(
    /// Thread `i` looks at the `i`-th pair of a vertex and a face: is it a candidate that may
    /// touch?
    filter_listed_vertex_face,
    0,
    [u32; 3],
    vertex_and_face,
    may_touch_vertex_face,
    [paths],
    6,
    7
);
listed_entry!(
    /// Thread `i` looks at the `i`-th pair of edges: is it a candidate that may touch?
    filter_listed_edge_edge,
    1,
    [u32; 2],
    two_edges,
    may_touch_edge_edge,
    [paths],
    6,
    7
);

/// Where the boxes of a pair are among all boxes.
#[inline(always)]
fn places(kind: u32, frame: &Frame, pair: Pair) -> [u32; 2] {
    if kind == 0 {
        [pair.a, frame.start[2] + pair.b]
    } else {
        [frame.start[1] + pair.a, frame.start[1] + pair.b]
    }
}

#[inline(always)]
fn vertex_and_face(pair: Pair, faces: &[[u32; 3]]) -> [Leaf; 2] {
    [
        Leaf { vertices: [pair.a; 3], id: pair.a },
        Leaf { vertices: at(faces, pair.b as usize), id: pair.b },
    ]
}

#[inline(always)]
fn two_edges(pair: Pair, edges: &[[u32; 2]]) -> [Leaf; 2] {
    let (a, b) = (at(edges, pair.a as usize), at(edges, pair.b as usize));
    [
        Leaf { vertices: [a[0], a[1], a[1]], id: pair.a },
        Leaf { vertices: [b[0], b[1], b[1]], id: pair.b },
    ]
}

#[inline(always)]
fn all(_a: &Leaf, _b: &Leaf, _frame: &Frame) -> bool {
    true
}

#[inline(always)]
fn may_touch_vertex_face(a: &Leaf, b: &Leaf, frame: &Frame, paths: &[Path]) -> bool {
    cascade::vertex_face(a, b, paths, frame.path_error, frame.min_distance)
}

/// The lesser edge is the first of a listed pair.
#[inline(always)]
fn may_touch_edge_edge(a: &Leaf, b: &Leaf, frame: &Frame, paths: &[Path]) -> bool {
    cascade::edge_edge(a, b, paths, frame.path_error, frame.min_distance)
}
