//! Bodies that move rigidly: trees that are built once, of which each step moves boxes instead of
//! making those of all features.
//!
//! The vertices of a body are divided along the Morton curve into clumps of at most [`CLUMP`]; a
//! clump has its vertices and the edges and faces that begin with one of them. Boxes around clumps,
//! around eight clumps, and so on, are of the positions before any pose. A step moves a box by both
//! poses ([`moved_box`]), and only where it is looked at: against other such bodies, and against
//! the trees of all else. Clumps that nothing comes near have no boxes of features, which are then
//! in no pair; those of the others are made and stand in the trees of the step as any.
//!
//! A body within itself is not looked at, so it must be one without self-contact.

use crate::broad_phase::block_bvh::BlockBvh;
use crate::broad_phase::leaf_boxes::{LeafBoxes, join};
use crate::simd::{Block, WIDTH};
use crate::threads::Threads;
use ccd_core::Aabb;
use ccd_core::backend::quantization::margin;
use ccd_core::backend::rules::Rules;
use ccd_core::math::morton::{MortonGrid, morton30};
use ccd_core::model::codimensional::edges_of_no_face;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::positions::moved_box;
use ccd_core::model::precision::{Coordinate, Precision};
use ccd_core::model::session::{Moved, Rigid, Rigids};
use std::ops::Range;

/// Vertices of a clump: four blocks of them, some twelve of edges and eight of faces.
const CLUMP: usize = 32;
/// Bodies of fewer vertices are moved as any.
const LEAST: usize = 32;
/// Trees are built anew for bodies that begin to move rigidly once they have one vertex for so many
/// of those that do.
const GROWTH: usize = 4;
/// After so many calls in a row without poses the bodies are as any.
const MOST_PLAIN: u32 = 8;

/// The trees of all bodies that move rigidly.
#[derive(Debug, Default)]
pub struct RigidTrees {
    bodies: Vec<Body>,
    /// By the number of a body: its place in `bodies`, plus 1.
    places: Vec<u32>,
    /// By vertex: its clump, or [`NONE`].
    clump_of: Vec<u32>,
    /// One body after the other, as all that follows.
    clumps: Vec<Clump>,
    nodes: Vec<Node>,
    /// By set: ids in the order of leaves, in whole blocks for each clump.
    pub orders: [Vec<u32>; 3],
    /// Which trees have what is in no box of a face.
    loose: [bool; 3],
    /// Those of the call that was prepared for last.
    version: u64,
    placed: u64,
    /// Whether this call has poses.
    on: bool,
    n_plain: u32,
    call: u64,
    /// Bodies from left to right.
    sorted: Vec<(f32, u32)>,
    stack: Vec<[u32; 4]>,
    /// Clumps that something is near.
    near: Vec<u32>,
    /// By set: their runs of blocks.
    pub runs: [Vec<Range<usize>>; 3],
}

/// A body and its tree: `clumps` nodes of level 0, an eighth of that of level 1, up to one.
#[derive(Debug)]
struct Body {
    number: u32,
    /// Any vertex of it.
    vertex: u32,
    /// Where it is among the bodies of the call.
    given: u32,
    first_clump: u32,
    /// Where the nodes of each level begin, and its number of nodes.
    levels: Vec<[u32; 2]>,
}

/// By set: runs of blocks of leaves.
#[derive(Debug)]
struct Clump {
    blocks: [Range<u32>; 3],
    /// The call in which something is near.
    near: u64,
}

/// A box before any pose, and where a call has it.
#[derive(Clone, Copy, Debug)]
struct Node {
    rest: Aabb<f64>,
    swept: Aabb<f32>,
    call: u64,
}

/// No clump.
const NONE: u32 = u32::MAX;

impl RigidTrees {
    /// Whether any body has a tree.
    pub fn is_there(&self) -> bool {
        !self.bodies.is_empty()
    }

    /// Whether in this call boxes are made of those clumps alone that something is near.
    pub fn is_on(&self) -> bool {
        self.on
    }

    /// Whether the body of a vertex has a tree.
    pub fn has(&self, v: u32) -> bool {
        self.clump_of.get(v as usize).is_some_and(|&clump| clump != NONE)
    }

    /// Edges and faces of clumps that something is near, in whole blocks.
    pub fn n_near(&self) -> usize {
        self.runs[1..].iter().flatten().map(|run| WIDTH * run.len()).sum()
    }

    /// Forgets all bodies; whether there were any.
    pub fn clear(&mut self) -> bool {
        let had = self.is_there();
        *self = Self { call: self.call, ..Self::default() };
        had
    }

