//! Bodies that move rigidly: trees that are built once, of which each step moves boxes instead of
//! making those of all features.
//!
//! The vertices of a body are divided along the Hilbert curve into small clumps; a clump has its
//! vertices, and the edges and faces that begin with one of them. Boxes around clumps, around eight
//! clumps, and so on, are of the positions before any pose. A step moves a box by both poses, and
//! only where it is looked at: against other such bodies, and against the trees of all else. Clumps
//! that nothing comes near have no boxes of features, which are then in no pair; those of the
//! others are made and stand in the trees of the step as any.
//!
//! A body within itself is not looked at, so it must be one without self-contact.

mod body;
mod trees;

use crate::broad_phase::block_bvh::BlockBvh;
use crate::broad_phase::leaf_boxes::LeafBoxes;
use crate::broad_phase::runs::join;
use crate::threads::Threads;
use body::Way;
use ccd_core::Aabb;
use ccd_core::backend::quantization::margin;
use ccd_core::backend::rules::Rules;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::precision::{Coordinate, Precision};
use ccd_core::model::session::{Moved, Rigid, Rigids};
use std::ops::Range;
use trees::Trees;

/// Bodies of fewer vertices are moved as any.
const LEAST: usize = 32;
/// Trees are built anew for bodies that begin to move rigidly once they have one vertex for so many
/// of those that do.
const GROWTH: usize = 4;
/// After so many calls in a row without poses the bodies are as any.
const MOST_PLAIN: u32 = 8;

/// The trees of all bodies that move rigidly, and what is near them.
#[derive(Debug, Default)]
pub struct RigidTrees {
    trees: Trees,
    /// See [`Rigids`].
    version: u64,
    placed: u64,
    /// Whether this call has poses.
    on: bool,
    n_plain: u32,
    call: u64,
    /// Boxes of bodies, along an axis.
    sorted: Vec<(Aabb<f32>, u32)>,
    /// Clumps that something is near.
    near: Vec<u32>,
    /// By set: runs of their blocks, numbered from the first posed one on.
    runs: [Vec<Range<usize>>; 3],
}

impl RigidTrees {
    /// Whether any body has a tree.
    pub fn is_there(&self) -> bool {
        !self.trees.bodies.is_empty()
    }

    /// Whether in this call boxes are made of those clumps alone that something is near.
    pub fn is_on(&self) -> bool {
        self.on
    }

    /// Whether the body of a vertex has a tree.
    pub fn has(&self, v: u32) -> bool {
        self.trees.has(v)
    }

    /// Ids of a set in the order of leaves.
    pub fn order(&self, set: usize) -> &[u32] {
        &self.trees.orders[set]
    }

    /// By set: runs of blocks that something is near, numbered from the first posed one on.
    pub fn runs(&self) -> &[Vec<Range<usize>>; 3] {
        &self.runs
    }

    /// Forgets all bodies; whether there were any.
    pub fn clear(&mut self) -> bool {
        let had = self.is_there();
        *self = Self { call: self.call, ..Self::default() };
        had
    }

    /// Has a call make all boxes.
    pub fn pause(&mut self) {
        self.on = false;
        self.runs.iter_mut().for_each(Vec::clear);
    }

    /// Begins a call without poses. Returns what [`RigidTrees::begin`] does.
    pub fn begin_plain(&mut self) -> bool {
        self.pause();
        self.n_plain += 1;
        self.n_plain > MOST_PLAIN && self.clear()
    }

    /// Begins a call with these bodies. Returns whether there are trees of other bodies now, so
    /// that leaves need another order.
    pub fn begin<T: Coordinate>(
        &mut self,
        threads: &Threads,
        mesh: &Mesh,
        rules: Option<&Rules>,
        rigids: Rigids<T>,
    ) -> bool {
        let rules = rules.filter(|rules| rules.worlds().is_none() && !rigids.all.is_empty());
        let Some(rules) = rules else { return self.begin_plain() };
        self.call += 1;
        self.n_plain = 0;
        let changes = self.version != rigids.version && self.take(threads, mesh, rules, &rigids);
        self.version = rigids.version;
        self.on = self.is_there();
        changes
    }

