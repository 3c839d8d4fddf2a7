//! `ccd boxes`: the broad phase alone.

use super::{Backend, Failure, Outcome, in_file, output};
use ccd::{Aabb, BroadPhase, Method};
use clap::{Args, ValueEnum};
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::time::Instant;

#[derive(Args)]
pub struct Boxes {
    /// Boxes
    #[arg(value_name = "A.bin")]
    a: PathBuf,
    /// A second set of boxes
    #[arg(value_name = "B.bin")]
    b: Option<PathBuf>,
    /// What runs the work
    #[arg(long, value_enum, default_value_t = Backend::Auto)]
    backend: Backend,
    /// How pairs are found; all ways find the same
    #[arg(long, value_enum, default_value_t = Way::Blocks)]
    method: Way,
    /// Number of threads; 0 means one per processor
    #[arg(long, value_name = "N", default_value_t = 0)]
    threads: usize,
    /// Runs; the median time is reported
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=1000))]
    runs: u32,
    /// Print one JSON object instead of text
    #[arg(long)]
    json: bool,
}

#[derive(Clone, Copy, ValueEnum)]
enum Way {
    /// Blocks of eight boxes in Morton order
    Blocks,
    /// A binary radix tree
    Tree,
}

#[derive(Serialize)]
struct Json {
    boxes: [usize; 2],
    pairs: usize,
    backend: &'static str,
    threads: usize,
    runs: u32,
    times_ms: Times,
}

#[derive(Serialize)]
struct Times {
    load: f64,
    first: f64,
    median: f64,
    min: f64,
}

impl Boxes {
    pub fn run(&self) -> Outcome {
        self.backend.require()?;
        let start = Instant::now();
        let a = read(&self.a)?;
        let b = self.b.as_deref().map(read).transpose()?;
        let load = start.elapsed().as_secs_f64() * 1e3;
        let method = match self.method {
            Way::Blocks => Method::Blocks,
            Way::Tree => Method::Tree,
        };
        let mut broad = BroadPhase::new(self.threads, method)?;
        let mut times = Vec::new();
        let mut n_pairs = 0;
        for _ in 0..self.runs {
            let start = Instant::now();
            let pairs = match &b {
                None => broad.self_pairs(&a).map_err(|e| in_file(&self.a, e))?,
                Some(b) => broad.pairs(&a, b)?,
            };
            n_pairs = pairs.len();
            times.push(start.elapsed().as_secs_f64() * 1e3);
        }
        let first = times[0];
        times.sort_unstable_by(f64::total_cmp);
        let times = Times { load, first, median: times[times.len() / 2], min: times[0] };
        let boxes = [a.len(), b.as_ref().map_or(0, Vec::len)];
        if self.json {
            output::json(&Json { boxes, pairs: n_pairs, backend: "cpu", threads: broad.threads(), runs: self.runs, times_ms: times })?;
        } else {
            match boxes {
                [n, 0] if b.is_none() => output::line("boxes", n),
                [n, m] => output::line("boxes", format_args!("{n} against {m}")),
            }
            output::line("pairs", n_pairs);
            let ms = output::milliseconds;
            let text = format!(
                "median {} of {} runs on {} threads (first {}, least {}); loading {}",
                ms(times.median),
                self.runs,
                broad.threads(),
                ms(times.first),
                ms(times.min),
                ms(load)
            );
            output::line("time", text);
        }
        output::flush();
        Ok(n_pairs > 0)
    }
}

fn read(path: &Path) -> Result<Vec<Aabb<f32>>, Failure> {
    let bytes = std::fs::read(path).map_err(|e| in_file(path, e))?;
    let size = size_of::<Aabb<f32>>();
    if bytes.len() % size != 0 {
        return Err(in_file(path, format_args!("{} bytes are no whole number of boxes ({size} bytes each)", bytes.len())));
    }
    let number = |b: &[u8]| f32::from_le_bytes([b[0], b[1], b[2], b[3]]);
    let boxes = bytes.chunks_exact(size).map(|b| {
        let n: [f32; 6] = std::array::from_fn(|i| number(&b[4 * i..]));
        Aabb { min: [n[0], n[1], n[2]], max: [n[3], n[4], n[5]] }
    });
    Ok(boxes.collect())
}
