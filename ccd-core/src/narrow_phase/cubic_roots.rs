//! Where a cubic can vanish: isolation into monotone pieces, then Newton-Raphson guarded by
//! bisection.
//!
//! A root is not a number here but an interval outside of which the cubic is certainly not zero,
//! rounding included ([da Silva 2013] takes Newton-Raphson with bisection from [Press 2007];
//! changed here: the iteration looks for the two ends of the band `|f| <= bound` rather than for a
//! root of the rounded polynomial).

use crate::math::real::Real;

/// A closed interval of time inside `[0, 1]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval<R> {
    /// Start; if it is not 0, the cubic is certainly not zero just before it.
    pub lo: R,
    /// End, `>= lo`.
    pub hi: R,
    /// Whether the exact cubic certainly changes its sign between `lo` and `hi`.
    pub crosses: bool,
}

impl<R: Real> Interval<R> {
    /// Whether no time is in it. (Not an `Option`: shader compilers cannot store the niche.)
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.lo > self.hi
    }
}

/// A cubic `c[0] s^3 + c[1] s^2 t + c[2] s t^2 + c[3] t^3`, `s = 1 - t`, known up to `band` on
/// `[0, 1]`.
#[derive(Clone, Copy, Debug)]
pub struct Cubic<R> {
    c: [R; 4],
    band: R,
    /// What makes the largest coefficient 1.
    scale: R,
    /// Width, in time, to which an end of an interval is refined.
    width: R,
}

/// Steps of the guarded iteration; each at least halves the bracket when it is a bisection, and 44
/// halvings reach [`WIDTH`] or a sixteenth of the least tolerance. Running out leaves a wider
/// interval, never a wrong one.
const MAX_STEPS: usize = 64;
/// Width, in time, to which an end of an interval is refined unless a caller wants less: 2^-42, far
/// below the 1e-6 that callers are promised by default.
const WIDTH: f32 = 2.273_736_8e-13;

/// Coefficients are taken from this many times the smallest normal number up to the inverse of
/// that: 2^26.
const MARGIN: f32 = 67_108_864.0;

impl<R: Real> Cubic<R> {
    /// `error` bounds how far the exact polynomial is from `c` anywhere on `[0, 1]`.
    ///
    /// The band adds the rounding of evaluation, at most `12 u max|c|`, and what a critical point
    /// that is only nearly right can hide: the derivative there is below `19 u` times the sum of
    /// its coefficients, itself at most `12 max|c|` (from the quadratic formula without
    /// cancellation, whose residual is at most `13 u` of that sum, and the rounding of the point),
    /// so the cubic turns back by less than `228 u max|c|`, and with coefficients that are off by
    /// `11 u max|c|` (below) by less than `239 u max|c|`.
    ///
    /// Where the discriminant, as it is rounded, is not above 0, no critical point is looked for,
    /// although there may be two. Then `q1^2` is rounded to at most `q0 q2`, so it is greater by at
    /// most `2 u q1^2`. If both are in `(0, 1)`, `q0` and `q2` have the sign that `q1` has not, and
    /// what the derivative is beyond 0 between them is `(q1^2 - q0 q2) / (|q0| + 2 |q1| + |q2|)`,
    /// below `u |q1| / 2`, which is at most `u max|c|`. (Where products vanish, `q1` and one of
    /// `q0` and `q2` are so small that it is less.) Coefficients are off by `11 u max|c|`: a
    /// product by three `3 u`, a difference `4 u`, scaling `4 u`. So the cubic turns back by at
    /// most `12 u max|c|` there.
    #[inline]
    pub fn new(c: [R; 4], error: R) -> Self {
        let largest = c[0].abs().max(c[1].abs()).max(c[2].abs().max(c[3].abs()));
        let least = R::MIN_NORMAL * R::splat(MARGIN);
        let one = R::splat(1.0);
        // Elsewhere products and quotients overflow, underflow, or are not what a device promises:
        // then nothing is known of the cubic.
        let fine = largest >= least && largest <= one / least;
        let rounding = if fine { R::UNIT * R::splat(256.0) } else { R::splat(2.0) };
        Self {
            c,
            band: error + largest * rounding,
            scale: if fine { one / largest } else { R::splat(0.0) },
            width: R::splat(WIDTH),
        }
    }

    /// The same, for intervals that need to be at most `tolerance` wide where the cubic is steep.
    #[inline]
    pub fn refined(self, tolerance: R) -> Self {
        // A sixteenth: what is between the ends is the band and up to three widths.
        Self { width: self.width.min(tolerance * R::splat(0.0625)), ..self }
    }

