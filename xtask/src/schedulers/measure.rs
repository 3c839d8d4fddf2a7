//! All schedulers on one scene at one place, in turn on every frame, so that a machine that is
//! busy for a while is so for all of them.

use super::scenes::{Counts, Scene};
use crate::cells::Cells;
use crate::measure::{Place, median};
use crate::stages::part;
use ccd::any::{self, Session};
use ccd::method::{
    BroadPhaseMethod, FrontCounts, Pipeline, Scheduling, Traversal, TreeOptions, Volume,
};
use ccd::{Error, Options, gpu};
use serde::{Deserialize, Serialize};
use std::fmt::Display;
use std::time::{Duration, Instant};

/// Structure that is descended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Structure {
    /// Binary trees, by pairs of nodes.
    Tree(Volume),
    /// Blocks.
    Blocks,
}

/// Length of a measurement.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Steps that are timed, at most.
    pub steps: usize,
    /// Steps that are timed however long they take.
    pub least: usize,
    /// After so long a time no step beyond those is timed.
    pub enough: Duration,
}

/// Steps before those that are timed: the first finds out how long a front is, the second makes
/// it, and the third begins at it.
pub const WARM: usize = 2;
/// Steps after those, whose parts are timed.
pub const WATCHED: usize = 2;

/// Measurements of one scheduler.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
pub struct Measured {
    /// Milliseconds of every step that was timed; on a GPU by its timestamps.
    pub steps: Vec<f64>,
    /// Fronts that these steps left.
    pub fronts: Vec<FrontCounts>,
    /// Number of these steps that built trees anew.
    pub n_rebuilt: usize,
    /// Parts of the steps after them.
    pub shares: Shares,
}

/// Milliseconds of a step, and how busy workers were.
#[derive(Clone, Copy, Debug, Default, Deserialize, Serialize)]
pub struct Shares {
    /// By [`PARTS`](crate::stages::PARTS).
    pub parts: [f64; 5],
    /// Part of the workers' time in which they have pairs, while pairs are shared out; on a GPU
    /// part of the turns of all their threads. Unknown where it is not counted.
    pub utilisation: Option<f64>,
}

impl Shares {
    /// The mean of some.
    fn mean(all: &[Self]) -> Self {
        let n = all.len().max(1) as f64;
        let utilisation: Option<f64> = all.iter().map(|shares| shares.utilisation).sum();
        Self {
            parts: std::array::from_fn(|k| {
                all.iter().map(|shares| shares.parts[k]).sum::<f64>() / n
            }),
            utilisation: utilisation.map(|sum| sum / n),
        }
    }
}

impl Measured {
    /// The middle one of all steps.
    pub fn ms(&self) -> f64 {
        median(self.steps.iter().copied())
    }

    /// Pairs of a front, on average; 0 if there was none.
    pub fn front_pairs(&self) -> f64 {
        self.fronts.iter().map(|f| f.pairs as f64).sum::<f64>() / self.fronts.len().max(1) as f64
    }
}

impl Structure {
    pub const ALL: [Self; 3] = [Self::Tree(Volume::Aabb), Self::Tree(Volume::Obb), Self::Blocks];

    pub fn name(self) -> &'static str {
        match self {
            Self::Tree(Volume::Aabb) => "tree",
            Self::Tree(_) => "obb",
            Self::Blocks => "blocks",
        }
    }

    /// From the roots where a backend has that, else from a cut.
    pub fn method(self, backend: &str) -> BroadPhaseMethod {
        let Self::Tree(volume) = self else { return BroadPhaseMethod::Blocks };
        let tree = |traversal| {
            BroadPhaseMethod::Tree(TreeOptions::default().volume(volume).traversal(traversal))
        };
        let from_roots = tree(Traversal::SIMULTANEOUS);
        if from_roots.lacking(backend).is_none() { from_roots } else { tree(Traversal::CUT) }
    }
}

/// A session at a place; `None`: the place does not have these options.
fn open(place: &Place, scene: &Scene, options: Options) -> Result<Option<Session>, any::Error> {
    let options = options.with_threads(place.threads());
    match Session::new(&place.choice(), scene.mesh.clone(), options) {
        Ok(session) => Ok(Some(session)),
        Err(any::Error::Input(Error::Method { .. }) | any::Error::NoStealing { .. }) => Ok(None),
        Err(e) => Err(e),
    }
}

/// Sets what is timed in each step: all of it, or, if `watched`, also its parts.
fn set_timing(session: &mut Session, watched: bool) -> Result<(), any::Error> {
    match session.gpu() {
        Some(on) if watched => on.set_timing(gpu::Timing::Stages),
        Some(on) => on.set_timing(gpu::Timing::Whole),
        None => {
            session.cpu().into_iter().for_each(|on| on.set_timed(watched));
            Ok(())
        }
    }
}

/// Milliseconds of the last step.
fn ms(session: &mut Session) -> f64 {
    let on_cpu = session.report().times.total;
    session.gpu().map_or(on_cpu, |on| on.stages().iter().map(|stage| stage.1).sum())
}

/// Shares of the last step, which was watched.
fn shares(session: &mut Session) -> Result<Shares, String> {
    match session.gpu() {
        Some(on) => of_gpu(on),
        None => Ok(session.cpu().map(|on| of_cpu(on)).unwrap_or_default()),
    }
}

