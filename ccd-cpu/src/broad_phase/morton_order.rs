//! Boxes in Morton order: bounds of the scene, codes of the centres, sort.

use crate::sort::RadixSort;
use crate::threads::Threads;
use ccd_core::Aabb;
use ccd_core::broad_phase::morton_key;
use ccd_core::math::morton::MortonGrid;

/// Bits per axis of the codes.
const BITS: u32 = 21;
/// Boxes that a task merges.
const CHUNK: usize = 256;

/// Sorts boxes along the Morton curve; buffers are kept.
#[derive(Debug, Default)]
pub struct MortonOrder {
    radix: RadixSort,
    chunks: Vec<Aabb<f32>>,
}

impl MortonOrder {
    /// The grid over the boxes.
    pub fn grid(&mut self, threads: &Threads, boxes: &[Aabb<f32>]) -> MortonGrid {
        self.chunks.resize(boxes.len().div_ceil(CHUNK), Aabb::EMPTY);
        threads.fill(&mut self.chunks, |i| {
            (0..CHUNK / morton_key::CHUNK).fold(Aabb::EMPTY, |all, k| {
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

    /// Fills `order` with the ids of the boxes; those for which `last(i)` come after all others.
    /// Returns the grid of the codes.
    pub fn sort(
        &mut self,
        threads: &Threads,
        boxes: &[Aabb<f32>],
        last: Option<&(dyn Fn(usize) -> bool + Sync)>,
        order: &mut Vec<u32>,
    ) -> MortonGrid {
        let grid = self.grid(threads, boxes);
        let key = |i: usize| {
            let [low, high] = morton_key::morton(i, boxes, &grid);
            let code = (high as u64) << 32 | low as u64;
            match last {
                Some(last) => (last(i) as u64) << 62 | code >> 1,
                None => code,
            }
        };
        self.radix.sort(threads, boxes.len(), key, order);
        grid
    }
}
