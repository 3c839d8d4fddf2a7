//! The boxes of one set in the order of a method's leaves, eight side by side: what a source of
//! pairs numbers its leaves by, and what a sink looks them up in; and what puts them in order.
//!
//! Twin: none; a GPU keeps boxes in the buffers of each method.

use crate::broad_phase::marks::{Marks, NO_BODY, Posed};
use crate::broad_phase::runs::add_runs;
use crate::simd::{Block, EMPTY, WIDTH, block_of, get_lane, set_lane};
use crate::threads::Threads;
use ccd_core::backend::broad_phase::candidate::bodies_meet;
use ccd_core::backend::rules::Rules;
use ccd_core::model::tree_statistics::TreeStatistics;
use ccd_core::{Aabb, Error};
use std::fmt::Debug;
use std::ops::Range;

/// Which of the sets that a source keeps, and what for.
#[derive(Clone, Copy, Debug, Default)]
pub struct Set {
    /// Its number, from 0; nothing else has it in the same source.
    pub index: usize,
    /// Whether pairs are sought within it or with it as the second of two. Of a set that is only
    /// ever the first of two, a source may need the order alone.
    pub searched: bool,
}

/// Of which boxes a call makes none: those of the last call hold, or none are needed yet.
#[derive(Clone, Copy, Debug, Default)]
pub struct Keeps<'a> {
    /// Boxes that stand still.
    pub still: bool,
    /// Runs of blocks, of those that are neither posed nor still, that alone are made; `None`: all.
    pub free: Option<&'a [Range<usize>]>,
    /// Boxes of what is posed, which wait for [`LeafBoxes::pose`].
    pub posed: bool,
}

/// Fills blocks with boxes: given the number of the first block, and the ids of each.
pub type Make<'a> = dyn Fn(usize, &[[u32; WIDTH]], &mut [Block]) + Sync + 'a;

/// The sets of a search: one against another, or, without another, within one.
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
    /// In an order that outlasts motion, a box that is repeated in a block is there once, and the
    /// rest of the block is empty. In another it may have several leaves, of which no two are ever
    /// emitted with each other.
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

    /// Takes boxes of a set at both ends of the times that matter, in the order of its leaves:
    /// until the next [`Order::fit`], pairs may be left out that an axis keeps further than `gap`
    /// apart at both. `changed`: runs of blocks, sorted and apart, that may be others than when it
    /// took them last; all others are the same, or empty now. Returns whether it took them.
    fn take_ends(
        &mut self,
        _threads: &Threads,
        _leaves: &LeafBoxes,
        _ends: &[[Block; 2]],
        _changed: &[Range<usize>],
        _gap: f32,
    ) -> bool {
        false
    }

    /// Figures of the binary tree over a set that is searched, if the source has one.
    fn tree_statistics(&self, _threads: &Threads, _leaves: &LeafBoxes) -> Option<TreeStatistics> {
        None
    }
}

/// Boxes of a set: leaf `8 i + j` is lane `j` of block `i`.
#[derive(Debug, Default)]
pub struct LeafBoxes {
    set: Set,
    n_boxes: usize,
    /// Lanes up to the last box.
    len: usize,
    /// Whether lanes before the last box are empty: those that repeat the id before.
    has_gaps: bool,
    /// From leaf to id; the last id is repeated up to a whole block.
    order: Vec<u32>,
    blocks: Vec<Block>,
    /// Boxes at the end of the order that stand still.
    n_still: usize,
    /// Leaves of what is posed, before these.
    n_posed: usize,
    /// Runs of blocks that were changed, and of those that are neither posed nor still.
    changed: Vec<Range<usize>>,
    free: Vec<Range<usize>>,
    /// Runs of posed blocks with boxes, and those that had some in the last call.
    filled: Vec<Range<usize>>,
    emptied: Vec<Range<usize>>,
}

impl LeafBoxes {
    /// No boxes yet.
    pub fn new(set: Set) -> Self {
        Self { set, ..Self::default() }
    }

    /// Which set this is.
    pub fn set(&self) -> Set {
        self.set
    }

    /// Number of leaves, up to that of the last box.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there is no box.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// From leaf to id.
    pub fn order(&self) -> &[u32] {
        &self.order[..self.len]
    }

