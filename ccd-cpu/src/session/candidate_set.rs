//! Candidates that are listed once and serve many steps: those of a line search, whose step sizes
//! are tried one after the other.
//!
//! # Why no contact is missed
//! Let `r` be the reach of a set: its inflation, and what interpolation may round. A set has the
//! pairs whose boxes, swept from `x0` to `x1` and grown by `r` and half of the minimum distance,
//! overlap. If every vertex of another step is, at both ends, within `r` of its swept box along
//! each axis, so is its whole path, and boxes of that step grown by half of the distance are within
//! those of the set. So are two features that come to the distance, and they are a pair.

use super::{Engine, SAMPLE, WHOLE};
use crate::session::passes::{first_contact, swept_until};
use crate::step::candidates::{Given, Scene, Take};
use crate::step::leaves::feature_box;
use crate::step::narrow_phase::{Worker, decide_open};
use crate::step::positions::Positions;
use crate::step::prepare::Prepared;
use crate::step::selection::Selection;
use crate::stop::Stop;
use crate::threads::Threads;
use ccd_core::backend::broad_phase::swept_box::swept;
use ccd_core::backend::layout::Pair;
use ccd_core::model::contact::{Contact, Kind};
use ccd_core::model::error::check_min_distance;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use ccd_core::model::pipeline::Pipeline;
use ccd_core::model::positions::{AsPositions, Ends, Gathered, ends};
use ccd_core::model::precision::Precision;
use ccd_core::model::session::{Engine as _, State, given};
use ccd_core::{Aabb, Error, Num, Real};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// Candidates of a step, owned, and used for all steps near it. They are decided on threads of this
/// machine as a session decides them, by the session's options, and just as certainly.
///
/// A set holds for steps whose vertices are, at both ends, at most its inflation outside of the box
/// around their own two positions `x0` and `x1`, along each axis. Rounding is granted besides:
/// eight units of roundoff, in the precision of `x0` and `x1`, of the greatest coordinate, which
/// covers `x0 + s (x1 - x0)` and `(1 - s) x0 + s x1`. Other steps are refused with
/// [`Error::Beyond`]: no contact is missed.
///
/// It costs some 8 bytes a pair and 100 a vertex, which [`Options::max_memory`] does not limit.
/// Bodies, distance, filter and token are those that the session had.
///
/// ```
/// use ccd::{Error, Kind, Mesh, Options, Session};
///
/// // A vertex above a triangle, and two directions of a line search.
/// let mut session = Session::new(Mesh::new(4, &[[0, 1, 2]])?, Options::default())?;
/// let at = |y: f64| [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.2, y, 0.2]];
/// let mut set = session.candidate_set(&at(1.0), &at(-1.0), 0.25)?;
/// assert_eq!(set.pairs(Kind::VertexFace).len(), 1);
/// for y in [-1.0, 0.0, 0.5, 1.0] {
///     let (step, same) = ((at(1.0), at(y)), set.collision_free_step_size(&at(1.0), &at(y))?);
///     assert_eq!(same, session.collision_free_step_size(&step.0, &step.1)?);
/// }
/// // By 0.25 below the end, and no further.
/// assert!(set.collision_free_step_size(&at(0.0), &at(-1.25)).is_ok());
/// let beyond = set.collision_free_step_size(&at(0.0), &at(-1.26));
/// assert_eq!(beyond, Err(Error::Beyond { time: 1, vertex: 3 }));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug)]
pub struct CandidateSet {
    mesh: Arc<Mesh>,
    options: Options,
    /// By kind.
    pairs: [Vec<Pair>; 4],
    inflation: f64,
    reach: f64,
    /// Of vertices, not grown.
    swept: Vec<Aabb<f64>>,
    threads: Threads,
    prepared: Prepared,
    selection: Selection,
    workers: Vec<Worker>,
    gathered: Gathered,
}

