//! Three-component arithmetic on plain arrays, over any [`Num`]: the same lines serve `f32`, `f64`
//! and SIMD lanes.

use crate::math::real::Num;

/// `a + b`
#[inline(always)]
pub fn add<N: Num>(a: [N; 3], b: [N; 3]) -> [N; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// `a - b`
#[inline(always)]
pub fn sub<N: Num>(a: [N; 3], b: [N; 3]) -> [N; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `s a`
#[inline(always)]
pub fn scale<N: Num>(a: [N; 3], s: N) -> [N; 3] {
    [a[0] * s, a[1] * s, a[2] * s]
}

/// `a + (b - a) t`
#[inline(always)]
pub fn lerp<N: Num>(a: [N; 3], b: [N; 3], t: N) -> [N; 3] {
    add(a, scale(sub(b, a), t))
}

/// Scalar product.
#[inline(always)]
pub fn dot<N: Num>(a: [N; 3], b: [N; 3]) -> N {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Vector product.
#[inline(always)]
pub fn cross<N: Num>(a: [N; 3], b: [N; 3]) -> [N; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Greatest absolute component.
#[inline(always)]
pub fn max_abs<N: Num>(a: [N; 3]) -> N {
    a[0].abs().max(a[1].abs()).max(a[2].abs())
}

/// Sum of absolute components: at least the length of `a`.
#[inline(always)]
pub fn sum_abs<N: Num>(a: [N; 3]) -> N {
    a[0].abs() + a[1].abs() + a[2].abs()
}
