//! Simultaneous traversal of binary trees, one level of pairs of nodes a dispatch: from all pairs
//! of two cuts on, every pair is expanded by one thread into at most four, and those of leaves are
//! found; see `ccd_core::backend::broad_phase::pair_descent`.

use super::volume::{BinaryTrees, Boxes, INNER, LEAF, Oriented, Volume, fate};
use crate::entry::{Thread, kernel};
use crate::records::ObbWords;
use crate::workgroup::{add, add_shared, barrier, count, get, raise, read_pair, set, write_pair};
use ccd_core::backend::broad_phase::pair_descent::{NodePair, expand};
use ccd_core::backend::broad_phase::pair_workers::FRONT;
use ccd_core::backend::broad_phase::stack_traversal::NONE;
use ccd_core::backend::kernel::Id;
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::layout::{Branch, EDGE_EDGE, LIST_HEADER, Node, NodeDescent, Pair, Params};
use ccd_core::model::method::Traversal;

const THREADS: u32 = Id::ExpandPairs.threads();
const CUTTERS: u32 = Id::CutNodes.threads();
/// Rounds in which a cut is made: each may double it.
const ROUNDS: u32 = 32;
/// Nodes of a cut that a thread looks at.
const SHARE: u32 = 1024 / CUTTERS;

/// Words of `counters`: pairs of nodes, pairs of leaves, where they go.
const NODES: u32 = 0;
const LEAVES: u32 = 1;
const NODES_BASE: u32 = 2;
const LEAVES_BASE: u32 = 3;

kernel! {
    /// One workgroup lists the nodes of a cut through the tree over set `args.kind`, at most
    /// `args.nodes` of them, as the cut of side `dispatch.first`. A node is split
    /// while it has more than its share of the leaves and the cut is not full.
    cut_nodes[256](t; params: NodeDescent; nodes: [u32; 1024], counters: [u32; 4];
        branches: [Branch], mut cuts: [u32]) {
        let first = cut_start(params.dispatch.first) + LIST_HEADER;
        let n_leaves = params.frame.count[params.args.kind as usize];
        let (n_internal, share) = (n_leaves - 1, n_leaves / params.args.nodes);
        if t.lane == 0 {
            set(nodes, 0, 0);
            set(counters, 0, 1);
            set(counters, 1, 0);
        }
        barrier();
        for _ in 0..ROUNDS {
            let n = get(counters, 0);
            barrier();
            for s in 0..SHARE {
                let k = s * CUTTERS + t.lane;
                if k < n {
                    let node = get(nodes, k);
                    if node < n_internal {
                        let branch = at(branches, node as usize);
                        if branch.last - branch.first >= share {
                            let to = n + add_shared(counters, 1, 1);
                            if to < params.args.nodes {
                                set(nodes, k, branch.left);
                                set(nodes, to, branch.right);
                            }
                        }
                    }
                }
            }
            barrier();
            if t.lane == 0 {
                set(counters, 0, (n + get(counters, 1)).min(params.args.nodes));
                set(counters, 1, 0);
            }
            barrier();
        }
        let n = get(counters, 0);
        for s in 0..SHARE {
            let k = s * CUTTERS + t.lane;
            if k < n {
                put(cuts, first + k as usize, get(nodes, k));
            }
        }
        if t.lane == 0 {
            put(cuts, first - LIST_HEADER, n);
        }
    }
}

/// Where the cut of a side begins; within one tree there is one for both.
#[inline(always)]
fn cut_start(side: u32) -> usize {
    side as usize * (LIST_HEADER + Traversal::MAX_CUT as usize)
}

kernel! {
    /// Thread `i * args.nodes + j` looks at the pair of node `i` of the first cut and node `j` of
    /// the second; within one tree if `i <= j`. Those that meet are listed, the others go to the
    /// front that is written, if one is kept.
    cut_pairs[256](t; params: NodeDescent;; a_nodes: [Node], b_nodes: [Node], cuts: [u32],
        mut control: [u32], mut output: [u32], mut front: [u32]) {
        let trees = BinaryTrees { params, a: a_nodes, b: b_nodes, volume: Boxes };
        begin(trees, of_cuts(&params.args, t.i, cuts), control, output, front);
    }
}

kernel! {
    /// As `cut_pairs`, of trees of oriented boxes.
    cut_pairs_oriented[256](t; params: NodeDescent;; a_nodes: [Node], b_nodes: [Node], cuts: [u32],
        oriented: [ObbWords], mut control: [u32], mut output: [u32], mut front: [u32]) {
        let trees = BinaryTrees { params, a: a_nodes, b: b_nodes, volume: Oriented(oriented) };
        begin(trees, of_cuts(&params.args, t.i, cuts), control, output, front);
    }
}

/// Makes the pair of two cuts a task of round 0 if it meets; another ends there, and belongs to the
/// front.
#[inline(always)]
fn begin<V: Volume>(
    trees: BinaryTrees<V>,
    pair: NodePair,
    control: &mut [u32],
    output: &mut [u32],
    front: &mut [u32],
) {
    let args = &trees.params.args;
    if pair[0] != NONE && !is_leaf_with_itself(trees, pair) {
        if meets(trees, pair) {
            let to = reserve(control, 0, output, 1);
            write_pair(output, args.capacity_nodes, to, Pair { a: pair[0], b: pair[1] });
        } else if args.capacity_front > 0 {
            let to = count_front(control, 1);
            write_front(args, front, to, pair);
        }
    }
}

/// Whether both nodes are one leaf, which makes no pair with itself.
#[inline(always)]
pub(super) fn is_leaf_with_itself<V: Volume>(trees: BinaryTrees<V>, pair: NodePair) -> bool {
    trees.within() && pair[0] == pair[1] && trees.nodes(pair).0.is_leaf()
}

