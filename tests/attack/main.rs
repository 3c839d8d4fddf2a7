//! Searches for wrong answers. What is right is known from brute force, exact arithmetic or
//! construction.
//!
//! `cargo xtask attack` searches for minutes; as a test this program takes the first cases of a
//! seed. A case is made from a seed and a number, so its number alone replays it. The first case
//! that fails ends the search of its kind: it is shrunk and written as JSON, which can be replayed
//! too. Cases that failed once stand in `tests/attack_cases` and are replayed before every search.

mod boxes;
mod exact;
mod queries;
mod query_families;
mod session_bodies;
mod session_check;
mod session_faults;
mod session_scenes;
mod session_steps;
mod sessions;

use ccd::any::Choice;
use ccd::gpu::{self, Device, DeviceOptions};
use ccd::method::{BroadPhaseMethod, Scheduler, Scheduling};
use ccd_testkit::grazing::random::Random;
use clap::Parser;
use libtest_mimic::{Arguments, Failed, Trial};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeMap;
use std::io::{IsTerminal, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// Cases that failed once.
const CASES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/attack_cases");
/// Consecutive cases on one device: an emulated one compiles for half a minute.
const IN_A_ROW: u64 = 16;
/// Sessions of the test: some 150 choices among the methods of a CPU, and every kind of change.
const FIRST_SESSIONS: u64 = 32;
const KINDS: [Kind; 4] = [
    Kind::of::<boxes::Case>(),
    Kind::of::<queries::Case>(),
    Kind::of::<sessions::Case>(),
    Kind::of::<exact::Case>(),
];

/// Searches for wrong answers: boxes by every method against brute force, nearly degenerate queries
/// against exact answers, changing and failing sessions against new ones, decisions by integers
/// against rational arithmetic. A case that fails is shrunk and written as JSON.
#[derive(Parser)]
#[command(name = "cargo xtask attack")]
struct Options {
    /// How long, all kinds together
    #[arg(long, default_value_t = 10.0)]
    minutes: f64,
    /// So many cases of each kind, however long they take; one of the kind `exact` has 110 queries
    /// of each family, so that 10000 are over a million
    #[arg(long, conflicts_with = "minutes")]
    cases: Option<u64>,
    /// Where the work under test runs: the GPU through both paths, with and without f64, in turn
    /// (CCD_ADAPTER chooses one; an error if there is none)
    #[arg(long, default_value = "cpu", value_parser = ["cpu", "gpu"])]
    backend: String,
    /// This kind alone
    #[arg(long, value_parser = KINDS.map(|kind| kind.name))]
    kind: Option<String>,
    /// The seed of all cases
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// This case alone: a file that a search has written, or with --kind its number
    #[arg(long, value_name = "FILE|NUMBER")]
    case: Option<String>,
    /// The folder for cases that fail
    #[arg(long, default_value = "target/attack")]
    out: PathBuf,
}

/// A kind of cases.
struct Kind {
    name: &'static str,
    search: fn(&Options, &[Place], Duration) -> Result<(), String>,
    replay: fn(&Value, &Place) -> Result<(), String>,
}

impl Kind {
    const fn of<C: Case>() -> Self {
        Self { name: C::NAME, search: search::<C>, replay: replay::<C> }
    }
}

/// A case: a call or a sequence of calls, as data.
trait Case: Clone + Serialize + DeserializeOwned {
    const NAME: &str;
    fn make(place: &Place, number: u64, random: Random, counts: &mut Counts) -> Self;
    /// What is wrong, if anything is.
    fn check(&self, place: &Place, counts: &mut Counts) -> Result<(), String>;
    /// A smaller case that fails too.
    fn shrunk(self, fails: &dyn Fn(&Self) -> bool) -> Self;

    /// The same without counting; a panic is wrong too.
    fn again(&self, place: &Place) -> Result<(), String> {
        caught(|| self.check(place, &mut Counts::default()))
    }
}

/// A case that fails, as it is written: what is wrong, the command that replays it, and the case.
#[derive(Serialize, Deserialize)]
struct Found<C> {
    what: String,
    again: String,
    kind: String,
    backend: String,
    case: C,
}

/// Where the work under test runs.
struct Place {
    name: &'static str,
    choice: Choice,
}

impl Place {
    fn backend(&self) -> &'static str {
        if self.choice.device().is_some() { "gpu" } else { "cpu" }
    }

    /// The default scheduling and all others that a method takes; stealing needs SPIR-V.
    fn schedulings(&self, method: BroadPhaseMethod) -> Vec<Scheduling> {
        let device = self.choice.device();
        let native = device.is_none_or(|device| device.info().path == gpu::Path::Passthrough);
        let steals = [Some(Scheduler::Stealing), Some(Scheduler::LazyStealing)];
        let all = Scheduling::every(self.backend());
        let all =
            all.filter(|s| s.check(method).is_ok() && (native || !steals.contains(&s.scheduler)));
        std::iter::once(Scheduling::default()).chain(all).collect()
    }
}

