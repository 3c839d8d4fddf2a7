//! The conformance table: every method on every backend finds the same pairs in every scene, and
//! every session the same contacts.
//!
//! A row is a test, `pairs/SCENE/METHOD/BACKEND` or `contacts/SCENE/BACKEND`. Small scenes are
//! compared with brute force; large ones by digests, with what one thread of the CPU lists, with
//! the recorded contacts, and with published answers where there are some. Each comparison is made
//! again with answers that are wrong on purpose, and must fail.
//!
//! Schedulers and fronts have rows `.../METHOD/SCHEDULER/BACKEND`, fronts over many frames
//! `frames/SCENE/cpu`. What is right of a generated scene is a snapshot, `recorded/SCENE`. A scene
//! in all units has rows `units/BACKEND`.
//!
//! Rows of real scenes are ignored without the data, rows of a GPU without one (with
//! `CCD_GPU=require` they fail), and steps of the largest scenes on a GPU that is emulated, where
//! they take minutes, but for those by default on the native path (without `CCD_WHOLE=1` that of
//! cloth-ball alone): reported with the reason, and counted. What is left out by default a row
//! says, too.

mod rows;
mod scenes;
mod sequences;
mod units;

use ccd::any::{BroadPhase, Choice, Error, Session};
use ccd::gpu::{self, Device, DeviceOptions};
use ccd::method::{BroadPhaseMethod, Builder, Catalogued, Scheduling};
use ccd::scenes::{Step, triangle_soup};
use ccd::{Aabb, Contact, Digest, Mesh, Mode, Options, Pair, State};
use ccd_testkit::compare::{self, agree, contact_digest, step_text};
use ccd_testkit::{WHOLE, data, is_whole};
use libtest_mimic::{Arguments, Completion, Failed, Trial};
use rows::{WGSL, is_emulated, methods, not_too_slow, pipelines, schedulings};
use scenes::{GENERATED, Loaded, Motion, Source, Want, load_boxes, load_motion};
use std::sync::Arc;

fn main() {
    let paths = [("gpu-passthrough", gpu::Path::Passthrough), (WGSL, gpu::Path::Wgsl)];
    let places: Vec<(&str, &str, Result<Choice, Missing>)> =
        std::iter::once(("cpu", "cpu", Ok(Choice::default())))
            .chain(paths.map(|(name, path)| {
                (name, "gpu", open(path).map(|d| Choice::of_device(&d, false)))
            }))
            .collect();
    let real = data::SCENES.iter().map(|scene| (scene.name, Source::Real(scene)));
    let mut trials = Vec::new();
    for (scene, source) in GENERATED.into_iter().chain(real) {
        let loaded = Arc::new(Loaded::default());
        if !matches!(source, Source::Real(_)) {
            let (loaded, name) = (loaded.clone(), format!("recorded/{scene}"));
            trials.push(Trial::test(name, move || {
                insta::assert_snapshot!(scene, recorded(&loaded, source));
                Ok(())
            }));
        }
        for (place, backend, choice) in &places {
            let emulated = choice.as_ref().is_ok_and(is_emulated);
            let methods = methods(source, backend, place, emulated);
            let left_out = ccd::method::every(backend).count() - methods.len();
            if left_out > 0 {
                let why = format!("{left_out} more methods: {WHOLE}=1");
                let name = format!("whole/{scene}/{place}");
                let ignored = move || Ok(Completion::ignored_with(why));
                trials.push(Trial::ignorable_test(name, ignored));
            }
            let base = Options::default().with_threads(2);
            let of = |method| base.clone().with_broad_phase(method);
            let by_itself = methods.iter().map(|&m| (m.to_string(), of(m)));
            let all = schedulings(scene, source, backend, place, emulated);
            let scheduled = all.map(|(m, s)| (format!("{m}/{s}"), of(m).with_scheduling(s)));
            let piped = pipelines(source, backend).into_iter().map(|(p, s)| {
                let name = if s == Scheduling::default() { String::new() } else { format!("/{s}") };
                let options = base.clone().with_pipeline(p).with_scheduling(s);
                let plain = if p.repeats_tests() { "-plain" } else { "" };
                (format!("{}{plain}{name}", p.row().name), options)
            });
            let fast = choice.clone().and_then(|c| not_too_slow(c, source));
            for (way, options) in by_itself.chain(scheduled).chain(piped) {
                if options.pipeline == base.pipeline {
                    let (loaded, options) = (loaded.clone(), options.clone());
                    // Its step has the same pairs, and takes as long again.
                    let choice = if emulated { &fast } else { choice };
                    let name = format!("pairs/{scene}/{way}/{place}");
                    trials.push(row_of(name, source, choice, move |choice| {
                        check_pairs(&loaded, source, choice, &options)
                    }));
                }
                if !matches!(source, Source::Boxes(_)) {
                    let (loaded, name) =
                        (loaded.clone(), format!("contacts/{scene}/{way}/{place}"));
                    let is_shown = is_whole() || scene == "cloth-ball";
                    let is_default = options == base && *place != WGSL && is_shown;
                    let choice = if is_default { choice } else { &fast };
                    trials.push(row_of(name, source, choice, move |choice| {
                        check_contacts(&loaded, source, choice, options)
                    }));
                }
            }
        }
    }
    for (name, needs_data, frames) in sequences::SEQUENCES {
        let check = move || match data::data_dir() {
            Err(why) if needs_data => Ok(Completion::ignored_with(why)),
            _ => Ok(sequences::check(&frames()).map(|()| Completion::Completed)?),
        };
        trials.push(Trial::ignorable_test(format!("frames/{name}/cpu"), check));
    }
    for (place, _, choice) in &places {
        let units = |choice: &Choice| units::check(choice).map(|()| Completion::Completed);
        trials.push(row_of(format!("units/{place}"), GENERATED[0].1, choice, units));
    }
    // A device of its own, which this row loses.
    let own = open(gpu::Path::Wgsl).map(|device| Choice::of_device(&device, true));
    let lost = |choice: &Choice| check_lost(choice).map(|()| Completion::Completed);
    trials.push(row_of("lost".into(), GENERATED[0].1, &own, lost));
    let mut arguments = Arguments::from_args();
    // A software adapter uses all cores by itself, but not between its calls.
    arguments.test_threads.get_or_insert(2);
    libtest_mimic::run(&arguments, trials).exit();
}

