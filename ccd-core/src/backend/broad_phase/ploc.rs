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

/// Rounds after which, on average, the clusters must be half as many; a round that comes later
/// joins neighbours in pairs, whatever their distance ([`neighbour`]).
///
/// Boxes inside of each other, the larger the later, all have the smallest for their nearest;
/// rounds that join two clusters each would take a time that grows with the square of their number,
/// and leave a tree as deep as there are boxes. On real scenes 3 to 5.3 rounds halve the clusters.
/// With this there are at most [`rounds`], for any boxes, and as many levels above the leaves.
pub const ROUNDS: u32 = 6;

/// How often `n` clusters must be halved, rounding up, until one is left.
#[inline(always)]
pub const fn halvings(n: u32) -> u32 {
    if n > 1 { 32 - (n - 1).leading_zeros() } else { 0 }
}

/// Whether round `round` (from 0), which `n` clusters of a tree over `n_leaves` have reached, joins
/// neighbours in pairs.
///
/// Each such round takes one from the halvings that are left, so none can be late twice in a row.
#[inline(always)]
pub fn is_late(round: u32, n: u32, n_leaves: u32) -> bool {
    round >= ROUNDS * (halvings(n_leaves) - halvings(n) + 1)
}

/// Rounds after which at most `left` clusters of `n` leaves are left, `left` a power of two.
pub const fn rounds(n: u32, left: u32) -> u32 {
    if n > left { ROUNDS * (halvings(n) - halvings(left)) + 1 } else { 0 }
}

/// Clusters that one workgroup of a device joins without further dispatches.
pub const FEW: u32 = 256;

/// Words, on a device, for the clusters that are left after each round in which there were more; no
/// tree has as many such rounds. Behind them are the sums of a round, of tiles of clusters.
pub const COUNTS: usize = 192;

const _: () = assert!((rounds(u32::MAX / 2, FEW) as usize) < COUNTS);

/// Most clusters of `n` leaves that reach round `round`.
pub fn clusters(round: u32, n: u32) -> u32 {
    let halved = round.saturating_sub(1) / ROUNDS;
    if halved == 0 { n } else { n.min(1 << halvings(n).saturating_sub(halved)) }
}

/// Half the surface of the box around two: what makes neighbours near. For one box or for lanes of
/// them.
#[inline(always)]
pub fn distance<N: Num>(a: &Aabb<N>, b: &Aabb<N>) -> N {
    let x = a.max[0].max(b.max[0]) - a.min[0].min(b.min[0]);
    let y = a.max[1].max(b.max[1]) - a.min[1].min(b.min[1]);
    let z = a.max[2].max(b.max[2]) - a.min[2].min(b.min[2]);
    x * y + y * z + z * x
}

/// More than any distance of boxes in cells of a Morton grid.
pub const FAR: f32 = 3.0e38;

/// The nearest of the neighbours that a cluster has looked at.
#[derive(Clone, Copy, Debug)]
pub struct Nearest {
    /// Its index; the cluster's own if there is none.
    pub best: u32,
    least: f32,
}

impl Nearest {
    /// Cluster `i` has looked at none.
    #[inline(always)]
    pub fn none(i: u32) -> Self {
        Self { best: i, least: FAR }
    }

    /// Cluster `i` looks at `j`, which may be itself.
    ///
    /// Of equally near ones it is that whose index differs in the lowest bits. With this two
    /// clusters with the least distance of all are each other's nearest, if not those of others;
    /// and equal boxes are joined in pairs.
    #[inline(always)]
    pub fn look(&mut self, i: u32, j: u32, aabb: &Aabb<f32>, other: &Aabb<f32>) {
        let d = distance(aabb, other);
        if j != i && (d < self.least || (d == self.least && prefers(i, j, self.best))) {
            self.best = j;
            self.least = d;
        }
    }
}

/// The clusters that cluster `i` of `n` looks at, itself among them: from the first to before the
/// second.
#[inline(always)]
pub fn window(i: u32, n: u32, radius: u32) -> [u32; 2] {
    [i - radius.min(i), (i + radius + 1).min(n)]
}

/// The nearest neighbour of cluster `i` of `n` among `radius` to either side; `i` itself if there
/// is none. The loop runs over `2 radius + 1` clusters.
#[inline(always)]
pub fn nearest(i: u32, n: u32, radius: u32, boxes: &[Aabb<f32>]) -> u32 {
    let aabb = at(boxes, i as usize);
    let [first, end] = window(i, n, radius);
    let mut nearest = Nearest::none(i);
    for j in first..end {
        nearest.look(i, j, &aabb, &at(boxes, j as usize));
    }
    nearest.best
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

/// What becomes of a cluster in a round. A word, because shaders have no smaller number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
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
    fate_beside(i, j, at(neighbours, j as usize))
}

/// What becomes of cluster `i`, from its neighbour `j` and the neighbour of that.
#[inline(always)]
pub fn fate_beside(i: u32, j: u32, of_j: u32) -> Fate {
    if i == j || of_j != i {
        Fate::Stays
    } else if i < j {
        Fate::Joins
    } else {
        Fate::Ends
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Clusters of which none joins another but in a round that is late are one after as many
    /// rounds as are promised, and never more than are promised.
    #[test]
    fn rounds_are_bounded() {
        for n_leaves in [1u32, 2, 3, 255, 256, 257, 1000, 65_537, 10_000_000, u32::MAX / 2] {
            for left in [1, 256] {
                let (mut n, mut round) = (n_leaves, 0);
                while n > left {
                    assert!(n <= clusters(round, n_leaves), "round {round} of {n_leaves}: {n}");
                    n = if is_late(round, n, n_leaves) { n.div_ceil(2) } else { n };
                    round += 1;
                }
                assert_eq!(round, rounds(n_leaves, left), "{n_leaves} to {left}");
            }
        }
        assert_eq!((rounds(1, 1), rounds(2, 1), rounds(256, 256)), (0, 7, 0));
        assert!(!is_late(5, 1000, 1000) && is_late(6, 1000, 1000) && !is_late(6, 512, 1000));
    }
}
