//! Pairs of blocks: 32 threads expand one, each a child of the first node against those of the
//! second; see `ccd_core::backend::broad_phase::block_workers`.
//!
//! Which children of the second reach into the first is a word of workgroup memory a team of 32;
//! their boxes are read again by all threads of the team at once. A thread keeps those that it met
//! as bits, so that it finds up to 32 children and claims places for all of them at once.

use super::shared::{COLUMNS, Shared, Stack};
use super::worker::{Child, PairTree, Worker};
use crate::broad_phase::volume::{APART, INNER, LEAF};
use crate::records::{BoxWords, box_at};
use crate::workgroup::{barrier, get, or_shared, set};
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::block_bvh::{TEAMS, WIDTH, sets};
use ccd_core::backend::broad_phase::block_workers::{
    children_there, meeting, nodes_on, packed, partners, unpacked,
};
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use ccd_core::backend::broad_phase::stack_traversal::NONE;
use ccd_core::backend::layout::{BlockDescent, Dispatch, EDGE_EDGE, NodeDescent, Pair, Params};

/// Block trees, whose nodes are in one buffer.
#[derive(Clone, Copy)]
pub(super) struct BlockTrees<'a> {
    pub params: &'a Params<BlockDescent>,
    pub boxes: &'a [BoxWords],
}

impl BlockTrees<'_> {
    /// Where node `i` of a side is.
    #[inline(always)]
    fn slot(self, level: u32, side: usize, i: u32) -> usize {
        (self.params.args.slots[level as usize][side] + i) as usize
    }
}

/// Children of a pair that are below one child of its first node.
#[derive(Clone, Copy)]
pub(super) struct Columns {
    /// Their level.
    level: u32,
    /// The child of the first node, the first child of the second.
    a: u32,
    b: u32,
    /// Children of the second that it meets, and those that it does not, as bits.
    met: u32,
    apart: u32,
}

impl Columns {
    /// The fate of those that meet.
    #[inline(always)]
    fn fate(self) -> u32 {
        if self.level > 1 { INNER } else { LEAF }
    }
}

impl PairTree for BlockTrees<'_> {
    type Found = Columns;
    type Places = [u32; 2];

    const WIDTH: u32 = TEAMS;

    #[inline(always)]
    fn descent(self) -> NodeDescent {
        self.params.args.of_pairs
    }

    #[inline(always)]
    fn dispatch(self) -> Dispatch {
        self.params.dispatch
    }

    #[inline(always)]
    fn index(lane: u32) -> u32 {
        lane / WIDTH
    }

    #[inline(always)]
    fn begin(shared: &mut Shared) {
        for team in 0..TEAMS {
            set(shared, COLUMNS + team, 0);
        }
    }

    #[inline(always)]
    fn expand(self, lane: u32, pair: NodePair, shared: &mut Shared) -> Columns {
        let Self { params, boxes } = self;
        let (team, i) = (lane / WIDTH, lane % WIDTH);
        let some = pair[0] != NONE;
        // A thread without a pair reads the first two nodes, without effect.
        let [above, x, y] = unpacked(if some { pair } else { packed(1, 0, 0) });
        let level = above - 1;
        let (a, b) = (x * WIDTH + i, y * WIDTH);
        let [set_a, set_b] = sets(params.args.of_pairs.kind);
        let present = children_there(nodes_on(params.frame.count[set_b], level), y);
        let first = self.slot(level, 1, b);
        let (mut row, mut is_row) = (Aabb::EMPTY, false);
        if some {
            if present >> i & 1 == 1 {
                let column = box_at(boxes, first + i as usize);
                if column.overlaps(&box_at(boxes, self.slot(above, 0, x))) {
                    or_shared(shared, COLUMNS + team, 1 << i);
                }
            }
            if a < nodes_on(params.frame.count[set_a], level) {
                row = box_at(boxes, self.slot(level, 0, a));
                is_row = true;
            }
        }
        barrier();
        let (mut met, mut apart) = (0, 0);
        if is_row {
            let tested = partners(params.args.of_pairs.kind == EDGE_EDGE && x == y, i);
            if row.overlaps(&box_at(boxes, self.slot(above, 1, y))) {
                met = meeting(&row, get(shared, COLUMNS + team) & tested, first, boxes);
            }
            if params.args.of_pairs.capacity_front > 0 {
                apart = present & tested & !met;
            }
        }
        Columns { level, a, b, met, apart }
    }

    #[inline(always)]
    fn counts(found: Columns, capacity_front: u32) -> [u32; 3] {
        let n_met = found.met.count_ones();
        let mut n = [0, n_met, found.apart.count_ones() + n_met];
        if found.fate() == INNER {
            n = [n_met, 0, found.apart.count_ones()];
        }
        if capacity_front == 0 {
            n[2] = 0;
        }
        n
    }

    #[inline(always)]
    fn places(found: Columns, first: [u32; 3]) -> [u32; 2] {
        [if found.fate() == INNER { first[0] } else { first[1] }, first[2]]
    }

    #[inline(always)]
    fn put_away(worker: &mut Worker<Self>, found: Columns, to: [u32; 2], stack: &mut Stack) {
        let (mut left, is_apart) = (found.met | found.apart, found.apart);
        let [mut next, mut next_ended] = to;
        let fate = found.fate();
        for _ in 0..WIDTH {
            if left == 0 {
                break;
            }
            let j = left.trailing_zeros();
            left &= left - 1;
            let pair = packed(found.level, found.a, found.b + j);
            let child = Child { pair, fate: if is_apart >> j & 1 == 1 { APART } else { fate } };
            worker.put_away(child, [next, next_ended], stack);
            next += (child.fate != APART) as u32;
            next_ended += (child.fate != INNER) as u32;
        }
    }

    #[inline(always)]
    fn fate(self, pair: NodePair) -> u32 {
        let [level, x, y] = unpacked(pair);
        let a = box_at(self.boxes, self.slot(level, 0, x));
        let b = box_at(self.boxes, self.slot(level, 1, y));
        let mut out = APART;
        if a.overlaps(&b) {
            out = if level > 1 { INNER } else { LEAF };
        }
        out
    }

    #[inline(always)]
    fn result(self, pair: NodePair) -> Pair {
        let [_, a, b] = unpacked(pair);
        Pair { a, b }
    }
}