/// Whether the volumes of two nodes overlap.
#[inline(always)]
pub(super) fn meets<V: Volume>(trees: BinaryTrees<V>, pair: NodePair) -> bool {
    let (x, y) = trees.nodes(pair);
    x.aabb().overlaps(&y.aabb()) && V::meets(trees, pair)
}

/// Pair `k` of two cuts, or of one, of which the second node does not stand before the first.
#[inline(always)]
pub(super) fn of_cuts(args: &NodeDescent, k: u32, cuts: &[u32]) -> NodePair {
    let (i, j, within) = (k / args.nodes, k % args.nodes, args.kind == EDGE_EDGE);
    let (a, b) = (cut_start(0), cut_start(if within { 0 } else { 1 }));
    let mut pair = [NONE; 2];
    if i < at(cuts, a) && j < at(cuts, b) && (!within || i <= j) {
        pair = [at(cuts, a + LIST_HEADER + i as usize), at(cuts, b + LIST_HEADER + j as usize)];
    }
    pair
}

/// Counts pairs of the front that is written; returns the number of the first.
#[inline(always)]
pub(super) fn count_front(control: &mut [u32], n: u32) -> u32 {
    let old = add(control, FRONT, n);
    if old.wrapping_add(n) < old {
        add(control, FRONT + 1, 1);
    }
    old
}

/// Writes a pair of the front; one beyond the capacity is only counted.
#[inline(always)]
pub(super) fn write_front(args: &NodeDescent, front: &mut [u32], i: u32, pair: NodePair) {
    if i < args.capacity_front {
        let to = 2 * (args.written * args.capacity_front + i) as usize;
        put(front, to, pair[0]);
        put(front, to + 1, pair[1]);
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

kernel! {
    /// Thread `i` expands the `i`-th pair of nodes of level `dispatch.first`.
    expand_pairs[128](t; params: NodeDescent; counters: [u32; 4]; a_nodes: [Node], b_nodes: [Node],
        input: [u32], mut levels: [u32], mut output: [u32], mut pairs: [u32]) {
        let trees = BinaryTrees { params, a: a_nodes, b: b_nodes, volume: Boxes };
        expand_level(trees, t, counters, input, levels, output, pairs);
    }
}

kernel! {
    /// As `expand_pairs`, of trees of oriented boxes.
    expand_pairs_oriented[128](t; params: NodeDescent; counters: [u32; 4]; a_nodes: [Node],
        b_nodes: [Node], oriented: [ObbWords], input: [u32], mut levels: [u32], mut output: [u32],
        mut pairs: [u32]) {
        let trees = BinaryTrees { params, a: a_nodes, b: b_nodes, volume: Oriented(oriented) };
        expand_level(trees, t, counters, input, levels, output, pairs);
    }
}

#[inline(always)]
fn expand_level<V: Volume>(
    trees: BinaryTrees<V>,
    t: Thread,
    counters: &mut [u32; 4],
    input: &[u32],
    levels: &mut [u32],
    output: &mut [u32],
    pairs: &mut [u32],
) {
    let dispatch = &trees.params.dispatch;
    let level = dispatch.first as usize;
    let internal = trees.internal();
    let len = at(levels, level).min(dispatch.capacity_in);
    // As many rounds as the capacity would take: no other bound is certainly uniform.
    for round in 0..dispatch.capacity_in.div_ceil(t.groups * THREADS) {
        let i = (t.group + round * t.groups) * THREADS + t.lane;
        if t.lane == 0 {
            set(counters, NODES, 0);
            set(counters, LEAVES, 0);
        }
        barrier();
        let (mut p, mut q) = ([NONE; 2], [NONE; 2]);
        let (mut r, mut s) = ([NONE; 2], [NONE; 2]);
        if i < len {
            let Pair { a, b } = read_pair(input, i);
            let children = expand(trees.rule(), trees.within(), trees.a, trees.b, [a, b]).met;
            let children = V::only_meeting(trees, children);
            p = children[0];
            q = children[1];
            r = children[2];
            s = children[3];
            // A pair of the cut may be one of leaves already.
            if fate([a, b], internal) == LEAF {
                p = [a, b];
            }
        }
        let (to_p, to_q) = (claim(p, internal, counters), claim(q, internal, counters));
        let (to_r, to_s) = (claim(r, internal, counters), claim(s, internal, counters));
        barrier();
        if t.lane == 0 {
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
        keep(trees, p, internal, bases, to_p, output, pairs);
        keep(trees, q, internal, bases, to_q, output, pairs);
        keep(trees, r, internal, bases, to_r, output, pairs);
        keep(trees, s, internal, bases, to_s, output, pairs);
    }
}

/// Counts a pair in its workgroup; returns its number there.
#[inline(always)]
fn claim(pair: NodePair, internal: [u32; 2], counters: &mut [u32; 4]) -> u32 {
    let fate = fate(pair, internal);
    let mut to = 0;
    if fate != 0 {
        to = add_shared(counters, if fate == INNER { NODES } else { LEAVES }, 1);
    }
    to
}

/// Writes a pair to the next level, or one of leaves to the results.
#[inline(always)]
fn keep<V: Volume>(
    trees: BinaryTrees<V>,
    pair: NodePair,
    internal: [u32; 2],
    bases: [u32; 2],
    to: u32,
    output: &mut [u32],
    pairs: &mut [u32],
) {
    let fate = fate(pair, internal);
    let Params { dispatch, args, .. } = trees.params;
    if fate == INNER {
        let pair = Pair { a: pair[0], b: pair[1] };
        write_pair(output, args.capacity_nodes, bases[0] + to, pair);
    } else if fate == LEAF {
        write_pair(pairs, dispatch.capacity_out, bases[1] + to, trees.ids(pair));
    }
}
