//! Sweep and prune in strips [Liu 2010]: the scene is cut into strips along the axis of the sweep,
//! each box is in every strip that it touches, and boxes are swept within each strip.
//!
//! ```text
//!   +--------+--------+     Across the strips. `a` is in four of them, `b` in two. They share two;
//!   |   a----|--.  b--|.    the lower corner of what they share, marked `o`, is in the right one
//!   |   |    |  |  |  ||    of the upper two, which reports the pair. On each axis that is the
//!   |   |    | o|--'--|'    strip where one of them begins, the one that begins later.
//!   +---|----+--|-----+
//!   |   '----|--'     |
//!   +--------+--------+
//! ```
//!
//! **Each pair is found once** [Dittrich 2000]. The strip of a place is a monotone function of it
//! along each axis ([`Strips::cell`]: differences, products and conversions round monotonely), so a
//! box is in the strips from that of its lower to that of its upper corner. The lower corner of
//! what two boxes share has along each axis the greater of two lower bounds, and is inside both
//! boxes, so its strip is one of both boxes; and being the strip of the greater bound it is the
//! greater of two numbers, that is, the only common strip in which, on each axis, at least one of
//! both begins ([`begins`]). Two bits a box and strip decide it, exactly, however places are
//! rounded. Within a strip the rule is that of [`super::sweep_and_prune`].
//!
//! Cost: that of a sweep over as many boxes as a strip has, for boxes that are counted once for
//! every strip that they touch. Strips are some mean sides wide, and wider if boxes would be
//! counted too often, so that no sizes need to be refused. Choose it instead of the plain sweep
//! from some hundred thousand boxes on, or where they are large beside the scene.

use crate::math::aabb::Aabb;

/// Bits of the number of a strip along one of the two axes.
pub const BITS: u32 = 6;
/// Most strips along an axis.
pub const MOST: u32 = 1 << BITS;

/// How a scene is cut along two axes; strips at its border have no end.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Strips {
    /// The axes across the strips.
    axes: [usize; 2],
    /// Half of the scene's least corner.
    half_origin: [f32; 2],
    /// One over half of a strip's width, 0 for one strip.
    inverse: [f32; 2],
    /// Number of the last strip.
    last: [f32; 2],
}

impl Strips {
    /// So many strips over `scene` along each of two axes, 1 to [`MOST`].
    #[inline(always)]
    pub fn new(scene: &Aabb<f32>, axes: [usize; 2], n: [u32; 2]) -> Self {
        let mut out = Self { axes, half_origin: [0.0; 2], inverse: [0.0; 2], last: [0.0; 2] };
        for k in 0..2 {
            let (min, max) = (scene.min[axes[k]] * 0.5, scene.max[axes[k]] * 0.5);
            out.half_origin[k] = min;
            // A scene so thin that the factor would overflow is one strip.
            if max - min > 1e-30 {
                out.inverse[k] = n[k] as f32 / (max - min);
            }
            out.last[k] = (n[k] - 1) as f32;
        }
        out
    }

    /// The strip of a place, along both axes.
    #[inline(always)]
    pub fn cell(&self, p: [f32; 3]) -> [u32; 2] {
        let mut out = [0; 2];
        for k in 0..2 {
            let place = (p[self.axes[k]] * 0.5 - self.half_origin[k]) * self.inverse[k];
            // Written so that NaN gives strip 0.
            out[k] = if place >= self.last[k] {
                self.last[k] as u32
            } else if place > 0.0 {
                place as u32
            } else {
                0
            };
        }
        out
    }
}

/// The number of a strip, by which boxes are sorted first.
#[inline(always)]
pub fn key(cell: [u32; 2]) -> u32 {
    cell[1] << BITS | cell[0]
}

/// The strip of a number.
#[inline(always)]
pub fn cell_of(key: u32) -> [u32; 2] {
    [key & (MOST - 1), key >> BITS]
}

/// On which axes a box whose lower corner is in the strip `first` begins in `cell`: bit `k` for
/// axis `k`. Of two boxes in a strip, it reports them if the bits of both together are 3.
#[inline(always)]
pub fn begins(first: [u32; 2], cell: [u32; 2]) -> u32 {
    (first[0] == cell[0]) as u32 | ((first[1] == cell[1]) as u32) << 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::aabb::GREATEST;

    #[test]
    fn strips_of_any_place_are_in_the_scene() {
        let places = [f32::NEG_INFINITY, -GREATEST, -1.0, 0.0, 1e-45, 1.0, GREATEST, f32::NAN];
        for (min, max) in [(-GREATEST, GREATEST), (0.0, 0.0), (-1.0, 1e-40), (1e-45, 2e-45)] {
            let scene = Aabb { min: [min; 3], max: [max; 3] };
            let strips = Strips::new(&scene, [0, 2], [MOST, 5]);
            for p in places {
                let cell = strips.cell([p; 3]);
                assert!(cell[0] < MOST && cell[1] < 5, "{p:e} in {scene:?}: {cell:?}");
                assert_eq!(cell_of(key(cell)), cell);
            }
        }
    }
}
