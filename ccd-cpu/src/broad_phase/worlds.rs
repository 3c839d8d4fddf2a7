//! The worlds of what is in the blocks of a tree: a fourth axis on which pairs of nodes are
//! separated.
//!
//! ```text
//!   leaves:             [0 0 0 0]  [0 0 - -]  [1 1 1 1]  [1 1 1 -]   -: no box
//!   one world:              0          0          1          1
//!   the block above:    [    0          0          1          1    ]
//!   one world:                             MANY
//! ```
//!
//! Boxes are sorted by world first, and each world begins with a block of its own: a block of two
//! worlds would reach over most of both and meet all blocks of either. So most blocks have boxes of
//! one world, which a word says: two of them meet whole or not at all. Ranges by lane are read
//! where a block has several.

use crate::simd::WIDTH;

/// Stands for several worlds: there are fewer than this.
const MANY: u32 = u32::MAX;

/// The worlds in every block of a tree; none where worlds play no part.
#[derive(Debug, Default)]
pub struct Worlds {
    levels: Vec<Level>,
}

/// Those of one level.
#[derive(Debug, Default)]
struct Level {
    /// Per block: its world, or [`MANY`].
    one: Vec<u32>,
    lanes: Vec<Lanes>,
}

/// Repeats the last box of each world up to a whole block, unless that takes more than half as much
/// room again: then worlds are so small that blocks hold several.
pub fn fill_blocks(order: &mut Vec<u32>, world: &dyn Fn(usize) -> u32) {
    let world = |id: u32| world(id as usize);
    let n = order.len();
    let worlds = order.chunk_by(|&a, &b| world(a) == world(b));
    let filled: usize = worlds.map(|ids| ids.len().next_multiple_of(WIDTH)).sum();
    if filled > n + n / 2 {
        return;
    }
    order.resize(filled, 0);
    // From the back, so that no id is written over that is yet to be moved.
    let (mut from, mut to) = (n, filled);
    while from > 0 {
        let last = order[from - 1];
        let before = order[..from].iter().rposition(|&id| world(id) != world(last));
        let first = before.map_or(0, |i| i + 1);
        let begin = to - (from - first).next_multiple_of(WIDTH);
        order.copy_within(first..from, begin);
        order[begin + from - first..to].fill(last);
        (from, to) = (first, begin);
    }
}

/// The worlds of what is in each lane of a block: none where the first is above the last.
#[derive(Clone, Copy, Debug)]
struct Lanes {
    first: [u16; WIDTH],
    last: [u16; WIDTH],
}

impl Lanes {
    const NONE: Self = Self { first: [u16::MAX; WIDTH], last: [0; WIDTH] };

    /// Of all lanes together.
    fn all(&self) -> [u16; 2] {
        let first = self.first.iter().fold(u16::MAX, |a, &b| a.min(b));
        [first, self.last.iter().fold(0, |a, &b| a.max(b))]
    }
}

impl Level {
    fn push(&mut self, lanes: Lanes) {
        let [first, last] = lanes.all();
        self.one.push(if first == last { first as u32 } else { MANY });
        self.lanes.push(lanes);
    }
}

impl Worlds {
    /// Whether worlds are known.
    #[inline(always)]
    pub fn are_known(&self) -> bool {
        !self.levels.is_empty()
    }

    /// Forgets all.
    pub fn clear(&mut self) {
        self.levels.clear();
    }

    /// Takes the worlds of boxes in the order of leaves.
    pub fn fill(&mut self, order: &[u32], world: &dyn Fn(usize) -> u32) {
        self.clear();
        let mut here = Level::default();
        for ids in order.chunks(WIDTH) {
            let mut lanes = Lanes::NONE;
            for (j, &id) in ids.iter().enumerate() {
                (lanes.first[j], lanes.last[j]) =
                    (world(id as usize) as u16, world(id as usize) as u16);
            }
            here.push(lanes);
        }
        while here.one.len() > 1 {
            let mut above = Level::default();
            for children in here.lanes.chunks(WIDTH) {
                let mut lanes = Lanes::NONE;
                for (j, child) in children.iter().enumerate() {
                    [lanes.first[j], lanes.last[j]] = child.all();
                }
                above.push(lanes);
            }
            self.levels.push(std::mem::replace(&mut here, above));
        }
        self.levels.push(here);
    }

    /// Byte `i`, bit `j`: whether the ranges of worlds of box `i` of block `a` and box `j` of block
    /// `b` of another tree, or of this, have one in common, as boxes on an axis. Blocks of levels
    /// that are not marked meet all.
    #[inline(always)]
    pub fn meet(&self, a: usize, other: &Self, b: usize, level: usize) -> u64 {
        let world = self.of_block(level, a);
        if world != MANY && world == other.of_block(level, b) {
            return u64::MAX;
        }
        self.lanes_meet(a, other, b, level)
    }

