//! `ccd queries`: elemental queries against the answers in their files.

use super::{Failure, Outcome, Precision, output};
use ccd::io::{Query, read_queries};
use ccd::{EdgeEdge, Real, Verdict, VertexFace};
use clap::Args;
use serde::Serialize;
use std::path::PathBuf;
use std::time::Instant;

#[derive(Args)]
pub struct Queries {
    /// Query files
    #[arg(required = true, value_name = "FILE.csv")]
    files: Vec<PathBuf>,
    /// Coordinates of the queries (f32: rounded, decided in f32 and, where that cannot, in f64)
    #[arg(long, value_enum, default_value_t = Precision::F64)]
    precision: Precision,
    /// Print one JSON object instead of text
    #[arg(long)]
    json: bool,
}

#[derive(Clone, Default, Serialize)]
struct Counts {
    queries: usize,
    hits: usize,
    misses: usize,
    undecided: usize,
    false_positives: usize,
    false_negatives: usize,
    ns_per_query: f64,
}

#[derive(Serialize)]
struct File {
    file: String,
    #[serde(flatten)]
    counts: Counts,
}

#[derive(Serialize)]
struct Json {
    files: Vec<File>,
    total: Counts,
}

impl Queries {
    pub fn run(&self) -> Outcome {
        let bar = output::progress(self.files.len(), "files");
        let mut files = Vec::new();
        let mut total = Counts::default();
        let mut total_ns = 0.0;
        for path in &self.files {
            let queries = read_queries(path)?;
            let start = Instant::now();
            let verdicts: Vec<Verdict<f64>> =
                queries.queries.iter().map(|q| decide(q, self.precision)).collect();
            let ns = start.elapsed().as_secs_f64() * 1e9;
            let mut counts = Counts { queries: verdicts.len(), ..Counts::default() };
            for (verdict, &answer) in verdicts.iter().zip(&queries.answers) {
                let hit = verdict.toi().is_some();
                counts.hits += hit as usize;
                counts.misses += !hit as usize;
                counts.undecided += matches!(verdict, Verdict::Undecided { .. }) as usize;
                counts.false_positives += (hit && !answer) as usize;
                counts.false_negatives += (!hit && answer) as usize;
            }
            counts.ns_per_query = per_query(ns, counts.queries);
            total.queries += counts.queries;
            total.hits += counts.hits;
            total.misses += counts.misses;
            total.undecided += counts.undecided;
            total.false_positives += counts.false_positives;
            total.false_negatives += counts.false_negatives;
            total_ns += ns;
            files.push(File { file: path.display().to_string(), counts });
            bar.inc(1);
        }
        bar.finish_and_clear();
        total.ns_per_query = per_query(total_ns, total.queries);
        let any = total.hits > 0;
        if self.json {
            output::json(&Json { files, total })?;
        } else {
            output::say!(
                "{:>8} {:>7} {:>7} {:>10} {:>10} {:>10} {:>8}  file",
                "queries",
                "hits",
                "misses",
                "undecided",
                "false pos",
                "false neg",
                "ns each"
            );
            files.iter().for_each(|f| print(&f.counts, &f.file));
            print(&total, "total");
        }
        output::flush();
        Ok::<_, Failure>(any)
    }
}

fn per_query(ns: f64, n: usize) -> f64 {
    if n == 0 { 0.0 } else { ns / n as f64 }
}

fn print(c: &Counts, name: &str) {
    output::say!(
        "{:>8} {:>7} {:>7} {:>10} {:>10} {:>10} {:>8.0}  {name}",
        c.queries,
        c.hits,
        c.misses,
        c.undecided,
        c.false_positives,
        c.false_negatives,
        c.ns_per_query
    );
}

fn decide(query: &Query, precision: Precision) -> Verdict<f64> {
    let narrow = |x: &[[f64; 3]; 4]| x.map(|p| p.map(|c| c as f32));
    match (precision, query) {
        (Precision::F64, Query::VertexFace(q)) => ccd::vertex_face(q, 0.0),
        (Precision::F64, Query::EdgeEdge(q)) => ccd::edge_edge(q, 0.0),
        (Precision::F32, Query::VertexFace(q)) => {
            let q = VertexFace { t0: narrow(&q.t0), t1: narrow(&q.t1) };
            widen(ccd::vertex_face(&q, 0.0)).unwrap_or_else(|| ccd::vertex_face(&q.widen(), 0.0))
        }
        (Precision::F32, Query::EdgeEdge(q)) => {
            let q = EdgeEdge { t0: narrow(&q.t0), t1: narrow(&q.t1) };
            widen(ccd::edge_edge(&q, 0.0)).unwrap_or_else(|| ccd::edge_edge(&q.widen(), 0.0))
        }
    }
}

/// `None` if undecided.
fn widen<R: Real>(verdict: Verdict<R>) -> Option<Verdict<f64>> {
    match verdict {
        Verdict::Miss => Some(Verdict::Miss),
        Verdict::Hit { toi } => Some(Verdict::Hit { toi: toi.to_f64() }),
        Verdict::Undecided { .. } => None,
    }
}
