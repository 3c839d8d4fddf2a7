//! Steps in flight: sessions whose steps are under way at the same time find what blocking calls
//! find; one that is dropped, or fails late as in a browser, leaves a session that finds what a new
//! one does.

use ccd::gpu::harness::{Faults, set_faults};
use ccd::gpu::{BroadPhase, Device, Error, Session};
use ccd::method::{BroadPhaseMethod, Front, Pipeline, Scheduling, TriangleOptions};
use ccd::scenes::{Step, crumpled_sheet};
use ccd::{Aabb, CancelToken, Contact, Options};
use ccd_testkit::generate::uniform_boxes;
use std::pin::pin;
use std::task::{Context, Poll, Waker};

pub const TESTS: crate::Tests = &[
    ("two_in_flight", check_two),
    ("submitted_and_polled", check_polled),
    ("replaced_in_flight", check_replaced),
    ("dropped_in_flight", check_dropped),
    ("boxes_in_flight", check_boxes),
    ("late_failures", check_late),
];

fn session(device: &Device, step: &Step, options: &Options) -> Session {
    let mut session = Session::new(device, step.mesh.clone(), options.clone()).expect("a session");
    // So short that the work is submitted again.
    session.reserve(8).expect("lists");
    session
}

/// What blocking calls of a new session find.
fn right(device: &Device, step: &Step, options: &Options) -> (Vec<Contact>, Option<f64>) {
    let mut session = Session::new(device, step.mesh.clone(), options.clone()).expect("a session");
    let toi = session.earliest_toi(&step.x0, &step.x1).expect("a time");
    let contacts = session.step(&step.x0, &step.x1).expect("contacts").contacts.clone();
    assert!(contacts.len() > 100 && toi.is_some(), "{} contacts", contacts.len());
    (contacts, toi)
}

fn is_send<T: Send>(future: T) -> T {
    future
}

/// Futures of two sessions on one device, polled in turn.
fn check_two(device: &Device) {
    let steps = [crumpled_sheet(24, 7), crumpled_sheet(17, 3)];
    let options = Options::default();
    let [want_a, want_b] = steps.each_ref().map(|step| right(device, step, &options));
    assert!(want_a != want_b, "both are the same");
    let [mut a, mut b] = steps.each_ref().map(|step| session(device, step, &options));
    let [step_a, step_b] = &steps;
    let context = &mut Context::from_waker(Waker::noop());
    // Whether they were asked again while both were in flight, which a busy host may miss.
    let mut are_both = false;
    for round in 0..100 {
        if round > 2 && are_both {
            break;
        }
        let mut n_asked = 0;
        let mut of_a = pin!(is_send(a.step_async(&step_a.x0, &step_a.x1)));
        let mut of_b = pin!(is_send(b.earliest_toi_async(&step_b.x0, &step_b.x1)));
        let (mut got_a, mut got_b) = (None, None);
        while got_a.is_none() || got_b.is_none() {
            are_both |= n_asked > 0 && got_a.is_none() && got_b.is_none();
            n_asked += 1;
            if got_a.is_none()
                && let Poll::Ready(report) = of_a.as_mut().poll(context)
            {
                got_a = Some(report.expect("contacts").contacts.clone());
            }
            if got_b.is_none()
                && let Poll::Ready(toi) = of_b.as_mut().poll(context)
            {
                got_b = Some(toi.expect("a time"));
            }
            std::thread::yield_now();
        }
        assert!(got_a.as_ref() == Some(&want_a.0), "{round}: other contacts");
        assert_eq!(got_b, Some(want_b.1), "{round}: another time");
    }
    assert!(are_both, "they were never in flight together");
    assert!(a.grown() > 0, "no list grew");
}

/// Waits by polling.
fn report(session: &mut Session) -> Result<Vec<Contact>, Error> {
    loop {
        if let Some(report) = session.poll()? {
            return Ok(report.contacts.clone());
        }
        std::thread::yield_now();
    }
}

