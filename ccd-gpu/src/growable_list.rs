//! Lists that kernels append to: a header that counts the entries wanted, then as many of them as
//! the capacity allows.

use crate::device::Device;
use crate::error::Error;
use crate::readback::word;
use ccd_core::backend::layout::{Dispatch, LIST_HEADER, Pair};
use wgpu::BufferUsages as U;

/// Bytes of a header.
pub const HEADER_BYTES: u64 = 4 * LIST_HEADER as u64;

/// What the header of a list says.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Header {
    /// Entries wanted, which may exceed the capacity.
    pub wanted: u32,
    /// Of candidates: those looked at; of pairs of both kinds: those of edges.
    pub second: u32,
}

/// The header of a list that was read; a count that ran over is refused.
pub fn read_header(bytes: &[u8]) -> Result<Header, Error> {
    for i in [0, 1] {
        if word(bytes, i + 2) > 0 {
            let count = (word(bytes, i + 2) as u64) << 32 | word(bytes, i) as u64;
            return Err(ccd_core::Error::TooMany {
                element: "overlapping pairs",
                count,
                limit: u32::MAX as u64,
            }
            .into());
        }
    }
    Ok(Header { wanted: word(bytes, 0), second: word(bytes, 1) })
}

/// The same of candidates that were listed a part at a time: the most that a part wanted, if that
/// is more than fits; else of the last.
pub fn read_header_of_parts(bytes: &[u8]) -> Result<Header, Error> {
    let most = word(bytes, 2).max(word(bytes, 0));
    let words = [0, word(bytes, 1), 0, word(bytes, 3)];
    Ok(Header { wanted: most, ..read_header(bytemuck::bytes_of(&words))? })
}

/// The pairs of a list that was read.
pub fn read_pairs(bytes: &[u8]) -> Vec<Pair> {
    bytemuck::pod_collect_to_vec(&bytes[HEADER_BYTES as usize..])
}

/// Runs of one search, at most. A run that was not complete makes a list longer by a quarter at
/// least, or parts half as large, or rounds or turns of workers twice as many: dozens are more than
/// any scene asks for.
const MOST_RUNS: u32 = 100;
/// Entries that a guess is not below.
const LEAST_GUESS: u32 = 4096;

/// The runs of one search so far.
#[derive(Debug, Default)]
pub struct Runs(u32);

impl Runs {
    /// Another one, because a list was too short, or pairs were left.
    ///
    /// # Errors
    /// [`Error::Incomplete`] after the last.
    pub fn another(&mut self) -> Result<(), Error> {
        if self.0 == MOST_RUNS {
            return Err(Error::Incomplete { runs: MOST_RUNS });
        }
        self.0 += 1;
        Ok(())
    }
}

/// The dispatches over `n` items, or entries of a list with that capacity, of at most `limit` each.
pub fn parts(n: u32, limit: u32, capacity_out: u32) -> impl Iterator<Item = Dispatch> {
    (0..n).step_by(limit as usize).map(move |first| Dispatch {
        n: (n - first).min(limit),
        first,
        capacity_in: n,
        capacity_out,
    })
}

/// A list on the device.
///
/// ```no_run
/// use ccd::gpu::{Error, Session};
///
/// // The first `n` entries of a list are in the first `bytes(n)` of `buffer()`.
/// fn show(session: &mut Session, x: &[[f32; 3]]) -> Result<(), Error> {
///     for list in session.candidates_on_device(x, x)? {
///         println!("{} pairs fit in {} bytes", list.capacity(), list.bytes(list.capacity()));
///     }
///     Ok(())
/// }
/// # let _ = show;
/// ```
#[derive(Clone, Debug)]
pub struct List {
    what: &'static str,
    buffer: wgpu::Buffer,
    /// Entries that fit.
    capacity: u32,
    /// 32-bit words of an entry; 0: no entries and no capacity for one, so that a header which
    /// counts any says that a search is not complete.
    words: u32,
    /// Whether more entries were wanted than fit when [`List::grow`] looked last.
    was_short: bool,
}

impl List {
    /// A list with a capacity of entries of `words` words each.
    ///
    /// # Errors
    /// [`Error::TooLarge`] and [`Error::OutOfMemory`].
    pub fn new(
        device: &Device,
        what: &'static str,
        words: u32,
        capacity: u32,
    ) -> Result<Self, Error> {
        let bytes = HEADER_BYTES + capacity as u64 * words as u64 * 4;
        let buffer = device.buffer(what, bytes, U::STORAGE | U::COPY_SRC | U::COPY_DST)?;
        Ok(Self { what, buffer, capacity, words, was_short: false })
    }

    /// A list for a number of entries that is a guess: of fewer where the device binds or has less.
    ///
    /// # Errors
    /// Those of [`List::new`].
    pub fn guessed(
        device: &Device,
        what: &'static str,
        words: u32,
        entries: u32,
    ) -> Result<Self, Error> {
        match Self::new(device, what, words, entries) {
            Err(e) if e.is_of_memory() && entries > LEAST_GUESS => {
                Self::guessed(device, what, words, (entries / 2).max(LEAST_GUESS))
            }
            other => other,
        }
    }

