//! First contacts of bodies on a level are those of whole steps.

use ccd::method::BroadPhaseMethod;
use ccd::scenes::{Random, grid, sphere};
use ccd::{Bodies, BodyMotion, Coordinate, Hit, Mesh};

/// A ball of many small faces falls on a level, so that a search for the earliest time looks at a
/// shorter time and at what is near: it finds the first contact of a new session's whole step,
/// whatever the session kept of calls before, while the level stays, moves, and is let go.
#[test]
fn first_contacts_are_those_of_whole_steps() {
    check::<f32>(0.0);
    check::<f64>(1e3 + 0.1);

    fn check<T: Coordinate>(far: f64) {
        let (n, m) = (24, 20);
        let mut faces = Vec::new();
        grid(&mut faces, n, 0);
        grid(&mut faces, m, (n * n) as u32);
        let mesh = Mesh::new(n * n + m * m, &faces).expect("a mesh");
        let body: Vec<u32> = (0..mesh.n_vertices()).map(|v| (v >= n * n) as u32).collect();
        let still = Bodies::new(&body).with_fixed(0, true).with_self_contacts(false);
        let options = ccd::Options::default().with_threads(2).with_bodies(still.clone());
        let of =
            |options: &ccd::Options| ccd::Session::new(&mesh, options.clone()).expect("a session");
        let (mut random, ball) = (Random::new(5), sphere(m));
        let (mut session, mut n_narrow, mut n_found) = (of(&options), 0, 0);
        let mut at_rest = Vec::new();
        for k in 0..40 {
            if k % 8 == 0 {
                let level = (0..n * n).map(|i| {
                    [(i % n) as f64, 0.4 * random.unit(), (i / n) as f64].map(|c| 0.25 * c + far)
                });
                let x: Vec<[f64; 3]> =
                    level.chain(ball.iter().map(|p| p.map(|c| c + far))).collect();
                at_rest = x.iter().map(|p| p.map(T::from_f64)).collect::<Vec<[T; 3]>>();
                session.set_positions(&at_rest).expect("positions");
            }
            match k % 10 {
                3 => session.set_min_distance(0.01).expect("a distance"),
                6 => session.set_min_distance(0.0).expect("a distance"),
                7 => session.set_bodies(still.clone().with_fixed(0, false)).expect("bodies"),
                9 => session.set_bodies(still.clone()).expect("bodies"),
                _ => {}
            }
            let [u, v, w] = random.point();
            let [from, to] = [0.9 + 0.4 * u, 0.7 - 0.8 * w].map(|y| {
                let middle = [2.9 + v, y, 2.9 - u];
                let at =
                    |p: &[f64; 3]| [0, 1, 2].map(|i| T::from_f64(0.6 * p[i] + middle[i] + far));
                ball.iter().map(at).collect::<Vec<[T; 3]>>()
            });
            let motion = [BodyMotion::new(1, &from, &to)];
            let toi = session.earliest_toi_of_bodies(&motion).expect("a step");
            let n_candidates = session.report().candidates.total();
            let hit = session.first_contact_of_bodies(&motion).expect("a step");
            let all = session.step_bodies(&motion).expect("a step").clone();
            let first = all.contacts.iter().min_by(|a, b| a.by_time(b));
            let contact = |hit: &Hit| (hit.toi, hit.kind, hit.features);
            let want = first.map(|c| (c.toi, c.kind, [c.a, c.b]));
            assert_eq!((toi, hit.as_ref().map(contact)), (all.toi, want), "{k}, {far}");
            n_narrow += (n_candidates < all.candidates.total()) as usize;
            n_found += toi.is_some() as usize;
            // Whatever the session kept, these are the contacts.
            let now = session.options().clone();
            let mut new = of(&now.with_broad_phase(BroadPhaseMethod::SweepAndPrune));
            new.set_positions(&at_rest).expect("positions");
            let want = new.step_bodies(&motion).expect("a step");
            assert!(want.contacts == all.contacts, "{k}, {far}");
        }
        assert!(n_found > 20 && n_narrow > 15, "{far}: {n_narrow} of {n_found}");
    }
}

/// Rows of spikes that stand in a plane at the start, so that many pairs touch at once and take
/// integers: an earliest time ends at the first that it finds, a first contact is still the first
/// by its ids, and any number of threads finds the same contacts, with a limit of memory, too.
#[test]
fn contacts_at_the_start() {
    let (n, mut faces) = (30, Vec::new());
    grid(&mut faces, n, 0);
    let n_level = n * n;
    let spikes = 300;
    faces.extend((0..spikes as u32).map(|i| [0, 1, 2].map(|k| n_level as u32 + 3 * i + k)));
    let mesh = Mesh::new(n_level + 3 * spikes, &faces).expect("a mesh");
    let mut random = Random::new(8);
    let mut x0: Vec<[f64; 3]> =
        (0..n_level).map(|i| [(i % n) as f64, 0.0, (i / n) as f64]).collect();
    for _ in 0..spikes {
        // Its tip touches the level, on an edge or inside of a face.
        let [u, v, _] = random.point().map(|c| c * 7.0 + 14.0);
        let u = if random.unit() < 0.5 { u.round() } else { u };
        x0.extend([[u, 0.0, v], [u + 0.3, 0.8, v], [u, 0.9, v + 0.4]]);
    }
    // Up and away, all along the level, or down.
    for (k, fall) in [0.25, 0.0, -0.5].into_iter().enumerate() {
        let moved = |(v, p): (usize, &[f64; 3])| match v < n_level {
            true => *p,
            false => [p[0] + 0.125, p[1] + fall, p[2]],
        };
        let x1: Vec<[f64; 3]> = x0.iter().enumerate().map(moved).collect();
        let mut want: Option<Vec<ccd::Contact>> = None;
        for (threads, memory) in [(1, None), (2, None), (5, None), (2, Some(1 << 28))] {
            let options = ccd::Options::default().with_threads(threads).with_max_memory(memory);
            let mut session = ccd::Session::new(&mesh, options).expect("a session");
            let all = session.step(&x0, &x1).expect("a step").contacts.clone();
            let toi = session.earliest_toi(&x0, &x1).expect("a step");
            assert_eq!(toi, Some(0.0), "{k}");
            let hit = session.first_contact(&x0, &x1).expect("a step").expect("a contact");
            let first = all.iter().min_by(|a, b| a.by_time(b)).expect("a contact");
            assert_eq!(
                (hit.toi, hit.kind, hit.features),
                (0.0, first.kind, [first.a, first.b]),
                "{k}, {threads} threads"
            );
            assert!(session.report().contacts.is_empty(), "{k}");
            assert_eq!(session.earliest_toi(&x0, &x1).expect("a step"), toi, "{k}");
            assert!(session.step(&x0, &x1).expect("a step").contacts == all, "{k}");
            let want = want.get_or_insert_with(|| all.clone());
            assert!(*want == all && all.len() >= spikes, "{k}, {threads} threads: {}", all.len());
        }
    }
}
