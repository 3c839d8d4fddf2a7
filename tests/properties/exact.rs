//! Exact decisions against an oracle of another algorithm, on coordinates so few that most queries
//! are degenerate: coplanar, collinear, at rest, touching at an end or a corner.

use ccd::exact::{self, Exact};
use ccd::{EdgeEdge, VertexEdge, VertexFace, VertexVertex};
use ccd_testkit::grazing::random::Random;
use ccd_testkit::{compare, sturm};

/// Another number of queries than by default.
const QUERIES: &str = "CCD_EXACT";

/// Both enclosures have a time in common, or there is no contact.
#[track_caller]
fn same(found: Option<Exact>, want: Option<[f64; 2]>, what: &dyn Fn() -> String) {
    match (found, want) {
        (Some(Exact::Miss), None) => (),
        (Some(Exact::Contact([lo, hi])), Some([least, most])) => {
            let right = lo <= most && least <= hi && hi <= lo.next_up().next_up();
            assert!(right, "{lo:e} to {hi:e}, right is {least:e} to {most:e}: {}", what());
        }
        other => panic!("{other:?}: {}", what()),
    }
}

#[test]
fn queries_on_a_lattice() {
    let n_queries = std::env::var(QUERIES).map_or(200, |n| n.parse().expect("a number"));
    let mut random = Random::new(11);
    let mut contacts = [0; 4];
    for i in 0..n_queries {
        let n = [2, 3, 4, 9][i % 4];
        let mut four = || {
            [(); 4].map(|()| {
                let p = [(); 3].map(|()| random.below(n) as f64);
                if i % 3 == 0 { [p[0], p[1], 0.0] } else { p }
            })
        };
        let (t0, t1) = (four(), four());
        let window = [[0.0, 1.0], [0.25, 0.75], [0.5, 0.5], [0.1, 0.9]][i / 7 % 4];
        let what = || format!("query {i}, {window:?}: {t0:?} {t1:?}");
        let three = |x: &[[f64; 3]; 4]| [x[0], x[1], x[2]];
        let ([a0, a1], [b0, b1]) = ([three(&t0), three(&t1)], [t0, t1].map(|x| [x[0], x[1]]));
        let rods = |x: [[f64; 3]; 2]| [x[0], x[1], x[1]];
        let answers = [
            (
                exact::vertex_face(&VertexFace { t0, t1 }, window),
                sturm::vertex_face(&t0, &t1, window),
            ),
            (exact::edge_edge(&EdgeEdge { t0, t1 }, window), sturm::edge_edge(&t0, &t1, window)),
            (
                exact::vertex_edge(&VertexEdge { t0: a0, t1: a1 }, window),
                sturm::vertex_edge(&a0, &a1, window),
            ),
            (
                exact::vertex_vertex(&VertexVertex { t0: b0, t1: b1 }, window),
                sturm::vertex_edge(&rods(b0), &rods(b1), window),
            ),
        ];
        for (k, (found, want)) in answers.into_iter().enumerate() {
            contacts[k] += want.is_some() as usize;
            same(found, want, &what);
        }
    }
    assert!(contacts.iter().all(|&n| n > n_queries / 50), "{contacts:?}");
}

#[test]
fn the_comparison_can_fail() {
    let contact = |lo, hi| Some(Exact::Contact([lo, hi]));
    same(contact(0.5, 0.5), Some([0.5, 0.5]), &String::new);
    let wrong = [
        (None, None),
        (Some(Exact::Miss), Some([0.5, 0.5])),
        (contact(0.5, 0.5), None),
        (contact(0.5, 0.5), Some([0.5f64.next_up(); 2])),
        (contact(0.5, 0.5f64.next_up().next_up().next_up()), Some([0.5, 0.5])),
    ];
    for (found, want) in wrong {
        assert!(compare::fails(|| same(found, want, &String::new)), "{found:?} {want:?}");
    }
}

#[test]
fn what_cannot_be_decided_is_none() {
    let face = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    let query = |x: f64, y: f64| VertexFace {
        t0: [[x, y, 0.25], face[0], face[1], face[2]],
        t1: [[x, -y, 0.25], face[0], face[1], face[2]],
    };
    let whole = [0.0, 1.0];
    for x in [f64::NAN, f64::INFINITY] {
        assert_eq!(exact::vertex_face(&query(x, 1.0), whole), None);
    }
    // From the highest bit of any number to the lowest.
    let (most, least) = (1.7e308, 5e-324);
    let t0 = [[most; 3], [least; 3], [-most, 1e308, least], [least, -most, 1e308]];
    let mut t1 = t0;
    t1[0] = [-most; 3];
    assert_eq!(exact::vertex_face(&VertexFace { t0, t1 }, whole), None);
    for window in [[-0.1, 1.0], [0.5, 0.4], [0.0, 1.1], [f64::NAN, 1.0]] {
        assert_eq!(exact::vertex_face(&query(0.25, 1.0), window), None);
    }
    // Beside the edge, by the least number.
    let contact = exact::vertex_face(&query(least, 1.0), whole);
    assert_eq!(contact, Some(Exact::Contact([0.5; 2])));
    assert_eq!(exact::vertex_face(&query(-least, 1.0), whole), Some(Exact::Miss));
}
