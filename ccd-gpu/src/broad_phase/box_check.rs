//! Boxes on their way to the device: checked by several threads of the host.
//!
//! Twin: none; a CPU reads boxes where they are.

use crate::threads;
use ccd_core::math::aabb::GREATEST;
use ccd_core::model::error::check_boxes;
use ccd_core::{Aabb, Error};

/// Boxes that are worth another thread.
const SHARE: usize = 1 << 14;

/// Checks bounds and number of boxes.
pub fn check(boxes: &[Aabb]) -> Result<(), Error> {
    let (count, limit) = (boxes.len() as u64, Error::MAX_ELEMENTS);
    if count > limit {
        return Err(Error::TooMany { element: "boxes", count, limit });
    }
    let mut checked = vec![Ok(()); boxes.len().div_ceil(SHARE)];
    threads::copy(boxes.chunks(SHARE).zip(&mut checked), |(part, checked)| {
        *checked = check_boxes(part, GREATEST as f64);
    });
    // The first by number, whichever thread was first.
    for (first, result) in (0..).step_by(SHARE).zip(checked) {
        result.map_err(|e| match e {
            Error::Box { at, axis, min, max } => Error::Box { at: first + at, axis, min, max },
            e => e,
        })?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_bad_box_is_named_whichever_thread_sees_it() {
        let mut boxes = vec![Aabb { min: [0.0; 3], max: [1.0; 3] }; 5 * SHARE];
        assert_eq!(check(&boxes), Ok(()));
        for at in [4 * SHARE + 7, 3 * SHARE, SHARE - 1] {
            boxes[at].max[1] = f32::NAN;
            let Err(Error::Box { at: named, axis: 1, .. }) = check(&boxes) else {
                panic!("{:?}", check(&boxes))
            };
            assert_eq!(named, at);
        }
    }
}
