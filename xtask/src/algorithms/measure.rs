//! One method on one scene at one place.

use super::scenes::Case;
use ccd::{BroadPhase, BroadPhaseMethod, Error, TreeStatistics};
use std::time::{Duration, Instant};

/// Where a method runs.
pub enum Place {
    /// So many threads.
    Cpu { threads: usize, name: String },
    /// The first GPU that there is.
    Gpu { device: ccd::gpu::Device, name: String },
}

/// Medians in milliseconds, of a GPU by its timestamps.
#[derive(Clone, Copy, Debug)]
pub struct Measured {
    pub build: f64,
    pub search: f64,
    pub visits: u64,
    pub tree: Option<TreeStatistics>,
}

/// A method is measured for so long at most, once at least.
const LONG_ENOUGH: Duration = Duration::from_millis(500);

impl Place {
    /// One thread, all threads, and the GPU if there is one.
    pub fn all() -> Result<Vec<Self>, String> {
        let all = std::thread::available_parallelism().map_or(1, |n| n.get());
        let mut places = vec![Self::one_thread()];
        if all > 1 {
            places.push(Self::Cpu { threads: all, name: format!("{all} threads") });
        }
        match ccd::gpu::Device::open(&ccd::gpu::DeviceOptions::default()) {
            Ok(device) => {
                let name = device.info().adapter.name.clone();
                places.push(Self::Gpu { device, name });
            }
            Err(why) => println!("without a GPU: {why}"),
        }
        Ok(places)
    }

    /// The calling thread alone.
    pub fn one_thread() -> Self {
        Self::Cpu { threads: 1, name: "1 thread".into() }
    }

    pub fn name(&self) -> &str {
        match self {
            Self::Cpu { name, .. } => name,
            Self::Gpu { name, .. } => name,
        }
    }
}

/// What was measured, or why the method refuses the scene.
pub fn measure(
    place: &Place,
    method: BroadPhaseMethod,
    case: &Case,
    runs: usize,
) -> Result<Result<Measured, &'static str>, String> {
    match place {
        Place::Cpu { threads, .. } => match on_cpu(*threads, method, case, runs) {
            Ok(measured) => Ok(Ok(measured)),
            Err(Failure::Refused(Error::Method { .. })) => Ok(Err("")),
            Err(Failure::Refused(_)) => Ok(Err("refused")),
            Err(Failure::Wrong(why)) => Err(why),
        },
        Place::Gpu { device, .. } => on_gpu(device, method, case, runs),
    }
}

enum Failure {
    Refused(Error),
    Wrong(String),
}

fn on_cpu(
    threads: usize,
    method: BroadPhaseMethod,
    case: &Case,
    runs: usize,
) -> Result<Measured, Failure> {
    let mut broad = BroadPhase::new(threads, method).map_err(Failure::Refused)?;
    let mut times = Vec::new();
    let start = Instant::now();
    // The first finds room for everything.
    for run in 0..=runs {
        let found = match &case.against {
            None => broad.self_pairs(&case.boxes),
            Some(other) => broad.pairs(other, &case.boxes),
        };
        check(case, method, found.map_err(Failure::Refused)?.len()).map_err(Failure::Wrong)?;
        let long = start.elapsed() > LONG_ENOUGH;
        if run > 0 || long {
            times.push(broad.times());
        }
        if long {
            break;
        }
    }
    let build = median(times.iter().map(|t| t.build));
    let (search, visits) = (median(times.iter().map(|t| t.search)), broad.visits());
    Ok(Measured { build, search, visits, tree: broad.tree_statistics() })
}

fn on_gpu(
    device: &ccd::gpu::Device,
    method: BroadPhaseMethod,
    case: &Case,
    runs: usize,
) -> Result<Result<Measured, &'static str>, String> {
    use ccd::gpu::Timing;
    let mut broad = match ccd::gpu::BroadPhase::new(device, method) {
        Ok(broad) => broad,
        Err(ccd::gpu::Error::Input(Error::Method { .. })) => return Ok(Err("")),
        Err(e) => return Err(e.to_string()),
    };
    let found = match &case.against {
        None => broad.self_pairs(&case.boxes),
        Some(other) => broad.pairs(other, &case.boxes),
    };
    match found {
        Ok(pairs) => check(case, method, pairs.len())?,
        Err(ccd::gpu::Error::Input(_)) => return Ok(Err("refused")),
        Err(e) => return Err(e.to_string()),
    }
    broad.set_timing(Timing::Stages).map_err(|e| e.to_string())?;
    let (mut builds, mut searches) = (Vec::new(), Vec::new());
    let start = Instant::now();
    // As long as a device needs to reach its clock, and then so many.
    while builds.len() < runs {
        broad.again().map_err(|e| e.to_string())?;
        if start.elapsed() > Duration::from_millis(300) {
            let of = |search: bool| {
                let stages = broad.stages().iter();
                stages.filter(|s| s.0.contains("pairs") == search).map(|s| s.1).sum::<f64>()
            };
            builds.push(of(false));
            searches.push(of(true));
        }
    }
    let search = median(searches.into_iter());
    Ok(Ok(Measured { build: median(builds.into_iter()), search, visits: 0, tree: None }))
}

fn check(case: &Case, method: BroadPhaseMethod, found: usize) -> Result<(), String> {
    if found == case.n_pairs {
        Ok(())
    } else {
        Err(format!("{}: {found} pairs by {method}, right are {}", case.name, case.n_pairs))
    }
}

/// The middle one; 0 of none.
pub fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_unstable_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}