    /// Whether there is a box in this leaf.
    pub fn has_box(&self, leaf: usize) -> bool {
        let Self { len, has_gaps, order, .. } = self;
        let repeats = || !leaf.is_multiple_of(WIDTH) && order[leaf] == order[leaf - 1];
        leaf < *len && !(*has_gaps && repeats())
    }

    /// The boxes; lanes without one hold the empty one.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// Boxes at the end of the order that stand still.
    pub fn n_still(&self) -> usize {
        self.n_still
    }

    /// Blocks with a box that may move: all behind them stand still.
    pub fn n_moving(&self) -> usize {
        (self.len - self.n_still).div_ceil(WIDTH)
    }

    /// Blocks with a box that may move and is not posed: the first ones.
    pub fn n_free(&self) -> usize {
        self.n_moving() - self.n_posed / WIDTH
    }

    /// Runs of blocks, sorted and apart, that the last call has changed.
    pub fn changed(&self) -> &[Range<usize>] {
        &self.changed
    }

    /// Runs of posed blocks that have boxes.
    pub fn filled(&self) -> &[Range<usize>] {
        &self.filled
    }

    /// The box of a leaf.
    #[inline]
    pub fn get(&self, leaf: usize) -> Aabb<f32> {
        get_lane(&self.blocks[leaf / WIDTH], leaf % WIDTH)
    }

    /// The ids of block `b`; lanes without a box repeat the id before.
    #[inline(always)]
    pub fn ids(&self, b: usize) -> &[u32; WIDTH] {
        debug_assert!(b < self.blocks.len());
        self.order.as_chunks().0.get(b).unwrap_or(&[0; WIDTH])
    }

    /// Takes boxes, in an order that the source chooses, and has it build what it needs.
    pub fn build(
        &mut self,
        threads: &Threads,
        source: &mut dyn Order,
        boxes: &[Aabb<f32>],
        marks: Marks,
    ) {
        self.order.truncate(self.len);
        source.sort(threads, self.set, boxes, &marks, &mut self.order);
        self.n_posed = marks.posed.map_or(0, |posed| posed.order.len());
        (self.n_boxes, self.len) = (boxes.len(), self.order.len());
        self.has_gaps = source.outlasts_motion() && self.len > self.n_boxes;
        self.n_still = match marks.fixed {
            // A source may give a box several leaves; each of them stands still.
            Some(fixed) => self.order.iter().rev().take_while(|&&id| fixed(id as usize)).count(),
            None => 0,
        };
        if let Some(&last) = self.order.last() {
            self.order.resize(self.len.next_multiple_of(WIDTH), last);
        }
        self.blocks.clear();
        self.filled.clear();
        let posed = marks.posed.is_some_and(|posed| posed.wait);
        self.take(threads, boxes, Keeps { posed, ..Keeps::default() });
        // Also what is posed and has no boxes yet.
        self.changed.clear();
        self.changed.extend(Some(0..self.blocks.len()).filter(|run| !run.is_empty()));
        source.fit(threads, self);
    }

    /// The same with what rules say of a vertex of each box; `kept`, `posed`: see [`Marks`].
    pub fn build_by_rules(
        &mut self,
        threads: &Threads,
        source: &mut dyn Order,
        boxes: &[Aabb<f32>],
        rules: Option<&Rules>,
        vertex: impl Fn(usize) -> u32 + Sync,
        (kept, posed): (usize, Option<Posed>),
    ) {
        let Some(rules) = rules else {
            return self.build(threads, source, boxes, Marks::default());
        };
        let still = |i: usize| rules.is_still(vertex(i));
        let world = |i: usize| rules.world(vertex(i));
        let alone = |i: usize| {
            let word = rules.word(vertex(i));
            if bodies_meet(word, word) { NO_BODY } else { word }
        };
        let mut marks = Marks { kept, posed, alone: Some(&alone), ..Marks::default() };
        marks.fixed = if rules.still().is_empty() { None } else { Some(&still) };
        if let Some(n) = rules.worlds() {
            marks.world = Some(&world);
            marks.world_bits = (n - 1).ilog2() + 1;
        }
        self.build(threads, source, boxes, marks);
    }

    /// Keeps the order of the last build and takes new boxes, see [`LeafBoxes::make`]. Returns how
    /// much looser the source has become since the build, see [`Order::fit`].
    pub fn refit(&mut self, threads: &Threads, source: &mut dyn Order, boxes: &[Aabb<f32>]) -> f64 {
        self.take(threads, boxes, Keeps::default());
        source.fit(threads, self)
    }

