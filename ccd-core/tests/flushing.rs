//! Boxes on devices that flush denormals: no pair within the minimum distance is lost. A number
//! type that flushes what goes into an operation and what comes out of it plays the device.

use bytemuck::{Pod, Zeroable};
use ccd_core::broad_phase::swept_box::swept;
use ccd_core::model::quantization::margin;
use ccd_core::{Aabb, Num, Real};
use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// An `f32` whose denormals are zeros.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(transparent)]
struct Flushed(f32);

fn flush(x: f32) -> f32 {
    if x.is_subnormal() { 0.0f32.copysign(x) } else { x }
}

macro_rules! operation {
    ($trait:ident $name:ident $op:tt) => {
        impl $trait for Flushed {
            type Output = Self;
            fn $name(self, other: Self) -> Self {
                Self(flush(flush(self.0) $op flush(other.0)))
            }
        }
    };
}

operation!(Add add +);
operation!(Sub sub -);
operation!(Mul mul *);
operation!(Div div /);

impl Neg for Flushed {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl PartialEq for Flushed {
    fn eq(&self, other: &Self) -> bool {
        flush(self.0) == flush(other.0)
    }
}

impl PartialOrd for Flushed {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        flush(self.0).partial_cmp(&flush(other.0))
    }
}

impl From<Flushed> for f64 {
    fn from(x: Flushed) -> f64 {
        x.0 as f64
    }
}

impl Num for Flushed {
    const UNIT: Self = Self(<f32 as Num>::UNIT);
    const MIN_NORMAL: Self = Self(f32::MIN_POSITIVE);
    type Mask = bool;
    fn gt(self, other: Self) -> bool {
        self > other
    }
    fn splat(x: f32) -> Self {
        Self(x)
    }
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
}

impl Real for Flushed {
    fn to_f64(self) -> f64 {
        self.0 as f64
    }
    fn from_f64(x: f64) -> Self {
        Self(x as f32)
    }
    fn round_down(self) -> f32 {
        self.0
    }
    fn round_up(self) -> f32 {
        self.0
    }
    fn sqrt_up(self) -> Self {
        unreachable!("no box needs a root")
    }
    fn next_up(self) -> Self {
        // As the library does it by bits, where comparisons flush.
        let zero = flush(self.0) == 0.0;
        Self(if zero { f32::from_bits(1) } else { Real::next_up(self.0) })
    }
    fn next_down(self) -> Self {
        -Real::next_up(-self)
    }
    fn is_finite_number(self) -> bool {
        self.0.is_finite()
    }
    fn to_unit(self) -> Self {
        Self(self.0.to_unit())
    }
}

/// Numbers from far below the smallest normal one to some way above it, of both signs.
struct Numbers(u32);

impl Numbers {
    fn bits(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        (self.0 >> 16) ^ self.0
    }

    fn next(&mut self) -> f32 {
        // Exponents 0 (denormal) to 3; denormals of all sizes.
        let bits = self.bits();
        let small = bits & 0x01ff_ffff;
        let small = if small < 0x0080_0000 { small >> (self.bits() % 24) } else { small };
        f32::from_bits(bits & 0x8000_0000 | small)
    }
}

/// The box that a device makes of a point, grown by half of the distance as the host sends that.
fn device_box(x: f32, min_distance: f64) -> Aabb<Flushed> {
    swept([Flushed(x); 3], [Flushed(x); 3]).inflated(Flushed(margin::<f32>(min_distance)))
}

fn check_pair(x: f32, y: f32, min_distance: f64) {
    let (a, b) = (device_box(x, min_distance), device_box(y, min_distance));
    assert!(
        a.overlaps(&b),
        "{x:e} and {y:e} at a distance of {min_distance:e} are lost: {a:?} {b:?}"
    );
}

#[test]
fn pairs_within_the_distance_overlap_where_denormals_are_flushed() {
    // A margin that is flushed itself; a coordinate that is flushed and moves inward by nearly the
    // margin.
    check_pair(1.175_494_4e-38, 1.175_494_6e-38, 1e-40);
    check_pair(3.4e-38, 1.0e-38, 2.45e-38);
    check_pair(-3.4e-38, -1.0e-38, 2.45e-38);
    let mut numbers = Numbers(1);
    for _ in 0..1_000_000 {
        let (x, y) = (numbers.next(), numbers.next());
        // Exactly the gap, which is a number of `f64`, and somewhat more.
        let gap = (x as f64 - y as f64).abs();
        check_pair(x, y, gap);
        check_pair(x, y, gap * 1.01);
    }
}

/// The model finds what it is for: without growing, and with the half of the distance alone, pairs
/// are lost.
#[test]
fn the_model_loses_pairs_that_are_grown_by_half_of_the_distance_alone() {
    let lost = |x: f32, y: f32, margin: f32| {
        let of = |x: f32| swept([Flushed(x); 3], [Flushed(x); 3]).inflated(Flushed(margin));
        !of(x).overlaps(&of(y))
    };
    assert!(lost(1.175_494_4e-38, 1.175_494_6e-38, 0.5e-40));
    assert!(lost(3.4e-38, 1.0e-38, 1.23e-38));
    assert!(!lost(3.4e-38, 1.5e-38, 1.23e-38));
}
