//! From candidates to contacts: pairs are queued, full queues pass the `f32` filters many at a
//! time, and what is left is decided in `f64`, or exactly.
//!
//! Pairs enter the arithmetic with the lesser edge first, so no result depends on the order of
//! leaves.

use crate::clock::Instant;
use crate::simd::{MAX_WIDTH, Mask, ROOM, Simd, Work};
use crate::step::candidates::{Scene, Take};
use crate::threads::Threads;
use ccd_core::Num;
use ccd_core::backend::layout::Pair;
use ccd_core::model::contact::{Contact, Kind, PerKind, State};
use ccd_core::model::decision::Open;
use ccd_core::model::precision::Precision;
use ccd_core::model::report::TriangleCounts;
use ccd_core::narrow_phase::cascade;
use ccd_core::narrow_phase::relative_motion::{Motion, Patch};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::time::Duration;

/// Pairs that a queue holds before it is worked off: fits the first-level cache with the positions
/// it touches.
const QUEUE: usize = 512;

/// The name of lists in [`ccd_core::Error::Memory`].
pub const CONTACTS: &str = "contacts";

/// Queues and results of one worker.
#[derive(Debug, Default)]
#[repr(align(128))]
pub struct Worker {
    queues: [Vec<Pair>; 2],
    /// Pairs that were put aside, see [`decide_open`].
    open: Vec<(Kind, Pair)>,
    /// How many of the step were.
    pub n_open: usize,
    pub contacts: Vec<Contact>,
    /// Those of them that are undecided.
    pub undecided: u64,
    /// The first contact, see [`Contact::by_time`].
    pub first: Option<Contact>,
    pub candidates: PerKind,
    pub filtered: PerKind,
    pub triangles: TriangleCounts,
    pub narrow: Duration,
}

impl Worker {
    /// Forgets the last step, keeps buffers.
    pub fn reset(&mut self) {
        for queue in &mut self.queues {
            queue.clear();
            queue.reserve(QUEUE + ROOM);
        }
        self.open.clear();
        self.n_open = 0;
        self.contacts.clear();
        self.undecided = 0;
        self.first = None;
        self.restart_counts();
        self.narrow = Duration::ZERO;
    }

    /// Counts from zero.
    pub fn restart_counts(&mut self) {
        self.candidates = PerKind::default();
        self.filtered = PerKind::default();
        self.triangles = TriangleCounts::default();
    }

    /// Filters and decides what is queued.
    #[inline(never)]
    fn flush(&mut self, scene: &Scene, kind: Kind) {
        let start = Instant::now();
        let mut queue = std::mem::take(&mut self.queues[kind as usize]);
        let pairs = &mut queue;
        crate::simd::run!(Filter { pairs, scene, kind });
        *self.filtered.of(kind) += queue.len() as u64;
        for &pair in &queue {
            self.decide(scene, kind, pair);
        }
        queue.clear();
        self.queues[kind as usize] = queue;
        self.narrow += start.elapsed();
    }

    /// Decides a pair, or puts it aside for [`decide_open`].
    pub fn decide(&mut self, scene: &Scene, kind: Kind, pair: Pair) {
        let decider = match self.first {
            // Of later ones nothing is kept.
            Some(first) if !scene.keep_contacts => &scene.decider.up_to(first.toi),
            _ => &scene.decider,
        };
        let contact = match scene.given {
            Precision::F32(x) => decider.quick_contact(scene.mesh, kind, pair, x),
            Precision::F64(x) => decider.quick_contact(scene.mesh, kind, pair, x),
        };
        match contact {
            Ok(contact) => self.keep(scene, contact),
            // A list of them is memory that a limit may not allow.
            Err(Open) if scene.stop.is_limited() => self.decide_by_integers(scene, (kind, pair)),
            Err(Open) => self.open.push((kind, pair)),
        }
    }

    fn decide_by_integers(&mut self, scene: &Scene, (kind, pair): (Kind, Pair)) {
        let contact = match scene.given {
            Precision::F32(x) => scene.decider.contact(scene.mesh, kind, pair, x),
            Precision::F64(x) => scene.decider.contact(scene.mesh, kind, pair, x),
        };
        self.keep(scene, contact);
    }

    fn keep(&mut self, scene: &Scene, contact: Option<Contact>) {
        let Some(contact) = contact else { return };
        self.first = self.first.into_iter().chain([contact]).min_by(Contact::by_time);
        if scene.keep_contacts && scene.stop.reserve(CONTACTS, &mut self.contacts, 1) {
            self.contacts.push(contact);
            self.undecided += (contact.state == State::Undecided) as u64;
        }
    }
}

/// Decides by integers what rounded arithmetic left open. Such pairs lie side by side, where
/// features share a plane or meet in a corner, so that one worker finds most of them; each takes
/// some 15 us, so all workers share them.
pub fn decide_open(threads: &Threads, scene: &Scene, workers: &mut [Worker]) {
    let n: usize = workers.iter().map(|worker| worker.open.len()).sum();
    let Some((first, others)) = workers.split_first_mut().filter(|_| n > 0) else { return };
    first.n_open += n;
    let mut open = std::mem::take(&mut first.open);
    for worker in others {
        open.append(&mut worker.open);
        // Any worker may find all of them next time, and a few more.
        worker.open.reserve(n + n / 8);
    }
    open.reserve(n / 8);
    let next = AtomicUsize::new(0);
    threads.each(workers, &|_, worker| {
        let start = Instant::now();
        while let Some(&pair) = open.get(next.fetch_add(1, Relaxed)) {
            if scene.stop.is_stopped() {
                break;
            }
            worker.decide_by_integers(scene, pair);
        }
        worker.narrow += start.elapsed();
    });
    open.clear();
    workers[0].open = open;
}

