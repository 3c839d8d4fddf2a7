//! Real scenes, beside times of other libraries; and what the order of contacts and completeness
//! cost there.

use super::ties::{self, Ties};
use crate::cells::Cells;
use crate::gpu::{Measured, of_session};
use crate::markdown::{Table, digits, thousands};
use crate::measure::{Place, median, median_of, timed, warm};
use crate::peers::PEERS;
use ccd::gpu::{self, Device, DeviceOptions};
use ccd::{Digest, Mesh, Mode, Options, Session};
use ccd_testkit::compare::contact_digest;
use ccd_testkit::data::Scene;
use serde_json::{Value, json};
use std::path::Path;
use std::sync::Arc;

/// Runs of each measurement; medians are reported.
pub const RUNS: usize = 25;
/// Entries that all lists are cut down to, so that a frame must run again.
const TOO_FEW: u32 = 1024;

/// Names of the scenes.
pub fn names() -> impl Iterator<Item = &'static str> {
    PEERS.iter().map(|peer| peer.scene)
}

struct Input {
    mesh: Arc<Mesh>,
    x: [Vec<[f64; 3]>; 2],
}

/// Measurements of a scene, as they are kept: of a GPU, if there is one, and of the CPU.
pub struct Results {
    scene: &'static str,
    gpu: Option<Value>,
    cpu: Value,
    ties: Ties,
}

/// A number of a cell.
fn number(cell: &Value, name: &str) -> Option<f64> {
    cell[name].as_f64()
}

/// A number of a cell as text; empty if there is none.
fn shown(cell: Option<&Value>, name: &str) -> String {
    cell.and_then(|cell| number(cell, name)).map_or(String::new(), digits)
}

/// Measures these scenes at all places; `None` for one that is left for another run.
pub fn all(
    places: &[Place],
    wanted: &dyn Fn(&str) -> bool,
    data: &Path,
    runs: usize,
    cells: &mut Cells,
) -> Result<Vec<Results>, String> {
    let mut all = Vec::new();
    for name in names().filter(|name| wanted(name)) {
        let [t0, t1] = Scene::named(name).load(data);
        let mesh = Arc::new(t0.mesh().map_err(|e| e.to_string())?);
        let input = Input { mesh, x: [t0.positions, t1.positions] };
        let (mut gpu, mut cpu) = (None, None);
        for place in places {
            let cell = cells.get(&format!("{name}|{runs}|{}", place.name()), || {
                let cell = match place {
                    Place::Gpu { device, .. } => on_gpu(device, &input, runs),
                    Place::Cpu { threads } => on_cpu(*threads, &input, runs).map_err(Into::into),
                };
                let cell = cell.map_err(|e| format!("{name}: {e}"))?;
                println!("{name}, {}: {cell}", place.name());
                Ok(cell)
            })?;
            *(if place.threads() == 0 { &mut gpu } else { &mut cpu }) = cell;
        }
        let threads = places.iter().map(Place::threads).max().unwrap_or(1);
        let ties = cells.get(&format!("{name}|ties"), || {
            ties::measure(&input.mesh, [&input.x[0], &input.x[1]], threads, runs)
        })?;
        let (Some(cpu), Some(ties)) = (cpu, ties) else { continue };
        if let Some(on_gpu) = &gpu {
            for what in ["candidates", "contacts"] {
                if on_gpu[what] != cpu[what] {
                    let (gpu, cpu) = (&on_gpu[what], &cpu[what]);
                    return Err(format!("{name}: {what} on the GPU {gpu}, on the CPU {cpu}"));
                }
            }
            let toi = [on_gpu, &cpu].map(|cell| number(cell, "toi").unwrap_or(f64::MAX));
            if (toi[0] - toi[1]).abs() > 2.0 * ccd::TOI_TOLERANCE {
                return Err(format!("{name}: earliest on the GPU and the CPU: {toi:?}"));
            }
        }
        all.push(Results { scene: name, gpu, cpu, ties });
    }
    Ok(all)
}

fn options() -> Options {
    Options::default()
}

