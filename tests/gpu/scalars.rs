//! Scalar operations and layouts: what a device makes of each, against native Rust; what SPIR-V and
//! the manifest say, against the table.

use crate::support::{bytes, not_run, run, zeros};
use ccd::gpu::bind::{ProbeLayout, ProbeScalars, ProbeWide};
use ccd::gpu::{Device, Path};
use ccd_core::backend::kernel::{Access, TABLE, probe};
use ccd_core::backend::layout::{Blocks, Leaf, Pair, Params, Touch};
use ccd_testkit::generate::Random;

pub const TESTS: crate::Tests =
    &[("scalars_f32", check_scalars), ("scalars_f64", check_wide), ("layouts", check_layouts)];

/// Numbers at which arithmetic changes its behaviour, as bits, and the thresholds of kernels.
const POISON: [u32; 28] = [
    0, 0x80000000, 1, 0x80000001, 0x007fffff, 0x00800000, 0x80800000, 0x3f800000, 0xbf800000,
    0x3f7fffff, 0x3f800001, 0x7f7fffff, 0xff7fffff, 0x7f800000, 0xff800000, 0x7fc00000, 0x34000000,
    0x33800000, 0x2b800000, 0x350637bd, 0x7e5a2d5a, 0x7e61b1e6, 0x4b000000, 0x4b800000, 0x4f000000,
    0x4f800000, 0x358637bd, 0x5f800000,
];

fn inputs() -> Vec<[u32; 2]> {
    let mut random = Random::new(11);
    let poison = POISON.iter().flat_map(|&a| POISON.iter().map(move |&b| [a, b]));
    poison.chain((0..20_000).map(|_| [random.bits(), random.bits()]).collect::<Vec<_>>()).collect()
}

fn number(bits: u32) -> f32 {
    f32::from_bits(bits)
}

/// Whether a device may flush the number to zero, and what comes from it.
fn tiny(x: f32) -> bool {
    x != 0.0 && x.abs() < f32::MIN_POSITIVE
}

/// Why `got` is no acceptable answer where `want` is the exact one; `exact`: operations must round
/// as IEEE 754 says.
fn difference(name: &str, input: [u32; 2], want: u32, got: u32, exact: bool) -> Option<String> {
    let (a, b) = (number(input[0]), number(input[1]));
    let integers =
        ["order_key", "leading_zeros", "trailing_zeros", "count_ones", "wrapping_mul", "shifts"]
            .contains(&name);
    let fine = if integers || want == got {
        want == got
    } else if tiny(a) || tiny(b) || a.is_nan() || b.is_nan() || a.is_infinite() || b.is_infinite() {
        // Denormals may be flushed before and after; kernels meet neither NaN nor infinity: hosts
        // refuse them.
        true
    } else if ["a < b", "a <= b", "a == b", "is_finite_number", "f32 to u32"].contains(&name) {
        false
    } else if ["-a", "abs", "min", "max", "next_up", "next_down"].contains(&name) {
        // Of two zeros either may be the smaller; bits and comparisons are exact.
        number(want) == 0.0 && number(got) == 0.0 || tiny(number(want))
    } else {
        let (want, got) = (number(want), number(got));
        // Division and what is made from it: 2.5 units; the rest one unit at most, which is what
        // the bounds of filters assume.
        let units = match name {
            "a / b" | "sqrt_up" => 8.0,
            _ if exact => 0.0,
            _ => 1.0,
        };
        let overflow = !want.is_finite() && (!got.is_finite() || got.abs() > 1e38)
            || !got.is_finite() && want.abs() > 1e38;
        // A product that rounds up to the smallest normal number may be flushed before it is
        // rounded.
        let small = want.abs() <= f32::MIN_POSITIVE;
        // Devices divide by numbers beyond 2^126 as they like; kernels scale before they divide.
        let beyond = name == "a / b" && b.abs() > 2f32.powi(126);
        overflow
            || small
            || beyond
            || (got as f64 - want as f64).abs()
                <= units * f32::EPSILON as f64 / 2.0 * want.abs() as f64
    };
    let [p, q] = input;
    let text = || format!("{name} of {a:e} ({p:#x}) and {b:e} ({q:#x}): {want:#x}, not {got:#x}");
    (!fine).then(text)
}

fn compare(inputs: &[[u32; 2]], got: &[[u32; 24]], exact: bool) -> Vec<String> {
    let mut out = Vec::new();
    for (input, got) in inputs.iter().zip(got) {
        let want = probe::scalars(*input);
        for (k, name) in probe::SCALARS.iter().enumerate() {
            out.extend(difference(name, *input, want[k], got[k], exact));
        }
    }
    out
}

