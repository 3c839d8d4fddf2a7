//! Pairs of nodes of binary trees: a thread expands one into at most four.

use super::shared::{Shared, Stack};
use super::worker::{Child, PairTree, Worker};
use crate::broad_phase::volume::{APART, BinaryTrees, INNER, LEAF, Volume, fate};
use ccd_core::backend::broad_phase::pair_descent::{NodePair, expand};
use ccd_core::backend::broad_phase::pair_workers::THREADS;
use ccd_core::backend::broad_phase::stack_traversal::NONE;
use ccd_core::backend::layout::{Dispatch, NodeDescent, Pair};

/// A value for each of four children.
#[derive(Clone, Copy)]
pub(super) struct Four<T> {
    p: T,
    q: T,
    r: T,
    s: T,
}

impl<V: Volume> PairTree for BinaryTrees<'_, V> {
    type Found = Four<Child>;
    type Places = Four<[u32; 2]>;

    const WIDTH: u32 = THREADS;

    #[inline(always)]
    fn descent(self) -> NodeDescent {
        self.params.args
    }

    #[inline(always)]
    fn dispatch(self) -> Dispatch {
        self.params.dispatch
    }

    #[inline(always)]
    fn index(lane: u32) -> u32 {
        lane
    }

    #[inline(always)]
    fn begin(_: &mut Shared) {}

    #[inline(always)]
    fn expand(self, _: u32, pair: NodePair, _: &mut Shared) -> Four<Child> {
        let (within, internal) = (self.within(), self.internal());
        let rule = self.rule();
        let (mut p, mut q) = (Child::NONE, Child::NONE);
        let (mut r, mut s) = (Child::NONE, Child::NONE);
        if pair[0] != NONE {
            let children = expand(rule, within, self.a, self.b, pair);
            let met = V::only_meeting(self, children.met);
            let mut all = met;
            if self.params.args.capacity_front > 0 {
                all = children.all;
            }
            p = child(met[0], all[0], internal);
            q = child(met[1], all[1], internal);
            r = child(met[2], all[2], internal);
            s = child(met[3], all[3], internal);
            // A pair of the cut may be one of leaves already.
            if fate(pair, internal) == LEAF {
                p = Child { pair, fate: LEAF };
            }
        }
        Four { p, q, r, s }
    }

    #[inline(always)]
    fn counts(found: Four<Child>, capacity_front: u32) -> [u32; 3] {
        let mut next = [0, 0, 0];
        take_place(found.p, &mut next);
        take_place(found.q, &mut next);
        take_place(found.r, &mut next);
        take_place(found.s, &mut next);
        let ended = if capacity_front > 0 { next[2] } else { 0 };
        [next[0], next[1], ended]
    }

    #[inline(always)]
    fn places(found: Four<Child>, first: [u32; 3]) -> Four<[u32; 2]> {
        let mut next = first;
        let p = take_place(found.p, &mut next);
        let q = take_place(found.q, &mut next);
        let r = take_place(found.r, &mut next);
        let s = take_place(found.s, &mut next);
        Four { p, q, r, s }
    }

    #[inline(always)]
    fn put_away(
        worker: &mut Worker<Self>,
        found: Four<Child>,
        to: Four<[u32; 2]>,
        stack: &mut Stack,
    ) {
        worker.put_away(found.p, to.p, stack);
        worker.put_away(found.q, to.q, stack);
        worker.put_away(found.r, to.r, stack);
        worker.put_away(found.s, to.s, stack);
    }

    #[inline(always)]
    fn fate(self, pair: NodePair) -> u32 {
        let (x, y) = self.nodes(pair);
        let mut out = APART;
        if x.aabb().overlaps(&y.aabb()) && V::meets(self, pair) {
            out = fate(pair, self.internal());
        }
        out
    }

    #[inline(always)]
    fn result(self, pair: NodePair) -> Pair {
        self.ids(pair)
    }
}

/// The place of a child among those of its fate, and in the front; the next places are behind.
#[inline(always)]
fn take_place(child: Child, next: &mut [u32; 3]) -> [u32; 2] {
    let to = [if child.fate == INNER { next[0] } else { next[1] }, next[2]];
    next[0] += (child.fate == INNER) as u32;
    next[1] += (child.fate == LEAF) as u32;
    next[2] += (child.fate >= LEAF) as u32;
    to
}

/// The child if it meets, or else, where one is kept for the front, the child that is apart.
#[inline(always)]
fn child(met: NodePair, child: NodePair, internal: [u32; 2]) -> Child {
    let mut out = Child { pair: met, fate: fate(met, internal) };
    if out.fate == 0 && child[0] != NONE {
        out = Child { pair: child, fate: APART };
    }
    out
}
