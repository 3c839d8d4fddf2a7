//! Ctrl-C: the first one ends a command as an error does, with status 130, so that it leaves whole
//! files or none; the second one ends it at once.
//!
//! A command that neither writes files nor steps a mesh does not wait for it: the first one ends
//! it.

use super::Failure;
use ccd::CancelToken;
use signal_hook::consts::SIGINT;
use signal_hook::flag;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::sync::{Arc, OnceLock};

/// The exit status after Ctrl-C: 128 and the number of the signal, as shells have it.
pub const STATUS: u8 = 130;

static PRESSED: OnceLock<Arc<AtomicBool>> = OnceLock::new();

/// From the first call on, Ctrl-C is waited for.
fn pressed() -> &'static Arc<AtomicBool> {
    PRESSED.get_or_init(|| {
        let pressed = Arc::new(AtomicBool::new(false));
        // In this order: the first one must not find what it sets itself. Where it cannot be waited
        // for, it ends the program as ever.
        let at_once = flag::register_conditional_shutdown(SIGINT, STATUS.into(), pressed.clone());
        let _ = at_once.and_then(|_| flag::register(SIGINT, pressed.clone()));
        pressed
    })
}

/// A token that cancels steps of a session.
pub fn token() -> CancelToken {
    pressed().clone().into()
}

/// Whether Ctrl-C was pressed.
pub fn happened() -> bool {
    PRESSED.get().is_some_and(|pressed| pressed.load(Relaxed))
}

/// An error once Ctrl-C was pressed.
pub fn check() -> Result<(), Failure> {
    if happened() { Err(Failure("interrupted".into())) } else { Ok(()) }
}
