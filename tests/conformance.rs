//! The conformance table: every method on every backend finds the same pairs in every scene, and
//! every session the same contacts.
//!
//! A row is a test, `pairs/SCENE/METHOD/BACKEND` or `contacts/SCENE/BACKEND`. Small scenes are
//! compared with brute force; large ones by digests, with what one thread of the CPU lists and
//! with the recorded contacts, which `truth.rs` compares with published answers. Each comparison
//! is made again with answers that are wrong on purpose, and must fail.
//!
//! Rows of real scenes are ignored without the data, rows of a GPU without one (with
//! `CCD_GPU=require` they fail), and steps of the largest scenes on a GPU that is emulated, where
//! they take minutes and `tests/gpu` makes them: reported with the reason, and counted. So are
//! rows of scenes that the uniform grid refuses, which must be for the crowding of its cells.

use ccd::any::{BroadPhase, Choice, Error, Session};
use ccd::gpu::{self, Device, DeviceOptions};
use ccd::scenes::{Random, Step, crumpled_sheet, debris_boxes, triangle_soup, uniform_boxes};
use ccd::{
    Aabb, BroadPhaseMethod, Builder, Catalogued, Contact, Digest, Mesh, Options, Pair, Pipeline,
    State,
};
use ccd_testkit::compare::{agree, recorded_step, step_text};
use ccd_testkit::{brute, data};
use libtest_mimic::{Arguments, Completion, Failed, Trial};
use std::sync::{Arc, OnceLock};

/// Boxes within which pairs are looked for, and two sets between which they are.
struct Boxes {
    within: Vec<Aabb<f32>>,
    between: [Vec<Aabb<f32>>; 2],
    /// What is right of both.
    want: [Digest; 2],
}

/// A step and what is right of it.
struct Motion {
    step: Step,
    want: Want,
    /// Contacts may end undecided so often.
    undecided: u64,
}

enum Want {
    /// Of brute force: candidates, and every contact asked for by itself.
    Brute([Digest; 2], Vec<Contact>),
    /// What is recorded of a real scene, and the contacts that one thread of the CPU finds.
    Recorded(String, Vec<Contact>),
}

/// What is loaded once for all rows of a scene.
#[derive(Default)]
struct Loaded {
    boxes: OnceLock<Boxes>,
    motion: OnceLock<Motion>,
}

/// Where a scene comes from.
#[derive(Clone, Copy)]
enum Source {
    Boxes(fn() -> Vec<Aabb<f32>>),
    Step(fn() -> Step),
    Real(&'static data::Scene),
}

const GENERATED: [(&str, Source); 9] = [
    ("uniform", Source::Boxes(|| uniform_boxes(20_000))),
    ("debris", Source::Boxes(debris_boxes)),
    ("crowded", Source::Boxes(|| inflated(&uniform_boxes(2000), 0.05))),
    ("equal", Source::Boxes(|| vec![Aabb { min: [0.5; 3], max: [0.5; 3] }; 300])),
    ("huge", Source::Boxes(huge)),
    ("one", Source::Boxes(|| uniform_boxes(1))),
    ("none", Source::Boxes(Vec::new)),
    ("sheet", Source::Step(|| crumpled_sheet(24, 1))),
    ("soup", Source::Step(|| triangle_soup(300, 0.15, 2))),
];

fn inflated(boxes: &[Aabb<f32>], by: f32) -> Vec<Aabb<f32>> {
    let grown = |b: &Aabb<f32>| Aabb { min: b.min.map(|c| c - by), max: b.max.map(|c| c + by) };
    boxes.iter().map(grown).collect()
}

/// Boxes whose extent is near the greatest `f32`.
fn huge() -> Vec<Aabb<f32>> {
    let mut random = Random::new(3);
    let mut make = || {
        let p = random.point().map(|c| (c as f32 - 0.5) * 3.4e38);
        Aabb { min: p, max: p.map(|c| c + 4e37) }
    };
    (0..200).map(|_| make()).collect()
}

fn main() {
    let paths = [("gpu-passthrough", gpu::Path::Passthrough), ("gpu-wgsl", gpu::Path::Wgsl)];
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
        for (place, backend, choice) in &places {
            for method in ccd::every(backend) {
                let choice = &choice.clone().and_then(|c| on_request(c, source, method));
                let (loaded, name) = (loaded.clone(), format!("pairs/{scene}/{method}/{place}"));
                trials.push(row_of(name, source, choice, move |choice| {
                    check_pairs(&loaded, source, choice, method)
                }));
            }
            for method in ccd::every(backend).filter(|_| !matches!(source, Source::Boxes(_))) {
                let choice = &choice
                    .clone()
                    .and_then(|c| not_too_slow(c, source))
                    .and_then(|c| on_request(c, source, method));
                let (loaded, name) = (loaded.clone(), format!("contacts/{scene}/{method}/{place}"));
                let options = Options { threads: 2, broad_phase: method, ..Options::default() };
                trials.push(row_of(name, source, choice, move |choice| {
                    check_contacts(&loaded, source, choice, options)
                }));
            }
            for pipeline in pipelines(source, backend) {
                let (loaded, name) = (loaded.clone(), format!("contacts/{scene}/{pipeline:?}"));
                let options = Options { threads: 2, pipeline, ..Options::default() };
                trials.push(row_of(name, source, choice, move |choice| {
                    check_contacts(&loaded, source, choice, options)
                }));
            }
        }
    }
    // A device of its own, which this row loses.
    let own = open(gpu::Path::Wgsl).map(|device| Choice::of_device(&device, true));
    let lost = |choice: &Choice| check_lost(choice).map(|()| Completion::Completed);
    trials.push(row_of("lost".into(), GENERATED[0].1, &own, lost));
    let mut arguments = Arguments::from_args();
    // Devices are shared, and a software adapter uses all cores by itself.
    arguments.test_threads.get_or_insert(1);
    libtest_mimic::run(&arguments, trials).exit();
}

