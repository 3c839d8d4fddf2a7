//! Plain twins of the kernels that build and descend block trees: loops over slices, sorts of the
//! standard library.

use ccd::{Aabb, Mesh, Pair};
use ccd_core::backend::broad_phase::block_bvh::{PADDING, WIDTH};
use ccd_core::backend::broad_phase::morton_key::Curve;
use ccd_core::backend::layout::{Blocks, Dispatch, Frame, Leaf, MAX_LEVELS, Params, Path, Plain};

/// Boxes of up to three sets and the block trees over them.
#[derive(Clone)]
pub struct Twin {
    pub frame: Frame,
    pub tree: Blocks,
    pub boxes: Vec<Aabb>,
    pub keys: Vec<u32>,
    pub order: Vec<u32>,
    pub nodes: Vec<Aabb>,
    pub leaves: Vec<Leaf>,
    /// Boxes of leaves at both ends of a step, in fours, if there are some.
    pub ends: Vec<[f32; 4]>,
}

/// Smallest box that holds all.
pub fn union<'a>(boxes: impl Iterator<Item = &'a Aabb>) -> Aabb {
    boxes.fold(Aabb::EMPTY, |all, b| Aabb {
        min: std::array::from_fn(|k| if b.min[k] < all.min[k] { b.min[k] } else { all.min[k] }),
        max: std::array::from_fn(|k| if b.max[k] > all.max[k] { b.max[k] } else { all.max[k] }),
    })
}

/// Interleaved bits of the place along a curve of the cell of a box's centre, one bit at a time.
pub fn code(b: &Aabb, scene: &Aabb, curve: Curve) -> u32 {
    let side = (0..3).fold(0.0f32, |m, k| m.max(scene.max[k] * 0.5 - scene.min[k] * 0.5));
    let scale = if side > 1e-30 { 0.5 * 1024.0 / side } else { 0.0 };
    let cell = |k: usize| {
        (((b.min[k] * 0.5 + b.max[k] * 0.5) - scene.min[k]) * scale).clamp(0.0, 1023.0) as u32
    };
    let cells = curve.place([cell(0), cell(1), cell(2)]);
    (0..30).fold(0, |code, i| code | (cells[2 - i as usize % 3] >> (i / 3) & 1) << i)
}

/// Sort keys of boxes whose sets begin at `start`.
fn keys(boxes: &[Aabb], start: &[u32; 4], curve: Curve) -> Vec<u32> {
    let scene = union(boxes.iter());
    let set_of = |i: u32| (i >= start[1]) as u32 + (i >= start[2]) as u32;
    let key = |(i, b): (usize, &Aabb)| set_of(i as u32) << 30 | code(b, &scene, curve);
    boxes.iter().enumerate().map(key).collect()
}

impl Twin {
    /// Of the boxes of a mesh's vertices, edges and faces.
    pub fn of_mesh(mesh: &Mesh, [v, e, f]: &[Vec<Aabb>; 3]) -> Self {
        Self::new([v, e, f], |set, i| match set {
            0 => [i; 3],
            1 => [
                mesh.edges()[i as usize][0],
                mesh.edges()[i as usize][1],
                mesh.edges()[i as usize][1],
            ],
            _ => mesh.faces()[i as usize],
        })
    }

    /// Builds everything. `leaf(set, i)`: vertices of feature `i`.
    pub fn new(sets: [&[Aabb]; 3], leaf: impl Fn(usize, u32) -> [u32; 3]) -> Self {
        let count = sets.map(|s| s.len() as u32);
        let mut slots = [[0u32; 4]; MAX_LEVELS];
        let (mut next, mut on_level) = (0, count);
        for row in &mut slots {
            for set in 0..3 {
                row[set] = next;
                next += on_level[set].next_multiple_of(PADDING);
                on_level[set] = on_level[set].div_ceil(WIDTH);
            }
            row[3] = next;
        }
        let start = [0, count[0], count[0] + count[1], count[0] + count[1] + count[2]];
        let frame = Frame { count, start, ..Frame::default() };
        let tree = Blocks { slots, kind: 0, level: 0, step: 1, limit: u32::MAX };
        let boxes = sets.concat();
        let keys = keys(&boxes, &start, Curve::Morton);
        let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
        order.sort_by_key(|&i| keys[i as usize]);
        let mut leaves = vec![Leaf { vertices: [0; 3], id: Leaf::NONE }; slots[0][3] as usize];
        for set in 0..3 {
            for k in 0..count[set] {
                let i = order[(start[set] + k) as usize];
                let slot = (slots[0][set] + k) as usize;
                leaves[slot] = Leaf { vertices: leaf(set, i - start[set]), id: i - start[set] };
            }
        }
        let nodes = vec![Aabb::EMPTY; next as usize];
        let mut twin = Self { frame, tree, boxes, keys, order, nodes, leaves, ends: Vec::new() };
        twin.fit();
        twin
    }

