//! Sets of candidates that serve many steps: what they hold is what a session lists of each step,
//! and their times are a session's; steps beyond them are refused.

use ccd::method::{BroadPhaseMethod, Pipeline};
use ccd::scenes::{Random, Step, crumpled_sheet, particles_and_rods, triangle_soup};
use ccd::{
    Bodies, CancelToken, CandidateSet, Coordinate, Error, Kind, Mesh, Options, Pair, Session,
};

type Points<T> = Vec<[T; 3]>;

/// Listed by a session for a step of its own.
fn listed<T: Coordinate>(session: &mut Session, x: [&Points<T>; 2]) -> [Vec<Pair>; 4] {
    let all = session.candidates(x[0], x[1]).expect("candidates");
    [all.vf.to_vec(), all.ee.to_vec(), all.ve.to_vec(), all.vv.to_vec()]
}

/// Holds the pairs of a step, if it is to.
fn has_all(set: &CandidateSet, pairs: &[Vec<Pair>; 4]) -> bool {
    Kind::ALL.into_iter().zip(pairs).all(|(kind, pairs)| {
        let mut held = set.pairs(kind).to_vec();
        held.sort_unstable();
        assert!(held.windows(2).all(|two| two[0] != two[1]), "a pair twice");
        pairs.iter().all(|pair| held.binary_search(pair).is_ok())
    })
}

/// Steps near that of a set, at both ends up to its inflation outside of it along every axis: the
/// set has their pairs and their times. Returns how many had contacts, and how many had not.
fn check_steps<T: Coordinate>(step: &Step, options: &Options, inflation: f64) -> [u32; 2] {
    let narrow = |p: &[f64; 3]| p.map(T::from_f64);
    let [x0, x1]: [Points<T>; 2] = [&step.x0, &step.x1].map(|x| x.iter().map(narrow).collect());
    let mut session = Session::new(step.mesh.clone(), options.clone()).expect("a session");
    let mut set = session.candidate_set(&x0, &x1, inflation).expect("a set");
    assert_eq!((set.inflation(), set.mesh().n_vertices()), (inflation, x0.len()));
    let mut others = Session::new(step.mesh.clone(), options.clone()).expect("a session");
    let (mut random, mut counts) = (Random::new(1), [0; 2]);
    let own = options.bodies.as_ref();
    for round in 0..24 {
        let part = [1.0, 0.5, 0.25, 0.0][round % 4];
        let mut end = |s: f64| -> Points<T> {
            let near = |v: usize| -> [T; 3] {
                std::array::from_fn(|k| {
                    let (p, q) = (x0[v][k].to_f64(), x1[v][k].to_f64());
                    let still = own.is_some_and(|bodies| bodies.is_fixed(v as u32));
                    let by = if still || round < 4 { 0.0 } else { random.unit() * 2.0 - 1.0 };
                    T::from_f64(p + s * (q - p) + by * inflation)
                })
            };
            (0..x0.len()).map(near).collect()
        };
        let (y0, y1) = (end(0.0), end(part));
        assert!(has_all(&set, &listed(&mut others, [&y0, &y1])), "step {round}");
        let want = others.step(&y0, &y1).expect("a step").toi;
        let found = set.earliest_toi(&y0, &y1).expect("a step of the set");
        assert_eq!(found.is_some(), want.is_some(), "step {round}");
        assert!(found <= want && found.unwrap_or(1.0) >= want.unwrap_or(1.0) - 1e-6, "{round}");
        assert_eq!(set.collision_free_step_size(&y0, &y1), Ok(found.unwrap_or(1.0)));
        counts[found.is_none() as usize] += 1;
    }
    counts
}

#[test]
fn sets_find_what_sessions_find() {
    let (sheet, thin) = (crumpled_sheet(14, 1), particles_and_rods(80, 2));
    let soup = triangle_soup(150, 0.2, 3);
    let mut counts = [0; 2];
    for (step, distance, inflation) in [
        (&sheet, 0.0, 0.0),
        (&sheet, 0.0, 0.03),
        (&sheet, 0.004, 0.01),
        (&thin, 0.0, 0.02),
        (&thin, 0.01, 0.05),
        (&soup, 0.0, 0.1),
    ] {
        for threads in [1, 2] {
            let options = Options::default().with_min_distance(distance).with_threads(threads);
            let wide = check_steps::<f64>(step, &options, inflation);
            let narrow = check_steps::<f32>(step, &options, inflation);
            for k in 0..2 {
                counts[k] += wide[k] + narrow[k];
            }
        }
    }
    assert!(counts[0] > 100 && counts[1] > 10, "{counts:?}");
}

#[test]
fn a_set_of_other_pairs_is_noticed() {
    let step = crumpled_sheet(14, 1);
    let mut session = Session::new(step.mesh.clone(), Options::default()).expect("a session");
    let set = session.candidate_set(&step.x0, &step.x0, 0.0).expect("a set");
    assert!(!has_all(&set, &listed(&mut session, [&step.x0, &step.x1])));
}

