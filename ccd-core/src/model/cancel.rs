//! A flag by which another thread ends a call of a session before its work is done.

use alloc::sync::Arc;
use core::sync::atomic::{AtomicBool, Ordering::Relaxed};

/// Ends calls of the sessions that have it: with [`Error::Cancelled`](super::error::Error), after
/// some milliseconds of work. Clones are one token, so that a clone can be kept by another thread;
/// one token may be that of many sessions.
///
/// A token stays cancelled. A session that has one refuses every call, and goes on with another
/// token, or without one, as a new session would.
///
/// ```
/// use ccd::CancelToken;
///
/// let token = CancelToken::new();
/// let of_another_thread = token.clone();
/// of_another_thread.cancel();
/// assert!(token.is_cancelled());
/// ```
#[derive(Clone, Debug, Default)]
pub struct CancelToken(Arc<AtomicBool>);

impl CancelToken {
    /// A token that is not cancelled.
    pub fn new() -> Self {
        Self::default()
    }

    /// Cancels, for good.
    pub fn cancel(&self) {
        self.0.store(true, Relaxed);
    }

    /// Whether it is cancelled.
    pub fn is_cancelled(&self) -> bool {
        self.0.load(Relaxed)
    }
}

/// A flag that a program has already, as for a signal: `true` cancels.
impl From<Arc<AtomicBool>> for CancelToken {
    fn from(flag: Arc<AtomicBool>) -> Self {
        Self(flag)
    }
}
