//! Trees of any shape over given boxes, for tests of traversals.

use crate::layout::{Branch, Node};
use crate::math::aabb::Aabb;
use crate::random::{Random, pcg};
use std::boxed::Box;
use std::vec::Vec;

/// A tree in the numbering of Karras: of `n` leaves the nodes `0 .. n - 1` are internal, an
/// internal left child has the number of its last leaf, a right one that of its first.
#[derive(Debug)]
pub struct Tree {
    pub branches: Vec<Branch>,
    pub nodes: Vec<Node>,
}

impl Tree {
    /// Over these boxes; `split(first, last)` is the last leaf of the left child of the node over
    /// that range.
    pub fn new(boxes: &[Aabb], split: impl Fn(u32, u32) -> u32) -> Self {
        let n_internal = boxes.len() - 1;
        let none = Branch { left: 0, right: 0, first: 0, last: 0 };
        let mut branches = Vec::from_iter((0..n_internal).map(|_| none));
        let empty = Node { min: [0.0; 3], left: 0, max: [0.0; 3], right: 0 };
        let mut nodes = Vec::from_iter((0..n_internal + boxes.len()).map(|_| empty));
        for (i, b) in boxes.iter().enumerate() {
            nodes[n_internal + i] =
                Node { min: b.min, left: i as u32, max: b.max, right: Node::LEAF };
        }
        // From the root down, then boxes in the opposite order.
        let mut order = Vec::new();
        let mut stack = Vec::from([(0u32, 0u32, n_internal as u32)]);
        stack.retain(|_| n_internal > 0);
        while let Some((node, first, last)) = stack.pop() {
            let gamma = split(first, last);
            assert!(first <= gamma && gamma < last);
            let leaf = |i: u32| n_internal as u32 + i;
            let left = if first == gamma { leaf(gamma) } else { gamma };
            let right = if last == gamma + 1 { leaf(last) } else { gamma + 1 };
            branches[node as usize] = Branch { left, right, first, last };
            order.push(node as usize);
            let children = [(left, first, gamma), (right, gamma + 1, last)];
            stack.extend(children.into_iter().filter(|c| c.0 < n_internal as u32));
        }
        for node in order.into_iter().rev() {
            let Branch { left, right, .. } = branches[node];
            let both = nodes[left as usize].aabb().union(&nodes[right as usize].aabb());
            nodes[node] = Node { min: both.min, left, max: both.max, right };
        }
        Self { branches, nodes }
    }
}

/// Where a node over a range of leaves is split.
pub type Split = Box<dyn Fn(u32, u32) -> u32>;

/// Ways to split `n` leaves: in halves, chains of leaves and of pairs of leaves to either side, at
/// random.
pub fn splits() -> Vec<(&'static str, Split)> {
    Vec::from([
        ("halves", Box::new(|first: u32, last: u32| first + (last - first) / 2) as Split),
        ("chain to the left", Box::new(|_, last| last - 1)),
        ("chain to the right", Box::new(|first, _| first)),
        ("pairs to the left", Box::new(|first, last| (last.max(2) - 2).max(first))),
        ("pairs to the right", Box::new(|first, last| (first + 1).min(last - 1))),
        ("random", Box::new(move |first, last| first + pcg(first * 977 + last) % (last - first))),
    ])
}

/// Boxes of which some overlap.
pub fn boxes(n: usize, seed: u32) -> Vec<Aabb> {
    let mut random = Random::new(seed);
    let mut unit = || random.unit() as f32;
    let mut one = || {
        let min = [unit(), unit(), unit()];
        Aabb { min, max: min.map(|c| c + 0.5 * unit()) }
    };
    Vec::from_iter((0..n).map(|_| one()))
}
