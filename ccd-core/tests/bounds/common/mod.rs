//! What the integration tests share: random numbers, exact arithmetic, generators of hard cases.

pub mod adversary;
pub mod ascent;
pub mod distance;
pub mod exact;
pub mod exact_distance;
pub mod motion;
pub mod oriented;
pub mod random;
pub mod tangential;

/// `v f0 f1 f2` or `ea0 ea1 eb0 eb1` at one time.
pub type Points<R> = [[R; 3]; 4];

/// Exactly the same points in `f64`.
pub fn widen<R: ccd_core::Real>(x: &Points<R>) -> Points<f64> {
    x.map(|p| p.map(|c| c.to_f64()))
}
