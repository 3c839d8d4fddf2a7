//! Plots of what was measured: bars of times, where the time of a step goes, fronts over steps.

use super::Results;
use super::measure::{Measured, Structure};
use super::tables::names;
use crate::algorithms::plot::Bars;
use ccd::Volume;
use plotters::prelude::*;
use std::fmt::Write;
use std::path::Path;

const TREE: Structure = Structure::Tree(Volume::Aabb);
const PARTS: [(&str, RGBColor); 5] = [
    ("refit", RGBColor(90, 90, 90)),
    ("front", RGBColor(31, 90, 160)),
    ("traversal", RGBColor(110, 170, 220)),
    ("balancing", RGBColor(200, 90, 40)),
    ("intersection", RGBColor(60, 130, 60)),
];
const LINES: [RGBColor; 5] = [
    RGBColor(31, 90, 160),
    RGBColor(200, 90, 40),
    RGBColor(60, 130, 60),
    RGBColor(120, 60, 150),
    RGBColor(90, 90, 90),
];

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
        let mut bars =
            Bars::new(&format!("A step, {place}"), "ms", series.map(str::to_owned).into());
        for results in all {
            let of = |name: &str| results.cell(k, TREE, name).map(Measured::ms);
            let values = vec![
                results.default(k).map(Measured::ms),
                of("lazy-stealing, front"),
                of("balanced, front"),
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
        let mut bars = Bars::new(&title, "ms a step", series);
        let mut stacks = Vec::new();
        for name in names(&chart.groups) {
            let of = |structure| chart.cell(k, structure, name);
            bars.add(name, Structure::ALL.map(|s| of(s).map(Measured::ms)).into());
            if let Some(m) = of(TREE).filter(|_| name.ends_with(", front")) {
                stacks.push((name.to_owned(), m.shares.parts()));
            }
        }
        let file = format!("schedulers-{backend}.svg");
        bars.write(&folder.join(&file))?;
        show(&format!("Every scheduler, {place}"), &file);
        if !stacks.is_empty() {
            let file = format!("shares-{backend}.svg");
            let path = folder.join(&file);
            let title = format!("{title}, trees with fronts, ms a step");
            stacked(&path, &title, &stacks).map_err(|e| format!("{}: {e}", path.display()))?;
            show(&format!("Where the time goes, {place}"), &file);
        }
    }
    Ok(text)
}

type Drawn = Result<(), Box<dyn std::error::Error>>;

/// Bars of parts, one a scheduler.
fn stacked(path: &Path, title: &str, stacks: &[(String, [f64; 5])]) -> Drawn {
    let n = stacks.len();
    let most = stacks.iter().map(|s| s.1.iter().sum()).fold(0.0, f64::max);
    let root = SVGBackend::new(path, (900, 140 + 40 * n as u32)).into_drawing_area();
    root.fill(&WHITE)?;
    // Room on the right for the legend.
    let mut chart = ChartBuilder::on(&root)
        .caption(title, ("sans-serif", 20))
        .margin(10)
        .x_label_area_size(30)
        .y_label_area_size(180)
        .build_cartesian_2d(0.0..1.35 * most.max(1e-9), 0.0..n as f64)?;
    let name_of = |y: &f64| {
        let k = n.checked_sub(*y as usize + 1).filter(|_| (*y - y.floor() - 0.5).abs() < 0.1);
        k.map_or(String::new(), |k| stacks[k].0.clone())
    };
    chart
        .configure_mesh()
        .disable_y_mesh()
        .y_labels(2 * n + 1)
        .y_label_formatter(&name_of)
        .label_style(("sans-serif", 14))
        .draw()?;
    for (part, (name, colour)) in PARTS.iter().enumerate() {
        let bars = stacks.iter().rev().enumerate().map(|(k, (_, parts))| {
            let from: f64 = parts[..part].iter().sum();
            let (low, high) = (k as f64 + 0.15, k as f64 + 0.85);
            Rectangle::new([(from, low), (from + parts[part], high)], colour.filled())
        });
        chart
            .draw_series(bars)?
            .label(*name)
            .legend(move |(x, y)| Rectangle::new([(x, y - 5), (x + 12, y + 5)], colour.filled()));
    }
    legend(&mut chart, SeriesLabelPosition::MiddleRight)?;
    root.present()?;
    Ok(())
}

/// Lines over steps.
pub fn lines(path: &Path, title: &str, lines: &[(String, Vec<f64>)]) -> Drawn {
    let all = || lines.iter().flat_map(|line| line.1.iter().copied());
    let (low, high) = (all().fold(f64::MAX, f64::min), all().fold(0.0, f64::max));
    let n = lines.iter().map(|line| line.1.len()).max().unwrap_or(1);
    let root = SVGBackend::new(path, (900, 420)).into_drawing_area();
    root.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&root)
        .caption(title, ("sans-serif", 20))
        .margin(10)
        .x_label_area_size(40)
        .y_label_area_size(80)
        .build_cartesian_2d(0.0..n as f64, 0.98 * low..high + 0.35 * (high - low).max(1e-9))?;
    chart.configure_mesh().x_desc("step").label_style(("sans-serif", 14)).draw()?;
    for (k, (name, values)) in lines.iter().enumerate() {
        let colour = LINES[k % LINES.len()];
        let points: Vec<_> = values.iter().enumerate().map(|(i, &y)| (i as f64, y)).collect();
        chart
            .draw_series([PathElement::new(points, colour.stroke_width(2))])?
            .label(name.clone())
            .legend(move |(x, y)| Rectangle::new([(x, y - 2), (x + 12, y + 2)], colour.filled()));
    }
    legend(&mut chart, SeriesLabelPosition::UpperLeft)?;
    root.present()?;
    Ok(())
}

type Chart<'a> = ChartContext<
    'a,
    SVGBackend<'a>,
    Cartesian2d<plotters::coord::types::RangedCoordf64, plotters::coord::types::RangedCoordf64>,
>;

fn legend<'a>(chart: &mut Chart<'a>, position: SeriesLabelPosition) -> Drawn {
    chart
        .configure_series_labels()
        .position(position)
        .background_style(WHITE)
        .border_style(RGBColor(200, 200, 200))
        .label_font(("sans-serif", 14))
        .draw()?;
    Ok(())
}
