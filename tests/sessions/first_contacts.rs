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