    /// Begins a call without poses. Returns what [`RigidTrees::begin`] does.
    pub fn begin_plain(&mut self) -> bool {
        self.pause();
        self.n_plain += 1;
        self.n_plain > MOST_PLAIN && self.clear()
    }

    /// Has a call make all boxes.
    pub fn pause(&mut self) {
        self.on = false;
    }

    /// Begins a call with these bodies. Returns whether there are trees of other bodies now, so
    /// that leaves need another order.
    pub fn begin<T: Coordinate>(
        &mut self,
        threads: &Threads,
        mesh: &Mesh,
        rules: Option<&Rules>,
        rigids: Rigids<T>,
    ) -> bool {
        let rules = rules.filter(|rules| rules.worlds().is_none() && !rigids.all.is_empty());
        let Some(rules) = rules else { return self.begin_plain() };
        self.call += 1;
        self.n_plain = 0;
        let changes = self.version != rigids.version && self.take(threads, mesh, rules, &rigids);
        self.version = rigids.version;
        self.on = self.is_there();
        changes
    }

    /// Takes other bodies.
    fn take<T: Coordinate>(
        &mut self,
        threads: &Threads,
        mesh: &Mesh,
        rules: &Rules,
        rigids: &Rigids<T>,
    ) -> bool {
        let number = |v: u32| rules.word(v) >> 2;
        let n_bodies = (0..mesh.n_vertices() as u32).map(number).max().map_or(0, |n| n + 1);
        // By the number of a body: its place among those given, plus 1.
        let mut given = vec![0; n_bodies as usize];
        for (place, body) in rigids.all.iter().enumerate() {
            given[body.number as usize] = place as u32 + 1;
        }
        let mut sizes = vec![0; n_bodies as usize];
        for v in 0..mesh.n_vertices() as u32 {
            // Neither self-contact nor a body that stands still.
            sizes[number(v) as usize] += (rules.word(v) & 3 == 0) as usize;
        }
        let is_new = |n: usize| given[n] > 0 && sizes[n] >= LEAST;
        let stay = self.placed == rigids.placed
            && self.bodies.iter().all(|body| given[body.number as usize] > 0);
        if stay {
            let has = |n: usize| self.places.get(n).is_some_and(|&place| place > 0);
            let size = |of: &dyn Fn(usize) -> bool| -> usize {
                (0..sizes.len()).filter(|&n| of(n)).map(|n| sizes[n]).sum()
            };
            if GROWTH * size(&|n| is_new(n) && !has(n)) <= size(&has) {
                for body in &mut self.bodies {
                    body.given = given[body.number as usize] - 1;
                }
                return false;
            }
        }
        self.placed = rigids.placed;
        let had = self.is_there();
        self.build(threads, mesh, rules, rigids.rest, |n| is_new(n).then(|| given[n] - 1));
        had || self.is_there()
    }

