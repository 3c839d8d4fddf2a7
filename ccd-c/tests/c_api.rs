//! Calls of the C API as C makes them, from Rust: answers of the facade, what is refused with which
//! status and message, and structs of other sizes. cargo builds the libraries for this test, where
//! `cargo xtask c-api` takes them from.

use ccd::{Kind, Options, Session};
use meshccd::bodies::*;
use meshccd::mesh::*;
use meshccd::moving::*;
use meshccd::options::*;
use meshccd::results::*;
use meshccd::session::*;
use meshccd::status::*;
use std::ffi::CStr;
use std::mem::MaybeUninit;
use std::ptr::{null, null_mut};
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::time::{Duration, Instant};

/// A square of two triangles, and a triangle that falls onto it with one corner first.
const FACES: [[u32; 3]; 3] = [[0, 1, 2], [2, 1, 3], [4, 5, 6]];
const BEFORE: [[f32; 3]; 7] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 0.0, 1.0],
    [1.0, 0.0, 1.0],
    [0.3, 0.5, 0.3],
    [0.2, 2.0, 0.3],
    [0.4, 2.0, 0.3],
];
const OK: CcdStatus = CcdStatus::Ok;

fn after() -> [[f32; 3]; 7] {
    BEFORE.map(|p| if p[1] > 0.0 { [p[0], p[1] - 1.0, p[2]] } else { p })
}

fn positions(x: &[[f32; 3]]) -> CcdPositions {
    let component = CcdComponent::F32 as u32;
    CcdPositions { data: x.as_ptr().cast(), stride: 0, count: x.len(), component }
}

fn message() -> String {
    // SAFETY: the message lives until another call fails on this thread.
    unsafe { CStr::from_ptr(ccd_last_error()) }.to_str().expect("UTF-8").to_owned()
}

#[track_caller]
fn check_refused(status: CcdStatus, want: CcdStatus, text: &str) {
    assert_eq!(status, want, "{}", message());
    assert_eq!(message(), text);
}

/// A mesh and a session of the tests, destroyed in the end.
struct Scene {
    mesh: *mut CcdMesh,
    session: *mut CcdSession,
}

impl Scene {
    fn new(bodies: *const CcdBodies, change: impl FnOnce(&mut CcdOptions)) -> Self {
        let (mut mesh, mut session) = (null_mut(), null_mut());
        let mut options = MaybeUninit::uninit();
        // SAFETY: arrays and outputs are those of this function.
        unsafe {
            assert_eq!(ccd_mesh_create(7, FACES.as_ptr().cast(), 3, 0, &mut mesh), OK);
            assert_eq!(ccd_options_default(options.as_mut_ptr(), size_of::<CcdOptions>()), OK);
            let mut options = options.assume_init();
            options.backend = CcdBackend::Cpu as u32;
            options.threads = 1;
            change(&mut options);
            let status = ccd_session_create(mesh, bodies, &options, &mut session);
            assert_eq!(status, OK, "{}", message());
        }
        Self { mesh, session }
    }

    fn step(&self, x0: CcdPositions, x1: CcdPositions) -> Result<&CcdReport, CcdStatus> {
        let mut report = null();
        // SAFETY: positions are arrays of the tests, the report is used before the next call.
        match unsafe { ccd_session_step(self.session, x0, x1, &mut report) } {
            OK => Ok(unsafe { &*report }),
            status => {
                assert!(report.is_null());
                Err(status)
            }
        }
    }
}

impl Drop for Scene {
    fn drop(&mut self) {
        // SAFETY: both came from the functions that make them. The mesh goes first: it is shared.
        unsafe {
            ccd_mesh_destroy(Some(Box::from_raw(self.mesh)));
            ccd_session_destroy(Some(Box::from_raw(self.session)));
        }
    }
}

fn contacts(report: &CcdReport) -> &[CcdContact] {
    // SAFETY: both are of one report.
    unsafe { std::slice::from_raw_parts(report.contacts, report.contact_count) }
}

