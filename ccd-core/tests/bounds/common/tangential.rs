//! Cubics that nearly touch zero, and queries whose features nearly graze: where rounding decides
//! what is seen.
//!
//! A cubic `(t - tau)^2 (t - rho) + depth` has a critical point at `tau`; a depth of about the band
//! of uncertainty puts the critical value at the band's edge, where noise makes it seem inside or
//! outside. A query adds a side of the patch that is crossed at `tau`, so that only one of the
//! zeros on both sides of it is a contact.

use super::Points;
use super::random::Random;
use ccd_core::Real;
use ccd_core::narrow_phase::coplanarity::Coplanarity;
use ccd_core::narrow_phase::cubic_roots::Cubic;
use ccd_core::narrow_phase::relative_motion::{Motion, Patch};

/// A time: anywhere, at an end of the step, or near one.
fn time(random: &mut Random) -> f64 {
    match random.below(8) {
        0 => 0.0,
        1 => 1.0,
        2 => random.power(-40.0, -1.0),
        3 => 1.0 - random.power(-40.0, -1.0),
        _ => random.unit(),
    }
}

/// A multiple of the band: mostly within some hundredths of its edge, on either side of zero.
fn depth(random: &mut Random) -> f64 {
    random.sign()
        * match random.below(8) {
            0 => 0.0,
            1 => random.between(0.0, 2.0),
            2 => 1.0 + random.sign() * random.power(-8.0, -2.0),
            _ => 1.0 + random.sign() * random.power(-16.0, -8.0),
        }
}

/// A cubic for [`Cubic`]: coefficients and the error with which they are known.
pub fn cubic<R: Real>(random: &mut Random) -> ([R; 4], R) {
    let unit = R::UNIT.to_f64();
    let tau = time(random);
    let rho = match random.below(4) {
        0 => tau + random.sign() * random.power(-24.0, 0.0),
        1 => time(random),
        2 => random.sign() * random.power(0.0, 20.0),
        _ => random.between(-1.0, 2.0),
    };
    let factor = |r: f64| [-r, 1.0 - r];
    let f = [factor(tau), factor(tau), factor(rho)];
    let mut c = [0.0f64; 4];
    for i in 0..8usize {
        c[i.count_ones() as usize] += f[0][i & 1] * f[1][i >> 1 & 1] * f[2][i >> 2 & 1];
    }
    let size = random.sign() * random.power(-8.0, 8.0);
    c = c.map(|c| c * size);
    let largest = c.iter().fold(0.0f64, |m, c| m.max(c.abs()));
    let error = if random.below(2) == 0 { 0.0 } else { largest * unit * random.power(0.0, 10.0) };
    let shift = depth(random) * band(largest, error, unit);
    for (c, n) in c.iter_mut().zip([1.0, 3.0, 3.0, 1.0]) {
        *c += n * shift;
    }
    (c.map(R::from_f64), R::from_f64(error))
}

/// About the band of [`Cubic::new`].
fn band(largest: f64, error: f64, unit: f64) -> f64 {
    error + 256.0 * unit * largest
}

/// A query of four points at both ends whose coplanarity nearly touches zero while they meet
/// inside.
pub struct Query<R> {
    pub patch: Patch,
    pub t0: Points<R>,
    pub t1: Points<R>,
}

