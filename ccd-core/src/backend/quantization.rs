//! What hosts find out about positions before a step: bounds, whether they are exact in `f32`, and
//! the numbers that follow from that.

use crate::math::aabb::{Aabb, GREATEST};
use crate::math::real::{Num, Real};
use crate::model::error::{Error, check_coordinates};

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

impl Scan {
    /// Of no position.
    pub const NONE: Self = Self {
        bounds: Aabb { min: [f64::INFINITY; 3], max: [f64::NEG_INFINITY; 3] },
        exact: true,
        finite: true,
    };

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

    /// Takes the positions of both ends of a step.
    pub fn take_all<T: Real>(&mut self, x0: &[[T; 3]], x1: &[[T; 3]]) {
        self.take_end(x0);
        self.take_end(x1);
    }

    /// Takes positions, four at a time, so that the compiler makes vectors of their coordinates.
    fn take_end<T: Real>(&mut self, x: &[[T; 3]]) {
        const LANES: usize = 12;
        let zero = T::splat(0.0);
        let mut least = [T::splat(f32::INFINITY); LANES];
        let mut greatest = [T::splat(f32::NEG_INFINITY); LANES];
        // Zero until a coordinate is no number or infinite, then NaN.
        let mut not_finite = [zero; LANES];
        let mut rounding = [zero; LANES];
        let (fours, rest) = x.as_chunks::<4>();
        for four in fours {
            let four = four.as_flattened();
            for i in 0..LANES {
                let c = four[i];
                least[i] = Num::min(least[i], c);
                greatest[i] = Num::max(greatest[i], c);
                not_finite[i] = not_finite[i] + c * zero;
                if T::UNIT.to_f64() < f32::UNIT as f64 {
                    let rounded = T::from_f64(c.to_f64() as f32 as f64);
                    rounding[i] = Num::max(rounding[i], Num::abs(rounded - c));
                }
            }
        }
        let mut taken = Self::NONE;
        for i in 0..LANES {
            let [min, max] = [&mut taken.bounds.min[i % 3], &mut taken.bounds.max[i % 3]];
            *min = Num::min(*min, least[i].to_f64());
            *max = Num::max(*max, greatest[i].to_f64());
            taken.exact &= rounding[i] == zero;
            taken.finite &= not_finite[i] == zero;
        }
        for k in 0..3 {
            // Of no position the one is infinity, the other its negative.
            taken.finite &= taken.bounds.max[k] <= Error::MAX_COORDINATE;
            taken.finite &= taken.bounds.min[k] >= -Error::MAX_COORDINATE;
        }
        *self = self.merged(&taken);
        rest.iter().for_each(|p| self.take(*p));
    }

    /// Fails with the first coordinate of these positions, all of which were taken, that is not
    /// accepted.
    ///
    /// # Errors
    /// [`Error::Coordinate`].
    pub fn check<T: Real>(&self, x0: &[[T; 3]], x1: &[[T; 3]]) -> Result<(), Error> {
        if self.finite {
            return Ok(());
        }
        check_coordinates(0, x0)?;
        check_coordinates(1, x1)
    }

    /// Of the positions of both.
    #[inline]
    pub fn merged(&self, other: &Self) -> Self {
        Self {
            bounds: self.bounds.union(&other.bounds),
            exact: self.exact & other.exact,
            finite: self.finite & other.finite,
        }
    }

    /// A guess at what a scan finds after all positions went `by` this: bounds that went with them
    /// and are wider on each side by a part of the longest one, and by what rounding takes.
    pub fn guess(&self, by: [f64; 3], part: f64) -> Self {
        let Aabb { mut min, mut max } = self.bounds;
        let longest = (0..3).fold(0.0, |longest, k| Num::max(longest, max[k] - min[k]));
        let wider = part * longest + self.greatest() * f32::UNIT as f64;
        for k in 0..3 {
            min[k] += by[k] - wider;
            max[k] += by[k] + wider;
        }
        Self { bounds: Aabb { min, max }, ..*self }
    }

