//! When a front is given up: settings beside each other, over more steps.

use super::measure::{Effort, Measured, Structure, WARM, WATCHED, kept};
use super::scenes;
use crate::cells::Cells;
use crate::markdown::{Table, digits};
use crate::measure::Place;
use crate::plot;
use ccd::method::{Front, FrontOptions, Scheduler, Scheduling, Volume};
use std::fmt::Write;
use std::path::Path;
use std::time::Duration;

/// Names, and what they stand for; without a front first.
fn settings() -> Vec<(String, Front)> {
    let never = FrontOptions::default().growth(u32::MAX).rebuild(1, 0);
    let mut all = vec![
        ("no front".to_owned(), Front::Off),
        ("kept for as long as trees are".to_owned(), Front::On(never)),
    ];
    for growth in [102, 110, 125, 150] {
        all.push((format!("dropped beyond {growth} %"), Front::On(never.growth(growth))));
    }
    for (period, threshold) in [(1, 101), (4, 101), (4, 110), (16, 101)] {
        let name = format!("dropped if less than {threshold} % after {period}");
        all.push((name, Front::On(never.rebuild(period, threshold))));
    }
    all
}

/// Means of all steps: the ones that begin at the roots are a part of them.
pub fn table(
    threads: usize,
    wanted: &dyn Fn(&str) -> bool,
    quick: bool,
    plots: &Path,
    cells: &mut Cells,
) -> Result<String, String> {
    let steps = if quick { 6 } else { 40 };
    let least = if quick { 2 } else { 12 };
    let effort = Effort { steps, least, enough: Duration::from_secs(if quick { 1 } else { 6 }) };
    let names = ["BART4096", "funnel", "debris-wall, features"];
    let is_one = |name: &str| wanted(name) && names.contains(&name);
    let all = scenes::all(&is_one, WARM + steps + WATCHED + 1)?;
    let place = Place::Cpu { threads };
    let settings = settings();
    let scheduling =
        |front| Scheduling::default().scheduler(Scheduler::SelfScheduling).front(front);
    let choices: Vec<Scheduling> = settings.iter().map(|s| scheduling(s.1)).collect();
    let mut text = format!(
        "Self-scheduling by {}: mean ms of a step, and in brackets thousand pairs of its \
         front.\n\n",
        place.name()
    );
    let structures = [Structure::Tree(Volume::Aabb), Structure::Blocks];
    for structure in structures {
        let mut columns = Vec::new();
        for scene in &all {
            columns.push(kept(cells, &place, scene, structure, &choices, effort)?);
        }
        let heads = all.iter().map(|scene| scene.name.as_str());
        let mut table = Table::new([structure.name()].into_iter().chain(heads));
        for (k, (name, _)) in settings.iter().enumerate() {
            let cells = columns.iter().map(|column| cell(column[k].as_ref()));
            table.row([name.clone()].into_iter().chain(cells));
        }
        let _ = writeln!(text, "{table}");
        if structure == structures[0] {
            text += &drawn(&all, &columns, &settings, plots)?;
        }
    }
    Ok(text)
}

fn cell(measured: Option<&Measured>) -> String {
    let Some(m) = measured else { return String::new() };
    let mean = m.steps.iter().sum::<f64>() / m.steps.len().max(1) as f64;
    match m.front_pairs() {
        0.0 => digits(mean),
        pairs => format!("{} ({})", digits(mean), digits(pairs / 1e3)),
    }
}

/// Fronts over steps where they are dropped and where they are kept.
fn drawn(
    all: &[scenes::Scene],
    columns: &[Vec<Option<Measured>>],
    settings: &[(String, Front)],
    plots: &Path,
) -> Result<String, String> {
    let shown = ["kept", "dropped beyond 110"];
    // Where a front that is kept grows most.
    let growth = |at: &usize| {
        let fronts = columns[*at][1].iter().flat_map(|m| &m.fronts).map(|front| front.pairs);
        let (least, most) = (fronts.clone().min().unwrap_or(0), fronts.max().unwrap_or(0));
        most as f64 / least.max(1) as f64
    };
    let grown = |a: &usize, b: &usize| growth(a).total_cmp(&growth(b));
    let Some(at) = (0..all.len()).max_by(grown) else { return Ok(String::new()) };
    let mut lines = Vec::new();
    for part in shown {
        let found = settings.iter().position(|(name, _)| name.starts_with(part));
        let Some(m) = found.and_then(|k| columns[at][k].as_ref()) else { continue };
        let pairs = m.fronts.iter().map(|front| front.pairs as f64 / 1e3).collect();
        lines.push((format!("{part} %").replace("kept %", "kept"), pairs));
    }
    let title = format!("{}: thousand pairs of the front over steps", all[at].name);
    plot::lines(&plots.join("fronts.svg"), &title, lines)?;
    Ok("![Fronts over steps](scheduling/fronts.svg)\n\n".into())
}
