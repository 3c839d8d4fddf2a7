//! `cargo xtask attack`: searches for wrong answers that know what is right from brute force, exact
//! arithmetic or construction.
//!
//! A search makes cases from a seed and a number each, so that a case is replayed by its number
//! alone. The first one that fails ends its search: it is shrunk, and written as JSON, which is
//! replayed too. What was found once stands in `tests/attack_cases` and is replayed by every run.

mod boxes;
mod queries;
mod query_families;
mod session_check;
mod session_faults;
mod session_steps;
mod sessions;

use crate::{AttackKind, AttackOptions, AttackedBackend};
use ccd::any::Choice;
use ccd::gpu::{self, Device, DeviceOptions};
use ccd::{BroadPhaseMethod, Scheduler, Scheduling};
use ccd_testkit::grazing::random::Random;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::io::{IsTerminal, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::{Duration, Instant};

/// What was found once, in the repository.
const CASES: &str = "tests/attack_cases";

/// A case of a search: what is asked of a place, as data.
trait Case: Clone + Serialize + DeserializeOwned {
    const KIND: AttackKind;
    const NAME: &str;
    fn make(place: &Place, number: u64, random: Random, counts: &mut Counts) -> Self;
    /// What is wrong, if anything is.
    fn check(&self, place: &Place, counts: &mut Counts) -> Result<(), String>;
    /// A smaller case that fails too.
    fn shrunk(self, fails: &dyn Fn(&Self) -> bool) -> Self;

    /// The same, quietly; a panic is wrong too.
    fn again(&self, place: &Place) -> Result<(), String> {
        caught(|| self.check(place, &mut Counts::default()))
    }
}

/// What was found, as it is written: what is wrong in a line, how to find it again, and the case.
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

    /// What a method does by itself, and every scheduling that it takes; stealing needs SPIR-V.
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

pub fn run(root: &Path, options: &AttackOptions) -> Result<(), String> {
    // What is caught is told with what is found.
    std::panic::set_hook(Box::new(|_| {}));
    if let Some(file) = options.case.as_ref().filter(|case| case.parse::<u64>().is_err()) {
        return replay_file(Path::new(file), None);
    }
    let places = places(options.backend)?;
    if options.case.is_none() {
        replay_folder(&root.join(CASES), &places)?;
    }
    let wanted = |kind| options.kind.is_none_or(|k| k == kind);
    let n = [boxes::Case::KIND, queries::Case::KIND, sessions::Case::KIND];
    let n = n.into_iter().filter(|&kind| wanted(kind)).count() as f64;
    let share = Duration::try_from_secs_f64(options.minutes * 60.0 / n)
        .map_err(|e| format!("--minutes {}: {e}", options.minutes))?;
    let found = [
        search::<boxes::Case>(options, &places, share)?,
        search::<queries::Case>(options, &places, share)?,
        search::<sessions::Case>(options, &places, share)?,
    ];
    let found: Vec<String> = found.into_iter().flatten().collect();
    if found.is_empty() { Ok(()) } else { Err(found.join("\n")) }
}

/// The CPU, or a device of each path with and without `f64`.
fn places(backend: AttackedBackend) -> Result<Vec<Place>, String> {
    if backend == AttackedBackend::Cpu {
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

/// Cases of one kind until its time is over; returns what was found.
fn search<C: Case>(
    options: &AttackOptions,
    places: &[Place],
    share: Duration,
) -> Result<Option<String>, String> {
    if options.kind.is_some_and(|kind| kind != C::KIND) {
        return Ok(None);
    }
    let (name, seed) = (C::NAME, options.seed);
    let (start, mut told) = (Instant::now(), Instant::now());
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
        if only.is_some() || start.elapsed() >= share {
            break None;
        }
        if told.elapsed().as_secs() >= 10 && std::io::stdout().is_terminal() {
            print!("\r{name}: case {number}, {} s", start.elapsed().as_secs());
            let _ = std::io::stdout().flush();
            told = Instant::now();
        }
    };
    println!("{name}: {counts}, in {:.1} s", start.elapsed().as_secs_f64());
    let Some((place, case, what)) = found else { return Ok(None) };
    let case = case.shrunk(&|case| case.again(place).is_err());
    let what = case.again(place).err().unwrap_or(what);
    let what = format!("{name}, {}: {what}", place.name);
    let backend = place.backend();
    let again = format!(
        "cargo xtask attack --backend {backend} --kind {name} --seed {seed} --case {number}"
    );
    let path = options.out.join(format!("{backend}_{name}_{seed}_{number}.json"));
    let told = format!("{what}\nagain: {again}\nwritten to {}", path.display());
    let found = Found { what, again, kind: name.into(), backend: backend.into(), case };
    let text = serde_json::to_string_pretty(&found).map_err(|e| e.to_string())?;
    std::fs::create_dir_all(&options.out)
        .and_then(|()| std::fs::write(&path, text + "\n"))
        .map_err(|e| format!("{}: {e}\n{told}", path.display()))?;
    Ok(Some(told))
}

/// Every case of a folder that is of the backend of these places; outside of a checkout there are
/// none.
fn replay_folder(folder: &Path, places: &[Place]) -> Result<(), String> {
    let Ok(files) = std::fs::read_dir(folder) else { return Ok(()) };
    let mut files: Vec<_> = files.flatten().map(|file| file.path()).collect();
    files.sort();
    files.iter().try_for_each(|file| replay_file(file, Some(places)))
}

/// The case of a file at every place of its backend.
fn replay_file(path: &Path, places: Option<&[Place]>) -> Result<(), String> {
    let failed = |e: String| format!("{}: {e}", path.display());
    let text = std::fs::read(path).map_err(|e| failed(e.to_string()))?;
    let found: Found<serde_json::Value> =
        serde_json::from_slice(&text).map_err(|e| failed(e.to_string()))?;
    let opened = match (places, found.backend.as_str()) {
        (Some(_), _) => Vec::new(),
        (None, "gpu") => self::places(AttackedBackend::Gpu)?,
        (None, _) => self::places(AttackedBackend::Cpu)?,
    };
    for place in places.unwrap_or(&opened).iter().filter(|p| p.backend() == found.backend) {
        match found.kind.as_str() {
            boxes::Case::NAME => replay::<boxes::Case>(&found.case, place),
            queries::Case::NAME => replay::<queries::Case>(&found.case, place),
            sessions::Case::NAME => replay::<sessions::Case>(&found.case, place),
            other => Err(format!("no kind of cases is `{other}`")),
        }
        .map_err(|e| failed(format!("{}: {e}", place.name)))?;
        println!("{}, {}: as it should be", path.display(), place.name);
    }
    Ok(())
}

fn replay<C: Case>(case: &serde_json::Value, place: &Place) -> Result<(), String> {
    C::deserialize(case).map_err(|e| e.to_string())?.again(place)
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

#[cfg(test)]
mod tests {
    use super::*;

    fn cpu() -> Vec<Place> {
        places(AttackedBackend::Cpu).unwrap()
    }

    #[test]
    fn what_was_found_once_is_right_now() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(CASES);
        assert!(std::fs::read_dir(&folder).unwrap().count() > 2);
        replay_folder(&folder, &cpu()).unwrap();
    }

    /// A query that is said to meet nothing fails, alone and in a session, shrinks to itself, and
    /// fails again as data.
    #[test]
    fn a_wrong_answer_is_found() {
        let place = &cpu()[0];
        let made = |n| queries::Case::make(place, n, Random::new(n), &mut Counts::default());
        let cases = (0..64).map(made).filter_map(queries::Case::with_a_lie);
        let found: Vec<_> = cases.filter(|case| case.again(place).is_err()).take(8).collect();
        assert_eq!(found.len(), 8);
        for case in found {
            let few = case.shrunk(&|case| case.again(place).is_err());
            assert_eq!(few.n_queries(), 1);
            let data = serde_json::to_value(&few).unwrap();
            replay::<queries::Case>(&data, place).unwrap_err();
        }
    }
}