    /// Whether a table, a slack and a greatest coordinate that were taken of this guess hold for
    /// positions of which a scan has `found` this.
    pub fn covers(&self, found: &Self) -> bool {
        let within = (0..3).all(|k| {
            found.bounds.min[k] >= self.bounds.min[k] && found.bounds.max[k] <= self.bounds.max[k]
        });
        let as_given = |scan: &Self| scan.table(true) == Table::AS_GIVEN;
        within
            && found.finite
            && self.finite
            && found.exact == self.exact
            && as_given(found) == as_given(self)
    }

    /// Greatest absolute coordinate, 0 without positions.
    pub fn greatest(&self) -> f64 {
        (0..3)
            .fold(0.0, |m, k| {
                Num::max(m, Num::max(Num::abs(self.bounds.min[k]), Num::abs(self.bounds.max[k])))
            })
            .min(f64::MAX)
    }

    /// Whether boxes in `f32` of positions of type `T` are rounded: by rounding the input, or by
    /// growing exact boxes.
    pub fn rounds_boxes<T: Real>(&self, min_distance: f64) -> bool {
        T::UNIT.to_f64() < f32::UNIT as f64 && !(self.exact && min_distance == 0.0)
    }

    /// By how much rounded boxes may overlap without overlapping in truth, see [`slack_at`]; at
    /// most [`GREATEST`], because bounds further apart than that were cut to it or are certainly in
    /// order.
    pub fn slack(&self, min_distance: f64) -> f32 {
        slack_at((self.greatest() + min_distance).round_up()).min(GREATEST)
    }

    /// How positions become `f32`: as they are if they are exact and `keep`, else relative to the
    /// middle of their bounds, and in another unit where theirs is one in which products of `f32`
    /// would overflow or vanish, or differences be flushed.
    ///
    /// Without `keep`, places between exact positions are rounded, in the unit of the positions and
    /// from their origin if that is near them: what stands still then has its places of the whole
    /// step.
    pub fn table(&self, keep: bool) -> Table {
        let empty = self.bounds.min[0] > self.bounds.max[0];
        let greatest = self.greatest();
        let fine = greatest <= EXACT_LIMIT && greatest >= LEAST_EXACT || greatest == 0.0;
        if empty || self.exact && keep && fine {
            return Table::AS_GIVEN;
        }
        let mut origin = [0.0; 3];
        let mut reach = 0f64;
        for k in 0..3 {
            origin[k] = 0.5 * self.bounds.min[k] + 0.5 * self.bounds.max[k];
            let far = Num::max(self.bounds.max[k] - origin[k], origin[k] - self.bounds.min[k]);
            reach = Num::max(reach, far);
        }
        let mut scale = scale_of(reach);
        if self.exact && fine && greatest <= NEAR_ORIGIN * reach {
            (origin, scale, reach) = ([0.0; 3], 1.0, greatest);
        }
        // Rounding to f32, and before it at most six roundings in f64 of numbers no greater than
        // the coordinates, and operands and a difference that a device may flush.
        let before = greatest * (16.0 * f64::UNIT) + 8.0 * f64::MIN_NORMAL;
        let error = reach * (1.01 * f32::UNIT as f64) + before;
        // Scaling is exact unless the result is tiny; so is the rounding to f32.
        let error = error * scale * (1.0 + 4.0 * f64::UNIT) + 2.0 * f32::MIN_NORMAL as f64;
        Table { origin, scale, error: error.round_up() }
    }
}

/// The origin is near positions whose coordinates are at most so many times half of their extent:
/// two bits of a place are lost at most.
const NEAR_ORIGIN: f64 = 4.0;

/// Coordinates in `f32` up to this, 2^28, are taken as they are: the fourth powers of their
/// differences, which filters form, are finite.
const EXACT_LIMIT: f64 = 268_435_456.0;

/// Coordinates in `f32` of which the greatest is at least this, 2^-74, are taken as they are: near
/// the greatest they differ by 2^-24 of it or not at all, and what is flushed in a difference, less
/// than three times the smallest normal number, 2^-126, is below a unit of roundoff of that. Lesser
/// differences have it in their bounds, see [`Motion::scaled`].
///
/// [`Motion::scaled`]: crate::narrow_phase::relative_motion::Motion::scaled
const LEAST_EXACT: f64 = 5.293_955_920_339_377e-23;

