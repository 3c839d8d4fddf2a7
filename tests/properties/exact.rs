//! Exact decisions against an oracle of another algorithm, on coordinates so few that most queries
//! are degenerate: coplanar, collinear, at rest, touching at an end or a corner.

use ccd::VertexFace;
use ccd::exact::{self, Exact};
use ccd_core::narrow_phase::relative_motion::Patch;
use ccd_testkit::degenerate::{FAMILIES, KINDS, Outcome, Query};
use ccd_testkit::grazing::exact::{Contact, contact};
use ccd_testkit::grazing::random::Random;
use ccd_testkit::grazing::tangential::{self, query};
use ccd_testkit::sturm;

/// A few of each family and kind; `cargo xtask attack --kind exact` takes as many as it is told.
#[test]
fn degenerate_queries() {
    let mut random = Random::new(11);
    let mut contacts = [0; FAMILIES.len()];
    for i in 0..20 * FAMILIES.len() * KINDS.len() {
        let (family, kind) = (i % FAMILIES.len(), i / FAMILIES.len() % KINDS.len());
        let outcome = Query::new(family, kind, &mut random).judged();
        contacts[family] += (outcome.unwrap() != Outcome::Miss) as usize;
    }
    assert!(contacts.iter().all(|&n| n > 60), "{contacts:?}");
}

/// Contacts in integers, by which queries in floating point are judged, against Sturm chains: of
/// points anywhere, then of features that nearly graze.
#[test]
fn integers_and_sturm_chains_agree() {
    let mut random = Random::new(5);
    let mut seen = [0; 2];
    for i in 0..80 {
        let is_anywhere = i < 40;
        let tangential::Query { patch, t0, t1 } = if is_anywhere {
            let mut points = || std::array::from_fn(|_| random.vector());
            let (t0, t1) = (points(), points());
            let patch = [Patch::Triangle, Patch::Parallelogram][i % 2];
            tangential::Query { patch, t0, t1 }
        } else {
            query::<f64>(&mut random)
        };
        let ask = match patch {
            Patch::Triangle => sturm::vertex_face,
            Patch::Parallelogram => sturm::edge_edge,
        };
        match (contact(patch, &t0, &t1), ask(&t0, &t1, [0.0, 1.0]).first()) {
            (Contact::At([lo, hi], first), Some([from, until])) => {
                let right = from <= hi && (until >= lo || !first);
                assert!(right, "[{lo}, {hi}], [{from}, {until}]: {patch:?} {t0:?} {t1:?}");
                seen[0] += 1;
            }
            (Contact::Free, None) => seen[1] += 1,
            (Contact::Degenerate, _) if !is_anywhere => {}
            (got, want) => panic!("{got:?} {want:?}: {patch:?} {t0:?} {t1:?}"),
        }
    }
    assert!(seen[0] > 10 && seen[1] > 10, "{seen:?}");
}

/// The first of two crossings, near each other: `8 t^2 - 2 t + 1/16 = 0`, by a face that turns.
#[test]
fn the_first_of_two_crossings_is_found() {
    let (z, n) = (0.765625, 4.0);
    let at = |t: f64| {
        let face = [[0.0; 3], [n, 0.0, 3.0 - 4.0 * t], [0.0, n, 0.0]];
        [[1.0 + 2.0 * t, 1.0, z], face[0], face[1], face[2]]
    };
    let query = VertexFace { t0: at(0.0), t1: at(1.0) };
    let times = [(2.0 - 2f64.sqrt()) / 16.0, (2.0 + 2f64.sqrt()) / 16.0];
    let after = (times[0] + times[1]) / 2.0;
    for (window, time) in [([0.0, 1.0], times[0]), ([after, 1.0], times[1])] {
        let Some(Exact::Contact([lo, hi])) = exact::vertex_face(&query, window) else { panic!() };
        assert!((lo - time).abs() < 1e-15, "{lo:e}, right is {time:e}");
        sturm::vertex_face(&query.t0, &query.t1, window).check(Some([lo, hi])).unwrap();
    }
    assert_eq!(sturm::vertex_face(&query.t0, &query.t1, [0.0, 1.0]).count(), 2);
    assert_eq!(exact::vertex_face(&query, [0.0625, 0.125]), Some(Exact::Miss));
}

