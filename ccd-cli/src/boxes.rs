//! `ccd boxes`: the broad phase alone.

use super::backend::BackendOptions;
use super::method::MethodOptions;
use super::{Failure, Outcome, in_file, output};
use ccd::Aabb;
use ccd::any::{BroadPhase, Choice, Error, Pairs};
use clap::Args;
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
    #[command(flatten)]
    backend: BackendOptions,
    #[command(flatten)]
    method: MethodOptions,
    /// Number of threads on the CPU; 0 means one per processor
    #[arg(long, value_name = "N", default_value_t = 0)]
    threads: usize,
    /// Runs; the median time is reported
    #[arg(long, value_name = "N", default_value_t = 5)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=1000))]
    runs: u32,
    /// Print one JSON object instead of text
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct Json<'a> {
    boxes: [usize; 2],
    pairs: usize,
    backend: &'static str,
    adapter: Option<&'a str>,
    threads: Option<usize>,
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
        self.method.no_pipeline()?;
        let start = Instant::now();
        let a = read(&self.a)?;
        let b = self.b.as_deref().map(read).transpose()?;
        let load = start.elapsed().as_secs_f64() * 1e3;
        let choice = self.backend.choose(a.len() + b.as_ref().map_or(0, Vec::len))?;
        let mut broad = self.broad_phase(&choice)?;
        let mut times = Vec::new();
        let mut n_pairs = 0;
        for _ in 0..self.runs {
            let start = Instant::now();
            n_pairs = count(&mut broad, &a, b.as_deref()).map_err(|e| match (e, &b) {
                (e @ Error::Input(_), None) => in_file(&self.a, e),
                (e, _) => e.into(),
            })?;
            times.push(start.elapsed().as_secs_f64() * 1e3);
        }
        let first = times[0];
        times.sort_unstable_by(f64::total_cmp);
        let times = Times { load, first, median: times[times.len() / 2], min: times[0] };
        let boxes = [a.len(), b.as_ref().map_or(0, Vec::len)];
        let place = broad.place();
        if self.json {
            let (backend, adapter, threads) = (place.backend(), place.adapter(), place.threads());
            output::json(&Json {
                boxes,
                pairs: n_pairs,
                backend,
                adapter,
                threads,
                runs: self.runs,
                times_ms: times,
            })?;
        } else {
            match boxes {
                [n, 0] if b.is_none() => output::line("boxes", n),
                [n, m] => output::line("boxes", format_args!("{n} against {m}")),
            }
            output::line("pairs", n_pairs);
            let ms = output::milliseconds;
            let text = format!(
                "median {} of {} runs on {place} (first {}, least {}); loading {}",
                ms(times.median),
                self.runs,
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

impl Boxes {
    fn broad_phase(&self, choice: &Choice) -> Result<BroadPhase, Failure> {
        let (method, scheduling) = (self.method.method()?, self.method.scheduling()?);
        Ok(BroadPhase::scheduled(choice, self.threads, method, scheduling)?)
    }
}

/// How many pairs there are within `a`, or of a box of `a` with one of `b`; all are listed.
fn count(broad: &mut BroadPhase, a: &[Aabb], b: Option<&[Aabb]>) -> Result<usize, Error> {
    match b {
        None => broad.self_pairs(a),
        Some(b) => broad.pairs(a, b),
    }
    .map(|pairs: Pairs| pairs.len())
}

fn read(path: &Path) -> Result<Vec<Aabb<f32>>, Failure> {
    let bytes = std::fs::read(path).map_err(|e| in_file(path, e))?;
    let size = size_of::<Aabb<f32>>();
    if bytes.len() % size != 0 {
        return Err(in_file(
            path,
            format_args!("{} bytes are no whole number of boxes ({size} bytes each)", bytes.len()),
        ));
    }
    let number = |b: &[u8]| f32::from_le_bytes([b[0], b[1], b[2], b[3]]);
    let boxes = bytes.chunks_exact(size).map(|b| {
        let n: [f32; 6] = std::array::from_fn(|i| number(&b[4 * i..]));
        Aabb { min: [n[0], n[1], n[2]], max: [n[3], n[4], n[5]] }
    });
    Ok(boxes.collect())
}
