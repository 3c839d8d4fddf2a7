//! What there is to choose from: a row for every method, builder, traversal, volume and pipeline;
//! those of schedulers and fronts stand beside them, in [`scheduling`](super::scheduling).

use super::method::{BroadPhaseMethod, Builder, Traversal, TreeOptions, Volume};
use super::pipeline::Pipeline;
use core::mem::discriminant;

/// What there is to say about a choice.
///
/// ```
/// use ccd::method::{Builder, Catalogued};
///
/// let row = Builder::Lbvh.row();
/// assert_eq!((row.name, row.source), ("lbvh", Some("Karras 2012")));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row<T> {
    /// The choice, with the settings that it has by default.
    pub value: T,
    /// Its name on a command line.
    pub name: &'static str,
    /// One line about it.
    pub about: &'static str,
    /// Where it is from: a key of docs/REFERENCES.md; `None`: this project.
    pub source: Option<&'static str>,
    /// Where it runs: `"cpu"`, `"gpu"`.
    pub backends: &'static [&'static str],
}

/// A choice that has a row for each of its values.
///
/// ```
/// use ccd::method::{BroadPhaseMethod, Catalogued};
///
/// let mut names = BroadPhaseMethod::ROWS.iter().map(|row| row.name);
/// assert!(names.any(|name| name == "blocks"));
/// assert_eq!(BroadPhaseMethod::named("blocks"), Some(BroadPhaseMethod::Blocks));
/// ```
pub trait Catalogued: Copy + PartialEq + 'static {
    /// Every value, in the order of the enum.
    const ROWS: &'static [Row<Self>];
    /// Names of those that every build has; others are there by the feature `catalogue`.
    const ALWAYS: &'static [&'static str];

    /// What there is to say about a value, whatever its settings.
    fn row(self) -> &'static Row<Self> {
        let same = |row: &&Row<Self>| discriminant(&row.value) == discriminant(&self);
        // A test sees that every value has its row.
        Self::ROWS.iter().find(same).unwrap_or(&Self::ROWS[0])
    }

    /// The value of that name, with the settings that it has by default.
    fn named(name: &str) -> Option<Self> {
        Self::ROWS.iter().find(|row| row.name == name).map(|row| row.value)
    }
}

pub(super) const CPU: &[&str] = &["cpu"];
pub(super) const GPU: &[&str] = &["gpu"];

impl<T: Copy> Row<T> {
    /// A choice of this project, on both backends.
    pub(super) const fn new(value: T, name: &'static str) -> Self {
        Self { value, name, about: "", source: None, backends: &["cpu", "gpu"] }
    }

    pub(super) const fn about(self, about: &'static str) -> Self {
        Self { about, ..self }
    }

    /// From a source, by its key.
    pub(super) const fn source(self, key: &'static str) -> Self {
        Self { source: Some(key), ..self }
    }

    pub(super) const fn on(self, backends: &'static [&'static str]) -> Self {
        Self { backends, ..self }
    }

    /// The name of the choice if a backend does not have it.
    pub(super) fn lacking(&self, backend: &str) -> Option<&'static str> {
        (!self.backends.contains(&backend)).then_some(self.name)
    }
}

impl Catalogued for BroadPhaseMethod {
    const ALWAYS: &'static [&'static str] = &["blocks", "tree"];
    const ROWS: &'static [Row<Self>] = &[
        Row::new(Self::BruteForce, "brute-force")
            .about("Every box against every other; what all else is compared with"),
        Row::new(Self::SweepAndPrune, "sweep-and-prune")
            .about("Boxes sorted along one axis, each against those that begin before it ends")
            .source("Karras 2012a"),
        Row::new(Self::SweepAndTiniestQueue, "sweep-and-tiniest-queue")
            .about("The same in rounds: each box moves on by a step while its interval lasts")
            .source("Belgrod 2023")
            .on(CPU),
        Row::new(Self::SweepInStrips, "sweep-in-strips")
            .about("Sweep and prune in strips along the axis; for many boxes, of any sizes")
            .source("Liu 2010")
            .on(CPU),
        Row::new(Self::SweepByEndPoints, "sweep-by-end-points")
            .about("One GPU thread per end point, which walks from each start to its end")
            .source("Karras 2012a")
            .on(GPU),
        Row::new(Self::UniformGrid, "uniform-grid")
            .about("Boxes in cells of several grids, a grid for each size; for boxes of any sizes")
            .source("Karras 2012a"),
        Row::new(Self::Blocks, "blocks")
            .about("Blocks of neighbouring boxes, of 8 on the CPU and 32 on a GPU"),
        Row::new(Self::TREE, "tree")
            .about("A binary tree; --builder, --traversal and --volume say which")
            .source("Karras 2012"),
    ];
}

impl Catalogued for Builder {
    const ALWAYS: &'static [&'static str] = &["lbvh"];
    const ROWS: &'static [Row<Self>] = &[
        Row::new(Self::Lbvh, "lbvh")
            .about("From sorted Morton codes, every node by itself")
            .source("Karras 2012"),
        Row::new(Self::SplitLists, "split-lists")
            .about("From sorted Morton codes, by lists of where neighbours split")
            .source("Lauterbach 2009"),
        Row::new(Self::NEAREST_PAIR, "nearest-pair")
            .about("Bottom up, every node with its nearest free neighbour; slow")
            .source("Tian and Wan"),
        Row::new(Self::PLOC, "ploc")
            .about("Bottom up, every cluster with its nearest neighbour along the Morton curve")
            .source("Meister 2018"),
    ];
}

