//! The broad phase alone: boxes in, overlapping pairs out; and the sources of pairs, which a step
//! has in common with it.
//!
//! A way to find pairs is a [`pair_source::PairSource`]: it orders boxes, keeps what it builds over
//! them, and emits rows of leaves into a [`pair_source::PairSink`]. The sinks are those of a list
//! of boxes (here) and of a step (candidates, with or without the narrow phase behind them).
//!
//! One more method takes
//! - a file here with its source of pairs, behind the feature `catalogue`. One that descends two
//!   hierarchies at once implements `descend::FrontTree` and leaves the rest to `scheduled.rs`,
//!   which runs it by any scheduler; one that makes queries hands them out by [`tasks::Shares`];
//! - an arm of [`method::Method::new`];
//! - a variant in `ccd-core/src/model/method.rs` and a row in `catalogue.rs` beside it.
//!
//! Sessions, the broad phase and the tests of all methods then have it.

pub mod block_bvh;
pub mod block_order;
mod block_pairs;
#[cfg(feature = "catalogue")]
mod block_workers;
#[cfg(feature = "catalogue")]
mod brute_force;
mod curve_order;
#[cfg(feature = "catalogue")]
mod descend;
#[cfg(feature = "catalogue")]
pub mod descent_times;
#[cfg(feature = "catalogue")]
mod front;
pub mod hilbert_code;
pub mod leaf_boxes;
pub mod marks;
pub mod method;
pub mod pair_list;
pub mod pair_source;
mod pair_tree;
mod rows;
pub mod runs;
#[cfg(feature = "catalogue")]
mod scheduled;
#[cfg(feature = "catalogue")]
mod scheduler;
#[cfg(test)]
mod sorted_tests;
#[cfg(feature = "catalogue")]
mod sweep_and_prune;
#[cfg(feature = "catalogue")]
mod sweep_and_tiniest_queue;
#[cfg(feature = "catalogue")]
mod sweep_in_strips;
mod tasks;
#[cfg(test)]
mod tests;
pub mod tree;
#[cfg(feature = "catalogue")]
mod uniform_grid;
mod worlds;

use crate::clock::{Instant, milliseconds};
use crate::simd::{Block, ROOM, RowSimd, WIDTH};
use crate::stop::Stop;
use crate::threads::Threads;
use ccd_core::model::error::check_boxes;
use ccd_core::model::method::BroadPhaseMethod;
use ccd_core::model::precision::{Boxes, Precision};
use ccd_core::model::report::FrontCounts;
use ccd_core::model::scheduling::Scheduling;
use ccd_core::model::tree_statistics::TreeStatistics;
use ccd_core::{Aabb, Coordinate, Error, Real};
use leaf_boxes::{LeafBoxes, Set};
use marks::Marks;
use method::Method;
use pair_list::{Lister, Pairs, Run, order_runs};
use pair_source::{Overlaps, PairSink, PairSource, confirmed_overlaps};
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

/// Finds overlapping boxes; keeps its buffers between calls.
///
/// Overlap is closed: boxes that touch are a pair. Boxes are compared as they are, not as their
/// roundings in `f32`; infinite bounds too: infinity touches infinity and nothing else.
/// The order of pairs depends on the boxes and the method, not on the number of threads.
///
/// ```
/// use ccd::{Aabb, BroadPhase, Pair, method::BroadPhaseMethod};
///
/// let at = |x: f32| Aabb { min: [x, 0.0, 0.0], max: [x + 1.0, 1.0, 1.0] };
/// let mut broad_phase = BroadPhase::new(1, BroadPhaseMethod::default())?;
/// let pairs = broad_phase.self_pairs(&[at(0.0), at(5.0), at(0.5)])?;
/// assert_eq!(pairs.to_vec(), [Pair { a: 0, b: 2 }]);
/// # Ok::<(), ccd::Error>(())
/// ```
#[derive(Debug)]
pub struct BroadPhase {
    threads: Threads,
    method: Method,
    /// The first of two sets.
    a: Side,
    /// The second of two sets, or the only one.
    b: Side,
    workers: Vec<Lister>,
    runs: Vec<Run>,
    times: BroadPhaseTimes,
}

