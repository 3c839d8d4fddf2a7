//! Groups of devices find what one of them finds; positions so many that they go by way of buffers
//! that stay mapped.

use ccd::gpu::{Device, Group, Session};
use ccd::scenes::{Random, copies, crumpled_sheet, grid, particles_and_rods};
use ccd::{Contact, Mesh, Options};

pub const TESTS: crate::Tests = &[
    ("groups_of_devices", check_groups),
    ("groups_whose_parts_meet", check_parts_that_meet),
    ("faces_of_one_vertex", check_faces_of_one_vertex),
    ("many_positions", check_many_positions),
];

fn check_groups(device: &Device) {
    let devices = vec![device.clone(); 2];
    // Corners meet corners: ties, which the host decides.
    let (twice, _) = copies(&crumpled_sheet(12, 7), 2);
    for step in [crumpled_sheet(30, 5), particles_and_rods(100, 6), twice] {
        let mut one = Session::new(device, &step.mesh, Options::default()).unwrap();
        let mut group = Group::new(&devices, &step.mesh, Options::default()).unwrap();
        group.set_least_share(1);
        let want = one.step(&step.x0, &step.x1).unwrap().contacts.clone();
        assert!(want.len() > 100);
        let found = group.step(&step.x0, &step.x1).unwrap();
        assert!(found.contacts == want, "contacts of a group");
        assert_eq!(group.n_used(), 2);
        let toi = one.earliest_toi(&step.x0, &step.x1).unwrap();
        assert_eq!(group.earliest_toi(&step.x0, &step.x1).unwrap(), toi);
        let lists = [one.candidates(&step.x0, &step.x1), group.candidates(&step.x0, &step.x1)];
        let [want, found] = lists.map(|found| {
            let mut found = found.unwrap();
            let lists = [&mut found.vf, &mut found.ee, &mut found.ve, &mut found.vv];
            lists.into_iter().for_each(|list| list.sort_unstable_by_key(|pair| (pair.a, pair.b)));
            found
        });
        assert!(found == want, "candidates of a group");
    }
}

/// Two sheets far from each other; then one vertex, which is none of the samples, goes through the
/// other sheet, so that parts are seen not to hold after the devices have begun; then all of a
/// sheet does; then a step is refused.
fn check_parts_that_meet(device: &Device) {
    let n = 12;
    let mut faces = Vec::new();
    [0, n * n].into_iter().for_each(|first| grid(&mut faces, n, first as u32));
    let mesh = Mesh::new(2 * n * n, &faces).unwrap();
    let sheets = |by: [f64; 3]| -> Vec<[f64; 3]> {
        let at = |i: usize| [(i % n) as f64, 0.1 * (i % 3) as f64, (i / n) as f64];
        let other = |i: usize| [0, 1, 2].map(|k| at(i)[k] + by[k]);
        (0..n * n).map(at).chain((0..n * n).map(other)).collect()
    };
    let mut one = Session::new(device, &mesh, Options::default()).unwrap();
    let mut group = Group::new(&vec![device.clone(); 2], &mesh, Options::default()).unwrap();
    group.set_least_share(1);
    let far = |y: f64| sheets([100.0, y, 0.3]);
    let near = |y: f64| sheets([0.3, y, 0.3]);
    let with_spike = |y: f64| {
        let mut x = far(0.2);
        x[1] = [105.3, y, 5.6];
        x
    };
    for (x0, x1, parts) in [
        (far(0.0), far(0.1), 1),
        (far(0.1), far(0.2), 1),
        (with_spike(1.0), with_spike(-1.0), 2),
        (near(1.0), near(-1.0), 3),
        (near(-1.0), near(-1.1), 3),
        (far(0.2), far(0.1), 4),
    ] {
        let want = &one.step(&x0, &x1).unwrap().contacts;
        assert!(&group.step(&x0, &x1).unwrap().contacts == want, "contacts of sheets");
        assert_eq!((group.n_used(), group.n_partitions()), (2, parts));
        let toi = one.earliest_toi(&x0, &x1).unwrap();
        assert_eq!(group.earliest_toi(&x0, &x1).unwrap(), toi);
    }
    let (x0, mut x1) = (far(0.1), far(0.2));
    x1[7][1] = f64::NAN;
    assert!(group.step(&x0, &x1).is_err());
    let want = &one.step(&near(1.0), &near(-1.0)).unwrap().contacts;
    assert!(want.len() > 100 && &group.step(&near(1.0), &near(-1.0)).unwrap().contacts == want);
}

/// A face that is one vertex, in a part without the edges of that vertex: there it is no particle,
/// either.
fn check_faces_of_one_vertex(device: &Device) {
    let mesh = Mesh::new(4, &[[0, 1, 2], [0, 0, 0]]).unwrap();
    let x0 = [[0.0f32, 0.0, 0.0], [-1.0, 0.0, -0.2], [-1.0, -1.0, -0.2], [1.0, 1.0, 1.0]];
    let mut x1 = x0;
    x1[3] = [0.0, 0.0, 0.05];
    let options = Options::default().with_min_distance(0.1);
    let mut one = Session::new(device, &mesh, options.clone()).unwrap();
    let mut group = Group::new(&vec![device.clone(); 2], &mesh, options).unwrap();
    group.set_least_share(1);
    let want = &one.step(&x0, &x1).unwrap().contacts;
    assert_eq!(want.len(), 2);
    assert_eq!(&group.step(&x0, &x1).unwrap().contacts, want);
}

/// Some triangles among many that meet nothing, in steps of which each is another: the CPU finds
/// the same.
fn check_many_positions(device: &Device) {
    let n = 60_000;
    let faces: Vec<[u32; 3]> = (0..n).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let mesh = Mesh::new(3 * n as usize, &faces).unwrap();
    let mut random = Random::new(9);
    let mut at = |i: u32| {
        // The first hundred are in one cell of a grid.
        let cell = [i % 40, i / 40 % 40, i / 1600].map(|k| if i < 100 { 0.0 } else { k as f64 });
        [(); 3].map(|()| {
            let p = random.point();
            [0, 1, 2].map(|k| cell[k] + 0.5 * p[k])
        })
    };
    let mut frame = || (0..n).flat_map(&mut at).collect::<Vec<[f64; 3]>>();
    let mut session = Session::new(device, &mesh, Options::default()).unwrap();
    let ids = |contacts: &[Contact]| {
        contacts.iter().map(|c| (c.kind, c.a, c.b, c.state)).collect::<Vec<_>>()
    };
    let mut x0 = frame();
    for in_f32 in [true, false, false] {
        let x1 = frame();
        let found = if in_f32 {
            let [x0, x1] =
                [&x0, &x1].map(|x| x.iter().map(|p| p.map(|c| c as f32)).collect::<Vec<_>>());
            let want = ccd::step(&mesh, &x0, &x1, &Options::default()).unwrap();
            (ids(&session.step(&x0, &x1).unwrap().contacts), ids(&want.contacts))
        } else {
            let want = ccd::step(&mesh, &x0, &x1, &Options::default()).unwrap();
            (ids(&session.step(&x0, &x1).unwrap().contacts), ids(&want.contacts))
        };
        assert!(found.1.len() > 100, "{}", found.1.len());
        assert!(found.0 == found.1, "contacts of many positions");
        x0 = x1;
    }
}
