//! Distances of features and the first time at which they are small, by other means than the
//! library's: projections, and steps that no feature can outrun.

type V = [f64; 3];

fn minus(a: V, b: V) -> V {
    std::array::from_fn(|k| a[k] - b[k])
}

fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn length(a: V) -> f64 {
    dot(a, a).sqrt()
}

fn along(a: V, b: V, s: f64) -> V {
    std::array::from_fn(|k| a[k] + s * (b[k] - a[k]))
}

fn point_segment(p: V, a: V, b: V) -> f64 {
    let d = minus(b, a);
    let s = dot(minus(p, a), d) / dot(d, d);
    length(minus(p, along(a, b, if s > 0.0 { s.min(1.0) } else { 0.0 })))
}

/// Of a point and a triangle: over its sides, and over its plane where the foot is inside.
pub fn point_triangle([p, a, b, c]: [V; 4]) -> f64 {
    let sides = point_segment(p, a, b).min(point_segment(p, b, c)).min(point_segment(p, c, a));
    let (u, v, w) = (minus(b, a), minus(c, a), minus(p, a));
    let (uu, uv, vv, wu, wv) = (dot(u, u), dot(u, v), dot(v, v), dot(w, u), dot(w, v));
    let d = uu * vv - uv * uv;
    let (s, r) = ((wu * vv - wv * uv) / d, (wv * uu - wu * uv) / d);
    if d > 1e-12 * uu * vv && s > 0.0 && r > 0.0 && s + r < 1.0 {
        let foot = std::array::from_fn(|k| a[k] + s * u[k] + r * v[k]);
        return sides.min(length(minus(p, foot)));
    }
    sides
}

/// Of two segments: from their ends, and between their lines where the feet are inside.
pub fn segment_segment([a, b, c, d]: [V; 4]) -> f64 {
    let first = point_segment(a, c, d).min(point_segment(b, c, d));
    let ends = first.min(point_segment(c, a, b)).min(point_segment(d, a, b));
    let (u, v, w) = (minus(b, a), minus(d, c), minus(c, a));
    let (uu, uv, vv, wu, wv) = (dot(u, u), dot(u, v), dot(v, v), dot(w, u), dot(w, v));
    let det = uu * vv - uv * uv;
    let (s, r) = ((wu * vv - wv * uv) / det, (wu * uv - wv * uu) / det);
    if det > 1e-12 * uu * vv && s > 0.0 && s < 1.0 && r > 0.0 && r < 1.0 {
        return ends.min(length(minus(along(a, b, s), along(c, d, r))));
    }
    ends
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
    let path = |i: usize| minus(t1[i], t0[i]);
    let pairs = (0..n).flat_map(|i| (n..4).map(move |j| (i, j)));
    let speed = pairs.map(|(i, j)| length(minus(path(i), path(j)))).fold(0.0, f64::max);
    let mut t = 0.0;
    for _ in 0..4000 {
        let gap = distance(std::array::from_fn(|i| along(t0[i], t1[i], t))) - d;
        if gap <= 1e-10 * speed.min(1.0) * (1.0 + d) {
            // Not yet for certain: it must become clearly less at once.
            let soon = (t + 2e-9).min(1.0);
            let then = distance(std::array::from_fn(|i| along(t0[i], t1[i], soon))) - d;
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
