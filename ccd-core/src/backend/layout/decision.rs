//! Parameters of kernels that look at one listed pair a thread.

use crate::narrow_phase::integer_search::Window;
use bytemuck::{Pod, Zeroable};

/// Parameters of the kernel that tells candidates among listed pairs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Listing {
    /// 0: vertices against faces, 1: edges against edges.
    pub kind: u32,
}

/// Parameters of the kernel that filters candidates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Filtering {
    /// Capacity of the list of pairs of edges; the other is that of the list that is read.
    pub capacity_ee: u32,
}

/// Parameters of the first of two kernels that decide listed pairs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Decision {
    /// Capacity of the list of pairs that are left to the second; 0: there is none.
    pub capacity_left: u32,
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

const _: () = assert!(size_of::<Listing>() == 4 && size_of::<Filtering>() == 4);
const _: () = assert!(size_of::<Decision>() == 4 && size_of::<IntegerDecision>() == 16);
