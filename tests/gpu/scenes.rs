//! Whole steps on a device, against the CPU and against exact answers: scenes that are read, scenes
//! that are made.

use ccd::gpu::{Device, Path as ShaderPath, Session};
use ccd::{Bodies, Contact, Kind, Options, Pair, Report, State};
use ccd_testkit::data::{SCENES, Scene};
use ccd_testkit::{compare, generate, oracle};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// What is done on a device.
pub type Test = Box<dyn FnOnce(&Device) + Send>;
/// A test, or why it cannot run here.
pub type Runnable = Result<Test, String>;

/// Tests of generated scenes.
pub const TESTS: crate::Tests = &[
    ("bodies", check_bodies),
    ("min_distance", check_min_distance),
    ("degenerate", check_degenerate),
    ("sequence", check_sequence),
    ("many_contacts", check_many_contacts),
];

/// Names and tests of scenes in a folder, which may not be there.
pub fn tests_of_data(dir: &Result<PathBuf, String>) -> Vec<(String, Runnable)> {
    let mut out: Vec<(String, Runnable)> = Vec::new();
    for scene in &SCENES {
        let test = dir
            .clone()
            .map(|dir| -> Test { Box::new(move |device| check_scene(device, scene, &dir)) });
        out.push((format!("scene_{}", scene.name), test));
    }
    out
}

/// Certified answers of two backends never contradict each other; times differ by rounding alone.
pub fn check_reports(cpu: &Report, gpu: &Report, same_arithmetic: bool) {
    assert_eq!(gpu.candidates, cpu.candidates, "candidates");
    assert_eq!(gpu.triangles, cpu.triangles, "pairs of triangles");
    if same_arithmetic {
        assert_eq!(gpu.contacts, cpu.contacts);
        assert_eq!(gpu.toi, cpu.toi);
        return;
    }
    let key = |c: &Contact| (c.kind, c.a, c.b);
    let of = |r: &Report, certain: bool| {
        r.contacts
            .iter()
            .filter(|c| !certain || c.state == State::Hit)
            .map(key)
            .collect::<BTreeSet<_>>()
    };
    assert!(
        of(gpu, false).is_superset(&of(cpu, true)),
        "a certain contact of the CPU is missing on the GPU"
    );
    assert!(
        of(cpu, false).is_superset(&of(gpu, true)),
        "a certain contact of the GPU is none on the CPU"
    );
    assert!(gpu.contacts.windows(2).all(|w| key(&w[0]) < key(&w[1])), "contacts are not in order");
    for g in &gpu.contacts {
        if let Ok(i) = cpu.contacts.binary_search_by_key(&key(g), key) {
            let c = &cpu.contacts[i];
            assert!(
                (g.toi - c.toi).abs() <= 2e-6
                    || g.state == State::Undecided
                    || c.state == State::Undecided,
                "{g:?} {c:?}"
            );
        }
    }
}

fn check_scene(device: &Device, scene: &Scene, dir: &Path) {
    let [t0, t1] = scene.load(dir);
    let mesh = t0.mesh().unwrap();
    let (x0, x1) = (&t0.positions, &t1.positions);
    let cpu = ccd::step(&mesh, x0, x1, &Options::default()).unwrap();
    let mut session = Session::new(device, mesh.clone(), Options::default()).unwrap();
    let gpu = session.step(x0, x1).unwrap().clone();
    // Where contraction is forbidden and f64 is on the device or on the CPU alone, even rounding is
    // the same.
    let same = device.info().path == ShaderPath::Passthrough && device.info().wide;
    check_reports(&cpu, &gpu, same);
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.bind(|| {
        insta::assert_snapshot!(format!("truth__step_{}", scene.name), compare::step_text(&gpu))
    });
    if scene.truth.is_some() {
        let n_false =
            compare::contacts(&gpu, &scene.contacts(dir, "vf"), &scene.contacts(dir, "ee"));
        println!(
            "{}: {} contacts, {} undecided, {n_false} false alarms; filtered {:?}",
            scene.name,
            gpu.contacts.len(),
            gpu.undecided,
            gpu.filtered
        );
    }
    check_earliest(&mut session, x0, x1, cpu.toi);
    // The sets themselves, not only their number.
    let found = session.candidates(x0, x1).unwrap();
    let mut cpu_session = ccd::Session::new(mesh, Options::default()).unwrap();
    let want = cpu_session.candidates(x0, x1).unwrap();
    for (kind, want, got) in [("vf", want.vf, found.vf), ("ee", want.ee, found.ee)] {
        check_pairs(&format!("{} {kind}", scene.name), want.to_vec(), got);
    }
}

