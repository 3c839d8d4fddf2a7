//! Workers that descend pairs of nodes of binary trees, and fronts at which they begin; see
//! `ccd_core::broad_phase::pair_workers`.
//!
//! A turn of a worker: its first thread says how many pairs come from the stack and how many from
//! the tasks; a thread expands one; inner pairs go onto the stack or, where that is full, to the
//! tasks of the next round, pairs of leaves to `pairs`, and what ends to the front, if one is kept.

use super::pair_descent::{count_front, fate, reserve};
use super::worker::{
    APART, Child, ENDED, ENDED_BASE, EXPANDED, INNER, LEAF, LEAVES, LEAVES_BASE, NEXT, NODES,
    Round, SPILL_BASE, TOP, TURNS, WORKS, claim, leave_rest, make_room, make_room_for_rest, plan,
    put_away, put_ended, take, write_task,
};
use crate::records::ObbWords;
use crate::workgroup::{add, barrier, count, get, get_uniform, group, set};
use ccd_core::broad_phase::block_bvh::sets;
use ccd_core::broad_phase::oriented_nodes::{only_reaching, reach};
use ccd_core::broad_phase::pair_descent::{NO_PAIR, children, expand};
use ccd_core::broad_phase::pair_workers::{THREADS, counts, listed};
use ccd_core::broad_phase::stack_traversal::NONE;
use ccd_core::kernel::memory::at;
use ccd_core::layout::{Node, NodeDescent, Params};
use ccd_core::model::method::Descent;
use spirv_std::glam::UVec3;
use spirv_std::spirv;

/// Of the children of a pair, those that meet.
macro_rules! meeting {
    ($within:ident, $all:expr, $internal:ident, $first:ident, $a:ident, $b:ident) => {
        $all
    };
    ($within:ident, $all:expr, $internal:ident, $first:ident, $a:ident, $b:ident, $obb:ident) => {
        only_reaching($within, $all, $internal, $first, $a, $b, $obb, $obb)
    };
}

/// Whether a pair whose boxes overlap meets.
macro_rules! meets {
    ($within:ident, $pair:ident, $internal:ident, $first:ident, $a:ident, $b:ident) => {
        true
    };
    ($within:ident, $pair:ident, $internal:ident, $first:ident, $a:ident, $b:ident, $obb:ident) => {
        reach($within, $pair, $internal, $first, $a, $b, $obb, $obb)
    };
}

