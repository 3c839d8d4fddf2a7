//! What a caller sees when something is too short, too large, missing, or lost; and that a session
//! goes on afterwards.

use crate::emulated::{is_thin, methods};
use crate::scenes::check_pairs;
use crate::support::{bytes, list, not_run, read, read_back, run};
use ccd::gpu::bind::{Decide, DecideIntegers};
use ccd::gpu::harness::{Faults, set_faults};
use ccd::gpu::{BroadPhase, Device, DeviceOptions, Error, Session};
use ccd::method::{BroadPhaseMethod, Pipeline, TriangleOptions};
use ccd::{Mode, Options, Pair};
use ccd_core::backend::layout::elements::with_kind;
use ccd_core::backend::layout::{
    Decision, Dispatch, Frame, IntegerDecision, LIST_HEADER, Params, Path, TOUCH_WORDS,
};
use ccd_core::narrow_phase::integer_search::Window;
use ccd_core::narrow_phase::search::Search;
use ccd_testkit::generate::{crumpled_sheet, uniform_boxes};

pub const TESTS: crate::Tests = &[
    ("lists_grow", check_growth),
    ("candidates_in_parts", check_parts),
    ("capacities", check_capacities),
    ("bad_input", check_input),
    ("too_large", check_too_large),
    ("no_adapter", check_no_adapter),
    ("lost_device", check_lost),
    ("recorded_by_the_caller", check_recorded),
    ("recorded_after_a_step_made_room", check_room_of_recorded),
    ("one_time_whoever_decides", check_time_of_open),
    ("memory_of_open_pairs", check_memory_of_open),
    ("empty_mesh", check_empty),
    ("unlike_sizes", check_unlike),
];

/// Lists far too short, of every method and pipeline: the frame runs again until everything fits,
/// and nothing is missing; the next one finds them long enough. An emulated GPU has the pipelines
/// in turn.
fn check_growth(device: &Device) {
    let step = crumpled_sheet(24, 7);
    let triangles = Pipeline::Triangles(TriangleOptions::default());
    let both = [(Pipeline::Features, 1), (triangles, 2)];
    let all = methods(device).enumerate().flat_map(|(k, method)| {
        let chosen = if is_thin(device) { &both[k % 2..][..1] } else { &both };
        chosen.iter().map(move |&(pipeline, least)| (pipeline, least, method))
    });
    for (pipeline, least, method) in all {
        let options = Options::default().with_pipeline(pipeline);
        let want = ccd::step(&step.mesh, &step.x0, &step.x1, &options).unwrap();
        let what = format!("{method}, {pipeline:?}");
        let options = options.with_broad_phase(method);
        let mut session = Session::new(device, step.mesh.clone(), options).unwrap();
        session.reserve(8).unwrap();
        let got = session.step(&step.x0, &step.x1).unwrap().clone();
        let grown = session.grown();
        assert!(grown >= least, "{what}: few lists had to grow");
        assert_eq!((got.candidates, got.triangles), (want.candidates, want.triangles), "{what}");
        assert_eq!(got.contacts.len(), want.contacts.len(), "{what}");
        session.step(&step.x0, &step.x1).unwrap();
        assert_eq!(session.grown(), grown, "{what}: the second frame grows again");
        let found = session.candidates(&step.x0, &step.x1).unwrap();
        let [n_vf, n_ee] = [found.vf.len() as u64, found.ee.len() as u64];
        assert_eq!([n_vf, n_ee], [want.candidates.vf, want.candidates.ee], "{what}");
    }
}

