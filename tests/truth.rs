//! Real scenes against published answers: candidates, contacts, times of impact, queries, digests.
//!
//! The data is not part of the repository (see `ccd_testkit::data`); without it every test here is
//! reported as ignored, with the reason.

use ccd::io::{Frame, Queries, Query, read_queries};
use ccd::method::BroadPhaseMethod;
use ccd::{
    BroadPhase, Contact, Digest, EdgeEdge, Kind, Options, Pair, Real, Report, Session, State,
    TOI_TOLERANCE, Verdict, VertexFace,
};
use ccd_testkit::data::{self, QUERY_SETS, SCENES, Scene};
use ccd_testkit::grazing::distance::{First, first_within, point_triangle, segment_segment};
use ccd_testkit::{brute, compare};
use libtest_mimic::{Arguments, Completion, Failed, Trial};
use std::path::Path;

#[path = "truth/candidate_sets.rs"]
mod candidate_sets;
#[path = "truth/exact.rs"]
mod exact_answers;

fn main() {
    let data = data::data_dir();
    let mut trials = Vec::new();
    let mut add = |name: String, test: Box<dyn FnOnce(&Path) + Send>| {
        let data = data.clone();
        trials.push(Trial::ignorable_test(name, move || match data {
            Ok(dir) => {
                test(&dir);
                Ok::<_, Failed>(Completion::Completed)
            }
            Err(why) => Ok(Completion::ignored_with(why)),
        }));
    };
    type OfScene = (&'static str, fn(&Path, &Scene));
    let of_scenes: [OfScene; 7] = [
        ("sizes", check_sizes),
        ("broad_phase", check_broad_phase),
        ("step", check_step),
        ("step_exact", exact_answers::check_step),
        ("min_distance", check_min_distance),
        ("candidate_set", candidate_sets::check),
        ("contacts_exact", exact_answers::check_contacts),
    ];
    for scene in &SCENES {
        let has_truth = |name: &str| scene.truth.is_some() || !name.starts_with("contacts");
        for (name, check) in of_scenes.into_iter().filter(|(name, _)| has_truth(name)) {
            add(format!("{}_{name}", scene.name), Box::new(move |data| check(data, scene)));
        }
    }
    add("rod_twist_contacts_f32".into(), Box::new(check_rod_twist_f32));
    add("queries_f64".into(), Box::new(|data| check_queries(data, false)));
    add("queries_f32".into(), Box::new(|data| check_queries(data, true)));
    add("queries_exact".into(), Box::new(exact_answers::check_queries));
    add("debris_wall_sequence".into(), Box::new(check_debris_sequence));
    add("bodies_of_rb_hashgrid".into(), Box::new(check_bodies));
    add("negative_controls".into(), Box::new(check_negative_controls));
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

fn check_sizes(data: &Path, scene: &Scene) {
    for frame in scene.load(data) {
        let mesh = frame.mesh().unwrap();
        let [v, e, f] = scene.size;
        assert_eq!((mesh.n_vertices(), mesh.faces().len()), (v, f));
        assert!(e == 0 || mesh.edges().len() == e, "{} edges, expected {e}", mesh.edges().len());
    }
}

/// Both methods give the same set, in f32 a superset of that in f64; small scenes equal brute
/// force.
fn check_broad_phase(data: &Path, scene: &Scene) {
    let [t0, t1] = scene.load(data);
    let mesh = t0.mesh().unwrap();
    let exact = brute::swept_boxes(&mesh, &t0.positions, &t1.positions);
    let rounded = [&exact[0], &exact[1], &exact[2]]
        .map(|boxes| boxes.iter().map(|b| b.round_out()).collect::<Vec<_>>());
    let mut digests = Vec::new();
    for (method, threads) in [
        (BroadPhaseMethod::Blocks, 1),
        (BroadPhaseMethod::Blocks, 2),
        (BroadPhaseMethod::Blocks, 8),
        (BroadPhaseMethod::TREE, 2),
    ] {
        let mut broad = BroadPhase::new(threads, method).unwrap();
        let ee = Digest::of(1, broad.self_pairs(&exact[1]).unwrap().iter());
        let vf = Digest::of(0, broad.pairs(&exact[0], &exact[2]).unwrap().iter());
        let ee_rounded = broad.self_pairs(&rounded[1]).unwrap().to_vec();
        let vf_rounded = broad.pairs(&rounded[0], &rounded[2]).unwrap().to_vec();
        assert!(ee_rounded.len() as u64 >= ee.count && vf_rounded.len() as u64 >= vf.count);
        let rounded =
            [Digest::of(0, vf_rounded.iter().copied()), Digest::of(1, ee_rounded.iter().copied())];
        digests.push([vf, ee, rounded[0], rounded[1]]);
        if method == BroadPhaseMethod::Blocks && threads == 1 {
            check_superset(&mut broad, &exact, &vf_rounded, &ee_rounded);
        }
    }
    assert!(
        digests.windows(2).all(|d| d[0] == d[1]),
        "methods or thread counts differ: {digests:?}"
    );
    let [vf, ee, ..] = digests[0];
    insta::assert_snapshot!(format!("broad_phase_{}", scene.name), format!("vf {vf}\nee {ee}\n"));
    if exact[1].len() < 10_000 {
        assert_eq!(vf, Digest::of(0, brute::pairs(&exact[0], &exact[2]).into_iter()));
        assert_eq!(ee, Digest::of(1, brute::self_pairs(&exact[1]).into_iter()));
    }
}

/// At a thousandth of the scene's size nothing is undecided after the start of the step, and times
/// are those of an independent computation.
fn check_min_distance(data: &Path, scene: &Scene) {
    let [t0, t1] = scene.load(data);
    let mesh = t0.mesh().unwrap();
    let (x0, x1) = (&t0.positions, &t1.positions);
    let bounds =
        x0.iter().fold(ccd::Aabb::of_point(x0[0]), |b, &p| b.union(&ccd::Aabb::of_point(p)));
    let diagonal = (0..3).map(|k| (bounds.max[k] - bounds.min[k]).powi(2)).sum::<f64>().sqrt();
    let d = 1e-3 * diagonal;
    let mut session = Session::new(mesh, Options::default().with_min_distance(d)).unwrap();
    let report = session.step(x0, x1).unwrap().clone();
    let mesh = session.mesh();
    let open = report.contacts.iter().filter(|c| c.state == State::Undecided && c.toi > 0.0);
    assert_eq!(open.count(), 0, "{}: undecided contacts after the start", scene.name);
    let late: Vec<&Contact> = report.contacts.iter().filter(|c| c.toi > 0.0).collect();
    let (mut n, mut n_unclear) = (0, 0);
    for contact in late.iter().step_by(late.len() / 2000 + 1) {
        let ids = mesh.vertices_of(contact.kind, Pair { a: contact.a, b: contact.b });
        let at = |x: &[[f64; 3]]| ids.map(|i| x[i as usize]);
        let first = match contact.kind {
            Kind::VertexFace => first_within(point_triangle, 1, &at(x0), &at(x1), d),
            _ => first_within(segment_segment, 2, &at(x0), &at(x1), d),
        };
        match first {
            First::At(t) => {
                let right = contact.toi <= t + 1e-8 && contact.toi >= t - TOI_TOLERANCE - 1e-8;
                assert!(right, "{contact:?}, but the first time is {t}");
                n += 1;
            }
            First::Never => panic!("{contact:?}, but the distance stays above {d}"),
            First::Unclear => n_unclear += 1,
        }
    }
    let seen = format!("{} contacts, {n} checked, {n_unclear} unclear", report.contacts.len());
    println!("{}: {seen}", scene.name);
    assert!(n >= 4 * n_unclear && n + n_unclear > 0, "{seen} show nothing");
}

/// No exact pair is missing among those of rounded boxes, and none of those comes twice.
fn check_superset(
    broad: &mut BroadPhase,
    exact: &[Vec<ccd::Aabb<f64>>; 3],
    vf_rounded: &[Pair],
    ee_rounded: &[Pair],
) {
    let sorted = |pairs: &[Pair]| {
        let mut pairs = pairs.to_vec();
        pairs.sort_unstable();
        assert!(pairs.windows(2).all(|w| w[0] != w[1]), "a pair comes twice");
        pairs
    };
    let (vf_rounded, ee_rounded) = (sorted(vf_rounded), sorted(ee_rounded));
    let holds = |pairs: &[Pair], pair: Pair| pairs.binary_search(&pair).is_ok();
    let vf = broad.pairs(&exact[0], &exact[2]).unwrap();
    assert!(vf.iter().all(|pair| holds(&vf_rounded, pair)));
    let ee = broad.self_pairs(&exact[1]).unwrap();
    assert!(ee.iter().all(|pair| holds(&ee_rounded, pair)));
}

/// Counts as published; one digest for 1, 2 and 8 threads, which is also the recorded one.
fn check_step(data: &Path, scene: &Scene) {
    let [t0, t1] = scene.load(data);
    let reports = [1, 2, 8].map(|threads| run(&t0, &t1, threads));
    if let Some([vf, ee]) = scene.candidates {
        assert_eq!((reports[0].candidates.vf, reports[0].candidates.ee), (vf, ee), "candidates");
    }
    let answers = |r: &Report| (r.contacts.clone(), r.candidates, r.toi);
    let of_one = answers(&reports[0]);
    assert!(reports.iter().all(|r| answers(r) == of_one), "answers depend on threads");
    let mesh = t0.mesh().unwrap();
    let earliest =
        ccd::earliest_toi(&mesh, &t0.positions, &t1.positions, &Options::default()).unwrap();
    assert_eq!(earliest, reports[0].toi, "the earliest time of impact alone");
    if mesh.edges().len() < 10_000 {
        let [vf, ee] = brute::candidates(&mesh, &t0.positions, &t1.positions);
        assert_eq!(of_one.1, ccd::PerKind::new(vf.len() as u64, ee.len() as u64));
    }
    assert_eq!(reports[0].undecided, 0);
    insta::assert_snapshot!(format!("step_{}", scene.name), compare::step_text(&reports[0]));
}

fn run(t0: &Frame, t1: &Frame, threads: usize) -> Report {
    let options = Options::default().with_threads(threads);
    ccd::step(&t0.mesh().unwrap(), &t0.positions, &t1.positions, &options).unwrap()
}

/// The scene whose coordinates are no `f32`, after rounding them, against the exact answers for the
/// rounded ones.
fn check_rod_twist_f32(data: &Path) {
    let scene = Scene::named("rod-twist");
    let [t0, t1] = scene.load(data);
    let mesh = t0.mesh().unwrap();
    let report =
        ccd::step(&mesh, &t0.positions_f32(), &t1.positions_f32(), &Options::default()).unwrap();
    let truth = ["vf", "ee"].map(|kind| {
        let times = data::read_times(
            &data.join("toi_f32").join(format!("rod-twist_queries_3036{kind}.csv")),
        );
        let mut pairs = scene.contacts(data, kind);
        assert_eq!(pairs.len(), times.len());
        pairs.iter_mut().zip(&times).for_each(|(p, t)| (p.hit, p.toi) = (t.hit, t.toi));
        pairs
    });
    // Pairs that became contacts only by rounding are not in the files, so what is left over is no
    // count of false alarms.
    compare::contacts(&report, &truth[0], &truth[1]);
}

/// All published queries, in `f64` or rounded to `f32` first.
fn check_queries(data: &Path, single: bool) {
    let (mut n, mut n_hits, mut n_undecided, mut n_false) = (0, 0, 0, 0);
    let mut left = QUERY_SETS.map(|(set, budgets)| (set, budgets[single as usize] as i64));
    for (path, name) in data::query_files(data) {
        let (_, left) = left
            .iter_mut()
            .find(|(set, _)| name.starts_with(set))
            .unwrap_or_else(|| panic!("{name} is of no set"));
        let Queries { queries, answers } = read_queries(&path).unwrap();
        let times =
            data::read_times(&data.join(if single { "toi_f32" } else { "toi" }).join(&name));
        assert_eq!(queries.len(), times.len(), "{name}");
        for (i, (query, time)) in queries.iter().zip(&times).enumerate() {
            assert!(single || time.hit == answers[i], "{name} {i}: the two sources disagree");
            let verdict = if single { decide_f32(query) } else { decide::<f64>(query) };
            let (hit, certain) = compare::verdict(verdict, time, &format!("{name} query {i}"));
            n += 1;
            n_hits += hit as usize;
            n_undecided += (hit && !certain) as usize;
            *left -= (hit && !certain) as i64;
            n_false += (hit && !time.hit) as usize;
        }
    }
    println!("{n} queries: {n_hits} hits, {n_undecided} of them undecided, {n_false} false alarms");
    assert_eq!(n, 7279);
    assert!(
        left.iter().all(|(_, left)| *left >= 0),
        "more are undecided than may be, by as many as are negative: {left:?}"
    );
}

/// The verdict on a query whose numbers are brought to another precision first.
fn decide<R: Real>(query: &Query) -> Verdict<R> {
    let narrow = |x: &[[f64; 3]; 4]| x.map(|p| p.map(R::from_f64));
    let zero = R::splat(0.0);
    match query {
        Query::VertexFace(q) => {
            ccd::vertex_face(&VertexFace { t0: narrow(&q.t0), t1: narrow(&q.t1) }, zero)
        }
        Query::EdgeEdge(q) => {
            ccd::edge_edge(&EdgeEdge { t0: narrow(&q.t0), t1: narrow(&q.t1) }, zero)
        }
    }
}

/// In `f32` arithmetic first, in `f64` if that is undecided.
fn decide_f32(query: &Query) -> Verdict<f64> {
    let rounded = |x: &[[f64; 3]; 4]| x.map(|p| p.map(|c| c as f32 as f64));
    match decide::<f32>(query) {
        Verdict::Miss => Verdict::Miss,
        Verdict::Hit { toi } => Verdict::Hit { toi: toi.into() },
        Verdict::Undecided { .. } => decide(&match query {
            Query::VertexFace(VertexFace { t0, t1 }) => {
                Query::VertexFace(VertexFace { t0: rounded(t0), t1: rounded(t1) })
            }
            Query::EdgeEdge(EdgeEdge { t0, t1 }) => {
                Query::EdgeEdge(EdgeEdge { t0: rounded(t0), t1: rounded(t1) })
            }
        }),
    }
}

/// A session over 60 frames gives what single steps give, refitted or rebuilt.
fn check_debris_sequence(data: &Path) {
    let path = |i| data.join(format!("scenes/debris-wall/frames/{i:03}.ply"));
    let frames: Vec<Frame> = (40..100).map(|i| ccd::io::read_frame(&path(i)).unwrap()).collect();
    let mut session =
        Session::new(frames[0].mesh().unwrap(), Options::default().with_threads(2)).unwrap();
    let mut n_rebuilt = 0;
    for (i, pair) in frames.windows(2).enumerate() {
        let report = session.step(&pair[0].positions, &pair[1].positions).unwrap();
        n_rebuilt += report.rebuilt as usize;
        if i % 7 == 0 {
            let single = run(&pair[0], &pair[1], 1);
            let want = (single.candidates, &single.contacts);
            assert_eq!((report.candidates, &report.contacts), want, "frame {i}");
        }
    }
    println!("debris-wall: trees built in {n_rebuilt} of 59 steps");
    assert!((1..59).contains(&n_rebuilt), "trees were built in {n_rebuilt} of 59 steps");
}

/// With bodies, the pairs within one body are gone and no others.
fn check_bodies(data: &Path) {
    let scene = Scene::named("rb-hashgrid");
    let [t0, t1] = scene.load(data);
    let text = std::fs::read_to_string(data.join("scenes/rb-hashgrid/body_of_vertex.txt")).unwrap();
    let body: Vec<u32> = text.split_whitespace().map(|w| w.parse().unwrap()).collect();
    let mesh = t0.mesh().unwrap();
    let all = run(&t0, &t1, 2);
    let bodies = ccd::Bodies::new(&body).with_self_contacts(false);
    let options = Options::default().with_bodies(bodies);
    let between = ccd::step(&mesh, &t0.positions, &t1.positions, &options).unwrap();
    let different = |c: &&Contact| {
        let ids = c.vertices(&mesh).map(|v| body[v as usize]);
        ids[0] != ids[c.kind.n_first()]
    };
    let want: Vec<Contact> = all.contacts.iter().filter(different).copied().collect();
    assert_eq!(between.contacts, want);
    assert!(between.candidates.total() < all.candidates.total());
}

/// The comparisons above fail when they should.
fn check_negative_controls(data: &Path) {
    let scene = Scene::named("cloth-funnel");
    let [t0, t1] = scene.load(data);
    let (vf, ee) = (scene.contacts(data, "vf"), scene.contacts(data, "ee"));
    let fails = |change: &dyn Fn(&mut Report)| {
        let mut report = run(&t0, &t1, 1);
        change(&mut report);
        compare::fails(std::panic::AssertUnwindSafe(|| {
            compare::contacts(&report, &vf, &ee);
        }))
    };
    let certain = |r: &Report| r.contacts.iter().position(|c| c.state == State::Hit).unwrap();
    assert!(!fails(&|_| {}));
    let early = |r: &mut Report| {
        let i = certain(r);
        r.contacts[i].toi -= 3e-6;
    };
    assert!(fails(&|r| _ = r.contacts.remove(5)), "a missing contact passes");
    assert!(fails(&|r| r.contacts[5].toi += 1e-9), "a late contact passes");
    assert!(fails(&early), "a contact that is too early passes");
}
