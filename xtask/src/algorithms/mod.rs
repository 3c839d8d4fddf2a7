//! `cargo xtask report --algorithms`: every method beside every other, in the tables of
//! docs/ALGORITHMS.md, whose text stays as it is, and plots beside it.
//!
//! A table stands between two comments, `<!-- NAME -->` and `<!-- end -->`. Every answer is
//! checked: pairs against the default method, and that against the known count where there is one.

pub mod measure;
mod pipelines;
pub mod plot;
mod scenes;

use ccd::{BroadPhaseMethod, Builder, Catalogued, Descent, Traversal, TreeOptions, Volume};
use measure::{Measured, Place, measure};
use plot::Bars;
use scenes::Case;
use std::fmt::Write;
use std::path::Path;

/// Measures all and rewrites the tables of docs/ALGORITHMS.md.
pub fn run(root: &Path, runs: usize) -> Result<(), String> {
    let path = root.join("docs/ALGORITHMS.md");
    let mut text = std::fs::read_to_string(&path).map_err(|e| format!("{path:?}: {e}"))?;
    let plots = root.join("docs/algorithms");
    std::fs::create_dir_all(&plots).map_err(|e| format!("{plots:?}: {e}"))?;
    let places = Place::all()?;
    let mut report = Report { places, runs, plots };
    let cases = scenes::all()?;
    let tables = [
        ("machine", report.machine()),
        ("methods", report.methods(&cases)?),
        ("ladder", report.ladder(&cases)?),
        ("simultaneous", report.simultaneous(&cases)?),
        ("builders", report.builders(&cases)?),
        ("cloth-and-sphere", report.cloth_and_sphere()?),
        ("volumes", report.volumes(&cases)?),
        ("pipelines", pipelines::table(&report.places, runs)?),
    ];
    for (name, table) in tables {
        text = replaced(&text, name, &table)?;
    }
    std::fs::write(&path, text).map_err(|e| format!("{path:?}: {e}"))?;
    println!("written {}", path.display());
    Ok(())
}

/// The text with another table between the comments of this name.
pub fn replaced(text: &str, name: &str, table: &str) -> Result<String, String> {
    let begin = format!("<!-- {name} -->\n");
    let (head, rest) = text.split_once(&begin).ok_or(format!("no place for `{name}`"))?;
    let (_, tail) = rest.split_once("<!-- end -->").ok_or(format!("`{name}` has no end"))?;
    Ok(format!("{head}{begin}\n{}\n<!-- end -->{tail}", table.trim()))
}

struct Report {
    places: Vec<Place>,
    runs: usize,
    plots: std::path::PathBuf,
}

/// A tree of these.
fn tree(builder: Builder, traversal: Traversal) -> BroadPhaseMethod {
    BroadPhaseMethod::Tree(TreeOptions::default().builder(builder).traversal(traversal))
}

impl Report {
    fn machine(&self) -> String {
        let names: Vec<&str> = self.places.iter().map(Place::name).collect();
        format!("Places: {}. Medians of {} runs.\n", names.join("; "), self.runs)
    }

    fn place_names(&self) -> Vec<String> {
        self.places.iter().map(|place| place.name().to_owned()).collect()
    }

    /// A method at every place; `None` where it is not.
    fn row(
        &self,
        method: BroadPhaseMethod,
        case: &Case,
        of: impl Fn(&Measured) -> f64,
    ) -> Result<(String, Vec<Option<f64>>), String> {
        let (mut cells, mut values) = (String::new(), Vec::new());
        for place in &self.places {
            let measured = measure(place, method, case, self.runs)?;
            match &measured {
                Ok(measured) => _ = write!(cells, " {} |", digits(of(measured))),
                Err(why) => _ = write!(cells, " {why} |"),
            }
            values.push(measured.ok().as_ref().map(&of));
        }
        Ok((cells, values))
    }

    /// The head of a table: these columns, then a column for each place.
    fn head(&self, columns: &[&str]) -> String {
        let names = columns.iter().copied().chain(self.places.iter().map(Place::name));
        let head: String = names.map(|name| format!(" {name} |")).collect();
        format!("|{head}\n|{}\n", "---|".repeat(columns.len() + self.places.len()))
    }

    /// Every broad phase on every scene, whole calls.
    fn methods(&mut self, cases: &[Case]) -> Result<String, String> {
        let mut text = String::new();
        for case in cases {
            let _ = writeln!(text, "{}\n", case.title());
            text += &self.head(&["ms, build and search"]);
            let mut bars = Bars::new(&case.name, "ms", self.place_names());
            for row in BroadPhaseMethod::ROWS {
                let (cells, values) = self.row(row.value, case, |m| m.build + m.search)?;
                let _ = writeln!(text, "| {} |{cells}", row.name);
                bars.add(row.name, values);
            }
            let file = format!("methods-{}.svg", case.file_name());
            bars.write(&self.plots.join(&file))?;
            let _ = writeln!(text, "\n![Methods on {}](algorithms/{file})\n", case.name);
        }
        Ok(text)
    }

