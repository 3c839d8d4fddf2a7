//! A source of pairs: what every way to find overlapping boxes has in common.
//!
//! It says in which order boxes are leaves, and emits pairs of leaves, not of ids: what belongs to
//! a leaf is laid out in that order, so that whatever takes the pairs serves every source.
//!
//! Sources come in two shapes. A [`PairSource`] hands rows to the sink at once, and is compiled for
//! every sink: for the default method. A [`RowSource`] lists rows, some thousand at a time, and is
//! compiled once: for all others.

use crate::broad_phase::descend::Descend;
use crate::broad_phase::leaf_boxes::{LeafBoxes, Set};
use crate::broad_phase::tree::TreeStatistics;
use crate::simd::RowSimd;
use crate::threads::Threads;
use ccd_core::broad_phase::pair_descent::NodePair;
use ccd_core::{Aabb, Error};
use std::fmt::Debug;
use std::marker::PhantomData;

/// What is known of boxes besides their places.
#[derive(Clone, Copy, Default)]
pub struct Marks<'a> {
    /// Whether box `i` stands still; pairs of two such boxes need not be emitted.
    pub fixed: Option<&'a (dyn Fn(usize) -> bool + Sync)>,
    /// The world of box `i`; pairs of boxes of two worlds need not be emitted.
    pub world: Option<&'a (dyn Fn(usize) -> u32 + Sync)>,
    /// Bits of the greatest world.
    pub world_bits: u32,
    /// So many boxes at the end of the order before are those that stand still, in an order that
    /// is good still.
    pub kept: usize,
}

/// What pairs are sought in: one set against another, or, without another, within one.
pub type Sides<'a> = (&'a LeafBoxes, Option<&'a LeafBoxes>);

/// Puts the boxes of a few sets in order, and keeps what it builds over them between calls.
pub trait Order: Debug + Send + Sync {
    /// Looks at the boxes of all sets that will be sorted, for what these must have in common: an
    /// axis, the size of a cell. Refuses boxes for which the method is not made.
    fn survey(&mut self, _threads: &Threads, _sets: &[&[Aabb<f32>]]) -> Result<(), Error> {
        Ok(())
    }

    /// Whether an order stays right when boxes move. If not, there is a survey and a sort whenever
    /// they did.
    fn outlasts_motion(&self) -> bool {
        true
    }

    /// Fills `order`, from leaf to id, for boxes that are new, and forgets those of the set before.
    /// A box may have several leaves, of which no two are ever emitted with each other, if the
    /// order does not outlast motion.
    fn sort(
        &mut self,
        threads: &Threads,
        set: Set,
        boxes: &[Aabb<f32>],
        marks: &Marks,
        order: &mut Vec<u32>,
    );

    /// Takes the boxes of a set, the first time after [`Order::sort`] and whenever they moved.
    /// Returns how much looser its volumes around several boxes are, relative to these, than the
    /// first time.
    fn fit(&mut self, _threads: &Threads, _leaves: &LeafBoxes) -> f64 {
        1.0
    }

    /// Figures of the binary tree over a set that is searched, if the source has one.
    fn tree_statistics(&self, _threads: &Threads, _leaves: &LeafBoxes) -> Option<TreeStatistics> {
        None
    }
}

/// Finds overlapping boxes, and hands rows of them to a sink.
pub trait PairSource {
    /// Its order of leaves.
    fn order(&mut self) -> &mut dyn Order;

    /// Hands the sink all pairs of leaves whose boxes overlap: of `a` against `b`, or within `a`
    /// (each unordered pair once, none with itself) if `b` is `None`. `part`: only every so
    /// many-th task (1: all).
    ///
    /// Which tasks there are, and what order pairs have within a task, depends on the boxes alone.
    fn find<K: PairSink>(
        &mut self,
        threads: &Threads,
        sides: Sides,
        part: usize,
        sink: &K,
        workers: &mut [K::Worker],
    );
}

