//! Buffers into which a session gathers what is no slice, kept from step to step.

use super::{Ends, Form, PositionView};
use crate::backend::quantization::Scan;
use crate::model::error::Error;
use crate::model::precision::{Coordinate, Given, Precision};
use alloc::vec::Vec;

/// Room for both ends of a step, in either precision; empty until it is needed.
#[derive(Debug, Default)]
pub struct Gathered {
    narrow: [Vec<[f32; 3]>; 2],
    wide: [Vec<[f64; 3]>; 2],
}

impl Gathered {
    /// Both ends as slices: those that there are, or what is gathered.
    ///
    /// # Errors
    /// What [`Strided`](super::Strided) and [`Posed`](super::Posed) say.
    #[inline(never)]
    pub fn slices<'a>(&'a mut self, ends: Ends<'a>) -> Result<Given<'a>, Error> {
        Ok(match ends {
            Precision::F32([x0, x1]) => {
                let [into0, into1] = &mut self.narrow;
                Precision::F32([slice(0, x0, into0)?, slice(1, x1, into1)?])
            }
            Precision::F64([x0, x1]) => {
                let [into0, into1] = &mut self.wide;
                Precision::F64([slice(0, x0, into0)?, slice(1, x1, into1)?])
            }
        })
    }

    /// The positions of some vertices.
    pub fn choose(&mut self, given: Given, vertices: &[u32]) -> Given<'_> {
        fn take<T: Copy>(from: [&[T]; 2], vertices: &[u32], into: &mut [Vec<T>; 2]) {
            for (from, into) in from.into_iter().zip(into) {
                into.clear();
                into.extend(vertices.iter().map(|&v| from[v as usize]));
            }
        }
        match given {
            Precision::F32(x) => {
                take(x, vertices, &mut self.narrow);
                Precision::F32(self.narrow.each_ref().map(|x| &x[..]))
            }
            Precision::F64(x) => {
                take(x, vertices, &mut self.wide);
                Precision::F64(self.wide.each_ref().map(|x| &x[..]))
            }
        }
    }
}

/// Vertices of a mesh, which are those of a part of it.
#[derive(Clone, Copy, Debug)]
pub struct Chosen<'a> {
    /// By the number that they have in the part.
    pub vertices: &'a [u32],
    /// What their positions say together, or a guess that covers it or turns out not to.
    pub scan: &'a Scan,
}

/// The positions of one end.
fn slice<'a, T: Coordinate>(
    time: u8,
    view: PositionView<'a, T>,
    into: &'a mut Vec<[T; 3]>,
) -> Result<&'a [[T; 3]], Error> {
    into.clear();
    match view.0 {
        Form::Points(x) => return Ok(x),
        Form::Strided(x) => into.extend(x.read(time)?),
        Form::Posed(x) => into.extend(x.read(time)?),
        // Only a view of `f32` has this form; an `f32` is exact in either type.
        #[cfg(feature = "glam")]
        Form::Padded(x) => {
            into.extend(x.iter().map(|p| p.to_array().map(|c| T::from_f64(c as f64))));
        }
    }
    Ok(into)
}

#[cfg(test)]
mod tests {
    use super::super::{AsPositions, Strided, ends};
    use super::*;
    use alloc::vec;

    /// What both ends are gathered to.
    fn gather<A, B>(x0: &A, x1: &B) -> Result<[Vec<[f64; 3]>; 2], Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        let mut gathered = Gathered::default();
        Ok(match gathered.slices(ends(x0, x1))? {
            Precision::F32(x) => x.map(|x| x.iter().map(|p| p.map(f64::from)).collect()),
            Precision::F64(x) => x.map(<[_]>::to_vec),
        })
    }

    #[test]
    fn wrong_strides_and_counts_say_where() {
        let bytes = [0u8; 100];
        let fine = [[0.0f32; 3]; 3];
        let of = |stride| Strided::<f32>::new(&bytes, stride);
        let refused = |of: Strided<f32>| gather(&fine, &of).unwrap_err();
        for stride in [0, 1, 11] {
            assert_eq!(refused(of(stride)), Error::Stride { time: 1, stride, least: 12 });
        }
        let bytes = |vertex, end| Error::Bytes { time: 1, vertex, end, found: 100 };
        assert_eq!(refused(of(32).count(4)), bytes(3, 108));
        assert_eq!(refused(of(32).offset(80).count(2)), bytes(1, 124));
        assert_eq!(refused(of(32).offset(90).count(1)), bytes(0, 102));
        assert_eq!(refused(of(32).offset(usize::MAX).count(1)), bytes(0, usize::MAX));
        assert_eq!(refused(of(usize::MAX).count(2)), bytes(1, usize::MAX));
        assert!(of(12).offset(101).is_empty() && of(12).offset(88).len() == 1);
        assert!(of(12).offset(89).is_empty() && of(12).len() == 8);
        let of = of(12).offset(usize::MAX).count(0);
        assert!(gather(&of, &of).unwrap()[0].is_empty());
    }

    #[test]
    fn slices_are_not_copied() {
        let (x0, x1) = ([[0.0f32; 3]; 4], vec![[1.0f32; 3]; 4]);
        let mut gathered = Gathered::default();
        let Ok(Precision::F32(x)) = gathered.slices(ends(&x0, &x1)) else { panic!() };
        assert_eq!(x.map(<[_]>::as_ptr), [x0.as_ptr(), x1.as_ptr()]);
        assert_eq!(gathered.narrow.map(|x| x.capacity()), [0, 0]);
    }
}
