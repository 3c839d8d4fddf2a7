//! A step of a session beside that of a new one by brute force; on a CPU also beside that of a new
//! one by the same method, and every pair by itself.

use super::Counts;
use super::session_steps::{State, keeps};
use ccd::method::{BroadPhaseMethod, Pipeline, Scheduling, TriangleCounts, TriangleOptions};
use ccd::{Contact, Options, Pair, PerKind, Report, State as Certainty};
use ccd_testkit::brute::{check_pairs, every_pair};
use ccd_testkit::compare::agree_within;
use ccd_testkit::grazing::random::Random;

/// Edges of a mesh of which every pair is asked by itself, at most: a search is for many scenes.
const MOST_EDGES: usize = 150;

impl State<'_> {
    /// A step, and that of a new session by brute force.
    pub fn check(&mut self, random: &mut Random, counts: &mut Counts) -> Result<(), String> {
        let ends = self.ends();
        let window = [[0.0, 1.0], [0.0, 1.0], [0.1, 0.7], [0.25, 0.25], [0.5, 1.0], [1.0, 1.0]]
            [random.below(6)];
        let (narrow, earliest) = (random.below(4) == 0, random.below(4) == 0);
        let plain = self
            .session
            .options()
            .clone()
            .with_broad_phase(BroadPhaseMethod::BruteForce)
            .with_scheduling(Scheduling::default())
            .with_pipeline(Pipeline::Features)
            .with_threads(1);
        let mut fresh = self.new_session(plain)?;
        if narrow {
            let ends = ends.map(|x| x.iter().map(|p| p.map(|c| c as f32)).collect::<Vec<_>>());
            self.compare(&mut fresh, &ends, window, earliest, counts)
        } else {
            self.compare(&mut fresh, &ends, window, earliest, counts)
        }
    }

    /// A session of the same mesh and filter.
    fn new_session(&self, options: Options) -> Result<ccd::Session, String> {
        let mut fresh = ccd::Session::new(&self.step.mesh, options).map_err(of_new)?;
        let n = self.filter;
        fresh.set_filter(move |_, a, b| keeps(n, a, b)).map_err(|e| format!("a filter: {e}"))?;
        Ok(fresh)
    }

    fn compare<T: ccd::Coordinate>(
        &mut self,
        fresh: &mut ccd::Session,
        ends: &[Vec<[T; 3]>; 2],
        window: [f64; 2],
        earliest: bool,
        counts: &mut Counts,
    ) -> Result<(), String> {
        let on_gpu = self.place.backend() == "gpu";
        let tolerance = self.session.options().tolerance;
        // A device's time is as early as it may be by itself, and rounded down to an `f32`.
        let slack = if on_gpu { tolerance + 1.1e-6 } else { 0.0 };
        let [x0, x1] = ends;
        if earliest {
            let all = fresh.step(x0, x1).map_err(of_new)?;
            let hits = all.contacts.iter().filter(|c| c.state == Certainty::Hit);
            let first = hits.map(|c| c.toi).reduce(f64::min);
            let found = self.session.earliest_toi(x0, x1).map_err(|e| format!("an error: {e}"))?;
            let late = first.is_some_and(|first| found.is_none_or(|t| t > first + slack));
            // Only one of a pair that is undecided may be earlier.
            let early = all.toi.zip(found).is_some_and(|(all, t)| t < all - slack);
            if late || early || !on_gpu && all.toi.is_some() != found.is_some() {
                return Err(format!("earliest time {found:?}, of all contacts {:?}", all.toi));
            }
        }
        let found =
            self.session.step_window(x0, x1, window).map_err(|e| format!("an error: {e}"))?.clone();
        let want = fresh.step_window(x0, x1, window).map_err(of_new)?;
        counts.add("contacts", want.contacts.len() as u64);
        same(&found, want, on_gpu.then_some(tolerance))?;
        if found.mesh() != &self.step.mesh {
            return Err("a report of another mesh".into());
        }
        // A device sweeps the boxes of a window itself, in `f32`, and those of a tiny scene in a
        // unit of its own: there it may take up other candidates.
        let other_boxes = on_gpu && (window != [0.0, 1.0] || self.unit < 1e-30);
        if !self.has_free_regions() && !other_boxes && found.candidates != want.candidates {
            return Err(format!("candidates {:?}, {:?}", found.candidates, want.candidates));
        }
        if on_gpu {
            return Ok(());
        }
        self.check_every_pair(ends, window, &found);
        self.check_same_method(fresh, ends, window, earliest, &found)
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
        let other = if self.has_free_regions() { &mut fresh } else { by_brute_force };
        let want = other.candidates(x0, x1).map_err(of_new)?;
        let want = [want.vf.to_vec(), want.ee.to_vec(), want.ve.to_vec(), want.vv.to_vec()];
        let found = self.session.candidates(x0, x1).map_err(|e| format!("an error: {e}"))?;
        let found = [found.vf, found.ee, found.ve, found.vv].map(|pairs| pairs.into_vec());
        let [n, right] = [&found, &want].map(|lists| lists.each_ref().map(|pairs| pairs.len()));
        if found.map(sorted) != want.map(sorted) {
            return Err(format!("{n:?} candidates are listed, right are others, {right:?}"));
        }
        Ok(())
    }
}

fn of_new(why: ccd::Error) -> String {
    format!("a new session: {why}")
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

/// The same contacts; of a GPU what both are certain of.
fn same(found: &Report, want: &Report, on_gpu: Option<f64>) -> Result<(), String> {
    if let Some(tolerance) = on_gpu {
        return agree_within(&want.contacts, &found.contacts, tolerance.max(1e-9));
    }
    if found.contacts == want.contacts {
        return Ok(());
    }
    let key = |c: &Contact| (c.kind, c.a, c.b);
    let other = want.contacts.iter().zip(&found.contacts).find(|(a, b)| key(a) != key(b) || a != b);
    let [n, right] = [found, want].map(|r| r.contacts.len());
    Err(format!("{n} contacts, {right} are right; the first that differ: {other:?}"))
}
