//! Hilbert codes: cells in the order of a curve that goes from neighbour to neighbour, so that
//! boxes that follow each other have small unions, [Skilling 2004].
//!
//! Like the Morton curve it fills an octant of the grid before it goes on to the next. It makes no
//! jumps inside of it: boxes of 32 neighbours on it overlap a third fewer others.
//!
//! [Skilling 2004]: https://doi.org/10.1063/1.1751381

/// The cell of a grid with `2^bits` cells a side whose Morton code is the Hilbert code of `cell`;
/// `bits` from 1 to 32, coordinates below `2^bits`.
#[inline]
pub fn hilbert_cell(cell: [u32; 3], bits: u32) -> [u32; 3] {
    let mut turned = cell;
    for k in 1..bits {
        turned = turned_at(turned, bits - k);
    }
    coded(turned)
}

/// The same for 10 bits, written out: what is a loop here stays one on a device.
#[inline]
pub fn hilbert_cell_of_10(cell: [u32; 3]) -> [u32; 3] {
    let turned = turned_at(turned_at(turned_at(cell, 9), 8), 7);
    let turned = turned_at(turned_at(turned_at(turned, 6), 5), 4);
    coded(turned_at(turned_at(turned_at(turned, 3), 2), 1))
}

/// The cell as the curve inside of its octant of a level sees it.
#[inline(always)]
fn turned_at([x, y, z]: [u32; 3], bit: u32) -> [u32; 3] {
    let below = (1 << bit) - 1;
    let x = x ^ (below & is_set(x, bit));
    let (x, y) = turned(x, y, is_set(y, bit), below);
    let (x, z) = turned(x, z, is_set(z, bit), below);
    [x, y, z]
}

/// The cell that is turned at all levels, by Gray code.
#[inline(always)]
fn coded([x, y, z]: [u32; 3]) -> [u32; 3] {
    let y = y ^ x;
    let z = z ^ y;
    let turns = above(z);
    [x ^ turns, y ^ turns, z ^ turns]
}

/// All bits if that one of `v` is set, else none.
#[inline(always)]
fn is_set(v: u32, bit: u32) -> u32 {
    0u32.wrapping_sub(v >> bit & 1)
}

/// The bits `below` a level: of the first axis inverted if `inverts` is all ones, else exchanged
/// with those of the other.
#[inline(always)]
fn turned(first: u32, other: u32, inverts: u32, below: u32) -> (u32, u32) {
    let exchanged = (first ^ other) & below & !inverts;
    (first ^ (below & inverts) ^ exchanged, other ^ exchanged)
}

/// Of each bit, whether an odd number of those above it is set.
#[inline(always)]
fn above(v: u32) -> u32 {
    let v = v ^ v >> 1;
    let v = v ^ v >> 2;
    let v = v ^ v >> 4;
    let v = v ^ v >> 8;
    (v ^ v >> 16) >> 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::morton::{morton30, morton63};

    #[test]
    fn the_curve_goes_from_neighbour_to_neighbour_through_all_cells() {
        for bits in 1..=5 {
            let side = 1u32 << bits;
            let mut all: [Option<[u32; 3]>; 1 << 15] = [None; 1 << 15];
            let along = &mut all[..1 << (3 * bits)];
            for i in 0..along.len() as u32 {
                let cell = [i % side, i / side % side, i / side / side];
                let code = morton30(hilbert_cell(cell, bits)) as usize;
                assert_eq!(along[code].replace(cell), None, "{cell:?}");
            }
            for pair in along.windows(2) {
                let [a, b] = [pair[0].unwrap(), pair[1].unwrap()];
                let steps: u32 = (0..3).map(|k| a[k].abs_diff(b[k])).sum();
                assert_eq!(steps, 1, "{a:?} {b:?}");
            }
            // An octant after the other, at every level.
            for levels in 1..bits {
                for part in along.chunks(1 << (3 * (bits - levels))) {
                    let octant = |c: &Option<[u32; 3]>| c.unwrap().map(|c| c >> (bits - levels));
                    assert!(part.iter().all(|c| octant(c) == octant(&part[0])));
                }
            }
        }
    }

    #[test]
    fn ten_levels_are_the_same_without_a_loop() {
        for i in 0..1u32 << 16 {
            let cell = [0, 7, 13].map(|k: u32| i.wrapping_mul(2_654_435_761) >> k & 1023);
            assert_eq!(hilbert_cell_of_10(cell), hilbert_cell(cell, 10), "{cell:?}");
        }
    }

    #[test]
    fn the_finest_grid_of_codes_has_neighbours_too() {
        let code = |cell| {
            let [low, high] = morton63(hilbert_cell(cell, 21));
            (high as u64) << 32 | low as u64
        };
        let cells: [[u32; 3]; 4] =
            [[0, 0, 0], [1 << 20, 5, 99], [(1 << 21) - 1; 3], [1_234_567, 7, 2_000_000]];
        for cell in cells {
            // The cell before or behind on the curve is one of six.
            let around = (0..6).filter_map(|k| {
                let mut other = cell;
                other[k / 2] =
                    if k % 2 == 0 { cell[k / 2].checked_sub(1)? } else { cell[k / 2] + 1 };
                (other[k / 2] < 1 << 21).then_some(other)
            });
            let near = around.filter(|&other| code(other).abs_diff(code(cell)) == 1).count();
            let is_end = code(cell) == 0 || code(cell) == (1 << 63) - 1;
            assert_eq!(near, if is_end { 1 } else { 2 }, "{cell:?}");
        }
    }
}