/// More candidates than a list may have are listed and filtered in parts: the answers are those of
/// one, and the next step makes no part smaller.
fn check_parts(device: &Device) {
    let step = crumpled_sheet(20, 7);
    let want = ccd::step(&step.mesh, &step.x0, &step.x1, &Options::default()).unwrap();
    for method in [BroadPhaseMethod::Blocks, BroadPhaseMethod::TREE] {
        let options = Options::default().with_broad_phase(method);
        let new = || Session::new(device, step.mesh.clone(), options.clone()).unwrap();
        let one = new().step(&step.x0, &step.x1).unwrap().clone();
        let toi = new().earliest_toi(&step.x0, &step.x1).unwrap();
        assert_eq!(one.candidates, want.candidates);
        for part in [3, 9] {
            let most_candidates = (want.candidates.ee / part) as u32;
            let old = set_faults(device, Faults { most_candidates, ..Faults::default() });
            let mut session = new();
            session.reserve(8).unwrap();
            let got = session.step(&step.x0, &step.x1).unwrap().clone();
            let grown = session.grown();
            assert!(grown > 1, "{method}: a part was not made smaller");
            assert_eq!((got.candidates, got.filtered), (one.candidates, one.filtered), "{method}");
            assert!(got.contacts == one.contacts && !got.contacts.is_empty(), "{method}");
            assert_eq!(session.earliest_toi(&step.x0, &step.x1).unwrap(), toi, "{method}");
            let again = session.step(&step.x0, &step.x1).unwrap();
            assert!(again.contacts == one.contacts && again.candidates == one.candidates);
            assert_eq!(session.grown(), grown, "{method}: parts are made smaller again");
            // The list of all is not in parts.
            let found = session.candidates(&step.x0, &step.x1).unwrap();
            assert_eq!(found.ee.len() as u64, want.candidates.ee);
            set_faults(device, old);
            // There is room for all now, and two steps are one part again.
            for _ in 0..2 {
                let again = session.step(&step.x0, &step.x1).unwrap();
                assert!(again.contacts == one.contacts && again.candidates == one.candidates);
            }
        }
    }
}

/// Pairs that are left to another decision beyond the capacity of their list, and contacts beyond
/// that of theirs, are counted and not written.
fn check_capacities(device: &Device) {
    // All vertices are one point: no arithmetic decides that.
    let (n, few) = (200u32, 10u32);
    let paths = bytes(&[Path { t0: [0.0; 4], t1: [0.0; 4] }; 8]);
    for (kind, integers) in [(0, false), (1, false), (0, true), (1, true)] {
        let pair = |i| with_kind(kind, Pair { a: i % 2, b: i % 2 });
        let pairs: Vec<Pair> = (0..n).map(pair).collect();
        let frame = Frame { flags: Frame::FLAG_KEEP, ..Frame::default() };
        let frame = frame.searching(&Search::whole(0.0));
        let words_of_one = if integers { 2 } else { TOUCH_WORDS };
        let mut open = vec![0u8; 4 * (LIST_HEADER + words_of_one * n as usize)];
        // In two parts, of which the second may take more than there is.
        for (first, most, sum) in [(0, 150, 150), (150, n, n)] {
            let dispatch = Dispatch { n: most, first, capacity_in: n, capacity_out: few };
            let (paths, input, earliest) = (paths.clone(), list(&pairs), vec![0xff; 16]);
            let elements =
                bytes(if kind == 0 { &[1u32, 2, 3, 4, 5, 6][..] } else { &[0, 1, 2, 3] });
            open = if integers {
                let window = Window::of(&Search::whole(0.0)).unwrap();
                let args = IntegerDecision::new(Decision { capacity_left: few }, window);
                let (positions, left, contacts) = (bytes(&[0u32]), open, vec![0u8; 256]);
                let kernel =
                    DecideIntegers { paths, positions, elements, input, contacts, left, earliest };
                run(device, kernel, &Params { frame, dispatch, args }, 3).left
            } else {
                let contacts = open;
                let kernel = Decide { paths, elements, input, contacts, earliest };
                let p = Params { frame, dispatch, ..Params::default() };
                run(device, kernel, &p, 3).contacts
            };
            assert_eq!(read::<u32>(&open)[0], sum, "pairs of this part and those before");
        }
        let words: Vec<u32> = read(&open);
        let (within, beyond) = words[LIST_HEADER..].split_at(words_of_one * few as usize);
        assert!(within.iter().any(|&w| w != 0), "nothing is written");
        assert!(beyond.iter().all(|&w| w == 0), "written beyond the capacity: {beyond:?}");
    }
}

