//! Parameters of kernels.

use super::{MAX_LEVELS, split};
use crate::math::real::Real;
use crate::narrow_phase::search::Search;
use bytemuck::{Pod, Zeroable};

/// Parameters of a kernel: a record of the frame, one of the dispatch and one of the algorithm, one
/// after the other without gaps, because all are made of 32-bit words.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Params<A = Plain> {
    /// Of the frame.
    pub frame: Frame,
    /// Of the dispatch.
    pub dispatch: Dispatch,
    /// Of the algorithm.
    pub args: A,
}

impl<A: Pod> Params<A> {
    /// The bytes of each part, in their order.
    pub fn parts(&self) -> [&[u8]; 3] {
        let Self { frame, dispatch, args } = self;
        [bytemuck::bytes_of(frame), bytemuck::bytes_of(dispatch), bytemuck::bytes_of(args)]
    }
}

/// Parameters of all kernels of a frame. Sets are numbered 0: vertices, 1: edges, 2: faces.
///
/// | field | bytes | | field | bytes |
/// |---|---|---|---|---|
/// | `count` | 0..12 | | `min_distance` | 40..44 |
/// | `flags` | 12..16 | | `slack` | 44..48 |
/// | `start` | 16..32 | | `distance_bits` | 48..56 |
/// | `margin` | 32..36 | | `origin` | 56..80 |
/// | `path_error` | 36..40 | | `margin_bits` | 80..88 |
/// | `tolerance` | 96..100 | | `scale_bits` | 88..96 |
/// | `from` | 100..104 | | `tolerance_bits` | 108..116 |
/// | `until` | 104..108 | | `from_bits` | 116..124 |
/// | | | | `until_bits` | 124..132 |
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Frame {
    /// Boxes of each set.
    pub count: [u32; 3],
    /// The `FLAG_` constants of this type.
    pub flags: u32,
    /// First box of each set among all boxes, then their number.
    pub start: [u32; 4],
    /// By how much boxes of paths are grown, in the unit of paths.
    pub margin: f32,
    /// How far a coordinate of a [`Path`](super::Path) may be from the true one, in the unit of
    /// paths.
    pub path_error: f32,
    /// Contact means at most this distance, in the unit of paths; rounded up.
    pub min_distance: f32,
    /// Boxes that overlap by less may overlap only because they were rounded.
    pub slack: f32,
    /// The minimum distance as bits of an `f64`, low word first.
    pub distance_bits: [u32; 2],
    /// What is subtracted from positions before they become `f32`: bits of `f64`, low words first.
    pub origin: [[u32; 2]; 3],
    /// By how much exact boxes are grown: bits of an `f64`, low word first.
    pub margin_bits: [u32; 2],
    /// By what positions are multiplied before they become `f32`, a power of two: bits of an `f64`,
    /// low word first. See [`Table`](crate::backend::quantization::Table).
    pub scale_bits: [u32; 2],
    /// How early a certain time of impact may be; rounded down.
    pub tolerance: f32,
    /// First time that matters; rounded down.
    pub from: f32,
    /// Last time that matters; rounded up.
    pub until: f32,
    /// The same three as bits of `f64`, low words first.
    pub tolerance_bits: [u32; 2],
    /// First time that matters.
    pub from_bits: [u32; 2],
    /// Last time that matters.
    pub until_bits: [u32; 2],
}

impl Frame {
    /// Bodies select pairs.
    pub const FLAG_BODIES: u32 = 2;
    /// There is a table of rules, see [`pair_rules`](crate::broad_phase::pair_rules).
    pub const FLAG_RULES: u32 = 4;
    /// Paths are exact: there are no wider ones.
    pub const FLAG_EXACT: u32 = 8;
    /// Contacts are kept; else only the earliest time of impact.
    pub const FLAG_KEEP: u32 = 16;
    /// Overlap that rounding may have made is looked at again, by the keys of the exact bounds.
    pub const FLAG_CONFIRM: u32 = 32;
    /// Features may leave a contact that is there at the first time.
    pub const FLAG_LEAVES: u32 = 64;
    /// The first or the last time is no `f32`.
    pub const FLAG_WINDOW_ROUNDED: u32 = 128;
    /// Some bodies stand still: nodes of blocks say whether all below them does, see
    /// [`marked`](crate::broad_phase::block_bvh::marked).
    pub const FLAG_STILL: u32 = 256;
    /// There are boxes of leaves at both ends of the step, see
    /// [`end_slot`](crate::broad_phase::block_bvh::end_slot).
    pub const FLAG_ENDS: u32 = 512;
    /// Candidates are listed a part at a time. The third word of their list, which otherwise counts
    /// beyond 32 bits, is the most that a part wanted, if one wanted more than fit.
    pub const FLAG_IN_PARTS: u32 = 1024;
    /// Boxes are sorted along the Hilbert curve, else along the Morton curve.
    pub const FLAG_HILBERT: u32 = 2048;
    /// Boxes of leaves come from paths, else from boxes of vertices.
    pub const FLAG_SWEPT: u32 = 4096;