impl Catalogued for Traversal {
    const ALWAYS: &'static [&'static str] = &["leaf-order", "half"];
    const ROWS: &'static [Row<Self>] = &[
        Row::new(Self::Recursive, "recursive")
            .about("A query per box in the order of input, by recursion; on a GPU emulated")
            .source("Karras 2012b"),
        Row::new(Self::Iterative, "iterative")
            .about("A query per box in the order of input, with a stack")
            .source("Karras 2012b"),
        Row::new(Self::LeafOrder, "leaf-order")
            .about("A query per box in the order of leaves")
            .source("Karras 2012b"),
        Row::new(Self::Half, "half")
            .about("In the order of leaves, each looking only at those after its own")
            .source("Karras 2012b"),
        Row::new(Self::DoubleRecursion, "double-recursion")
            .about("One tree to a leaf, that leaf through the other tree, by one thread")
            .source("Tian and Wan")
            .on(CPU),
        Row::new(Self::SIMULTANEOUS, "simultaneous")
            .about("Pairs of nodes from the root on, by one thread")
            .source("Karras 2012b")
            .on(CPU),
        Row::new(Self::CUT, "cut")
            .about("Pairs of nodes from all pairs of a cut of 256 nodes on, in parallel")
            .source("Karras 2012b"),
        Row::new(Self::CUT_STACKS, "cut-stacks")
            .about(
                "As `cut`, but each starting pair has a thread and a stack of its own, as on a CPU",
            )
            .source("Karras 2012b")
            .on(GPU),
    ];
}

impl Catalogued for Volume {
    const ALWAYS: &'static [&'static str] = &["aabb"];
    const ROWS: &'static [Row<Self>] = &[
        Row::new(Self::Aabb, "aabb").about("Boxes along the axes"),
        Row::new(Self::Obb, "obb")
            .about(
                "Along axes of their own; with --pipeline triangles a CPU rejects pairs by theirs",
            )
            .source("Gottschalk 1996"),
    ];
}

impl Catalogued for Pipeline {
    const ALWAYS: &'static [&'static str] = &["features", "triangles"];
    const ROWS: &'static [Row<Self>] = &[
        Row::new(Self::Features, "features")
            .about("Vertices against faces and edges against edges, by their own boxes"),
        Row::new(Self::TRIANGLES, "triangles")
            .about("Triangles against triangles, expanded to features that each one represents")
            .source("Curtis 2008"),
    ];
}

impl Pipeline {
    /// The name of the pipeline if a backend does not have it.
    pub fn lacking(self, backend: &str) -> Option<&'static str> {
        self.row().lacking(backend)
    }
}

impl BroadPhaseMethod {
    /// Whether a backend has the method with all its settings; if not, the name of what it lacks.
    pub fn lacking(self, backend: &str) -> Option<&'static str> {
        let method = self.row().lacking(backend);
        let Self::Tree(TreeOptions { builder, traversal, volume }) = self else { return method };
        method
            .or_else(|| builder.row().lacking(backend))
            .or_else(|| traversal.row().lacking(backend))
            .or_else(|| volume.row().lacking(backend))
    }
}

/// Every method of a backend with its default settings, trees in every combination of theirs.
///
/// ```
/// use ccd::method::every;
///
/// assert!(every("cpu").any(|method| method.to_string() == "tree-ploc-half-aabb"));
/// ```
pub fn every(backend: &str) -> impl Iterator<Item = BroadPhaseMethod> {
    let plain = |row: &Row<BroadPhaseMethod>| !matches!(row.value, BroadPhaseMethod::Tree(_));
    let methods = BroadPhaseMethod::ROWS.iter().filter(move |row| plain(row)).map(|row| row.value);
    let trees = Builder::ROWS.iter().flat_map(|builder| {
        Traversal::ROWS.iter().flat_map(move |traversal| {
            Volume::ROWS.iter().map(move |volume| {
                let (traversal, volume) = (traversal.value, volume.value);
                BroadPhaseMethod::Tree(TreeOptions { builder: builder.value, traversal, volume })
            })
        })
    });
    methods.chain(trees).filter(move |method| method.lacking(backend).is_none())
}

/// The name on a command line; of a tree with its builder, its traversal and its volume.
impl core::fmt::Display for BroadPhaseMethod {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.row().name)?;
        let Self::Tree(TreeOptions { builder, traversal, volume }) = *self else { return Ok(()) };
        write!(f, "-{}-{}-{}", builder.row().name, traversal.row().name, volume.row().name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::scheduling::{Front, Scheduler};

    fn check_rows<T: Catalogued + core::fmt::Debug + Default>() {
        for row in T::ROWS {
            assert_eq!(row.value.row().name, row.name, "every value has a row of its own");
            assert_eq!(T::named(row.name), Some(row.value));
            let known = row.backends.iter().all(|b| ["cpu", "gpu"].contains(b));
            assert!(known && !row.about.is_empty(), "{}", row.name);
        }
        assert_eq!(T::named("by hand"), None);
        assert!(T::ROWS.iter().any(|row| row.value == T::default()));
        assert!(T::ALWAYS.iter().all(|name| T::named(name).is_some()));
        assert!(T::ALWAYS.contains(&T::default().row().name));
    }

    #[test]
    fn every_choice_has_its_row() {
        check_rows::<BroadPhaseMethod>();
        check_rows::<Builder>();
        check_rows::<Traversal>();
        check_rows::<Volume>();
        check_rows::<Pipeline>();
        check_rows::<Scheduler>();
        check_rows::<Front>();
    }

    #[test]
    fn a_method_is_there_if_all_its_parts_are() {
        assert_eq!(BroadPhaseMethod::Blocks.lacking("cpu"), None);
        assert_eq!(BroadPhaseMethod::BruteForce.lacking("abacus"), Some("brute-force"));
    }
}
