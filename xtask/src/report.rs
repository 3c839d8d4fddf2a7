//! Whole runs side by side with ipctk and parry3d in one run, and the kernels of criterion, written
//! to `benches/RESULTS.md`.

use crate::markdown::{Table, wrap};
use crate::measure::{median, this_run, timed};
use ccd::method::BroadPhaseMethod;
use ccd::{Aabb, BroadPhase, Digest, Options, Session};
use ccd_testkit::brute::swept_boxes;
use ccd_testkit::data::{Scene, data_dir};
use parry3d::partitioning::{Bvh, BvhBuildStrategy, BvhWorkspace};
use std::fmt::Write;
use std::path::Path;
use std::process::Command;

const SCENES: [&str; 3] = ["cloth-ball", "rod-twist", "cloth-funnel"];
const THREADS: [usize; 2] = [1, 2];
const IPCTK: &str = "ipctk==1.6.1";

pub fn run(root: &Path, runs: usize) -> Result<(), String> {
    let data = data_dir()?;
    let mut out = header(root, runs);
    for name in SCENES {
        let scene = Scene::named(name);
        let [t0, t1] = scene.load(&data);
        let input = Input {
            mesh: t0.mesh().map_err(|e| e.to_string())?,
            x0: t0.positions,
            x1: t1.positions,
        };
        let mut ours = Vec::new();
        println!("{name}");
        for threads in THREADS {
            let row = measure_ours(&input, threads, runs)?;
            let ipctk = measure_ipctk(root, name, &input, threads, runs)?;
            let parry = measure_parry(&input, threads, runs);
            section(&mut out, name, threads, &row, &ipctk, &parry);
            ours.push(row);
        }
        scaling(&mut out, &ours);
    }
    kernels(root, &mut out)?;
    let path = root.join("benches/RESULTS.md");
    std::fs::write(&path, wrap(&out)).map_err(|e| format!("{}: {e}", path.display()))?;
    println!("written {}", path.display());
    Ok(())
}

struct Input {
    mesh: ccd::Mesh,
    x0: Vec<[f64; 3]>,
    x1: Vec<[f64; 3]>,
}

/// Median of `runs` times of `f` in milliseconds, and what it returned last.
fn medians<T>(runs: usize, mut f: impl FnMut() -> T) -> (f64, T) {
    let (first, mut last) = timed(&mut f);
    let mut times = vec![first];
    while times.len() < runs {
        let (ms, result) = timed(&mut f);
        times.push(ms);
        last = result;
    }
    (median(times), last)
}

/// Our times in milliseconds; `fresh` pays for every buffer anew, as the other libraries do.
struct Ours {
    candidates_fresh: f64,
    candidates_kept: f64,
    n_candidates: [usize; 2],
    edges: f64,
    faces: f64,
    vertices_faces: f64,
    digests: [Digest; 3],
    toi_fresh: f64,
    toi_kept: f64,
    toi: Option<f64>,
    step_kept: f64,
    n_contacts: u64,
}