/// What a row lacks.
#[derive(Clone)]
enum Missing {
    /// A device, and why.
    Device(String),
    /// Minutes.
    Time,
}

fn open(path: gpu::Path) -> Result<Device, Missing> {
    // The most native device, and the most portable.
    let narrow = path == gpu::Path::Wgsl;
    let options = DeviceOptions { path: Some(path), narrow, ..Default::default() };
    Device::open(&options).map_err(|e| Missing::Device(e.to_string()))
}

/// A row, or why it is ignored.
fn row_of(
    name: String,
    source: Source,
    choice: &Result<Choice, Missing>,
    check: impl FnOnce(&Choice) -> Result<Completion, String> + Send + 'static,
) -> Trial {
    let choice = choice.clone();
    Trial::ignorable_test(name, move || {
        if let (Source::Real(_), Err(why)) = (source, data::data_dir()) {
            return Ok(Completion::ignored_with(why));
        }
        match choice {
            Ok(choice) => check(&choice).map_err(Failed::from),
            Err(Missing::Device(why)) if std::env::var("CCD_GPU").is_ok_and(|v| v == "require") => {
                Err(Failed::from(format!("CCD_GPU=require, but there is no device: {why}")))
            }
            Err(Missing::Device(why)) => Ok(Completion::ignored_with(why)),
            Err(Missing::Time) => Ok(Completion::ignored_with("too slow on an emulated GPU")),
        }
    })
}

/// Counts and digests that every method of every backend is compared with.
fn recorded(loaded: &Loaded, source: Source) -> String {
    let [within, between] = loaded.boxes.get_or_init(|| load_boxes(source)).want;
    let pairs = format!("pairs within one set {within}, between two {between}\n");
    if matches!(source, Source::Boxes(_)) {
        return pairs;
    }
    let motion = loaded.motion.get_or_init(|| load_motion(source));
    let Want::Reference([vf, ee], contacts) = &motion.want else { return pairs };
    let toi = contacts.iter().map(|c| c.toi).reduce(f64::min);
    let contacts = contact_digest(contacts);
    format!("{pairs}candidates vf {vf} ee {ee}\ncontacts {contacts}, earliest {toi:?}\n")
}

fn check_pairs(
    loaded: &Loaded,
    source: Source,
    choice: &Choice,
    options: &Options,
) -> Result<Completion, String> {
    let boxes = loaded.boxes.get_or_init(|| load_boxes(source));
    let (method, scheduling) = (options.broad_phase, options.scheduling);
    let mut broad =
        BroadPhase::scheduled(choice, 2, method, scheduling).map_err(|e| e.to_string())?;
    let answer = broad.self_pairs(&boxes.within).map(|pairs| pairs.into_vec());
    let within = taken(method, boxes.within.len(), answer)?;
    if let Ok(within) = &within {
        same_pairs("within one set", &boxes.want[0], within)?;
    }
    let [a, b] = &boxes.between;
    let answer = broad.pairs(a, b).map(|pairs| pairs.into_vec());
    let between = taken(method, a.len().max(b.len()), answer)?;
    if let Ok(between) = &between {
        same_pairs("between two sets", &boxes.want[1], between)?;
    }
    let refused = |why| Completion::ignored_with(format!("refused: {why}"));
    Ok(within.and(between).map_or_else(refused, |_| Completion::Completed))
}

