//! Mesh topology: faces, and the undirected edges in a canonical order.

use crate::Real;
use crate::layout::Pair;
use crate::model::contact::Kind;
use crate::model::error::Error;
use crate::narrow_phase::distance::Distance;
use crate::narrow_phase::pair_verdict::{edge_edge_ids, vertex_face_ids};
use alloc::sync::Arc;
use alloc::vec::Vec;

/// The connectivity of a triangle mesh; it stays the same while vertices move.
///
/// Edges are undirected vertex pairs `[a, b]` with `a < b`, sorted by `b`, then by `a`: the order
/// of the upper triangle of an adjacency matrix column by column, which published collision data
/// uses. Their ids do not depend on the order of faces. A degenerate face (a vertex twice) is kept
/// and counted; its sides that join a vertex with itself are no edges.
///
/// A session takes a `Mesh`, a `&Mesh` (a copy), or an `Arc<Mesh>`, which many sessions can share.
/// Its `Debug` says how many vertices, edges and faces there are, not which.
///
/// ```
/// use ccd::Mesh;
///
/// let square = Mesh::new(4, &[[0, 1, 2], [2, 1, 3]])?;
/// assert_eq!(square.edges(), [[0, 1], [0, 2], [1, 2], [1, 3], [2, 3]]);
/// # Ok::<(), ccd::Error>(())
/// ```
#[derive(Clone, Default, PartialEq, Eq)]
pub struct Mesh {
    n_vertices: usize,
    faces: Vec<[u32; 3]>,
    edges: Vec<[u32; 2]>,
    isolated: Vec<u32>,
    n_degenerate: usize,
}

impl Mesh {
    pub(crate) const EMPTY: Self = Self {
        n_vertices: 0,
        faces: Vec::new(),
        edges: Vec::new(),
        isolated: Vec::new(),
        n_degenerate: 0,
    };

    /// A mesh of `n_vertices` vertices and these faces; edges are derived.
    ///
    /// # Errors
    /// [`Error::Index`] with the first face that names a vertex that is not there;
    /// [`Error::TooMany`].
    pub fn new(n_vertices: usize, faces: &[[u32; 3]]) -> Result<Self, Error> {
        Self::with_edges(n_vertices, faces, &[])
    }

    /// A mesh with edges that no face has (rods, wires) besides those of the faces. Repeated edges
    /// count once.
    ///
    /// # Errors
    /// [`Error::Index`] with the first face or edge that names a vertex that is not there;
    /// [`Error::TooMany`].
    pub fn with_edges(
        n_vertices: usize,
        faces: &[[u32; 3]],
        more_edges: &[[u32; 2]],
    ) -> Result<Self, Error> {
        limit("vertices", n_vertices)?;
        limit("faces", faces.len())?;
        limit("edges", faces.len().saturating_mul(3).saturating_add(more_edges.len()))?;
        let mut n_degenerate = 0;
        for (at, face) in faces.iter().enumerate() {
            for &vertex in face {
                check_index("face", at, vertex, n_vertices)?;
            }
            n_degenerate +=
                (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) as usize;
        }
        for (at, edge) in more_edges.iter().enumerate() {
            for &vertex in edge {
                check_index("edge", at, vertex, n_vertices)?;
            }
            n_degenerate += (edge[0] == edge[1]) as usize;
        }
        let sides = faces.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let all = sides.chain(more_edges.iter().copied()).filter(|[a, b]| a != b);
        let edges = each_once(n_vertices, all.map(|[a, b]| if a < b { [a, b] } else { [b, a] }));
        let mut has_edge = alloc::vec![false; n_vertices];
        edges.iter().flatten().for_each(|&v| has_edge[v as usize] = true);
        let alone = (0..).zip(has_edge).filter(|(_, has_edge)| !has_edge);
        let isolated = alone.map(|(v, _)| v).collect();
        Ok(Self { n_vertices, faces: faces.to_vec(), edges, isolated, n_degenerate })
    }

    /// Number of vertices, also those in no face.
    pub fn n_vertices(&self) -> usize {
        self.n_vertices
    }

    /// Faces as given.
    pub fn faces(&self) -> &[[u32; 3]] {
        &self.faces
    }

    /// Undirected edges `[a, b]`, `a < b`, sorted by `b`, then by `a`.
    pub fn edges(&self) -> &[[u32; 2]] {
        &self.edges
    }

    /// Vertices of no edge, in order: particles.
    pub fn isolated_vertices(&self) -> &[u32] {
        &self.isolated
    }

    /// The vertices of a pair of features: `v f0 f1 f2`, `ea0 ea1 eb0 eb1`, `v e0 e1 e1` or
    /// `v w w w`: a feature of few vertices has its last one repeated.
    #[inline]
    pub fn vertices_of(&self, kind: Kind, pair: Pair) -> [u32; 4] {
        match kind {
            Kind::VertexFace => vertex_face_ids(pair, &self.faces),
            Kind::EdgeEdge => edge_edge_ids(pair, &self.edges),
            Kind::VertexEdge => {
                let [e0, e1] = self.edges[pair.b as usize];
                [pair.a, e0, e1, e1]
            }
            Kind::VertexVertex => [pair.a, pair.b, pair.b, pair.b],
        }
    }