fn check_earliest(session: &mut Session, x0: &[[f64; 3]], x1: &[[f64; 3]], want: Option<f64>) {
    let got = session.earliest_toi(x0, x1).unwrap();
    match (want, got) {
        (Some(want), Some(got)) => {
            assert!(
                got <= want && got >= want - 1e-6 - 1e-7 * want,
                "earliest {got:e}, on the CPU {want:e}"
            );
        }
        _ => assert_eq!(got, want, "earliest"),
    }
}

/// The same set, no pair twice.
pub fn check_pairs(what: &str, mut want: Vec<Pair>, mut got: Vec<Pair>) {
    want.sort_unstable();
    got.sort_unstable();
    assert!(got.windows(2).all(|w| w[0] != w[1]), "{what}: a pair comes twice");
    assert_eq!(got.len(), want.len(), "{what}: number of pairs");
    assert!(got == want, "{what}: other pairs");
}

/// Bodies, fixed ones among them, on the device as on the CPU.
fn check_bodies(device: &Device) {
    let step = generate::triangle_soup(300, 0.2, 5);
    let body: Vec<u32> = (0..step.mesh.n_vertices() as u32).map(|v| v / 3 % 7).collect();
    // Names that differ in their highest bit alone.
    let far: Vec<u32> = body.iter().map(|b| (b / 2) | ((b % 2) << 31)).collect();
    check_step(device, &step, Options::default().with_bodies(Bodies::new(&far, &[], false)));
    for self_contact in [false, true] {
        let bodies =
            Some(Bodies::new(&body, &[true, false, true], self_contact).with_fixed_motion(true));
        check_step(device, &step, Options::default().with_bodies(bodies));
    }
}

/// Contact at a distance, in f64 and in f32.
fn check_min_distance(device: &Device) {
    check_step(
        device,
        &generate::crumpled_sheet(24, 3),
        Options::default().with_min_distance(0.01),
    );
    check_step(
        device,
        &generate::triangle_soup(200, 0.1, 9),
        Options::default().with_min_distance(0.003),
    );
}

pub fn check_step(device: &Device, step: &generate::Step, options: Options) {
    let cpu = ccd::step(&step.mesh, &step.x0, &step.x1, &options).unwrap();
    let mut session = Session::new(device, step.mesh.clone(), options.clone()).unwrap();
    let gpu = session.step(&step.x0, &step.x1).unwrap();
    assert!(!cpu.contacts.is_empty(), "a scene without contact shows nothing");
    check_reports(&cpu, gpu, false);
    check_earliest(&mut session, &step.x0, &step.x1, cpu.toi);
    let single = |x: &[[f64; 3]]| x.iter().map(|p| p.map(|c| c as f32)).collect::<Vec<_>>();
    let (x0, x1) = (single(&step.x0), single(&step.x1));
    let cpu = ccd::step(&step.mesh, &x0, &x1, &options).unwrap();
    check_reports(&cpu, session.step(&x0, &x1).unwrap(), false);
}

/// Triangles with corners on a coarse grid: most pairs touch in corners, move in planes, or are
/// parallel. What the CPU reports and the device does not must be free of contact in exact
/// arithmetic.
fn check_degenerate(device: &Device) {
    let mut random = generate::Random::new(21);
    for unit in [0.25, 0.1] {
        let n = 90u32;
        let mut corner = || std::array::from_fn::<f64, 3, _>(|_| random.below(5) as f64 * unit);
        let x0: Vec<[f64; 3]> = (0..3 * n).map(|_| corner()).collect();
        let x1: Vec<[f64; 3]> =
            x0.iter().map(|p| if p[0] > unit { corner() } else { *p }).collect();
        let faces: Vec<[u32; 3]> = (0..n).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        let mesh = ccd::Mesh::new(3 * n as usize, &faces).unwrap();
        let cpu = ccd::step(&mesh, &x0, &x1, &Options::default()).unwrap();
        let mut session = Session::new(device, mesh.clone(), Options::default()).unwrap();
        let gpu = session.step(&x0, &x1).unwrap();
        assert_eq!(gpu.candidates, cpu.candidates);
        let key = |c: &Contact| (c.kind, c.a, c.b);
        let found: BTreeSet<_> = gpu.contacts.iter().map(key).collect();
        let (mut n_missing, mut n_open) = (0, 0);
        for c in cpu.contacts.iter().filter(|c| !found.contains(&key(c))) {
            let ids = c.vertices(&mesh);
            let (p, q) = (ids.map(|v| x0[v as usize]), ids.map(|v| x1[v as usize]));
            let answer = if c.kind == Kind::VertexFace {
                oracle::vertex_face(&p, &q)
            } else {
                oracle::edge_edge(&p, &q)
            };
            assert!(
                !matches!(answer, oracle::Answer::Contact(..)),
                "missed {c:?}: {answer:?}, {p:?} {q:?}"
            );
            assert_eq!(c.state, State::Undecided);
            n_missing += 1;
            n_open += (answer == oracle::Answer::Degenerate) as usize;
        }
        println!(
            "degenerate, {unit}: {} contacts, {n_missing} only on the CPU, \
             {n_open} of them not decided exactly",
            cpu.contacts.len()
        );
        assert!(cpu.undecided > 100, "nothing degenerate");
    }
}

