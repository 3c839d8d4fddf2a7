//! `cargo xtask report --gpu`: what a GPU needs for each stage, for whole steps, for sorting, and how far that is from the bytes that must move.

use ccd::gpu::{BroadPhase, Device, DeviceOptions, Path as Shaders, Session, Sorter};
use ccd_testkit::data::{SCENES, Scene, data_dir};
use ccd_testkit::generate::{pcg, uniform_boxes};
use std::fmt::Write as _;
use std::path::Path;
use std::time::{Duration, Instant};

/// Work before a measurement: a device that was idle needs about this long to reach its clock again.
const WARM_UP: Duration = Duration::from_millis(300);
/// Bytes a second that an NVIDIA H200 copies, as TARGETS of the project state it; floors on other devices do not follow from it.
const COPY: f64 = 4.3e12;

type Stages = Vec<(&'static str, f64)>;

/// Measures and writes Markdown to `out`.
pub fn run(runs: usize, out: &Path) -> Result<(), String> {
    let dir = data_dir()?;
    let mut text =
        String::from("# GPU: measured times\n\n`cargo xtask report --gpu`. Milliseconds, medians. Stages by timestamps of the device; ");
    text.push_str("wall clock with upload, waiting and reading back.\n");
    for path in [Shaders::Passthrough, Shaders::Wgsl] {
        let device = Device::open(&DeviceOptions { path: Some(path), ..DeviceOptions::default() }).map_err(error)?;
        let _ = write!(text, "\n## {} through {path:?}\n\n```\n{}\n```\n", device.info().adapter.name, device.info());
        for scene in SCENES.iter().filter(|s| dir.join("scenes").join(s.name).is_dir()) {
            measure_scene(&device, scene, &dir, runs, &mut text).map_err(error)?;
        }
        measure_boxes(&device, runs, &mut text).map_err(error)?;
        measure_sort(&device, runs, &mut text).map_err(error)?;
    }
    let device = Device::open(&DeviceOptions { narrow: true, ..DeviceOptions::default() }).map_err(error)?;
    text.push_str("\n## Queries that reach each stage, with `f32` alone on the device\n\n");
    text.push_str("| scene | candidates | left by the filters | left open by `f32`, decided on the CPU | contacts | undecided | wall |\n");
    text.push_str("|---|---|---|---|---|---|---|\n");
    for scene in SCENES.iter().filter(|s| dir.join("scenes").join(s.name).is_dir()) {
        measure_narrow(&device, scene, &dir, runs, &mut text).map_err(error)?;
    }
    std::fs::write(out, &text).map_err(|e| format!("{}: {e}", out.display()))?;
    println!("{text}");
    Ok(())
}

fn error(e: ccd::gpu::Error) -> String {
    e.to_string()
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

/// Medians of the stages and of wall clock, after a warm-up; stages of the same name are numbered.
fn sample<E>(runs: usize, mut run: impl FnMut(bool) -> Result<Stages, E>) -> Result<(Vec<(String, f64)>, f64), E> {
    let mut wall = Vec::new();
    let start = Instant::now();
    run(false)?;
    while start.elapsed() < WARM_UP {
        run(false)?;
    }
    for _ in 0..runs {
        let start = Instant::now();
        run(false)?;
        wall.push(start.elapsed().as_secs_f64() * 1e3);
    }
    let mut timed: Vec<Stages> = Vec::new();
    let start = Instant::now();
    while timed.len() < runs || start.elapsed() < WARM_UP {
        timed.push(run(true)?);
    }
    // Now and then a call goes another way (the earliest time tries a sample again): the way that most went.
    let usual = |n: usize| timed.iter().filter(|s| s.len() == n).count();
    let n_stages = timed.iter().map(Vec::len).max_by_key(|&n| usual(n)).unwrap_or(0);
    timed.retain(|s| s.len() == n_stages);
    let mut columns: Vec<(String, f64)> = Vec::new();
    for i in 0..n_stages {
        let name = timed[0][i].0;
        let again = timed[0][..i].iter().filter(|s| s.0 == name).count();
        let name = if again == 0 { name.to_string() } else { format!("{name} {}", again + 1) };
        columns.push((name, median(&mut timed.iter().map(|s| s[i].1).collect::<Vec<_>>())));
    }
    Ok((columns, median(&mut wall)))
}

fn table(text: &mut String, title: &str, stages: &[(String, f64)], wall: f64, note: &str) {
    let total: f64 = stages.iter().map(|s| s.1).sum();
    let parts: Vec<String> = stages.iter().filter(|s| s.1 > 0.0).map(|(name, ms)| format!("{name} {ms:.3}")).collect();
    let _ = writeln!(text, "| {title} | {total:.3} | {wall:.2} | {} | {note} |", parts.join(", "));
}

fn measure_scene(device: &Device, scene: &Scene, dir: &Path, runs: usize, text: &mut String) -> Result<(), ccd::gpu::Error> {
    let [t0, t1] = scene.load(dir);
    let mesh = t0.mesh().map_err(ccd::gpu::Error::Input)?;
    let (x0, x1) = (&t0.positions, &t1.positions);
    let want = ccd::step(&mesh, x0, x1, &ccd::Options::default())?;
    let mut session = Session::new(device, mesh, ccd::Options::default())?;
    let _ = writeln!(text, "\n### {}\n\n| | device | wall | stages | |\n|---|---|---|---|---|", scene.name);
    let (stages, wall) = sample(runs, |timed| -> Result<Stages, ccd::gpu::Error> {
        session.time_stages(timed)?;
        session.candidates_on_device(x0, x1)?;
        Ok(session.stages().to_vec())
    })?;
    assert_eq!(session.report().candidates, want.candidates, "candidates of {}", scene.name);
    let c = want.candidates;
    table(text, "candidates, listed on the device", &stages, wall, &format!("{} vertex-face, {} edge-edge", c.vf, c.ee));
    let (stages, wall) = sample(runs, |timed| -> Result<Stages, ccd::gpu::Error> {
        session.time_stages(timed)?;
        session.step(x0, x1)?;
        Ok(session.stages().to_vec())
    })?;
    let report = session.report();
    assert_eq!(report.n_contacts(), want.n_contacts(), "contacts of {}", scene.name);
    let (f, n) = (report.filtered, report.n_contacts());
    let note = format!("filtered {} + {}, contacts {} + {}, {} undecided", f.vf, f.ee, n.vf, n.ee, report.undecided);
    table(text, "step, all contacts", &stages, wall, &note);
    let (stages, wall) = sample(runs, |timed| -> Result<Stages, ccd::gpu::Error> {
        session.time_stages(timed)?;
        session.earliest_toi(x0, x1)?;
        Ok(session.stages().to_vec())
    })?;
    let (toi, exact) = (session.report().toi, want.toi);
    assert!(toi.is_some() == exact.is_some() && toi <= exact, "earliest {toi:?}, want {exact:?}");
    table(text, "earliest time of impact", &stages, wall, &format!("{toi:?}"));
    Ok(())
}

/// One line for a scene: how many pairs each stage sees.
fn measure_narrow(device: &Device, scene: &Scene, dir: &Path, runs: usize, text: &mut String) -> Result<(), ccd::gpu::Error> {
    let [t0, t1] = scene.load(dir);
    let mesh = t0.mesh().map_err(ccd::gpu::Error::Input)?;
    let mut session = Session::new(device, mesh, ccd::Options::default())?;
    let (_, wall) = sample(runs, |_| session.step(&t0.positions, &t1.positions).map(|_| Stages::new()))?;
    let (report, open) = (session.report(), session.left_open());
    let (c, f, n) = (report.candidates, report.filtered, report.n_contacts());
    let _ = writeln!(
        text,
        "| {} | {} + {} | {} + {} | {} + {} | {} + {} | {} | {wall:.2} |",
        scene.name, c.vf, c.ee, f.vf, f.ee, open.vf, open.ee, n.vf, n.ee, report.undecided
    );
    Ok(())
}

fn measure_boxes(device: &Device, runs: usize, text: &mut String) -> Result<(), ccd::gpu::Error> {
    let _ = writeln!(
        text,
        "\n### Uniform boxes against themselves, boxes on the device\n\n| | device | wall | stages | |\n|---|---|---|---|---|"
    );
    for (n, pairs) in [(100_000, 320), (1_000_000, 25_417), (10_000_000, 255_457)] {
        let mut broad = BroadPhase::new(device)?;
        let found = match broad.self_pairs_on_device(&uniform_boxes(n)) {
            Ok((found, _)) => found,
            Err(e @ (ccd::gpu::Error::TooLarge { .. } | ccd::gpu::Error::OutOfMemory { .. })) => {
                let _ = writeln!(text, "| {n} | | | | {e} |");
                continue;
            }
            Err(e) => return Err(e),
        };
        assert_eq!(found, pairs, "pairs of {n} boxes");
        let (stages, wall) = sample(runs, |timed| -> Result<Stages, ccd::gpu::Error> {
            broad.time_stages(timed)?;
            broad.again()?;
            Ok(broad.stages().to_vec())
        })?;
        // Each box once for its bounds and its code, once into the leaves; the sort as below.
        let floor = n as f64 * (24.0 * 3.0 + 16.0 + 80.0) / COPY * 1e3;
        table(text, &n.to_string(), &stages, wall, &format!("{pairs} pairs; bytes alone {floor:.3} at 4.3 TB/s"));
    }
    Ok(())
}

fn measure_sort(device: &Device, runs: usize, text: &mut String) -> Result<(), ccd::gpu::Error> {
    let _ = writeln!(
        text,
        "\n### Sort of 32-bit keys with 32-bit values\n\n| pairs | ms | Gpairs/s | count, scan, scatter | bytes alone, ms at 4.3 TB/s |\n|---|---|---|---|---|"
    );
    for n in [100_000u32, 1_000_000, 10_000_000] {
        let keys: Vec<u32> = (0..n).map(pcg).collect();
        let values: Vec<u32> = (0..n).collect();
        let mut sorter = Sorter::new(device, n)?;
        let (sorted, order) = sorter.sort(&keys, &values)?;
        assert!(sorted.is_sorted() && order.iter().zip(&sorted).all(|(&i, &k)| keys[i as usize] == k), "not sorted");
        let (stages, _) = sample(runs, |_| sorter.again())?;
        let total: f64 = stages.iter().map(|s| s.1).sum();
        let of = |name: &str| stages.iter().filter(|s| s.0.starts_with(name)).map(|s| s.1).sum::<f64>();
        let parts = format!("{:.3}, {:.3}, {:.3}", of("sort_count"), of("sort_scan"), of("sort_scatter"));
        let floor = n as f64 * 80.0 / COPY * 1e3;
        let _ = writeln!(text, "| {n} | {total:.3} | {:.2} | {parts} | {floor:.3} |", n as f64 / total / 1e6);
    }
    Ok(())
}
