//! `cargo xtask`: what the project does to itself.
#![deny(unsafe_code)]

#[cfg(feature = "algorithms")]
mod algorithms;
#[cfg(feature = "attack")]
mod attack;
mod checked;
mod ci;
mod compile_times;
#[cfg(feature = "gpu-report")]
mod gpu;
#[cfg(feature = "loom")]
mod interleavings;
#[cfg(any(feature = "report", feature = "gpu-report", test))]
mod markdown;
mod mutants;
mod optional;
mod python;
#[cfg(feature = "report")]
mod report;
#[cfg(feature = "algorithms")]
mod schedulers;
mod shaders;
#[cfg(feature = "soak")]
mod soak;
mod tidy;
mod tint;
mod wasm;
#[cfg(feature = "shaders")]
mod wgsl;

use clap::Parser;
use std::path::Path;
use std::process::ExitCode;

/// Tasks of the project.
#[derive(Parser)]
#[command(name = "cargo xtask")]
enum Task {
    /// Everything that must pass: formatting, lints, no_std, tests, docs, tidy
    Ci {
        /// Leave nothing out (with CCD_WHOLE=1), and search for long: some hours
        #[arg(long)]
        whole: bool,
    },
    /// Rules of the repository that no compiler checks
    Tidy,
    /// Mutations of ccd-core that its tests must notice, one at a time
    Mutants {
        /// Only those whose name contains one of these
        names: Vec<String>,
    },
    /// Model checks of the deques that workers steal from: all interleavings, within bounds that
    /// docs/SCHEDULING.md states; the printed algorithms must be refuted
    Loom {
        /// Only models whose name contains this
        #[arg(default_value = "")]
        name: String,
        /// Run this one in this process
        #[arg(long, hide = true)]
        here: bool,
    },
    /// Search for wrong answers: boxes by every method against brute force, queries that are nearly
    /// degenerate against exact answers, sessions in which everything changes and fails against
    /// new ones; what is found is shrunk and written as a test
    Attack(AttackOptions),
    /// Compile the shaders (needs the nightly of ccd-shaders/rust-toolchain.toml) and write them to
    /// ccd-gpu/shaders
    Shaders {
        /// Compare with the committed files instead; reported as skipped where the nightly is
        /// missing
        #[arg(long)]
        check: bool,
        /// Write the committed modules with a check of every index to target/shaders/checked
        /// instead, for tests with CCD_CHECKED_SHADERS
        #[arg(long, conflicts_with = "check")]
        checked: bool,
    },
    /// Have Tint, the compiler of Chromium's WebGPU, read the WGSL; fetched by npm where it is not
    /// there, and reported as skipped where it cannot be
    Tint,
    /// Build for WebAssembly and compare answers under Node with those of this machine
    Wasm,
    /// Test the Python module against ipctk, in an environment below target
    Python {
        /// Build a wheel with maturin and test that
        #[arg(long)]
        wheel: bool,
    },
    /// Measure against ipctk and parry3d and write benches/RESULTS.md (needs the data, python3, and
    /// pip or an installed ipctk)
    Report {
        /// Runs of each measurement; medians are reported
        #[arg(long, default_value_t = 5)]
        runs: usize,
        /// Measure the GPU instead and write benches/GPU.md (needs the data)
        #[arg(long)]
        gpu: bool,
        /// Where the GPU's report goes
        #[arg(long, requires = "gpu", default_value = "benches/GPU.md")]
        out: std::path::PathBuf,
        /// Measure every method beside every other instead, on the CPU and on the GPU if there is
        /// one, and write the tables and plots of docs/ALGORITHMS.md (needs the data)
        #[arg(long, conflicts_with = "gpu")]
        algorithms: bool,
        /// Measure every scheduler with a front and without one over sequences instead, on the CPU
        /// and on the GPU if there is one, and write the tables and plots of docs/SCHEDULING.md
        #[arg(long, conflicts_with_all = ["gpu", "algorithms"])]
        schedulers: bool,
        #[command(flatten)]
        of_schedulers: SchedulersOptions,
        /// Only these measurements of the GPU
        #[arg(long, requires = "gpu", value_enum, value_delimiter = ',')]
        only: Vec<Part>,
    },
    /// Measure how long compiling takes, beside bars; fails above twice a bar (takes long)
    CompileTimes {
        /// Measure this alone
        #[arg(long, value_enum)]
        only: Option<compile_times::Part>,
    },
    /// One session and one device through changing meshes, bodies and methods; fails if contacts
    /// change or memory grows
    Soak {
        /// How long; three cycles at least
        #[arg(long, default_value_t = 60.0)]
        minutes: f64,
        #[arg(long, default_value = "cpu", value_parser = ["cpu", "gpu"])]
        backend: String,
    },
}

