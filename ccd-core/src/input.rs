//! What hosts find out about positions before a step: bounds, whether they are exact in `f32`, and the numbers that follow from that.

use crate::aabb::Aabb;
use crate::error::Error;
use crate::real::{Num, Real};

/// What one pass over positions finds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scan {
    /// Bounds of all positions.
    pub bounds: Aabb<f64>,
    /// Whether each coordinate is an `f32`.
    pub exact: bool,
    /// Whether each coordinate is accepted, see [`Error::MAX_COORDINATE`].
    pub finite: bool,
}

impl Default for Scan {
    fn default() -> Self {
        Self::NONE
    }
}

impl Scan {
    /// Of no position.
    pub const NONE: Self = Self { bounds: Aabb { min: [f64::INFINITY; 3], max: [f64::NEG_INFINITY; 3] }, exact: true, finite: true };

    /// Takes one position.
    #[inline]
    pub fn take<T: Real>(&mut self, p: [T; 3]) {
        for k in 0..3 {
            let c = p[k].to_f64();
            self.bounds.min[k] = Num::min(self.bounds.min[k], c);
            self.bounds.max[k] = Num::max(self.bounds.max[k], c);
            self.exact &= c as f32 as f64 == c;
            // Written so that NaN fails.
            self.finite &= c <= Error::MAX_COORDINATE && c >= -Error::MAX_COORDINATE;
        }
    }

    /// Of the positions of both.
    #[inline]
    pub fn merged(&self, other: &Self) -> Self {
        Self { bounds: self.bounds.union(&other.bounds), exact: self.exact & other.exact, finite: self.finite & other.finite }
    }

    /// Greatest absolute coordinate, 0 without positions.
    pub fn greatest(&self) -> f64 {
        (0..3).fold(0.0, |m, k| Num::max(m, Num::max(Num::abs(self.bounds.min[k]), Num::abs(self.bounds.max[k])))).min(f64::MAX)
    }

    /// Whether boxes in `f32` of positions of type `T` are rounded: by rounding the input, or by growing exact boxes.
    pub fn rounds_boxes<T: Real>(&self, min_distance: f64) -> bool {
        T::UNIT.to_f64() < f32::UNIT as f64 && !(self.exact && min_distance == 0.0)
    }

    /// By how much rounded boxes may overlap without overlapping in truth, see [`slack_at`].
    pub fn slack(&self, min_distance: f64) -> f32 {
        slack_at((self.greatest() + min_distance).round_up())
    }

    /// How positions become `f32`: as they are if they are exact and `keep`, else relative to the middle of their bounds.
    pub fn table(&self, keep: bool) -> Table {
        if self.exact && keep || self.bounds.min[0] > self.bounds.max[0] {
            return Table { origin: [0.0; 3], error: 0.0 };
        }
        let mut origin = [0.0; 3];
        let mut reach = 0f64;
        for k in 0..3 {
            origin[k] = 0.5 * self.bounds.min[k] + 0.5 * self.bounds.max[k];
            reach = Num::max(reach, Num::max(self.bounds.max[k] - origin[k], origin[k] - self.bounds.min[k]));
        }
        // Rounding to f32, and before it at most six roundings in f64 of numbers no greater than the coordinates.
        let error = reach * (1.01 * f32::UNIT as f64) + self.greatest() * (16.0 * f64::UNIT) + f32::MIN_NORMAL as f64;
        Table { origin, error: error.round_up() }
    }
}

/// Positions in `f32` relative to an origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Table {
    /// What is subtracted.
    pub origin: [f64; 3],
    /// How far a coordinate may be from the true one.
    pub error: f32,
}

impl Table {
    /// A position in the table.
    #[inline]
    pub fn place(&self, p: [f64; 3]) -> [f32; 3] {
        [(p[0] - self.origin[0]) as f32, (p[1] - self.origin[1]) as f32, (p[2] - self.origin[2]) as f32]
    }
}

/// Half of the minimum distance and the smallest normal number, rounded up: two boxes grown by it keep the distance.
///
/// The smallest normal number is for devices that flush denormals. A coordinate that is flushed when it is read moves by less
/// than that, and what a comparison or a sum flushes keeps its order; a margin that is a denormal would be none.
pub fn margin<T: Real>(min_distance: f64) -> T {
    let half = T::from_f64(min_distance * 0.5);
    // Two roundings, of half of a unit of the sum each at most, are one step.
    if min_distance > 0.0 { (half + T::MIN_NORMAL).next_up() } else { T::splat(0.0) }
}

/// Boxes of coordinates up to `greatest` that were rounded to `f32` and overlap by at most this may not overlap in truth: twice the spacing of `f32` there,
/// since outward rounding moves two bounds by less than that together.
pub fn slack_at(greatest: f32) -> f32 {
    greatest * (8.0 * f32::UNIT) + f32::MIN_NORMAL
}