    /// Whether the cubic may vanish at `t`.
    #[inline(always)]
    pub fn may_vanish_at(&self, t: R) -> bool {
        !(self.value(t).abs() > self.band)
    }

    /// Value at `t` in `[0, 1]`.
    #[inline]
    pub fn value(&self, t: R) -> R {
        let s = R::splat(1.0) - t;
        let [c0, c1, c2, c3] = self.c;
        (c0 * s + c1 * t) * (s * s) + (c2 * s + c3 * t) * (t * t)
    }

    /// Bernstein coefficients of the derivative, a quadratic `q[0] s^2 + 2 q[1] s t + q[2] t^2`.
    #[inline]
    fn derivative(&self) -> [R; 3] {
        let three = R::splat(3.0);
        let [c0, c1, c2, c3] = self.c;
        [c1 - three * c0, c2 - c1, three * c3 - c2]
    }

    /// The critical points inside `(0, 1)`, ascending, as the ends of monotone pieces: `[0, .., 1]`
    /// and the number of pieces.
    pub fn pieces(&self) -> ([R; 4], usize) {
        let (zero, one) = (R::splat(0.0), R::splat(1.0));
        // Scaled, so that squares neither overflow nor vanish.
        let q = self.derivative();
        let (q0, q1, q2) = (q[0] * self.scale, q[1] * self.scale, q[2] * self.scale);
        let mut ends = [zero, one, one, one];
        let mut n = 1;
        let discriminant = q1 * q1 - q0 * q2;
        if discriminant > zero {
            let root = discriminant.sqrt_up();
            let z = -(q1 + if q1 < zero { -root } else { root });
            // With r = t / s: r = z / q2 or q0 / z, so t = z / (z + q2) or q0 / (q0 + z).
            let mut t = [z / (z + q2), q0 / (q0 + z)];
            if t[1] < t[0] {
                t = [t[1], t[0]];
            }
            for i in 0..2 {
                if t[i] > zero && t[i] < one {
                    ends[n] = t[i];
                    n += 1;
                }
            }
        }
        ends[n] = one;
        (ends, n)
    }

    /// The intervals in which the exact cubic may vanish, ascending; they are at most three and
    /// together hold every zero.
    pub fn zero_intervals(&self) -> ([Interval<R>; 3], usize) {
        let zero = R::splat(0.0);
        let mut out = [Interval { lo: zero, hi: zero, crosses: false }; 3];
        let mut n = 0;
        let (ends, n_pieces) = self.pieces();
        for i in 0..n_pieces {
            let interval = self.zero_in_piece(ends[i], ends[i + 1]);
            if !interval.is_empty() {
                out[n] = interval;
                n += 1;
            }
        }
        (out, n)
    }

    /// The interval of possible zeros within one monotone piece `[from, to]`; empty if there can be
    /// none.
    pub fn zero_in_piece(&self, from: R, to: R) -> Interval<R> {
        let (f0, f1) = (self.value(from), self.value(to));
        let starts_outside = f0.abs() > self.band;
        let ends_outside = f1.abs() > self.band;
        let zero = R::splat(0.0);
        let crosses = starts_outside && ends_outside && (f0 > zero) != (f1 > zero);
        if starts_outside && ends_outside && !crosses {
            return Interval { lo: R::splat(1.0), hi: zero, crosses };
        }
        let lo = if starts_outside { self.enter_band(from, to, f0 < zero) } else { from };
        let hi = if ends_outside { self.leave_band(lo, to, f1 < zero) } else { to };
        Interval { lo, hi, crosses }
    }

    /// Whether the exact cubic certainly does not vanish in `[from, to]` up to `latest`, which is
    /// before `to`: cheaper than [`Cubic::zero_in_piece`], and `false` where that is not sure.
    ///
    /// At `from` and two widths after `latest` it is beyond the band on one side, and the piece is
    /// monotone up to what the band allows for. In `f64`, what [`Cubic::zero_in_piece`] says then
    /// starts after `latest`, too: the later value is beyond twice the band, so a value that falls
    /// towards zero was beyond the band at all times before (rounding of two values and what the
    /// piece turns back are less than the band, `252 u max|c|`; another `11 u` if coefficients are
    /// off as far as they can be, of which less than 10 together were ever reached; were it more,
    /// the same contact would be found with other last bits), the bracket of the start is above
    /// these times, and once it is a width wide, all of it is; a value that moves away from zero
    /// stays on its side to the end of the piece, and no zero is reported. (A bracket that is wider
    /// after `MAX_STEPS` may start earlier; not known to happen.)
    pub fn is_nonzero_until(&self, latest: R, from: R, to: R) -> bool {
        let t = latest + (self.width + self.width);
        if !(t < to) {
            return false;
        }
        let (f0, f) = (self.value(from), self.value(t.max(from)));
        let twice = self.band + self.band;
        f0.abs() > self.band && f.abs() > twice && (f0 > R::splat(0.0)) == (f > R::splat(0.0))
    }

