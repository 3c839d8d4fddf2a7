//! Slices in either precision: where generic calls end, so that what is behind them is compiled
//! once, by the crate that has it, and not by every crate that calls it.

use crate::math::real::Real;
use crate::model::positions::{Ends, PositionView};

/// Something in one of the two precisions.
///
/// ```
/// use ccd_core::model::{positions::ends, precision::Precision};
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

/// A record of coordinates, whatever their type: `[T; 3]`, a box of `T`.
pub trait Record {
    /// The record of coordinates `T`.
    type Of<T: 'static>: 'static;
}

/// Points, `[T; 3]`.
#[derive(Clone, Copy, Debug)]
pub struct Points;

impl Record for Points {
    type Of<T: 'static> = [T; 3];
}

/// `N` slices of one kind of record, all in one precision.
pub type Slices<'a, R, const N: usize> =
    Precision<[&'a [<R as Record>::Of<f32>]; N], [&'a [<R as Record>::Of<f64>]; N]>;

/// Positions at both ends of a step, as given.
pub type Given<'a> = Slices<'a, Points, 2>;

mod sealed {
    /// `f32` and `f64` alone.
    pub trait Sealed {}
}

/// A type of coordinates that callers may have: `f32` or `f64`.
///
/// ```
/// use ccd_core::Coordinate;
/// use ccd_core::model::positions::AsPositions;
///
/// fn n_vertices<T: Coordinate>(x: &[[T; 3]]) -> usize {
///     x.as_positions().len()
/// }
/// assert_eq!(n_vertices(&[[0.0f32; 3]; 2]) + n_vertices(&[[0.0f64; 3]]), 3);
/// ```
pub trait Coordinate: Real + sealed::Sealed {
    /// Slices of records of such numbers, as what they are: a public function that is generic calls
    /// one that is not.
    #[doc(hidden)]
    fn slices<'a, R: Record, const N: usize>(of: [&'a [R::Of<Self>]; N]) -> Slices<'a, R, N>;

    /// The same for positions at both ends of a step.
    #[doc(hidden)]
    fn ends(of: [PositionView<'_, Self>; 2]) -> Ends<'_>;
}

macro_rules! coordinate {
    ($t:ty, $precision:path) => {
        impl sealed::Sealed for $t {}

        impl Coordinate for $t {
            #[inline]
            fn slices<'a, R: Record, const N: usize>(
                of: [&'a [R::Of<Self>]; N],
            ) -> Slices<'a, R, N> {
                $precision(of)
            }

            #[inline]
            fn ends(of: [PositionView<'_, Self>; 2]) -> Ends<'_> {
                $precision(of)
            }
        }
    };
}

coordinate!(f32, Precision::F32);
coordinate!(f64, Precision::F64);