/// Ways to pair features, other than by default.
fn pipelines(source: Source, backend: &'static str) -> Vec<Pipeline> {
    let other = |row: &&ccd::Row<Pipeline>| row.value != Pipeline::default();
    let here = |row: &&ccd::Row<Pipeline>| row.backends.contains(&backend);
    match source {
        Source::Boxes(_) => Vec::new(),
        _ => Pipeline::ROWS.iter().filter(other).filter(here).map(|row| row.value).collect(),
    }
}

/// What a row lacks.
#[derive(Clone)]
enum Missing {
    /// A device, and why.
    Device(String),
    /// The wish: [`WHOLE`].
    Request,
    /// Minutes.
    Time,
}

fn open(path: gpu::Path) -> Result<Device, Missing> {
    let options = DeviceOptions { path: Some(path), ..Default::default() };
    Device::open(&options).map_err(|e| Missing::Device(e.to_string()))
}

/// Steps of so many edges are left out where threads of this machine do a GPU's work.
const MAX_EDGES_EMULATED: usize = 50_000;

/// Set to 1, this variable has real scenes run by every method: hours. Without it they run by the
/// default and the default tree.
const WHOLE: &str = "CCD_WHOLE";

fn on_request(choice: Choice, source: Source, method: BroadPhaseMethod) -> Result<Choice, Missing> {
    let usual = [BroadPhaseMethod::default(), BroadPhaseMethod::TREE].contains(&method);
    let whole = std::env::var(WHOLE).is_ok_and(|v| v == "1");
    if whole || usual || !matches!(source, Source::Real(_)) {
        Ok(choice)
    } else {
        Err(Missing::Request)
    }
}

fn not_too_slow(choice: Choice, source: Source) -> Result<Choice, Missing> {
    let kind = choice.device().map(|device| device.info().adapter.device_type);
    let emulated = kind == Some(gpu::wgpu::DeviceType::Cpu);
    match source {
        Source::Real(scene) if emulated && scene.size[1] > MAX_EDGES_EMULATED => Err(Missing::Time),
        _ => Ok(choice),
    }
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
            Err(Missing::Request) => {
                Ok(Completion::ignored_with(format!("real scenes by every method: {WHOLE}=1")))
            }
            Err(Missing::Time) => Ok(Completion::ignored_with("too slow on an emulated GPU")),
        }
    })
}

fn check_pairs(
    loaded: &Loaded,
    source: Source,
    choice: &Choice,
    method: BroadPhaseMethod,
) -> Result<Completion, String> {
    let boxes = loaded.boxes.get_or_init(|| load_boxes(source));
    let mut broad = BroadPhase::new(choice, 2, method).map_err(|e| e.to_string())?;
    let answer = broad.self_pairs(&boxes.within).map(|pairs| pairs.into_vec());
    let within = taken(source, method, boxes.within.len(), answer)?;
    if let Ok(within) = &within {
        same_pairs("within one set", &boxes.want[0], within)?;
    }
    let [a, b] = &boxes.between;
    let answer = broad.pairs(a, b).map(|pairs| pairs.into_vec());
    let between = taken(source, method, a.len().max(b.len()), answer)?;
    if let Ok(between) = &between {
        same_pairs("between two sets", &boxes.want[1], between)?;
    }
    let refused = |why| Completion::ignored_with(format!("refused: {why}"));
    Ok(within.and(between).map_or_else(refused, |_| Completion::Completed))
}