    /// Builds the trees of those bodies of which `given` says where they are.
    fn build<T: Coordinate>(
        &mut self,
        threads: &Threads,
        mesh: &Mesh,
        rules: &Rules,
        rest: &[[T; 3]],
        given: impl Fn(usize) -> Option<u32>,
    ) {
        let number = |v: u32| rules.word(v) >> 2;
        let of_clumps =
            (0..mesh.n_vertices() as u32).filter(|&v| given(number(v) as usize).is_some());
        let mut vertices: Vec<u32> = of_clumps.collect();
        let at = |v: u32| rest[v as usize].map(T::to_f64);
        let around = |ids: &[u32]| {
            let boxes = ids.iter().map(|&v| Aabb::of_point(at(v)));
            boxes.reduce(|all, one| all.union(&one)).expect("a feature has vertices")
        };
        threads.sort(&mut vertices, |&v| (number(v), v));
        (self.bodies.clear(), self.clumps.clear(), self.nodes.clear());
        self.places.clear();
        self.clump_of.clear();
        self.clump_of.resize(mesh.n_vertices(), NONE);
        let mut grids = Vec::new();
        for of_body in vertices.chunk_by_mut(|&a, &b| number(a) == number(b)) {
            let (vertex, n) = (of_body[0], number(of_body[0]) as usize);
            self.places.resize(n + 1, 0);
            self.places[n] = self.bodies.len() as u32 + 1;
            let grid = MortonGrid::new(&around(of_body).round_out(), BITS);
            let code = |v: u32| morton30(grid.cell(&around(&[v]).round_out()));
            threads.sort(of_body, |&v| (code(v), v));
            let first_clump = self.clumps.len() as u32;
            for ids in of_body.chunks(CLUMP) {
                ids.iter().for_each(|&v| self.clump_of[v as usize] = grids.len() as u32);
                grids.push(grid);
                self.clumps.push(Clump { blocks: [0..0, 0..0, 0..0], near: 0 });
            }
            let given = given(n).expect("one of these");
            let levels = Vec::new();
            self.bodies.push(Body { number: n as u32, vertex, given, first_clump, levels });
        }
        if self.bodies.is_empty() {
            self.clear();
            return;
        }
        let mut boxes = vec![None::<Aabb<f64>>; self.clumps.len()];
        let (edges, faces) = (mesh.edges(), mesh.faces());
        for set in 0..3 {
            // The clump, the code, and the id.
            let mut all: Vec<[u32; 3]> = Vec::new();
            let mut add = |id: u32, ids: &[u32]| {
                let clump = self.clump_of[ids[0] as usize];
                if clump == NONE {
                    return;
                }
                let (of_feature, clump) = (around(ids), clump as usize);
                boxes[clump] = Some(boxes[clump].map_or(of_feature, |all| all.union(&of_feature)));
                let code = morton30(grids[clump].cell(&of_feature.round_out()));
                all.push([clump as u32, code, id]);
            };
            match set {
                0 => vertices.iter().for_each(|&v| add(v, &[v])),
                1 => (0..).zip(edges).for_each(|(e, ids)| add(e, ids)),
                _ => (0..).zip(faces).for_each(|(f, ids)| add(f, ids)),
            }
            threads.sort(&mut all, |&key| key);
            let order = &mut self.orders[set];
            order.clear();
            for of_clump in all.chunk_by(|a, b| a[0] == b[0]) {
                let begin = (order.len() / WIDTH) as u32;
                order.extend(of_clump.iter().map(|key| key[2]));
                order.resize(order.len().next_multiple_of(WIDTH), of_clump[of_clump.len() - 1][2]);
                let blocks = begin..(order.len() / WIDTH) as u32;
                self.clumps[of_clump[0][0] as usize].blocks[set] = blocks;
            }
        }
        self.join(&boxes);
        let mut has_face = vec![false; mesh.n_vertices()];
        faces.iter().flatten().for_each(|&v| has_face[v as usize] = true);
        self.loose = [has_face.contains(&false), !edges_of_no_face(mesh).is_empty(), true];
    }

    /// Boxes around those of clumps, eight at a time.
    fn join(&mut self, clumps: &[Option<Aabb<f64>>]) {
        for k in 0..self.bodies.len() {
            let end = self.bodies.get(k + 1).map_or(clumps.len(), |next| next.first_clump as usize);
            let body = &mut self.bodies[k];
            let rest = clumps[body.first_clump as usize..end].iter();
            let mut first = self.nodes.len();
            let node = |rest| Node { rest, swept: Aabb::EMPTY, call: 0 };
            self.nodes.extend(rest.map(|rest| node(rest.expect("a clump has vertices"))));
            loop {
                let last = self.nodes.len();
                body.levels.push([first as u32, (last - first) as u32]);
                if last - first == 1 {
                    break;
                }
                for children in (first..last).step_by(WIDTH) {
                    let of = self.nodes[children..(children + WIDTH).min(last)].iter();
                    let all = of.map(|node| node.rest).reduce(|all, one| all.union(&one));
                    self.nodes.push(node(all.expect("a child")));
                }
                first = last;
            }
        }
    }

    /// Finds the clumps that something is near, and where their blocks are. `trees`: by set, what
    /// else there is.
    pub fn look(
        &mut self,
        rules: &Rules,
        moved: &Moved,
        min_distance: f64,
        trees: [(&BlockBvh, &LeafBoxes); 3],
    ) {
        self.near.clear();
        match moved.rigids {
            Precision::F32(of) => self.search(rules, (of.all, margin(min_distance)), trees),
            Precision::F64(of) => self.search(rules, (of.all, margin(min_distance)), trees),
        }
        self.near.sort_unstable();
        for (set, runs) in self.runs.iter_mut().enumerate() {
            runs.clear();
            let blocks = self.near.iter().map(|&clump| &self.clumps[clump as usize].blocks[set]);
            let blocks = blocks.map(|run| run.start as usize..run.end as usize);
            runs.extend(blocks.filter(|run| !run.is_empty()));
            join(runs);
        }
    }

    fn search<T: Coordinate>(
        &mut self,
        rules: &Rules,
        (given, margin): (&[Rigid<T>], T),
        trees: [(&BlockBvh, &LeafBoxes); 3],
    ) {
        let mut search = Search { of: self, given, margin };
        search.all_bodies(rules);
        for (set, (tree, leaves)) in trees.into_iter().enumerate() {
            if search.of.loose[set] && !leaves.is_empty() {
                (0..search.of.bodies.len()).for_each(|body| search.beside(body, tree, leaves));
            }
        }
    }
}

/// Bits per axis of codes.
const BITS: u32 = 10;

