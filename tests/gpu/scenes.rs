//! Whole steps on a device, against the CPU and against exact answers, of scenes that are made; the
//! conformance table has those that are read.

use ccd::gpu::{Device, Path as ShaderPath, Session};
use ccd::method::BroadPhaseMethod;
use ccd::{Contact, EdgeEdge, Kind, Options, Pair, Report, State, Verdict, VertexFace};
use ccd_testkit::{compare, generate};

/// What is done on a device.
pub type Test = Box<dyn FnOnce(&Device) + Send>;
/// A test, or why it cannot run here.
pub type Runnable = Result<Test, String>;

/// Tests of generated scenes.
pub const TESTS: crate::Tests = &[
    ("degenerate", check_degenerate),
    ("many_contacts", check_many_contacts),
    ("who_decides", check_who_decides),
];

/// Certified answers of two backends never contradict each other; times differ by rounding alone.
pub fn check_reports(cpu: &Report, gpu: &Report, same_arithmetic: bool) {
    assert_eq!(gpu.candidates, cpu.candidates, "candidates");
    // A GPU has oriented boxes of nodes alone.
    let on_gpu = cpu.triangles.map(|mut counts| {
        counts.separated = 0;
        counts
    });
    assert_eq!(gpu.triangles, on_gpu, "pairs of triangles");
    if same_arithmetic {
        assert_eq!(gpu.contacts, cpu.contacts);
        assert_eq!(gpu.toi, cpu.toi);
        return;
    }
    compare::agree(&cpu.contacts, &gpu.contacts).unwrap_or_else(|e| panic!("{e}"));
}

/// The candidates of a session are those of one on the CPU.
pub fn check_candidates(session: &mut Session, x0: &[[f64; 3]], x1: &[[f64; 3]]) {
    let options = on_cpu(session.options());
    let mut cpu = ccd::Session::new(session.mesh().clone(), options).unwrap();
    let (want, found) = (cpu.candidates(x0, x1).unwrap(), session.candidates(x0, x1).unwrap());
    check_pairs("vertices and faces", want.vf.to_vec(), found.vf);
    check_pairs("edges", want.ee.to_vec(), found.ee);
}

/// An earliest time that is rounded down to `f32` where the CPU finds `want`.
pub fn check_earliest(session: &mut Session, x0: &[[f64; 3]], x1: &[[f64; 3]], want: Option<f64>) {
    let got = session.earliest_toi(x0, x1).unwrap();
    let near = |(want, got): (f64, f64)| got <= want && got >= want - 1e-6 - 1e-7 * want;
    assert_eq!(got.is_some(), want.is_some(), "{got:?}, on the CPU {want:?}");
    assert!(want.zip(got).is_none_or(near), "{got:?}, on the CPU {want:?}");
}

/// The same set, no pair twice.
pub fn check_pairs(what: &str, mut want: Vec<Pair>, mut got: Vec<Pair>) {
    want.sort_unstable();
    got.sort_unstable();
    assert!(got.windows(2).all(|w| w[0] != w[1]), "{what}: a pair comes twice");
    assert_eq!(got.len(), want.len(), "{what}: number of pairs");
    assert!(got == want, "{what}: other pairs");
}

pub fn check_step(device: &Device, step: &generate::Step, options: Options) {
    let for_cpu = on_cpu(&options);
    let cpu = ccd::step(&step.mesh, &step.x0, &step.x1, &for_cpu).unwrap();
    let mut session = Session::new(device, step.mesh.clone(), options.clone()).unwrap();
    let gpu = session.step(&step.x0, &step.x1).unwrap();
    assert!(!cpu.contacts.is_empty(), "a scene without contact shows nothing");
    check_reports(&cpu, gpu, false);
    check_earliest(&mut session, &step.x0, &step.x1, cpu.toi);
    let [x0, x1] = step.rounded();
    let cpu = ccd::step(&step.mesh, &x0, &x1, &for_cpu).unwrap();
    check_reports(&cpu, session.step(&x0, &x1).unwrap(), false);
}

/// The same options for the CPU: with its default where it does not have the broad phase.
pub fn on_cpu(options: &Options) -> Options {
    match options.broad_phase.lacking("cpu") {
        Some(_) => options.clone().with_broad_phase(BroadPhaseMethod::default()),
        None => options.clone(),
    }
}

