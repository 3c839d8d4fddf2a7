//! A step of a mesh on a device: its buffers, its dispatches, and what the host does before and
//! after them.

pub mod buffers;
mod candidates;
pub mod codimensional;
pub mod contact_geometry;
pub mod contact_order;
pub mod cpu_fallback;
pub mod frame;
mod kept_order;
pub mod lists;
mod part_limits;
mod passes;
pub mod source;
pub mod triangle_pairs;
pub mod upload;

/// What a frame is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Goal {
    Contacts,
    /// With a sample first, and paths cut at what it finds.
    Earliest,
    /// In one pass over everything.
    EarliestAtOnce,
    Candidates,
}

impl Goal {
    /// Whether the earliest time is all that is asked for.
    pub fn is_earliest(self) -> bool {
        matches!(self, Self::Earliest | Self::EarliestAtOnce)
    }
}

/// All times of a step.
pub const WHOLE: [f64; 2] = [0.0, 1.0];

/// Of how many pairs of blocks one is sampled to bound the earliest time of impact.
pub const SAMPLE: u32 = 64;
