//! Geometry of decided contacts, judged at the true time without rounding: weights, the side and
//! the direction of the normal, also of needles and of edges that are nearly parallel.

use ccd::exact::Exact;
use ccd::{Bodies, Contact, Kind, Mesh, Mode, Options, Session, State};
use ccd_testkit::compare;
use ccd_testkit::degenerate::{KINDS, Query};
use ccd_testkit::grazing::random::Random;
use ccd_testkit::sturm;

/// A vertex and a needle, or two edges, all along one direction but for a width of `2^-50` to 1.
fn thin(family: usize, r: &mut Random) -> [[[f64; 3]; 4]; 2] {
    let (width, direction) = (2f64.powi(-(r.below(51) as i32)), r.vector());
    [(); 2].map(|()| {
        let origin = r.vector();
        let mut along = |s: f64| {
            let off = r.vector();
            std::array::from_fn(|k| origin[k] + s * direction[k] + width * off[k])
        };
        match family {
            0 => [along(0.5), origin, along(0.3), along(1.0)],
            _ => [origin, along(1.0), along(-0.4), along(1.2)],
        }
    })
}

fn mesh(family: usize) -> Mesh {
    let mesh = match family {
        0 => Mesh::new(4, &[[1, 2, 3]]),
        _ => Mesh::with_edges(4, &[], &[[0, 1], [2, 3]]),
    };
    mesh.unwrap()
}

fn check(family: usize, t0: &[[f64; 3]; 4], t1: &[[f64; 3]; 4], toi: f64) -> bool {
    let kind = [Kind::VertexFace, Kind::EdgeEdge][family];
    let contact = Contact::new(kind, State::Hit, 0, family as u32, toi);
    let g = contact.geometry(&mesh(family), t0, t1);
    let judge = |weights, normal| sturm::meet(family == 1, [t0, t1], toi, weights, normal);
    let is_judged = judge(g.weights, g.normal)
        .unwrap_or_else(|what| panic!("{what}, {kind:?} at {toi:?}: {t0:?} {t1:?}"));
    if is_judged {
        // The opposite side, another direction, another weight.
        let [x, y, z] = g.normal;
        let mut weights = g.weights;
        weights[2] = if weights[2] < 0.5 { weights[2] + 1e-15 } else { weights[2] - 1e-15 };
        assert!(judge(g.weights, [-x, -y, -z]).is_err());
        let mut direction = g.normal;
        direction[if x.abs() < y.abs() { 0 } else { 1 }] += 1e-14;
        assert!(judge(g.weights, direction).is_err());
        assert!(judge(weights, g.normal).is_err());
        // Both points are the same but for rounding.
        let most = t0.iter().chain(t1).flatten().fold(0.0f64, |most, x| most.max(x.abs()));
        let near = |k: usize| (g.on_a[k] - g.on_b[k]).abs() <= 16.0 * f64::EPSILON * most;
        assert!((0..3).all(near) && g.distance == 0.0, "{g:?}");
    }
    is_judged
}

#[test]
fn weights_and_normals_are_those_of_the_true_time() {
    let mut random = Random::new(5);
    let (mut n_judged, mut n_thin) = (0, 0);
    for i in 0..800 {
        let (family, is_thin) = (i % 2, i % 3 > 0);
        let mut query = Query::new(family, i / 2 % KINDS.len(), &mut random);
        query.window = [0.0, 1.0];
        if is_thin {
            [query.t0, query.t1] = thin(family, &mut random);
        }
        let Some(Exact::Contact([toi, _])) = query.decided() else { continue };
        let is_judged = check(family, &query.t0, &query.t1, toi);
        n_judged += is_judged as usize;
        n_thin += (is_judged && is_thin) as usize;
    }
    assert!(n_judged > 160 && n_thin > 40, "{n_judged}, {n_thin}");
}

/// The normal towards a body points to the side from which it came, of needles too.
#[test]
fn a_normal_away_from_a_named_body() {
    let mut random = Random::new(6);
    let mut n_hits = 0;
    for _ in 0..200 {
        let [t0, t1] = thin(0, &mut random);
        let options = Options::default()
            .with_mode(Mode::Exact)
            .with_bodies(Bodies::new(&[7, 3, 3, 3]).with_self_contacts(false));
        let mut session = Session::new(mesh(0), options).unwrap();
        let Some(hit) = session.first_contact(&t0, &t1).unwrap() else { continue };
        n_hits += 1;
        assert_eq!((hit.bodies, hit.normal_towards(7)), ([7, 3], hit.normal));
        let towards =
            |body| sturm::meet(false, [&t0, &t1], hit.toi, hit.weights, hit.normal_towards(body));
        assert_eq!(towards(7), Ok(true), "{hit:?}");
        assert!(towards(3).is_err());
    }
    assert!(n_hits > 5, "{n_hits}");
}

