//! Scenes in other units and far from the origin, in windows whose ends are no `f32`: contacts are
//! what every pair by itself says, although filters calculate in `f32` of rounded positions.

use ccd::scenes::{particles_and_rods, triangle_soup};
use ccd::{Options, Session};
use ccd_testkit::brute::{check_pairs, every_pair};

#[test]
fn no_unit_and_no_place_loses_a_contact() {
    let mut total = 0;
    for seed in 0..4u32 {
        for (unit, offset) in [
            (1.0, 0.0),
            (1e-30, 0.0),
            (1.0, 1e8),
            (1e30, 1e31),
            (1e-9, 3.0),
            (1e-300, 0.0),
            (1e60, 0.0),
        ] {
            let step = match seed % 2 {
                0 => particles_and_rods(20, seed + 10),
                _ => triangle_soup(40, 0.4, seed + 10),
            };
            let place = |x: &[[f64; 3]]| -> Vec<[f64; 3]> {
                x.iter().map(|p| p.map(|c| c * unit + offset)).collect()
            };
            let (x0, x1) = (place(&step.x0), place(&step.x1));
            for (window, d) in [
                ([0.0, 1.0], 0.0),
                ([0.1, 0.7], 0.0),
                ([0.3, 0.3], 0.01),
                ([0.1, 1.0], 0.02),
                ([0.0, 1e-40], 0.03),
                ([0.0, 0.9], 1e-320),
            ] {
                for leaves in [false, true] {
                    let options = Options::default()
                        .with_threads(1)
                        .with_min_distance(d * unit)
                        .with_leave_contact(leaves);
                    let mut session = Session::new(&step.mesh, options.clone()).unwrap();
                    let found = session.step_window(&x0, &x1, window).unwrap().contacts.clone();
                    let what = format!("{seed}, {unit:e} at {offset:e}, {window:?} {d} {leaves}");
                    let want = every_pair(&step.mesh, [&x0, &x1], &options, window);
                    check_pairs(&what, &want, &found);
                    total += found.len();
                }
            }
        }
    }
    println!("{total} contacts");
    assert!(total > 2_000, "{total} contacts show little");
}
