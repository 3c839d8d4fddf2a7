//! One vertex against one face, or two edges: filters first, then a certified verdict.

pub mod approach;
pub mod cascade;
pub mod closest_point;
#[cfg(any(feature = "alloc", test))]
pub mod codimensional;
pub mod conservative_advancement;
pub mod contact_geometry;
pub mod containment;
pub mod coplanarity;
pub mod cubic_roots;
pub mod decide;
#[cfg(any(feature = "alloc", test))]
pub mod distance;
#[cfg(any(feature = "alloc", test))]
pub mod exact;
#[cfg(any(feature = "alloc", test))]
mod exact_distance;
pub mod integer_search;
#[cfg(any(feature = "alloc", test))]
pub mod intersection;
pub mod pair_verdict;
pub mod query;
pub mod relative_motion;
pub mod search;
pub mod separating_direction;
pub mod squared_distance;
pub mod touch_geometry;
