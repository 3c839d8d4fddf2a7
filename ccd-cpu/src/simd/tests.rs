//! Every instruction set gives the bits of the portable one.

use super::portable::Portable;
use super::*;
use ccd_core::narrow_phase::cascade;
use ccd_core::narrow_phase::coplanarity::Coplanarity;
use ccd_core::narrow_phase::relative_motion::{Motion, Patch};
use ccd_core::narrow_phase::separating_direction::{axis_separated, beside};

/// A few distinct numbers, so that comparisons are often equal, and all that is special.
const VALUES: [f32; 14] = [
    0.0,
    -0.0,
    1.0,
    1.5,
    -1.0,
    2.0,
    -0.75,
    1e-38,
    -3e-39,
    1e20,
    f32::MAX,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::NAN,
];
/// The first of them are ordinary.
const N_ORDINARY: usize = 7;

/// Random numbers, the same for each instruction set.
struct Random(u32);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        (self.0 >> 16) as usize % n
    }

    /// Mostly any number in (-1, 1), else one of the values, of which one in four may be special.
    fn number(&mut self) -> f32 {
        match self.below(8) {
            0 => VALUES[self.below(VALUES.len())],
            1..4 => VALUES[self.below(N_ORDINARY)],
            _ => {
                (self.below(65_536) as f32 + self.below(65_536) as f32 / 65_536.0) / 32_768.0 - 1.0
            }
        }
    }

    fn lanes(&mut self) -> F32x8 {
        F32x8(std::array::from_fn(|_| self.number()))
    }

    fn block(&mut self) -> Block {
        let mut rows = || [self.lanes(), self.lanes(), self.lanes()];
        Block { min: rows(), max: rows() }
    }
}

/// What rows of boxes answer, word by word.
struct Rows;

impl<S: RowSimd> Work<S> for Rows {
    type Out = Vec<u32>;

