//! Cheap certificates that two features stay apart: a direction along which they are separated at
//! both ends of the step.
//!
//! Along a fixed direction, separation at `t = 0` and on the same side at `t = 1` is separation
//! throughout: positions are linear in time, so every difference of two positions along the
//! direction keeps its sign. Branch-free, for lanes.
//!
//! # The bound
//! Any direction `w` will do, so its own rounding does not matter; what must be known is how far
//! the computed `w . d` of a corner `d` is from the true one. Let `S = A + B + C` bound the
//! components of all corners and `|w|` be the sum of absolute components of `w`.
//!
//! - A corner carries at most `u S` from its differences and `2 u S` from at most two subtractions.
//! - Its product with `w` passes one multiplication and two additions: `3 u |w| S`.
//!
//! Together `6 u |w| S`; `17` leaves more than as much again for the roundings of `S`, of `|w|` and
//! of the comparison. Input: `3 e` a corner, `3.1` with its rounding. Flushing: a corner is off by
//! 5 times the smallest normal number a difference and 2 for its subtractions, below `256` a unit
//! of `|w|`; products and sums lose at most 5 more, and the terms of the bound 4, below `64`.
//! (Where operands are flushed, every operation sees the same `w`, which is a direction too.)
//! Overflow: a product or a sum is at most `|w| S`, so where one overflows `|w| 2 S` does, and the
//! result is negative infinity or NaN.

use crate::math::real::Num;
use crate::math::vec3::{add, cross, dot, sub, sum_abs};
use crate::narrow_phase::relative_motion::{Motion, Patch};

/// Whether one of the three axes keeps two features further than `needed >= 0` apart during the
/// whole step, from their boxes `[min, max]` at `t = 0` and `t = 1`.
///
/// One subtraction a side and time: where it is seen, the true gap exceeds `needed / (1 + u)`, so
/// `needed` must exceed what is wanted by that much, and by what the boxes lost by flushed operands
/// (none, if they were rounded outward to numbers that are not flushed). A difference that
/// overflows has the right sign; one that is NaN separates nothing.
#[inline(always)]
pub fn axis_separated<N: Num>(
    a0: &[[N; 3]; 2],
    a1: &[[N; 3]; 2],
    b0: &[[N; 3]; 2],
    b1: &[[N; 3]; 2],
    needed: N,
) -> N::Mask {
    // No closures: they would not be compiled for the instruction set of the caller.
    separated_on::<N, 0>(a0, a1, b0, b1, needed)
        | separated_on::<N, 1>(a0, a1, b0, b1, needed)
        | separated_on::<N, 2>(a0, a1, b0, b1, needed)
}

/// The same on axis `K`.
#[inline(always)]
fn separated_on<N: Num, const K: usize>(
    a0: &[[N; 3]; 2],
    a1: &[[N; 3]; 2],
    b0: &[[N; 3]; 2],
    b1: &[[N; 3]; 2],
    needed: N,
) -> N::Mask {
    let above = (a0[0][K] - b0[1][K]).gt(needed) & (a1[0][K] - b1[1][K]).gt(needed);
    let below = (b0[0][K] - a0[1][K]).gt(needed) & (b1[0][K] - a1[1][K]).gt(needed);
    above | below
}

/// Positive only if the features are certainly never closer than `min_distance`, because they pass
/// beside each other: tries the directions in the plane of the patch (halfway through the step)
/// that are perpendicular to its sides. The size means nothing; NaN where a computation overflowed.
#[inline(always)]
pub fn beside<N: Num>(m: &Motion<N>, patch: Patch, min_distance: N) -> N {
    // Twice the sides at t = 1/2; a direction needs no scale.
    let b = add(m.b[0], m.b[1]);
    let c = add(m.c[0], m.c[1]);
    let n = cross(b, c);
    let (corners0, corners1) = (m.corners(patch, 0), m.corners(patch, 1));
    let [ma, mb, mc] = m.magnitudes();
    let reach = Reach {
        size: (ma + mb + mc) * N::splat(2.0),
        needed: min_distance * N::splat(1.0001)
            + m.error * N::splat(3.1)
            + (N::MIN_NORMAL * N::splat(256.0)),
    };
    let along_b = apart(cross(n, b), &corners0, &corners1, &reach);
    let along_c = apart(cross(n, c), &corners0, &corners1, &reach);
    let best = along_b.max(along_c);
    if matches!(patch, Patch::Triangle) {
        best.max(apart(cross(n, sub(c, b)), &corners0, &corners1, &reach))
    } else {
        best
    }
}

/// What a separation must exceed.
struct Reach<N> {
    /// Twice a bound of the components of all corners: times the sum of the direction's, of every
    /// product with it.
    size: N,
    /// Distance and errors of the input, per unit of the direction.
    needed: N,
}

/// How far each of four points is along `w`.
#[inline(always)]
fn along<N: Num>(w: [N; 3], points: &[[N; 3]; 4]) -> [N; 4] {
    [dot(w, points[0]), dot(w, points[1]), dot(w, points[2]), dot(w, points[3])]
}

/// Separation along `w` beyond what is needed; `sum_abs` is at least the length of `w`.
///
/// If a product overflows, so does the sum of `w` times the size, and the result is not positive.
/// `17 / 2`: of twice the bound.
#[inline(always)]
fn apart<N: Num>(w: [N; 3], corners0: &[[N; 3]; 4], corners1: &[[N; 3]; 4], reach: &Reach<N>) -> N {
    // No loop: indices that are not constants would keep the corners out of a GPU's registers.
    let (a, b) = (along(w, corners0), along(w, corners1));
    let low = (a[0].min(a[1])).min(a[2].min(a[3])).min((b[0].min(b[1])).min(b[2].min(b[3])));
    let high = (a[0].max(a[1])).max(a[2].max(a[3])).max((b[0].max(b[1])).max(b[2].max(b[3])));
    let length = sum_abs(w);
    let rounding = (length * reach.size) * (N::UNIT * N::splat(17.0 / 2.0));
    low.max(-high) - rounding - length * reach.needed - (N::MIN_NORMAL * N::splat(64.0))
}
