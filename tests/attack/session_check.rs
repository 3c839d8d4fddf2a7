//! A step of a session beside that of a new one by brute force.

use super::Counts;
use super::session_steps::State;
use ccd::method::{BroadPhaseMethod, Pipeline, Scheduling, TriangleOptions};
use ccd::{Contact, Report, State as Certainty};
use ccd_testkit::compare::agree_within;
use ccd_testkit::grazing::random::Random;

impl State<'_> {
    /// A step, and that of a new session by brute force.
    pub fn check(&mut self, random: &mut Random, counts: &mut Counts) -> Result<(), String> {
        let ends = self.ends();
        let window =
            [[0.0, 1.0], [0.0, 1.0], [0.1, 0.7], [0.25, 0.25], [0.5, 1.0]][random.below(5)];
        let (narrow, earliest) = (random.below(4) == 0, random.below(4) == 0);
        let options = self.session.options();
        let plain = options
            .clone()
            .with_broad_phase(BroadPhaseMethod::BruteForce)
            .with_scheduling(Scheduling::default())
            .with_pipeline(Pipeline::Features)
            .with_threads(1);
        let mut fresh = ccd::Session::new(self.session.mesh().clone(), plain)
            .map_err(|e| format!("a new session: {e}"))?;
        let n = self.filter;
        fresh
            .set_filter(move |_, a, b| n == 0 || (a + b) % n != 0)
            .map_err(|e| format!("a filter: {e}"))?;
        if narrow {
            let ends = ends.map(|x| x.iter().map(|p| p.map(|c| c as f32)).collect::<Vec<_>>());
            self.compare(&mut fresh, &ends, window, earliest, counts)
        } else {
            self.compare(&mut fresh, &ends, window, earliest, counts)
        }
    }

    fn compare<T: ccd::Coordinate>(
        &mut self,
        fresh: &mut ccd::Session,
        [x0, x1]: &[Vec<[T; 3]>; 2],
        window: [f64; 2],
        earliest: bool,
        counts: &mut Counts,
    ) -> Result<(), String> {
        let on_gpu = self.place.backend() == "gpu";
        let tolerance = self.session.options().tolerance;
        // A device's time is as early as it may be by itself, and rounded down to an `f32`.
        let slack = if on_gpu { tolerance + 1.1e-6 } else { 0.0 };
        if earliest {
            let all = fresh.step(x0, x1).map_err(|e| format!("a new session: {e}"))?;
            let hits = all.contacts.iter().filter(|c| c.state == Certainty::Hit);
            let first = hits.map(|c| c.toi).reduce(f64::min);
            let found = self.session.earliest_toi(x0, x1).map_err(|e| format!("an error: {e}"))?;
            let late = first.is_some_and(|first| found.is_none_or(|t| t > first + slack));
            // Only one of a pair that is undecided may be earlier.
            let early = all.toi.zip(found).is_some_and(|(all, t)| t < all - slack);
            if late || early || all.toi.is_none() && found.is_some() && !on_gpu {
                return Err(format!("earliest time {found:?}, of all contacts {:?}", all.toi));
            }
        }
        let found =
            self.session.step_window(x0, x1, window).map_err(|e| format!("an error: {e}"))?.clone();
        let want = fresh.step_window(x0, x1, window).map_err(|e| format!("a new session: {e}"))?;
        counts.add("contacts", want.contacts.len() as u64);
        let free_regions = matches!(
            self.session.options().pipeline,
            Pipeline::Triangles(TriangleOptions { free_regions: true, .. })
        );
        same(&found, want, on_gpu.then_some(tolerance))?;
        // A device sweeps the boxes of a window itself, in `f32`, and those of a tiny scene in a
        // unit of its own: there it may take up other candidates.
        let other_boxes = on_gpu && (window != [0.0, 1.0] || self.unit < 1e-30);
        if !free_regions && !other_boxes && found.candidates != want.candidates {
            return Err(format!("candidates {:?}, {:?}", found.candidates, want.candidates));
        }
        Ok(())
    }
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