/// Obstacles and components, a filter, and a method and a pipeline that sets do not have.
#[test]
fn sets_keep_the_rules_of_their_session() {
    let step = triangle_soup(150, 0.3, 4);
    let n = step.mesh.n_vertices();
    let is_static: Vec<bool> = (0..n).map(|v| v >= n / 2).collect();
    let mut still = step.clone();
    still.x1[n / 2..].copy_from_slice(&step.x0[n / 2..]);
    let obstacles = Options::default().with_bodies(Bodies::of_obstacles(&is_static));
    assert!(check_steps::<f64>(&still, &obstacles, 0.02)[0] > 5);
    let mut session = Session::new(still.mesh.clone(), obstacles).expect("a session");
    let mut set = session.candidate_set(&still.x0, &still.x1, 0.5).expect("a set");
    let mut moved = still.x1.clone();
    moved[n - 1][0] += 0.25;
    let refused = set.earliest_toi(&still.x0, &moved);
    assert_eq!(refused, Err(Error::FixedMoves { vertex: n - 1 }));

    let parts = Bodies::of_components(&step.mesh).with_self_contacts(false);
    let parts = Options::default().with_bodies(parts);
    assert!(check_steps::<f64>(&step, &parts, 0.02)[0] > 5);

    let triangles = ccd::method::Pipeline::Triangles(Default::default());
    let options = Options::default().with_pipeline(triangles);
    assert!(check_steps::<f64>(&step, &options, 0.02)[0] > 5);
    let mut session = Session::new(step.mesh.clone(), options).expect("a session");
    session.set_filter(|kind, a, b| kind == Kind::EdgeEdge && (a + b) % 2 == 0).expect("a CPU");
    let set = session.candidate_set(&step.x0, &step.x1, 0.02).expect("a set");
    assert!(set.pairs(Kind::VertexFace).is_empty() && set.pairs(Kind::EdgeEdge).len() > 20);
    assert!(set.pairs(Kind::EdgeEdge).iter().all(|pair| (pair.a + pair.b) % 2 == 0));
}

/// The last position that a set holds for, and the next one.
#[test]
fn steps_beyond_a_set_are_refused() {
    let mesh = Mesh::new(4, &[[0, 1, 2]]).expect("a mesh");
    let mut session = Session::new(mesh, Options::default()).expect("a session");
    let at = |y: f64| [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.2, y, 0.2]];
    for inflation in [0.0, 0.125] {
        let mut set = session.candidate_set(&at(1.0), &at(0.5), inflation).expect("a set");
        let mut ask = |y0: f64, y1: f64| set.earliest_toi(&at(y0), &at(y1));
        // Of a greatest coordinate of 1, eight units of roundoff.
        let least = 0.5 - inflation - 4.0 * f64::EPSILON;
        assert_eq!((ask(1.0 + inflation, least), ask(least, least)), (Ok(None), Ok(None)));
        for (y0, y1, time) in [(1.0, least - f64::EPSILON, 1), (1.2, 0.5, 0), (0.5, -1.0, 1)] {
            assert_eq!(ask(y0, y1), Err(Error::Beyond { time, vertex: 3 }), "{y0} {y1}");
        }
        assert!(matches!(ask(f64::NAN, 1.0), Err(Error::Coordinate { .. })));
    }
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        let refused = session.candidate_set(&at(1.0), &at(0.5), bad);
        assert!(matches!(refused, Err(Error::MinDistance { .. })), "{bad}");
    }
    assert_eq!(session.step(&at(1.0), &at(-1.0)).expect("a step").contacts.len(), 1);
    let (short, whole) = ([[0.0; 3]; 3], at(1.0));
    let refused = session.candidate_set(&short, &whole, 0.0).err();
    assert_eq!(refused, Some(Error::VertexCount { time: 0, expected: 4, found: 3 }));
    let token = CancelToken::new();
    session.set_cancel_token(token.clone());
    let mut set = session.candidate_set(&at(1.0), &at(0.5), 0.0).expect("a set");
    token.cancel();
    assert_eq!(set.earliest_toi(&at(1.0), &at(0.5)), Err(Error::Cancelled));
}

/// A grid falls flat on another one, so that many pairs touch at once: whichever are sampled, the
/// earliest time is that of the step, by every method.
#[test]
fn an_earliest_time_is_that_of_the_step() {
    for n in [9, 31] {
        let mut faces = Vec::new();
        ccd::scenes::grid(&mut faces, n, 0);
        ccd::scenes::grid(&mut faces, n, (n * n) as u32);
        let at = |k: usize| ((k % (n * n) / n) as f64, (k % n) as f64);
        let place = |k: usize, fall: f64| match (at(k), k < n * n) {
            ((x, z), true) => [x, 0.0, z],
            ((x, z), false) => [0.97 * x + 0.31, 1.0 - fall, 0.93 * z + 0.17],
        };
        let [x0, x1] = [0.0, 1.7]
            .map(|fall| (0..2 * n * n).map(|k| place(k, fall)).collect::<Vec<[f64; 3]>>());
        let mesh = Mesh::new(2 * n * n, &faces).expect("a mesh");
        let of = |options: &Options| Session::new(&mesh, options.clone()).expect("a session");
        let blocks = Options::default().with_threads(1);
        let want = of(&blocks).step(&x0, &x1).expect("a step").toi;
        assert!(want.is_some());
        let every =
            Options::default().with_threads(1).with_broad_phase(BroadPhaseMethod::BruteForce);
        let triangles = blocks.clone().with_pipeline(Pipeline::Triangles(Default::default()));
        for options in [&blocks, &every, &triangles] {
            let found = of(options).earliest_toi(&x0, &x1).expect("a step");
            assert_eq!(found, want, "{n}, {:?}", options.broad_phase);
        }
        let mut used = of(&blocks);
        used.step(&x1, &x0).expect("a step");
        assert_eq!(used.earliest_toi(&x0, &x1).expect("a step"), want, "{n}, used");
        let mut set = used.candidate_set(&x0, &x1, 0.0).expect("candidates");
        let found = set.earliest_toi(&x0, &x1).expect("a step");
        assert_eq!(found, want, "{n}, candidates");
    }
}
