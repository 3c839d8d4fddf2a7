//! Bindings of the npm package `meshccd`: numbers in, places in memory out. `js/index.js` makes
//! classes and typed arrays of them, and its types are `js/index.d.ts`.
//!
//! Positions are written by JavaScript into buffers of a session, and results are read from columns
//! of it: nothing but numbers and short lists crosses the border as an argument. On other targets
//! the crate is empty.
#![cfg(target_arch = "wasm32")]
#![deny(unsafe_code)]

mod columns;
#[cfg(feature = "gpu")]
mod gpu;
mod options;
mod session;
#[cfg(feature = "gpu")]
mod watch;

use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    /// Milliseconds since some moment.
    #[wasm_bindgen(js_namespace = performance)]
    fn now() -> f64;
}

/// Gives the library a clock, and turns a panic into an `Error` with its text.
#[wasm_bindgen(start)]
fn start() {
    ccd::set_clock(now);
    #[cfg(feature = "gpu")]
    ccd::gpu::set_clock(now);
    std::panic::set_hook(Box::new(|info| {
        let text = info.to_string();
        #[cfg(feature = "gpu")]
        watch::tell(&text);
        wasm_bindgen::throw_str(&text)
    }));
}

/// Version of the package.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").into()
}

/// An `Error` with the text of a refusal.
fn refused(why: impl std::fmt::Display) -> JsError {
    JsError::new(&why.to_string())
}
