//! The broad phase alone: boxes in, overlapping pairs out.

pub mod block_bvh;
mod morton_order;
pub mod pair_descent;
pub mod pair_list;
mod radix_tree;

use crate::simd::RowSimd;
use crate::threads::Threads;
use block_bvh::{BlockBvh, lane_ids};
use ccd_core::layout::Pair;
use ccd_core::math::aabb::Boxes;
use ccd_core::model::error::check_boxes;
use ccd_core::model::method::BroadPhaseMethod;
use ccd_core::model::precision::{Precision, Slices};
use ccd_core::{Aabb, Coordinate, Error, Real};
use pair_descent::{PairDescent, Rows, keep};
use pair_list::{Lister, Pairs, Run, order_runs};
use radix_tree::RadixTree;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

/// Finds overlapping boxes; keeps its buffers between calls.
///
/// Overlap is closed: boxes that touch are a pair. Boxes are compared as they are, not as their
/// roundings in `f32`; infinite bounds too: infinity touches infinity and nothing else.
/// The order of pairs depends on the boxes and the method, not on the number of threads.
#[derive(Debug)]
pub struct BroadPhase {
    threads: Threads,
    method: BroadPhaseMethod,
    a: Side,
    b: Side,
    traversal: PairDescent,
    tree: RadixTree,
    workers: Vec<Lister>,
    runs: Vec<Run>,
}

/// One set of boxes.
#[derive(Debug, Default)]
struct Side {
    boxes: Vec<Aabb<f32>>,
    bvh: BlockBvh,
}

impl BroadPhase {
    /// With `threads` threads: 0 for those of rayon's current pool, 1 for the calling one alone.
    pub fn new(threads: usize, method: BroadPhaseMethod) -> Result<Self, Error> {
        Ok(Self {
            threads: Threads::new(threads)?,
            method,
            a: Side::default(),
            b: Side::default(),
            traversal: PairDescent::default(),
            tree: RadixTree::default(),
            workers: Vec::new(),
            runs: Vec::new(),
        })
    }

    /// Number of threads in use.
    pub fn threads(&self) -> usize {
        self.threads.count()
    }

    /// Pairs within one set, each once, lesser index first.
    pub fn self_pairs<T: Coordinate>(&mut self, boxes: &[Aabb<T>]) -> Result<Pairs<'_>, Error> {
        self.within(T::slices::<Boxes, 1>([boxes]))?;
        Ok(Pairs::new(&self.runs, &self.workers))
    }

    /// Pairs of a box of `a` with a box of `b`.
    pub fn pairs<T: Coordinate>(&mut self, a: &[Aabb<T>], b: &[Aabb<T>]) -> Result<Pairs<'_>, Error> {
        self.between(T::slices::<Boxes, 2>([a, b]))?;
        Ok(Pairs::new(&self.runs, &self.workers))
    }

    #[inline(never)]
    fn within(&mut self, boxes: Slices<Boxes, 1>) -> Result<(), Error> {
        let exact = match boxes {
            Precision::F32([boxes]) => self.a.take(&self.threads, boxes),
            Precision::F64([boxes]) => self.a.take(&self.threads, boxes),
        }?;
        let overlap = |i: u32, j: u32| match boxes {
            Precision::F32([boxes]) => boxes[i as usize].overlaps(&boxes[j as usize]),
            Precision::F64([boxes]) => boxes[i as usize].overlaps(&boxes[j as usize]),
        };
        let confirm: Option<Confirm> = if exact { None } else { Some(&overlap) };
        let Self { threads, method, a, traversal, tree, workers, runs, .. } = self;
        threads.enter(|| {
            match *method {
                BroadPhaseMethod::Blocks => {
                    a.bvh.build(threads, &a.boxes, None);
                    let slack = slack(&a.boxes, &a.boxes);
                    let rows = Listing::<true> { a: &a.bvh, b: &a.bvh, slack, confirm };
                    list(threads, traversal, &rows, workers);
                }
                BroadPhaseMethod::Tree => {
                    let out = only_list(workers);
                    tree.self_pairs(threads, &a.boxes, out);
                    keep_confirmed(out, confirm);
                }
                other => return Err(Error::Method { name: other.row().name, backend: "cpu" }),
            }
            order_runs(workers, runs);
            Ok(())
        })
    }

    #[inline(never)]
    fn between(&mut self, boxes: Slices<Boxes, 2>) -> Result<(), Error> {
        let Self { threads, method, a, b, traversal, tree, workers, runs } = self;
        let exact = match boxes {
            Precision::F32([x, y]) => a.take(threads, x)? & b.take(threads, y)?,
            Precision::F64([x, y]) => a.take(threads, x)? & b.take(threads, y)?,
        };
        let overlap = |i: u32, j: u32| match boxes {
            Precision::F32([a, b]) => a[i as usize].overlaps(&b[j as usize]),
            Precision::F64([a, b]) => a[i as usize].overlaps(&b[j as usize]),
        };
        let confirm: Option<Confirm> = if exact { None } else { Some(&overlap) };
        threads.enter(|| {
            match *method {
                BroadPhaseMethod::Blocks => {
                    a.bvh.build(threads, &a.boxes, None);
                    b.bvh.build(threads, &b.boxes, None);
                    let height = a.bvh.height().max(b.bvh.height());
                    a.bvh.raise(height);
                    b.bvh.raise(height);
                    let slack = slack(&a.boxes, &b.boxes);
                    let rows = Listing::<false> { a: &a.bvh, b: &b.bvh, slack, confirm };
                    list(threads, traversal, &rows, workers);
                }
                BroadPhaseMethod::Tree => {
                    let out = only_list(workers);
                    tree.pairs(threads, &a.boxes, &b.boxes, out);
                    keep_confirmed(out, confirm);
                }
                other => return Err(Error::Method { name: other.row().name, backend: "cpu" }),
            }
            order_runs(workers, runs);
            Ok(())
        })
    }
}

