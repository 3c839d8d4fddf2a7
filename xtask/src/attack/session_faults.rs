//! The failures that only a device has, provoked in a session that goes on afterwards.

use super::Place;
use ccd::gpu::harness::{Faults, set_faults};
use ccd::gpu::{Error, Session};
use ccd_testkit::grazing::random::Random;

/// What was provoked.
pub struct Broken {
    pub what: &'static str,
    pub as_it_should: bool,
    /// Whether searches begin with so few rounds that pairs are left.
    pub short_rounds: bool,
}

/// A filter that is refused, lists that are too short, or a driver that fails for a while.
pub fn break_device(
    place: &Place,
    session: &mut Session,
    random: &mut Random,
    ends: [&[[f64; 3]]; 2],
    text: &mut String,
) -> Result<Broken, Error> {
    let (what, as_it_should) = match random.below(4) {
        0 => {
            *text += "assert!(session.set_filter(|_, _, _| true).is_err());\n";
            ("filter on a GPU", session.set_filter(|_, _, _| true).is_err())
        }
        1 => {
            let entries = 1 + random.below(64) as u32;
            *text += &format!("session.gpu().unwrap().reserve({entries}).unwrap();\n");
            ("short lists", session.reserve(entries).is_ok())
        }
        _ => return fail_driver(place, session, random, ends, text),
    };
    Ok(Broken { what, as_it_should, short_rounds: false })
}

/// A call in which the driver fails; half of them of a session whose searches were begun anew.
fn fail_driver(
    place: &Place,
    session: &mut Session,
    random: &mut Random,
    [x0, x1]: [&[[f64; 3]]; 2],
    text: &mut String,
) -> Result<Broken, Error> {
    let device = place.choice.device().ok_or(Error::NoBoxes)?;
    let short_rounds = random.below(2) == 0;
    let (skip, n) = (random.below(40) as u32, [1, 2, u32::MAX][random.below(3)]);
    let (error, error_code) = match random.below(3) {
        0 => (
            Error::OutOfMemory { what: "provoked", bytes: 1 },
            "OutOfMemory { what: \"provoked\", bytes: 1 }",
        ),
        1 => (
            Error::TooLarge { what: "provoked", bytes: 2, limit: 1 },
            "TooLarge { what: \"provoked\", bytes: 2, limit: 1 }",
        ),
        _ => (Error::Refused { why: "provoked".into() }, "Refused { why: \"provoked\".into() }"),
    };
    let of_harness = "use ccd::gpu::harness::{Faults, set_faults};";
    *text += "let device = choice.device().unwrap();\n";
    if short_rounds {
        let entries = 1 + random.below(64) as u32;
        *text += &format!(
            "{{\n{of_harness}\nset_faults(device, Faults {{ short_rounds: true, \
             ..Faults::default() }});\n}}\n\
             session.set_options(session.options().clone()).unwrap();\n\
             session.gpu().unwrap().reserve({entries}).unwrap();\n"
        );
        set_faults(device, Faults { short_rounds, ..Faults::default() });
        session.set_options(session.options().clone())?;
        session.reserve(entries)?;
    }
    let (call, code) = [
        (0, "step(&x0, &x1).map(|_| ())"),
        (1, "earliest_toi(&x0, &x1).map(|_| ())"),
        (2, "set_options(session.options().clone())"),
    ][[0, 0, 0, 1, 2][random.below(5)]];
    *text += &format!(
        "{{\n{of_harness}\nset_faults(device, Faults {{ skip: {skip}, n: {n}, error: \
         Some(ccd::gpu::Error::{error_code}), short_rounds: {short_rounds} }});\n\
         let failed = session.{code}.is_err();\n\
         let left = set_faults(device, Faults::default());\n\
         assert!(!failed || left.n < {n});\n}}\n"
    );
    set_faults(device, Faults { skip, n, error: Some(error.clone()), short_rounds });
    let done = match call {
        0 => session.step(x0, x1).map(|_| ()),
        1 => session.earliest_toi(x0, x1).map(|_| ()),
        _ => session.set_options(session.options().clone()),
    };
    let left = set_faults(device, Faults::default());
    let (what, as_it_should) = match done {
        Ok(()) if left.n == n => ("faults after a call", true),
        Ok(()) => ("faults without an error", true),
        Err(why) => ("faults", left.n < n && why.to_string() == error.to_string()),
    };
    Ok(Broken { what, as_it_should, short_rounds })
}
