//! `ccd check`: contacts between two frames.

use super::objects::{Files, Objects, mesh_of};
use super::output::{self, Counts, MeshSize, TimesMs};
use super::start::{self, Intersections};
use super::{
    Failure, INPUT, OUTPUT, Outcome, Precision, QUESTION, StepOptions, backend, files, in_file,
    look, picture, progress::Work, rows,
};
use ccd::any::{Error, Place, Session};
use ccd::io::{Frame, MESH_EXTENSIONS, listed};
use ccd::method::Front;
use ccd::{Contact, Kind};
use clap::Args;
use serde::Serialize;
use std::borrow::Cow;
use std::path::{Path, PathBuf};
use std::time::Instant;

#[derive(Args)]
pub struct Check {
    #[arg(value_name = "T0")]
    #[arg(help = format!("The mesh at the start of the step ({}; also by gzip, as .ply.gz); `-` \
        for one of the two is standard input", listed(&MESH_EXTENSIONS)))]
    t0: PathBuf,
    /// The same mesh at the end of the step
    #[arg(value_name = "T1")]
    t1: PathBuf,
    /// Another object: a file if it stands still, else two with a comma
    ///
    /// Its start and its end. May be given several times. Every object is a body, the first one
    /// being 0.
    #[arg(short = 'w', long = "with", value_name = "B0[,B1]", help_heading = INPUT)]
    others: Vec<Files>,
    /// Format of standard input; default: as its first bytes say
    #[arg(long, value_parser = MESH_EXTENSIONS, hide_short_help = true, help_heading = INPUT)]
    format: Option<String>,
    /// Only contacts that exist at some time from A to B in [0, 1]
    #[arg(long, value_name = "A,B", value_parser = window, allow_hyphen_values = true)]
    #[arg(help_heading = QUESTION)]
    window: Option<[f64; 2]>,
    /// Write and draw the N earliest contacts at most
    ///
    /// This limits files and the picture alone: all contacts are found and counted.
    #[arg(long, visible_alias = "limit", value_name = "N", allow_negative_numbers = true)]
    #[arg(help_heading = OUTPUT)]
    earliest: Option<usize>,
    /// Write the candidates, pairs whose swept boxes overlap, as CSV: kind,a,b, sorted
    ///
    /// They are those of the whole step: refused with a --window that is a part of it. `-` is
    /// standard output.
    #[arg(long, value_name = "OUT.csv", hide_short_help = true, help_heading = OUTPUT)]
    candidates: Option<PathBuf>,
    #[command(flatten)]
    look: look::Look,
    #[command(flatten)]
    pub options: StepOptions,
}

#[derive(Serialize)]
struct Json<'a> {
    mesh: MeshSize,
    candidates: Counts,
    contacts: Counts,
    undecided: u64,
    /// Contacts at t = 0.
    at_start: u64,
    /// Of the first frame with itself.
    intersections: &'a Intersections,
    toi: Option<f64>,
    #[serde(flatten)]
    place: output::Place<'a>,
    /// Compilation of kernels, on a GPU.
    compile_ms: Option<f64>,
    times_ms: TimesMs,
    /// Time of the check of the first frame.
    intersections_ms: f64,
}

