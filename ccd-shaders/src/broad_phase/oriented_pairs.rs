//! Simultaneous traversal of trees of oriented boxes: as `pair_descent`, and pairs of nodes that
//! their oriented boxes tell apart are left out.

use super::pair_descent::{
    LEAVES, LEAVES_BASE, NODES, NODES_BASE, claim, fate, keep, of_cuts, place, reserve,
};
use crate::records::ObbWords;
use crate::workgroup::{barrier, count, get, group, read_pair, set};
use ccd_core::broad_phase::block_bvh::sets;
use ccd_core::broad_phase::oriented_nodes::{only_reaching, reach};
use ccd_core::broad_phase::pair_descent::expand;
use ccd_core::broad_phase::stack_traversal::NONE;
use ccd_core::kernel::Id;
use ccd_core::kernel::memory::at;
use ccd_core::layout::{Node, NodeDescent, Params};
use ccd_core::model::method::Descent;
use spirv_std::glam::UVec3;
use spirv_std::spirv;

const THREADS: u32 = Id::ExpandPairsOriented.threads();
const CUTTERS: u32 = Id::CutPairsOriented.threads();

/// As `cut_pairs`.
#[spirv(compute(threads(256)))]
pub fn cut_pairs_oriented(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<NodeDescent>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] a_nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] b_nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] cuts: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] oriented: &[ObbWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] control: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] output: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] front: &mut [u32],
) {
    let pair = of_cuts(&params.own, group(id, n) * CUTTERS + lane, cuts);
    if pair[0] != NONE {
        let (x, y) = (at(a_nodes, pair[0] as usize), at(b_nodes, pair[1] as usize));
        let [set_a, set_b] = sets(params.own.kind);
        let internal = [params.frame.count[set_a] - 1, params.frame.count[set_b] - 1];
        let first = [params.frame.start[set_a], params.frame.start[set_b]];
        let within = params.own.kind == 1;
        // A leaf makes no pair with itself.
        if !(within && pair[0] == pair[1] && x.is_leaf()) {
            let meets = x.aabb().overlaps(&y.aabb())
                && reach(within, pair, internal, first, a_nodes, b_nodes, oriented, oriented);
            place(params, pair, meets, control, output, front);
        }
    }
}

/// As `expand_pairs`.
#[spirv(compute(threads(128)))]
pub fn expand_pairs_oriented(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] counters: &mut [u32; 4],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<NodeDescent>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] a_nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] b_nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] oriented: &[ObbWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] input: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] levels: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] output: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] pairs: &mut [u32],
) {
    let (own, groups) = (group(id, n), n.x * n.y);
    let (kind, level) = (params.own.kind, params.dispatch.first as usize);
    let [set_a, set_b] = sets(kind);
    let internal = [params.frame.count[set_a] - 1, params.frame.count[set_b] - 1];
    let first = [params.frame.start[set_a], params.frame.start[set_b]];
    let rule = if params.own.larger != 0 { Descent::Larger } else { Descent::Both };
    let there = at(levels, level).min(params.dispatch.room_in);
    // As many rounds as the room would take, because only that is the same for all threads for
    // certain.
    for round in 0..params.dispatch.room_in.div_ceil(groups * THREADS) {
        let i = (own + round * groups) * THREADS + lane;
        if lane == 0 {
            set(counters, NODES, 0);
            set(counters, LEAVES, 0);
        }
        barrier();
        let (mut p, mut q) = ([NONE; 2], [NONE; 2]);
        let (mut r, mut s) = ([NONE; 2], [NONE; 2]);
        if i < there {
            let pair = read_pair(input, i);
            let [a, b] = [pair.a, pair.b];
            let all = expand(rule, kind == 1, a_nodes, b_nodes, [a, b]).met;
            let children = only_reaching(
                kind == 1,
                all,
                internal,
                first,
                a_nodes,
                b_nodes,
                oriented,
                oriented,
            );
            p = children[0];
            q = children[1];
            r = children[2];
            s = children[3];
            // A pair of the cut may be one of leaves already.
            if fate([a, b], internal) == 2 {
                p = [a, b];
            }
        }
        let (to_p, to_q) = (claim(p, internal, counters), claim(q, internal, counters));
        let (to_r, to_s) = (claim(r, internal, counters), claim(s, internal, counters));
        barrier();
        if lane == 0 {
            let (n_nodes, n_leaves) = (get(counters, NODES), get(counters, LEAVES));
            if n_nodes > 0 {
                set(counters, NODES_BASE, reserve(levels, level + 1, output, n_nodes));
            }
            if n_leaves > 0 {
                set(counters, LEAVES_BASE, count(pairs, 0, n_leaves));
            }
        }
        barrier();
        let bases = [get(counters, NODES_BASE), get(counters, LEAVES_BASE)];
        keep(params, p, internal, bases, to_p, a_nodes, b_nodes, output, pairs);
        keep(params, q, internal, bases, to_q, a_nodes, b_nodes, output, pairs);
        keep(params, r, internal, bases, to_r, a_nodes, b_nodes, output, pairs);
        keep(params, s, internal, bases, to_s, a_nodes, b_nodes, output, pairs);
    }
}
