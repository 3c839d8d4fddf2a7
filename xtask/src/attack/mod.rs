//! `cargo xtask attack`: searches for wrong answers that know what is right from brute force, exact
//! arithmetic or construction.
//!
//! A search makes cases from a seed and a number each, so that a case is replayed by its number
//! alone. The first one that fails ends its search: it is shrunk, and written as a test.

mod boxes;
mod queries;
mod query_families;
mod session_check;
mod session_faults;
mod session_steps;
mod sessions;

use crate::{AttackKind, AttackOptions, AttackedBackend};
use ccd::any::Choice;
use ccd::gpu::{Device, DeviceOptions, Path};
use ccd_testkit::grazing::random::Random;
use std::collections::BTreeMap;
use std::io::{IsTerminal, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

/// Where the work under test runs.
struct Place {
    name: &'static str,
    choice: Choice,
}

impl Place {
    fn backend(&self) -> &'static str {
        if self.choice.device().is_some() { "gpu" } else { "cpu" }
    }

    /// Rust that makes `choice`.
    fn code(&self) -> String {
        let Some(device) = self.choice.device() else {
            return "let choice = ccd::any::Choice::default();\n".into();
        };
        let info = device.info();
        format!(
            "let options = ccd::gpu::DeviceOptions {{ path: Some(ccd::gpu::Path::{:?}), narrow: \
             {}, ..Default::default() }};\n\
             let device = ccd::gpu::Device::open(&options).unwrap();\n\
             let choice = ccd::any::Choice::of_device(&device, false);\n",
            info.path, !info.wide
        )
    }
}

/// What was found: what is wrong in a line, and a body of a test that shows it.
struct Found {
    what: String,
    code: String,
}

/// Numbers by name, for the line at the end.
#[derive(Default)]
struct Counts(BTreeMap<String, u64>);

impl Counts {
    fn add(&mut self, name: &str, n: u64) {
        match self.0.get_mut(name) {
            Some(sum) => *sum += n,
            None => _ = self.0.insert(name.to_owned(), n),
        }
    }
}

impl std::fmt::Display for Counts {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let all: Vec<String> = self.0.iter().map(|(name, n)| format!("{name} {n}")).collect();
        f.write_str(&all.join(", "))
    }
}

/// Cases on one device before the next: an emulated one compiles for half a minute.
const IN_A_ROW: u64 = 16;

/// One case of a search.
type Case = fn(&Place, u64, Random, &mut Counts) -> Result<(), Found>;

pub fn run(options: &AttackOptions) -> Result<(), String> {
    let places = places(options.backend)?;
    // What is caught is told with what is found.
    std::panic::set_hook(Box::new(|_| {}));
    let all = [
        (AttackKind::Boxes, "boxes", boxes::case as Case),
        (AttackKind::Queries, "queries", queries::case as Case),
        (AttackKind::Sessions, "sessions", sessions::case as Case),
    ];
    let chosen = all.iter().filter(|(kind, ..)| options.kind.is_none_or(|k| k == *kind));
    let n = chosen.clone().count() as f64;
    let share = Duration::try_from_secs_f64(options.minutes * 60.0 / n)
        .map_err(|e| format!("--minutes {}: {e}", options.minutes))?;
    let mut found = Vec::new();
    for (_, name, case) in chosen {
        found.extend(search(options, &places, name, *case, share)?);
    }
    if found.is_empty() { Ok(()) } else { Err(found.join("\n")) }
}

/// The CPU, or a device of each path with and without `f64`.
fn places(backend: AttackedBackend) -> Result<Vec<Place>, String> {
    if backend == AttackedBackend::Cpu {
        return Ok(vec![Place { name: "cpu", choice: Choice::default() }]);
    }
    let mut all = Vec::new();
    for (narrow, path, name) in [
        (false, Path::Passthrough, "passthrough, f64"),
        (false, Path::Wgsl, "WGSL, f64"),
        (true, Path::Passthrough, "passthrough, f32"),
        (true, Path::Wgsl, "WGSL, f32"),
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

/// Cases of one kind until its time is over; returns what was found.
fn search(
    options: &AttackOptions,
    places: &[Place],
    name: &str,
    case: Case,
    share: Duration,
) -> Result<Option<String>, String> {
    let (start, mut told) = (Instant::now(), Instant::now());
    let mut counts = Counts::default();
    let mut number = options.case.unwrap_or(0);
    let found = loop {
        let place = &places[(number / IN_A_ROW) as usize % places.len()];
        // One after the other of two generators, so that neighbours have nothing in common.
        let mut random = Random::new(options.seed);
        let random = Random::new(random.bits() ^ Random::new(number).bits());
        counts.add("cases", 1);
        if let Err(found) = case(place, number, random, &mut counts) {
            break Some((place, found));
        }
        number += 1;
        if options.case.is_some() || start.elapsed() >= share {
            break None;
        }
        if told.elapsed().as_secs() >= 10 && std::io::stdout().is_terminal() {
            print!("\r{name}: case {number}, {} s", start.elapsed().as_secs());
            let _ = std::io::stdout().flush();
            told = Instant::now();
        }
    };
    println!("{name}: {counts}, in {:.1} s", start.elapsed().as_secs_f64());
    let Some((place, found)) = found else { return Ok(None) };
    let seed = options.seed;
    let backend = place.backend();
    let replay = format!(
        "cargo xtask attack --backend {backend} --kind {name} --seed {seed} --case {number}"
    );
    let what = format!("{name}, {}: {}", place.name, found.what);
    let comment: Vec<String> = what.lines().map(|line| format!("// {line}")).collect();
    let text = format!(
        "{}\n// {replay}\n#[test]\nfn {name}_{seed}_{number}() {{\n{}}}\n",
        comment.join("\n"),
        found.code
    );
    let path = options.out.join(format!("{backend}_{name}_{seed}_{number}.rs"));
    std::fs::create_dir_all(&options.out)
        .and_then(|()| std::fs::write(&path, &text))
        .map_err(|e| format!("{}: {e}\n{text}", path.display()))?;
    Ok(Some(format!("{what}\nagain: {replay}\nwritten to {}:\n{text}", path.display())))
}

/// What `work` says; a panic in it is an error.
fn caught<T>(work: impl FnOnce() -> Result<T, String>) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|why| {
        let text = why.downcast_ref::<String>().cloned();
        let text = text.or_else(|| why.downcast_ref::<&str>().map(|s| (*s).to_owned()));
        Err(format!("a panic: {}", text.unwrap_or_default()))
    })
}

/// The fewest of these with which it still fails, nearly: parts are left out for as long as it
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