/// A step takes the place of one that is still on the device: its results are read when it is done,
/// not when the first is.
fn check_replaced(device: &Device) {
    let step = crumpled_sheet(64, 7);
    let mut session = session(device, &step, &Options::default());
    let still = session.step(&step.x1, &step.x1).expect("contacts").contacts.clone();
    let moved = session.step(&step.x0, &step.x1).expect("contacts").contacts.clone();
    assert!(moved.len() > still.len() + 100, "{} and {}", moved.len(), still.len());
    for round in 0..4 {
        session.submit(&step.x0, &step.x1).expect("submitted");
        session.submit(&step.x1, &step.x1).expect("submitted");
        let found = report(&mut session).expect("contacts");
        assert!(found == still, "{round}: {} of {}", found.len(), still.len());
    }
    // A change that is refused does not end a step in flight.
    session.submit(&step.x0, &step.x1).expect("submitted");
    assert!(session.set_filter(|_, _, _| true).is_err());
    assert!(report(&mut session).expect("contacts") == moved);
}

/// As a frame loop does it; with positions in `f32`, which are gone before the end of the step.
fn check_polled(device: &Device) {
    let step = crumpled_sheet(24, 7);
    let options = Options::default();
    let want = right(device, &step, &options);
    let mut session = session(device, &step, &options);
    assert!(matches!(session.poll(), Err(Error::NotSubmitted)), "nothing was submitted");
    let narrow =
        |x: &[[f64; 3]]| -> Vec<[f32; 3]> { x.iter().map(|p| p.map(|c| c as f32)).collect() };
    let want_narrow =
        session.step(&narrow(&step.x0), &narrow(&step.x1)).expect("contacts").contacts.clone();
    session.submit(&narrow(&step.x0), &narrow(&step.x1)).expect("submitted");
    assert!(session.is_in_flight());
    assert!(session.report().contacts.is_empty(), "a report of what is in flight");
    assert!(report(&mut session).expect("contacts") == want_narrow, "of positions that are gone");
    assert!(!session.is_in_flight() && matches!(session.poll(), Err(Error::NotSubmitted)));
    // A second one takes the place of the first, and so does a call that blocks.
    session.submit(&step.x1, &step.x1).expect("submitted");
    session.submit(&step.x0, &step.x1).expect("submitted");
    assert!(report(&mut session).expect("contacts") == want.0, "of the second");
    session.submit(&step.x0, &step.x1).expect("submitted");
    assert_eq!(session.earliest_toi(&step.x0, &step.x1).expect("a time"), want.1);
    assert!(matches!(session.poll(), Err(Error::NotSubmitted)), "it is still in flight");
    session.submit_earliest_toi(&step.x0, &step.x1).expect("submitted");
    assert!(report(&mut session).expect("no list").is_empty());
    assert_eq!(session.report().toi, want.1);
    // Changes end it, errors do.
    session.submit(&step.x0, &step.x1).expect("submitted");
    session.set_min_distance(1e-3).expect("a distance");
    assert!(!session.is_in_flight(), "a step by other options");
    session.set_min_distance(0.0).expect("a distance");
    session.submit(&step.x0, &step.x1).expect("submitted");
    assert!(session.submit(&step.x0[1..], &step.x1).is_err() && !session.is_in_flight());
    let token = CancelToken::new();
    token.cancel();
    session.set_cancel_token(token);
    let cancelled = session.submit(&step.x0, &step.x1).expect_err("a cancelled call");
    assert!(matches!(cancelled, Error::Input(ccd::Error::Cancelled)), "{cancelled}");
    session.set_cancel_token(None);
    assert!(session.step(&step.x0, &step.x1).expect("contacts").contacts == want.0);
}

/// Options by which sources of pairs remember something from step to step, and others.
fn options() -> [Options; 3] {
    let schedulings: Vec<Scheduling> = Scheduling::every("gpu").collect();
    let with_front = schedulings.iter().find(|s| s.front != Front::default());
    let front = with_front.copied().unwrap_or_default();
    let triangles = Pipeline::Triangles(TriangleOptions::default());
    [
        Options::default(),
        Options::default().with_scheduling(front),
        Options::default().with_pipeline(triangles),
    ]
}

