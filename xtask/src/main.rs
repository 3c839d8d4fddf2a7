//! `cargo xtask`: what the project does to itself.
#![deny(unsafe_code)]

#[cfg(feature = "report")]
mod algorithms;
mod bevy;
mod c_api;
#[cfg(any(feature = "report", test))]
mod cells;
mod checked;
mod ci;
mod circles;
mod compile_times;
mod doc_examples;
#[cfg(any(feature = "report", test))]
mod exponents;
#[cfg(feature = "report")]
mod gpu;
#[cfg(feature = "report")]
mod group;
#[cfg(feature = "report")]
mod growth;
#[path = "../../ccd-shaders/builder/src/instructions.rs"]
mod instructions;
#[cfg(feature = "report")]
mod level;
mod lints;
#[cfg(any(feature = "report", test))]
mod markdown;
#[cfg(feature = "report")]
mod measure;
mod mutants;
#[cfg(feature = "shaders")]
mod packed;
#[cfg(feature = "report")]
mod peers;
#[cfg(feature = "report")]
mod plot;
mod programs;
mod python;
mod python_calls;
#[cfg(feature = "report")]
mod report;
#[cfg(feature = "report")]
mod schedulers;
mod shaders;
#[cfg(feature = "soak")]
mod soak;
#[cfg(any(feature = "report", test))]
mod stages;
mod tidy;
mod tint;
mod wasm;
#[cfg(feature = "web")]
mod web;
#[cfg(feature = "shaders")]
mod wgsl;
#[cfg(feature = "report")]
mod worlds;

use clap::Parser;
use std::path::Path;
use std::process::ExitCode;

/// Tasks of the project.
#[derive(Parser)]
#[allow(dead_code, reason = "what a task is told is read where its feature is built in")]
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
    /// Model checks of the deques that workers steal from: interleavings, within bounds that
    /// docs/SCHEDULING.md states; the printed algorithms must be refuted
    Loom {
        /// Within the bounds of docs/SCHEDULING.md, which takes minutes, instead of two preemptions
        #[arg(long)]
        whole: bool,
        /// Only models whose name contains this, and other arguments of a test program
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        args: Vec<String>,
    },
    /// Search for wrong answers (--help lists its options)
    #[command(disable_help_flag = true)]
    Attack {
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        args: Vec<String>,
    },
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
    /// Build the example in a Bevy app by its own Rust, run it under Xvfb and compare its contacts;
    /// reported as skipped where either is missing
    Bevy,
    /// Build the examples of the C API with CMake, against an installed package, and run them
    CApi {
        /// Have CMake build the libraries by cargo, from nothing
        #[arg(long)]
        cargo: bool,
    },
    /// Build the npm package into ccd-web/pkg and test it under Node
    Web {
        /// Test its page too, in Chromium and Firefox
        #[arg(long)]
        page: bool,
    },
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
        #[arg(long, group = "by_scenes")]
        gpu: bool,
        /// Where the GPU's report goes
        #[arg(long, requires = "gpu", default_value = "benches/GPU.md")]
        out: std::path::PathBuf,
        /// Measure every method beside every other instead, on the CPU and on the GPU if there is
        /// one, and write the tables and plots of docs/ALGORITHMS.md (needs the data)
        #[arg(long, conflicts_with = "gpu")]
        algorithms: bool,
        /// Count how far threads of a GPU diverge instead, by running its kernels on the CPU, and
        /// write these tables of docs/ALGORITHMS.md (needs the data)
        #[arg(long, conflicts_with_all = ["gpu", "algorithms"])]
        divergence: bool,
        /// Measure every scheduler with a front and without one over sequences instead, on the CPU
        /// and on the GPU if there is one, and write the tables and plots of docs/SCHEDULING.md
        #[arg(long, conflicts_with_all = ["gpu", "algorithms", "divergence"],
            groups = ["chosen", "by_scenes"])]
        schedulers: bool,
        /// Measure real scenes and how times and memory grow with the input instead, on the CPU and
        /// on the GPU if there is one, and write the tables and plots of docs/PERFORMANCE.md and,
        /// with a GPU, the table of README.md (needs the data)
        #[arg(long, conflicts_with_all = ["gpu", "algorithms", "divergence"],
            groups = ["chosen", "by_scenes"])]
        growth: bool,
        /// Measure a body that falls on a large level instead, beside parry3d, and print the table
        #[arg(long, conflicts_with_all = ["gpu", "algorithms", "divergence", "chosen"])]
        level: bool,
        #[command(flatten)]
        chosen: ChoiceOptions,
        /// Keep what --algorithms, --schedulers or --growth measured in this folder, so that a
        /// report goes on where it was
        #[arg(long, value_name = "FOLDER")]
        cells: Option<std::path::PathBuf>,
        /// Begin no measurement after so many minutes; tables are written once all cells are there
        #[arg(long, requires = "cells")]
        minutes: Option<f64>,
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

