//! Tables and plots of growth.

use super::measure::{Answer, Cell, Measured};
use super::series::{Series, Work};
use crate::exponents::{exponent, size};
use crate::markdown::{Table, digits, thousands};
use crate::measure::Place;
use crate::plot;
use std::fmt::Write;
use std::path::Path;

/// Build and query of Kitten, an LBVH for CUDA, over the same boxes on an NVIDIA H200 on another
/// day, in milliseconds.
const KITTEN: [(usize, f64); 3] = [(100_000, 0.250), (1_000_000, 0.668), (10_000_000, 4.136)];

/// What a table is about.
pub struct Subject<'a> {
    /// What its elements are: `boxes`.
    pub elements: &'static str,
    /// What is found: `pairs`.
    pub found: &'static str,
    pub sizes: &'a [usize],
    pub places: &'a [Place],
    pub series: &'a [Series],
}

/// Reasons why cells are empty, each once, by numbers.
#[derive(Default)]
struct Reasons(Vec<String>);

impl Reasons {
    fn mark(&mut self, why: &str) -> String {
        let known = self.0.iter().position(|known| known == why);
        let k = known.unwrap_or_else(|| {
            self.0.push(why.into());
            self.0.len() - 1
        });
        format!("({})", k + 1)
    }

    fn lines(&self) -> String {
        let line = |(k, why): (usize, &String)| format!("- ({}) {why}.\n", k + 1);
        self.0.iter().enumerate().map(line).collect()
    }
}

fn is_gpu(place: &Place) -> bool {
    place.threads() == 0
}

/// The time that growth is measured by: of a GPU that of its kernels, if it has timestamps.
fn ms(measured: &Measured) -> f64 {
    measured.device.filter(|&ms| ms > 0.0).unwrap_or(measured.wall)
}

impl Subject<'_> {
    /// All tables with the plot, which is written to `folder`.
    pub fn text(&self, folder: &Path) -> Result<String, String> {
        let mut text = format!("{}\n", self.times());
        let _ = writeln!(
            text,
            "By what power of the size times grow, over all sizes, over those \
             from a million on, and from the size before to this one:\n\n{}",
            self.exponents()
        );
        let _ = writeln!(text, "Bytes for each of the {}:\n\n{}", self.elements, self.bytes());
        let path = folder.join(format!("performance/{}.svg", self.elements));
        plot::growth(&path, &format!("{}, ms", self.elements), &self.lines())?;
        let (elements, name) = (self.elements, path.file_name().unwrap_or_default());
        let _ = writeln!(text, "![Growth over {elements}](performance/{})", name.display());
        Ok(text)
    }

    fn name(&self, series: &Series) -> String {
        let place = if is_gpu(&self.places[series.place]) { "GPU" } else { "CPU" };
        format!("{}, {place}", series.work.name())
    }

    /// Series of the same work side by side.
    fn in_order(&self) -> Vec<&Series> {
        let mut works: Vec<Work> = Vec::new();
        for series in self.series {
            if !works.contains(&series.work) {
                works.push(series.work);
            }
        }
        let of = |work| self.series.iter().filter(move |series| series.work == work);
        works.into_iter().flat_map(of).collect()
    }

    fn times(&self) -> String {
        let of_boxes = self.elements == "boxes";
        let mut names = vec![self.elements.to_owned(), self.found.to_owned()];
        for series in self.in_order() {
            names.push(self.name(series));
            if is_gpu(&self.places[series.place]) {
                names.push("wall".into());
            }
        }
        if of_boxes {
            names.push("Kitten".into());
        }
        let (mut table, mut reasons) = (Table::new(names), Reasons::default());
        for (i, &n) in self.sizes.iter().enumerate() {
            let cell = |series: &Series| series.cells[i].clone();
            let found = self.series.iter().find_map(|series| match cell(series).ok()?.answer {
                Answer::Pairs(n, _) => Some(thousands(n)),
                Answer::Toi(_) => None,
            });
            let mut row = vec![size(n), found.unwrap_or_default()];
            for series in self.in_order() {
                let on_gpu = is_gpu(&self.places[series.place]);
                match cell(series) {
                    Ok(m) if on_gpu => {
                        row.push(m.device.map_or(String::new(), digits));
                        row.push(digits(m.wall));
                    }
                    Ok(m) => row.push(digits(m.wall)),
                    Err(why) => {
                        row.push(reasons.mark(&why));
                        row.extend(on_gpu.then(String::new));
                    }
                }
            }
            if of_boxes {
                let peer = KITTEN.iter().find(|peer| peer.0 == n);
                row.push(peer.map_or(String::new(), |peer| digits(peer.1)));
            }
            table.row(row);
        }
        match reasons.lines() {
            lines if lines.is_empty() => table.to_string(),
            lines => format!("{table}\n{lines}"),
        }
    }

    /// Sizes and times of a series.
    fn points(&self, series: &Series) -> Vec<[f64; 2]> {
        let cells = self.sizes.iter().zip(&series.cells);
        cells.filter_map(|(&n, cell)| Some([n as f64, ms(cell.as_ref().ok()?)])).collect()
    }

    fn exponents(&self) -> String {
        let sizes = self.sizes.iter().skip(1).map(|&n| size(n));
        let columns = ["", "all", "1 M on"].map(String::from).into_iter().chain(sizes);
        let mut table = Table::new(columns);
        let power =
            |points: &[[f64; 2]]| exponent(points).map_or(String::new(), |p| format!("{p:.2}"));
        for series in self.in_order() {
            let points = self.points(series);
            let large: Vec<_> = points.iter().copied().filter(|p| p[0] >= 0.999e6).collect();
            let mut row = vec![self.name(series), power(&points), power(&large)];
            for (n, cells) in self.sizes.windows(2).zip(series.cells.windows(2)) {
                let both = n
                    .iter()
                    .zip(cells)
                    .map(|(&n, cell): (_, &Cell)| Some([n as f64, ms(cell.as_ref().ok()?)]));
                let both: Option<Vec<_>> = both.collect();
                row.push(both.map_or(String::new(), |both| power(&both)));
            }
            table.row(row);
        }
        table.to_string()
    }

    fn bytes(&self) -> String {
        let sizes = self.sizes.iter().map(|&n| size(n));
        let mut table = Table::new(std::iter::once(String::new()).chain(sizes));
        type Of = fn(&Measured) -> Option<u64>;
        let (on_device, on_host): (Of, Of) = (|m| m.on_device, |m| Some(m.on_host));
        for series in self.in_order() {
            let on_gpu = is_gpu(&self.places[series.place]);
            let of: &[(&str, Of)] = if on_gpu {
                &[(": device", on_device), (": host", on_host)]
            } else {
                &[(": host", on_host)]
            };
            for (what, of) in of {
                let cells = self.sizes.iter().zip(&series.cells).map(|(&n, cell)| {
                    let bytes = cell.as_ref().ok().and_then(of);
                    bytes.map_or(String::new(), |bytes| format!("{:.0}", bytes as f64 / n as f64))
                });
                table.row(std::iter::once(self.name(series) + what).chain(cells));
            }
        }
        table.to_string()
    }

    /// Lines of the plot.
    fn lines(&self) -> Vec<(String, Vec<[f64; 2]>)> {
        self.in_order().iter().map(|series| (self.name(series), self.points(series))).collect()
    }
}
