//! Simultaneous traversal with a stack a thread, from all pairs of two cuts; see
//! `ccd_core::backend::broad_phase::pair_stacks`.

use super::pair_descent::{is_leaf_with_itself, meets, of_cuts, reserve};
use super::volume::{BinaryTrees, Boxes, INNER, LEAF, Oriented, Volume, fate};
use crate::entry::kernel;
use crate::records::ObbWords;
use crate::workgroup::{append, read_pair, write_pair};
use ccd_core::backend::broad_phase::pair_descent::{NodePair, expand};
use ccd_core::backend::broad_phase::pair_stacks::{CAPACITY, PairStack};
use ccd_core::backend::broad_phase::stack_traversal::NONE;
use ccd_core::backend::kernel::memory::at;
use ccd_core::backend::layout::{Node, Pair, Params};

kernel! {
    /// In round 0 (`dispatch.first`) `input` are cuts, and thread `i * args.nodes + j` descends
    /// from the pair of node `i` of the first and node `j` of the second, within one tree if
    /// `i <= j`. In later rounds it is the list of the round before, and thread `i` descends from
    /// its `i`-th pair. After `args.turns` pairs, or where `args.stack` of them wait, the others
    /// are left to the next round.
    descend_stacks[128](t; params: NodeDescent;; a_nodes: [Node], b_nodes: [Node], input: [u32],
        mut rounds: [u32], mut output: [u32], mut pairs: [u32]) {
        let trees = BinaryTrees { params, a: a_nodes, b: b_nodes, volume: Boxes };
        descend(trees, t.i, input, rounds, output, pairs);
    }
}

kernel! {
    /// As `descend_stacks`, of trees of oriented boxes.
    descend_stacks_oriented[128](t; params: NodeDescent;; a_nodes: [Node], b_nodes: [Node],
        oriented: [ObbWords], input: [u32], mut rounds: [u32], mut output: [u32],
        mut pairs: [u32]) {
        let trees = BinaryTrees { params, a: a_nodes, b: b_nodes, volume: Oriented(oriented) };
        descend(trees, t.i, input, rounds, output, pairs);
    }
}

#[inline(always)]
fn descend<V: Volume>(
    trees: BinaryTrees<V>,
    i: u32,
    input: &[u32],
    rounds: &mut [u32],
    output: &mut [u32],
    pairs: &mut [u32],
) {
    let Params { dispatch, args, .. } = trees.params;
    let mut first = [NONE; 2];
    if dispatch.first > 0 {
        if i < at(rounds, dispatch.first as usize).min(dispatch.capacity_in) {
            let Pair { a, b } = read_pair(input, i);
            first = [a, b];
        }
    } else if i < args.nodes * args.nodes {
        let pair = of_cuts(args, i, input);
        if pair[0] != NONE && !is_leaf_with_itself(trees, pair) && meets(trees, pair) {
            first = pair;
        }
    }
    let mut stack = PairStack::new();
    keep(trees, first, &mut stack, rounds, output, pairs);
    for _ in 0..args.turns {
        let pair = stack.pop();
        if pair[0] == NONE {
            break;
        }
        let children = expand(trees.rule(), trees.within(), trees.a, trees.b, pair).met;
        let children = V::only_meeting(trees, children);
        keep(trees, children[0], &mut stack, rounds, output, pairs);
        keep(trees, children[1], &mut stack, rounds, output, pairs);
        keep(trees, children[2], &mut stack, rounds, output, pairs);
        keep(trees, children[3], &mut stack, rounds, output, pairs);
    }
    for _ in 0..CAPACITY {
        let pair = stack.pop();
        if pair[0] == NONE {
            break;
        }
        leave(trees, pair, rounds, output);
    }
}

/// Lists a pair of leaves; puts another on the stack, or leaves it to the next round.
#[inline(always)]
fn keep<V: Volume>(
    trees: BinaryTrees<V>,
    pair: NodePair,
    stack: &mut PairStack,
    rounds: &mut [u32],
    output: &mut [u32],
    pairs: &mut [u32],
) {
    let fate = fate(pair, trees.internal());
    if fate == LEAF {
        append(pairs, trees.params.dispatch.capacity_out, trees.ids(pair));
    } else if fate == INNER && !stack.push(pair, trees.params.args.stack) {
        leave(trees, pair, rounds, output);
    }
}

/// Leaves a pair to the next round; one beyond the capacity of its list is only counted.
#[inline(always)]
fn leave<V: Volume>(trees: BinaryTrees<V>, pair: NodePair, rounds: &mut [u32], output: &mut [u32]) {
    let Params { dispatch, args, .. } = trees.params;
    let to = reserve(rounds, dispatch.first as usize + 1, output, 1);
    write_pair(output, args.capacity_nodes, to, Pair { a: pair[0], b: pair[1] });
}
