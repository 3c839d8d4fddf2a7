//! A warm session allocates nothing; and what a session holds for its mesh is no more than the
//! estimate by which a limit of memory is kept.
#![deny(unsafe_code)]

use ccd::method::{BroadPhaseMethod, Builder, Front, Pipeline, Scheduling, Traversal, TreeOptions};
use ccd::{Bodies, BodyMotion, CancelToken, Error, Mesh, Options, Posed, Session, Strided};
use ccd_testkit::generate::crumpled_sheet;
use ccd_testkit::methods::is_near_default;
use libtest_mimic::{Arguments, Trial};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::LazyCell;
use std::sync::atomic::{AtomicUsize, Ordering};

struct Counting;

static CALLS: AtomicUsize = AtomicUsize::new(0);
/// Bytes that are allocated and not freed.
static LIVE: AtomicUsize = AtomicUsize::new(0);

#[allow(unsafe_code, reason = "the trait of allocators is unsafe; this one only counts")]
// SAFETY: every call goes to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        CALLS.fetch_add(1, Ordering::Relaxed);
        LIVE.fetch_add(layout.size(), Ordering::Relaxed);
        // SAFETY: the caller's promises are passed on.
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, p: *mut u8, layout: Layout) {
        LIVE.fetch_sub(layout.size(), Ordering::Relaxed);
        // SAFETY: the caller's promises are passed on.
        unsafe { System.dealloc(p, layout) }
    }
    unsafe fn realloc(&self, p: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        CALLS.fetch_add(1, Ordering::Relaxed);
        LIVE.fetch_add(size.wrapping_sub(layout.size()), Ordering::Relaxed);
        // SAFETY: the caller's promises are passed on.
        unsafe { System.realloc(p, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Allocations of each of 24 steps after 12 to warm up.
fn count(
    threads: usize,
    broad_phase: BroadPhaseMethod,
    pipeline: Pipeline,
    scheduling: Scheduling,
) -> Vec<usize> {
    // More edges than two threads share out as one chunk.
    let step = crumpled_sheet(28, 1);
    let options = Options::default()
        .with_threads(threads)
        .with_broad_phase(broad_phase)
        .with_pipeline(pipeline)
        .with_scheduling(scheduling);
    let mut session = Session::new(step.mesh, options).unwrap();
    session.set_cancel_token(CancelToken::new());
    let one = |session: &mut Session, i: usize| {
        let before = CALLS.load(Ordering::Relaxed);
        // Forwards and backwards in turn; every third time only the earliest time.
        let (x0, x1) =
            if i.is_multiple_of(2) { (&step.x0, &step.x1) } else { (&step.x1, &step.x0) };
        if i.is_multiple_of(3) {
            session.earliest_toi(x0, x1).unwrap();
        } else {
            assert!(!session.step(x0, x1).unwrap().contacts.is_empty());
        }
        CALLS.load(Ordering::Relaxed) - before
    };
    for i in 0..12 {
        one(&mut session, i);
    }
    (12..24).map(|i| one(&mut session, i)).collect()
}

fn check(method: BroadPhaseMethod, pipeline: Pipeline, scheduling: Scheduling) {
    let what = format!("{method}, {pipeline:?}, {scheduling}");
    let alone = count(1, method, pipeline, scheduling);
    assert!(alone.iter().all(|&n| n == 0), "{what}, one thread: {alone:?}");
    // Rayon's queue for calls from outside of the pool grows by one block in 63 calls, and each
    // worker's own queue may grow once. A worker that a busy machine kept from the steps before
    // grows its lists later: then the same is counted again. What each step allocates, every count
    // has.
    let counted = [(); 3].map(|()| LazyCell::new(|| count(2, method, pipeline, scheduling)));
    let few = |calls: &[usize]| calls.iter().sum::<usize>() <= 4;
    let is_warm = counted.iter().any(|calls| few(calls));
    assert!(is_warm, "{what}, two threads: {:?}", counted.each_ref().map(|calls| calls.to_vec()));
}

/// Positions that are gathered, and steps after changes: a warm session allocates nothing in them,
/// nor in a change to what it had before.
fn check_forms_and_changes() {
    let (step, small) = (crumpled_sheet(30, 1), crumpled_sheet(20, 1));
    let still =
        [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
    let mut session = Session::new(&step.mesh, Options::default().with_threads(1)).unwrap();
    let meshes = [&step, &small].map(|step| std::sync::Arc::new(step.mesh.clone()));
    let mut one = || {
        let before = CALLS.load(Ordering::Relaxed);
        for (of, mesh) in [(&step, &meshes[0]), (&small, &meshes[1])] {
            session.set_mesh(mesh.clone()).unwrap();
            let x0 = Strided::<f64>::of(&of.x0);
            session.step(&x0, &Posed::one(&of.x1, &still)).unwrap();
            session.set_min_distance(0.001).unwrap();
            session.step(&of.x0, &Strided::<f64>::of(&of.x1)).unwrap();
            session.set_min_distance(0.0).unwrap();
            session.earliest_toi(&of.x0, &of.x1).unwrap();
        }
        CALLS.load(Ordering::Relaxed) - before
    };
    (0..6).for_each(|_| _ = one());
    let calls: Vec<usize> = (0..10).map(|_| one()).collect();
    assert!(calls.iter().all(|&n| n == 0), "forms and changes: {calls:?}");
}

/// Bodies that are moved by poses: a warm session allocates nothing, and holds no more than the
/// estimate for its mesh.
fn check_poses() {
    const N_BODIES: u32 = 3;
    let (step, bodies) = ccd::scenes::copies(&crumpled_sheet(20, 1), N_BODIES as usize);
    let names: Vec<u32> = (0..step.x0.len()).map(|v| bodies.name(v as u32)).collect();
    let bodies = Bodies::new(&names).with_self_contacts(false);
    let options = Options::default().with_threads(1).with_bodies(bodies);
    let mesh = std::sync::Arc::new(step.mesh);
    let limited = options.clone().with_max_memory(0);
    let Some(Error::Memory { bytes, .. }) = Session::new(mesh.clone(), limited).err() else {
        panic!("no memory was enough");
    };
    let before = LIVE.load(Ordering::Relaxed);
    let mut session = Session::new(mesh, options).unwrap();
    session.set_positions(&step.x0).unwrap();
    // Apart at first, then one on the other.
    let pose = |body: u32, time: usize| {
        let mut pose = [0, 1, 2, 3].map(|k| [0, 1, 2, 3].map(|i| (i == k) as u8 as f64));
        pose[3][1] = if time.is_multiple_of(4) { 4.0 } else { 0.01 } * f64::from(body);
        pose
    };
    let apart = |body| BodyMotion::posed(body, &pose(body, 0), &pose(body, 0));
    for _ in 0..3 {
        let motions: Vec<BodyMotion> = (0..N_BODIES).map(apart).collect();
        assert!(session.step_bodies(&motions).unwrap().contacts.is_empty());
    }
    let held = (LIVE.load(Ordering::Relaxed) - before) as u64;
    assert!(held <= bytes, "poses: {held} bytes, not {bytes}");
    let mut one = |time: usize| {
        let before = CALLS.load(Ordering::Relaxed);
        for body in 0..N_BODIES {
            let motion = BodyMotion::posed(body, &pose(body, time), &pose(body, time + 1));
            session.step_bodies(&[motion]).unwrap();
            session.earliest_toi_of_bodies(&[motion]).unwrap();
        }
        CALLS.load(Ordering::Relaxed) - before
    };
    (0..12).for_each(|time| _ = one(time));
    let calls: Vec<usize> = (12..24).map(one).collect();
    assert!(calls.iter().all(|&n| n == 0), "poses: {calls:?}");
}

/// Steps with few pairs hold what the mesh needs: no more than the estimate, and not so little that
/// it would be a bad one.
fn check_estimate(method: BroadPhaseMethod, pipeline: Pipeline, scheduling: Scheduling) {
    // That builder takes fewer boxes than these, and its tree is as large as any other.
    let tree = |tree: TreeOptions| matches!(tree.builder, Builder::NearestPair { .. });
    let is_small = matches!(method, BroadPhaseMethod::Tree(of) if tree(of));
    // Fronts are counted as they grow.
    if is_small || scheduling.front != Front::Off {
        return;
    }
    // One, and for blocks also many worlds, of which each begins with a block of its own.
    // Forms: 0, particles; 1, a sheet; 2, rods among particles.
    let n_scenes = if method == BroadPhaseMethod::Blocks { 5 } else { 4 };
    let scenes = [(64, 1, 1, 1), (64, 1, 2, 1), (64, 1, 1, 0), (64, 1, 1, 2), (4, 500, 1, 1)];
    for (side, copies, threads, form) in scenes.into_iter().take(n_scenes) {
        let mut sheet = crumpled_sheet(side, 1);
        // A bowl, of which nothing touches anything.
        let at = |v: usize| {
            let (i, j) = ((v % side) as f64, (v / side) as f64);
            [i + 0.01 * j, 0.01 * (i * i + j * j), j]
        };
        sheet.x0 = (0..sheet.x0.len()).map(at).collect();
        let n = sheet.x0.len();
        match form {
            0 => sheet.mesh = Mesh::with_edges(n, &[], &[]).unwrap(),
            2 => {
                let rods: Vec<[u32; 2]> = (2..n as u32).step_by(2).map(|v| [v - 2, v]).collect();
                sheet.mesh = Mesh::with_edges(n, &[], &rods).unwrap();
            }
            _ => {}
        }
        let (ccd::scenes::Step { mesh, x0: bowl, .. }, bodies) =
            ccd::scenes::copies(&sheet, copies);
        let mesh = std::sync::Arc::new(mesh);
        let options = Options::default()
            .with_threads(threads)
            .with_bodies((copies > 1).then_some(bodies))
            .with_broad_phase(method)
            .with_pipeline(pipeline)
            .with_scheduling(scheduling);
        let limited = options.clone().with_max_memory(0);
        let Some(Error::Memory { bytes, .. }) = Session::new(mesh.clone(), limited).err() else {
            panic!("no memory was enough");
        };
        let before = LIVE.load(Ordering::Relaxed);
        let mut session = Session::new(mesh.clone(), options).unwrap();
        let gathered = Strided::<f64>::of(&bowl);
        for _ in 0..3 {
            assert!(session.step(&gathered, &bowl).unwrap().contacts.is_empty());
        }
        let held = (LIVE.load(Ordering::Relaxed) - before) as u64;
        let what = format!("{method}, {pipeline:?}, {scheduling}, {copies} of {side}, form {form}");
        assert!(held <= bytes && 4 * held > bytes, "{held} bytes, not {bytes}: {what}");
    }
}

/// The standard library's harness prints, and allocates, beside a test that takes over a minute.
fn main() -> std::process::ExitCode {
    let mut arguments = Arguments::from_args();
    arguments.test_threads = Some(1);
    let test = || {
        warm_sessions_allocate_nothing();
        Ok(())
    };
    let name = "warm_sessions_allocate_nothing";
    libtest_mimic::run(&arguments, vec![Trial::test(name, test)]).exit_code()
}

fn warm_sessions_allocate_nothing() {
    for method in ccd::method::every("cpu").filter(|&method| is_near_default(method)) {
        for pipeline in [Pipeline::Features, Pipeline::TRIANGLES] {
            check(method, pipeline, Scheduling::default());
            check_estimate(method, pipeline, Scheduling::default());
        }
    }
    let cut = TreeOptions::default().traversal(Traversal::CUT);
    for scheduling in Scheduling::every("cpu") {
        for method in [BroadPhaseMethod::Blocks, BroadPhaseMethod::Tree(cut)] {
            check(method, Pipeline::Features, scheduling);
            check_estimate(method, Pipeline::Features, scheduling);
        }
    }
    check_forms_and_changes();
    check_poses();
    // The counter counts.
    let before = CALLS.load(Ordering::Relaxed);
    drop(std::hint::black_box(vec![1u8; 100]));
    assert!(CALLS.load(Ordering::Relaxed) > before);
}
