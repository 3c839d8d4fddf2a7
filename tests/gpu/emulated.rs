//! What is left out where threads of this machine do the work of a GPU: tests that take longest
//! there and show what another has shown.

use ccd::gpu::wgpu::DeviceType;
use ccd::gpu::{Device, Path};
use ccd::method::BroadPhaseMethod;
use ccd_testkit::methods::{differences, is_near_default};
use ccd_testkit::{WHOLE, is_whole};

/// Of the five devices two are run by all tests: the most native, with `f64`, and the most
/// portable, WGSL without. Two between them are run by these tests, of boxes and of arithmetic, and
/// by all published queries; the other, whose `f64` counts as slow, by those of decisions.
const OF_DECISIONS: [&str; 6] =
    ["degenerate", "leaving", "one_time_whoever_decides", "tolerances", "who_decides", "windows"];
const OF_KERNELS: [crate::Tests; 2] = [crate::kernels::TESTS, crate::scalars::TESTS];

/// The most portable is not run by tests of methods that are not the default's, by those over many
/// boxes or steps whose kernels other tests compare there, nor by those of what the host does with
/// a frame.
const LONG: [&str; 30] = [
    "a_thousand_times_the_pairs",
    "boxes_after_failures",
    "builders_and_hard_boxes",
    "candidates_in_parts",
    "changes_between_steps",
    "dropped_in_flight",
    "fronts",
    "fronts_that_are_given_up",
    "grids_of_many_sizes",
    "groups_of_devices",
    "limit_of_memory",
    "lists_grow",
    "many_contacts",
    "many_positions",
    "moving_bodies",
    "nearest_pair",
    "order_is_kept",
    "order_of_small_meshes",
    "oriented_traversals",
    "ploc",
    "replaced_in_flight",
    "schedulers_over_sequences",
    "stacks",
    "steps_after_failures",
    "triangles_by_every_method",
    "triangles_in_several_dispatches",
    "two_threads",
    "uniform_boxes",
    "workers",
    "workers_of_blocks",
];

/// No device is: twenty seconds of as many rounds as a filter can need.
const LONGEST: &str = "dense_exclusions";

/// Whether a test leaves out what others show: threads of this machine do the work of a GPU.
pub fn is_thin(device: &Device) -> bool {
    !is_whole() && device.info().adapter.device_type == DeviceType::Cpu
}

/// Every method of a GPU; on an emulated one, of trees those that differ from the default in one
/// choice, without [`WHOLE`] in their traversal or volume, and through WGSL the default and the
/// default tree: builders are in `builders.rs`, and all methods in the conformance table.
pub fn methods(device: &Device) -> impl Iterator<Item = BroadPhaseMethod> {
    let (thin, emulated) = (is_thin(device), device.info().adapter.device_type == DeviceType::Cpu);
    let is_portable = device.info().path == Path::Wgsl;
    let is_usual = |m| m == BroadPhaseMethod::default() || m == BroadPhaseMethod::TREE;
    let is_few = move |method| match is_portable {
        true => is_usual(method),
        false => differences(method).is_none_or(|[builder, ..]| !builder),
    };
    let chosen = move |&method: &_| !emulated || is_near_default(method);
    ccd::method::every("gpu").filter(chosen).filter(move |&method| !thin || is_few(method))
}

/// Why a test is left out on a device, if it is.
pub fn left_out(name: &str, device: &Device) -> Option<String> {
    let info = device.info();
    if !is_thin(device) {
        return None;
    }
    let of_kernels = || OF_KERNELS.iter().flat_map(|tests| tests.iter());
    let long = "long on an emulated GPU";
    let why = match (info.path, info.wide) {
        _ if name == LONGEST => long,
        (Path::Passthrough, true) if !info.integers || OF_DECISIONS.contains(&name) => return None,
        (Path::Passthrough, true) => "as on a device with fast `f64` or with none",
        (Path::Wgsl, false) if LONG.contains(&name) => long,
        (Path::Wgsl, false) => return None,
        _ if name == "queries" || of_kernels().any(|(test, _)| *test == name) => return None,
        _ => "as on the most native device and the most portable",
    };
    Some(format!("{why}: {WHOLE}=1"))
}

/// That no name above is of a test that is gone.
pub fn check_names(tests: &[crate::Tests]) {
    for name in LONG.into_iter().chain(OF_DECISIONS) {
        let is_there = tests.iter().flat_map(|tests| tests.iter()).any(|(test, _)| *test == name);
        assert!(is_there, "{name} is no test");
    }
}
