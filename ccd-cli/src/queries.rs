//! `ccd queries`: elemental queries against the answers in their files.

use super::method::{Choices, choice};
use super::rows::{self, Rows};
use super::{Failure, Outcome, Precision, files, interrupt, output, progress};
use ccd::exact::{self, Exact};
use ccd::io::{Queries as File, Query, read_queries, read_queries_of};
use ccd::{EdgeEdge, Kind, Verdict, VertexFace};
use clap::Args;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::time::Instant;

#[derive(Args)]
pub struct Queries {
    /// Query files
    #[arg(required = true, value_name = "FILE.csv")]
    files: Vec<PathBuf>,
    /// Coordinates of the queries (f32: rounded, decided in f32, in f64 where that leaves it open;
    /// answers of files are about coordinates that are not rounded)
    #[arg(long, value_enum, default_value_t = Precision::F64)]
    precision: Precision,
    /// What the files hold; without it their paths tell
    #[arg(long, value_parser = choice(KINDS))]
    kind: Option<Kind>,
    /// Contact means a distance of at most D; answers of files are about touching: with D above 0
    /// hits that they call misses are not counted as false
    #[arg(long, value_name = "D", default_value_t = 0.0, allow_negative_numbers = true)]
    min_distance: f64,
    /// Write the verdicts as CSV: file,query,kind,verdict,toi,answer; verdicts are hit,
    /// miss, undecided, or far (a miss by the boxes alone); `-` is standard output
    #[arg(long, value_name = "OUT.csv")]
    out: Option<PathBuf>,
    /// Print one JSON object instead of text
    #[arg(short, long)]
    json: bool,
}

const KINDS: Choices<Kind, 2> =
    [("vf", "Vertex-face", Kind::VertexFace), ("ee", "Edge-edge", Kind::EdgeEdge)];

#[derive(Clone, Default, Serialize)]
struct Counts {
    queries: usize,
    hits: usize,
    misses: usize,
    /// Misses whose swept boxes are apart.
    far: usize,
    undecided: usize,
    /// `None` where files have no answers, or answers about something else.
    false_positives: Option<usize>,
    false_negatives: Option<usize>,
    ns_per_query: f64,
}

#[derive(Serialize)]
struct Row {
    file: String,
    #[serde(flatten)]
    counts: Counts,
}

#[derive(Serialize)]
struct Json {
    files: Vec<Row>,
    total: Counts,
}

impl Queries {
    pub fn run(&self) -> Outcome {
        ccd::Options::default()
            .with_min_distance(self.min_distance)
            .check(&ccd::Mesh::new(0, &[])?)?;
        let read_from: Vec<&Path> = self.files.iter().map(PathBuf::as_path).collect();
        let path = self.out.as_deref();
        files::check(self.json.then_some("--json"), &[("--out", path)], &read_from)?;
        let columns = "file,query,kind,verdict,toi,answer";
        let mut out = path.map(|path| Rows::create(path, columns)).transpose()?;
        let prints_text = !self.json && !path.is_some_and(files::is_standard);
        let bar = progress::bar(self.files.len(), "files");
        let mut files = Vec::new();
        let mut total = Counts::default();
        let mut total_ns = 0.0;
        for path in &self.files {
            interrupt::check()?;
            let queries = match self.kind {
                None => read_queries(path)?,
                Some(kind) => read_queries_of(path, kind)?,
            };
            let start = Instant::now();
            let decide = |query| decide(query, self.precision, self.min_distance);
            let verdicts: Vec<Option<Verdict<f64>>> = queries.queries.iter().map(decide).collect();
            let ns = start.elapsed().as_secs_f64() * 1e9;
            let mut counts = self.count(&queries, &verdicts);
            counts.ns_per_query = per_query(ns, counts.queries);
            if let Some(out) = &mut out {
                write(out, &path.display().to_string(), &queries, &verdicts)?;
            }
            total.add(&counts);
            total_ns += ns;
            files.push(Row { file: path.display().to_string(), counts });
            bar.inc(1);
        }
        bar.finish_and_clear();
        out.map_or(Ok(()), Rows::done)?;
        total.ns_per_query = per_query(total_ns, total.queries);
        let any = total.hits > 0;
        if self.json {
            output::json(&Json { files, total })?;
        } else if prints_text {
            output::say!(
                "{:>8} {:>6} {:>7} {:>6} {:>6} {:>6} {:>6} {:>5}  file",
                "queries",
                "hits",
                "misses",
                "(far)",
                "undec.",
                "f.pos.",
                "f.neg.",
                "ns"
            );
            let folder = common_folder(&self.files);
            for (row, path) in files.iter().zip(&self.files) {
                let name = path.strip_prefix(folder).unwrap_or(path);
                print(&row.counts, &name.display().to_string());
            }
            print(&total, "total");
            output::say!(
                "far: misses by the boxes alone; undec.: counted among hits, too close to"
            );
            output::say!("tell; f.pos., f.neg.: hits and misses that the answers deny; ns: each");
            if self.precision == Precision::F32 {
                output::say!("With f32 these two are no errors: answers are about coordinates");
                output::say!("that are not rounded.");
            }
        }
        output::flush();
        Ok::<_, Failure>(any)
    }

