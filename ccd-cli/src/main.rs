//! The `ccd` command, see `ccd --help`: arguments, dispatch, exit codes.
#![deny(unsafe_code)]

mod backend;
mod bench;
mod bodies;
mod boxes;
mod camera;
mod canvas;
mod check;
mod cloth;
mod demo;
mod environment;
mod failure;
mod files;
mod frames;
mod info;
mod interrupt;
mod join;
mod legend;
mod lines;
mod look;
mod manual;
mod merge;
mod mesh_file;
mod method;
mod named;
mod objects;
mod output;
mod part;
mod picture;
mod pixels;
mod plot;
mod points;
mod progress;
mod queries;
mod rows;
mod scheduling;
mod sequence;
mod start;
mod toi;

use clap::{Args, Parser, Subcommand, ValueEnum};
use failure::{Failure, in_file};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Continuous collision detection for triangle meshes.
///
/// Finds every vertex-face and edge-edge contact while each vertex moves on a straight line from
/// one frame to the next, with the time of impact in [0, 1]. No contact is missed and no time is
/// late, and no contact is a false alarm; only with a minimum distance some may be "undecided".
///
/// A contact is where features meet during the motion. A first frame that already passes through
/// itself need not have any, so `check` and `sequence` test it exactly, edges against faces, and
/// say so. If it does not, and no step has a contact, nothing passes through anything at any time.
/// Pairs that --fixed, --layers and similar options leave out are not tested.
///
/// Vertices, edges, faces, bodies, boxes, queries, frames and steps are counted from 0, in what is
/// printed and written and in errors, whatever the file's own numbers are: `f 1 2 3` of an OBJ file
/// has vertices 0, 1 and 2. Lines of files, and parts (--part 1/8), are counted from 1.
///
/// Exit status: 0 done; 1 contacts were found, or a first frame that intersects itself, and
/// --fail-on-contact was given; 2 bad use or bad input; 130 ended by Ctrl-C, 143 by SIGTERM. Files
/// are written whole or not at all.
#[derive(Parser)]
#[command(name = "ccd", version, max_term_width = 100)]
struct Cli {
    #[command(subcommand)]
    command: Command,
    /// Say nothing but what was asked for (JSON, files) and errors
    #[arg(short, long, global = true)]
    quiet: bool,
}

#[derive(Subcommand)]
enum Command {
    /// Contacts between two frames of a mesh
    #[command(after_help = CHECKS, after_long_help = format!("{CHECKS}\n\n{CSV}"))]
    Check(check::Check),
    /// Contacts over many frames of a mesh, one step from each frame to the next
    #[command(after_help = SEQUENCES, after_long_help = format!("{SEQUENCES}\n\n{CSV}"))]
    Sequence(sequence::Sequence),
    /// Join the JSON lines or the contacts of the parts of a `sequence`
    #[command(after_help = "EXAMPLES:\n  ccd merge part-*.jsonl > all.jsonl\n  \
        ccd merge part-*.csv > all.csv\n\n\
        Lines of JSON say which part they are of: each must be given exactly once.\n\
        Files whose names end in .csv are contacts (sequence --contacts): sorted by their steps\n\
        under one header. Rows do not say whether a part is missing; lines of JSON do.")]
    Merge(merge::Merge),
    /// Elemental queries from files, compared with the answers in them
    #[command(after_help = "A file holds eight rows a query: four points at t0, four at t1 \
        (v f0 f1 f2, or ea0 ea1 eb0 eb1), each as\n\
        x numerator, x denominator, y .., z .., and in a seventh column the answer (0 or 1); files \
        of six columns have no answers.\n\
        Its path must name vertex-face (vf) or edge-edge (ee), or --kind does.")]
    Queries(queries::Queries),
    /// Overlapping pairs of boxes: the broad phase alone
    #[command(after_help = "A file holds raw little-endian f32 numbers, six a box: \
        min x y z, max x y z. Boxes that touch overlap.\n\
        With one file, pairs within it; \
        with two, pairs of a box of the first with one of the second.\n\
        --pairs writes raw little-endian u32 numbers, two a pair: the boxes' numbers, from 0, \
        sorted.")]
    Boxes(boxes::Boxes),
    /// A cloth falls on a sphere; needs no file (the experiment of Tian and Wan)
    Demo(demo::Demo),
    /// The ways to find pairs: broad phases, trees, pipelines, schedulers, fronts
    List(method::List),
    /// The processor, the GPU that would be used and how, and which others there are
    Info(info::InfoCommand),
    /// Times of built-in scenes; needs no file
    #[command(after_help = "EXAMPLES:\n  ccd bench --backend cpu\n  \
        ccd bench --backend gpu --large\n  ccd bench --size 0.5 --size 2")]
    Bench(bench::Bench),
    /// Completions for a shell, on standard output
    Completions(manual::Completions),
    /// The manual as man pages
    Man(manual::Man),
}

