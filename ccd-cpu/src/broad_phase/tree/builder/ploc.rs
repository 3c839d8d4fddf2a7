//! PLOC: clusters of boxes along the Morton curve join their nearest neighbours, all at once, round
//! after round [Meister 2018].
//!
//! ```text
//! along the curve   a b c d e f g        each looks `radius` to either side for the neighbour with
//! nearest           b a b e d g f        which its common box has the least surface
//! joined            ab  c  de  fg        who is each other's nearest is joined, and takes the
//! next round        ab  c  de  fg        place of the first; the others wait
//! ```
//!
//! Cost: the sort, then `2 radius + 1` boxes looked at per cluster and round; there are some five
//! to seven times as many clusters in all rounds together as boxes. What is joined in a round, and
//! how many rounds there may be, is in [`ccd_core::backend::broad_phase::ploc`]. When to choose it:
//! where one tree serves so many queries or refits that fewer visited nodes pay for the build,
//! which takes several times that of [`super::lbvh`]; figures are in benches/NOTES.md.

use super::TreeBuilder;
use super::bottom_up::{Joins, Subtree};
use super::ploc_search::{Search, fill_boxes};
use crate::broad_phase::curve_order::CurveOrder;
use crate::broad_phase::marks::Marks;
use crate::broad_phase::tree::shared_words::Shared;
use crate::simd::{Block, WIDTH, get_lane};
use crate::threads::Threads;
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::ploc::{Fate, fate, is_late, neighbour};
use ccd_core::backend::kernel::Words;
use ccd_core::backend::layout::Branch;
use std::sync::atomic::AtomicU32;

/// Clusters that a task counts and moves.
const CHUNK: usize = 2048;

/// Joins among so many neighbours to either side; buffers are kept.
#[derive(Debug, Default)]
pub struct Ploc {
    radius: u32,
    joins: Joins,
    /// Ids along the curve.
    along: Vec<u32>,
    clusters: Clusters,
    next: Clusters,
    neighbours: Vec<u32>,
    /// Of every chunk: how many clusters are left of it; then where those go.
    counts: Vec<usize>,
    /// From the clusters of the next round to those of this one.
    sources: Vec<AtomicU32>,
}

/// The clusters of a round, in order.
#[derive(Debug, Default)]
struct Clusters {
    boxes: Vec<Block>,
    named: Vec<Named>,
}

/// A cluster as part of the tree, and the name that no other has.
#[derive(Clone, Copy, Debug, Default)]
struct Named {
    subtree: Subtree,
    name: u32,
}

impl Ploc {
    /// With this radius, at least 1.
    pub fn new(radius: u32) -> Self {
        Self { radius, ..Self::default() }
    }

    /// Decides who is joined with whom in a round over `n_leaves`; returns how many clusters are
    /// left.
    fn choose(&mut self, threads: &Threads, round: u32, n_leaves: usize) -> usize {
        let (boxes, radius) = (&self.clusters.boxes, self.radius);
        let n = self.clusters.named.len();
        self.neighbours.resize(n, 0);
        if is_late(round, n as u32, n_leaves as u32) {
            threads.fill(&mut self.neighbours, |i| neighbour(i as u32, n as u32));
        } else {
            threads.chunks(&mut self.neighbours, &|first, nearest| {
                crate::simd::run_rows!(Search { boxes, n, radius, first, nearest })
            });
        }
        self.count(threads)
    }

    /// How many clusters are left.
    fn count(&mut self, threads: &Threads) -> usize {
        let Self { neighbours, counts, .. } = self;
        let n = neighbours.len();
        counts.resize(n.div_ceil(CHUNK), 0);
        threads.each(counts, &|k, count| {
            let chunk = k * CHUNK..((k + 1) * CHUNK).min(n);
            *count = chunk.filter(|&i| fate(i as u32, neighbours) != Fate::Ends).count();
        });
        counts.iter().sum()
    }

    /// Joins, and moves those that are left together.
    fn advance(&mut self, threads: &Threads, left: usize) {
        let Self { joins, clusters, next, neighbours, counts, sources, .. } = self;
        let n = neighbours.len();
        let mut begin = 0;
        for count in counts.iter_mut() {
            begin += std::mem::replace(count, begin);
        }
        sources.resize_with(left.max(sources.len()), AtomicU32::default);
        let sources = Shared(sources);
        threads.each(counts, &|k, count| {
            let mut to = *count;
            for i in k * CHUNK..((k + 1) * CHUNK).min(n) {
                if fate(i as u32, neighbours) != Fate::Ends {
                    sources.store(to, i as u32);
                    to += 1;
                }
            }
        });
        let source = |k: usize| {
            let i = sources.load(k);
            let joins = fate(i, neighbours) == Fate::Joins;
            (i as usize, joins.then(|| neighbours[i as usize] as usize))
        };
        let boxed = |i: usize| get_lane(&clusters.boxes[i / WIDTH], i % WIDTH);
        fill_boxes(threads, left, &mut next.boxes, &|k| match source(k) {
            (i, Some(j)) => boxed(i).union(&boxed(j)),
            (i, None) => boxed(i),
        });
        next.named.resize(left, Named::default());
        threads.fill(&mut next.named, |k| match source(k) {
            (i, Some(j)) => {
                let (a, b) = (clusters.named[i], clusters.named[j]);
                Named { subtree: joins.join(b.name - 1, a.subtree, b.subtree), name: a.name }
            }
            (i, None) => clusters.named[i],
        });
        std::mem::swap(clusters, next);
    }
}

impl TreeBuilder for Ploc {
    fn build(
        &mut self,
        threads: &Threads,
        morton: &mut CurveOrder,
        boxes: &[Aabb<f32>],
        order: &mut Vec<u32>,
        branches: &mut Vec<Branch>,
    ) {
        let n = boxes.len();
        let grid = morton.sort(threads, boxes, &Marks::default(), &mut self.along);
        self.joins.begin(n);
        if n < 2 {
            order.clone_from(&self.along);
            branches.clear();
            return;
        }
        let Self { clusters, joins, along, .. } = self;
        let boxed = |i: usize| grid.in_cells(&boxes[along[i] as usize]);
        fill_boxes(threads, n, &mut clusters.boxes, &boxed);
        clusters.named.resize(n, Named::default());
        threads.fill(&mut clusters.named, |i| Named { subtree: joins.leaf(i), name: i as u32 });
        let mut round = 0;
        while self.clusters.named.len() > 1 {
            let left = self.choose(threads, round, n);
            self.advance(threads, left);
            round += 1;
        }
        let Self { clusters, joins, along, .. } = self;
        let root = clusters.named[0].subtree.node;
        joins.finish(threads, root, |i| along[i], order, branches);
    }
}
