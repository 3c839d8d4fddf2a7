//! Every pair against every pair: what faster ways must equal.

use ccd::{Aabb, Contact, EdgeEdge, Kind, Mesh, Pair, Real, VertexFace};

/// Pairs of boxes of one set that overlap, sorted.
pub fn self_pairs<T: Real>(boxes: &[Aabb<T>]) -> Vec<Pair> {
    let mut out = Vec::new();
    for a in 0..boxes.len() {
        for b in a + 1..boxes.len() {
            if boxes[a].overlaps(&boxes[b]) {
                out.push(Pair { a: a as u32, b: b as u32 });
            }
        }
    }
    out
}

/// Pairs of a box of `a` with a box of `b` that overlap, sorted.
pub fn pairs<T: Real>(a: &[Aabb<T>], b: &[Aabb<T>]) -> Vec<Pair> {
    let mut out = Vec::new();
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            if x.overlaps(y) {
                out.push(Pair { a: i as u32, b: j as u32 });
            }
        }
    }
    out
}

/// Swept boxes of vertices, edges and faces in the precision of the input.
pub fn swept_boxes<T: Real>(mesh: &Mesh, x0: &[[T; 3]], x1: &[[T; 3]]) -> [Vec<Aabb<T>>; 3] {
    let v: Vec<Aabb<T>> =
        x0.iter().zip(x1).map(|(&p, &q)| Aabb::of_point(p).union(&Aabb::of_point(q))).collect();
    let join =
        |ids: &[u32]| ids.iter().fold(v[ids[0] as usize], |all, &i| all.union(&v[i as usize]));
    let edges = mesh.edges().iter().map(|e| join(e)).collect();
    let faces = mesh.faces().iter().map(|f| join(f)).collect();
    [v, edges, faces]
}

/// Candidates of a mesh step without shared vertices: vertex-face, edge-edge, sorted.
pub fn candidates<T: Real>(mesh: &Mesh, x0: &[[T; 3]], x1: &[[T; 3]]) -> [Vec<Pair>; 2] {
    candidates_among(mesh, &swept_boxes(mesh, x0, x1))
}

/// The same, of boxes of vertices, edges and faces.
pub fn candidates_among<T: Real>(mesh: &Mesh, [v, e, f]: &[Vec<Aabb<T>>; 3]) -> [Vec<Pair>; 2] {
    let (edges, faces) = (mesh.edges(), mesh.faces());
    let mut vf = pairs(v, f);
    vf.retain(|p| !faces[p.b as usize].contains(&p.a));
    let mut ee = self_pairs(e);
    ee.retain(|p| edges[p.a as usize].iter().all(|i| !edges[p.b as usize].contains(i)));
    [vf, ee]
}

/// Every contact of a step without shared vertices, each pair of features asked by itself; in the
/// order of a report.
pub fn contacts(mesh: &Mesh, x0: &[[f64; 3]], x1: &[[f64; 3]]) -> Vec<Contact> {
    let [vf, ee] = candidates(mesh, x0, x1);
    let take = |ids: [u32; 4], x: &[[f64; 3]]| ids.map(|i| x[i as usize]);
    let vertex_face = vf.into_iter().filter_map(|pair| {
        let [a, b, c] = mesh.faces()[pair.b as usize];
        let ids = [pair.a, a, b, c];
        let verdict = ccd::vertex_face(&VertexFace { t0: take(ids, x0), t1: take(ids, x1) }, 0.0);
        Contact::of(Kind::VertexFace, pair, verdict)
    });
    let edge_edge = ee.into_iter().filter_map(|pair| {
        let ([a, b], [c, d]) = (mesh.edges()[pair.a as usize], mesh.edges()[pair.b as usize]);
        let ids = [a, b, c, d];
        let verdict = ccd::edge_edge(&EdgeEdge { t0: take(ids, x0), t1: take(ids, x1) }, 0.0);
        Contact::of(Kind::EdgeEdge, pair, verdict)
    });
    vertex_face.chain(edge_edge).collect()
}
