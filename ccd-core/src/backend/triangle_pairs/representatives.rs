//! Representative triangles: of all triangles that have a vertex or an edge, the first tests it
//! [Curtis 2008].
//!
//! Changed: the first triangle instead of a choice that evens out their number, because all tests
//! of a pair of triangles are made at once; and features without a face have triangles too.

use crate::layout::Triangle;
use crate::model::incidence::Incidence;
use crate::model::mesh::Mesh;
use alloc::vec::Vec;

/// No edge: a side that joins a vertex with itself.
pub const NO_EDGE: u32 = u32::MAX;

/// Triangles that together have every feature of a mesh: its faces by their ids, then a triangle
/// `a b b` for every edge that no face has, then `v v v` for every vertex in nothing else.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Triangles {
    n_faces: usize,
    corners: Vec<[u32; 3]>,
    sides: Vec<[u32; 3]>,
    represented: Vec<u8>,
    of_vertex: Incidence,
    of_edge: Incidence,
}

impl Triangles {
    /// The triangles of a mesh.
    pub fn new(mesh: &Mesh) -> Self {
        let edges = mesh.edges();
        let mut corners = mesh.faces().to_vec();
        let mut covered = Covered::new(mesh);
        covered.add(&corners, edges);
        let loose = |(e, ends): (usize, &[u32; 2])| (!covered.edges[e]).then_some(*ends);
        let loose: Vec<[u32; 2]> = edges.iter().enumerate().filter_map(loose).collect();
        corners.extend(loose.iter().map(|&[a, b]| [a, b, b]));
        covered.add(&corners[mesh.faces().len()..], edges);
        let lonely = (0..mesh.n_vertices()).filter(|&v| !covered.vertices[v]);
        corners.extend(lonely.map(|v| [v as u32; 3]));

        let sides: Vec<[u32; 3]> = corners.iter().map(|c| sides_of(c, edges)).collect();
        let of_vertex = Incidence::new(mesh.n_vertices(), || each_once(&corners));
        let of_edge = Incidence::new(edges.len(), || each_once(&sides));
        let represented = (0..corners.len())
            .map(|t| {
                let first = |lists: &Incidence, ids: &[u32; 3], k: usize| {
                    let repeated = ids[..k].contains(&ids[k]);
                    ids[k] != NO_EDGE && !repeated && lists.of(ids[k])[0] == t as u32
                };
                (0..3).fold(0, |bits, k| {
                    bits | (first(&of_vertex, &corners[t], k) as u8) << k
                        | (first(&of_edge, &sides[t], k) as u8) << (k + 3)
                })
            })
            .collect();
        Self { n_faces: mesh.faces().len(), corners, sides, represented, of_vertex, of_edge }
    }

    /// Number of triangles.
    pub fn len(&self) -> usize {
        self.corners.len()
    }

    /// Whether the mesh has no vertex.
    pub fn is_empty(&self) -> bool {
        self.corners.is_empty()
    }

    /// Whether it is a face: only faces are tested as such.
    pub fn is_face(&self, t: u32) -> bool {
        (t as usize) < self.n_faces
    }

    /// Its vertices.
    pub fn corners(&self, t: u32) -> [u32; 3] {
        self.corners[t as usize]
    }

    /// The vertices of all.
    pub fn all_corners(&self) -> &[[u32; 3]] {
        &self.corners
    }

    /// Its edges, from corner 0 to 1, 1 to 2, 2 to 0; [`NO_EDGE`] from a vertex to itself.
    pub fn sides(&self, t: u32) -> [u32; 3] {
        self.sides[t as usize]
    }

    /// Bits 0 to 2: whether it represents that corner; bits 3 to 5: that side.
    pub fn represents(&self, t: u32) -> u8 {
        self.represented[t as usize]
    }

    /// The same bits of what it has: of equal corners and sides the first.
    pub fn has(&self, t: u32) -> u8 {
        let (corners, sides) = (self.corners(t), self.sides(t));
        (0..3).fold(0, |bits, k| {
            let corner = !corners[..k].contains(&corners[k]);
            let side = sides[k] != NO_EDGE && !sides[..k].contains(&sides[k]);
            bits | (corner as u8) << k | (side as u8) << (k + 3)
        })
    }

    /// The record of a triangle for a device; `body`: the word of its body.
    pub fn record(&self, t: u32, body: u32) -> Triangle {
        let (corners, sides) = (self.corners(t), self.sides(t));
        Triangle { corners, represents: self.represents(t) as u32, sides, body }
    }

    /// The triangles of a vertex, ascending: the first represents it.
    pub fn of_vertex(&self, v: u32) -> &[u32] {
        self.of_vertex.of(v)
    }

    /// The triangles of an edge, ascending: the first represents it.
    pub fn of_edge(&self, e: u32) -> &[u32] {
        self.of_edge.of(e)
    }

    /// Whether two triangles have a vertex in common.
    pub fn adjacent(&self, s: u32, t: u32) -> bool {
        let other = self.corners(t);
        self.corners(s).iter().any(|v| other.contains(v))
    }

    /// Which corner of `t` is vertex `v`: the first if several are.
    pub fn corner_of(&self, t: u32, v: u32) -> usize {
        self.corners(t).iter().position(|&c| c == v).unwrap_or(0)
    }

    /// Which side of `t` is edge `e`: the first if several are.
    pub fn side_of(&self, t: u32, e: u32) -> usize {
        self.sides(t).iter().position(|&s| s == e).unwrap_or(0)
    }
}

/// The edges along the sides of a triangle.
fn sides_of(&[a, b, c]: &[u32; 3], edges: &[[u32; 2]]) -> [u32; 3] {
    [[a, b], [b, c], [c, a]].map(|[p, q]| {
        let (low, high) = (p.min(q), p.max(q));
        edges.binary_search_by_key(&(high, low), |&[a, b]| (b, a)).map_or(NO_EDGE, |e| e as u32)
    })
}

/// Which features have a triangle.
struct Covered {
    vertices: Vec<bool>,
    edges: Vec<bool>,
}

impl Covered {
    fn new(mesh: &Mesh) -> Self {
        let none = |n| alloc::vec![false; n];
        Self { vertices: none(mesh.n_vertices()), edges: none(mesh.edges().len()) }
    }

    fn add(&mut self, triangles: &[[u32; 3]], edges: &[[u32; 2]]) {
        for corners in triangles {
            corners.iter().for_each(|&v| self.vertices[v as usize] = true);
            let sides = sides_of(corners, edges);
            sides.iter().filter(|&&e| e != NO_EDGE).for_each(|&e| self.edges[e as usize] = true);
        }
    }
}

/// Features with the triangles that have them, ascending, each once; from those of every triangle.
fn each_once(triangles: &[[u32; 3]]) -> impl Iterator<Item = (u32, u32)> {
    (0..).zip(triangles).flat_map(|(t, ids)| {
        let first = |k: &usize| ids[*k] != NO_EDGE && !ids[..*k].contains(&ids[*k]);
        (0..3).filter(first).map(move |k| (ids[k], t))
    })
}
