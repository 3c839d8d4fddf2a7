//! Limits that a caller sets: memory, and a token by which another thread cancels; and what wants
//! them, a step with thousands of times the pairs of the one before.

use ccd::method::{BroadPhaseMethod, Pipeline, Scheduling, Traversal, TreeOptions};
use ccd::scenes::{Step, cloth_on_ball, crumpled_sheet, particles_and_rods};
use ccd::{CancelToken, Candidates, Contact, Error, Mesh, Options, Pair, Session};
use std::time::{Duration, Instant};

/// Triangles whose pairs are few at first and then as many as can be, in `f64`.
fn collapse(n: usize) -> (Mesh, [Vec<[f64; 3]>; 3]) {
    let (mesh, x) = ccd_testkit::collapse::collapse(n);
    (mesh, x.map(|x| x.iter().map(|p| p.map(f64::from)).collect()))
}

fn contacts(session: &mut Session, x0: &[[f64; 3]], x1: &[[f64; 3]]) -> Vec<Contact> {
    session.step(x0, x1).unwrap().contacts.clone()
}

/// Candidates in an order that does not depend on the steps before.
fn sorted(found: &Candidates) -> [Vec<Pair>; 2] {
    [found.vf, found.ee].map(|pairs| {
        let mut pairs = pairs.to_vec();
        pairs.sort_unstable();
        pairs
    })
}

/// Methods, schedulings and pipelines that keep lists of different kinds.
fn ways() -> Vec<Options> {
    let cut = BroadPhaseMethod::Tree(TreeOptions::default().traversal(Traversal::CUT));
    let by_itself = [BroadPhaseMethod::SweepAndPrune, BroadPhaseMethod::TREE]
        .map(|method| (method, Scheduling::default()));
    let scheduled = [BroadPhaseMethod::Blocks, cut]
        .into_iter()
        .flat_map(|method| Scheduling::every("cpu").map(move |scheduling| (method, scheduling)));
    let mut all = Vec::new();
    for (method, scheduling) in by_itself.into_iter().chain(scheduled) {
        for pipeline in [Pipeline::Features, Pipeline::TRIANGLES] {
            let options = Options::default().with_broad_phase(method).with_scheduling(scheduling);
            all.push(options.with_pipeline(pipeline).with_threads(2));
        }
    }
    all
}

#[test]
fn a_thousand_times_the_pairs_in_one_frame() {
    let (mesh, [a, b, c]) = collapse(60);
    for options in ways() {
        let new = || Session::new(&mesh, options.clone()).unwrap();
        let mut session = new();
        let mut before = 0;
        for (x0, x1) in [(&a, &b), (&b, &c), (&b, &a), (&b, &c), (&c, &c)] {
            let mut fresh = new();
            assert_eq!(contacts(&mut session, x0, x1), contacts(&mut fresh, x0, x1), "{options:?}");
            let n = session.report().candidates.total();
            assert_eq!(n, fresh.report().candidates.total(), "{options:?}");
            if x1 == &c && before > 0 && before < 100 {
                assert!(n > 1000 * before, "{n} after {before} show little");
            }
            before = n;
        }
    }
}

/// The memory that a session holds for its mesh.
fn of_mesh(mesh: &Mesh, options: &Options) -> u64 {
    match Session::new(mesh, options.clone().with_max_memory(0)).err() {
        Some(Error::Memory { bytes, held: 0, limit: 0, .. }) => bytes,
        other => panic!("{other:?}"),
    }
}

#[test]
fn what_is_beyond_the_limit_of_memory_is_refused() {
    let (mesh, [a, b, c]) = collapse(14);
    for options in ways() {
        let mut fresh = Session::new(&mesh, options.clone()).unwrap();
        let want = contacts(&mut fresh, &b, &c);
        let listed = sorted(&fresh.candidates(&b, &c).unwrap());
        let few = contacts(&mut Session::new(&mesh, options.clone()).unwrap(), &a, &b);
        let base = of_mesh(&mesh, &options);
        let mut refused = 0;
        for more in [0, 1 << 12, 1 << 17, 1 << 20, 1 << 26] {
            let limit = base + more;
            let mut session = Session::new(&mesh, options.clone().with_max_memory(limit)).unwrap();
            let what = format!("{more} bytes more: {options:?}");
            for _ in 0..2 {
                match session.step(&b, &c) {
                    Ok(report) => assert_eq!(report.contacts, want, "{what}"),
                    Err(Error::Memory { bytes, held, limit: l, .. }) => {
                        assert!(l == limit && held <= l && held + bytes > l, "{what}");
                        assert!(session.report().contacts.is_empty(), "{what}");
                        refused += 1;
                        assert!(more < 1 << 26, "{what}");
                    }
                    Err(other) => panic!("{what}: {other}"),
                }
                match session.candidates(&b, &c) {
                    Ok(found) => assert!(sorted(&found) == listed, "{what}"),
                    Err(e) => assert!(matches!(e, Error::Memory { .. }), "{what}: {e}"),
                }
                // What fits is found as ever.
                if more >= 1 << 17 {
                    assert_eq!(contacts(&mut session, &a, &b), few, "{what}");
                }
            }
            session.set_options(options.clone()).unwrap();
            assert_eq!(contacts(&mut session, &b, &c), want, "{what}: without a limit");
            assert!(session.set_options(options.clone().with_max_memory(base - 1)).is_err());
            session.set_options(options.clone().with_max_memory(base + (1 << 26))).unwrap();
            assert_eq!(contacts(&mut session, &b, &c), want, "{what}: with another limit");
        }
        assert!(refused > 2, "{refused} refused: {options:?}");
    }
}

