//! Numbers, vectors, boxes and space-filling codes that everything else is written with.

pub mod aabb;
pub mod morton;
pub mod real;
pub mod vec3;
