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
//! come one after the other. A leader goes through them; for each, whoever is free takes chunks of
//! the nodes that are left, the leader too, so that it waits for nobody who has not begun. Eight
//! distances are found at once, which takes a thread a microsecond for 8,192 nodes: of fewer than
//! twice as many it finds the nearest alone.
//!
//! Cost: `n^2 / 4` distances on the first level, a quarter of that on the next, so `n^2 / 3`. Nodes
//! that are paired last on a level are far from each other, and such a pair stays near the root for
//! the rest. The tree is `log2 n` deep. When to choose it: to learn from it; [`super::ploc`] does
//! the same among neighbours along a curve, all at once, and gives the better tree in a hundredth
//! of the time; figures are in benches/NOTES.md.
//!
//! Whoever wants more boxes than [`Builder::NEAREST_PAIR`] allows says so by its limit.

use super::TreeBuilder;
use super::bottom_up::{Joins, Subtree};
use crate::broad_phase::curve_order::CurveOrder;
use crate::simd::{F32x8, RowSimd, WIDTH, Work};
use crate::threads::Threads;
use ccd_core::backend::broad_phase::nearest_pair::{centre, distance, parents};
use ccd_core::backend::layout::Branch;
use ccd_core::model::method::Builder;
use ccd_core::{Aabb, Error, Num};
use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering::*};
use std::sync::{Mutex, PoisonError, RwLock};

/// Blocks that are searched together; only the nearest of such a stretch is looked for again.
const STRETCH: usize = 16;
/// Blocks that a thread takes at a time, at least: fewer take less time than to share them out.
const MIN_CHUNK: usize = 1024;
/// A centre that is farther from all than any other: that of a node in a pair.
const AWAY: f32 = 1e30;

/// Pairs up to so many boxes; buffers are kept.
#[derive(Debug, Default)]
pub struct NearestPair {
    limit: u32,
    joins: Joins,
    level: Level,
    next: Level,
    centres: RwLock<Centres>,
}

/// The nodes of a level.
#[derive(Debug, Default)]
struct Level {
    boxes: Vec<Aabb<f32>>,
    subtrees: Vec<Subtree>,
}

/// Centres of the nodes of a level, eight side by side, and where the nearest one is looked for.
#[derive(Debug, Default)]
struct Centres {
    blocks: Vec<[F32x8; 3]>,
    target: [f32; 3],
    /// The first block, and how many a chunk has.
    first: usize,
    chunk: usize,
}

impl Centres {
    fn get(&self, i: usize) -> [f32; 3] {
        self.blocks[i / WIDTH].map(|lanes| lanes.0[i % WIDTH])
    }

    fn set(&mut self, i: usize, centre: [f32; 3]) {
        for k in 0..3 {
            self.blocks[i / WIDTH][k].0[i % WIDTH] = centre[k];
        }
    }

    /// The node of some blocks that is nearest to the target, as a key that is the smaller the
    /// nearer it is and, of equally near ones, the earlier; the greatest key of no blocks.
    fn nearest(&self, blocks: Range<usize>) -> u64 {
        let first = blocks.start;
        let search = Search { blocks: &self.blocks[blocks], target: self.target };
        let (stretch, least): (usize, f32) = crate::simd::run_rows!(search);
        let from = (first + stretch * STRETCH) * WIDTH;
        let nodes = from..(from + STRETCH * WIDTH).min(self.blocks.len() * WIDTH);
        let at = nodes.into_iter().find(|&i| distance(self.get(i), self.target) == least);
        at.map_or(u64::MAX, |i| (least.to_bits() as u64) << 32 | i as u64)
    }
}

/// The first stretch with the least distance, and that distance.
struct Search<'a> {
    blocks: &'a [[F32x8; 3]],
    target: [f32; 3],
}

