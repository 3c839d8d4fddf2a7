//! Plots of what was measured: bars of times, where the time of a step goes.

use super::Results;
use super::measure::{Measured, Structure};
use super::tables::names;
use crate::plot::{Bars, stacked};
use crate::stages::PARTS;
use ccd::method::Volume;
use std::fmt::Write;
use std::path::Path;

const TREE: Structure = Structure::Tree(Volume::Aabb);
/// Writes all plots of these places; returns the lines that show them.
pub fn all(all: &[Results], places: &[(usize, &str)], folder: &Path) -> Result<String, String> {
    let mut text = String::new();
    let mut show = |what: &str, file: &str| {
        let _ = writeln!(text, "![{what}](scheduling/{file})\n");
    };
    // The one of which the dissertation has a chart, or else the last.
    let chart = all.iter().find(|results| results.scene.name == "cloth on ball").or(all.last());
    for &(k, place) in places {
        let backend = if place.contains("thread") { "cpu" } else { "gpu" };
        let series = ["default", "tree, lazy stealing, front", "tree, balanced, front", "fastest"];
        let mut bars = Bars::new(format!("A step, {place}, ms"), series.map(str::to_owned).into());
        for results in all {
            let ms = |name: &str| results.cell(k, TREE, name).map(Measured::ms);
            let values = vec![
                results.default(k).map(Measured::ms),
                ms("lazy-stealing, front"),
                ms("balanced, front"),
                results.best(k).map(|(_, best)| best.ms()),
            ];
            bars.add(&results.scene.name, values);
        }
        let file = format!("scenes-{backend}.svg");
        bars.write(&folder.join(&file))?;
        show(&format!("A step of each scene, {place}"), &file);
        let Some(chart) = chart else { continue };
        let title = format!("{}, {place}", chart.scene.name);
        let series = Structure::ALL.map(|s| s.name().to_owned()).into();
        let mut bars = Bars::new(format!("{title}, ms a step"), series);
        let mut stacks = Vec::new();
        for name in names(&chart.groups) {
            let cell = |structure| chart.cell(k, structure, name);
            bars.add(name, Structure::ALL.map(|s| cell(s).map(Measured::ms)).into());
            if let Some(m) = cell(TREE).filter(|_| name.ends_with(", front")) {
                stacks.push((name.to_owned(), m.shares.parts));
            }
        }
        let file = format!("schedulers-{backend}.svg");
        bars.write(&folder.join(&file))?;
        show(&format!("Every scheduler, {place}"), &file);
        if !stacks.is_empty() {
            let file = format!("shares-{backend}.svg");
            let title = format!("{title}, trees with fronts, ms a step");
            stacked(&folder.join(&file), &title, PARTS, &stacks)?;
            show(&format!("Where the time goes, {place}"), &file);
        }
    }
    Ok(text)
}
