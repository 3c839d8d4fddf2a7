//! Trees of bodies that move rigidly, from positions before any pose.

use super::body::Body;
use crate::broad_phase::hilbert_code::{BITS, UPPER_LEVELS, hilbert_codes, turned_octants};
use crate::simd::WIDTH;
use crate::threads::Threads;
use ccd_core::Aabb;
use ccd_core::backend::rules::Rules;
use ccd_core::math::morton::MortonGrid;
use ccd_core::model::codimensional::edges_of_no_face;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::precision::Coordinate;
use std::ops::Range;

/// Vertices of a clump: four blocks of them, some twelve of edges and eight of faces.
const CLUMP: usize = 32;
/// No clump.
const NONE: u32 = u32::MAX;

/// The upper 30 bits of the Hilbert code of a box's centre.
fn code_of(aabb: &Aabb, grid: &MortonGrid) -> u32 {
    let boxes = std::slice::from_ref(aabb);
    let [code] = hilbert_codes::<UPPER_LEVELS, 1>(turned_octants(), boxes, [0], grid);
    (code >> 3) as u32
}

/// The trees of some bodies, and the order of their features' leaves.
#[derive(Debug, Default)]
pub struct Trees {
    pub bodies: Vec<Body>,
    /// By the number of a body: whether it is one of them.
    has: Vec<bool>,
    /// By vertex: its clump, or [`NONE`].
    clump_of: Vec<u32>,
    /// By clump and set: runs of blocks of leaves.
    pub blocks: Vec<[Range<u32>; 3]>,
    /// By set: ids in the order of leaves, in whole blocks for each clump.
    pub orders: [Vec<u32>; 3],
    /// By set: whether its tree must be searched for what is near. That of faces always, since
    /// their boxes hold those of their vertices and edges; the others where there are more.
    pub searched: [bool; 3],
}

impl Trees {
    /// Whether the body of a vertex has a tree.
    pub fn has(&self, v: u32) -> bool {
        self.clump_of.get(v as usize).is_some_and(|&clump| clump != NONE)
    }

    /// Whether a body has one, by its number.
    pub fn has_body(&self, number: usize) -> bool {
        self.has.get(number).is_some_and(|&has| has)
    }

    /// Trees of the bodies of which `given` says where they are among those of the call.
    pub fn new<T: Coordinate>(
        threads: &Threads,
        mesh: &Mesh,
        rules: &Rules,
        rest: &[[T; 3]],
        given: impl Fn(usize) -> Option<u32>,
    ) -> Self {
        let number = |v: u32| rules.word(v) >> 2;
        let around = |ids: &[u32]| {
            let boxes = ids.iter().map(|&v| Aabb::of_point(rest[v as usize].map(T::to_f64)));
            boxes.reduce(|all, one| all.union(&one)).expect("a feature has vertices")
        };
        let is_of = |&v: &u32| given(number(v) as usize).is_some();
        let mut vertices: Vec<u32> = (0..mesh.n_vertices() as u32).filter(is_of).collect();
        threads.sort(&mut vertices, |&v| (number(v), v));
        let (mut clump_of, mut grids) = (vec![NONE; mesh.n_vertices()], Vec::new());
        // By body: its number, a vertex, and its first clump.
        let mut firsts = Vec::new();
        for of_body in vertices.chunk_by_mut(|&a, &b| number(a) == number(b)) {
            firsts.push([number(of_body[0]), of_body[0], grids.len() as u32]);
            let grid = MortonGrid::new(&around(of_body).round_out(), BITS);
            let code = |v: u32| code_of(&around(&[v]).round_out(), &grid);
            threads.sort(of_body, |&v| (code(v), v));
            for ids in of_body.chunks(CLUMP) {
                ids.iter().for_each(|&v| clump_of[v as usize] = grids.len() as u32);
                grids.push(grid);
            }
        }
        let n_clumps = grids.len();
        let mut boxes: Vec<Option<Aabb<f64>>> = vec![None; n_clumps];
        let mut blocks = vec![[0..0, 0..0, 0..0]; n_clumps];
        let mut orders: [Vec<u32>; 3] = Default::default();
        for (set, order) in orders.iter_mut().enumerate() {
            // The clump, the code, and the id.
            let mut all: Vec<[u32; 3]> = Vec::new();
            let mut add = |id: u32, ids: &[u32]| {
                let clump = clump_of[ids[0] as usize];
                if clump == NONE {
                    return;
                }
                let (of_feature, at) = (around(ids), clump as usize);
                boxes[at] = Some(boxes[at].map_or(of_feature, |all| all.union(&of_feature)));
                let code = code_of(&of_feature.round_out(), &grids[at]);
                all.push([clump, code, id]);
            };
            match set {
                0 => vertices.iter().for_each(|&v| add(v, &[v])),
                1 => (0..).zip(mesh.edges()).for_each(|(e, ids)| add(e, ids)),
                _ => (0..).zip(mesh.faces()).for_each(|(f, ids)| add(f, ids)),
            }
            threads.sort(&mut all, |&key| key);
            for of_clump in all.chunk_by(|a, b| a[0] == b[0]) {
                let begin = (order.len() / WIDTH) as u32;
                order.extend(of_clump.iter().map(|key| key[2]));
                order.resize(order.len().next_multiple_of(WIDTH), of_clump[of_clump.len() - 1][2]);
                blocks[of_clump[0][0] as usize][set] = begin..(order.len() / WIDTH) as u32;
            }
        }
        let ends = firsts.iter().skip(1).map(|first| first[2]).chain([n_clumps as u32]);
        let bodies = firsts.iter().zip(ends).map(|(&[number, vertex, first], end)| {
            let clumps = boxes[first as usize..end as usize].iter();
            let given = given(number as usize).expect("one of these");
            let clumps = clumps.map(|of| of.expect("a clump has vertices"));
            Body::new([number, vertex, given, first], clumps)
        });
        let bodies: Vec<Body> = bodies.collect();
        let mut has = vec![false; firsts.last().map_or(0, |last| last[0] as usize + 1)];
        firsts.iter().for_each(|&[number, ..]| has[number as usize] = true);
        let mut has_face = vec![false; mesh.n_vertices()];
        mesh.faces().iter().flatten().for_each(|&v| has_face[v as usize] = true);
        let searched = [has_face.contains(&false), !edges_of_no_face(mesh).is_empty(), true];
        Self { bodies, has, clump_of, blocks, orders, searched }
    }
}
