//! Slices in either precision: where generic calls end, so that what is behind them is compiled
//! once, by the crate that has it, and not by every crate that calls it.

/// Something in one of the two precisions.
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
pub type Slices<'a, R, const N: usize> = Precision<[&'a [<R as Record>::Of<f32>]; N], [&'a [<R as Record>::Of<f64>]; N]>;
