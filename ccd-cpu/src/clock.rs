//! Times as reports give them.

use std::time::Instant;

/// Milliseconds of the clock since then.
pub fn milliseconds(since: Instant) -> f64 {
    since.elapsed().as_secs_f64() * 1e3
}
