//! Pairs of features that a minimum distance must not see: near by topology, or near at rest.
//!
//! A mesh whose edges are shorter than the minimum distance is in contact with itself wherever it
//! is whole. Solvers leave such pairs out.

use super::incidence::Incidence;
use super::mesh::Mesh;
use crate::model::error::Error;
use alloc::vec;
use alloc::vec::Vec;
use core::convert::Infallible;

/// Bytes of a pair: in a list, and with its kind in the rules of bodies.
const PAIR: u64 = 20;

/// Pairs of features, by their ids in a mesh; sorted, each once.
///
/// ```
/// use ccd::Exclusions;
///
/// let some = Exclusions::new(vec![[4, 0]], vec![[2, 5], [1, 2]]);
/// let all = some.and(&Exclusions::new(vec![[4, 0], [3, 1]], vec![]));
/// assert_eq!(all.vf, [[3, 1], [4, 0]]);
/// assert_eq!(all.ee, [[1, 2], [2, 5]]);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Exclusions {
    /// Vertex, face.
    pub vf: Vec<[u32; 2]>,
    /// Two edges, the lesser id first.
    pub ee: Vec<[u32; 2]>,
}

impl Exclusions {
    /// From lists in any order.
    pub fn new(mut vf: Vec<[u32; 2]>, mut ee: Vec<[u32; 2]>) -> Self {
        for list in [&mut vf, &mut ee] {
            list.sort_unstable();
            list.dedup();
        }
        Self { vf, ee }
    }

    /// Pairs of which some vertex of one is at most `rings` edges away from some vertex of the
    /// other, without those that share one, which are no pairs anyway: of a regular triangle mesh
    /// some `6 rings^2` faces a vertex, and as many edges an edge, times three.
    ///
    /// ```
    /// use ccd::{Exclusions, Mesh};
    ///
    /// // A strip of three triangles.
    /// let mesh = Mesh::new(5, &[[0, 1, 2], [2, 1, 3], [2, 3, 4]])?;
    /// let near = Exclusions::of_neighbours(&mesh, 1);
    /// // Vertex 0 reaches 1 and 2, and so the faces of these.
    /// assert_eq!(near.vf[..2], [[0, 1], [0, 2]]);
    /// # Ok::<(), ccd::Error>(())
    /// ```
    pub fn of_neighbours(mesh: &Mesh, rings: u32) -> Self {
        let Ok(all) = Self::list_neighbours(mesh, rings, |_| Ok::<(), Infallible>(()));
        all
    }

    /// [`Exclusions::of_neighbours`] where that takes no more than so many bytes: many rings are
    /// all pairs of a mesh. Counted are the lists as they are made, in which some pairs stand
    /// several times, and the [`Bodies`](super::bodies::Bodies) that take them.
    ///
    /// # Errors
    /// [`Error::Memory`].
    ///
    /// ```
    /// use ccd::{Error, Exclusions, Mesh};
    ///
    /// let mesh = Mesh::new(5, &[[0, 1, 2], [2, 1, 3], [2, 3, 4]])?;
    /// let some = Exclusions::of_neighbours_within(&mesh, 9, 10_000)?;
    /// assert_eq!(some, Exclusions::of_neighbours(&mesh, 9));
    /// let none = Exclusions::of_neighbours_within(&mesh, 9, 100);
    /// assert!(matches!(none, Err(Error::Memory { limit: 100, .. })));
    /// # Ok::<(), ccd::Error>(())
    /// ```
    pub fn of_neighbours_within(mesh: &Mesh, rings: u32, max_bytes: u64) -> Result<Self, Error> {
        Self::list_neighbours(mesh, rings, |n| match n as u64 * PAIR {
            bytes if bytes > max_bytes => {
                let what = "pairs of neighbours";
                Err(Error::Memory { what, bytes, held: 0, limit: max_bytes })
            }
            _ => Ok(()),
        })
    }

