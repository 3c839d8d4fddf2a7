//! What is written per instruction set, behind two traits: portable arrays, and vectors that are
//! chosen at run time.
//!
//! | set | rows of eight boxes | filters |
//! |---|---|---|
//! | portable | arrays of 8 | arrays of 8 |
//! | SSE2 (x86-64) | 8 in two registers | 8 in two registers |
//! | AVX2 (x86-64) | 8 in one register | 8 in one register |
//! | AVX-512 (x86-64) | those of AVX2 | 16 in one register |
//! | NEON (AArch64) | 8 in two registers | 8 in two registers |
//! | `simd128` (WebAssembly, where a module is built with it) | 8 in two vectors | the same |
//!
//! All give the same bits: every operation rounds as IEEE 754 says, nothing is contracted, and the
//! greater or smaller of two numbers is chosen by one comparison, as `Num` for `f32` does. (The
//! least of eight numbers is found in an order of its own by each set: of zeros with different
//! signs it may be either.)
//!
//! Where there is another set, only tests have the portable one: vectorizing it took the compiler
//! as long as all the rest of this crate.

#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx512;
#[cfg(target_arch = "aarch64")]
mod neon;
#[cfg(any(
    test,
    not(any(
        target_arch = "x86_64",
        target_arch = "aarch64",
        all(target_arch = "wasm32", target_feature = "simd128")
    ))
))]
pub mod portable;
mod row_simd;
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod simd128;
#[cfg(target_arch = "x86_64")]
mod sse2;
#[cfg(test)]
mod tests;

#[cfg(target_arch = "x86_64")]
pub use avx2::Avx2;
#[cfg(target_arch = "x86_64")]
pub use avx512::Avx512;
#[cfg(target_arch = "aarch64")]
pub use neon::Neon;
pub use row_simd::{ROOM, RowSimd};
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
pub use simd128::Simd128;
#[cfg(target_arch = "x86_64")]
pub use sse2::Sse2;

pub use ccd_core::math::real::Mask;
use ccd_core::{Aabb, Num};

/// Boxes side by side in a block, and lanes of a row.
pub const WIDTH: usize = 8;
/// Lanes of the widest vectors that filters use.
pub const MAX_WIDTH: usize = 16;

/// Eight numbers, aligned for vectors.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C, align(32))]
pub struct F32x8(pub [f32; WIDTH]);

/// Eight boxes side by side; a lane without a box holds the empty one.
pub type Block = Aabb<F32x8>;

/// Eight empty boxes.
pub const EMPTY: Block =
    Aabb { min: [F32x8([f32::INFINITY; WIDTH]); 3], max: [F32x8([f32::NEG_INFINITY; WIDTH]); 3] };

/// The box in lane `j`.
#[inline]
pub fn get_lane(block: &Block, j: usize) -> Aabb<f32> {
    Aabb { min: block.min.map(|x| x.0[j]), max: block.max.map(|x| x.0[j]) }
}

/// Up to eight boxes side by side.
#[inline(always)]
pub fn block_of(boxes: impl Iterator<Item = Aabb<f32>>) -> Block {
    let mut block = EMPTY;
    for (j, aabb) in boxes.enumerate() {
        set_lane(&mut block, j, &aabb);
    }
    block
}

/// Puts a box into lane `j`.
pub fn set_lane(block: &mut Block, j: usize, aabb: &Aabb<f32>) {
    for k in 0..3 {
        block.min[k].0[j] = aabb.min[k];
        block.max[k].0[j] = aabb.max[k];
    }
}

/// An instruction set. A value of it is the proof that the processor has it; vectors of the set are
/// made and used only where there is such a value.
pub trait Simd: Copy + Send + Sync {
    /// What it is called.
    const NAME: &'static str;
    /// Numbers side by side, for filters.
    type Lanes: Num;
    /// How many.
    const LANES: usize;
    /// The first [`Simd::LANES`] of the rows `ids` of a table, transposed: component `k` of all
    /// rows in `out[k]`.
    fn gather(self, table: &[[f32; WIDTH]], ids: &[u32]) -> [Self::Lanes; WIDTH];
    /// Runs `work` with the set enabled for everything that is inlined into it.
    #[inline(always)]
    fn run<W: Work<Self>>(self, work: W) -> W::Out {
        work.call(self)
    }
}

/// The rows `ids` of a table, transposed, where eight numbers are two vectors: `load` reads a row,
/// and `quads` transposes 4 x 4.
#[cfg(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    all(target_arch = "wasm32", target_feature = "simd128")
))]
#[inline(always)]
fn transposed<V: Copy>(
    table: &[[f32; WIDTH]],
    ids: &[u32],
    load: impl Fn(&[f32; WIDTH]) -> [V; 2],
    quads: impl Fn([V; 4]) -> [V; 4],
) -> [[V; 2]; WIDTH] {
    let ids = &ids[..WIDTH];
    let row = |i: usize| load(&table[ids[i] as usize]);
    let (r0, r1, r2, r3) = (row(0), row(1), row(2), row(3));
    let (r4, r5, r6, r7) = (row(4), row(5), row(6), row(7));
    let a = quads([r0[0], r1[0], r2[0], r3[0]]);
    let b = quads([r4[0], r5[0], r6[0], r7[0]]);
    let c = quads([r0[1], r1[1], r2[1], r3[1]]);
    let d = quads([r4[1], r5[1], r6[1], r7[1]]);
    let (low, high) = ([0, 1, 2, 3].map(|k| [a[k], b[k]]), [0, 1, 2, 3].map(|k| [c[k], d[k]]));
    [low[0], low[1], low[2], low[3], high[0], high[1], high[2], high[3]]
}