#[test]
fn answers_are_those_of_the_facade() {
    let mesh = ccd::Mesh::new(7, &FACES).unwrap();
    let mut session = Session::new(mesh.clone(), Options::default().with_threads(1)).unwrap();
    let want = session.step(&BEFORE, &after()).unwrap().clone();
    let scene = Scene::new(null(), |_| {});
    let report = scene.step(positions(&BEFORE), positions(&after())).unwrap();
    assert_eq!(contacts(report).len(), want.contacts.len());
    assert!(want.contacts.iter().any(|c| c.kind == Kind::VertexFace));
    for (have, want) in contacts(report).iter().zip(&want.contacts) {
        let ids = (CcdKind::from(want.kind), want.a, want.b, want.vertices(&mesh));
        assert_eq!((have.kind, have.a, have.b, have.vertices), ids);
        assert_eq!((have.toi, have.state), (want.toi, CcdState::from(want.state)));
    }
    assert_eq!((Some(report.toi), report.undecided_count), (want.toi, want.undecided));
    assert_eq!(report.candidates.vertex_face, want.candidates.vf);

    let end = after();
    let (x0, x1) = (positions(&BEFORE), positions(&end));
    let (mut geometry, mut n, mut hit, mut toi) = (null(), 0, null(), 0.0);
    // SAFETY: as above.
    unsafe {
        let status = ccd_session_contact_geometry(scene.session, x0, x1, &mut geometry, &mut n);
        assert_eq!((status, n), (OK, want.contacts.len()));
        let at = want.contacts[0].geometry(&mesh, &BEFORE, &after());
        assert_eq!(((*geometry).point, (*geometry).weights), (at.point, at.weights));
        assert_eq!(ccd_session_first_contact(scene.session, x0, x1, &mut hit), OK);
        let first = session.first_contact(&BEFORE, &after()).unwrap().expect("a contact");
        let [a, b] = first.features;
        let contact = (*hit).contact;
        let have = (contact.kind, contact.a, contact.b, contact.toi);
        assert_eq!(have, (CcdKind::from(first.kind), a, b, first.toi));
        let have = ((*hit).geometry.point, (*hit).geometry.normal, (*hit).geometry.weights);
        assert_eq!(have, (first.point, first.normal, first.weights));
        assert_eq!(ccd_session_earliest_toi(scene.session, x0, x1, &mut toi), OK);
        assert_eq!(Some(toi), session.earliest_toi(&BEFORE, &after()).unwrap());
        assert_eq!(ccd_session_earliest_toi(scene.session, x0, x0, &mut toi), OK);
        assert_eq!(toi, f64::INFINITY);
        assert_eq!(ccd_session_first_contact(scene.session, x0, x0, &mut hit), OK);
        assert!(hit.is_null());
    }
}

#[test]
fn strides_and_components_say_the_same() {
    let scene = Scene::new(null(), |options| options.mode = CcdMode::Exact as u32);
    let found = |x: [CcdPositions; 2]| -> Vec<(u32, u32, u64)> {
        let report = scene.step(x[0], x[1]).unwrap();
        contacts(report).iter().map(|c| (c.a, c.b, c.toi.to_bits())).collect()
    };
    let want = found([positions(&BEFORE), positions(&after())]);
    assert!(!want.is_empty());
    let wide = [BEFORE, after()].map(|x| x.map(|p| p.map(f64::from)));
    let (component, count) = (CcdComponent::F64 as u32, 7);
    let at = |x: &[[f64; 3]; 7]| x.as_ptr().cast();
    let wide = wide.each_ref().map(|x| CcdPositions { data: at(x), stride: 24, count, component });
    assert_eq!(found(wide), want);
    // One byte before each position, which so is aligned for nothing.
    let odd = [BEFORE, after()].map(|x| {
        let bytes = x.iter().flat_map(|p| [[p[0]; 1], [p[1]; 1], [p[2]; 1]].concat());
        let bytes: Vec<u8> = bytes.flat_map(f32::to_ne_bytes).collect();
        bytes.chunks(12).flat_map(|p| [&[0xff], p].concat()).collect::<Vec<u8>>()
    });
    let component = CcdComponent::F32 as u32;
    let odd = odd.each_ref().map(|bytes| {
        let data = bytes[1..].as_ptr().cast();
        CcdPositions { data, stride: 13, count, component }
    });
    assert_eq!(found(odd), want);
}

