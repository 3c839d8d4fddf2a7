//! What is left out where threads of this machine do the work of a GPU: tests that take longest
//! there and show what another has shown.

use ccd::gpu::wgpu::DeviceType;
use ccd::gpu::{Device, Path};
use ccd_testkit::data::SCENES;

/// Set to 1, this variable has nothing left out.
const WHOLE: &str = "CCD_WHOLE";

/// Tests of kernels that know no `f64`: a device that is used without it runs the same code.
const ALIKE: [crate::Tests; 11] = [
    crate::sorts::TESTS,
    crate::pairs::TESTS,
    crate::trees::TESTS,
    crate::builders::TESTS,
    crate::listed::TESTS,
    crate::triangles::TESTS,
    crate::intervals::TESTS,
    crate::descent::TESTS,
    crate::workers::TESTS,
    crate::oriented::TESTS,
    crate::stealing::TESTS,
];

/// Tests of what the host does around the kernels, which it does alike on every device: run as
/// natively as there is, with `f64`, and as portably, without.
const BY_THE_HOST: [crate::Tests; 5] = [
    crate::changes::TESTS,
    crate::kept_order::TESTS,
    crate::rules::TESTS,
    crate::failures::TESTS,
    crate::sequences::TESTS,
];

/// Scenes of more edges are run as natively as there is, with `f64`: the other devices have the
/// smaller ones.
const MAX_EDGES: usize = 50_000;

/// So are tests over many boxes or steps whose kernels other tests compare on the other devices:
/// `steps_by_every_method` has all methods there.
const LONG: [&str; 7] = [
    "builders_and_hard_boxes",
    "changes_between_steps",
    "order_of_small_meshes",
    "oriented_traversals",
    "schedulers_over_sequences",
    "triangles_by_every_method",
    "uniform_boxes",
];

/// Why a test is left out on a device, if it is.
pub fn left_out(name: &str, device: &Device) -> Option<String> {
    let info = device.info();
    let whole = std::env::var(WHOLE).is_ok_and(|v| v == "1");
    if whole || info.adapter.device_type != DeviceType::Cpu {
        return None;
    }
    let is_of = |groups: &[crate::Tests]| {
        groups.iter().flat_map(|tests| tests.iter()).any(|(test, _)| *test == name)
    };
    let scene = name.strip_prefix("scene_").and_then(|s| SCENES.iter().find(|t| t.name == s));
    let is_large = scene.is_some_and(|scene| scene.size[1] > MAX_EDGES);
    let native = info.wide && info.path == Path::Passthrough;
    let between = info.wide != (info.path == Path::Passthrough);
    let why = if is_of(&ALIKE) && !info.wide {
        "the same kernels as with f64"
    } else if is_of(&BY_THE_HOST) && between {
        "by the host as on the other devices"
    } else if !native && (is_large || LONG.contains(&name)) {
        "long on an emulated GPU"
    } else {
        return None;
    };
    Some(format!("{why}: {WHOLE}=1"))
}

/// That no name above is of a test that is gone.
pub fn check_names(tests: &[crate::Tests]) {
    for name in LONG {
        let is_there = tests.iter().flat_map(|tests| tests.iter()).any(|(test, _)| *test == name);
        assert!(is_there, "{name} is no test");
    }
}
