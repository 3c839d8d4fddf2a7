//! Positions of a step, and which of its times matter.

use crate::step::candidates::Given;
use ccd_core::Real;
use ccd_core::backend::broad_phase::swept_box;
use ccd_core::model::session::Moved;

/// Positions of a step, of which only the times from `from` to `until` matter.
#[derive(Clone, Copy)]
pub struct Positions<'a> {
    pub given: Given<'a>,
    pub from: f64,
    pub until: f64,
    /// What is known from the call before.
    pub moved: Option<Moved<'a>>,
    /// Whether this is the second pass of a call, over a shorter time.
    pub again: bool,
}

impl<'a> Positions<'a> {
    /// At both ends of the step, of which the times of a window matter.
    pub fn new(given: Given<'a>, [from, until]: [f64; 2]) -> Self {
        Self { given, from, until, moved: None, again: false }
    }

    /// Whether the whole step matters.
    pub fn whole(&self) -> bool {
        self.from <= 0.0 && self.until >= 1.0
    }
}

/// The same in the precision of the input.
pub struct Ends<'a, T> {
    pub x0: &'a [[T; 3]],
    pub x1: &'a [[T; 3]],
    pub times: &'a Positions<'a>,
}

impl<T: Real> Ends<'_, T> {
    /// Positions of vertex `i` at `from` and at `until`, each up to [`swept_box::end_error`].
    pub fn ends(&self, i: usize) -> [[f64; 3]; 2] {
        let (p, q) = (self.x0[i].map(T::to_f64), self.x1[i].map(T::to_f64));
        [
            if self.times.from <= 0.0 { p } else { swept_box::end(p, q, self.times.from) },
            if self.times.until >= 1.0 { q } else { swept_box::end(p, q, self.times.until) },
        ]
    }
}
