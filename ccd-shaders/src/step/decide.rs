//! Verdicts of what the filters left: in `f64`, or in `f32` with what that cannot decide passed on.

use crate::workgroup::{
    add, add_shared, barrier, get, group, lower, part, read_pair, set, write_pair,
};
use ccd_core::kernel::Id;
use ccd_core::kernel::memory::put;
use ccd_core::layout::{Decision, Frame, LIST_HEADER, Pair, Params, Path, TOUCH_WORDS, Touch};
use ccd_core::narrow_phase::decide::{self, Verdicts};
use spirv_std::glam::UVec3;
use spirv_std::spirv;

const THREADS: u32 = Id::DecideVertexFace.threads();

/// Appends to a list one entry of every thread that has one, in one addition for the workgroup.
/// Returns where this thread's goes.
#[inline(always)]
fn place(lane: u32, has: bool, counters: &mut [u32; 4], list: &mut [u32]) -> u32 {
    if lane == 0 {
        set(counters, 0, 0);
    }
    barrier();
    let mut own = 0;
    if has {
        own = add_shared(counters, 0, 1);
    }
    barrier();
    if lane == 0 {
        let n = get(counters, 0);
        if n > 0 {
            set(counters, 1, add(list, 0, n));
        }
    }
    barrier();
    get(counters, 1) + own
}

#[inline(always)]
fn write_touch(list: &mut [u32], room: u32, i: u32, touch: &Touch) {
    if i < room {
        let to = LIST_HEADER + TOUCH_WORDS * i as usize;
        put(list, to, touch.kind);
        put(list, to + 1, touch.state);
        put(list, to + 2, touch.a);
        put(list, to + 3, touch.b);
        put(list, to + 4, touch.toi[0]);
        put(list, to + 5, touch.toi[1]);
        put(list, to + 6, touch.approach);
    }
}

macro_rules! decide_wide_entry {
    ($(#[$doc:meta])* $name:ident, $kind:literal, $body:path, $element:ty) => {
        $(#[$doc])*
        #[spirv(compute(threads(64)))]
        pub fn $name(
            #[spirv(workgroup_id)] id: UVec3,
            #[spirv(num_workgroups)] n: UVec3,
            #[spirv(local_invocation_index)] lane: u32,
            #[spirv(workgroup)] counters: &mut [u32; 4],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] paths: &[Path],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] positions: &[[f64; 3]],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] elements: &[$element],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] input: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] contacts: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] earliest: &mut [u32],
        ) {
            let (own, groups) = (group(id, n), n.x * n.y);
            let there = part(input, &params.dispatch);
            for round in 0..decide::rounds(there, own, groups, THREADS) {
                let i = (own + round * groups) * THREADS + lane;
                let mut touch =
                    Touch { kind: $kind, state: 0, a: 0, b: 0, toi: [0; 2], approach: 0 };
                let mut found = false;
                if i < there {
                    let pair = read_pair(input, params.dispatch.first + i);
                    let Verdicts { touches, undecided, approach, toi } =
                        $body(pair, &params.frame, paths, positions, elements);
                    found = touches;
                    touch.a = pair.a;
                    touch.b = pair.b;
                    touch.state = undecided;
                    touch.toi = toi;
                    touch.approach = approach;
                    if found {
                        lower(earliest, 0, decide::earliest_key(toi));
                    }
                }
                if params.frame.has(Frame::FLAG_KEEP) {
                    let to = place(lane, found, counters, contacts);
                    if found {
                        write_touch(contacts, params.dispatch.room_out, to, &touch);
                    }
                }
            }
        }
    };
}

decide_wide_entry!(
    /// Thread `i` decides the `i`-th vertex-face pair from `dispatch.first` on in `f64`.
    decide_vertex_face_wide,
    0,
    decide::vertex_face_wide,
    [u32; 3]
);
decide_wide_entry!(
    /// Thread `i` decides the `i`-th edge-edge pair from `dispatch.first` on in `f64`.
    decide_edge_edge_wide,
    1,
    decide::edge_edge_wide,
    [u32; 2]
);

macro_rules! decide_entry {
    ($(#[$doc:meta])* $name:ident, $kind:literal, $body:path, $element:ty) => {
        $(#[$doc])*
        #[spirv(compute(threads(64)))]
        pub fn $name(
            #[spirv(workgroup_id)] id: UVec3,
            #[spirv(num_workgroups)] n: UVec3,
            #[spirv(local_invocation_index)] lane: u32,
            #[spirv(workgroup)] counters: &mut [u32; 4],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<Decision>,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] paths: &[Path],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] elements: &[$element],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] input: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] contacts: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] undecided: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] earliest: &mut [u32],
        ) {
            let (own, groups) = (group(id, n), n.x * n.y);
            let there = part(input, &params.dispatch);
            for round in 0..decide::rounds(there, own, groups, THREADS) {
                let i = (own + round * groups) * THREADS + lane;
                let mut touch =
                    Touch { kind: $kind, state: 0, a: 0, b: 0, toi: [0; 2], approach: 0 };
                let (mut certain, mut open) = (false, false);
                if i < there {
                    let pair = read_pair(input, params.dispatch.first + i);
                    let verdict = $body(pair, &params.frame, paths, elements);
                    certain = verdict.touches && verdict.undecided == 0;
                    open = verdict.undecided != 0;
                    touch.a = pair.a;
                    touch.b = pair.b;
                    touch.toi = verdict.toi;
                    touch.approach = verdict.approach;
                    if certain {
                        lower(earliest, 0, decide::earliest_key(verdict.toi));
                    }
                }
                if params.frame.has(Frame::FLAG_KEEP) {
                    let to = place(lane, certain, counters, contacts);
                    if certain {
                        write_touch(contacts, params.dispatch.room_out, to, &touch);
                    }
                }
                barrier();
                // Counted also beyond the room, so that the host sees how many there are.
                let to = place(lane, open, counters, undecided);
                if open {
                    write_pair(
                        undecided,
                        params.own.room_open,
                        to,
                        Pair { a: touch.a, b: touch.b },
                    );
                }
            }
        }
    };
}

decide_entry!(
    /// Thread `i` decides the `i`-th vertex-face pair from `dispatch.first` on in `f32`; what that
    /// leaves open goes to `undecided`.
    decide_vertex_face,
    0,
    decide::vertex_face,
    [u32; 3]
);
decide_entry!(
    /// Thread `i` decides the `i`-th edge-edge pair from `dispatch.first` on in `f32`; what that
    /// leaves open goes to `undecided`.
    decide_edge_edge,
    1,
    decide::edge_edge,
    [u32; 2]
);
