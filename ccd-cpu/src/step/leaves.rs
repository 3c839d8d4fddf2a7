//! What belongs to the leaves of one set of features, in the order of the method that was chosen:
//! all that the filters read of a pair of leaves.

use crate::broad_phase::leaf_boxes::{Keeps, LeafBoxes, Order, Set, add_runs};
use crate::broad_phase::marks::Posed;
use crate::broad_phase::method::Method;
use crate::broad_phase::pair_source::PairSource;
use crate::simd::{Block, EMPTY, RowSimd, WIDTH, Work};
use crate::step::rigid::RigidTrees;
use crate::step::selection::BlockBodies;
use crate::threads::Threads;
use ccd_core::backend::rules::Rules;
use ccd_core::{Aabb, Num};
use std::ops::Range;
use std::slice;

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

    /// Takes boxes in the order that there is, see [`LeafBoxes::take`]; [`Feature::fit`] is next.
    pub fn take_boxes(&mut self, threads: &Threads, keeps: Keeps) {
        self.leaves.boxes.take(threads, &self.boxes, keeps);
    }

    /// Has the method fit them, see [`Order::fit`](crate::broad_phase::leaf_boxes::Order::fit).
    pub fn fit(&mut self, threads: &Threads, order: &mut dyn Order) -> f64 {
        order.fit(threads, &self.leaves.boxes)
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
        &self.0.ends[self.1]
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
    /// Boxes of the features at the start and at the end, of the positions in the table.
    pub ends: Vec<[Block; 2]>,
    /// Whether the method has taken `ends`, but for those of these runs of blocks.
    taken: bool,
    untaken: Vec<Range<usize>>,
}

impl<const N: usize> Leaves<N> {
    /// No features yet.
    pub fn new(set: Set) -> Self {
        Self {
            boxes: LeafBoxes::new(set),
            vertices: Vec::new(),
            bodies: BlockBodies::default(),
            ends: Vec::new(),
            taken: false,
            untaken: Vec::new(),
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
        self.ends.clear();
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
        boxes.pose(threads, runs, |i| {
            std::array::from_fn(|lane| {
                let of = |k: usize| &of_vertices[vertices[i][k][lane] as usize];
                (1..N).fold(*of(0), |all, k| all.union(of(k)))
            })
        });
        method.order().fit(threads, boxes);
        boxes.all_changed(still);
    }

    /// Boxes at both ends, from the table of positions; `holds`: whether those of leaves that were
    /// not changed do. Of what is posed those are made that have boxes.
    pub fn place(&mut self, threads: &Threads, table: &[[f32; WIDTH]], holds: bool) {
        let Self { boxes, vertices, ends, taken, untaken, .. } = self;
        threads.resize(ends, vertices.len(), || [EMPTY; 2]);
        if !holds {
            *taken = false;
            untaken.clear();
        }
        if *taken {
            // The call before may have changed others, of which nobody took the ends.
            add_runs(untaken, boxes.changed());
        }
        boxes.emptied().iter().for_each(|run| ends[run.clone()].fill([EMPTY; 2]));
        let first = 0..boxes.n_free();
        let first = if holds { boxes.free() } else { slice::from_ref(&first) };
        let last = if holds { 0..0 } else { boxes.n_moving()..vertices.len() };
        for runs in [first, boxes.filled(), slice::from_ref(&last)] {
            threads.chunks_in(ends, runs, &|first, out| {
                place(table, &vertices[first..first + out.len()], out);
            });
        }
    }

    /// Has the method leave out pairs that an axis keeps further than `gap` apart at both ends.
    pub fn hand_on_ends(&mut self, threads: &Threads, method: &mut Method, gap: f32) {
        let Self { boxes, ends, taken, untaken, .. } = self;
        let all = 0..ends.len();
        let changed = if *taken { &untaken[..] } else { slice::from_ref(&all) };
        if method.order().take_ends(threads, boxes, ends, changed, gap) {
            *taken = true;
            untaken.clear();
        }
    }
}

/// The boxes of eight features at both ends, from the table of positions.
pub fn ends<const N: usize>(table: &[[f32; WIDTH]], vertices: &[[u32; WIDTH]; N]) -> [Block; 2] {
    let mut out = [[EMPTY; 2]];
    place(table, slice::from_ref(vertices), &mut out);
    out[0]
}

fn place<const N: usize>(
    table: &[[f32; WIDTH]],
    vertices: &[[[u32; WIDTH]; N]],
    out: &mut [[Block; 2]],
) {
    crate::simd::run_rows!(Place { table, vertices, out })
}

/// The boxes of eight features at both ends, block by block, written where they belong.
struct Place<'a, const N: usize> {
    table: &'a [[f32; WIDTH]],
    vertices: &'a [[[u32; WIDTH]; N]],
    out: &'a mut [[Block; 2]],
}

impl<S: RowSimd, const N: usize> Work<S> for Place<'_, N> {
    type Out = ();

    #[inline(always)]
    fn call(self, simd: S) {
        for (vertices, out) in self.vertices.iter().zip(self.out) {
            *out = ends_of(simd, self.table, vertices);
        }
    }
}

#[inline(always)]
fn ends_of<S: RowSimd, const N: usize>(
    simd: S,
    table: &[[f32; WIDTH]],
    vertices: &[[u32; WIDTH]; N],
) -> [Block; 2] {
    let first = simd.gather(table, &vertices[0]);
    let (mut min, mut max) = (first, first);
    for ids in &vertices[1..] {
        let next = simd.gather(table, ids);
        for k in 0..WIDTH {
            min[k] = min[k].min(next[k]);
            max[k] = max[k].max(next[k]);
        }
    }
    [block(simd, &min, &max, 0), block(simd, &min, &max, 4)]
}

/// The boxes whose bounds begin at component `k`.
#[inline(always)]
fn block<S: RowSimd>(simd: S, min: &[S::Lanes; WIDTH], max: &[S::Lanes; WIDTH], k: usize) -> Block {
    Block {
        min: [simd.store(min[k]), simd.store(min[k + 1]), simd.store(min[k + 2])],
        max: [simd.store(max[k]), simd.store(max[k + 1]), simd.store(max[k + 2])],
    }
}
