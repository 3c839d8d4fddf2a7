//! Generators and exact arithmetic of the core's own tests: queries that nearly graze, contacts in
//! integers, distances, squares of them in rational numbers.

#[allow(missing_docs, reason = "as in the tests it comes from")]
#[path = "../../ccd-core/tests/bounds/common/distance.rs"]
pub mod distance;
#[path = "../../ccd-core/tests/bounds/common/exact.rs"]
pub mod exact;
#[allow(missing_docs, reason = "as in the tests it comes from")]
#[path = "../../ccd-core/tests/bounds/common/exact_distance.rs"]
pub mod exact_distance;
#[allow(missing_docs, reason = "as in the tests it comes from")]
#[path = "../../ccd-core/tests/bounds/common/random.rs"]
pub mod random;
#[allow(missing_docs, reason = "as in the tests it comes from")]
#[path = "../../ccd-core/tests/bounds/common/tangential.rs"]
pub mod tangential;

/// `v f0 f1 f2` or `ea0 ea1 eb0 eb1` at one time.
pub type Points<R> = [[R; 3]; 4];

/// Exactly the same points in `f64`.
pub fn widen<R: ccd_core::Real>(x: &Points<R>) -> Points<f64> {
    x.map(|p| p.map(|c| c.to_f64()))
}