/// Lists of particles and rods count as all others do, and a limit does not wear out.
#[test]
fn a_limit_holds_for_as_many_steps_as_there_are() {
    let Step { mesh, x0, x1 } = particles_and_rods(40, 2);
    let options = Options::default().with_threads(1);
    let want = contacts(&mut Session::new(&mesh, options.clone()).unwrap(), &x0, &x1);
    let limit = of_mesh(&mesh, &options) + (1 << 20);
    let limited = options.with_max_memory(limit);
    let mut session = Session::new(&mesh, limited.clone()).unwrap();
    for k in 0..300 {
        assert_eq!(contacts(&mut session, &x0, &x1), want, "step {k}");
        session.candidates(&x0, &x1).unwrap();
        if k % 3 == 0 {
            session.set_mesh(&mesh).unwrap();
        }
        if k % 5 == 0 {
            session.set_options(limited.clone().with_min_distance(0.0)).unwrap();
        }
    }
    let of_lists = limit - (1 << 20) + 64;
    let mut session = Session::new(&mesh, limited.with_max_memory(of_lists)).unwrap();
    assert!(matches!(session.step(&x0, &x1), Err(Error::Memory { .. })));
}

/// Which thread finds what is another one every time; what they keep of it is no reason to refuse a
/// step that a new session makes.
#[test]
fn a_limit_does_not_wear_out_on_many_threads() {
    let (mesh, [_, b, c]) = collapse(150);
    let options = Options::default().with_threads(4);
    let mut fresh = Session::new(&mesh, options.clone()).unwrap();
    let total = |found: &Candidates| found.vf.len() + found.ee.len();
    let want = total(&fresh.candidates(&b, &c).unwrap());
    let n_contacts = fresh.step(&b, &c).unwrap().contacts.len();
    assert!(want > 50_000 && n_contacts > 1000, "{want} candidates, {n_contacts} contacts");
    // Threads have lists that are not full; contacts are joined in another one.
    let lists = [18 * want, 4 * size_of::<Contact>() * n_contacts].map(|bytes| bytes as u64);
    for (k, bytes) in lists.into_iter().enumerate() {
        let limit = of_mesh(&mesh, &options) + bytes;
        let mut session = Session::new(&mesh, options.clone().with_max_memory(limit)).unwrap();
        for call in 0..40 {
            let found = match k {
                0 => session.candidates(&b, &c).map(|found| total(&found) == want),
                _ => session.step(&b, &c).map(|report| report.contacts.len() == n_contacts),
            };
            assert_eq!(found, Ok(true), "call {call} of {k}");
        }
    }
}

#[test]
fn another_thread_cancels() {
    let cloth = cloth_on_ball(80);
    let (x0, x1) = (cloth.frame(30), cloth.frame(31));
    let step = crumpled_sheet(60, 1);
    for (mesh, x0, x1) in [(&cloth.mesh, &x0, &x1), (&step.mesh, &step.x0, &step.x1)] {
        let mut session = Session::new(mesh, Options::default()).unwrap();
        let want = contacts(&mut session, x0, x1);
        let mut cancelled = 0;
        for k in 0..40 {
            let token = CancelToken::new();
            session.set_cancel_token(token.clone());
            let other = std::thread::spawn(move || {
                std::thread::sleep(Duration::from_micros(200 * k));
                token.cancel();
                Instant::now()
            });
            let end = loop {
                match session.step(x0, x1) {
                    Ok(report) => assert_eq!(report.contacts, want, "a step that was in time"),
                    Err(e) => break e,
                }
            };
            assert_eq!(end, Error::Cancelled);
            let late = Instant::now().saturating_duration_since(other.join().unwrap());
            assert!(late < Duration::from_secs(1), "cancelled after {late:?}");
            cancelled += 1;
            // It stays so.
            assert_eq!(session.earliest_toi(x0, x1), Err(Error::Cancelled));
            session.set_cancel_token(None);
            assert_eq!(contacts(&mut session, x0, x1), want);
        }
        assert_eq!(cancelled, 40);
    }
}

#[test]
fn a_cancelled_session_looks_for_no_intersections() {
    let step = crumpled_sheet(10, 1);
    let plain = Options::default();
    for options in [plain.clone().with_pipeline(ccd::method::Pipeline::TRIANGLES), plain] {
        let mut session = Session::new(&step.mesh, options).unwrap();
        session.intersections(&step.x0).unwrap();
        let token = CancelToken::new();
        session.set_cancel_token(token.clone());
        token.cancel();
        assert_eq!(session.has_intersections(&step.x0), Err(Error::Cancelled));
        assert_eq!(session.intersections(&step.x0).err(), Some(Error::Cancelled));
    }
}
