//! Orphans of meshes for which they are known, and of random ones against the definition.

use super::*;
use crate::model::contact::Kind;
use crate::random::Random;
use std::collections::BTreeMap;
use std::println;

fn sets(mesh: &Mesh) -> OrphanSets {
    OrphanSets::new(mesh, &Triangles::new(mesh)).expect("few enough comparisons")
}

/// Orphans by their vertices: vertex and face, two edges.
type Named = (Vec<(u32, [u32; 3])>, Vec<[[u32; 2]; 2]>);

/// Orphans by vertices: a vertex and the corners of a face, the ends of two edges.
fn named(mesh: &Mesh, sets: &OrphanSets) -> Named {
    let vf = sets.vf().iter().map(|p| (p.a, mesh.faces()[p.b as usize])).collect();
    let mut ee: Vec<_> =
        sets.ee().iter().map(|p| [p.a, p.b].map(|e| mesh.edges()[e as usize])).collect();
    ee.iter_mut().for_each(|pair: &mut [[u32; 2]; 2]| pair.sort_unstable());
    ee.sort_unstable();
    (vf, ee)
}

/// A strip of `n` triangles: triangle `i` is `i`, `i + 1`, `i + 2`.
fn strip(n: u32) -> Mesh {
    let faces: Vec<[u32; 3]> = (0..n).map(|i| [i, i + 1, i + 2]).collect();
    Mesh::new(n as usize + 2, &faces).unwrap()
}

/// A torus of `n` by `n` squares of two triangles each, six at every vertex.
fn torus(n: u32) -> Vec<[u32; 3]> {
    let at = |i: u32, j: u32| i % n * n + j % n;
    let square = |k: u32| {
        let (i, j) = (k / n, k % n);
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)];
        [[a, b, d], [a, d, c]]
    };
    (0..n * n).flat_map(square).collect()
}

/// Figure 2.9: a boundary. Triangles of a strip are neighbours if their numbers differ by at most
/// two; the vertices and edges of the first and the last are in fewer triangles than others.
#[test]
fn boundaries_have_orphans() {
    let mesh = strip(9);
    let (vf, ee) = named(&mesh, &sets(&mesh));
    // (a) Vertices at either end.
    let want = [(0, [1, 2, 3]), (0, [2, 3, 4]), (1, [2, 3, 4])];
    let mirrored = want.map(|(v, face)| (10 - v, face.map(|w: u32| 10 - w)));
    let mut all: Vec<(u32, [u32; 3])> = want.into_iter().chain(mirrored).collect();
    all.iter_mut().for_each(|(_, face)| face.sort_unstable());
    all.sort_unstable();
    assert_eq!(vf, all);
    // (b) Edges along the boundary, each with the one across from it, and the two ends.
    let mut all: Vec<[[u32; 2]; 2]> = (0..8).map(|i| [[i, i + 2], [i + 1, i + 3]]).collect();
    all.extend([[[0, 1], [2, 3]], [[0, 1], [2, 4]], [[7, 8], [9, 10]], [[6, 8], [9, 10]]]);
    all.sort_unstable();
    assert_eq!(ee, all);
}

/// Figure 2.10: interior orphans.
#[test]
fn some_interior_vertices_are_orphans() {
    let none = Mesh::new(36, &torus(6)).unwrap();
    let (vf, ee) = named(&none, &sets(&none));
    assert!(vf.is_empty() && ee.is_empty(), "a closed regular mesh: {vf:?} {ee:?}");
    // (a) A fan around a vertex: a triangle of that mesh, cut into three.
    let mut faces = torus(6);
    let [a, b, c] = faces[20];
    faces[20] = [a, b, 36];
    faces.extend([[b, c, 36], [c, a, 36]]);
    let mesh = Mesh::new(37, &faces).unwrap();
    let (vf, ee) = named(&mesh, &sets(&mesh));
    let beside = |face: &[u32; 3]| [a, b, c].iter().filter(|v| face.contains(v)).count() == 2;
    assert_eq!(vf.len(), 3);
    assert!(vf.iter().all(|(v, face)| *v == 36 && beside(face)), "{vf:?}");
    assert_eq!(ee.len(), 3, "the spokes, each with the side across from it: {ee:?}");
    // (b) A tetrahedron: every vertex with the face across, every edge with the edge across.
    let mesh = Mesh::new(4, &[[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]).unwrap();
    let (vf, ee) = named(&mesh, &sets(&mesh));
    assert_eq!(vf, [(0, [1, 2, 3]), (1, [0, 2, 3]), (2, [0, 1, 3]), (3, [0, 1, 2])]);
    assert_eq!(ee, [[[0, 1], [2, 3]], [[0, 2], [1, 3]], [[0, 3], [1, 2]]]);
    // (c) A pyramid of four sides: all of its triangles have vertices in common.
    let faces = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1], [1, 2, 3], [1, 3, 4]];
    let mesh = Mesh::new(5, &faces).unwrap();
    let (vf, ee) = named(&mesh, &sets(&mesh));
    assert_eq!((vf.len(), ee.len()), (12, 12));
    assert!(vf.contains(&(0, [1, 2, 3])) && vf.contains(&(0, [1, 3, 4])), "the tip and its base");
}

