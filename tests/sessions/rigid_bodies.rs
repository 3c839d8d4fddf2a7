//! Steps in which bodies move by poses find, to the last bit, what plain steps find of the same
//! positions: whatever else moves or stands still, changes in between, or is refused.

use ccd::scenes::{Random, grid, sphere};
use ccd::{Bodies, BodyMotion, Coordinate, Mesh, Options, Posed, Session};

type Pose<T> = [[T; 4]; 4];

/// Vertices along a side of each ball.
const BALL: usize = 12;
/// Bodies: a floor that is fixed, a cloth, particles and rods, a plate with self-contact; without
/// it a die, and balls.
const FLOOR: u32 = 0;
const CLOTH: u32 = 1;
const LOOSE: u32 = 2;
const SELF: u32 = 3;
const DIE: u32 = 4;
const FIRST: u32 = 5;
const N_BODIES: u32 = 10;

/// A mesh whose bodies' vertices are spread over the ids, its bodies, and where they are.
fn scene() -> (Mesh, Bodies, Vec<[f64; 3]>) {
    let (mut x, mut body, mut faces, mut edges) = (vec![], vec![], vec![], vec![]);
    let sheet = |n: usize, side: f64, y: f64| -> Vec<[f64; 3]> {
        let at = |k: usize| side * (k as f64 / (n - 1) as f64 - 0.5);
        (0..n * n).map(|i| [at(i % n), y, at(i / n)]).collect()
    };
    let mut add = |of: u32, points: Vec<[f64; 3]>, n: usize| {
        let first = x.len() as u32;
        body.resize(x.len() + points.len(), of);
        x.extend(points);
        if n > 0 {
            grid(&mut faces, n, first);
        }
        first
    };
    add(FLOOR, sheet(20, 6.0, -1.0), 20);
    add(CLOTH, sheet(14, 2.0, 0.3), 14);
    let loose = add(LOOSE, sheet(5, 3.0, 0.0), 0);
    edges.extend((0..10).map(|k| [loose + k, loose + k + 10]));
    for of in FIRST..N_BODIES {
        // In a row, so that some have room.
        let x = 0.85 * (of as f64 - 0.5 * N_BODIES as f64);
        let ball =
            sphere(BALL).iter().map(|p| [x + 0.3 * p[0], 1.0 + 0.3 * p[1], 0.3 * p[2]]).collect();
        let first = add(of, ball, BALL);
        // A strut that is no edge of a face.
        edges.push([first, first + (BALL * BALL / 2) as u32]);
    }
    add(DIE, sheet(2, 0.3, 2.0), 2);
    add(SELF, sheet(12, 0.8, 3.0), 12);
    // Ids in runs of five that are mixed.
    let mut random = Random::new(5);
    let mut runs: Vec<Vec<usize>> =
        (0..x.len()).collect::<Vec<_>>().chunks(5).map(<[_]>::to_vec).collect();
    for i in 1..runs.len() {
        runs.swap(i, random.below(i as u32 + 1) as usize);
    }
    let old: Vec<usize> = runs.concat();
    let mut new = vec![0; old.len()];
    old.iter().enumerate().for_each(|(id, &was)| new[was] = id as u32);
    let faces: Vec<[u32; 3]> = faces.iter().map(|face| face.map(|v| new[v as usize])).collect();
    let edges: Vec<[u32; 2]> = edges.iter().map(|edge| edge.map(|v| new[v as usize])).collect();
    let names: Vec<u32> = old.iter().map(|&was| body[was]).collect();
    let mut bodies = Bodies::new(&names).with_fixed(FLOOR, true);
    for of in [DIE].into_iter().chain(FIRST..N_BODIES) {
        bodies = bodies.with_self_contact(of, false);
    }
    // Two balls that go through each other.
    bodies = bodies.with_excluded_bodies(&[[FIRST, FIRST + 1]]);
    let mesh = Mesh::with_edges(x.len(), &faces, &edges).unwrap();
    let at = old.iter().map(|&was| x[was].map(|c| c as f32 as f64)).collect();
    (mesh, bodies, at)
}

