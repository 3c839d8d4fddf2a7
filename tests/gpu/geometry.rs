//! Point, normal and weights of contacts on a device: the kernels against the same bodies here, and
//! sessions against `Contact::geometry`.

use crate::support::{
    TINY, bytes, elements_of, paths, read, read_back, rounds_like_a_cpu, run, same, zeros,
};
use ccd::gpu::bind::{Bind, ContactGeometry, ContactGeometryWide};
use ccd::gpu::{Device, Error, Session};
use ccd::{Contact, Coordinate, Mesh, Options};
use ccd_core::backend::layout::{
    Dispatch, Frame, LIST_HEADER, Params, Path, Placing, Plain, TOUCH_WORDS, Touch, TouchGeometry,
    split,
};
use ccd_core::narrow_phase::touch_geometry;
use ccd_testkit::generate::{Random, triangle_soup};

pub const TESTS: crate::Tests =
    &[("geometry_kernels", check_kernels), ("geometry_of_sessions", check_sessions)];

/// Unit normal, weights in the patch.
fn check_sound(g: &TouchGeometry, vertex_face: bool) {
    let length = g.normal.iter().map(|c| c * c).sum::<f32>().sqrt();
    assert!((length - 1.0).abs() < 1e-5, "{g:?}");
    assert!(g.weights.iter().all(|w| (0.0..=1.0).contains(w)), "{g:?}");
    let first = if vertex_face { 1 } else { 2 };
    for side in [&g.weights[..first], &g.weights[first..]] {
        assert!((side.iter().sum::<f32>() - 1.0).abs() < 1e-6, "{g:?}");
    }
}

fn apart<const N: usize>(a: [f32; N], b: [f32; N]) -> f32 {
    (0..N).fold(0.0, |m, k| m.max((a[k] - b[k]).abs()))
}

/// The same numbers, or near ones: positions are about 1, times anywhere.
fn check_near(got: &TouchGeometry, want: &TouchGeometry, exact: bool) {
    assert_eq!((got.vertices, got.state), (want.vertices, want.state));
    let words = |g: &TouchGeometry| -> [u32; 12] {
        bytemuck::cast_slice(bytemuck::bytes_of(g))[..12].try_into().unwrap()
    };
    let is_same = |(a, b)| same(f32::from_bits(a), f32::from_bits(b));
    let equal = words(got).into_iter().zip(words(want)).all(is_same);
    if exact {
        return assert!(equal, "{got:?}, not {want:?}");
    }
    let far = (got.distance - want.distance).abs() > 1e-4
        || apart(got.point, want.point) > 1e-3
        || apart(got.weights, want.weights) > 1e-3
        || want.distance > 1e-2 && apart(got.normal, want.normal) > 1e-3;
    assert!(!far, "{got:?}, not {want:?}");
}

/// Contacts of random features at random times, of scenes and of what is degenerate, tiny and huge.
/// The list wants more entries than its capacity; nothing is written behind that.
fn check_kernels(device: &Device) {
    for poison in [false, true] {
        let step = triangle_soup(80, 0.4, 3);
        let mesh = &step.mesh;
        let mut paths = paths(&step, false);
        let mut random = Random::new(8);
        if poison {
            let values = [0.0, 0.0, 1e-45, -1e-40, TINY, 1.0, -1.0, 1e30, -1e38];
            let mut pick = || values[random.below(9) as usize];
            for p in paths.iter_mut().step_by(2) {
                *p = Path { t0: [pick(), pick(), pick(), 0.0], t1: [pick(), pick(), pick(), 0.0] };
            }
        }
        let (capacity, wanted) = (700usize, 1000u32);
        let (n_e, n_f) = (mesh.edges().len() as u32, mesh.faces().len() as u32);
        let counts = [[mesh.n_vertices() as u32, n_f], [n_e; 2]];
        let mut touch = |i: u32| {
            let [a, b] = counts[i as usize % 2].map(|n| random.below(n));
            let toi = [0.0, 1.0, random.unit()][random.below(3) as usize];
            Touch { kind: i % 2, state: i % 3 / 2, a, b, toi: split(toi), approach: 0 }
        };
        let touches: Vec<Touch> = (0..wanted).map(&mut touch).collect();
        let mut contacts = bytes(&[wanted, 0, 0, 0]);
        contacts.extend(bytes(&touches[..capacity]));
        let list: Vec<u32> = read(&contacts);
        // In two parts, of which the second may take more than there is.
        let part = |(first, n)| Dispatch { n, first, capacity_in: 700, capacity_out: 0 };
        let dispatch = [(0, 300), (300, 700)].map(part);
        let n = mesh.n_vertices() as u32;
        let frame = Frame { count: [n, n_e, n_f], flags: Frame::FLAG_EXACT, ..Frame::default() };
        let (elements, touches) = (elements_of(mesh), &touches[..capacity]);
        let args = Placing { origin: [0.5, -2.0, 0.0], unit: 0.25 };
        let p = dispatch.map(|dispatch| Params { frame, dispatch, args });
        let kernel = ContactGeometry {
            paths: bytes(&paths),
            elements: bytes(&elements),
            contacts: contacts.clone(),
            geometry: zeros::<TouchGeometry>(capacity + 64),
        };
        check_kernel(device, kernel, p, touches, poison, |i| {
            touch_geometry::narrow(i, &p[0], &paths, &elements, &list)
        });
        if device.info().wide {
            let p = dispatch.map(|dispatch| Params { frame, dispatch, args: Plain::default() });
            let kernel = ContactGeometryWide {
                paths: bytes(&paths),
                positions: bytes(&[[0.0f64; 3]]),
                elements: bytes(&elements),
                contacts,
                geometry: zeros::<TouchGeometry>(capacity + 64),
            };
            check_kernel(device, kernel, p, touches, poison, |i| {
                touch_geometry::wide(i, &p[0], &paths, &[], &elements, &list)
            });
        }
    }
}