    /// Takes other bodies. Returns whether they have other trees.
    fn take<T: Coordinate>(
        &mut self,
        threads: &Threads,
        mesh: &Mesh,
        rules: &Rules,
        rigids: &Rigids<T>,
    ) -> bool {
        let numbers = rules.words().iter().map(|word| (word >> 2) as usize);
        let n_bodies = numbers.clone().max().map_or(0, |last| last + 1);
        let mut given = vec![None; n_bodies];
        for (place, body) in (0..).zip(rigids.all) {
            given[body.number as usize] = Some(place);
        }
        // By body: its vertices, if it has no self-contact and does not stand still.
        let mut sizes = vec![0; n_bodies];
        for (number, word) in numbers.zip(rules.words()) {
            sizes[number] += (word & 3 == 0) as usize;
        }
        let trees = &mut self.trees;
        let stay = self.placed == rigids.placed
            && trees.bodies.iter().all(|body| given[body.number as usize].is_some());
        let fits = |n: usize| given[n].filter(|_| sizes[n] >= LEAST);
        let size = |of: &dyn Fn(usize) -> bool| -> usize {
            (0..n_bodies).filter(|&n| of(n)).map(|n| sizes[n]).sum()
        };
        let has = |n: usize| trees.has_body(n);
        if stay && GROWTH * size(&|n| fits(n).is_some() && !has(n)) <= size(&has) {
            for body in &mut trees.bodies {
                body.given = given[body.number as usize].expect("all are there");
            }
            return false;
        }
        self.placed = rigids.placed;
        let had = self.is_there();
        self.trees = Trees::default();
        if (0..n_bodies).any(|n| fits(n).is_some()) {
            self.trees = Trees::new(threads, mesh, rules, rigids.rest, fits);
        }
        had || self.is_there()
    }

    /// Finds what is near something. `others`: by set, the tree of all else.
    pub fn look(
        &mut self,
        threads: &Threads,
        rules: &Rules,
        moved: &Moved,
        min_distance: f64,
        others: [(&BlockBvh, &LeafBoxes); 3],
    ) {
        match moved.rigids {
            Precision::F32(of) => self.mark(threads, rules, (of.all, margin(min_distance)), others),
            Precision::F64(of) => self.mark(threads, rules, (of.all, margin(min_distance)), others),
        }
        let Self { trees, near, runs, .. } = self;
        near.clear();
        trees.bodies.iter_mut().for_each(|body| body.take_near(near));
        near.sort_unstable();
        for (set, runs) in runs.iter_mut().enumerate() {
            runs.clear();
            let blocks = near.iter().map(|&clump| &trees.blocks[clump as usize][set]);
            let blocks = blocks.map(|run| run.start as usize..run.end as usize);
            runs.extend(blocks.filter(|run| !run.is_empty()));
            join(runs);
        }
    }

    /// Marks clumps that something is near.
    fn mark<T: Coordinate>(
        &mut self,
        threads: &Threads,
        rules: &Rules,
        (given, margin): (&[Rigid<T>], T),
        others: [(&BlockBvh, &LeafBoxes); 3],
    ) {
        let Self { trees: Trees { bodies, searched, .. }, sorted, call, .. } = self;
        let call = *call;
        let way = |place: u32| Way { poses: &given[place as usize].poses, margin, call };
        threads.each(bodies, &|_, body| {
            let way = way(body.given);
            for (&searched, (tree, leaves)) in searched.iter().zip(others) {
                if searched && !leaves.is_empty() {
                    body.beside(way, tree, leaves);
                }
            }
        });
        sorted.clear();
        for (k, body) in (0..).zip(bodies.iter_mut()) {
            sorted.push((body.swept(way(body.given)), k));
        }
        let axis = axis_of(sorted);
        let begin = |of: &(Aabb<f32>, u32)| of.0.min[axis];
        sorted.sort_unstable_by(|a, b| begin(a).total_cmp(&begin(b)).then(a.1.cmp(&b.1)));
        for (k, (of_a, a)) in sorted.iter().enumerate() {
            let begins = |next: &&(Aabb<f32>, u32)| begin(next) <= of_a.max[axis];
            for (_, b) in
                sorted[k + 1..].iter().take_while(begins).filter(|of| !of.0.separated(of_a))
            {
                let two = bodies.get_disjoint_mut([*a as usize, *b as usize]);
                let [a, b] = two.expect("two bodies");
                if rules.wants(a.vertex, b.vertex) {
                    a.beside_body(b, [way(a.given), way(b.given)]);
                }
            }
        }
    }
}

/// The axis along which boxes are furthest apart, by their sizes.
fn axis_of(boxes: &[(Aabb<f32>, u32)]) -> usize {
    let all = boxes.iter().fold(Aabb::EMPTY, |all, of| all.union(&of.0));
    let room = |k: usize| {
        let side = |of: &Aabb<f32>| of.max[k] as f64 - of.min[k] as f64;
        // None where all are flat and in one plane, which parts nothing.
        (side(&all) / boxes.iter().map(|of| side(&of.0)).sum::<f64>()).max(0.0)
    };
    [1, 2].into_iter().fold(0, |best, k| if room(k) > room(best) { k } else { best })
}
