//! Binary trees as a source of pairs: a builder puts boxes in order and joins them, a traversal
//! finds the pairs; any builder goes with any traversal.
//!
//! One more builder is a file in `builder/` and an arm of [`builder::new`]; one more traversal a
//! file in `traversal/` and an arm of [`traversal::new`].

mod binary_tree;
mod builder;
pub mod shared_words;
mod statistics;
#[cfg(test)]
mod tests;
mod traversal;

use crate::broad_phase::leaf_boxes::{LeafBoxes, Set};
use crate::broad_phase::pair_source::{
    Marks, Order, Pairs, PairsOfNodes, RowSource, Rows, Scratch, Sides,
};
use crate::threads::Threads;
pub use statistics::TreeStatistics;

use binary_tree::BinaryTree;
use builder::TreeBuilder;
use ccd_core::model::method::{TreeOptions, Volume};
use ccd_core::{Aabb, Error};
use traversal::{Traverse, Trees};

/// A tree per set that needs one, and what builds and traverses them.
#[derive(Debug)]
pub struct TreeSource {
    builder: Box<dyn TreeBuilder>,
    traversal: Box<dyn Traverse>,
    trees: Vec<BinaryTree>,
    volume: Volume,
}

impl TreeSource {
    /// The source of these options.
    pub fn new(options: TreeOptions) -> Result<Self, Error> {
        let builder = builder::new(options.builder)?;
        let traversal = traversal::new(options.traversal)?;
        Ok(Self { builder, traversal, trees: Vec::new(), volume: options.volume })
    }

    /// Whether this set has a tree.
    fn has_tree(&self, set: Set) -> bool {
        set.searched || self.traversal.descends_both()
    }

    /// The tree over a set.
    #[cfg(test)]
    pub fn tree(&self, set: usize) -> &BinaryTree {
        &self.trees[set]
    }
}

impl Order for TreeSource {
    fn survey(&mut self, _threads: &Threads, sets: &[&[Aabb<f32>]]) -> Result<(), Error> {
        self.builder.check(sets.iter().map(|boxes| boxes.len()).max().unwrap_or(0))
    }

    /// Fixed boxes are not told apart: the tree needs its order, so that no subtrees of them arise
    /// that could be left out; the sink's rule takes their pairs away.
    fn sort(
        &mut self,
        threads: &Threads,
        set: Set,
        boxes: &[Aabb<f32>],
        _marks: &Marks,
        order: &mut Vec<u32>,
    ) {
        if self.trees.len() <= set.index {
            self.trees.resize_with(set.index + 1, || BinaryTree::new(self.volume));
        }
        if self.has_tree(set) {
            let tree = &mut self.trees[set.index];
            self.builder.build(threads, boxes, order, &mut tree.branches);
            tree.link(threads, boxes.len());
        } else {
            self.builder.sort(threads, boxes, order);
        }
    }

    fn fit(&mut self, threads: &Threads, leaves: &LeafBoxes) -> f64 {
        let set = leaves.set();
        if self.has_tree(set) { self.trees[set.index].fit(threads, leaves) } else { 1.0 }
    }

    fn tree_statistics(&self, threads: &Threads, leaves: &LeafBoxes) -> Option<TreeStatistics> {
        let tree = self.trees.get(leaves.set().index)?;
        Some(TreeStatistics::of(tree, threads, leaves))
    }
}

impl RowSource for TreeSource {
    fn begin(&mut self, threads: &Threads, sides: Sides) -> usize {
        let (a, b) = sides;
        assert!(b.unwrap_or(a).set().searched, "there is no tree over this set");
        let trees = trees_of(&self.trees, self.has_tree(a.set()), sides);
        self.traversal.begin(threads, trees, sides)
    }

    fn task(&self, k: usize, sides: Sides, scratch: &mut Scratch, rows: &mut Rows) {
        let trees = trees_of(&self.trees, self.has_tree(sides.0.set()), sides);
        self.traversal.task(k, trees, sides, scratch, rows);
    }

    fn max_threads(&self) -> usize {
        self.traversal.max_threads()
    }
}

impl PairsOfNodes for TreeSource {
    fn descend(&mut self, threads: &Threads, sides: Sides, run: &mut dyn FnMut(Pairs)) {
        let Self { traversal, trees, .. } = self;
        let trees = trees_of(trees, traversal.descends_both(), sides);
        traversal.begin(threads, trees, sides);
        let builds = [trees.a.unwrap_or(trees.b), trees.b].map(BinaryTree::build);
        traversal
            .descend(trees, sides, &mut |tree, roots| run(Pairs { tree, roots, builds }));
    }
}

/// The trees of two sides; `a_has_one`: the first has a tree.
fn trees_of<'a>(trees: &'a [BinaryTree], a_has_one: bool, (a, b): Sides) -> Trees<'a> {
    let of = |leaves: &LeafBoxes| &trees[leaves.set().index];
    Trees { a: a_has_one.then(|| of(a)), b: of(b.unwrap_or(a)) }
}