/// Milliseconds of a search by the clock.
///
/// ```
/// use ccd::{Aabb, BroadPhase, method::BroadPhaseMethod};
///
/// let mut broad_phase = BroadPhase::new(1, BroadPhaseMethod::default())?;
/// broad_phase.self_pairs(&[Aabb { min: [0.0f32; 3], max: [1.0; 3] }; 100])?;
/// let times = broad_phase.times();
/// assert!(times.build > 0.0 && times.search > 0.0);
/// # Ok::<(), ccd::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BroadPhaseTimes {
    /// Boxes checked and put in order, and what is built over them.
    pub build: f64,
    /// Pairs found.
    pub search: f64,
}

/// One set of boxes.
#[derive(Debug)]
struct Side {
    boxes: Vec<Aabb<f32>>,
    leaves: LeafBoxes,
}

impl BroadPhase {
    /// With `threads` threads: 0 for those of rayon's current pool, 1 for the calling one alone.
    ///
    /// # Errors
    /// Those of [`BroadPhase::scheduled`].
    pub fn new(threads: usize, method: BroadPhaseMethod) -> Result<Self, Error> {
        Self::scheduled(threads, method, Scheduling::default())
    }

    /// The same with work shared out in a way of its own. Boxes are new in every call, so that a
    /// front is made, and none is ever begun with.
    ///
    /// # Errors
    /// [`Error::Method`], [`Error::Setting`] and [`Error::NoPairsOfNodes`] for the method and its
    /// scheduling; [`Error::Threads`].
    pub fn scheduled(
        threads: usize,
        method: BroadPhaseMethod,
        scheduling: Scheduling,
    ) -> Result<Self, Error> {
        Ok(Self {
            threads: Threads::new(threads)?,
            method: Method::new(method, scheduling)?,
            a: Side::new(Set { index: 0, searched: false }),
            b: Side::new(Set { index: 1, searched: true }),
            workers: Vec::new(),
            runs: Vec::new(),
            times: BroadPhaseTimes::default(),
        })
    }

    /// How long the last search took.
    pub fn times(&self) -> BroadPhaseTimes {
        self.times
    }

    /// Number of threads in use.
    pub fn threads(&self) -> usize {
        self.threads.count()
    }

    /// Pairs within one set, each once, lesser index first.
    ///
    /// # Errors
    /// [`Error::Box`]; [`Error::TooMany`] where the method has such a limit.
    pub fn self_pairs<T: Coordinate>(&mut self, boxes: &[Aabb<T>]) -> Result<Pairs<'_>, Error> {
        self.search::<true>(T::erase::<Boxes<2>>([boxes; 2]))?;
        Ok(Pairs::new(&self.runs, &self.workers))
    }

    /// Pairs of a box of `a` with a box of `b`.
    ///
    /// # Errors
    /// [`Error::Box`]; [`Error::TooMany`] where the method has such a limit.
    pub fn pairs<T: Coordinate>(
        &mut self,
        a: &[Aabb<T>],
        b: &[Aabb<T>],
    ) -> Result<Pairs<'_>, Error> {
        self.search::<false>(T::erase::<Boxes<2>>([a, b]))?;
        Ok(Pairs::new(&self.runs, &self.workers))
    }

    /// How many nodes the last search visited, for comparisons of traversals: internal nodes of a
    /// binary tree that queries looked at, or pairs of nodes that were expanded, and of a cut the
    /// pairs from which it began. The same on any number of threads; 0 by a method without a binary
    /// tree.
    pub fn visits(&self) -> u64 {
        self.method.visits()
    }

    /// Fronts of the last call, if they are kept.
    pub fn front(&self) -> Option<FrontCounts> {
        self.method.front()
    }

    /// Figures of the binary tree of the last call: over the boxes of [`BroadPhase::self_pairs`],
    /// or the second set of [`BroadPhase::pairs`]. `None` before any call, and if the method has
    /// none.
    pub fn tree_statistics(&self) -> Option<TreeStatistics> {
        self.method.tree_statistics(&self.threads, &self.b.leaves)
    }

    /// From now on a part of what these threads work on, which ends with it.
    pub(crate) fn join(&mut self, threads: &Threads) {
        self.threads.stop = threads.stop.clone();
    }

    /// Of two sets, or within one that is given twice.
    #[inline(never)]
    fn search<const WITHIN: bool>(&mut self, boxes: Boxes<2>) -> Result<(), Error> {
        let start = Instant::now();
        let Self { threads, method, a, b, workers, runs, times } = self;
        let exact = match boxes {
            Precision::F32([x, y]) => (WITHIN || a.take(threads, x)?) & b.take(threads, y)?,
            Precision::F64([x, y]) => (WITHIN || a.take(threads, x)?) & b.take(threads, y)?,
        };
        let overlap = |i: u32, j: u32| match boxes {
            Precision::F32([a, b]) => a[i as usize].overlaps(&b[j as usize]),
            Precision::F64([a, b]) => a[i as usize].overlaps(&b[j as usize]),
        };
        let confirm: Option<Confirm> = if exact { None } else { Some(&overlap) };
        threads.enter(|| {
            let sets = [&a.boxes[..], &b.boxes];
            method.order().survey(threads, &sets[WITHIN as usize..])?;
            if !WITHIN {
                a.leaves.build(threads, method.order(), &a.boxes, Marks::default());
            }
            b.leaves.build(threads, method.order(), &b.boxes, Marks::default());
            let (a, b) = (if WITHIN { &*b } else { &*a }, &*b);
            let slack = slack(&a.boxes, &b.boxes);
            let (a, b, stop) = (&a.leaves, &b.leaves, &*threads.stop);
            let sink = Listing::<WITHIN> { a, b, slack, confirm, stop };
            times.build = milliseconds(start);
            workers.resize_with(threads.count(), Lister::default);
            workers.iter_mut().for_each(Lister::clear);
            method.find(threads, (a, (!WITHIN).then_some(b)), 1, &sink, workers);
            order_runs(workers, runs);
            times.search = milliseconds(start) - times.build;
            threads.stop.check()
        })
    }
}

