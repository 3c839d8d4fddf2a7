//! `ccd sequence`: a session over many frames.

use super::check::{self, step};
use super::frames::Frames;
use super::lines::{LastLine, Share, Step, Summary, digest_of, step_ms, summarise};
use super::objects::notice_folded;
use super::output::{self, MeshSize, TimesMs};
use super::part::Part;
use super::pixels::Picture;
use super::plot::Series;
use super::start::Intersections;
use super::{Failure, INPUT, OUTPUT, Outcome, StepOptions, backend, plot, progress, rows, toi};
use ccd::any::Session;
use ccd::io::{MESH_EXTENSIONS, PointCache, listed};
use clap::Args;
use serde::Serialize;
use std::path::PathBuf;
use std::time::Instant;

#[derive(Args)]
pub struct Sequence {
    #[arg(required = true, value_name = "FRAMES")]
    #[arg(help = format!("Frames of one mesh, two or more: files in order ({}), or folders and \
        patterns, whose files are taken by name, f2 before f10; or one file of positions over \
        time ({}) and --mesh", listed(&MESH_EXTENSIONS), listed(&PointCache::EXTENSIONS)))]
    frames: Vec<PathBuf>,
    /// The mesh of a file of positions over time; its own positions are not used
    #[arg(long, value_name = "MESH", help_heading = INPUT)]
    mesh: Option<PathBuf>,
    /// Print a JSON object a line: one for each step as soon as it is done, then the summary
    #[arg(long, conflicts_with = "json", help_heading = OUTPUT)]
    json_lines: bool,
    /// Do only share i of n of the steps, so that several machines do all of them
    ///
    /// `slurm`: i and n from SLURM_ARRAY_TASK_ID, _COUNT, _MIN and _STEP, which are read for
    /// this alone. `ccd merge` joins what --json-lines printed, and what --contacts wrote.
    #[arg(long, value_name = "i/n", allow_hyphen_values = true, help_heading = INPUT)]
    part: Option<Part>,
    #[command(flatten)]
    pub options: StepOptions,
}

#[derive(Serialize)]
struct Json<'a> {
    mesh: MeshSize,
    #[serde(flatten)]
    place: output::Place<'a>,
    #[serde(skip_serializing_if = "Option::is_none")]
    part: Option<Share>,
    steps: Vec<Step>,
    summary: Summary,
    #[serde(skip_serializing_if = "Option::is_none")]
    intersections: Option<Intersections>,
}

impl Sequence {
    pub fn run(&self) -> Outcome {
        self.options.check_outputs(self.json_lines.then_some("--json-lines"), None, &[])?;
        let picture = self.options.picture_file()?;
        let mut file = self.options.contact_file(true)?;
        let (mut frames, is_unsorted) = Frames::open(&self.frames, self.mesh.as_deref())?;
        if is_unsorted {
            output::notice!("the frames are in the order given, not in that of their numbers");
        }
        let all_steps = frames.len() - 1;
        let share =
            self.part.map(|part| Share { part, all_steps, asked: 0, frames: Default::default() });
        let todo = self.part.map_or(0..all_steps, |part| part.steps(all_steps));
        let load_start = Instant::now();
        let (mut before, mesh) = frames.first(todo.start)?;
        notice_folded(&frames.name(todo.start), &before);
        let polygons = before.polygons.clone();
        let mut session = self.options.session(mesh, None)?;
        let mut load = load_start.elapsed().as_secs_f64() * 1e3;
        let precision = self.options.precision;
        let is_first = self.part.is_none_or(|part| part.index == 1);
        let first = frames.name(0);
        let share = share.map(|share| {
            let frames = [digest_of(&before.positions); 2];
            Share { asked: self.options.asked(session.options()), frames, ..share }
        });
        let start = is_first.then(|| {
            check::look_at_start(&mut session, &self.options, &before, |_, vertex| (&first, vertex))
        });
        let start = start.transpose()?;
        let bar = progress::bar(todo.len(), "steps");
        let mut steps: Vec<Step> = Vec::new();
        let is_text = self.options.prints_text() && !self.json_lines;
        if is_text {
            print_head(&session, share);
        }
        for i in todo.clone() {
            let start = Instant::now();
            let after = frames.next(&before, i + 1)?;
            load += start.elapsed().as_secs_f64() * 1e3;
            let [path_0, path_1] = [i, i + 1].map(|at| frames.name(at));
            let place =
                |time: u32, vertex| (if time == 0 { path_0.as_path() } else { &path_1 }, vertex);
            step(&mut session, precision, [&before, &after], [0.0, 1.0], place)?;
            let report = session.report();
            let row = Step {
                frame: i,
                file: path_1.display().to_string(),
                candidates: report.candidates.into(),
                contacts: report.n_contacts().into(),
                undecided: report.undecided,
                at_start: output::at_start(report),
                toi: report.toi,
                // The look at the first frame leaves trees to the first step.
                rebuilt: report.rebuilt || i == todo.start,
                triangles: report.triangles,
                front: report.front,
                times_ms: TimesMs::new(load, report, &session.place()),
            };
            if let Some(file) = &mut file {
                let [x0, x1] = [&before, &after].map(|frame| precision.round(&frame.positions));
                let mesh = session.mesh();
                let step = rows::Step { mesh, x0: &x0, x1: &x1, polygons: &polygons };
                file.contacts(Some(i), &report.contacts, &step)?;
            }
            if self.json_lines {
                bar.suspend(|| output::json(&row))?;
            } else if is_text {
                bar.suspend(|| print(&row, has_particles(&session)));
            }
            steps.push(row);
            bar.inc(1);
            before = after;
            load = 0.0;
        }
        bar.finish_and_clear();
        let share = share.map(|share| {
            let last = digest_of(&before.positions);
            Share { frames: [share.frames[0], last], ..share }
        });
        file.map_or(Ok(()), rows::Rows::done)?;
        if let Some(to) = picture {
            let [from, until] = [todo.start, todo.end].map(|at| frames.name(at));
            let distance = self.options.min_distance;
            let mut title = output::title(&[&from, &until], distance, &session.place());
            if let Some(Share { part, all_steps, .. }) = share {
                title += &format!("; part {} of {} of {all_steps} steps", part.index, part.of);
            }
            draw(to, &title, todo.start, &steps)?;
        }
        self.finish(&mut session, steps, share, start)
    }