/// Numbers by name, printed at the end of a search.
#[derive(Default)]
struct Counts(BTreeMap<String, u64>);

impl Counts {
    fn add(&mut self, name: &str, n: u64) {
        *self.0.entry(name.to_owned()).or_default() += n;
    }
}

impl std::fmt::Display for Counts {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let all: Vec<String> = self.0.iter().map(|(name, n)| format!("{name} {n}")).collect();
        f.write_str(&all.join(", "))
    }
}

fn main() -> ExitCode {
    // A panic that is caught is reported with its case.
    std::panic::set_hook(Box::new(|_| {}));
    if std::env::args().nth(1).is_none_or(|arg| arg != "search") {
        return libtest_mimic::run(&Arguments::from_args(), trials()).exit_code();
    }
    match run(&Options::parse_from(std::env::args().skip(1))) {
        Ok(()) => ExitCode::SUCCESS,
        Err(e) => {
            eprintln!("error: {e}");
            ExitCode::FAILURE
        }
    }
}

/// The first cases of each kind on the CPU: for seconds, of sessions always the same.
fn trials() -> Vec<Trial> {
    let first = |kind: Kind| {
        Trial::test(format!("first_{}", kind.name), move || {
            let cases = (kind.name == sessions::Case::NAME).then_some(FIRST_SESSIONS);
            let options = Options { cases, ..Options::parse_from(["attack"]) };
            Ok((kind.search)(&options, &places("cpu")?, Duration::from_secs(2))?)
        })
    };
    let mut all = Vec::from(KINDS.map(first));
    all.push(Trial::test("cases_that_failed_once_pass", || {
        assert!(std::fs::read_dir(CASES)?.count() > 2);
        Ok(replay_folder(Path::new(CASES), &places("cpu")?)?)
    }));
    all.push(Trial::test("a_wrong_answer_is_found", a_wrong_answer_is_found));
    all
}

/// A query that is said to meet nothing fails, alone and in a session, shrinks to itself, and fails
/// again as data.
fn a_wrong_answer_is_found() -> Result<(), Failed> {
    let place = &places("cpu")?[0];
    let made = |n| queries::Case::make(place, n, Random::new(n), &mut Counts::default());
    let cases = (0..1024).map(made).filter_map(queries::Case::with_a_lie);
    let found: Vec<_> = cases.filter(|case| case.again(place).is_err()).take(8).collect();
    assert_eq!(found.len(), 8);
    for case in found {
        let few = case.shrunk(&|case| case.again(place).is_err());
        assert_eq!(few.n_queries(), 1);
        let data = serde_json::to_value(&few)?;
        replay::<queries::Case>(&data, place).unwrap_err();
    }
    Ok(())
}

fn run(options: &Options) -> Result<(), String> {
    if let Some(file) = options.case.as_ref().filter(|case| case.parse::<u64>().is_err()) {
        return replay_file(Path::new(file), None);
    }
    let places = places(&options.backend)?;
    if options.case.is_none() {
        replay_folder(Path::new(CASES), &places)?;
    }
    let is_wanted = |kind: &&Kind| options.kind.as_ref().is_none_or(|name| name == kind.name);
    let kinds: Vec<&Kind> = KINDS.iter().filter(is_wanted).collect();
    let share = Duration::try_from_secs_f64(options.minutes * 60.0 / kinds.len() as f64)
        .map_err(|e| format!("--minutes {}: {e}", options.minutes))?;
    let search = |kind: &Kind| (kind.search)(options, &places, share).err();
    let found: Vec<String> = kinds.into_iter().filter_map(search).collect();
    if found.is_empty() { Ok(()) } else { Err(found.join("\n")) }
}

/// The CPU, or a device of each path with and without `f64`.
fn places(backend: &str) -> Result<Vec<Place>, String> {
    if backend == "cpu" {
        return Ok(vec![Place { name: "cpu", choice: Choice::default() }]);
    }
    let mut all = Vec::new();
    for (narrow, path, name) in [
        (false, gpu::Path::Passthrough, "passthrough, f64"),
        (false, gpu::Path::Wgsl, "WGSL, f64"),
        (true, gpu::Path::Passthrough, "passthrough, f32"),
        (true, gpu::Path::Wgsl, "WGSL, f32"),
    ] {
        let options = DeviceOptions { path: Some(path), narrow, ..DeviceOptions::default() };
        match Device::open(&options) {
            Ok(device) if narrow || device.info().wide => {
                println!("{name}: {}", device.info().adapter.name);
                all.push(Place { name, choice: Choice::of_device(&device, false) });
            }
            Ok(_) => println!("{name}: the device has no f64"),
            Err(e) => println!("{name}: {e}"),
        }
    }
    if all.is_empty() {
        Err("--backend gpu, but no device could be opened".into())
    } else {
        Ok(all)
    }
}