/// What is near what, at these poses.
struct Search<'a, T> {
    of: &'a mut RigidTrees,
    given: &'a [Rigid<T>],
    margin: T,
}

impl<T: Coordinate> Search<'_, T> {
    /// The box of node `i` of a level of a body during the step.
    fn swept(&mut self, body: u32, level: u32, i: u32) -> Aabb<f32> {
        let Body { levels, given, .. } = &self.of.bodies[body as usize];
        let node = &mut self.of.nodes[(levels[level as usize][0] + i) as usize];
        if node.call != self.of.call {
            let rest =
                Aabb { min: node.rest.min.map(T::from_f64), max: node.rest.max.map(T::from_f64) };
            let [at0, at1] =
                self.given[*given as usize].poses.each_ref().map(|p| moved_box(p, &rest));
            (node.swept, node.call) =
                (at0.union(&at1).inflated(self.margin).round_out(), self.of.call);
        }
        node.swept
    }

    fn top(&self, body: u32) -> u32 {
        self.of.bodies[body as usize].levels.len() as u32 - 1
    }

    /// The nodes below one.
    fn below(&self, body: u32, level: u32, i: u32) -> Range<u32> {
        let [_, n] = self.of.bodies[body as usize].levels[level as usize - 1];
        WIDTH as u32 * i..(WIDTH as u32 * (i + 1)).min(n)
    }

    fn is_near(&self, body: u32, clump: u32) -> bool {
        let clump = self.of.bodies[body as usize].first_clump + clump;
        self.of.clumps[clump as usize].near == self.of.call
    }

    fn mark(&mut self, body: u32, clump: u32) {
        if !self.is_near(body, clump) {
            let clump = self.of.bodies[body as usize].first_clump + clump;
            self.of.clumps[clump as usize].near = self.of.call;
            self.of.near.push(clump);
        }
    }

    /// All bodies against each other, where rules want it.
    fn all_bodies(&mut self, rules: &Rules) {
        let mut sorted = std::mem::take(&mut self.of.sorted);
        sorted.clear();
        for body in 0..self.of.bodies.len() as u32 {
            sorted.push((self.swept(body, self.top(body), 0).min[0], body));
        }
        sorted.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        for (k, &(_, a)) in sorted.iter().enumerate() {
            let of_a = self.swept(a, self.top(a), 0);
            for &(_, b) in sorted[k + 1..].iter().take_while(|next| next.0 <= of_a.max[0]) {
                let vertex = |body: u32| self.of.bodies[body as usize].vertex;
                if rules.wants(vertex(a), vertex(b)) {
                    self.two_bodies(a, b);
                }
            }
        }
        self.of.sorted = sorted;
    }

    /// Marks clumps of two bodies that are near each other.
    fn two_bodies(&mut self, a: u32, b: u32) {
        let mut stack = std::mem::take(&mut self.of.stack);
        stack.push([self.top(a), 0, self.top(b), 0]);
        while let Some([level_a, i, level_b, j]) = stack.pop() {
            if self.swept(a, level_a, i).separated(&self.swept(b, level_b, j)) {
                continue;
            }
            if level_a == 0 && level_b == 0 {
                self.mark(a, i);
                self.mark(b, j);
            } else if level_a >= level_b {
                stack.extend(self.below(a, level_a, i).map(|i| [level_a - 1, i, level_b, j]));
            } else {
                stack.extend(self.below(b, level_b, j).map(|j| [level_a, i, level_b - 1, j]));
            }
        }
        self.of.stack = stack;
    }

    /// Marks clumps of a body that are near something in a tree of other boxes.
    fn beside(&mut self, body: usize, tree: &BlockBvh, leaves: &LeafBoxes) {
        let body = body as u32;
        let mut stack = std::mem::take(&mut self.of.stack);
        stack.push([self.top(body), 0, tree.height() as u32 - 1, 0]);
        while let Some([level, i, height, block]) = stack.pop() {
            if level == 0 && self.is_near(body, i) {
                continue;
            }
            let swept = self.swept(body, level, i);
            let at = height as usize;
            let blocks = if at == 0 { leaves.blocks() } else { tree.level(at) };
            let near = lanes(&blocks[block as usize], &swept);
            if near == 0 {
                continue;
            }
            if level == 0 && height == 0 {
                self.mark(body, i);
            } else if level + 1 >= height && level > 0 {
                stack.extend(self.below(body, level, i).map(|i| [level - 1, i, height, block]));
            } else {
                let of = (0..WIDTH as u32).filter(|lane| near >> lane & 1 == 1);
                stack.extend(of.map(|lane| [level, i, height - 1, WIDTH as u32 * block + lane]));
            }
        }
        self.of.stack = stack;
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
