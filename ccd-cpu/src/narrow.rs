//! From candidates to contacts: pairs are queued, full queues pass the `f32` filters eight at a time, and what is left is decided in `f64`.
//!
//! Pairs enter the arithmetic with the lesser edge first, so no result depends on the order of leaves.

use crate::lanes::{Lanes, WIDTH};
use crate::rows::{Scene, Take};
use crate::simd::{Simd, Work};
use ccd_core::Real;
use ccd_core::layout::Pair;
use ccd_core::model::contact::{Contact, Kind};
use ccd_core::narrow_phase::coplanarity::Coplanarity;
use ccd_core::narrow_phase::decide;
use ccd_core::narrow_phase::relative_motion::{Motion, Patch};
use ccd_core::narrow_phase::separating_direction::beside;
use std::time::{Duration, Instant};

/// Pairs that a queue holds before it is worked off: fits the first-level cache with the positions it touches.
const QUEUE: usize = 512;

/// What one worker gathers.
#[derive(Debug, Default)]
#[repr(align(128))]
pub struct Worker {
    queue: Vec<Pair>,
    pub contacts: Vec<Contact>,
    pub toi: Option<f64>,
    pub n_candidates: u64,
    pub n_filtered: u64,
    pub narrow: Duration,
}

impl Worker {
    /// Forgets the last step, keeps buffers.
    pub fn reset(&mut self) {
        self.queue.clear();
        self.queue.reserve(QUEUE + WIDTH);
        self.contacts.clear();
        self.toi = None;
        self.start_kind();
        self.narrow = Duration::ZERO;
    }

    /// Starts counting another kind of pair.
    pub fn start_kind(&mut self) {
        self.n_candidates = 0;
        self.n_filtered = 0;
    }

    /// Filters and decides what is queued.
    fn flush<S: Simd, T: Real>(&mut self, simd: S, scene: &Scene<T>, kind: Kind) {
        let start = Instant::now();
        simd.run(Filter { pairs: &mut self.queue, scene, kind });
        self.n_filtered += self.queue.len() as u64;
        for i in 0..self.queue.len() {
            self.decide(scene, kind, self.queue[i]);
        }
        self.queue.clear();
        self.narrow += start.elapsed();
    }

    fn decide<T: Real>(&mut self, scene: &Scene<T>, kind: Kind, pair: Pair) {
        let ids = vertices(scene, kind, pair);
        let verdict = match kind {
            Kind::VertexFace => decide::vertex_face_pair(ids, scene.x0, scene.x1, scene.min_distance, 0.0),
            Kind::EdgeEdge => decide::edge_edge_pair(ids, scene.x0, scene.x1, scene.min_distance, 0.0),
        };
        let Some(contact) = Contact::of(kind, pair, verdict) else { return };
        self.toi = Some(self.toi.map_or(contact.toi, |t| t.min(contact.toi)));
        if scene.keep_contacts {
            self.contacts.push(contact);
        }
    }
}

impl Take for Worker {
    const FILTERED: bool = true;

    #[inline(always)]
    fn count(&mut self, n: u64) {
        self.n_candidates += n;
    }

    #[inline(always)]
    fn take<S: Simd, T: Real>(&mut self, simd: S, scene: &Scene<T>, kind: Kind, id: u32, ids: &[u32; WIDTH], mask: u32) {
        match kind {
            Kind::VertexFace => simd.append::<false>(&mut self.queue, id, ids, mask),
            Kind::EdgeEdge => simd.append::<true>(&mut self.queue, id, ids, mask),
        }
        if self.queue.len() >= QUEUE {
            self.flush(simd, scene, kind);
        }
    }

    #[inline(always)]
    fn begin(&mut self, _task: usize) {}

    fn finish<T: Real>(&mut self, scene: &Scene<T>, kind: Kind) {
        if !self.queue.is_empty() {
            crate::simd::dispatch!(simd => self.flush(simd, scene, kind));
        }
    }
}