/// Takes overlapping pairs of leaves, one against up to eight.
pub trait PairSink: Sync {
    /// What each thread has of its own.
    type Worker: Send;
    /// Whether what is made of rows depends on their order, which then must not depend on threads.
    const ORDERED: bool = false;
    /// Lane `lane` of block `a` overlaps the lanes `mask` of block `b`; `mask` is not 0. Must be
    /// `#[inline(always)]`, or the instruction set is not enabled inside.
    fn row<S: RowSimd>(
        &self,
        worker: &mut Self::Worker,
        simd: S,
        a: usize,
        lane: usize,
        b: usize,
        mask: u32,
    );
    /// A task begins; rows that come in no order belong to none.
    fn begin(&self, _worker: &mut Self::Worker, _task: usize) {}
    /// No further task comes.
    fn end(&self, _worker: &mut Self::Worker) {}
}

/// Finds overlapping boxes, and lists rows of them; same contract as [`PairSource::find`].
pub trait RowSource: Order {
    /// Prepares to find pairs; returns how many tasks there are.
    fn begin(&mut self, threads: &Threads, sides: Sides) -> usize;

    /// Does one task. Tasks are done in any order, by several threads at once.
    fn task(&self, k: usize, sides: Sides, scratch: &mut Scratch, rows: &mut Rows);

    /// Most threads that take tasks.
    fn max_threads(&self) -> usize {
        usize::MAX
    }
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

/// A source of pairs of nodes, which any scheduler shares out among workers.
pub trait PairsOfNodes: Order {
    /// Calls `run` with the pairs of nodes of these sides.
    fn descend(&mut self, threads: &Threads, sides: Sides, run: &mut dyn FnMut(Pairs));
}

/// Pairs of nodes of two trees, or of one with itself.
pub struct Pairs<'a> {
    /// What descends them.
    pub tree: &'a dyn Descend,
    /// Where a descent begins: every pair of leaves is below exactly one.
    pub roots: &'a [NodePair],
    /// Which builds of the trees these are: of later ones the numbers are others.
    pub builds: [u64; 2],
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
    pub const ROOM: usize = 1024;

    /// An empty list.
    pub fn new(list: &'a mut Vec<Row>, flush: &'a mut (dyn FnMut(&[Row]) + Send)) -> Self {
        list.clear();
        list.reserve(Self::ROOM);
        Self { list, flush }
    }

    /// Adds a row, unless its mask is 0.
    #[inline(always)]
    pub fn push(&mut self, a: usize, b: usize, mask: u32) {
        if mask != 0 {
            self.list.push(Row { a: a as u32, b: b as u32, mask });
            if self.list.len() == Self::ROOM {
                self.flush();
            }
        }
    }

    /// Adds the pairs of leaf `a` with these leaves: those in one block that follow each other as
    /// one row. (Sorting them first would make fewer rows, and takes longer than the rows that it
    /// saves.)
    pub fn push_leaves(&mut self, a: usize, leaves: &[u32]) {
        use crate::simd::WIDTH;
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

/// Has a tree of pairs list its rows: the sink by which what descends one is a [`RowSource`].
/// `WHOLE`: they come whole.
#[derive(Debug, Default)]
pub struct IntoRows<'r, 'a, const WHOLE: bool>(PhantomData<&'r mut &'a ()>);

impl<'r, 'a, const WHOLE: bool> PairSink for IntoRows<'r, 'a, WHOLE> {
    type Worker = Gathered<'r, 'a>;

    #[inline(always)]
    fn row<S: RowSimd>(
        &self,
        rows: &mut Gathered<'r, 'a>,
        _simd: S,
        a: usize,
        lane: usize,
        b: usize,
        mask: u32,
    ) {
        let leaf = a * crate::simd::WIDTH + lane;
        if WHOLE {
            rows.push_whole(leaf, b, mask);
        } else {
            rows.push(leaf, b, mask);
        }
    }
}
