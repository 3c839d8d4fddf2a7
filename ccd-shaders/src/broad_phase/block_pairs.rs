//! Pairs of nodes of block trees: a workgroup takes four pairs of nodes at once, a team of 32
//! threads each.
//!
//! A thread holds one child of the first node; the children of the second that reach into the first
//! are gathered in workgroup memory, and every thread tests its child against all of them. The hits
//! of all teams are numbered, and worked on together, one a thread: as many at once as the pool
//! takes, which is small, because a device runs as many workgroups at a time as their memory
//! allows.

use crate::entry::{Thread, kernel};
use crate::records::{BoxWords, box_at};
use crate::workgroup::{
    add_shared, barrier, get, get_uniform, length, read_pair, reserve, set, write_pair,
};
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::block_bvh::{
    POOL, TEAMS, THREADS, WIDTH, is_still, sets, slot,
};
use ccd_core::backend::broad_phase::worlds::{meet, range};
use ccd_core::backend::layout::{Blocks, EDGE_EDGE, Frame, Pair, Params};

/// Words of `counters`: columns of each team, hits, hits that are kept, where they go in the list,
/// candidates.
const HITS: u32 = 4;
pub(super) const KEPT: u32 = 5;
const BASE: u32 = 6;
pub(super) const WANTED: u32 = 7;

/// A workgroup of four teams, as one of its threads sees it: its nodes and its memory. `N`: words
/// of worlds; 1 where worlds do not matter.
pub(super) struct Teams<'a, const N: usize> {
    pub t: Thread,
    pub params: &'a Params<Blocks>,
    /// Entries that are looked at.
    pub n: u32,
    pub nodes: &'a [BoxWords],
    /// Where the nodes are.
    pub at: Places,
    /// Where the first child of each team's first node is.
    pub rows: &'a mut [u32; 4],
    /// Children of each team's second node that reach into the first, and where they are.
    pub columns: &'a mut [Aabb; 128],
    pub names: &'a mut [u32; 128],
    /// Worlds of each team's second node's children.
    pub ranges: &'a mut [u32; N],
    pub counters: &'a mut [u32; 8],
    /// Hits of all teams.
    pub n_hits: &'a mut [u32; 1],
    /// Those that are worked on: a thread, whose row it is, and a column, in seven bits each.
    pub hits: &'a mut [u32; 384],
}

/// Where the nodes of a level and their children begin.
#[derive(Clone, Copy)]
pub(super) struct Places {
    /// First nodes, and their children.
    pub(super) nodes: u32,
    pub(super) rows: u32,
    /// Children of second nodes.
    pub(super) columns: u32,
}

impl Places {
    /// For pairs of nodes of a level.
    #[inline(always)]
    pub(super) fn of(args: &Blocks, level: u32) -> Self {
        let [a, b] = sets(args.kind);
        Self {
            nodes: slot(args, level, a, 0) as u32,
            rows: slot(args, level - 1, a, 0) as u32,
            columns: slot(args, level - 1, b, 0) as u32,
        }
    }
}

/// Entries of a list that a dispatch looks at: from `dispatch.first` on every `args.step`-th.
#[inline(always)]
pub(super) fn entries(params: &Params<Blocks>, list: &[u32]) -> u32 {
    let Params { dispatch, args, .. } = params;
    let len = length(list, dispatch.capacity_in);
    let left = if len > dispatch.first { len - dispatch.first } else { 0 };
    // Divisions take long.
    let wanted = if args.step == 1 { left } else { left.div_ceil(args.step) };
    wanted.min(args.limit)
}