/// A turn by up to `angle` about some axis through the point `at` on all axes, and a shift.
fn pose<T: Coordinate>(random: &mut Random, angle: f64, shift: [f64; 3], at: f64) -> Pose<T> {
    let axis = random.point().map(|c| c - 0.5);
    let length = axis.iter().map(|c| c * c).sum::<f64>().sqrt().max(1e-3);
    let [x, y, z] = axis.map(|c| c / length);
    let (sin, cos) = (angle * random.unit()).sin_cos();
    let versine = 1.0 - cos;
    let columns = [
        [cos + x * x * versine, y * x * versine + z * sin, z * x * versine - y * sin, 0.0],
        [x * y * versine - z * sin, cos + y * y * versine, z * y * versine + x * sin, 0.0],
        [x * z * versine + y * sin, y * z * versine - x * sin, cos + z * z * versine, 0.0],
        [0.0, 0.0, 0.0, 1.0],
    ];
    let turned = |k: usize| at * (columns[0][k] + columns[1][k] + columns[2][k]);
    let place = [0, 1, 2].map(|k| shift[k] + at - turned(k));
    let columns = [columns[0], columns[1], columns[2], [place[0], place[1], place[2], 1.0]];
    columns.map(|column| column.map(T::from_f64))
}

/// Compares two sessions over many steps; of one bodies are moved.
fn check<T: Coordinate>(what: &str, n: usize, mesh: &Mesh, options: &Options, at_rest: &[[T; 3]]) {
    let session = || Session::new(mesh, options.clone()).unwrap();
    let (mut told, mut plain, mut random) = (session(), session(), Random::new(3));
    let bodies = options.bodies.clone().expect("bodies");
    let of = bodies.body_of_vertex();
    let vertices = |name: u32| (0..of.len()).filter(move |&v| of[v] == name);
    // The scene is around this point.
    let at = (at_rest[0][0].to_f64() / 1e3).round() * 1e3;
    let mut rest = at_rest.to_vec();
    let mut x = rest.clone();
    told.set_positions(&x).unwrap();
    let mut n_contacts = 0;
    for k in 0..n {
        if k % 11 == 10 {
            // Bodies of another shape.
            let by = [1.4, 0.8][k / 11 % 2];
            let stretched = |y: T| T::from_f64(at + by * (y.to_f64() - at));
            rest = at_rest.iter().map(|&[x, y, z]| [x, stretched(y), z]).collect();
            x.clone_from(&rest);
            told.set_positions(&x).unwrap();
        }
        let (mut from, mut to) = (x.clone(), x.clone());
        let mut posed: Vec<(u32, [Pose<T>; 2])> = Vec::new();
        let mut given: Vec<(u32, [Vec<[T; 3]>; 2])> = Vec::new();
        // Of some steps all, of others none; the first moves one alone.
        let chance = if k == 0 { 0.0 } else { [0.3, 1.0, 0.1, 0.0][k % 4] };
        for name in CLOTH..N_BODIES {
            if random.unit() >= chance && !(k == 0 && name == FIRST) {
                continue;
            }
            let shift = random.point().map(|c| if k % 3 == 0 { 3.0 } else { 9.0 } * (c - 0.5));
            let end = random.point();
            let end = [0, 1, 2].map(|i| shift[i] + 0.6 * (end[i] - 0.5));
            let by_positions = name <= LOOSE || random.unit() < 0.04;
            let [pose0, pose1] =
                [pose::<T>(&mut random, 3.0, shift, at), pose(&mut random, 0.3, end, at)];
            let of_body: Vec<[T; 3]> = vertices(name).map(|v| rest[v]).collect();
            let ends = [pose0, pose1].map(|pose| moved(&of_body, &pose));
            for (i, v) in vertices(name).enumerate() {
                (from[v], to[v]) = (ends[0][i], ends[1][i]);
            }
            if by_positions {
                given.push((name, ends));
            } else {
                posed.push((name, [pose0, pose1]));
            }
        }
        let moves = posed.iter().map(|(name, [a, b])| BodyMotion::posed(*name, a, b));
        let others = given.iter().map(|(name, [a, b])| BodyMotion::new(*name, a, b));
        let motions: Vec<BodyMotion> = moves.chain(others).collect();
        match k % 11 {
            3 => {
                check_refused(&mut told, &motions, &posed);
                let report = told.step_bodies(&[]).unwrap();
                let want = plain.step(&x, &x).unwrap();
                assert!(report.contacts == want.contacts, "{what}, step {k}: after a refusal");
                check_others(&format!("{what}, step {k}"), [&mut told, &mut plain], [&x, &to]);
            }
            4 => check_others(&format!("{what}, step {k}"), [&mut told, &mut plain], [&to, &from]),
            5 => {
                let report = told.step(&to, &from).unwrap();
                let want = plain.step(&to, &from).unwrap();
                assert!(report.contacts == want.contacts, "{what}, step {k}");
            }
            6 => assert_eq!(
                told.has_intersections(&x).unwrap(),
                plain.has_intersections(&x).unwrap(),
                "{what}, step {k}"
            ),
            7 => {
                let other = if told.options().min_distance > 0.0 { 0.0 } else { 0.02 };
                told.set_min_distance(other).unwrap();
                plain.set_min_distance(other).unwrap();
            }
            8 if k % 2 == 0 => {
                let now = told.options().bodies.clone().expect("bodies");
                let now = now.with_self_contact(FIRST + 2, k % 4 == 0);
                told.set_bodies(now.clone()).unwrap();
                plain.set_bodies(now).unwrap();
            }
            // So often that trees of rigid bodies go.
            9 => (0..10).for_each(|_| {
                let toi = told.earliest_toi(&x, &to).unwrap();
                assert_eq!(toi, plain.earliest_toi(&x, &to).unwrap(), "{what}, step {k}");
            }),
            _ => {}
        }
        let toi = told.earliest_toi_of_bodies(&motions).unwrap();
        assert_eq!(toi, plain.earliest_toi(&from, &to).unwrap(), "{what}, step {k}");
        let hit = told.first_contact_of_bodies(&motions).unwrap();
        let report = told.step_bodies(&motions).unwrap();
        let want = plain.step(&from, &to).unwrap();
        assert!(report.contacts == want.contacts, "{what}, step {k}: other contacts");
        assert_eq!(report.candidates, want.candidates, "{what}, step {k}");
        assert_eq!(hit.map(|hit| hit.toi), want.toi, "{what}, step {k}");
        n_contacts += want.contacts.len();
        x = to;
    }
    assert!(n_contacts > 50 * n, "{what}: {n_contacts} contacts");
}

