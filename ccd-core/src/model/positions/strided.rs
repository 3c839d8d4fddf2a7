//! Positions in bytes, a stride apart: vertex buffers in which positions lie between normals and
//! other attributes.

use super::{AsPositions, Form, PositionView};
use crate::model::error::Error;
use crate::model::precision::Coordinate;
use bytemuck::NoUninit;
use core::marker::PhantomData;

/// Positions of which the first begins at an offset in bytes, and every other a stride after the
/// one before. Coordinates are `f32` or `f64` in the byte order of the machine and may lie at any
/// address: they are read one by one, unaligned.
///
/// ```
/// use ccd::Strided;
///
/// // Two vertices: a normal, a position, a pair of texture coordinates.
/// let first = [0.0f32, 0.0, 1.0, 7.0, 8.0, 9.0, 0.5, 0.5];
/// let buffer = [first, first].concat();
/// let positions = Strided::<f32>::new(bytemuck::cast_slice(&buffer), 32).offset(12);
/// assert_eq!(positions.len(), 2);
///
/// // The same from a slice of vertices.
/// #[repr(C)]
/// #[derive(Clone, Copy, bytemuck::NoUninit)]
/// struct Vertex {
///     normal: [f32; 3],
///     position: [f32; 3],
///     texture: [f32; 2],
/// }
/// let vertices: [Vertex; 0] = [];
/// let offset = std::mem::offset_of!(Vertex, position);
/// assert!(Strided::<f32>::of(&vertices).offset(offset).is_empty());
/// ```
///
/// # Errors
/// A call that reads them refuses a stride that is shorter than a position, with [`Error::Stride`],
/// and a [`Strided::count`] beyond the bytes, with [`Error::Bytes`].
#[derive(Clone, Copy, Debug)]
pub struct Strided<'a, T> {
    bytes: &'a [u8],
    stride: usize,
    offset: usize,
    count: Option<usize>,
    scalar: PhantomData<T>,
}

impl<'a, T: Coordinate> Strided<'a, T> {
    /// Positions in these bytes, the first of which begins with the first byte; as many as there
    /// are.
    pub const fn new(bytes: &'a [u8], stride: usize) -> Self {
        Self { bytes, stride, offset: 0, count: None, scalar: PhantomData }
    }

    /// Positions in these vertices, a position each.
    pub fn of<V: NoUninit>(vertices: &'a [V]) -> Self {
        let all = Self::new(bytemuck::cast_slice(vertices), size_of::<V>());
        Self { count: Some(vertices.len()), ..all }
    }

    /// The same, but the first begins at so many bytes.
    #[must_use]
    pub const fn offset(self, offset: usize) -> Self {
        Self { offset, ..self }
    }

    /// The same, but only the first so many.
    #[must_use]
    pub const fn count(self, count: usize) -> Self {
        Self { count: Some(count), ..self }
    }

    /// Number of positions.
    pub fn len(&self) -> usize {
        self.count.unwrap_or_else(|| self.fitting())
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The position of vertex `v`.
    pub(super) fn at(&self, v: usize) -> [T; 3] {
        let &Self { bytes, stride, offset, .. } = self;
        assert!(v < self.len(), "vertex {v} of {} positions", self.len());
        bytemuck::pod_read_unaligned(&bytes[offset + v * stride..][..size_of::<[T; 3]>()])
    }

    /// How many positions end within the bytes.
    fn fitting(&self) -> usize {
        let capacity = self.bytes.len().checked_sub(self.offset);
        let after_first = capacity.and_then(|capacity| capacity.checked_sub(size_of::<[T; 3]>()));
        after_first.map_or(0, |rest| rest.checked_div(self.stride).map_or(usize::MAX, |n| n + 1))
    }

    /// All of them, or why the bytes do not have them.
    pub(super) fn read(&self, time: u8) -> Result<impl Iterator<Item = [T; 3]>, Error> {
        let &Self { bytes, stride, offset, .. } = self;
        let (size, n) = (size_of::<[T; 3]>(), self.len());
        if stride < size {
            return Err(Error::Stride { time, stride, least: size });
        }
        let vertex = self.fitting();
        if n > vertex {
            let end = [stride.saturating_mul(vertex), offset, size];
            let end = end.into_iter().fold(0, usize::saturating_add);
            return Err(Error::Bytes { time, vertex, end, found: bytes.len() });
        }
        let all = bytes.get(offset..).unwrap_or_default().chunks(stride).take(n);
        Ok(all.map(move |vertex| bytemuck::pod_read_unaligned(&vertex[..size])))
    }
}

impl<T: Coordinate> AsPositions for Strided<'_, T> {
    type Scalar = T;

    #[inline]
    fn as_positions(&self) -> PositionView<'_, T> {
        PositionView(Form::Strided(*self))
    }
}