    /// `check`: whether there may be so many pairs.
    fn list_neighbours<E>(
        mesh: &Mesh,
        rings: u32,
        check: impl Fn(usize) -> Result<(), E>,
    ) -> Result<Self, E> {
        if rings == 0 {
            return Ok(Self::default());
        }
        let n = mesh.n_vertices();
        let ends = |&[a, b]: &[u32; 2]| [(a, b), (b, a)];
        let neighbours = Incidence::new(n, || mesh.edges().iter().flat_map(ends));
        let faces = Incidence::of_vertices(n, mesh.faces());
        let edges = Incidence::of_vertices(n, mesh.edges());
        let (mut vf, mut ee) = (Vec::new(), Vec::new());
        let mut near = Near { distance: vec![u32::MAX; n], found: Vec::new() };
        for v in 0..n as u32 {
            near.search(v, rings, &neighbours);
            for &w in &near.found {
                let of_w = faces.of(w).iter();
                vf.extend(
                    of_w.filter(|&&f| !mesh.faces()[f as usize].contains(&v)).map(|&f| [v, f]),
                );
                for &a in edges.of(v) {
                    for &b in edges.of(w) {
                        let ([p, q], others) = (mesh.edges()[a as usize], mesh.edges()[b as usize]);
                        if a < b && !others.contains(&p) && !others.contains(&q) {
                            ee.push([a, b]);
                        }
                    }
                    check(vf.len() + ee.len())?;
                }
            }
        }
        Ok(Self::new(vf, ee))
    }

    /// Both together.
    pub fn and(mut self, other: &Self) -> Self {
        self.vf.extend_from_slice(&other.vf);
        self.ee.extend_from_slice(&other.ee);
        Self::new(self.vf, self.ee)
    }
}

/// Vertices within a distance of one, breadth first; buffers stay.
struct Near {
    distance: Vec<u32>,
    found: Vec<u32>,
}

impl Near {
    fn search(&mut self, from: u32, rings: u32, neighbours: &Incidence) {
        let Self { distance, found } = self;
        found.drain(..).for_each(|v| distance[v as usize] = u32::MAX);
        distance[from as usize] = 0;
        found.push(from);
        let mut next = 0;
        while next < found.len() {
            let v = found[next];
            next += 1;
            let beyond = distance[v as usize] + 1;
            if beyond > rings {
                break;
            }
            for &w in neighbours.of(v) {
                if distance[w as usize] == u32::MAX {
                    distance[w as usize] = beyond;
                    found.push(w);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against distances between all vertices: of a grid; of a fan around 0, a rod from it that
    /// branches, a loop of rods, and particles, which have no neighbours.
    #[test]
    fn neighbours_are_those_of_all_distances() {
        let square = |i: u32| i / 4 * 5 + i % 4;
        let grid = (0..16).map(square).flat_map(|v| [[v, v + 1, v + 5], [v + 5, v + 1, v + 6]]);
        check_neighbours(&Mesh::new(25, &grid.collect::<Vec<_>>()).unwrap(), 4);
        let fan = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [5, 6, 7]];
        let rods =
            [[4, 8], [8, 9], [9, 10], [9, 5], [12, 13], [13, 14], [14, 15], [15, 12], [16, 12]];
        let mesh = Mesh::with_edges(20, &fan, &rods).unwrap();
        assert_eq!(mesh.isolated_vertices(), [11, 17, 18, 19]);
        check_neighbours(&mesh, 6);
    }

    fn check_neighbours(mesh: &Mesh, most: u32) {
        let n = mesh.n_vertices();
        let mut d = vec![vec![99u32; n]; n];
        (0..n).for_each(|v| d[v][v] = 0);
        for &[a, b] in mesh.edges() {
            (d[a as usize][b as usize], d[b as usize][a as usize]) = (1, 1);
        }
        for k in 0..n {
            for i in 0..n {
                for j in 0..n {
                    d[i][j] = d[i][j].min(d[i][k] + d[k][j]);
                }
            }
        }
        let least = |a: &[u32], b: &[u32]| {
            let all = a.iter().flat_map(|&v| b.iter().map(move |&w| (v, w)));
            all.map(|(v, w)| d[v as usize][w as usize]).min().unwrap()
        };
        let mut counts = Vec::new();
        for rings in 0..most {
            let (mut vf, mut ee) = (Vec::new(), Vec::new());
            let is_near = |a: &[u32], b: &[u32]| (1..=rings).contains(&least(a, b));
            for v in 0..n as u32 {
                let faces = (0..).zip(mesh.faces());
                vf.extend(faces.filter(|(_, f)| is_near(&[v], *f)).map(|(f, _)| [v, f]));
            }
            for (i, a) in (0..).zip(mesh.edges()) {
                let others = (0..).zip(mesh.edges()).filter(|(j, b)| i < *j && is_near(a, *b));
                ee.extend(others.map(|(j, _)| [i, j]));
            }
            counts.push(vf.len() + ee.len());
            assert_eq!(Exclusions::of_neighbours(mesh, rings), Exclusions::new(vf, ee));
        }
        assert!(counts.is_sorted_by(|a, b| a < b), "{counts:?}");
    }
}
