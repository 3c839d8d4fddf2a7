//! Times as reports give them, from a clock where there is one.
//!
//! In a browser, or under Node without WASI, there is none: there all times are 0, unless a program
//! gives its own clock (`set_clock`).

ccd_core::clock!();

/// Milliseconds of the clock since then.
pub fn milliseconds(since: Instant) -> f64 {
    since.elapsed().as_secs_f64() * 1e3
}
