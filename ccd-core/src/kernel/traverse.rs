//! Emit: overlapping pairs by independent traversal with an explicit stack (Thinking Parallel 2).
//!
//! Within one set, queries go in leaf order and each looks only at leaves after its own, so that every pair is found once.

use super::{Sink, build::MAX_DEPTH};
use crate::aabb::Aabb;
use crate::layout::{Branch, Node, Pair};

/// All leaves of the tree that overlap `query`, as their ids.
///
/// `skip_until`: leaves up to and including this number are left out (`None`: none are). The loop visits every node at most once; the
/// stack holds at most one node per level, see [`MAX_DEPTH`].
#[inline]
fn visit(query: &Aabb<f32>, nodes: &[Node], branches: &[Branch], skip_until: Option<u32>, mut found: impl FnMut(u32)) {
    let n_internal = branches.len() as u32;
    let mut stack = [0u32; MAX_DEPTH];
    let mut height = 0usize;
    let mut node = 0u32;
    for _ in 0..nodes.len() {
        let branch = &branches[node as usize];
        let mut next = [Node::LEAF; 2];
        let mut n_next = 0;
        for child in [branch.right, branch.left] {
            let last = if child >= n_internal { child - n_internal } else { branches[child as usize].last };
            let late_enough = match skip_until {
                Some(leaf) => last > leaf,
                None => true,
            };
            let c = &nodes[child as usize];
            if late_enough && c.aabb().overlaps(query) {
                if c.is_leaf() {
                    found(c.left);
                } else {
                    next[n_next] = child;
                    n_next += 1;
                }
            }
        }
        if n_next == 0 {
            if height == 0 {
                return;
            }
            height -= 1;
            node = stack[height];
        } else {
            // The left child, last in `next` if both are to be visited, comes first.
            node = next[n_next - 1];
            if n_next == 2 {
                stack[height] = next[0];
                height += 1;
            }
        }
    }
}

/// Pairs of leaf `i` with later leaves, lesser id first; `nodes` as in [`Node`], at least two leaves.
pub fn half(i: usize, nodes: &[Node], branches: &[Branch], sink: &mut impl Sink<Pair>) {
    let leaf = &nodes[branches.len() + i];
    let id = leaf.left;
    visit(&leaf.aabb(), nodes, branches, Some(i as u32), |other| sink.push(Pair::ordered(id, other)));
}

/// Pairs of one loose box with all leaves of a tree: `a` is `id`, `b` the leaf's id (Tian and Wan, section 1.2). At least two leaves.
pub fn against(id: u32, query: &Aabb<f32>, nodes: &[Node], branches: &[Branch], sink: &mut impl Sink<Pair>) {
    visit(query, nodes, branches, None, |other| sink.push(Pair { a: id, b: other }));
}
