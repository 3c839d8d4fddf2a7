//! Errors of the input where they are worst: those of three differences, independent of each other.
//!
//! Features that touch in truth, in the corner where both sides end; each given difference is off
//! by the input error, all of them along the direction that is tried.

use crate::common::random::Random;
use ccd_core::Real;
use ccd_core::math::vec3::{add, cross, scale};
use ccd_core::narrow_phase::conservative_advancement::{Advance, advance};
use ccd_core::narrow_phase::relative_motion::{Motion, Patch};
use ccd_core::narrow_phase::separating_direction::beside;

/// Two edges that end in each other, given by vectors that are off by `part` of `error` along the
/// signs of `w`, so that they seem to be `3 part error` apart in each component.
fn ends<R: Real>(b: [f64; 3], c: [f64; 3], w: [f64; 3], part: f64, error: f64) -> Motion<R> {
    let off = w.map(|x| part * error * if x < 0.0 { -3.0 } else { 3.0 });
    let a = add(add(b, c), off);
    let [a, b, c] = [a, b, c].map(|v| [v.map(R::from_f64); 2]);
    Motion { a, b, c, error: R::from_f64(error) }
}

fn check_beside<R: Real>(random: &mut Random) -> usize {
    let (b, c) = (random.vector(), random.vector());
    let n = cross(b, c);
    let mut n_far = 0;
    for (side, other) in [(b, c), (c, b)] {
        let w = cross(n, side);
        // Towards the side on which the other edge is.
        let along = (0..3).map(|k| w[k] * other[k]).sum::<f64>();
        let w = scale(w, if along < 0.0 { -1.0 } else { 1.0 });
        let apart = |part: f64| {
            beside(&ends::<R>(b, c, w, part, 1e-3), Patch::Parallelogram, R::splat(0.0))
        };
        assert!(!(apart(0.999) > R::splat(0.0)), "{b:?} {c:?} {w:?} touch");
        n_far += (apart(1.05) > R::splat(0.0)) as usize;
    }
    n_far
}

fn check_advance<R: Real>(random: &mut Random) -> usize {
    // Both sides ahead of the corner along the way from it.
    let w = random.vector();
    let ahead = |v: [f64; 3]| [0, 1, 2].map(|k| if w[k] < 0.0 { -v[k].abs() } else { v[k].abs() });
    let (b, c) = (ahead(random.vector()), ahead(random.vector()));
    let (zero, one, tolerance) = (R::splat(0.0), R::splat(1.0), R::splat(1e-6));
    let free = |part: f64| {
        advance(&ends::<R>(b, c, w, part, 1e-3), Patch::Parallelogram, zero, one, zero, tolerance)
            == Advance::Clear
    };
    assert!(!free(0.999), "{b:?} {c:?} {w:?} touch");
    free(1.05) as usize
}

fn check<R: Real>(seed: u64) {
    const N: usize = 500;
    let mut random = Random::new(seed);
    let mut n = [0; 2];
    for _ in 0..N {
        n[0] += check_beside::<R>(&mut random);
        n[1] += check_advance::<R>(&mut random);
    }
    // The control: a little further apart is seen.
    println!("{n:?}");
    assert!(n[0] > N && n[1] > N / 2, "{n:?} of {N} are told apart");
}

#[test]
fn errors_of_three_differences_separate_nothing() {
    check::<f64>(1);
    check::<f32>(2);
}
