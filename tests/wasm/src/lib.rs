//! Steps of generated scenes, and their answers as numbers: a native test writes them
//! (`tests/answers.rs`), and a script prints them from the same functions compiled for WebAssembly
//! (`answers.mjs`). `cargo xtask wasm` compares the two. Exported functions take and return plain
//! numbers, so that no memory is shared with the script.

#![allow(unsafe_code, reason = "exported names, which nothing else here has")]

use ccd::method::{BroadPhaseMethod, Catalogued, Pipeline, Scheduling};
use ccd::scenes::{Step, crumpled_sheet, triangle_soup};
use ccd::{Bodies, BroadPhase, Digest, Error, Options, Pair, Report, Session};

/// How many scenes there are.
#[unsafe(no_mangle)]
pub extern "C" fn n_scenes() -> u32 {
    SCENES.len() as u32
}

/// How many ways of finding pairs there are.
#[unsafe(no_mangle)]
pub extern "C" fn n_ways() -> u32 {
    ways(&Options::default()).count() as u32
}

/// A digest of what is found in a scene in one way, bits of times included; `in_f32`: from
/// positions rounded to `f32`. `u64::MAX` if it is refused, which nothing here is.
#[unsafe(no_mangle)]
pub extern "C" fn answer(scene: u32, way: u32, in_f32: u32, threads: u32) -> u64 {
    let (step, options) = SCENES[scene as usize]();
    let Some(options) = ways(&options).nth(way as usize) else { return u64::MAX };
    let options = options.with_threads(threads as usize);
    let found = if in_f32 == 0 {
        digest(&step, options, &step.x0, &step.x1)
    } else {
        let [x0, x1] = step.rounded();
        digest(&step, options, &x0, &x1)
    };
    found.unwrap_or(u64::MAX)
}

/// Contacts in a scene.
#[unsafe(no_mangle)]
pub extern "C" fn n_contacts(scene: u32) -> u64 {
    first_report(scene).map_or(u64::MAX, |report| report.contacts.len() as u64)
}

/// Milliseconds that a step says it took.
#[unsafe(no_mangle)]
pub extern "C" fn milliseconds(scene: u32) -> f64 {
    first_report(scene).map_or(f64::NAN, |report| report.times.total)
}

/// Threads of a session and of a broad phase that were asked for so many; 0 if either is refused.
#[unsafe(no_mangle)]
pub extern "C" fn threads(wanted: u32) -> u32 {
    let wanted = wanted as usize;
    let session = Session::new(SCENES[0]().0.mesh, Options::default().with_threads(wanted));
    let broad = BroadPhase::new(wanted, BroadPhaseMethod::Blocks);
    match (session, broad) {
        (Ok(session), Ok(broad)) if session.threads() == broad.threads() => {
            session.threads() as u32
        }
        _ => 0,
    }
}

/// A scene and what is looked for in it.
type Scene = fn() -> (Step, Options);

const SCENES: [Scene; 3] = [
    || (crumpled_sheet(10, 1), Options::default()),
    || (triangle_soup(80, 0.3, 2), Options::default().with_min_distance(0.01)),
    || {
        let step = triangle_soup(60, 0.4, 3);
        // A body of three triangles each; every fifth does not move.
        let body: Vec<u32> = (0..step.mesh.n_vertices() as u32).map(|v| v / 9).collect();
        let fixed: Vec<bool> = (0..=body.len() / 9).map(|b| b % 5 == 0).collect();
        let mut still = step.x1.clone();
        for (v, x) in still.iter_mut().enumerate().filter(|(v, _)| fixed[body[*v] as usize]) {
            *x = step.x0[v];
        }
        let bodies = Bodies::new(&body).with_fixed_mask(&fixed).with_self_contacts(false);
        (Step { x1: still, ..step }, Options::default().with_bodies(bodies))
    },
];

/// Options with every method, then with every scheduling, then with every pipeline.
fn ways(options: &Options) -> impl Iterator<Item = Options> {
    let methods = ccd::method::every("cpu").map(|m| options.clone().with_broad_phase(m));
    let schedulings = Scheduling::every("cpu").map(|s| options.clone().with_scheduling(s));
    let pipelines = Pipeline::ROWS.iter().filter(|row| row.value.lacking("cpu").is_none());
    methods.chain(schedulings).chain(pipelines.map(|row| options.clone().with_pipeline(row.value)))
}

fn first_report(scene: u32) -> Result<Report, Error> {
    let (step, options) = SCENES[scene as usize]();
    ccd::step(&step.mesh, &step.x0, &step.x1, &options.with_threads(1))
}

/// Of candidates, contacts with their times and states, and the earliest time, in two steps of one
/// session: the second finds its trees built.
fn digest<T: ccd::Coordinate>(
    step: &Step,
    options: Options,
    x0: &[[T; 3]],
    x1: &[[T; 3]],
) -> Result<u64, Error> {
    let mut session = Session::new(step.mesh.clone(), options)?;
    let mut digest = Digest::default();
    let candidates = session.candidates(x0, x1)?;
    candidates.vf.iter().for_each(|pair| digest.add(0, pair));
    candidates.ee.iter().for_each(|pair| digest.add(1, pair));
    for _ in 0..2 {
        let report = session.step(x0, x1)?;
        for contact in &report.contacts {
            let kind = 2 + contact.kind as u32;
            digest.add(kind + 4 * contact.state as u32, Pair { a: contact.a, b: contact.b });
            digest.add(6, halves(contact.toi));
        }
    }
    let toi = session.earliest_toi(x0, x1)?;
    digest.add(7, halves(toi.unwrap_or(2.0)));
    Ok(digest.sum)
}

/// The bits of a number as a pair.
fn halves(x: f64) -> Pair {
    let bits = x.to_bits();
    Pair { a: (bits >> 32) as u32, b: bits as u32 }
}
