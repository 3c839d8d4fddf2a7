//! After a call that failed, whatever it was that failed in it, a session finds what a new one
//! does: buffers, frames and results fail in turn, while lists are short and pairs are left after
//! the last round.

use ccd::gpu::harness::{Faults, set_faults};
use ccd::gpu::wgpu::DeviceType;
use ccd::gpu::{BroadPhase, Device, Error, Session};
use ccd::method::{
    BroadPhaseMethod, Descent, Pipeline, Scheduler, Scheduling, Traversal, TreeOptions,
    TriangleOptions, Volume,
};
use ccd::scenes::{Step, crumpled_sheet};
use ccd::{Aabb, Contact, Digest, Options};
use ccd_testkit::generate::uniform_boxes;

pub const TESTS: crate::Tests =
    &[("steps_after_failures", check_sessions), ("boxes_after_failures", check_broad_phase)];

/// What a device says when it fails.
fn errors() -> [Error; 3] {
    [
        Error::OutOfMemory { what: "test", bytes: 1 },
        Error::TooLarge { what: "test", bytes: 2, limit: 1 },
        Error::Refused { why: "test".into() },
    ]
}

/// A call in which the device fails `n` times after so many calls of the driver, and whether it
/// did.
fn failing<T>(
    device: &Device,
    (skip, n): (u32, u32),
    error: &Error,
    call: impl FnOnce() -> Result<T, Error>,
) -> (Option<T>, bool) {
    let error = Some(error.clone());
    let faults = Faults { skip, n, error: error.clone(), short_rounds: true, ..Faults::default() };
    let old = set_faults(device, faults);
    let got = call();
    let left = set_faults(device, old);
    let failed = left.n < n;
    match got {
        Ok(got) => (Some(got), failed),
        Err(why) => {
            assert!(failed && Some(why.to_string()) == error.map(|e| e.to_string()), "{why}");
            (None, true)
        }
    }
}

/// What a session finds in a step and in the same the other way round, at once after, which begins
/// with what the first one left.
fn found(session: &mut Session, step: &Step) -> Result<Vec<Contact>, Error> {
    let mut all = session.step(&step.x0, &step.x1)?.contacts.clone();
    all.extend_from_slice(&session.step(&step.x1, &step.x0)?.contacts);
    Ok(all)
}

fn candidates(session: &mut Session, step: &Step) -> Result<[Digest; 2], Error> {
    let found = session.candidates(&step.x0, &step.x1)?;
    Ok([Digest::of(0, found.vf.into_iter()), Digest::of(1, found.ee.into_iter())])
}

/// Where calls fail: everywhere, or at some places where threads of this machine do the work of a
/// GPU, others for every `i`.
fn places(device: &Device, i: usize) -> Vec<u32> {
    match (device.info().adapter.device_type, i) {
        // Whatever follows the second frame, in which pairs are left and all else had room: the
        // next call wants no list longer that could tell it that something was amiss.
        (DeviceType::Cpu, 0) => (18..22).collect(),
        // Lists grow for the first time.
        (DeviceType::Cpu, _) => vec![8 + i as u32 % 3],
        _ => (0..1000).collect(),
    }
}

/// What is right for a step: contacts, and candidates of both kinds.
type Right = (Vec<Contact>, [Digest; 2]);

fn right(device: &Device, step: &Step, pipeline: Pipeline) -> Right {
    let options = Options::default().with_pipeline(pipeline);
    let mut session = Session::new(device, step.mesh.clone(), options).expect("a session");
    let contacts = found(&mut session, step).expect("contacts");
    assert!(!contacts.is_empty(), "no contacts");
    (contacts, candidates(&mut session, step).expect("candidates"))
}

/// Sessions that fail in a call, one at each place, and then have steps that do not. They begin
/// with lists and rounds that are too short. `call` is what is called, and of which number. Returns
/// how many failed.
fn check_session(
    device: &Device,
    what: &str,
    [step, other]: [&Step; 2],
    options: &Options,
    (want, pairs): &Right,
    (call, i): (usize, usize),
) -> usize {
    let new = |step: &Step| Session::new(device, step.mesh.clone(), options.clone()).expect(what);
    set_faults(device, Faults { short_rounds: true, ..Faults::default() });
    let mut n_failed = 0;
    for (k, skip) in places(device, i).into_iter().enumerate() {
        // One list that cannot grow, not even a little, or all from then on.
        let (n, error) = ([2, u32::MAX][(i + k) % 2], &errors()[(i + k) % 3]);
        let at = format!("{what}: call {call}, {n} failures after {skip}: {error}");
        let mut session = new(step);
        session.reserve(8).expect(&at);
        let (got, failed) = failing(device, (skip, n), error, || match call {
            0 => found(&mut session, step).map(|got| assert!(got == *want, "{at}: at once")),
            1 => candidates(&mut session, step).map(|got| assert_eq!(got, *pairs, "{at}")),
            _ => session.set_mesh(&other.mesh),
        });
        n_failed += got.is_none() as usize;
        if call == 0 && got.is_none() {
            let report = session.report();
            let n = report.candidates.total();
            assert!(report.contacts.is_empty() && report.toi.is_none() && n == 0, "{at}: a report");
        }
        if call == 2 && got.is_some() {
            let got = found(&mut session, other).expect(&at);
            assert!(got == found(&mut new(other), other).expect(&at), "{at}: another mesh");
            session.set_mesh(&step.mesh).expect(&at);
        }
        let got = found(&mut session, step).expect(&at);
        let (n, of) = (got.len(), want.len());
        assert!(got == *want, "{at}: then {n} contacts, a new session finds {of}");
        assert_eq!(candidates(&mut session, step).expect(&at), *pairs, "{at}: candidates");
        if !failed {
            break;
        }
    }
    set_faults(device, Faults::default());
    n_failed
}