    #[inline(always)]
    fn call(self, simd: S) -> Vec<u32> {
        let (mut random, mut out, mut pairs) = (Random(3), Vec::new(), Vec::new());
        for _ in 0..3000 {
            let (a, b) = (random.block(), random.block());
            let (c, d) = (random.block(), random.block());
            let bounds = |of: &Block| {
                let of = simd.boxes(of);
                [of.min, of.max]
            };
            for i in 0..WIDTH {
                out.push(simd.overlaps(&a, i, &b));
                out.push(simd.overlaps_surely(&a, i, &b, 0.5));
                let one = simd.one(&a, i);
                let (one, needed) = ([one.min, one.max], S::Lanes::splat(0.125));
                let mask = axis_separated(&one, &bounds(&b), &bounds(&c), &bounds(&d), needed);
                out.push(mask.bits());
            }
            let ids: [u32; WIDTH] = std::array::from_fn(|_| random.below(5) as u32);
            let (id, mask) = (random.below(5) as u32, random.below(256) as u32);
            out.push(simd.equals(&ids, [id, 2]));
            simd.append::<true>(&mut pairs, id, &ids, mask);
            simd.append::<false>(&mut pairs, id, &ids, mask);
            // Rows at once, without and with numbers in common.
            let more: [u32; WIDTH] = std::array::from_fn(|_| random.below(9) as u32);
            let mut bits = || random.below(1 << 16) as u64;
            let (low, high, few) = (bits(), bits(), bits());
            let masks = low | high << 30 | few << 48;
            let masks = masks & [u64::MAX, few << 20, 0][random.below(3)];
            pairs.reserve(4 * ROOM);
            out.push(
                simd.append_rows::<true, 0, 0>(&mut pairs, [&ids, &more], [], [], masks) as u32
            );
            let (of_a, of_b) = ([&ids, &more], [&more, &ids]);
            out.push(simd.append_rows::<true, 2, 2>(&mut pairs, of_a, of_a, of_b, masks) as u32);
            let (of_a, of_b) = ([&more], [&ids, &[3; WIDTH], &[4; WIDTH]]);
            let n = simd.append_rows::<false, 1, 3>(&mut pairs, [&ids, &more], of_a, of_b, masks);
            out.push(n as u32);
            // Eight pairs at once, of 0 to 16 bits.
            let mut masks = (0..16).fold(0, |all, _| all | 1 << random.below(64));
            masks &= random.below(3) as u64 * 0x5555_ffff_0f0f_ffff;
            while masks != 0 {
                let ([at_a, at_b], mask) = simd.eight(&mut masks);
                out.extend((0..mask.count_ones() as usize).map(|k| 8 * at_a[k] + at_b[k] % 8));
                let (of_a, of_b) = (simd.pick_ids(&ids, &at_a), simd.pick_ids(&ids, &at_b));
                out.push(simd.equals_each(&of_a, [&of_b, &[2; WIDTH]]));
                let ends_a = [simd.picked(&a, &at_a), simd.picked(&b, &at_a)];
                let ends_b = [simd.picked(&c, &at_b), simd.picked(&d, &at_b)];
                out.push(simd.separated_each(ends_a, ends_b, 0.125) & mask);
                simd.append_each::<true>(&mut pairs, &of_a, &of_b, mask);
                simd.append_each::<false>(&mut pairs, &of_a, &of_b, mask);
            }
            let boxes: [Aabb<f32>; 9] = std::array::from_fn(|i| get_lane([&a, &b][i % 2], i / 2));
            let Aabb { min, max } = simd.gather_boxes(&boxes, &more);
            for lanes in [min, max].into_iter().flatten() {
                out.extend(simd.store(lanes).0.map(f32::to_bits));
            }
            // Which of two zeros it is is not promised, and of NaN nothing.
            let lists = [&a.min, &a.max, &b.min, &b.max]
                .map(|of| F32x8(of[0].0.map(|x| if x.is_nan() { 0.5 } else { x })));
            let lists = std::array::from_fn(|k| &lists[k % 4]);
            for lanes in [simd.least_of_each(lists), simd.greatest_of_each(lists)] {
                out.extend(simd.store(lanes).0.map(|x| (x + 0.0).to_bits()));
            }
            let table = [a.min[0].0, a.min[1].0, a.max[0].0, b.min[2].0, b.max[1].0];
            for lanes in simd.gather(&table, &ids) {
                out.extend(simd.store(lanes).0.map(f32::to_bits));
            }
        }
        out.extend(pairs.iter().flat_map(|p| [p.a, p.b]));
        out
    }
}

/// What arithmetic and filters answer, word by word, for pairs that fill every width.
struct Filters;

impl<S: Simd> Work<S> for Filters {
    type Out = Vec<u32>;

    #[inline(always)]
    fn call(self, simd: S) -> Vec<u32> {
        let (mut random, mut out) = (Random(5), Vec::new());
        for _ in 0..600 {
            let table: Vec<[f32; WIDTH]> = (0..64).map(|_| random.lanes().0).collect();
            let ids: [[u32; MAX_WIDTH]; 4] =
                std::array::from_fn(|_| std::array::from_fn(|_| random.below(64) as u32));
            // Answers per pair, so that their order does not depend on the width.
            let mut bits = [[0u32; 3]; MAX_WIDTH];
            let mut numbers = [[0f32; MAX_WIDTH]; 10];
            for first in (0..MAX_WIDTH).step_by(S::LANES) {
                let rows = ids.map(|ids| simd.gather(&table, &ids[first..first + S::LANES]));
                let x = rows.map(|p| [p[0], p[1], p[2]]);
                let y = rows.map(|p| [p[4], p[5], p[6]]);
                let error = S::Lanes::splat(1e-7);
                let (p, q) = (rows[0][3], rows[1][7]);
                let values = [p.max(q), p.min(-q), p.abs() * q + (p - q), S::Lanes::UNIT * p];
                for (k, &value) in values.iter().enumerate() {
                    read(value, &mut numbers[k][first..first + S::LANES]);
                }
                let distance = S::Lanes::splat(0.01);
                let vertex_face = Motion::vertex_face(&x, &y, error);
                let edge_edge = Motion::edge_edge(&x, &y, error);
                let (zero, one) = (S::Lanes::splat(0.0), S::Lanes::splat(1.0));
                let part = cascade::clipped(&edge_edge, zero, one).0;
                let motions = [vertex_face, edge_edge, part];
                let patches = [Patch::Triangle, Patch::Triangle, Patch::Parallelogram];
                for (k, (m, patch)) in motions.iter().zip(patches).enumerate() {
                    let plane = Coplanarity::new(m).clearance(distance);
                    let side = beside(m, patch, distance);
                    read(plane, &mut numbers[4 + 2 * k][first..first + S::LANES]);
                    read(side, &mut numbers[5 + 2 * k][first..first + S::LANES]);
                    let (plane, side) = (plane.gt(zero).bits(), side.gt(zero).bits());
                    for j in 0..S::LANES {
                        bits[first + j][k] = (plane >> j & 1) << 1 | side >> j & 1;
                    }
                }
                assert_eq!(
                    S::Lanes::splat(f32::NAN).gt(p).bits(),
                    0,
                    "NaN is greater than nothing"
                );
            }
            out.extend(numbers.iter().flatten().map(|&x| word(x)));
            out.extend(bits.iter().flatten());
        }
        out
    }
}

