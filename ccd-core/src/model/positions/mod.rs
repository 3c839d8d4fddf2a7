//! What a session takes positions from: slices as they are, and what is gathered into slices first.
//!
//! | positions | how they are read |
//! |---|---|
//! | `[[f32; 3]]`, `[[f64; 3]]`, as slice, array, `Vec`, behind `Box`, `Arc` | in place |
//! | `[glam::Vec3]`, `[glam::DVec3]` (feature `glam`) | in place |
//! | `[glam::Vec3A]` (feature `glam`) | gathered |
//! | [`Strided`]: bytes with a stride and an offset, as in a vertex buffer | gathered |
//! | [`Posed`]: rest positions, and a matrix for each body | gathered |
//!
//! Both ends of a step are in one precision, and each may come from something else. What is
//! gathered goes to buffers that the session keeps, so that a warm one allocates nothing. Lengths,
//! strides and offsets are checked by the call that reads them.

#[cfg(feature = "alloc")]
mod gathered;
#[cfg(feature = "glam")]
mod glam;
#[cfg_attr(not(feature = "alloc"), allow(dead_code, reason = "what reads them has a heap"))]
mod posed;
#[cfg_attr(not(feature = "alloc"), allow(dead_code, reason = "what reads them has a heap"))]
mod strided;

#[cfg(feature = "alloc")]
pub use gathered::{Chosen, Gathered};
pub use posed::{Matrix, Pose, Posed, check_pose, moved, moved_box};
pub use strided::Strided;

use crate::model::precision::{Coordinate, Erased, Precision};

/// Something that has positions, one a vertex: what `step` and its like take for either end.
///
/// ```
/// use ccd::AsPositions;
/// use ccd::positions::PositionView;
///
/// /// An engine's own container.
/// struct Cloth {
///     x: Vec<[f32; 3]>,
/// }
///
/// impl AsPositions for Cloth {
///     type Scalar = f32;
///
///     fn as_positions(&self) -> PositionView<'_, f32> {
///         self.x.as_positions()
///     }
/// }
/// # assert_eq!(Cloth { x: vec![[0.0; 3]] }.as_positions().len(), 1);
/// ```
pub trait AsPositions {
    /// The type of the coordinates; the same at both ends of a step.
    type Scalar: Coordinate;

    /// Where the positions are.
    fn as_positions(&self) -> PositionView<'_, Self::Scalar>;
}

/// Positions with coordinates `T`, somewhere.
///
/// ```
/// use ccd::AsPositions;
///
/// let x = [[0.0f32; 3]; 4];
/// let view = x.as_positions();
/// // A view has positions itself, so it can be handed on.
/// assert_eq!((view.len(), view.as_positions().is_empty()), (4, false));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PositionView<'a, T>(pub(crate) Form<'a, T>);