fn check_sessions(device: &Device) {
    let native = device.check_native().is_ok();
    let steals =
        |s: Scheduling| matches!(s.scheduler, Some(Scheduler::Stealing | Scheduler::LazyStealing));
    let cut = Traversal::Cut { nodes: 8, descent: Descent::Larger };
    let tree = TreeOptions::default().traversal(cut);
    let aabb = BroadPhaseMethod::Tree(tree);
    let obb = BroadPhaseMethod::Tree(tree.volume(Volume::Obb));
    // Of blocks, some on a level above them.
    let of_blocks = [crumpled_sheet(46, 1), crumpled_sheet(27, 2)];
    let small = [crumpled_sheet(7, 1), crumpled_sheet(6, 2)];
    let triangles = Pipeline::Triangles(TriangleOptions::default().orphans(true));
    let right = |[step, _]: &[Step; 2], pipeline| right(device, step, pipeline);
    let of_small = right(&small, Pipeline::Features);
    let of_triangles = right(&small, triangles);
    let of_large = right(&of_blocks, Pipeline::Features);
    let (mut n_failed, mut n) = (0, 0);
    let mut check = |steps: &[Step; 2], options: Options, right: &Right, call: usize| {
        let Options { broad_phase, scheduling, pipeline, .. } = &options;
        let what = format!("{broad_phase}, {scheduling}, {pipeline:?}");
        n_failed += check_session(device, &what, steps.each_ref(), &options, right, (call, n));
        n += 1;
    };
    for (i, scheduling) in Scheduling::every("gpu").enumerate() {
        if steals(scheduling) && !native {
            continue;
        }
        let options = Options::default().with_scheduling(scheduling);
        // Trees with every second scheduling, one with a front and one without in turn, blocks and
        // triangles with every fifth, where a GPU is emulated.
        let emulated = device.info().adapter.device_type == DeviceType::Cpu;
        if (i + i / 2) % 2 == 1 || !emulated {
            check(&small, options.clone().with_broad_phase(aabb), &of_small, 0);
        }
        if i % 5 == 1 || !emulated {
            check(&of_blocks, options.clone(), &of_large, 0);
            let k = (i + i / 5) % 2;
            let options = options.with_broad_phase([obb, aabb][k]);
            check(&small, options.with_pipeline(triangles), &of_triangles, k + 1);
        }
    }
    let stacks = Traversal::CutStacks { nodes: 8, descent: Descent::Larger };
    let stacks = BroadPhaseMethod::Tree(tree.traversal(stacks));
    let stacks = Options::default().with_broad_phase(stacks);
    check(&small, stacks.clone(), &of_small, 0);
    check(&small, stacks.with_pipeline(triangles), &of_triangles, 0);
    assert!(n_failed > n / 2, "{n_failed} calls failed in {n} sessions");
}

/// A broad phase, and what a call after one that failed finds.
fn check_broad_phase(device: &Device) {
    let boxes: Vec<Aabb> = uniform_boxes(1500).iter().map(|b| b.inflated(0.12)).collect();
    let cut = Traversal::Cut { nodes: 8, descent: Descent::Both };
    let method = BroadPhaseMethod::Tree(TreeOptions::default().traversal(cut));
    let scheduling = Scheduling::default().scheduler(Scheduler::BALANCED);
    let new = || BroadPhase::scheduled(device, method, scheduling).expect("a broad phase");
    assert!(matches!(new().again(), Err(Error::NoBoxes)), "pairs without boxes");
    let want = new().self_pairs(&boxes).expect("pairs").len();
    assert!(want > 1 << 16, "{want} pairs have room at once");
    for (k, skip) in places(device, 3).into_iter().enumerate() {
        let (n, error, mut broad) = ([2, u32::MAX][k % 2], &errors()[k % 3], new());
        let (got, failed) =
            failing(device, (skip, n), error, || broad.self_pairs(&boxes).map(|p| p.len()));
        assert!(got.is_none_or(|n| n == want), "{skip}: {got:?} of {want}");
        let got = broad.self_pairs(&boxes).expect("pairs").len();
        assert_eq!(got, want, "{skip}: after {error}");
        if !failed {
            break;
        }
    }
}