fn measure_ours(input: &Input, threads: usize, runs: usize) -> Result<Ours, String> {
    let Input { mesh, x0, x1 } = input;
    let [v, e, f] = rounded(input);
    let new = || BroadPhase::new(threads, BroadPhaseMethod::Blocks).map_err(|e| e.to_string());
    let session = || {
        Session::new(mesh.clone(), Options::default().with_threads(threads))
            .map_err(|e| e.to_string())
    };
    let count = |session: &mut Session| {
        session.candidates(x0, x1).map_or([0; 2], |c| [c.vf.len(), c.ee.len()])
    };
    let (candidates_fresh, _) = medians(runs, || session().map(|mut s| count(&mut s)));
    let mut kept = session()?;
    count(&mut kept);
    let (candidates_kept, n_candidates) = medians(runs, || count(&mut kept));
    let mut broad = new()?;
    let (edges, _) = medians(runs, || new().map(|mut b| b.self_pairs(&e).map_or(0, |p| p.len())));
    let (faces, _) = medians(runs, || new().map(|mut b| b.self_pairs(&f).map_or(0, |p| p.len())));
    let (vertices_faces, _) =
        medians(runs, || new().map(|mut b| b.pairs(&v, &f).map_or(0, |p| p.len())));
    let digest = |r: Result<ccd::Pairs, ccd::Error>| {
        r.map(|p| Digest::of(0, p.iter())).map_err(|e| e.to_string())
    };
    let digests = [
        digest(broad.self_pairs(&e))?,
        digest(broad.self_pairs(&f))?,
        digest(broad.pairs(&v, &f))?,
    ];
    let (toi_fresh, _) = medians(runs, || session().map(|mut s| s.earliest_toi(x0, x1).ok()));
    let mut kept = session()?;
    kept.earliest_toi(x0, x1).map_err(|e| e.to_string())?;
    let (toi_kept, toi) = medians(runs, || kept.earliest_toi(x0, x1).ok().flatten());
    let mut kept = session()?;
    kept.step(x0, x1).map_err(|e| e.to_string())?;
    let (step_kept, n_contacts) =
        medians(runs, || kept.step(x0, x1).map_or(0, |r| r.n_contacts().total()));
    println!(
        "  ours, {threads} threads: candidates {candidates_fresh:.1} ms, \
         earliest toi {toi_fresh:.1} ms, step {step_kept:.1} ms"
    );
    Ok(Ours {
        candidates_fresh,
        candidates_kept,
        n_candidates,
        edges,
        faces,
        vertices_faces,
        digests,
        toi_fresh,
        toi_kept,
        toi,
        step_kept,
        n_contacts,
    })
}

/// Boxes of vertices, edges and faces, rounded outward.
fn rounded(input: &Input) -> [Vec<Aabb<f32>>; 3] {
    swept_boxes(&input.mesh, &input.x0, &input.x1)
        .map(|boxes| boxes.iter().map(|b| b.round_out()).collect())
}

fn measure_ipctk(
    root: &Path,
    name: &str,
    input: &Input,
    threads: usize,
    runs: usize,
) -> Result<serde_json::Value, String> {
    let file = std::env::temp_dir().join(format!("ccd-report-{name}-{}.bin", std::process::id()));
    let mut bytes: Vec<u8> = Vec::new();
    for n in [input.x0.len(), input.mesh.edges().len(), input.mesh.faces().len()] {
        bytes.extend((n as u32).to_le_bytes());
    }
    input.x0.iter().chain(&input.x1).flatten().for_each(|c| bytes.extend(c.to_le_bytes()));
    input
        .mesh
        .edges()
        .iter()
        .flatten()
        .chain(input.mesh.faces().iter().flatten())
        .for_each(|i| bytes.extend(i.to_le_bytes()));
    std::fs::write(&file, bytes).map_err(|e| e.to_string())?;
    let script = root.join("xtask/src/ipctk_times.py");
    let python = || {
        Command::new("python3")
            .arg(&script)
            .arg(&file)
            .args([threads.to_string(), runs.to_string()])
            .output()
    };
    let mut output = python().map_err(|e| format!("python3: {e}"))?;
    if !output.status.success() {
        let pip = Command::new("python3")
            .args(["-m", "pip", "install", "--quiet", IPCTK, "numpy"])
            .status();
        pip.map_err(|e| format!("pip: {e}"))?;
        output = python().map_err(|e| format!("python3: {e}"))?;
    }
    let _ = std::fs::remove_file(&file);
    if !output.status.success() {
        return Err(format!("ipctk: {}", String::from_utf8_lossy(&output.stderr)));
    }
    let value: serde_json::Value =
        serde_json::from_slice(&output.stdout).map_err(|e| e.to_string())?;
    println!("  ipctk: {value}");
    Ok(value)
}

