//! What belongs to the leaves of one set of features, in the order of the method that was chosen:
//! all that the filters read of a pair of leaves.

use crate::broad_phase::leaf_boxes::{LeafBoxes, Set};
use crate::simd::{Block, EMPTY, RowSimd, WIDTH, Work};
use crate::threads::Threads;
use ccd_core::Num;

/// The features of one set, `N` vertices each, in leaf order, eight side by side.
#[derive(Debug)]
pub struct Leaves<const N: usize> {
    /// Their order and their boxes.
    pub boxes: LeafBoxes,
    /// Vertices of the features.
    pub vertices: Vec<[[u32; WIDTH]; N]>,
    /// Boxes of the features at the start and at the end, of the positions in the table.
    pub ends: Vec<[Block; 2]>,
}

impl<const N: usize> Leaves<N> {
    /// No features yet.
    pub fn new(set: Set) -> Self {
        Self { boxes: LeafBoxes::new(set), vertices: Vec::new(), ends: Vec::new() }
    }

    /// Vertices, from those of every feature and the order of leaves.
    pub fn order(&mut self, threads: &Threads, features: impl Fn(u32) -> [u32; N] + Sync) {
        let boxes = &self.boxes;
        self.vertices.resize(boxes.len().div_ceil(WIDTH), [[0; WIDTH]; N]);
        threads.fill(&mut self.vertices, |i| {
            let of = boxes.ids(i).map(&features);
            std::array::from_fn(|k| of.map(|vertices| vertices[k]))
        });
    }

    /// Boxes at both ends, from the table of positions; `still`: those at the end that stand still
    /// have theirs.
    pub fn place(&mut self, threads: &Threads, table: &[[f32; WIDTH]], still: bool) {
        let vertices = &self.vertices;
        self.ends.resize(vertices.len(), [EMPTY; 2]);
        let n = if still { self.boxes.n_moving() } else { vertices.len() };
        threads.fill(&mut self.ends[..n], |i| ends(table, &vertices[i]));
    }
}

/// The boxes of eight features at both ends, from the table of positions.
pub fn ends<const N: usize>(table: &[[f32; WIDTH]], vertices: &[[u32; WIDTH]; N]) -> [Block; 2] {
    crate::simd::run_rows!(Place { table, vertices })
}

/// The boxes of eight features at both ends.
struct Place<'a, const N: usize> {
    table: &'a [[f32; WIDTH]],
    vertices: &'a [[u32; WIDTH]; N],
}

impl<S: RowSimd, const N: usize> Work<S> for Place<'_, N> {
    type Out = [Block; 2];

    #[inline(always)]
    fn call(self, simd: S) -> [Block; 2] {
        let first = simd.gather(self.table, &self.vertices[0]);
        let (mut min, mut max) = (first, first);
        for ids in &self.vertices[1..] {
            let next = simd.gather(self.table, ids);
            for k in 0..WIDTH {
                min[k] = min[k].min(next[k]);
                max[k] = max[k].max(next[k]);
            }
        }
        [block(simd, &min, &max, 0), block(simd, &min, &max, 4)]
    }
}

/// The boxes whose bounds begin at component `k`.
#[inline(always)]
fn block<S: RowSimd>(simd: S, min: &[S::Lanes; WIDTH], max: &[S::Lanes; WIDTH], k: usize) -> Block {
    Block {
        min: [simd.store(min[k]), simd.store(min[k + 1]), simd.store(min[k + 2])],
        max: [simd.store(max[k]), simd.store(max[k + 1]), simd.store(max[k + 2])],
    }
}
