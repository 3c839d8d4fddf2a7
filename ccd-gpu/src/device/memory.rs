//! Bytes of buffers that a session may hold on its device: counted where buffers are created, and
//! where lists are replaced by longer ones.

use super::Device;
use crate::error::Error;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// A limit, and the bytes that are held.
#[derive(Debug)]
pub struct Memory {
    limit: u64,
    held: AtomicU64,
}

impl Memory {
    /// Nothing is held yet.
    pub fn new(limit: u64) -> Self {
        Self { limit, held: AtomicU64::new(0) }
    }

    /// Takes memory for a buffer.
    ///
    /// # Errors
    /// [`ccd_core::Error::Memory`]; nothing is taken then.
    pub fn take(&self, what: &'static str, bytes: u64) -> Result<(), ccd_core::Error> {
        let limit = self.limit;
        let more = |held: u64| held.checked_add(bytes).filter(|&sum| sum <= limit);
        let taken = self.held.fetch_update(Relaxed, Relaxed, more);
        taken.map(|_| ()).map_err(|held| ccd_core::Error::Memory { what, bytes, held, limit })
    }
}

impl Device {
    /// Gives back the memory of buffers that were replaced, or could not be created.
    pub(crate) fn give_back(&self, bytes: u64) {
        if let Some(memory) = self.memory() {
            memory.held.fetch_sub(bytes, Relaxed);
        }
    }

    /// Makes buffers; returns what they take, if there is a limit. If not all could be created,
    /// none is left.
    pub(crate) fn counting<T>(
        &self,
        make: impl FnOnce() -> Result<T, Error>,
    ) -> Result<(T, u64), Error> {
        let held = || self.memory().map_or(0, |memory| memory.held.load(Relaxed));
        let before = held();
        let made = make();
        let bytes = held() - before;
        if made.is_err() {
            self.give_back(bytes);
        }
        made.map(|made| (made, bytes))
    }
}
