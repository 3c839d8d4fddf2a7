//! Steps in which few of many bodies move find, to the last bit, what plain steps find: nothing
//! that is kept from the calls before is used where it does not hold any more.

use crate::rigid_bodies::moved;
use ccd::scenes::{Random, grid, sphere};
use ccd::{Bodies, BodyMotion, Coordinate, Mesh, Options, Session};
use ccd_testkit::is_whole;

/// Balls along an axis, and vertices along a side of the grid that each is.
const SIDE: u32 = 4;
const BALL: usize = 6;
const N_BODIES: u32 = SIDE * SIDE * SIDE;
/// Bodies that are fixed, and number of worlds.
const SCENES: [(&[u32], u32); 4] = [(&[], 1), (&[3, 17, 18, 40], 1), (&[5], 2), (&MOST, 1)];
/// All but the last ones, which are beside each other.
const MOST: [u32; N_BODIES as usize - 6] = {
    let mut names = [0; N_BODIES as usize - 6];
    let mut name = 0;
    while name < names.len() {
        names[name] = name as u32;
        name += 1;
    }
    names
};

type Pose<T> = [[T; 4]; 4];

/// Balls in rows, with ids that are mixed, and where they are.
fn scene((fixed, n_worlds): (&[u32], u32)) -> (Mesh, Bodies, Vec<[f64; 3]>) {
    let n = BALL * BALL * N_BODIES as usize;
    // Of ball k the vertices k, k + N_BODIES, ..
    let names: Vec<u32> = (0..n as u32).map(|v| v % N_BODIES).collect();
    let mut faces = Vec::new();
    for ball in 0..N_BODIES {
        let mut of_ball = Vec::new();
        grid(&mut of_ball, BALL, 0);
        faces.extend(of_ball.iter().map(|face| face.map(|v| v * N_BODIES + ball)));
    }
    let points = sphere(BALL);
    let at = |v: usize| {
        let (ball, p) = (v as u32 % N_BODIES, points[v / N_BODIES as usize]);
        let row = [ball % SIDE, ball / SIDE % SIDE, ball / SIDE / SIDE];
        [0, 1, 2].map(|k| (1.15 * row[k] as f64 + 0.5 * p[k]) as f32 as f64)
    };
    let mut bodies = Bodies::new(&names).with_self_contacts(false);
    if n_worlds > 1 {
        let worlds: Vec<u32> = (0..N_BODIES).map(|name| name % n_worlds).collect();
        bodies = bodies.with_worlds(&worlds);
    }
    for &name in fixed {
        bodies = bodies.with_fixed(name, true);
    }
    (Mesh::new(n, &faces).unwrap(), bodies, (0..n).map(at).collect())
}

