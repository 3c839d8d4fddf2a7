//! One method on one scene at one place.

use super::scenes::Case;
use crate::cells::Cells;
use crate::measure::{Place, median, warm};
use ccd::method::{BroadPhaseMethod, TreeStatistics};
use ccd::{BroadPhase, Error};
use serde_json::{Value, json};

/// Medians in milliseconds, of a GPU by its timestamps.
#[derive(Clone, Copy, Debug)]
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
    let value = cells.get(&name, || {
        Ok(match measure(place, method, case)? {
            Ok(m) => {
                let tree = m.tree.map(|t| (t.nodes, t.depth, t.sah_cost, t.visited_per_query));
                json!([m.build, m.search, m.visits, tree])
            }
            Err(why) => json!(why),
        })
    })?;
    let Some(value) = value else { return Ok(None) };
    if let Some(why) = value.as_str() {
        return Ok(Some(Err(why.into())));
    }
    let measured = of_json(&value).ok_or_else(|| format!("{name}: not a cell of this report"))?;
    Ok(Some(Ok(measured)))
}

fn of_json(value: &Value) -> Option<Measured> {
    let [build, search, visits, tree] = &value.as_array()?[..] else { return None };
    let tree = match &tree.as_array().map(Vec::as_slice) {
        Some([nodes, depth, cost, visited]) => Some(TreeStatistics {
            nodes: nodes.as_u64()? as usize,
            depth: depth.as_u64()? as usize,
            sah_cost: cost.as_f64()?,
            visited_per_query: visited.as_f64()?,
        }),
        _ => None,
    };
    let (build, search) = (build.as_f64()?, search.as_f64()?);
    Some(Measured { build, search, visits: visits.as_u64()?, tree })
}

fn measure(
    place: &Place,
    method: BroadPhaseMethod,
    case: &Case,
) -> Result<Result<Measured, &'static str>, String> {
    match place {
        Place::Cpu { threads, .. } => match on_cpu(*threads, method, case) {
            Ok(measured) => Ok(Ok(measured)),
            Err(Failure::Refused(Error::Method { .. })) => Ok(Err("")),
            Err(Failure::Refused(_)) => Ok(Err("refused")),
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
