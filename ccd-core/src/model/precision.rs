//! Slices in either precision: where generic calls end, so that what is behind them is compiled
//! once, by the crate that has it, and not by every crate that calls it.

use crate::math::aabb::Aabb;
use crate::math::real::Real;

/// Something in one of the two precisions.
///
/// ```
/// use ccd::positions::{Precision, ends};
///
/// let x = [[0.0f64; 3]; 2];
/// assert!(matches!(ends(&x, &x), Precision::F64(_)));
/// ```
#[derive(Clone, Copy, Debug)]
pub enum Precision<F, D> {
    /// In `f32`.
    F32(F),
    /// In `f64`.
    F64(D),
}

/// Something in either precision, and what it is where the precision is known.
pub trait Erased {
    /// What it is with coordinates `T`.
    type Of<T: 'static>;
}

/// `N` slices of points, all in one precision.
pub type Points<'a, const N: usize> = Precision<[&'a [[f32; 3]]; N], [&'a [[f64; 3]]; N]>;

impl<'a, const N: usize> Erased for Points<'a, N> {
    type Of<T: 'static> = [&'a [[T; 3]]; N];
}

/// `N` slices of boxes, all in one precision.
pub type Boxes<'a, const N: usize> = Precision<[&'a [Aabb<f32>]; N], [&'a [Aabb<f64>]; N]>;

impl<'a, const N: usize> Erased for Boxes<'a, N> {
    type Of<T: 'static> = [&'a [Aabb<T>]; N];
}

/// Positions at both ends of a step, as given.
pub type Given<'a> = Points<'a, 2>;

mod sealed {
    /// `f32` and `f64` alone.
    pub trait Sealed {}
}

/// A type of coordinates that callers may have: `f32` or `f64`.
///
/// ```
/// use ccd::{AsPositions, Coordinate};
///
/// fn n_vertices<T: Coordinate>(x: &[[T; 3]]) -> usize {
///     x.as_positions().len()
/// }
/// assert_eq!(n_vertices(&[[0.0f32; 3]; 2]) + n_vertices(&[[0.0f64; 3]]), 3);
/// ```
pub trait Coordinate: Real + sealed::Sealed {
    /// The same without its type: a public function that is generic calls one that is not.
    #[doc(hidden)]
    fn erase<E: Erased>(value: E::Of<Self>) -> Precision<E::Of<f32>, E::Of<f64>>;
}

macro_rules! coordinate {
    ($t:ty, $precision:path) => {
        impl sealed::Sealed for $t {}

        impl Coordinate for $t {
            #[inline]
            fn erase<E: Erased>(value: E::Of<Self>) -> Precision<E::Of<f32>, E::Of<f64>> {
                $precision(value)
            }
        }
    };
}

coordinate!(f32, Precision::F32);
coordinate!(f64, Precision::F64);
