//! Fronts: the pairs of nodes where a descent ended, from which the next one begins [Tang 2010a],
//! [da Silva 2013], section 2.3.3.
//!
//! ```text
//!             (0, 0)                   a descent ends where two nodes are apart, and at pairs of
//!        /      |      \               leaves; the pairs in brackets are its front: each pair of
//!     (1, 1)  (1, 4)   (4, 4)          leaves is below exactly one of them
//!      / \     /   \        \
//!  [2, 3]  [2, 4] (3, 4)   [5, 6]      when boxes have moved:
//!                 /   \                 [2, 4]  apart: stays        [2, 4]  meet: descends again
//!            [3, 5]  [3, 6]             [3, 5]  leaves: stays, and is a pair if they overlap
//! ```
//!
//! It holds for as long as the trees keep their shape, however boxes move: a refit does no harm,
//! and a front of trees that were built since is dropped, by the numbers of their builds.
//!
//! A front is a list of fixed capacity in which workers claim pieces; it is written while the front
//! of the step before is read. One that does not fit is dropped as a whole. The next step begins at
//! the roots with a longer list, up to the bound of memory. That costs time and never a pair: rows
//! are handed on whether or not the front is kept.
//!
//! Cost: a test a pair of the front. A descent from the roots expands about half as many pairs as
//! its front has, so that beginning at a front saves what the expansions cost beyond those tests,
//! and has all of its work at hand at once; but a front never gets shorter by itself. It is given
//! up as [`FrontOptions`] says.

use crate::stop::Stop;
use crate::threads::Own;
use ccd_core::backend::broad_phase::pair_descent::{NO_PAIR, NodePair};
use ccd_core::backend::scheduling::front::{Fate, FrontState};
use ccd_core::model::report::FrontCounts;
use ccd_core::model::scheduling::FrontOptions;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering::Relaxed};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Pairs of a piece, which a worker claims or reads as one.
pub const PIECE: usize = 512;

/// The fronts of all pairs of sets that a source descends.
#[derive(Debug)]
pub struct Fronts {
    options: FrontOptions,
    fronts: Vec<Front>,
}

/// The front of one pair of sets, or of one set with itself.
#[derive(Debug, Default)]
pub struct Front {
    /// Of which sets it is.
    sets: [Option<usize>; 2],
    /// The builds of their trees.
    builds: [u64; 2],
    /// Whether the kept list is one for these trees, and whether the next is written.
    state: FrontState,
    kept: List,
    next: List,
}

impl Fronts {
    /// None yet.
    pub fn new(options: FrontOptions) -> Self {
        Self { options, fronts: Vec::new() }
    }

    /// The front of these sets, of which the trees have these builds.
    pub fn of(&mut self, sets: [Option<usize>; 2], builds: [u64; 2], n_workers: usize) -> usize {
        let at = self.fronts.iter().position(|front| front.sets == sets);
        let at = at.unwrap_or_else(|| {
            self.fronts.push(Front { sets, ..Front::default() });
            self.fronts.len() - 1
        });
        self.fronts[at].begin(builds, n_workers);
        at
    }

    /// One of them.
    pub fn at(&self, at: usize) -> &Front {
        &self.fronts[at]
    }

    /// A step is over: what was written is kept, if it may be.
    pub fn end(&mut self, at: usize, stop: &Stop) {
        let others = self.fronts.iter().enumerate().filter(|&(i, _)| i != at);
        let used: usize = others.map(|(_, front)| front.bytes()).sum();
        let most = (self.options.memory as usize) << 20;
        let front = &mut self.fronts[at];
        let before = front.bytes() as u64;
        let most = (most.saturating_sub(used) as u64).min(before.saturating_add(stop.left()));
        front.end(&self.options, most as usize);
        // Within the limit: nobody else takes memory now.
        stop.take(front.bytes() as u64 - before);
    }

    /// What the fronts of the last step were.
    pub fn counts(&self) -> FrontCounts {
        let counts = |front: &Front| {
            FrontCounts::new(front.state.kept(), front.state.begun(), front.bytes() as u64)
        };
        self.fronts.iter().map(counts).fold(FrontCounts::default(), FrontCounts::plus)
    }
}

impl Front {
    /// The front to begin with, if there is one.
    pub fn kept(&self) -> Option<&List> {
        (self.state.kept() > 0).then_some(&self.kept)
    }

