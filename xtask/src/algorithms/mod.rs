//! `cargo xtask report --algorithms`: every method beside every other, in the tables of
//! docs/ALGORITHMS.md, whose text stays as it is, and plots beside it.
//!
//! A table stands between two comments, `<!-- NAME -->` and `<!-- end -->`. Every answer is
//! checked: pairs against the default method, and that against the known count where there is one.

mod divergence;
mod measure;
mod pipelines;
mod scenes;

use crate::cells::Cells;
use crate::markdown::{Table, digits, rewrite, rewrite_alone};
use crate::measure::{Place, median_of};
use crate::plot::Bars;
use ccd::method::{BroadPhaseMethod, Builder, Catalogued, Descent, Traversal, TreeOptions, Volume};
use ccd::{BroadPhase, Pair};
use measure::{Measured, RUNS, kept};
use scenes::{Case, Draped};
use std::fmt::Write;
use std::path::{Path, PathBuf};

type Ms = fn(&Measured) -> f64;

/// A table for each case: rows of methods, columns of places.
struct Section {
    what: &'static str,
    ms: Ms,
    rows: Vec<(String, BroadPhaseMethod)>,
    /// Columns of figures that no place changes, by one thread.
    figures: &'static [&'static str],
    /// Names of the plot and of its file, if there is one.
    plot: Option<(&'static str, &'static str)>,
}

/// Measures all and rewrites the tables of docs/ALGORITHMS.md.
pub fn run(root: &Path, mut cells: Cells) -> Result<(), String> {
    let plots = root.join("docs/algorithms");
    std::fs::create_dir_all(&plots).map_err(|e| format!("{plots:?}: {e}"))?;
    let all = std::thread::available_parallelism().map_or(1, |n| n.get());
    let threads = if all > 1 { vec![1, all] } else { vec![1] };
    let cpus = threads.into_iter().map(|threads| Place::Cpu { threads });
    let places: Vec<Place> = cpus.chain(Place::gpu()).collect();
    let names: Vec<String> = places.iter().map(Place::name).collect();
    let machine = format!("Places: {}. Medians of {RUNS} runs.\n", names.join("; "));
    let pipelines = cells.get("pipelines", || pipelines::table(&places, RUNS))?.unwrap_or_default();
    let mut report = Report { places, cells, plots };
    let (cases, cloths) = (scenes::all()?, scenes::cloths_on_spheres(root)?);
    // The parallel searches of [Tian and Wan] are small: two threads as well.
    if all > 2 {
        report.places.insert(1, Place::Cpu { threads: 2 });
    }
    let cloth_and_sphere = report.draped(&cloths)?;
    report.places.retain(|place| place.threads() != 2 || all == 2);
    let tables = [
        ("machine", machine),
        ("methods", report.tables(&cases, &[methods()])?),
        ("ladder", report.tables(&cases, &[ladder()])?),
        ("simultaneous", report.tables(&cases, &[simultaneous()])?),
        ("builders", report.tables(&cases, &[builders()])?),
        ("cloth-and-sphere", cloth_and_sphere),
        ("volumes", report.tables(&cases, &volumes())?),
        ("pipelines", pipelines),
        ("divergence", divergence::tables(&cases)?),
    ];
    if !report.cells.are_complete() {
        return Ok(());
    }
    rewrite(&root.join("docs/ALGORITHMS.md"), &tables)
}

/// Rewrites the tables of divergence alone, which no machine changes.
pub fn divergence(root: &Path) -> Result<(), String> {
    let table = divergence::tables(&scenes::all()?)?;
    rewrite_alone(&root.join("docs/ALGORITHMS.md"), "divergence", &table)
}

/// A tree of these.
fn tree(builder: Builder, traversal: Traversal) -> BroadPhaseMethod {
    BroadPhaseMethod::Tree(TreeOptions::default().builder(builder).traversal(traversal))
}

/// Every broad phase on every scene, whole calls.
fn methods() -> Section {
    let rows = BroadPhaseMethod::ROWS.iter().map(|row| (row.name.to_owned(), row.value)).collect();
    let ms = |m: &Measured| m.build + m.search;
    let plot = Some(("Methods", "methods"));
    Section { what: "ms, build and search", ms, rows, figures: &[], plot }
}

