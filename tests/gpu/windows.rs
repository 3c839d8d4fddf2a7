//! What a step on a device looks for besides a distance: a window of time, contacts that are left,
//! a tolerance; against the CPU.

use crate::scenes::check_step;
use ccd::gpu::{Device, Session};
use ccd::{Approach, Contact, Mode, Options, State};
use ccd_testkit::{compare, generate};

pub const TESTS: crate::Tests = &[
    ("windows", check_windows),
    ("leaving", check_leaving),
    ("tolerances", check_tolerances),
    ("exact_mode", check_exact_mode),
];

/// Contacts of windows, in `f64` that is rounded on the device and in `f32`, with and without a
/// distance, between whole steps.
fn check_windows(device: &Device) {
    let step = generate::triangle_soup(150, 0.2, 11);
    let [y0, y1] = step.rounded();
    for options in [Options::default(), Options::default().with_min_distance(0.004)] {
        let mut gpu = Session::new(device, step.mesh.clone(), options.clone()).unwrap();
        let mut cpu = ccd::Session::new(step.mesh.clone(), options).unwrap();
        let mut n = 0;
        // The third window's ends are no f32.
        for window in [[0.0, 1.0], [0.25, 0.5], [0.1, 0.7], [0.0, 1.0], [0.75, 1.0]] {
            let want = cpu.step_window(&step.x0, &step.x1, window).unwrap().contacts.clone();
            let got = &gpu.step_window(&step.x0, &step.x1, window).unwrap().contacts;
            compare::agree(&want, got).unwrap_or_else(|e| panic!("f64 {window:?}: {e}"));
            let inside = |c: &Contact| c.toi >= window[0] && c.toi <= window[1];
            assert!(got.iter().all(inside), "{window:?}");
            n += want.len();
            let want = cpu.step_window(&y0, &y1, window).unwrap().contacts.clone();
            let got = &gpu.step_window(&y0, &y1, window).unwrap().contacts;
            compare::agree(&want, got).unwrap_or_else(|e| panic!("f32 {window:?}: {e}"));
        }
        assert!(n > 200, "{n} contacts show little");
        assert!(gpu.step_window(&y0, &y1, [0.5, 0.25]).is_err());
        let until = gpu.step_until(&y0, &y1, 0.5).unwrap().contacts.clone();
        let want = &cpu.step_until(&y0, &y1, 0.5).unwrap().contacts;
        compare::agree(want, &until).unwrap_or_else(|e| panic!("until 0.5: {e}"));
    }
}

/// Contacts at the start that are left, and what is known of those that are not.
fn check_leaving(device: &Device) {
    let step = generate::triangle_soup(150, 0.1, 12);
    let near = Options::default().with_min_distance(0.03);
    let leaves = near.clone().with_leave_contact(true);
    check_step(device, &step, leaves.clone());
    let contacts = |options: &Options| {
        let mut gpu = Session::new(device, step.mesh.clone(), options.clone()).unwrap();
        gpu.step(&step.x0, &step.x1).unwrap().contacts.clone()
    };
    let (stays, left) = (contacts(&near), contacts(&leaves));
    let known = |a: Approach| stays.iter().filter(|c| c.toi == 0.0 && c.approach == a).count();
    let (nears, parts) = (known(Approach::Approaching), known(Approach::Separating));
    assert!(nears > 5 && parts > 5, "{nears} approaching, {parts} separating show little");
    assert!(left.len() + 5 < stays.len(), "{} of {} are left", left.len(), stays.len());
    // What a device says for certain is not denied by the CPU.
    let cpu = ccd::step(&step.mesh, &step.x0, &step.x1, &near).unwrap();
    for (c, d) in cpu.contacts.iter().zip(&stays) {
        assert_eq!((c.kind, c.a, c.b), (d.kind, d.a, d.b));
        let both = [c.approach, d.approach];
        assert!(both[0] == both[1] || both.contains(&Approach::Unknown), "{c:?} {d:?}");
    }
}

/// What `f32` cannot tell as exactly goes on to `f64`.
fn check_tolerances(device: &Device) {
    let step = generate::triangle_soup(120, 0.3, 13);
    for d in [0.0, 0.003] {
        let options = Options::default().with_min_distance(d);
        let fine = options.clone().with_tolerance(1e-10);
        let want = ccd::step(&step.mesh, &step.x0, &step.x1, &fine).unwrap();
        let mut gpu = Session::new(device, step.mesh.clone(), fine).unwrap();
        let got = gpu.step(&step.x0, &step.x1).unwrap().contacts.clone();
        compare::agree(&want.contacts, &got).unwrap_or_else(|e| panic!("{e}"));
        for (c, d) in want.contacts.iter().zip(&got) {
            let certain = c.state == State::Hit && d.state == State::Hit;
            assert!(!certain || (c.toi - d.toi).abs() <= 2e-10, "{c:?} {d:?}");
        }
        assert!(want.contacts.len() > 20, "{} contacts show little", want.contacts.len());
        let earliest = gpu.earliest_toi(&step.x0, &step.x1).unwrap();
        let (earliest, want) = (earliest.unwrap(), want.toi.unwrap());
        assert!((earliest - want).abs() <= 2e-10, "{earliest} {want}");
        let size = gpu.collision_free_step_size(&step.x0, &step.x1).unwrap();
        assert_eq!(size, earliest);
    }
}

/// In exact mode the host finds the last digits of what a device decides, and decides what it does
/// not: the same bits as on the CPU alone.
fn check_exact_mode(device: &Device) {
    let mut resting = generate::triangle_soup(150, 0.2, 11);
    // On a lattice, and not all of it moves.
    for (i, (p, q)) in resting.x0.iter_mut().zip(&mut resting.x1).enumerate() {
        *p = p.map(|x| (x * 16.0).round() / 16.0);
        *q = if i % 3 == 0 { *p } else { q.map(|x| (x * 16.0).round() / 16.0) };
    }
    for step in [generate::triangle_soup(150, 0.2, 11), resting] {
        let [y0, y1] = step.rounded();
        let exact = Options::default().with_mode(Mode::Exact);
        let mut gpu = Session::new(device, step.mesh.clone(), exact.clone()).unwrap();
        let mut cpu = ccd::Session::new(step.mesh.clone(), exact).unwrap();
        let mut n = 0;
        for window in [[0.0, 1.0], [0.25, 0.5], [0.1, 0.7]] {
            let want = cpu.step_window(&step.x0, &step.x1, window).unwrap().contacts.clone();
            assert_eq!(gpu.step_window(&step.x0, &step.x1, window).unwrap().contacts, want);
            let want = cpu.step_window(&y0, &y1, window).unwrap().contacts.clone();
            let report = gpu.step_window(&y0, &y1, window).unwrap();
            assert_eq!((&report.contacts, report.undecided), (&want, 0));
            n += want.len();
        }
        assert!(n > 50, "{n} contacts show little");
        let want = cpu.earliest_toi(&step.x0, &step.x1).unwrap();
        assert!(want.is_some());
        assert_eq!(gpu.earliest_toi(&step.x0, &step.x1).unwrap(), want);
    }
}
