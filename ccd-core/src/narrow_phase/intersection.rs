//! Whether an edge and a face meet at one moment, exactly: by the signs of determinants, which are
//! calculated without rounding where rounding could turn them.
//!
//! Both are closed: touching counts, also of an edge in the plane of the face, and of a face
//! without an area.
//!
//! Before that, in lanes: most edges lie outside one of four [`slabs`] around the face. Any
//! direction `w` will do, so its own rounding does not matter. Let `R` bound the coordinates, `e`
//! their input error, `|w|` be the sum of absolute components of `w`. A product `w . x` is off by
//! `e |w|` and three roundings, `3 u R |w|`; there are two, of a corner and of an end, and the
//! bound is added with one more: `2 e + 7 u R`. `2.01` and `16` have the roundings of the bound.
//! Flushing: a product by `R + |w| + 1` smallest normal numbers, six of them, and less than 10 in
//! sums. Where a product overflows, so does `R |w|`, and nothing is outside.

use crate::math::expansion::{Expansion, is_safe};
use crate::math::real::Num;
use crate::math::vec3::{cross, dot, max_abs, sub, sum_abs};
use core::cmp::Ordering::{self, Equal, Greater, Less};

type Point = [f64; 3];

/// The space between two planes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Slab<N> {
    /// Perpendicular to both.
    pub direction: [N; 3],
    /// Of what lies between them, the least product with that.
    pub low: N,
    /// The greatest.
    pub high: N,
}

/// Slabs that hold a triangle: of its plane, and of the planes on its sides, perpendicular to it.
/// `reach`: the greatest coordinate of anything, of which each may be off by `error`.
#[inline(always)]
pub fn slabs<N: Num>([a, b, c]: &[[N; 3]; 3], reach: N, error: N) -> [Slab<N>; 4] {
    let (v, w) = (sub(*b, *a), sub(*c, *a));
    let n = cross(v, w);
    let corners = [a, b, c];
    [
        slab(n, corners, reach, error),
        slab(cross(n, v), corners, reach, error),
        slab(cross(n, w), corners, reach, error),
        slab(cross(n, sub(*c, *b)), corners, reach, error),
    ]
}

#[inline(always)]
fn slab<N: Num>(direction: [N; 3], [a, b, c]: [&[N; 3]; 3], reach: N, error: N) -> Slab<N> {
    let size = sum_abs(direction);
    let one = N::splat(1.0);
    let bound = size * reach * (N::UNIT * N::splat(16.0))
        + size * (error * N::splat(2.01))
        + (one + reach) * (one + size) * (N::MIN_NORMAL * N::splat(64.0));
    let (a, b, c) = (dot(direction, *a), dot(direction, *b), dot(direction, *c));
    Slab { direction, low: a.min(b).min(c) - bound, high: a.max(b).max(c) + bound }
}

/// Whether the ends of an edge are on the same side outside: then it does not meet what is within.
#[inline(always)]
pub fn are_outside<N: Num>(slab: &Slab<N>, [p, q]: &[[N; 3]; 2]) -> N::Mask {
    let (p, q) = (dot(slab.direction, *p), dot(slab.direction, *q));
    (p.gt(slab.high) & q.gt(slab.high)) | (slab.low.gt(p) & slab.low.gt(q))
}

/// Whether the segment from `p` to `q` and the triangle have a point in common; `None` if rounded
/// numbers do not tell, and exact arithmetic would overflow or underflow: some coordinate is not
/// zero and beyond 2^200 or below 2^-200.
pub fn segment_meets_triangle(segment: [Point; 2], triangle: [Point; 3]) -> Option<bool> {
    let sides = certain_sides(segment, triangle);
    if sides[0].is_some() && sides[0] == sides[1] {
        return Some(false);
    }
    let safe = |points: &[Point]| points.iter().flatten().all(|&x| is_safe(x));
    if safe(&segment) && safe(&triangle) {
        return Some(meets(segment, triangle, sides));
    }
    // As [`meets`] does, where no sign is zero.
    let ([p, q], [a, b, c]) = (segment, triangle);
    let around = [[a, b], [b, c], [c, a]].map(|[from, to]| rounded_orientation(p, q, from, to));
    if around.contains(&Some(Less)) && around.contains(&Some(Greater)) {
        return Some(false);
    }
    let ends = segment.map(|x| rounded_orientation(a, b, c, x));
    let is_through = around[0].is_some() && around == [around[0]; 3];
    let crosses = ends.contains(&Some(Less)) && ends.contains(&Some(Greater));
    (is_through && crosses).then_some(true)
}

