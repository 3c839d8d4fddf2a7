//! What is left out where threads of this machine do the work of a GPU: tests that take longest
//! there and show what another has shown.

use ccd::gpu::wgpu::DeviceType;
use ccd::gpu::{Device, Path};

/// Set to 1, this variable has nothing left out.
const WHOLE: &str = "CCD_WHOLE";

/// Of the four devices two are run by all tests: the most native, with `f64`, and the most
/// portable, WGSL without. The two between them are run by these tests of kernels by themselves and
/// by all published queries.
const OF_KERNELS: [crate::Tests; 4] =
    [crate::kernels::TESTS, crate::scalars::TESTS, crate::poison::TESTS, crate::geometry::TESTS];

/// The most portable is not run by tests over many boxes or steps whose kernels other tests compare
/// there:
/// `steps_by_every_method` has all methods.
const LONG: [&str; 9] = [
    "boxes_after_failures",
    "builders_and_hard_boxes",
    "changes_between_steps",
    "order_of_small_meshes",
    "oriented_traversals",
    "schedulers_over_sequences",
    "steps_after_failures",
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
    let of_kernels = || OF_KERNELS.iter().flat_map(|tests| tests.iter());
    let why = match (info.path, info.wide) {
        (Path::Passthrough, true) => return None,
        (Path::Wgsl, false) if LONG.contains(&name) => "long on an emulated GPU",
        (Path::Wgsl, false) => return None,
        _ if name == "queries" || of_kernels().any(|(test, _)| *test == name) => return None,
        _ => "as on the most native device and the most portable",
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