/// What the reports of schedulers and of growth measure; that of the GPU takes scenes alone.
#[derive(Clone, Debug, clap::Args)]
struct ChoiceOptions {
    /// Numbers of threads; --schedulers: 1 and 2; --growth, which takes the largest: all
    #[arg(long, requires = "chosen", value_delimiter = ',')]
    threads: Vec<usize>,
    /// Only scenes whose name contains one of these
    #[arg(long, requires = "by_scenes", value_delimiter = ',')]
    scenes: Vec<String>,
    /// Few steps of the smaller scenes, few sizes
    #[arg(long, requires = "chosen")]
    quick: bool,
    /// Leave the GPU out
    #[arg(long, requires = "chosen")]
    no_gpu: bool,
    /// Only the table over the number of workers of the GPU
    #[arg(long, requires = "schedulers", conflicts_with = "no_gpu")]
    workers: bool,
    /// The folder with the page, SCHEDULING.md or PERFORMANCE.md, and its folder of plots
    #[arg(long, requires = "chosen", default_value = "docs")]
    folder: std::path::PathBuf,
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
    /// Steps of real scenes on a device whose `f64` is not used (needs the data)
    Narrow,
    /// Steps on all GPUs of this host, beside one
    Group,
    /// 4,096 independent cloths in one call, beside calls of 16
    Worlds,
}

fn main() -> ExitCode {
    if let Some(code) = lints::wrapped() {
        return code;
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new("."));
    let task = Task::parse();
    let result = match feature_of(&task) {
        Some((feature, false)) => again_with(root, feature, &task),
        _ => run(root, task),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(e) => {
            eprintln!("error: {e}");
            ExitCode::FAILURE
        }
    }
}

/// The feature that a task needs, and whether this program is built with it.
fn feature_of(task: &Task) -> Option<(&'static str, bool)> {
    Some(match task {
        Task::Shaders { checked: false, .. } => ("shaders", cfg!(feature = "shaders")),
        Task::Report { .. } => ("report", cfg!(feature = "report")),
        Task::Soak { .. } => ("soak", cfg!(feature = "soak")),
        Task::Web { .. } => ("web", cfg!(feature = "web")),
        _ => return None,
    })
}

/// Builds this program again with a feature, and runs the same task by that.
fn again_with(root: &Path, feature: &str, task: &Task) -> Result<(), String> {
    if let (Task::Shaders { check: true, .. }, Some(no_nightly)) = (task, shaders::missing(root)?) {
        programs::skipped(&no_nightly);
        return tint::run(root);
    }
    // Bindings need no optimized program. Windows does not replace this one while it runs.
    let is_debug = feature == "web" && !cfg!(windows);
    let profile: &[&str] = if is_debug { &[] } else { &["--release"] };
    let build = ["-p", "xtask", "--features", feature, "--"];
    let args: Vec<String> = std::env::args().skip(1).collect();
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    programs::command(root, &[&["cargo", "run"], profile, &build, &args].concat())
}

fn run(root: &Path, task: Task) -> Result<(), String> {
    match task {
        Task::Ci { whole } => ci::run(root, whole),
        Task::Tidy => tidy::run(root),
        Task::Mutants { names } => mutants::run(root, &names),
        Task::Loom { whole, args } => {
            let env: &[_] = if whole { &[("CCD_WHOLE", "1")] } else { &[] };
            programs::test(root, "interleavings", &args, env)
        }
        Task::Attack { args } => {
            programs::test(root, "attack", &[vec!["search".into()], args].concat(), &[])
        }
        Task::Shaders { checked: true, .. } => checked::run(root),
        #[cfg(feature = "shaders")]
        Task::Shaders { check, .. } => shaders::run(root, check),
        Task::Tint => tint::run(root),
        Task::Bevy => bevy::run(root),
        Task::CApi { cargo } => c_api::run(root, cargo),
        Task::Wasm => wasm::run(root, &[]),
        #[cfg(feature = "web")]
        Task::Web { page } => web::run(root, page),
        Task::Python { wheel } => python::run(root, wheel),
        #[cfg(feature = "report")]
        Task::Report { algorithms: true, cells, minutes, .. } => {
            algorithms::run(root, cells::Cells::open(cells.as_deref(), "algorithms", minutes)?)
        }
        #[cfg(feature = "report")]
        Task::Report { divergence: true, .. } => algorithms::divergence(root),
        #[cfg(feature = "report")]
        Task::Report { schedulers: true, chosen, cells, minutes, .. } => {
            let cells = cells::Cells::open(cells.as_deref(), "schedulers", minutes)?;
            schedulers::run(root, chosen, cells)
        }
        #[cfg(feature = "report")]
        Task::Report { growth: true, chosen, cells, minutes, .. } => {
            let cells = cells::Cells::open(cells.as_deref(), "growth", minutes)?;
            growth::run(root, &chosen, cells)
        }
        #[cfg(feature = "report")]
        Task::Report { level: true, .. } => level::run(),
        #[cfg(feature = "report")]
        Task::Report { runs, gpu: true, out, only, chosen, .. } => {
            gpu::run(root, runs, &out, &only, &chosen.scenes)
        }
        #[cfg(feature = "report")]
        Task::Report { runs, .. } => report::run(root, runs),
        Task::CompileTimes { only } => compile_times::run(root, only),
        #[cfg(feature = "soak")]
        Task::Soak { minutes, backend } => soak::run(minutes, &backend),
        #[allow(unreachable_patterns, reason = "with all features there is none")]
        _ => Err("the feature of this task is missing".into()),
    }
}
