//! Hilbert codes of 63 bits from Morton codes, two levels of the grid a look into a table.
//!
//! Twin: on a GPU `hilbert_cell` of the core's `math/hilbert.rs`, level by level: the same codes,
//! without a table.

use crate::sort::LOW_BITS;
use ccd_core::Aabb;
use ccd_core::math::morton::{MortonGrid, morton33, morton63};
use std::sync::LazyLock;

/// Bits an axis of a code.
pub const BITS: u32 = 21;
/// Levels of the bits that are sorted digit by digit.
pub const UPPER_LEVELS: u32 = BITS - LOW_BITS / 3;

/// How what is below an octant is turned: from which axis each of the three coordinates is taken,
/// and whether it is inverted; as a number below 48.
#[derive(Clone, Copy)]
struct Turn {
    axes: [u8; 3],
    inverted: [bool; 3],
}

const TURNS: usize = 48;

/// By turn and the octants of two levels, three bits each: the turned octants, six bits, and above
/// them the turn of what is below. Made at the first use, so that no program is 8 KB larger; it has
/// an entry for every index of 12 bits, so that none needs a check.
pub type Turned = [u16; 1 << 12];
static TURNED: LazyLock<Turned> = LazyLock::new(turned);

/// The bits of the three coordinates in a code.
const X: u64 = 0x4924_9249_2492_4924;
const Y: u64 = X >> 1;
const Z: u64 = X >> 2;

/// The table that codes are looked up in.
pub fn turned_octants() -> &'static Turned {
    &TURNED
}

/// The Hilbert codes of the cells of these boxes' centres, on a grid of [`BITS`] an axis: three
/// bits of each of the upper levels, all of which there are [`BITS`]. Each look into the table
/// waits for the one before, not for those of other boxes.
#[inline(never)]
pub fn hilbert_codes<const LEVELS: u32, const K: usize>(
    turned: &Turned,
    boxes: &[Aabb],
    of: [usize; K],
    grid: &MortonGrid,
) -> [u64; K] {
    // A loop: `map` of an array is a call for each box here.
    let mut morton = [0; K];
    for k in 0..K {
        morton[k] = upper_morton::<LEVELS>(grid.cell(&boxes[of[k]]));
    }
    hilbert::<LEVELS, K>(turned, morton)
}

/// Three bits of each of the upper levels of a cell's Morton code, [`UPPER_LEVELS`] or all.
#[inline]
pub fn upper_morton<const LEVELS: u32>(cell: [u32; 3]) -> u64 {
    if LEVELS == UPPER_LEVELS {
        return morton33(cell.map(|k| k >> (BITS - UPPER_LEVELS)));
    }
    let [low, high] = morton63(cell);
    (high as u64) << 32 | low as u64
}

/// The Hilbert codes of the cells with these Morton codes, of an odd number of levels.
fn hilbert<const LEVELS: u32, const K: usize>(turned: &Turned, morton: [u64; K]) -> [u64; K] {
    let (mut found, mut codes) = ([0; K], [0; K]);
    for two in (0..LEVELS / 2).rev() {
        for k in 0..K {
            let octants = (morton[k] >> (6 * two + 3)) as usize & 63;
            found[k] = turned[(found[k] & (63 << 6)) | octants] as usize;
            codes[k] = codes[k] << 6 | (found[k] & 63) as u64;
        }
    }
    for k in 0..K {
        // The last level, and one below it that is not there.
        let last = turned[(found[k] & (63 << 6)) | (morton[k] as usize & 7) << 3];
        let mut code = codes[k] << 3 | (last >> 3 & 7) as u64;
        // From the Gray code of each level to its place, and back where the levels above it turn.
        code ^= (code & X) >> 1;
        code ^= (code & Y) >> 1;
        let mut above = code & Z;
        above ^= above >> 3;
        above ^= above >> 6;
        above ^= above >> 12;
        above ^= above >> 24;
        above ^= above >> 48;
        above >>= 3;
        codes[k] = code ^ above ^ above << 1 ^ above << 2;
    }
    codes
}

impl Turn {
    fn of(number: usize) -> Self {
        let (a, b) = (number / 16, number / 8 % 2);
        let b = if b < a { b } else { b + 1 };
        let flips = number % 8;
        let inverted = [flips & 4 != 0, flips & 2 != 0, flips & 1 != 0];
        Self { axes: [a as u8, b as u8, (3 - a - b) as u8], inverted }
    }

    fn number(self) -> usize {
        let [a, b, _] = self.axes;
        let [x, y, z] = self.inverted;
        let rank = 2 * a as usize + if b < a { b } else { b - 1 } as usize;
        8 * rank + 4 * x as usize + 2 * y as usize + z as usize
    }

    /// An octant (the bits of x, y and z) turned, and the turn of what is below it; see
    /// `hilbert_cell`.
    fn level(mut self, octant: usize) -> (usize, Self) {
        let bit = |k: usize| (octant >> (2 - self.axes[k]) & 1 == 1) != self.inverted[k];
        let bits = [bit(0), bit(1), bit(2)];
        self.inverted[0] ^= bits[0];
        for other in [1, 2] {
            if bits[other] {
                self.inverted[0] ^= true;
            } else {
                self.axes.swap(0, other);
                self.inverted.swap(0, other);
            }
        }
        (4 * bits[0] as usize + 2 * bits[1] as usize + bits[2] as usize, self)
    }
}

fn turned() -> Turned {
    let mut out = [0; 1 << 12];
    for i in 0..64 * TURNS {
        let (first, below) = Turn::of(i / 64).level(i / 8 % 8);
        let (second, below) = below.level(i % 8);
        out[i] = (below.number() << 6 | first << 3 | second) as u16;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::broad_phase::tests::random;
    use ccd_core::math::hilbert::hilbert_cell;

    #[test]
    fn codes_are_those_of_the_core() {
        let code = upper_morton::<BITS>;
        let (mut unit, turned) = (random(5), turned_octants());
        for i in 0..20_000 {
            // Of all sizes.
            let cell = [(); 3].map(|()| (unit() * 2_097_152.0) as u32 >> (i % 21));
            let want = code(hilbert_cell(cell, BITS));
            assert_eq!(hilbert::<BITS, 1>(turned, [code(cell)]), [want], "{cell:?}");
            let upper = upper_morton::<UPPER_LEVELS>(cell);
            assert_eq!(upper, code(cell) >> LOW_BITS, "{cell:?}");
            assert_eq!(hilbert::<UPPER_LEVELS, 1>(turned, [upper]), [want >> LOW_BITS], "{cell:?}");
        }
    }

    #[test]
    fn turns_are_numbered() {
        for number in 0..TURNS {
            assert_eq!(Turn::of(number).number(), number);
        }
    }
}
