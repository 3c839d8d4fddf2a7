//! Workgroup memory of a worker: its stack, and words by which its threads agree.

use ccd_core::backend::broad_phase::pair_workers::STACK;

/// Pairs in the memory of a worker.
pub(super) type Stack = [u32; 2 * STACK as usize];
/// Words that its threads share.
pub(super) type Shared = [u32; 22];

/// Words that the threads of a worker share: pairs on its stack; of those, how many are expanded in
/// this turn, and how many tasks are; the first of these, and from each to the next.
pub(super) const TOP: u32 = 0;
pub(super) const FROM_STACK: u32 = 1;
pub(super) const FROM_TASKS: u32 = 2;
pub(super) const FIRST: u32 = 3;
pub(super) const STRIDE: u32 = 4;
/// Tasks of its own part that it has taken; or, of the counter, 1 if there are no more.
pub(super) const NEXT: u32 = 5;
/// Pairs found in this turn: of inner nodes, of leaves, of the front.
pub(super) const NODES: u32 = 6;
pub(super) const LEAVES: u32 = 7;
pub(super) const ENDED: u32 = 8;
/// Where they go: the first place on the stack, how many fit there, then on the lists.
pub(super) const BELOW: u32 = 9;
pub(super) const TO_STACK: u32 = 10;
pub(super) const SPILL_BASE: u32 = 11;
pub(super) const LEAVES_BASE: u32 = 12;
pub(super) const ENDED_BASE: u32 = 13;
/// Tasks of its part that a worker leaves, and where they go behind its stack: not `SPILL_BASE`,
/// which other threads may still read.
pub(super) const REST: u32 = 14;
pub(super) const REST_BASE: u32 = 17;
/// Turns of the worker so far, and pairs that it expanded.
pub(super) const TURNS: u32 = 15;
pub(super) const EXPANDED: u32 = 16;
/// Of blocks: the columns of each team of threads, as bits.
pub(super) const COLUMNS: u32 = 18;
