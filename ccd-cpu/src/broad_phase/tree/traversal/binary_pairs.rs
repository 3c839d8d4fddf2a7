//! Two binary trees, or one with itself, as a tree of pairs.

use super::Trees;
use crate::broad_phase::descend::{FrontTree, Place};
use crate::broad_phase::front::Writer;
use crate::broad_phase::pair_source::{Overlaps, PairSink};
use crate::broad_phase::pair_tree::PairTree;
use crate::broad_phase::rows::{Gathered, IntoRows, Scratch};
use crate::broad_phase::tasks::DepthFirst;
use crate::broad_phase::tree::binary_tree::BinaryTree;
use crate::simd::{RowSimd, WIDTH};
use ccd_core::backend::broad_phase::pair_descent::{NO_PAIR, NodePair, expand};
use ccd_core::model::method::Descent;

/// The trees that are descended, the same if pairs are sought `within` one.
#[derive(Clone, Copy)]
pub struct BinaryPairs<'a> {
    a: &'a BinaryTree,
    b: &'a BinaryTree,
    within: bool,
    descent: Descent,
}

impl<'a> BinaryPairs<'a> {
    /// The trees of both sides, neither empty.
    pub fn new(trees: Trees<'a>, within: bool, descent: Descent) -> Self {
        Self { a: trees.a.unwrap_or(trees.b), b: trees.b, within, descent }
    }

    /// Whether there may be pairs of leaves below this pair: its volumes overlap; of a leaf with
    /// itself there is none.
    pub fn is_wanted(&self, [i, j]: NodePair) -> bool {
        if self.within && i == j {
            (i as usize) < self.a.branches.len()
        } else {
            let (a, b) = (&self.a.nodes()[i as usize], &self.b.nodes()[j as usize]);
            a.aabb().overlaps(&b.aabb()) && self.a.reach(i, self.b, j)
        }
    }

    /// Whether a child whose boxes overlap is wanted; a node with itself always is.
    #[inline(always)]
    fn reach(&self, [i, j]: NodePair) -> bool {
        self.within && i == j || self.a.reach(i, self.b, j)
    }

    /// Adds all pairs of leaves below a wanted pair.
    pub fn descend(self, from: NodePair, scratch: &mut Scratch, rows: &mut Gathered) {
        let Scratch { pairs: stack, visits, .. } = scratch;
        stack.clear();
        // As in a scheduler: so that which tasks a thread gets decides nothing about allocations.
        stack.reserve(1024);
        stack.push(from);
        let (tree, sink, worker) = (self, &IntoRows::<false>::default(), rows);
        *visits += crate::simd::run_rows!(DepthFirst { tree, stack, sink, worker });
    }
}

impl PairTree for BinaryPairs<'_> {
    #[inline(always)]
    fn is_leaf(self, [i, j]: NodePair) -> bool {
        i as usize >= self.a.branches.len() && j as usize >= self.b.branches.len()
    }

    #[inline(always)]
    fn expand<S: RowSimd>(self, _simd: S, pair: NodePair, out: &mut Vec<NodePair>) {
        let (a, b) = (self.a.nodes(), self.b.nodes());
        let met = expand(self.descent, self.within, a, b, pair).met;
        out.extend(met.into_iter().filter(|&child| child != NO_PAIR && self.reach(child)));
    }

    #[inline(always)]
    fn rows<S: RowSimd, K: PairSink>(
        self,
        simd: S,
        [i, j]: NodePair,
        sink: &K,
        worker: &mut K::Worker,
    ) {
        let (i, j) = (i as usize - self.a.branches.len(), j as usize - self.b.branches.len());
        let mask = 1 << (j % WIDTH);
        sink.row(worker, simd, Overlaps { a: i / WIDTH, lane: i % WIDTH, b: j / WIDTH, mask });
    }
}

/// A front reaches down to pairs of leaves.
impl FrontTree for BinaryPairs<'_> {
    const WHOLE_ROWS: bool = false;

    #[inline(always)]
    fn place(self, pair: NodePair) -> Place {
        if self.is_leaf(pair) { Place::At } else { Place::Above }
    }

    #[inline(always)]
    fn meets(self, pair: NodePair) -> bool {
        self.is_wanted(pair)
    }

    #[inline(always)]
    fn expand_all<S: RowSimd>(
        self,
        _simd: S,
        pair: NodePair,
        out: &mut Vec<NodePair>,
        front: &mut Writer,
    ) {
        let (a, b) = (self.a.nodes(), self.b.nodes());
        let children = expand(self.descent, self.within, a, b, pair);
        for (child, met) in children.all.into_iter().zip(children.met) {
            if met != NO_PAIR && self.reach(met) {
                out.push(met);
            } else if child != NO_PAIR {
                front.push(child);
            }
        }
    }
}
