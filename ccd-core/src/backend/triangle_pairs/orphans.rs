//! Orphan sets: the pairs of features that no pair of triangles without a common vertex tests
//! [Tang 2008], found once per mesh (Algorithms 2.2 and 2.3 of [da Silva 2013]).
//!
//! A vertex and a face are tested by any triangle of the vertex that has no vertex in common with
//! the face; two edges by any two of their triangles that have none in common. If there are no
//! such triangles, the pair is an orphan:
//!
//! ```text
//!   at a boundary                         inside, around a vertex of three triangles
//!   v---w---z    v is in vxy and vyw,              b
//!   | \ |  /     both have y in common            /|\     v, and every face outside that
//!   |  \| /      with wyz: v and wyz             / v \    has two of a b c: all triangles
//!   x---y        are an orphan                  a-----c   of v have one of the two
//! ```
//!
//! Changed: the sets of adjacent triangles are gathered around the representative only, because a
//! pair whose representatives have no vertex in common is tested by these. What is not an orphan
//! but has adjacent representatives gets a stand-in: the first pair of triangles that tests it.
//!
//! Cost: for a triangle with `k` neighbours some `k` to `4 k` comparisons of triangles, once per
//! mesh. A fan of `n` triangles has `n^2` orphans, so there is a limit, beyond which there are no
//! sets ([`OrphanSets::new`]) and neighbours must be tested like all others.

use super::Test;
use super::representatives::{NO_EDGE, Triangles};
use crate::layout::Pair;
use crate::model::mesh::Mesh;
use alloc::vec::Vec;

/// Comparisons of two triangles that orphan sets may take, for each triangle of the mesh: regular
/// meshes take about 100.
pub const MAX_COMPARISONS: usize = 1024;

/// The orphans of a mesh, and what stands in for representatives that are adjacent.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct OrphanSets {
    vf: Vec<Pair>,
    ee: Vec<Pair>,
    starts: Vec<u32>,
    stand_ins: Vec<StandIn>,
}

/// Tests that a pair of triangles makes besides those that it represents.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StandIn {
    /// The other triangle.
    pub other: u32,
    /// Bits of [`Test`]s, of the triangle as the first and the other as the second.
    pub tests: u16,
}

impl OrphanSets {
    /// The sets of a mesh and its triangles; `None` if they take more than [`MAX_COMPARISONS`] for
    /// each triangle.
    pub fn new(mesh: &Mesh, triangles: &Triangles) -> Option<Self> {
        let mut found = Found {
            mesh,
            triangles,
            left: MAX_COMPARISONS * triangles.len(),
            sets: Self::default(),
            tests: Vec::new(),
        };
        let mut near = Vec::new();
        for t in 0..triangles.len() as u32 {
            found.neighbours(t, &mut near)?;
            found.of_vertices(t, &near)?;
            found.of_edges(t, &near)?;
        }
        let Found { mut sets, mut tests, .. } = found;
        tests.sort_unstable();
        sets.starts = alloc::vec![0; triangles.len() + 1];
        let mut last = None;
        for (t, other, test) in tests {
            if last == Some((t, other)) {
                if let Some(stand_in) = sets.stand_ins.last_mut() {
                    stand_in.tests |= test.bit();
                }
            } else {
                sets.stand_ins.push(StandIn { other, tests: test.bit() });
                sets.starts[t as usize + 1] += 1;
                last = Some((t, other));
            }
        }
        for i in 0..triangles.len() {
            sets.starts[i + 1] += sets.starts[i];
        }
        sets.vf.sort_unstable();
        sets.ee.sort_unstable();
        Some(sets)
    }

    /// Orphans of a vertex and a face.
    pub fn vf(&self) -> &[Pair] {
        &self.vf
    }

    /// Orphans of two edges, the lesser id first.
    pub fn ee(&self) -> &[Pair] {
        &self.ee
    }

    /// The triangles with which `t` makes tests besides those that both represent; listed for both
    /// of a pair.
    #[inline]
    pub fn stand_ins(&self, t: u32) -> &[StandIn] {
        let i = t as usize;
        &self.stand_ins[self.starts[i] as usize..self.starts[i + 1] as usize]
    }
}

/// Sets in the making.
struct Found<'a> {
    mesh: &'a Mesh,
    triangles: &'a Triangles,
    left: usize,
    sets: OrphanSets,
    tests: Vec<(u32, u32, Test)>,
}

/// The two triangles that test a pair, or none: an orphan.
type Tested = Option<[u32; 2]>;

impl Found<'_> {
    /// Takes comparisons off what is left; `None` if there are too few.
    fn spend(&mut self, n: usize) -> Option<()> {
        self.left = self.left.checked_sub(n)?;
        Some(())
    }

    /// All triangles that have a vertex in common with `t`, and `t`.
    fn neighbours(&mut self, t: u32, near: &mut Vec<u32>) -> Option<()> {
        near.clear();
        for v in self.triangles.corners(t) {
            self.spend(self.triangles.of_vertex(v).len())?;
            near.extend_from_slice(self.triangles.of_vertex(v));
        }
        near.sort_unstable();
        near.dedup();
        Some(())
    }

    /// Algorithm 2.2 for all vertices that `t` represents.
    fn of_vertices(&mut self, t: u32, near: &[u32]) -> Option<()> {
        let triangles = self.triangles;
        for k in (0..3).filter(|k| triangles.represents(t) >> k & 1 == 1) {
            let v = triangles.corners(t)[k];
            let incident = triangles.of_vertex(v);
            for &face in near {
                if !triangles.is_face(face) || triangles.corners(face).contains(&v) {
                    continue;
                }
                match self.first_apart(incident, &[face])? {
                    None => self.sets.vf.push(Pair { a: v, b: face }),
                    Some(pair) => {
                        self.stand_in(pair, Test::corner(triangles.corner_of(pair[0], v)))
                    }
                }
            }
        }
        Some(())
    }

    /// Algorithm 2.3 for all edges that `t` represents, with those of greater ids.
    fn of_edges(&mut self, t: u32, near: &[u32]) -> Option<()> {
        let (triangles, edges) = (self.triangles, self.mesh.edges());
        for k in (0..3).filter(|k| triangles.represents(t) >> (k + 3) & 1 == 1) {
            let e = triangles.sides(t)[k];
            for &s in near {
                let sides = triangles.sides(s);
                for j in (0..3).filter(|j| triangles.represents(s) >> (j + 3) & 1 == 1) {
                    let other = sides[j];
                    let touch = edges[e as usize].iter().any(|v| edges[other as usize].contains(v));
                    if other == NO_EDGE || other <= e || touch {
                        continue;
                    }
                    match self.first_apart(triangles.of_edge(e), triangles.of_edge(other))? {
                        None => self.sets.ee.push(Pair { a: e, b: other }),
                        Some(pair) => {
                            let (i, j) =
                                (triangles.side_of(pair[0], e), triangles.side_of(pair[1], other));
                            self.stand_in(pair, Test::sides(i, j));
                        }
                    }
                }
            }
        }
        Some(())
    }

    /// The first two triangles, one of each list, without a common vertex.
    fn first_apart(&mut self, a: &[u32], b: &[u32]) -> Option<Tested> {
        for &s in a {
            for &t in b {
                self.spend(1)?;
                if !self.triangles.adjacent(s, t) {
                    return Some(Some([s, t]));
                }
            }
        }
        Some(None)
    }

    fn stand_in(&mut self, [s, t]: [u32; 2], test: Test) {
        self.tests.push((s, t, test));
        self.tests.push((t, s, test.swapped()));
    }
}
