//! From pairs of triangles to pairs of features: every vertex and edge is tested by one triangle.
//!
//! Two triangles are 15 elemental tests: each of six vertices against the other face, each of three
//! edges against each of the other three. Neighbours have their vertices and edges in common, so
//! that plain expansion repeats most tests. What makes it free of duplicates and of most
//! neighbours:
//! - *Representatives* [Curtis 2008]: one triangle tests a vertex or an edge for all that have it
//!   ([`representatives`]). A pair of features is tested by the pair of their representatives,
//!   whose boxes overlap if those of the features do.
//! - *Orphan sets* [Tang 2008]: triangles that share a vertex always overlap, and are skipped. What
//!   no pair without a common vertex tests is found once per mesh, mostly at the boundary
//!   ([`orphans`]).
//! - *Stand-ins* (ours): if the representatives of two features share a vertex, but others of their
//!   triangles do not, the first such pair tests them.
//! - *Free regions* [Volino 1994]: pairs within a region that certainly does not touch itself are
//!   skipped ([`region_certificate`], [`patches`]).
//!
//! ```text
//!   a pair of triangles:   0       3      6 vertex-face: 0 1 2 against 345, 3 4 5 against 012
//!                         / \     / \     9 edge-edge:   01 12 20 against 34 45 53
//!                        1---2   4---5
//! ```
//!
//! Edges that no face has, and vertices in nothing, are triangles with a corner twice or thrice.
//!
//! Both backends make the same tests and count them alike: on a CPU eight pairs side by side, on a
//! GPU one a thread ([`feature_pairs`]).
//!
//! Cost: a face has half a vertex and one edge and a half on average, so a pair of triangles is
//! `2 / 2 + 9 / 4` instead of 15 tests. Choose it to compare with literature that works on
//! triangles, or where a hierarchy of triangles is there anyway; features of their own
//! ([`Features`](crate::model::pipeline::Pipeline::Features)) make smaller boxes.

pub mod feature_pairs;
#[cfg(feature = "alloc")]
pub mod free_regions;
#[cfg(feature = "alloc")]
pub mod near_tests;
#[cfg(feature = "alloc")]
pub mod orphans;
#[cfg(feature = "alloc")]
pub mod patches;
pub mod region_certificate;
#[cfg(feature = "alloc")]
pub mod representatives;

#[cfg(feature = "alloc")]
use crate::{layout::Pair, model::contact::Kind};
#[cfg(feature = "alloc")]
use representatives::Triangles;

/// Which of the tests of a pair of triangles: 0 to 2 a corner of the first against the second, 3 to
/// 5 a corner of the second against the first, 6 + 3 i + j side i of the first against side j of
/// the second.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Test(u8);

impl Test {
    /// Corner `k` of the first triangle against the second.
    pub fn corner(k: usize) -> Self {
        Self(k as u8)
    }

    /// Side `i` of the first triangle against side `j` of the second.
    pub fn sides(i: usize, j: usize) -> Self {
        Self((6 + 3 * i + j) as u8)
    }

    /// The same test with the triangles swapped.
    pub fn swapped(self) -> Self {
        match self.0 {
            k @ 0..3 => Self(k + 3),
            k @ 3..6 => Self(k - 3),
            k => Self(6 + 3 * ((k - 6) % 3) + (k - 6) / 3),
        }
    }

    /// As one bit of a word.
    pub fn bit(self) -> u16 {
        1 << self.0
    }

    /// The tests whose bits are set in a word.
    pub fn all(mut bits: u16) -> impl Iterator<Item = Self> {
        core::iter::from_fn(move || {
            let k = bits.trailing_zeros();
            bits &= bits.wrapping_sub(1);
            (k < 16).then_some(Self(k as u8))
        })
    }

    /// The features that it tests for two triangles.
    #[cfg(feature = "alloc")]
    pub fn features(self, triangles: &Triangles, first: u32, second: u32) -> (Kind, Pair) {
        let k = self.0 as usize;
        let corner = |t: u32, k: usize| triangles.corners(t)[k];
        let side = |t: u32, k: usize| triangles.sides(t)[k];
        match k {
            0..3 => (Kind::VertexFace, Pair { a: corner(first, k), b: second }),
            3..6 => (Kind::VertexFace, Pair { a: corner(second, k - 3), b: first }),
            _ => {
                let (a, b) = (side(first, (k - 6) / 3), side(second, (k - 6) % 3));
                (Kind::EdgeEdge, Pair { a: a.min(b), b: a.max(b) })
            }
        }
    }
}
