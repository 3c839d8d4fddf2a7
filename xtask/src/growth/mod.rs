//! `cargo xtask report --growth`: real scenes beside other libraries, growth of times and bytes
//! from 10 thousand boxes to 100 million and from 10 thousand triangles to 10 million, and what the
//! order of contacts and completeness cost, in the tables of docs/PERFORMANCE.md, whose text stays
//! as it is, and plots beside it.
//!
//! A table stands between two comments, as in docs/ALGORITHMS.md. All places and methods must find
//! the same. The table of scenes is that of the README too, where it is measured on a GPU.

mod heap;
mod measure;
mod scenes;
mod series;
mod tables;
mod ties;

use crate::ChoiceOptions;
use crate::cells::Cells;
use crate::markdown::{rewrite, rewrite_alone, wrap};
use crate::measure::{Place, this_run};
use ccd_testkit::data::data_dir;
use series::{Limits, Work, sizes};
use std::path::Path;
use std::time::Instant;
use tables::Subject;

/// Most milliseconds that a call of a size may be expected to take.
const MOST: f64 = 20_000.0;
const MOST_OF_QUICK: f64 = 2000.0;

/// Measures all and rewrites the tables of PERFORMANCE.md.
pub fn run(root: &Path, options: &ChoiceOptions, mut cells: Cells) -> Result<(), String> {
    // Before files are written that git would see.
    let run = format!("Run: `cargo xtask {}`, {}.\n\n", command(), this_run(root));
    let folder = root.join(&options.folder);
    let plots = folder.join("performance");
    std::fs::create_dir_all(&plots).map_err(|e| format!("{plots:?}: {e}"))?;
    let (start, quick) = (Instant::now(), options.quick);
    let all = std::thread::available_parallelism().map_or(1, |n| n.get());
    let threads = options.threads.iter().copied().max().unwrap_or(all);
    let gpu = if options.no_gpu { None } else { Place::gpu() };
    let places: Vec<Place> = gpu.into_iter().chain([Place::Cpu { threads }]).collect();
    let wanted = |name: &str| {
        let named = options.scenes.iter().any(|part| name.contains(part.as_str()));
        if options.scenes.is_empty() { !quick || name == "cloth-funnel" } else { named }
    };
    let load = cells.get("load", || Ok(load()))?.unwrap_or_default();
    let runs = if quick { 3 } else { scenes::RUNS };
    let of_scenes = scenes::all(&places, &wanted, &data_dir()?, runs, &mut cells)?;
    println!("scenes: {:.0} s", start.elapsed().as_secs_f64());
    let limits = Limits { call: if quick { MOST_OF_QUICK } else { MOST } };
    let mut grow = |works: &[Work], elements, found| -> Result<String, String> {
        let sizes = sizes(elements == "boxes", quick);
        let series = series::all(&places, works, &sizes, &limits, &mut cells)?;
        println!("{elements}: {:.0} s", start.elapsed().as_secs_f64());
        let subject = Subject { elements, found, sizes: &sizes, places: &places, series: &series };
        if series.iter().all(|of| of.cells.len() == sizes.len()) {
            subject.text(&folder)
        } else {
            Ok(String::new())
        }
    };
    let triangles = grow(&Work::STEPS, "triangles", "contacts")?;
    let boxes = grow(&Work::BOXES, "boxes", "pairs")?;
    if !cells.are_complete() {
        return Ok(());
    }
    let (machine, table) = (run + &machine(&places, &load), scenes::table(&of_scenes));
    let of_readme = wrap(&format!("{machine}\n{table}"));
    let sections = [
        ("machine", machine),
        ("scenes", table),
        ("boxes", boxes),
        ("triangles", triangles),
        ("order", scenes::order(&of_scenes)),
        ("completeness", scenes::completeness(&of_scenes)),
    ];
    let sections = sections.map(|(name, text)| (name, wrap(&text)));
    rewrite(&folder.join("PERFORMANCE.md"), &sections)?;
    let readme = folder.join("../README.md");
    let is_real =
        |place: &Place| matches!(place, Place::Gpu { name, .. } if !name.starts_with("llvmpipe"));
    if places.iter().any(is_real) && !quick && readme.is_file() {
        rewrite_alone(&readme, "speed", &of_readme)?;
    }
    Ok(())
}

/// The command, without where results are kept, and for how long it may run.
fn command() -> String {
    let is_apart = |arg: &str| ["--cells", "--minutes", "--folder"].contains(&arg);
    let (mut command, mut args) = (Vec::new(), std::env::args().skip(1));
    while let Some(arg) = args.next() {
        if is_apart(&arg) {
            args.next();
        } else if !arg.split_once('=').is_some_and(|(name, _)| is_apart(name)) {
            command.push(arg);
        }
    }
    command.join(" ")
}

/// Processes that wanted to run in the last minute, on average; nothing where a system does not say
/// it.
fn load() -> String {
    let text = std::fs::read_to_string("/proc/loadavg").unwrap_or_default();
    text.split(' ').next().unwrap_or_default().to_owned()
}

/// Where it was measured, and how busy that was.
fn machine(places: &[Place], load: &str) -> String {
    let mut text = String::new();
    for place in places {
        match place {
            Place::Cpu { threads: 1 } => text += "- CPU: 1 thread of it.\n",
            Place::Cpu { threads } => text += &format!("- CPU: {threads} threads of it.\n"),
            Place::Gpu { device, name } => {
                let info = device.info();
                text += &format!(
                    "- GPU: {name}, driver {}, {:?} shaders.\n",
                    info.adapter.driver_info, info.path
                );
            }
        }
    }
    if places.iter().all(|place| place.threads() > 0) {
        text += "- No GPU was there: its columns are missing.\n";
    }
    if !load.is_empty() {
        text += &format!("- Load of the machine by other work when the run began: {load}.\n");
    }
    text
}