/// The power of two that brings `reach` to about 2^16 where it is far from it; 1 from 2^-16 to
/// 2^28. At most 2^126, whose inverse is a normal `f32`, where that brings it to 2^-16 at least.
fn scale_of(reach: f64) -> f64 {
    const BIAS: u64 = 1023;
    if reach >= 1.0 / 65_536.0 && reach <= EXACT_LIMIT || reach < f64::MIN_NORMAL {
        return 1.0;
    }
    // 2^(16 - e) for a reach in 2^e .. 2^(e + 1); e is at most 334 for coordinates up to 1e100.
    let exponent = reach.to_bits() >> 52;
    let most = if exponent >= BIAS - 142 { BIAS + 126 } else { 2 * BIAS };
    f64::from_bits((2 * BIAS + 16 - exponent).min(most) << 52)
}

/// Positions in `f32`, relative to an origin and in a unit of their own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Table {
    /// What is subtracted.
    pub origin: [f64; 3],
    /// By what the difference is multiplied: a power of two.
    pub scale: f64,
    /// How far a coordinate may be from the true one, in the unit of the table.
    pub error: f32,
}

impl Table {
    /// Positions that are `f32` already.
    pub const AS_GIVEN: Self = Self { origin: [0.0; 3], scale: 1.0, error: 0.0 };

    /// A position in the table.
    #[inline]
    pub fn place(&self, p: [f64; 3]) -> [f32; 3] {
        let at = |k: usize| ((p[k] - self.origin[k]) * self.scale) as f32;
        [at(0), at(1), at(2)]
    }

    /// A distance in the unit of the table, rounded up. One that is tiny becomes the smallest
    /// normal number, within which nothing certainly is: bounds of a distance are greater where a
    /// device may flush, in whichever unit ([`Motion::scaled`]).
    ///
    /// [`Motion::scaled`]: crate::narrow_phase::relative_motion::Motion::scaled
    #[inline]
    pub fn distance(&self, min_distance: f64) -> f32 {
        // The product is exact unless it is tiny, and then some normal number is above it.
        let scaled = min_distance * self.scale;
        let tiny = min_distance > 0.0 && scaled < f32::MIN_NORMAL as f64;
        if tiny { f32::MIN_NORMAL } else { scaled.round_up() }
    }

    /// How far from the middle between them two points may have their places in the table, in any
    /// direction, where the points are at most `min_distance` apart: half of that, and what either
    /// place is off by, along a diagonal `sqrt(3) < 1.7321` times the error of a coordinate.
    ///
    /// `1.0001` is for three roundings and for axes that are as much as `8 u` longer than 1, `11 u`
    /// in all; the smallest normal number for a half that is below it.
    #[inline]
    pub fn contact_reach(&self, min_distance: f64) -> f32 {
        let reach = 0.5 * self.distance(min_distance) + 1.7321 * self.error;
        reach * 1.0001 + f32::MIN_NORMAL
    }
}

/// Half of the minimum distance and the smallest normal number, rounded up: two boxes grown by it
/// keep the distance.
///
/// The smallest normal number is for devices that flush denormals. A coordinate that is flushed
/// when it is read moves by less than that, and what a comparison or a sum flushes keeps its order;
/// a margin that is a denormal would be none.
pub fn margin<T: Real>(min_distance: f64) -> T {
    let half = T::from_f64(min_distance * 0.5);
    // Two roundings, of half of a unit of the sum each at most, are one step.
    if min_distance > 0.0 { (half + T::MIN_NORMAL).next_up() } else { T::splat(0.0) }
}

/// Boxes of coordinates up to `greatest` that were rounded to `f32` and overlap by at most this may
/// not overlap in truth: 4 to 8 times the spacing of `f32` there, of which outward rounding makes
/// boxes that are apart overlap by one at most.
pub fn slack_at(greatest: f32) -> f32 {
    greatest * (8.0 * f32::UNIT) + f32::MIN_NORMAL
}

#[cfg(test)]
mod tests;
