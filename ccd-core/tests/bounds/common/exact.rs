//! Zeros of a cubic and contacts of a query in integer arithmetic: nothing is rounded.

use super::Points;
use ccd_core::narrow_phase::relative_motion::Patch;
use num_bigint::BigInt;
use num_traits::{Float, Signed, Zero};

/// Halvings after which a zero is located well enough: 2^-56.
const NARROW: u32 = 56;
/// Halvings after which two zeros count as one that nobody decides.
const MAX_DEPTH: u32 = 110;

/// All numbers times one power of two that makes them integers.
pub fn integers<const N: usize>(x: [f64; N]) -> [BigInt; N] {
    let parts = x.map(|x| {
        assert!(x.is_finite(), "{x} is no coefficient");
        x.integer_decode()
    });
    let least = parts.iter().filter(|p| p.0 != 0).map(|p| p.1).min().unwrap_or(0);
    parts.map(|(m, e, sign)| match m {
        0 => BigInt::zero(),
        m => (BigInt::from(m) << (e - least)) * sign,
    })
}

/// Three times the control values of a cubic.
type Control = [BigInt; 4];

/// Where a cubic certainly changes its sign or is zero at an end.
struct Zeros {
    /// `k` of intervals `[k, k + 1] / 2^depth`, with the depth, ascending.
    at: Vec<(u128, u32)>,
    /// Whether these are all zeros: none without a change of sign, none closer together than
    /// `2^-MAX_DEPTH`.
    all: bool,
}

fn isolate(control: Control) -> Zeros {
    let mut out = Zeros { at: Vec::new(), all: true };
    // The interval [k, k + 1] / 2^depth.
    let mut stack = vec![(control, 0u128, 0u32)];
    while let Some((b, k, depth)) = stack.pop() {
        let signs: Vec<bool> = b.iter().filter(|b| !b.is_zero()).map(|b| b.is_positive()).collect();
        let variations = signs.windows(2).filter(|w| w[0] != w[1]).count();
        let zero_end = b[0].is_zero() || b[3].is_zero();
        if variations == 0 && !zero_end {
            continue;
        }
        if depth > MAX_DEPTH || signs.is_empty() {
            out.all = false;
            continue;
        }
        let changes = variations == 1 && !zero_end;
        if depth >= NARROW && (changes || zero_end && variations == 0) {
            out.at.push((k, depth));
            continue;
        }
        let [b0, b1, b2, b3] = b;
        let (b01, b12, b23) = (&b0 + &b1, &b1 + &b2, &b2 + &b3);
        let (b012, b123) = (&b01 + &b12, &b12 + &b23);
        let middle = &b012 + &b123;
        let first = [b0 << 3usize, b01 << 2usize, b012 << 1usize, middle.clone()];
        let second = [middle, b123 << 1usize, b23 << 2usize, b3 << 3usize];
        stack.push((second, 2 * k + 1, depth + 1));
        stack.push((first, 2 * k, depth + 1));
    }
    out
}

fn rounded_outward((k, depth): (u128, u32)) -> [f64; 2] {
    let at = |k: u128| k as f64 * 0.5f64.powi(depth as i32);
    [f64::next_down(at(k)).max(0.0), f64::next_up(at(k + 1)).min(1.0)]
}

/// Intervals of `[0, 1]`, at most 2^-56 wide (then rounded outward to `f64`), that certainly hold a
/// zero of `c[0] s^3 + c[1] s^2 t + c[2] s t^2 + c[3] t^3 + shift`, ascending. Zeros without a
/// change of sign, or closer together than 2^-110, are left out.
pub fn zeros(c: [f64; 4], shift: f64) -> Vec<[f64; 2]> {
    let [c0, c1, c2, c3, e] = integers([c[0], c[1], c[2], c[3], shift]);
    let (e3, three) = (&e * 3, BigInt::from(3));
    let control = [c0 * &three + &e3, c1 + &e3, c2 + &e3, c3 * &three + &e3];
    isolate(control).at.into_iter().map(rounded_outward).collect()
}

type Vector = [BigInt; 3];
/// Twice the control values of a quadratic.
type Quadratic = [BigInt; 3];

/// What is exactly true of a query. Sturm chains say the same (`ccd-testkit/src/sturm.rs`);
/// `tests/properties/exact.rs` compares them.
#[derive(Clone, Debug, PartialEq)]
pub enum Contact {
    /// None in `[0, 1]`.
    Free,
    /// There is one in this interval, and none that is certain before it; whether there is none at
    /// all before it.
    At([f64; 2], bool),
    /// Not decided: zeros that coincide, or lie on a boundary.
    Degenerate,
}