    /// Recursive, iterative, leaf order, half: the ladder of [Karras 2012b].
    fn ladder(&mut self, cases: &[Case]) -> Result<String, String> {
        let rungs =
            [Traversal::Recursive, Traversal::Iterative, Traversal::LeafOrder, Traversal::Half];
        let mut text = String::new();
        for case in cases {
            let _ = writeln!(text, "{}\n", case.title());
            text += &self.head(&["ms, search alone"]);
            let mut bars = Bars::new(&case.name, "ms, search alone", self.place_names());
            for traversal in rungs {
                let method = tree(Builder::Lbvh, traversal);
                let (cells, values) = self.row(method, case, |m| m.search)?;
                let _ = writeln!(text, "| {} |{cells}", traversal.row().name);
                bars.add(traversal.row().name, values);
            }
            let file = format!("ladder-{}.svg", case.file_name());
            bars.write(&self.plots.join(&file))?;
            let _ = writeln!(text, "\n![The ladder on {}](algorithms/{file})\n", case.name);
        }
        Ok(text)
    }

    /// Simultaneous against independent traversal, in visits and in time.
    fn simultaneous(&mut self, cases: &[Case]) -> Result<String, String> {
        let rows = [
            ("leaf-order", Traversal::LeafOrder),
            ("half", Traversal::Half),
            ("simultaneous, larger", Traversal::Simultaneous(Descent::Larger)),
            ("simultaneous, both", Traversal::Simultaneous(Descent::Both)),
            ("cut of 256, larger", Traversal::Cut { nodes: 256, descent: Descent::Larger }),
            ("cut of 256, both", Traversal::CUT),
        ];
        let mut text = String::new();
        for case in cases {
            let _ = writeln!(text, "{}\n", case.title());
            text += &self.head(&["ms, search alone", "visits"]);
            for (name, traversal) in rows {
                let method = tree(Builder::Lbvh, traversal);
                let (cells, _) = self.row(method, case, |m| m.search)?;
                let visits = measure(&Place::one_thread(), method, case, 1)?
                    .map_or("-".to_owned(), |m| m.visits.to_string());
                let _ = writeln!(text, "| {name} | {visits} |{cells}");
            }
            text.push('\n');
        }
        Ok(text)
    }

    /// Build time, cost and visited nodes of every builder.
    fn builders(&mut self, cases: &[Case]) -> Result<String, String> {
        let mut text = String::new();
        for case in cases {
            let _ = writeln!(text, "{}\n", case.title());
            text += &self.head(&["ms, build alone", "cost", "nodes a query", "depth"]);
            for row in Builder::ROWS {
                let method = tree(row.value, Traversal::Half);
                let (cells, _) = self.row(method, case, |m| m.build)?;
                let of_tree = measure(&Place::one_thread(), method, case, 1)?;
                let figures = match of_tree.ok().and_then(|m| m.tree) {
                    Some(t) => format!(
                        "{} | {} | {}",
                        digits(t.sah_cost),
                        digits(t.visited_per_query),
                        t.depth
                    ),
                    None => " | | ".to_owned(),
                };
                let _ = writeln!(text, "| {} | {figures} |{cells}", row.name);
            }
            text.push('\n');
        }
        Ok(text)
    }

    /// Boxes along the axes against oriented ones, in visits and in time.
    fn volumes(&mut self, cases: &[Case]) -> Result<String, String> {
        let mut text = String::new();
        for case in cases {
            let _ = writeln!(text, "{}\n", case.title());
            for (what, of) in [
                ("ms, build alone", (|m: &Measured| m.build) as fn(&Measured) -> f64),
                ("ms, search alone", |m: &Measured| m.search),
            ] {
                text += &self.head(&[what, "visits"]);
                for traversal in [Traversal::Half, Traversal::CUT] {
                    for row in Volume::ROWS {
                        let options = TreeOptions::default().traversal(traversal);
                        let method = BroadPhaseMethod::Tree(options.volume(row.value));
                        let (cells, _) = self.row(method, case, of)?;
                        let visits = measure(&Place::one_thread(), method, case, 1)?
                            .map_or("-".to_owned(), |m| m.visits.to_string());
                        let name = traversal.row().name;
                        let _ = writeln!(text, "| {}, {name} | {visits} |{cells}", row.name);
                    }
                }
                text.push('\n');
            }
        }
        Ok(text)
    }

    /// The table of [Tian and Wan].
    fn cloth_and_sphere(&mut self) -> Result<String, String> {
        let mut text = String::new();
        for case in scenes::cloths_on_spheres()? {
            let _ = writeln!(text, "{}\n", case.title());
            for (what, of) in [
                ("build, ms", (|m: &Measured| m.build) as fn(&Measured) -> f64),
                ("collision, ms", |m: &Measured| m.search),
            ] {
                text += &self.head(&[what]);
                let pairs = Builder::NearestPair { limit: u32::MAX };
                let builders = [pairs, Builder::PLOC, Builder::SplitLists, Builder::Lbvh];
                for builder in builders {
                    let (cells, _) = self.row(tree(builder, Traversal::Half), &case, of)?;
                    let _ = writeln!(text, "| {} |{cells}", builder.row().name);
                }
                text.push('\n');
            }
        }
        Ok(text)
    }
}

/// Three significant digits.
pub fn digits(x: f64) -> String {
    let places = (2 - x.abs().max(1e-9).log10().floor() as i32).clamp(0, 4) as usize;
    format!("{x:.places$}")
}