/// A coordinate that is none is found on the way to the device; what else is refused is refused
/// before, as on a CPU.
fn check_input(device: &Device) {
    let step = crumpled_sheet(8, 1);
    let mut session = Session::new(device, step.mesh.clone(), Options::default()).unwrap();
    let mut bad = step.x1.clone();
    bad[5][1] = f64::NAN;
    let error = session.step(&step.x0, &bad).unwrap_err();
    assert!(
        matches!(error, Error::Input(ccd::Error::Coordinate { time: 1, vertex: 5, axis: 1, .. })),
        "{error}"
    );
    let found = session.step(&step.x0, &step.x1).unwrap();
    assert!(!found.contacts.is_empty(), "the session does not go on");
}

/// More boxes than one binding of the device holds: refused with the sizes, and the next call
/// works.
fn check_too_large(device: &Device) {
    let limit = device.info().limits.max_storage_buffer_binding_size;
    let n = limit / 24 + 1000;
    if n > 20_000_000 {
        return not_run(format!("{n} boxes fit"));
    }
    let mut broad = BroadPhase::new(device, BroadPhaseMethod::Blocks).unwrap();
    let boxes = vec![ccd::Aabb::of_point([0.0f32; 3]); n as usize];
    match broad.self_pairs(&boxes) {
        Err(Error::TooLarge { bytes, limit: named, .. }) => {
            assert!(bytes > named && named <= limit, "{bytes} {named}")
        }
        Err(other) => panic!("{other}"),
        Ok(_) => panic!("{n} boxes were accepted"),
    }
    let boxes = &uniform_boxes(100_000)[..50_000];
    let mut cpu = ccd::BroadPhase::new(1, BroadPhaseMethod::Blocks).unwrap();
    let want = cpu.self_pairs(boxes).unwrap().len();
    assert_eq!(broad.self_pairs(boxes).unwrap().len(), want);
    // What is refused leaves the boxes of the call before, many or few.
    for boxes in [boxes, &boxes[..500]] {
        let want = broad.self_pairs(boxes).unwrap().len();
        let mut bad = vec![ccd::Aabb::of_point([0.5f32; 3]); boxes.len()];
        bad[boxes.len() - 9].min[1] = f32::NAN;
        let error = broad.self_pairs(&bad).unwrap_err();
        let at = boxes.len() - 9;
        assert!(
            matches!(error, Error::Input(ccd::Error::Box { at: named, axis: 1, .. }) if named == at)
        );
        assert_eq!(broad.again().unwrap() as usize, want);
    }
}

fn check_no_adapter(_: &Device) {
    let options =
        DeviceOptions { adapter: Some("no such adapter".into()), ..DeviceOptions::default() };
    match Device::open(&options) {
        Err(Error::Unavailable { why }) => {
            assert!(why.contains("no such adapter") && why.contains("there are"), "{why}")
        }
        other => panic!("{other:?}"),
    }
}

/// After its device is lost a session says so, and goes on with another.
fn check_lost(device: &Device) {
    let info = device.info();
    let (path, narrow, integers) = (Some(info.path), !info.wide, Some(info.integers));
    let options = DeviceOptions { path, narrow, integers, ..DeviceOptions::default() };
    let other = Device::open(&options).unwrap();
    let step = crumpled_sheet(10, 1);
    let mut session = Session::new(&other, step.mesh.clone(), Options::default()).unwrap();
    let want = session.step(&step.x0, &step.x1).unwrap().contacts.clone();
    other.wgpu().destroy();
    let _ = other.wgpu().poll(ccd::gpu::wgpu::PollType::Poll);
    let error = session.step(&step.x0, &step.x1).unwrap_err();
    assert!(matches!(error, Error::Lost { .. }), "{error}");
    assert!(matches!(session.step(&step.x0, &step.x1), Err(Error::Lost { .. })), "the second time");
    assert!(other.is_lost() && !device.is_lost());
    session.move_to(device).unwrap();
    assert_eq!(session.step(&step.x0, &step.x1).unwrap().contacts, want);
}

