//! Steps in exact mode: every pair as a query of its own says it, and times to the last bit.

use ccd::exact::{self, Exact};
use ccd::scenes::{Random, Step, particles_and_rods, triangle_soup};
use ccd::{
    Contact, EdgeEdge, Error, Kind, Mesh, Mode, Options, Pair, Session, State, TOI_TOLERANCE,
    Verdict, VertexEdge, VertexFace, VertexVertex,
};
use ccd_testkit::brute::feature_pairs;

type Positions = Vec<[f64; 3]>;

const WINDOWS: [[f64; 2]; 4] = [[0.0, 1.0], [0.25, 0.75], [0.1, 0.9], [0.0, 0.0]];

fn exactly() -> Options {
    Options::default().with_mode(Mode::Exact).with_threads(1)
}

/// A step whose coordinates are so few that many features are coplanar, at rest, or in touch.
fn on_a_lattice(step: Step, n: u32) -> Step {
    let mut random = Random::new(n);
    let round = |x: &mut Positions, moves: &mut dyn FnMut() -> bool, from: &Positions| {
        for (p, q) in x.iter_mut().zip(from) {
            let stays = !moves();
            *p = p.map(|x| (x * n as f64).round() / 8.0);
            if stays {
                *p = *q;
            }
        }
    };
    let Step { mesh, mut x0, mut x1 } = step;
    let start = x0.clone();
    round(&mut x0, &mut || true, &start);
    let start = x0.clone();
    round(&mut x1, &mut || random.below(3) > 0, &start);
    Step { mesh, x0, x1 }
}

/// The contacts of all pairs of features by queries of their own.
fn by_queries(mesh: &Mesh, x0: &Positions, x1: &Positions, window: [f64; 2]) -> Vec<Contact> {
    let at =
        |x: &Positions, kind: Kind, pair: Pair| mesh.vertices_of(kind, pair).map(|v| x[v as usize]);
    let ask = |kind: Kind, pair: Pair| {
        let (t0, t1) = (at(x0, kind, pair), at(x1, kind, pair));
        let three = |x: [[f64; 3]; 4]| [x[0], x[1], x[2]];
        let answer = match kind {
            Kind::VertexFace => exact::vertex_face(&VertexFace { t0, t1 }, window),
            Kind::EdgeEdge => exact::edge_edge(&EdgeEdge { t0, t1 }, window),
            Kind::VertexEdge => {
                exact::vertex_edge(&VertexEdge { t0: three(t0), t1: three(t1) }, window)
            }
            Kind::VertexVertex => {
                let [t0, t1] = [t0, t1].map(|x| [x[0], x[1]]);
                exact::vertex_vertex(&VertexVertex { t0, t1 }, window)
            }
        };
        let Some(Exact::Contact([toi, _])) = answer else { return None };
        Some(Contact::new(kind, State::Hit, pair.a, pair.b, toi))
    };
    let mut all: Vec<Contact> =
        feature_pairs(mesh).into_iter().filter_map(|(kind, pair)| ask(kind, pair)).collect();
    let alone = mesh.isolated_vertices();
    let of_face = |[a, b]: &[u32; 2]| mesh.faces().iter().any(|f| f.contains(a) && f.contains(b));
    for (i, &a) in alone.iter().enumerate() {
        let edges = (0..).zip(mesh.edges()).filter(|(_, ends)| !of_face(ends));
        all.extend(edges.filter_map(|(b, _)| ask(Kind::VertexEdge, Pair { a, b })));
        all.extend(alone[i + 1..].iter().filter_map(|&b| ask(Kind::VertexVertex, Pair { a, b })));
    }
    all.sort_unstable_by_key(|c| (c.kind, c.a, c.b));
    all
}

/// Whether `f64` leaves the pair of a contact open.
fn is_open(mesh: &Mesh, x0: &Positions, x1: &Positions, contact: &Contact) -> bool {
    let [t0, t1] = [x0, x1].map(|x| contact.vertices(mesh).map(|v| x[v as usize]));
    let verdict = match contact.kind {
        Kind::VertexFace => ccd::vertex_face(&VertexFace { t0, t1 }, 0.0),
        Kind::EdgeEdge => ccd::edge_edge(&EdgeEdge { t0, t1 }, 0.0),
        _ => return false,
    };
    matches!(verdict, Verdict::Undecided { .. })
}

fn times(contacts: &[Contact]) -> Vec<(Kind, u32, u32, State, u64)> {
    contacts.iter().map(|c| (c.kind, c.a, c.b, c.state, c.toi.to_bits())).collect()
}

#[test]
fn steps_are_what_every_pair_says() {
    let scenes = [
        triangle_soup(100, 0.4, 3),
        on_a_lattice(triangle_soup(120, 0.4, 4), 16),
        on_a_lattice(particles_and_rods(40, 5), 8),
        on_a_lattice(triangle_soup(100, 0.6, 6), 12),
    ];
    let (mut n, mut n_open) = (0, 0);
    for Step { mesh, x0, x1 } in &scenes {
        let mut session = Session::new(mesh.clone(), exactly()).unwrap();
        for window in WINDOWS {
            let want = by_queries(mesh, x0, x1, window);
            let report = session.step_window(x0, x1, window).unwrap();
            assert_eq!(report.undecided, 0);
            assert_eq!(times(&report.contacts), times(&want), "{window:?}");
            n += want.len();
        }
        let want = by_queries(mesh, x0, x1, WINDOWS[0]).iter().map(|c| c.toi).reduce(f64::min);
        assert_eq!(session.earliest_toi(x0, x1).unwrap(), want);
        session.set_options(exactly().with_mode(Mode::Conservative)).unwrap();
        let conservative = session.step(x0, x1).unwrap();
        let want = by_queries(mesh, x0, x1, WINDOWS[0]);
        assert_eq!((conservative.undecided, conservative.contacts.len()), (0, want.len()));
        for (early, exact) in conservative.contacts.iter().zip(&want) {
            assert_eq!((early.kind, early.a, early.b), (exact.kind, exact.a, exact.b));
            let by = exact.toi - early.toi;
            assert!((0.0..=TOI_TOLERANCE).contains(&by), "{early:?} {exact:?}");
            n_open += is_open(mesh, x0, x1, exact) as usize;
        }
        session.set_options(exactly()).unwrap();
        assert_eq!(session.step(x0, x1).unwrap().undecided, 0);
    }
    assert!(n > 1000 && n_open > 100, "{n} contacts, {n_open} are open in `f64`");
}

#[test]
fn no_distance_is_exact() {
    let Step { mesh, .. } = triangle_soup(2, 0.4, 3);
    let refused = |error: Error| assert_eq!(error, Error::ExactDistance { value: 0.5 });
    refused(Session::new(mesh.clone(), exactly().with_min_distance(0.5)).unwrap_err());
    let mut session = Session::new(mesh, exactly()).unwrap();
    refused(session.set_min_distance(0.5).unwrap_err());
    refused(session.set_options(exactly().with_min_distance(0.5)).unwrap_err());
    session.set_options(Options::default().with_min_distance(0.5)).unwrap();
}
