//! Traversal of a binary tree with a stack, a thread each query; see
//! `ccd_core::backend::broad_phase::stack_traversal`. Workgroups are small, because a thread that
//! is done waits for the others.

use super::volume::{Boxes, Oriented, Volume};
use crate::entry::kernel;
use crate::records::{BoxWords, NodeWords, ObbWords, box_at, node_at};
use crate::workgroup::append;
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::block_bvh::{self, sets};
use ccd_core::backend::broad_phase::recursive::Calls;
use ccd_core::backend::broad_phase::stack_traversal::NONE;
use ccd_core::backend::broad_phase::wide_nodes::{LeafDescent, WideWalk};
use ccd_core::backend::kernel::memory::at;
use ccd_core::backend::layout::{Blocks, Pair, Params, Queries, VERTEX_FACE};

/// The set within which pairs are looked for.
const SET: usize = 1;

kernel! {
    /// Thread `i` finds the leaves after leaf `dispatch.first + i` that overlap it.
    traverse_half[128](t; params: Blocks;; leaves: [BoxWords], order: [u32], nodes: [NodeWords],
        mut pairs: [u32]) {
        walk_half(Boxes, t.i, params, leaves, order, nodes, pairs);
    }
}

kernel! {
    /// As `traverse_half`, and leaves out what an oriented box tells apart.
    traverse_half_oriented[128](t; params: Blocks;; leaves: [BoxWords], order: [u32],
        nodes: [NodeWords], oriented: [ObbWords], mut pairs: [u32]) {
        walk_half(Oriented(oriented), t.i, params, leaves, order, nodes, pairs);
    }
}

kernel! {
    /// Thread `i` finds the leaves that overlap query `dispatch.first + i`; of the first set, which
    /// may be that of the leaves: then it keeps those of a greater id than its own.
    traverse_full[128](t; params: Queries;; boxes: [BoxWords], order: [u32], nodes: [NodeWords],
        mut pairs: [u32]) {
        walk_full(Boxes, t.i, params, boxes, order, nodes, pairs);
    }
}

kernel! {
    /// As `traverse_full`, and leaves out what an oriented box tells apart.
    traverse_full_oriented[128](t; params: Queries;; boxes: [BoxWords], order: [u32],
        nodes: [NodeWords], oriented: [ObbWords], mut pairs: [u32]) {
        walk_full(Oriented(oriented), t.i, params, boxes, order, nodes, pairs);
    }
}

kernel! {
    /// As `traverse_full`, a call of a recursion a step.
    traverse_recursive[128](t; params: Queries;; boxes: [BoxWords], order: [u32],
        nodes: [NodeWords], mut pairs: [u32]) {
        call(Boxes, t.i, params, boxes, order, nodes, pairs);
    }
}

kernel! {
    /// As `traverse_recursive`, and leaves out what an oriented box tells apart.
    traverse_recursive_oriented[128](t; params: Queries;; boxes: [BoxWords], order: [u32],
        nodes: [NodeWords], oriented: [ObbWords], mut pairs: [u32]) {
        call(Oriented(oriented), t.i, params, boxes, order, nodes, pairs);
    }
}

#[inline(always)]
fn walk_half<V: Volume>(
    volume: V,
    i: u32,
    params: &Params<Blocks>,
    leaves: &[BoxWords],
    order: &[u32],
    nodes: &[NodeWords],
    pairs: &mut [u32],
) {
    if i < params.dispatch.n {
        let leaf_idx = params.dispatch.first + i;
        let query = box_at(leaves, block_bvh::slot(&params.args, 0, SET, leaf_idx));
        let (first, n_leaves) = (params.frame.start[SET], params.frame.count[SET]);
        let a = at(order, (first + leaf_idx) as usize) - first;
        let (mut descent, mut walk) = (LeafDescent::to(leaf_idx), WideWalk::new());
        for _ in 0..n_leaves - 1 {
            if descent.is_done {
                break;
            }
            for _ in 0..n_leaves - 1 {
                if !descent.goes_on(&walk) {
                    break;
                }
                let node = node_at(nodes, descent.node as usize);
                let found = descent.step(&node, &query, &mut walk);
                keep_ordered(params, a, order, found, pairs);
            }
            walk.take();
            for _ in 0..n_leaves - 1 {
                if !walk.goes_on {
                    break;
                }
                if volume.reaches(&query, first + walk.node) {
                    let node = node_at(nodes, walk.node as usize);
                    let found = walk.step(&node, &query);
                    keep_ordered(params, a, order, found[0], pairs);
                    keep_ordered(params, a, order, found[1], pairs);
                } else {
                    walk.take();
                }
            }
        }
    }
}

