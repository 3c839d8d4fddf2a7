//! Plots as SVG: bars that lie, and lines.

use crate::exponents::size;
use plotters::coord::ranged1d::{AsRangedCoord, Ranged, ValueFormatter};
use plotters::prelude::*;
use std::path::Path;

const COLOURS: [RGBColor; 5] = [
    RGBColor(31, 90, 160),
    RGBColor(110, 170, 220),
    RGBColor(200, 90, 40),
    RGBColor(60, 130, 60),
    RGBColor(90, 90, 90),
];

type Drawn = Result<(), Box<dyn std::error::Error>>;

/// Shape of a series, in one colour.
enum Shape {
    /// Left, lower, right and upper end of each.
    Bars(Vec<[f64; 4]>),
    /// Points, left to right.
    Line(Vec<(f64, f64)>),
}

/// Names of what is drawn, and the axis that goes up.
struct Plot<'a> {
    title: &'a str,
    height: u32,
    up: std::ops::Range<f64>,
    /// Label at a value of that axis instead of its number.
    label: &'a dyn Fn(f64) -> Option<String>,
    /// Whether these are names, which need space and no lines.
    named: bool,
    /// Whether the other axis is of sizes.
    sized: bool,
    n_labels: usize,
    legend: SeriesLabelPosition,
    series: Vec<(String, Shape)>,
}

impl Plot<'_> {
    fn write<X>(self, path: &Path, along: X) -> Result<(), String>
    where
        X: AsRangedCoord<Value = f64>,
        X::CoordDescType: Ranged<ValueType = f64> + ValueFormatter<f64>,
    {
        self.draw(path, along).map_err(|e| format!("{}: {e}", path.display()))
    }

    fn draw<X>(self, path: &Path, along: X) -> Drawn
    where
        X: AsRangedCoord<Value = f64>,
        X::CoordDescType: Ranged<ValueType = f64> + ValueFormatter<f64>,
    {
        let root = SVGBackend::new(path, (900, self.height)).into_drawing_area();
        root.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(&root)
            .caption(self.title, ("sans-serif", 20))
            .margin(10)
            .x_label_area_size(30)
            .y_label_area_size(if self.named { 180 } else { 80 })
            .build_cartesian_2d(along, self.up)?;
        let label = |y: &f64| (self.label)(*y).unwrap_or_else(|| format!("{y:.1}"));
        let mut mesh = chart.configure_mesh();
        if self.named {
            mesh.disable_y_mesh();
        }
        let along_label = |x: &f64| size(x.round() as usize);
        if self.sized {
            mesh.x_label_formatter(&along_label);
        }
        mesh.y_labels(self.n_labels)
            .y_label_formatter(&label)
            .label_style(("sans-serif", 14))
            .draw()?;
        for (k, (name, shape)) in self.series.into_iter().enumerate() {
            let colour = COLOURS[k % COLOURS.len()];
            let series = match shape {
                Shape::Bars(bars) => {
                    let bar =
                        |[a, b, c, d]: [f64; 4]| Rectangle::new([(a, b), (c, d)], colour.filled());
                    chart.draw_series(bars.into_iter().map(bar))?
                }
                Shape::Line(points) => {
                    chart.draw_series([PathElement::new(points, colour.stroke_width(2))])?
                }
            };
            series.label(name).legend(move |(x, y)| {
                Rectangle::new([(x, y - 5), (x + 12, y + 5)], colour.filled())
            });
        }
        chart
            .configure_series_labels()
            .position(self.legend)
            .background_style(WHITE)
            .border_style(RGBColor(200, 200, 200))
            .label_font(("sans-serif", 14))
            .draw()?;
        root.present()?;
        Ok(())
    }
}

/// Groups of bars, one colour a series; times are on a logarithmic axis.
pub struct Bars {
    title: String,
    series: Vec<String>,
    groups: Vec<(String, Vec<Option<f64>>)>,
}

impl Bars {
    /// No groups yet. `series`: what each colour stands for.
    pub fn new(title: String, series: Vec<String>) -> Self {
        Self { title, series, groups: Vec::new() }
    }

    /// A group: a value for each series.
    pub fn add(&mut self, name: &str, values: Vec<Option<f64>>) {
        if values.iter().any(Option::is_some) {
            self.groups.push((name.into(), values));
        }
    }

    pub fn write(&self, path: &Path) -> Result<(), String> {
        let all = || self.groups.iter().flat_map(|group| group.1.iter().flatten().copied());
        let (low, high) = (all().fold(f64::MAX, f64::min), all().fold(0.0, f64::max));
        let n = self.series.len();
        // Above the bars there is space for the legend.
        let (rows, above) = (self.groups.len() * (n + 1), n + 1);
        let label = |y: f64| {
            let middle = y as usize % (n + 1) == n / 2;
            let group = self.groups.len().checked_sub(y as usize / (n + 1) + 1);
            Some(group.filter(|_| middle).map_or(String::new(), |k| self.groups[k].0.clone()))
        };
        let bars = |p: usize| {
            let bars = self.groups.iter().rev().enumerate().filter_map(|(k, group)| {
                let y = (k * (n + 1) + n - 1 - p) as f64;
                Some([low / 2.0, y + 0.1, group.1[p]?, y + 0.9])
            });
            Shape::Bars(bars.collect())
        };
        let plot = Plot {
            title: &self.title,
            height: 120 + 24 * (rows + above) as u32,
            up: 0.0..(rows + above) as f64,
            label: &label,
            named: true,
            sized: false,
            n_labels: rows + above + 1,
            legend: SeriesLabelPosition::UpperRight,
            series: self.series.iter().cloned().zip((0..n).map(bars)).collect(),
        };
        plot.write(path, (low / 2.0..high * 2.0).log_scale())
    }
}