/// Whether two boxes overlap as they were given; asked where rounding may have made it so.
type Confirm<'a> = &'a (dyn Fn(u32, u32) -> bool + Sync);

/// Lists pairs of ids.
struct Listing<'a, const WITHIN: bool> {
    a: &'a LeafBoxes,
    b: &'a LeafBoxes,
    slack: f32,
    confirm: Option<Confirm<'a>>,
    stop: &'a Stop,
}

impl<const WITHIN: bool> PairSink for Listing<'_, WITHIN> {
    type Worker = Lister;
    const ORDERED: bool = true;

    #[inline(always)]
    fn row<S: RowSimd>(&self, lister: &mut Lister, simd: S, row: Overlaps) {
        let Overlaps { a, lane, b, mut mask } = row;
        let id = self.a.order()[a * 8 + lane];
        let ids = self.b.ids(b);
        if let Some(confirm) = self.confirm {
            let sure =
                simd.overlaps_surely(&self.a.blocks()[a], lane, &self.b.blocks()[b], self.slack);
            mask = mask & sure | keep(mask & !sure, |j| confirm(id, ids[j]));
        }
        if let Some(pairs) = lister.room(self.stop, "overlapping boxes", WIDTH) {
            simd.append::<WITHIN>(pairs, id, ids, mask);
        }
    }

    #[inline(always)]
    fn blocks<S: RowSimd>(
        &self,
        lister: &mut Lister,
        simd: S,
        (a, b): (usize, usize),
        boxes: [&Block; 2],
        mut masks: u64,
    ) {
        let (ids_a, ids_b) = (self.a.ids(a), self.b.ids(b));
        if let Some(confirm) = self.confirm {
            let confirmed = |i: usize, j: usize| confirm(ids_a[i], ids_b[j]);
            masks = confirmed_overlaps(simd, boxes, masks, self.slack, confirmed);
        }
        if masks != 0
            && let Some(pairs) = lister.room(self.stop, "overlapping boxes", ROOM)
        {
            simd.append_rows::<WITHIN, 0, 0>(pairs, [ids_a, ids_b], [], [], masks);
        }
    }

    fn begin(&self, lister: &mut Lister, task: usize) {
        lister.begin(task);
    }
}

/// The bits `j` of `mask` for which `wanted(j)`.
#[inline(always)]
pub fn keep(mask: u32, wanted: impl Fn(usize) -> bool) -> u32 {
    let (mut rest, mut out) = (mask, mask);
    while rest != 0 {
        let j = rest.trailing_zeros();
        rest &= rest - 1;
        if !wanted(j as usize) {
            out &= !(1 << j);
        }
    }
    out
}

impl Side {
    fn new(set: Set) -> Self {
        Self { boxes: Vec::new(), leaves: LeafBoxes::new(set) }
    }

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
        boxes.iter().fold(0f32, |m, b| {
            m.max(ccd_core::math::vec3::max_abs(b.min)).max(ccd_core::math::vec3::max_abs(b.max))
        })
    };
    ccd_core::backend::quantization::slack_at(greatest(a).max(greatest(b)))
}
