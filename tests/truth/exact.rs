//! Exact decisions against published answers: every contact, every near miss, and when.

use ccd::exact::{self, Exact};
use ccd::io::{Queries, Query, read_queries};
use ccd::{Contact, EdgeEdge, Kind, Mode, Options, State, TOI_TOLERANCE, VertexFace};
use ccd_testkit::data::{self, Scene};
use std::collections::BTreeMap;
use std::path::Path;
use std::time::{Duration, Instant};

/// Every published pair, decided exactly: near misses are none.
pub fn check_contacts(data: &Path, scene: &Scene) {
    let [t0, t1] = scene.load(data);
    let mesh = t0.mesh().unwrap();
    for kind in ["vf", "ee"] {
        for pair in scene.contacts(data, kind) {
            let (a, b) = (pair.a as usize, pair.b as usize);
            let at =
                |ids: [u32; 4]| [&t0, &t1].map(|frame| ids.map(|i| frame.positions[i as usize]));
            let query = if kind == "vf" {
                let [x, y, z] = mesh.faces()[b];
                let [t0, t1] = at([pair.a, x, y, z]);
                Query::VertexFace(VertexFace { t0, t1 })
            } else {
                let ([w, x], [y, z]) = (mesh.edges()[a], mesh.edges()[b]);
                let [t0, t1] = at([w, x, y, z]);
                Query::EdgeEdge(EdgeEdge { t0, t1 })
            };
            let toi = if pair.hit { pair.toi } else { None };
            check_exact(&query, pair.hit, toi, &format!("{} {kind} {a} {b}", scene.name));
        }
    }
}

/// A whole step in exact mode: nothing is undecided, and what conservative steps are certain of is
/// so; where answers are published, the contacts are those and no others.
pub fn check_step(data: &Path, scene: &Scene) {
    let [t0, t1] = scene.load(data);
    let step = |mode: Mode| {
        let options = Options::default().with_threads(2).with_mode(mode);
        ccd::step(&t0.mesh().unwrap(), &t0.positions, &t1.positions, &options).unwrap()
    };
    let report = step(Mode::Exact);
    assert_eq!(report.undecided, 0);
    let key = |c: &Contact| (c.kind, c.a, c.b);
    let found: BTreeMap<_, f64> = report.contacts.iter().map(|c| (key(c), c.toi)).collect();
    for contact in &step(Mode::Conservative).contacts {
        let (early, exact) = (contact.toi, found.get(&key(contact)));
        match contact.state {
            State::Hit => {
                let exact = *exact.unwrap_or_else(|| panic!("{contact:?} is missing"));
                assert!(early <= exact && exact <= early + TOI_TOLERANCE, "{contact:?}, {exact:e}");
            }
            State::Undecided => {
                assert!(exact.is_none_or(|&exact| early <= exact), "{contact:?}, {exact:?}");
            }
        }
    }
    if scene.truth.is_some() {
        let mut n = 0;
        for (kind, name) in [(Kind::VertexFace, "vf"), (Kind::EdgeEdge, "ee")] {
            for pair in scene.contacts(data, name).iter().filter(|pair| pair.hit) {
                let (want, toi) = (pair.toi.expect("a time"), found.get(&(kind, pair.a, pair.b)));
                let fine = |t: f64| t <= want.next_up() && want <= t.next_up();
                assert!(
                    toi.is_some_and(|&t| fine(t)),
                    "{name} {} {} {toi:?} {want:e}",
                    pair.a,
                    pair.b
                );
                n += 1;
            }
        }
        assert_eq!(n, found.len(), "contacts that are none");
    }
    println!("{}: {} exact contacts", scene.name, found.len());
}

/// Every published query, decided exactly, and none takes long.
pub fn check_queries(data: &Path) {
    let (mut n, mut worst) = (0, Duration::ZERO);
    for (path, name) in data::query_files(data) {
        let Queries { queries, .. } = read_queries(&path).unwrap();
        let times = data::read_times(&data.join("toi").join(&name));
        for (i, (query, time)) in queries.iter().zip(&times).enumerate() {
            check_exact(query, time.hit, time.toi, &format!("{name} query {i}"));
            // The least of a few, because something else may have its turn in between.
            let took = (0..5).map(|_| took(query)).min().unwrap_or_default();
            worst = worst.max(took);
            n += 1;
        }
    }
    println!("{n} exact queries, of which the longest took {worst:?}");
    assert_eq!(n, 7279);
    assert!(cfg!(debug_assertions) || worst <= Duration::from_millis(1), "{worst:?}");
}

fn took(query: &Query) -> Duration {
    let start = Instant::now();
    std::hint::black_box(decide(std::hint::black_box(query)));
    start.elapsed()
}

fn decide(query: &Query) -> Option<Exact> {
    match query {
        Query::VertexFace(q) => exact::vertex_face(q, [0.0, 1.0]),
        Query::EdgeEdge(q) => exact::edge_edge(q, [0.0, 1.0]),
    }
}

/// The published time is the lower end of an enclosure of two neighbouring numbers.
fn check_exact(query: &Query, hit: bool, toi: Option<f64>, what: &str) {
    let found = decide(query);
    let want = if hit { Some(toi.expect("a time")) } else { None };
    match (found, want) {
        (Some(Exact::Miss), None) => (),
        (Some(Exact::Contact([lo, hi])), Some(toi)) => {
            assert!(lo <= toi.next_up() && toi.next_down() <= hi, "{what}: {lo:e} {hi:e} {toi:e}");
            assert!(hi <= lo.next_up().next_up(), "{what}: {lo:e} {hi:e}");
        }
        other => panic!("{what}: {other:?}"),
    }
}