fn check_scalars(device: &Device) {
    let inputs = inputs();
    let kernel = ProbeScalars { inputs: bytes(&inputs), results: zeros::<[u32; 24]>(inputs.len()) };
    let done = run(device, kernel, &Params::default(), inputs.len().div_ceil(64) as u32);
    let got: Vec<[u32; 24]> = bytemuck::pod_collect_to_vec(&done.results);
    let wrong = compare(&inputs, &got, device.info().path == Path::Passthrough);
    let first = wrong[..wrong.len().min(8)].join("\n");
    assert!(wrong.is_empty(), "{} differences, first:\n{first}", wrong.len());
    // Bounds rest on this one: never below the root.
    for (input, got) in inputs.iter().zip(&got) {
        let (x, root) = (number(input[0]), number(got[11]));
        let holds = root as f64 >= (x as f64).sqrt();
        assert!(holds || !(x > 1e-37 && x.is_finite()), "sqrt_up({x:e}) = {root:e}");
    }
}

fn check_wide(device: &Device) {
    if !device.info().wide {
        return not_run("the device is used without f64");
    }
    let mut random = Random::new(12);
    let mut number = || {
        f64::from_bits(1.0f64.to_bits() & !0xf_ffff | random.bits() as u64)
            * 2f64.powi(random.below(200) as i32 - 100)
            * (random.unit() - 0.5)
    };
    let inputs: Vec<[f64; 2]> = (0..20_000)
        .map(|_| [number(), number()])
        .chain([[0.0, 1.0], [1.0, 3.0], [-0.0, 0.0], [1e308, 1e-308]])
        .collect();
    let kernel = ProbeWide { inputs: bytes(&inputs), results: zeros::<[u32; 28]>(inputs.len()) };
    let done = run(device, kernel, &Params::default(), inputs.len().div_ceil(64) as u32);
    let got: Vec<[[u32; 2]; 14]> = bytemuck::pod_collect_to_vec(&done.results);
    for (input, got) in inputs.iter().zip(&got) {
        let want: [[u32; 2]; 14] = bytemuck::cast(probe::wide(bytemuck::cast(*input)));
        for (k, name) in probe::WIDE.iter().enumerate() {
            let what = || format!("{name} of {input:?}: {:x?} and {:x?}", want[k], got[k]);
            assert!(is_wide_fine(name, *input, want[k], got[k]), "{}", what());
        }
    }
}

/// Whether `got` is an acceptable answer in `f64` where the CPU finds `want`.
fn is_wide_fine(name: &str, input: [f64; 2], want: [u32; 2], got: [u32; 2]) -> bool {
    let [low, _]: [u32; 2] = bytemuck::cast(input[0]);
    let (w, g) = (ccd_core::backend::layout::join(want), ccd_core::backend::layout::join(got));
    // Denormals may be flushed, as the lavapipe of Mesa 26 does.
    let tiny = || input.iter().chain([&w]).any(|x| x.is_subnormal());
    match name {
        // Words, and no number; rounded by bits.
        "round_down, is_finite_number" => want == got,
        "a < b" => want == got || input.iter().any(|x| x.is_subnormal()),
        "f32 to f64" => want == got || !f32::from_bits(low).is_normal(),
        // Either neighbour.
        "f64 to f32" => !number(want[0]).is_normal() || want[0].abs_diff(got[0]) <= 1,
        _ => {
            let close = (w - g).abs() <= 2.0 * f64::EPSILON * w.abs();
            want == got || close || w == 0.0 && g == 0.0 || tiny()
        }
    }
}

/// Fills records with numbers of their own and looks whether the device finds each in its field.
fn check_layouts(device: &Device) {
    let fill = |n: usize, first: u32| -> Vec<u32> { (0..n as u32).map(|i| first + i).collect() };
    let n_words = |part: &[u8]| part.len() / 4;
    let [frame, dispatch, args] = Params::<Blocks>::default().parts().map(n_words);
    let params = Params {
        frame: bytemuck::cast_slice(&fill(frame, 0x100))[0],
        dispatch: bytemuck::cast_slice(&fill(dispatch, 0x100 + frame as u32))[0],
        args: bytemuck::cast_slice::<u32, Blocks>(&fill(args, 0x100 + (frame + dispatch) as u32))
            [0],
    };
    let record =
        |size: usize, first| bytemuck::cast_slice::<u32, u8>(&fill(2 * size / 4, first)).to_vec();
    let kernel = ProbeLayout {
        paths: record(32, 0x1000),
        leaves: record(size_of::<Leaf>(), 0x2000),
        touches: record(size_of::<Touch>(), 0x3000),
        pairs: record(size_of::<Pair>(), 0x4000),
        words: zeros::<u32>(probe::WORDS),
    };
    let got: Vec<u32> = bytemuck::pod_collect_to_vec(&run(device, kernel, &params, 1).words);
    let records = [fill(8, 0x1008), fill(4, 0x2004), fill(7, 0x3007), fill(2, 0x4002)];
    assert_eq!(got, [fill(probe::PARAMS_WORDS, 0x100), records.concat()].concat());
}

