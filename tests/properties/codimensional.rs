//! Particles and rods in a mesh, against every pair; and a mesh at one moment, against what the
//! queries say of a mesh that stands still.

use ccd::scenes::{crumpled_sheet, particles_and_rods, triangle_soup};
use ccd::{Bodies, Contact, Kind, Mesh, Options, Pair, Session, State};
use ccd_testkit::brute;
use ccd_testkit::compare::agree;

fn is_thin(c: &&Contact) -> bool {
    matches!(c.kind, Kind::VertexEdge | Kind::VertexVertex)
}

#[test]
fn particles_and_rods_are_found_as_by_every_pair() {
    for (seed, distance, threads) in [(1, 0.0, 1), (2, 0.01, 2), (3, 0.05, 0)] {
        let step = particles_and_rods(150, seed);
        let (candidates, want) = brute::codimensional(&step.mesh, &step.x0, &step.x1, distance);
        let options = Options::default().with_min_distance(distance).with_threads(threads);
        let mut session = Session::new(step.mesh.clone(), options).unwrap();
        for round in 0..2 {
            let report = session.step(&step.x0, &step.x1).unwrap().clone();
            let found: Vec<Contact> = report.contacts.iter().filter(is_thin).copied().collect();
            agree(&want, &found).unwrap_or_else(|e| panic!("{distance}, step {round}: {e}"));
            assert_eq!(found.len(), want.len(), "{distance}");
            let n = report.n_contacts();
            assert_eq!((n.ve + n.vv) as usize, found.len());
            assert!(n.ve > 100 && n.vv > 30, "{n:?}");
            // Through points that are exact, all of them are certain.
            let certain = found.iter().filter(|c| c.state == State::Hit).count();
            assert!(certain >= 150, "{certain}");
            let least = report.contacts.iter().map(|c| c.toi).reduce(f64::min);
            assert_eq!(report.toi, least);
            let earliest = session.earliest_toi(&step.x0, &step.x1).unwrap();
            assert_eq!(earliest, least);
            let listed = session.candidates(&step.x0, &step.x1).unwrap();
            // Margins are rounded up by a little.
            for (want, found) in candidates.iter().zip([listed.ve, listed.vv]) {
                assert!(want.iter().all(|pair| found.contains(pair)), "{distance}");
                assert!(found.len() <= want.len() + 1, "{distance}");
            }
        }
    }
}

#[test]
fn a_particle_on_a_rod_has_a_geometry() {
    // It falls onto a rod that lies along the first axis.
    let mesh = Mesh::with_edges(3, &[], &[[0, 1]]).unwrap();
    let x0 = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [1.0, 1.0, 0.0f32]];
    let mut x1 = x0;
    x1[2][1] = -1.0;
    let report = ccd::step(&mesh, &x0, &x1, &Options::default()).unwrap();
    let [contact] = report.contacts[..] else { panic!("{report:?}") };
    let key = (contact.kind, contact.state, contact.a, contact.b);
    assert_eq!(key, (Kind::VertexEdge, State::Hit, 2, 0));
    assert!(contact.toi <= 0.5 && contact.toi > 0.5 - 1e-6);
    assert_eq!(contact.vertices(&mesh), [2, 0, 1, 1]);
    let at = Contact::new(contact.kind, contact.state, 2, 0, 0.5).geometry(&mesh, &x0, &x1);
    assert_eq!((at.normal, at.weights), ([0.0, 1.0, 0.0], [1.0, 0.75, 0.25, 0.0]));
    // Of one body, or fixed, it is not looked at.
    let apart = Options::default().with_bodies(Bodies::new(&[0; 3]).with_self_contacts(false));
    assert!(ccd::step(&mesh, &x0, &x1, &apart).unwrap().contacts.is_empty());
    let d = mesh.distance(Kind::VertexEdge, Pair { a: 2, b: 0 }, &x0);
    assert!(d.least <= 1.0 && d.greatest >= 1.0 && d.greatest - d.least < 1e-13);
}

