//! `ccd boxes`: the broad phase alone.

use super::backend::BackendOptions;
use super::method::MethodOptions;
use super::{Failure, Outcome, backend, files, in_file, output, progress};
use ccd::Aabb;
use ccd::any::{BroadPhase, Error, Pairs};
use clap::Args;
use serde::Serialize;
use std::io::{BufWriter, Write};
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
    /// Runs; the median time is reported
    #[arg(long, value_name = "N", default_value_t = 5, allow_negative_numbers = true)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=1000))]
    runs: u32,
    /// Write the pairs, raw and sorted, as below; `-` is standard output
    #[arg(long, value_name = "OUT.bin")]
    pairs: Option<PathBuf>,
    /// Print one JSON object instead of text
    #[arg(short, long)]
    json: bool,
    #[command(flatten)]
    backend: BackendOptions,
    // Last: the options behind it would stand below its heading.
    #[command(flatten)]
    method: MethodOptions,
}

#[derive(Serialize)]
struct Json<'a> {
    boxes: [usize; 2],
    pairs: usize,
    #[serde(flatten)]
    place: output::Place<'a>,
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
        let read_from: Vec<&Path> =
            [Some(&self.a), self.b.as_ref()].into_iter().flatten().map(PathBuf::as_path).collect();
        let json = self.json.then_some("--json");
        let pairs_path = self.pairs.as_deref();
        files::check(json, &[("--pairs", pairs_path)], &read_from)?;
        let out = pairs_path.map(|path| files::create(path, &["bin"])).transpose()?;
        let start = Instant::now();
        let a = read(&self.a)?;
        let b = self.b.as_deref().map(read).transpose()?;
        let load = start.elapsed().as_secs_f64() * 1e3;
        let choice = self.backend.choose(a.len() + b.as_ref().map_or(0, Vec::len))?;
        let (method, scheduling) = (self.method.method()?, self.method.scheduling()?);
        let mut broad = BroadPhase::scheduled(&choice, self.backend.threads(), method, scheduling)?;
        let mut times = Vec::new();
        let mut n_pairs = 0;
        let bar = progress::bar(self.runs as usize, "runs");
        for _ in 0..self.runs {
            let start = Instant::now();
            n_pairs = pairs(&mut broad, &a, b.as_deref())?.len();
            times.push(start.elapsed().as_secs_f64() * 1e3);
            bar.inc(1);
        }
        bar.finish_and_clear();
        if let (Some(out), Some(path)) = (out, &self.pairs) {
            let found = pairs(&mut broad, &a, b.as_deref())?;
            write(out, found).map_err(|e| files::failed(path, e))?;
        }
        let compilation = choice.device().map(|device| device.compilation());
        let first = times[0];
        times.sort_unstable_by(f64::total_cmp);
        let median = output::median(&times).unwrap_or_default();
        let times = Times { load, first, median, min: times[0] };
        let boxes = [a.len(), b.as_ref().map_or(0, Vec::len)];
        let place = broad.place();
        if self.json {
            let (place, runs) = (output::Place::new(&place, None), self.runs);
            output::json(&Json { boxes, pairs: n_pairs, place, runs, times_ms: times })?;
        } else if !pairs_path.is_some_and(files::is_standard) {
            match boxes {
                [n, 0] if b.is_none() => output::line("boxes", n),
                [n, m] => output::line("boxes", format_args!("{n} against {m}")),
            }
            output::line("pairs", n_pairs);
            backend::print_compilation(compilation);
            let ms = output::milliseconds;
            let text = format!("median {} of {} runs on {place}", ms(times.median), self.runs);
            output::line("time", text);
            let [first, min, load] = [times.first, times.min, load].map(ms);
            output::line("", format_args!("first {first}, least {min}; loading {load}"));
        }
        output::flush();
        Ok(n_pairs > 0)
    }
}

/// The pairs within `a`, or of a box of `a` with one of `b`.
fn pairs<'a>(
    broad: &'a mut BroadPhase,
    a: &[Aabb],
    b: Option<&[Aabb]>,
) -> Result<Pairs<'a>, Error> {
    match b {
        None => broad.self_pairs(a),
        Some(b) => broad.pairs(a, b),
    }
}

/// Pairs as little-endian numbers of 32 bits, two each, sorted.
fn write(out: files::Output, pairs: Pairs) -> std::io::Result<()> {
    let mut pairs: Vec<[u32; 2]> = pairs.iter().map(|pair| [pair.a, pair.b]).collect();
    pairs.sort_unstable();
    let mut out = BufWriter::with_capacity(1 << 16, out);
    for id in pairs.as_flattened() {
        out.write_all(&id.to_le_bytes())?;
    }
    out.into_inner()?.done()
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
    let boxes = bytes.chunks_exact(size).enumerate().map(|(at, b)| {
        let n: [f32; 6] = std::array::from_fn(|i| number(&b[4 * i..]));
        // Written so that NaN fails.
        if let Some(axis) = (0..3).find(|&axis| !(n[axis] <= n[axis + 3])) {
            let (name, min, max) = (["x", "y", "z"][axis], n[axis], n[axis + 3]);
            let what = format!("box {at} (counted from 0) has {name} from {min} to {max}");
            return Err(in_file(path, what));
        }
        Ok(Aabb { min: [n[0], n[1], n[2]], max: [n[3], n[4], n[5]] })
    });
    boxes.collect()
}