impl Engine {
    /// Candidates of the step from `x0` to `x1` as a [`CandidateSet`], which holds for steps of
    /// which each vertex is at most `inflation` outside of the box of its two positions.
    ///
    /// With `x0` twice they are those of one moment: then it says how far vertices may move.
    ///
    /// # Errors
    /// [`Error::MinDistance`] for an inflation that is negative or not finite, and those of
    /// [`Session::step`](super::Session::step).
    pub fn candidate_set<A, B>(
        &mut self,
        x0: &A,
        x1: &B,
        inflation: f64,
    ) -> Result<CandidateSet, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        let mut gathered = Gathered::default();
        let given = given(&self.state.mesh, &mut gathered, ends(x0, x1))?;
        self.set_of(given, inflation)
    }

    #[inline(never)]
    fn set_of(&mut self, given: Given, inflation: f64) -> Result<CandidateSet, Error> {
        check_min_distance(inflation)?;
        let mut options = self.state.options.clone();
        if std::mem::take(&mut options.pipeline) != Pipeline::Features {
            // Triangles are free of each other for the session's distance.
            let state = State::new(self.state.mesh.clone(), options);
            let mut plain = Self::new(&(), state)?;
            plain.selection.filter = self.selection.filter.clone();
            plain.set_cancel_token(self.threads.stop.token().cloned());
            return plain.set_of(given, inflation);
        }
        let (swept, reach) = match given {
            Precision::F32(x) => swept_and_reach(x, inflation),
            Precision::F64(x) => swept_and_reach(x, inflation),
        };
        let min_distance = options.min_distance;
        options.min_distance = distance_for(min_distance, reach);
        check_min_distance(options.min_distance)
            .map_err(|_| Error::MinDistance { value: inflation })?;
        if let Err(why) = self.within_limit(|engine| engine.list(given, Some(&options))) {
            self.clear();
            return Err(why);
        }
        options.min_distance = min_distance;
        let all = self.listed();
        let selection = Selection::new(&options)?;
        let mesh = self.state.mesh.clone();
        let mut prepared = Prepared::new(&mesh, &options);
        prepared.set_rules(selection.rules.as_ref());
        let stop = Stop::new(self.threads.stop.token().cloned(), None, 0);
        Ok(CandidateSet {
            pairs: [all.vf.to_vec(), all.ee.to_vec(), all.ve.to_vec(), all.vv.to_vec()],
            threads: self.threads.shared(Arc::new(stop)),
            workers: Vec::new(),
            gathered: Gathered::default(),
            mesh,
            options,
            inflation,
            reach,
            swept,
            prepared,
            selection,
        })
    }
}

impl CandidateSet {
    /// The mesh, whose features the pairs name.
    pub fn mesh(&self) -> &Arc<Mesh> {
        &self.mesh
    }

    /// The pairs of a kind, each once, in an order that no thread changes.
    pub fn pairs(&self, kind: Kind) -> &[Pair] {
        &self.pairs[kind as usize]
    }

    /// How far vertices may be outside of the step that the candidates were found for.
    pub fn inflation(&self) -> f64 {
        self.inflation
    }

    /// The earliest time of impact of a step, `None` if all of it is free: certain as
    /// [`Session::earliest_toi`](super::Session::earliest_toi) is, without its search for pairs.
    ///
    /// # Errors
    /// [`Error::Beyond`] with the first vertex that is outside of what the set holds for;
    /// [`Error::VertexCount`], [`Error::Coordinate`], [`Error::FixedMoves`], [`Error::Cancelled`].
    pub fn earliest_toi<A, B>(&mut self, x0: &A, x1: &B) -> Result<Option<f64>, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.earliest(ends(x0, x1))
    }

    /// How much of a step is certainly free of contact: 1 if all of it is, else
    /// [`CandidateSet::earliest_toi`], which may be 0.
    ///
    /// # Errors
    /// Those of [`CandidateSet::earliest_toi`].
    pub fn collision_free_step_size<A, B>(&mut self, x0: &A, x1: &B) -> Result<f64, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        Ok(self.earliest_toi(x0, x1)?.unwrap_or(1.0))
    }

    fn earliest(&mut self, ends: Ends) -> Result<Option<f64>, Error> {
        let mut gathered = std::mem::take(&mut self.gathered);
        let found = given(&self.mesh, &mut gathered, ends).and_then(|given| self.decide(given));
        self.gathered = gathered;
        found
    }

    #[inline(never)]
    fn decide(&mut self, given: Given) -> Result<Option<f64>, Error> {
        let Self { mesh, options, pairs, threads, prepared, selection, workers, .. } = self;
        let (swept, reach) = (&self.swept, self.reach);
        let (threads, mesh, options, selection) = (&*threads, &*mesh, &*options, &*selection);
        let stop = &*threads.stop;
        stop.begin()?;
        threads.enter(|| {
            let mut x = Positions::new(given, WHOLE);
            prepared.boxes(threads, options, &x)?;
            match given {
                Precision::F32(x) => check_within(swept, reach, x)?,
                Precision::F64(x) => check_within(swept, reach, x)?,
            }
            workers.resize_with(threads.count(), Worker::default);
            workers.iter_mut().for_each(Worker::reset);
            let parts: Vec<(Kind, &[Pair])> = Kind::ALL
                .into_iter()
                .flat_map(|kind| pairs[kind as usize].chunks(PART).map(move |part| (kind, part)))
                .collect();
            // A sample bounds the time that matters; an earlier contact is in smaller boxes.
            let scene = prepared.scene((mesh, options), selection, &x, WHOLE, false, stop);
            decide(threads, &scene, prepared.of_vertices(), (&parts, SAMPLE), workers);
            stop.check()?;
            if parts.len() > 1
                && let Some(Contact { toi, .. }) = first_contact(workers)
            {
                (x.until, x.again) = (swept_until(toi, options), true);
                prepared.boxes(threads, options, &x)?;
            }
            let scene = prepared.scene((mesh, options), selection, &x, WHOLE, false, stop);
            decide(threads, &scene, prepared.of_vertices(), (&parts, 1), workers);
            stop.check()?;
            Ok(first_contact(workers).map(|first| first.toi))
        })
    }
}

