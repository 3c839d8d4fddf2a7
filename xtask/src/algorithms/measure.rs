//! One method on one scene at one place.

use super::scenes::Case;
use crate::measure::{Place, median, warm};
use ccd::{BroadPhase, BroadPhaseMethod, Error, TreeStatistics};
use std::time::{Duration, Instant};

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

/// Measurements, or why the method refuses the scene.
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
    // The first allocates every buffer.
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
    let sum = |stages: &[(&str, f64)], search: bool| {
        stages.iter().filter(|s| s.0.contains("pairs") == search).map(|s| s.1).sum::<f64>()
    };
    let times = warm(runs, || {
        broad.again()?;
        Ok([sum(broad.stages(), false), sum(broad.stages(), true)])
    });
    let times = times.map_err(|e: ccd::gpu::Error| e.to_string())?;
    let [build, search] = [0, 1].map(|k| median(times.iter().map(|t| t[k])));
    Ok(Ok(Measured { build, search, visits: 0, tree: None }))
}

fn check(case: &Case, method: BroadPhaseMethod, found: usize) -> Result<(), String> {
    if found == case.n_pairs {
        Ok(())
    } else {
        Err(format!("{}: {found} pairs by {method}, right are {}", case.name, case.n_pairs))
    }
}
