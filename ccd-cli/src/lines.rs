//! The lines of `ccd sequence --json-lines`, which `ccd merge` reads: steps, and their summary.

use super::output::{Counts, MeshSize, TimesMs, median};
use super::part::Part;
use super::start::Intersections;
use ccd::method::{FrontCounts, TriangleCounts};
use serde::{Deserialize, Serialize};

/// A step; `frame` is its number among all steps, from 0, and that of the frame it begins with.
#[derive(Serialize, Deserialize)]
pub struct Step {
    pub frame: usize,
    /// Name of the frame that the step ends with.
    pub file: String,
    pub candidates: Counts,
    pub contacts: Counts,
    pub undecided: u64,
    /// Contacts at t = 0.
    pub at_start: u64,
    pub toi: Option<f64>,
    pub rebuilt: bool,
    /// With --pipeline triangles.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub triangles: Option<TriangleCounts>,
    /// With --front on.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub front: Option<FrontCounts>,
    pub times_ms: TimesMs,
}

/// The last of the lines of JSON.
#[derive(Serialize, Deserialize)]
pub struct LastLine {
    #[serde(flatten)]
    pub summary: Summary,
    pub mesh: MeshSize,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part: Option<Share>,
    /// Of the first frame of all with itself; in the first part alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub intersections: Option<Intersections>,
}

/// Part of the steps that was done.
#[derive(Clone, Copy, Serialize, Deserialize)]
pub struct Share {
    #[serde(flatten)]
    pub part: Part,
    pub all_steps: usize,
    /// Of parts that are joined: digests of what was asked, and of the frames that the part begins
    /// and ends with, which are those that its neighbours end and begin with.
    #[serde(default)]
    pub asked: u64,
    #[serde(default)]
    pub frames: [u64; 2],
}

/// A digest of bytes, FNV-1a, as a number that JSON holds.
pub fn digest(bytes: impl Iterator<Item = u8>) -> u64 {
    let next = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    bytes.fold(0xcbf2_9ce4_8422_2325, next) >> 11
}

/// A digest of positions.
pub fn digest_of(positions: &[[f64; 3]]) -> u64 {
    digest(positions.iter().flatten().flat_map(|x| x.to_le_bytes()))
}

#[derive(Serialize, Deserialize)]
pub struct Summary {
    pub steps: usize,
    pub contacts: u64,
    pub undecided: u64,
    pub at_start: u64,
    pub free_steps: usize,
    pub rebuilt: usize,
    pub median_ms: f64,
    pub total_ms: f64,
}

/// Milliseconds of a step without loading.
pub fn step_ms(s: &Step) -> f64 {
    s.times_ms.total - s.times_ms.load
}

/// All steps together.
pub fn summarise(steps: &[Step]) -> Summary {
    let mut times: Vec<f64> = steps.iter().map(step_ms).collect();
    times.sort_unstable_by(f64::total_cmp);
    // Lines that were changed by hand may hold any numbers.
    let sum = |number: fn(&Step) -> u64| steps.iter().map(number).fold(0, u64::saturating_add);
    Summary {
        steps: steps.len(),
        contacts: sum(|s| s.contacts.total()),
        undecided: sum(|s| s.undecided),
        at_start: sum(|s| s.at_start),
        free_steps: steps.iter().filter(|s| s.toi.is_none()).count(),
        rebuilt: steps.iter().filter(|s| s.rebuilt).count(),
        median_ms: median(&times).unwrap_or_default(),
        // From a zero that has no sign: that of no steps is 0.
        total_ms: times.iter().fold(0.0, |sum, time| sum + time),
    }
}
