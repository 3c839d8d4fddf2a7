//! What all members look for at once, and what they count.
//!
//! To look whether parts hold for positions takes a pass over all of them. So a step begins with a
//! guess at what they say, and the pass runs while the devices work. Where the guess was wrong, the
//! step is forgotten and made again, and the next ones are looked at before they begin.

use super::member::{Asked, InGroup, Member};
use super::threads::each_alone;
use super::{Division, Engine};
use crate::{Kind, Report};
use ccd_core::backend::quantization::Scan;
use ccd_core::model::precision::Given;

/// Steps without a guess after one that was wrong.
const NO_GUESS: u32 = 8;

impl<E: Member> Engine<E> {
    /// A step of all parts that begins with a guess. False if there is none, or if it was wrong:
    /// members have found nothing that counts then.
    pub(super) fn find_by_guess(&mut self, given: Given, ask: Asked) -> Result<bool, E::Error> {
        let Division::Parts(parts) = &mut self.division else { return Ok(false) };
        let Some(mut guess) = parts.guess(given) else { return Ok(false) };
        let (parts, threads) = (&*parts, &self.threads);
        let find = |(member, (p, scan)): (&mut InGroup<E>, (usize, &mut Scan))| {
            let guessed = *scan;
            let holds = || {
                let (found, holds) = parts.look_at(p, threads, given);
                *scan = found;
                holds && guessed.covers(&found)
            };
            member.find(given, (&parts.all[p], &guessed), ask, holds)
        };
        let scans = guess.scans.iter_mut().enumerate();
        let found = each_alone(self.members.iter_mut().zip(scans), find);
        let Division::Parts(parts) = &mut self.division else { return Ok(false) };
        // An error may be due to parts that do not hold.
        if found.iter().any(|held| matches!(held, Ok(false))) {
            parts.no_guess = NO_GUESS;
            return Ok(false);
        }
        found.into_iter().collect::<Result<Vec<_>, _>>()?;
        parts.last = guess;
        Ok(true)
    }

    /// All parts at once, whose positions were looked at.
    pub(super) fn find_each(&mut self, given: Given, ask: Asked) -> Result<(), E::Error> {
        let Division::Parts(parts) = &self.division else { return Ok(()) };
        let find = |(member, (part, scan)): (&mut InGroup<E>, _)| {
            member.find(given, (part, scan), ask, || true).map(|_| ())
        };
        let parts = parts.all.iter().map(|part| &**part).zip(&parts.last.scans);
        each_alone(self.members.iter_mut().zip(parts), find).into_iter().collect()
    }
}

/// Adds what a member counted, and the times of the slowest.
pub fn add(all: &mut Report, of: &Report) {
    all.toi = all.toi.into_iter().chain(of.toi).reduce(f64::min);
    for kind in Kind::ALL {
        let mut candidates = of.candidates;
        let mut filtered = of.filtered;
        *all.candidates.of(kind) += *candidates.of(kind);
        *all.filtered.of(kind) += *filtered.of(kind);
    }
    all.triangles = match (all.triangles, of.triangles) {
        (Some(a), Some(b)) => Some(a.plus(b)),
        (a, b) => a.or(b),
    };
    all.front = match (all.front, of.front) {
        (Some(a), Some(b)) => Some(a.plus(b)),
        (a, b) => a.or(b),
    };
    all.rebuilt |= of.rebuilt;
    let (most, of) = (&mut all.times, &of.times);
    most.boxes = most.boxes.max(of.boxes);
    most.build = most.build.max(of.build);
    most.traverse = most.traverse.max(of.traverse);
    most.narrow = most.narrow.max(of.narrow);
}
