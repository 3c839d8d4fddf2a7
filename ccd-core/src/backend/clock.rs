//! The text of a clock that may be missing, for the backends: the core itself asks for no time.

/// For a file of a backend: `Instant`, of the standard library where that has one. On
/// `wasm32-unknown-unknown` it traps when it is asked for the time: there all times are 0, unless a
/// program gives its own clock, by `set_clock`.
#[doc(hidden)]
#[macro_export]
macro_rules! clock {
    () => {
        #[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
        pub use std::time::Instant;

        #[cfg(all(target_family = "wasm", target_os = "unknown"))]
        pub use given::{Instant, set_clock};

        /// The clock of the program where the system has none.
        #[cfg(all(target_family = "wasm", target_os = "unknown"))]
        mod given {
            use std::sync::OnceLock;
            use std::time::Duration;

            static CLOCK: OnceLock<fn() -> f64> = OnceLock::new();

            /// Gives the times of reports a clock, on `wasm32-unknown-unknown`, where the standard
            /// library has none: `now` returns milliseconds, such as `performance.now()` does. The
            /// first one given stays; without one all times are 0.
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
    };
}