/// Build and traversal of parry's tree over the same boxes: edges, faces, vertices against faces;
/// its parallel traversal where it has one.
struct Parry {
    edges: f64,
    faces: f64,
    vertices_faces: f64,
    digests: [Digest; 3],
}

fn measure_parry(input: &Input, threads: usize, runs: usize) -> Parry {
    let [v, e, f] = rounded(input);
    let convert = |boxes: &[Aabb<f32>]| -> Vec<parry3d::bounding_volume::Aabb> {
        boxes
            .iter()
            .map(|b| parry3d::bounding_volume::Aabb::new(b.min.into(), b.max.into()))
            .collect()
    };
    let (v, e, f) = (convert(&v), convert(&e), convert(&f));
    let within = |boxes: &[parry3d::bounding_volume::Aabb]| {
        let bvh = Bvh::from_leaves(BvhBuildStrategy::Binned, boxes);
        if threads > 1 {
            return bvh.traverse_bvtt_single_tree_parallel::<false>();
        }
        let mut pairs = Vec::new();
        bvh.traverse_bvtt_single_tree::<false>(&mut BvhWorkspace::default(), &mut |a, b| {
            pairs.push((a, b))
        });
        pairs
    };
    let between = || {
        let (a, b) = (
            Bvh::from_leaves(BvhBuildStrategy::Binned, &v),
            Bvh::from_leaves(BvhBuildStrategy::Binned, &f),
        );
        a.leaf_pairs(&b, |a, b| a.intersects(b)).collect::<Vec<_>>()
    };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    let (edges, edge_pairs) = pool.install(|| medians(runs, || within(&e)));
    let (faces, face_pairs) = pool.install(|| medians(runs, || within(&f)));
    let (vertices_faces, vf_pairs) = pool.install(|| medians(runs, between));
    let digest = |pairs: &[(u32, u32)], ordered: bool| {
        let pair = |&(a, b): &(u32, u32)| {
            if ordered { ccd::Pair::ordered(a, b) } else { ccd::Pair { a, b } }
        };
        Digest::of(0, pairs.iter().map(pair))
    };
    println!(
        "  parry3d: edges {edges:.1} ms, faces {faces:.1} ms, \
         vertices x faces {vertices_faces:.1} ms"
    );
    Parry {
        edges,
        faces,
        vertices_faces,
        digests: [digest(&edge_pairs, true), digest(&face_pairs, true), digest(&vf_pairs, false)],
    }
}

fn header(root: &Path, runs: usize) -> String {
    format!(
        "# Results\n\nWritten by `cargo xtask report --runs {runs}` on {}.\n\n\
         Milliseconds, medians of {runs} runs in one go; compare ratios, not times. \
         \"Fresh\" pays for every buffer anew, as the other libraries do; \
         \"kept\" keeps them from the run before. \
         Candidates: checks, boxes, trees, and all pairs without a shared vertex listed. \
         parry3d: the same boxes, build and traversal together; \
         it has no parallel traversal of two trees.\n",
        this_run(root)
    )
}