fn on_gpu(device: &Device, input: &Input, runs: usize) -> Result<Value, gpu::Error> {
    let Input { mesh, x: [x0, x1] } = input;
    let mut session = gpu::Session::new(device, mesh.clone(), options())?;
    let found = session.candidates(x0, x1)?;
    let candidates = digest_of(found.vf.iter().copied(), found.ee.iter().copied());
    let contacts = contact_digest(&session.step(x0, x1)?.contacts).to_string();
    let all = of_session(&mut session, runs, |s| s.candidates_on_device(x0, x1).map(|_| ()))?;
    let step = of_session(&mut session, runs, |s| s.step(x0, x1).map(|_| ()))?;
    let earliest = of_session(&mut session, runs, |s| s.earliest_toi(x0, x1).map(|_| ()))?;
    let toi = session.report().toi;
    session.set_timing(gpu::Timing::Off)?;
    // Every list too short, and the step after that, in turn.
    let (mut again, mut kept, mut grown) = (Vec::new(), Vec::new(), 0);
    for _ in 0..runs {
        session.reserve(TOO_FEW)?;
        let before = session.grown();
        for times in [&mut again, &mut kept] {
            let (ms, done) = timed(|| session.step(x0, x1).map(|_| ()));
            done?;
            times.push(ms);
        }
        grown = session.grown() - before;
    }
    let mut exact = gpu::Session::new(device, mesh.clone(), options().with_mode(Mode::Exact))?;
    let [early, exact] =
        in_turn(runs, || session.step(x0, x1).map(|_| ()), || exact.step(x0, x1).map(|_| ()))?;
    let narrow = DeviceOptions { narrow: true, ..DeviceOptions::default() };
    let mut narrow = gpu::Session::new(&Device::open(&narrow)?, mesh.clone(), options())?;
    let (without, ()) = median_of(runs, || narrow.step(x0, x1).map(|_| ()))?;
    let stage = |m: &Measured, word: &str| {
        m.stages.iter().filter(|s| s.0.starts_with(word)).fold(0.0, |sum, s| sum + s.1)
    };
    Ok(json!({
        "candidates": candidates, "contacts": contacts, "toi": toi,
        "candidates ms": all.device, "candidates wall": all.wall,
        "step ms": step.device, "step wall": step.wall,
        "earliest ms": earliest.device, "earliest wall": earliest.wall,
        "order": stage(&step, "order"), "decide": stage(&step, "decide"),
        "again": median(again), "kept": median(kept), "runs": grown,
        "early": early, "exact": exact, "narrow": without,
    }))
}

fn on_cpu(threads: usize, input: &Input, runs: usize) -> Result<Value, ccd::Error> {
    let Input { mesh, x: [x0, x1] } = input;
    let options = options().with_threads(threads);
    let mut session = Session::new(mesh.clone(), options.clone())?;
    let found = session.candidates(x0, x1)?;
    let candidates = digest_of(found.vf.iter(), found.ee.iter());
    let (all, ()) = median_of(runs, || session.candidates(x0, x1).map(|_| ()))?;
    let contacts = contact_digest(&session.step(x0, x1)?.contacts).to_string();
    let steps = warm(runs, || {
        let (ms, done) = timed(|| session.step(x0, x1).map(|_| ()));
        done.map(|()| (ms, session.order_ms()))
    })?;
    let [step, order] = [median(steps.iter().map(|s| s.0)), median(steps.iter().map(|s| s.1))];
    let (earliest, toi) = median_of(runs, || session.earliest_toi(x0, x1))?;
    let mut early = Session::new(mesh.clone(), options.with_mode(Mode::Conservative))?;
    let [early, exact] =
        in_turn(runs, || early.step(x0, x1).map(|_| ()), || session.step(x0, x1).map(|_| ()))?;
    Ok(json!({
        "candidates": candidates, "contacts": contacts, "toi": toi, "candidates wall": all,
        "step wall": step, "earliest wall": earliest, "order": order,
        "early": early, "exact": exact,
    }))
}

/// Digest of pairs of both kinds.
fn digest_of(vf: impl Iterator<Item = ccd::Pair>, ee: impl Iterator<Item = ccd::Pair>) -> String {
    let mut digest = Digest::of(0, vf);
    ee.for_each(|pair| digest.add(1, pair));
    digest.to_string()
}

/// Medians of two calls in turn, so that a machine that is busy for a while is so for both.
fn in_turn<E>(
    runs: usize,
    mut one: impl FnMut() -> Result<(), E>,
    mut other: impl FnMut() -> Result<(), E>,
) -> Result<[f64; 2], E> {
    let both = warm(runs, || {
        let ((a, one), (b, other)) = (timed(&mut one), timed(&mut other));
        one.and(other).map(|()| [a, b])
    })?;
    Ok([0, 1].map(|k| median(both.iter().map(|ms| ms[k]))))
}

/// How many a digest has.
fn count(cell: &Value, what: &str) -> String {
    let digest = cell[what].as_str().unwrap_or_default();
    let count = digest.split(' ').next().and_then(|count| count.parse().ok());
    count.map_or(String::new(), thousands)
}