/// Bars of parts, one a name.
pub fn stacked(
    path: &Path,
    title: &str,
    parts: [&str; 5],
    stacks: &[(String, [f64; 5])],
) -> Result<(), String> {
    let n = stacks.len();
    let most = stacks.iter().map(|s| s.1.iter().sum()).fold(0.0, f64::max);
    let label = |y: f64| {
        let k = n.checked_sub(y as usize + 1).filter(|_| (y - y.floor() - 0.5).abs() < 0.1);
        Some(k.map_or(String::new(), |k| stacks[k].0.clone()))
    };
    let of_part = |part: usize| {
        let bars = stacks.iter().rev().enumerate().map(|(k, (_, parts))| {
            let from: f64 = parts[..part].iter().sum();
            [from, k as f64 + 0.15, from + parts[part], k as f64 + 0.85]
        });
        (parts[part].to_owned(), Shape::Bars(bars.collect()))
    };
    let plot = Plot {
        title,
        height: 140 + 40 * n as u32,
        up: 0.0..n as f64,
        label: &label,
        named: true,
        sized: false,
        n_labels: 2 * n + 1,
        legend: SeriesLabelPosition::MiddleRight,
        series: (0..5).map(of_part).collect(),
    };
    // Space on the right for the legend.
    plot.write(path, 0.0..1.35 * most.max(1e-9))
}

/// Values over their numbers.
fn line(values: Vec<f64>) -> Shape {
    Shape::Line((0u32..).map(f64::from).zip(values).collect())
}

/// Milliseconds over sizes, both on logarithmic axes.
pub fn growth(path: &Path, title: &str, lines: &[(String, Vec<[f64; 2]>)]) -> Result<(), String> {
    let all = || lines.iter().flat_map(|line| &line.1);
    let range = |k: usize| {
        let values = || all().map(move |point| point[k]);
        (values().fold(f64::MAX, f64::min), values().fold(0.0, f64::max))
    };
    if all().next().is_none() {
        return Err(format!("{title}: nothing to be drawn"));
    }
    let ((left, right), (low, high)) = (range(0), range(1));
    // Whole powers of ten, and one above for the legend.
    let (low, high) = (low.log10().floor(), high.log10().ceil() + 1.0);
    let label = |y: f64| {
        let power = y.round();
        let is_whole = (y - power).abs() < 1e-6;
        Some(if is_whole { 10f64.powf(power).to_string() } else { String::new() })
    };
    let series = lines.iter().map(|(name, points)| {
        (name.clone(), Shape::Line(points.iter().map(|p| (p[0], p[1].log10())).collect()))
    });
    let plot = Plot {
        title,
        height: 420,
        up: low..high,
        label: &label,
        named: false,
        sized: true,
        n_labels: (high - low) as usize + 1,
        legend: SeriesLabelPosition::UpperLeft,
        series: series.collect(),
    };
    plot.write(path, (0.9 * left..1.1 * right).log_scale())
}

/// Lines over steps.
pub fn lines(path: &Path, title: &str, lines: Vec<(String, Vec<f64>)>) -> Result<(), String> {
    let all = || lines.iter().flat_map(|line| line.1.iter().copied());
    let (low, high) = (all().fold(f64::MAX, f64::min), all().fold(0.0, f64::max));
    let n = lines.iter().map(|line| line.1.len()).max().unwrap_or(1);
    let plot = Plot {
        title,
        height: 420,
        up: 0.98 * low..high + 0.35 * (high - low).max(1e-9),
        label: &|_| None,
        named: false,
        sized: false,
        n_labels: 10,
        legend: SeriesLabelPosition::UpperLeft,
        series: lines.into_iter().map(|(name, values)| (name, line(values))).collect(),
    };
    plot.write(path, 0.0..n as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plots_name_what_they_show() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("plot.svg");
        let check = |names: &[&str]| {
            let text = std::fs::read_to_string(&path).unwrap();
            names.iter().for_each(|name| assert!(text.contains(name), "{name}: {text}"));
        };
        let mut bars = Bars::new("times, ms".into(), vec!["1 thread".into(), "GPU".into()]);
        bars.add("blocks", vec![Some(1.5), None]);
        bars.add("nowhere", vec![None, None]);
        bars.add("tree", vec![Some(20.0), Some(0.5)]);
        bars.write(&path).unwrap();
        check(&["times, ms", "1 thread", "GPU", "blocks", "tree"]);
        let stacks = [("lazy".to_owned(), [1.0, 0.5, 2.0, 0.0, 3.0])];
        stacked(&path, "a step", ["v", "w", "x", "y", "z"], &stacks).unwrap();
        check(&["a step", "lazy", ">\nw\n<"]);
        lines(&path, "a front", vec![("kept".into(), vec![1.0, 3.0, 2.0])]).unwrap();
        check(&["a front", "kept", "polyline"]);
        let points = vec![[1e4, 0.02], [1e5, 0.3], [1e6, 2.5]];
        growth(&path, "boxes, ms", &[("tree, GPU".into(), points)]).unwrap();
        check(&["boxes, ms", "tree, GPU", "polyline", ">\n0.01\n<", ">\n10\n<", ">\n100 K\n<"]);
        assert!(growth(&path, "none", &[]).is_err());
    }
}
