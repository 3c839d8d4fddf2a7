//! Sessions in which everything that can change changes between steps, in any order, with calls
//! that fail in between: after each change a session finds what a new one by brute force does.
//!
//! Bodies move by themselves in between, with all that a session keeps of them.
//!
//! A change is made of a number of its own, so that changes may be left out without others
//! becoming different ones. What a number stands for is decided in `session_steps.rs`: a case in a
//! file means the same for as long as the order of the draws stays.

use super::session_steps::State;
use super::{Counts, Place, fewest};
use ccd::gpu::harness::{Faults, set_faults};
use ccd_testkit::grazing::random::Random;
use serde::{Deserialize, Serialize};

/// Changes of a session, each with a step after it.
const CHANGES: usize = 24;

/// Numbers: of what a session is made, and of its changes.
#[derive(Clone, Serialize, Deserialize)]
pub struct Case {
    first: u64,
    changes: Vec<u64>,
}

impl super::Case for Case {
    const NAME: &str = "sessions";

    fn make(_: &Place, _: u64, mut random: Random, _: &mut Counts) -> Self {
        let first = random.bits();
        Self { first, changes: (0..CHANGES).map(|_| random.bits()).collect() }
    }

    fn check(&self, place: &Place, counts: &mut Counts) -> Result<(), String> {
        // Those of a run that ended in the middle.
        place.choice.device().map(|device| set_faults(device, Faults::default()));
        let mut state = State::new(place, self.first).map_err(|e| format!("an error: {e}"))?;
        counts.add("sessions", 1);
        for &change in &self.changes {
            let random = &mut Random::new(change);
            state.change(random, counts).map_err(|e| format!("an error: {e}"))?;
            counts.add("steps", 1);
            state.check(random, counts)?;
            state.check_bodies(random, counts)?;
        }
        Ok(())
    }

    fn shrunk(self, fails: &dyn Fn(&Self) -> bool) -> Self {
        let with_changes = |changes: &[u64]| Self { first: self.first, changes: changes.to_vec() };
        with_changes(&fewest(&self.changes, |changes| fails(&with_changes(changes))))
    }
}