/// Whether two boxes overlap as they were given; asked where rounding may have made it so.
type Confirm<'a> = &'a (dyn Fn(u32, u32) -> bool + Sync);

fn keep_confirmed(pairs: &mut Vec<Pair>, confirm: Option<Confirm>) {
    if let Some(confirm) = confirm {
        pairs.retain(|p| confirm(p.a, p.b));
    }
}

/// Lists all pairs: within one set if its pairs are ordered, else of one set with another.
fn list<const WITHIN: bool>(threads: &Threads, traversal: &mut PairDescent, rows: &Listing<WITHIN>, workers: &mut Vec<Lister>) {
    workers.resize_with(threads.count(), Lister::default);
    workers.iter_mut().for_each(Lister::clear);
    traversal.run(threads, (rows.a, (!WITHIN).then_some(rows.b)), 1, rows, workers);
}

struct Listing<'a, const WITHIN: bool> {
    a: &'a BlockBvh,
    b: &'a BlockBvh,
    slack: f32,
    confirm: Option<Confirm<'a>>,
}

impl<const WITHIN: bool> Rows for Listing<'_, WITHIN> {
    type Worker = Lister;

    #[inline(always)]
    fn row<S: RowSimd>(&self, lister: &mut Lister, simd: S, a: usize, lane: usize, b: usize, mut mask: u32) {
        let id = self.a.order()[a * 8 + lane];
        let ids = lane_ids(self.b.order(), b);
        if let Some(confirm) = self.confirm {
            let (block_a, block_b) = (&self.a.level(0)[a], &self.b.level(0)[b]);
            let sure = simd.overlaps_surely(block_a, lane, block_b, self.slack);
            mask = mask & sure | keep(mask & !sure, |j| confirm(id, ids[j]));
        }
        simd.append::<WITHIN>(&mut lister.pairs, id, &ids, mask);
    }

    fn begin(&self, lister: &mut Lister, task: usize) {
        lister.begin(task);
    }
}

/// Empties all lists and returns that of the first worker, as one segment.
fn only_list(workers: &mut Vec<Lister>) -> &mut Vec<Pair> {
    workers.resize_with(1, Lister::default);
    let lister = &mut workers[0];
    lister.clear();
    lister.begin(0);
    &mut lister.pairs
}

impl Side {
    /// Takes boxes, rounded outward; whether that changed none of them. Bounds beyond the greatest
    /// of a rounded box change in `f32` too.
    fn take<T: Real>(&mut self, threads: &Threads, boxes: &[Aabb<T>]) -> Result<bool, Error> {
        check_boxes(boxes, f64::INFINITY)?;
        self.boxes.resize(boxes.len(), Aabb::EMPTY);
        let exact = AtomicBool::new(true);
        let rounded = |i: usize| {
            let (b, r) = (&boxes[i], boxes[i].round_out());
            let same = |r: f32, b: T| r as f64 == b.to_f64();
            if !(0..3).all(|k| same(r.min[k], b.min[k]) && same(r.max[k], b.max[k])) {
                exact.store(false, Relaxed);
            }
            r
        };
        threads.enter(|| threads.fill(&mut self.boxes, rounded));
        Ok(exact.into_inner())
    }
}

