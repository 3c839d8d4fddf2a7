//! What is known of boxes besides their bounds, and what blocks of a tree have of it in common.
//!
//! Twin: none; a GPU has the bit of what stands still in its nodes.

use crate::broad_phase::worlds::Worlds;
use crate::simd::WIDTH;

/// Properties of boxes besides their bounds.
#[derive(Clone, Copy, Default)]
pub struct Marks<'a> {
    /// Whether box `i` stands still; pairs of two such boxes need not be emitted.
    pub fixed: Option<&'a (dyn Fn(usize) -> bool + Sync)>,
    /// The world of box `i`; pairs of boxes of two worlds need not be emitted.
    pub world: Option<&'a (dyn Fn(usize) -> u32 + Sync)>,
    /// The body of box `i`, if pairs within it need not be emitted, else [`NO_BODY`].
    pub alone: Option<&'a (dyn Fn(usize) -> u32 + Sync)>,
    /// Bits of the greatest world.
    pub world_bits: u32,
    /// Number of boxes at the end of the previous order that stand still and keep their order.
    pub kept: usize,
    /// Those that are posed.
    pub posed: Option<Posed<'a>>,
}

/// See [`Marks::alone`].
pub const NO_BODY: u32 = u32::MAX;

/// Boxes of bodies that move rigidly: they come between those that move otherwise and those that
/// stand still, in an order of their own, see [`LeafBoxes::pose`].
#[derive(Clone, Copy)]
pub struct Posed<'a> {
    /// Whether box `i` is one.
    pub is: &'a (dyn Fn(usize) -> bool + Sync),
    /// Their ids in whole blocks: a box that is repeated is the last of its block.
    pub order: &'a [u32],
    /// Whether they have no boxes until [`LeafBoxes::pose`] gives some.
    ///
    /// [`LeafBoxes::pose`]: crate::broad_phase::leaf_boxes::LeafBoxes::pose
    pub wait: bool,
}

/// Which blocks of a tree are fixed, of one body, of one world.
#[derive(Debug, Default)]
pub struct BlockMarks {
    /// Per level and block: the lanes that hold fixed boxes only; empty where none was marked.
    fixed: Vec<Vec<u8>>,
    any_fixed: bool,
    /// Per level and block: the one body of all that is in it, see [`Marks::alone`]; empty where no
    /// body is marked.
    alone: Vec<Vec<u32>>,
    any_alone: bool,
    worlds: Worlds,
}

impl BlockMarks {
    /// Lanes of block `i` of a level that hold fixed boxes only.
    #[inline(always)]
    pub fn fixed(&self, level: usize, i: usize) -> u8 {
        if level < self.fixed.len() && i < self.fixed[level].len() {
            self.fixed[level][i]
        } else {
            0
        }
    }

    /// Whether block `i` of a level, and block `j` of the same level of another tree or this one,
    /// have boxes of one body alone, pairs within which are not wanted.
    #[inline(always)]
    pub fn within_one_body(&self, level: usize, i: usize, other: &Self, j: usize) -> bool {
        let body = |tree: &Self, i: usize| match tree.alone.get(level) {
            Some(bodies) if i < bodies.len() => bodies[i],
            _ => NO_BODY,
        };
        let of = body(self, i);
        of != NO_BODY && of == body(other, j)
    }

    /// Whether any block has boxes of one body alone, pairs within which are not wanted.
    pub fn any_alone(&self) -> bool {
        self.any_alone
    }

    /// Whether any box is fixed.
    pub fn any_fixed(&self) -> bool {
        self.any_fixed
    }

    /// Byte `i`, bit `j`: whether everything in box `i` of block `a` of a level and box `j` of
    /// block `b` of another tree, or of this, is fixed.
    #[inline(always)]
    pub fn both_fixed(&self, level: usize, a: usize, other: &Self, b: usize) -> u64 {
        if !self.any_fixed {
            return 0;
        }
        let (rows, row) = (self.fixed(level, a), other.fixed(level, b) as u64);
        (0..WIDTH)
            .fold(0, |masks, i| if rows >> i & 1 == 1 { masks | row << (8 * i) } else { masks })
    }

    /// The worlds in its blocks.
    #[inline(always)]
    pub fn worlds(&self) -> &Worlds {
        &self.worlds
    }

    /// Takes boxes in the order of leaves.
    pub fn fill(&mut self, order: &[u32], marks: &Marks) {
        self.worlds.clear();
        if let Some(world) = marks.world {
            self.worlds.fill(order, world);
        }
        self.any_fixed = marks.fixed.is_some();
        if let Some(fixed) = marks.fixed {
            let whole = |ids: &[u32]| all_of(ids, |&id| fixed(id as usize));
            by_level(&mut self.fixed, order, whole, |masks| all_of(masks, |&mask| mask == 0xff));
        } else {
            self.fixed.iter_mut().for_each(Vec::clear);
        }
        if let Some(alone) = marks.alone {
            let of_leaves = |ids: &[u32]| one_of(ids, |&id| alone(id as usize));
            by_level(&mut self.alone, order, of_leaves, |bodies| one_of(bodies, |&body| body));
        } else {
            self.alone.iter_mut().for_each(Vec::clear);
        }
        self.any_alone =
            self.alone.first().is_some_and(|bodies| bodies.iter().any(|&body| body != NO_BODY));
    }
}

/// Fills every level: the first from eight leaves a block, the others from eight blocks below.
/// Levels that are not there are empty: a tree that is raised has no marks there.
fn by_level<T>(
    levels: &mut Vec<Vec<T>>,
    order: &[u32],
    of_leaves: impl Fn(&[u32]) -> T,
    of_blocks: impl Fn(&[T]) -> T,
) {
    levels.iter_mut().for_each(Vec::clear);
    for level in 0.. {
        if levels.len() == level {
            levels.push(Vec::new());
        }
        let (below, here) = levels.split_at_mut(level);
        match below.last() {
            None => here[0].extend(order.chunks(WIDTH).map(&of_leaves)),
            Some(below) => here[0].extend(below.chunks(WIDTH).map(&of_blocks)),
        }
        if here[0].len() <= 1 {
            break;
        }
    }
}

/// The one body of all items, if there is one.
fn one_of<T>(items: &[T], body: impl Fn(&T) -> u32) -> u32 {
    let first = body(&items[0]);
    if items.iter().all(|item| body(item) == first) { first } else { NO_BODY }
}

/// The items for which `f`, as bits; a lane past the last item counts as fixed.
fn all_of<T>(items: &[T], f: impl Fn(&T) -> bool) -> u8 {
    items
        .iter()
        .enumerate()
        .fold(0xff, |mask, (j, item)| if f(item) { mask } else { mask & !(1 << j) })
}
