//! The unit of the coordinates decides nothing: a scene in any unit that is accepted has the
//! contacts that it has in the unit 1 on a CPU, also where `f32` has no such numbers.

use crate::rows::is_emulated;
use ccd::any::{Choice, Session};
use ccd::scenes::triangle_soup;
use ccd::{Coordinate, Kind, Options, Report, State};
use ccd_testkit::is_whole;
use std::collections::BTreeSet;

/// Exponents of units in `f64`: those at which something is rounded or scaled otherwise, then more.
const WIDE: [i32; 21] = [
    -330, -130, 0, 126, 127, 128, 330, -300, -200, -60, -20, 20, 29, 40, 100, 125, 129, 130, 160,
    200, 300,
];
/// The same in `f32`.
const NARROW: [i32; 16] =
    [-118, -60, 0, 28, 124, 126, 127, -100, -80, -30, 20, 30, 40, 60, 100, 120];
/// An emulated GPU has the first of them alone.
const FEW: usize = 7;

fn keys(report: &Report, sure: bool) -> BTreeSet<(Kind, u32, u32)> {
    let wanted = report.contacts.iter().filter(|c| !sure || c.state == State::Hit);
    wanted.map(|c| (c.kind, c.a, c.b)).collect()
}

/// A step in every unit: every contact of the unit 1 (on a GPU every certain one), hardly any
/// other, and the earliest time.
fn check_precision<T: Coordinate>(
    choice: &Choice,
    exponents: &[i32],
    min_distance: f64,
) -> Result<(), String> {
    let step = triangle_soup(150, 0.3, 5);
    let place = |x: &[[f64; 3]], unit: f64| -> Vec<[T; 3]> {
        x.iter().map(|p| p.map(|c| T::from_f64((c + 0.25) * unit))).collect()
    };
    let ends = |unit: f64| (place(&step.x0, unit), place(&step.x1, unit));
    let options = Options::default().with_threads(1);
    let (x0, x1) = ends(1.0);
    let want = ccd::step(&step.mesh, &x0, &x1, &options.clone().with_min_distance(min_distance));
    let want = want.map_err(|e| e.to_string())?;
    let (sure, all) = (keys(&want, choice.device().is_some()), keys(&want, false));
    assert!(sure.len() > 200, "{} contacts show nothing", sure.len());
    for &exponent in exponents {
        let unit = 2f64.powi(exponent);
        let options = options.clone().with_min_distance(min_distance * unit);
        let mut session =
            Session::new(choice, step.mesh.clone(), options).map_err(|e| e.to_string())?;
        let (x0, x1) = ends(unit);
        let got = keys(session.step(&x0, &x1).map_err(|e| e.to_string())?, false);
        let what = format!("2^{exponent}, distance {min_distance}");
        if let Some(missed) = sure.difference(&got).next() {
            return Err(format!("{what}: {} of {}, without {missed:?}", got.len(), sure.len()));
        }
        if got.len() > all.len() + all.len() / 50 {
            return Err(format!("{what}: {} contacts, {} in the unit 1", got.len(), all.len()));
        }
        let first = session.earliest_toi(&x0, &x1).map_err(|e| e.to_string())?;
        if first.zip(want.toi).is_none_or(|(a, b)| (a - b).abs() > 2e-6) {
            return Err(format!("{what}: earliest {first:?}, {:?} in the unit 1", want.toi));
        }
    }
    Ok(())
}

pub fn check(choice: &Choice) -> Result<(), String> {
    let few = is_emulated(choice) && !is_whole();
    let n = |all: usize| if few { FEW.min(all) } else { all };
    check_precision::<f64>(choice, &WIDE[..n(WIDE.len())], 0.0)?;
    check_precision::<f64>(choice, &WIDE[..n(WIDE.len())], 0.01)?;
    check_precision::<f32>(choice, &NARROW[..n(NARROW.len())], 0.0)?;
    check_precision::<f32>(choice, &NARROW[..1], 0.01)
}
