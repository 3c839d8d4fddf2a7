//! Sessions in which everything that can change changes between steps, in any order, with calls
//! that fail in between: after each change a session finds what a new one by brute force does.
//!
//! A change is made of a number of its own, so that changes may be left out without others
//! becoming different ones.

use super::session_steps::State;
use super::{Counts, Found, Place, caught, fewest};
use ccd::gpu::harness::{Faults, set_faults};
use ccd_testkit::grazing::random::Random;

/// Changes of a session, each with a step after it.
const CHANGES: usize = 24;

pub fn case(
    place: &Place,
    _number: u64,
    mut random: Random,
    counts: &mut Counts,
) -> Result<(), Found> {
    let first = random.bits();
    let changes: Vec<u64> = (0..CHANGES).map(|_| random.bits()).collect();
    let what = match run(place, first, &changes, counts) {
        Ok(()) => return Ok(()),
        Err((what, _)) => what,
    };
    let quiet = &mut Counts::default();
    let changes =
        fewest(&changes, |changes| run(place, first, changes, &mut Counts::default()).is_err());
    let (what, body) = run(place, first, &changes, quiet).err().unwrap_or((what, String::new()));
    Err(Found { what, code: place.code() + &body })
}

/// All changes one after the other; else what is wrong, and the calls until then.
fn run(
    place: &Place,
    first: u64,
    changes: &[u64],
    counts: &mut Counts,
) -> Result<(), (String, String)> {
    let mut text = String::new();
    // Those of a run that ended in the middle.
    place.choice.device().map(|device| set_faults(device, Faults::default()));
    let done = caught(|| {
        let mut state = State::new(place, first, &mut text)?;
        counts.add("sessions", 1);
        for change in changes {
            state.change(&mut Random::new(*change), counts, &mut text)?;
        }
        Ok(())
    });
    done.map_err(|what| (what, text))
}
