//! Pairs of nodes of binary trees: a thread expands one into at most four.

use super::pair_tree::{APART, LEAF, PairTree};
use super::shared::{Round, Shared, Stack};
use super::worker::{Child, claim, put_away};
use crate::broad_phase::pair_descent::fate;
use crate::broad_phase::volume::{Volume, internal};
use ccd_core::backend::broad_phase::pair_descent::{NodePair, expand};
use ccd_core::backend::broad_phase::pair_workers::THREADS;
use ccd_core::backend::broad_phase::stack_traversal::NONE;
use ccd_core::backend::kernel::memory::at;
use ccd_core::backend::layout::EDGE_EDGE;
use ccd_core::backend::layout::{Node, NodeDescent, Pair, Params};
use ccd_core::model::method::Descent;
use core::marker::PhantomData;

/// Binary trees of a volume.
pub(super) struct BinaryTrees<V>(PhantomData<V>);

/// Something of each of four children.
#[derive(Clone, Copy)]
pub(super) struct Four<T> {
    p: T,
    q: T,
    r: T,
    s: T,
}

impl<V: Volume> PairTree for BinaryTrees<V> {
    type Args = NodeDescent;
    type Node = Node;
    type More = V::More<Node>;
    type Found = Four<Child>;
    type Places = Four<[u32; 2]>;

    const WIDTH: u32 = THREADS;

    #[inline(always)]
    fn descent(args: &NodeDescent) -> NodeDescent {
        *args
    }

    #[inline(always)]
    fn index(lane: u32) -> u32 {
        lane
    }

    #[inline(always)]
    fn begin(_: &mut Shared) {}

    #[inline(always)]
    fn expand(
        params: &Params<NodeDescent>,
        _: u32,
        pair: NodePair,
        a: &[Node],
        b: &[Node],
        more: &[V::More<Node>],
        _: &mut Shared,
    ) -> Four<Child> {
        let (within, internal) = (params.args.kind == EDGE_EDGE, internal(params));
        let rule = if params.args.larger != 0 { Descent::Larger } else { Descent::Both };
        let (mut p, mut q) = (Child::NONE, Child::NONE);
        let (mut r, mut s) = (Child::NONE, Child::NONE);
        if pair[0] != NONE {
            let children = expand(rule, within, a, b, pair);
            let met = V::only_meeting(params, children.met, a, b, more);
            let mut all = met;
            if params.args.capacity_front > 0 {
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
    fn claim(found: Four<Child>, capacity_front: u32, shared: &mut Shared) -> Four<[u32; 2]> {
        Four {
            p: claim(found.p.fate, capacity_front, shared),
            q: claim(found.q.fate, capacity_front, shared),
            r: claim(found.r.fate, capacity_front, shared),
            s: claim(found.s.fate, capacity_front, shared),
        }
    }

    #[inline(always)]
    fn put_away(
        args: &NodeDescent,
        round: Round,
        found: Four<Child>,
        to: Four<[u32; 2]>,
        a: &[Node],
        b: &[Node],
        shared: &Shared,
        stack: &mut Stack,
        nodes: &mut [u32],
        pairs: &mut [u32],
        front: &mut [u32],
    ) {
        let Four { p, q, r, s } = found;
        put_away::<Self>(args, round, p, to.p, a, b, shared, stack, nodes, pairs, front);
        put_away::<Self>(args, round, q, to.q, a, b, shared, stack, nodes, pairs, front);
        put_away::<Self>(args, round, r, to.r, a, b, shared, stack, nodes, pairs, front);
        put_away::<Self>(args, round, s, to.s, a, b, shared, stack, nodes, pairs, front);
    }

    #[inline(always)]
    fn fate(
        params: &Params<NodeDescent>,
        pair: NodePair,
        a: &[Node],
        b: &[Node],
        more: &[V::More<Node>],
    ) -> u32 {
        let (x, y) = (at(a, pair[0] as usize), at(b, pair[1] as usize));
        let mut out = APART;
        if x.aabb().overlaps(&y.aabb()) && V::meets(params, pair, a, b, more) {
            out = fate(pair, internal(params));
        }
        out
    }

    #[inline(always)]
    fn result(args: &NodeDescent, pair: NodePair, a: &[Node], b: &[Node]) -> Pair {
        let (a, b) = (at(a, pair[0] as usize).left, at(b, pair[1] as usize).left);
        if args.kind == EDGE_EDGE { Pair::ordered(a, b) } else { Pair { a, b } }
    }
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