/// What is searched, where, and for how long.
#[derive(Clone, Debug, clap::Args)]
#[cfg_attr(not(feature = "attack"), allow(dead_code, reason = "read where it is built"))]
struct AttackOptions {
    /// How long, all kinds together
    #[arg(long, default_value_t = 10.0)]
    minutes: f64,
    /// Where the work under test runs: the GPU through both paths, with and without f64, in turn
    /// (CCD_ADAPTER chooses one; an error if there is none)
    #[arg(long, value_enum, default_value = "cpu")]
    backend: AttackedBackend,
    /// This kind alone
    #[arg(long, value_enum)]
    kind: Option<AttackKind>,
    /// What cases are made of
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// This case alone, as a find names it
    #[arg(long, requires = "kind")]
    case: Option<u64>,
    /// The folder for what is found
    #[arg(long, default_value = "target/attack")]
    out: std::path::PathBuf,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum AttackedBackend {
    Cpu,
    Gpu,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum AttackKind {
    /// Pairs of boxes by every method and scheduler
    Boxes,
    /// Queries of families that are nearly degenerate
    Queries,
    /// Sessions in which everything changes between steps
    Sessions,
}

/// What the report of schedulers measures.
#[derive(Clone, Debug, clap::Args)]
struct SchedulersOptions {
    /// Numbers of threads
    #[arg(long, requires = "schedulers", value_delimiter = ',', default_values_t = [1, 2])]
    threads: Vec<usize>,
    /// Only scenes whose name contains one of these
    #[arg(long, requires = "schedulers", value_delimiter = ',')]
    scenes: Vec<String>,
    /// Few steps of the smaller scenes
    #[arg(long, requires = "schedulers")]
    quick: bool,
    /// No measurement of when fronts are given up
    #[arg(long, requires = "schedulers")]
    no_rules: bool,
    /// Leave the GPU out
    #[arg(long, requires = "schedulers")]
    no_gpu: bool,
    /// The folder with SCHEDULING.md and the folder of plots, scheduling
    #[arg(long, requires = "schedulers", default_value = "docs")]
    folder: std::path::PathBuf,
}

impl SchedulersOptions {
    /// As they are written on a command line.
    #[cfg(not(feature = "algorithms"))]
    fn args(&self) -> Vec<String> {
        let mut args: Vec<String> =
            self.threads.iter().map(|threads| format!("--threads={threads}")).collect();
        args.extend(self.scenes.iter().map(|scene| format!("--scenes={scene}")));
        let flags =
            [(self.quick, "--quick"), (self.no_rules, "--no-rules"), (self.no_gpu, "--no-gpu")];
        args.extend(flags.into_iter().filter(|flag| flag.0).map(|flag| flag.1.to_owned()));
        args.push(format!("--folder={}", self.folder.display()));
        args
    }
}

/// What the report of the GPU measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Part {
    /// Steps of real scenes (needs the data)
    Scenes,
    /// Pairs of uniform boxes
    Boxes,
    /// Sorting
    Sort,
}

impl std::fmt::Display for Part {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Scenes => "scenes",
            Self::Boxes => "boxes",
            Self::Sort => "sort",
        })
    }
}

fn main() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new("."));
    let result = match Task::parse() {
        Task::Ci { whole } => ci::run(root, whole),
        Task::Tidy => tidy::run(root),
        Task::Mutants { names } => mutants::run(root, &names),
        Task::Loom { name, here } => loom_task(root, &name, here),
        Task::Attack(options) => attack_task(root, &options),
        Task::Shaders { checked: true, .. } => checked::run(root),
        Task::Shaders { check, .. } => shaders_task(root, check),
        Task::Tint => tint::run(root),
        Task::Wasm => wasm::run(root),
        Task::Python { wheel } => python::run(root, wheel),
        Task::Report { runs, algorithms: true, .. } => algorithms_task(root, runs),
        Task::Report { schedulers: true, of_schedulers, .. } => {
            schedulers_task(root, &of_schedulers)
        }
        Task::Report { runs, gpu: true, out, only, .. } => {
            gpu_task(root, runs, &root.join(out), &only)
        }
        Task::Report { runs, .. } => report_task(root, runs),
        Task::CompileTimes { only } => compile_times::run(root, only),
        Task::Soak { minutes, backend } => soak_task(root, minutes, &backend),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(e) => {
            eprintln!("error: {e}");
            ExitCode::FAILURE
        }
    }
}

#[cfg(feature = "report")]
fn report_task(root: &Path, runs: usize) -> Result<(), String> {
    report::run(root, runs)
}

