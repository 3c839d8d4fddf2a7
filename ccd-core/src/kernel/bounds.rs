//! Map: the bounds of many boxes, a chunk a thread; repeated until one box is left. Also their Morton codes.

use crate::aabb::Aabb;
use crate::morton::{MortonGrid, morton63};

/// Boxes that one thread merges: enough that two passes serve 65,536 boxes, few enough to keep a GPU busy.
pub const CHUNK: usize = 256;

/// Bounds of chunk `i`, that is of boxes `i * CHUNK ..` up to the end of the chunk or of `boxes`.
#[inline]
pub fn scene_bounds(i: usize, boxes: &[Aabb<f32>]) -> Aabb<f32> {
    let mut out = Aabb::EMPTY;
    let end = (i + 1) * CHUNK;
    let end = if end < boxes.len() { end } else { boxes.len() };
    for k in i * CHUNK..end {
        out = out.union(&boxes[k]);
    }
    out
}

/// Morton code, 63 bits as `[low, high]`, of the centre of box `i`.
#[inline]
pub fn morton(i: usize, boxes: &[Aabb<f32>], grid: &MortonGrid) -> [u32; 2] {
    morton63(grid.cell(&boxes[i]))
}