/// Pairs, or why they were refused: for nearest pairs above their limit, where they must be, and for
/// real scenes whose sizes are so unequal that the cells of a grid are crowded. Any other error is
/// one.
fn taken<T>(
    source: Source,
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
    let may = matches!(source, Source::Real(_)) && method == BroadPhaseMethod::UniformGrid;
    match answer {
        Ok(_) if n > limit => Err(format!("{n} boxes were not refused")),
        Ok(found) => Ok(Ok(found)),
        Err(e @ Error::Input(ccd::Error::TooMany { .. })) if n > limit => Ok(Err(e.to_string())),
        Err(e @ Error::Input(ccd::Error::CrowdedCells { .. })) if may => Ok(Err(e.to_string())),
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

fn load_boxes(source: Source) -> Boxes {
    let (within, between) = match source {
        Source::Boxes(make) => {
            let all = make();
            let (a, b) = all.split_at(all.len() / 3);
            let between = [a.to_vec(), b.to_vec()];
            (all, between)
        }
        Source::Step(make) => {
            let step = make();
            let [x0, x1] = step.rounded();
            let [v, e, f] = brute::swept_boxes(&step.mesh, &x0, &x1);
            (e, [v, f])
        }
        Source::Real(scene) => {
            let step = load_step(scene);
            let boxes = brute::swept_boxes(&step.mesh, &step.x0, &step.x1);
            let [v, e, f] = boxes.map(|set| set.iter().map(|b| b.round_out()).collect());
            (e, [v, f])
        }
    };
    let [a, b] = &between;
    let want = if within.len() <= MAX_BRUTE {
        [brute::self_pairs(&within), brute::pairs(a, b)]
            .map(|pairs| Digest::of(0, pairs.into_iter()))
    } else {
        let mut one = ccd::BroadPhase::new(1, BroadPhaseMethod::Blocks).expect("one thread");
        let within = Digest::of(0, one.self_pairs(&within).expect("valid boxes").iter());
        [within, Digest::of(0, one.pairs(a, b).expect("valid boxes").iter())]
    };
    Boxes { within, between, want }
}

/// So many boxes are still tested each against each: 4e8 tests take half a second.
const MAX_BRUTE: usize = 20_000;

fn load_step(scene: &data::Scene) -> Step {
    let dir = data::data_dir().expect("the row is ignored without the data");
    let [t0, t1] = scene.load(&dir);
    let mesh = t0.mesh().expect("a valid mesh");
    Step { mesh, x0: t0.positions, x1: t1.positions }
}

fn load_motion(source: Source) -> Motion {
    match source {
        Source::Real(scene) => {
            let step = load_step(scene);
            let options = Options { threads: 1, ..Options::default() };
            let one = ccd::step(&step.mesh, &step.x0, &step.x1, &options).expect("a valid step");
            let want = Want::Recorded(recorded_step(scene.name), one.contacts);
            Motion { step, want, undecided: scene.undecided }
        }
        Source::Step(make) => {
            let step = make();
            let candidates = brute::candidates(&step.mesh, &step.x0, &step.x1);
            let contacts = brute::contacts(&step.mesh, &step.x0, &step.x1);
            let digests = candidates.map(|pairs| Digest::of(0, pairs.into_iter()));
            Motion { step, want: Want::Brute(digests, contacts), undecided: 0 }
        }
        Source::Boxes(_) => panic!("boxes do not move"),
    }
}

fn check_contacts(
    loaded: &Loaded,
    source: Source,
    choice: &Choice,
    options: Options,
) -> Result<Completion, String> {
    let Motion { step, want, undecided } = loaded.motion.get_or_init(|| load_motion(source));
    let Step { mesh, x0, x1 } = step;
    let (method, n) = (options.broad_phase, mesh.edges().len().max(mesh.n_vertices()));
    let mut session = Session::new(choice, mesh.clone(), options).map_err(|e| e.to_string())?;
    let answer = session.step(x0, x1).map(|report| report.clone());
    let report = match taken(source, method, n, answer)? {
        Ok(report) => report,
        Err(why) => return Ok(Completion::ignored_with(format!("refused: {why}"))),
    };
    match want {
        Want::Recorded(text, contacts) => {
            agree(contacts, &report.contacts)?;
            check_controls(contacts)?;
            let found = step_text(&report);
            if found != *text {
                return Err(format!("{found}recorded is\n{text}"));
            }
            let mut wrong = report.clone();
            wrong.contacts[0].b ^= 1;
            if step_text(&wrong) == *text {
                return Err("the comparison does not see another contact".into());
            }
        }
        Want::Brute(candidates, contacts) => {
            agree(contacts, &report.contacts)?;
            check_controls(contacts)?;
            let found = session.candidates(x0, x1).map_err(|e| e.to_string())?;
            for (want, found) in candidates.iter().zip([found.vf, found.ee]) {
                same_pairs("candidates", want, &found.into_vec())?;
            }
        }
    }
    if report.undecided > *undecided {
        return Err(format!("{} contacts are undecided, {undecided} may be", report.undecided));
    }
    check_earliest(&mut session, mesh, x0, x1, report.toi)?;
    Ok(Completion::Completed)
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
    let want = ccd::step(&step.mesh, &step.x0, &step.x1, &Options::default())
        .map_err(|e| e.to_string())?
        .contacts;
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
