//! Pairs of nearest nodes, bottom up: on every level the first node that is free is joined with the
//! nearest of the others that are [Tian and Wan].
//!
//! ```text
//! level 0   a  b  c  d  e      a's nearest is d:   a d | b c e     they change places,
//!           a  d  c  b  e      c's nearest is e:   a d | c e | b   and so on; b is left over
//! level 1   ad    ce    b
//! ```
//!
//! Only the distances to one target and the search for the least of them are parallel; targets
//! come one after the other. Cost: `n^2 / 4` distances on the first level, a quarter of that on the
//! next, so `n^2 / 3`: a second for 45,000 boxes on one thread, and a search takes so little that
//! more threads do not help much. Nodes that are paired last on a level are far from each other,
//! and such a pair stays near the root for the rest. The tree is `log2 n` deep. When to choose it:
//! to learn from it; [`super::ploc`] does the same among neighbours along a curve, all at once, and
//! gives the better tree in a hundredth of the time; figures are in benches/NOTES.md.
//!
//! Whoever wants more boxes than [`Builder::NEAREST_PAIR`] allows says so by its limit.

use super::TreeBuilder;
use super::bottom_up::{Joins, Subtree};
use crate::broad_phase::morton_order::MortonOrder;
use crate::threads::{Own, Threads};
use ccd_core::backend::broad_phase::nearest_pair::{
    Found, beginning, centre, distance, nearer, parents,
};
use ccd_core::backend::layout::Branch;
use ccd_core::model::method::Builder;
use ccd_core::{Aabb, Error};

/// Nodes that a thread must have to look at before it pays.
const MIN_PART: usize = 8192;

/// Pairs up to so many boxes; buffers are kept.
#[derive(Debug, Default)]
pub struct NearestPair {
    limit: u32,
    joins: Joins,
    level: Level,
    next: Level,
    found: Vec<Own<Found>>,
}

/// The nodes of a level.
#[derive(Debug, Default)]
struct Level {
    boxes: Vec<Aabb<f32>>,
    centres: Vec<[f32; 3]>,
    subtrees: Vec<Subtree>,
}

impl NearestPair {
    /// For at most `limit` boxes.
    pub fn new(limit: u32) -> Self {
        Self { limit, ..Self::default() }
    }

    /// Puts the nodes of the level in pairs; the last is alone if their number is odd.
    fn pair(&mut self, threads: &Threads) {
        let Self { level, found, .. } = self;
        let n = level.boxes.len();
        for target in (0..n).step_by(2) {
            let partner = nearest(threads, target, &level.centres, found);
            if target + 1 < n {
                level.boxes.swap(target + 1, partner);
                level.centres.swap(target + 1, partner);
                level.subtrees.swap(target + 1, partner);
            }
        }
    }
}

/// The nearest of the nodes after `target`.
fn nearest(
    threads: &Threads,
    target: usize,
    centres: &[[f32; 3]],
    found: &mut Vec<Own<Found>>,
) -> usize {
    let (centre, first, n) = (centres[target], target + 1, centres.len());
    let none = beginning(first as u32);
    let search = |range: std::ops::Range<usize>| {
        range.fold(none, |best, i| nearer(best, (distance(centre, centres[i]), i as u32)))
    };
    let n_parts = threads.count().min((n - first) / MIN_PART).max(1);
    let part = (n - first).div_ceil(n_parts);
    let range = |k: usize| (first + k * part).min(n)..(first + (k + 1) * part).min(n);
    if n_parts == 1 {
        return search(range(0)).1 as usize;
    }
    found.resize_with(n_parts, Own::default);
    threads.each(found, &|k, Own(found)| *found = search(range(k)));
    found.iter().fold(none, |best, &Own(other)| nearer(best, other)).1 as usize
}

impl TreeBuilder for NearestPair {
    fn check(&self, n: usize) -> Result<(), Error> {
        Builder::NearestPair { limit: self.limit }.check(n as u64)
    }

    fn build(
        &mut self,
        threads: &Threads,
        morton: &mut MortonOrder,
        boxes: &[Aabb<f32>],
        order: &mut Vec<u32>,
        branches: &mut Vec<Branch>,
    ) {
        let n = boxes.len();
        self.joins.begin(n);
        if n < 2 {
            order.clear();
            order.extend(0..n as u32);
            branches.clear();
            return;
        }
        let grid = morton.grid(threads, boxes);
        self.level.boxes.resize(n, Aabb::EMPTY);
        threads.fill(&mut self.level.boxes, |i| grid.in_cells(&boxes[i]));
        self.level.subtrees.clear();
        self.level.subtrees.extend((0..n).map(|i| self.joins.leaf(i)));
        let mut made = 0;
        while self.level.boxes.len() > 1 {
            let n = self.level.boxes.len();
            self.level.centres.resize(n, [0.0; 3]);
            threads.fill(&mut self.level.centres, |i| centre(&self.level.boxes[i]));
            self.pair(threads);
            let Self { joins, level, next, .. } = self;
            next.boxes.resize(parents(n), Aabb::EMPTY);
            threads.fill(&mut next.boxes, |i| match level.boxes[2 * i..].get(..2) {
                Some([a, b]) => a.union(b),
                _ => level.boxes[2 * i],
            });
            next.subtrees.resize(parents(n), Subtree::default());
            threads.fill(&mut next.subtrees, |i| match level.subtrees[2 * i..].get(..2) {
                Some(&[a, b]) => joins.join(made + i as u32, a, b),
                _ => level.subtrees[2 * i],
            });
            made += n as u32 / 2;
            std::mem::swap(level, next);
        }
        let root = self.level.subtrees[0].node;
        self.joins.finish(threads, root, |i| i as u32, order, branches);
    }
}
