//! Forms of positions: whatever a step is given in, it finds what slices would; and calls as
//! programs write them are compiled as before.

use ccd::any::{self, Backend};
use ccd::{AsPositions, Contact, Error, Mesh, Options, Posed, Session, Strided};
use ccd_testkit::generate::{Step, crumpled_sheet};
use glam::{DMat4, DVec3, Mat4, Quat, Vec3, Vec3A};
use std::borrow::Cow;
use std::sync::Arc;

/// A vertex as a renderer has it: 36 bytes.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::NoUninit)]
struct Vertex {
    normal: [f32; 3],
    colour: u32,
    position: [f32; 3],
    texture: [f32; 2],
}

impl Vertex {
    fn at(position: [f32; 3]) -> Self {
        Self { normal: [f32::NAN; 3], colour: 7, position, texture: [1e30; 2] }
    }
}

/// Contacts, the earliest time and candidates of one form are those of slices; on both sessions.
fn check<A, B>(what: &str, mesh: &Mesh, x: [&A; 2], want: [&B; 2])
where
    A: AsPositions + ?Sized,
    B: AsPositions<Scalar = A::Scalar> + ?Sized,
{
    let options = Options::default().with_threads(1);
    let mut session = Session::new(mesh, options.clone()).unwrap();
    let choice = Backend::Cpu.choose(1).unwrap();
    let mut either = any::Session::new(&choice, mesh, options).unwrap();
    let right = session.step(want[0], want[1]).unwrap().contacts.clone();
    assert!(right.len() > 10, "{what}: {} contacts", right.len());
    // The control: the other way round there are others.
    assert_ne!(session.step(want[1], want[0]).unwrap().contacts, right, "{what}");
    let mixed = session.step(x[0], want[1]).unwrap().contacts == right;
    assert!(mixed, "{what}: at the start alone");
    assert!(session.step(x[0], x[1]).unwrap().contacts == right, "{what}");
    assert!(either.step(x[0], x[1]).unwrap().contacts == right, "{what}, any");
    let of_form = right.iter().map(|c| c.geometry(mesh, x[0], x[1]));
    let slices = right.iter().map(|c| c.geometry(mesh, want[0], want[1]));
    assert!(of_form.eq(slices), "{what}: geometry");
    let earliest = right.iter().map(|c| c.toi).reduce(f64::min);
    assert_eq!(session.earliest_toi(x[0], x[1]).unwrap(), earliest, "{what}");
    assert_eq!(either.earliest_toi(x[0], x[1]).unwrap(), earliest, "{what}, any");
    let n = session.candidates(want[0], want[1]).unwrap().ee.len();
    assert_eq!(session.candidates(x[0], x[1]).unwrap().ee.len(), n, "{what}");
    assert_eq!(either.candidates(x[0], x[1]).unwrap().ee.len(), n, "{what}, any");
}

#[test]
fn every_form_finds_the_same() {
    let step = crumpled_sheet(12, 3);
    let narrow = step.rounded();
    let Step { mesh, x0, x1, .. } = step;
    let wide = [&x0, &x1];
    let slices = narrow.each_ref();

    let vertices = narrow.each_ref().map(|x| x.iter().map(|&p| Vertex::at(p)).collect::<Vec<_>>());
    let offset = std::mem::offset_of!(Vertex, position);
    let views = vertices.each_ref().map(|x| Strided::<f32>::of(x).offset(offset));
    check("vertices", &mesh, views.each_ref(), slices);
    // The same bytes at an odd address, behind others, with something after them.
    let bytes = vertices.each_ref().map(|x| {
        let mut all = vec![0xff; 3];
        all.extend_from_slice(bytemuck::cast_slice(x));
        all.extend([0xff; 40]);
        all
    });
    let (stride, n) = (size_of::<Vertex>(), mesh.n_vertices());
    let views =
        bytes.each_ref().map(|x| Strided::<f32>::new(x, stride).offset(3 + offset).count(n));
    check("bytes", &mesh, views.each_ref(), slices);
    let rows = wide.map(|x| x.iter().map(|p| [1.0, p[0], p[1], p[2]]).collect::<Vec<_>>());
    let views = rows.each_ref().map(|x| Strided::<f64>::of(x).offset(8));
    check("rows of f64", &mesh, views.each_ref(), wide);

    let views = narrow.each_ref().map(|x| x.iter().map(|&p| Vec3::from(p)).collect::<Vec<_>>());
    check("Vec3", &mesh, views.each_ref(), slices);
    let views = narrow.each_ref().map(|x| x.iter().map(|&p| Vec3A::from(p)).collect::<Vec<_>>());
    check("Vec3A", &mesh, views.each_ref(), slices);
    check("slices of Vec3A", &mesh, views.each_ref().map(|x| &x[..]), slices);
    let views = wide.map(|x| x.iter().map(|&p| DVec3::from(p)).collect::<Vec<_>>());
    check("DVec3", &mesh, views.each_ref(), wide);

    let views = narrow.each_ref().map(|x| Cow::Borrowed(&x[..]));
    check("Cow", &mesh, views.each_ref(), slices);
    let views = narrow.each_ref().map(|x| Arc::<[[f32; 3]]>::from(&x[..]));
    check("Arc", &mesh, views.each_ref(), slices);
}

