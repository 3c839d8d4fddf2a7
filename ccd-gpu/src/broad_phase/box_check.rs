//! Boxes on their way to the device: checked by the threads of the host that send them.
//!
//! Twin: none; a CPU reads boxes where they are.

use crate::staging::{Each, Items};
use ccd_core::math::aabb::GREATEST;
use ccd_core::model::error::check_boxes;
use ccd_core::{Aabb, Error};
use std::ops::Range;
use std::sync::atomic::AtomicUsize;
use std::sync::atomic::Ordering::Relaxed;

/// Boxes that are checked as they are written.
pub struct Checked<'a> {
    boxes: &'a [Aabb],
    /// The first box of the first part that was written and has a bad one; of none, their number.
    bad: AtomicUsize,
}

impl<'a> Checked<'a> {
    /// None of them is checked yet, but that they are not too many.
    pub fn new(boxes: &'a [Aabb]) -> Result<Self, Error> {
        let (count, limit) = (boxes.len() as u64, Error::MAX_ELEMENTS);
        if count > limit {
            return Err(Error::TooMany { element: "boxes", count, limit });
        }
        Ok(Self { boxes, bad: AtomicUsize::new(boxes.len()) })
    }

    /// Checks all of them.
    pub fn check_all(&self) -> Result<(), Error> {
        self.look(0..self.boxes.len());
        self.result()
    }

    /// The first bad box, by number, of those that were written.
    pub fn result(&self) -> Result<(), Error> {
        let first = self.bad.load(Relaxed);
        check_boxes(&self.boxes[first..], GREATEST as f64).map_err(|e| match e {
            Error::Box { at, axis, min, max } => Error::Box { at: first + at, axis, min, max },
            e => e,
        })
    }

    fn look(&self, numbers: Range<usize>) {
        // Without a way out of the loop, so that it is one of vectors. NaN fails.
        let mut fine = true;
        for b in &self.boxes[numbers.clone()] {
            for k in 0..3 {
                fine &= b.min[k] <= b.max[k];
                fine &= b.min[k] >= -GREATEST;
                fine &= b.max[k] <= GREATEST;
            }
        }
        if !fine {
            self.bad.fetch_min(numbers.start, Relaxed);
        }
    }
}

impl Items for Checked<'_> {
    fn size(&self) -> usize {
        size_of::<Aabb>()
    }

    fn write(&self, to: wgpu::WriteOnly<[u8]>, numbers: Range<usize>) {
        self.look(numbers.clone());
        Each(|i: usize| self.boxes[i]).write(to, numbers);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_bad_box_is_named_whichever_part_is_seen_first() {
        let mut boxes = vec![Aabb { min: [0.0; 3], max: [1.0; 3] }; 5000];
        let look = |boxes: &[Aabb]| {
            let checked = Checked::new(boxes).expect("few boxes");
            [4, 0, 2, 3, 1]
                .into_iter()
                .for_each(|part| checked.look(1000 * part..1000 * (part + 1)));
            let found = checked.result();
            assert_eq!(format!("{found:?}"), format!("{:?}", checked.check_all()));
            found
        };
        assert_eq!(look(&boxes), Ok(()));
        for (at, bad) in [(4321, f32::NAN), (3000, f32::INFINITY), (999, -1.0), (0, 2.0 * GREATEST)]
        {
            boxes[at].max[1] = bad;
            let found = look(&boxes);
            assert!(matches!(found, Err(Error::Box { at: named, axis: 1, .. }) if named == at));
        }
    }
}