/// Compares two sessions over many steps in which some bodies leave their places, and are back at
/// home in the next one; `posed`: how many of ten by their poses.
fn check<T: Coordinate>(
    what: &str,
    of: (&[u32], u32),
    posed: u32,
    home: &[[T; 3]],
    options: Options,
) {
    let ((mesh, bodies, _), fixed) = (scene(of), of.0);
    let options = options.with_bodies(bodies);
    let mut told = Session::new(&mesh, options.clone()).unwrap();
    let mut plain = Session::new(&mesh, options.with_threads(1)).unwrap();
    told.set_positions(home).unwrap();
    let mut random = Random::new(posed + 7);
    let by = |shift: [f64; 3]| -> Pose<T> {
        let mut pose =
            [0, 1, 2, 3].map(|k| [0, 1, 2, 3].map(|i| T::from_f64((i == k) as u8 as f64)));
        (0..3).for_each(|k| pose[3][k] = T::from_f64(shift[k]));
        pose
    };
    let of_body = |name: u32| -> Vec<[T; 3]> {
        home.iter().skip(name as usize).step_by(N_BODIES as usize).copied().collect()
    };
    let (mut away, mut found): (Vec<u32>, [usize; 2]) = (Vec::new(), [0, 0]);
    let n_steps = if is_whole() { 160 } else { 60 };
    for k in 0..n_steps {
        let mut next = Vec::new();
        // More than a quarter of all, once in a while.
        for _ in 0..[1, 2, 0, 1, 2, 1, 1, 24][random.below(8) as usize] {
            let name = N_BODIES - 1 - random.below(if fixed.len() > 9 { 6 } else { N_BODIES });
            if !fixed.contains(&name) && !next.contains(&name) {
                next.push(name);
            }
        }
        let (mut from, mut to) = (home.to_vec(), home.to_vec());
        let mut moves = Vec::new();
        for &name in next.iter().chain(away.iter().filter(|name| !next.contains(name))) {
            let way = if next.contains(&name) { 3.0 } else { 0.0 };
            let end = random.point().map(|c| way * (c - 0.5));
            let poses = [by([0.0; 3]), by(end)];
            let ends = poses.map(|pose| moved(&of_body(name), &pose));
            for (i, v) in (name as usize..home.len()).step_by(N_BODIES as usize).enumerate() {
                (from[v], to[v]) = (ends[0][i], ends[1][i]);
            }
            moves.push((name, poses, ends, random.below(10) < posed));
        }
        let motions: Vec<BodyMotion> = moves
            .iter()
            .map(|(name, [pose0, pose1], [x0, x1], posed)| match posed {
                true => BodyMotion::posed(*name, pose0, pose1),
                false => BodyMotion::new(*name, x0, x1),
            })
            .collect();
        let what = format!("{what}, step {k}");
        match random.below(12) {
            0 => {
                let report = told.step(&to, &from).unwrap();
                assert!(report.contacts == plain.step(&to, &from).unwrap().contacts, "{what}");
            }
            1 => {
                let listed = told.candidates(&from, &to).unwrap().vf.len();
                assert_eq!(listed, plain.candidates(&from, &to).unwrap().vf.len(), "{what}");
            }
            2 => {
                let distance = 0.01 - told.options().min_distance;
                told.set_min_distance(distance).unwrap();
                plain.set_min_distance(distance).unwrap();
            }
            3 => {
                let none: [[T; 3]; 0] = [];
                told.step_bodies(&[BodyMotion::new(1, &none, &none)]).expect_err("refused");
            }
            _ => {}
        }
        match random.below(3) {
            0 => {
                let report = told.step_bodies(&motions).unwrap();
                let want = plain.step(&from, &to).unwrap();
                assert!(report.contacts == want.contacts, "{what}: other contacts");
                assert_eq!(report.candidates, want.candidates, "{what}");
                found[0] += want.contacts.len();
            }
            1 => {
                let toi = told.earliest_toi_of_bodies(&motions).unwrap();
                assert_eq!(toi, plain.earliest_toi(&from, &to).unwrap(), "{what}");
                found[1] += toi.is_some_and(|toi| toi > 0.0) as usize;
            }
            _ => {
                let hit = told.first_contact_of_bodies(&motions).unwrap();
                assert_eq!(hit, plain.first_contact(&from, &to).unwrap(), "{what}");
            }
        }
        away = next;
    }
    assert!(found[0] > 6 * n_steps && 16 * found[1] > n_steps, "{what}: {found:?}");
}

#[test]
fn what_is_kept_holds() {
    for of in SCENES {
        let (_, _, home) = scene(of);
        let narrow: Vec<[f32; 3]> = home.iter().map(|p| p.map(|c| c as f32)).collect();
        // Far away, so that boxes and tables are rounded.
        let far: Vec<[f64; 3]> = home.iter().map(|p| p.map(|c| c + 1e5 + 0.1)).collect();
        let options = Options::default();
        check("by positions", of, 0, &narrow, options.clone());
        check("by both", of, 5, &home, options.clone().with_threads(2));
        check("by poses", of, 10, &narrow, options.clone().with_threads(1));
        check("far away", of, 3, &far, options);
    }
}