/// Posed positions are bit for bit what `glam` makes of them.
#[test]
fn posed_bodies_are_where_glam_puts_them() {
    let step = crumpled_sheet(12, 3);
    let [rest, _] = step.rounded();
    let Step { mesh, x0, .. } = step;
    let pose = |angle: f32, scale: f32, place: [f32; 3]| {
        let turn = Quat::from_axis_angle(Vec3::new(1.0, 2.0, 3.0).normalize(), angle);
        Mat4::from_scale_rotation_translation(Vec3::splat(scale), turn, place.into())
    };
    let poses = [
        [pose(0.1, 1.0, [0.0; 3]), pose(2.0, 1.1, [0.3, 0.1, -0.2])],
        [pose(-0.3, 0.9, [0.0, 0.1, 0.0]), pose(1.7, 1.0, [0.2, 0.0, 0.1])],
    ];
    // Whole bodies would be one sheet here; a step does not ask.
    let body: Vec<u32> = (0..rest.len()).map(|v| (v / 30 % 2) as u32).collect();
    let at = |k: usize| -> Vec<Vec3> {
        let moved = rest.iter().zip(&body);
        moved.map(|(&p, &b)| poses[k][b as usize].transform_point3(p.into())).collect()
    };
    let want = [at(0), at(1)];
    let views = poses.each_ref().map(|poses| Posed::new(&rest, &body, poses));
    check("posed", &mesh, views.each_ref(), want.each_ref());
    let one = |k: usize| rest.iter().map(|&p| poses[k][1].transform_point3(p.into())).collect();
    let want: [Vec<Vec3>; 2] = [one(0), at(1)];
    let views = [Posed::one(&rest, &poses[0][1]), Posed::new(&rest, &body, &poses[1])];
    check("one pose", &mesh, views.each_ref(), want.each_ref());
    let turn = DMat4::from_rotation_x(0.5);
    let mut still = turn.to_cols_array_2d();
    still[3][1] += 0.25;
    let want = [turn, DMat4::from_cols_array_2d(&still)]
        .map(|m| x0.iter().map(|&p| m.transform_point3(p.into()).to_array()).collect::<Vec<_>>());
    let rest: Vec<DVec3> = x0.iter().map(|&p| p.into()).collect();
    let mut session = Session::new(&mesh, Options::default().with_min_distance(0.01)).unwrap();
    let right = session.step(&want[0], &want[1]).unwrap().contacts.clone();
    let found = session.step(&Posed::one(&rest, &turn), &Posed::one(&rest, &still)).unwrap();
    assert!(!right.is_empty() && found.contacts == right);
}