/// [`orientation`] where rounded numbers tell. Where products vanish, the cross product is off by
/// components up to 2^-1073 besides what [`certain_sign`] covers, and the determinant by that times
/// its first row, far less than it has to be here.
#[inline(never)]
fn rounded_orientation(a: Point, b: Point, c: Point, d: Point) -> Option<Ordering> {
    let (u, v, w) = (sub(a, d), sub(b, d), sub(c, d));
    let value = dot(u, cross(v, w));
    let sign = certain_sign(value, max_abs(u) * max_abs(v) * max_abs(w));
    sign.filter(|_| value.abs() > max_abs(u) * f64::MIN_POSITIVE)
}

/// On which side of the plane of the triangle the ends of the segment are, where rounded numbers
/// tell.
///
/// Coordinates may be so small here that products vanish. If both ends seem to be on one side, no
/// point of the segment is in the triangle all the same. In addition to what [`certain_sign`]
/// covers, the normal `n` is off by a vector `y` with components up to 2^-1074, which is the same
/// for both ends. Let `V W` bound the components of `v w`, and `|x|` be the greatest component of
/// `x`. The ends less `a`, and so all points `x` of the segment less `a`, are further along `n + y`
/// than `60 u |x| V W` and 255 smallest normal numbers together. A point of the triangle is at 0
/// along `n`, and along `y` at `3 |x| 2^-1074` at most. For that to be as far, `V W` must be below
/// 2^-1025 and `|x|` above 2^58. As `|x|` is at most the greater one of `V` and `W`, the other one
/// is below 2^-1083, which is 0; and without a normal nothing is certain.
fn certain_sides(segment: [Point; 2], [a, b, c]: [Point; 3]) -> [Option<Ordering>; 2] {
    let (v, w) = (sub(b, a), sub(c, a));
    let (normal, size) = (cross(w, v), max_abs(v) * max_abs(w));
    segment.map(|x| {
        let u = sub(x, a);
        certain_sign(dot(u, normal), max_abs(u) * size)
    })
}

/// The sign of a determinant that was calculated with rounding, if that is certain. `size`: the
/// product of the greatest elements of its rows, of which there are two or three.
fn certain_sign(value: f64, size: f64) -> Option<Ordering> {
    // Each of six products of three differences is rounded by at most 5 u of what it may be, the
    // sums of them by 4 u more; twice as much, and what vanishes.
    let bound = size * (6.0 * 20.0 * f64::EPSILON / 2.0) + 256.0 * f64::MIN_POSITIVE;
    (value.abs() > bound).then_some(if value > 0.0 { Greater } else { Less })
}

fn meets([p, q]: [Point; 2], [a, b, c]: [Point; 3], known: [Option<Ordering>; 2]) -> bool {
    let sides = [[a, b], [b, c], [c, a]];
    let side = |known: Option<Ordering>, x| known.unwrap_or_else(|| orientation(a, b, c, x));
    match (side(known[0], p), side(known[1], q)) {
        (Equal, Equal) => {
            let is_flat = (0..3).all(|axis| turn(axis, a, b, c) == Equal);
            let in_plane = |[a, b]: [Point; 2]| !is_flat || orientation(p, q, a, b) == Equal;
            sides.into_iter().any(|side| in_plane(side) && segments_meet([p, q], side))
                || !is_flat && lies_in([a, b, c], p)
        }
        (Less, Less) | (Greater, Greater) => false,
        // The line through both meets the plane in one point, which is between them.
        _ => {
            let around = sides.map(|[from, to]| orientation(p, q, from, to));
            !(around.contains(&Less) && around.contains(&Greater))
        }
    }
}

