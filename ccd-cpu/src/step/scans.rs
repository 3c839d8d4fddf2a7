//! Coordinates, checked in parts: bounds, and whether each number is an `f32`. Where it is known
//! which vertices are elsewhere than in the call before, the other parts are kept.

use crate::threads::Threads;
use ccd_core::backend::quantization::Scan;
use ccd_core::{Error, Real};
use std::ops::Range;

/// Vertices of a part.
const PART: usize = 512;

/// What is known of each part.
#[derive(Debug, Default)]
pub struct Scans {
    parts: Vec<Scan>,
    changed: Vec<(usize, Scan)>,
}

impl Scans {
    /// Checks positions at both ends: those of vertices in `runs` alone, if the others are known.
    ///
    /// # Errors
    /// [`Error::Coordinate`].
    pub fn check<T: Real>(
        &mut self,
        threads: &Threads,
        (x0, x1): (&[[T; 3]], &[[T; 3]]),
        runs: Option<&[Range<u32>]>,
    ) -> Result<Scan, Error> {
        let scan = |i: usize| {
            let mut scan = Scan::NONE;
            let part = i * PART..((i + 1) * PART).min(x0.len());
            scan.take_all(&x0[part.clone()], &x1[part]);
            scan
        };
        let Self { parts, changed } = self;
        if let Some(runs) = runs {
            changed.clear();
            for run in runs {
                let parts = run.start as usize / PART..(run.end as usize).div_ceil(PART);
                changed.extend(parts.map(|i| (i, Scan::NONE)));
            }
            changed.sort_unstable_by_key(|part| part.0);
            changed.dedup_by_key(|part| part.0);
            threads.each(changed, &|_, (i, slot)| *slot = scan(*i));
            changed.iter().for_each(|&(i, scan)| parts[i] = scan);
        } else {
            parts.resize(x0.len().div_ceil(PART), Scan::NONE);
            threads.each(parts, &|i, slot| *slot = scan(i));
        }
        let all = parts.iter().fold(Scan::NONE, |all, s| all.merged(s));
        all.check(x0, x1)?;
        Ok(all)
    }
}
