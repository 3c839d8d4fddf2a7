//! The ways to find overlapping boxes, as choices: what each is is said in
//! [`catalogue`](super::catalogue).

use super::error::{Error, check_setting};

/// How a broad phase finds overlapping boxes; all methods give the same set.
///
/// ```
/// use ccd::{Options, method::{BroadPhaseMethod, Catalogued}};
///
/// let options = Options::default().with_broad_phase(BroadPhaseMethod::SweepAndPrune);
/// assert_eq!(options.broad_phase.row().name, "sweep-and-prune");
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum BroadPhaseMethod {
    /// Every box against every other: what all else is compared with.
    BruteForce,
    /// Boxes sorted along the axis of largest variance, each compared with those that begin before
    /// it ends [Cohen 1995], [Karras 2012a].
    SweepAndPrune,
    /// The same with a queue of boxes that have not met their end, each of which moves on by one
    /// step a round [Belgrod 2023].
    SweepAndTiniestQueue,
    /// Boxes in all strips along the axis that they touch, swept within each [Liu 2010]: the sweep
    /// for many boxes, of any sizes.
    SweepInStrips,
    /// End points of boxes sorted along one axis, and a thread for each [Karras 2012a]: the sweep
    /// as its author prints it, on a GPU alone.
    SweepByEndPoints,
    /// Boxes sorted into the cells of a grid, each compared with those of its own cell and of the
    /// cells around it [Karras 2012a]; boxes of unequal sizes in several grids.
    UniformGrid,
    /// Blocks of neighbouring boxes in Hilbert order, descended together: the fastest where boxes
    /// overlap many others.
    #[default]
    Blocks,
    /// A binary tree.
    Tree(TreeOptions),
}

/// Which binary tree, and how it is traversed.
///
/// ```
/// use ccd::method::{Builder, Traversal, TreeOptions};
///
/// let tree = TreeOptions::default().builder(Builder::Lbvh).traversal(Traversal::Half);
/// assert_eq!(tree, TreeOptions::default());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[non_exhaustive]
pub struct TreeOptions {
    /// How it is built.
    pub builder: Builder,
    /// How pairs are found in it.
    pub traversal: Traversal,
    /// What bounds its nodes.
    pub volume: Volume,
}

/// How a binary tree over boxes is built.
///
/// ```
/// use ccd::method::Builder;
///
/// assert_eq!(Builder::PLOC, Builder::Ploc { radius: 16 });
/// assert!(Builder::NEAREST_PAIR.check(1_000_000).is_err());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum Builder {
    /// From sorted Morton codes, every node by itself [Karras 2012].
    #[default]
    Lbvh,
    /// From sorted Morton codes by lists of the levels at which neighbours split [Lauterbach 2009].
    SplitLists,
    /// Bottom up, every node with its nearest free neighbour [Tian and Wan]: takes a time that
    /// grows with the square of the number of boxes.
    NearestPair {
        /// Most boxes that it is used for; more are refused.
        limit: u32,
    },
    /// Bottom up, every cluster with its nearest neighbour along the Morton curve [Meister 2018].
    Ploc {
        /// How many neighbours to either side are looked at, 1 to [`Builder::MAX_RADIUS`].
        radius: u32,
    },
}

impl Builder {
    /// [`Builder::NearestPair`] up to the number of boxes that takes a fifth of a second.
    pub const NEAREST_PAIR: Self = Self::NearestPair { limit: 20_000 };
    /// [`Builder::Ploc`] with the radius that its authors recommend for speed.
    pub const PLOC: Self = Self::Ploc { radius: 16 };
    /// Greatest radius of [`Builder::Ploc`].
    pub const MAX_RADIUS: u32 = 128;

    /// Refuses more boxes than the builder is to be used for.
    ///
    /// # Errors
    /// [`Error::TooMany`].
    pub fn check(self, n_boxes: u64) -> Result<(), Error> {
        match self {
            Self::NearestPair { limit } if n_boxes > limit as u64 => Err(Error::TooMany {
                element: "boxes for `nearest-pair`, by its limit, which can be set",
                count: n_boxes,
                limit: limit as u64,
            }),
            _ => Ok(()),
        }
    }
}

