//! Times as reports give them, from a clock where there is one.
//!
//! In a browser, or under Node without WASI, there is none: the standard library compiles for
//! `wasm32-unknown-unknown`, and traps when it is asked for the time. There all times are 0.

#[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
pub use std::time::Instant;

#[cfg(all(target_family = "wasm", target_os = "unknown"))]
pub use none::Instant;

/// Milliseconds of the clock since then.
pub fn milliseconds(since: Instant) -> f64 {
    since.elapsed().as_secs_f64() * 1e3
}

/// What stands for a clock where there is none.
#[cfg(all(target_family = "wasm", target_os = "unknown"))]
mod none {
    use std::time::Duration;

    /// A moment: the same as every other.
    #[derive(Clone, Copy, Debug)]
    pub struct Instant;

    impl Instant {
        pub fn now() -> Self {
            Self
        }

        pub fn elapsed(&self) -> Duration {
            Duration::ZERO
        }
    }
}