    #[inline(always)]
    fn of_block(&self, level: usize, i: usize) -> u32 {
        match self.levels.get(level) {
            Some(level) if i < level.one.len() => level.one[i],
            _ => MANY,
        }
    }

    #[inline(never)]
    fn lanes_meet(&self, a: usize, other: &Self, b: usize, level: usize) -> u64 {
        let lanes = |worlds: &Self, i: usize| worlds.levels.get(level)?.lanes.get(i).copied();
        let (Some(a), Some(b)) = (lanes(self, a), lanes(other, b)) else { return u64::MAX };
        let (mut masks, mut row) = (0, 0);
        for i in 0..WIDTH {
            // In order, so that a block has few ranges.
            if i == 0 || a.first[i] != a.first[i - 1] || a.last[i] != a.last[i - 1] {
                row = 0;
                for j in 0..WIDTH {
                    let meet = (a.first[i] <= b.last[j]) & (b.first[j] <= a.last[i]);
                    row |= (meet as u64) << j;
                }
            }
            masks |= row << (8 * i);
        }
        masks
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Boxes `0 .. n` in their order, `size` of a world.
    fn worlds(n: usize, size: usize) -> Worlds {
        let order: Vec<u32> = (0..n as u32).collect();
        let mut worlds = Worlds::default();
        worlds.fill(&order, &|i| (i / size) as u32);
        worlds
    }

    #[test]
    fn lanes_meet_where_leaves_below_are_of_one_world() {
        for (sizes, n) in [([77, 50], 1000), ([8, 64], 640), ([1, 3], 90), ([600, 1000], 600)] {
            let [a, b] = sizes.map(|size| worlds(n, size));
            assert_eq!(a.levels.len(), b.levels.len());
            for level in 0..a.levels.len() {
                let leaves = WIDTH.pow(level as u32);
                // The worlds in a lane, from its leaves; none past the end.
                let of = |block: usize, lane: usize, size: usize| {
                    let first = (block * WIDTH + lane) * leaves;
                    (first..(first + leaves).min(n)).map(|i| i / size).collect::<Vec<_>>()
                };
                let n_blocks = a.levels[level].one.len();
                let pairs = (0..n_blocks).flat_map(|p| (0..n_blocks).map(move |q| (p, q)));
                for (p, q) in pairs.filter(|(p, q)| p.abs_diff(*q) < 9) {
                    let masks = a.meet(p, &b, q, level);
                    for (i, j) in (0..WIDTH).flat_map(|i| (0..WIDTH).map(move |j| (i, j))) {
                        let (x, y) = (of(p, i, sizes[0]), of(q, j, sizes[1]));
                        let got = masks >> (8 * i + j) & 1 == 1;
                        if x.is_empty() || y.is_empty() {
                            // No box is there.
                            continue;
                        }
                        let want = x.iter().any(|w| y.contains(w));
                        assert_eq!(got, want, "{sizes:?}, level {level}, {p}.{i} {q}.{j}");
                    }
                }
            }
        }
    }

    #[test]
    fn each_world_begins_with_a_block_of_its_own() {
        for (sizes, fills) in [
            (&[1, 9, 8, 16, 7, 23][..], true),
            (&[8, 8], true),
            (&[5], false),
            (&[6], true),
            (&[1, 2, 1, 2, 3], false),
            (&[], true),
        ] {
            let of: Vec<u32> =
                (0..).zip(sizes).flat_map(|(world, &size)| vec![world; size]).collect();
            // Any order within a world.
            let mut order: Vec<u32> = (0..of.len() as u32).collect();
            order.chunk_by_mut(|&a, &b| of[a as usize] == of[b as usize]).for_each(<[_]>::reverse);
            let mut want = Vec::new();
            for ids in order.chunk_by(|&a, &b| of[a as usize] == of[b as usize]) {
                want.extend(ids);
                while fills && !want.len().is_multiple_of(WIDTH) {
                    want.push(ids[ids.len() - 1]);
                }
            }
            fill_blocks(&mut order, &|i| of[i]);
            assert_eq!(order, want, "{sizes:?}");
        }
    }

    #[test]
    fn unmarked_levels_meet_all() {
        let (marked, none) = (worlds(100, 7), Worlds::default());
        assert!(marked.are_known() && !none.are_known());
        assert_eq!(marked.meet(0, &marked, 0, 9), u64::MAX);
        assert_eq!(marked.meet(0, &none, 0, 0), u64::MAX);
    }
}
