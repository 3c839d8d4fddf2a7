//! Overlapping pairs of two bvhs, or of one with itself: both are descended at once, block against
//! block, eight boxes a test.
//!
//! The work is cut into tasks by descending breadth first from the top until there are enough;
//! threads take tasks from a shared counter. Which tasks there are, and what order pairs have
//! within a task, depends on the boxes alone.

use crate::broad_phase::block_bvh::BlockBvh;
use crate::simd::{Block, RowSimd, WIDTH, Work};
use crate::threads::{Own, Threads};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Two blocks of the same level whose boxes are to be tested against each other.
#[derive(Clone, Copy, Debug)]
pub struct Task {
    level: u32,
    a: u32,
    b: u32,
}

/// Tasks wanted: enough that the largest is a small part of the whole.
const MIN_TASKS: usize = 1024;

/// Takes the overlapping pairs of leaves, one row at a time.
pub trait Rows: Sync {
    /// What each thread has of its own.
    type Worker: Send;
    /// Box `lane` of block `a` overlaps the boxes in `mask` of block `b`; `a`, `b` index level 0.
    /// Must be `#[inline(always)]`.
    fn row<S: RowSimd>(&self, worker: &mut Self::Worker, simd: S, a: usize, lane: usize, b: usize, mask: u32);
    /// A task begins.
    fn begin(&self, _worker: &mut Self::Worker, _task: usize) {}
    /// No further task comes.
    fn end(&self, _worker: &mut Self::Worker) {}
}

/// The tasks of a traversal and the stack of each worker, kept between calls.
#[derive(Debug, Default)]
pub struct PairDescent {
    tasks: Vec<Task>,
    next: Vec<Task>,
    stacks: Vec<Own<Vec<Task>>>,
}

impl PairDescent {
    /// All pairs of boxes that overlap: of `a` against `b`, or within `a` (each unordered pair
    /// once, none with itself) if `b` is `None`. `part`: only every so many-th task (1: all).
    ///
    /// Both trees must be equally high, see [`BlockBvh::raise`].
    pub fn run<R: Rows>(
        &mut self,
        threads: &Threads,
        (a, b): (&BlockBvh, Option<&BlockBvh>),
        part: usize,
        rows: &R,
        workers: &mut [R::Worker],
    ) {
        if a.is_empty() || b.is_some_and(BlockBvh::is_empty) {
            return;
        }
        let sides = Sides { a, b: b.unwrap_or(a), within: b.is_none() };
        self.split(sides);
        self.stacks.resize_with(workers.len(), || Own(Vec::with_capacity(1024)));
        let tasks = &self.tasks;
        let counter = AtomicUsize::new(0);
        threads.each_with(workers, &mut self.stacks, &|worker, Own(stack)| {
            loop {
                let k = counter.fetch_add(part, Ordering::Relaxed);
                if k >= tasks.len() {
                    rows.end(worker);
                    break;
                }
                rows.begin(worker, k);
                let task = tasks[k];
                crate::simd::run_rows!(Descent { sides, task, stack, rows, worker });
            }
        });
    }

    /// Cuts the traversal into tasks.
    fn split(&mut self, sides: Sides) {
        let height = sides.a.height();
        assert_eq!(height, sides.b.height(), "trees of different height");
        self.tasks.clear();
        self.tasks.push(Task { level: height as u32 - 1, a: 0, b: 0 });
        while self.tasks.len() < MIN_TASKS && self.tasks.first().is_some_and(|t| t.level > 0) {
            self.next.clear();
            let (tasks, out) = (&self.tasks, &mut self.next);
            crate::simd::run_rows!(Split { sides, tasks, out });
            std::mem::swap(&mut self.tasks, &mut self.next);
        }
    }
}

/// The trees that are descended, equal if pairs are sought `within` one.
#[derive(Clone, Copy)]
struct Sides<'a> {
    a: &'a BlockBvh,
    b: &'a BlockBvh,
    within: bool,
}

/// The children of all `tasks`, appended to `out`.
struct Split<'a> {
    sides: Sides<'a>,
    tasks: &'a [Task],
    out: &'a mut Vec<Task>,
}

