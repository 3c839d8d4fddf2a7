//! How far two features are apart at one moment where rounding hides it: the squares and products
//! that say which points are nearest, and how far they are, are calculated without rounding, and
//! only their quotient and its root are rounded.

use crate::math::expansion::{Expansion, is_safe};
use crate::math::real::{Num, Real};
use crate::math::vec3::{max_abs, scale};
use crate::narrow_phase::relative_motion::Patch;
use core::cmp::Ordering::{Greater, Less};

type Vector = [Expansion; 3];

/// The distance of `v f0 f1 f2` or `ea0 ea1 eb0 eb1`, as two bounds that are 64 units of roundoff
/// from it, or both 0 if it is 0. `None` if a coordinate is not zero and below 2^-200 of the
/// greatest one.
///
/// Values of sums are off by 4 `u`, so quotients of them by 9 `u` and their roots by half of that
/// and 18 `u` of their own; a product over a root by as little.
pub fn bounds(x: &[[f64; 3]; 4], patch: Patch) -> Option<[f64; 2]> {
    let unit = x.iter().fold(0.0, |most, p| Num::max(most, max_abs(*p))).to_unit();
    let scaled = x.map(|p| scale(p, unit));
    let mut all = x.as_flattened().iter().zip(scaled.as_flattened());
    if !all.all(|(x, s)| (*s != 0.0 || *x == 0.0) && is_safe(*s)) {
        return None;
    }
    let distance = inside(&scaled, patch).unwrap_or_else(|| {
        let sides = match patch {
            Patch::Triangle => [[0, 1, 2], [0, 1, 3], [0, 2, 3], [0, 2, 3]],
            Patch::Parallelogram => [[0, 2, 3], [1, 2, 3], [2, 0, 1], [3, 0, 1]],
        };
        let square = |ids: [usize; 3]| square_to_segment(ids.map(|i| scaled[i]));
        sides.map(square).into_iter().fold(f64::INFINITY, Num::min).sqrt_up()
    });
    let off = 64.0 * f64::UNIT;
    let [least, greatest] = [1.0 - off, 1.0 + off].map(|factor| distance * factor / unit);
    match distance > 0.0 {
        true => Some([Num::max(Real::next_down(least), 0.0), Real::next_up(greatest)]),
        false => Some([0.0; 2]),
    }
}

/// The distance of the planes or lines of the features, if that is where they are nearest.
fn inside(x: &[[f64; 3]; 4], patch: Patch) -> Option<f64> {
    let [a, b, c] = match patch {
        Patch::Triangle => [[0, 1], [2, 1], [3, 1]],
        Patch::Parallelogram => [[2, 0], [1, 0], [2, 3]],
    }
    .map(|[to, from]| difference(x[to], x[from]));
    let (bb, bc, cc, ab, ac) = (dot(&b, &b), dot(&b, &c), dot(&c, &c), dot(&a, &b), dot(&a, &c));
    let minor =
        |p: &Expansion, q: &Expansion, r: &Expansion, s: &Expansion| p.times(q).minus(&r.times(s));
    let area = minor(&bb, &cc, &bc, &bc);
    let (s, r) = (minor(&ab, &cc, &ac, &bc), minor(&ac, &bb, &ab, &bc));
    let left = match patch {
        Patch::Triangle => [area.clone().minus(&s).minus(&r), Expansion::default()],
        Patch::Parallelogram => [area.clone().minus(&s), area.clone().minus(&r)],
    };
    let is_inside = area.sign() == Greater && [s, r].iter().chain(&left).all(|x| x.sign() != Less);
    is_inside.then(|| {
        let normal = [[1, 2], [2, 0], [0, 1]].map(|[i, j]| minor(&b[i], &c[j], &b[j], &c[i]));
        dot(&a, &normal).value().abs() / area.value().sqrt_up()
    })
}

/// The square of the distance of `v` from the segment between `p` and `q`.
fn square_to_segment([v, p, q]: [[f64; 3]; 3]) -> f64 {
    let (a, b) = (difference(v, p), difference(q, p));
    let (ab, bb) = (dot(&a, &b), dot(&b, &b));
    if ab.sign() != Greater {
        dot(&a, &a).value()
    } else if ab.clone().minus(&bb).sign() != Less {
        let a = difference(v, q);
        dot(&a, &a).value()
    } else {
        dot(&a, &a).times(&bb).minus(&ab.times(&ab)).value() / bb.value()
    }
}

fn difference(to: [f64; 3], from: [f64; 3]) -> Vector {
    [0, 1, 2].map(|k| Expansion::difference(to[k], from[k]))
}

fn dot(a: &Vector, b: &Vector) -> Expansion {
    a[0].times(&b[0]).plus(&a[1].times(&b[1])).plus(&a[2].times(&b[2]))
}
