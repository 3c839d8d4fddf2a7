//! Tools of all reports: places, times, medians.

use ccd::any::Choice;
use ccd::gpu::{Device, DeviceOptions};
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

/// Place of a measurement.
pub enum Place {
    /// Threads of this machine.
    Cpu { threads: usize },
    /// The first GPU that there is.
    Gpu { device: Box<Device>, name: String },
}

impl Place {
    /// The GPU, if there is one.
    pub fn gpu() -> Option<Self> {
        match Device::open(&DeviceOptions::default()) {
            Ok(device) => {
                let name = device.info().adapter.name.clone();
                Some(Self::Gpu { device: Box::new(device), name })
            }
            Err(why) => {
                println!("without a GPU: {why}");
                None
            }
        }
    }

    /// The choice by which a session or a broad phase runs here and nowhere else.
    pub fn choice(&self) -> Choice {
        match self {
            Self::Cpu { .. } => Choice::default(),
            Self::Gpu { device, .. } => Choice::of_device(device, false),
        }
    }

    /// Threads of the CPU; 0 for a GPU.
    pub fn threads(&self) -> usize {
        if let Self::Cpu { threads } = self { *threads } else { 0 }
    }

    pub fn backend(&self) -> &'static str {
        if matches!(self, Self::Cpu { .. }) { "cpu" } else { "gpu" }
    }

    pub fn name(&self) -> String {
        match self {
            Self::Cpu { threads: 1 } => "1 thread".into(),
            Self::Cpu { threads } => format!("{threads} threads"),
            Self::Gpu { name, .. } => name.clone(),
        }
    }
}

/// Date, commit, processor and compiler of a run; what a machine does not have is left out.
pub fn this_run(root: &Path) -> String {
    // A program that was built elsewhere may run where its sources are not.
    let folder = if root.is_dir() { root } else { Path::new(".") };
    let shell = |words: &[&str]| {
        let output = Command::new(words[0]).args(&words[1..]).current_dir(folder).output();
        output.map(|o| String::from_utf8_lossy(&o.stdout).trim().to_owned()).unwrap_or_default()
    };
    let cpu = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let cpu = cpu
        .lines()
        .find_map(|l| l.strip_prefix("model name"))
        .map_or("unknown processor", |l| l.trim_start_matches([':', '\t', ' ']));
    let cores = std::thread::available_parallelism().map_or(0, |n| n.get());
    let is_clean = shell(&["git", "status", "--porcelain"]).is_empty();
    let changed = if is_clean { "" } else { " with uncommitted changes" };
    let commit = shell(&["git", "rev-parse", "--short", "HEAD"]);
    let commit = if commit.is_empty() { commit } else { format!("commit {commit}{changed}") };
    let (date, compiler) = (shell(&["date", "-u", "+%Y-%m-%d"]), shell(&["rustc", "--version"]));
    let cores = format!("{cores} cores");
    let all = [date, commit, cpu.to_owned(), cores, compiler];
    let all: Vec<String> = all.into_iter().filter(|part| !part.is_empty()).collect();
    all.join(", ")
}

/// The middle one; 0 of none.
pub fn median(values: impl IntoIterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.into_iter().collect();
    values.sort_unstable_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

/// Result of `work`, and its milliseconds by the clock.
pub fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let start = Instant::now();
    let done = work();
    (start.elapsed().as_secs_f64() * 1e3, done)
}

/// The median of the milliseconds of `runs` calls after a warm-up, and what the last one returned.
pub fn median_of<T, E>(runs: usize, mut call: impl FnMut() -> Result<T, E>) -> Result<(f64, T), E> {
    let mut last = None;
    let times = warm(runs, || {
        let (ms, done) = timed(&mut call);
        done.map(|done| {
            last = Some(done);
            ms
        })
    })?;
    Ok((median(times), last.expect("a warm-up calls at least once")))
}

/// As [`median_of`], of several calls that take turns: `rounds` of `runs` each. What slows the
/// machine down for a while slows down all of them.
pub fn by_turns<N, T, E, C: FnMut() -> Result<T, E>>(
    rounds: usize,
    runs: usize,
    calls: &mut [(N, C)],
) -> Result<Vec<(f64, T)>, E> {
    let mut times = vec![Vec::with_capacity(rounds * runs); calls.len()];
    let mut last: Vec<Option<T>> = calls.iter().map(|_| None).collect();
    for _ in 0..rounds {
        for (k, (_, call)) in calls.iter_mut().enumerate() {
            let start = Instant::now();
            while start.elapsed() < WARM_UP {
                call()?;
            }
            for _ in 0..runs {
                let (ms, result) = timed(&mut *call);
                times[k].push(ms);
                last[k] = Some(result?);
            }
        }
    }
    Ok(times.into_iter().map(median).zip(last.into_iter().flatten()).collect())
}

/// Works before a measurement: a device that was idle needs about this long to reach its clock
/// again.
const WARM_UP: Duration = Duration::from_millis(300);

/// Results of `runs` calls of `run` after a warm-up.
pub fn warm<T, E>(runs: usize, mut run: impl FnMut() -> Result<T, E>) -> Result<Vec<T>, E> {
    let start = Instant::now();
    while start.elapsed() < WARM_UP {
        run()?;
    }
    (0..runs).map(|_| run()).collect()
}