/// Appends the pair with a leaf that was found.
#[inline(always)]
fn keep_ordered(params: &Params<Blocks>, a: u32, order: &[u32], found: u32, pairs: &mut [u32]) {
    if found != NONE {
        let first = params.frame.start[SET];
        let b = at(order, (first + found) as usize) - first;
        append(pairs, params.dispatch.capacity_out, Pair::ordered(a, b));
    }
}

#[inline(always)]
fn walk_full<V: Volume>(
    volume: V,
    i: u32,
    params: &Params<Queries>,
    boxes: &[BoxWords],
    order: &[u32],
    nodes: &[NodeWords],
    pairs: &mut [u32],
) {
    if i < params.dispatch.n {
        let (a, query) = query_of(params, i, boxes, order);
        let tree = sets(params.args.kind)[1];
        let (first, n_internal) = (params.frame.start[tree], params.frame.count[tree] - 1);
        if n_internal == 0 {
            ask_only_leaf(params, (a, &query), boxes, order, pairs);
        }
        let mut walk = WideWalk::new();
        for _ in 0..n_internal {
            if !walk.goes_on {
                break;
            }
            if volume.reaches(&query, first + walk.node) {
                let node = node_at(nodes, walk.node as usize);
                let found = walk.step(&node, &query);
                keep(params, a, order, found[0], pairs);
                keep(params, a, order, found[1], pairs);
            } else {
                walk.take();
            }
        }
    }
}

#[inline(always)]
fn call<V: Volume>(
    volume: V,
    i: u32,
    params: &Params<Queries>,
    boxes: &[BoxWords],
    order: &[u32],
    nodes: &[NodeWords],
    pairs: &mut [u32],
) {
    if i < params.dispatch.n {
        let (a, query) = query_of(params, i, boxes, order);
        let tree = sets(params.args.kind)[1];
        let (first, n_internal) = (params.frame.start[tree], params.frame.count[tree] - 1);
        if n_internal == 0 {
            ask_only_leaf(params, (a, &query), boxes, order, pairs);
        }
        let mut calls = Calls::new();
        for _ in 0..2 * n_internal {
            if !calls.goes_on {
                break;
            }
            if !calls.enters() || volume.reaches(&query, first + calls.node) {
                let node = node_at(nodes, calls.node as usize);
                let found = calls.step(&node, &query);
                keep(params, a, order, found, pairs);
            } else {
                calls.leave();
            }
        }
    }
}

/// The number in its set, and the box, of the query of thread `i`.
#[inline(always)]
fn query_of(params: &Params<Queries>, i: u32, boxes: &[BoxWords], order: &[u32]) -> (u32, Aabb) {
    let first = params.frame.start[sets(params.args.kind)[0]];
    let mut a = first + params.dispatch.first + i;
    if params.args.sorted != 0 {
        a = at(order, a as usize);
    }
    (a - first, box_at(boxes, a as usize))
}

/// Asks the leaf of a tree that has no internal node.
#[inline(always)]
fn ask_only_leaf(
    params: &Params<Queries>,
    (a, query): (u32, &Aabb),
    boxes: &[BoxWords],
    order: &[u32],
    pairs: &mut [u32],
) {
    let first = params.frame.start[sets(params.args.kind)[1]];
    if box_at(boxes, at(order, first as usize) as usize).overlaps(query) {
        keep(params, a, order, 0, pairs);
    }
}

/// Appends the pair with a leaf that was found, once.
#[inline(always)]
fn keep(params: &Params<Queries>, a: u32, order: &[u32], found: u32, pairs: &mut [u32]) {
    if found != NONE {
        let first = params.frame.start[sets(params.args.kind)[1]];
        let b = at(order, (first + found) as usize) - first;
        if params.args.kind == VERTEX_FACE || b > a {
            append(pairs, params.dispatch.capacity_out, Pair { a, b });
        }
    }
}
