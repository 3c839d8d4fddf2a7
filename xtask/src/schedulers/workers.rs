//! Tables 4.2 and 4.5 of [da Silva 2013] over the number of workers of a GPU: the same device with
//! more and more of its workgroups, where the dissertation has two devices.

use super::measure::{Effort, kept};
use super::scenes::Scene;
use super::tables::{BALANCED, LAZY, TREE, ms};
use crate::cells::Cells;
use crate::markdown::Table;
use crate::measure::Place;
use ccd::method::{Scheduling, WorkerOptions};
use std::fmt::Write;

const WORKERS: [u32; 5] = [16, 64, 256, 1024, 2048];

/// Milliseconds of a step; empty where there is no GPU.
pub fn table(
    scenes: &[Scene],
    places: &[Place],
    effort: Effort,
    cells: &mut Cells,
) -> Result<String, String> {
    let mut text = String::new();
    let Some(place) = places.iter().find(|place| place.threads() == 0) else { return Ok(text) };
    for name in [LAZY, BALANCED] {
        let row = super::rows(place.backend()).into_iter().find(|row| row.name == name);
        let scheduling = row.ok_or_else(|| format!("{name}: no scheduler of a GPU"))?.scheduling;
        let all = WORKERS.map(|n| scheduling.workers(WorkerOptions::default().workers(n)));
        let (few, many) = (WORKERS[0], WORKERS[WORKERS.len() - 1]);
        let columns = [name.to_owned()].into_iter().chain(WORKERS.map(|n| n.to_string()));
        let mut table = Table::new(columns.chain([format!("{few} to {many}")]));
        for scene in scenes {
            let all: &[Scheduling] = &all;
            let measured = kept(cells, place, scene, TREE, all, effort)?;
            let ratio = match (&measured[0], &measured[WORKERS.len() - 1]) {
                (Some(few), Some(many)) => format!("{:.2}", few.ms() / many.ms()),
                _ => String::new(),
            };
            let times = measured.iter().map(|cell| ms(cell.as_ref()));
            table.row([scene.name.clone()].into_iter().chain(times).chain([ratio]));
        }
        let _ = writeln!(text, "{table}");
    }
    Ok(text)
}