    /// Trees over the same boxes, each of which has moved, in the order that there is.
    pub fn moved(&self, mut to: impl FnMut(&Aabb) -> Aabb) -> Self {
        let boxes = self.boxes.iter().map(&mut to).collect();
        let (keys, order) = (self.keys.clone(), self.order.clone());
        let (nodes, leaves) = (self.nodes.clone(), self.leaves.clone());
        let mut twin = Self {
            frame: self.frame,
            tree: self.tree,
            boxes,
            keys,
            order,
            nodes,
            leaves,
            ends: Vec::new(),
        };
        twin.fit();
        twin
    }

    /// Sort keys of the boxes along a curve; those of the tree are along Morton's.
    pub fn keys_along(&self, curve: Curve) -> Vec<u32> {
        keys(&self.boxes, &self.frame.start, curve)
    }

    /// The same, with the boxes of leaves at both ends of the paths.
    pub fn with_ends(mut self, paths: &[Path]) -> Self {
        let of = |leaf: &Leaf, end: fn(&Path) -> [f32; 4]| {
            let points = leaf.vertices.map(|v| {
                let p = end(&paths[v as usize]);
                let p = [p[0], p[1], p[2]];
                Aabb { min: p, max: p }
            });
            let b = union(points.iter());
            [b.min, b.max].concat()
        };
        self.ends = vec![[0.0; 4]; 3 * self.leaves.len()];
        for (i, leaf) in self.leaves.iter().enumerate().filter(|(_, leaf)| leaf.id != Leaf::NONE) {
            let words = [of(leaf, |p| p.t0), of(leaf, |p| p.t1)].concat();
            for (k, four) in words.chunks(4).enumerate() {
                let width = WIDTH as usize;
                self.ends[i / width * 3 * width + k * width + i % width].copy_from_slice(four);
            }
        }
        self.frame.flags |= Frame::FLAG_ENDS;
        self
    }

    /// Vertices of the edges, then of the faces, as kernels have them.
    pub fn elements(&self) -> Vec<u32> {
        let of = |(set, n): (usize, usize)| {
            let mut out = vec![0; n * self.frame.count[set] as usize];
            let first = self.tree.slots[0][set] as usize;
            for leaf in &self.leaves[first..][..self.frame.count[set] as usize] {
                out[n * leaf.id as usize..][..n].copy_from_slice(&leaf.vertices[..n]);
            }
            out
        };
        [(1, 2), (2, 3)].map(of).concat()
    }

    /// Boxes of all nodes, in the order that there is.
    fn fit(&mut self) {
        let Self { frame, tree, boxes, order, nodes, .. } = self;
        let slots = &tree.slots;
        for set in 0..3 {
            for k in 0..frame.count[set] {
                let i = order[(frame.start[set] + k) as usize];
                nodes[(slots[0][set] + k) as usize] = boxes[i as usize];
            }
        }
        for level in 1..MAX_LEVELS {
            for set in 0..3 {
                let (below, here) = (slots[level - 1][set] as usize, slots[level][set] as usize);
                let n = (slots[level - 1][set + 1] as usize - below) / WIDTH as usize;
                let end = slots[level][set + 1] as usize - here;
                for i in 0..n.min(end) {
                    let children =
                        &nodes[below + i * WIDTH as usize..below + (i + 1) * WIDTH as usize];
                    nodes[here + i] = union(children.iter());
                }
            }
        }
    }

    /// Parameters of a pass over pairs of nodes.
    pub fn pass(
        &self,
        kind: u32,
        level: u32,
        capacity_in: usize,
        capacity_out: u32,
    ) -> Params<Blocks> {
        let dispatch =
            Dispatch { capacity_in: capacity_in as u32, capacity_out, ..Dispatch::default() };
        Params { frame: self.frame, dispatch, args: Blocks { kind, level, ..self.tree } }
    }

    /// Parameters of a kernel that knows nothing of block trees.
    pub fn plain(&self, dispatch: Dispatch) -> Params {
        Params { frame: self.frame, dispatch, args: Plain::default() }
    }

    /// Nodes of a set on a level.
    pub fn n_nodes(&self, level: u32, set: usize) -> u32 {
        (0..level).fold(self.frame.count[set], |n, _| n.div_ceil(WIDTH))
    }

    pub fn node(&self, level: u32, set: usize, i: u32) -> &Aabb {
        &self.nodes[(self.tree.slots[level as usize][set] + i) as usize]
    }

    /// All pairs of nodes of a level that overlap, by testing each against each; within one set
    /// with themselves.
    pub fn node_pairs(&self, level: u32, kind: u32) -> Vec<Pair> {
        let [a, b] = ccd_core::backend::broad_phase::block_bvh::sets(kind);
        let mut out = Vec::new();
        for i in 0..self.n_nodes(level, a) {
            for j in if kind == 0 { 0 } else { i }..self.n_nodes(level, b) {
                if self.node(level, a, i).overlaps(self.node(level, b, j)) {
                    out.push(Pair { a: i, b: j });
                }
            }
        }
        out
    }
}
