//! What belongs to the leaves of one set of features, in the order of the method that was chosen:
//! all that the filters read of a pair of leaves.

use crate::broad_phase::leaf_boxes::{Keeps, LeafBoxes, Order, Set};
use crate::broad_phase::marks::Posed;
use crate::broad_phase::method::Method;
use crate::broad_phase::pair_source::PairSource;
use crate::simd::{Block, RowSimd, WIDTH, Work};
use crate::step::leaf_ends::{self, LeafEnds};
use crate::step::rigid::RigidTrees;
use crate::step::selection::BlockBodies;
use crate::threads::Threads;
use ccd_core::backend::rules::Rules;
use ccd_core::{Aabb, Num};
use std::ops::Range;

/// Boxes and leaves of one kind of feature with `N` vertices.
#[derive(Debug)]
pub struct Feature<const N: usize> {
    pub boxes: Vec<Aabb<f32>>,
    pub leaves: Leaves<N>,
}

impl<const N: usize> Feature<N> {
    /// No features yet.
    pub fn new(index: usize, searched: bool) -> Self {
        Self { boxes: Vec::new(), leaves: Leaves::new(Set { index, searched }) }
    }

    /// Puts boxes in a new order; `keep`: but for those that stand still. What is posed has an
    /// order of its own.
    pub fn build(
        &mut self,
        threads: &Threads,
        order: &mut dyn Order,
        rules: Option<&Rules>,
        (keep, rigid): (bool, &RigidTrees),
        features: impl Fn(u32) -> [u32; N] + Sync,
    ) {
        let Self { boxes, leaves } = self;
        let kept = if keep { leaves.boxes.n_still() } else { 0 };
        let vertex = |i: usize| features(i as u32)[0];
        let is = |i: usize| rigid.has(vertex(i));
        let posed = rigid.order(leaves.boxes.set().index);
        let posed = Posed { is: &is, order: posed, wait: rigid.is_on() };
        let posed = rigid.is_there().then_some(posed);
        leaves.boxes.build_by_rules(threads, order, boxes, rules, vertex, (kept, posed));
        leaves.order(threads, rules, &features);
    }
}

/// One feature of each lane of a block: what the rule of candidates and the first filter read.
pub trait Side<'a, const N: usize>: Copy {
    /// Vertices.
    fn vertices(self) -> [&'a [u32; WIDTH]; N];
    /// Ids.
    fn ids(self) -> &'a [u32; WIDTH];
    /// Boxes during the step.
    fn boxes(self) -> &'a Block;
    /// Boxes at its ends, of the positions in the table.
    fn ends(self) -> &'a [Block; 2];
    /// The vertices of one lane.
    #[inline(always)]
    fn vertices_of(self, lane: usize) -> [u32; N] {
        self.vertices().map(|ids| ids[lane])
    }
}

/// A block of leaves.
impl<'a, const N: usize> Side<'a, N> for (&'a Leaves<N>, usize) {
    #[inline(always)]
    fn vertices(self) -> [&'a [u32; WIDTH]; N] {
        self.0.vertices[self.1].each_ref()
    }

    #[inline(always)]
    fn ids(self) -> &'a [u32; WIDTH] {
        self.0.boxes.ids(self.1)
    }

    #[inline(always)]
    fn boxes(self) -> &'a Block {
        &self.0.boxes.blocks()[self.1]
    }

    #[inline(always)]
    fn ends(self) -> &'a [Block; 2] {
        self.0.ends.of(self.1)
    }
}

/// The features of one set, `N` vertices each, in leaf order, eight side by side.
#[derive(Debug)]
pub struct Leaves<const N: usize> {
    /// Their order and their boxes.
    pub boxes: LeafBoxes,
    /// Vertices of the features.
    pub vertices: Vec<[[u32; WIDTH]; N]>,
    /// Bodies of the features.
    pub bodies: BlockBodies,
    /// Boxes of the features at both ends.
    pub ends: LeafEnds,
}

impl<const N: usize> Leaves<N> {
    /// No features yet.
    pub fn new(set: Set) -> Self {
        Self {
            boxes: LeafBoxes::new(set),
            vertices: Vec::new(),
            bodies: BlockBodies::default(),
            ends: LeafEnds::default(),
        }
    }

    /// The first vertices of block `i`, if it is neither posed nor still.
    pub fn first_of_free(&self, i: usize) -> Option<&[u32; WIDTH]> {
        (i < self.boxes.n_free()).then(|| &self.vertices[i][0])
    }

