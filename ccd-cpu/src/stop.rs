//! What ends a call before its work is done: its token was cancelled, or a list would have to be
//! longer than the limit of memory allows. Workers look at it between pieces of work, and leave the
//! rest undone; whoever started the work asks for the error once they have come back, and uses
//! nothing of what they made.

use ccd_core::Error;
use ccd_core::model::cancel::CancelToken;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::Relaxed};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Whether to go on. The first reason not to is kept until the next call begins, whatever becomes
/// of the token in the meantime.
#[derive(Debug, Default)]
pub struct Stop {
    token: Option<CancelToken>,
    /// Bytes that may be held; `None`: any number.
    limit: Option<u64>,
    held: AtomicU64,
    stopped: AtomicBool,
    why: Mutex<Option<Error>>,
}

impl Stop {
    /// By a token, if there is one, and a limit of bytes, if there is one, of which so many are
    /// held.
    pub fn new(token: Option<CancelToken>, limit: Option<u64>, held: u64) -> Self {
        Self { token, limit, held: held.into(), ..Self::default() }
    }

    /// The token.
    pub fn token(&self) -> Option<&CancelToken> {
        self.token.as_ref()
    }

    /// A call begins.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub fn begin(&self) -> Result<(), Error> {
        *self.why() = None;
        self.stopped.store(false, Relaxed);
        self.check()
    }

    /// Whether the call is to end.
    #[inline]
    pub fn is_stopped(&self) -> bool {
        self.stopped.load(Relaxed)
            || self.token.as_ref().is_some_and(CancelToken::is_cancelled)
                && self.end(Error::Cancelled)
    }

    /// Whether everything was done since [`Stop::begin`], or why not.
    ///
    /// # Errors
    /// [`Error::Cancelled`] and [`Error::Memory`].
    pub fn check(&self) -> Result<(), Error> {
        if self.is_stopped() { Err(self.why().unwrap_or(Error::Cancelled)) } else { Ok(()) }
    }

    /// Whether there is a limit of memory: then nothing is allocated for later alone.
    pub fn is_limited(&self) -> bool {
        self.limit.is_some()
    }

    /// Bytes that are held, if there is a limit.
    pub fn held(&self) -> u64 {
        self.held.load(Relaxed)
    }

    /// So many bytes are held, and no more.
    pub fn hold(&self, bytes: u64) {
        self.held.store(bytes, Relaxed);
    }

    /// Bytes that may still be allocated.
    #[cfg(feature = "catalogue")]
    pub fn left(&self) -> u64 {
        self.limit.map_or(u64::MAX, |limit| limit.saturating_sub(self.held.load(Relaxed)))
    }

    /// Takes so many bytes; whether the limit allows it. Ends nothing.
    pub fn take(&self, bytes: u64) -> bool {
        let Some(limit) = self.limit else { return true };
        let more = |held: u64| held.checked_add(bytes).filter(|&sum| sum <= limit);
        self.held.fetch_update(Relaxed, Relaxed, more).is_ok()
    }

    /// Makes sure that so many items can be added to a list; without a limit the list does so
    /// itself. If the limit does not allow it, the call ends, and nothing may be added.
    #[inline]
    #[must_use]
    pub fn reserve<T>(&self, what: &'static str, list: &mut Vec<T>, more: usize) -> bool {
        self.limit.is_none() || more <= list.capacity() - list.len() || self.grow(what, list, more)
    }

    /// To twice the capacity, or less, if that is enough.
    #[cold]
    fn grow<T>(&self, what: &'static str, list: &mut Vec<T>, more: usize) -> bool {
        self.allocate(what, list, (list.len() + more).max(2 * list.capacity()) - list.len(), more)
    }

    /// Makes a list long enough for `wanted` more items, or for fewer, down to `least`, as the
    /// limit allows. If it allows not even these, the call ends, and nothing may be added.
    #[must_use]
    pub fn allocate<T>(
        &self,
        what: &'static str,
        list: &mut Vec<T>,
        wanted: usize,
        least: usize,
    ) -> bool {
        let bytes = |more: usize| ((list.len() + more - list.capacity()) * size_of::<T>()) as u64;
        let mut granted = wanted.max(least);
        while !self.take(bytes(granted)) {
            if granted == least {
                let (held, limit) = (self.held.load(Relaxed), self.limit.unwrap_or(u64::MAX));
                self.end(Error::Memory { what, bytes: bytes(least), held, limit });
                return false;
            }
            granted = (granted / 2).max(least);
        }
        list.reserve_exact(granted);
        true
    }

    /// Has workers leave what they have not begun, because what they found is enough. Until the
    /// next call begins, [`Stop::check`] takes it for a cancellation.
    pub fn enough(&self) {
        self.stopped.store(true, Relaxed);
    }

    fn end(&self, why: Error) -> bool {
        self.why().get_or_insert(why);
        self.stopped.store(true, Relaxed);
        true
    }

    fn why(&self) -> MutexGuard<'_, Option<Error>> {
        self.why.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
