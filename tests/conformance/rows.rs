//! Which rows the conformance table has by default.

use crate::Missing;
use crate::scenes::Source;
use ccd::any::Choice;
use ccd::gpu;
use ccd::{BroadPhaseMethod, Catalogued, Pipeline, Scheduling, Traversal, TreeOptions, Volume};
use ccd_testkit::methods::{differences, is_near_default, is_oriented};

/// The path on which there are no oriented boxes.
pub const WGSL: &str = "gpu-wgsl";

/// Steps of so many edges are left out where threads of this machine do a GPU's work.
const MAX_EDGES_EMULATED: usize = 50_000;

/// Set to 1, this variable has every scene run by every method: hours. Without it real scenes are
/// run by the default and the default tree, and an emulated GPU has trees that differ from that in
/// one choice, or have a kernel of their own.
pub const WHOLE: &str = "CCD_WHOLE";

/// The methods of a backend by which a scene is run.
pub fn methods(
    source: Source,
    backend: &'static str,
    place: &str,
    emulated: bool,
) -> Vec<BroadPhaseMethod> {
    let whole = std::env::var(WHOLE).is_ok_and(|v| v == "1");
    let usual = [BroadPhaseMethod::default(), BroadPhaseMethod::TREE];
    let chosen = |method: &BroadPhaseMethod| match source {
        Source::Real(_) => usual.contains(method),
        _ => !emulated || has_a_row(*method),
    };
    of_place(backend, place).filter(|method| whole || chosen(method)).collect()
}

/// The methods of a backend, as far as this path to a GPU has them.
pub fn of_place(backend: &'static str, place: &str) -> impl Iterator<Item = BroadPhaseMethod> {
    let all = place != WGSL;
    ccd::every(backend).filter(move |&method| all || !is_oriented(method))
}

/// Whether a method is no tree, or the default one but for one choice; or another traversal of
/// oriented boxes, which has a kernel of its own.
fn has_a_row(method: BroadPhaseMethod) -> bool {
    is_near_default(method) || differences(method) == Some([false, true, true])
}

/// Whether threads of this machine do the work of a GPU.
pub fn is_emulated(choice: &Choice) -> bool {
    let kind = choice.device().map(|device| device.info().adapter.device_type);
    kind == Some(gpu::wgpu::DeviceType::Cpu)
}

pub fn not_too_slow(choice: Choice, source: Source) -> Result<Choice, Missing> {
    match source {
        Source::Real(scene) if is_emulated(&choice) && scene.size[1] > MAX_EDGES_EMULATED => {
            Err(Missing::Time)
        }
        _ => Ok(choice),
    }
}

/// Ways to pair features, other than by default.
pub fn pipelines(source: Source, backend: &'static str) -> Vec<Pipeline> {
    let other = |row: &&ccd::Row<Pipeline>| row.value != Pipeline::default();
    let here = |row: &&ccd::Row<Pipeline>| row.backends.contains(&backend);
    match source {
        Source::Boxes(_) => Vec::new(),
        _ => Pipeline::ROWS.iter().filter(other).filter(here).map(|row| row.value).collect(),
    }
}

/// Generated scenes that an emulated GPU runs by every scheduler.
const FEW: [&str; 4] = ["crowded", "equal", "one", "sheet"];

/// Ways to share out pairs of nodes, of generated scenes, with the methods that have some.
pub fn schedulings(
    scene: &'static str,
    source: Source,
    backend: &'static str,
    place: &str,
    emulated: bool,
) -> impl Iterator<Item = (BroadPhaseMethod, Scheduling)> {
    let tree = |traversal, volume| {
        let tree = TreeOptions::default().traversal(traversal).volume(volume);
        BroadPhaseMethod::Tree(tree)
    };
    let methods = [
        BroadPhaseMethod::Blocks,
        tree(Traversal::CUT, Volume::Aabb),
        // A traversal that each backend has.
        match backend {
            "cpu" => tree(Traversal::SIMULTANEOUS, Volume::Obb),
            _ => tree(Traversal::CUT, Volume::Obb),
        },
    ];
    let (native, chosen) = (place != WGSL, !emulated || FEW.contains(&scene));
    let here = methods.into_iter().filter(move |method| native || !is_oriented(*method));
    here.filter(move |_| chosen && !matches!(source, Source::Real(_)))
        .flat_map(|method| Scheduling::every(backend).map(move |s| (method, s)))
        .filter(move |&(method, s)| backend == "cpu" || gpu::check_scheduling(method, s).is_ok())
}
