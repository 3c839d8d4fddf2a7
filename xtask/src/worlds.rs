//! The part `worlds` of `cargo xtask report --gpu`: many independent cloths in one call, with the
//! earliest time of each, beside calls of 16 of them and of one.

use crate::measure::{Place, median_of};
use ccd::any::{Error, Session};
use ccd::scenes::{copies, crumpled_sheet};
use ccd::{Bodies, Mesh, Options};
use std::fmt::Write as _;

/// Worlds in one call.
const ALL: usize = 4096;
/// Worlds in each of several calls.
const SOME: usize = 16;

/// Adds its table: these places.
pub fn measure(places: &[Place], runs: usize, text: &mut String) -> Result<(), Error> {
    let one = crumpled_sheet(12, 5);
    let _ = write!(
        text,
        "\n## Many worlds\n\nCopies of a cloth of {} edges, each a world of its own: \
         `Session::step` and `Report::toi_of_worlds`. Wall, in milliseconds, medians.\n\n\
         | place | one world | {SOME} worlds | {} calls of {SOME} | {ALL} worlds in one call | of \
         the calls |\n|---|---|---|---|---|---|\n",
        one.mesh.edges().len(),
        ALL / SOME
    );
    for place in places {
        let mut times = [0.0; 4];
        for (i, (n_worlds, calls)) in
            [(1, 1), (SOME, 1), (SOME, ALL / SOME), (ALL, 1)].into_iter().enumerate()
        {
            let (step, bodies) = copies(&one, n_worlds);
            let mut session = open(place, &step.mesh, bodies.clone())?;
            let (ms, ()) = median_of(runs, || -> Result<(), Error> {
                for _ in 0..calls {
                    let tois = session.step(&step.x0, &step.x1)?.toi_of_worlds(&bodies);
                    let right = tois.len() == n_worlds && tois.iter().all(|t| *t == tois[0]);
                    assert!(right && tois[0].is_some(), "times of worlds: {tois:?}");
                }
                Ok(())
            })?;
            times[i] = ms;
        }
        let [one, some, calls, all] = times;
        let name = place.name();
        let share = all / calls;
        let _ = writeln!(
            text,
            "| {name} | {one:.3} | {some:.3} | {calls:.1} | {all:.2} | {share:.2} |"
        );
    }
    Ok(())
}

fn open(place: &Place, mesh: &Mesh, bodies: Bodies) -> Result<Session, Error> {
    let options = Options::default().with_bodies(bodies).with_threads(place.threads());
    Session::new(&place.choice(), mesh.clone(), options)
}