impl Check {
    pub fn run(&self) -> Outcome {
        let files = [Files::moving(&self.t0, &self.t1)].into_iter().chain(self.others.clone());
        let files: Vec<Files> = files.collect();
        // Meshes are PLY, and so may contacts be.
        let read: Vec<&Path> = files.iter().flat_map(Files::paths).collect();
        self.options.check_outputs(None, self.candidates.as_deref(), &read)?;
        let window = self.window.unwrap_or([0.0, 1.0]);
        if self.candidates.is_some() && !start::is_whole(window) {
            let what = "--candidates are those of the whole step, --window is a part of it";
            return Err(Failure(format!("{what}: use one of the two")));
        }
        if self.earliest.is_some() && !self.options.shows_contacts() {
            output::notice!("--earliest has no effect without --contacts or --picture");
        }
        let picture = self.options.picture_file()?;
        let file = self.options.contact_file(false)?;
        let points = self.options.point_file()?;
        let listed = self.candidates.as_deref().map(|path| rows::Rows::create(path, "kind,a,b"));
        let listed = listed.transpose()?;
        let work = Work::new("reading meshes");
        let start = Instant::now();
        let objects = Objects::read(files, self.format.as_deref())?;
        let (t0, t1) = (&objects.start, &objects.end);
        let names = objects.first();
        let mesh = mesh_of(names[0], t0)?;
        let load = start.elapsed().as_secs_f64() * 1e3;

        work.goes_on("preparing the step");
        let mut session = self.options.session(mesh, objects.bodies())?;
        if session.options().scheduling.front != Front::Off {
            output::notice!("--front on has no effect on a single step; it is for `ccd sequence`");
        }
        let precision = self.options.precision;
        let place = |time, vertex| objects.place(time == 1, vertex);
        if let Some(file) = listed {
            work.goes_on("listing candidates");
            list_candidates(&mut session, precision, [t0, t1], place, file)?;
        }
        work.goes_on("looking for contacts");
        step(&mut session, precision, [t0, t1], window, place)?;
        work.goes_on("looking for intersections of the first frame");
        let start = look_at_start(&mut session, &self.options, t0, place)?;
        let compilation = backend::compilation(&mut session);
        let (mesh, report) = (session.mesh(), session.report());
        let shown = self.shown(&report.contacts);
        if file.is_some() || points.is_some() {
            work.goes_on("writing contacts");
            let [x0, x1] = [t0, t1].map(|frame| self.options.precision.round(&frame.positions));
            let step = rows::Step { mesh, x0: &x0, x1: &x1, polygons: &t0.polygons };
            if let Some(mut file) = file {
                file.contacts(None, &shown, &step)?;
                file.done()?;
            }
            if let Some(points) = points {
                points.write(&shown, &step)?;
            }
        }
        if let Some(to) = picture {
            work.goes_on("drawing the picture");
            let (distance, place) = (self.options.min_distance, session.place());
            let mut title = output::title(&names, distance, &place);
            match self.others.len() {
                0 => {}
                1 => title += "; with another object",
                n => title += &format!("; with {n} other objects"),
            }
            let title = &title;
            let x = [&t0.positions[..], &t1.positions];
            let (contacts, total) = (&shown[..], report.contacts.len());
            let scene = picture::Scene { title, mesh, x, contacts, total, window, look: self.look };
            picture::write(to, &scene)?;
        }
        drop(work);
        let contacts = report.n_contacts();
        if self.options.json {
            let place = session.place();
            output::json(&Json {
                mesh: MeshSize::of(mesh),
                candidates: report.candidates.into(),
                contacts: contacts.into(),
                undecided: report.undecided,
                at_start: output::at_start(report),
                intersections: &start,
                toi: report.toi,
                place: output::Place::new(&place, Some(precision)),
                compile_ms: compilation.map(|done| done.time.as_secs_f64() * 1e3),
                times_ms: TimesMs::new(load, report, &place),
                intersections_ms: start.ms,
            })?;
        } else if self.options.prints_text()
            && !self.candidates.as_deref().is_some_and(files::is_standard)
        {
            print(&session, &objects, &start, window, load, compilation);
        }
        output::flush();
        Ok(contacts.total() > 0 || start.pairs > 0)
    }

    /// The contacts that are written and drawn.
    fn shown<'a>(&self, contacts: &'a [Contact]) -> Cow<'a, [Contact]> {
        let Some(n) = self.earliest else { return Cow::Borrowed(contacts) };
        let mut all = contacts.to_vec();
        // Stable: equal times keep their order.
        all.sort_by(|a, b| a.toi.total_cmp(&b.toi));
        all.truncate(n);
        all.sort_unstable_by_key(|c| (c.kind as u8, c.a, c.b));
        Cow::Owned(all)
    }
}

fn list_candidates<'a>(
    session: &mut Session,
    precision: Precision,
    [t0, t1]: [&Frame; 2],
    place: impl Fn(u32, usize) -> (&'a Path, usize),
    mut file: rows::Rows,
) -> Result<(), Failure> {
    let found = match precision {
        Precision::F64 => session.candidates(&t0.positions, &t1.positions),
        Precision::F32 => session.candidates(&t0.positions_f32(), &t1.positions_f32()),
    };
    let found = found.map_err(|e| named(e, precision, place))?;
    for (kind, pairs) in Kind::ALL.into_iter().zip([found.vf, found.ee, found.ve, found.vv]) {
        file.pairs(kind, pairs.iter())?;
    }
    file.done()
}

