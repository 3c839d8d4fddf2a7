//! What tests of single kernels share: bytes, scenes, lists, comparisons of boxes.

use crate::twin::Twin;
use ccd::gpu::bind::Bind;
use ccd::gpu::wgpu::{
    Buffer, BufferDescriptor, BufferUsages, CommandEncoder, DeviceType, MapMode, PollType,
};
use ccd::gpu::{self, Device, harness};
use ccd::{Aabb, Mesh, Pair};
use ccd_core::backend::kernel::TABLE;
use ccd_core::backend::layout::{LIST_HEADER, Params, Path};
use ccd_testkit::brute;
use ccd_testkit::generate::{Random, Step, crumpled_sheet};
use std::cell::RefCell;
use std::collections::BTreeSet;
use std::sync::Mutex;

pub fn bytes<T: bytemuck::Pod>(x: &[T]) -> Vec<u8> {
    bytemuck::cast_slice(x).to_vec()
}

pub fn read<T: bytemuck::Pod>(bytes: &[u8]) -> Vec<T> {
    bytemuck::pod_collect_to_vec(bytes)
}

/// Vertices of edges, then of faces, as kernels have them.
pub fn elements_of(mesh: &Mesh) -> Vec<u32> {
    let (edges, faces) = (mesh.edges().as_flattened(), mesh.faces().as_flattened());
    [edges, faces].concat()
}