/// `v f0 f1 f2` or `ea0 ea1 eb0 eb1`.
#[inline(always)]
fn vertices<T>(scene: &Scene<T>, kind: Kind, pair: Pair) -> [u32; 4] {
    match kind {
        Kind::VertexFace => decide::vertex_face_ids(pair, scene.mesh.faces()),
        Kind::EdgeEdge => decide::edge_edge_ids(pair, scene.mesh.edges()),
    }
}

/// Keeps of `pairs` what the `f32` filters cannot reject, in place: first over the whole step, then what is left over each half of it.
struct Filter<'a, T> {
    pairs: &'a mut Vec<Pair>,
    scene: &'a Scene<'a, T>,
    kind: Kind,
}

impl<T: Real> Work for Filter<'_, T> {
    type Out = ();

    #[inline(always)]
    fn call<S: Simd>(mut self, simd: S) {
        match self.kind {
            Kind::VertexFace => {
                self.keep::<S, true, false>(simd);
                self.keep::<S, true, true>(simd);
            }
            Kind::EdgeEdge => {
                self.keep::<S, false, false>(simd);
                self.keep::<S, false, true>(simd);
            }
        }
    }
}

impl<T: Real> Filter<'_, T> {
    /// Keeps what cannot be rejected over the whole step or over one of its halves, in order. (No closures here: they would not be compiled with the
    /// instruction set.)
    #[inline(always)]
    fn keep<S: Simd, const VERTEX_FACE: bool, const HALVES: bool>(&mut self, simd: S) {
        let patch = if VERTEX_FACE { Patch::Triangle } else { Patch::Parallelogram };
        let distance = Lanes([self.scene.table_distance; WIDTH]);
        let mut n = 0;
        for start in (0..self.pairs.len()).step_by(WIDTH) {
            let end = (start + WIDTH).min(self.pairs.len());
            let motion = load::<S, T, VERTEX_FACE>(simd, self.scene, self.kind, &self.pairs[start..end]);
            let rejected = if HALVES {
                let (first, second) = motion.halves();
                apart(simd, &first, patch, distance) & apart(simd, &second, patch, distance)
            } else {
                apart(simd, &motion, patch, distance)
            };
            let mut left = !rejected & (0xff >> (WIDTH - (end - start)));
            while left != 0 {
                self.pairs[n] = self.pairs[start + left.trailing_zeros() as usize];
                n += 1;
                left &= left - 1;
            }
        }
        self.pairs.truncate(n);
    }
}

/// The motion of up to eight pairs; lanes past the last repeat it.
#[inline(always)]
fn load<S: Simd, T, const VERTEX_FACE: bool>(simd: S, scene: &Scene<T>, kind: Kind, eight: &[Pair]) -> Motion<Lanes> {
    let mut v = [[0u32; WIDTH]; 4];
    for j in 0..WIDTH {
        let four = vertices(scene, kind, eight[j.min(eight.len() - 1)]);
        for k in 0..4 {
            v[k][j] = four[k];
        }
    }
    let error = Lanes([scene.table_error; WIDTH]);
    let mut x0 = [[error; 3]; 4];
    let mut x1 = [[error; 3]; 4];
    for k in 0..4 {
        let p = simd.gather(scene.table, &v[k]);
        x0[k] = [p[0], p[1], p[2]];
        x1[k] = [p[4], p[5], p[6]];
    }
    if VERTEX_FACE { Motion::vertex_face(&x0, &x1, error) } else { Motion::edge_edge(&x0, &x1, error) }
}

/// Lanes in which the features certainly stay further than `distance` apart.
#[inline(always)]
fn apart<S: Simd>(simd: S, motion: &Motion<Lanes>, patch: Patch, distance: Lanes) -> u32 {
    let by_plane = simd.greater(Coplanarity::new(motion).clearance(distance), 0.0);
    if by_plane == 0xff { by_plane } else { by_plane | simd.greater(beside(motion, patch, distance), 0.0) }
}