/// Shares on the CPU; times of workers are divided by their number.
fn of_cpu(session: &ccd::Session) -> Shares {
    let times = session.report().times;
    let descents = session.descent_times().unwrap_or_default();
    let n = session.threads() as f64;
    let (refit, front) = (times.boxes + times.build, descents.keep + descents.front / n);
    let waits = descents.balancing(session.threads());
    let balancing = waits / n;
    // Rows are handed on to what expands triangles, and filters and decides features.
    let intersection = (descents.rows / n).max(times.narrow);
    let traversal = times.total - refit - front - balancing - intersection;
    let all = n * descents.shared_out;
    Shares {
        parts: [refit, front, traversal.max(0.0), balancing, intersection],
        utilisation: (all > 0.0).then(|| 1.0 - waits / all),
    }
}

/// Shares on a GPU, by its stages.
fn of_gpu(session: &mut gpu::Session) -> Result<Shares, String> {
    let mut shares = Shares::default();
    for &(name, ms) in session.stages() {
        shares.parts[part(name)?] += ms;
    }
    shares.utilisation = utilisation(session).map_err(|e| e.to_string())?;
    Ok(shares)
}

/// Part of all turns that expanded a pair, or helped to, if every worker went on for as long as the
/// last; `None` without workers.
fn utilisation(session: &mut gpu::Session) -> Result<Option<f64>, any::Error> {
    let n_kinds = if session.options().pipeline == Pipeline::Features { 2 } else { 1 };
    let counts = session.worker_counts()?;
    let (mut expanded, mut turns) = (0, 0);
    for kind in counts.chunks((counts.len() / n_kinds).max(1)) {
        let last = kind.iter().map(|worker| worker.turns as u64).max().unwrap_or(0);
        expanded += kind.iter().map(|worker| worker.expanded as u64).sum::<u64>();
        let width = kind.first().map_or(1, |worker| worker.width as u64);
        turns += last * kind.len() as u64 * width;
    }
    Ok((turns > 0).then(|| expanded as f64 / turns as f64))
}

/// The same as [`measure`], of a group that is kept: it is measured at most once.
pub fn kept(
    cells: &mut Cells,
    place: &Place,
    scene: &Scene,
    structure: Structure,
    all: &[Scheduling],
    effort: Effort,
) -> Result<Vec<Option<Measured>>, String> {
    let (name, pipeline) = (&scene.name, scene.pipeline);
    let name = format!("{name}|{pipeline:?}|{}|{structure:?}|{all:?}|{effort:?}", place.name());
    let group = cells.get(&name, || measure(place, scene, structure, all, effort))?;
    Ok(group.unwrap_or_else(|| vec![None; all.len()]))
}

/// Steps a scene by all of these in turn; `None`: the place does not have it. Every step has the
/// pairs of the default, or this fails.
fn measure(
    place: &Place,
    scene: &Scene,
    structure: Structure,
    all: &[Scheduling],
    effort: Effort,
) -> Result<Vec<Option<Measured>>, String> {
    let broad_phase = structure.method(place.backend());
    let options = |&scheduling: &Scheduling| {
        scene.options().with_broad_phase(broad_phase).with_scheduling(scheduling)
    };
    let failed = |scheduling: &Scheduling, why: &dyn Display| {
        format!("{}, {}, {broad_phase}, {scheduling}: {why}", scene.name, place.name())
    };
    let mut sessions = Vec::new();
    for scheduling in all {
        let session = open(place, scene, options(scheduling));
        let session = session.map_err(|e| failed(scheduling, &e))?;
        sessions.push(session.map(|session| (session, Measured::default(), Vec::new())));
    }
    let n_steps = scene.frames.len() - 1;
    let (mut start, mut n_timed, mut n_watched) = (Instant::now(), 0, 0);
    for (i, (x, want)) in scene.frames.windows(2).zip(&scene.counts).enumerate() {
        let warm = i < WARM;
        let left = n_steps - i;
        let is_timed = !warm
            && left > WATCHED
            && n_watched == 0
            && n_timed < effort.steps
            && (n_timed < effort.least || start.elapsed() < effort.enough);
        if i == WARM {
            start = Instant::now();
        }
        for (session, scheduling) in sessions.iter_mut().zip(all) {
            let Some((session, measured, all_shares)) = session else { continue };
            let why = |e| failed(scheduling, &e);
            // Watched from zero before each step.
            let is_watched = !warm && !is_timed;
            if i == 0 || is_watched {
                set_timing(session, is_watched).map_err(why)?;
            }
            let report = session.step(&x[0], &x[1]).map_err(why)?;
            let found = Counts::of(report);
            if found != *want {
                let what = format!("step {i}: {found:?}, right is {want:?}");
                return Err(failed(scheduling, &what));
            }
            if is_timed {
                measured.fronts.extend(report.front);
                measured.n_rebuilt += report.rebuilt as usize;
                measured.steps.push(ms(session));
            } else if !warm {
                all_shares.push(shares(session).map_err(|e| failed(scheduling, &e))?);
            }
        }
        n_timed += is_timed as usize;
        n_watched += (!warm && !is_timed) as usize;
        if n_watched == WATCHED {
            break;
        }
    }
    let done = |(_, measured, shares): (Session, Measured, Vec<Shares>)| Measured {
        shares: Shares::mean(&shares),
        ..measured
    };
    Ok(sessions.into_iter().map(|session| session.map(done)).collect())
}