/// The kernels of one volume: `$obb` is there for oriented boxes. The numbers are bindings.
macro_rules! kernels {
    ($workers:ident, $resume:ident, $control:tt $nodes:tt $pairs:tt $front:tt
        $(, $obb:ident $binding:tt)?) => {
        /// Workgroup `i` is worker `i` of round `dispatch.first`.
        #[spirv(compute(threads(128)))]
        pub fn $workers(
            #[spirv(workgroup_id)] id: UVec3,
            #[spirv(num_workgroups)] n: UVec3,
            #[spirv(local_invocation_index)] lane: u32,
            #[spirv(workgroup)] state: &mut [u32; 1],
            #[spirv(workgroup)] shared: &mut [u32; 18],
            #[spirv(workgroup)] stack: &mut [u32; 2048],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<NodeDescent>,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] a_nodes: &[Node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] b_nodes: &[Node],
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $binding)] $obb: &[ObbWords],)?
            #[spirv(storage_buffer, descriptor_set = 0, binding = $control)] control: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $nodes)] nodes: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $pairs)] pairs: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $front)] front: &mut [u32],
        ) {
            let own = params.own;
            let round = Round::new(params, group(id, n), control);
            let within = own.kind == 1;
            let [set_a, set_b] = sets(own.kind);
            let internal = [params.frame.count[set_a] - 1, params.frame.count[set_b] - 1];
            $(let _ = $obb;
            let first = [params.frame.start[set_a], params.frame.start[set_b]];)?
            let rule = if own.larger != 0 { Descent::Larger } else { Descent::Both };
            if lane == 0 {
                set(shared, TOP, 0);
                set(shared, NEXT, 0);
                set(shared, TURNS, 0);
                set(shared, EXPANDED, 0);
            }
            for turn in 0..own.turns {
                if lane == 0 {
                    let next = plan(&own, round, turn, shared, control);
                    set(state, 0, next);
                }
                if get_uniform(state, 0) != WORKS {
                    break;
                }
                let pair = take(lane, round.input, shared, stack, nodes);
                let (mut p, mut q) = (Child::NONE, Child::NONE);
                let (mut r, mut s) = (Child::NONE, Child::NONE);
                if pair[0] != NONE {
                    let found = expand(rule, within, a_nodes, b_nodes, pair);
                    let met = meeting!(within, found, internal, first, a_nodes, b_nodes $(, $obb)?);
                    let mut all = met;
                    if own.room_front > 0 {
                        all = children(rule, within, a_nodes, b_nodes, pair);
                    }
                    p = Child::new(met[0], all[0], internal);
                    q = Child::new(met[1], all[1], internal);
                    r = Child::new(met[2], all[2], internal);
                    s = Child::new(met[3], all[3], internal);
                    // A pair of the cut may be one of leaves already.
                    if fate(pair, internal) == LEAF {
                        p = Child { pair, fate: LEAF };
                    }
                }
                let room = own.room_front;
                let (to_p, to_q) = (claim(p.fate, room, shared), claim(q.fate, room, shared));
                let (to_r, to_s) = (claim(r.fate, room, shared), claim(s.fate, room, shared));
                barrier();
                if lane == 0 {
                    make_room(&own, round.number, shared, control, nodes, pairs);
                }
                barrier();
                let (to, x, y) = (round.output, a_nodes, b_nodes);
                put_away(params, to, p, to_p, shared, stack, x, y, nodes, pairs, front);
                put_away(params, to, q, to_q, shared, stack, x, y, nodes, pairs, front);
                put_away(params, to, r, to_r, shared, stack, x, y, nodes, pairs, front);
                put_away(params, to, s, to_s, shared, stack, x, y, nodes, pairs, front);
            }
            if lane == 0 {
                make_room_for_rest(&own, round, shared, control, nodes);
                add(control, counts(round.me), get(shared, TURNS));
                add(control, counts(round.me) + 1, get(shared, EXPANDED));
            }
            barrier();
            leave_rest(&own, round, lane, shared, stack, control, nodes);
        }

        /// Thread `i` looks at pair `i` of the `dispatch.n` of the front of the search before.
        #[spirv(compute(threads(128)))]
        pub fn $resume(
            #[spirv(workgroup_id)] id: UVec3,
            #[spirv(num_workgroups)] n: UVec3,
            #[spirv(local_invocation_index)] lane: u32,
            #[spirv(workgroup)] shared: &mut [u32; 18],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<NodeDescent>,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] a_nodes: &[Node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] b_nodes: &[Node],
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $binding)] $obb: &[ObbWords],)?
            #[spirv(storage_buffer, descriptor_set = 0, binding = $control)] control: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $nodes)] nodes: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $pairs)] pairs: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $front)] front: &mut [u32],
        ) {
            let i = group(id, n) * THREADS + lane;
            let own = params.own;
            let [set_a, set_b] = sets(own.kind);
            let internal = [params.frame.count[set_a] - 1, params.frame.count[set_b] - 1];
            $(let (_, within) = ($obb, own.kind == 1);
            let first = [params.frame.start[set_a], params.frame.start[set_b]];)?
            if lane == 0 {
                set(shared, NODES, 0);
                set(shared, LEAVES, 0);
                set(shared, ENDED, 0);
            }
            barrier();
            let (mut pair, mut fate) = (NO_PAIR, 0);
            if i < params.dispatch.n {
                let place = 2 * ((1 - own.written) * own.room_front + i) as usize;
                pair = [at(front, place), at(front, place + 1)];
                let (x, y) = (at(a_nodes, pair[0] as usize), at(b_nodes, pair[1] as usize));
                fate = APART;
                if x.aabb().overlaps(&y.aabb())
                    && meets!(within, pair, internal, first, a_nodes, b_nodes $(, $obb)?)
                {
                    fate = super::pair_descent::fate(pair, internal);
                }
            }
            let to = claim(fate, own.room_front, shared);
            barrier();
            if lane == 0 {
                let (n_nodes, n_leaves) = (get(shared, NODES), get(shared, LEAVES));
                if n_nodes > 0 {
                    set(shared, SPILL_BASE, reserve(control, listed(0), nodes, n_nodes));
                }
                if n_leaves > 0 {
                    set(shared, LEAVES_BASE, count(pairs, 0, n_leaves));
                }
                if get(shared, ENDED) > 0 {
                    set(shared, ENDED_BASE, count_front(control, get(shared, ENDED)));
                }
            }
            barrier();
            if fate == INNER {
                write_task(&own, 0, nodes, get(shared, SPILL_BASE) + to[0], pair);
            } else if fate != 0 {
                put_ended(params, pair, fate, to, shared, a_nodes, b_nodes, pairs, front);
            }
        }
    };
}

kernels!(pair_workers, resume_front, 3 4 5 6);
kernels!(pair_workers_oriented, resume_front_oriented, 4 5 6 7, oriented 3);