/// Futures that are dropped after so many polls, then calls of the same session.
fn check_dropped(device: &Device) {
    let step = crumpled_sheet(24, 7);
    let context = &mut Context::from_waker(Waker::noop());
    for options in options() {
        let want = right(device, &step, &options);
        let what = format!("{}, {:?}", options.scheduling, options.pipeline);
        let mut session = session(device, &step, &options);
        let (mut n_dropped, mut n_grown) = (0, 0);
        for polls in [1, 2, 1, 3, 1, 5, 8] {
            {
                let mut future = pin!(session.step_async(&step.x1, &step.x0));
                let mut polled = Poll::Pending;
                for _ in 0..polls {
                    if polled.is_pending() {
                        polled = future.as_mut().poll(context).map(|done| done.is_ok());
                        // So that the second poll finds results.
                        device.wgpu().poll(ccd::gpu::wgpu::PollType::wait_indefinitely()).unwrap();
                    }
                }
                n_dropped += polled.is_pending() as u32;
            }
            if n_grown == session.grown() {
                assert!(matches!(session.poll(), Err(Error::NotSubmitted)), "{what}: in flight");
            }
            n_grown = session.grown();
            let toi = session.earliest_toi(&step.x0, &step.x1).expect(&what);
            assert_eq!(toi, want.1, "{what}: after {polls} polls");
            let found = session.step(&step.x0, &step.x1).expect(&what);
            assert!(found.contacts == want.0, "{what}: after {polls} polls, other contacts");
        }
        // A GPU may be done before the poll that began the step has encoded the next.
        if device.info().adapter.device_type == ccd::gpu::wgpu::DeviceType::Cpu {
            assert!(n_dropped >= 3, "{what}: {n_dropped} were in flight");
        }
        // Candidates have two readings.
        let mut futures = pin!(session.candidates_async(&step.x0, &step.x1));
        assert!(futures.as_mut().poll(context).is_pending());
    }
}

/// Boxes by themselves.
fn check_boxes(device: &Device) {
    let boxes: Vec<Aabb> = uniform_boxes(3000).iter().map(|b| b.inflated(0.05)).collect();
    let context = &mut Context::from_waker(Waker::noop());
    let mut broad = BroadPhase::new(device, BroadPhaseMethod::default()).expect("a broad phase");
    let want = broad.self_pairs(&boxes).expect("pairs").len();
    let want_fewer = broad.self_pairs(&boxes[..1000]).expect("pairs").len();
    assert!(want > want_fewer && want_fewer > 0, "{want_fewer} of {want} pairs");
    assert!(pin!(broad.self_pairs_async(&boxes)).poll(context).is_pending());
    assert_eq!(broad.self_pairs(&boxes[..1000]).expect("pairs").len(), want_fewer);
    let mut future = pin!(is_send(broad.self_pairs_async(&boxes)));
    let found = loop {
        if let Poll::Ready(found) = future.as_mut().poll(context) {
            break found.expect("pairs");
        }
    };
    assert_eq!(found.len(), want);
}

/// Commands that fail and seem to succeed, as in a browser: whoever waits for results gets the
/// error, and the next call makes new buffers.
fn check_late(device: &Device) {
    let step = crumpled_sheet(17, 3);
    let options = Options::default();
    let want = right(device, &step, &options);
    let mut n_failed = 0;
    let mut session = session(device, &step, &options);
    for (turn, skip) in [20, 0, 1, 2, 3, 4, 1000].into_iter().chain(0..16).enumerate() {
        if turn >= 7 {
            // Whatever encodes the next frames has to go on with the device of the change.
            session.set_mesh(step.mesh.clone()).expect("the same mesh");
            session.step(&step.x0, &step.x1).expect("contacts");
        }
        let error = Error::OutOfMemory { what: "test", bytes: skip as u64 };
        let faults =
            Faults { skip, n: 1, error: Some(error.clone()), late: true, ..Faults::default() };
        let old = set_faults(device, faults);
        let got = session.step(&step.x0, &step.x1).map(|report| report.contacts.clone());
        let left = set_faults(device, old);
        match got {
            Ok(contacts) => {
                assert!(contacts == want.0 && left.n == 1, "{skip}: nothing was said")
            }
            Err(why) => {
                n_failed += 1;
                assert_eq!(why.to_string(), error.to_string(), "{skip}");
                assert!(session.report().contacts.is_empty(), "{skip}: a report");
            }
        }
        let before = session.paths().clone();
        let found = session.step(&step.x0, &step.x1).expect("contacts");
        assert!(found.contacts == want.0, "{skip}: other contacts");
        assert_eq!(before != *session.paths(), left.n == 0, "{skip}: the same buffers");
    }
    assert!(n_failed >= 8, "{n_failed} failed");
}