#[test]
fn what_is_wrong_is_refused() {
    use CcdStatus::{InvalidArgument, InvalidInput};
    let (x0, x1) = (BEFORE, after());
    let (x0, x1) = (positions(&x0), positions(&x1));
    let scene = Scene::new(null(), |_| {});
    let refused = |x0, x1| scene.step(x0, x1).map(|_| ()).unwrap_err();
    let argument = |status, text: &str| check_refused(status, InvalidArgument, text);
    argument(refused(CcdPositions { data: null(), ..x0 }, x1), "x0.data is NULL");
    let mixed = refused(x0, CcdPositions { component: 1, ..x1 });
    argument(mixed, "x0 and x1 have different components");
    let neither = CcdPositions { component: 2, ..x0 };
    argument(refused(neither, neither), "component is 2; it must be a CcdComponent");
    let huge = CcdPositions { count: usize::MAX / 4, ..x0 };
    assert_eq!(refused(huge, x1), InvalidArgument);
    let few = refused(x0, CcdPositions { count: 6, ..x1 });
    check_refused(few, InvalidInput, "t1 has 6 vertices, the mesh has 7");
    let short = refused(CcdPositions { stride: 8, ..x0 }, x1);
    check_refused(short, InvalidInput, "t0 has a stride of 8 bytes; a position takes 12");
    let mut nan = BEFORE;
    nan[2][1] = f32::NAN;
    let text = "vertex 2 at t0 has y = NaN; coordinates must be finite and at most 1e100";
    check_refused(refused(positions(&nan), x1), InvalidInput, text);
    assert!(scene.step(x0, x1).is_ok(), "the session stays usable");

    let (mut mesh, mut session) = (null_mut(), null_mut());
    // SAFETY: pointers are NULL or of this function.
    unsafe {
        argument(ccd_session_step(null_mut(), x0, x1, null_mut()), "session is NULL");
        argument(ccd_session_earliest_toi(scene.session, x0, x1, null_mut()), "toi is NULL");
        argument(ccd_mesh_create(3, null(), 1, 0, &mut mesh), "triangles is NULL");
        argument(ccd_mesh_create(3, null(), 0, 0, null_mut()), "mesh is NULL");
        let status = ccd_mesh_create(3, FACES.as_ptr().cast(), 3, 0, &mut mesh);
        let text = "face 1 refers to vertex 3, but there are 3 vertices (0 to 2)";
        check_refused(status, InvalidInput, text);
        assert!(mesh.is_null());
        assert_eq!((ccd_mesh_vertex_count(null()), ccd_mesh_edges(null()).count), (0, 0));
        argument(ccd_session_create(null(), null(), null(), &mut session), "mesh is NULL");
        ccd_mesh_destroy(None);
        ccd_bodies_destroy(None);
        ccd_session_destroy(None);
    }
}

/// Also where no session is found, or another call has it.
#[test]
fn outputs_are_nothing_after_a_failure() {
    let none = null_mut();
    let (mut toi, mut count, mut place) = (0.25, 7, c"stale".as_ptr());
    let (mut geometry, mut report) = (std::ptr::dangling(), std::ptr::dangling());
    let (end, invalid) = (after(), CcdStatus::InvalidArgument);
    let (x0, x1) = (positions(&BEFORE), positions(&end));
    // SAFETY: outputs are variables of this function; the session is NULL.
    unsafe {
        assert_eq!(ccd_session_earliest_toi_of_bodies(none, null(), 0, &mut toi), invalid);
        assert_eq!(ccd_session_step_bodies(none, null(), 0, &mut report), invalid);
        assert_eq!(ccd_session_place(none, &mut place), invalid);
        let status = ccd_session_contact_geometry(none, x0, x1, &mut geometry, &mut count);
        assert_eq!(status, invalid);
    }
    assert!(toi == 0.0 && count == 0 && place.is_null() && geometry.is_null() && report.is_null());
}

#[test]
fn options_of_other_sizes() {
    let size = size_of::<CcdOptions>();
    let scene = Scene::new(null(), |_| {});
    // What a later header would have: more bytes at the end.
    let mut long = [0u64; 64];
    let options = long.as_mut_ptr().cast::<CcdOptions>();
    let mut session = null_mut();
    // SAFETY: there are 512 bytes.
    unsafe {
        assert_eq!(ccd_options_default(options, 512), OK);
        assert_eq!(((*options).size, (*options).tolerance), (512, 1e-6));
        assert_eq!(ccd_session_create(scene.mesh, null(), options, &mut session), OK);
        ccd_session_destroy(Some(Box::from_raw(session)));
        (*options).backend = 9;
        let status = ccd_session_create(scene.mesh, null(), options, &mut session);
        check_refused(status, CcdStatus::InvalidArgument, "backend is 9; it must be a CcdBackend");
        (*options).backend = 0;
        (*options).adapter = c"no such adapter".as_ptr();
        let status = ccd_session_create(scene.mesh, null(), options, &mut session);
        let want = if cfg!(feature = "gpu") { CcdStatus::NoGpu } else { OK };
        assert_eq!((status, session.is_null()), (want, cfg!(feature = "gpu")), "{}", message());
        ccd_session_destroy((!session.is_null()).then(|| Box::from_raw(session)));
        (*options).adapter = null();
        (*options).tolerance = f64::NAN;
        let status = ccd_session_create(scene.mesh, null(), options, &mut session);
        check_refused(
            status,
            CcdStatus::InvalidInput,
            "tolerance is NaN; it must be from 1e-12 to 1",
        );
        // A field that only a later library knows.
        options.cast::<u64>().add(63).write(1);
        let status = ccd_session_create(scene.mesh, null(), options, &mut session);
        assert_eq!((status, session), (CcdStatus::InvalidArgument, null_mut()));
        for wrong in [0, size - 1, usize::MAX] {
            let status = ccd_options_default(options, wrong);
            assert_eq!(status, CcdStatus::InvalidArgument, "{wrong}");
        }
    }
}