/// Every edge against every face, by signed volumes.
#[test]
fn intersections_are_those_of_every_pair() {
    let mut total = 0;
    for (seed, size) in [(1, 0.6), (2, 0.3)] {
        let step = triangle_soup(200, size, seed);
        let (mesh, x) = (&step.mesh, &step.x0);
        let found = ccd::intersections(mesh, x, &Options::default()).unwrap();
        let mut want = Vec::new();
        for (e, &edge) in mesh.edges().iter().enumerate() {
            for (f, &face) in mesh.faces().iter().enumerate() {
                if !edge.iter().any(|v| face.contains(v)) && goes_through(x, edge, face) {
                    want.push((e as u32, f as u32));
                }
            }
        }
        let keys: Vec<_> = found.iter().map(|i| (i.edge, i.face)).collect();
        assert_eq!(keys, want, "seed {seed}");
        assert!(ccd::has_intersections(mesh, x, &Options::default()).unwrap());
        assert!(found.iter().all(|i| i.state == State::Hit));
        total += found.len();
        // In another place of the same shape there are none of a body with itself.
        let body = vec![0; mesh.n_vertices()];
        let alone = Options::default().with_bodies(Bodies::new(&body).with_self_contacts(false));
        assert!(ccd::intersections(mesh, x, &alone).unwrap().is_empty());
        assert!(!ccd::has_intersections(mesh, x, &alone).unwrap());
        // A session that has found some goes on.
        let mut session = Session::new(mesh.clone(), Options::default()).unwrap();
        for _ in 0..2 {
            assert!(session.has_intersections(x).unwrap());
            assert_eq!(session.intersections(x).unwrap(), found);
        }
    }
    assert!(total > 200, "{total}");
    let far =
        [[0.0, 0.0, 0.0], [1e70, 0.0, 0.0], [0.0, 0.0, 1e70], [1.0, -1e70, 1.0], [1.0, 1e70, 1.0]];
    let mesh = Mesh::with_edges(5, &[[0, 1, 2]], &[[3, 4]]).unwrap();
    let found = ccd::intersections(&mesh, &far, &Options::default()).unwrap();
    assert_eq!(found.iter().map(|i| i.state).collect::<Vec<_>>(), [State::Undecided]);
    let nan = [[f64::NAN; 3]; 5];
    assert!(ccd::intersections(&mesh, &nan, &Options::default()).is_err());
}

/// By signed volumes in `f64`, which random positions do not bring near zero.
fn goes_through(x: &[[f64; 3]], [p, q]: [u32; 2], [a, b, c]: [u32; 3]) -> bool {
    let volume = |i: u32, j: u32, k: u32, l: u32| {
        let d =
            |v: u32| -> [f64; 3] { std::array::from_fn(|n| x[v as usize][n] - x[l as usize][n]) };
        let ([a, b, c], [d, e, f], [g, h, i]) = (d(i), d(j), d(k));
        let value = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
        assert!(value.abs() > 1e-12, "too near to tell");
        value > 0.0
    };
    let around = [volume(p, q, a, b), volume(p, q, b, c), volume(p, q, c, a)];
    volume(a, b, c, p) != volume(a, b, c, q) && around.iter().all(|&side| side == around[0])
}

/// Edges that cross at a distance of 24, whose ends are further, and so nearly parallel that
/// rounded numbers take them for that: they are near from 24 on, and not from half of it.
#[test]
fn edges_that_are_nearly_parallel_are_as_near_as_they_are() {
    // Vectors of length 3 at right angles.
    let at = |[a, b, c]: [f64; 3]| -> [f64; 3] {
        let axes = [[1.0, 2.0, 2.0], [2.0, 1.0, -2.0], [2.0, -2.0, 1.0]];
        std::array::from_fn(|k| a * axes[0][k] + b * axes[1][k] + c * axes[2][k])
    };
    let far = 2f64.powi(27);
    let x = [[-far, 0.0, 0.0], [far, 0.0, 0.0], [-far, -5.0, 8.0], [far, 5.0, 8.0]].map(at);
    let mesh = Mesh::with_edges(4, &[], &[[0, 1], [2, 3]]).unwrap();
    let d = mesh.distance(Kind::EdgeEdge, Pair { a: 0, b: 1 }, &x);
    assert!(d.least <= 24.0 && d.greatest >= 24.0 && d.greatest - d.least < 24e-6, "{d:?}");
    for (distance, want) in [(14.0, 0), (23.99, 0), (24.0, 1), (25.0, 1)] {
        let near = ccd::near_at_rest(&mesh, &x, distance).unwrap();
        assert_eq!((near.vf.len(), near.ee.len()), (0, want), "{distance}");
    }
}