/// Pairs that a thread takes at once.
const PART: usize = 4096;

/// Decides the pairs of every `nth` part whose boxes in this step overlap.
fn decide(
    threads: &Threads,
    scene: &Scene,
    boxes: &[Aabb<f32>],
    (parts, nth): (&[(Kind, &[Pair])], usize),
    workers: &mut [Worker],
) {
    let counter = AtomicUsize::new(0);
    threads.each(workers, &|_, worker| {
        while let Some(&(kind, part)) = parts.get(counter.fetch_add(nth, Relaxed)) {
            if scene.stop.is_stopped() {
                break;
            }
            for &pair in part {
                let [p, q, r, s] = scene.mesh.vertices_of(kind, pair);
                let exact = scene.slack.is_some();
                match kind {
                    Kind::VertexFace => {
                        if feature_box([p], boxes).overlaps(&feature_box([q, r, s], boxes))
                            && (!exact || scene.boxes_overlap([p], [q, r, s]))
                        {
                            worker.take_one(scene, kind, pair);
                        }
                    }
                    Kind::EdgeEdge => {
                        if feature_box([p, q], boxes).overlaps(&feature_box([r, s], boxes))
                            && (!exact || scene.boxes_overlap([p, q], [r, s]))
                        {
                            worker.take_one(scene, kind, pair);
                        }
                    }
                    // Of few vertices: no filter is worth its table.
                    Kind::VertexEdge | Kind::VertexVertex => {
                        if scene.boxes_overlap([p], [q, r]) {
                            worker.decide(scene, kind, pair);
                        }
                    }
                }
            }
        }
        for kind in [Kind::VertexFace, Kind::EdgeEdge] {
            worker.finish(scene, kind);
        }
    });
    decide_open(threads, scene, workers);
}

/// The swept boxes of vertices, and how far from them they may be.
fn swept_and_reach<T: Real>([x0, x1]: [&[[T; 3]]; 2], inflation: f64) -> (Vec<Aabb<f64>>, f64) {
    let wide = |p: &[T; 3]| p.map(T::to_f64);
    let boxes: Vec<_> = x0.iter().zip(x1).map(|(p, q)| swept(wide(p), wide(q))).collect();
    let all = boxes.iter().flat_map(|b| b.min.iter().chain(&b.max));
    let greatest = all.fold(0.0, |most: f64, &c| Num::max(most, c.abs()));
    // Of `x0 + s (x1 - x0)`, a difference and a product of twice the greatest coordinate are
    // rounded, and a sum: five units. The other way rounds less. Numbers that are not normal are
    // rounded to multiples of the least one.
    let least = 2.0 * T::UNIT.to_f64() * T::MIN_NORMAL.to_f64();
    (boxes, inflation + 8.0 * (greatest * T::UNIT.to_f64() + least))
}

/// The minimum distance for which candidates are listed: boxes grow by half of it, at least by half
/// of `min_distance` and by what [`check_within`] lets pass, `reach` and a unit of roundoff of it.
fn distance_for(min_distance: f64, reach: f64) -> f64 {
    let wide = min_distance + 2.0 * reach * (1.0 + 8.0 * f64::UNIT);
    if reach > 0.0 { wide * (1.0 + 8.0 * f64::UNIT) } else { min_distance }
}

/// Checks that vertices are within `reach` of their boxes, rounded by at most half a unit.
fn check_within<T: Real>(boxes: &[Aabb<f64>], reach: f64, x: [&[[T; 3]]; 2]) -> Result<(), Error> {
    for (time, x) in (0..).zip(x) {
        for (vertex, (p, Aabb { min, max })) in x.iter().zip(boxes).enumerate() {
            for k in 0..3 {
                let c = p[k].to_f64();
                // Written so that NaN fails.
                if !(min[k] - c <= reach && c - max[k] <= reach) {
                    return Err(Error::Beyond { time, vertex });
                }
            }
        }
    }
    Ok(())
}