/// The comparison of scalars finds a single wrong bit.
pub fn check_negative_control() {
    let inputs = inputs();
    let mut got: Vec<[u32; 24]> = inputs.iter().map(|&i| probe::scalars(i)).collect();
    assert!(compare(&inputs, &got, true).is_empty());
    let at = inputs.len() - 1;
    for k in 0..24 {
        let right = got[at][k];
        got[at][k] ^= if k == 3 || k == 11 { 64 } else { 1 };
        assert!(!compare(&inputs, &got, true).is_empty(), "a wrong {} passes", probe::SCALARS[k]);
        got[at][k] = right;
    }
    let input = [1.0 / 3.0, -0.7];
    let right: [[u32; 2]; 14] = bytemuck::cast(probe::wide(bytemuck::cast(input)));
    for (name, [p, q]) in probe::WIDE.iter().zip(right) {
        assert!(is_wide_fine(name, input, [p, q], [p, q]), "{name}");
        assert!(!is_wide_fine(name, input, [p, q], [p ^ 64, q]), "a wrong {name} passes");
        let two = ["a < b", "round_down, is_finite_number"].contains(name);
        assert!(!two || !is_wide_fine(name, input, [p, q], [p, q ^ 1]), "a wrong {name} passes");
    }
}

/// Offsets of the members of parameters and of their records, as the modules of the table declare
/// them.
pub fn check_decorations() {
    let frame = [0, 12, 16, 32, 36, 40, 44, 48, 56, 80, 88, 96, 100, 104, 108, 116, 124];
    let (dispatch, params) = ([0, 4, 8, 12], [0, 132, 148]);
    for kernel in TABLE {
        let Some(record) = kernel.params else { continue };
        let args: &[u32] = match record {
            "Blocks" => &[0, 128, 132, 136, 140],
            "SortPass" | "Queries" => &[0, 4],
            "Intervals" => &[0, 4, 8, 12],
            "Expansion" => &[0, 4, 8, 12, 20],
            "NodeDescent" => {
                &[0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48, 52, 56, 60, 64, 68, 72]
            }
            "BlockDescent" => &[0, 76],
            "IntegerDecision" => &[0, 4, 8, 12],
            "Placing" => &[0, 12],
            "Building" => &[0, 4, 8, 12, 16],
            "Plain" | "Worlds" | "Listing" | "Filtering" | "Decision" => &[0],
            other => panic!("{}: where are the members of {other}?", kernel.name),
        };
        let found = offsets(kernel.name);
        for want in [&frame[..], &dispatch, &params, args] {
            let name = kernel.name;
            assert!(found.iter().any(|o| o == want), "{name}: none of {found:?} is {want:?}");
        }
    }
    let size = |parts: [&[u8]; 3]| parts.map(<[u8]>::len);
    assert_eq!(size(Params::<Blocks>::default().parts()), [132, 16, 144]);
}

/// Offsets of the members of each structure of a module.
fn offsets(kernel: &str) -> Vec<Vec<u32>> {
    const MEMBER_DECORATE: u32 = 72;
    const OFFSET: u32 = 35;
    let path = format!("{}/../ccd-gpu/shaders/{kernel}.spv", env!("CARGO_MANIFEST_DIR"));
    let words: Vec<u32> = bytemuck::pod_collect_to_vec(&std::fs::read(&path).expect(&path));
    let mut offsets = std::collections::BTreeMap::<u32, Vec<u32>>::new();
    let mut at = 5;
    while at < words.len() {
        let n = (words[at] >> 16).max(1) as usize;
        if words[at] & 0xffff == MEMBER_DECORATE && words[at + 3] == OFFSET {
            offsets.entry(words[at + 1]).or_default().push(words[at + 4]);
        }
        at += n;
    }
    offsets.into_values().collect()
}

/// The manifest of the shaders and the kernel table say the same.
pub fn check_manifest() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../ccd-gpu/shaders/manifest.json");
    let manifest: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(path).expect(path)).expect(path);
    let kernels = manifest["kernels"].as_array().unwrap();
    assert_eq!(kernels.len(), TABLE.len());
    for row in TABLE {
        let name = row.name;
        let kernel = kernels.iter().find(|k| k["name"] == name).expect(name);
        let access = row.bindings().map(|a| if a == Access::Write { "write" } else { "read" });
        assert_eq!(kernel["bindings"], serde_json::json!(access.collect::<Vec<_>>()), "{name}");
        let want = [row.threads.into(), row.wide.into(), row.native.into(), row.barriers.into()];
        let found = ["workgroup", "wide", "native", "barriers"].map(|key| kernel[key].clone());
        assert_eq!(found, want as [serde_json::Value; 4], "{name}");
        assert_eq!(kernel["entry"], name);
        let (threads, bytes) = if row.by_subgroups { (512, 32_768) } else { (256, 16_384) };
        assert!(kernel["shared_bytes"].as_u64().unwrap() <= bytes, "{name}");
        assert!(row.threads <= threads && row.bindings().count() <= 8, "{name}");
    }
}
