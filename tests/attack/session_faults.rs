//! The failures that only a device has, provoked in a session that goes on afterwards.

use super::{Counts, Place};
use ccd::gpu::harness::{Faults, set_faults};
use ccd::gpu::{Error, Session};
use ccd_testkit::grazing::random::Random;

/// A filter that is refused, lists that are too short, or a driver that fails for a while; says
/// what was provoked, and whether the session answered as it should.
pub fn break_device(
    place: &Place,
    session: &mut Session,
    random: &mut Random,
    ends: [&[[f64; 3]]; 2],
    counts: &mut Counts,
) -> Result<(&'static str, bool), Error> {
    match random.below(4) {
        0 => Ok(("filter on a GPU", session.set_filter(|_, _, _| true).is_err())),
        1 => Ok(("short lists", session.reserve(1 + random.below(64) as u32).is_ok())),
        _ => fail_driver(place, session, random, ends, counts),
    }
}

/// A call in which the driver fails; half of them of a session whose searches were begun anew, with
/// so few rounds that pairs are left.
fn fail_driver(
    place: &Place,
    session: &mut Session,
    random: &mut Random,
    [x0, x1]: [&[[f64; 3]]; 2],
    counts: &mut Counts,
) -> Result<(&'static str, bool), Error> {
    let device = place.choice.device().ok_or(Error::NoBoxes)?;
    let short_rounds = random.below(2) == 0;
    let (skip, n) = (random.below(40) as u32, [1, 2, u32::MAX][random.below(3)]);
    let error = match random.below(3) {
        0 => Error::OutOfMemory { what: "provoked", bytes: 1 },
        1 => Error::TooLarge { what: "provoked", bytes: 2, limit: 1 },
        _ => Error::Refused { why: "provoked".into() },
    };
    if short_rounds {
        let entries = 1 + random.below(64) as u32;
        set_faults(device, Faults { short_rounds, ..Faults::default() });
        session.set_options(session.options().clone())?;
        session.reserve(entries)?;
    }
    let call = [0, 0, 0, 1, 2][random.below(5)];
    let provoked = Some(error.clone());
    set_faults(device, Faults { skip, n, error: provoked, short_rounds, ..Faults::default() });
    let done = match call {
        0 => session.step(x0, x1).map(|_| ()),
        1 => session.earliest_toi(x0, x1).map(|_| ()),
        _ => session.set_options(session.options().clone()),
    };
    let left = set_faults(device, Faults::default());
    counts.add("short rounds", short_rounds as u64);
    Ok(match done {
        Ok(()) if left.n == n => ("faults after a call", true),
        Ok(()) => ("faults without an error", true),
        Err(why) => ("faults", left.n < n && why.to_string() == error.to_string()),
    })
}