fn print(
    session: &Session,
    objects: &Objects,
    start: &Intersections,
    window: [f64; 2],
    load: f64,
    compilation: Option<ccd::gpu::Compilation>,
) {
    let (mesh, report) = (session.mesh(), session.report());
    let contacts = report.n_contacts();
    output::say!("{}", start::sentence(report, start, window));
    output::line("mesh", MeshSize::of(mesh));
    if mesh.n_degenerate() > 0 {
        output::line(
            "",
            format_args!("faces and edges that name a vertex twice: {}", mesh.n_degenerate()),
        );
    }
    objects.print();
    let candidates = Counts::from(report.candidates);
    output::line("candidates", format_args!("{candidates} (swept boxes overlap)"));
    output::line(
        "contacts",
        format_args!("{} ({} undecided)", Counts::from(contacts), report.undecided),
    );
    let min_distance = session.options().min_distance;
    output::explain(report.undecided, output::at_start(report), min_distance, "the first frame");
    match report.toi {
        Some(toi) => output::line("earliest", format_args!("t = {toi:?}")),
        None => output::line("earliest", "none"),
    }
    start.print(start::is_whole(window) && contacts.total() == 0);
    backend::print_compilation(compilation);
    let (t, ms, place) = (report.times, output::milliseconds, session.place());
    let parts = match place {
        Place::Gpu { .. } => format!("upload {}", ms(t.boxes)),
        Place::Cpu { .. } => format!(
            "boxes {}, build {}, traverse {}, narrow {}",
            ms(t.boxes),
            ms(t.build),
            ms(t.traverse),
            ms(t.narrow)
        ),
    };
    output::line("time", format_args!("{} on {place}; loading {}", ms(t.total), ms(load)));
    output::line("", parts);
}

/// Intersections of the frame that steps start from; `place` as of [`step`].
pub fn look_at_start<'a>(
    session: &mut Session,
    options: &StepOptions,
    frame: &Frame,
    place: impl Fn(u32, usize) -> (&'a Path, usize),
) -> Result<Intersections, Failure> {
    let precision = options.precision;
    let x = precision.round(&frame.positions);
    // An object of --with that stands still is fixed without an option that says so.
    let has_fixed = |bodies: &ccd::Bodies| (0..x.len() as u32).any(|v| bodies.is_fixed(v));
    let of_some =
        options.leaves_pairs_out() || session.options().bodies.as_ref().is_some_and(has_fixed);
    Intersections::of(session, &x, of_some).map_err(|e| named(e.into(), precision, place))
}

/// Two parts of a step, with a comma.
fn window(text: &str) -> Result<[f64; 2], String> {
    let ends = text.split_once(',').and_then(|(a, b)| Some([a.parse().ok()?, b.parse().ok()?]));
    ends.ok_or("expected two numbers and a comma, such as 0,0.5".into())
}

/// One step between two frames, in a window of it; an error in coordinates names the file by
/// `place`, which has that of a vertex at a time, and its number there.
pub fn step<'a>(
    session: &mut Session,
    precision: Precision,
    [t0, t1]: [&Frame; 2],
    window: [f64; 2],
    place: impl Fn(u32, usize) -> (&'a Path, usize),
) -> Result<(), Failure> {
    let result = match precision {
        Precision::F64 => session.step_window(&t0.positions, &t1.positions, window).map(|_| ()),
        Precision::F32 => {
            session.step_window(&t0.positions_f32(), &t1.positions_f32(), window).map(|_| ())
        }
    };
    result.map_err(|e| named(e, precision, place))
}

/// An error of a step, with the file that it is in.
fn named<'a>(
    e: Error,
    precision: Precision,
    place: impl Fn(u32, usize) -> (&'a Path, usize),
) -> Failure {
    match e {
        Error::Input(ccd::Error::Coordinate { time, vertex, axis, value }) => {
            let name = ["x", "y", "z"][axis as usize];
            let precision = precision.name();
            let (path, vertex) = place(time as u32, vertex);
            let what = format!("vertex {vertex} (counted from 0): {name} = {value} in {precision}");
            let more =
                if precision == "f32" { "; it may be within f64, see --precision" } else { "" };
            in_file(path, format_args!("{what}{more}"))
        }
        Error::Input(ccd::Error::FixedMoves { vertex }) => {
            let [(from, _), (path, vertex)] = [0, 1].map(|time| place(time, vertex));
            let from = from.display();
            let what = format!("vertex {vertex} (counted from 0) is not where it is in {from}");
            in_file(path, format_args!("{what}, and its body is --fixed"))
        }
        _ => e.into(),
    }
}

impl Precision {
    /// Positions as the step takes them.
    pub fn round(self, positions: &[[f64; 3]]) -> Cow<'_, [[f64; 3]]> {
        match self {
            Precision::F64 => Cow::Borrowed(positions),
            Precision::F32 => positions.iter().map(|p| p.map(|x| x as f32 as f64)).collect(),
        }
    }
}
