//! Exact decisions against an oracle of another algorithm and against published answers.

use ccd::io::{Queries, Query, read_queries};
use ccd_core::narrow_phase::exact::{self, Exact};
use ccd_testkit::data::{self, SCENES};
use ccd_testkit::grazing::random::Random;
use ccd_testkit::sturm;
use std::time::Instant;

/// The same contact: both enclosures have a time in common, or there is none.
#[track_caller]
fn same(found: Option<Exact>, want: Option<[f64; 2]>, what: &dyn Fn() -> String) {
    match (found, want) {
        (Some(Exact::Miss), None) => (),
        (Some(Exact::Contact([lo, hi])), Some([least, most])) => {
            assert!(
                lo <= most && least <= hi,
                "{lo:e} {hi:e}, right {least:e} {most:e}: {}",
                what()
            );
            assert!(lo.next_up().next_up() >= hi, "{lo:e} {hi:e}: {}", what());
        }
        other => panic!("{other:?}: {}", what()),
    }
}

fn n_queries() -> usize {
    std::env::var("CCD_EXACT").map_or(1500, |n| n.parse().expect("a number of queries"))
}

/// Coordinates on a small lattice, so that most queries are degenerate in some way.
#[test]
fn queries_on_a_lattice() {
    let mut random = Random::new(11);
    let mut contacts = [0; 3];
    for i in 0..n_queries() {
        let n = [2, 3, 4, 9][i % 4];
        let flat = i % 3 == 0;
        let mut four = || {
            [(); 4].map(|()| {
                let p = [(); 3].map(|()| random.below(n) as f64);
                if flat { [p[0], p[1], 0.0] } else { p }
            })
        };
        let (t0, t1) = (four(), four());
        let what = || format!("query {i}: {t0:?} {t1:?}");
        let window = [[0.0, 1.0], [0.25, 0.75], [0.5, 0.5]][i / 7 % 3];
        let want = sturm::vertex_face(&t0, &t1, window);
        contacts[0] += want.is_some() as usize;
        let whole = window == [0.0, 1.0];
        let check = |found: Option<Exact>, want| {
            if whole {
                same(found, want, &what);
            } else {
                assert_eq!(found != Some(Exact::Miss), want.is_some(), "{} {window:?}", what());
            }
        };
        check(exact::vertex_face(&t0, &t1, window), want);
        let want = sturm::edge_edge(&t0, &t1, window);
        contacts[1] += want.is_some() as usize;
        check(exact::edge_edge(&t0, &t1, window), want);
        let three = |x: &[[f64; 3]; 4]| [x[0], x[1], x[2]];
        let want = sturm::vertex_edge(&three(&t0), &three(&t1), window);
        contacts[2] += want.is_some() as usize;
        check(exact::vertex_edge(&three(&t0), &three(&t1), window), want);
    }
    println!("contacts: {contacts:?}");
    assert!(contacts.iter().all(|&n| n > n_queries() / 50), "{contacts:?}");
}

/// Published queries and all published pairs of the scenes, with the enclosures of their times.
#[test]
fn published_answers() {
    let Ok(data) = data::data_dir() else { return };
    let mut slowest = 0.0f64;
    let mut timed = |f: &dyn Fn() -> Option<Exact>| {
        let start = Instant::now();
        let found = f();
        slowest = slowest.max(start.elapsed().as_secs_f64());
        found
    };
    let (mut n, mut n_contacts) = (0, 0);
    let start = Instant::now();
    for (path, name) in data::query_files(&data) {
        let Queries { queries, .. } = read_queries(&path).unwrap();
        let times = data::read_times(&data.join("toi").join(&name));
        for (i, (query, time)) in queries.iter().zip(&times).enumerate() {
            let found = timed(&|| match query {
                Query::VertexFace(q) => exact::vertex_face(&q.t0, &q.t1, [0.0, 1.0]),
                Query::EdgeEdge(q) => exact::edge_edge(&q.t0, &q.t1, [0.0, 1.0]),
            });
            let want = time.hit.then(|| [time.toi.expect("a time"); 2]);
            let around = want.map(|[a, b]| [a.next_down(), b.next_up()]);
            same(found, around, &|| format!("{name} {i}: {query:?}"));
            n += 1;
            n_contacts += time.hit as usize;
        }
    }
    println!("{n} queries, {n_contacts} contacts, {:.2} s", start.elapsed().as_secs_f64());
    for scene in SCENES.iter().filter(|scene| scene.truth.is_some()) {
        let start = Instant::now();
        let [f0, f1] = scene.load(&data);
        let mesh = f0.mesh().unwrap();
        let (mut n, mut n_contacts) = (0, 0);
        for kind in ["vf", "ee"] {
            for pair in scene.contacts(&data, kind) {
                let (a, b) = (pair.a as usize, pair.b as usize);
                let ids: [u32; 4] = if kind == "vf" {
                    let [x, y, z] = mesh.faces()[b];
                    [pair.a, x, y, z]
                } else {
                    let ([w, x], [y, z]) = (mesh.edges()[a], mesh.edges()[b]);
                    [w, x, y, z]
                };
                let at = |x: &[[f64; 3]]| ids.map(|i| x[i as usize]);
                let (t0, t1) = (at(&f0.positions), at(&f1.positions));
                let found = timed(&|| match kind {
                    "vf" => exact::vertex_face(&t0, &t1, [0.0, 1.0]),
                    _ => exact::edge_edge(&t0, &t1, [0.0, 1.0]),
                });
                let want = pair.hit.then(|| pair.toi.expect("a time"));
                let around = want.map(|t| [t.next_down(), t.next_up()]);
                same(found, around, &|| format!("{} {kind} {a} {b}", scene.name));
                n += 1;
                n_contacts += pair.hit as usize;
            }
        }
        let (name, seconds) = (scene.name, start.elapsed().as_secs_f64());
        println!("{name}: {n} pairs, {n_contacts} contacts, {seconds:.2} s");
    }
    println!("the slowest query took {:.3} ms", slowest * 1e3);
}
