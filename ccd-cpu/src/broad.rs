//! The broad phase alone: boxes in, overlapping pairs out.

use crate::pyramid::Pyramid;
use crate::rows::keep;
use crate::simd::Simd;
use crate::threads::Threads;
use crate::traverse::{Rows, Traversal};
use crate::tree::Tree;
use ccd_core::error::check_boxes;
use ccd_core::layout::Pair;
use ccd_core::method::BroadPhaseMethod;
use ccd_core::{Aabb, Error, Num, Real};

/// Finds overlapping boxes; keeps its buffers between calls.
///
/// Overlap is closed: boxes that touch are a pair. Infinite bounds count as the greatest finite `f32`. `f64` boxes are compared as they are, not as
/// their `f32` roundings. The order of pairs depends on the boxes and the method, not on the number of threads.
#[derive(Debug)]
pub struct BroadPhase {
    threads: Threads,
    method: BroadPhaseMethod,
    a: Side,
    b: Side,
    traversal: Traversal,
    tree: Tree,
    workers: Vec<Lister>,
    runs: Vec<Run>,
}

/// One set of boxes.
#[derive(Debug, Default)]
struct Side {
    boxes: Vec<Aabb<f32>>,
    pyramid: Pyramid,
}

impl BroadPhase {
    /// With `threads` threads: 0 for those of rayon's current pool, 1 for the calling one alone.
    pub fn new(threads: usize, method: BroadPhaseMethod) -> Result<Self, Error> {
        Ok(Self {
            threads: Threads::new(threads)?,
            method,
            a: Side::default(),
            b: Side::default(),
            traversal: Traversal::default(),
            tree: Tree::default(),
            workers: Vec::new(),
            runs: Vec::new(),
        })
    }

    /// Number of threads in use.
    pub fn threads(&self) -> usize {
        self.threads.count()
    }

    /// Pairs within one set, each once, lesser index first.
    pub fn self_pairs<T: Real + Send + Sync>(&mut self, boxes: &[Aabb<T>]) -> Result<Pairs<'_>, Error> {
        check_boxes(boxes, f64::INFINITY)?;
        let Self { threads, method, a, traversal, tree, workers, runs, .. } = self;
        threads.enter(|| {
            let exact = a.take(threads, boxes);
            match method {
                BroadPhaseMethod::Blocks => {
                    a.pyramid.build(threads, &a.boxes, None);
                    let slack = (!exact).then(|| slack(&a.boxes, &a.boxes));
                    let confirm = |i: u32, j: u32| boxes[i as usize].overlaps(&boxes[j as usize]);
                    let rows = Listing::<true> { a: &a.pyramid, b: &a.pyramid, slack, confirm: &confirm };
                    list(threads, traversal, &rows, workers);
                }
                // The other method that there is.
                _ => {
                    let out = only_list(workers);
                    tree.self_pairs(threads, &a.boxes, out);
                    if !exact {
                        out.retain(|p| boxes[p.a as usize].overlaps(&boxes[p.b as usize]));
                    }
                }
            }
            order_runs(workers, runs);
        });
        Ok(Pairs { runs: &self.runs, workers: &self.workers })
    }

    /// Pairs of a box of `a` with a box of `b`.
    pub fn pairs<T: Real + Send + Sync>(&mut self, a: &[Aabb<T>], b: &[Aabb<T>]) -> Result<Pairs<'_>, Error> {
        check_boxes(a, f64::INFINITY)?;
        check_boxes(b, f64::INFINITY)?;
        let Self { threads, method, a: side_a, b: side_b, traversal, tree, workers, runs } = self;
        threads.enter(|| {
            let exact = side_a.take(threads, a) & side_b.take(threads, b);
            match method {
                BroadPhaseMethod::Blocks => {
                    side_a.pyramid.build(threads, &side_a.boxes, None);
                    side_b.pyramid.build(threads, &side_b.boxes, None);
                    let height = side_a.pyramid.height().max(side_b.pyramid.height());
                    side_a.pyramid.raise(height);
                    side_b.pyramid.raise(height);
                    let slack = (!exact).then(|| slack(&side_a.boxes, &side_b.boxes));
                    let confirm = |i: u32, j: u32| a[i as usize].overlaps(&b[j as usize]);
                    let rows = Listing::<false> { a: &side_a.pyramid, b: &side_b.pyramid, slack, confirm: &confirm };
                    list(threads, traversal, &rows, workers);
                }
                // The other method that there is.
                _ => {
                    let out = only_list(workers);
                    tree.pairs(threads, &side_a.boxes, &side_b.boxes, out);
                    if !exact {
                        out.retain(|p| a[p.a as usize].overlaps(&b[p.b as usize]));
                    }
                }
            }
            order_runs(workers, runs);
        });
        Ok(Pairs { runs: &self.runs, workers: &self.workers })
    }
}

/// Lists all pairs: within one set if its pairs are ordered, else of one set with another.
fn list<const WITHIN: bool>(threads: &Threads, traversal: &mut Traversal, rows: &Listing<WITHIN>, workers: &mut Vec<Lister>) {
    workers.resize_with(threads.count(), Lister::default);
    workers.iter_mut().for_each(Lister::clear);
    traversal.run(threads, (rows.a, (!WITHIN).then_some(rows.b)), 1, rows, workers);
}