/// Pairs, or why they were refused: for nearest pairs above their limit, where they must be. Any
/// other error is one.
fn taken<T>(
    method: BroadPhaseMethod,
    n: usize,
    answer: Result<T, Error>,
) -> Result<Result<T, String>, String> {
    let limit = match method {
        BroadPhaseMethod::Tree(tree) => match tree.builder {
            Builder::NearestPair { limit } => limit as usize,
            _ => usize::MAX,
        },
        _ => usize::MAX,
    };
    match answer {
        Ok(_) if n > limit => Err(format!("{n} boxes were not refused")),
        Ok(found) => Ok(Ok(found)),
        Err(e @ Error::Input(ccd::Error::TooMany { .. })) if n > limit => Ok(Err(e.to_string())),
        Err(e) => Err(e.to_string()),
    }
}

/// The same set, no pair twice; and the same comparison fails for sets that differ in one pair.
fn same_pairs(what: &str, want: &Digest, found: &[Pair]) -> Result<(), String> {
    let is = |found: &mut dyn Iterator<Item = Pair>| Digest::of(0, found) == *want;
    let of = || found.iter().copied();
    if !is(&mut of()) {
        return Err(format!("{what}: {}, right is {want}", Digest::of(0, of())));
    }
    let more = Pair { a: 7, b: 11 };
    let mut wrong: Vec<(&str, Box<dyn Iterator<Item = Pair> + '_>)> =
        vec![("a pair more", Box::new(of().chain([more])))];
    if let Some(&first) = found.first() {
        let other = Pair { a: first.a, b: first.b + 1 };
        wrong.push(("a pair less", Box::new(of().skip(1))));
        wrong.push(("a pair twice", Box::new(of().chain([first]))));
        wrong.push(("another pair", Box::new(of().skip(1).chain([other]))));
    }
    match wrong.iter_mut().find_map(|(name, pairs)| is(pairs).then_some(*name)) {
        Some(name) => Err(format!("{what}: the comparison does not see {name}")),
        None => Ok(()),
    }
}

fn check_contacts(
    loaded: &Loaded,
    source: Source,
    choice: &Choice,
    options: Options,
) -> Result<Completion, String> {
    let Motion { step, want } = loaded.motion.get_or_init(|| load_motion(source));
    let Step { mesh, x0, x1 } = step;
    let (method, n) = (options.broad_phase, mesh.edges().len().max(mesh.n_vertices()));
    let refused = |why| Completion::ignored_with(format!("refused: {why}"));
    let mut session = match Session::new(choice, mesh.clone(), options) {
        Ok(session) => session,
        // A GPU refuses when it makes room.
        Err(e) => {
            let answer = taken(method, n, Err::<(), _>(e))?;
            return Ok(answer.map_or_else(refused, |()| Completion::Completed));
        }
    };
    let answer = session.step(x0, x1).cloned();
    let report = match taken(method, n, answer)? {
        Ok(report) => report,
        Err(why) => return Ok(refused(why)),
    };
    match want {
        Want::Recorded(text, by_mode, truth) => {
            let contacts = of_place(by_mode, choice);
            // Every true collision is found, never late, at most the tolerance early, and no other.
            if let Some([vf, ee]) = truth
                && compare::contacts(&report, vf, ee) > 0
            {
                return Err("contacts that are none".into());
            }
            agree(contacts, &report.contacts)?;
            check_controls(contacts)?;
            let found = step_text(&report);
            // Rounding is the same where nothing is contracted and `f64` is on one of both alone.
            let native = |device: &Device| {
                device.info().path == gpu::Path::Passthrough && device.info().wide
            };
            if choice.device().is_none_or(native) && report.contacts != contacts {
                return Err("contacts differ in a bit from those of a CPU".into());
            }
            if found != *text {
                return Err(format!("{found}recorded is\n{text}"));
            }
            let mut wrong = report.clone();
            wrong.contacts[0].b ^= 1;
            if step_text(&wrong) == *text {
                return Err("the comparison does not see another contact".into());
            }
        }
        Want::Reference(candidates, contacts) => {
            agree(contacts, &report.contacts)?;
            check_controls(contacts)?;
            let found = session.candidates(x0, x1).map_err(|e| e.to_string())?;
            for (want, found) in candidates.iter().zip([found.vf, found.ee]) {
                same_pairs("candidates", want, &found.into_vec())?;
            }
        }
    }
    if report.undecided > 0 {
        return Err(format!("{} contacts are undecided", report.undecided));
    }
    // Of a real scene by the CPU, not by the report that is looked at.
    let toi = match want {
        Want::Recorded(_, by_mode, _) => {
            of_place(by_mode, choice).iter().map(|c| c.toi).min_by(f64::total_cmp)
        }
        Want::Reference(..) => report.toi,
    };
    check_earliest(&mut session, mesh, x0, x1, toi)?;
    Ok(Completion::Completed)
}

/// By default times are exact on a CPU, and conservative on a GPU.
fn of_place<'a>([exact, conservative]: &'a [Vec<Contact>; 2], choice: &Choice) -> &'a [Contact] {
    if choice.device().is_some() { conservative } else { exact }
}