    /// How far a pair of features is from each other at positions `x`, between two bounds.
    ///
    /// # Panics
    /// If a position or a feature of these ids is missing.
    pub fn distance<T: Real>(&self, kind: Kind, pair: Pair, x: &[[T; 3]]) -> Distance {
        let at = self.vertices_of(kind, pair).map(|v| x[v as usize].map(Real::to_f64));
        match kind {
            Kind::VertexFace => Distance::vertex_face(at),
            Kind::EdgeEdge => Distance::edge_edge(at),
            Kind::VertexEdge => Distance::vertex_edge([at[0], at[1], at[2]]),
            Kind::VertexVertex => Distance::vertex_vertex([at[0], at[1]]),
        }
    }

    /// Checks that there is a position for every vertex at both ends of a step.
    ///
    /// # Errors
    /// [`Error::VertexCount`].
    pub fn check_positions<T>(&self, x0: &[[T; 3]], x1: &[[T; 3]]) -> Result<(), Error> {
        let expected = self.n_vertices;
        for (time, found) in [(0, x0.len()), (1, x1.len())] {
            if expected != found {
                return Err(Error::VertexCount { time, expected, found });
            }
        }
        Ok(())
    }

    /// Faces and given edges that name a vertex twice.
    pub fn n_degenerate(&self) -> usize {
        self.n_degenerate
    }
}

impl core::fmt::Debug for Mesh {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let mut numbers = f.debug_struct("Mesh");
        numbers.field("n_vertices", &self.n_vertices).field("n_edges", &self.edges.len());
        numbers.field("n_faces", &self.faces.len()).finish_non_exhaustive()
    }
}

/// A copy.
impl From<&Mesh> for Arc<Mesh> {
    fn from(mesh: &Mesh) -> Self {
        Arc::new(mesh.clone())
    }
}

fn limit(element: &'static str, count: usize) -> Result<(), Error> {
    let (count, limit) = (count as u64, Error::MAX_ELEMENTS);
    if count > limit { Err(Error::TooMany { element, count, limit }) } else { Ok(()) }
}

fn check_index(
    element: &'static str,
    at: usize,
    vertex: u32,
    n_vertices: usize,
) -> Result<(), Error> {
    if (vertex as usize) < n_vertices {
        Ok(())
    } else {
        Err(Error::Index { element, at, vertex, n_vertices })
    }
}

/// These edges `[a, b]`, `a < b`, sorted by `b`, then by `a`, each once: by counting for each `b`,
/// then a sort of its few `a`.
fn each_once(n_vertices: usize, all: impl Iterator<Item = [u32; 2]> + Clone) -> Vec<[u32; 2]> {
    let mut ends = alloc::vec![0; n_vertices];
    all.clone().for_each(|[_, b]| ends[b as usize] += 1);
    let mut n = 0u32;
    for end in &mut ends {
        // Where the list of a vertex begins; it is its end when all are in place.
        (*end, n) = (n, n + *end);
    }
    let mut lesser = alloc::vec![0; n as usize];
    for [a, b] in all {
        let end = &mut ends[b as usize];
        lesser[*end as usize] = a;
        *end += 1;
    }
    let mut edges = Vec::new();
    let mut start = 0;
    for (b, end) in (0..).zip(ends) {
        let list = &mut lesser[start..end as usize];
        list.sort_unstable();
        let distinct = list.chunk_by(|a, next| a == next);
        edges.extend(distinct.map(|same| [same[0], b]));
        start = end as usize;
    }
    edges.shrink_to_fit();
    edges
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    #[test]
    fn edges_are_sorted_and_unique() {
        let mesh = Mesh::new(5, &[[4, 2, 1], [1, 2, 0], [3, 3, 0]]).unwrap();
        assert_eq!(mesh.edges(), [[0, 1], [0, 2], [1, 2], [0, 3], [1, 4], [2, 4]]);
        assert_eq!(mesh.n_degenerate(), 1);
        assert_eq!(Mesh::new(0, &[]).unwrap().edges(), [[0u32; 2]; 0]);
    }

    #[test]
    fn edges_of_many_faces_are_those_of_a_sort() {
        let mut random = Random::new(3);
        for n in [3, 40, 5000] {
            let mut vertex = || (random.unit() * n as f64) as u32;
            let faces: Vec<[u32; 3]> = (0..3000).map(|_| [(); 3].map(|()| vertex())).collect();
            let more: Vec<[u32; 2]> = (0..100).map(|_| [(); 2].map(|()| vertex())).collect();
            let sides = faces.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
            let pairs = sides.chain(more.iter().copied()).filter(|[a, b]| a != b);
            let mut want: Vec<[u32; 2]> = pairs.map(|[a, b]| [a.max(b), a.min(b)]).collect();
            want.sort_unstable();
            want.dedup();
            let mesh = Mesh::with_edges(n, &faces, &more).unwrap();
            assert!(mesh.edges().iter().map(|&[a, b]| [b, a]).eq(want), "{n} vertices");
        }
    }

    #[test]
    fn bad_indices_and_counts_are_named() {
        let want = Error::Index { element: "face", at: 1, vertex: 7, n_vertices: 3 };
        assert_eq!(Mesh::new(3, &[[0, 1, 2], [0, 7, 2]]), Err(want));
        assert!(matches!(Mesh::new(1 << 31, &[]), Err(Error::TooMany { element: "vertices", .. })));
    }
}
