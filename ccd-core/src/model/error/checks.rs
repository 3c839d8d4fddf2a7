//! Checks of numbers that callers give.

use super::Error;
use crate::narrow_phase::query::LEAST_TOLERANCE;

/// Checks that every coordinate is finite and at most [`Error::MAX_COORDINATE`].
///
/// # Errors
/// [`Error::Coordinate`] with the first one that is not.
pub fn check_coordinates<R: crate::Real>(time: u8, x: &[[R; 3]]) -> Result<(), Error> {
    for (vertex, p) in x.iter().enumerate() {
        for (axis, c) in p.iter().enumerate() {
            let value = c.to_f64();
            // Written so that NaN fails.
            let fine = value <= Error::MAX_COORDINATE && value >= -Error::MAX_COORDINATE;
            if !fine {
                return Err(Error::Coordinate { time, vertex, axis: axis as u8, value });
            }
        }
    }
    Ok(())
}

/// Checks that boxes have bounds in order, each at most `greatest` in size, and that their ids are
/// 31 bits.
///
/// # Errors
/// [`Error::TooMany`] and [`Error::Box`].
pub fn check_boxes<R: crate::Real>(boxes: &[crate::Aabb<R>], greatest: f64) -> Result<(), Error> {
    let (count, limit) = (boxes.len() as u64, Error::MAX_ELEMENTS);
    if count > limit {
        return Err(Error::TooMany { element: "boxes", count, limit });
    }
    for (at, b) in boxes.iter().enumerate() {
        for axis in 0..3 {
            let (min, max) = (b.min[axis].to_f64(), b.max[axis].to_f64());
            // Written so that NaN fails.
            let fine = min <= max && min >= -greatest && max <= greatest;
            if !fine {
                return Err(Error::Box { at, axis: axis as u8, min, max });
            }
        }
    }
    Ok(())
}

/// Checks a minimum distance.
///
/// # Errors
/// [`Error::MinDistance`] unless it is from 0 to [`Error::MAX_COORDINATE`].
pub fn check_min_distance(value: f64) -> Result<(), Error> {
    if value >= 0.0 && value <= Error::MAX_COORDINATE {
        Ok(())
    } else {
        Err(Error::MinDistance { value })
    }
}

/// Checks a tolerance of times of impact.
///
/// # Errors
/// [`Error::Tolerance`] unless it is from [`LEAST_TOLERANCE`] to 1.
pub fn check_tolerance(value: f64) -> Result<(), Error> {
    // Written so that NaN fails.
    let fine = value >= LEAST_TOLERANCE && value <= 1.0;
    if fine { Ok(()) } else { Err(Error::Tolerance { value }) }
}

/// Checks the first and the last time of a window of a step.
///
/// # Errors
/// [`Error::Window`] unless `0 <= from <= until <= 1`.
pub fn check_window([from, until]: [f64; 2]) -> Result<(), Error> {
    // Written so that NaN fails.
    let fine = from >= 0.0 && from <= until && until <= 1.0;
    if fine { Ok(()) } else { Err(Error::Window { from, until }) }
}

/// Checks a setting that must be from `least` to `greatest`.
///
/// # Errors
/// [`Error::Setting`].
pub fn check_setting(
    name: &'static str,
    value: u32,
    least: u32,
    greatest: u32,
) -> Result<(), Error> {
    if (least..=greatest).contains(&value) {
        Ok(())
    } else {
        let [value, least, greatest] = [value, least, greatest].map(u64::from);
        Err(Error::Setting { name, value, least, greatest })
    }
}
