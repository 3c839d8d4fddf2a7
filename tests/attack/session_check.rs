//! A step of a session beside that of a new one by brute force; on a CPU also beside that of a new
//! one by the same method, and every pair by itself; on a GPU submitted and polled, too.

use super::Counts;
use super::session_steps::{State, keeps};
use ccd::any::Error;
use ccd::gpu;
use ccd::method::{BroadPhaseMethod, Pipeline, Scheduling, TriangleCounts, TriangleOptions};
use ccd::{Contact, Distance, Kind, Options, Pair, PerKind, Report, State as Certainty};
use ccd_testkit::brute::{check_pairs, every_pair};
use ccd_testkit::compare::agree_within;
use ccd_testkit::grazing::random::Random;

/// Edges of a mesh of which every pair is asked by itself, at most: a search is for many scenes.
const MOST_EDGES: usize = 150;

/// What is asked of a step: a part of it, the earliest time and candidates as well, without waiting
/// for a device.
#[derive(Clone, Copy)]
struct Wanted {
    window: [f64; 2],
    more: bool,
    in_flight: bool,
}

impl State<'_> {
    /// A step, and that of a new session by brute force.
    pub fn check(&mut self, random: &mut Random, counts: &mut Counts) -> Result<(), String> {
        let ends = self.ends();
        let window = [[0.0, 1.0], [0.0, 1.0], [0.1, 0.7], [0.25, 0.25], [0.5, 1.0], [1.0, 1.0]]
            [random.below(6)];
        let narrow = random.below(4) == 0;
        let [more, in_flight] = [4, 2].map(|n| random.below(n) == 0);
        let wanted = Wanted { window, more, in_flight };
        let mut fresh = self.new_session(self.plain_options())?;
        if narrow {
            let ends = ends.map(|x| x.iter().map(|p| p.map(|c| c as f32)).collect::<Vec<_>>());
            self.compare(&mut fresh, &ends, wanted, counts)
        } else {
            self.compare(&mut fresh, &ends, wanted, counts)
        }
    }

    /// The session's options, but by brute force on one thread.
    pub fn plain_options(&self) -> Options {
        self.session
            .options()
            .clone()
            .with_broad_phase(BroadPhaseMethod::BruteForce)
            .with_scheduling(Scheduling::default())
            .with_pipeline(Pipeline::Features)
            .with_threads(1)
    }

    /// A session of the same mesh and filter.
    pub fn new_session(&self, options: Options) -> Result<ccd::Session, String> {
        let mut fresh = ccd::Session::new(&self.step.mesh, options).map_err(of_new)?;
        let n = self.filter;
        fresh.set_filter(move |_, a, b| keeps(n, a, b)).map_err(|e| format!("a filter: {e}"))?;
        Ok(fresh)
    }

    fn compare<T: ccd::Coordinate>(
        &mut self,
        fresh: &mut ccd::Session,
        ends: &[Vec<[T; 3]>; 2],
        Wanted { window, more, in_flight }: Wanted,
        counts: &mut Counts,
    ) -> Result<(), String> {
        let on_gpu = self.place.backend() == "gpu";
        let in_flight = in_flight && on_gpu;
        let [x0, x1] = ends;
        if more {
            let all = fresh.step(x0, x1).map_err(of_new)?;
            let found = match self.session.gpu().filter(|_| in_flight) {
                Some(on) => on.submit_earliest_toi(x0, x1).and_then(|()| Ok(polled(on)?.toi)),
                None => self.session.earliest_toi(x0, x1),
            };
            self.check_earliest(all, found.map_err(an_error)?)?;
        }
        let found = match self.session.gpu().filter(|_| in_flight && window == [0.0, 1.0]) {
            Some(on) => on.submit(x0, x1).and_then(|()| polled(on)),
            None => self.session.step_window(x0, x1, window).cloned(),
        };
        let found = found.map_err(an_error)?;
        let want = fresh.step_window(x0, x1, window).map_err(of_new)?;
        counts.add("contacts", want.contacts.len() as u64);
        self.same(&found, want, [x0, x1], window)?;
        if found.mesh() != &self.step.mesh {
            return Err("a report of another mesh".into());
        }
        // A device sweeps the boxes of a window itself, in `f32`, those of a tiny scene in a unit
        // of its own, and those of a scene that is far away about its middle: there it may take up
        // other candidates. Large `f32` it takes as `f64`, and the distance with them.
        let is_wide = self.unit > 1e29 && size_of::<T>() == 4;
        let is_placed = self.unit < 1e-30 || self.is_far || is_wide;
        let other_boxes = on_gpu && (window != [0.0, 1.0] || is_placed);
        if !self.has_free_regions() && !other_boxes && found.candidates != want.candidates {
            return Err(format!("candidates {:?}, {:?}", found.candidates, want.candidates));
        }
        if on_gpu {
            let is_listed = more && !other_boxes && !self.has_free_regions();
            return if is_listed { self.check_candidates(fresh, [x0, x1]) } else { Ok(()) };
        }
        self.check_every_pair(ends, window, &found);
        self.check_same_method(fresh, ends, window, more, &found)
    }

    /// An earliest time beside a step in which all contacts were sought.
    pub fn check_earliest(&self, all: &Report, found: Option<f64>) -> Result<(), String> {
        let on_gpu = self.place.backend() == "gpu";
        // A device's time is as early as it may be by itself, and rounded down to an `f32`.
        let slack = if on_gpu { self.session.options().tolerance + 1.1e-6 } else { 0.0 };
        let hits = all.contacts.iter().filter(|c| c.state == Certainty::Hit);
        let first = hits.map(|c| c.toi).reduce(f64::min);
        let late = first.is_some_and(|first| found.is_none_or(|t| t > first + slack));
        // Only one of a pair that is undecided may be earlier; of that a device has its own time.
        let is_certain = all.undecided == 0 || !on_gpu;
        let early = is_certain && all.toi.zip(found).is_some_and(|(all, t)| t < all - slack);
        if late || early || !on_gpu && all.toi.is_some() != found.is_some() {
            return Err(format!("earliest time {found:?}, of all contacts {:?}", all.toi));
        }
        Ok(())
    }

    /// The same contacts; of a GPU what both are certain of, and no others are left at the start.
    pub fn same<T: ccd::Coordinate>(
        &self,
        found: &Report,
        want: &Report,
        ends: [&Vec<[T; 3]>; 2],
        window: [f64; 2],
    ) -> Result<(), String> {
        if self.place.backend() == "gpu" {
            let tolerance = self.session.options().tolerance.max(1e-9);
            let kept = |these: &Report, those: &Report| -> Vec<Contact> {
                let is_kept = |c: &&Contact| !self.is_left(c, those, ends, window);
                these.contacts.iter().filter(is_kept).copied().collect()
            };
            return agree_within(&kept(want, found), &kept(found, want), tolerance);
        }
        if found.contacts == want.contacts {
            return Ok(());
        }
        let mut both = want.contacts.iter().zip(&found.contacts);
        let other = both.find(|(a, b)| a != b);
        let [n, right] = [found, want].map(|r| r.contacts.len());
        Err(format!("{n} contacts, {right} are right; the first that differ: {other:?}"))
    }

    /// Whether a contact that another report has at another time, or not at all, may be one that
    /// was left at the start, which takes certainty that a device may have or lack: features are
    /// near at the start, and until the later time, at moments that are looked at, no nearer than
    /// there, or further apart than the minimum distance.
    fn is_left<T: ccd::Coordinate>(
        &self,
        contact: &Contact,
        other: &Report,
        ends: [&Vec<[T; 3]>; 2],
        [from, until]: [f64; 2],
    ) -> bool {
        let options = self.session.options();
        let key = |c: &Contact| (c.kind, c.a, c.b);
        let same = other.contacts.binary_search_by_key(&key(contact), key);
        let toi = same.map_or(until, |at| other.contacts[at].toi);
        let leaves = options.leave_contact && options.min_distance > 0.0;
        if !leaves || (toi - contact.toi).abs() <= 2.0 * options.tolerance {
            return false;
        }
        let mesh = &self.step.mesh;
        let pair = Pair { a: contact.a, b: contact.b };
        let ids = mesh.vertices_of(contact.kind, pair);
        let [x0, x1] = ends.map(|x| ids.map(|v| x[v as usize].map(|c| c.to_f64())));
        let distance = |t: f64| {
            let at = |v: usize| std::array::from_fn(|k| x0[v][k] + t * (x1[v][k] - x0[v][k]));
            match contact.kind {
                Kind::VertexFace => Distance::vertex_face([0, 1, 2, 3].map(at)),
                Kind::EdgeEdge => Distance::edge_edge([0, 1, 2, 3].map(at)),
                Kind::VertexEdge => Distance::vertex_edge([0, 1, 2].map(at)),
                Kind::VertexVertex => Distance::vertex_vertex([0, 1].map(at)),
            }
        };
        // Of a device without `f64`.
        let all = ends.iter().flat_map(|x| x.iter().flatten()).map(|c| c.to_f64().abs());
        let slack = 1e-6 * all.fold(0.0, f64::max);
        let start = distance(from).least;
        let needed = options.min_distance.min(start) - slack;
        let until = toi.max(contact.toi);
        let is_near = start <= options.min_distance + slack;
        is_near
            && (0..=64)
                .all(|k| distance(from + (until - from) * k as f64 / 64.0).greatest >= needed)
    }

    /// Regions that are certainly free of contacts omit candidates.
    fn has_free_regions(&self) -> bool {
        matches!(
            self.session.options().pipeline,
            Pipeline::Triangles(TriangleOptions { free_regions: true, .. })
        )
    }

    /// What every pair of features says, asked by itself.
    fn check_every_pair<T: ccd::Coordinate>(
        &self,
        ends: &[Vec<[T; 3]>; 2],
        window: [f64; 2],
        found: &Report,
    ) {
        let mesh = &self.step.mesh;
        if mesh.edges().len() > MOST_EDGES {
            return;
        }
        let wide = |x: &Vec<[T; 3]>| -> Vec<[f64; 3]> {
            x.iter().map(|p| p.map(|c| c.to_f64())).collect()
        };
        let [x0, x1] = ends.each_ref().map(wide);
        let mut want = every_pair(mesh, [&x0, &x1], self.session.options(), window);
        want.retain(|c| keeps(self.filter, c.a, c.b));
        check_pairs(&format!("{window:?}, every pair"), &want, &found.contacts);
    }

    /// What is counted is what a new session by the same method counts; candidates, if they are
    /// wanted, are those by brute force, or, if some are omitted, those of that session.
    fn check_same_method<T: ccd::Coordinate>(
        &mut self,
        by_brute_force: &mut ccd::Session,
        [x0, x1]: &[Vec<[T; 3]>; 2],
        window: [f64; 2],
        with_candidates: bool,
        found: &Report,
    ) -> Result<(), String> {
        let mut fresh = self.new_session(self.session.options().clone())?;
        let want = fresh.step_window(x0, x1, window).map_err(of_new)?;
        // Oriented boxes are compared in the order of leaves, by which they may be apart or not by
        // a rounding; what they separate is not filtered.
        let separates = |r: &Report| r.triangles.is_some_and(|of| of.separated > 0);
        let with_filtered = !separates(found) && !separates(want);
        let [n, right] = [found, want].map(|r| numbers(r, with_filtered));
        if n != right {
            return Err(format!("numbers {n:?}, of a new session {right:?}"));
        }
        if !with_candidates {
            return Ok(());
        }
        self.check_candidate_set(&mut fresh, [x0, x1])?;
        let other = if self.has_free_regions() { &mut fresh } else { by_brute_force };
        self.check_candidates(other, [x0, x1])
    }

    /// Earliest times of the step and of half of it, by candidates of the whole.
    fn check_candidate_set<T: ccd::Coordinate>(
        &mut self,
        fresh: &mut ccd::Session,
        [x0, x1]: [&Vec<[T; 3]>; 2],
    ) -> Result<(), String> {
        let set = self.session.candidate_set(x0, x1, 1e-3 * self.unit);
        let mut set = set.map_err(|e| format!("a set of candidates: {e}"))?;
        let half = |(p, q): (&[T; 3], &[T; 3])| -> [T; 3] {
            let at = |k: usize| p[k].to_f64() + 0.5 * (q[k].to_f64() - p[k].to_f64());
            [0, 1, 2].map(|k| T::from_f64(at(k)))
        };
        let halves: Vec<[T; 3]> = x0.iter().zip(x1).map(half).collect();
        for x1 in [x1, &halves] {
            let all = fresh.step(x0, x1).map_err(of_new)?;
            let found = set.earliest_toi(x0, x1);
            self.check_earliest(all, found.map_err(|e| format!("a set of candidates: {e}"))?)?;
        }
        Ok(())
    }

    /// The candidates that a session lists beside those of another one.
    fn check_candidates<T: ccd::Coordinate>(
        &mut self,
        other: &mut ccd::Session,
        [x0, x1]: [&Vec<[T; 3]>; 2],
    ) -> Result<(), String> {
        let want = other.candidates(x0, x1).map_err(of_new)?;
        let want = [want.vf.to_vec(), want.ee.to_vec(), want.ve.to_vec(), want.vv.to_vec()];
        let found = self.session.candidates(x0, x1).map_err(an_error)?;
        let found = [found.vf, found.ee, found.ve, found.vv].map(|pairs| pairs.into_vec());
        let [n, right] = [&found, &want].map(|lists| lists.each_ref().map(|pairs| pairs.len()));
        if found.map(sorted) != want.map(sorted) {
            return Err(format!("{n:?} candidates are listed, right are others, {right:?}"));
        }
        Ok(())
    }
}

pub fn of_new(why: ccd::Error) -> String {
    format!("a new session: {why}")
}

pub fn an_error(why: Error) -> String {
    format!("an error: {why}")
}

/// The report of what was submitted, once the device is done.
fn polled(on: &mut gpu::Session) -> Result<Report, Error> {
    loop {
        if let Some(report) = on.poll()? {
            return Ok(report.clone());
        }
    }
}

fn sorted(mut pairs: Vec<Pair>) -> Vec<Pair> {
    pairs.sort_unstable();
    pairs
}

type Numbers = (Option<f64>, PerKind, Option<PerKind>, u64, Option<TriangleCounts>);

/// What a report counts, the same whatever a session did before; without what oriented boxes
/// separate.
fn numbers(r: &Report, with_filtered: bool) -> Numbers {
    let triangles = r.triangles.map(|mut of| {
        of.separated = 0;
        of
    });
    (r.toi, r.candidates, with_filtered.then_some(r.filtered), r.undecided, triangles)
}