impl<S: RowSimd> Work<S> for Search<'_> {
    type Out = (usize, f32);

    #[inline(always)]
    fn call(self, simd: S) -> (usize, f32) {
        let target = self.target.map(S::Lanes::splat);
        let mut best = (0, f32::INFINITY);
        for (k, stretch) in self.blocks.chunks(STRETCH).enumerate() {
            let mut least = S::Lanes::splat(f32::INFINITY);
            for [x, y, z] in stretch {
                let (x, y, z) =
                    (simd.load(x) - target[0], simd.load(y) - target[1], simd.load(z) - target[2]);
                least = least.min(x * x + y * y + z * z);
            }
            let least = simd.store(least).0.into_iter().fold(f32::INFINITY, f32::min);
            if least < best.1 {
                best = (k, least);
            }
        }
        best
    }
}

impl NearestPair {
    /// For at most `limit` boxes.
    pub fn new(limit: u32) -> Self {
        Self { limit, ..Self::default() }
    }

    /// Puts the nodes of the level in pairs; the last is alone if their number is odd.
    fn pair(&mut self, threads: &Threads) {
        let Self { level, centres, .. } = self;
        let n = level.boxes.len();
        let all = centres.get_mut().unwrap_or_else(PoisonError::into_inner);
        all.blocks.clear();
        all.blocks.resize(n.div_ceil(WIDTH), [F32x8([AWAY; WIDTH]); 3]);
        (0..n).for_each(|i| all.set(i, centre(&level.boxes[i])));
        let n_threads = threads.count().min(all.blocks.len() / MIN_CHUNK).max(1);
        let search = SharedSearch {
            centres,
            n_threads,
            chunks: AtomicU64::new(0),
            done: AtomicUsize::new(0),
            best: AtomicU64::new(0),
            over: AtomicBool::new(false),
        };
        let leads = Mutex::new(Some(level));
        threads.each(&mut vec![(); n_threads], &|_, ()| {
            // Whoever comes first.
            let level = leads.lock().unwrap_or_else(PoisonError::into_inner).take();
            match level {
                Some(level) => search.lead(level),
                None => search.help(),
            }
        });
    }
}

/// One search after the other, by all threads.
struct SharedSearch<'a> {
    centres: &'a RwLock<Centres>,
    n_threads: usize,
    /// Which search this is, in the upper half, and how many of its chunks nobody has taken.
    chunks: AtomicU64,
    /// Chunks that have been searched.
    done: AtomicUsize,
    best: AtomicU64,
    /// Whether there will be no other search.
    over: AtomicBool,
}

impl SharedSearch<'_> {
    /// Takes a chunk of the present search and searches it; whether there was one.
    fn chunk(&self) -> bool {
        let chunks = self.chunks.load(Acquire);
        let left = chunks as u32 as usize;
        if left == 0 {
            return false;
        }
        // A search does not end before its chunks are done: what is taken is of this one.
        if self.chunks.compare_exchange(chunks, chunks - 1, AcqRel, Relaxed).is_ok() {
            let centres = self.centres.read().unwrap_or_else(PoisonError::into_inner);
            let first = centres.first + (left - 1) * centres.chunk;
            let blocks = first..(first + centres.chunk).min(centres.blocks.len());
            self.best.fetch_min(centres.nearest(blocks), Relaxed);
            drop(centres);
            self.done.fetch_add(1, Release);
        }
        true
    }

    fn help(&self) {
        while !self.over.load(Acquire) {
            wait_until(|| self.chunk() || self.over.load(Acquire));
        }
    }

    fn lead(&self, level: &mut Level) {
        /// Lets the others go, also when something is wrong.
        struct Over<'a>(&'a AtomicBool);
        impl Drop for Over<'_> {
            fn drop(&mut self) {
                self.0.store(true, Release);
            }
        }
        let _over = Over(&self.over);
        let n = level.boxes.len();
        for target in (0..n - n % 2).step_by(2) {
            let mut centres = self.centres.write().unwrap_or_else(PoisonError::into_inner);
            centres.target = centres.get(target);
            centres.set(target, [AWAY; 3]);
            centres.first = (target + 1) / WIDTH;
            let left = centres.blocks.len() - centres.first;
            centres.chunk = left.div_ceil(self.n_threads).max(MIN_CHUNK);
            let n_chunks = left.div_ceil(centres.chunk);
            let best = if n_chunks == 1 || self.n_threads == 1 {
                centres.nearest(centres.first..centres.blocks.len())
            } else {
                drop(centres);
                self.best.store(u64::MAX, Relaxed);
                self.done.store(0, Relaxed);
                self.chunks.store((target as u64) << 32 | n_chunks as u64, Release);
                while self.chunk() {}
                wait_until(|| self.done.load(Acquire) == n_chunks);
                centres = self.centres.write().unwrap_or_else(PoisonError::into_inner);
                self.best.load(Relaxed)
            };
            let partner = best as u32 as usize;
            level.boxes.swap(target + 1, partner);
            level.subtrees.swap(target + 1, partner);
            let moved = centres.get(target + 1);
            centres.set(partner, moved);
            centres.set(target + 1, [AWAY; 3]);
        }
    }
}