/// What `agree` must refuse.
fn check_controls(contacts: &[Contact]) -> Result<(), String> {
    let certain =
        contacts.iter().position(|c| c.state == State::Hit).ok_or("no certain contact")?;
    let wrong = |change: &dyn Fn(&mut Vec<Contact>)| {
        let mut found = contacts.to_vec();
        change(&mut found);
        agree(contacts, &found).is_err()
    };
    let seen = [
        wrong(&|c| _ = c.remove(certain)),
        wrong(&|c| c.insert(certain, c[certain])),
        wrong(&|c| c[certain].toi += 1e-5),
        wrong(&|c| c[certain].b = u32::MAX),
        wrong(&|c| c.swap(0, 1)),
    ];
    if seen.contains(&false) || wrong(&|_| {}) {
        Err(format!("controls: {seen:?}"))
    } else {
        Ok(())
    }
}

/// On a GPU the earliest time is rounded down to an `f32`.
fn check_earliest(
    session: &mut Session,
    mesh: &Mesh,
    x0: &[[f64; 3]],
    x1: &[[f64; 3]],
    want: Option<f64>,
) -> Result<(), String> {
    let slack = if session.place().backend() == "cpu" { 0.0 } else { 1e-6 };
    let fits = |found: Option<f64>| match (want, found) {
        (Some(want), Some(found)) => found <= want && found >= want - slack - 0.1 * slack * want,
        _ => want == found,
    };
    let found = session.earliest_toi(x0, x1).map_err(|e| e.to_string())?;
    let controls = [None, want.map(|t| t + 1e-9), want.map(|t| t - 2e-6)];
    if !fits(found) || (want.is_some() && controls.into_iter().any(fits)) {
        return Err(format!(
            "earliest {found:?}, of all contacts {want:?}, {} edges",
            mesh.edges().len()
        ));
    }
    Ok(())
}

/// A choice that was free goes on with the CPU when its device is lost; one that was not fails.
fn check_lost(free: &Choice) -> Result<(), String> {
    let device = free.device().ok_or("no device")?.clone();
    let step = triangle_soup(40, 0.3, 2);
    let options = Options::default().with_mode(Mode::Conservative);
    let want =
        ccd::step(&step.mesh, &step.x0, &step.x1, &options).map_err(|e| e.to_string())?.contacts;
    let session = |choice: &Choice| {
        Session::new(choice, step.mesh.clone(), Options::default()).map_err(|e| e.to_string())
    };
    let (mut kept, mut lost) = (session(free)?, session(&free.clone().fixed())?);
    let mut broad =
        BroadPhase::new(free, 1, BroadPhaseMethod::Blocks).map_err(|e| e.to_string())?;
    let (x0, x1) = (&step.x0[..], &step.x1[..]);
    agree(&want, &kept.step(x0, x1).map_err(|e| e.to_string())?.contacts)?;
    // Bad input is that on either, and no reason to leave the GPU.
    let refused = kept.step(&x0[1..], x1).map(|_| ());
    let stays = matches!(refused, Err(gpu::Error::Input(_))) && kept.place().backend() == "gpu";

    device.wgpu().destroy();
    let goes_on = kept.step(x0, x1).map_err(|e| e.to_string())?.contacts == want;
    let fails = lost.step(x0, x1).is_err_and(|e| !matches!(e, gpu::Error::Input(_)));
    let overlapping = [Aabb { min: [0.0; 3], max: [1.0; 3] }; 2];
    let n = broad.self_pairs(&overlapping).map_err(|e| e.to_string())?.len();
    let places = [kept.place().backend(), broad.place().backend(), lost.place().backend()];
    match (stays, goes_on, fails, n, places) {
        (true, true, true, 1, ["cpu", "cpu", "gpu"]) => Ok(()),
        other => Err(format!("stays, goes on, fails, pairs, places: {other:?}")),
    }
}
