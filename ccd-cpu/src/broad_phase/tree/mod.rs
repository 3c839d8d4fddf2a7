//! Binary trees as a source of pairs: a builder puts boxes in order and joins them, a traversal
//! finds the pairs; any builder goes with any traversal.
//!
//! One more builder is a file in `builder/` and an arm of [`builder_of`]; one more traversal a file
//! in `traversal/` and an arm of [`traversal_of`].

mod binary_tree;
mod builder;
pub mod shared_words;
mod statistics;
#[cfg(test)]
mod tests;
mod traversal;

use crate::broad_phase::curve_order::CurveOrder;
#[cfg(feature = "catalogue")]
use crate::broad_phase::descend::{Pairs, PairsOfNodes};
use crate::broad_phase::leaf_boxes::{LeafBoxes, Order, Set, Sides};
use crate::broad_phase::marks::Marks;
use crate::broad_phase::rows::{RowSource, Rows, Scratch};
use crate::threads::Threads;
use binary_tree::BinaryTree;
use builder::TreeBuilder;
use builder::lbvh::Lbvh;
#[cfg(feature = "catalogue")]
use builder::{nearest_pair::NearestPair, ploc::Ploc, split_lists::SplitLists};
use ccd_core::backend::broad_phase::morton_key::Curve;
use ccd_core::model::catalogue::Catalogued;
use ccd_core::model::method::{Builder, Traversal, TreeOptions, Volume};
use ccd_core::model::tree_statistics::TreeStatistics;
use ccd_core::{Aabb, Error};
use statistics::statistics;
use traversal::queries::Queries;
use traversal::{Traverse, Trees};
#[cfg(feature = "catalogue")]
use traversal::{cut::Cut, double_recursion::DoubleRecursion};

/// A tree per set that needs one, and what builds and traverses them.
#[derive(Debug)]
pub struct TreeSource {
    builder: Box<dyn TreeBuilder>,
    traversal: Box<dyn Traverse>,
    morton: CurveOrder,
    trees: Vec<BinaryTree>,
    volume: Volume,
}

impl TreeSource {
    /// The source of these options.
    pub fn new(options: TreeOptions) -> Result<Self, Error> {
        let builder = builder_of(options.builder)?;
        let traversal = traversal_of(options.traversal)?;
        if options.volume != Volume::Aabb && !cfg!(feature = "catalogue") {
            return Err(absent(options.volume));
        }
        let (morton, trees) = (CurveOrder::of(Curve::Morton), Vec::new());
        Ok(Self { builder, traversal, morton, trees, volume: options.volume })
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
            self.builder.build(threads, &mut self.morton, boxes, order, &mut tree.branches);
            tree.link(threads, boxes.len());
        } else {
            // No tree is needed, but what is near is to be near in the order.
            self.morton.sort(threads, boxes, &Marks::default(), order);
        }
    }

    fn fit(&mut self, threads: &Threads, leaves: &LeafBoxes) -> f64 {
        let set = leaves.set();
        if self.has_tree(set) { self.trees[set.index].fit(threads, leaves) } else { 1.0 }
    }

    fn tree_statistics(&self, threads: &Threads, leaves: &LeafBoxes) -> Option<TreeStatistics> {
        let tree = self.trees.get(leaves.set().index)?;
        Some(statistics(tree, threads, leaves))
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
}

#[cfg(feature = "catalogue")]
impl PairsOfNodes for TreeSource {
    fn descend(&mut self, threads: &Threads, sides: Sides, run: &mut dyn FnMut(Pairs)) {
        let Self { traversal, trees, .. } = self;
        let trees = trees_of(trees, traversal.descends_both(), sides);
        traversal.begin(threads, trees, sides);
        let builds = [trees.a.unwrap_or(trees.b), trees.b].map(BinaryTree::build);
        traversal.descend(trees, sides, &mut |tree, roots| run(Pairs { tree, roots, builds }));
    }
}

/// The builder of a choice, if there is one here.
fn builder_of(choice: Builder) -> Result<Box<dyn TreeBuilder>, Error> {
    Ok(match choice {
        Builder::Lbvh => Box::new(Lbvh::default()),
        #[cfg(feature = "catalogue")]
        Builder::SplitLists => Box::new(SplitLists::default()),
        #[cfg(feature = "catalogue")]
        Builder::NearestPair { limit } => Box::new(NearestPair::new(limit)),
        #[cfg(feature = "catalogue")]
        Builder::Ploc { radius } => Box::new(Ploc::new(radius)),
        other => return Err(absent(other)),
    })
}

/// The traversal of a choice, if there is one here.
fn traversal_of(choice: Traversal) -> Result<Box<dyn Traverse>, Error> {
    Ok(match choice {
        Traversal::LeafOrder | Traversal::Half => Box::new(Queries::new(choice)),
        #[cfg(feature = "catalogue")]
        Traversal::Recursive | Traversal::Iterative => Box::new(Queries::new(choice)),
        #[cfg(feature = "catalogue")]
        Traversal::DoubleRecursion => Box::new(DoubleRecursion),
        #[cfg(feature = "catalogue")]
        Traversal::Simultaneous(descent) => Box::new(Cut::new(1, descent)),
        #[cfg(feature = "catalogue")]
        Traversal::Cut { nodes, descent } => Box::new(Cut::new(nodes as usize, descent)),
        other => return Err(absent(other)),
    })
}

fn absent(choice: impl Catalogued) -> Error {
    Error::NotCompiled { name: choice.row().name, backend: "cpu" }
}

/// The trees of two sides; `a_has_one`: the first has a tree.
fn trees_of<'a>(trees: &'a [BinaryTree], a_has_one: bool, (a, b): Sides) -> Trees<'a> {
    let tree = |leaves: &LeafBoxes| &trees[leaves.set().index];
    Trees { a: a_has_one.then(|| tree(a)), b: tree(b.unwrap_or(a)) }
}
