//! `ccd sequence`: a session over many frames.

use super::check::{mesh_of, same_topology, step};
use super::output::{self, Counts, MeshSize, TimesMs};
use super::{Failure, Outcome, StepOptions, frames, plot};
use ccd::any::Session;
use ccd::io::{Frame, read_frame};
use clap::Args;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::time::Instant;

#[derive(Args)]
pub struct Sequence {
    /// Frames of one mesh (.ply or .obj), two or more: files in order, or folders and patterns,
    /// whose files are taken by name, f2 before f10
    #[arg(required = true, value_name = "FRAMES")]
    frames: Vec<PathBuf>,
    /// Print a JSON object a line: one for each step as soon as it is done, then the summary
    #[arg(long, conflicts_with = "json")]
    json_lines: bool,
    #[command(flatten)]
    pub options: StepOptions,
}

#[derive(Serialize)]
struct Step {
    frame: usize,
    /// The file of the step's end.
    file: String,
    candidates: Counts,
    contacts: Counts,
    undecided: u64,
    toi: Option<f64>,
    rebuilt: bool,
    times_ms: TimesMs,
}

#[derive(Serialize)]
struct Json<'a> {
    mesh: MeshSize,
    backend: &'static str,
    adapter: Option<&'a str>,
    precision: &'static str,
    threads: Option<usize>,
    steps: Vec<Step>,
    summary: Summary,
}

#[derive(Serialize)]
struct Summary {
    steps: usize,
    contacts: u64,
    undecided: u64,
    free_steps: usize,
    rebuilt: usize,
    median_ms: f64,
    total_ms: f64,
}

impl Sequence {
    pub fn run(&self) -> Outcome {
        let mut file = self.options.contact_file(true)?;
        let (frames, is_unsorted) = frames::expand(&self.frames)?;
        if is_unsorted {
            eprintln!("ccd: the frames are not in the order of the numbers in their names");
        }
        let load_start = Instant::now();
        let mut before: Frame = read_frame(&frames[0])?;
        let mut session = self.options.session(mesh_of(&frames[0], &before)?)?;
        let mut load = load_start.elapsed().as_secs_f64() * 1e3;
        let bar = output::progress(frames.len() - 1, "steps");
        let mut steps: Vec<Step> = Vec::new();
        let is_text = self.options.prints_text() && !self.json_lines;
        if is_text {
            output::line("mesh", MeshSize::from(session.mesh()));
            output::say!(
                "{:>6} {:>9} {:>9} {:>10} {:>12} {:>10} {:>6}  to",
                "frame",
                "vf",
                "ee",
                "undecided",
                "earliest",
                "step",
                "trees"
            );
        }
        for (i, paths) in frames.windows(2).enumerate() {
            let start = Instant::now();
            let after = read_frame(&paths[1])?;
            same_topology((&paths[0], &before), (&paths[1], &after))?;
            load += start.elapsed().as_secs_f64() * 1e3;
            step(&mut session, self.options.precision, (&paths[0], &before), (&paths[1], &after))?;
            let report = session.report();
            let row = Step {
                frame: i,
                file: paths[1].display().to_string(),
                candidates: report.candidates.into(),
                contacts: report.n_contacts().into(),
                undecided: report.undecided,
                toi: report.toi,
                rebuilt: report.rebuilt,
                times_ms: TimesMs::new(load, report),
            };
            if let Some(file) = &mut file {
                file.write(i, &report.contacts)?;
            }
            if self.json_lines {
                bar.suspend(|| output::json(&row))?;
            } else if is_text {
                bar.suspend(|| print(&row));
            }
            steps.push(row);
            bar.inc(1);
            before = after;
            load = 0.0;
        }
        bar.finish_and_clear();
        let ends = [&*frames[0], &*frames[frames.len() - 1]];
        self.finish(&session, ends, steps)
    }

    fn finish(&self, session: &Session, ends: [&Path; 2], steps: Vec<Step>) -> Outcome {
        let summary = summarise(&steps);
        if let Some(path) = &self.options.picture {
            let times: Vec<f64> = steps.iter().map(step_ms).collect();
            let contacts: Vec<f64> =
                steps.iter().map(|s| (s.contacts.vf + s.contacts.ee) as f64).collect();
            let title = output::title(&ends, &session.place());
            plot::write(path, &title, "frame", [("step, ms", &times), ("contacts", &contacts)])?;
        }
        let any = summary.contacts > 0;
        let place = session.place();
        if self.options.json {
            let (backend, precision) = (place.backend(), self.options.precision.name());
            let (mesh, adapter, threads) =
                (session.mesh().into(), place.adapter(), place.threads());
            output::json(&Json { mesh, backend, adapter, precision, threads, steps, summary })?;
        } else if self.json_lines {
            output::json(&summary)?;
        } else if self.options.prints_text() {
            let text = format!(
                "{} steps, {} of them free; {} contacts, {} undecided",
                summary.steps, summary.free_steps, summary.contacts, summary.undecided
            );
            output::line("summary", text);
            let ms = output::milliseconds;
            let text = format!(
                "median {} a step on {place}, {} in all; trees built in {} steps",
                ms(summary.median_ms),
                ms(summary.total_ms),
                summary.rebuilt
            );
            output::line("time", text);
        }
        output::flush();
        Ok::<_, Failure>(any)
    }
}

fn step_ms(s: &Step) -> f64 {
    s.times_ms.total - s.times_ms.load
}

fn summarise(steps: &[Step]) -> Summary {
    let mut times: Vec<f64> = steps.iter().map(step_ms).collect();
    times.sort_unstable_by(f64::total_cmp);
    Summary {
        steps: steps.len(),
        contacts: steps.iter().map(|s| s.contacts.vf + s.contacts.ee).sum(),
        undecided: steps.iter().map(|s| s.undecided).sum(),
        free_steps: steps.iter().filter(|s| s.toi.is_none()).count(),
        rebuilt: steps.iter().filter(|s| s.rebuilt).count(),
        median_ms: times[times.len() / 2],
        total_ms: times.iter().sum(),
    }
}

fn print(s: &Step) {
    let toi = s.toi.map_or("-".into(), |t| format!("{t:.6e}"));
    let trees = if s.rebuilt { "built" } else { "refit" };
    output::say!(
        "{:>6} {:>9} {:>9} {:>10} {:>12} {:>10} {:>6}  {}",
        s.frame,
        s.contacts.vf,
        s.contacts.ee,
        s.undecided,
        toi,
        output::milliseconds(step_ms(s)),
        trees,
        s.file
    );
}