/// Bits of a number; which NaN it is is not promised.
fn word(x: f32) -> u32 {
    if x.is_nan() { f32::NAN.to_bits() } else { x.to_bits() }
}

/// Lanes as numbers, by their bytes.
fn read<N: Copy>(lanes: N, out: &mut [f32]) {
    assert_eq!(size_of::<N>(), size_of_val(out));
    // SAFETY: lanes are as many numbers side by side, as the sizes say.
    out.copy_from_slice(unsafe {
        std::slice::from_raw_parts((&raw const lanes).cast::<f32>(), out.len())
    });
}

/// Compares answers with those of the portable set.
fn check_same(name: &str, got: &[u32], want: &[u32]) {
    assert_eq!(got.len(), want.len(), "{name}: number of answers");
    if let Some(i) = (0..got.len()).find(|&i| got[i] != want[i]) {
        panic!("{name}: answer {i} is {:#x}, {:#x} by portable code", got[i], want[i]);
    }
}

#[test]
fn rows_are_the_same_by_every_set() {
    let want = Portable.run(Rows);
    let n_overlaps = want.iter().filter(|&&word| word > 0 && word < 256).count();
    assert!(n_overlaps > 1000, "{n_overlaps} masks show little");
    #[cfg(target_arch = "x86_64")]
    {
        check_same("SSE2", &Sse2.run(Rows), &want);
        match Avx2::new() {
            Some(simd) => check_same("AVX2", &simd.run(Rows), &want),
            None => println!("no AVX2 here: nothing to compare"),
        }
    }
    #[cfg(target_arch = "aarch64")]
    check_same("NEON", &Neon::new().run(Rows), &want);
}

#[test]
fn filters_are_the_same_by_every_set() {
    let want = Portable.run(Filters);
    let rejected = want.iter().filter(|&&word| word > 0 && word < 4).count();
    assert!(rejected > 1000, "{rejected} rejections show little");
    #[cfg(target_arch = "x86_64")]
    {
        check_same("SSE2", &Sse2.run(Filters), &want);
        match Avx2::new() {
            Some(simd) => check_same("AVX2", &simd.run(Filters), &want),
            None => println!("no AVX2 here: nothing to compare"),
        }
        match Avx512::new() {
            Some(simd) => check_same("AVX-512", &simd.run(Filters), &want),
            None => println!("no AVX-512 here: nothing to compare"),
        }
    }
    #[cfg(target_arch = "aarch64")]
    check_same("NEON", &Neon::new().run(Filters), &want);
}

#[test]
#[should_panic = "answer 1 is 0x3"]
fn a_differing_answer_is_seen() {
    check_same("changed", &[1, 3], &[1, 2]);
}