/// Twice the spacing of `f32` at the greatest coordinate: outward rounding moves two bounds by less
/// than that together. Bounds that were cut to the greatest of a rounded box are equal, so that
/// pairs which overlap only there overlap by nothing; a bound that was not cut compares with them
/// as with what they were.
fn slack(a: &[Aabb<f32>], b: &[Aabb<f32>]) -> f32 {
    let greatest = |boxes: &[Aabb<f32>]| {
        boxes.iter().fold(0f32, |m, b| m.max(ccd_core::math::vec3::max_abs(b.min)).max(ccd_core::math::vec3::max_abs(b.max)))
    };
    ccd_core::model::quantization::slack_at(greatest(a).max(greatest(b)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bounds at and beyond the greatest that a rounded box has, and ordinary ones.
    const BOUNDS: [f32; 13] =
        [f32::NEG_INFINITY, f32::MIN, -3.2e38, -2.95e38, -2.9e38, -1.0, 0.0, 1.0, 2.9e38, 2.95e38, 3.2e38, f32::MAX, f32::INFINITY];

    /// Pairs by both methods are those of brute force, in the precision of the boxes.
    fn check_pairs<T: Coordinate>(a: &[Aabb<T>], b: &[Aabb<T>]) {
        let all = |n: usize, m: usize| (0..n).flat_map(move |i| (0..m).map(move |j| (i, j)));
        let pair = |(i, j): (usize, usize)| Pair { a: i as u32, b: j as u32 };
        let n = a.len();
        let within: Vec<Pair> = all(n, n).filter(|&(i, j)| i < j && a[i].overlaps(&a[j])).map(pair).collect();
        let between: Vec<Pair> = all(n, b.len()).filter(|&(i, j)| a[i].overlaps(&b[j])).map(pair).collect();
        assert!(!within.is_empty() && within.len() < n * (n - 1) / 2, "all or none overlap");
        let sorted = |pairs: Pairs| {
            let mut pairs = pairs.to_vec();
            pairs.sort_unstable_by_key(|p| (p.a, p.b));
            pairs
        };
        for method in [BroadPhaseMethod::Blocks, BroadPhaseMethod::Tree] {
            let mut broad = BroadPhase::new(1, method).unwrap();
            let got = sorted(broad.self_pairs(a).unwrap());
            assert_eq!(got, within, "{method:?}, within {a:?}");
            let got = sorted(broad.pairs(a, b).unwrap());
            assert_eq!(got, between, "{method:?}, {a:?} against {b:?}");
        }
    }

    #[test]
    fn huge_and_infinite_bounds_are_compared_as_they_are() {
        let apart =
            [(2.95e38f32, 3.0e38), (3.2e38, 3.3e38), (0.0, 3.1e38)].map(|(min, max)| Aabb { min: [min, 0.0, 0.0], max: [max, 1.0, 1.0] });
        check_pairs(&apart, &apart);
        let mut x = 11u32;
        let mut bound = || {
            x = x.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            (x >> 16) as usize % BOUNDS.len()
        };
        for n in [3usize, 8, 40] {
            for _ in 0..20 {
                let mut side = || (bound(), bound());
                let mut one = || {
                    let sides: [_; 3] = std::array::from_fn(|_| side());
                    Aabb { min: sides.map(|(p, q)| BOUNDS[p.min(q)]), max: sides.map(|(p, q)| BOUNDS[p.max(q)]) }
                };
                // The first two are apart, the third and the fourth overlap.
                let mut boxes = vec![apart[0], apart[1], apart[2], apart[2]];
                boxes.extend((0..n).map(|_| one()));
                let others: Vec<_> = (0..n).map(|_| one()).collect();
                check_pairs(&boxes, &others);
                let wide = |b: &Aabb<f32>| Aabb { min: b.min.map(f64::from), max: b.max.map(f64::from) };
                let far = |b: &Aabb<f32>| {
                    let wide = wide(b);
                    Aabb { min: wide.min.map(|x| x * 1e60), max: wide.max.map(|x| x * 1e60) }
                };
                for to_f64 in [&wide as &dyn Fn(&Aabb<f32>) -> Aabb<f64>, &far] {
                    let all = |boxes: &[Aabb<f32>]| boxes.iter().map(to_f64).collect::<Vec<_>>();
                    check_pairs(&all(&boxes), &all(&others));
                }
            }
        }
    }
}
