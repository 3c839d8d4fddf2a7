//! The unit of the coordinates decides nothing on a device either: also where `f32` has no such
//! numbers.

use ccd::gpu::{Device, Session};
use ccd::{Contact, Coordinate, Kind, Options, State};
use ccd_testkit::generate;
use std::collections::BTreeSet;

/// Tests of sessions.
pub const TESTS: crate::Tests = &[("units", check_units)];

type Keys = BTreeSet<(Kind, u32, u32)>;

fn keys<'a>(contacts: impl Iterator<Item = &'a Contact>) -> Keys {
    contacts.map(|c| (c.kind, c.a, c.b)).collect()
}

/// A step on the device has the candidates of the CPU, every certain contact of it, and its
/// earliest time.
fn check_scale<T: Coordinate>(device: &Device, scale: f64, min_distance: f64) {
    let step = generate::triangle_soup(150, 0.3, 5);
    let at = |x: &[[f64; 3]]| -> Vec<[T; 3]> {
        x.iter().map(|p| p.map(|c| T::from_f64((c + 0.25) * scale))).collect()
    };
    let (x0, x1) = (at(&step.x0), at(&step.x1));
    let options = Options::default().with_min_distance(min_distance * scale).with_threads(1);
    let mut cpu = ccd::Session::new(step.mesh.clone(), options.clone()).expect("a session");
    let mut gpu = Session::new(device, step.mesh.clone(), options).expect("a session");
    let want = cpu.step(&x0, &x1).expect("a step").clone();
    let got = gpu.step(&x0, &x1).expect("a step").clone();
    let what = format!("scale {scale:e}, distance {min_distance}");
    let sure = |c: &&Contact| c.state == State::Hit;
    let (want_keys, got_keys) =
        (keys(want.contacts.iter().filter(sure)), keys(got.contacts.iter()));
    assert!(want_keys.len() > 100, "{what}: {} contacts show nothing", want_keys.len());
    let missed: Vec<_> = want_keys.difference(&got_keys).collect();
    assert!(missed.is_empty(), "{what}: {} missed, {:?} ..", missed.len(), missed.first());
    assert!(
        got_keys.len() <= keys(want.contacts.iter()).len() + 2,
        "{what}: {} contacts",
        got_keys.len()
    );
    let (a, b) = (
        want.toi.expect("a contact"),
        gpu.earliest_toi(&x0, &x1).expect("a step").expect("a contact"),
    );
    assert!((a - b).abs() < 2e-6, "{what}: earliest {b}, {a} on the CPU");
}

fn check_units(device: &Device) {
    for min_distance in [0.0, 0.01] {
        for e in [-200, -130, -60, 0, 29, 60, 100, 126, 127, 128, 130, 200, 300] {
            check_scale::<f64>(device, 2f64.powi(e), min_distance);
        }
    }
    for e in [-60, 0, 28, 40, 100, 124] {
        check_scale::<f32>(device, 2f64.powi(e), 0.0);
    }
}