/// A frame in an encoder of the caller's, from positions that are on the device already.
fn check_recorded(device: &Device) {
    let step = crumpled_sheet(16, 2);
    let [x0, x1] = step.rounded();
    let mut session = Session::new(device, step.mesh.clone(), Options::default()).unwrap();
    let want = session.step(&x0, &x1).unwrap().contacts.len();
    let n_found = |session: &mut Session| {
        let mut encoder = device.wgpu().create_command_encoder(&Default::default());
        let contacts = session.record(&mut encoder).unwrap().contacts.clone();
        read_back(device, encoder, &[(contacts.buffer(), 4)])[0][0] as usize
    };
    // What was uploaded last is still there. Without `f64` some pairs stay open.
    let n = n_found(&mut session);
    assert!(n == want || n > want && device.info().integers, "{n} for {want}");
    // Positions written by the caller: nothing moves, nothing touches.
    let at = |i: usize| [(i % 16) as f32, 0.0, (i / 16) as f32, 0.0];
    let still: Vec<Path> = (0..x0.len()).map(|i| Path { t0: at(i), t1: at(i) }).collect();
    device.queue().write_buffer(session.paths(), 0, bytemuck::cast_slice(&still));
    assert_eq!(n_found(&mut session), 0);
}

/// Triangles below a face each, with a corner up that moves between these points, far from each
/// other. `turn`: by how much a corner of the face rises.
fn standing(n: usize, corner: [[f64; 3]; 2], turn: f64) -> (ccd::Mesh, [Vec<[f64; 3]>; 2]) {
    let n = n as u32;
    let faces: Vec<[u32; 3]> = (0..2 * n).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let mesh = ccd::Mesh::new(6 * n as usize, &faces).unwrap();
    let x = [0, 1].map(|end| {
        let (c, rise) = (corner[end], end as f64 * turn);
        let group = |i: u32| {
            let at = |x: f64, y: f64, z: f64| [c[0] + x, c[1] + y, c[2] + z];
            [[0.0; 3], [1.0, rise, 0.0], [0.0, 0.0, 1.0], c, at(0.1, -9.0, 0.0)]
                .into_iter()
                .chain([at(0.0, -9.0, 0.1)])
                .map(move |[x, y, z]| [x, y, z + 20.0 * i as f64])
        };
        (0..n).flat_map(group).collect()
    });
    (mesh, x)
}

/// What the first of two decisions leaves, a recorded frame has in a list that steps which decide
/// once do not use: as the documentation promises, one step makes room there.
fn check_room_of_recorded(device: &Device) {
    let (mesh, [x0, x1]) = standing(20, [[0.2, 0.0, 0.2]; 2], 0.0);
    let mut session = Session::new(device, mesh, Options::default()).unwrap();
    session.reserve(8).unwrap();
    let fits = |session: &mut Session| {
        let mut encoder = device.wgpu().create_command_encoder(&Default::default());
        let lists = session.record(&mut encoder).unwrap().lists;
        let lists: Vec<_> = lists.into_iter().cloned().collect();
        let headers: Vec<_> = lists.iter().map(|list| (list.buffer(), 12)).collect();
        let headers = read_back(device, encoder, &headers);
        lists.iter().zip(headers).all(|(list, header)| {
            list.capacity() == 0 || header[0] <= list.capacity() && header[2] == 0
        })
    };
    assert_eq!(session.step(&x0, &x1).unwrap().contacts.len(), 20);
    session.reserve(8).unwrap();
    assert!(!fits(&mut session), "lists of 8 entries hold all");
    session.step(&x0, &x1).unwrap();
    assert!(fits(&mut session), "a step has made no room");
}