const CHECKS: &str = "EXAMPLES:\n  ccd check before.ply after.ply\n  \
    ccd check before.ply after.ply --contacts contacts.csv --picture contacts.png\n  \
    ccd check a0.obj a1.obj --with level.obj --with b0.obj,b1.obj";

const SEQUENCES: &str = "EXAMPLES:\n  ccd sequence frames --picture times.png\n  \
    ccd sequence cloth.npz --mesh cloth.obj\n  \
    ccd sequence 'frames/*.ply' --json-lines --part 2/8 > part-2.jsonl";

/// Help on the columns of contacts.
const CSV: &str = "COLUMNS OF --contacts (sequence: frame first, the number of the step):
  kind        vf (vertex a, face b) or ee (edges a < b); with particles
              (vertices of no edge) and rods (edges of no face) also ve
              (particle a, rod b) and vv (particles a < b)
  a, b        features, all counted from 0: vertices as in the file;
              faces as triangles in the file's order, polygons cut into
              fans; edges sorted by their greater vertex, then by the
              other
  toi, state  time of impact in [0, 1]; hit or undecided
  v0 .. v3    the vertices of a, then those of b; ve has three, vv two
  polygon     the file's face that face b is cut from; without a face:
              empty
  px py pz    where they meet at the time of impact
  nx ny nz    unit normal there, from b to a
  w0 .. w3    weights of v0 .. v3: points on a and b as sums of positions";

/// The coordinates that a step starts from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Precision {
    /// Rounded to f32 on load, as an engine stores them
    F32,
    /// As they are in the file
    F64,
}

impl Precision {
    fn name(self) -> &'static str {
        match self {
            Precision::F32 => "f32",
            Precision::F64 => "f64",
        }
    }
}

const MODES: method::Choices<ccd::Mode, 3> = [
    ("auto", "Exact on the CPU without --min-distance, else conservative", ccd::Mode::Auto),
    ("conservative", "Never late, and at most --tolerance early", ccd::Mode::Conservative),
    ("exact", "True times, rounded down", ccd::Mode::Exact),
];

/// Headings of options in the help.
const INPUT: &str = "Input";
const QUESTION: &str = "What is looked for";
const OUTPUT: &str = "Output";