/// Triangles with corners on a coarse grid: most pairs touch in corners, move in planes, or are
/// parallel, which rounded arithmetic leaves open. What the CPU reports the device does, too.
fn check_degenerate(device: &Device) {
    let mut random = generate::Random::new(21);
    for unit in [0.25, 0.1] {
        let n = 90u32;
        let mut corner = || std::array::from_fn::<f64, 3, _>(|_| random.below(5) as f64 * unit);
        let x0: Vec<[f64; 3]> = (0..3 * n).map(|_| corner()).collect();
        let x1: Vec<[f64; 3]> =
            x0.iter().map(|p| if p[0] > unit { corner() } else { *p }).collect();
        let apart: Vec<[f64; 3]> = x1.iter().map(|p| [p[0], p[1] + 0.3, p[2] + 0.1]).collect();
        let faces: Vec<[u32; 3]> = (0..n).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        let mesh = ccd::Mesh::new(3 * n as usize, &faces).unwrap();
        let mut session = Session::new(device, mesh.clone(), Options::default()).unwrap();
        let keys = |contacts: &[Contact]| -> Vec<_> {
            contacts.iter().map(|c| (c.kind, c.a, c.b, c.state)).collect()
        };
        // Where pairs are left open, those of later steps are read with their results, if they are
        // no more than expected: as many, none, more.
        for [x0, x1] in [[&x0, &x1], [&x0, &x1], [&x1, &apart], [&x0, &x1]] {
            let cpu = ccd::step(&mesh, x0, x1, &Options::default()).unwrap();
            let gpu = session.step(x0, x1).unwrap();
            assert_eq!(gpu.candidates, cpu.candidates);
            assert_eq!(keys(&gpu.contacts), keys(&cpu.contacts));
            assert_eq!(gpu.undecided, 0);
        }
        let cpu = ccd::step(&mesh, &x0, &x1, &Options::default()).unwrap();
        let of_cpu = &cpu.contacts;
        let open = of_cpu.iter().filter(|c| {
            let ids = c.vertices(&mesh);
            let (t0, t1) = (ids.map(|v| x0[v as usize]), ids.map(|v| x1[v as usize]));
            let verdict = match c.kind {
                Kind::VertexFace => ccd::vertex_face(&VertexFace { t0, t1 }, 0.0),
                _ => ccd::edge_edge(&EdgeEdge { t0, t1 }, 0.0),
            };
            matches!(verdict, Verdict::Undecided { .. })
        });
        let n_open = open.count();
        println!("degenerate, {unit}: {} contacts, {n_open} open in `f64`", of_cpu.len());
        assert!(n_open > 100, "nothing degenerate");
    }
}

/// Times that integers find are multiples of 2^-31, and those of `f64` are none.
fn check_who_decides(device: &Device) {
    let step = generate::crumpled_sheet(40, 1);
    let mut session = Session::new(device, step.mesh, Options::default()).unwrap();
    let contacts = &session.step(&step.x0, &step.x1).unwrap().contacts;
    let hits = contacts.iter().filter(|contact| contact.state == State::Hit);
    let are_units = hits.map(|contact| (contact.toi * (1u64 << 31) as f64).fract() == 0.0);
    let (units, others): (Vec<bool>, Vec<bool>) = are_units.partition(|&is| is);
    let [units, others] = [units.len(), others.len()];
    let (more, fewer) = if device.info().integers { (units, others) } else { (others, units) };
    assert!(more > 100 && more > 20 * fewer, "{units} of integers, {others} others");
}

/// Contacts that are so many that they are sorted on the device from the second frame on; then
/// fewer, then more than were expected.
fn check_many_contacts(device: &Device) {
    let [many, few] = [120, 20].map(|n| generate::crumpled_sheet(n, 2));
    let mut session = Session::new(device, many.mesh.clone(), Options::default()).unwrap();
    let options = session.options().clone();
    let cpu = ccd::step(&many.mesh, &many.x0, &many.x1, &options).unwrap();
    assert!(cpu.contacts.len() > 5000, "{} contacts", cpu.contacts.len());
    let info = device.info();
    let same = info.path == ShaderPath::Passthrough && !info.integers;
    let x0 = &many.x0;
    // Half of the sheet stands still.
    let half: Vec<[f64; 3]> =
        (0..x0.len()).map(|i| if i < x0.len() / 2 { many.x1[i] } else { x0[i] }).collect();
    let less = ccd::step(&many.mesh, x0, &half, &options).unwrap();
    let n_less = less.contacts.len();
    assert!(n_less > 4096 / 2 && n_less * 5 / 4 + 256 < cpu.contacts.len(), "{n_less} contacts");
    for (x1, want) in
        [(&many.x1, &cpu), (&many.x1, &cpu), (&half, &less), (&many.x1, &cpu), (&many.x1, &cpu)]
    {
        check_reports(want, session.step(x0, x1).unwrap(), same);
    }
    let mut session = Session::new(device, few.mesh.clone(), Options::default()).unwrap();
    let cpu = ccd::step(&few.mesh, &few.x0, &few.x1, &options).unwrap();
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
    assert!(fails(&|r| _ = r.contacts.remove(certain), false), "a missing contact passes");
    assert!(fails(&|r| r.contacts[certain].toi += 1e-3, false), "a late contact passes");
    assert!(fails(&|r| r.contacts[certain].toi += 1e-15, true), "another rounding is the same");
    assert!(fails(&|r| r.candidates.ee += 1, false), "another number of candidates passes");
    let extra = Contact::new(Kind::VertexFace, State::Hit, 0, 0, 0.5);
    assert!(fails(&|r| r.contacts.insert(0, extra), false), "a contact that is none passes");
    let pairs = |of: &[[u32; 2]]| of.iter().map(|&[a, b]| Pair { a, b }).collect::<Vec<_>>();
    let differs = |of: &[[u32; 2]]| {
        compare::fails(|| check_pairs("control", pairs(&[[1, 2], [3, 4]]), pairs(of)))
    };
    assert!(!differs(&[[3, 4], [1, 2]]) && differs(&[[1, 2]]));
    assert!(differs(&[[1, 2], [1, 2]]) && differs(&[[1, 2], [3, 5]]));
}
