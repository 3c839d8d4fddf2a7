//! Boxes in the order of a curve: bounds of the scene, codes of the centres, sort.
//!
//! Twin: none; on a GPU a sort of keys, as any other.

use crate::broad_phase::hilbert_code::{
    BITS, UPPER_LEVELS, hilbert_codes, turned_octants, upper_morton,
};
use crate::broad_phase::marks::Marks;
use crate::simd::WIDTH;
use crate::sort::{Keys, LANES, LOW_BITS, RadixSort};
use crate::threads::Threads;
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::morton_key::{self, Curve};
use ccd_core::math::morton::MortonGrid;

/// Boxes that a task merges.
const CHUNK: usize = 2048;

/// Sorts boxes along a curve; buffers are kept.
#[derive(Debug, Default)]
pub struct CurveOrder {
    curve: Curve,
    radix: RadixSort,
    chunks: Vec<Aabb<f32>>,
    moving: Vec<u32>,
    still: Vec<u32>,
}

impl CurveOrder {
    /// Along this curve.
    pub fn of(curve: Curve) -> Self {
        Self { curve, ..Self::default() }
    }

    /// The grid over the boxes.
    pub fn grid(&mut self, threads: &Threads, boxes: &[Aabb<f32>]) -> MortonGrid {
        self.chunks.resize(boxes.len().div_ceil(CHUNK), Aabb::EMPTY);
        threads.each(&mut self.chunks, &|i, chunk| {
            *chunk = (0..CHUNK / morton_key::CHUNK).fold(Aabb::EMPTY, |all, k| {
                all.union(&morton_key::scene_bounds(
                    i * CHUNK + k * morton_key::CHUNK,
                    1,
                    boxes,
                    boxes.len(),
                ))
            })
        });
        let scene = self.chunks.iter().fold(Aabb::EMPTY, |all, b| all.union(b));
        MortonGrid::new(&scene, BITS)
    }

    /// Fills `order` with the ids of the boxes: one world after the other, in each those that stand
    /// still after all others, and before these what is posed. Those that are kept stay where they
    /// are. Returns the grid of the codes.
    pub fn sort(
        &mut self,
        threads: &Threads,
        boxes: &[Aabb<f32>],
        marks: &Marks,
        order: &mut Vec<u32>,
    ) -> MortonGrid {
        let grid = self.grid(threads, boxes);
        let (curve, turned) = (self.curve, turned_octants());
        let upper = |of: [usize; LANES]| match curve {
            Curve::Hilbert => hilbert_codes::<UPPER_LEVELS, LANES>(turned, boxes, of, &grid),
            Curve::Morton => of.map(|i| upper_morton::<UPPER_LEVELS>(grid.cell(&boxes[i]))),
        };
        let whole = |i: usize| match curve {
            Curve::Hilbert => hilbert_codes::<BITS, 1>(turned, boxes, [i], &grid)[0],
            Curve::Morton => upper_morton::<BITS>(grid.cell(&boxes[i])),
        };
        let Marks { fixed, world, world_bits: bits, kept, .. } = *marks;
        let is_fixed = |i: usize| fixed.is_some_and(|fixed| fixed(i)) as u64;
        match (world, fixed) {
            (None, None) => {
                let keys = Keys { upper: &upper, whole: &whole };
                self.radix.sort_keys(threads, boxes.len(), &keys, order);
            }
            (None, Some(_)) if kept > 0 => {
                // The others are all that is sorted, each once.
                self.moving.clear();
                self.moving.extend_from_slice(&order[..order.len() - kept]);
                self.moving.dedup();
                self.still.clear();
                self.still.extend_from_slice(&order[order.len() - kept..]);
                let moving = &self.moving;
                let keys = Keys {
                    upper: &|of| upper(of.map(|i| moving[i] as usize)),
                    whole: &|i| whole(moving[i] as usize),
                };
                self.radix.sort_keys(threads, moving.len(), &keys, order);
                threads.update(order, |i| moving[i as usize]);
                order.extend_from_slice(&self.still);
            }
            _ => {
                // Bits of the world and whether the box stands still before those of the code.
                let before = |i: usize| world.map_or(0, |world| world(i) as u64) << 1 | is_fixed(i);
                let keys = Keys {
                    upper: &|of| {
                        let codes = upper(of);
                        std::array::from_fn(|k| {
                            before(of[k]) << (62 - LOW_BITS - bits) | codes[k] >> (1 + bits)
                        })
                    },
                    whole: &|i| before(i) << (62 - bits) | whole(i) >> (1 + bits),
                };
                self.radix.sort_keys(threads, boxes.len(), &keys, order);
            }
        }
        self.place_posed(order, marks);
        grid
    }

    /// Puts what is posed into its own order, between what moves otherwise, in whole blocks, and
    /// what stands still.
    fn place_posed(&mut self, order: &mut Vec<u32>, marks: &Marks) {
        let Some(posed) = marks.posed else { return };
        let is_still = |id: u32| marks.fixed.is_some_and(|fixed| fixed(id as usize));
        let n_moving = order.partition_point(|&id| !is_still(id));
        self.still.clear();
        self.still.extend(order.drain(n_moving..));
        order.retain(|&id| !(posed.is)(id as usize));
        if let Some(&last) = order.last() {
            order.resize(order.len().next_multiple_of(WIDTH), last);
        }
        order.extend_from_slice(posed.order);
        order.extend_from_slice(&self.still);
    }

    /// The same along the Morton curve, of one world where all moves; fills `codes` with the codes
    /// of the sorted boxes.
    pub fn sort_codes(
        &mut self,
        threads: &Threads,
        boxes: &[Aabb<f32>],
        order: &mut Vec<u32>,
        codes: &mut Vec<[u32; 2]>,
    ) {
        debug_assert_eq!(self.curve, Curve::Morton);
        let grid = self.sort(threads, boxes, &Marks::default(), order);
        codes.resize(boxes.len(), [0; 2]);
        threads.fill(codes, |i| morton_key::morton(order[i] as usize, boxes, &grid));
    }
}