impl<S: RowSimd> Work<S> for Split<'_> {
    type Out = ();

    #[inline(always)]
    fn call(self, simd: S) {
        for &task in self.tasks {
            children(simd, self.sides, task, self.out);
        }
    }
}

/// Appends the overlapping pairs of children of a task above level 0.
#[inline(always)]
fn children<S: RowSimd>(simd: S, sides: Sides, task: Task, out: &mut Vec<Task>) {
    let Sides { a, b, within } = sides;
    let level = task.level as usize;
    let (block_a, block_b) = (&a.level(level)[task.a as usize], &b.level(level)[task.b as usize]);
    let mut masks = overlaps(simd, block_a, block_b) & !both_fixed(a, b, task);
    if within && task.a == task.b {
        masks &= UPPER_OR_DIAGONAL;
    }
    while masks != 0 {
        let bit = masks.trailing_zeros();
        masks &= masks - 1;
        let (a, b) = (task.a * WIDTH as u32 + bit / 8, task.b * WIDTH as u32 + bit % 8);
        out.push(Task { level: task.level - 1, a, b });
    }
}

/// Byte `i`, bit `j`: whether box `i` of `a` overlaps box `j` of `b`. All rows first, without a
/// branch between them.
#[inline(always)]
fn overlaps<S: RowSimd>(simd: S, a: &Block, b: &Block) -> u64 {
    let mut masks = 0;
    for i in 0..WIDTH {
        masks |= (simd.overlaps(a, i, b) as u64) << (8 * i);
    }
    masks
}

/// Byte `i`, bit `j`: whether everything in box `i` of one block and box `j` of the other is fixed.
#[inline(always)]
fn both_fixed(a: &BlockBvh, b: &BlockBvh, task: Task) -> u64 {
    if !a.any_fixed() {
        return 0;
    }
    let rows = a.fixed(task.level as usize, task.a as usize);
    let row = b.fixed(task.level as usize, task.b as usize) as u64;
    (0..WIDTH).fold(0, |masks, i| if rows >> i & 1 == 1 { masks | row << (8 * i) } else { masks })
}

/// Byte `i` has the bits `j >= i`.
const UPPER_OR_DIAGONAL: u64 = 0x80c0_e0f0_f8fc_feff;
/// Byte `i` has the bits `j > i`.
const UPPER: u64 = 0x0080_c0e0_f0f8_fcfe;

/// One task, from its pair of blocks down to the boxes.
struct Descent<'a, R: Rows> {
    sides: Sides<'a>,
    task: Task,
    stack: &'a mut Vec<Task>,
    rows: &'a R,
    worker: &'a mut R::Worker,
}

impl<S: RowSimd, R: Rows> Work<S> for Descent<'_, R> {
    type Out = ();

    #[inline(always)]
    fn call(self, simd: S) {
        let Descent { sides, task, stack, rows, worker } = self;
        let Sides { a, b, within } = sides;
        stack.clear();
        stack.push(task);
        let (leaves_a, leaves_b): (&[Block], &[Block]) = (a.level(0), b.level(0));
        while let Some(task) = stack.pop() {
            if task.level > 0 {
                children(simd, sides, task, stack);
                continue;
            }
            let (block_a, block_b) = (&leaves_a[task.a as usize], &leaves_b[task.b as usize]);
            let mut masks = overlaps(simd, block_a, block_b) & !both_fixed(a, b, task);
            if within && task.a == task.b {
                masks &= UPPER;
            }
            while masks != 0 {
                let i = masks.trailing_zeros() as usize / 8;
                let mask = (masks >> (8 * i)) as u32 & 0xff;
                masks &= !(0xff << (8 * i));
                rows.row(worker, simd, task.a as usize, i, task.b as usize, mask);
            }
        }
    }
}

/// The bits `j` of `mask` for which `wanted(j)`.
#[inline(always)]
pub fn keep(mask: u32, wanted: impl Fn(usize) -> bool) -> u32 {
    let (mut rest, mut out) = (mask, mask);
    while rest != 0 {
        let j = rest.trailing_zeros();
        rest &= rest - 1;
        if !wanted(j as usize) {
            out &= !(1 << j);
        }
    }
    out
}
