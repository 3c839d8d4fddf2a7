//! Limits that a caller sets, and what wants them: memory, a token that cancels, a step with a
//! thousand times the pairs of the one before; and one device for sessions of two threads.

use crate::emulated::is_thin;
use ccd::gpu::{Device, Error, Session};
use ccd::{CancelToken, Contact, Options};
use ccd_testkit::collapse::collapse;
use ccd_testkit::compare::agree;
use ccd_testkit::generate::crumpled_sheet;

pub const TESTS: crate::Tests = &[
    ("a_thousand_times_the_pairs", check_thousandfold),
    ("limit_of_memory", check_memory),
    ("cancelled", check_cancelled),
    ("two_threads", check_two_threads),
];

fn check_thousandfold(device: &Device) {
    let (mesh, [a, b, c]) = collapse(60);
    for limit in [None, Some(1 << 30)] {
        let options = Options::default().with_max_memory(limit);
        let mut session = Session::new(device, &mesh, options.clone()).unwrap();
        // Lists as short as those of a scene without pairs.
        session.reserve(16).unwrap();
        let mut before = 0;
        for (x0, x1) in [(&a, &b), (&b, &c), (&b, &a), (&b, &c)] {
            let mut fresh = Session::new(device, &mesh, options.clone()).unwrap();
            let want = fresh.step(x0, x1).unwrap();
            let found = session.step(x0, x1).unwrap();
            assert_eq!(found.contacts, want.contacts);
            assert_eq!((found.candidates, found.toi), (want.candidates, want.toi));
            let on_cpu = ccd::step(&mesh, x0, x1, &Options::default()).unwrap();
            agree(&on_cpu.contacts, &found.contacts).unwrap();
            assert_eq!(found.candidates, on_cpu.candidates);
            let n = found.candidates.total();
            if x1 == &c {
                assert!(n > 1000 * before && before > 0, "{n} after {before} show little");
            }
            before = n;
        }
        assert!(session.grown() > 0, "no list was too short");
    }
}

fn is_memory(e: &Error) -> bool {
    let Error::Input(ccd::Error::Memory { bytes, held, limit, .. }) = e else { return false };
    held + bytes > *limit
}

fn check_memory(device: &Device) {
    let (mesh, [a, b, c]) = collapse(120);
    let want = ccd::step(&mesh, &b, &c, &Options::default()).unwrap();
    let (mut new, mut step, mut found) = (0, 0, 0);
    let between = (0..20).map(|k| (1 << 20) + (k << 16));
    let few = ccd::step(&mesh, &a, &b, &Options::default()).unwrap();
    for limit in [1 << 10, 1 << 16].into_iter().chain(between).chain([1 << 27]) {
        let options = Options::default().with_max_memory(limit);
        let mut session = match Session::new(device, &mesh, options) {
            Ok(session) => session,
            Err(e) => {
                assert!(is_memory(&e), "{limit}: {e}");
                new += 1;
                continue;
            }
        };
        for _ in 0..2 {
            match session.step(&b, &c) {
                Ok(report) => {
                    agree(&want.contacts, &report.contacts).unwrap();
                    found += 1;
                }
                Err(e) => {
                    assert!(is_memory(&e), "{limit}: {e}");
                    step += 1;
                }
            }
            match session.step(&a, &b) {
                Ok(report) => agree(&few.contacts, &report.contacts).unwrap(),
                Err(e) => assert!(is_memory(&e) && limit < 1 << 24, "{limit}: {e}"),
            }
        }
        session.set_options(Options::default()).unwrap();
        agree(&want.contacts, &session.step(&b, &c).unwrap().contacts).unwrap();
    }
    println!("refused: {new} sessions, {step} steps; {found} steps found all");
    assert!(new > 0 && step > 0 && found > 0, "{new} {step} {found}");
    // Bodies that come and go do not use a limit up.
    let options = Options::default().with_max_memory(1 << 27);
    let mut session = Session::new(device, &mesh, options).unwrap();
    let body: Vec<u32> = (0..mesh.n_vertices() as u32).map(|v| v / 3).collect();
    for k in 0..200 {
        let bodies = ccd::Bodies::new(&body).with_self_contacts(k % 2 == 0);
        session.set_bodies(bodies).unwrap();
        if k % 50 == 0 {
            session.set_mesh(&mesh).unwrap();
            agree(&want.contacts, &session.step(&b, &c).unwrap().contacts).unwrap();
        }
    }
}

fn check_cancelled(device: &Device) {
    let step = crumpled_sheet(30, 5);
    let options = Options::default();
    let mut session = Session::new(device, &step.mesh, options.clone()).unwrap();
    let mut other = Session::new(device, &step.mesh, options).unwrap();
    for (x0, x1) in [(&step.x0, &step.x1), (&step.x1, &step.x0), (&step.x1, &step.x1)] {
        let token = CancelToken::new();
        session.set_cancel_token(token.clone());
        let want: Vec<Contact> = other.step(x0, x1).unwrap().contacts.clone();
        assert_eq!(session.step(x0, x1).unwrap().contacts, want);
        token.cancel();
        let is_cancelled = |e: Error| matches!(e, Error::Input(ccd::Error::Cancelled));
        // Of other positions than those of the step that follows.
        assert!(session.step(x1, x0).is_err_and(is_cancelled));
        assert!(session.earliest_toi(x0, x1).is_err_and(is_cancelled));
        assert!(session.candidates(x0, x1).is_err_and(is_cancelled));
        session.set_cancel_token(None);
        assert_eq!(session.step(x0, x1).unwrap().contacts, want);
    }
}

/// Sessions of their own on one device, stepped by two threads at once.
fn check_two_threads(device: &Device) {
    let scenes = [crumpled_sheet(30, 3), crumpled_sheet(24, 4)];
    std::thread::scope(|scope| {
        for step in &scenes {
            scope.spawn(move || {
                let options = Options::default();
                let mut alone = ccd::Session::new(&step.mesh, options.clone()).unwrap();
                let mut session = Session::new(device, &step.mesh, options).unwrap();
                for k in 0..if is_thin(device) { 5 } else { 12 } {
                    let ends = [&step.x0, &step.x1];
                    let (x0, x1) = (ends[k % 2], ends[(k + 1) % 2]);
                    if k % 4 == 0 {
                        // Lists grow on both.
                        session.reserve(8).unwrap();
                    }
                    let want = alone.step(x0, x1).unwrap();
                    let found = session.step(x0, x1).unwrap();
                    agree(&want.contacts, &found.contacts).unwrap();
                    assert_eq!(found.candidates, want.candidates, "step {k}");
                    let earliest = session.earliest_toi(x0, x1).unwrap();
                    let least = alone.step(x0, x1).unwrap().toi;
                    assert_eq!(earliest.is_some(), least.is_some(), "step {k}");
                }
            });
        }
    });
}