/// A session over several frames gives what single steps give: nothing is left over from the frame
/// before.
fn check_sequence(device: &Device) {
    let steps: Vec<_> = (0..4).map(|seed| generate::crumpled_sheet(20, seed)).collect();
    let mut session = Session::new(device, steps[0].mesh.clone(), Options::default()).unwrap();
    for step in steps.iter().chain(steps.iter().rev()) {
        let cpu = ccd::step(&step.mesh, &step.x0, &step.x1, &Options::default()).unwrap();
        check_reports(&cpu, session.step(&step.x0, &step.x1).unwrap(), false);
    }
    let still = &steps[0].x0;
    let cpu = ccd::step(&steps[0].mesh, still, still, &Options::default()).unwrap();
    check_reports(&cpu, session.step(still, still).unwrap(), false);
}

/// Contacts that are so many that they are sorted on the device from the second frame on; then
/// fewer, then more than were expected.
fn check_many_contacts(device: &Device) {
    let [many, few] = [120, 20].map(|n| generate::crumpled_sheet(n, 2));
    let mut session = Session::new(device, many.mesh.clone(), Options::default()).unwrap();
    let cpu = ccd::step(&many.mesh, &many.x0, &many.x1, &Options::default()).unwrap();
    assert!(cpu.contacts.len() > 5000, "{} contacts", cpu.contacts.len());
    let same = device.info().path == ShaderPath::Passthrough && device.info().wide;
    let x0 = &many.x0;
    // Half of the sheet stands still.
    let half: Vec<[f64; 3]> =
        (0..x0.len()).map(|i| if i < x0.len() / 2 { many.x1[i] } else { x0[i] }).collect();
    let less = ccd::step(&many.mesh, x0, &half, &Options::default()).unwrap();
    assert!(
        less.contacts.len() > 4096 / 2 && less.contacts.len() * 5 / 4 + 256 < cpu.contacts.len(),
        "{} contacts",
        less.contacts.len()
    );
    for (x1, want) in
        [(&many.x1, &cpu), (&many.x1, &cpu), (&half, &less), (&many.x1, &cpu), (&many.x1, &cpu)]
    {
        check_reports(want, session.step(x0, x1).unwrap(), same);
    }
    let mut session = Session::new(device, few.mesh.clone(), Options::default()).unwrap();
    let cpu = ccd::step(&few.mesh, &few.x0, &few.x1, &Options::default()).unwrap();
    check_reports(&cpu, session.step(&few.x0, &few.x1).unwrap(), same);
}

/// The comparisons fail when they should.
pub fn check_negative_controls() {
    let step = generate::crumpled_sheet(20, 1);
    let cpu = ccd::step(&step.mesh, &step.x0, &step.x1, &Options::default()).unwrap();
    let fails = |change: &dyn Fn(&mut Report), same: bool| {
        let mut gpu = cpu.clone();
        change(&mut gpu);
        compare::fails(std::panic::AssertUnwindSafe(|| check_reports(&cpu, &gpu, same)))
    };
    let certain = cpu.contacts.iter().position(|c| c.state == State::Hit).unwrap();
    assert!(!fails(&|_| {}, true) && !fails(&|_| {}, false));
    assert!(
        fails(&|r| r.contacts.retain(|c| *c != cpu.contacts[certain]), false),
        "a missing contact passes"
    );
    assert!(fails(&|r| r.contacts[certain].toi += 1e-3, false), "a late contact passes");
    assert!(
        fails(&|r| r.contacts[certain].toi += 1e-15, true),
        "another rounding passes as the same"
    );
    assert!(fails(&|r| r.candidates.ee += 1, false), "another number of candidates passes");
    let extra = Contact::new(Kind::VertexFace, State::Hit, 0, 0, 0.5);
    assert!(
        fails(&|r| r.contacts.insert(0, extra), false),
        "a certain contact that is none passes"
    );
    let pairs = vec![Pair { a: 1, b: 2 }, Pair { a: 3, b: 4 }];
    let other = |pairs: Vec<Pair>| {
        compare::fails(|| {
            check_pairs("control", vec![Pair { a: 1, b: 2 }, Pair { a: 3, b: 4 }], pairs)
        })
    };
    assert!(
        !other(pairs.clone())
            && other(pairs[..1].to_vec())
            && other(vec![pairs[0], pairs[0]])
            && other(vec![pairs[0], Pair { a: 3, b: 5 }])
    );
}