    fn count(&self, file: &File, verdicts: &[Option<Verdict<f64>>]) -> Counts {
        let mut counts = Counts { queries: verdicts.len(), ..Counts::default() };
        let is_hit = |verdict: &Option<Verdict<f64>>| verdict.is_some_and(|v| v.toi().is_some());
        for verdict in verdicts {
            counts.hits += is_hit(verdict) as usize;
            counts.misses += !is_hit(verdict) as usize;
            counts.far += verdict.is_none() as usize;
            counts.undecided += matches!(verdict, Some(Verdict::Undecided { .. })) as usize;
        }
        if !file.answers.is_empty() || file.queries.is_empty() {
            let both = || verdicts.iter().map(is_hit).zip(file.answers.iter().copied());
            let positives = both().filter(|&(hit, answer)| hit && !answer).count();
            counts.false_positives = (self.min_distance == 0.0).then_some(positives);
            counts.false_negatives = Some(both().filter(|&(hit, answer)| !hit && answer).count());
        }
        counts
    }
}

impl Counts {
    fn add(&mut self, other: &Self) {
        self.queries += other.queries;
        self.hits += other.hits;
        self.misses += other.misses;
        self.far += other.far;
        self.undecided += other.undecided;
        let sum = |a: Option<usize>, b: Option<usize>| a.zip(b).map(|(a, b)| a + b).or(a).or(b);
        self.false_positives = sum(self.false_positives, other.false_positives);
        self.false_negatives = sum(self.false_negatives, other.false_negatives);
    }
}

/// A row for each query.
fn write(
    out: &mut Rows,
    name: &str,
    file: &File,
    verdicts: &[Option<Verdict<f64>>],
) -> Result<(), Failure> {
    let name = quoted(name);
    for (at, (query, verdict)) in file.queries.iter().zip(verdicts).enumerate() {
        let kind = rows::kind(match query {
            Query::VertexFace(_) => Kind::VertexFace,
            Query::EdgeEdge(_) => Kind::EdgeEdge,
        });
        let word = match verdict {
            None => "far",
            Some(Verdict::Miss) => "miss",
            Some(Verdict::Hit { .. }) => "hit",
            Some(Verdict::Undecided { .. }) => "undecided",
        };
        let toi = verdict.and_then(|v| v.toi()).map_or(String::new(), |toi| format!("{toi:?}"));
        let answer = file.answers.get(at).map_or("", |&yes| if yes { "1" } else { "0" });
        out.row(format_args!("{name},{at},{kind},{word},{toi},{answer}"))?;
    }
    out.flush()
}

/// A cell of CSV, in quotes if it needs them.
fn quoted(cell: &str) -> String {
    match cell.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", cell.replace('"', "\"\"")),
        false => cell.to_owned(),
    }
}

/// The folder that all files are in, below which their names tell them apart.
fn common_folder(files: &[PathBuf]) -> &Path {
    let first = files.first().and_then(|file| file.parent());
    let holds_all = |folder: &&Path| files.iter().all(|file| file.starts_with(folder));
    first.and_then(|first| first.ancestors().find(holds_all)).unwrap_or(Path::new(""))
}

fn per_query(ns: f64, n: usize) -> f64 {
    if n == 0 { 0.0 } else { ns / n as f64 }
}