    /// With what its kernels look for besides the distance.
    pub fn searching(mut self, search: &Search<f64>) -> Self {
        let Search { tolerance, from, until, leaves, .. } = *search;
        (self.tolerance, self.from) = (tolerance.round_down(), from.round_down());
        self.until = until.round_up();
        [self.tolerance_bits, self.from_bits, self.until_bits] =
            [split(tolerance), split(from), split(until)];
        self.flags &= !(Self::FLAG_LEAVES | Self::FLAG_WINDOW_ROUNDED);
        self.flags |= if leaves { Self::FLAG_LEAVES } else { 0 };
        let exact = self.from as f64 == from && self.until as f64 == until;
        self.flags |= if exact { 0 } else { Self::FLAG_WINDOW_ROUNDED };
        self
    }

    /// Whether a flag is set.
    #[inline(always)]
    pub fn has(&self, flag: u32) -> bool {
        self.flags & flag != 0
    }
}

/// Parameters of a dispatch: its items, and the capacities of the lists that it reads and writes.
///
/// | field | bytes |
/// |---|---|
/// | `n` | 0..4 |
/// | `first` | 4..8 |
/// | `capacity_in` | 8..12 |
/// | `capacity_out` | 12..16 |
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Dispatch {
    /// Items of a map.
    pub n: u32,
    /// The first of them, or the first entry of a list that is looked at.
    pub first: u32,
    /// Capacity of the list that is read.
    pub capacity_in: u32,
    /// Capacity of the list that is written.
    pub capacity_out: u32,
}

/// No record: for kernels that need no more than [`Frame`] and [`Dispatch`]. Shaders have no
/// structure without a member.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Plain {
    unused: u32,
}

/// How coordinates of paths become those of the input: multiplied by the unit, then moved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Placing {
    /// What was subtracted from those of the input.
    pub origin: [f32; 3],
    /// The unit of paths, a power of two; where `f32` has none so large, the greatest number.
    pub unit: f32,
}

/// Parameters of kernels over block trees: where the nodes are, and which of them a dispatch reads.
///
/// | field | bytes |
/// |---|---|
/// | `slots` | 0..128 |
/// | `kind` | 128..132 |
/// | `level` | 132..136 |
/// | `step` | 136..140 |
/// | `limit` | 140..144 |
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Blocks {
    /// First node of each set on each level, then the first of the next level.
    pub slots: [[u32; 4]; MAX_LEVELS],
    /// 0: vertices against faces, 1: edges against edges; the set, for a kernel that is about one.
    pub kind: u32,
    /// Level that a kernel reads.
    pub level: u32,
    /// Every so many-th entry of the list that is read is looked at.
    pub step: u32,
    /// Entries that a dispatch looks at, at most.
    pub limit: u32,
}

/// Parameters of a traversal of a binary tree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Queries {
    /// 0: vertices against faces, 1: edges against edges; the tree is over the second.
    pub kind: u32,
    /// 1: queries in the order of leaves, 0: in that of input.
    pub sorted: u32,
}

/// Parameters of the methods by keys; see
/// [`key_intervals`](crate::broad_phase::key_intervals).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Intervals {
    /// A constant of that module.
    pub method: u32,
    /// 0: vertices against faces, 1: edges against edges.
    pub kind: u32,
    /// The first interval of those that are looked for.
    pub row: u32,
}

