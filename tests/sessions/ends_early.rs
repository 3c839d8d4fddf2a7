//! Calls that end in the middle, because a filter panics or because they are cancelled: they leave
//! nothing behind in a session. The next one finds what a new session does, by every method,
//! pipeline and scheduling.

use ccd::method::{BroadPhaseMethod, Pipeline, Scheduling, Traversal, TreeOptions};
use ccd::scenes::{Step, crumpled_sheet, particles_and_rods};
use ccd::{Bodies, BodyMotion, CancelToken, Contact, Error, Mesh, Options, Pair, PerKind, Session};
use ccd_testkit::is_whole;
use ccd_testkit::methods::is_near_default;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::sync::{Arc, Mutex};

/// The same scene in every way of asking for it: contacts, counts, the earliest time, candidates.
type Found = (Vec<Contact>, PerKind, PerKind, Option<f64>, [Vec<Pair>; 4]);

fn found(session: &mut Session, Step { x0, x1, .. }: &Step) -> Found {
    let earliest = session.earliest_toi(x0, x1).unwrap();
    let all = session.candidates(x0, x1).unwrap();
    let mut pairs = [all.vf.to_vec(), all.ee.to_vec(), all.ve.to_vec(), all.vv.to_vec()];
    pairs.iter_mut().for_each(|pairs| pairs.sort_unstable());
    let report = session.step(x0, x1).unwrap();
    (report.contacts.clone(), report.candidates, report.filtered, earliest, pairs)
}

/// Has the filter of a session unwind, or cancel, in its n-th call, for some n, in each kind of
/// call.
fn check(step: &Step, options: &Options, unwinds: bool) {
    let calls = Arc::new(AtomicUsize::new(0));
    // The call in which it unwinds; 0: in none.
    let fatal = Arc::new(AtomicUsize::new(0));
    let token = Arc::new(Mutex::new(CancelToken::new()));
    let filter = {
        let (calls, fatal, token) = (calls.clone(), fatal.clone(), token.clone());
        move |_, a: u32, b: u32| {
            if calls.fetch_add(1, Relaxed) + 1 == fatal.load(Relaxed) {
                if unwinds {
                    // As a panic, but without a message.
                    resume_unwind(Box::new(()));
                }
                token.lock().unwrap().cancel();
            }
            !a.wrapping_add(b).is_multiple_of(5)
        }
    };
    let new = || {
        let mut session = Session::new(&step.mesh, options.clone()).unwrap();
        session.set_filter(filter.clone()).unwrap();
        session
    };
    let (want, mut session) = (found(&mut new(), step), new());
    assert!(want.0.len() > 10, "{} contacts show little", want.0.len());
    type Call = fn(&mut Session, &Step) -> Result<(), Error>;
    let kinds: [Call; 3] = [
        |session, of| session.step(&of.x0, &of.x1).map(|_| ()),
        |session, of| session.earliest_toi(&of.x0, &of.x1).map(|_| ()),
        |session, of| session.candidates(&of.x0, &of.x1).map(|_| ()),
    ];
    for (k, call) in kinds.into_iter().enumerate() {
        calls.store(0, Relaxed);
        call(&mut session, step).unwrap();
        let n = calls.load(Relaxed);
        assert!(n > 100, "{n} calls show little");
        for nth in [1, n / 3, n - 1, n] {
            let what = format!("call {nth} of {n} in call {k}: {options:?}");
            *token.lock().unwrap() = CancelToken::new();
            session.set_cancel_token(token.lock().unwrap().clone());
            calls.store(0, Relaxed);
            fatal.store(nth, Relaxed);
            let ended = catch_unwind(AssertUnwindSafe(|| call(&mut session, step)));
            fatal.store(0, Relaxed);
            assert_eq!(ended.ok(), (!unwinds).then_some(Err(Error::Cancelled)), "{what}");
            if k < 2 {
                assert!(session.report().contacts.is_empty(), "{what}: contacts are left");
            }
            session.set_cancel_token(None);
            let found = catch_unwind(AssertUnwindSafe(|| found(&mut session, step)));
            let found = found.unwrap_or_else(|_| panic!("{what}: the next step panics"));
            assert!(found == want, "{what}: {} contacts, not {}", found.0.len(), want.0.len());
        }
    }
}

#[test]
fn a_filter_that_panics_leaves_nothing_behind() {
    check_all(true);
}

#[test]
fn a_call_that_is_cancelled_leaves_nothing_behind() {
    check_all(false);
}

fn check_all(unwinds: bool) {
    let scenes = [crumpled_sheet(9, 1), particles_and_rods(14, 3)];
    let tree = |traversal| BroadPhaseMethod::Tree(TreeOptions::default().traversal(traversal));
    let descending =
        [BroadPhaseMethod::Blocks, tree(Traversal::CUT), tree(Traversal::SIMULTANEOUS)];
    let scheduled = descending
        .into_iter()
        .flat_map(|method| Scheduling::every("cpu").map(move |scheduling| (method, scheduling)));
    let by_itself = ccd::method::every("cpu").filter(|&method| is_near_default(method));
    let all = by_itself.map(|method| (method, Scheduling::default())).chain(scheduled);
    for (i, (method, scheduling)) in all.enumerate() {
        for (k, pipeline) in [Pipeline::Features, Pipeline::TRIANGLES].into_iter().enumerate() {
            // One thread or two, of one method both.
            for threads in [1, 2].into_iter().filter(|n| is_whole() || (i / 2 + k + n) % 2 == 0) {
                let options = Options::default()
                    .with_threads(threads)
                    .with_broad_phase(method)
                    .with_pipeline(pipeline)
                    .with_scheduling(scheduling);
                check(&scenes[i % 2], &options, unwinds);
            }
        }
    }
}

/// A body that was to move stands where it stood, as after an error.
#[test]
fn bodies_of_a_call_that_panics_stay() {
    let faces = [[0u32, 1, 2], [3, 4, 5], [6, 7, 8]];
    let mesh = Mesh::new(9, &faces).unwrap();
    let bodies = Bodies::new(&[0, 0, 0, 1, 1, 1, 2, 2, 2]).with_self_contacts(false);
    let at = |y: f64| [[0.2, y, 0.2], [0.4, y + 0.1, 0.2], [0.2, y + 0.1, 0.4]];
    let floor = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    let x: Vec<[f64; 3]> = [floor, at(1.0), at(-5.0)].concat();
    let new = || {
        let options = Options::default().with_bodies(bodies.clone());
        let mut session = Session::new(&mesh, options).unwrap();
        session.set_positions(&x).unwrap();
        session
    };
    let panics = Arc::new(AtomicUsize::new(1));
    let mut session = new();
    let until = panics.clone();
    let filter = move |_, _, _| {
        if until.load(Relaxed) > 0 {
            resume_unwind(Box::new(()));
        }
        true
    };
    session.set_filter(filter).unwrap();
    let (from, to) = (at(1.0), at(-1.0));
    let falls = [BodyMotion::new(1, &from, &to)];
    let step = AssertUnwindSafe(|| session.step_bodies(&falls).map(|_| ()));
    assert!(catch_unwind(step).is_err());
    panics.store(0, Relaxed);
    // Through what stands at 1 still.
    let (from, to) = (at(0.5), at(2.0));
    let rises = [BodyMotion::new(2, &from, &to)];
    let found = session.step_bodies(&rises).unwrap().contacts.clone();
    assert!(!found.is_empty());
    assert_eq!(found, new().step_bodies(&rises).unwrap().contacts);
}