/// Cases of one kind until its time is over, or the one that `--case` names; the first that fails
/// is an error.
fn search<C: Case>(options: &Options, places: &[Place], share: Duration) -> Result<(), String> {
    let (name, seed) = (C::NAME, options.seed);
    let (start, mut shown) = (Instant::now(), Instant::now());
    let mut counts = Counts::default();
    let only: Option<u64> = options.case.as_ref().and_then(|case| case.parse().ok());
    let mut number = only.unwrap_or(0);
    let found = loop {
        let place = &places[(number / IN_A_ROW) as usize % places.len()];
        // One after the other of two generators, so that neighbours have nothing in common.
        let mut random = Random::new(seed);
        let random = Random::new(random.bits() ^ Random::new(number).bits());
        counts.add("cases", 1);
        let case = C::make(place, number, random, &mut counts);
        if let Err(what) = caught(|| case.check(place, &mut counts)) {
            break Some((place, case, what));
        }
        number += 1;
        let is_over = match options.cases {
            Some(n) => number >= n,
            None => start.elapsed() >= share,
        };
        if only.is_some() || is_over {
            break None;
        }
        if shown.elapsed().as_secs() >= 10 && std::io::stdout().is_terminal() {
            print!("\r{name}: case {number}, {} s", start.elapsed().as_secs());
            let _ = std::io::stdout().flush();
            shown = Instant::now();
        }
    };
    println!("{name}: {counts}, in {:.1} s", start.elapsed().as_secs_f64());
    let Some((place, case, what)) = found else { return Ok(()) };
    let case = case.shrunk(&|case| case.again(place).is_err());
    let what = case.again(place).err().unwrap_or(what);
    let what = format!("{name}, {}: {what}", place.name);
    let backend = place.backend();
    let again = format!(
        "cargo xtask attack --backend {backend} --kind {name} --seed {seed} --case {number}"
    );
    let path = options.out.join(format!("{backend}_{name}_{seed}_{number}.json"));
    let report = format!("{what}\nagain: {again}\nwritten to {}", path.display());
    let found = Found { what, again, kind: name.into(), backend: backend.into(), case };
    let text = serde_json::to_string_pretty(&found).map_err(|e| e.to_string())?;
    std::fs::create_dir_all(&options.out)
        .and_then(|()| std::fs::write(&path, text + "\n"))
        .map_err(|e| format!("{}: {e}\n{report}", path.display()))?;
    Err(report)
}

/// Replays every case of a folder at the places of its backend; without the folder there is none.
fn replay_folder(folder: &Path, places: &[Place]) -> Result<(), String> {
    let Ok(files) = std::fs::read_dir(folder) else { return Ok(()) };
    let mut files: Vec<_> = files.flatten().map(|file| file.path()).collect();
    files.sort();
    files.iter().try_for_each(|file| replay_file(file, Some(places)))
}

/// Replays the case of a file at every place of its backend, which is opened if none is given.
fn replay_file(path: &Path, places: Option<&[Place]>) -> Result<(), String> {
    let failed = |e: String| format!("{}: {e}", path.display());
    let text = std::fs::read(path).map_err(|e| failed(e.to_string()))?;
    let found: Found<Value> = serde_json::from_slice(&text).map_err(|e| failed(e.to_string()))?;
    let kind = KINDS.iter().find(|kind| kind.name == found.kind);
    let kind = kind.ok_or_else(|| failed(format!("no kind of cases is `{}`", found.kind)))?;
    let opened = if places.is_some() { Vec::new() } else { self::places(&found.backend)? };
    for place in places.unwrap_or(&opened).iter().filter(|p| p.backend() == found.backend) {
        (kind.replay)(&found.case, place).map_err(|e| failed(format!("{}: {e}", place.name)))?;
        println!("{}, {}: as it should be", path.display(), place.name);
    }
    Ok(())
}

fn replay<C: Case>(case: &Value, place: &Place) -> Result<(), String> {
    C::deserialize(case).map_err(|e| e.to_string())?.again(place)
}

/// The result of `work`; a panic in it is an error.
fn caught<T>(work: impl FnOnce() -> Result<T, String>) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|why| {
        let text = why.downcast_ref::<String>().cloned();
        let text = text.or_else(|| why.downcast_ref::<&str>().map(|s| (*s).to_owned()));
        Err(format!("a panic: {}", text.unwrap_or_default()))
    })
}

/// Nearly the least part of `all` with which it still fails: parts are left out for as long as it
/// does, for at most half a minute.
fn fewest<T: Clone>(all: &[T], fails: impl Fn(&[T]) -> bool) -> Vec<T> {
    let mut kept = all.to_vec();
    let start = Instant::now();
    let mut part = kept.len().div_ceil(2);
    while part > 0 {
        let mut at = 0;
        while at < kept.len() && start.elapsed().as_secs() < 30 {
            let end = (at + part).min(kept.len());
            let less = [&kept[..at], &kept[end..]].concat();
            if fails(&less) { kept = less } else { at = end }
        }
        part /= 2;
    }
    kept
}
