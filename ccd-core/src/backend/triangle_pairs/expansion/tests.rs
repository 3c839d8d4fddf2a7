//! What pairs of triangles are expanded to, and tests of neighbours, against all pairs of features.

extern crate std;

use super::*;
use crate::backend::rules::Rules;
use crate::backend::triangle_pairs::near_tests::NearTests;
use crate::backend::triangle_pairs::orphans::OrphanSets;
use crate::backend::triangle_pairs::representatives::Triangles;
use crate::broad_phase::swept_box;
use crate::layout::Triangle;
use crate::model::bodies::Bodies;
use crate::model::groups::Groups;
use crate::model::mesh::Mesh;
use crate::random::Random;
use std::collections::BTreeMap;
use std::vec::Vec;

/// A mesh with a box for each feature.
struct Scene {
    mesh: Mesh,
    bodies: Option<Bodies>,
    triangles: Triangles,
    records: Vec<Triangle>,
    regions: Vec<u32>,
    frame: Frame,
    boxes: Vec<Aabb<f32>>,
    swept: Vec<Aabb<f32>>,
}

/// Features by kind, 0 or 1, and how often a pair of them came.
type Found = BTreeMap<(u32, Pair), usize>;

impl Scene {
    fn new(
        mesh: Mesh,
        bodies: Option<Bodies>,
        vertices: &[Aabb<f32>],
        mut regions: Vec<u32>,
    ) -> Self {
        let triangles = Triangles::new(&mesh);
        let rules = bodies.as_ref().map(|bodies| Rules::new(bodies).expect("few classes"));
        let body = |t: u32| rules.as_ref().map_or(0, |of| of.word(triangles.corners(t)[0]));
        let all = 0..triangles.len() as u32;
        let records = all.clone().map(|t| triangles.record(t, body(t))).collect();
        let count = [mesh.n_vertices(), mesh.edges().len(), mesh.faces().len()].map(|n| n as u32);
        let [v, e, f] = count;
        let mut frame = Frame { count, start: [0, v, v + e, v + e + f], ..Frame::default() };
        if let Some(rules) = &rules {
            frame.flags |= Frame::FLAG_BODIES;
            frame.flags |= if rules.has_table() { Frame::FLAG_RULES } else { 0 };
            regions.resize(triangles.len(), u32::MAX);
            regions.extend(rules.table());
        }
        let mut boxes = vertices.to_vec();
        boxes.extend((0..e as usize).map(|i| swept_box::edge(i, mesh.edges(), vertices)));
        boxes.extend((0..f as usize).map(|i| swept_box::face(i, mesh.faces(), vertices)));
        let swept = all.map(|t| swept_box::triangle(triangles.corners(t), vertices)).collect();
        Self { mesh, bodies, triangles, records, regions, frame, boxes, swept }
    }

    fn wants(&self, of: Pair) -> bool {
        let [a, b] = [of.a, of.b].map(|t| self.triangles.corners(t)[0]);
        self.bodies.as_ref().is_none_or(|bodies| bodies.wants(a, b))
    }

    /// Everything that kernels do with all overlapping triangles, and their counts.
    fn expanded(&self, orphans: bool, flags: u32) -> (Found, [u32; N_COUNTS]) {
        let sets = orphans.then(|| OrphanSets::new(&self.mesh, &self.triangles)).flatten();
        let near_tests = sets.map(|sets| {
            NearTests::new(&sets, &self.triangles, |of| self.wants(of)).expect("few tests")
        });
        let orphans = if near_tests.is_some() { Expansion::FLAG_ORPHANS } else { 0 };
        let NearTests { tests, n_vf, orphans: of_list } = near_tests.unwrap_or_default();
        let rules = self.triangles.len() as u32;
        let args =
            Expansion { flags: flags | orphans, n_vf, orphans: of_list, capacity_ee: 0, rules };
        let (mut found, mut counts) = (Found::new(), [0; N_COUNTS]);
        let mut take = |one: Expanded| (0..N_COUNTS).for_each(|k| counts[k] += one.counts[k]);
        for b in 0..self.records.len() as u32 {
            for a in (0..b).filter(|&a| self.swept[a as usize].overlaps(&self.swept[b as usize])) {
                let (pair, records) = (Pair { a, b }, &self.records);
                let one = expand(pair, &self.frame, &args, records, &self.regions, &self.boxes);
                take(one);
                for test in (0..15).filter(|test| one.hits >> test & 1 == 1) {
                    let kind = (test >= N_VERTEX_FACE) as u32;
                    *found.entry((kind, features(test, pair, records))).or_default() += 1;
                }
            }
        }
        for (i, test) in (0..).zip(&tests) {
            let one = near(i, test, &self.frame, &args, &self.regions, &self.swept, &self.boxes);
            take(one);
            if one.hits == 1 {
                *found.entry(((i >= n_vf) as u32, test.pair)).or_default() += 1;
            }
        }
        (found, counts)
    }