/// Parameters of the descent of pairs of nodes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct NodeDescent {
    /// 0: vertices against faces, 1: edges against edges; the set, for a kernel that is about one.
    pub kind: u32,
    /// 1: the larger of two nodes into its children, 0: both.
    pub larger: u32,
    /// Nodes of a cut.
    pub nodes: u32,
    /// Capacity of the list of pairs of nodes; of each of two, if they are one buffer.
    pub capacity_nodes: u32,
    /// Capacity of the front, of each of two in one buffer; 0: none is kept.
    pub capacity_front: u32,
    /// Which of the two fronts is written, 0 or 1; the other is read.
    pub written: u32,
    /// Where tasks of workers come from, a `TASKS_` constant of this type; see
    /// [`pair_workers`](crate::broad_phase::pair_workers).
    pub tasks: u32,
    /// log2 of the number of workers.
    pub workers: u32,
    /// Tasks that are taken at once from the counter, at least.
    pub piece: u32,
    /// A worker ends when of all so many percent are idle; 0: it does not look.
    pub idle: u32,
    /// Pairs that a stack may hold.
    pub stack: u32,
    /// Where what the threads of a worker find in a turn goes: 1: by prefix sums, 0: by counters.
    pub scans: u32,
    /// Turns of a worker, at most.
    pub turns: u32,
    /// 1 in the last round: pairs that are left are seen by the host.
    pub last: u32,
    /// Of workers that steal: batches that fit in a deque.
    pub batches: u32,
    /// Pairs that fit in a batch.
    pub batch: u32,
    /// Batches that are stolen from one deque at once, at most; 0: tasks are stolen, one at a time.
    pub most: u32,
    /// A batch is pushed while the stack has so many pairs, at least two batches.
    pub push: u32,
    /// Times that a worker may look for work in vain before it retires.
    pub patience: u32,
}

impl NodeDescent {
    /// Every worker has a part of the tasks of its own.
    pub const TASKS_DEALT: u32 = 0;
    /// Workers take the next tasks from a counter.
    pub const TASKS_COUNTED: u32 = 1;
    /// Every worker has a part of its own, and what it leaves is dealt out again; see
    /// [`balanced`](crate::broad_phase::balanced).
    pub const TASKS_BALANCED: u32 = 2;
}

/// Parameters of the descent of pairs of blocks by workers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct BlockDescent {
    /// Those of the descent of any pairs of nodes.
    pub of_pairs: NodeDescent,
    /// First node of either side on each level, as in [`Blocks`].
    pub slots: [[u32; 2]; MAX_LEVELS],
}

/// Parameters of the builders of binary trees.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Building {
    /// The set that the tree is over.
    pub set: u32,
    /// How many neighbours to either side a cluster looks at.
    pub radius: u32,
    /// Rounds, or targets that are paired one after the other.
    pub rounds: u32,
    /// 1: leaves in the order of codes, 0: in that of input.
    pub sorted: u32,
    /// Internal nodes that were made before.
    pub made: u32,
}

/// Parameters of one pass of the radix sort.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct SortPass {
    /// Lowest bit of the digit that is sorted by.
    pub shift: u32,
    /// Tiles of the sort.
    pub n_tiles: u32,
}

/// Parameters of the kernels that expand pairs of triangles; see
/// [`feature_pairs`](crate::backend::triangle_pairs::feature_pairs).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Expansion {
    /// The `FLAG_` constants of this type.
    pub flags: u32,
    /// Capacity of the list of pairs of edges.
    pub capacity_ee: u32,
    /// Which of the tests of neighbours are of a vertex and a face: those before this one.
    pub n_vf: u32,
    /// Which are orphans: from the first of these on, up to the second.
    pub orphans: [u32; 2],
    /// Where the table of rules begins behind the regions.
    pub rules: u32,
}

impl Expansion {
    /// Triangles that share a vertex are skipped.
    pub const FLAG_ORPHANS: u32 = 1;
    /// Triangles in one free region are skipped.
    pub const FLAG_REGIONS: u32 = 2;

    /// Whether a flag is set.
    #[inline(always)]
    pub fn has(&self, flag: u32) -> bool {
        self.flags & flag != 0
    }
}

/// Parameters of the kernels that sort boxes of many worlds; see
/// [`worlds`](crate::broad_phase::worlds).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Worlds {
    /// Bits of a key that are a world.
    pub bits: u32,
}

const _: () = assert!(size_of::<Frame>() == 132);
const _: () = assert!(size_of::<Dispatch>() == 16 && size_of::<Blocks>() == 144);
const _: () = assert!(size_of::<SortPass>() == 8 && size_of::<Plain>() == 4);
const _: () = assert!(size_of::<Queries>() == 8 && size_of::<Intervals>() == 12);
const _: () = assert!(size_of::<NodeDescent>() == 76 && size_of::<Building>() == 20);
const _: () = assert!(size_of::<Expansion>() == 24 && size_of::<Worlds>() == 4);
const _: () = assert!(size_of::<Params<Blocks>>() == 132 + 16 + 144);
const _: () = assert!(size_of::<Params>() == 132 + 16 + 4);