/// What is near at rest is what every pair says, between its bounds; and a session that leaves it
/// out has the contacts that are left. Also of rods, and where particles are in contact with them,
/// which stay.
#[test]
fn what_is_near_at_rest_is_left_out() {
    let (sheet, thin) = (crumpled_sheet(9, 3), particles_and_rods(60, 3));
    for (step, distance, least) in [
        (&sheet, 0.0, [0, 0]),
        (&sheet, 0.02, [8, 40]),
        (&sheet, 0.1, [8, 40]),
        (&thin, 0.0, [0, 0]),
        (&thin, 0.05, [8, 40]),
        (&thin, 0.1, [8, 40]),
    ] {
        let (mesh, x) = (&step.mesh, &step.x0);
        let near = ccd::near_at_rest(mesh, x, distance).unwrap();
        let (mut vf, mut ee, mut n_open) = (Vec::new(), Vec::new(), 0);
        let mut ask = |kind: Kind, a: u32, b: u32| {
            let d = mesh.distance(kind, Pair { a, b }, x);
            let ids = mesh.vertices_of(kind, Pair { a, b }).map(|v| x[v as usize]);
            let (p, q) = ids.split_at(kind.n_first());
            // Corners of both bound it from above, and what is between two bounds is found.
            let corners = p.iter().flat_map(|p| q.iter().map(move |q| length(*p, *q)));
            assert!(d.least <= corners.fold(f64::INFINITY, f64::min) * (1.0 + 1e-15));
            n_open += (d.least <= distance && d.greatest > distance) as usize;
            d.least <= distance
        };
        for (kind, Pair { a, b }) in brute::feature_pairs(mesh) {
            if ask(kind, a, b) {
                (if kind == Kind::VertexFace { &mut vf } else { &mut ee }).push([a, b]);
            }
        }
        assert!(near.vf == vf && near.ee == ee, "{distance}");
        let [n_vf, n_ee] = least;
        assert!(vf.len() >= n_vf && ee.len() >= n_ee, "{distance}: {} {}", vf.len(), ee.len());
        assert!(n_open < 9, "{n_open}");
        let options = Options::default().with_min_distance(distance);
        let all = ccd::step(mesh, x, &step.x1, &options).unwrap().contacts;
        let bodies = Bodies::new(&vec![0; mesh.n_vertices()]).with_exclusions(&near);
        let left = ccd::step(mesh, x, &step.x1, &options.with_bodies(bodies)).unwrap().contacts;
        let is_near = |c: &&Contact| match c.kind {
            Kind::VertexFace => near.vf.contains(&[c.a, c.b]),
            Kind::EdgeEdge => near.ee.contains(&[c.a, c.b]),
            _ => false,
        };
        let want: Vec<Contact> = all.iter().filter(|c| !is_near(c)).copied().collect();
        assert!(left == want && (distance == 0.0 || left.len() < all.len()), "{distance}");
        assert!(left.iter().all(|c| c.toi > 0.0 || is_thin(&c)), "{distance}");
        let n_thin = left.iter().filter(is_thin).count();
        assert!(n_thin > 30 || std::ptr::eq(step, &sheet), "{distance}: {n_thin}");
    }
}

fn length(p: [f64; 3], q: [f64; 3]) -> f64 {
    (0..3).map(|k| (p[k] - q[k]).powi(2)).sum::<f64>().sqrt()
}