    /// Takes new boxes in the order of the last build, as many as then: see [`LeafBoxes::make`].
    fn take(&mut self, threads: &Threads, boxes: &[Aabb<f32>], keeps: Keeps) {
        assert_eq!(boxes.len(), self.n_boxes, "refit with another number of boxes");
        self.make(threads, keeps, &|_, ids, blocks| {
            for (ids, block) in ids.iter().zip(blocks) {
                *block = block_of(ids.iter().map(|&id| boxes[id as usize]));
            }
        });
    }

    /// Has boxes made in the order of the last build; what `make` puts into lanes of ids that are
    /// repeated does not matter. What is posed has none, if it is not made here. The source must
    /// fit them next.
    pub fn make(&mut self, threads: &Threads, keeps: Keeps, make: &Make) {
        let n = self.len.div_ceil(WIDTH);
        threads.resize(&mut self.blocks, n, || EMPTY);
        let (free, moving) = (self.n_free(), self.n_moving());
        let posed = free..if keeps.posed { free } else { moving };
        let last = moving..if keeps.still { moving } else { n };
        self.free.clear();
        let all = 0..free;
        self.free.extend_from_slice(keeps.free.unwrap_or(std::slice::from_ref(&all)));
        self.emptied.clear();
        self.changed.clear();
        let runs = self.free.iter().cloned().chain([posed, last]);
        self.changed.extend(runs.filter(|run| !run.is_empty()));
        self.fill(threads, make);
        let Self { blocks, filled, emptied, .. } = self;
        if keeps.posed {
            std::mem::swap(filled, emptied);
            emptied.iter().for_each(|run| blocks[run.clone()].fill(EMPTY));
            self.add_changed(false);
        } else if free < moving {
            filled.clear();
            filled.push(free..moving);
        }
    }

    /// Has runs of posed blocks, numbered from the first one on, sorted and apart, made as
    /// [`LeafBoxes::make`] does. The source must fit these next; then [`LeafBoxes::all_changed`]
    /// says all that have changed.
    pub fn pose(&mut self, threads: &Threads, runs: &[Range<usize>], make: &Make) {
        let first = self.n_free();
        let Self { changed, filled, .. } = self;
        filled.clear();
        filled.extend(runs.iter().map(|run| first + run.start..first + run.end));
        changed.clear();
        changed.extend_from_slice(filled);
        self.fill(threads, make);
    }

    /// Has the blocks that change made.
    fn fill(&mut self, threads: &Threads, make: &Make) {
        let Self { len, has_gaps, order, blocks, changed, .. } = self;
        threads.chunks_in(blocks, changed, &|first, out| {
            let ids = &order.as_chunks().0[first..first + out.len()];
            make(first, ids, out);
            for (i, (ids, block)) in ids.iter().zip(out).enumerate() {
                let n = n_in_block(ids, *has_gaps).min(*len - (first + i) * WIDTH);
                (n..WIDTH).for_each(|j| set_lane(block, j, &Aabb::EMPTY));
            }
        });
    }

    /// After [`LeafBoxes::pose`]: has [`LeafBoxes::changed`] say what changed since
    /// [`LeafBoxes::make`] began, too.
    pub fn all_changed(&mut self, still: bool) {
        let (moving, n) = (self.n_moving(), self.blocks.len());
        let last = moving..if still { moving } else { n };
        let Self { changed, free, .. } = self;
        changed.clear();
        changed.extend(free.iter().cloned().chain([last]).filter(|run| !run.is_empty()));
        self.add_changed(true);
    }

    /// Adds what was emptied and filled to what has changed.
    fn add_changed(&mut self, filled: bool) {
        add_runs(&mut self.changed, &self.emptied);
        if filled {
            add_runs(&mut self.changed, &self.filled);
        }
    }
}

/// How many boxes a block with these ids has. One that is repeated is the last of them.
#[inline(always)]
fn n_in_block(ids: &[u32; WIDTH], has_gaps: bool) -> usize {
    if has_gaps && ids[WIDTH - 2] == ids[WIDTH - 1] {
        1 + ids.windows(2).take_while(|pair| pair[0] != pair[1]).count()
    } else {
        WIDTH
    }
}
