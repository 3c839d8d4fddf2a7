//! Every pair against every pair: what faster ways must equal.

use ccd::{
    Aabb, Contact, EdgeEdge, Kind, Mesh, Options, Pair, Real, State, VertexEdge, VertexFace,
    VertexVertex,
};
use ccd_core::model::decision::Decider;

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

/// Every vertex with every face and every edge with every later one, without common vertices.
pub fn feature_pairs(mesh: &Mesh) -> Vec<(Kind, Pair)> {
    let (edges, faces, mut out) = (mesh.edges(), mesh.faces(), Vec::new());
    for a in 0..mesh.n_vertices() as u32 {
        let others = (0..).zip(faces).filter(|(_, face)| !face.contains(&a));
        out.extend(others.map(|(b, _)| (Kind::VertexFace, Pair { a, b })));
    }
    for (a, ends) in (0..).zip(edges) {
        let later = (0..).zip(edges).skip(a as usize + 1);
        let others = later.filter(|(_, other)| !ends.iter().any(|v| other.contains(v)));
        out.extend(others.map(|(b, _)| (Kind::EdgeEdge, Pair { a, b })));
    }
    out
}

/// Candidates and contacts of features that belong to nothing of a higher dimension, with a minimum
/// distance: vertex-edge, vertex-vertex, found by looking at every pair of a mesh.
pub fn codimensional(
    mesh: &Mesh,
    x0: &[[f64; 3]],
    x1: &[[f64; 3]],
    distance: f64,
) -> ([Vec<Pair>; 2], Vec<Contact>) {
    let sides = |f: &[u32; 3]| [[f[0], f[1]], [f[1], f[2]], [f[2], f[0]]];
    let is_side = |e: &[u32; 2]| {
        mesh.faces().iter().any(|f| sides(f).iter().any(|s| s == e || *s == [e[1], e[0]]))
    };
    let [boxes, ..] = swept_boxes(mesh, x0, x1);
    let overlap = |v: u32, others: &[u32]| {
        let all = others.iter().map(|&w| boxes[w as usize]).reduce(|a, b| a.union(&b));
        all.is_some_and(|b| {
            (0..3).all(|k| {
                let a = boxes[v as usize];
                a.min[k] <= b.max[k] + distance && b.min[k] <= a.max[k] + distance
            })
        })
    };
    let alone: Vec<u32> = (0..mesh.n_vertices() as u32)
        .filter(|v| mesh.edges().iter().all(|e| !e.contains(v)))
        .collect();
    let (mut ve, mut vv, mut contacts) = (Vec::new(), Vec::new(), Vec::new());
    let at = |v: u32| [x0, x1].map(|x| x[v as usize]);
    for &v in &alone {
        for (e, edge) in mesh.edges().iter().enumerate().filter(|(_, e)| !is_side(e)) {
            if overlap(v, edge) {
                ve.push(Pair { a: v, b: e as u32 });
                let [v, p, q] = [at(v), at(edge[0]), at(edge[1])];
                let query = VertexEdge { t0: [v[0], p[0], q[0]], t1: [v[1], p[1], q[1]] };
                let verdict = ccd::vertex_edge(&query, distance);
                contacts.extend(Contact::of(Kind::VertexEdge, ve[ve.len() - 1], verdict));
            }
        }
    }
    for (i, &v) in alone.iter().enumerate() {
        for &w in alone[i + 1..].iter().filter(|&&w| overlap(v, &[w])) {
            vv.push(Pair { a: v, b: w });
            let (v, w) = (at(v), at(w));
            let query = VertexVertex { t0: [v[0], w[0]], t1: [v[1], w[1]] };
            let verdict = ccd::vertex_vertex(&query, distance);
            contacts.extend(Contact::of(Kind::VertexVertex, vv[vv.len() - 1], verdict));
        }
    }
    ([ve, vv], contacts)
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

/// Contacts of every pair that the options want, each asked by itself, whether boxes overlap or
/// not; in the order of a report.
pub fn every_pair(
    mesh: &Mesh,
    x: [&[[f64; 3]]; 2],
    options: &Options,
    window: [f64; 2],
) -> Vec<Contact> {
    let decider = Decider::new(options, window);
    let (edges, faces) = (mesh.edges(), mesh.faces());
    let wants = |kind: Kind, a: u32, b: u32, v: u32, w: u32| {
        options.bodies.as_ref().is_none_or(|of| of.wants(v, w) && !of.excludes(kind, a, b))
    };
    let mut all = Vec::new();
    for (kind, pair) in feature_pairs(mesh) {
        let ids = mesh.vertices_of(kind, pair);
        if wants(kind, pair.a, pair.b, ids[0], ids[kind.n_first()]) {
            all.extend(decider.contact(mesh, kind, pair, x));
        }
    }
    let alone = mesh.isolated_vertices();
    let of_face = |[a, b]: &[u32; 2]| faces.iter().any(|f| f.contains(a) && f.contains(b));
    let mut thin = |kind: Kind, a: u32, b: u32, w: u32| {
        if wants(kind, a, b, a, w) {
            all.extend(decider.contact(mesh, kind, Pair { a, b }, x));
        }
    };
    for &v in alone {
        for (e, ends) in (0..).zip(edges).filter(|(_, ends)| !of_face(ends)) {
            thin(Kind::VertexEdge, v, e, ends[0]);
        }
    }
    for (i, &v) in alone.iter().enumerate() {
        alone[i + 1..].iter().for_each(|&w| thin(Kind::VertexVertex, v, w, w));
    }
    all.sort_unstable_by_key(|c| (c.kind, c.a, c.b));
    all
}

/// What is found is among what every pair says, the same to the last bit; and of that nothing is
/// missing but what is undecided and has boxes that are apart.
pub fn check_pairs(what: &str, want: &[Contact], found: &[Contact]) {
    let key = |c: &Contact| (c.kind, c.a, c.b);
    for c in found {
        let at =
            want.binary_search_by_key(&key(c), key).unwrap_or_else(|_| panic!("{what}: {c:?}"));
        assert_eq!(want[at], *c, "{what}");
    }
    for c in want.iter().filter(|c| c.state == State::Hit) {
        assert!(found.binary_search_by_key(&key(c), key).is_ok(), "{what}: missing {c:?}");
    }
}