/// Something to run with an instruction set. `call` must be `#[inline(always)]`, or the set is not
/// enabled inside.
pub trait Work<S: Simd> {
    /// What it returns.
    type Out;
    /// Does the work.
    fn call(self, simd: S) -> Self::Out;
}

/// Runs work with the best set of this processor for rows.
macro_rules! run_rows {
    ($work:expr) => {{
        #[cfg(target_arch = "x86_64")]
        {
            if let Some(simd) = $crate::simd::Avx2::new() {
                $crate::simd::Simd::run(simd, $work)
            } else {
                $crate::simd::Simd::run($crate::simd::Sse2, $work)
            }
        }
        #[cfg(target_arch = "aarch64")]
        {
            $crate::simd::Simd::run($crate::simd::Neon::new(), $work)
        }
        #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
        {
            $crate::simd::Simd::run($crate::simd::Simd128, $work)
        }
        #[cfg(not(any(
            target_arch = "x86_64",
            target_arch = "aarch64",
            all(target_arch = "wasm32", target_feature = "simd128")
        )))]
        {
            $crate::simd::Simd::run($crate::simd::portable::Portable, $work)
        }
    }};
}
pub(crate) use run_rows;

/// Runs work with the best set of this processor for filters.
macro_rules! run {
    ($work:expr) => {{
        #[cfg(target_arch = "x86_64")]
        {
            if let Some(simd) = $crate::simd::Avx512::new() {
                $crate::simd::Simd::run(simd, $work)
            } else {
                $crate::simd::run_rows!($work)
            }
        }
        #[cfg(not(target_arch = "x86_64"))]
        {
            $crate::simd::run_rows!($work)
        }
    }};
}
pub(crate) use run;

/// The widest instruction set of this processor that the filters use: `AVX-512`, `AVX2`, `SSE2`,
/// `NEON`, `simd128` or `portable`.
///
/// ```
/// let all = ["AVX-512", "AVX2", "SSE2", "NEON", "portable"];
/// assert!(all.contains(&ccd::instruction_set()));
/// ```
pub fn instruction_set() -> &'static str {
    struct Name;
    impl<S: Simd> Work<S> for Name {
        type Out = &'static str;
        #[inline(always)]
        fn call(self, _: S) -> Self::Out {
            S::NAME
        }
    }
    run!(Name)
}

/// `Num` for a vector type from functions of its instruction set: the two that take one vector,
/// those that take two, the comparison, and all lanes alike. With `@mask`: `Mask` for eight answers
/// as vectors, from those that take two, and the one that makes bits of them.
#[cfg(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    all(target_arch = "wasm32", target_feature = "simd128")
))]
macro_rules! num {
    (
        $lanes:ident($width:expr), $mask:ty,
        $neg:path, $abs:path, $add:path, $sub:path, $mul:path, $div:path, $max:path, $min:path,
        $gt:path
    ) => {
        $crate::simd::num!(@operator $lanes, Add, add, $add);
        $crate::simd::num!(@operator $lanes, Sub, sub, $sub);
        $crate::simd::num!(@operator $lanes, Mul, mul, $mul);
        $crate::simd::num!(@operator $lanes, Div, div, $div);

        impl std::ops::Neg for $lanes {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                // SAFETY: there are such vectors only where the processor has the set.
                Self(unsafe { $neg(self.0) })
            }
        }

        impl $lanes {
            /// `x` in every lane; any processor can do that.
            #[inline(always)]
            const fn all(x: f32) -> Self {
                // SAFETY: a vector is its numbers, in order; every bit pattern is one.
                unsafe { std::mem::transmute::<[f32; $width], Self>([x; $width]) }
            }
        }

        impl ccd_core::Num for $lanes {
            const UNIT: Self = Self::all(<f32 as ccd_core::Num>::UNIT);
            const MIN_NORMAL: Self = Self::all(<f32 as ccd_core::Num>::MIN_NORMAL);
            type Mask = $mask;
            #[inline(always)]
            fn gt(self, other: Self) -> $mask {
                // SAFETY: as above.
                unsafe { $gt(self.0, other.0) }.into()
            }
            #[inline(always)]
            fn splat(x: f32) -> Self {
                Self::all(x)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                // SAFETY: as above.
                Self(unsafe { $abs(self.0) })
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                // SAFETY: as above.
                Self(unsafe { $max(self.0, other.0) })
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                // SAFETY: as above.
                Self(unsafe { $min(self.0, other.0) })
            }
        }
    };
    (@mask $mask:ident($vector:ty), $and:path, $or:path, $bits:path) => {
        $crate::simd::num!(@operator $mask, BitAnd, bitand, $and);
        $crate::simd::num!(@operator $mask, BitOr, bitor, $or);

        impl From<$vector> for $mask {
            #[inline(always)]
            fn from(x: $vector) -> Self {
                Self(x)
            }
        }

        impl $crate::simd::Mask for $mask {
            const ALL: u32 = 0xff;
            #[inline(always)]
            fn bits(self) -> u32 {
                // SAFETY: there are such masks only where the processor has the set.
                unsafe { $bits(self.0) }
            }
        }
    };
    (@operator $lanes:ident, $trait:ident, $name:ident, $function:path) => {
        impl std::ops::$trait for $lanes {
            type Output = Self;
            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                // SAFETY: there are such vectors only where the processor has the set.
                Self(unsafe { $function(self.0, other.0) })
            }
        }
    };
}
#[cfg(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    all(target_arch = "wasm32", target_feature = "simd128")
))]
pub(crate) use num;
