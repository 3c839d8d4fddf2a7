//! A group of engines that share a mesh, on the CPU, against one session: contacts to the bit,
//! candidates, times, whatever changes between steps.

use ccd::group::Engine;
use ccd::scenes::{self, Random, Step};
use ccd::{Bodies, Error, Exclusions, Groups, Kind, Mesh, Options, Session};
use ccd_core::model::session::{self, Engine as _, On};

type Group = session::Session<Engine<ccd_cpu::Engine>, On<Vec<()>>>;

fn group(n: usize, mesh: &Mesh, options: &Options) -> Group {
    let mut group = Group::new(&vec![(); n], mesh, options.clone()).expect("a group");
    group.set_least_share(1);
    group
}

/// All that both find of a step; how many contacts.
#[track_caller]
fn same(group: &mut Group, session: &mut Session, x0: &[[f64; 3]], x1: &[[f64; 3]]) -> usize {
    let want = session.step(x0, x1).expect("a step").clone();
    let found = group.step(x0, x1).expect("a step");
    assert!(found.contacts == want.contacts, "contacts");
    assert_eq!((found.toi, found.undecided), (want.toi, want.undecided));
    assert_eq!(found.mesh(), want.mesh());
    assert_eq!(group.earliest_toi(x0, x1).unwrap(), session.earliest_toi(x0, x1).unwrap());
    let window = [0.25, 0.5];
    let want = session.step_window(x0, x1, window).unwrap().contacts.clone();
    assert!(group.step_window(x0, x1, window).unwrap().contacts == want, "of a window");
    let listed = session.candidates(x0, x1).unwrap();
    let mut lists = [listed.vf.to_vec(), listed.ee.to_vec(), listed.ve.into(), listed.vv.into()];
    lists.iter_mut().for_each(|list| list.sort_unstable_by_key(|pair| (pair.a, pair.b)));
    let found = group.candidates(x0, x1).unwrap();
    let mut found = [found.vf, found.ee, found.ve, found.vv];
    found.iter_mut().for_each(|list| list.sort_unstable_by_key(|pair| (pair.a, pair.b)));
    assert!(found == lists, "candidates");
    session.step(x0, x1).unwrap().contacts.len()
}

fn every_number_of_parts(step: &Step, options: &Options, fewest: usize) {
    let mut session = Session::new(&step.mesh, options.clone()).unwrap();
    for n in [1, 2, 3, 7] {
        let mut group = group(n, &step.mesh, options);
        let found = same(&mut group, &mut session, &step.x0, &step.x1);
        assert!(found > fewest, "{found}");
        assert_eq!((group.n_partitions(), group.n_used()), (1, n));
    }
}

#[test]
fn contacts_are_those_of_one_session() {
    let options = Options::default();
    every_number_of_parts(&scenes::crumpled_sheet(40, 1), &options, 100);
    every_number_of_parts(&scenes::triangle_soup(3000, 0.05, 2), &options, 100);
    every_number_of_parts(&scenes::particles_and_rods(500, 3), &options, 300);
    let near = options.with_min_distance(0.01);
    every_number_of_parts(&scenes::crumpled_sheet(20, 4), &near, 100);
    every_number_of_parts(&scenes::particles_and_rods(300, 5), &near, 300);
}

#[test]
fn there_may_be_more_members_than_elements() {
    let mesh = Mesh::new(4, &[[0, 1, 2]]).unwrap();
    let x0 = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.2, 1.0, 0.2]];
    let mut x1 = x0;
    x1[3][1] = -1.0;
    let (mut group, mut session) =
        (group(5, &mesh, &Options::default()), Session::new(&mesh, Options::default()).unwrap());
    assert_eq!(same(&mut group, &mut session, &x0, &x1), 1);
    // Two elements.
    assert_eq!((group.n_used(), group.members().len()), (2, 5));
    let none = Group::new(&Vec::new(), &mesh, Options::default());
    assert!(matches!(none.err(), Some(Error::Setting { value: 0, .. })));
}

