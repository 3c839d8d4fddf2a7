//! Tables of the measurements.

use super::measure::{Measured, Structure};
use super::{Group, Results};
use crate::markdown::{Table, digits};
use crate::measure::Place;
use crate::stages::PARTS;
use ccd::method::Volume;
use std::fmt::Write;

/// Trees with boxes along the axes.
pub const TREE: Structure = Structure::Tree(Volume::Aabb);
/// The dissertation's own scheduler and the one it is compared with, as it has them.
pub const LAZY: &str = "lazy-stealing, front";
pub const BALANCED: &str = "balanced, front";

/// Three significant digits, down to the microsecond.
pub fn ms(cell: Option<&Measured>) -> String {
    cell.map_or(String::new(), |m| match m.ms() {
        few if few < 0.1 => format!("{few:.3}"),
        ms => digits(ms),
    })
}

/// A published figure.
fn published(x: f64) -> String {
    if x.is_nan() { "-".into() } else { x.to_string() }
}

/// Tables 4.1 and 4.4: lazy stealing and lists that are balanced, on trees with fronts, beside the
/// default, the fastest, and the dissertation's figures.
pub fn summary(all: &[Results], places: &[String]) -> String {
    let mut text = String::new();
    for (k, place) in places.iter().enumerate() {
        let mut table = Table::new(["", "lazy", "balanced", "default", "fastest", "which"]);
        for results in all {
            let Some((name, best)) = results.best(k) else { continue };
            let cell = |name: &str| ms(results.cell(k, TREE, name));
            let (default, best) = (ms(results.default(k)), digits(best.ms()));
            table.row([
                results.scene.name.clone(),
                cell(LAZY),
                cell(BALANCED),
                default,
                best,
                name,
            ]);
        }
        let _ = writeln!(text, "ms a step, {place}:\n\n{table}");
    }
    let columns = ["", "lazy, GTS 450", "GT 520", "gProximity, GTS 450", "GT 520"];
    let mut table = Table::new(columns);
    for results in all {
        let Some(figures) = results.scene.published else { continue };
        let [[a, b], [c, d]] = [figures.lazy, figures.gproximity].map(|ms| ms.map(published));
        table.row([results.scene.name.clone(), a, b, c, d]);
    }
    let _ = write!(text, "The dissertation's, ms:\n\n{table}");
    text
}

/// Tables 4.2 and 4.5: how many times as fast the most threads are as the fewest.
pub fn speedup(all: &[Results], places: &[Place]) -> String {
    let threads = |k: &usize| places[*k].threads();
    let cpus = || (0..places.len()).filter(|k| threads(k) > 0);
    let (Some(few), Some(many)) = (cpus().min_by_key(threads), cpus().max_by_key(threads)) else {
        return String::new();
    };
    let title = format!("{} to {} threads", threads(&few), threads(&many));
    let columns = [&title, "lazy", "balanced", "default", "lazy, there", "gProximity, there"];
    let mut table = Table::new(columns);
    for results in all {
        let speedup = |few: Option<&Measured>, many: Option<&Measured>| {
            few.zip(many)
                .map_or(String::new(), |(few, many)| format!("{:.2}", few.ms() / many.ms()))
        };
        let cell =
            |name: &str| speedup(results.cell(few, TREE, name), results.cell(many, TREE, name));
        let ratio = |ms: Option<[f64; 2]>| match ms {
            Some([a, b]) if a > 0.0 => format!("{:.2}", b / a),
            _ => "-".into(),
        };
        let published = results.scene.published;
        table.row([
            results.scene.name.clone(),
            cell(LAZY),
            cell(BALANCED),
            speedup(results.default(few), results.default(many)),
            ratio(published.map(|p| p.lazy)),
            ratio(published.map(|p| p.gproximity)),
        ]);
    }
    table.to_string()
}

/// Table 4.3: front nodes a step, by the first place.
pub fn fronts(all: &[Results]) -> String {
    let structures = Structure::ALL.map(|s| s.name().to_owned());
    let columns = [String::new()].into_iter().chain(structures);
    let rest = ["there", "MiB, tree", "steps that begin at it", "trees built"];
    let mut table = Table::new(columns.chain(rest.map(str::to_owned)));
    for results in all {
        let cell = |structure| results.cell(0, structure, LAZY);
        let pairs = |s| cell(s).map(Measured::front_pairs).map_or(String::new(), thousands);
        let published = results.scene.published.map_or("-".into(), |p| thousands(p.front));
        let of_tree = cell(TREE).map(|m| {
            let begun = m.fronts.iter().filter(|front| front.begun > 0).count();
            let most = m.fronts.iter().map(|front| front.bytes).max().unwrap_or(0);
            let begun = format!("{begun} of {}", m.steps.len());
            [digits(most as f64 / (1 << 20) as f64), begun, m.n_rebuilt.to_string()]
        });
        let name = [results.scene.name.clone()];
        let fronts = Structure::ALL.map(pairs);
        table.row([&name[..], &fronts, &[published], &of_tree.unwrap_or_default()].concat());
    }
    table.to_string()
}

fn thousands(n: f64) -> String {
    if n < 1e4 { format!("{n:.0}") } else { format!("{} K", digits(n / 1e3)) }
}

/// Every scheduler on every scene.
pub fn times(all: &[Results], places: &[String]) -> String {
    let mut text = String::new();
    for results in all {
        let _ = writeln!(text, "{}\n", results.scene.title());
        for groups in results.groups.chunks(WIDEST) {
            let columns = groups.iter().map(|group| {
                let short = places[group.place].replace(" threads", "").replace(" thread", "");
                let short = if short.len() > 3 { "GPU" } else { &short };
                format!("{} {short}", group.structure.name())
            });
            let mut table = Table::new(std::iter::once("ms".to_owned()).chain(columns));
            for name in names(&results.groups) {
                let cells = groups.iter();
                let cells = cells.map(|group| ms(results.cell(group.place, group.structure, name)));
                table.row([name.to_owned()].into_iter().chain(cells));
            }
            let _ = writeln!(text, "{table}");
        }
    }
    text
}

/// Most columns of a table of times: its rows are at most 100 wide.
const WIDEST: usize = 9;

/// The names of all rows, each once.
pub fn names<'g>(groups: &'g [Group]) -> Vec<&'g str> {
    let mut names: Vec<&'g str> = Vec::new();
    for (row, _) in groups.iter().flat_map(|group| &group.rows) {
        if !names.contains(&row.name.as_str()) {
            names.push(&row.name);
        }
    }
    names
}

/// Parts of a step on trees, at these places, for scenes that are not small.
pub fn shares(all: &[Results], places: &[(usize, &str)]) -> String {
    let mut text = String::new();
    for results in all.iter().filter(|results| results.scene.mesh.faces().len() > 4000) {
        for &(k, place) in places {
            let columns = ["%"].into_iter().chain(PARTS).chain(["workers busy"]);
            let mut table = Table::new(columns);
            for name in names(&results.groups).into_iter().filter(|name| name.ends_with(", front"))
            {
                let Some(m) = results.cell(k, TREE, name) else { continue };
                let percent = |x: f64| format!("{:.0}", 100.0 * x);
                let total = m.shares.parts.iter().sum::<f64>().max(1e-9);
                let cells = m.shares.parts.map(|x| percent(x / total));
                let busy = m.shares.utilisation.map_or(String::new(), percent);
                table.row([&[name.to_owned()][..], &cells, &[busy]].concat());
            }
            let _ = writeln!(text, "**{}**, {place}:\n\n{table}", results.scene.name);
        }
    }
    text
}
