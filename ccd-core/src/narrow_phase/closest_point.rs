//! The point of a patch nearest to the origin: gives a direction to separate along, and an upper
//! bound of the distance.

use crate::math::real::Real;
use crate::math::vec3::{dot, scale, sub};
use crate::narrow_phase::relative_motion::Patch;

/// `x` limited to `[0, 1]`; NaN (from a side of no length) becomes 0.
#[inline]
fn unit<R: Real>(x: R) -> R {
    if x > R::splat(0.0) {
        if x < R::splat(1.0) { x } else { R::splat(1.0) }
    } else {
        R::splat(0.0)
    }
}

/// `a - x b` with the `x` in `[0, 1]` that makes it shortest.
#[inline]
fn to_segment<R: Real>(a: [R; 3], b: [R; 3]) -> [R; 3] {
    sub(a, scale(b, unit(dot(a, b) / dot(b, b))))
}

/// The shortest `a - s b - r c` with `(s, r)` in the patch, up to rounding.
///
/// Whatever rounding does, the result is some such vector, up to `6 u (A + B + C)` a component,
/// where `A B C` bound those of `a b c`: its length bounds the distance from above. For `s` and `r`
/// are within the patch as they are computed (their sum may exceed 1 by `u`), however wrong; then
/// `b s`, `c r`, their sum and the difference round by `u (A + 3 B + 3 C)`, and a side from a
/// corner, `(a - b) - (c - b) x`, by `u (2 A + 5 B + 3 C)`. A degenerate patch (collinear or zero
/// sides) is handled by its boundary.
pub fn closest<R: Real>(a: [R; 3], b: [R; 3], c: [R; 3], patch: Patch) -> [R; 3] {
    let (bb, bc, cc) = (dot(b, b), dot(b, c), dot(c, c));
    let (ab, ac) = (dot(a, b), dot(a, c));
    let det = bb * cc - bc * bc;
    let (zero, one) = (R::splat(0.0), R::splat(1.0));
    let s = (ab * cc - ac * bc) / det;
    let r = (ac * bb - ab * bc) / det;
    let within = match patch {
        Patch::Triangle => s >= zero && r >= zero && s + r <= one,
        Patch::Parallelogram => s >= zero && r >= zero && s <= one && r <= one,
    };
    // A lesser one is rounding, and so are `s` and `r`: sides that are parallel have their nearest
    // point on a side.
    if det > bb * cc * (R::UNIT * R::splat(64.0)) && within {
        return sub(a, [b[0] * s + c[0] * r, b[1] * s + c[1] * r, b[2] * s + c[2] * r]);
    }
    closest_of_sides(a, b, c, patch)
}

/// The same among the sides of the patch.
fn closest_of_sides<R: Real>(a: [R; 3], b: [R; 3], c: [R; 3], patch: Patch) -> [R; 3] {
    let a_b = sub(a, b);
    let sides = match patch {
        Patch::Triangle => {
            let hypotenuse = to_segment(a_b, sub(c, b));
            [to_segment(a, b), to_segment(a, c), hypotenuse, hypotenuse]
        }
        Patch::Parallelogram => {
            [to_segment(a, b), to_segment(a, c), to_segment(a_b, c), to_segment(sub(a, c), b)]
        }
    };
    let nearer = |p: [R; 3], q: [R; 3]| if dot(q, q) < dot(p, p) { q } else { p };
    nearer(nearer(nearer(sides[0], sides[1]), sides[2]), sides[3])
}

#[cfg(test)]
mod tests {
    use crate::narrow_phase::query::{EdgeEdge, Verdict, edge_edge};

    /// Diagonals of neighbouring cells of a grid, parallel but for the last digits, which lie 0.022
    /// apart in a plane.
    #[test]
    fn edges_that_are_parallel_but_for_rounding_are_told_apart() {
        let t0 = [
            [-0.8412698412698413, -0.007177598363243843, 0.6825396825396826],
            [-0.8730158730158729, -0.007577598363243842, 0.7142857142857142],
            [-0.8412698412698412, -0.007377598363243843, 0.7142857142857142],
            [-0.873015873015873, -0.0077775983632438405, 0.746031746031746],
        ];
        assert_eq!(edge_edge(&EdgeEdge { t0, t1: t0 }, 0.0), Verdict::<f64>::Miss);
    }
}
