//! `cargo xtask report --gpu`: what a GPU needs for each stage, for whole steps, for sorting, and
//! how far that is from the bytes that must move.

use crate::Part;
use crate::measure::{Place, median, median_of, this_run, warm};
use crate::peers::PEERS;
use ccd::gpu::{BroadPhase, Device, DeviceOptions, Path as Shaders, Session, Sorter, Timing};
use ccd::method::BroadPhaseMethod;
use ccd::{Mesh, PerKind};
use ccd_testkit::data::{SCENES, Scene, data_dir};
use ccd_testkit::generate::{pcg, uniform_boxes};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Bytes a second that an NVIDIA H200 copies, as TARGETS of the project state it; floors on other
/// devices do not follow from it.
const COPY: f64 = 4.3e12;

type Stages = Vec<(&'static str, f64)>;

/// Measures and writes Markdown to `out` below `root`. `only`: these parts; none: all. `named`:
/// scenes whose name contains one of these; none: all.
pub fn run(
    root: &Path,
    runs: usize,
    out: &Path,
    only: &[Part],
    named: &[String],
) -> Result<(), String> {
    let out = &root.join(out);
    let wanted = |part| only.is_empty() || only.contains(&part);
    let of_scenes = wanted(Part::Scenes) || wanted(Part::Narrow);
    let dir = if of_scenes { Some(data_dir()?) } else { None };
    let scenes = || {
        let exists = |(s, dir): &(&'static Scene, &PathBuf)| {
            let is_named = named.is_empty() || named.iter().any(|part| s.name.contains(part));
            is_named && dir.join("scenes").join(s.name).is_dir()
        };
        dir.iter().flat_map(|dir| SCENES.iter().map(move |s| (s, dir))).filter(exists)
    };
    let mut text = format!(
        "# GPU: measured times\n\n`cargo xtask report --gpu`, {}. Milliseconds, medians. \
         Device: all kernels together, by its timestamps; \
         stages: each by itself, so that none overlaps another. \
         Wall: with upload, waiting and reading back. \
         Floor: bytes that must move, at 4.3 TB/s. \
         A session steps one frame again and again, so that boxes keep their order, and trees are \
         refitted, as in a sequence: where there is no stage `sort`, a step that sorts takes \
         0.16 to 0.18 more: libraries that build in every step are to be compared with that.\n",
        this_run(root)
    );
    // What was measured before a failure is kept.
    let write = |text: &str| {
        std::fs::write(out, crate::markdown::wrap(text))
            .map_err(|e| format!("{}: {e}", out.display()))
    };
    for path in [Shaders::Passthrough, Shaders::Wgsl] {
        let device = Device::open(&DeviceOptions { path: Some(path), ..DeviceOptions::default() })
            .map_err(error)?;
        let _ = write!(
            text,
            "\n## {} through {path:?}\n\n```\n{}\n```\n",
            device.info().adapter.name,
            device.info()
        );
        for (scene, dir) in scenes().filter(|_| wanted(Part::Scenes)) {
            measure_scene(&device, scene, dir, runs, &mut text).map_err(error)?;
            write(&text)?;
        }
        if wanted(Part::Boxes) {
            let measured = measure_boxes(&device, runs, &mut text).map_err(error);
            write(&text)?;
            measured?;
        }
        if wanted(Part::Sort) {
            measure_sort(&device, runs, &mut text).map_err(error)?;
        }
    }
    for path in [Shaders::Passthrough, Shaders::Wgsl].into_iter().filter(|_| wanted(Part::Narrow)) {
        let options = DeviceOptions { path: Some(path), narrow: true, ..DeviceOptions::default() };
        let device = Device::open(&options).map_err(error)?;
        let _ = writeln!(text, "\n## Steps without `f64` on the device, through {path:?}\n");
        text.push_str(
            "What is left open is decided on the CPU. By `f32` alone: a tolerance of 1e-10, for \
             which integers of 32 bits are not asked. Decide: that stage, on the device.\n\n\
             | scene | left by filters | left open | decide | wall | by `f32` alone: left open | \
             decide | wall |\n|---|---|---|---|---|---|---|---|\n",
        );
        for (scene, dir) in scenes() {
            measure_narrow(&device, scene, dir, runs, &mut text).map_err(error)?;
        }
        write(&text)?;
    }
    if wanted(Part::Group) {
        crate::group::measure(runs, &mut text).map_err(error)?;
        write(&text)?;
    }
    if wanted(Part::Worlds) {
        let threads = std::thread::available_parallelism().map_or(1, |n| n.get());
        let places: Vec<Place> = Place::gpu().into_iter().chain([Place::Cpu { threads }]).collect();
        crate::worlds::measure(&places, runs, &mut text).map_err(error)?;
        write(&text)?;
    }
    println!("{text}");
    Ok(())
}

fn error(e: ccd::gpu::Error) -> String {
    e.to_string()
}

/// Medians of what was measured.
pub struct Measured {
    /// All kernels together, by the device.
    pub device: f64,
    /// With upload, waiting and reading back.
    pub wall: f64,
    /// Each stage by itself, by the device; those of the same name are numbered.
    pub stages: Vec<(String, f64)>,
}

/// Measures in three ways, one after the other. `run` sets the timing it is told, works, and
/// returns the stages.
fn sample<E>(runs: usize, mut run: impl FnMut(Timing) -> Result<Stages, E>) -> Result<Measured, E> {
    run(Timing::Off)?;
    let (wall, _) = median_of(runs, || run(Timing::Off))?;
    let device =
        warm(runs, || -> Result<f64, E> { Ok(run(Timing::Whole)?.iter().map(|s| s.1).sum()) })?;
    let mut stages_of = warm(runs, || run(Timing::Stages))?;
    // Now and then a call goes another way (the earliest time tries a sample again): the way that
    // most went.
    let usual = |n: usize| stages_of.iter().filter(|s| s.len() == n).count();
    let n_stages = stages_of.iter().map(Vec::len).max_by_key(|&n| usual(n)).unwrap_or(0);
    stages_of.retain(|s| s.len() == n_stages);
    let mut stages: Vec<(String, f64)> = Vec::new();
    for i in 0..n_stages {
        let name = stages_of[0][i].0;
        let again = stages_of[0][..i].iter().filter(|s| s.0 == name).count();
        let name = if again == 0 { name.to_string() } else { format!("{name} {}", again + 1) };
        stages.push((name, median(stages_of.iter().map(|s| s[i].1))));
    }
    Ok(Measured { device: median(device), wall, stages })
}

/// [`sample`] of a call of a session.
pub fn of_session(
    session: &mut Session,
    runs: usize,
    call: impl Fn(&mut Session) -> Result<(), ccd::gpu::Error>,
) -> Result<Measured, ccd::gpu::Error> {
    sample(runs, |timing| {
        session.set_timing(timing)?;
        call(session)?;
        Ok(session.stages().to_vec())
    })
}

/// One item of a list: it is too long for a row of a table. `bytes`: those that must move; `peer`:
/// what others need for the same.
fn row(text: &mut String, title: &str, m: &Measured, bytes: f64, peer: &str, note: &str) {
    let part = |(name, ms): &(String, f64)| format!("{name} {ms:.3}");
    let parts: Vec<String> = m.stages.iter().filter(|s| s.1 > 0.0).map(part).collect();
    let (floor, (device, wall)) = (bytes / COPY * 1e3, (m.device, m.wall));
    let peer = if peer.is_empty() { String::new() } else { format!(" ({peer})") };
    let _ = writeln!(
        text,
        "- {title}: **device {device:.3}**{peer}, wall {wall:.2}, floor {floor:.3}; {note}. \
         Stages: {}.",
        parts.join(", ")
    );
}

/// Bytes that must move between a device's memory and its processors for boxes, order and trees of
/// a mesh: paths read; boxes written, and read for keys; four passes of a sort over keys and
/// numbers, read and written, keys once more to be counted; boxes into their order, leaves written.
fn bytes_of_trees(mesh: &Mesh) -> f64 {
    let features = (mesh.n_vertices() + mesh.edges().len() + mesh.faces().len()) as f64;
    32.0 * mesh.n_vertices() as f64 + features * (24.0 + 24.0 + 4.0 * 20.0 + 24.0 + 24.0 + 16.0)
}

fn measure_scene(
    device: &Device,
    scene: &Scene,
    dir: &Path,
    runs: usize,
    text: &mut String,
) -> Result<(), ccd::gpu::Error> {
    let [t0, t1] = scene.load(dir);
    let mesh = t0.mesh().map_err(ccd::gpu::Error::Input)?;
    let (x0, x1) = (&t0.positions, &t1.positions);
    let want = ccd::step(&mesh, x0, x1, &ccd::Options::default())?;
    let trees = bytes_of_trees(&mesh);
    let _ = writeln!(text, "\n### {}\n", scene.name);
    measure_sources(device, &mesh, [x0, x1], want.candidates, runs, text)?;
    let mut session = Session::new(device, mesh, ccd::Options::default())?;
    let peer = PEERS.iter().find(|p| p.scene == scene.name);
    let measured = of_session(&mut session, runs, |s| s.candidates_on_device(x0, x1).map(|_| ()))?;
    assert_eq!(session.report().candidates, want.candidates, "candidates of {}", scene.name);
    let c = want.candidates;
    let note = format!("{} vertex-face, {} edge-edge", c.vf, c.ee);
    row(
        text,
        "candidates",
        &measured,
        trees + 8.0 * c.total() as f64,
        &peer.map_or(String::new(), |p| format!("Kitten {}, edges alone", p.kitten[0])),
        &note,
    );
    let steps = of_session(&mut session, runs, |s| s.step(x0, x1).map(|_| ()))?;
    let report = session.report().clone();
    let earliest = of_session(&mut session, runs, |s| s.earliest_toi(x0, x1).map(|_| ()))?;
    assert_eq!(report.n_contacts(), want.n_contacts(), "contacts of {}", scene.name);
    let (f, n) = (report.filtered, report.n_contacts());
    let note = format!(
        "filtered {} + {}, contacts {} + {}, {} undecided",
        f.vf, f.ee, n.vf, n.ee, report.undecided
    );
    row(
        text,
        "step, all contacts",
        &steps,
        trees + 24.0 * n.total() as f64,
        &peer.map_or(String::new(), |p| format!("Scalable-CCD {}", p.scalable)),
        &note,
    );
    let (toi, exact) = (session.report().toi, want.toi);
    assert!(toi.is_some() == exact.is_some() && toi <= exact, "earliest {toi:?}, want {exact:?}");
    row(
        text,
        "earliest time of impact",
        &earliest,
        trees,
        "",
        &toi.map_or("none".into(), |t| format!("{t:e}")),
    );
    Ok(())
}

/// Candidates of a scene by methods other than the default, whose stages are of one kind of pairs
/// each.
fn measure_sources(
    device: &Device,
    mesh: &Mesh,
    [x0, x1]: [&[[f64; 3]]; 2],
    want: ccd::PerKind,
    runs: usize,
    text: &mut String,
) -> Result<(), ccd::gpu::Error> {
    let bytes = bytes_of_trees(mesh) + 8.0 * want.total() as f64;
    for (name, broad_phase) in [
        ("sweep-and-prune", BroadPhaseMethod::SweepAndPrune),
        ("uniform-grid", BroadPhaseMethod::UniformGrid),
        ("tree", BroadPhaseMethod::TREE),
    ] {
        let options = ccd::Options::default().with_broad_phase(broad_phase);
        let mut session = Session::new(device, mesh.clone(), options)?;
        let measured =
            of_session(&mut session, runs, |s| s.candidates_on_device(x0, x1).map(|_| ()));
        match measured {
            Ok(measured) => {
                assert_eq!(session.report().candidates, want, "candidates by {name}");
                let title = format!("candidates by {name}");
                row(text, &title, &measured, bytes, "", "as below");
            }
            // The grid, of cells that are too full.
            Err(ccd::gpu::Error::Input(e)) => {
                let _ = writeln!(text, "- candidates by {name}: {e}.");
            }
            Err(e) => return Err(e),
        }
    }
    Ok(())
}

/// One line for a scene: how many pairs each stage sees.
fn measure_narrow(
    device: &Device,
    scene: &Scene,
    dir: &Path,
    runs: usize,
    text: &mut String,
) -> Result<(), ccd::gpu::Error> {
    let [t0, t1] = scene.load(dir);
    let mesh = t0.mesh().map_err(ccd::gpu::Error::Input)?;
    let mut rows = Vec::new();
    for tolerance in [ccd::TOI_TOLERANCE, 1e-10] {
        let options = ccd::Options::default().with_tolerance(tolerance);
        let mut session = Session::new(device, mesh.clone(), options)?;
        let measured = of_session(&mut session, runs, |session| {
            session.step(&t0.positions, &t1.positions).map(|_| ())
        })?;
        let decides = measured.stages.iter().filter(|(name, _)| name.starts_with("decide"));
        let decide: f64 = decides.map(|stage| stage.1).sum();
        let PerKind { vf, ee, .. } = session.left_open();
        let row = format!("{vf} + {ee} | {decide:.3} | {:.2}", measured.wall);
        rows.push((row, session.report().clone()));
    }
    let [(row, report), (row_narrow, narrow)] = &rows[..] else { unreachable!("two sessions") };
    assert_eq!(report.n_contacts(), narrow.n_contacts(), "{}", scene.name);
    let PerKind { vf, ee, .. } = report.filtered;
    let _ = writeln!(text, "| {} | {vf} + {ee} | {row} | {row_narrow} |", scene.name);
    Ok(())
}

fn measure_boxes(device: &Device, runs: usize, text: &mut String) -> Result<(), ccd::gpu::Error> {
    let _ = writeln!(text, "\n### Uniform boxes against themselves, boxes on the device\n");
    for (n, pairs, peer) in [
        (100_000, 320, "Kitten 0.25"),
        (1_000_000, 25_417, "Kitten 0.67"),
        (10_000_000, 255_457, "Kitten 4.14"),
        (20_000_000, 512_281, ""),
    ] {
        let boxes = uniform_boxes(n);
        for (name, method) in
            [("blocks", BroadPhaseMethod::Blocks), ("tree", BroadPhaseMethod::TREE)]
        {
            let title = format!("{n}, {name}");
            let mut broad = BroadPhase::new(device, method)?;
            let found = match broad.self_pairs_on_device(&boxes) {
                Ok((found, _)) => found,
                Err(
                    e @ (ccd::gpu::Error::TooLarge { .. } | ccd::gpu::Error::OutOfMemory { .. }),
                ) => {
                    let _ = writeln!(text, "| {title} | | | | | | {e} |");
                    continue;
                }
                Err(e) => return Err(e),
            };
            assert_eq!(found, pairs, "pairs of {n} boxes by {name}");
            let measured = sample(runs, |timing| -> Result<Stages, ccd::gpu::Error> {
                broad.set_timing(timing)?;
                broad.again()?;
                Ok(broad.stages().to_vec())
            })?;
            // Each box once for its bounds and its code, once into the leaves; the sort as below.
            let bytes = n as f64 * (24.0 * 3.0 + 16.0 + 80.0);
            row(text, &title, &measured, bytes, peer, &format!("{pairs} pairs"));
        }
    }
    Ok(())
}

fn measure_sort(device: &Device, runs: usize, text: &mut String) -> Result<(), ccd::gpu::Error> {
    let _ = writeln!(
        text,
        "\n### Sort of 32-bit keys with 32-bit values\n\n\
         | pairs | ms | Gpairs/s | count, passes | bytes alone, ms at 4.3 TB/s |\n\
         |---|---|---|---|---|"
    );
    for n in [100_000u32, 1_000_000, 10_000_000] {
        let keys: Vec<u32> = (0..n).map(pcg).collect();
        let values: Vec<u32> = (0..n).collect();
        let mut sorter = Sorter::new(device, n)?;
        let (sorted, order) = sorter.sort(&keys, &values)?;
        assert!(
            sorted.is_sorted() && order.iter().zip(&sorted).all(|(&i, &k)| keys[i as usize] == k),
            "not sorted"
        );
        let kernels = warm(runs, || sorter.again())?;
        let names: Vec<&str> = kernels[0].iter().map(|s| s.0).collect();
        let stages: Vec<(&str, f64)> =
            (0..names.len()).map(|i| (names[i], median(kernels.iter().map(|k| k[i].1)))).collect();
        let total: f64 = stages.iter().map(|s| s.1).sum();
        let sum =
            |name: &str| stages.iter().filter(|s| s.0.starts_with(name)).map(|s| s.1).sum::<f64>();
        let parts = format!("{:.3}, {:.3}", sum("sort_count"), sum("sort_scatter"));
        let floor = n as f64 * 68.0 / COPY * 1e3;
        let _ = writeln!(
            text,
            "| {n} | {total:.3} | {:.2} | {parts} | {floor:.3} |",
            n as f64 / total / 1e6
        );
    }
    Ok(())
}