/// Options of every command that steps a mesh, in the order of the help.
#[derive(Args)]
struct StepOptions {
    #[command(flatten)]
    bodies: bodies::BodyOptions,
    /// Coordinates of the step
    #[arg(long, value_enum, default_value_t = Precision::F64, help_heading = INPUT)]
    precision: Precision,
    /// Contact is a distance of at most D, in units of coordinates
    #[arg(short = 'd', long, value_name = "D", default_value_t = 0.0)]
    #[arg(allow_negative_numbers = true, help_heading = QUESTION)]
    min_distance: f64,
    /// How times of impact are found
    ///
    /// All modes find the same contacts. `exact` cannot be used with --min-distance.
    #[arg(long, value_parser = method::choice(MODES), default_value = "auto")]
    #[arg(help_heading = QUESTION)]
    mode: ccd::Mode,
    /// Leave out contacts at the start whose features separate
    ///
    /// If they certainly separate, their next contact in the step counts instead. Without a
    /// --min-distance it is never certain that what touches separates.
    #[arg(long, help_heading = QUESTION)]
    leave_contact: bool,
    /// How early the time of a hit may be, in units of the step
    #[arg(long, value_name = "T", default_value_t = ccd::TOI_TOLERANCE)]
    #[arg(allow_negative_numbers = true, hide_short_help = true, help_heading = QUESTION)]
    tolerance: f64,
    /// Print one JSON object instead of text
    #[arg(short, long, help_heading = OUTPUT)]
    json: bool,
    /// Write contacts as CSV (check: or as points in a PLY file)
    ///
    /// `-` is standard output, and has CSV. The points of a PLY file, which `check` alone writes,
    /// have the normals, are coloured by their times, and have a, b, toi and undecided as
    /// properties.
    #[arg(short, long, value_name = "OUT", help_heading = OUTPUT)]
    contacts: Option<PathBuf>,
    /// Write a picture of the contacts, or of a sequence's times
    ///
    /// `-` is standard output.
    #[arg(short, long, value_name = "OUT.png", help_heading = OUTPUT)]
    picture: Option<PathBuf>,
    /// Exit with status 1 if there is a contact
    ///
    /// Or if the first frame intersects itself.
    #[arg(long, help_heading = OUTPUT)]
    fail_on_contact: bool,
    #[command(flatten)]
    backend: backend::BackendOptions,
    /// Memory that may be held, in bytes, or with K, M or G (2G); more is an error
    ///
    /// Not counted are the mesh and what is read and written.
    #[arg(long, value_name = "BYTES", value_parser = bytes, allow_hyphen_values = true)]
    #[arg(hide_short_help = true, help_heading = backend::PLACE)]
    max_memory: Option<u64>,
    #[command(flatten)]
    method: method::MethodOptions,
}

impl StepOptions {
    /// Opens the file of a picture before any work, if one is wanted.
    fn picture_file(&self) -> Result<Option<pixels::Picture<'_>>, Failure> {
        self.picture.as_deref().map(pixels::Picture::create).transpose()
    }

    /// The same of contacts.
    fn contact_file(&self, frames: bool) -> Result<Option<rows::Rows<'_>>, Failure> {
        let path = self.contacts.as_deref().filter(|path| frames || !points::are_wanted(path));
        path.map(|path| rows::Rows::of_contacts(path, frames)).transpose()
    }

    /// The same of contacts as points.
    fn point_file(&self) -> Result<Option<points::Points<'_>>, Failure> {
        let path = self.contacts.as_deref().filter(|path| points::are_wanted(path));
        path.map(points::Points::create).transpose()
    }

    /// Refuses outputs that lie over each other or over what is read. `json`: another option that
    /// prints JSON; `candidates`: where they go; `meshes`: files that are read.
    fn check_outputs(
        &self,
        json: Option<&str>,
        candidates: Option<&Path>,
        meshes: &[&Path],
    ) -> Result<(), Failure> {
        let written = [
            ("--contacts", self.contacts.as_deref()),
            ("--candidates", candidates),
            ("--picture", self.picture.as_deref()),
        ];
        let read: Vec<_> = self.bodies.file().into_iter().chain(meshes.iter().copied()).collect();
        files::check(json.or(self.json.then_some("--json")), &written, &read)?;
        let is_file = |path: &Path| !files::is_standard(path);
        if self.fail_on_contact || written.iter().any(|(_, path)| path.is_some_and(is_file)) {
            output::go_on();
        }
        Ok(())
    }

    /// Whether contacts are written or drawn.
    fn shows_contacts(&self) -> bool {
        self.contacts.is_some() || self.picture.is_some()
    }

    /// As [`bodies::BodyOptions::leaves_pairs_out`].
    fn leaves_pairs_out(&self) -> bool {
        self.bodies.leaves_pairs_out()
    }

    /// A digest of what is asked of each step: parts of one sequence have the same.
    fn asked(&self, options: &ccd::Options) -> u64 {
        let ccd::Options { min_distance, mode, leave_contact, tolerance, bodies, .. } = options;
        let precision = self.precision.name();
        let all = (min_distance, mode, leave_contact, tolerance, bodies, precision);
        lines::digest(format!("{all:?}").bytes())
    }

    /// Whether text is printed: not with JSON, nor if a file goes to standard output.
    fn prints_text(&self) -> bool {
        let files = [&self.contacts, &self.picture];
        !self.json && !files.into_iter().flatten().any(|path| files::is_standard(path))
    }

    /// A session for a mesh where the options want it. `objects`: of several, the body of each
    /// vertex, and which of them stand still.
    fn session(
        &self,
        mesh: ccd::Mesh,
        objects: Option<(Vec<u32>, Vec<bool>)>,
    ) -> Result<ccd::any::Session, Failure> {
        let options = ccd::Options::default()
            .with_min_distance(self.min_distance)
            .with_tolerance(self.tolerance)
            .with_mode(self.mode)
            .with_leave_contact(self.leave_contact)
            .with_bodies(self.bodies.of(&mesh, objects, self.max_memory)?)
            .with_threads(self.backend.threads())
            .with_max_memory(self.max_memory);
        if self.leave_contact && self.min_distance == 0.0 {
            output::notice!("--leave-contact has no effect without --min-distance");
        }
        if self.mode == ccd::Mode::Exact && self.tolerance != ccd::TOI_TOLERANCE {
            output::notice!("--tolerance has no effect on exact times");
        }
        let choice = self.backend.choose(mesh.edges().len())?;
        let session = ccd::any::Session::new(&choice, mesh, self.method.set(options)?);
        let mut session = session.map_err(|e| match e {
            ccd::any::Error::Input(ccd::Error::MixedBodies { element, at, bodies: [a, b] }) => {
                let element = if element == "face" { "triangle" } else { element };
                let what = format!("{element} {at} (counted from 0) joins bodies {a} and {b}");
                in_file(self.bodies.file().unwrap_or("--bodies".as_ref()), what)
            }
            _ => Failure::from(e),
        })?;
        session.set_cancel_token(interrupt::token());
        Ok(session)
    }
}