/// As users have it, all calls go to the first member.
#[test]
fn a_small_mesh_stays_whole() {
    let (step, other) = (scenes::crumpled_sheet(12, 1), scenes::particles_and_rods(50, 1));
    let mut group = Group::new(&vec![(); 2], &step.mesh, Options::default()).unwrap();
    let mut session = Session::new(&step.mesh, Options::default()).unwrap();
    assert_eq!(group.n_used(), 0);
    same(&mut group, &mut session, &step.x0, &step.x1);
    let odd = |_: Kind, a: u32, b: u32| (a + b) % 2 == 1;
    group.set_filter(odd).unwrap();
    session.set_filter(odd).unwrap();
    same(&mut group, &mut session, &step.x0, &step.x1);
    let bodies = Bodies::new(&vec![0; step.mesh.n_vertices()]).with_self_contacts(false);
    group.set_bodies(bodies.clone()).unwrap();
    session.set_bodies(bodies).unwrap();
    assert_eq!(same(&mut group, &mut session, &step.x0, &step.x1), 0);
    group.set_mesh_and_bodies(&other.mesh, None).unwrap();
    session.set_mesh_and_bodies(&other.mesh, None).unwrap();
    assert!(group.report().contacts.is_empty());
    same(&mut group, &mut session, &other.x0, &other.x1);
    assert_eq!(group.n_used(), 1);
    // Another division is for the next step: the report of the last one stays.
    let last = group.step(&other.x0, &other.x1).unwrap().clone();
    assert!(!last.contacts.is_empty() && last.toi.is_some());
    group.set_least_share(1);
    assert!(group.report().contacts == last.contacts);
    assert_eq!((group.report().toi, group.report().mesh()), (last.toi, last.mesh()));
    assert_eq!(group.n_used(), 0);
    same(&mut group, &mut session, &other.x0, &other.x1);
    assert_eq!(group.n_used(), 2);
    group.set_least_share(usize::MAX);
    same(&mut group, &mut session, &other.x0, &other.x1);
    let wrong = group.step(&other.x0, &vec![[f64::NAN; 3]; other.x0.len()]);
    assert!(matches!(wrong.err(), Some(Error::Coordinate { .. })));
    assert!(group.report().contacts.is_empty() && group.report().toi.is_none());
}

/// A vertex that is so far away that boxes in `f32` do not reach it.
#[test]
fn one_vertex_may_be_beyond_all_boxes() {
    let mut step = scenes::crumpled_sheet(12, 1);
    let last = step.x0.len() - 1;
    for far in [1e39, -1e99] {
        (step.x0[last][1], step.x1[last][1]) = (far, far);
        let options = Options::default();
        let (mut group, mut session) =
            (group(3, &step.mesh, &options), Session::new(&step.mesh, options).unwrap());
        for _ in 0..2 {
            assert!(same(&mut group, &mut session, &step.x0, &step.x1) > 10);
        }
    }
}

/// Parts are kept while vertices stay near, and made anew where they do not.
#[test]
fn parts_follow_a_sequence() {
    let scene = scenes::n_body(8, 12);
    let options = Options::default();
    let (mut group, mut session) =
        (group(3, &scene.mesh, &options), Session::new(&scene.mesh, options).unwrap());
    let mut partitions = Vec::new();
    for frame in 0..12 {
        let [x0, x1] = [frame, frame + 1].map(|i| scene.frame(i));
        same(&mut group, &mut session, &x0, &x1);
        partitions.push(group.n_partitions());
    }
    let made = partitions.windows(2).filter(|of| of[0] < of[1]).count();
    assert!(0 < made && made < 11, "{partitions:?}");
    // Elsewhere altogether.
    let far = |x: Vec<[f64; 3]>| x.iter().map(|p| p.map(|c| c + 1e3)).collect::<Vec<_>>();
    let [x0, x1] = [11, 12].map(|i| far(scene.frame(i)));
    same(&mut group, &mut session, &x0, &x1);
    assert_eq!(group.n_partitions(), partitions[11] + 1);
}

/// A scene that falls as a whole is where it was, seen from each of its parts.
#[test]
fn a_motion_of_all_keeps_parts() {
    let (step, options) = (scenes::crumpled_sheet(30, 3), Options::default());
    let (mut group, mut session) =
        (group(3, &step.mesh, &options), Session::new(&step.mesh, options).unwrap());
    let fallen = |x: &[[f64; 3]], by: f64| -> Vec<[f64; 3]> {
        x.iter().map(|p| [p[0] + 0.5 * by, p[1] - by, p[2]]).collect()
    };
    for i in 0..8 {
        let [from, to] = [i, i + 1].map(|i| 0.1 * i as f64);
        let [x0, x1] = [fallen(&step.x0, from), fallen(&step.x1, to)];
        assert!(same(&mut group, &mut session, &x0, &x1) > 100);
        assert_eq!(group.n_partitions(), 1, "{i}");
    }
    let mut x1 = step.x1.clone();
    x1[0][1] -= 0.8;
    same(&mut group, &mut session, &step.x0, &x1);
    assert_eq!(group.n_partitions(), 2);
}