pub fn moved<T: Coordinate>(rest: &[[T; 3]], pose: &Pose<T>) -> Vec<[T; 3]> {
    let x = Posed::one(rest, pose);
    let view = ccd::AsPositions::as_positions(&x);
    (0..rest.len()).map(|v| view.at(v)).collect()
}

/// Calls that are told all positions.
fn check_others<T: Coordinate>(what: &str, sessions: [&mut Session; 2], x: [&[[T; 3]]; 2]) {
    let [told, plain] = sessions.map(|session| {
        let candidates = session.candidates(x[0], x[1]).unwrap();
        let mut pairs = [candidates.vf, candidates.ee].map(|of| of.iter().collect::<Vec<_>>());
        pairs.iter_mut().for_each(|of| of.sort_unstable_by_key(|pair| (pair.a, pair.b)));
        let through = session.intersections(x[0]).unwrap();
        let toi = session.earliest_toi(x[0], x[1]).unwrap();
        (pairs, through, toi, session.step(x[0], x[1]).unwrap().contacts.clone())
    });
    assert!(told == plain, "{what}: other answers to plain calls");
}

/// Calls that are refused leave all bodies where they were.
fn check_refused<T: Coordinate>(
    session: &mut Session,
    motions: &[BodyMotion],
    posed: &[(u32, [Pose<T>; 2])],
) {
    let Some((name, [pose0, pose1])) = posed.first() else { return };
    let mut refused = |pose1: &Pose<T>, want: &str| {
        let others = motions.iter().filter(|of| of.body != *name).copied();
        let all: Vec<BodyMotion> = others.chain([BodyMotion::posed(*name, pose0, pose1)]).collect();
        let error = session.step_bodies(&all).expect_err("refused");
        assert!(format!("{error:?}").contains(want), "{error:?} for {want}");
    };
    let mut bad = *pose1;
    bad[1][3] = T::from_f64(0.5);
    refused(&bad, "Projection");
    bad = *pose1;
    bad[3][2] = T::from_f64(f64::NAN);
    refused(&bad, "Coordinate");
    bad[3][2] = T::from_f64(f64::INFINITY);
    refused(&bad, "Coordinate");
}