/// The table of scenes.
pub fn table(all: &[Results]) -> String {
    let mut table = Table::new(["scene", "what", "GPU", "wall", "CPU", "beside", "its time"]);
    for Results { scene, gpu, cpu, .. } in all {
        let gpu = gpu.as_ref();
        let peer = PEERS.iter().find(|peer| peer.scene == *scene);
        let [edges, faces] = peer.map_or([""; 2], |peer| peer.kitten);
        let scalable = peer.map_or("", |peer| peer.scalable);
        let mut row = |what: &str, name: &str, beside: &str, theirs: &str| {
            let [ms, wall] = ["ms", "wall"].map(|of| shown(gpu, &format!("{name} {of}")));
            let on_cpu = shown(Some(cpu), &format!("{name} wall"));
            table.row([*scene, what, &ms, &wall, &on_cpu, beside, theirs]);
        };
        let [candidates, contacts] = ["candidates", "contacts"].map(|what| count(cpu, what));
        row(&format!("{candidates} candidates, listed"), "candidates", "Kitten, edges", edges);
        if !faces.is_empty() {
            row("", "", "Kitten, faces", faces);
        }
        row(&format!("{contacts} contacts"), "step", "Scalable-CCD, earliest", scalable);
        row("earliest time of impact", "earliest", "", "");
        if gpu.is_some() {
            let wall = shown(gpu, "narrow");
            table.row([*scene, "contacts, no `f64` on the device", "", &wall, "", "", ""]);
        }
    }
    table.to_string()
}

/// What the order of contacts costs: with it, without it, and their ratio.
pub fn order(all: &[Results]) -> String {
    let columns = ["scene", "contacts", "where", "ordered", "not ordered", "the order", "of all"];
    let mut table = Table::new(columns);
    for Results { scene, gpu, cpu, .. } in all {
        let on_gpu = gpu.as_ref().map(|cell| ("GPU", cell, "step ms"));
        for (place, cell, step) in on_gpu.into_iter().chain([("CPU", cpu, "step wall")]) {
            let [step, order] = [step, "order"].map(|of| number(cell, of).unwrap_or(f64::NAN));
            let of_all = format!("{:.1} %", 100.0 * order / step);
            let [with, without, alone] = [step, step - order, order].map(digits);
            let (alone, of_all) = if order == 0.0 {
                ("by the host".to_owned(), String::new())
            } else {
                (alone, of_all)
            };
            let contacts = count(cell, "contacts");
            table.row([*scene, &contacts, place, &with, &without, &alone, &of_all]);
        }
    }
    table.to_string()
}

/// What completeness costs: lists that are too short, decisions in `f64`, exact decisions.
pub fn completeness(all: &[Results]) -> String {
    let mut text = String::new();
    let mut table = Table::new(["scene", "step, wall", "lists too short, wall", "runs again"]);
    let mut decide = Table::new(["scene", "step, GPU", "decisions in `f64`", "of all"]);
    for Results { scene, gpu, .. } in all {
        let Some(cell) = gpu.as_ref() else { continue };
        let runs = cell["runs"].to_string();
        let [step, again] = ["kept", "again"].map(|of| shown(Some(cell), of));
        table.row([*scene, &step, &again, &runs]);
        let [ms, decided] = ["step ms", "decide"].map(|of| number(cell, of).unwrap_or(f64::NAN));
        let of_all = format!("{:.1} %", 100.0 * decided / ms);
        decide.row([*scene, &digits(ms), &digits(decided), &of_all]);
    }
    if all.iter().any(|of| of.gpu.is_some()) {
        text += &format!("{table}\n{decide}\n");
    }
    let mut table = Table::new([
        "scene",
        "ties",
        "left open, 1 thread",
        "decided, 1 thread",
        "of them contacts",
    ]);
    for Results { scene, ties, .. } in all {
        let ms = |ms: f64| if ties.n > 0 { digits(ms) } else { String::new() };
        let [open, decided] = [ties.open_ms, ties.decided_ms].map(ms);
        let [n, contacts] = [ties.n, ties.contacts].map(thousands);
        table.row([*scene, &n, &open, &decided, &contacts]);
    }
    text += &format!("{table}\n");
    let mut table = Table::new(["scene", "where", "conservative, wall", "exact, wall", "ratio"]);
    for Results { scene, gpu, cpu, .. } in all {
        let on_gpu = gpu.as_ref().map(|cell| ("GPU", cell));
        for (place, cell) in on_gpu.into_iter().chain([("CPU", cpu)]) {
            let [early, exact] = ["early", "exact"].map(|of| number(cell, of).unwrap_or(f64::NAN));
            let ratio = format!("{:.2}", exact / early);
            table.row([*scene, place, &digits(early), &digits(exact), &ratio]);
        }
    }
    text + &table.to_string()
}
