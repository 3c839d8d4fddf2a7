//! Rows of leaves as a list: what sources that are compiled once for all sinks make, a leaf against
//! up to eight at a time, and how listed rows go to a sink.
//!
//! Twin: none; a GPU lists pairs of ids rather than rows.

use crate::broad_phase::leaf_boxes::{Order, Sides};
use crate::broad_phase::pair_source::{Overlaps, PairSink};
use crate::simd::{RowSimd, WIDTH, Work};
use crate::threads::Threads;
use std::marker::PhantomData;

/// Finds overlapping boxes, and lists rows of them; same contract as
/// [`super::pair_source::PairSource::find`].
pub trait RowSource: Order {
    /// Prepares to find pairs; returns how many tasks there are.
    fn begin(&mut self, threads: &Threads, sides: Sides) -> usize;

    /// Does one task. Tasks are done in any order, by several threads at once.
    fn task(&self, k: usize, sides: Sides, scratch: &mut Scratch, rows: &mut Rows);
}

/// Buffers that a thread keeps between tasks, for whatever a source needs.
#[derive(Debug, Default)]
pub struct Scratch {
    /// Leaves that a query found.
    pub hits: Vec<u32>,
    /// Pairs of nodes that are still to be visited.
    pub pairs: Vec<[u32; 2]>,
    /// Nodes, or pairs of nodes, that were visited since the search began.
    pub visits: u64,
}

/// A leaf that overlaps the lanes `mask` of block `b`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// The leaf.
    pub a: u32,
    /// The block.
    pub b: u32,
    /// Its lanes, not 0.
    pub mask: u32,
}

/// A list of rows that is handed on whenever it is full.
pub struct Rows<'a> {
    list: &'a mut Vec<Row>,
    flush: &'a mut (dyn FnMut(&[Row]) + Send),
}

impl<'a> Rows<'a> {
    /// Rows that are listed before they are handed on: they fit the cache of a core.
    pub const CAPACITY: usize = 1024;

    /// An empty list.
    pub fn new(list: &'a mut Vec<Row>, flush: &'a mut (dyn FnMut(&[Row]) + Send)) -> Self {
        list.clear();
        list.reserve(Self::CAPACITY);
        Self { list, flush }
    }

    /// Adds a row, unless its mask is 0.
    #[inline(always)]
    pub fn push(&mut self, a: usize, b: usize, mask: u32) {
        if mask != 0 {
            self.list.push(Row { a: a as u32, b: b as u32, mask });
            if self.list.len() == Self::CAPACITY {
                self.flush();
            }
        }
    }

    /// Adds the pairs of leaf `a` with these leaves: those in one block that follow each other as
    /// one row. (Sorting them first would make fewer rows, and takes longer than the rows that it
    /// saves.)
    pub fn push_leaves(&mut self, a: usize, leaves: &[u32]) {
        let mut i = 0;
        while i < leaves.len() {
            let b = leaves[i] as usize / WIDTH;
            let mut mask = 0;
            while i < leaves.len() && leaves[i] as usize / WIDTH == b {
                mask |= 1 << (leaves[i] as usize % WIDTH);
                i += 1;
            }
            self.push(a, b, mask);
        }
    }

    /// Hands on what there is.
    #[inline(never)]
    pub fn flush(&mut self) {
        (self.flush)(self.list);
        self.list.clear();
    }
}

/// Rows that [`Gathered`] keeps: of eight leaves against eight blocks.
const PENDING: usize = 64;

/// Pairs of leaves that come one by one, gathered into rows: the same leaf and the same block come
/// again soon where trees are descended, but not at once.
pub struct Gathered<'r, 'a> {
    rows: &'r mut Rows<'a>,
    /// A row each for the leaves and blocks with the same last bits; a mask of 0: none.
    pending: [Row; PENDING],
}

impl<'r, 'a> Gathered<'r, 'a> {
    /// Gathers into `rows`.
    pub fn new(rows: &'r mut Rows<'a>) -> Self {
        Self { rows, pending: [Row { a: 0, b: 0, mask: 0 }; PENDING] }
    }

    /// Adds a row that is whole: nothing of it comes again.
    #[inline(always)]
    pub fn push_whole(&mut self, a: usize, b: usize, mask: u32) {
        self.rows.push(a, b, mask);
    }

    /// Adds lanes of a block to the row of a leaf.
    #[inline(always)]
    pub fn push(&mut self, a: usize, b: usize, mask: u32) {
        let row = &mut self.pending[a % 8 * 8 + b % 8];
        if (row.a, row.b) != (a as u32, b as u32) {
            self.rows.push(row.a as usize, row.b as usize, row.mask);
            *row = Row { a: a as u32, b: b as u32, mask: 0 };
        }
        row.mask |= mask;
    }

    /// Hands on what was gathered.
    pub fn finish(self) {
        for Row { a, b, mask } in self.pending {
            self.rows.push(a as usize, b as usize, mask);
        }
    }
}

/// The sink that lists the rows of a tree of pairs. `WHOLE`: each row comes once with all of its
/// lanes.
#[derive(Debug, Default)]
pub struct IntoRows<'r, 'a, const WHOLE: bool>(PhantomData<&'r mut &'a ()>);

impl<'r, 'a, const WHOLE: bool> PairSink for IntoRows<'r, 'a, WHOLE> {
    type Worker = Gathered<'r, 'a>;

    #[inline(always)]
    fn row<S: RowSimd>(&self, rows: &mut Gathered<'r, 'a>, _simd: S, row: Overlaps) {
        let Overlaps { a, lane, b, mask } = row;
        let leaf = a * WIDTH + lane;
        if WHOLE {
            rows.push_whole(leaf, b, mask);
        } else {
            rows.push(leaf, b, mask);
        }
    }
}

/// Listed rows on their way to the sink.
pub struct HandOn<'a, K: PairSink> {
    /// The rows.
    pub rows: &'a [Row],
    /// What takes them.
    pub sink: &'a K,
    /// Its part for this thread.
    pub worker: &'a mut K::Worker,
}

impl<S: RowSimd, K: PairSink> Work<S> for HandOn<'_, K> {
    type Out = ();

    #[inline(always)]
    fn call(self, simd: S) {
        for &Row { a, b, mask } in self.rows {
            let (a, b) = (a as usize, b as usize);
            let row = Overlaps { a: a / WIDTH, lane: a % WIDTH, b, mask };
            self.sink.row(self.worker, simd, row);
        }
    }
}
