//! Features that belong to nothing of a higher dimension: vertices of no edge, edges of no face.
//!
//! Against anything else they are covered: a vertex against a face, which is closed, or an edge
//! against an edge, whose ends belong to it. Left are such vertices against such edges and against
//! each other.

use crate::backend::quantization::margin;
use crate::backend::rules::Rules;
use crate::layout::Pair;
use crate::math::aabb::Aabb;
use crate::math::real::Real;
use crate::model::contact::Kind;
use crate::model::mesh::Mesh;
use alloc::vec;
use alloc::vec::Vec;

/// The kinds of pairs of such features, in the order of their contacts.
pub const KINDS: [Kind; 2] = [Kind::VertexEdge, Kind::VertexVertex];

/// The features of a mesh that belong to nothing of a higher dimension, by id.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Codimensional {
    /// Vertices of no edge.
    pub vertices: Vec<u32>,
    /// Edges of no face.
    pub edges: Vec<u32>,
}

impl Codimensional {
    /// Those of `mesh`; no edges if there are no such vertices.
    pub fn of(mesh: &Mesh) -> Self {
        if mesh.isolated_vertices().is_empty() {
            // Every pair has such a vertex.
            return Self::default();
        }
        Self { vertices: mesh.isolated_vertices().to_vec(), edges: edges_of_no_face(mesh) }
    }

    /// Whether there can be no pair of them.
    pub fn is_empty(&self) -> bool {
        self.vertices.is_empty() || self.vertices.len() == 1 && self.edges.is_empty()
    }

    /// Swept boxes, grown by half the minimum distance, of vertex or edge `i` of this list.
    pub fn vertex_box<T: Real>(&self, i: usize, x: [&[[T; 3]]; 2], min_distance: f64) -> Aabb<f64> {
        swept(x, &[self.vertices[i]], min_distance)
    }

    /// The same of an edge.
    pub fn edge_box<T: Real>(
        &self,
        i: usize,
        mesh: &Mesh,
        x: [&[[T; 3]]; 2],
        min_distance: f64,
    ) -> Aabb<f64> {
        swept(x, &mesh.edges()[self.edges[i] as usize], min_distance)
    }

    /// Fills `out` with the candidates of a kind: pairs of features by id, sorted, from those pairs
    /// of numbers in these lists whose boxes overlap; without those that `rules` exclude.
    pub fn candidates(
        &self,
        kind: Kind,
        overlaps: impl Iterator<Item = Pair>,
        (mesh, rules): (&Mesh, Option<&Rules>),
        out: &mut Vec<Pair>,
    ) {
        let second = if kind == Kind::VertexEdge { &self.edges } else { &self.vertices };
        let ids = |at: Pair| Pair { a: self.vertices[at.a as usize], b: second[at.b as usize] };
        out.clear();
        out.extend(overlaps.map(ids).filter(|&pair| {
            let [v, w, ..] = mesh.vertices_of(kind, pair);
            rules.is_none_or(|rules| rules.wants(v, w) && !rules.excludes(kind, pair.a, pair.b))
        }));
        out.sort_unstable_by_key(|pair| (pair.a, pair.b));
    }
}

/// The edges that no face has, ascending.
pub fn edges_of_no_face(mesh: &Mesh) -> Vec<u32> {
    // Edges are sorted by their greater vertex, then by the lesser.
    let mut begin = vec![0; mesh.n_vertices() + 1];
    mesh.edges().iter().for_each(|&[_, b]| begin[b as usize + 1] += 1);
    (0..mesh.n_vertices()).for_each(|v| begin[v + 1] += begin[v]);
    let mut has_face = vec![false; mesh.edges().len()];
    for &[a, b, c] in mesh.faces() {
        for [p, q] in [[a, b], [b, c], [c, a]] {
            let (lesser, greater) = (p.min(q), p.max(q) as usize);
            let of = begin[greater]..begin[greater + 1];
            if let Some(at) = mesh.edges()[of.clone()].iter().position(|&[a, _]| a == lesser) {
                has_face[of.start + at] = true;
            }
        }
    }
    (0..).zip(has_face).filter(|(_, has_face)| !has_face).map(|(e, _)| e).collect()
}

fn swept<T: Real>(x: [&[[T; 3]]; 2], ids: &[u32], min_distance: f64) -> Aabb<f64> {
    let ends = ids.iter().flat_map(|&v| x.map(|x| x[v as usize].map(Real::to_f64)));
    let boxes = ends.map(Aabb::of_point);
    let all = boxes.reduce(|all, one| all.union(&one));
    all.unwrap_or(Aabb { min: [0.0; 3], max: [0.0; 3] }).inflated(margin(min_distance))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::bodies::Bodies;

    #[test]
    fn what_belongs_to_nothing_higher_is_told() {
        // A triangle, a rod of two edges, a rod at a corner of the triangle, two particles.
        let mesh = Mesh::with_edges(9, &[[0, 1, 2]], &[[3, 4], [4, 5], [6, 2]]).unwrap();
        let found = Codimensional::of(&mesh);
        let edges: Vec<[u32; 2]> = found.edges.iter().map(|&e| mesh.edges()[e as usize]).collect();
        assert_eq!(found.vertices, [7, 8]);
        assert_eq!(edges, [[3, 4], [4, 5], [2, 6]]);
        assert!(!found.is_empty());
        assert!(Codimensional::of(&Mesh::new(4, &[[0, 1, 2]]).unwrap()).is_empty());
    }

    #[test]
    fn candidates_are_by_id_sorted_and_wanted() {
        // Three particles and two rods, each a body of its own.
        let mesh = Mesh::with_edges(7, &[], &[[1, 2], [3, 4]]).unwrap();
        let found = Codimensional::of(&mesh);
        assert_eq!((&found.vertices[..], &found.edges[..]), (&[0, 5, 6][..], &[0, 1][..]));
        let bodies = Bodies::new(&[0, 1, 1, 2, 2, 3, 4])
            .with_excluded_bodies(&[[1, 3]])
            .with_excluded_features(Kind::VertexVertex, &[[5, 6]]);
        let rules = Rules::new(&bodies).unwrap();
        let list = |kind, pairs: &[[u32; 2]], rules| {
            let mut out = vec![Pair { a: 9, b: 9 }];
            let pairs = pairs.iter().map(|&[a, b]| Pair { a, b });
            found.candidates(kind, pairs, (&mesh, rules), &mut out);
            out.iter().map(|pair| [pair.a, pair.b]).collect::<Vec<_>>()
        };
        let (ve, vv) = ([[1, 1], [1, 0], [0, 1]], [[1, 2], [0, 2]]);
        assert_eq!(list(Kind::VertexEdge, &ve, None), [[0, 1], [5, 0], [5, 1]]);
        assert_eq!(list(Kind::VertexVertex, &vv, None), [[0, 6], [5, 6]]);
        assert_eq!(list(Kind::VertexEdge, &ve, Some(&rules)), [[0, 1], [5, 1]]);
        assert_eq!(list(Kind::VertexVertex, &vv, Some(&rules)), [[0, 6]]);
    }
}