/// Without the libraries to compare with: builds itself again with them.
#[cfg(not(feature = "report"))]
fn report_task(root: &Path, runs: usize) -> Result<(), String> {
    let runs = runs.to_string();
    ci::command(
        root,
        &[
            "cargo",
            "run",
            "--release",
            "-p",
            "xtask",
            "--features",
            "report",
            "--",
            "report",
            "--runs",
            &runs,
        ],
    )
}

#[cfg(feature = "algorithms")]
fn algorithms_task(root: &Path, runs: usize) -> Result<(), String> {
    algorithms::run(root, runs)
}

/// Without what it measures: builds itself again with it.
#[cfg(not(feature = "algorithms"))]
fn algorithms_task(root: &Path, runs: usize) -> Result<(), String> {
    let runs = runs.to_string();
    let build = ["cargo", "run", "--release", "-p", "xtask", "--features", "algorithms", "--"];
    ci::command(root, &[&build[..], &["report", "--algorithms", "--runs", &runs]].concat())
}

#[cfg(feature = "algorithms")]
fn schedulers_task(root: &Path, options: &SchedulersOptions) -> Result<(), String> {
    schedulers::run(root, options)
}

/// Without what it measures: builds itself again with it.
#[cfg(not(feature = "algorithms"))]
fn schedulers_task(root: &Path, options: &SchedulersOptions) -> Result<(), String> {
    let args = options.args();
    let build = ["cargo", "run", "--release", "-p", "xtask", "--features", "algorithms", "--"];
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    ci::command(root, &[&build[..], &["report", "--schedulers"], &args].concat())
}

#[cfg(feature = "gpu-report")]
fn gpu_task(_root: &Path, runs: usize, out: &Path, only: &[Part]) -> Result<(), String> {
    gpu::run(runs, out, only)
}

/// Without what it measures: builds itself again with it.
#[cfg(not(feature = "gpu-report"))]
fn gpu_task(root: &Path, runs: usize, out: &Path, only: &[Part]) -> Result<(), String> {
    let (runs, out) = (runs.to_string(), out.to_string_lossy());
    let only: Vec<String> = only.iter().map(|part| format!("--only={part}")).collect();
    let mut args = vec!["report", "--gpu", "--runs", &runs, "--out", &out];
    args.extend(only.iter().map(String::as_str));
    ci::command(
        root,
        &[
            &["cargo", "run", "--release", "-p", "xtask", "--features", "gpu-report", "--"],
            &args[..],
        ]
        .concat(),
    )
}

#[cfg(feature = "attack")]
fn attack_task(_root: &Path, options: &AttackOptions) -> Result<(), String> {
    attack::run(options)
}

/// Without what it attacks: builds itself again with it.
#[cfg(not(feature = "attack"))]
fn attack_task(root: &Path, _options: &AttackOptions) -> Result<(), String> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let build = ["cargo", "run", "--release", "-p", "xtask", "--features", "attack", "--"];
    ci::command(root, &build.into_iter().chain(args.iter().map(String::as_str)).collect::<Vec<_>>())
}

#[cfg(feature = "shaders")]
fn shaders_task(root: &Path, check: bool) -> Result<(), String> {
    shaders::run(root, check)
}

/// Without the translator: builds itself again with it, if there is anything to do.
#[cfg(not(feature = "shaders"))]
fn shaders_task(root: &Path, check: bool) -> Result<(), String> {
    if let (true, Some(no_nightly)) = (check, shaders::missing(root)?) {
        optional::skipped(&no_nightly);
        return tint::run(root);
    }
    let mut args =
        vec!["cargo", "run", "--release", "-p", "xtask", "--features", "shaders", "--", "shaders"];
    args.extend(check.then_some("--check"));
    ci::command(root, &args)
}

#[cfg(feature = "loom")]
fn loom_task(_root: &Path, name: &str, here: bool) -> Result<(), String> {
    if here { interleavings::here(name) } else { interleavings::run(name) }
}

/// Without the model checker: builds itself again with it.
#[cfg(not(feature = "loom"))]
fn loom_task(root: &Path, name: &str, _here: bool) -> Result<(), String> {
    let build = ["cargo", "run", "--release", "-p", "xtask", "--features", "loom", "--", "loom"];
    ci::command(root, &[&build[..], &[name]].concat())
}

#[cfg(feature = "soak")]
fn soak_task(_root: &Path, minutes: f64, backend: &str) -> Result<(), String> {
    soak::run(minutes, backend)
}

/// Without what it runs: builds itself again with it.
#[cfg(not(feature = "soak"))]
fn soak_task(root: &Path, minutes: f64, backend: &str) -> Result<(), String> {
    let build = ["cargo", "run", "--release", "-p", "xtask", "--features", "soak", "--", "soak"];
    let minutes = minutes.to_string();
    ci::command(root, &[&build[..], &["--minutes", &minutes, "--backend", backend]].concat())
}