#[test]
fn another_time_is_no_contact() {
    let face = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    let at = |z: f64| [[1.0, 1.0, z], face[0], face[1], face[2]];
    assert!(check(0, &at(1.0), &at(-1.0), 0.5));
    let early = || {
        check(0, &at(1.0), &at(-1.0), 0.25);
    };
    assert!(compare::fails(early));
}

/// What is always in one plane first touches in its boundary, at times that are no `f64`.
#[test]
fn what_is_coplanar_has_weights_of_the_true_time() {
    let far = 1e6;
    // A vertex, a face: in the middle of a side, in a corner along a side.
    let face = [[0.0; 3], [3.0, 0.0, 0.0], [0.0, 0.0, 3.0]];
    let at = |x: f64, z: f64| [[x, 0.0, z], face[0], face[1], face[2]];
    let side = [at(-1.0, -far), at(6.0, 6.0 * far + 1.0)];
    let corner = [at(0.0, -1.0), at(0.0, 6.0)];
    // An edge of which one end comes to the middle of the other, or along it to an end of it.
    let at = |x: f64, z: f64| [[0.0; 3], [3.0, 0.0, 0.0], [x, 0.0, z], [0.0, 0.0, -9.0]];
    let end = [at(-far, -1.0), at(6.0 * far + 1.0, 6.0)];
    let ends = [at(-1.0, 0.0), at(6.0, 0.0)];
    let (first, last) = (20.0 / 21.0, 1.0 / 21.0);
    for (family, [t0, t1], want) in [
        (0, side, [1.0, first, 0.0, last]),
        (0, corner, [1.0, 1.0, 0.0, 0.0]),
        (1, end, [first, last, 1.0, 0.0]),
        (1, ends, [1.0, 0.0, 1.0, 0.0]),
    ] {
        let options = Options::default().with_mode(Mode::Exact);
        let mesh = mesh(family);
        let mut session = Session::new(&mesh, options).unwrap();
        let contacts = session.step(&t0, &t1).unwrap().contacts.clone();
        let [contact] = &contacts[..] else { panic!("{contacts:?}") };
        assert!(contact.toi <= 1.0 / 7.0 && contact.toi > 1.0 / 7.0 - 1e-15, "{contact:?}");
        let found = contact.geometry(&mesh, &t0, &t1);
        assert_eq!((found.weights, found.distance), (want, 0.0), "{contact:?}");
    }
}

/// Sides that shrink to a point while they move, and edges in one plane that touch in a point of
/// the middle of where they overlap by rounding.
#[test]
fn features_come_nearer_along_the_normal() {
    type Pair = [[[f64; 3]; 4]; 2];
    let shrinking: [(usize, Pair); 2] = [
        (
            0,
            [
                [[-1.0, 0.0, 0.0], [-1.0, 1.0, 0.0], [0.0; 3], [0.0, 1.0, 0.0]],
                [[0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0; 3], [0.0, -2.0, 0.0]],
            ],
        ),
        (
            1,
            [
                [[1.0, -3.0, -1.0], [4.0, -3.0, 2.0], [6.0, 1.0, 6.0], [5.0, -1.0, 4.0]],
                [[-1.0, -1.0, 0.0], [2.0, -1.0, 3.0], [-18.0, -41.0, -37.0], [-8.0, -21.0, -17.0]],
            ],
        ),
    ];
    let in_a_plane: (usize, Pair) = (
        1,
        [
            [[0.2, 0.30000000000000004, 0.0], [-0.2, -0.1, 0.0], [-0.1, 0.0, 0.0], [0.0, 0.1, 0.0]],
            [[0.0, 0.1, 0.0], [-0.2, 0.2, 0.0], [0.1, 0.0, 0.0], [-0.30000000000000004, 0.1, 0.0]],
        ],
    );
    for (family, [t0, t1]) in shrinking.into_iter().chain([in_a_plane]) {
        let mesh = mesh(family);
        let mut session = Session::new(&mesh, Options::default().with_mode(Mode::Exact)).unwrap();
        let contacts = session.step(&t0, &t1).unwrap().contacts.clone();
        let [contact] = &contacts[..] else { panic!("{contacts:?}") };
        let at = contact.geometry(&mesh, &t0, &t1);
        let n_first = contact.kind.n_first();
        let way = |i: usize, k: usize| at.weights[i] * (t1[i][k] - t0[i][k]) * at.normal[k];
        let along = |i: usize| (0..3).map(|k| way(i, k)).sum::<f64>();
        let speed: f64 = (0..4).map(|i| if i < n_first { along(i) } else { -along(i) }).sum();
        assert!(speed < 0.0, "{contact:?}: {at:?}, {speed}");
    }
}