/// A vertex that goes far in a step has much room; others have theirs.
#[test]
fn one_fast_vertex_leaves_parts_small() {
    let (mut step, options) = (scenes::crumpled_sheet(60, 4), Options::default());
    step.x1[0] = [0.9, 0.1, 0.9];
    let (mut group, mut session) =
        (group(4, &step.mesh, &options), Session::new(&step.mesh, options).unwrap());
    same(&mut group, &mut session, &step.x0, &step.x1);
    let in_parts: usize = group.members().map(|of| of.state().mesh.faces().len()).sum();
    let of_mesh = step.mesh.faces().len();
    assert!(in_parts < 2 * of_mesh, "{in_parts} for {of_mesh}");
}

#[test]
fn bodies_rules_and_filters_are_those_of_the_mesh() {
    let step = scenes::triangle_soup(1500, 0.08, 6);
    let (mesh, n) = (&step.mesh, step.mesh.n_vertices());
    let body: Vec<u32> = (0..n as u32).map(|v| v / 3 % 20 * 7).collect();
    let mut random = Random::new(7);
    let mut bodies = Bodies::new(&body).with_fixed_motion(true).with_fixed(14, true);
    for body in 0..20 {
        let filter = 1 + random.below(15);
        bodies = bodies.with_groups(7 * body, Groups { memberships: 1 + random.below(15), filter });
        bodies = bodies.with_excluded_bodies(&[[7 * body, 7 * random.below(20)]]);
        bodies = bodies.with_self_contact(7 * body, random.below(2) == 0);
    }
    let options = Options::default();
    let mut session = Session::new(mesh, options.clone()).unwrap();
    let all = session.step(&step.x0, &step.x1).unwrap().contacts.clone();
    let of = |kind| all.iter().filter(move |c| c.kind == kind).step_by(3).map(|c| [c.a, c.b]);
    let excluded = Exclusions::new(of(Kind::VertexFace).collect(), of(Kind::EdgeEdge).collect());
    let bodies = bodies.with_exclusions(&excluded);
    let mut group = group(3, mesh, &options);
    let mut counts = vec![same(&mut group, &mut session, &step.x0, &step.x1)];
    let ruled = Some(bodies);
    group.set_bodies(ruled.clone()).unwrap();
    session.set_bodies(ruled).unwrap();
    counts.push(same(&mut group, &mut session, &step.x0, &step.x1));
    let odd = |_: Kind, a: u32, b: u32| (a + b) % 2 == 1;
    group.set_filter(odd).unwrap();
    session.set_filter(odd).unwrap();
    counts.push(same(&mut group, &mut session, &step.x0, &step.x1));
    group.remove_filter();
    session.remove_filter();
    group.set_min_distance(0.02).unwrap();
    session.set_min_distance(0.02).unwrap();
    let near = same(&mut group, &mut session, &step.x0, &step.x1);
    assert!(counts.is_sorted_by(|a, b| a > b) && counts[2] > 20 && near > counts[1], "{counts:?}");
    let other = scenes::crumpled_sheet(15, 8);
    group.set_mesh_and_bodies(&other.mesh, None).unwrap();
    session.set_mesh_and_bodies(&other.mesh, None).unwrap();
    same(&mut group, &mut session, &other.x0, &other.x1);
}

#[test]
fn errors_name_what_the_mesh_has() {
    let mut step = scenes::crumpled_sheet(10, 9);
    let last = step.mesh.n_vertices() - 1;
    let body: Vec<u32> = vec![0; last + 1];
    let mut group = group(4, &step.mesh, &Options::default());
    group.step(&step.x0, &step.x1).unwrap();
    group.set_bodies(Bodies::new(&body).with_fixed(0, true)).unwrap();
    let mut still = step.x0.clone();
    assert!(group.step(&step.x0, &still).unwrap().contacts.is_empty());
    still[last][0] += 1.0;
    let moves = group.step(&step.x0, &still).err();
    assert_eq!(moves, Some(Error::FixedMoves { vertex: last }));
    group.set_bodies(None).unwrap();
    let fine = group.step(&step.x0, &step.x1).unwrap().contacts.len();
    step.x1[last][1] = f64::NAN;
    let wrong = group.step(&step.x0, &step.x1).err();
    assert!(
        matches!(wrong, Some(Error::Coordinate { time: 1, vertex, axis: 1, .. }) if vertex == last)
    );
    assert!(group.report().contacts.is_empty());
    step.x1[last][1] = 0.0;
    assert!(group.step(&step.x0, &step.x1).is_ok() && fine > 0);
}
