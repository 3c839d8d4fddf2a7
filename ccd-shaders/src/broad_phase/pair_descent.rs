//! Simultaneous traversal of binary trees, one level of pairs of nodes a dispatch: from all pairs
//! of two cuts on, every pair is expanded by one thread into at most four, and those of leaves are
//! found; see `ccd_core::broad_phase::pair_descent`.

use crate::workgroup::{
    add, add_shared, barrier, count, get, group, raise, read_pair, set, write_pair,
};
use ccd_core::broad_phase::block_bvh::sets;
use ccd_core::broad_phase::pair_descent::{NodePair, expand};
use ccd_core::broad_phase::stack_traversal::NONE;
use ccd_core::kernel::Id;
use ccd_core::kernel::memory::{at, put};
use ccd_core::layout::{Branch, LIST_HEADER, Node, NodeDescent, Pair, Params};
use ccd_core::model::method::Descent;
use spirv_std::glam::UVec3;
use spirv_std::spirv;

const THREADS: u32 = Id::ExpandPairs.threads();
const CUTTERS: u32 = Id::CutNodes.threads();
/// Rounds in which a cut is made: each may double it.
const ROUNDS: u32 = 32;
/// Nodes of a cut that a thread looks at.
const SHARE: u32 = 1024 / CUTTERS;

/// Words of `counters`: pairs of nodes, pairs of leaves, where they go.
pub(super) const NODES: u32 = 0;
pub(super) const LEAVES: u32 = 1;
pub(super) const NODES_BASE: u32 = 2;
pub(super) const LEAVES_BASE: u32 = 3;

/// One workgroup lists the nodes of a cut through the tree over set `own.kind`, at most `own.nodes`
/// of them. A node is split, if there is room, while it has more than its share of the leaves.
#[spirv(compute(threads(256)))]
pub fn cut_nodes(
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] nodes: &mut [u32; 1024],
    #[spirv(workgroup)] counters: &mut [u32; 4],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<NodeDescent>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] branches: &[Branch],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] cut: &mut [u32],
) {
    let n_leaves = params.frame.count[params.own.kind as usize];
    let (n_internal, share) = (n_leaves - 1, n_leaves / params.own.nodes);
    if lane == 0 {
        set(nodes, 0, 0);
        set(counters, 0, 1);
        set(counters, 1, 0);
    }
    barrier();
    for _ in 0..ROUNDS {
        let n = get(counters, 0);
        barrier();
        for s in 0..SHARE {
            let k = s * CUTTERS + lane;
            if k < n {
                let node = get(nodes, k);
                if node < n_internal {
                    let branch = at(branches, node as usize);
                    if branch.last - branch.first >= share {
                        let to = n + add_shared(counters, 1, 1);
                        if to < params.own.nodes {
                            set(nodes, k, branch.left);
                            set(nodes, to, branch.right);
                        }
                    }
                }
            }
        }
        barrier();
        if lane == 0 {
            set(counters, 0, (n + get(counters, 1)).min(params.own.nodes));
            set(counters, 1, 0);
        }
        barrier();
    }
    let n = get(counters, 0);
    for s in 0..SHARE {
        let k = s * CUTTERS + lane;
        if k < n {
            put(cut, LIST_HEADER + k as usize, get(nodes, k));
        }
    }
    if lane == 0 {
        put(cut, 0, n);
    }
}

/// Thread `i * own.nodes + j` looks at the pair of node `i` of the first cut and node `j` of the
/// second; within one tree if `i <= j`.
#[spirv(compute(threads(256)))]
pub fn cut_pairs(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<NodeDescent>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] a_nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] b_nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] a_cut: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] b_cut: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] levels: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] output: &mut [u32],
) {
    let k = group(id, n) * CUTTERS + lane;
    let (i, j) = (k / params.own.nodes, k % params.own.nodes);
    if i < at(a_cut, 0) && j < at(b_cut, 0) {
        let (a, b) = (at(a_cut, LIST_HEADER + i as usize), at(b_cut, LIST_HEADER + j as usize));
        let (x, y) = (at(a_nodes, a as usize), at(b_nodes, b as usize));
        let within = params.own.kind == 1;
        // A leaf makes no pair with itself.
        let is_pair = if within { i < j || (i == j && !x.is_leaf()) } else { true };
        if is_pair && x.aabb().overlaps(&y.aabb()) {
            let to = reserve(levels, 0, output, 1);
            write_pair(output, params.own.room_nodes, to, Pair { a, b });
        }
    }
}

/// Reserves entries of a level in a list that is used for several levels: its header says the most
/// that any wanted. Returns where they begin.
#[inline(always)]
pub(super) fn reserve(levels: &mut [u32], level: usize, list: &mut [u32], n: u32) -> u32 {
    let old = add(levels, level, n);
    raise(list, 0, old.wrapping_add(n));
    if old.wrapping_add(n) < old {
        add(list, 2, 1);
    }
    old
}

/// What becomes of a pair of nodes: 0: there is none; 1: it is expanded in the next level; 2: it is
/// one of leaves.
#[inline(always)]
pub(super) fn fate(pair: NodePair, internal: [u32; 2]) -> u32 {
    if pair[0] == NONE {
        0
    } else if pair[0] >= internal[0] && pair[1] >= internal[1] {
        2
    } else {
        1
    }
}

/// Thread `i` expands the `i`-th pair of nodes of level `dispatch.first`.
#[spirv(compute(threads(128)))]
pub fn expand_pairs(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] counters: &mut [u32; 4],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<NodeDescent>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] a_nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] b_nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] input: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] levels: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] output: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] pairs: &mut [u32],
) {
    let (own, groups) = (group(id, n), n.x * n.y);
    let (kind, level) = (params.own.kind, params.dispatch.first as usize);
    let [set_a, set_b] = sets(kind);
    let internal = [params.frame.count[set_a] - 1, params.frame.count[set_b] - 1];
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
            let children = expand(rule, kind == 1, a_nodes, b_nodes, [pair.a, pair.b]);
            p = children[0];
            q = children[1];
            r = children[2];
            s = children[3];
            // A pair of the cut may be one of leaves already.
            if fate([pair.a, pair.b], internal) == 2 {
                p = [pair.a, pair.b];
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

/// Counts a pair in its workgroup; returns the number that it has there.
#[inline(always)]
pub(super) fn claim(pair: NodePair, internal: [u32; 2], counters: &mut [u32; 4]) -> u32 {
    let fate = fate(pair, internal);
    let mut to = 0;
    if fate != 0 {
        to = add_shared(counters, if fate == 1 { NODES } else { LEAVES }, 1);
    }
    to
}

/// Writes a pair to where it belongs.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "naga refuses structures that hold views")]
pub(super) fn keep(
    params: &Params<NodeDescent>,
    pair: NodePair,
    internal: [u32; 2],
    bases: [u32; 2],
    to: u32,
    a_nodes: &[Node],
    b_nodes: &[Node],
    output: &mut [u32],
    pairs: &mut [u32],
) {
    let fate = fate(pair, internal);
    if fate == 1 {
        let pair = Pair { a: pair[0], b: pair[1] };
        write_pair(output, params.own.room_nodes, bases[0] + to, pair);
    } else if fate == 2 {
        let (a, b) = (at(a_nodes, pair[0] as usize).left, at(b_nodes, pair[1] as usize).left);
        let pair = if params.own.kind == 1 { Pair::ordered(a, b) } else { Pair { a, b } };
        write_pair(pairs, params.dispatch.room_out, bases[1] + to, pair);
    }
}
