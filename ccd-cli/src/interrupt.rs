//! Ctrl-C (SIGINT), and SIGTERM, by which clusters end jobs: the first one ends a command as an
//! error does, with status 130 or 143, so that it leaves whole files or none. Work that does not
//! look at signals is ended where it is, a second later or by a second signal, with the same status
//! and without its unfinished files.
//!
//! A command that neither writes files nor steps a mesh does not wait for them: the first one ends
//! it.

use super::{Failure, output};
use ccd::CancelToken;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::{flag, low_level};
use std::sync::atomic::Ordering::{Acquire, Relaxed};
use std::sync::atomic::{AtomicBool, AtomicUsize};
use std::sync::{Arc, OnceLock};
use std::thread;
use std::time::{Duration, Instant};

/// Time that work has to end by itself after the first signal.
const GRACE: Duration = Duration::from_secs(1);
/// Time between two looks at what signals have set.
const LOOK: Duration = Duration::from_millis(20);

/// What signals set.
#[derive(Clone, Default)]
struct Signals {
    /// Whether one came.
    came: Arc<AtomicBool>,
    /// The same, until the first one was seen; then whether another one came.
    again: Arc<AtomicBool>,
    /// The number of the last one.
    which: Arc<AtomicUsize>,
}

static SIGNALS: OnceLock<Signals> = OnceLock::new();

/// From the first call on, signals are waited for.
fn signals() -> &'static Signals {
    SIGNALS.get_or_init(|| {
        let signals = Signals::default();
        for signal in [SIGINT, SIGTERM] {
            // Where it cannot be waited for, it ends the program as ever.
            let _ = flag::register_usize(signal, signals.which.clone(), signal as usize)
                .and_then(|_| flag::register(signal, signals.again.clone()))
                .and_then(|_| flag::register(signal, signals.came.clone()));
        }
        let watched = signals.clone();
        thread::spawn(move || watched.end());
        signals
    })
}

impl Signals {
    /// Waits for the first signal and for what ends the program then. A handler may neither lock
    /// nor allocate, and so remove no files: handlers set flags, and a thread does the rest.
    fn end(&self) {
        // By `Acquire` what the same handler set before is seen, too.
        while !self.came.load(Acquire) {
            thread::sleep(LOOK);
        }
        self.again.store(false, Relaxed);
        let first = Instant::now();
        while !self.again.load(Relaxed) && first.elapsed() < GRACE {
            thread::sleep(LOOK);
        }
        let _none_begins = output::remove_unfinished();
        if !self.again.load(Relaxed) {
            interrupted().print();
        }
        // Nothing else is to run, such as what drivers of GPUs do at an exit while they work.
        low_level::exit(self.status().into())
    }

    fn status(&self) -> u8 {
        128 | self.which.load(Relaxed) as u8
    }
}

/// Why a command ends after a signal.
pub fn interrupted() -> Failure {
    Failure("interrupted".into())
}

/// The exit status after a signal: 128 and its number, as shells have it.
pub fn status() -> u8 {
    SIGNALS.get().map_or(0, Signals::status)
}

/// A token that cancels steps of a session.
pub fn token() -> CancelToken {
    signals().came.clone().into()
}

/// Whether a signal came.
pub fn happened() -> bool {
    SIGNALS.get().is_some_and(|signals| signals.came.load(Relaxed))
}

/// An error once one came.
pub fn check() -> Result<(), Failure> {
    if happened() { Err(interrupted()) } else { Ok(()) }
}