/// What one worker found: pairs, and which task each run of them belongs to.
#[derive(Debug, Default)]
#[repr(align(128))]
pub(crate) struct Lister {
    pub(crate) pairs: Vec<Pair>,
    segments: Vec<(usize, usize)>,
}

impl Lister {
    /// Forgets everything, keeps buffers.
    pub(crate) fn clear(&mut self) {
        self.pairs.clear();
        self.segments.clear();
    }

    /// Pairs from here on belong to this task.
    pub(crate) fn begin(&mut self, task: usize) {
        self.segments.push((task, self.pairs.len()));
    }
}

struct Listing<'a, const WITHIN: bool> {
    a: &'a Pyramid,
    b: &'a Pyramid,
    slack: Option<f32>,
    confirm: &'a (dyn Fn(u32, u32) -> bool + Sync),
}

impl<const WITHIN: bool> Rows for Listing<'_, WITHIN> {
    type Worker = Lister;

    #[inline(always)]
    fn row<S: Simd>(&self, lister: &mut Lister, simd: S, a: usize, lane: usize, b: usize, mut mask: u32) {
        let id = self.a.order()[a * 8 + lane];
        let ids = lane_ids(self.b.order(), b);
        if let Some(slack) = self.slack {
            let sure = simd.overlaps_shrunk(&self.a.level(0)[a], lane, &self.b.level(0)[b], slack);
            mask = mask & sure | keep(mask & !sure, |j| (self.confirm)(id, ids[j]));
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

/// The ids of block `b`; lanes past the end repeat the last id.
#[inline(always)]
pub(crate) fn lane_ids(order: &[u32], b: usize) -> [u32; 8] {
    match order.get(b * 8..b * 8 + 8) {
        Some(ids) => ids.try_into().unwrap_or([0; 8]),
        None => std::array::from_fn(|j| order[(b * 8 + j).min(order.len() - 1)]),
    }
}

/// The pairs that a broad phase found, in canonical order: a few runs, which stay where the threads wrote them.
#[derive(Clone, Copy, Debug)]
pub struct Pairs<'a> {
    runs: &'a [Run],
    workers: &'a [Lister],
}

/// A run of pairs: of which task, found by which worker, where.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Run {
    task: usize,
    worker: usize,
    start: usize,
    end: usize,
}

impl<'a> Pairs<'a> {
    pub(crate) fn new(runs: &'a [Run], workers: &'a [Lister]) -> Self {
        Self { runs, workers }
    }

    /// Number of pairs.
    pub fn len(&self) -> usize {
        self.runs.iter().map(|r| r.end - r.start).sum()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The runs, in order.
    pub fn runs(&self) -> impl Iterator<Item = &'a [Pair]> + use<'a> {
        let workers = self.workers;
        self.runs.iter().map(|r| &workers[r.worker].pairs[r.start..r.end])
    }

    /// All pairs, in order.
    pub fn iter(&self) -> impl Iterator<Item = Pair> + use<'a> {
        self.runs().flatten().copied()
    }

    /// A copy in one piece.
    pub fn to_vec(&self) -> Vec<Pair> {
        let mut out = Vec::with_capacity(self.len());
        self.runs().for_each(|run| out.extend_from_slice(run));
        out
    }
}

/// Puts the workers' segments in the order of tasks, neighbours in one worker's list joined.
pub(crate) fn order_runs(workers: &[Lister], runs: &mut Vec<Run>) {
    runs.clear();
    for (k, worker) in workers.iter().enumerate() {
        let ends = worker.segments.iter().skip(1).map(|s| s.1).chain([worker.pairs.len()]);
        runs.extend(worker.segments.iter().zip(ends).map(|(&(task, start), end)| Run { task, worker: k, start, end }));
    }
    runs.sort_unstable_by_key(|run| run.task);
    runs.dedup_by(|next, run| {
        let joined = next.worker == run.worker && next.start == run.end;
        if joined {
            run.end = next.end;
        }
        joined
    });
}

impl Side {
    /// Takes boxes, rounded outward; whether nothing was rounded.
    fn take<T: Real + Send + Sync>(&mut self, threads: &Threads, boxes: &[Aabb<T>]) -> bool {
        self.boxes.resize(boxes.len(), Aabb::EMPTY);
        threads.fill(&mut self.boxes, |i| boxes[i].round_out());
        let same =
            |r: &Aabb<f32>, b: &Aabb<T>| (0..3).all(|k| r.min[k] as f64 == b.min[k].to_f64() && r.max[k] as f64 == b.max[k].to_f64());
        T::UNIT.to_f64() == f32::UNIT as f64 || self.boxes.iter().zip(boxes).all(|(r, b)| same(r, b))
    }
}

/// Twice the spacing of `f32` at the greatest coordinate: outward rounding moves two bounds by less than that together.
fn slack(a: &[Aabb<f32>], b: &[Aabb<f32>]) -> f32 {
    let greatest =
        |boxes: &[Aabb<f32>]| boxes.iter().fold(0f32, |m, b| m.max(ccd_core::vec3::max_abs(b.min)).max(ccd_core::vec3::max_abs(b.max)));
    ccd_core::input::slack_at(greatest(a).max(greatest(b)))
}