    /// Vertices and bodies, from the vertices of every feature and the order of leaves.
    pub fn order(
        &mut self,
        threads: &Threads,
        rules: Option<&Rules>,
        features: impl Fn(u32) -> [u32; N] + Sync,
    ) {
        let boxes = &self.boxes;
        threads.resize(&mut self.vertices, boxes.len().div_ceil(WIDTH), || [[0; WIDTH]; N]);
        threads.fill(&mut self.vertices, |i| {
            let features = boxes.ids(i).map(&features);
            std::array::from_fn(|k| features.map(|vertices| vertices[k]))
        });
        self.bodies.fill(rules, self.vertices.iter().map(|block| &block[0]));
        self.ends.forget();
    }

    /// Makes boxes in the order that there is from those of vertices, see [`LeafBoxes::make`];
    /// [`Leaves::fit`] is next.
    pub fn sweep(&mut self, threads: &Threads, of_vertices: &[Aabb<f32>], keeps: Keeps) {
        let Self { boxes, vertices, .. } = self;
        boxes.make(threads, keeps, &|first, _, out| sweep(of_vertices, &vertices[first..], out));
    }

    /// Has the method fit them, see [`Order::fit`](crate::broad_phase::leaf_boxes::Order::fit).
    pub fn fit(&mut self, threads: &Threads, order: &mut dyn Order) -> f64 {
        order.fit(threads, &self.boxes)
    }

    /// Makes boxes of these runs of posed blocks from those of vertices, see [`LeafBoxes::pose`].
    pub fn pose(
        &mut self,
        threads: &Threads,
        method: &mut Method,
        runs: &[Range<usize>],
        of_vertices: &[Aabb<f32>],
        still: bool,
    ) {
        let Self { boxes, vertices, .. } = self;
        let make = |first: usize, _: &[_], out: &mut [Block]| {
            sweep(of_vertices, &vertices[first..], out);
        };
        boxes.pose(threads, runs, &make);
        method.order().fit(threads, boxes);
        boxes.all_changed(still);
    }

    /// Boxes at both ends change with those of leaves: see [`LeafEnds::change`].
    pub fn change_ends(&mut self, holds: bool) {
        self.ends.change(&self.boxes, holds);
    }

    /// See [`leaf_ends::lengths`].
    pub fn lengths(&self, table: &[[f32; WIDTH]]) -> [f64; 2] {
        leaf_ends::lengths(&self.boxes, &self.vertices, table)
    }

    /// See [`LeafEnds::make`].
    pub fn make_ends(&mut self, threads: &Threads, table: &[[f32; WIDTH]]) {
        self.ends.make(threads, &self.boxes, &self.vertices, table);
    }

    /// See [`LeafEnds::hand_on`].
    pub fn hand_on_ends(&mut self, threads: &Threads, method: &mut Method, gap: f32) {
        self.ends.hand_on(threads, method.order(), &self.boxes, gap);
    }
}

/// The box of a feature during the step, from those of vertices.
pub fn feature_box<const N: usize>(ids: [u32; N], of_vertices: &[Aabb<f32>]) -> Aabb<f32> {
    let of = |v: u32| &of_vertices[v as usize];
    ids.iter().skip(1).fold(*of(ids[0]), |all, &v| all.union(of(v)))
}

/// The boxes of features during the step, from those of vertices.
fn sweep<const N: usize>(boxes: &[Aabb<f32>], vertices: &[[[u32; WIDTH]; N]], out: &mut [Block]) {
    crate::simd::run_rows!(Sweep { boxes, vertices, out })
}

/// The same, block by block, written where they belong.
struct Sweep<'a, const N: usize> {
    boxes: &'a [Aabb<f32>],
    vertices: &'a [[[u32; WIDTH]; N]],
    out: &'a mut [Block],
}

impl<S: RowSimd, const N: usize> Work<S> for Sweep<'_, N> {
    type Out = ();

    #[inline(always)]
    fn call(self, simd: S) {
        for (vertices, out) in self.vertices.iter().zip(self.out) {
            let Aabb { mut min, mut max } = simd.gather_boxes(self.boxes, &vertices[0]);
            for ids in &vertices[1..] {
                let next = simd.gather_boxes(self.boxes, ids);
                for k in 0..3 {
                    min[k] = min[k].min(next.min[k]);
                    max[k] = max[k].max(next.max[k]);
                }
            }
            *out = Block {
                min: [simd.store(min[0]), simd.store(min[1]), simd.store(min[2])],
                max: [simd.store(max[0]), simd.store(max[1]), simd.store(max[2])],
            };
        }
    }
}
