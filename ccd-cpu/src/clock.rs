//! Times as reports give them, from a clock where there is one.
//!
//! In a browser, or under Node without WASI, there is none: the standard library compiles for
//! `wasm32-unknown-unknown`, and traps when it is asked for the time. There all times are 0, unless
//! a program gives its own clock (`set_clock`).

#[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
pub use std::time::Instant;

#[cfg(all(target_family = "wasm", target_os = "unknown"))]
pub use given::{Instant, set_clock};

/// Milliseconds of the clock since then.
pub fn milliseconds(since: Instant) -> f64 {
    since.elapsed().as_secs_f64() * 1e3
}

/// The clock of the program where the system has none.
#[cfg(all(target_family = "wasm", target_os = "unknown"))]
mod given {
    use std::sync::OnceLock;
    use std::time::Duration;

    static CLOCK: OnceLock<fn() -> f64> = OnceLock::new();

    /// Gives the times of reports a clock, on `wasm32-unknown-unknown`, where the standard library
    /// has none: `now` returns milliseconds, such as `performance.now()` does. The first one given
    /// stays; without one all times are 0.
    pub fn set_clock(now: fn() -> f64) {
        let _ = CLOCK.set(now);
    }

    /// A moment, in milliseconds.
    #[derive(Clone, Copy, Debug)]
    pub struct Instant(f64);

    impl Instant {
        pub fn now() -> Self {
            Self(CLOCK.get().map_or(0.0, |now| now()))
        }

        pub fn elapsed(&self) -> Duration {
            let Self(now) = Self::now();
            Duration::try_from_secs_f64((now - self.0) * 1e-3).unwrap_or_default()
        }
    }
}
