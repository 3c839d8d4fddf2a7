//! For tests, and to say what a device flushes: what it reads from records, and what it makes of
//! the scalar operations that kernels use.

use crate::broad_phase::morton_key::{from_order_key, order_key};
use crate::kernel::memory::put;
use crate::layout::{Blocks, Leaf, MAX_LEVELS, Pair, Params, Path, Touch, join, split};
use crate::math::real::{Num, Real};

/// Words that [`params`] writes.
pub const PARAMS_WORDS: usize = size_of::<Params<Blocks>>() / 4;
/// Words that [`params`] and [`records`] write.
pub const WORDS: usize = PARAMS_WORDS + 8 + 4 + 7 + 2;

/// Writes the fields in their order.
#[inline(always)]
pub fn params(p: &Params<Blocks>, out: &mut [u32]) {
    let (frame, dispatch, args) = (&p.frame, &p.dispatch, &p.args);
    for k in 0..3 {
        put(out, k, frame.count[k]);
    }
    put(out, 3, frame.flags);
    for k in 0..4 {
        put(out, 4 + k, frame.start[k]);
    }
    put(out, 8, frame.margin.to_bits());
    put(out, 9, frame.path_error.to_bits());
    put(out, 10, frame.min_distance.to_bits());
    put(out, 11, frame.slack.to_bits());
    put(out, 12, frame.distance_bits[0]);
    put(out, 13, frame.distance_bits[1]);
    for k in 0..3 {
        put(out, 14 + 2 * k, frame.origin[k][0]);
        put(out, 15 + 2 * k, frame.origin[k][1]);
    }
    put(out, 20, frame.margin_bits[0]);
    put(out, 21, frame.margin_bits[1]);
    put(out, 22, frame.scale_bits[0]);
    put(out, 23, frame.scale_bits[1]);
    put(out, 24, frame.tolerance.to_bits());
    put(out, 25, frame.from.to_bits());
    put(out, 26, frame.until.to_bits());
    for k in 0..2 {
        put(out, 27 + k, frame.tolerance_bits[k]);
        put(out, 29 + k, frame.from_bits[k]);
        put(out, 31 + k, frame.until_bits[k]);
    }
    put(out, 33, dispatch.n);
    put(out, 34, dispatch.first);
    put(out, 35, dispatch.capacity_in);
    put(out, 36, dispatch.capacity_out);
    for level in 0..MAX_LEVELS {
        for k in 0..4 {
            put(out, 37 + 4 * level + k, args.slots[level][k]);
        }
    }
    let n = 37 + 4 * MAX_LEVELS;
    put(out, n, args.kind);
    put(out, n + 1, args.level);
    put(out, n + 2, args.step);
    put(out, n + 3, args.limit);
}

/// Writes the fields of one record of each type, behind those of [`params`].
#[inline(always)]
pub fn records(path: &Path, leaf: &Leaf, touch: &Touch, pair: &Pair, out: &mut [u32]) {
    let mut n = PARAMS_WORDS;
    for k in 0..4 {
        put(out, n + k, path.t0[k].to_bits());
        put(out, n + 4 + k, path.t1[k].to_bits());
    }
    n += 8;
    for k in 0..3 {
        put(out, n + k, leaf.vertices[k]);
    }
    put(out, n + 3, leaf.id);
    n += 4;
    put(out, n, touch.kind);
    put(out, n + 1, touch.state);
    put(out, n + 2, touch.a);
    put(out, n + 3, touch.b);
    put(out, n + 4, touch.toi[0]);
    put(out, n + 5, touch.toi[1]);
    put(out, n + 6, touch.approach);
    put(out, n + 7, pair.a);
    put(out, n + 8, pair.b);
}

/// Names of what [`scalars`] computes, in order.
pub const SCALARS: [&str; 24] = [
    "a + b",
    "a - b",
    "a * b",
    "a / b",
    "-a",
    "abs",
    "min",
    "max",
    "a < b",
    "a <= b",
    "a == b",
    "sqrt_up",
    "next_up",
    "next_down",
    "is_finite_number",
    "f32 to u32",
    "u32 to f32",
    "order_key",
    "from_order_key",
    "leading_zeros",
    "trailing_zeros",
    "count_ones",
    "wrapping_mul",
    "shifts",
];

/// Every operation in `f32` and `u32` that kernels use, of two words as numbers or as integers.
#[inline(always)]
pub fn scalars(input: [u32; 2]) -> [u32; 24] {
    let (i, j) = (input[0], input[1]);
    let (a, b) = (f32::from_bits(i), f32::from_bits(j));
    [
        (a + b).to_bits(),
        (a - b).to_bits(),
        (a * b).to_bits(),
        (a / b).to_bits(),
        (-a).to_bits(),
        Num::abs(a).to_bits(),
        Num::min(a, b).to_bits(),
        Num::max(a, b).to_bits(),
        (a < b) as u32,
        (a <= b) as u32,
        (a == b) as u32,
        a.sqrt_up().to_bits(),
        Real::next_up(a).to_bits(),
        Real::next_down(a).to_bits(),
        a.is_finite_number() as u32,
        // In range, as kernels see to.
        if a > 0.0 && a < 4.0e9 { a as u32 } else { 0 },
        (i as f32).to_bits(),
        order_key(a),
        from_order_key(i).to_bits(),
        i.leading_zeros(),
        i.trailing_zeros(),
        i.count_ones(),
        i.wrapping_mul(j),
        (i << (j & 31)) ^ (i >> (j & 31)),
    ]
}

/// Names of what [`wide`] computes, in order; each is two words.
pub const WIDE: [&str; 14] = [
    "a + b",
    "a - b",
    "a * b",
    "a / b",
    "abs",
    "min",
    "max",
    "a < b",
    "sqrt_up",
    "next_up",
    "next_down",
    "round_down, is_finite_number",
    "f32 to f64",
    "f64 to f32",
];

/// Every operation in `f64` that kernels use, of two numbers of two words each, and the conversion
/// to `f64`, which they do without, of the first word.
#[inline(always)]
pub fn wide(input: [u32; 4]) -> [u32; 28] {
    let (a, b) = (join([input[0], input[1]]), join([input[2], input[3]]));
    let results = [
        split(a + b),
        split(a - b),
        split(a * b),
        split(a / b),
        split(Num::abs(a)),
        split(Num::min(a, b)),
        split(Num::max(a, b)),
        [(a < b) as u32, (a <= b) as u32],
        split(a.sqrt_up()),
        split(Real::next_up(a)),
        split(Real::next_down(a)),
        [a.round_down().to_bits(), a.is_finite_number() as u32],
        split(f32::from_bits(input[0]) as f64),
        [(a as f32).to_bits(), 0],
    ];
    let mut out = [0; 28];
    for k in 0..14 {
        out[2 * k] = results[k][0];
        out[2 * k + 1] = results[k][1];
    }
    out
}