    /// What is counted, by the definition: of all pairs, of those that share a vertex, and of the
    /// tests that the others represent and stand in for.
    fn counted(&self) -> [u32; 3] {
        let (triangles, mut out) = (&self.triangles, [0; 3]);
        let sets = OrphanSets::new(&self.mesh, triangles).expect("few neighbours");
        let n = triangles.len() as u32;
        for (s, t) in (0..n).flat_map(|t| (0..t).map(move |s| (s, t))) {
            let overlap = self.swept[s as usize].overlaps(&self.swept[t as usize]);
            if !overlap || !self.wants(Pair { a: s, b: t }) {
                continue;
            }
            out[0] += 1;
            if triangles.adjacent(s, t) {
                out[1] += 1;
                continue;
            }
            let represents = |t: u32, k: usize| triangles.represents(t) >> k & 1 == 1;
            for k in 0..3 {
                out[2] += (represents(s, k) && triangles.is_face(t)) as u32;
                out[2] += (represents(t, k) && triangles.is_face(s)) as u32;
                out[2] +=
                    (0..3).filter(|j| represents(s, 3 + k) && represents(t, 3 + j)).count() as u32;
            }
            let more = sets.stand_ins(s).iter().find(|stand_in| stand_in.other == t);
            out[2] += more.map_or(0, |stand_in| stand_in.tests.count_ones());
        }
        out
    }

    /// Every pair of features of wanted bodies without a common vertex whose boxes overlap.
    fn all(&self) -> Found {
        let (mesh, start) = (&self.mesh, self.frame.start);
        let hit = |a: u32, b: u32| self.boxes[a as usize].overlaps(&self.boxes[b as usize]);
        let wants = |v: u32, w: u32| self.bodies.as_ref().is_none_or(|bodies| bodies.wants(v, w));
        let mut out = Found::new();
        for v in 0..mesh.n_vertices() as u32 {
            for (f, face) in (0..).zip(mesh.faces()) {
                if !face.contains(&v) && wants(v, face[0]) && hit(v, start[2] + f) {
                    out.insert((0, Pair { a: v, b: f }), 1);
                }
            }
        }
        for (f, b) in (0..).zip(mesh.edges()) {
            for (e, a) in (0..f).zip(mesh.edges()) {
                let apart = !a.iter().any(|v| b.contains(v));
                if apart && wants(a[0], b[0]) && hit(start[1] + e, start[1] + f) {
                    out.insert((1, Pair { a: e, b: f }), 1);
                }
            }
        }
        out
    }
}

/// Random triangles, wires and vertices in one another, with random boxes.
fn random_scene(below: &mut impl FnMut(u32) -> u32, with_bodies: bool) -> Scene {
    let n = 6 + below(30);
    // Names of two bodies are far apart, so no element joins two.
    let half = n / 2;
    let mut point = |second: u32| if second == 1 { half + below(n - half) } else { below(half) };
    let mut faces: Vec<[u32; 3]> = (0..n).map(|i| core::array::from_fn(|_| point(i % 2))).collect();
    faces.push(faces[0]);
    let wires: Vec<[u32; 2]> = (0..6).map(|i| core::array::from_fn(|_| point(i % 2))).collect();
    let mesh = Mesh::with_edges(n as usize, &faces, &wires).unwrap();
    let of_vertex: Vec<u32> = (0..n).map(|v| (v >= half) as u32).collect();
    let groups = Groups { memberships: 1 + below(3), filter: 1 + below(3) };
    let fixed = [below(4) == 1];
    let mut rules = |bodies: Bodies| bodies.with_groups(below(2), groups);
    let bodies = with_bodies.then(|| rules(Bodies::new(&of_vertex, &fixed, true)));
    let bodies = bodies.map(|bodies| bodies.with_self_contact(1, !n.is_multiple_of(3)));
    let vertices: Vec<Aabb<f32>> = (0..n)
        .map(|_| {
            let min = [below(12), below(12), below(12)].map(|x| x as f32);
            Aabb { min, max: min.map(|x| x + below(3) as f32) }
        })
        .collect();
    let regions = (0..2 * n + 32).map(|_| if below(2) == 0 { u32::MAX } else { below(3) });
    Scene::new(mesh, bodies, &vertices, regions.collect())
}

#[test]
fn every_pair_of_features_comes_once() {
    let mut random = Random::new(5);
    let mut below = |n: u32| random.below(n);
    let (mut sums, mut n_lost) = ([0; N_COUNTS], 0);
    for round in 0..120 {
        let scene = random_scene(&mut below, round % 2 == 1);
        let want = scene.all();
        let (plain, before) = scene.expanded(false, 0);
        assert_eq!(plain, want, "round {round}");
        let (with_sets, counts) = scene.expanded(true, 0);
        assert_eq!(with_sets, want, "round {round}, with orphans");
        assert_eq!((before[1], before[2], before[4]), (0, 0, 0));
        assert_eq!((before[0], counts[2]), (counts[0], 0));
        assert_eq!([counts[0], counts[1], counts[3]], scene.counted(), "round {round}");
        // What is lost in regions is of triangles in one of them.
        let (rest, counts) = scene.expanded(false, Expansion::FLAG_REGIONS);
        for (&(kind, pair), _) in want.iter().filter(|(key, _)| !rest.contains_key(key)) {
            let of = |feature: u32| match kind {
                0 => [scene.triangles.of_vertex(pair.a)[0], pair.b][(feature != 0) as usize],
                _ => scene.triangles.of_edge([pair.a, pair.b][feature as usize])[0],
            };
            let [s, t] = [of(0), of(1)].map(|t| scene.regions[t as usize]);
            assert!(s == t && s != u32::MAX, "round {round}: {kind} {pair:?}");
            n_lost += 1;
        }
        assert!(rest.iter().all(|(key, n)| want.get(key) == Some(n)), "round {round}");
        let (_, all) = scene.expanded(true, Expansion::FLAG_REGIONS);
        (0..N_COUNTS).for_each(|k| sums[k] += all[k] + counts[k]);
    }
    assert!(sums.iter().all(|&n| n > 200) && n_lost > 200, "{sums:?} {n_lost} show nothing");
}