    /// A list that holds these pairs from the start.
    ///
    /// # Errors
    /// Those of [`List::new`].
    pub fn of_pairs(
        device: &Device,
        what: &'static str,
        pairs: &[[u32; 2]],
    ) -> Result<Self, Error> {
        let list = Self::new(device, what, 2, pairs.len() as u32)?;
        let mut words = vec![pairs.len() as u32, 0, 0, 0];
        words.extend(pairs.iter().flatten());
        device.write(what, &list.buffer, 0, bytemuck::cast_slice(&words))?;
        Ok(list)
    }

    /// The buffer: a header of four words, of which the first is the number of entries wanted and
    /// the third is 0 unless that exceeds 32 bits, or, of the candidates of a step, a part of it
    /// wanted more than fit; then the entries.
    pub fn buffer(&self) -> &wgpu::Buffer {
        &self.buffer
    }

    /// Entries that fit.
    pub fn capacity(&self) -> u32 {
        self.capacity
    }

    /// Bytes of the header and `n` entries, at most of all.
    pub fn bytes(&self, n: u32) -> u64 {
        HEADER_BYTES + n.min(self.capacity) as u64 * self.words as u64 * 4
    }

    /// The same list with another capacity; one without entries stays as it is.
    ///
    /// # Errors
    /// Those of [`List::new`].
    pub fn resized(&self, device: &Device, capacity: u32) -> Result<Self, Error> {
        Self::new(device, self.what, self.words, if self.words == 0 { 0 } else { capacity })
    }

    /// A list of at least this capacity: one that was made for the same purpose, if it is large
    /// enough, else a new one.
    ///
    /// # Errors
    /// Those of [`List::new`].
    pub fn reusing(
        device: &Device,
        old: Option<&Self>,
        what: &'static str,
        words: u32,
        capacity: u32,
    ) -> Result<Self, Error> {
        match old {
            Some(old) if old.capacity >= capacity && old.words == words => Ok(old.clone()),
            _ => Self::new(device, what, words, capacity),
        }
    }

    /// Replaces a shorter list for the same purpose.
    pub fn replace_shorter(&self, other: &mut Self) {
        if other.what == self.what && other.words == self.words && other.capacity < self.capacity {
            *other = self.clone();
        }
    }

    /// Whether more entries were wanted than fit in the last search that was read.
    pub(crate) fn was_short(&self) -> bool {
        self.was_short
    }

    /// Grows every list, each given with what was wanted of it, also after one that cannot grow: a
    /// list that is left out would not know of this search. Returns whether any was too short.
    ///
    /// # Errors
    /// The first of those of [`List::grow`].
    pub(crate) fn grow_all<'a>(
        device: &Device,
        lists: impl IntoIterator<Item = (&'a mut Self, u32)>,
    ) -> Result<bool, Error> {
        let mut any = Ok(false);
        for (list, wanted) in lists {
            let grown = list.grow(device, wanted);
            any = any.and_then(|any| Ok(any | grown?));
        }
        any
    }

    /// Replaces the list by a larger one if more entries were `wanted` than fit. Returns whether it
    /// was too short.
    ///
    /// # Errors
    /// Those of [`List::new`].
    pub fn grow(&mut self, device: &Device, wanted: u32) -> Result<bool, Error> {
        self.was_short = wanted > self.capacity;
        if !self.was_short || self.words == 0 {
            return Ok(self.was_short);
        }
        // Some more, as the next frame may want more; without it where the device has too little
        // for that.
        let larger = wanted.saturating_add(wanted / 4);
        let before = self.buffer.size();
        *self = match Self::new(device, self.what, self.words, larger) {
            Err(e) if e.is_of_memory() => Self::new(device, self.what, self.words, wanted)?,
            other => other?,
        };
        device.give_back(before);
        Ok(true)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_end() {
        let mut runs = Runs::default();
        let n = (0..u32::MAX).take_while(|_| runs.another().is_ok()).count();
        assert_eq!(n, MOST_RUNS as usize);
        let why = runs.another().unwrap_err();
        assert!(matches!(why, Error::Incomplete { runs: MOST_RUNS }), "{why}");
    }

    #[test]
    fn counts_that_ran_over_are_refused() {
        let header = |words: [u32; 4]| read_header(bytemuck::cast_slice(&words));
        assert_eq!(header([7, u32::MAX, 0, 0]).unwrap(), Header { wanted: 7, second: u32::MAX });
        for (words, count) in [([5, 0, 1, 0], "4294967301"), ([5, 6, 0, 2], "8589934598")] {
            let error = header(words).unwrap_err().to_string();
            assert!(error.contains(count) && error.contains("4294967295"), "{error}");
        }
    }
}
