//! Bodies that move as a whole: rest positions, and a matrix for each body at either end.

use super::{AsPositions, Form, Point, PositionView, sealed::Sealed};
use crate::math::aabb::Aabb;
use crate::math::real::Num;
use crate::model::error::Error;
use crate::model::precision::Coordinate;

/// Positions at one end of a step: those of rest, each moved by the matrix of its body.
///
/// **A step is straight.** Each vertex moves on the line between its positions at the two ends,
/// also where a body turns: the corners of a box that turns by half a circle meet in its axis. The
/// larger the angle of a step, the more a body shrinks in between, by `1 - cos(angle / 2)` of its
/// radius; steps of a few degrees (1 degree: 0.004 %) are nearly rigid.
///
/// Matrices are affine and of columns: three axes, each with a 0, then the place with a 1, as those
/// of `glam` (feature `glam`: `Mat4`, `DMat4`). A position is the sum `axis0 * x + axis1 * y +
/// axis2 * z + place` in the precision of the input, from left to right, which are the bits of
/// `Mat4::transform_point3`.
///
/// ```
/// use ccd::Posed;
///
/// let rest = [[0.0f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [5.0, 5.0, 5.0]];
/// let mut still = [[0.0; 4]; 4];
/// (0..4).for_each(|k| still[k][k] = 1.0);
/// let mut moved = still;
/// moved[3][2] = -2.0;
/// // Two bodies: the first three vertices, and the last.
/// let poses = [still, moved];
/// let x1 = Posed::new(&rest, &[0, 0, 0, 1], &poses);
/// assert_eq!(x1.len(), 4);
/// ```
///
/// # Errors
/// A call that reads them refuses a body without a matrix, with [`Error::Pose`], a matrix whose
/// last row is not 0, 0, 0, 1, with [`Error::Projection`], and another number of bodies' numbers
/// than of vertices, with [`Error::BodyCount`].
#[derive(Clone, Copy, Debug)]
pub struct Posed<'a, T> {
    rest: &'a [[T; 3]],
    /// `None`: all have the first matrix.
    body_of_vertex: Option<&'a [u32]>,
    poses: &'a [Pose<T>],
}

/// An affine matrix of four columns.
pub type Pose<T> = [[T; 4]; 4];

/// A matrix of four columns of four numbers: `[[f32; 4]; 4]`, `[[f64; 4]; 4]`, and with the feature
/// `glam` its `Mat4` and `DMat4`.
///
/// ```
/// use ccd::Posed;
/// use ccd::positions::Matrix;
///
/// fn posed<'a, M: Matrix<Scalar = f32>>(rest: &'a [[f32; 3]], pose: &'a M) -> Posed<'a, f32> {
///     Posed::one(rest, pose)
/// }
/// let identity = [0, 1, 2, 3].map(|k| [0, 1, 2, 3].map(|i| (i == k) as u8 as f32));
/// assert_eq!(posed(&[[1.0, 2.0, 3.0]], &identity).len(), 1);
/// ```
pub trait Matrix: Sealed + Sized {
    /// The type of the numbers.
    type Scalar: Coordinate;

    /// The same memory.
    #[doc(hidden)]
    fn cast(slice: &[Self]) -> &[Pose<Self::Scalar>];
}

impl<T: Coordinate> Sealed for [[T; 4]; 4] {}

impl<T: Coordinate> Matrix for [[T; 4]; 4] {
    type Scalar = T;

    #[inline]
    fn cast(slice: &[Self]) -> &[Pose<T>] {
        slice
    }
}

impl<'a, T: Coordinate> Posed<'a, T> {
    /// Every vertex has the matrix of its body: `poses[body_of_vertex[v]]`.
    pub fn new<P, M>(rest: &'a [P], body_of_vertex: &'a [u32], poses: &'a [M]) -> Self
    where
        P: Point<Scalar = T>,
        M: Matrix<Scalar = T>,
    {
        let body_of_vertex = Some(body_of_vertex);
        Self { rest: P::cast(rest), body_of_vertex, poses: M::cast(poses) }
    }

    /// All vertices have one matrix.
    pub fn one<P, M>(rest: &'a [P], pose: &'a M) -> Self
    where
        P: Point<Scalar = T>,
        M: Matrix<Scalar = T>,
    {
        let poses = M::cast(core::slice::from_ref(pose));
        Self { rest: P::cast(rest), body_of_vertex: None, poses }
    }

    /// Number of positions.
    pub fn len(&self) -> usize {
        self.rest.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    /// All of them, or what is wrong with bodies or matrices.
    pub(super) fn read(&self, time: u8) -> Result<impl Iterator<Item = [T; 3]>, Error> {
        let &Self { rest, body_of_vertex, poses } = self;
        let (expected, n_poses) = (rest.len(), poses.len());
        if let Some(bodies) = body_of_vertex {
            if bodies.len() != expected {
                return Err(Error::BodyCount { expected, found: bodies.len() });
            }
            if let Some(vertex) = bodies.iter().position(|&body| body as usize >= n_poses) {
                return Err(Error::Pose { time, vertex, body: bodies[vertex], n_poses });
            }
        }
        for (body, pose) in poses.iter().enumerate() {
            check_pose(time, body, pose)?;
        }
        Ok((0..rest.len()).map(|v| self.at(v)))
    }

    /// The position of vertex `v`.
    #[inline]
    pub(super) fn at(&self, v: usize) -> [T; 3] {
        let body = self.body_of_vertex.map_or(0, |bodies| bodies[v] as usize);
        moved(&self.poses[body], &self.rest[v])
    }
}

/// Refuses the matrix of a body that is not affine.
///
/// # Errors
/// [`Error::Projection`].
pub fn check_pose<T: Coordinate>(time: u8, body: usize, pose: &Pose<T>) -> Result<(), Error> {
    let row = pose.map(|column| column[3].to_f64());
    if row == [0.0, 0.0, 0.0, 1.0] { Ok(()) } else { Err(Error::Projection { time, body, row }) }
}

/// A point moved by a matrix.
#[inline]
pub fn moved<T: Coordinate>([x, y, z, place]: &Pose<T>, p: &[T; 3]) -> [T; 3] {
    core::array::from_fn(|k| x[k] * p[0] + y[k] * p[1] + z[k] * p[2] + place[k])
}

/// A box that holds where [`moved`] puts any point of a box, to the last bit: rounding to nearest
/// is monotone, so its terms, each at the corner that makes it least, add up in its order to no
/// more than they do for any point. Only for matrices that move the points whose coordinates bound
/// the box to finite numbers: then each term is finite, and no bound is NaN.
#[inline]
pub fn moved_box<T: Coordinate>([x, y, z, place]: &Pose<T>, of: &Aabb<T>) -> Aabb<T> {
    let terms = |axis: &[T; 4], k: usize, j: usize| [axis[k] * of.min[j], axis[k] * of.max[j]];
    let sum = |k: usize, choose: fn(T, T) -> T| {
        let term = |axis, j| {
            let [a, b] = terms(axis, k, j);
            choose(a, b)
        };
        term(x, 0) + term(y, 1) + term(z, 2) + place[k]
    };
    Aabb { min: [0, 1, 2].map(|k| sum(k, Num::min)), max: [0, 1, 2].map(|k| sum(k, Num::max)) }
}

impl<T: Coordinate> AsPositions for Posed<'_, T> {
    type Scalar = T;

    #[inline]
    fn as_positions(&self) -> PositionView<'_, T> {
        PositionView(Form::Posed(*self))
    }
}