impl Take for Worker {
    const FILTERED: bool = true;

    #[inline(always)]
    fn count(&mut self, kind: Kind, n: u64) {
        *self.candidates.of(kind) += n;
    }

    #[inline(always)]
    fn count_triangles(&mut self, counts: TriangleCounts) {
        self.triangles = self.triangles.plus(counts);
    }

    #[inline(always)]
    fn list(&mut self, _scene: &Scene, kind: Kind, _n: usize) -> Option<&mut Vec<Pair>> {
        Some(&mut self.queues[kind as usize])
    }

    #[inline(always)]
    fn listed(&mut self, scene: &Scene, kind: Kind) {
        if self.queues[kind as usize].len() >= QUEUE {
            self.flush(scene, kind);
        }
    }

    fn finish(&mut self, scene: &Scene, kind: Kind) {
        if !self.queues[kind as usize].is_empty() {
            self.flush(scene, kind);
        }
    }
}

/// Keeps of `pairs` what the `f32` filters cannot reject, in place: first over the whole step, then
/// what is left at the times at which it may be coplanar, clipped once and twice; and of that what
/// no axis separates at both ends, where the search has not asked.
struct Filter<'a> {
    pairs: &'a mut Vec<Pair>,
    scene: &'a Scene<'a>,
    kind: Kind,
}

impl<S: Simd> Work<S> for Filter<'_> {
    type Out = ();

    #[inline(always)]
    fn call(mut self, simd: S) {
        // A loop, so that the filters are compiled once.
        for n_clips in 0..3 {
            match self.kind {
                Kind::VertexFace => self.keep::<S, true>(simd, n_clips),
                _ => self.keep::<S, false>(simd, n_clips),
            }
        }
        if !self.scene.asks_ends {
            self.keep_near();
        }
    }
}

impl Filter<'_> {
    /// Keeps pairs that no axis separates at both ends, where the search has not asked for that.
    #[inline(never)]
    fn keep_near(&mut self) {
        let Self { pairs, scene, kind } = self;
        pairs.retain(|&pair| {
            let [p, q, r, s] = scene.mesh.vertices_of(*kind, pair);
            !match kind {
                Kind::VertexFace => scene.axis_separated([p], [q, r, s]),
                _ => scene.axis_separated([p, q], [r, s]),
            }
        });
    }

    /// Keeps, in order, what cannot be rejected during the times that so many clips leave. (No
    /// closures here: they would not be compiled with the instruction set.)
    #[inline(always)]
    fn keep<S: Simd, const VERTEX_FACE: bool>(&mut self, simd: S, n_clips: u32) {
        let patch = if VERTEX_FACE { Patch::Triangle } else { Patch::Parallelogram };
        let distance = S::Lanes::splat(self.scene.table_distance);
        let mut n = 0;
        for start in (0..self.pairs.len()).step_by(S::LANES) {
            let end = (start + S::LANES).min(self.pairs.len());
            let pairs = &self.pairs[start..end];
            let mut motion = load(simd, self.scene, self.kind, patch, pairs);
            let mut latest = S::Lanes::splat(self.scene.latest);
            let mut known = all(S::LANES);
            for _ in 0..n_clips {
                let (part, is_known) = cascade::clipped(&motion, distance, latest);
                (motion, latest) = (part, S::Lanes::splat(1.0));
                known &= is_known.bits();
            }
            let apart = cascade::apart_throughout(&motion, patch, distance).bits();
            let mut left = !(known & apart) & all(end - start);
            while left != 0 {
                self.pairs[n] = self.pairs[start + left.trailing_zeros() as usize];
                n += 1;
                left &= left - 1;
            }
        }
        self.pairs.truncate(n);
    }
}

/// As many bits as there are lanes.
#[inline(always)]
fn all(n_lanes: usize) -> u32 {
    (1 << n_lanes) - 1
}

/// The motion of as many pairs as there are lanes, or fewer; lanes past the last repeat it.
#[inline(always)]
fn load<S: Simd>(
    simd: S,
    scene: &Scene,
    kind: Kind,
    patch: Patch,
    pairs: &[Pair],
) -> Motion<S::Lanes> {
    let mut v = [[0u32; MAX_WIDTH]; 4];
    for j in 0..S::LANES {
        let four = scene.mesh.vertices_of(kind, pairs[j.min(pairs.len() - 1)]);
        for k in 0..4 {
            v[k][j] = four[k];
        }
    }
    let error = S::Lanes::splat(scene.table_error);
    let mut x0 = [[error; 3]; 4];
    let mut x1 = [[error; 3]; 4];
    for k in 0..4 {
        let p = simd.gather(scene.table, &v[k]);
        x0[k] = [p[0], p[1], p[2]];
        x1[k] = [p[4], p[5], p[6]];
    }
    Motion::new(patch, &x0, &x1, error)
}