thread_local! {
    static NOT_RUN: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// Says that a test that returns now could not run, and why: it is reported as ignored.
pub fn not_run(why: impl Into<String>) {
    NOT_RUN.set(Some(why.into()));
}

/// Why the test that has just returned could not run.
pub fn take_not_run() -> Option<String> {
    NOT_RUN.take()
}

/// Kernels that ran by themselves.
static RAN: Mutex<BTreeSet<&'static str>> = Mutex::new(BTreeSet::new());

/// Every kernel of the table was run by itself in this process; those with `f64` and those by
/// subgroups only where these are there.
pub fn check_all_ran(wide: bool, subgroups: bool) {
    let ran = RAN.lock().unwrap();
    let missing = TABLE.iter().filter(|kernel| {
        (wide || !kernel.wide) && (subgroups || !kernel.by_subgroups) && !ran.contains(kernel.name)
    });
    let missing: Vec<&str> = missing.map(|kernel| kernel.name).collect();
    assert!(missing.is_empty(), "no test runs {missing:?} by itself");
}

/// Runs a kernel and returns it with what its buffers hold then.
pub fn run<K: Bind<Vec<u8>>>(
    device: &Device,
    mut kernel: K,
    params: &Params<K::Args>,
    groups: u32,
) -> K {
    RAN.lock().unwrap().insert(K::ID.row().name);
    harness::run(device, &mut kernel, params, groups, 65_535).unwrap();
    kernel
}

/// Zeroed records.
pub fn zeros<T>(n: usize) -> Vec<u8> {
    vec![0; n * size_of::<T>()]
}

/// The smallest normal number.
pub const TINY: f32 = f32::MIN_POSITIVE;

const POISON: [f32; 14] = {
    const INF: f32 = f32::INFINITY;
    [0.0, -0.0, 1e-45, -1e-40, TINY, 1.0, -1.0, 1e30, -1e38, 2.9e38, -2.9e38, 3.4e38, f32::NAN, INF]
};

/// Paths of a scene, and paths of poison.
pub fn paths(step: &Step, poison: bool) -> Vec<Path> {
    let four = |p: &[f64; 3]| [p[0] as f32, p[1] as f32, p[2] as f32, 0.0];
    let mut out: Vec<Path> =
        step.x0.iter().zip(&step.x1).map(|(p, q)| Path { t0: four(p), t1: four(q) }).collect();
    let mut random = Random::new(4);
    let mut pick = || POISON[random.below(POISON.len() as u32) as usize];
    if poison {
        out.iter_mut().step_by(3).for_each(|p| {
            *p = Path { t0: [pick(), pick(), pick(), 0.0], t1: [pick(), pick(), pick(), 0.0] }
        });
    }
    out
}

/// Equal bits, or both NaN, or both so small that a device may flush them.
pub fn same(a: f32, b: f32) -> bool {
    let small = |x: f32| x.abs() < f32::MIN_POSITIVE;
    a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan() || small(a) && small(b)
}

/// Whether quotients and roots of `f32` are those of a CPU: a GPU's are off by some units in the
/// last place, compilers of WGSL may contract, and the lavapipe of Mesa 26 flushes denormals.
pub fn rounds_like_a_cpu(device: &Device) -> bool {
    let info = device.info();
    info.path == gpu::Path::Passthrough
        && info.adapter.device_type == DeviceType::Cpu
        && device.flushes().expect("what it flushes").is_empty()
}

pub fn check_boxes(what: &str, want: &[Aabb], got: &[Aabb]) {
    assert_eq!(want.len(), got.len(), "{what}");
    for (i, (w, g)) in want.iter().zip(got).enumerate() {
        let fine = (0..3).all(|k| same(w.min[k], g.min[k]) && same(w.max[k], g.max[k]));
        assert!(fine, "{what} {i}: {w:?} on the CPU, {g:?} on the device");
    }
}

/// The words at the beginning of buffers, after what is in the encoder.
pub fn read_back(
    device: &Device,
    mut encoder: CommandEncoder,
    buffers: &[(&Buffer, u64)],
) -> Vec<Vec<u32>> {
    let copies: Vec<Buffer> = buffers
        .iter()
        .map(|&(from, size)| {
            let usage = BufferUsages::MAP_READ | BufferUsages::COPY_DST;
            let label = BufferDescriptor { label: None, size, usage, mapped_at_creation: false };
            let to = device.wgpu().create_buffer(&label);
            encoder.copy_buffer_to_buffer(from, 0, &to, 0, size);
            to
        })
        .collect();
    device.queue().submit([encoder.finish()]);
    let words = |copy: Buffer| {
        copy.slice(..).map_async(MapMode::Read, |_| {});
        device.wgpu().poll(PollType::wait_indefinitely()).unwrap();
        read(&copy.slice(..).get_mapped_range().unwrap())
    };
    copies.into_iter().map(words).collect()
}

/// A path's box, by hand.
pub fn swept(p: &Path) -> Aabb {
    let low = |a: f32, b: f32| if a < b { a } else { b };
    let high = |a: f32, b: f32| if a > b { a } else { b };
    let clamp = |x: f32| low(high(x, -2.9e38), 2.9e38);
    Aabb {
        min: std::array::from_fn(|k| clamp(low(p.t0[k], p.t1[k]))),
        max: std::array::from_fn(|k| clamp(high(p.t0[k], p.t1[k]))),
    }
}

pub fn twin(n: usize, seed: u32) -> (Twin, Step) {
    let step = crumpled_sheet(n, seed);
    let [x0, x1] = step.rounded();
    let sets = brute::swept_boxes(&step.mesh, &x0, &x1);
    let twin = Twin::of_mesh(&step.mesh, &sets);
    (twin, step)
}

pub fn list(pairs: &[Pair]) -> Vec<u8> {
    let mut words = vec![pairs.len() as u32, 0, 0, 0];
    words.extend(pairs.iter().flat_map(|p| [p.a, p.b]));
    bytes(&words)
}

pub fn entries(list: &[u8]) -> Vec<Pair> {
    let words: Vec<u32> = read(list);
    words[LIST_HEADER..LIST_HEADER + 2 * words[0] as usize]
        .chunks_exact(2)
        .map(|p| Pair { a: p[0], b: p[1] })
        .collect()
}

pub fn capacity(n: u32) -> Vec<u8> {
    vec![0; 4 * (LIST_HEADER + 2 * n as usize)]
}
