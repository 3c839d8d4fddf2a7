//! Vectors and matrices of `glam` as positions and poses: read in place where they are three
//! numbers or sixteen, gathered where they are padded.

use super::{AsPositions, Form, Matrix, Point, PositionView, sealed::Sealed};
use ::glam::{DMat4, DVec3, Mat4, Vec3, Vec3A};

macro_rules! same_memory {
    ($($trait:ident for $t:ty as $of:ty, $scalar:ty;)*) => {$(
        impl Sealed for $t {}

        impl $trait for $t {
            type Scalar = $scalar;

            #[inline]
            fn cast(slice: &[Self]) -> &[$of] {
                bytemuck::cast_slice(slice)
            }
        }
    )*};
}

same_memory! {
    Point for Vec3 as [f32; 3], f32;
    Point for DVec3 as [f64; 3], f64;
    Matrix for Mat4 as [[f32; 4]; 4], f32;
    Matrix for DMat4 as [[f64; 4]; 4], f64;
}

/// Gathered: each is padded to 16 bytes.
impl AsPositions for [Vec3A] {
    type Scalar = f32;

    #[inline]
    fn as_positions(&self) -> PositionView<'_, f32> {
        PositionView(Form::Padded(self))
    }
}