/// How pairs are found in a binary tree.
///
/// ```
/// use ccd::method::{Descent, Traversal};
///
/// assert_eq!(Traversal::SIMULTANEOUS, Traversal::Simultaneous(Descent::Both));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum Traversal {
    /// A query per box, in the order of input, by a function that calls itself; on a GPU, which has
    /// no calls, by a stack of the places to which they return.
    Recursive,
    /// A query per box, in the order of input, with a stack [Karras 2012b].
    Iterative,
    /// The same in the order of leaves, so that neighbouring queries visit the same nodes.
    LeafOrder,
    /// The same, each looking only at leaves after its own, so that every pair is found once.
    #[default]
    Half,
    /// The first of two trees to each of its leaves, and that leaf through the second, by functions
    /// that call themselves, one after the other [Tian and Wan].
    DoubleRecursion,
    /// Pairs of nodes from the root on, one after the other.
    Simultaneous(Descent),
    /// Pairs of nodes from all pairs of a cut through the tree on, in parallel.
    Cut {
        /// Nodes of the cut, 1 to [`Traversal::MAX_CUT`].
        nodes: u32,
        /// How a pair is expanded.
        descent: Descent,
    },
    /// The same, each pair of the cut by one thread of a GPU with a stack of its own
    /// [Karras 2012b].
    CutStacks {
        /// Nodes of the cut, 1 to [`Traversal::MAX_CUT`].
        nodes: u32,
        /// How a pair is expanded.
        descent: Descent,
    },
}

impl Traversal {
    /// [`Traversal::Simultaneous`] as it is by default.
    pub const SIMULTANEOUS: Self = Self::Simultaneous(Descent::Both);
    /// [`Traversal::Cut`] of 256 nodes, which are 32,896 pairs.
    pub const CUT: Self = Self::Cut { nodes: 256, descent: Descent::Both };
    /// [`Traversal::CutStacks`] of the same cut.
    pub const CUT_STACKS: Self = Self::CutStacks { nodes: 256, descent: Descent::Both };
    /// Most nodes of a cut: half a million pairs a tree.
    pub const MAX_CUT: u32 = 1024;
}

/// How a pair of nodes that overlap is expanded.
///
/// ```
/// use ccd::method::{BroadPhaseMethod, Descent, Traversal, TreeOptions};
///
/// let by_size = Traversal::Simultaneous(Descent::Larger);
/// let method = BroadPhaseMethod::Tree(TreeOptions::default().traversal(by_size));
/// assert!(method.check().is_ok());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[repr(u32)]
pub enum Descent {
    /// The larger of the two into its children.
    Larger,
    /// Both into theirs: fewer steps, and faster on every scene that was measured.
    #[default]
    Both,
}

/// What bounds the nodes of a binary tree.
///
/// ```
/// use ccd::method::{BroadPhaseMethod, TreeOptions, Volume};
///
/// let method = BroadPhaseMethod::Tree(TreeOptions::default().volume(Volume::Obb));
/// assert_eq!(method.to_string(), "tree-lbvh-half-obb");
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum Volume {
    /// Boxes along the axes.
    #[default]
    Aabb,
    /// Boxes along axes of their own [Gottschalk 1996], for nodes above the leaves: see
    /// [`obb`](crate::math::obb). By pairs of triangles, on a CPU, those of moving triangles also
    /// reject pairs whose candidates are counted.
    Obb,
}

impl TreeOptions {
    /// The same with this builder.
    pub const fn builder(self, builder: Builder) -> Self {
        Self { builder, ..self }
    }

    /// The same with this traversal.
    pub const fn traversal(self, traversal: Traversal) -> Self {
        Self { traversal, ..self }
    }

    /// The same with these volumes.
    pub const fn volume(self, volume: Volume) -> Self {
        Self { volume, ..self }
    }
}

impl BroadPhaseMethod {
    /// The tree that is fastest among the trees.
    pub const TREE: Self = Self::Tree(TreeOptions {
        builder: Builder::Lbvh,
        traversal: Traversal::Half,
        volume: Volume::Aabb,
    });

    /// Checks settings that have a range.
    ///
    /// # Errors
    /// [`Error::Setting`] with the first that is not.
    pub fn check(self) -> Result<(), Error> {
        let Self::Tree(tree) = self else { return Ok(()) };
        if let Builder::Ploc { radius } = tree.builder {
            check_setting("radius of PLOC", radius, 1, Builder::MAX_RADIUS)?;
        }
        if let Traversal::Cut { nodes, .. } | Traversal::CutStacks { nodes, .. } = tree.traversal {
            check_setting("nodes of the cut", nodes, 1, Traversal::MAX_CUT)?;
        }
        Ok(())
    }
}