/// Recursive, iterative, leaf order, half: the ladder of [Karras 2012b].
fn ladder() -> Section {
    let rungs = [Traversal::Recursive, Traversal::Iterative, Traversal::LeafOrder, Traversal::Half];
    let row = |t: Traversal| (t.row().name.to_owned(), tree(Builder::Lbvh, t));
    let (rows, plot) = (rungs.map(row).into(), Some(("The ladder", "ladder")));
    Section { what: "ms, search alone", ms: |m| m.search, rows, figures: &[], plot }
}

/// Simultaneous against independent traversal, in visits and in time.
fn simultaneous() -> Section {
    let rows = [
        ("leaf-order", Traversal::LeafOrder),
        ("half", Traversal::Half),
        ("simultaneous, larger", Traversal::Simultaneous(Descent::Larger)),
        ("simultaneous, both", Traversal::Simultaneous(Descent::Both)),
        ("cut of 256, larger", Traversal::Cut { nodes: 256, descent: Descent::Larger }),
        ("cut of 256, both", Traversal::CUT),
        ("cut of 256 by stacks, both", Traversal::CUT_STACKS),
    ];
    let rows = rows.map(|(name, t)| (name.to_owned(), tree(Builder::Lbvh, t))).into();
    Section { what: "ms, search alone", ms: |m| m.search, rows, figures: &["visits"], plot: None }
}

/// Build time, cost and visited nodes of every builder.
fn builders() -> Section {
    let row =
        |row: &ccd::method::Row<Builder>| (row.name.to_owned(), tree(row.value, Traversal::Half));
    let (rows, figures) = (Builder::ROWS.iter().map(row).collect(), &OF_TREE[..]);
    Section { what: "ms, build alone", ms: |m| m.build, rows, figures, plot: None }
}

const OF_TREE: [&str; 3] = ["cost", "nodes a query", "depth"];

/// Boxes along the axes against oriented ones, in visits and in time.
fn volumes() -> [Section; 2] {
    let columns: [(_, Ms); 2] =
        [("ms, build alone", |m| m.build), ("ms, search alone", |m| m.search)];
    columns.map(|(what, ms)| {
        let traversals = [Traversal::Half, Traversal::CUT];
        let rows = traversals.into_iter().flat_map(|traversal| {
            Volume::ROWS.iter().map(move |row| {
                let options = TreeOptions::default().traversal(traversal).volume(row.value);
                let name = format!("{}, {}", row.name, traversal.row().name);
                (name, BroadPhaseMethod::Tree(options))
            })
        });
        Section { what, ms, rows: rows.collect(), figures: &["visits"], plot: None }
    })
}

/// The table of [Tian and Wan].
fn cloth_and_sphere() -> [Section; 2] {
    let columns: [(_, Ms); 2] = [("build, ms", |m| m.build), ("collision, ms", |m| m.search)];
    columns.map(|(what, ms)| {
        let pairs = Builder::NearestPair { limit: u32::MAX };
        let builders = [pairs, Builder::PLOC, Builder::SplitLists, Builder::Lbvh];
        let row = |b: Builder| (b.row().name.to_owned(), tree(b, Traversal::Half));
        let both = |b: Builder| {
            (format!("{}, double recursion", b.row().name), tree(b, Traversal::DoubleRecursion))
        };
        let rows = builders.map(row).into_iter().chain([pairs, Builder::Lbvh].map(both)).collect();
        Section { what, ms, rows, figures: &[], plot: None }
    })
}

struct Report {
    places: Vec<Place>,
    cells: Cells,
    plots: PathBuf,
}

impl Report {
    /// All sections of every case.
    fn tables(&mut self, cases: &[Case], sections: &[Section]) -> Result<String, String> {
        let mut text = String::new();
        for case in cases {
            let _ = writeln!(text, "{}\n", case.title());
            for section in sections {
                self.section(case, section, &mut text)?;
            }
        }
        Ok(text)
    }

