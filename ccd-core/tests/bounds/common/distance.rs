//! Distances of features and the first time at which they are small, by other means than the
//! library's: projections, in any numbers, and steps that no feature can outrun.

use num_traits::Num;

type V<T = f64> = [T; 3];

/// `f64`, or exact numbers.
pub trait Number: Num + Clone + PartialOrd {}

impl<T: Num + Clone + PartialOrd> Number for T {}

fn minus<T: Number>(a: &V<T>, b: &V<T>) -> V<T> {
    std::array::from_fn(|k| a[k].clone() - b[k].clone())
}

fn dot<T: Number>(a: &V<T>, b: &V<T>) -> T {
    let [x, y, z]: V<T> = std::array::from_fn(|k| a[k].clone() * b[k].clone());
    x + y + z
}

/// `a + s b`.
fn ahead<T: Number>(a: &V<T>, s: &T, b: &V<T>) -> V<T> {
    std::array::from_fn(|k| a[k].clone() + s.clone() * b[k].clone())
}

fn apart_squared<T: Number>(a: &V<T>, b: &V<T>) -> T {
    let d = minus(a, b);
    dot(&d, &d)
}

fn least<T: Number>(a: T, b: T) -> T {
    if b < a { b } else { a }
}

fn point_segment_squared<T: Number>(p: &V<T>, a: &V<T>, b: &V<T>) -> T {
    let d = minus(b, a);
    let (along, square) = (dot(&minus(p, a), &d), dot(&d, &d));
    let is_ahead = square > T::zero() && along > T::zero();
    let s = if is_ahead { least(along / square, T::one()) } else { T::zero() };
    apart_squared(p, &ahead(a, &s, &d))
}

/// `s` and `r` of the point `s u + r v` that is nearest to `w`. `apart` says, by `uu vv - uv uv`,
/// `uu` and `vv`, whether `u` and `v` are far enough from parallel.
fn nearest<T: Number>([u, v, w]: [&V<T>; 3], apart: impl Fn(&T, &T, &T) -> bool) -> Option<[T; 2]> {
    let (uu, uv, vv, wu, wv) = (dot(u, u), dot(u, v), dot(v, v), dot(w, u), dot(w, v));
    let minor = |a: &T, b: &T, c: &T, d: &T| a.clone() * b.clone() - c.clone() * d.clone();
    let det = minor(&uu, &vv, &uv, &uv);
    apart(&det, &uu, &vv)
        .then(|| [minor(&wu, &vv, &wv, &uv) / det.clone(), minor(&wv, &uu, &wu, &uv) / det])
}

/// Of a point and a triangle: over its sides, and over its plane where the foot is inside. See
/// `nearest`.
pub fn point_triangle_squared<T: Number>(
    [p, a, b, c]: &[V<T>; 4],
    apart: impl Fn(&T, &T, &T) -> bool,
) -> T {
    let two = least(point_segment_squared(p, a, b), point_segment_squared(p, b, c));
    let sides = least(two, point_segment_squared(p, c, a));
    let (u, v, w) = (minus(b, a), minus(c, a), minus(p, a));
    match nearest([&u, &v, &w], apart) {
        Some([s, r]) if s > T::zero() && r > T::zero() && s.clone() + r.clone() < T::one() => {
            least(sides, apart_squared(p, &ahead(&ahead(a, &s, &u), &r, &v)))
        }
        _ => sides,
    }
}

/// Of two segments: from their ends, and between their lines where the feet are inside. See
/// `nearest`.
pub fn segment_segment_squared<T: Number>(
    [a, b, c, d]: &[V<T>; 4],
    apart: impl Fn(&T, &T, &T) -> bool,
) -> T {
    let of_first = least(point_segment_squared(a, c, d), point_segment_squared(b, c, d));
    let of_second = least(point_segment_squared(c, a, b), point_segment_squared(d, a, b));
    let ends = least(of_first, of_second);
    let (u, v, w) = (minus(b, a), minus(d, c), minus(c, a));
    let Some([s, r]) = nearest([&u, &v, &w], apart) else { return ends };
    let r = T::zero() - r;
    let inside = |x: &T| *x > T::zero() && *x < T::one();
    if inside(&s) && inside(&r) {
        return least(ends, apart_squared(&ahead(a, &s, &u), &ahead(c, &r, &v)));
    }
    ends
}

fn certainly_apart(det: &f64, uu: &f64, vv: &f64) -> bool {
    *det > 1e-12 * uu * vv
}

/// Of a point and a triangle.
pub fn point_triangle(x: [V; 4]) -> f64 {
    point_triangle_squared(&x, certainly_apart).sqrt()
}

/// Of two segments.
pub fn segment_segment(x: [V; 4]) -> f64 {
    segment_segment_squared(&x, certainly_apart).sqrt()
}

/// When features come within a distance for the first time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum First {
    Never,
    /// At this time, up to 1e-9.
    At(f64),
    /// Too close to the distance for too long.
    Unclear,
}

/// `distance` of four points, of which any of the first `n` and any of the others move towards each
/// other.
pub fn first_within(
    distance: fn([V; 4]) -> f64,
    n: usize,
    t0: &[V; 4],
    t1: &[V; 4],
    d: f64,
) -> First {
    let path = |i: usize| minus(&t1[i], &t0[i]);
    let pairs = (0..n).flat_map(|i| (n..4).map(move |j| (i, j)));
    let speeds = pairs.map(|(i, j)| apart_squared(&path(i), &path(j)).sqrt());
    let speed = speeds.fold(0.0, f64::max);
    let gap_at = |t: f64| distance(std::array::from_fn(|i| ahead(&t0[i], &t, &path(i)))) - d;
    let mut t = 0.0;
    for _ in 0..4000 {
        let gap = gap_at(t);
        if gap <= 1e-10 * speed.min(1.0) * (1.0 + d) {
            // Not yet for certain: it must become clearly less at once.
            let then = gap_at((t + 2e-9).min(1.0));
            let now = t == 0.0 && gap < -1e-9;
            return if now || then < -1e-15 * (1.0 + d) { First::At(t) } else { First::Unclear };
        }
        t += gap / speed;
        if !(t <= 1.0) {
            return First::Never;
        }
    }
    First::Unclear
}
