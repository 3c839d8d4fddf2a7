//! The unit of the coordinates decides nothing: a scene in any unit that is accepted has the
//! contacts that it has at scale 1.

use ccd_core::model::contact::Contact;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use ccd_core::{Coordinate, Real};
use ccd_cpu::Session;

/// Triangles that fly through each other, around a point that is not the origin.
fn soup(n: usize) -> (Mesh, Vec<[f64; 3]>, Vec<[f64; 3]>) {
    let mut state = 11u32;
    let mut unit = || {
        state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        (state >> 8) as f64 / 16_777_216.0
    };
    let mut near = |centre: [f64; 3], size: f64| centre.map(|c| c + size * (unit() - 0.5));
    let (mut x0, mut x1) = (Vec::new(), Vec::new());
    for _ in 0..n {
        let (from, to) = (near([0.25; 3], 1.0), near([0.25; 3], 1.0));
        for _ in 0..3 {
            x0.push(near(from, 0.3));
            x1.push(near(to, 0.3));
        }
    }
    let faces: Vec<[u32; 3]> = (0..n as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    (Mesh::new(3 * n, &faces).expect("a mesh"), x0, x1)
}

fn scaled<R: Real>(x: &[[f64; 3]], scale: f64) -> Vec<[R; 3]> {
    x.iter().map(|p| p.map(|c| R::from_f64(c * scale))).collect()
}

type Key = (ccd_core::model::contact::Kind, u32, u32);

fn keys(contacts: &[Contact]) -> Vec<Key> {
    contacts.iter().map(|c| (c.kind, c.a, c.b)).collect()
}

/// Contacts at `scale`, and the earliest time, must be those at scale 1; contacts that only a
/// coarser arithmetic leaves open may come in addition.
fn check_scale<R: Coordinate>(scale: f64, min_distance: f64, want: &[Key], want_toi: f64) {
    let (mesh, x0, x1) = soup(60);
    let options = Options::default().with_threads(1).with_min_distance(min_distance * scale);
    let mut session = Session::new(mesh, options).expect("a session");
    let (x0, x1) = (scaled::<R>(&x0, scale), scaled::<R>(&x1, scale));
    let got = keys(&session.step(&x0, &x1).expect("a step").contacts);
    for key in want {
        assert!(
            got.contains(key),
            "scale {scale:e}: {key:?} is missed; {} of {} found",
            got.len(),
            want.len()
        );
    }
    assert!(
        got.len() <= want.len() + want.len() / 50,
        "scale {scale:e}: {} contacts, {} at scale 1",
        got.len(),
        want.len()
    );
    let toi = session.earliest_toi(&x0, &x1).expect("a step").expect("a contact");
    assert!(
        (toi - want_toi).abs() <= 2e-6,
        "scale {scale:e}: earliest {toi}, {want_toi} at scale 1"
    );
}

#[test]
fn contacts_do_not_depend_on_the_unit() {
    for min_distance in [0.0, 0.01] {
        let (mesh, x0, x1) = soup(60);
        let options = Options::default().with_threads(1).with_min_distance(min_distance);
        let mut session = Session::new(mesh, options).expect("a session");
        let want = keys(&session.step(&x0, &x1).expect("a step").contacts);
        let toi = session.earliest_toi(&x0, &x1).expect("a step").expect("a contact");
        assert!(want.len() > 200, "{} contacts show nothing", want.len());
        for e in [
            -330, -300, -200, -130, -60, -20, 0, 20, 40, 100, 120, 125, 126, 127, 128, 129, 130,
            160, 200, 300, 330,
        ] {
            check_scale::<f64>(2f64.powi(e), min_distance, &want, toi);
        }
    }
}

#[test]
fn contacts_in_f32_do_not_depend_on_the_unit() {
    let (mesh, x0, x1) = soup(60);
    let mut session = Session::new(mesh, Options::default().with_threads(1)).expect("a session");
    let (y0, y1) = (scaled::<f32>(&x0, 1.0), scaled::<f32>(&x1, 1.0));
    let want = keys(&session.step(&y0, &y1).expect("a step").contacts);
    let toi = session.earliest_toi(&y0, &y1).expect("a step").expect("a contact");
    for e in [-100, -60, -30, 0, 20, 28, 30, 40, 60, 100, 120, 126, 127] {
        check_scale::<f32>(2f64.powi(e), 0.0, &want, toi);
    }
}