/// How they lie there.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Form<'a, T> {
    Points(&'a [[T; 3]]),
    Strided(Strided<'a, T>),
    Posed(Posed<'a, T>),
    #[cfg(feature = "glam")]
    Padded(&'a [::glam::Vec3A]),
}

/// Positions at both ends of a step, in one precision.
///
/// ```
/// use ccd::positions::{Precision, ends};
///
/// let (x0, x1) = ([[0.0f32; 3]; 4], vec![[1.0f32; 3]; 4]);
/// assert!(matches!(ends(&x0, &x1), Precision::F32([a, b]) if a.len() == b.len()));
/// ```
pub type Ends<'a> = Precision<[PositionView<'a, f32>; 2], [PositionView<'a, f64>; 2]>;

impl<'a> Erased for Ends<'a> {
    type Of<T: 'static> = [PositionView<'a, T>; 2];
}

/// Both ends, without their types: where a generic call ends.
#[inline]
pub fn ends<'a, A, B>(x0: &'a A, x1: &'a B) -> Ends<'a>
where
    A: AsPositions + ?Sized,
    B: AsPositions<Scalar = A::Scalar> + ?Sized,
{
    A::Scalar::erase::<Ends>([x0.as_positions(), x1.as_positions()])
}

impl<'a, T: Coordinate> PositionView<'a, T> {
    /// Number of positions.
    pub fn len(&self) -> usize {
        match &self.0 {
            Form::Points(x) => x.len(),
            Form::Strided(x) => x.len(),
            Form::Posed(x) => x.len(),
            #[cfg(feature = "glam")]
            Form::Padded(x) => x.len(),
        }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The position of vertex `v`, the same bits that a step reads.
    ///
    /// # Panics
    /// If there is none, or no matrix for its body.
    pub fn at(&self, v: usize) -> [T; 3] {
        match &self.0 {
            Form::Points(x) => x[v],
            Form::Strided(x) => x.at(v),
            Form::Posed(x) => x.at(v),
            // Only a view of `f32` has this form; an `f32` is exact in either type.
            #[cfg(feature = "glam")]
            Form::Padded(x) => x[v].to_array().map(|c| T::from_f64(c as f64)),
        }
    }
}

/// A point that lies in memory as three coordinates and nothing else: `[f32; 3]`, `[f64; 3]`, and
/// with the feature `glam` its `Vec3` and `DVec3`.
///
/// ```
/// use ccd::AsPositions;
/// use ccd::positions::Point;
///
/// fn count<P: Point>(points: &[P]) -> usize {
///     points.as_positions().len()
/// }
/// assert_eq!(count(&[[0.0f64; 3]; 4]), 4);
/// ```
pub trait Point: sealed::Sealed + Sized {
    /// The type of the coordinates.
    type Scalar: Coordinate;

    /// The same memory.
    #[doc(hidden)]
    fn cast(slice: &[Self]) -> &[[Self::Scalar; 3]];
}

mod sealed {
    /// Types whose layout is known here.
    pub trait Sealed {}
}

impl<T: Coordinate> sealed::Sealed for [T; 3] {}

impl<T: Coordinate> Point for [T; 3] {
    type Scalar = T;

    #[inline]
    fn cast(slice: &[Self]) -> &[[T; 3]] {
        slice
    }
}

impl<P: Point> AsPositions for [P] {
    type Scalar = P::Scalar;

    #[inline]
    fn as_positions(&self) -> PositionView<'_, P::Scalar> {
        PositionView(Form::Points(P::cast(self)))
    }
}

impl<P, const N: usize> AsPositions for [P; N]
where
    [P]: AsPositions,
{
    type Scalar = <[P] as AsPositions>::Scalar;

    #[inline]
    fn as_positions(&self) -> PositionView<'_, Self::Scalar> {
        self[..].as_positions()
    }
}

macro_rules! behind {
    ($($(#[$attr:meta])* ($($of:tt)*) for $what:ty;)*) => {$(
        $(#[$attr])*
        impl<$($of)*> AsPositions for $what {
            type Scalar = A::Scalar;

            #[inline]
            fn as_positions(&self) -> PositionView<'_, A::Scalar> {
                (**self).as_positions()
            }
        }
    )*};
}

behind! {
    (A: AsPositions + ?Sized) for &A;
    (A: AsPositions + ?Sized) for &mut A;
    #[cfg(feature = "alloc")]
    (A: AsPositions + ?Sized) for alloc::boxed::Box<A>;
    #[cfg(feature = "alloc")]
    (A: AsPositions + ?Sized) for alloc::rc::Rc<A>;
    #[cfg(feature = "alloc")]
    (A: AsPositions + ?Sized) for alloc::sync::Arc<A>;
    #[cfg(feature = "alloc")]
    (A: AsPositions + ?Sized + alloc::borrow::ToOwned) for alloc::borrow::Cow<'_, A>;
}

#[cfg(feature = "alloc")]
impl<P> AsPositions for alloc::vec::Vec<P>
where
    [P]: AsPositions,
{
    type Scalar = <[P] as AsPositions>::Scalar;

    #[inline]
    fn as_positions(&self) -> PositionView<'_, Self::Scalar> {
        self[..].as_positions()
    }
}

impl<T: Coordinate> AsPositions for PositionView<'_, T> {
    type Scalar = T;

    #[inline]
    fn as_positions(&self) -> PositionView<'_, T> {
        *self
    }
}