/// Whether two segments in a plane meet.
fn segments_meet([p, q]: [Point; 2], [a, b]: [Point; 2]) -> bool {
    // At least one projection along an axis is one to one. Segments that meet do so in all three,
    // segments that do not meet, in that one neither.
    (0..3).all(|axis| meet_along(axis, [p, q], [a, b]))
}

/// The same, projected along an axis.
fn meet_along(axis: usize, [p, q]: [Point; 2], [a, b]: [Point; 2]) -> bool {
    let turns =
        [turn(axis, p, q, a), turn(axis, p, q, b), turn(axis, a, b, p), turn(axis, a, b, q)];
    if turns == [Equal; 4] {
        // On one line, or points: they meet if their shadows on both axes do.
        return (0..3)
            .filter(|&k| k != axis)
            .all(|k| p[k].min(q[k]) <= a[k].max(b[k]) && a[k].min(b[k]) <= p[k].max(q[k]));
    }
    let apart = |one: Ordering, other: Ordering| one == other && one != Equal;
    !apart(turns[0], turns[1]) && !apart(turns[2], turns[3])
}

/// Whether a point in the plane of a triangle that has an area is within it.
fn lies_in([a, b, c]: [Point; 3], p: Point) -> bool {
    let Some(axis) = (0..3).find(|&axis| turn(axis, a, b, c) != Equal) else { return false };
    let around = [turn(axis, a, b, p), turn(axis, b, c, p), turn(axis, c, a, p)];
    !(around.contains(&Less) && around.contains(&Greater))
}

/// On which side of the plane through `a b c` the point `d` is: the sign of a determinant.
fn orientation(a: Point, b: Point, c: Point, d: Point) -> Ordering {
    if let Some(sign) = rounded_orientation(a, b, c, d) {
        return sign;
    }
    let (u, v, w) = (sub(a, d), sub(b, d), sub(c, d));
    // Of points that are the same, or have a coordinate in common. A difference is zero if and only
    // if it is.
    let is_zero = |k: usize| u[k] == 0.0 && v[k] == 0.0 && w[k] == 0.0;
    if [a, b, c].contains(&d) || a == b || b == c || c == a || (0..3).any(is_zero) {
        return Equal;
    }
    let rows = [a, b, c].map(|x| [0, 1, 2].map(|k| Expansion::difference(x[k], d[k])));
    let minor =
        |i: usize, j: usize| rows[1][i].times(&rows[2][j]).minus(&rows[1][j].times(&rows[2][i]));
    let part = |k: usize| rows[0][k].times(&minor((k + 1) % 3, (k + 2) % 3));
    part(0).plus(&part(1)).plus(&part(2)).sign()
}

