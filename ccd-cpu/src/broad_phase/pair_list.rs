//! Lists of pairs: what each worker found, and all of them in an order that no thread changes.
//!
//! Twin: none; a GPU lists pairs in one buffer.

use ccd_core::backend::layout::Pair;

/// The pairs that a broad phase found, in canonical order: a few runs, which stay where the threads
/// wrote them.
///
/// ```
/// use ccd::{Aabb, BroadPhase, method::BroadPhaseMethod};
///
/// let mut broad_phase = BroadPhase::new(1, BroadPhaseMethod::default())?;
/// let pairs = broad_phase.self_pairs(&[Aabb { min: [0.0f32; 3], max: [1.0; 3] }; 3])?;
/// assert_eq!((pairs.len(), pairs.iter().count()), (3, 3));
/// assert!(pairs.iter().all(|pair| pair.a < pair.b));
/// # Ok::<(), ccd::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Pairs<'a> {
    runs: &'a [Run],
    workers: &'a [Lister],
}

/// A run of pairs: of which task, found by which worker, where.
#[derive(Clone, Copy, Debug)]
pub struct Run {
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
pub fn order_runs(workers: &[Lister], runs: &mut Vec<Run>) {
    runs.clear();
    for (k, worker) in workers.iter().enumerate() {
        let ends = worker.segments.iter().skip(1).map(|s| s.1).chain([worker.pairs.len()]);
        runs.extend(worker.segments.iter().zip(ends).map(|(&(task, start), end)| Run {
            task,
            worker: k,
            start,
            end,
        }));
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

/// What one worker found: pairs, and which task each run of them belongs to.
#[derive(Debug, Default)]
#[repr(align(128))]
pub struct Lister {
    pub pairs: Vec<Pair>,
    segments: Vec<(usize, usize)>,
}

impl Lister {
    /// Forgets everything, keeps buffers.
    pub fn clear(&mut self) {
        self.pairs.clear();
        self.segments.clear();
    }

    /// Pairs from here on belong to this task.
    pub fn begin(&mut self, task: usize) {
        self.segments.push((task, self.pairs.len()));
    }
}