/// Of `v f0 f1 f2` or `ea0 ea1 eb0 eb1`.
pub fn contact(patch: Patch, t0: &Points<f64>, t1: &Points<f64>) -> Contact {
    let flat: [f64; 24] =
        std::array::from_fn(|i| if i < 12 { t0[i / 3][i % 3] } else { t1[i / 3 - 4][i % 3] });
    let x = integers(flat);
    let difference = |p: usize, q: usize| -> [Vector; 2] {
        [0, 12].map(|t| std::array::from_fn(|k| &x[t + 3 * p + k] - &x[t + 3 * q + k]))
    };
    let (a, b, c) = match patch {
        Patch::Triangle => (difference(0, 1), difference(2, 1), difference(3, 1)),
        Patch::Parallelogram => (difference(2, 0), difference(1, 0), difference(2, 3)),
    };
    let cross = |p: &Vector, q: &Vector, k: usize| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        &p[i] * &q[j] - &p[j] * &q[i]
    };
    let quadratic = |p: &[Vector; 2], q: &[Vector; 2], k: usize| -> Quadratic {
        let middle = cross(&p[0], &q[1], k) + cross(&p[1], &q[0], k);
        [cross(&p[0], &q[0], k) * 2, middle, cross(&p[1], &q[1], k) * 2]
    };
    let n: [Quadratic; 3] = std::array::from_fn(|k| quadratic(&b, &c, k));
    let dot = |t: usize, i: usize| (0..3).map(|k| &a[t][k] * &n[k][i]).sum::<BigInt>();
    // Six times the control values: index i of the product takes 1/3 or 2/3 of either way to split
    // i.
    let control =
        [dot(0, 0) * 3, dot(1, 0) + dot(0, 1) * 2, dot(0, 2) + dot(1, 1) * 2, dot(1, 2) * 3];
    let zeros = isolate(control);
    let mut certain = zeros.all;
    for at in zeros.at {
        let inside = (0..3).find_map(|k| {
            let (d, s, r) = (&n[k], quadratic(&a, &c, k), quadratic(&b, &a, k));
            let minus = |p: &Quadratic, q: &Quadratic| -> Quadratic {
                std::array::from_fn(|i| &p[i] - &q[i])
            };
            let positive = sign(d, at)?;
            let rest = match patch {
                Patch::Triangle => vec![minus(&minus(d, &s), &r), s, r],
                Patch::Parallelogram => vec![minus(d, &s), minus(d, &r), s, r],
            };
            let signs: Vec<Option<bool>> = rest.iter().map(|q| sign(q, at)).collect();
            if signs.contains(&Some(!positive)) {
                return Some(false);
            }
            signs.iter().all(|s| *s == Some(positive)).then_some(true)
        });
        match inside {
            Some(true) => return Contact::At(rounded_outward(at), certain),
            Some(false) => {}
            None => certain = false,
        }
    }
    if certain { Contact::Free } else { Contact::Degenerate }
}

/// The sign that a quadratic has all over `[k, k + 1] / 2^depth`, if its control values there show
/// one.
fn sign(q: &Quadratic, (k, depth): (u128, u32)) -> Option<bool> {
    let n = BigInt::from(1u128 << depth);
    let blossom = |u: u128, v: u128| {
        let (u, v) = (BigInt::from(u), BigInt::from(v));
        let (x, y) = (&n - &u, &n - &v);
        &q[0] * &x * &y + &q[1] * (x * &v + &u * y) + &q[2] * u * v
    };
    let values = [blossom(k, k), blossom(k, k + 1), blossom(k + 1, k + 1)];
    if values.iter().all(BigInt::is_positive) {
        Some(true)
    } else if values.iter().all(BigInt::is_negative) {
        Some(false)
    } else {
        None
    }
}

#[test]
fn zeros_of_known_cubics() {
    // (t - 1/4) (t - 1/2) (t - 3/4), times 32: factors are -s + 3 t, -s + t, -3 s + t.
    let all = zeros([-3.0, 13.0, -13.0, 3.0], 0.0);
    for r in [0.25, 0.5, 0.75] {
        assert!(all.iter().any(|[lo, hi]| *lo <= r && r <= *hi), "{r} is not in {all:?}");
    }
    assert!(zeros([1.0, 3.0, 3.0, 1.0], 0.0).is_empty());
    // 1 - shift is zero everywhere or nowhere; t - shift at one place.
    assert!(zeros([1.0, 3.0, 3.0, 1.0], -0.5).is_empty());
    let all = zeros([0.0, 1.0, 2.0, 1.0], -0.1);
    assert!(
        !all.is_empty() && all.iter().all(|[lo, hi]| *lo <= 0.1 && 0.1 <= *hi && hi - lo < 1e-15),
        "{all:?}"
    );
}