    /// The table of [Tian and Wan] with the tree over either object, and the exact tests of the
    /// pairs of triangles, which come after the search.
    fn draped(&mut self, scenes: &[Draped]) -> Result<String, String> {
        let mut text = String::new();
        for draped in scenes {
            text += &self.tables(&draped.cases, &cloth_and_sphere())?;
            let places = self.places.iter().filter(|place| place.threads() > 0);
            let names = places.clone().map(Place::name);
            let mut table = Table::new(
                ["exact tests, ms".into(), "triangles meet".into()].into_iter().chain(names),
            );
            let (mut times, mut n_meeting) = (Vec::new(), None);
            for place in places {
                let name = format!("{}|{}|exact tests", draped.cases[0].name, place.name());
                let cell = self.cells.get(&name, || tests(draped, place.threads()))?;
                let Some((ms, n)) = cell else { continue };
                if *n_meeting.get_or_insert(n) != n {
                    return Err(format!("{name}: {n} meet, elsewhere {n_meeting:?}"));
                }
                times.push(digits(ms));
            }
            let n = n_meeting.map_or(String::new(), |n| n.to_string());
            table.row(["all pairs".into(), n].into_iter().chain(times));
            let _ = writeln!(text, "{table}");
        }
        Ok(text)
    }

    fn section(&mut self, case: &Case, section: &Section, text: &mut String) -> Result<(), String> {
        let &Section { what, ms, ref rows, figures, plot } = section;
        let names: Vec<String> = self.places.iter().map(Place::name).collect();
        let places = names.iter().map(String::as_str);
        let mut table = Table::new([what].into_iter().chain(figures.iter().copied()).chain(places));
        let mut bars = Bars::new(format!("{}, {what}", case.name), names);
        for (name, method) in rows {
            let mut cells = vec![name.clone()];
            if !figures.is_empty() {
                let one = Place::Cpu { threads: 1 };
                let measured = kept(&mut self.cells, &one, *method, case)?.and_then(Result::ok);
                cells.extend(of_one_thread(measured, figures));
            }
            let mut values = Vec::new();
            for place in &self.places {
                let measured = kept(&mut self.cells, place, *method, case)?;
                let Some(measured) = measured else { continue };
                cells.push(measured.as_ref().map_or_else(Clone::clone, |m| digits(ms(m))));
                values.push(measured.ok().as_ref().map(ms));
            }
            table.row(cells);
            if values.len() == self.places.len() {
                bars.add(name, values);
            }
        }
        let _ = writeln!(text, "{table}");
        if let Some((title, prefix)) = plot {
            let file = format!("{prefix}-{}.svg", case.file_name());
            bars.write(&self.plots.join(&file))?;
            let _ = writeln!(text, "![{title} on {}](algorithms/{file})\n", case.name);
        }
        Ok(())
    }
}

/// The median of milliseconds of the tests on so many threads, and how many triangles meet.
fn tests(draped: &Draped, threads: usize) -> Result<(f64, usize), String> {
    let (boxes, against) = (&draped.cases[0].boxes, draped.cases[0].against.as_ref());
    let mut broad =
        BroadPhase::new(threads, BroadPhaseMethod::default()).map_err(|e| e.to_string())?;
    let pairs = broad.pairs(against.ok_or("no spheres")?, boxes).map_err(|e| e.to_string())?;
    let pairs: Vec<Pair> = pairs.iter().collect();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|e| e.to_string())?;
    median_of(RUNS, || Ok(pool.install(|| draped.n_meeting(&pairs))))
}

/// Cells of figures: visits, or those of the tree.
fn of_one_thread(measured: Option<Measured>, figures: &[&str]) -> Vec<String> {
    if figures != OF_TREE {
        return vec![measured.map_or("-".into(), |m| m.visits.to_string())];
    }
    let tree = measured.and_then(|m| m.tree);
    let cells =
        tree.map(|t| [digits(t.sah_cost), digits(t.visited_per_query), t.depth.to_string()]);
    cells.unwrap_or_default().into()
}
