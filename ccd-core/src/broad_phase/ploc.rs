//! Map and meet: clusters of boxes along the Morton curve, joined in rounds with their nearest
//! neighbours [Meister 2018].
//!
//! A round is three passes over the clusters: each looks for its [`nearest`] neighbour among so
//! many to either side; two that are each other's nearest are joined, by the lesser ([`fate`]), and
//! take its place; those that are left move together, in order.
//!
//! A cluster has a name that none other has: that of its first box; of two that are joined, the
//! lesser name stays and the greater is retired, and less one it is the number of the new node. So
//! nodes are numbered without a counter.

use crate::kernel::memory::at;
use crate::math::aabb::Aabb;
use crate::math::real::Num;

/// A round in which fewer than one of so many clusters would take in another joins neighbours in
/// pairs instead, whatever their distance ([`neighbour`]).
///
/// Boxes inside of each other, the larger the later, all have the smallest for their nearest;
/// rounds that join two clusters each would take a time that grows with the square of their number,
/// and leave a tree as deep as there are boxes. A usual round joins 1 of 3 to 4. With this there
/// are at most 350 rounds, and levels, for any boxes: each leaves at most 15/16 of the clusters.
pub const SLOW: u32 = 16;

/// Half the surface of the box around two: what makes neighbours near. For one box or for lanes of
/// them.
#[inline(always)]
pub fn distance<N: Num>(a: &Aabb<N>, b: &Aabb<N>) -> N {
    let x = a.max[0].max(b.max[0]) - a.min[0].min(b.min[0]);
    let y = a.max[1].max(b.max[1]) - a.min[1].min(b.min[1]);
    let z = a.max[2].max(b.max[2]) - a.min[2].min(b.min[2]);
    x * y + y * z + z * x
}

/// The nearest neighbour of cluster `i` of `n` among `radius` to either side; `i` itself if there
/// is none. The loop runs over `2 radius + 1` clusters.
///
/// Of equally near ones it is that whose index differs in the lowest bits. With this two clusters
/// with the least distance of all are each other's nearest, if not those of others; and equal boxes
/// are joined in pairs.
#[inline(always)]
pub fn nearest(i: u32, n: u32, radius: u32, boxes: &[Aabb<f32>]) -> u32 {
    let own = at(boxes, i as usize);
    let (first, end) = (i.saturating_sub(radius), (i + radius + 1).min(n));
    let (mut best, mut least) = (i, f32::MAX);
    for j in first..end {
        let d = distance(&own, &at(boxes, j as usize));
        if j != i && (d < least || (d == least && prefers(i, j, best))) {
            best = j;
            least = d;
        }
    }
    best
}

/// Whether cluster `i` takes `j` rather than `best`, which is as near or is `i` itself.
#[inline(always)]
pub fn prefers(i: u32, j: u32, best: u32) -> bool {
    best == i || (i ^ j) < (i ^ best)
}

/// The neighbour of cluster `i` of `n` in a round that joins them in pairs; itself if it is the
/// last and has none.
#[inline(always)]
pub fn neighbour(i: u32, n: u32) -> u32 {
    if (i ^ 1) < n { i ^ 1 } else { i }
}

/// What becomes of a cluster in a round.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// It stays as it is.
    Stays,
    /// It takes in its neighbour, which comes after it.
    Joins,
    /// It is taken in.
    Ends,
}

/// What becomes of cluster `i`, from the neighbours of all.
#[inline(always)]
pub fn fate(i: u32, neighbours: &[u32]) -> Fate {
    let j = at(neighbours, i as usize);
    if i == j || at(neighbours, j as usize) != i {
        Fate::Stays
    } else if i < j {
        Fate::Joins
    } else {
        Fate::Ends
    }
}