/// A kernel over both parts; `want`: its body here. Of the first part nothing is written beyond its
/// last record.
fn check_kernel<K: Bind<Vec<u8>>>(
    device: &Device,
    kernel: K,
    p: [Params<K::Args>; 2],
    touches: &[Touch],
    poison: bool,
    want: impl Fn(u32) -> TouchGeometry,
) {
    let geometry = |kernel: &K| kernel.buffers().pop().expect("the last buffer").clone();
    let kernel = run(device, kernel, &p[0], 5);
    let first = geometry(&kernel);
    let (within, beyond) = first.split_at(300 * size_of::<TouchGeometry>());
    assert!(within.iter().any(|&b| b != 0) && beyond.iter().all(|&b| b == 0));
    let got: Vec<TouchGeometry> = read(&geometry(&run(device, kernel, &p[1], 5)));
    let exact = rounds_like_a_cpu(device);
    for (i, touch) in touches.iter().enumerate() {
        check_sound(&got[i], touch.kind == 0);
        if !poison {
            check_near(&got[i], &want(i as u32), exact);
        }
    }
    let behind = &got[touches.len()..];
    assert!(behind.iter().all(|g| *g == TouchGeometry::default()), "written beyond the capacity");
}

/// What the device has of the last step or frame: contacts, and their geometry.
fn geometry(
    device: &Device,
    session: &mut Session,
    record: bool,
) -> (Vec<Touch>, Vec<TouchGeometry>) {
    let mut encoder = device.wgpu().create_command_encoder(&Default::default());
    if record {
        session.record(&mut encoder).unwrap();
    }
    let found = session.record_geometry(&mut encoder).unwrap();
    let (contacts, geometry) = (found.contacts.clone(), found.geometry.clone());
    let sources = [(contacts.buffer(), contacts.bytes(u32::MAX)), (&geometry, geometry.size())];
    let words = read_back(device, encoder, &sources);
    let n = words[0][0] as usize;
    let touches = read(&bytes(&words[0][LIST_HEADER..LIST_HEADER + TOUCH_WORDS * n]));
    (touches, read(&bytes(&words[1][..16 * n])))
}

fn check_session<T: Coordinate>(
    device: &Device,
    mesh: &Mesh,
    x0: &[[T; 3]],
    x1: &[[T; 3]],
    unit: f32,
    record: bool,
) {
    let mut session = Session::new(device, mesh.clone(), Options::default()).unwrap();
    let mut encoder = device.wgpu().create_command_encoder(&Default::default());
    let mut check_refused = |session: &mut Session| {
        let refused = session.record_geometry(&mut encoder).map(|_| ());
        assert!(matches!(refused, Err(Error::NoContacts)), "{refused:?}");
    };
    check_refused(&mut session);
    let n = session.step(x0, x1).unwrap().contacts.len();
    let (touches, records) = geometry(device, &mut session, record);
    let wide = device.info().wide;
    assert!(n > 100 && (!wide || touches.len() == n), "{} of {n} contacts", touches.len());
    let mut n_turned = 0;
    for (touch, got) in touches.iter().zip(&records) {
        let contact = Contact::from(touch);
        let want = contact.geometry(mesh, x0, x1);
        assert_eq!(got.vertices, contact.vertices(mesh));
        check_sound(got, touch.kind == 0);
        let narrow = |v: [f64; 3]| v.map(|c| c as f32);
        let close = if wide { 1e-6 } else { 1e-4 };
        assert!(apart(got.point, narrow(want.point)) <= close * unit, "{got:?}, not {want:?}");
        // In f32 the distance is rounding, in f64 it is not: another of the rules holds near sides.
        n_turned += usize::from(apart(got.normal, narrow(want.normal)) > 1e-3);
        assert!(!wide || apart(got.normal, narrow(want.normal)) < 1e-6, "{got:?}, not {want:?}");
    }
    assert!(n_turned <= touches.len() / 20, "{n_turned} of {} normals", touches.len());
    // No list of contacts is left.
    session.earliest_toi(x0, x1).unwrap();
    check_refused(&mut session);
    // Nor one of this mesh after another is there.
    session.step(x0, x1).unwrap();
    session.set_mesh(mesh).unwrap();
    check_refused(&mut session);
}

fn check_sessions(device: &Device) {
    let step = triangle_soup(150, 0.3, 5);
    let [x0, x1] = step.rounded();
    for record in [false, true] {
        check_session(device, &step.mesh, &x0, &x1, 1.0, record);
    }
    // Not exact in f32, somewhere else, in a unit in which f32 has no such numbers.
    for (scale, from) in [(1.0, 0.0), (1.0, 0.1), (2f64.powi(100), 3.0)] {
        let at = |x: &[[f64; 3]]| -> Vec<[f64; 3]> {
            x.iter().map(|p| p.map(|c| (c + from) * scale)).collect()
        };
        check_session(device, &step.mesh, &at(&step.x0), &at(&step.x1), scale as f32 * 4.0, false);
    }
}