/// Every pair of features is tested once: by its representatives, by a stand-in or as an orphan;
/// by definition it is an orphan if all triangles of one have a vertex of all those of the other.
fn check(mesh: &Mesh, what: &str) -> [usize; 3] {
    let triangles = Triangles::new(mesh);
    let Some(sets) = OrphanSets::new(mesh, &triangles) else { panic!("{what}: no sets") };
    let mut tests = BTreeMap::<(Kind, Pair), usize>::new();
    let mut stand_ins = 0;
    for s in 0..triangles.len() as u32 {
        for t in s + 1..triangles.len() as u32 {
            let more = sets.stand_ins(s).iter().find(|x| x.other == t).map_or(0, |x| x.tests);
            let back = sets.stand_ins(t).iter().find(|x| x.other == s).map_or(0, |x| x.tests);
            let swapped = Test::all(back).fold(0, |bits, test| bits | test.swapped().bit());
            assert_eq!(more, swapped, "{what}: stand-ins of {s} and {t} differ");
            if triangles.adjacent(s, t) {
                assert_eq!(more, 0, "{what}: adjacent triangles {s} {t} stand in");
                continue;
            }
            stand_ins += more.count_ones() as usize;
            let both = represented(&triangles, s, t);
            assert_eq!(both & more, 0, "{what}: {s} {t}");
            for test in Test::all(both | more) {
                *tests.entry(test.features(&triangles, s, t)).or_default() += 1;
            }
        }
    }
    let apart =
        |a: &[u32], b: &[u32]| a.iter().any(|&s| b.iter().any(|&t| !triangles.adjacent(s, t)));
    let mut orphans = 0;
    let mut see = |kind: Kind, pair: Pair, tested: bool| {
        let list = if kind == Kind::VertexFace { sets.vf() } else { sets.ee() };
        let n = list.iter().filter(|&&p| p == pair).count();
        assert_eq!(n, !tested as usize, "{what}: {kind:?} {pair:?} as an orphan");
        let by_pairs = tests.remove(&(kind, pair)).unwrap_or(0);
        assert_eq!(by_pairs, tested as usize, "{what}: {kind:?} {pair:?}");
        orphans += n;
    };
    for v in 0..mesh.n_vertices() as u32 {
        for (f, face) in mesh.faces().iter().enumerate() {
            if !face.contains(&v) {
                let pair = Pair { a: v, b: f as u32 };
                see(Kind::VertexFace, pair, apart(triangles.of_vertex(v), &[pair.b]));
            }
        }
    }
    for (e, ends) in mesh.edges().iter().enumerate() {
        for (g, others) in mesh.edges().iter().enumerate().skip(e + 1) {
            if !ends.iter().any(|v| others.contains(v)) {
                let pair = Pair { a: e as u32, b: g as u32 };
                let tested = apart(triangles.of_edge(pair.a), triangles.of_edge(pair.b));
                see(Kind::EdgeEdge, pair, tested);
            }
        }
    }
    assert!(tests.is_empty(), "{what}: no features, or with a common vertex: {tests:?}");
    [orphans, stand_ins, triangles.len()]
}

/// The tests that two triangles represent.
fn represented(triangles: &Triangles, s: u32, t: u32) -> u16 {
    let represents = |t: u32, k: usize| triangles.represents(t) >> k & 1 == 1;
    let mut bits = 0;
    for i in 0..3 {
        if represents(s, i) && triangles.is_face(t) {
            bits |= Test::corner(i).bit();
        }
        if represents(t, i) && triangles.is_face(s) {
            bits |= Test::corner(i).swapped().bit();
        }
        for j in (0..3).filter(|&j| represents(s, 3 + i) && represents(t, 3 + j)) {
            bits |= Test::sides(i, j).bit();
        }
    }
    bits
}

#[test]
fn every_pair_of_features_is_tested_once() {
    let mut random = Random::new(11);
    let mut below = |n: u32| random.below(n);
    let mut seen = [0; 2];
    // Random triangles, wires and vertices: from all in one another to far apart; corners repeat,
    // edges have many faces, faces are there twice.
    for round in 0..60 {
        let n = 4 + below(26);
        let n_faces = below(n) as usize;
        let mut faces: Vec<[u32; 3]> =
            (0..n_faces).map(|_| [below(n), below(n), below(n)]).collect();
        if n_faces > 0 && round % 3 == 0 {
            faces.push(faces[0]);
        }
        let wires: Vec<[u32; 2]> = (0..below(8)).map(|_| [below(n), below(n)]).collect();
        let mesh = Mesh::with_edges(n as usize, &faces, &wires).unwrap();
        let [orphans, stand_ins, _] = check(&mesh, &std::format!("{faces:?} {wires:?}"));
        seen = [seen[0] + orphans, seen[1] + stand_ins];
    }
    assert!(seen[0] > 500 && seen[1] > 500, "{seen:?} show nothing");
    let [_, stand_ins, n] = check(&Mesh::new(64, &torus(8)).unwrap(), "a torus");
    println!("a regular mesh: {} stand-ins a triangle", stand_ins as f64 / n as f64);
    check(&strip(12), "a strip");
}

/// A fan of many triangles has too many orphans to list.
#[test]
fn there_is_a_limit() {
    let fan = |n: u32| {
        let faces: Vec<[u32; 3]> = (1..=n).map(|i| [0, i, i % n + 1]).collect();
        Mesh::new(n as usize + 1, &faces).unwrap()
    };
    let small = fan(30);
    assert!(OrphanSets::new(&small, &Triangles::new(&small)).is_some());
    let large = fan(2000);
    assert_eq!(OrphanSets::new(&large, &Triangles::new(&large)), None);
}
