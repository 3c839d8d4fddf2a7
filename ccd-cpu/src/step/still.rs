//! What stands still: which boxes of fixed and sleeping bodies need not be made again, because
//! their vertices are where they were.
//!
//! Vertices of such bodies are compared with where they were in the step before, in the pass that
//! looks for those that move and must not. If all are there, parts of the boxes that are theirs
//! alone are left as they are: of vertices, of leaves, and of the table, if that has the same
//! origin and unit. A call that is told what moves leaves all else (`movers.rs`).

use crate::step::movers::Movers;
use crate::threads::Threads;
use ccd_core::backend::quantization::Table;
use ccd_core::backend::rules::{Rules, moves};
use ccd_core::{Error, Real};
use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering::Relaxed};

/// Elements that are left or made together.
const PART: usize = 256;

/// The vertices that stand still, and what is known of them.
#[derive(Debug, Default)]
pub struct Still {
    vertices: Vec<u32>,
    /// Where they were; NaN after they moved.
    at: Vec<[f64; 3]>,
    may_move: bool,
    /// Runs of vertices that may move, in whole parts.
    moving: Vec<Range<usize>>,
    /// What boxes depend on besides positions: size of the input's numbers, bits of the distance.
    made: Option<(u32, u64)>,
    table: Option<Table>,
    holds: bool,
    holds_table: bool,
    /// What moves, where that is told.
    pub movers: Movers,
}

impl Still {
    /// Takes other rules.
    pub fn set(&mut self, rules: Option<&Rules>) {
        *self = Self::default();
        let Some(rules) = rules.filter(|rules| !rules.still().is_empty()) else { return };
        self.vertices = rules.still().to_vec();
        self.at = vec![[f64::NAN; 3]; self.vertices.len()];
        self.may_move = rules.may_move();
        self.moving = runs(rules.words().len(), |v| !rules.is_still(v as u32));
    }

    /// Whether boxes of what stands still are those of the call before.
    pub fn holds(&self) -> bool {
        self.holds
    }

    /// Of `n` vertices, how many have new boxes.
    pub fn n_made(&self, n: usize) -> usize {
        self.made().map_or(n, |runs| runs.iter().map(Range::len).sum())
    }

    /// Whether what was made of the table is, too.
    pub fn holds_table(&self) -> bool {
        self.holds_table
    }

    /// Looks at checked positions: whether all are where they were; `runs`: vertices that may be
    /// elsewhere than in the call before, if that is known.
    ///
    /// # Errors
    ///
    /// [`Error::FixedMoves`].
    pub fn look<T: Real>(
        &mut self,
        threads: &Threads,
        (x0, x1): (&[[T; 3]], &[[T; 3]]),
        min_distance: f64,
        runs: Option<&[Range<u32>]>,
    ) -> Result<(), Error> {
        let made = (size_of::<T>() as u32, min_distance.to_bits());
        let made_so = self.made.replace(made) == Some(made);
        (self.holds, self.holds_table) = (false, false);
        self.movers.turn(made_so && runs.is_some());
        if self.vertices.is_empty() {
            return Ok(());
        }
        let is_still = |run: &Range<u32>| {
            let first = self.vertices.partition_point(|&v| v < run.start);
            self.vertices.get(first).is_some_and(|v| run.contains(v))
        };
        if runs.is_some_and(|runs| !runs.iter().any(is_still)) {
            self.holds = made_so;
            return Ok(());
        }
        let (vertices, may_move) = (&self.vertices, self.may_move);
        let (first, same) = (AtomicU32::new(u32::MAX), AtomicBool::new(true));
        threads.chunks(&mut self.at, &|from, part| {
            for (i, at) in part.iter_mut().enumerate() {
                let v = vertices[from + i];
                let (p, q) = (x0[v as usize], x1[v as usize]);
                let moved = moves(p, q);
                if moved && !may_move {
                    first.fetch_min(v, Relaxed);
                }
                let now = if moved { [f64::NAN; 3] } else { p.map(T::to_f64) };
                // NaN is not where it was.
                if *at != now {
                    same.store(false, Relaxed);
                    *at = now;
                }
            }
        });
        let vertex = first.into_inner();
        if vertex != u32::MAX {
            self.made = None;
            return Err(Error::FixedMoves { vertex: vertex as usize });
        }
        self.holds = same.into_inner() && made_so;
        if !self.holds {
            self.movers.pause();
        }
        Ok(())
    }

    /// Looks at the table of this step; how far places between exact ones are off says nothing of
    /// what stands still.
    pub fn look_at_table(&mut self, table: Table) {
        let places = Table { error: 0.0, ..table };
        let same = self.table.replace(places) == Some(places);
        self.holds_table = (self.holds || self.movers.is_on()) && same;
    }

    /// No call before this one was complete.
    pub fn forget(&mut self) {
        (self.made, self.table) = (None, None);
    }

    /// Boxes of vertices, but for those that hold, in parts that begin at the given index.
    pub fn chunks<B: Send>(
        &self,
        threads: &Threads,
        boxes: &mut [B],
        f: &(dyn Fn(usize, &mut [B]) + Sync),
    ) {
        match self.made() {
            Some(runs) => threads.chunks_in(boxes, runs, f),
            None => threads.chunks(boxes, f),
        }
    }

    /// The table, but for what holds of it.
    pub fn fill_table<B: Send>(
        &self,
        threads: &Threads,
        table: &mut [B],
        f: impl Fn(usize) -> B + Sync,
    ) {
        if self.holds_table {
            let movers = Some(&self.movers).filter(|movers| movers.is_on());
            threads.fill_in(table, movers.map_or(&self.moving, Movers::vertices), f);
        } else {
            threads.fill(table, f);
        }
    }

    /// The runs of vertices that have new boxes; `None`: all.
    fn made(&self) -> Option<&[Range<usize>]> {
        if self.movers.is_on() {
            return Some(self.movers.vertices());
        }
        self.holds.then_some(&self.moving)
    }
}

/// The runs of `n` elements with `holds`, in whole parts: those that have one of these.
fn runs(n: usize, holds: impl Fn(usize) -> bool) -> Vec<Range<usize>> {
    let mut runs: Vec<Range<usize>> = Vec::new();
    for part in (0..n).step_by(PART).map(|from| from..(from + PART).min(n)) {
        if !part.clone().any(&holds) {
            continue;
        }
        match runs.last_mut() {
            Some(run) if run.end == part.start => run.end = part.end,
            _ => runs.push(part),
        }
    }
    runs
}
