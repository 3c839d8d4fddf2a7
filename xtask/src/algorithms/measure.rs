//! One method on one scene at one place.

use super::scenes::Case;
use crate::cells::Cells;
use crate::measure::{Place, median, warm};
use ccd::method::{BroadPhaseMethod, TreeStatistics};
use ccd::{BroadPhase, Error};
use serde::{Deserialize, Serialize};

/// Medians in milliseconds, of a GPU by its timestamps.
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
pub struct Measured {
    pub build: f64,
    pub search: f64,
    pub visits: u64,
    pub tree: Option<TreeStatistics>,
}

/// Runs of each cell after a warm-up; medians are reported.
pub const RUNS: usize = 12;

/// Measurements, or why the method refuses the scene.
pub type Cell = Result<Measured, String>;

/// A method on a scene at a place, one for all tables; `None` if it is left for another run.
pub fn kept(
    cells: &mut Cells,
    place: &Place,
    method: BroadPhaseMethod,
    case: &Case,
) -> Result<Option<Cell>, String> {
    let name = format!("{}|{}|{method:?}|{RUNS}", case.name, place.name());
    cells.get(&name, || measure(place, method, case))
}

fn measure(place: &Place, method: BroadPhaseMethod, case: &Case) -> Result<Cell, String> {
    match place {
        Place::Cpu { threads, .. } => match on_cpu(*threads, method, case) {
            Ok(measured) => Ok(Ok(measured)),
            Err(Failure::Refused(Error::Method { .. })) => Ok(Err(String::new())),
            Err(Failure::Refused(_)) => Ok(Err("refused".into())),
            Err(Failure::Wrong(why)) => Err(why),
        },
        Place::Gpu { device, .. } => on_gpu(device, method, case),
    }
}

enum Failure {
    Refused(Error),
    Wrong(String),
}

fn on_cpu(threads: usize, method: BroadPhaseMethod, case: &Case) -> Result<Measured, Failure> {
    let mut broad = BroadPhase::new(threads, method).map_err(Failure::Refused)?;
    // The warm-up also allocates every buffer.
    let times = warm(RUNS, || {
        let found = match &case.against {
            None => broad.self_pairs(&case.boxes),
            Some(other) => broad.pairs(other, &case.boxes),
        };
        check(case, method, found.map_err(Failure::Refused)?.len()).map_err(Failure::Wrong)?;
        Ok(broad.times())
    })?;
    let build = median(times.iter().map(|t| t.build));
    let (search, visits) = (median(times.iter().map(|t| t.search)), broad.visits());
    Ok(Measured { build, search, visits, tree: broad.tree_statistics() })
}

fn on_gpu(
    device: &ccd::gpu::Device,
    method: BroadPhaseMethod,
    case: &Case,
) -> Result<Cell, String> {
    use ccd::gpu::Timing;
    let mut broad = match ccd::gpu::BroadPhase::new(device, method) {
        Ok(broad) => broad,
        Err(ccd::gpu::Error::Input(Error::Method { .. })) => return Ok(Err(String::new())),
        Err(e) => return Err(e.to_string()),
    };
    let found = match &case.against {
        None => broad.self_pairs(&case.boxes),
        Some(other) => broad.pairs(other, &case.boxes),
    };
    match found {
        Ok(pairs) => check(case, method, pairs.len())?,
        Err(ccd::gpu::Error::Input(_)) => return Ok(Err("refused".into())),
        Err(e) => return Err(e.to_string()),
    }
    broad.set_timing(Timing::Stages).map_err(|e| e.to_string())?;
    let sum = |stages: &[(&str, f64)], search: bool| {
        stages.iter().filter(|s| s.0.contains("pairs") == search).map(|s| s.1).sum::<f64>()
    };
    let times = warm(RUNS, || {
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