/// What is wrong with a form is an error that says what and where, and the session goes on.
#[test]
fn wrong_forms_are_refused() {
    let mesh = Mesh::new(3, &[[0, 1, 2]]).unwrap();
    let mut session = Session::new(&mesh, Options::default()).unwrap();
    let fine = [[0.0f32; 3]; 3];
    let bytes: [u8; 100] = [0; 100];
    let strided = |stride| Strided::<f32>::new(&bytes, stride);
    let why = session.step(&fine, &strided(8)).unwrap_err();
    assert_eq!(why.to_string(), "t1 has a stride of 8 bytes; a position takes 12");
    let why = session.step(&strided(44).offset(1), &fine).unwrap_err();
    assert_eq!(why, Error::VertexCount { time: 0, expected: 3, found: 2 });
    let why = session.step(&strided(44).offset(1).count(3), &fine).unwrap_err();
    assert_eq!(why, Error::Bytes { time: 0, vertex: 2, end: 101, found: 100 });
    assert_eq!(why.to_string(), "vertex 2 at t0 ends at byte 101, but there are 100 bytes");
    let why = session.step(&Posed::new(&fine, &[0, 0, 9], &[Mat4::IDENTITY]), &fine).unwrap_err();
    assert_eq!(why.to_string(), "vertex 2 at t0 is of body 9, but there are 1 matrices (0 to 0)");
    let few = session.step(&Posed::new(&fine, &[0, 0], &[Mat4::IDENTITY]), &fine).unwrap_err();
    assert_eq!(few, Error::BodyCount { expected: 3, found: 2 });
    let mut perspective = Mat4::IDENTITY;
    perspective.z_axis.w = -1.0;
    perspective.w_axis.w = 0.0;
    let why = session.step(&fine, &Posed::one(&fine, &perspective)).unwrap_err();
    let text = "the matrix of body 0 at t1 has the last row [0.0, 0.0, -1.0, 0.0]; \
        it must be 0, 0, 0, 1";
    assert_eq!(why.to_string(), text);
    let bad = Mat4::from_translation(Vec3::new(0.0, f32::NAN, 0.0));
    let why = session.step(&fine, &Posed::one(&fine, &bad)).unwrap_err();
    assert!(matches!(why, Error::Coordinate { time: 1, vertex: 0, axis: 1, .. }), "{why}");
    assert!(session.step(&strided(44), &strided(44)).unwrap().contacts.is_empty());
}

/// Calls that programs have are compiled, with their types inferred.
#[test]
fn calls_need_no_types() {
    let mesh = Arc::new(Mesh::new(3, &[[0, 1, 2]]).unwrap());
    let mut session = Session::new(mesh.clone(), Options::default()).unwrap();
    // The one end says that the other is `f32`.
    let plain = [[0.0, 0.5, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let mut single = vec![[0.0f32; 3]; 3];
    let none = |contacts: &[Contact]| assert!(contacts.is_empty());
    none(&session.step(&plain, &single).unwrap().contacts);
    none(&session.step(&plain[..], single.as_slice()).unwrap().contacts);
    none(&session.step(&[[0.0; 3]; 3], &vec![[1.0; 3]; 3]).unwrap().contacts);
    let (x0, x1): (&Vec<_>, &mut Vec<_>) = (&single.clone(), &mut single);
    none(&session.step(x0, x1).unwrap().contacts);
    none(&session.step(&x0, &&x1[..]).unwrap().contacts);
    none(&session.step(&Box::new(plain), &Cow::from(&x0[..])).unwrap().contacts);
    assert_eq!(ccd::earliest_toi(&mesh, &plain, x1, &Options::default()).unwrap(), None);
    none(&ccd::step(&mesh, &plain, &plain, &Options::default()).unwrap().contacts);

    // The mesh: given, shared, or copied; at hand while a report is.
    let report = session.step(&plain, &plain).unwrap();
    assert!(std::ptr::eq(report.mesh(), &*mesh));
    let kept = report.clone();
    drop(session);
    assert_eq!(kept.mesh().faces(), [[0, 1, 2]]);
    assert_eq!(ccd::Report::default().mesh().n_vertices(), 0);
    let copied = Session::new(&*mesh, Options::default()).unwrap();
    assert!(**copied.mesh() == *mesh && !Arc::ptr_eq(copied.mesh(), &mesh));
    let given = Session::new((*mesh).clone(), Options::default()).unwrap();
    assert_eq!(Arc::strong_count(given.mesh()), 1);
}
