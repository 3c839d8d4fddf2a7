//! Simultaneous traversal with a stack a thread [Karras 2012b]: each pair of two cuts is descended
//! by one thread, which keeps the pairs of nodes that wait.
//!
//! ```text
//!   pairs of two cuts       thread 0: apart, done at once
//!   0  1  2  3  ..          thread 1: pop, expand, push, pop, .. pairs of leaves are found
//!   |  |  |  |              thread 2: stack full: a pair goes to the list of the next round
//! ```
//!
//! **Height.** A pair that is taken from the stack is replaced by at most four, and the last of
//! those is taken next: while pairs `d` levels below the first one are expanded, at most three wait
//! of each level, so `3 d + 3` at most when the last child is pushed. A pair that finds `n` on the
//! stack is thus at least `n / 3` levels below the first ([`rounds`] follows). Trees from Morton
//! codes of 30 bits and 31 bits of ties have 62 levels, of which a stack of [`CAPACITY`] takes 21:
//! in three rounds nothing is left, whatever the boxes are. With leaf counts at hand the smallest
//! could go first, and 93 places would do for any tree; a list that is never used costs less.
//!
//! Cost: the visits of [`super::pair_descent`], without a word of memory between them but the
//! thread's stack. Threads have nothing in common: most pairs of a cut are apart, and a node with
//! itself has the most below it, so that of 32 threads side by side few are busy.

use super::pair_descent::{NO_PAIR, NodePair};
use crate::kernel::stack::Stack;

/// Pairs of nodes that fit on a stack.
pub const CAPACITY: usize = 64;

/// Pairs of nodes that wait.
#[derive(Clone, Copy, Debug)]
pub struct PairStack {
    first: Stack<CAPACITY>,
    second: Stack<CAPACITY>,
}

impl PairStack {
    /// Without a pair.
    #[inline(always)]
    pub fn new() -> Self {
        Self { first: Stack::new(), second: Stack::new() }
    }

    /// Puts a pair on top. Returns whether there was a place, of `most`, [`CAPACITY`] at most.
    #[inline(always)]
    pub fn push(&mut self, pair: NodePair, most: u32) -> bool {
        let has_place = self.first.height() < most.min(CAPACITY as u32);
        if has_place {
            self.first.push(pair[0]);
            self.second.push(pair[1]);
        }
        has_place
    }

    /// Takes the pair on top; [`NO_PAIR`] if there is none.
    #[inline(always)]
    pub fn pop(&mut self) -> NodePair {
        if self.first.height() > 0 { [self.first.pop(), self.second.pop()] } else { NO_PAIR }
    }
}

impl Default for PairStack {
    fn default() -> Self {
        Self::new()
    }
}

/// Rounds after which no pair is left, with stacks of `most` places and `n_levels` levels of pairs
/// of nodes.
pub fn rounds(n_levels: u32, most: u32) -> u32 {
    n_levels.div_ceil((most / 3).max(1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::broad_phase::pair_descent::expand;
    use crate::broad_phase::test_trees::{Tree, boxes, splits};
    use crate::model::method::Descent;
    use std::vec::Vec;

    /// Pairs of leaves below the roots, each by the number of the round in which it was found; and
    /// the number of rounds.
    fn descend(a: &Tree, b: &Tree, within: bool, rule: Descent, most: u32) -> (Vec<NodePair>, u32) {
        let [n, m] = [a, b].map(|tree| tree.branches.len() as u32);
        let (mut found, mut waiting, mut n_rounds) = (Vec::new(), Vec::from([[0, 0]]), 0);
        while !waiting.is_empty() {
            n_rounds += 1;
            let mut next = Vec::new();
            for first in waiting {
                let mut stack = PairStack::new();
                assert!(stack.push(first, 1), "an empty stack has a place");
                loop {
                    let pair = stack.pop();
                    if pair == NO_PAIR {
                        break;
                    }
                    let children = expand(rule, within, &a.nodes, &b.nodes, pair).met;
                    for child in children.into_iter().filter(|&child| child != NO_PAIR) {
                        if child[0] >= n && child[1] >= m {
                            found.push([child[0] - n, child[1] - m]);
                        } else if !stack.push(child, most) {
                            next.push(child);
                        }
                    }
                }
            }
            waiting = next;
        }
        (found, n_rounds)
    }

    /// Levels of internal nodes.
    fn height(tree: &Tree) -> u32 {
        let (mut level, mut height) = (Vec::from([0u32]), 0);
        while !level.is_empty() {
            let branches = level.iter().map(|&node| &tree.branches[node as usize]);
            let children = branches.flat_map(|branch| [branch.left, branch.right]);
            level = children.filter(|&child| (child as usize) < tree.branches.len()).collect();
            height += 1;
        }
        height
    }

    #[test]
    fn no_pair_is_lost_where_stacks_are_full() {
        let (all, others) = (boxes(150, 3), boxes(90, 8));
        let mut most_rounds = 0;
        for (name, split) in splits() {
            let (a, b) = (Tree::new(&all, &split), Tree::new(&others, &split));
            for rule in [Descent::Larger, Descent::Both] {
                for (other, within) in [(&a, true), (&b, false)] {
                    let unbounded = descend(&a, other, within, rule, CAPACITY as u32).0.len();
                    for most in [1, 2, 3, 7, CAPACITY as u32] {
                        let (mut found, n_rounds) = descend(&a, other, within, rule, most);
                        let sum = height(&a) + height(other);
                        assert!(n_rounds <= rounds(sum + 1, most), "{name}: {n_rounds} by {most}");
                        most_rounds = most_rounds.max(n_rounds);
                        assert_eq!(found.len(), unbounded, "{name}, {most} places");
                        found.sort_unstable();
                        let boxes = |[i, j]: [u32; 2]| {
                            let place = |tree: &Tree, leaf: u32| {
                                tree.nodes[tree.branches.len() + leaf as usize].aabb()
                            };
                            (place(&a, i), place(other, j))
                        };
                        assert!(found.windows(2).all(|w| w[0] != w[1]), "{name}: twice");
                        let overlap = |&pair: &[u32; 2]| {
                            let (x, y) = boxes(pair);
                            x.overlaps(&y)
                        };
                        assert!(found.iter().all(overlap));
                        let right = if within {
                            (0..150)
                                .flat_map(|i| (i + 1..150).map(move |j| [i, j]))
                                .filter(overlap)
                                .count()
                        } else {
                            (0..150)
                                .flat_map(|i| (0..90).map(move |j| [i, j]))
                                .filter(overlap)
                                .count()
                        };
                        assert_eq!(found.len(), right, "{name}, {most} places");
                    }
                }
            }
        }
        assert!(most_rounds > 20, "{most_rounds} rounds at most: stacks were hardly full");
    }

    #[test]
    fn trees_of_codes_need_few_rounds() {
        // 30 bits of code, 31 of ties, and the pair of leaves; twice as many if one is split.
        assert_eq!([62, 123].map(|levels| rounds(levels, CAPACITY as u32)), [3, 6]);
        assert_eq!([1, 64, 65].map(|levels| rounds(levels, 0)), [1, 64, 65]);
    }
}
