//! Ctrl-C (SIGINT), and SIGTERM, by which clusters end jobs: the first one ends a command as an
//! error does, with status 130 or 143, so that it leaves whole files or none; the second one ends
//! it at once.
//!
//! A command that neither writes files nor steps a mesh does not wait for them: the first one ends
//! it.

use super::Failure;
use ccd::CancelToken;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};
use std::sync::{Arc, OnceLock};

/// Whether a signal came, and the number of the last one.
static CAME: OnceLock<(Arc<AtomicBool>, Arc<AtomicUsize>)> = OnceLock::new();

/// From the first call on, signals are waited for.
fn came() -> &'static (Arc<AtomicBool>, Arc<AtomicUsize>) {
    CAME.get_or_init(|| {
        let (came, which) = (Arc::new(AtomicBool::new(false)), Arc::new(AtomicUsize::new(0)));
        for signal in [SIGINT, SIGTERM] {
            // In this order: the first one must not find what it sets itself. Where it cannot be
            // waited for, it ends the program as ever.
            let _ = flag::register_conditional_shutdown(signal, 128 + signal, came.clone())
                .and_then(|_| flag::register_usize(signal, which.clone(), signal as usize))
                .and_then(|_| flag::register(signal, came.clone()));
        }
        (came, which)
    })
}

/// The exit status after a signal: 128 and its number, as shells have it.
pub fn status() -> u8 {
    CAME.get().map_or(0, |(_, which)| 128 | which.load(Relaxed) as u8)
}

/// A token that cancels steps of a session.
pub fn token() -> CancelToken {
    came().0.clone().into()
}

/// Whether a signal came.
pub fn happened() -> bool {
    CAME.get().is_some_and(|(came, _)| came.load(Relaxed))
}

/// An error once one came.
pub fn check() -> Result<(), Failure> {
    if happened() { Err(Failure("interrupted".into())) } else { Ok(()) }
}