    fn finish(
        &self,
        session: &mut Session,
        steps: Vec<Step>,
        part: Option<Share>,
        start: Option<Intersections>,
    ) -> Outcome {
        let summary = summarise(&steps);
        let compilation = backend::compilation(session);
        let any = summary.contacts > 0 || start.as_ref().is_some_and(|start| start.pairs > 0);
        let place = session.place();
        if self.options.json {
            let mesh = MeshSize::of(session.mesh());
            let place = output::Place::new(&place, Some(self.options.precision));
            output::json(&Json { mesh, place, part, steps, summary, intersections: start })?;
        } else if self.json_lines {
            let mesh = MeshSize::of(session.mesh());
            output::json(&LastLine { summary, mesh, part, intersections: start })?;
        } else if self.options.prints_text() {
            output::say!("{}", sentence(&steps, start.as_ref()));
            let text = format!(
                "{}, {} of them free; {}, {} undecided",
                output::counted(summary.steps as u64, "step"),
                summary.free_steps,
                output::counted(summary.contacts, "contact"),
                summary.undecided
            );
            output::line("summary", text);
            output::explain(
                summary.undecided,
                summary.at_start,
                self.options.min_distance,
                "the start",
            );
            let stays = summary.contacts == 0;
            start.iter().for_each(|start| start.print(stays));
            backend::print_compilation(compilation);
            let ms = output::milliseconds;
            let text = format!("median {} a step on {place}", ms(summary.median_ms));
            output::line("time", text);
            let text = format!(
                "{} in all; trees built in {} of {} steps",
                ms(summary.total_ms),
                summary.rebuilt,
                summary.steps
            );
            output::line("", text);
        }
        output::flush();
        Ok::<_, Failure>(any)
    }
}

/// Draws times and contacts of steps, of which the first has this number.
fn draw(to: Picture, title: &str, first: usize, steps: &[Step]) -> Result<(), Failure> {
    let times: Vec<f64> = steps.iter().map(step_ms).collect();
    let contacts: Vec<f64> = steps.iter().map(|s| s.contacts.total() as f64).collect();
    let tois: Vec<f64> = steps.iter().map(|s| s.toi.unwrap_or(f64::NAN)).collect();
    let series = [
        Series::new("time of a step, ms", &times),
        Series::new("contacts", &contacts),
        Series { top: Some(1.0), ..Series::new("earliest time of impact", &tois) },
    ];
    plot::write(to, title, ("step", first), series)
}

/// The first contact of all steps, for people.
fn sentence(steps: &[Step], start: Option<&Intersections>) -> String {
    match steps.iter().find_map(|step| step.toi.map(|time| (step, time))) {
        None if steps.is_empty() => "No step in this part.".into(),
        None => match start.and_then(Intersections::verb) {
            None => "No contact in any step.".into(),
            Some(verb) => format!("No contact in any step, but the first frame {verb}."),
        },
        Some((step, time)) => {
            let when = match time {
                0.0 => "at the start".into(),
                _ => toi::when(time),
            };
            format!("First contact {when} of step {}, to {}.", step.frame, name(step))
        }
    }
}

/// Name of the frame that a step ends with, without its folder.
fn name(step: &Step) -> std::borrow::Cow<'_, str> {
    let path = std::path::Path::new(&step.file);
    path.file_name().map_or(step.file.as_str().into(), |name| name.to_string_lossy())
}

fn print_head(session: &Session, share: Option<Share>) {
    output::line("mesh", MeshSize::of(session.mesh()));
    if let Some(Share { part, all_steps, .. }) = share {
        let steps = part.steps(all_steps);
        let text = match steps.is_empty() {
            true => "no step".into(),
            false => format!("steps {} to {}", steps.start, steps.end - 1),
        };
        let text = format!("{} of {}: {text} of {all_steps}", part.index, part.of);
        output::line("part", text);
    }
    let others =
        if has_particles(session) { format!(" {:>6} {:>6}", "ve", "vv") } else { String::new() };
    output::say!(
        "{:>6} {:>8} {:>8}{others} {:>6} {:>10} {:>8} {:>5}  to",
        "step",
        "vf",
        "ee",
        "undec.",
        "earliest",
        "time",
        "trees"
    );
}

/// Whether the mesh has particles, and so contacts of their kinds.
fn has_particles(session: &Session) -> bool {
    !session.mesh().isolated_vertices().is_empty()
}

fn print(s: &Step, has_particles: bool) {
    let earliest = s.toi.map_or("-".into(), |time| toi::short(time, 5));
    let trees = if s.rebuilt { "built" } else { "refit" };
    let others = match has_particles {
        true => format!(" {:>6} {:>6}", s.contacts.ve, s.contacts.vv),
        false => String::new(),
    };
    output::say!(
        "{:>6} {:>8} {:>8}{others} {:>6} {:>10} {:>8} {:>5}  {}",
        s.frame,
        s.contacts.vf,
        s.contacts.ee,
        s.undecided,
        earliest,
        output::milliseconds(step_ms(s)),
        trees,
        name(s)
    );
}
