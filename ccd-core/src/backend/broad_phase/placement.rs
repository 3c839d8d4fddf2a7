//! Map: a vertex as it was given, in `f64`, to what other kernels read of it: its path in `f32`,
//! the exact bounds of its box as keys, its box.
//!
//! For devices with `f64`; a host does the same for the others. Positions of all vertices at the
//! start of the step come first, then those at its end.

use super::candidate::{above, bound_key};
use crate::kernel::memory::at;
use crate::layout::{Frame, Path, join, split};
use crate::math::aabb::Aabb;
use crate::math::real::{Num, Real};

/// Positions of vertex `i` at both ends of the step.
#[inline(always)]
pub fn given(i: u32, frame: &Frame, positions: &[[f64; 3]]) -> ([f64; 3], [f64; 3]) {
    (at(positions, i as usize), at(positions, (frame.count[0] + i) as usize))
}

/// The path of a vertex relative to the origin, in the unit of paths.
#[inline(always)]
pub fn path(p: [f64; 3], q: [f64; 3], frame: &Frame) -> Path {
    let mut out = Path { t0: [0.0; 4], t1: [0.0; 4] };
    for k in 0..3 {
        let (origin, scale) = (join(frame.origin[k]), join(frame.scale_bits));
        out.t0[k] = nearest((p[k] - origin) * scale);
        out.t1[k] = nearest((q[k] - origin) * scale);
    }
    out
}

/// The box of a vertex in `f64`, grown by the margin. Its ends are compared as integers, because a
/// device may compare as if denormals were zero, and boxes are compared by integers.
#[inline(always)]
pub fn exact_box(p: [f64; 3], q: [f64; 3], frame: &Frame) -> Aabb<f64> {
    let mut out = Aabb { min: p, max: q };
    for k in 0..3 {
        if above(bound_key(p[k]), bound_key(q[k])) {
            out.min[k] = q[k];
            out.max[k] = p[k];
        }
    }
    out.inflated(join(frame.margin_bits))
}

/// Bounds of a box as integers of the same order: `min`, then `max`.
#[inline(always)]
pub fn keys(b: &Aabb<f64>) -> [[u32; 2]; 6] {
    let (min, max) = (b.min, b.max);
    [
        bound_key(min[0]),
        bound_key(min[1]),
        bound_key(min[2]),
        bound_key(max[0]),
        bound_key(max[1]),
        bound_key(max[2]),
    ]
}

/// The box in `f32`, rounded outward; numbers that a device may flush become zero or the smallest
/// normal number.
#[inline(always)]
pub fn rounded(b: &Aabb<f64>) -> Aabb<f32> {
    let mut out = b.round_out();
    for k in 0..3 {
        out.min[k] = if is_tiny(out.min[k]) { -flushed_up(-b.min[k]) } else { out.min[k] };
        out.max[k] = if is_tiny(out.max[k]) { flushed_up(b.max[k]) } else { out.max[k] };
    }
    out
}

#[inline(always)]
fn is_tiny(x: f32) -> bool {
    x < f32::MIN_NORMAL && x > -f32::MIN_NORMAL
}

/// Zero or the smallest normal number, whichever is not below `x`, which is below that number. By
/// bits, because a device may compare as if `x` were zero.
#[inline(always)]
fn flushed_up(x: f64) -> f32 {
    let bits = split(x);
    let positive = bits[1] >> 31 == 0 && (bits[0] | bits[1]) != 0;
    if positive { f32::MIN_NORMAL } else { 0.0 }
}

/// The `f32` nearest to `x`, of two the even one, however a device rounds when it converts.
#[inline(always)]
fn nearest(x: f64) -> f32 {
    let (low, high) = (x.round_down(), x.round_up());
    let (above, below) = (x - low as f64, high as f64 - x);
    if above < below || (above == below && low.to_bits() & 1 == 0) { low } else { high }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    #[test]
    fn nearest_is_the_conversion_of_the_standard_library() {
        let mut random = Random::new(1);
        for _ in 0..100_000 {
            let state = (random.bits() as u64) << 32 | random.bits() as u64;
            // Exponents from 2^-100 to 2^100; every fourth exactly between two f32.
            let exponent = (1023 - 100 + (state >> 50) % 200) << 52;
            let all = state >> 12;
            let tie = all & !0x1fff_ffff | 0x1000_0000;
            let fraction = if state.is_multiple_of(4) { tie } else { all };
            let x = f64::from_bits(state >> 63 << 63 | exponent | fraction & ((1 << 52) - 1));
            assert_eq!(nearest(x).to_bits(), (x as f32).to_bits(), "{x:e}");
        }
        assert_eq!(nearest(0.0), 0.0);
    }

    #[test]
    fn boxes_hold_the_exact_ones_also_where_numbers_are_tiny() {
        for x in
            [0.0, -0.0, 1e-40, -1e-40, 1e-310, -1e-310, 1e-38, -1e-38, 2e-38, 1.0 / 3.0, -1.0 / 3.0]
        {
            let b = rounded(&Aabb { min: [x; 3], max: [x; 3] });
            assert!(b.min[0] as f64 <= x && b.max[0] as f64 >= x, "{x:e}: {b:?}");
            let fine = |y: f32| y == 0.0 || y.abs() >= f32::MIN_POSITIVE;
            assert!(fine(b.min[0]) && fine(b.max[0]), "{x:e}: {b:?}");
        }
    }
}