    /// The last time, up to the width, at which `f` is still certainly on the side where it is at
    /// `from`.
    fn enter_band(&self, from: R, to: R, negative: bool) -> R {
        let sign = if negative { R::splat(-1.0) } else { R::splat(1.0) };
        let (width, half) = (self.width, R::splat(0.5));
        let q = self.derivative();
        let (mut low, mut high) = (from, to);
        let mut t = half * (low + high);
        for _ in 0..MAX_STEPS {
            let gap = sign * self.value(t) - self.band;
            if gap > R::splat(0.0) {
                low = t;
            } else {
                high = t;
            }
            if !(high - low > width) {
                break;
            }
            let s = R::splat(1.0) - t;
            let slope = sign * ((q[0] * s + q[1] * t) * s + (q[1] * s + q[2] * t) * t);
            // Newton's step, moved a little past its target so that the bracket closes from both
            // sides in turn.
            let step = -gap / slope;
            let past = if gap > R::splat(0.0) { half * width } else { -(half * width) };
            let next = t + step + past;
            t = if next > low && next < high && step.abs() < half * (high - low) {
                next
            } else {
                half * (low + high)
            };
        }
        low
    }

    /// A time after `from` from which on `f` certainly is on the side where it is at `to`, at most
    /// twice as far away as needed; `to` if none is found.
    ///
    /// Only that side counts: on the other one noise at a critical point may lie just outside of
    /// the band, with the crossing still to come. On the piece `f` is monotone up to what the band
    /// allows for, so it does not come back.
    fn leave_band(&self, from: R, to: R, negative: bool) -> R {
        let sign = if negative { R::splat(-1.0) } else { R::splat(1.0) };
        let mut step = self.width + self.width;
        for _ in 0..MAX_STEPS {
            let t = from + step;
            if !(t < to) {
                break;
            }
            if sign * self.value(t) > self.band {
                return t;
            }
            step = step + step;
        }
        to
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    /// `(t - r0)(t - r1)(t - r2)` scaled, in the basis of `Cubic`.
    fn from_roots(r: [f64; 3]) -> [f64; 4] {
        // Each factor is -r s + (1 - r) t.
        let f = r.map(|r| [-r, 1.0 - r]);
        let mut c = [0.0; 4];
        for i in 0..8usize {
            let k = i.count_ones() as usize;
            c[k] += f[0][i & 1] * f[1][i >> 1 & 1] * f[2][i >> 2 & 1];
        }
        c
    }

    fn check_roots(roots: [f64; 3], slack: f64) {
        let cubic = Cubic::new(from_roots(roots), 1e-15);
        let (intervals, n) = cubic.zero_intervals();
        for r in roots.iter().filter(|r| (0.0..=1.0).contains(*r)) {
            let held = intervals[..n].iter().any(|i| i.lo <= *r && *r <= i.hi);
            assert!(held, "root {r} of {roots:?} is in none of {:?}", &intervals[..n]);
        }
        let total: f64 = intervals[..n].iter().map(|i| i.hi - i.lo).sum();
        assert!(total <= slack, "{roots:?}: {:?} is wider than {slack}", &intervals[..n]);
    }

    #[test]
    fn intervals_hold_every_root() {
        check_roots([0.25, 0.5, 0.75], 1e-11);
        check_roots([0.1, 2.0, 3.0], 1e-11);
        check_roots([-1.0, 2.0, 3.0], 0.0);
        check_roots([0.5, 0.5, 0.9], 1e-5);
        check_roots([0.5, 0.5, 0.5], 1e-3);
        check_roots([0.0, 0.5, 1.0], 1e-10);
        check_roots([1e-9, 2e-9, 3e-9], 1e-4);
        let mut random = Random::new(12345);
        for _ in 0..2000 {
            let [a, b, c] = random.point();
            check_roots([a * 3.0 - 1.0, b * 3.0 - 1.0, c], 1e-3);
        }
    }

    #[test]
    fn constant_and_zero_cubics() {
        assert_eq!(Cubic::new([1.0, 3.0, 3.0, 1.0], 1e-15).zero_intervals().1, 0);
        let (intervals, n) = Cubic::new([0.0f64; 4], 0.0).zero_intervals();
        assert_eq!(
            (n, intervals[0].lo, intervals[0].hi, intervals[0].crosses),
            (1, 0.0, 1.0, false)
        );
    }
}