fn section(
    out: &mut String,
    name: &str,
    threads: usize,
    ours: &Ours,
    ipctk: &serde_json::Value,
    parry: &Parry,
) {
    let number = |key: &str| ipctk[key].as_f64().unwrap_or(f64::NAN);
    let toi = |i: usize| ipctk["toi"][i].as_f64().unwrap_or(f64::NAN);
    let (broad, tight, additive) = (number("broad"), number("tight"), number("additive"));
    let lbvh = "ipctk LBVH";
    let tight_alone = "ipctk Tight-Inclusion, narrow alone";
    let rows = [
        ("candidates, fresh", ours.candidates_fresh, lbvh, broad),
        ("candidates, kept", ours.candidates_kept, lbvh, broad),
        ("edge boxes, fresh", ours.edges, "parry3d", parry.edges),
        ("face boxes, fresh", ours.faces, "parry3d", parry.faces),
        ("vertices x faces, fresh", ours.vertices_faces, "parry3d", parry.vertices_faces),
        ("earliest toi, all of it, fresh", ours.toi_fresh, tight_alone, tight),
        ("earliest toi, all of it, fresh", ours.toi_fresh, "ipctk ACCD, narrow alone", additive),
        ("earliest toi, all of it, kept", ours.toi_kept, tight_alone, tight),
        ("all contacts, kept", ours.step_kept, "ipctk LBVH + Tight-Inclusion", broad + tight),
    ];
    let kind = if threads == 1 { "thread" } else { "threads" };
    let mut table = Table::new(["what", "ccd", "beside", "its time", "ratio"]);
    for (what, ours, peer, theirs) in rows {
        let [ours_ms, theirs_ms] = [ours, theirs].map(|ms| format!("{ms:.1}"));
        table.row([what, &ours_ms, peer, &theirs_ms, &format!("{:.3}", ours / theirs)]);
    }
    let _ = write!(out, "\n## {name}, {threads} {kind}\n\n{table}");
    let same = if ours.digests == parry.digests { "the same pairs" } else { "OTHER PAIRS" };
    let _ = writeln!(
        out,
        "\nAnswers: {} contacts, earliest {:?}; \
         ipctk {}: {:?} (Tight-Inclusion), {:?} (ACCD); \
         parry3d finds {same} ({}, {}, {}).",
        ours.n_contacts,
        ours.toi,
        ipctk["version"].as_str().unwrap_or("?"),
        toi(0),
        toi(1),
        ours.digests[0].count,
        ours.digests[1].count,
        ours.digests[2].count
    );
    assert_eq!(ours.digests, parry.digests, "{name}: parry3d finds other pairs");
    // Its boxes are rounded to f32: it lists a few pairs more.
    for k in 0..2 {
        let (ours, theirs) =
            (ours.n_candidates[k], ipctk["candidates"][k].as_u64().unwrap_or(0) as usize);
        assert!(
            ours <= theirs && theirs - ours <= theirs / 1000,
            "{name}: {ours} candidates, ipctk {theirs}"
        );
    }
}

fn scaling(out: &mut String, ours: &[Ours]) {
    let [one, two] = ours else { return };
    let _ = writeln!(
        out,
        "\nTwo threads against one: candidates (kept) {:.2} times as fast, \
         earliest toi {:.2}, all contacts {:.2}.",
        one.candidates_kept / two.candidates_kept,
        one.toi_kept / two.toi_kept,
        one.step_kept / two.step_kept
    );
}

/// Runs criterion and lists its medians.
fn kernels(root: &Path, out: &mut String) -> Result<(), String> {
    crate::programs::command(
        root,
        &[
            "cargo",
            "bench",
            "-p",
            "ccd-benches",
            "--features",
            "criterion",
            "--",
            "--quick",
            "--noplot",
        ],
    )?;
    let mut rows = Vec::new();
    let groups = std::fs::read_dir(root.join("target/criterion"))
        .map_err(|e| format!("target/criterion: {e}"))?;
    for group in groups.flatten() {
        let path = group.path().join("new/estimates.json");
        let Ok(text) = std::fs::read(&path) else { continue };
        let estimates: serde_json::Value =
            serde_json::from_slice(&text).map_err(|e| e.to_string())?;
        let ns = estimates["median"]["point_estimate"].as_f64().unwrap_or(f64::NAN);
        rows.push((group.file_name().to_string_lossy().into_owned(), ns));
    }
    rows.sort_by(|a, b| a.0.cmp(&b.0));
    let mut table = Table::new(["kernel", "time"]);
    for (name, ns) in rows {
        let time = match ns {
            1e6.. => format!("{:.2} ms", ns * 1e-6),
            1e3.. => format!("{:.2} us", ns * 1e-3),
            _ => format!("{ns:.1} ns"),
        };
        table.row([name, time]);
    }
    let _ = write!(out, "\n## Kernels (criterion, medians, one thread)\n\n{table}");
    Ok(())
}
