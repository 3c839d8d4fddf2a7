//! Parameters of kernels that decide listed pairs.

use crate::narrow_phase::integer_search::Window;
use bytemuck::{Pod, Zeroable};

/// Parameters of the kernels that look at one listed pair a thread.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Decision {
    /// 0: vertices against faces, 1: edges against edges.
    pub kind: u32,
    /// Capacity of the list of pairs that are left open.
    pub capacity_open: u32,
}

/// Parameters of the kernel that decides listed pairs by integers. Times are in 2^-31 of the step,
/// as in [`Window`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct IntegerDecision {
    /// As where pairs are decided otherwise.
    pub of_pairs: Decision,
    /// First time, rounded up.
    pub from: u32,
    /// Last time, rounded down.
    pub until: u32,
    /// How early a time of impact may be, rounded down.
    pub tolerance: u32,
}

impl IntegerDecision {
    /// In a window.
    pub fn new(of_pairs: Decision, window: Window) -> Self {
        let Window { from, until, tolerance } = window;
        Self { of_pairs, from, until, tolerance }
    }
}

const _: () = assert!(size_of::<Decision>() == 8 && size_of::<IntegerDecision>() == 20);