    /// The front to be written, unless it would be too large.
    pub fn next(&self) -> Option<&List> {
        self.state.is_written().then_some(&self.next)
    }

    fn bytes(&self) -> usize {
        (self.kept.slots.len() + self.next.slots.len()) * size_of::<AtomicU64>()
    }

    fn begin(&mut self, builds: [u64; 2], n_workers: usize) {
        self.state.begin(self.builds == builds);
        self.builds = builds;
        self.next.clear(n_workers);
    }

    fn end(&mut self, options: &FrontOptions, most_bytes: usize) {
        let wanted = self.next.finish() as u64;
        // Both lists take turns.
        let most = most_bytes / (2 * size_of::<AtomicU64>());
        let (n, capacity) = (self.next.n_pairs(), self.next.slots.len() as u64);
        match self.state.end(options, n, wanted, capacity, most as u64) {
            Fate::Kept => std::mem::swap(&mut self.kept, &mut self.next),
            Fate::Grows(capacity) => {
                self.kept.grow(capacity as usize);
                self.next.grow(capacity as usize);
            }
            Fate::Dropped => {}
        }
    }
}

/// Pairs of nodes in pieces, of which each worker fills its own; what is left of a piece holds no
/// pair.
#[derive(Debug, Default)]
pub struct List {
    slots: Vec<AtomicU64>,
    claimed: AtomicUsize,
    cursors: Vec<Own<Mutex<Cursor>>>,
}

/// Where a worker writes next, and to where it may.
#[derive(Debug, Default)]
struct Cursor {
    at: usize,
    end: usize,
    n_pairs: u64,
}

impl List {
    fn clear(&mut self, n_workers: usize) {
        *self.claimed.get_mut() = 0;
        self.cursors.clear();
        self.cursors.resize_with(n_workers, Own::default);
    }

    fn grow(&mut self, capacity: usize) {
        self.slots.reserve_exact(capacity.saturating_sub(self.slots.len()));
        self.slots.resize_with(capacity, AtomicU64::default);
    }

    /// Ends all pieces. Returns the number of entries that were wanted.
    fn finish(&mut self) -> usize {
        for Own(cursor) in &mut self.cursors {
            let cursor = cursor.get_mut().unwrap_or_else(PoisonError::into_inner);
            let end = cursor.end.min(self.slots.len());
            for slot in self.slots.get_mut(cursor.at..end).unwrap_or_default() {
                *slot.get_mut() = pack(NO_PAIR);
            }
            cursor.at = cursor.end;
        }
        *self.claimed.get_mut()
    }

    fn n_pairs(&self) -> u64 {
        self.cursors.iter().map(|Own(cursor)| lock(cursor).n_pairs).sum()
    }

    /// What a worker writes with.
    pub fn writer(&self, worker: usize) -> Writer<'_> {
        Writer { list: self, cursor: lock(&self.cursors[worker].0) }
    }

    /// Number of pieces.
    pub fn n_pieces(&self) -> usize {
        self.claimed.load(Relaxed) / PIECE
    }

    /// Appends the pairs of a piece.
    pub fn piece(&self, k: usize, out: &mut Vec<NodePair>) {
        let pairs = self.slots[k * PIECE..(k + 1) * PIECE].iter().map(|s| unpack(s.load(Relaxed)));
        out.extend(pairs.filter(|&pair| pair != NO_PAIR));
    }
}

/// A worker's access to a list.
#[derive(Debug)]
pub struct Writer<'a> {
    list: &'a List,
    cursor: MutexGuard<'a, Cursor>,
}

impl Writer<'_> {
    /// Adds a pair; beyond the capacity of the list it is only counted.
    #[inline(always)]
    pub fn push(&mut self, pair: NodePair) {
        let Cursor { at, end, n_pairs } = &mut *self.cursor;
        if *at == *end {
            *at = self.list.claimed.fetch_add(PIECE, Relaxed);
            *end = *at + PIECE;
        }
        if let Some(slot) = self.list.slots.get(*at) {
            slot.store(pack(pair), Relaxed);
        }
        *at += 1;
        *n_pairs += 1;
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

fn pack([a, b]: NodePair) -> u64 {
    (a as u64) << 32 | b as u64
}

fn unpack(word: u64) -> NodePair {
    [(word >> 32) as u32, word as u32]
}