#[test]
fn steps_by_poses_are_plain_steps() {
    let (mesh, bodies, x) = scene();
    let narrow: Vec<[f32; 3]> = x.iter().map(|p| p.map(|c| c as f32)).collect();
    let plain = Options::default().with_bodies(bodies);
    // Far away, so that boxes and tables are rounded.
    let far: Vec<[f64; 3]> = x.iter().map(|p| p.map(|c| c + 1e5 + 0.1)).collect();
    check("f32, one thread", 45, &mesh, &plain.clone().with_threads(1), &narrow);
    check("f64, two threads", 34, &mesh, &plain.clone().with_threads(2), &x);
    check("far away", 34, &mesh, &plain, &far);
    check("a distance", 23, &mesh, &plain.clone().with_min_distance(0.02), &x);
    let sweep = plain.with_broad_phase(ccd::method::BroadPhaseMethod::SweepAndPrune);
    check("a sweep", 12, &mesh, &sweep, &x);
}

/// Two plates that pass each other at nearly the minimum distance, or a little more: by poses both,
/// one of them, or neither.
#[test]
fn what_keeps_less_than_the_distance_is_near() {
    const DISTANCE: f64 = 0.1;
    let (mut x, mut faces) = (Vec::new(), Vec::new());
    for plate in 0..2 {
        grid(&mut faces, 8, x.len() as u32);
        x.extend((0..64).map(|i| [(i % 8) as f32, plate as f32, (i / 8) as f32]));
    }
    let names: Vec<u32> = (0..x.len() as u32).map(|v| v / 64).collect();
    let mesh = Mesh::new(x.len(), &faces).unwrap();
    let bodies = Bodies::new(&names).with_self_contacts(false);
    let options = Options::default().with_bodies(bodies).with_min_distance(DISTANCE);
    let pose = |height: f64| {
        let mut pose = [0, 1, 2, 3].map(|k| [0, 1, 2, 3].map(|i| (i == k) as u8 as f32));
        pose[3][1] = height as f32;
        pose
    };
    for posed in [[true, true], [true, false], [false, true], [false, false]] {
        for gap in [0.99 * DISTANCE, 1.01 * DISTANCE] {
            let mut session = Session::new(&mesh, options.clone()).unwrap();
            session.set_positions(&x).unwrap();
            let poses = [pose(0.0), pose(gap - 1.0)];
            let ends = [0, 1].map(|plate| moved(&x[64 * plate..64 * (plate + 1)], &poses[plate]));
            let motion = |plate: usize| match posed[plate] {
                true => BodyMotion::posed(plate as u32, &poses[plate], &poses[plate]),
                false => BodyMotion::new(plate as u32, &ends[plate], &ends[plate]),
            };
            for _ in 0..2 {
                let report = session.step_bodies(&[motion(0), motion(1)]).unwrap();
                assert_eq!(report.toi.is_some(), gap < DISTANCE, "{posed:?}, {gap}");
            }
            // They stay where they are if a call is refused, and whatever they are called.
            let mut bad = poses[1];
            bad[3][0] = f32::NAN;
            let refused = [(0, pose(5.0)), (1, bad)];
            let refused = refused.each_ref().map(|(plate, to)| BodyMotion::posed(*plate, to, to));
            assert!(session.step_bodies(&refused).is_err());
            let toi = session.step_bodies(&[]).unwrap().toi;
            assert_eq!(toi.is_some(), gap < DISTANCE, "{posed:?}, {gap}, refused");
            let swapped: Vec<u32> = names.iter().map(|name| 1 - name).collect();
            session.set_bodies(Bodies::new(&swapped).with_self_contacts(false)).unwrap();
            let toi = session.earliest_toi_of_bodies(&[]).unwrap();
            assert_eq!(toi.is_some(), gap < DISTANCE, "{posed:?}, {gap}, with other names");
        }
    }
}
