//! A body that moves rigidly: the boxes of its tree at the poses of a call, and which of its clumps
//! are near something.

use crate::broad_phase::block_bvh::BlockBvh;
use crate::broad_phase::leaf_boxes::LeafBoxes;
use crate::simd::{Block, WIDTH};
use ccd_core::Aabb;
use ccd_core::model::positions::{Pose, moved_box};
use ccd_core::model::precision::Coordinate;
use std::ops::Range;

/// A body and its tree: a node of level 0 for each clump, one of level 1 for eight of them, and so
/// on, up to one.
#[derive(Debug)]
pub struct Body {
    /// Its number among all bodies.
    pub number: u32,
    /// Any vertex of it.
    pub vertex: u32,
    /// Where it is among the bodies of the call.
    pub given: u32,
    /// Its first clump among those of all bodies.
    pub first_clump: u32,
    nodes: Vec<Node>,
    /// Where the nodes of each level begin, and their number.
    levels: Vec<[u32; 2]>,
    /// Clumps that something is near, as they are found.
    near: Vec<u32>,
    stack: Vec<[u32; 4]>,
}

/// A box before any pose, and where a call has it.
#[derive(Clone, Copy, Debug)]
struct Node {
    rest: Aabb<f64>,
    swept: Aabb<f32>,
    /// The call of `swept`, and that in which something is near, of a clump.
    call: u64,
    near: u64,
}

/// Where a body goes in a call.
#[derive(Clone, Copy, Debug)]
pub struct Way<'a, T> {
    pub poses: &'a [Pose<T>; 2],
    /// What boxes of vertices are grown by.
    pub margin: T,
    /// The number of the call; each has its own.
    pub call: u64,
}

impl Body {
    /// The tree over the boxes of its clumps, before any pose; there is one at least.
    pub fn new(
        [number, vertex, given, first_clump]: [u32; 4],
        clumps: impl Iterator<Item = Aabb<f64>>,
    ) -> Self {
        let node = |rest| Node { rest, swept: Aabb::EMPTY, call: 0, near: 0 };
        let mut nodes: Vec<Node> = clumps.map(node).collect();
        let (mut levels, mut first) = (Vec::new(), 0);
        loop {
            let last = nodes.len();
            levels.push([first as u32, (last - first) as u32]);
            if last - first <= 1 {
                break;
            }
            for children in (first..last).step_by(WIDTH) {
                let of = nodes[children..(children + WIDTH).min(last)].iter();
                let all = of.map(|node| node.rest).reduce(|all, one| all.union(&one));
                nodes.push(node(all.expect("a child")));
            }
            first = last;
        }
        let (near, stack) = (Vec::new(), Vec::new());
        Self { number, vertex, given, first_clump, nodes, levels, near, stack }
    }

    /// Clumps that something is near, among those of all bodies; for the next call there are none.
    pub fn take_near(&mut self, into: &mut Vec<u32>) {
        into.extend(self.near.drain(..).map(|clump| self.first_clump + clump));
    }

    /// The box of all of it during the step.
    pub fn swept<T: Coordinate>(&mut self, way: Way<T>) -> Aabb<f32> {
        self.node(way, self.top(), 0)
    }

    fn top(&self) -> u32 {
        self.levels.len() as u32 - 1
    }

    /// The box of node `i` of a level during the step.
    fn node<T: Coordinate>(&mut self, way: Way<T>, level: u32, i: u32) -> Aabb<f32> {
        let node = &mut self.nodes[(self.levels[level as usize][0] + i) as usize];
        if node.call != way.call {
            let [min, max] = [node.rest.min, node.rest.max].map(|p| p.map(T::from_f64));
            let [at0, at1] = way.poses.each_ref().map(|pose| moved_box(pose, &Aabb { min, max }));
            node.swept = at0.union(&at1).inflated(way.margin).round_out();
            node.call = way.call;
        }
        node.swept
    }

    /// The nodes below one.
    fn below(&self, level: u32, i: u32) -> Range<u32> {
        let [_, n] = self.levels[level as usize - 1];
        WIDTH as u32 * i..(WIDTH as u32 * (i + 1)).min(n)
    }

    fn mark(&mut self, clump: u32, call: u64) {
        let near = &mut self.nodes[clump as usize].near;
        if *near != call {
            *near = call;
            self.near.push(clump);
        }
    }

    /// Marks clumps of two bodies that are near each other.
    pub fn beside_body<T: Coordinate>(&mut self, other: &mut Self, way: [Way<T>; 2]) {
        let (a, b, call) = (self, other, way[0].call);
        let mut stack = std::mem::take(&mut a.stack);
        stack.push([a.top(), 0, b.top(), 0]);
        while let Some([level_a, i, level_b, j]) = stack.pop() {
            if a.node(way[0], level_a, i).separated(&b.node(way[1], level_b, j)) {
                continue;
            }
            if level_a == 0 && level_b == 0 {
                a.mark(i, call);
                b.mark(j, call);
            } else if level_a >= level_b {
                stack.extend(a.below(level_a, i).map(|i| [level_a - 1, i, level_b, j]));
            } else {
                stack.extend(b.below(level_b, j).map(|j| [level_a, i, level_b - 1, j]));
            }
        }
        a.stack = stack;
    }

    /// Marks clumps that are near something in a tree of other boxes, of which there is one.
    pub fn beside<T: Coordinate>(&mut self, way: Way<T>, tree: &BlockBvh, leaves: &LeafBoxes) {
        let mut stack = std::mem::take(&mut self.stack);
        stack.push([self.top(), 0, tree.height() as u32 - 1, 0]);
        while let Some([level, i, height, block]) = stack.pop() {
            if level == 0 && self.nodes[i as usize].near == way.call {
                continue;
            }
            let swept = self.node(way, level, i);
            let at = height as usize;
            let blocks = if at == 0 { leaves.blocks() } else { tree.level(at) };
            let near = lanes(&blocks[block as usize], &swept);
            if near == 0 {
                continue;
            }
            if level == 0 && height == 0 {
                self.mark(i, way.call);
            } else if level > 0 && level + 1 >= height {
                // A clump is about as large as a block of blocks of leaves.
                stack.extend(self.below(level, i).map(|i| [level - 1, i, height, block]));
            } else {
                let of = (0..WIDTH as u32).filter(|lane| near >> lane & 1 == 1);
                stack.extend(of.map(|lane| [level, i, height - 1, WIDTH as u32 * block + lane]));
            }
        }
        self.stack = stack;
    }
}

/// The lanes of a block that no axis keeps apart from a box.
fn lanes(block: &Block, from: &Aabb<f32>) -> u32 {
    let mut apart = [false; WIDTH];
    for k in 0..3 {
        for (lane, apart) in apart.iter_mut().enumerate() {
            *apart |= block.min[k].0[lane] > from.max[k] || from.min[k] > block.max[k].0[lane];
        }
    }
    (0..WIDTH).fold(0, |near, lane| near | (!apart[lane] as u32) << lane)
}
