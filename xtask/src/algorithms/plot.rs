//! Bars of times, one group a method, one colour a place, as SVG.

use plotters::prelude::*;
use std::path::Path;

const COLOURS: [RGBColor; 4] =
    [RGBColor(31, 90, 160), RGBColor(110, 170, 220), RGBColor(200, 90, 40), RGBColor(60, 130, 60)];

/// A plot of bars; times are on a logarithmic axis.
pub struct Bars {
    title: String,
    unit: String,
    places: Vec<String>,
    groups: Vec<(String, Vec<Option<f64>>)>,
}

impl Bars {
    /// No groups yet. `places`: what each colour stands for.
    pub fn new(title: &str, unit: &str, places: Vec<String>) -> Self {
        Self { title: title.into(), unit: unit.into(), places, groups: Vec::new() }
    }

    /// A group: a value for each place.
    pub fn add(&mut self, name: &str, values: Vec<Option<f64>>) {
        if values.iter().any(Option::is_some) {
            self.groups.push((name.into(), values));
        }
    }

    pub fn write(&self, path: &Path) -> Result<(), String> {
        self.draw(path).map_err(|e| format!("{}: {e}", path.display()))
    }

    fn draw(&self, path: &Path) -> Result<(), Box<dyn std::error::Error>> {
        let all = || self.groups.iter().flat_map(|group| group.1.iter().flatten().copied());
        let (low, high) = (all().fold(f64::MAX, f64::min), all().fold(0.0, f64::max));
        let n = self.places.len();
        // Above the bars there is room for the legend.
        let (rows, above) = (self.groups.len() * (n + 1), n + 1);
        let size = (900, 120 + 24 * (rows + above) as u32);
        let root = SVGBackend::new(path, size).into_drawing_area();
        root.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(&root)
            .caption(format!("{}, {}", self.title, self.unit), ("sans-serif", 20))
            .margin(10)
            .x_label_area_size(30)
            .y_label_area_size(180)
            .build_cartesian_2d((low / 2.0..high * 2.0).log_scale(), 0f64..(rows + above) as f64)?;
        let name_of = |row: &f64| {
            let k = *row as usize / (n + 1);
            let middle = *row as usize % (n + 1) == n / 2;
            let group = self.groups.len().checked_sub(k + 1).filter(|_| middle);
            group.map_or(String::new(), |k| self.groups[k].0.clone())
        };
        chart
            .configure_mesh()
            .disable_y_mesh()
            .y_labels(rows + above + 1)
            .y_label_formatter(&name_of)
            .label_style(("sans-serif", 14))
            .draw()?;
        for (p, place) in self.places.iter().enumerate() {
            let colour = COLOURS[p % COLOURS.len()];
            let bars = self.groups.iter().rev().enumerate().filter_map(|(k, group)| {
                let value = group.1[p]?;
                let y = (k * (n + 1) + n - 1 - p) as f64;
                Some(Rectangle::new([(low / 2.0, y + 0.1), (value, y + 0.9)], colour.filled()))
            });
            chart.draw_series(bars)?.label(place.clone()).legend(move |(x, y)| {
                Rectangle::new([(x, y - 5), (x + 12, y + 5)], colour.filled())
            });
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperRight)
            .background_style(WHITE)
            .border_style(RGBColor(200, 200, 200))
            .label_font(("sans-serif", 14))
            .draw()?;
        root.present()?;
        Ok(())
    }
}
