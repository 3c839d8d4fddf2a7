//! What all members look for at once, and what they count.
//!
//! To look whether parts hold for positions takes a pass over all of them. So a step is begun as if
//! they were near those of the last step, and looked at while the devices work. Where that was
//! wrong, the step is forgotten and made again.

use super::member::{Asked, InGroup, Member};
use super::threads::each_alone;
use super::{Division, Engine};
use crate::{Kind, Report};
use ccd_core::model::precision::Given;

/// What is known of positions before members look for contacts.
#[derive(Clone, Copy)]
pub enum Known {
    /// They were looked at: parts hold for them.
    Looked,
    /// Those of the last step. How far these ones are from them is looked at while devices work.
    Guessed,
}

/// By this part of the greatest coordinate vertices may be beyond where they all were in the last
/// step, so that what was guessed of them holds.
const LEEWAY: f64 = 1.0 / 64.0;

impl<E: Member> Engine<E> {
    /// All parts at once. Returns whether parts hold for these positions; where they do not, or
    /// there are none yet, members have found nothing that counts.
    pub(super) fn each(
        &mut self,
        given: Given,
        ask: Asked,
        known: Known,
    ) -> Result<bool, E::Error> {
        let Self { division: Division::Parts(parts), members, threads, .. } = self else {
            return Ok(false);
        };
        let find = |(member, p): (&mut InGroup<E>, usize)| {
            let mut scan = match known {
                Known::Looked => parts.scans[p],
                Known::Guessed => parts.scans[p].widened(LEEWAY),
            };
            let (part, guess) = (&*parts.all[p], scan);
            let mut holds = || match known {
                Known::Looked => true,
                Known::Guessed => parts.look_at(p, threads, given).is_some_and(|found| {
                    scan = found;
                    guess.covers(&found)
                }),
            };
            let holds = member.find(given, (part, &guess), ask, &mut holds)?;
            Ok::<_, E::Error>(holds.then_some(scan))
        };
        let found = each_alone(members.iter_mut().zip(0..parts.all.len()), find);
        match found.into_iter().collect::<Result<Option<Vec<_>>, _>>()? {
            Some(scans) => parts.scans = scans,
            None => return Ok(false),
        }
        Ok(true)
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