fn print(c: &Counts, name: &str) {
    let number = |n: Option<usize>| n.map_or("-".into(), |n| n.to_string());
    output::say!(
        "{:>8} {:>6} {:>7} {:>6} {:>6} {:>6} {:>6} {:>5.0}  {name}",
        c.queries,
        c.hits,
        c.misses,
        c.far,
        c.undecided,
        number(c.false_positives),
        number(c.false_negatives),
        c.ns_per_query
    );
}

/// `None`: a miss by the boxes alone.
fn decide(query: &Query, precision: Precision, d: f64) -> Option<Verdict<f64>> {
    let (kind, ends) = match *query {
        Query::VertexFace(VertexFace { t0, t1 }) => (Kind::VertexFace, [t0, t1]),
        Query::EdgeEdge(EdgeEdge { t0, t1 }) => (Kind::EdgeEdge, [t0, t1]),
    };
    let narrow = ends.map(|x| x.map(|p| p.map(|c| c as f32)));
    let is_wide = precision == Precision::F64;
    let ends = if is_wide { ends } else { narrow.map(|x| x.map(|p| p.map(f64::from))) };
    if are_apart(&ends[0], &ends[1], kind.n_first(), d) {
        return None;
    }
    let decided = (!is_wide).then(|| widen(ask(kind, narrow, round_up(d)), d)).flatten();
    let verdict = decided.unwrap_or_else(|| ask(kind, ends, d));
    let is_open = matches!(verdict, Verdict::Undecided { .. }) && d == 0.0;
    Some(is_open.then(|| exactly(kind, ends)).flatten().unwrap_or(verdict))
}

/// By integers, as steps decide what is left open; `None` for numbers that these do not take.
fn exactly(kind: Kind, [t0, t1]: [[[f64; 3]; 4]; 2]) -> Option<Verdict<f64>> {
    let window = [0.0, 1.0];
    let exact = match kind {
        Kind::VertexFace => exact::vertex_face(&VertexFace { t0, t1 }, window),
        _ => exact::edge_edge(&EdgeEdge { t0, t1 }, window),
    };
    exact.map(|exact| match exact {
        Exact::Miss => Verdict::Miss,
        Exact::Contact([toi, _]) => Verdict::Hit { toi },
    })
}

fn ask<R: ccd::Real>(kind: Kind, [t0, t1]: [[[R; 3]; 4]; 2], d: R) -> Verdict<R> {
    match kind {
        Kind::VertexFace => ccd::vertex_face(&VertexFace { t0, t1 }, d),
        _ => ccd::edge_edge(&EdgeEdge { t0, t1 }, d),
    }
}

/// Whether the boxes in which the first `n` points and the others move are farther apart than `d`
/// along an axis. Rounded differences keep the order of exact ones, so this is exact.
fn are_apart(t0: &[[f64; 3]; 4], t1: &[[f64; 3]; 4], n: usize, d: f64) -> bool {
    let bounds = |from: usize, to: usize, axis: usize| {
        let extent = |x: &[[f64; 3]; 4]| {
            let all = x[from..to].iter().map(|p| p[axis]);
            (all.clone().fold(f64::INFINITY, f64::min), all.fold(f64::NEG_INFINITY, f64::max))
        };
        let (a, b) = (extent(t0), extent(t1));
        (a.0.min(b.0), a.1.max(b.1))
    };
    (0..3).any(|axis| {
        let (a, b) = (bounds(0, n, axis), bounds(n, 4, axis));
        b.0 - a.1 > d || a.0 - b.1 > d
    })
}

/// The least `f32` that is no less.
fn round_up(d: f64) -> f32 {
    let near = d as f32;
    if (near as f64) < d { near.next_up() } else { near }
}

/// A verdict of `f32`, about a distance that may have been rounded up; `None` if it leaves open
/// whether features come as near as `d`.
fn widen(verdict: Verdict<f32>, d: f64) -> Option<Verdict<f64>> {
    match verdict {
        Verdict::Miss => Some(Verdict::Miss),
        Verdict::Hit { toi } if round_up(d) as f64 == d => Some(Verdict::Hit { toi: toi.into() }),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_with_ends_of_lines_are_quoted() {
        for (cell, want) in [
            ("in/a b.csv", "in/a b.csv"),
            ("a,b", "\"a,b\""),
            ("a\"b", "\"a\"\"b\""),
            ("a\nb", "\"a\nb\""),
            ("a\rb", "\"a\rb\""),
        ] {
            assert_eq!(quoted(cell), want);
        }
    }
}