/// A number of bytes: `1000`, `64K`, `512M`, `2G`.
fn bytes(text: &str) -> Result<u64, String> {
    let units = [("K", 10), ("M", 20), ("G", 30)];
    let unit = units.into_iter().find_map(|(name, bits)| Some((text.strip_suffix(name)?, bits)));
    let (number, bits) = unit.unwrap_or((text, 0));
    let number = number.parse::<u64>().ok().filter(|n| n.leading_zeros() >= bits);
    number
        .map(|n| n << bits)
        .ok_or("expected a whole number of bytes, which K, M or G may follow (2G)".into())
}

/// Whether there was a contact.
type Outcome = Result<bool, Failure>;

fn main() -> ExitCode {
    environment::prepare();
    let cli = Cli::try_parse().unwrap_or_else(|e| unparsed(&e));
    if cli.quiet {
        output::be_quiet();
    }
    let (outcome, fail_on_contact) = match &cli.command {
        Command::Check(c) => (c.run(), c.options.fail_on_contact),
        Command::Sequence(c) => (c.run(), c.options.fail_on_contact),
        Command::Merge(c) => (c.run(), false),
        Command::Queries(c) => (c.run(), false),
        Command::Boxes(c) => (c.run(), false),
        Command::Demo(c) => (c.run(), false),
        Command::Info(c) => (c.run(), false),
        Command::List(c) => (c.run(), false),
        Command::Bench(c) => (c.run(), false),
        Command::Completions(c) => (c.run(), false),
        Command::Man(c) => (c.run(), false),
    };
    match outcome {
        Ok(true) if fail_on_contact => ExitCode::from(1),
        Ok(_) => ExitCode::SUCCESS,
        Err(_) if interrupt::happened() => {
            interrupt::interrupted().print();
            ExitCode::from(interrupt::status())
        }
        Err(failure) => {
            failure.print();
            ExitCode::from(2)
        }
    }
}

/// Prints what clap has to say, a manual or what is wrong, and ends the program.
fn unparsed(e: &clap::Error) -> ! {
    match e.print() {
        Err(why) if !e.use_stderr() => output::ended(&why),
        _ => output::flush(),
    }
    std::process::exit(e.exit_code())
}