/// How `a b c` turn where they are projected along an axis.
fn turn(axis: usize, a: Point, b: Point, c: Point) -> Ordering {
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let (v, w) = ([a[i] - c[i], a[j] - c[j]], [b[i] - c[i], b[j] - c[j]]);
    let size = v[0].abs().max(v[1].abs()) * w[0].abs().max(w[1].abs());
    if let Some(sign) = certain_sign(v[0] * w[1] - v[1] * w[0], size) {
        return sign;
    }
    let d = |x: Point, k: usize| Expansion::difference(x[k], c[k]);
    d(a, i).times(&d(b, j)).minus(&d(a, j).times(&d(b, i))).sign()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;
    use num_bigint::BigInt;
    use std::vec::Vec;

    type Exact = [BigInt; 3];

    /// In units of 2^-60, of which all numbers here are multiples.
    fn exact(p: Point) -> Exact {
        p.map(|x| {
            let (high, low) = (x * 2f64.powi(26), (x * 2f64.powi(26)).fract() * 2f64.powi(34));
            (BigInt::from(high.trunc() as i64) << 34) + BigInt::from(low as i64)
        })
    }

    fn minus(a: &Exact, b: &Exact) -> Exact {
        core::array::from_fn(|k| &a[k] - &b[k])
    }

    fn product(a: &Exact, b: &Exact) -> Exact {
        core::array::from_fn(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            &a[i] * &b[j] - &a[j] * &b[i]
        })
    }

    /// Two convex hulls are apart exactly if a plane is between them, whose normal is a product of
    /// two differences of their points, or of such a product and a difference, or a difference.
    fn reference(segment: [Point; 2], triangle: [Point; 3]) -> bool {
        let (s, t) = (segment.map(exact), triangle.map(exact));
        let mut differences: Vec<Exact> =
            s.iter().flat_map(|p| t.iter().map(|q| minus(p, q)).collect::<Vec<_>>()).collect();
        differences.extend([(0, 1), (1, 2), (2, 0)].map(|(i, j)| minus(&t[i], &t[j])));
        differences.push(minus(&s[0], &s[1]));
        let with_all = |a: &Exact| differences.iter().map(|b| product(a, b)).collect::<Vec<_>>();
        let normals: Vec<Exact> = differences.iter().flat_map(with_all).collect();
        let within = normals.iter().flat_map(with_all);
        let along = |axis: &Exact, p: &Exact| -> BigInt {
            &axis[0] * &p[0] + &axis[1] * &p[1] + &axis[2] * &p[2]
        };
        let separates = |axis: &Exact| {
            let [p, q] = [&s[..], &t[..]].map(|points| {
                let mut of: Vec<BigInt> = points.iter().map(|x| along(axis, x)).collect();
                of.sort();
                [of[0].clone(), of[of.len() - 1].clone()]
            });
            p[0] > q[1] || q[0] > p[1]
        };
        !(differences.iter().any(separates)
            || normals.iter().any(separates)
            || within.into_iter().any(|axis| separates(&axis)))
    }

    /// Points of a small lattice, where nearly everything is degenerate, and the same moved by a
    /// unit of roundoff.
    #[test]
    fn small_cases_are_decided_as_by_planes_in_between() {
        let mut random = Random::new(11);
        let (mut met, mut apart, mut flat) = (0, 0, 0);
        for round in 0..1200 {
            let scale = if round % 3 == 0 { 1.0 } else { 0.1 };
            let mut point = || -> Point {
                core::array::from_fn(|k| {
                    let planar = round % 2 == 1 && k == 2;
                    let x = (1 + if planar { 0 } else { random.below(3) }) as f64 * scale;
                    let nudge = if round % 5 == 4 { random.below(3) as f64 - 1.0 } else { 0.0 };
                    x + nudge * f64::EPSILON
                })
            };
            let (segment, triangle) = ([point(), point()], [point(), point(), point()]);
            let want = reference(segment, triangle);
            let found = segment_meets_triangle(segment, triangle);
            assert_eq!(found, Some(want), "{segment:?} {triangle:?}");
            met += want as u32;
            apart += !want as u32;
            let [a, b, c] = triangle;
            flat += (0..3).all(|axis| turn(axis, a, b, c) == Equal) as u32;
        }
        assert!(met > 200 && apart > 200 && flat > 50, "{met} {apart} {flat}");
    }

    /// Beyond what is exact, rounded numbers tell nearly always: points scaled by a power of two,
    /// or with a coordinate that is tiny instead of zero.
    #[test]
    fn numbers_beyond_the_exact_ones_are_told_by_rounded_ones() {
        let mut random = Random::new(13);
        let (mut told, mut met) = (0, 0);
        for round in 0..3000 {
            let mut point =
                || -> Point { [(); 3].map(|()| (random.bits() >> 8) as f64 / (1 << 24) as f64) };
            let (mut segment, mut triangle) = ([point(), point()], [point(), point(), point()]);
            let tiny = if round % 3 == 0 { 2f64.powi(-230) } else { 0.0 };
            triangle[0][1] = 0.0;
            let want = segment_meets_triangle(segment, triangle).unwrap();
            triangle[0][1] = tiny;
            let scale = [1.0, 2f64.powi(-210), 2f64.powi(230)][round % 3];
            for x in segment.iter_mut().chain(&mut triangle) {
                *x = x.map(|k| k * scale);
            }
            if let Some(found) = segment_meets_triangle(segment, triangle) {
                assert_eq!(found, want, "{segment:?} {triangle:?}");
                (told, met) = (told + 1, met + found as u32);
            }
        }
        assert!(told > 2990 && met > 300, "{told} told, {met} met");
    }

    /// An edge from the middle of a side of a triangle, far from the origin, where all of the
    /// directions are rounded.
    #[test]
    fn no_edge_that_touches_is_outside() {
        let mut random = Random::new(7);
        let (mut outside, reach) = (0, 102.0);
        for _ in 0..20_000 {
            let mut point =
                || -> [f32; 3] { [(); 3].map(|()| 100.0 + (random.bits() >> 16) as f32 / 65536.0) };
            let (t, far) = ([point(), point(), point()], point());
            let middle: [f32; 3] = core::array::from_fn(|k| 0.5 * t[0][k] + 0.5 * t[1][k]);
            let exact = |x: [f32; 3]| x.map(f64::from);
            let halves = (0..3).all(|k| {
                f64::from(middle[k]) == 0.5 * f64::from(t[0][k]) + 0.5 * f64::from(t[1][k])
            });
            let within = slabs(&t, reach, 0.0);
            let is_outside =
                |ends: [[f32; 3]; 2]| within.iter().any(|slab| are_outside(slab, &ends));
            assert!(!halves || !is_outside([middle, far]), "{t:?} {far:?}");
            // All of them off by an eighth: what touches in truth may look apart by a quarter.
            let moved = |x: [f32; 3], by: f32| x.map(|c| c + by);
            let loose = slabs(&t.map(|x| moved(x, -0.125)), reach, 0.125);
            let ends = [moved(middle, 0.125), moved(far, 0.125)];
            assert!(!halves || !loose.iter().any(|slab| are_outside(slab, &ends)));
            let other = point();
            if is_outside([far, other]) {
                let met = segment_meets_triangle([far, other].map(exact), t.map(exact));
                assert_eq!(met, Some(false), "{t:?} {far:?} {other:?}");
                outside += 1;
            }
        }
        assert!(outside > 10_000, "{outside}");
    }

    /// Where nothing has a size, operands and results that are flushed are all that counts.
    #[test]
    fn slabs_hold_what_is_flushed() {
        let narrow = slabs(&[[0.0f32; 3]; 3], 0.0, 0.0)[0];
        let wide = slabs(&[[0.0f64; 3]; 3], 0.0, 0.0)[0];
        assert!(narrow.high.min(-narrow.low) >= 16.0 * f32::MIN_POSITIVE, "{narrow:?}");
        assert!(wide.high.min(-wide.low) >= 16.0 * f64::MIN_POSITIVE, "{wide:?}");
    }

    #[test]
    fn rounding_turns_no_sign() {
        // A point off the plane `x = y` by a fraction of a unit of roundoff of the corners.
        let (a, b, c) = ([12.0, 12.0, 0.0], [24.0, 24.0, 1.0], [24.0, 24.0, -3.0]);
        let at = |x: f64| orientation(a, b, c, [0.5 + x, 0.5, 0.5]);
        assert_eq!(at(0.0), Equal);
        assert!(at(f64::EPSILON) != Equal && at(f64::EPSILON) == at(-f64::EPSILON).reverse());
        assert_eq!(segment_meets_triangle([a, b], [a, b, [1e61, 0.0, 0.0]]), None);
    }
}
