//! Lists of pairs: what each worker found, and all of them in an order that no thread changes.
//!
//! Twin: none; a GPU lists pairs in one buffer.

use crate::pages;
use crate::stop::Stop;
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

/// A run of pairs: of which task, found by which worker, where in which of its chunks.
#[derive(Clone, Copy, Debug)]
pub struct Run {
    task: usize,
    worker: usize,
    chunk: usize,
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
        self.runs.iter().map(|r| &workers[r.worker].chunk(r.chunk)[r.start..r.end])
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

/// Puts the workers' segments in the order of tasks, neighbours in one worker's chunk joined.
pub fn order_runs(workers: &[Lister], runs: &mut Vec<Run>) {
    runs.clear();
    for (k, worker) in workers.iter().enumerate() {
        for (i, of) in worker.segments.iter().enumerate() {
            let next = worker.segments.get(i + 1).filter(|next| next.chunk == of.chunk);
            let end = next.map_or_else(|| worker.chunk(of.chunk).len(), |next| next.start);
            let Segment { task, chunk, start } = *of;
            runs.push(Run { task, worker: k, chunk, start, end });
        }
    }
    runs.sort_unstable_by_key(|run| (run.task, run.chunk));
    runs.dedup_by(|next, run| {
        let joined = (next.worker, next.chunk, next.start) == (run.worker, run.chunk, run.end);
        if joined {
            run.end = next.end;
        }
        joined
    });
}

/// What one worker found: pairs in chunks, none of which is moved when another one is needed, and
/// which task each run of them belongs to.
#[derive(Debug, Default)]
#[repr(align(128))]
pub struct Lister {
    /// The chunk that is being filled.
    pairs: Vec<Pair>,
    /// Those before it, and empty ones for later, the next one last.
    full: Vec<Vec<Pair>>,
    spare: Vec<Vec<Pair>>,
    segments: Vec<Segment>,
}

/// Where pairs of a task begin; they end where the next one begins, or with the chunk.
#[derive(Clone, Copy, Debug)]
struct Segment {
    task: usize,
    chunk: usize,
    start: usize,
}

/// Pairs of the first chunk. Each has twice as many as the one before, up to [`LARGE`], and then 16
/// MiB: the system gives memory as it is touched, and large pages only to large chunks. With a
/// limit of memory, which counts all of a chunk, each has twice as many, or fewer if it is near.
const FIRST: usize = 1 << 12;
const LARGE: usize = 1 << 17;
const MOST: usize = 1 << 21;
const LEAST: usize = 1 << 6;

impl Lister {
    /// Forgets everything, keeps buffers.
    pub fn clear(&mut self) {
        self.segments.clear();
        self.spare.push(std::mem::take(&mut self.pairs));
        self.spare.extend(self.full.drain(..).rev());
        self.spare.iter_mut().for_each(Vec::clear);
        self.pairs = self.spare.pop().unwrap_or_default();
    }

    /// Pairs from here on belong to this task.
    pub fn begin(&mut self, task: usize) {
        self.segments.push(Segment { task, chunk: self.full.len(), start: self.pairs.len() });
    }

    /// The list to add up to so many pairs to, at most [`LEAST`], which are called `what`; none if
    /// the limit of memory does not allow them, and the call ends.
    #[inline(always)]
    pub fn room(&mut self, stop: &Stop, what: &'static str, n: usize) -> Option<&mut Vec<Pair>> {
        if self.pairs.capacity() - self.pairs.len() < n && !self.next(stop, what) {
            return None;
        }
        Some(&mut self.pairs)
    }

    #[cold]
    fn next(&mut self, stop: &Stop, what: &'static str) -> bool {
        let next = match self.spare.pop() {
            Some(next) => next,
            None => {
                let before = self.pairs.capacity();
                let wanted = if before < LARGE || stop.is_limited() { 2 * before } else { MOST };
                let wanted = wanted.clamp(FIRST, MOST);
                let mut next = Vec::new();
                if !stop.allocate(what, &mut next, wanted, LEAST) {
                    return false;
                }
                pages::large(next.spare_capacity_mut());
                next
            }
        };
        let pairs = std::mem::replace(&mut self.pairs, next);
        if pairs.capacity() == 0 {
            return true;
        }
        self.full.push(pairs);
        if let Some(&Segment { task, .. }) = self.segments.last() {
            self.begin(task);
        }
        true
    }

    /// Chunk `k`.
    fn chunk(&self, k: usize) -> &[Pair] {
        self.full.get(k).unwrap_or(&self.pairs)
    }
}
