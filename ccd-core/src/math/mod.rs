//! Numbers, vectors, boxes and space-filling codes that everything else is written with.

pub mod aabb;
#[cfg(any(feature = "alloc", test))]
pub mod expansion;
pub mod f64_bits;
pub mod hilbert;
pub mod morton;
pub mod obb;
pub mod q62;
pub mod real;
pub mod symmetric_eigen;
pub mod vec3;