#[test]
fn bodies_move_alone() {
    let mut bodies = null_mut();
    let of_vertex = [0u32, 0, 0, 0, 5, 5, 5];
    // SAFETY: arrays and outputs are those of this function.
    unsafe {
        assert_eq!(ccd_bodies_create(of_vertex.as_ptr(), 7, &mut bodies), OK);
        assert_eq!(ccd_bodies_set_fixed(bodies, 0, 1), OK);
        assert_eq!(ccd_bodies_set_self_contacts(bodies, 0), OK);
        let scene = Scene::new(bodies, |_| {});
        let (x0, x1) = (positions(&BEFORE[4..]), after());
        let motion = CcdBodyMotion { body: 5, x0, x1: positions(&x1[4..]) };
        let (mut toi, mut hit) = (0.0, null());
        let early = ccd_session_earliest_toi_of_bodies(scene.session, &motion, 1, &mut toi);
        let text = "there are no positions yet: call `set_positions` before bodies move";
        check_refused(early, CcdStatus::InvalidInput, text);
        assert_eq!(ccd_session_set_positions(scene.session, positions(&BEFORE)), OK);
        let status = ccd_session_first_contact_of_bodies(scene.session, &motion, 1, &mut hit);
        assert_eq!((status, (*hit).bodies), (OK, [5, 0]));
        assert!((*hit).contact.toi <= 0.5 && (*hit).contact.toi > 0.5 - 1e-5);
        // Without the pair of bodies nothing is left.
        let pair = CcdPair { a: 0, b: 5 };
        assert_eq!(ccd_bodies_exclude_bodies(bodies, &pair, 1), OK);
        assert_eq!(ccd_session_set_bodies(scene.session, bodies), OK);
        let report = scene.step(positions(&BEFORE), positions(&after())).unwrap();
        assert_eq!(report.contact_count, 0);
        let status = ccd_bodies_exclude_features(bodies, 4, &pair, 1);
        check_refused(status, CcdStatus::InvalidArgument, "kind is 4; it must be a CcdKind");
        ccd_bodies_destroy(Some(Box::from_raw(bodies)));
    }
}

#[test]
fn a_cancelled_session_resumes() {
    let scene = Scene::new(null(), |_| {});
    let step = || scene.step(positions(&BEFORE), positions(&after())).map(|of| of.contact_count);
    let want = step();
    // SAFETY: the session lives.
    unsafe {
        assert_eq!(ccd_session_cancel(scene.session), OK);
        assert_eq!(step(), Err(CcdStatus::Cancelled));
        assert_eq!(ccd_session_resume(scene.session), OK);
    }
    assert_eq!(step(), want);
}

#[test]
fn two_calls_at_a_time_are_refused() {
    let scene = Scene::new(null(), |_| {});
    let end = after();
    let (x0, x1) = (positions(&BEFORE), positions(&end));
    // As another thread of C has it.
    let session = scene.session as usize;
    let begun = Instant::now();
    let seen = AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(|| {
            let mut place = null();
            while !seen.load(Relaxed) && begun.elapsed() < Duration::from_secs(60) {
                // SAFETY: the session lives until the scope ends; nothing is read by `place`.
                let status = unsafe { ccd_session_place(session as *mut CcdSession, &mut place) };
                if status == CcdStatus::Busy {
                    assert_eq!(message(), "another call uses this session at the moment");
                    seen.store(true, Relaxed);
                }
            }
        });
        while !seen.load(Relaxed) && begun.elapsed() < Duration::from_secs(60) {
            // SAFETY: positions are arrays of this function.
            let status = unsafe { ccd_session_step(scene.session, x0, x1, null_mut()) };
            if status == CcdStatus::Busy {
                seen.store(true, Relaxed);
            }
        }
    });
    assert!(seen.into_inner(), "a minute of calls, none at the same time");
}

#[test]
fn a_panic_is_a_status() {
    let status = guard(|| panic!("what is {}", "wrong"));
    check_refused(status, CcdStatus::Panicked, "a defect of the library: what is wrong");
    assert_eq!(guard_value(7, || panic!("again")), 7);
}