impl<const N: usize> Teams<'_, N> {
    /// The pair of nodes of the thread's team, when the workgroup takes the `four`-th four of the
    /// entries; the second part says whether there is one: a team without tests nothing, see
    /// [`Teams::gather`].
    #[inline(always)]
    pub(super) fn pair(&self, list: &[u32], four: u32) -> (Pair, bool) {
        let i = four * TEAMS + self.t.lane / WIDTH;
        let some = i < self.n;
        let (first, step) = (self.params.dispatch.first, self.params.args.step);
        (read_pair(list, first + if some { i * step } else { 0 }), some)
    }

    /// Before the teams take their pairs of a round.
    #[inline(always)]
    pub(super) fn clear(&mut self) {
        if self.t.lane <= KEPT {
            set(self.counters, self.t.lane, 0);
        }
        barrier();
    }

    /// Gathers the columns of each team, and returns this thread's child of the first node. `same`:
    /// both nodes are one, all of whose children are columns.
    #[inline(always)]
    pub(super) fn gather(&mut self, pair: Pair, some: bool, same: bool) -> Aabb {
        let (at, nodes, lane) = (self.at, self.nodes, self.t.lane);
        let (team, child) = (lane / WIDTH, lane % WIDTH);
        let (place, name) = (at.rows + pair.a * WIDTH + child, at.columns + pair.b * WIDTH + child);
        let a = box_at(nodes, (at.nodes + pair.a) as usize);
        let (row, column) = (box_at(nodes, place as usize), box_at(nodes, name as usize));
        if child == 0 {
            set(self.rows, team, place);
        }
        if some && (same || column.overlaps(&a)) {
            let next = add_shared(self.counters, team, 1);
            let to = team * WIDTH + if same { child } else { next };
            set(self.columns, to, column);
            set(self.names, to, name);
        }
        barrier();
        row
    }

    /// Tests this thread's row against the columns of its team. Returns its hits. Within one node
    /// each pair comes twice, and once with itself, so that a row has those of the columns behind
    /// it and, but for `leaves`, its own. `worlds`: those of the row.
    #[inline(always)]
    pub(super) fn test(&self, row: Aabb, same: bool, leaves: bool, worlds: u32) -> Hits {
        let (team, i) = (self.t.lane / WIDTH, self.t.lane % WIDTH);
        let (first, n) = (team * WIDTH, get(self.counters, team));
        let mut columns = 0;
        // Not `div_ceil`, which takes twice as many instructions.
        for four in 0..(n + 3) / 4 {
            let c = 4 * four;
            let hit = |k: u32| row.overlaps(&get(self.columns, first + c + k)) as u32;
            columns |= (hit(0) | hit(1) << 1 | hit(2) << 2 | hit(3) << 3) << c;
        }
        // Behind the last stands what did before.
        if n < WIDTH {
            columns &= (1 << n) - 1;
        }
        if same {
            columns &= (if leaves { u32::MAX - 1 } else { u32::MAX }) << i;
        }
        if !leaves && self.params.frame.has(Frame::FLAG_STILL) && is_still(&row) {
            for c in 0..n {
                if is_still(&get(self.columns, first + c)) {
                    columns &= !(1 << c);
                }
            }
        }
        if N > 1 {
            for c in 0..n {
                let j = get(self.names, first + c) % WIDTH;
                if !meet(worlds, get(self.ranges, first + j)) {
                    columns &= !(1 << c);
                }
            }
        }
        Hits { columns, number: 0 }
    }

    /// Numbers the hits of the workgroup. Returns how often the pool is filled with them.
    #[inline(always)]
    pub(super) fn number(&mut self, hits: &mut Hits) -> u32 {
        // All threads at once, of which a compiler makes one addition of many.
        hits.number = add_shared(self.counters, HITS, hits.columns.count_ones());
        barrier();
        if self.t.lane == 0 {
            set(self.n_hits, 0, get(self.counters, HITS));
        }
        get_uniform(self.n_hits, 0).div_ceil(POOL)
    }

    /// Fills the pool for the `pass`-th time; returns how many it has.
    #[inline(always)]
    pub(super) fn fill(&mut self, hits: &Hits, pass: u32) -> u32 {
        let (lane, team, first) = (self.t.lane, self.t.lane / WIDTH, pass * POOL);
        let (mut columns, mut hit) = (hits.columns, lane * THREADS + team * WIDTH);
        let mut to = hits.number.wrapping_sub(first);
        if columns != 0 {
            // Column by column, for all rows at once: few instructions, of which none waits.
            for _ in 0..(get(self.counters, team) + 3) / 4 {
                to = self.put(columns & 1, hit, to);
                to = self.put(columns & 2, hit + 1, to);
                to = self.put(columns & 4, hit + 2, to);
                to = self.put(columns & 8, hit + 3, to);
                columns >>= 4;
                hit += 4;
            }
        }
        barrier();
        (get(self.n_hits, 0) - first).min(POOL)
    }

    /// Puts a hit into the pool at `to`, if it is one and the pool has that place. Returns where
    /// the next goes.
    #[inline(always)]
    fn put(&mut self, is_hit: u32, hit: u32, to: u32) -> u32 {
        if is_hit != 0 && to < POOL {
            set(self.hits, to, hit);
        }
        if is_hit != 0 { to.wrapping_add(1) } else { to }
    }

    /// Where the two children of a hit of the pool are.
    #[inline(always)]
    pub(super) fn hit(&self, h: u32) -> [u32; 2] {
        let hit = get(self.hits, h);
        let row = get(self.rows, hit / (THREADS * WIDTH)) + hit / THREADS % WIDTH;
        [row, get(self.names, hit % THREADS)]
    }

    /// Reserves entries of `list` for what the workgroup kept, `counters[KEPT]`, and returns the
    /// first; what hits were counted is forgotten.
    #[inline(always)]
    pub(super) fn reserve(&mut self, list: &mut [u32]) -> u32 {
        barrier();
        if self.t.lane == 0 {
            let n = get(self.counters, KEPT);
            if n > 0 {
                set(self.counters, BASE, reserve(list, n, self.params));
            }
            set(self.counters, KEPT, 0);
        }
        barrier();
        get(self.counters, BASE)
    }

    /// From pairs of nodes to those of their children that overlap. `worlds`: of the leaves.
    #[inline(always)]
    fn children(mut self, worlds: &[u32], input: &[u32], output: &mut [u32]) {
        let Params { frame, dispatch, args } = self.params;
        let (lane, i) = (self.t.lane, self.t.lane % WIDTH);
        let mut four = self.t.group;
        while four < self.n.div_ceil(TEAMS) {
            let (pair, some) = self.pair(input, four);
            four += self.t.groups;
            self.clear();
            let mut of_row = 0;
            if N > 1 {
                let ([a, b], level, n) = (sets(args.kind), args.level - 1, frame.count);
                of_row = range(args, level, a, pair.a * WIDTH + i, n[a], worlds);
                set(self.ranges, lane, range(args, level, b, pair.b * WIDTH + i, n[b], worlds));
            }
            let same = args.kind == EDGE_EDGE && pair.a == pair.b;
            let row = self.gather(pair, some, same);
            let mut hits = self.test(row, same, false, of_row);
            for pass in 0..self.number(&mut hits) {
                let n = self.fill(&hits, pass);
                if lane == 0 {
                    set(self.counters, KEPT, n);
                }
                let base = self.reserve(output);
                for share in 0..POOL / THREADS {
                    let h = lane + share * THREADS;
                    if h >= n {
                        break;
                    }
                    let [a, b] = self.hit(h);
                    let pair = Pair { a: a - self.at.rows, b: b - self.at.columns };
                    write_pair(output, dispatch.capacity_out, base + h, pair);
                }
                barrier();
            }
        }
    }
}

