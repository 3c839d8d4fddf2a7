//! Which rows the conformance table has by default.

use crate::Missing;
use crate::scenes::Source;
use ccd::any::Choice;
use ccd::gpu;
use ccd::method::{
    BroadPhaseMethod, Builder, Catalogued, Pipeline, Scheduler, Scheduling, Traversal, TreeOptions,
    TriangleOptions, Volume,
};
use ccd_testkit::is_whole;
use ccd_testkit::methods::{differences, is_near_default};

/// The path on which no worker takes from another.
pub const WGSL: &str = "gpu-wgsl";

/// Steps of so many edges are left out where threads of this machine do a GPU's work.
const MAX_EDGES_EMULATED: usize = 50_000;

/// Brute force over more boxes is left out there, and the tree by nearest pairs.
const MAX_BOXES_EMULATED: usize = 10_000;

/// The methods of a backend by which a scene is run: with [`WHOLE`](ccd_testkit::WHOLE) by all of
/// them, which takes hours. Without it real scenes are run by the default, the default tree and the
/// grid of a CPU, and an emulated GPU has trees that differ from the default tree in one choice, or
/// have a kernel of their own, and no brute force over many boxes; through WGSL it has the default
/// and the default tree.
pub fn methods(
    source: Source,
    backend: &'static str,
    place: &str,
    emulated: bool,
) -> Vec<BroadPhaseMethod> {
    let whole = is_whole();
    let usual = [BroadPhaseMethod::default(), BroadPhaseMethod::TREE];
    let chosen = |method: &BroadPhaseMethod| match source {
        Source::Real(_) => {
            usual.contains(method) || backend == "cpu" && *method == BroadPhaseMethod::UniformGrid
        }
        _ if emulated && place == WGSL => usual.contains(method),
        Source::Boxes(make) if emulated && is_slow(*method) => make().len() <= MAX_BOXES_EMULATED,
        _ => !emulated || has_a_row(*method),
    };
    ccd::method::every(backend).filter(|method| whole || chosen(method)).collect()
}

/// Whether a method takes the square of the number of boxes, or waits for one thread of a GPU.
fn is_slow(method: BroadPhaseMethod) -> bool {
    let nearest_pair = |tree: TreeOptions| matches!(tree.builder, Builder::NearestPair { .. });
    method == BroadPhaseMethod::BruteForce
        || matches!(method, BroadPhaseMethod::Tree(tree) if nearest_pair(tree))
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

/// Ways to pair features, other than by default; of generated scenes on a CPU with every way to
/// share out pairs of nodes.
pub fn pipelines(source: Source, backend: &'static str) -> Vec<(Pipeline, Scheduling)> {
    let other = |row: &&ccd::method::Row<Pipeline>| row.value != Pipeline::default();
    let here = |row: &&ccd::method::Row<Pipeline>| row.backends.contains(&backend);
    let rows = Pipeline::ROWS.iter().filter(other).filter(here).map(|row| row.value);
    let plain = Pipeline::Triangles(TriangleOptions::default().representatives(false));
    let shared = backend == "cpu" && !matches!(source, Source::Real(_));
    let rows = rows.chain(shared.then_some(plain));
    let scheduled = Scheduling::every("cpu").filter(|_| shared);
    let all: Vec<_> = std::iter::once(Scheduling::default()).chain(scheduled).collect();
    match source {
        Source::Boxes(_) => Vec::new(),
        _ => rows.flat_map(|p| all.iter().map(move |&s| (p, s))).collect(),
    }
}

/// Generated scenes that an emulated GPU runs by every scheduler, on the native path.
const FEW: [&str; 2] = ["equal", "sheet"];

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
    let native = place != WGSL;
    let chosen = !emulated || native && FEW.contains(&scene);
    let all = methods.into_iter();
    all.filter(move |_| chosen && !matches!(source, Source::Real(_)))
        .flat_map(|method| Scheduling::every(backend).map(move |s| (method, s)))
        .filter(move |&(method, s)| backend == "cpu" || gpu::check_scheduling(method, s).is_ok())
        .filter(move |&(_, s)| native || !steals(s))
}

/// Whether workers take from each other, for which a GPU needs its native path.
fn steals(scheduling: Scheduling) -> bool {
    matches!(scheduling.scheduler, Some(Scheduler::Stealing | Scheduler::LazyStealing))
}