/// A member of the family.
///
/// The plane is spanned by `b = (p, 0, h)` and `c = (0, q, g)`, all linear in time, and `a` is
/// `s b + r c` at a time `tau`; its last component is chosen so that the cubic has a critical point
/// there, of a value of about the band.
pub fn query<R: Real>(random: &mut Random) -> Query<R> {
    let patch = if random.below(2) == 0 { Patch::Triangle } else { Patch::Parallelogram };
    let tau = time(random);
    let simple = random.below(2) == 0;
    // A linear function by its values at both ends.
    let mut line = |fixed: Option<f64>| {
        let start = fixed.unwrap_or_else(|| random.between(-1.0, 1.0));
        [start, fixed.unwrap_or_else(|| random.between(-1.0, 1.0))]
    };
    let (p, q) = (line(simple.then_some(1.0)), line(simple.then_some(1.0)));
    let (h, g) = (line(None), line(simple.then_some(0.0)));
    let (mut x, mut y) = (line(None), line(None));
    let at = |l: [f64; 2], t: f64| l[0] + (l[1] - l[0]) * t;
    let slope = |l: [f64; 2]| l[1] - l[0];
    let (mut s, mut r) = (random.between(0.1, 0.5), random.between(0.1, 0.45));
    // Mostly on a side of the patch: then of two zeros beside tau one is a contact.
    match random.below(5) {
        0 => {}
        1 => r = 0.0,
        2 if matches!(patch, Patch::Triangle) => s = 1.0 - r,
        2 => s = 1.0,
        3 => s = 0.0,
        // Crossed a little before or after, as far as the zeros are apart.
        _ => s = random.sign() * R::UNIT.to_f64().sqrt() * random.power(-2.0, 6.0),
    }
    // Moved so that it is at (s, r) at tau.
    let shift = |l: &mut [f64; 2], want: f64| {
        let by = want - at(*l, tau);
        *l = l.map(|v| v + by);
    };
    shift(&mut x, s * at(p, tau));
    shift(&mut y, r * at(q, tau));
    // f = p q z - h q x - p g y; f(tau) = depth and f'(tau) = 0 give z there and its slope.
    let (pt, qt, ht, gt, xt, yt) =
        (at(p, tau), at(q, tau), at(h, tau), at(g, tau), at(x, tau), at(y, tau));
    let w = pt * qt;
    let w_slope = slope(p) * qt + pt * slope(q);
    let rest = ht * qt * xt + pt * gt * yt;
    let rest_slope = slope(h) * qt * xt
        + ht * (slope(q) * xt + qt * slope(x))
        + slope(p) * gt * yt
        + pt * (slope(g) * yt + gt * slope(y));
    let z_for = |depth: f64| {
        let z = (rest + depth) / w;
        let z_slope = (rest_slope - w_slope * z) / w;
        [z - z_slope * tau, z + z_slope * (1.0 - tau)]
    };
    let order = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1]][random.below(4)];
    let size = random.power(-4.0, 4.0);
    let offset = if random.below(4) == 0 { random.vector() } else { [0.0; 3] };
    let assemble = |z: [f64; 2]| {
        let points = |k: usize| {
            let (a, b, c) = ([x[k], y[k], z[k]], [p[k], 0.0, h[k]], [0.0, q[k], g[k]]);
            let corners = match patch {
                Patch::Triangle => [a, [0.0; 3], b, c],
                Patch::Parallelogram => [[0.0; 3], b, a, [a[0] - c[0], a[1] - c[1], a[2] - c[2]]],
            };
            corners.map(|v| order.map(|i| R::from_f64(v[i] * size + offset[i])))
        };
        Query { patch, t0: points(0), t1: points(1) }
    };
    let plain = assemble(z_for(0.0));
    let plane = Coplanarity::new(&plain.motion());
    let largest = plane.c.iter().fold(0.0f64, |m, c| m.max(c.to_f64().abs()));
    let edge = band(largest, plane.bound.to_f64() * 0.34, R::UNIT.to_f64());
    assemble(z_for(depth(random) * edge / (size * size * size)))
}

impl<R: Real> Query<R> {
    pub fn motion(&self) -> Motion<R> {
        let zero = R::splat(0.0);
        Motion::new(self.patch, &self.t0, &self.t1, zero)
    }
}

/// What [`Cubic`] says of a member: intervals of time.
pub fn intervals<R: Real>(c: [R; 4], error: R) -> Vec<[f64; 2]> {
    let (all, n) = Cubic::new(c, error).zero_intervals();
    all[..n].iter().map(|i| [i.lo.to_f64(), i.hi.to_f64()]).collect()
}