/// Of Tight-Inclusion's first report: a vertex near a face, for which inclusion alone said 0.
#[test]
fn the_first_report_of_tight_inclusion_is_decided() {
    let t0 = [
        [3.5000000000e-01, 0.0000000000e+00, 3.5000000000e-01],
        [3.4604643638e-01, 2.7847887896e-03, 3.4658121160e-01],
        [3.5000819263e-01, -1.5763377304e-06, 3.5001214242e-01],
        [3.4903882032e-01, -1.5866575093e-03, 3.4560164356e-01],
    ];
    let by = [
        [0.0000000000e+00, 0.0000000000e+00, 0.0000000000e+00],
        [1.0120300789e-07, -1.4009994248e-04, -8.5653091896e-05],
        [-9.2976239634e-07, 1.4361165221e-06, 5.5168830145e-07],
        [1.1649271683e-04, -3.6172565398e-05, -4.7128237917e-05],
    ];
    let t1 = std::array::from_fn(|i| std::array::from_fn(|k| t0[i][k] + by[i][k]));
    let query = VertexFace { t0, t1 };
    let found = match exact::vertex_face(&query, [0.0, 1.0]) {
        Some(Exact::Contact(times)) => Some(times),
        Some(Exact::Miss) => None,
        None => panic!("not decided"),
    };
    sturm::vertex_face(&t0, &t1, [0.0, 1.0]).check(found).unwrap();
    assert!(found.is_none_or(|[lo, _]| lo > 0.0), "{found:?}");
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
    for window in [[-0.1, 1.0], [0.5, 0.4], [0.0, 1.1], [f64::NAN, 1.0]] {
        assert_eq!(exact::vertex_face(&query(0.25, 1.0), window), None);
    }
}

/// From the highest bit of any number to the lowest: integers of 25,000 bits.
#[test]
fn numbers_as_far_apart_as_they_can_be_are_decided() {
    let (most, least, whole) = (f64::MAX, f64::from_bits(1), [0.0, 1.0]);
    let t0 = [[most; 3], [least; 3], [-most, 1e308, least], [least, -most, 1e308]];
    let mut t1 = t0;
    t1[0] = [-most; 3];
    let judged = |family, t0, t1| {
        let kind = KINDS.len() - 1;
        Query { family, kind, moved: false, t0, t1, window: whole }.judged().unwrap()
    };
    assert_eq!(judged(0, t0, t1), Outcome::Contact);
    // Any exponents, and what shrinks to a point but for one coordinate.
    let mut random = Random::new(13);
    let mut contacts = 0;
    for i in 0..12 {
        let mut any = || random.sign() * random.power(-300.0, 300.0);
        let mut points = || [(); 4].map(|()| [(); 3].map(|()| any()));
        let (t0, mut t1) = (points(), points());
        if i % 4 < 2 {
            t1 = t0.map(|p| p.map(|x| -x));
            t1[0][0] *= 0.75;
        }
        contacts += (judged(i % 2, t0, t1) != Outcome::Miss) as usize;
    }
    assert!(contacts > 2, "{contacts}");
    // Beside the edge, by the least number.
    let face = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    let query = |x: f64, y: f64| VertexFace {
        t0: [[x, y, 0.25], face[0], face[1], face[2]],
        t1: [[x, -y, 0.25], face[0], face[1], face[2]],
    };
    let contact = exact::vertex_face(&query(least, 1.0), whole);
    assert_eq!(contact, Some(Exact::Contact([0.5; 2])));
    assert_eq!(exact::vertex_face(&query(-least, 1.0), whole), Some(Exact::Miss));
}