/// Hits of a thread's row.
pub(super) struct Hits {
    /// Their columns, as bits.
    columns: u32,
    /// The number of the first among those of the workgroup; that of the others ascends.
    number: u32,
}

kernel! {
    /// From pairs of nodes of level `args.level` to those of their children that overlap.
    node_pairs[128](t; params: Blocks; rows: [u32; 4], columns: [Aabb; 128], names: [u32; 128],
        ranges: [u32; 1], counters: [u32; 8], n_hits: [u32; 1], hits: [u32; 384];
        nodes: [BoxWords], input: [u32], mut output: [u32]) {
        let (n, at) = (entries(params, input), Places::of(&params.args, params.args.level));
        Teams { t, params, n, nodes, at, rows, columns, names, ranges, counters, n_hits, hits }
            .children(input, input, output);
    }
}

kernel! {
    /// As `node_pairs`, of nodes that have a world in common. `worlds`: of the leaves of level 0.
    node_pairs_of_worlds[128](t; params: Blocks; rows: [u32; 4], columns: [Aabb; 128],
        names: [u32; 128], ranges: [u32; 128], counters: [u32; 8], n_hits: [u32; 1],
        hits: [u32; 384]; nodes: [BoxWords], worlds: [u32], input: [u32], mut output: [u32]) {
        let (n, at) = (entries(params, input), Places::of(&params.args, params.args.level));
        Teams { t, params, n, nodes, at, rows, columns, names, ranges, counters, n_hits, hits }
            .children(worlds, input, output);
    }
}
