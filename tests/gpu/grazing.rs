//! The generator of grazing queries and the exact arithmetic of the core's tests.

#[allow(dead_code, reason = "the core's tests use the rest")]
#[path = "../../ccd-core/tests/bounds/common/exact.rs"]
pub mod exact;
#[path = "../../ccd-core/tests/bounds/common/random.rs"]
pub mod random;
#[allow(dead_code, reason = "the core's tests use the rest")]
#[path = "../../ccd-core/tests/bounds/common/tangential.rs"]
pub mod tangential;

/// `v f0 f1 f2` or `ea0 ea1 eb0 eb1` at one time.
pub type Points<R> = [[R; 3]; 4];

/// Exactly the same points in `f64`.
pub fn widen<R: ccd_core::Real>(x: &Points<R>) -> Points<f64> {
    x.map(|p| p.map(|c| c.to_f64()))
}