/// Corners that begin in the plane of a face, beside it, and go through it later: a first step
/// leaves them to the host, which the next one does not.
fn check_time_of_open(device: &Device) {
    let (mesh, [x0, x1]) = standing(100, [[2.0, 0.0, 0.2], [-3.1, 0.6, 0.2]], 2.0);
    let options = Options::default().with_mode(Mode::Conservative);
    let mut session = Session::new(device, mesh, options).unwrap();
    let mut left = Vec::new();
    let times: Vec<f64> = (0..3)
        .map(|_| {
            let toi = session.earliest_toi(&x0, &x1).unwrap().expect("a contact");
            left.push(session.left_open().total());
            toi
        })
        .collect();
    assert!(times[0] <= 1.0 / 3.0 && times[0] > 1.0 / 3.0 - 2e-6, "{times:?}");
    assert!(times.iter().all(|toi| toi.to_bits() == times[0].to_bits()), "{times:?}");
    let info = device.info();
    let by_host = if info.integers { left[0] == 0 } else { left[0] >= 100 };
    assert!(!info.wide || by_host && left[2] == 0, "left open: {left:?}");
}

/// Corners that rest beside a face, nearer than filters see, on a device that has no memory for as
/// many contacts as a first decision leaves open: the second one takes less, and leaves none.
fn check_memory_of_open(device: &Device) {
    if device.info().integers {
        // They leave none of these open.
        return;
    }
    let beside = 0.5 + 1e-9;
    let n = 200;
    let (mesh, [x0, x1]) = standing(n, [[beside, 0.0, 0.5]; 2], 0.0);
    let run = |faults: Faults| {
        let mut session = Session::new(device, &mesh, Options::default()).unwrap();
        session.reserve(8).unwrap();
        set_faults(device, faults);
        let found = session.step(&x0, &x1).map(|report| report.contacts.len());
        set_faults(device, Faults::default());
        assert!(
            found.as_ref().is_ok_and(|&n| n == 0)
                || matches!(found, Err(Error::OutOfMemory { .. }))
        );
        assert_eq!(session.step(&x0, &x1).unwrap().contacts.len(), 0);
        let mut encoder = device.wgpu().create_command_encoder(&Default::default());
        (found.is_ok(), session.record(&mut encoder).unwrap().contacts.capacity() >= n as u32)
    };
    assert_eq!(run(Faults::default()), (true, true), "none was left open");
    let error = Error::OutOfMemory { what: "a test", bytes: 1 };
    // A list is tried with some more entries, and then with just enough.
    let faults = |skip| Faults { skip, n: 2, error: Some(error.clone()), ..Faults::default() };
    let goes_on = (0..60).any(|skip| run(faults(skip)) == (true, false));
    assert!(goes_on, "no step did without memory for contacts");
}

fn check_empty(device: &Device) {
    let mesh = ccd::Mesh::new(0, &[]).unwrap();
    let mut session = Session::new(device, mesh, Options::default()).unwrap();
    let none: [[f64; 3]; 0] = [];
    assert!(session.step(&none, &none).unwrap().contacts.is_empty());
    assert_eq!(session.earliest_toi(&none, &none).unwrap(), None);
}

/// A box nearly as large as the scene, so that cells are: all pairs, as by the grids of the CPU.
fn check_unlike(device: &Device) {
    let mut boxes = uniform_boxes(20_000);
    boxes[19_999] = ccd::Aabb { min: [0.0; 3], max: [0.9; 3] };
    let mut broad = BroadPhase::new(device, BroadPhaseMethod::UniformGrid).unwrap();
    let mut cpu = ccd::BroadPhase::new(1, BroadPhaseMethod::UniformGrid).unwrap();
    let want = cpu.self_pairs(&boxes).unwrap().to_vec();
    assert!(want.len() > 10_000);
    check_pairs("boxes of unlike sizes", want, broad.self_pairs(&boxes).unwrap().to_vec());
}