/// Turns for which a thread waits before it lets others run: longer than a search takes, because
/// to ask the system costs more than one.
const PATIENCE: u32 = 1 << 13;

/// Waits until something is so.
fn wait_until(mut is_so: impl FnMut() -> bool) {
    let mut turns = 0;
    while !is_so() {
        std::hint::spin_loop();
        turns += 1;
        if turns == PATIENCE {
            turns = 0;
            std::thread::yield_now();
        }
    }
}

impl TreeBuilder for NearestPair {
    fn check(&self, n: usize) -> Result<(), Error> {
        Builder::NearestPair { limit: self.limit }.check(n as u64)
    }

    fn build(
        &mut self,
        threads: &Threads,
        morton: &mut CurveOrder,
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

#[cfg(test)]
mod tests {
    use super::*;
    use ccd_core::backend::broad_phase::nearest_pair::{beginning, nearer};

    /// Nodes that say where they began, in the order in which they are paired.
    fn paired(threads: usize, boxes: &[Aabb<f32>]) -> Vec<u32> {
        let mut pairs = NearestPair::new(u32::MAX);
        pairs.level.boxes = boxes.to_vec();
        let leaf = |i| Subtree { node: i, leaves: 1 };
        pairs.level.subtrees = (0..boxes.len() as u32).map(leaf).collect();
        let threads = Threads::new(threads).unwrap();
        threads.enter(|| pairs.pair(&threads));
        for (b, subtree) in pairs.level.boxes.iter().zip(&pairs.level.subtrees) {
            assert_eq!(*b, boxes[subtree.node as usize]);
        }
        pairs.level.subtrees.iter().map(|subtree| subtree.node).collect()
    }

    /// By the rule alone, a distance after the other.
    fn by_the_rule(boxes: &[Aabb<f32>]) -> Vec<u32> {
        let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
        let n = boxes.len();
        for target in (0..n - n % 2).step_by(2) {
            let of = |i: usize| centre(&boxes[order[i] as usize]);
            let found = (target + 1..n).fold(beginning(target as u32 + 1), |best, i| {
                nearer(best, (distance(of(target), of(i)), i as u32))
            });
            order.swap(target + 1, found.1 as usize);
        }
        order
    }

    #[test]
    fn any_number_of_threads_pairs_the_same_nodes() {
        /// Of a chunk.
        const NODES: usize = MIN_CHUNK * WIDTH;
        // On a lattice, so that many are equally near.
        let place = |i: u32, k: u32| (i.wrapping_mul(2_654_435_769 + 2 * k) >> 16) % 12;
        let point = |i| Aabb::of_point([0, 1, 2].map(|k| place(i, k * 77) as f32));
        let boxes: Vec<_> = (0..5 * NODES as u32 + 77).map(point).collect();
        for n in [1, 2, 3, 9, 130, NODES, 2 * NODES + 1, boxes.len()] {
            let want = by_the_rule(&boxes[..n]);
            for threads in [1, 2, 3] {
                assert!(paired(threads, &boxes[..n]) == want, "{n} nodes, {threads} threads");
            }
        }
    }
}
