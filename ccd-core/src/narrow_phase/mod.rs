//! One vertex against one face, or two edges: filters first, then a certified verdict.

pub mod approach;
pub mod cascade;
pub mod closest_point;
pub mod conservative_advancement;
pub mod containment;
pub mod coplanarity;
pub mod cubic_roots;
pub mod decide;
pub mod query;
pub mod relative_motion;
pub mod search;
pub mod separating_direction;
