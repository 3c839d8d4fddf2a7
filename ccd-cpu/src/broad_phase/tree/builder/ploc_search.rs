//! The nearest neighbours of clusters, eight boxes at a time.
//!
//! Twin: none; on a GPU a thread looks for the neighbour of a cluster.

use crate::simd::{Block, EMPTY, F32x8, Mask, RowSimd, WIDTH, Work, block_of};
use crate::threads::Threads;
use ccd_core::backend::broad_phase::ploc::{self, distance, prefers};
use ccd_core::model::method::Builder;
use ccd_core::{Aabb, Num};

/// Puts `n` boxes side by side.
pub fn fill_boxes(
    threads: &Threads,
    n: usize,
    out: &mut Vec<Block>,
    boxed: &(dyn Fn(usize) -> Aabb<f32> + Sync),
) {
    out.resize(n.div_ceil(WIDTH), EMPTY);
    threads.fill(out, |b| block_of((b * WIDTH..((b + 1) * WIDTH).min(n)).map(boxed)));
}

/// Blocks that the neighbours of a cluster may be in.
const MAX_BLOCKS: usize = 2 * Builder::MAX_RADIUS as usize / WIDTH + 2;

/// Eight distances that are none.
const FAR: F32x8 = F32x8([ploc::FAR; WIDTH]);

/// The nearest neighbours of some clusters, eight distances at a time; the same clusters as by
/// [`ccd_core::backend::broad_phase::ploc::nearest`].
pub struct Search<'a> {
    /// Of all clusters, in order.
    pub boxes: &'a [Block],
    /// How many those are.
    pub n: usize,
    /// How many to either side are looked at.
    pub radius: u32,
    /// The first cluster whose neighbour is wanted.
    pub first: usize,
    /// The neighbours of it and those that follow.
    pub nearest: &'a mut [u32],
}

impl<S: RowSimd> Work<S> for Search<'_> {
    type Out = ();

    #[inline(always)]
    fn call(self, simd: S) {
        let Self { boxes, n, radius, first, nearest } = self;
        let mut distances = [FAR; MAX_BLOCKS];
        for (k, nearest) in nearest.iter_mut().enumerate() {
            *nearest = nearest_of(simd, first + k, n, radius as usize, boxes, &mut distances);
        }
    }
}

#[inline(always)]
fn nearest_of<S: RowSimd>(
    simd: S,
    i: usize,
    n: usize,
    radius: usize,
    boxes: &[Block],
    distances: &mut [F32x8; MAX_BLOCKS],
) -> u32 {
    let (begin, end) = (i.saturating_sub(radius), (i + radius + 1).min(n));
    let (first, last) = (begin / WIDTH, (end - 1) / WIDTH);
    let aabb = simd.one(&boxes[i / WIDTH], i % WIDTH);
    for (b, block) in boxes[first..last + 1].iter().enumerate() {
        distances[b] = simd.store(distance(&aabb, &simd.boxes(block)));
    }
    // Neither itself nor who is too far along the curve.
    for lane in first * WIDTH..begin {
        distances[0].0[lane % WIDTH] = ploc::FAR;
    }
    for lane in end..(last + 1) * WIDTH {
        distances[last - first].0[lane % WIDTH] = ploc::FAR;
    }
    distances[i / WIDTH - first].0[i % WIDTH] = ploc::FAR;
    let mut least = simd.load(&FAR);
    for of_block in &distances[..last - first + 1] {
        least = least.min(simd.load(of_block));
    }
    let mut least_of_all = ploc::FAR;
    for lane in simd.store(least).0 {
        least_of_all = Num::min(least_of_all, lane);
    }
    let mut best = i as u32;
    for (b, of_block) in distances[..last - first + 1].iter().enumerate() {
        let farther = simd.load(of_block).gt(S::Lanes::splat(least_of_all)).bits();
        let mut nearest = !farther & 0xff;
        while nearest != 0 && least_of_all < ploc::FAR {
            let j = ((first + b) * WIDTH) as u32 + nearest.trailing_zeros();
            nearest &= nearest - 1;
            if prefers(i as u32, j, best) {
                best = j;
            }
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::broad_phase::tests::random;
    use ccd_core::backend::broad_phase::ploc::nearest;

    #[test]
    fn lanes_find_the_neighbours_that_a_kernel_finds() {
        let mut unit = random(5);
        let threads = Threads::new(1).unwrap();
        for n in [1usize, 2, 7, 8, 9, 100, 777] {
            let mut point = |p: f32| Aabb::of_point([p * unit(), p * unit(), unit()]);
            let random: Vec<_> = (0..n).map(|_| point(1.0)).collect();
            let flat: Vec<_> = (0..n).map(|_| point(0.0)).collect();
            for boxes in [random, flat, vec![Aabb::of_point([1.0; 3]); n]] {
                let mut blocks = Vec::new();
                fill_boxes(&threads, n, &mut blocks, &|i| boxes[i]);
                for radius in [1, 2, 8, 16, Builder::MAX_RADIUS] {
                    let mut found = vec![0; n];
                    let (boxes_8, out) = (&blocks[..], &mut found[..]);
                    crate::simd::run_rows!(Search {
                        boxes: boxes_8,
                        n,
                        radius,
                        first: 0,
                        nearest: out
                    });
                    let want = (0..n).map(|i| nearest(i as u32, n as u32, radius, &boxes));
                    let want: Vec<u32> = want.collect();
                    assert_eq!(found, want, "radius {radius}, {boxes:?}");
                }
            }
        }
    }
}
