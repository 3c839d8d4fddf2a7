//! Options that choose how pairs are found, and `ccd list`, which says what there is to choose
//! from.

use super::named::named;
use super::scheduling::{SchedulingOptions, within};
use super::{Failure, Outcome, output};
use ccd::Options;
use ccd::method::{
    BroadPhaseMethod, Builder, Catalogued, Descent, Front, Pipeline, Row, Scheduler, Scheduling,
    Traversal, TreeOptions, Volume,
};
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use serde::Serialize;

/// Options of every command that looks for pairs.
#[derive(Args)]
#[command(next_help_heading = "How pairs are found (all find the same contacts)")]
pub struct MethodOptions {
    /// Broad phase; --help has the other options, `ccd list` the names
    #[arg(long, value_name = "NAME", value_parser = named::<BroadPhaseMethod>())]
    #[arg(hide_possible_values = true, long_help = "Broad phase; `ccd list` has the names")]
    broad_phase: Option<BroadPhaseMethod>,
    /// How a tree is built; implies --broad-phase tree, as do the other options of trees
    #[arg(long, value_name = "NAME", value_parser = named::<Builder>())]
    #[arg(hide_possible_values = true, hide_short_help = true)]
    builder: Option<Builder>,
    /// How pairs are found in a tree
    #[arg(long, value_name = "NAME", value_parser = named::<Traversal>())]
    #[arg(hide_possible_values = true, hide_short_help = true)]
    traversal: Option<Traversal>,
    /// What bounds the nodes of a tree
    #[arg(long, value_name = "NAME", value_parser = named::<Volume>())]
    #[arg(hide_possible_values = true, hide_short_help = true)]
    volume: Option<Volume>,
    /// Neighbours to either side that --builder ploc looks at [default: 16]
    #[arg(long, value_name = "N", allow_negative_numbers = true, hide_short_help = true)]
    #[arg(value_parser = within(1, Builder::MAX_RADIUS))]
    radius: Option<u32>,
    /// Most boxes for --builder nearest-pair, whose time grows with their square [default: 20000]
    #[arg(long, value_name = "N", allow_negative_numbers = true, hide_short_help = true)]
    #[arg(value_parser = within(1, u32::MAX))]
    max_boxes: Option<u32>,
    /// Nodes of the cut that --traversal cut and cut-stacks start from [default: 256]
    #[arg(long, value_name = "N", allow_negative_numbers = true, hide_short_help = true)]
    #[arg(value_parser = within(1, Traversal::MAX_CUT))]
    cut: Option<u32>,
    /// What is paired first, features or triangles
    #[arg(long, value_name = "NAME", value_parser = named::<Pipeline>())]
    #[arg(hide_possible_values = true, hide_short_help = true)]
    pipeline: Option<Pipeline>,
    /// Whether --pipeline triangles skips triangles that share a vertex, and tests their features
    /// from a list
    #[arg(long, value_parser = choice(ON_OFF), hide_short_help = true)]
    orphans: Option<bool>,
    /// Whether --pipeline triangles skips regions that certainly do not touch themselves: their
    /// pairs are no candidates
    #[arg(long, value_parser = choice(ON_OFF), hide_short_help = true)]
    free_regions: Option<bool>,
    /// Whether --pipeline triangles tests a vertex or an edge once; off: all 15 tests of each pair,
    /// on a CPU
    #[arg(long, value_parser = choice(ON_OFF), hide_short_help = true)]
    representatives: Option<bool>,
    /// Which of two nodes --traversal simultaneous, cut and cut-stacks expand
    #[arg(long, value_parser = choice(DESCENTS), hide_short_help = true)]
    descent: Option<Descent>,
    #[command(flatten)]
    scheduling: SchedulingOptions,
}

/// Names of values, each with its line of help, which may be empty.
pub type Choices<T, const N: usize> = [(&'static str, &'static str, T); N];

const DESCENTS: Choices<Descent, 2> =
    [("larger", "The larger one", Descent::Larger), ("both", "Both", Descent::Both)];
const ON_OFF: Choices<bool, 2> = [("on", "", true), ("off", "", false)];

/// A parser of the names of values.
pub fn choice<T, const N: usize>(choices: Choices<T, N>) -> impl TypedValueParser<Value = T>
where
    T: Copy + Send + Sync + 'static,
{
    let names = choices.map(|(name, help, _)| {
        let value = PossibleValue::new(name);
        if help.is_empty() { value } else { value.help(help) }
    });
    PossibleValuesParser::new(names).try_map(move |name| {
        let found = choices.iter().find(|choice| choice.0 == name);
        found.map(|choice| choice.2).ok_or("not in the table")
    })
}

impl MethodOptions {
    /// Options of a session with all that was chosen.
    pub fn set(&self, options: Options) -> Result<Options, Failure> {
        Ok(options
            .with_broad_phase(self.method()?)
            .with_pipeline(self.pipeline()?)
            .with_scheduling(self.scheduling()?))
    }

    /// The broad phase that was chosen, or the default.
    pub fn method(&self) -> Result<BroadPhaseMethod, Failure> {
        Ok(self.chosen()?.unwrap_or_default())
    }

    /// The broad phase that was chosen, if one was.
    pub fn chosen(&self) -> Result<Option<BroadPhaseMethod>, Failure> {
        let Some(option) = self.first_of_tree() else { return Ok(self.broad_phase) };
        match self.broad_phase {
            None | Some(BroadPhaseMethod::Tree(_)) => {}
            Some(other) => {
                let name = other.row().name;
                let why = format!("{option} is for --broad-phase tree; {name} has none");
                return Err(Failure(why));
            }
        }
        let tree = TreeOptions::default()
            .builder(self.builder()?)
            .traversal(self.traversal()?)
            .volume(self.volume.unwrap_or_default());
        Ok(Some(BroadPhaseMethod::Tree(tree)))
    }

    /// The pipeline.
    pub fn pipeline(&self) -> Result<Pipeline, Failure> {
        let (orphans, free_regions, once) = (self.orphans, self.free_regions, self.representatives);
        match self.pipeline.unwrap_or_default() {
            Pipeline::Triangles(options) => {
                let orphans = orphans.unwrap_or(options.orphans);
                let free_regions = free_regions.unwrap_or(options.free_regions);
                let once = once.unwrap_or(options.representatives);
                let options =
                    options.orphans(orphans).free_regions(free_regions).representatives(once);
                Ok(Pipeline::Triangles(options))
            }
            other if orphans.or(free_regions).or(once).is_some() => {
                let option = match (orphans, free_regions) {
                    (Some(_), _) => "orphans",
                    (None, Some(_)) => "free-regions",
                    (None, None) => "representatives",
                };
                let name = other.row().name;
                Err(Failure(format!("--{option} is for --pipeline triangles, not {name}")))
            }
            other => Ok(other),
        }
    }

    /// Scheduler, front and workers.
    pub fn scheduling(&self) -> Result<Scheduling, Failure> {
        self.scheduling.chosen()
    }

    /// Nothing, or why a command that pairs boxes alone has no pipeline.
    pub fn no_pipeline(&self) -> Result<(), Failure> {
        match self.pipeline()? {
            Pipeline::Features => Ok(()),
            other => Err(Failure(format!(
                "--pipeline {} pairs features of a mesh; boxes alone have none",
                other.row().name
            ))),
        }
    }

    /// The first of the options given that only trees have.
    fn first_of_tree(&self) -> Option<&'static str> {
        [
            (self.builder.is_some(), "--builder"),
            (self.traversal.is_some(), "--traversal"),
            (self.volume.is_some(), "--volume"),
            (self.radius.is_some(), "--radius"),
            (self.max_boxes.is_some(), "--max-boxes"),
            (self.cut.is_some(), "--cut"),
            (self.descent.is_some(), "--descent"),
        ]
        .into_iter()
        .find_map(|(given, name)| given.then_some(name))
    }

    fn builder(&self) -> Result<Builder, Failure> {
        let builder = self.builder.unwrap_or_default();
        match (builder, self.radius, self.max_boxes) {
            (Builder::Ploc { .. }, Some(radius), None) => Ok(Builder::Ploc { radius }),
            (Builder::NearestPair { .. }, None, Some(limit)) => Ok(Builder::NearestPair { limit }),
            (_, None, None) => Ok(builder),
            (_, Some(_), _) => Err(Failure("--radius needs --builder ploc".into())),
            (_, _, Some(_)) => Err(Failure("--max-boxes needs --builder nearest-pair".into())),
        }
    }

    fn traversal(&self) -> Result<Traversal, Failure> {
        let traversal = self.traversal.unwrap_or_default();
        match (traversal, self.cut, self.descent) {
            (Traversal::Simultaneous(default), None, descent) => {
                Ok(Traversal::Simultaneous(descent.unwrap_or(default)))
            }
            (Traversal::Cut { nodes, descent: default }, cut, descent) => {
                let (nodes, descent) = (cut.unwrap_or(nodes), descent.unwrap_or(default));
                Ok(Traversal::Cut { nodes, descent })
            }
            (Traversal::CutStacks { nodes, descent: default }, cut, descent) => {
                let (nodes, descent) = (cut.unwrap_or(nodes), descent.unwrap_or(default));
                Ok(Traversal::CutStacks { nodes, descent })
            }
            (_, None, None) => Ok(traversal),
            (_, Some(_), _) => Err(Failure("--cut needs --traversal cut or cut-stacks".into())),
            (_, _, Some(_)) => {
                Err(Failure("--descent needs --traversal simultaneous, cut or cut-stacks".into()))
            }
        }
    }
}

/// `ccd list`
#[derive(Args)]
pub struct List {
    /// Print one JSON object instead of text
    #[arg(short, long)]
    json: bool,
}

/// A row of the catalogue.
#[derive(Serialize)]
struct Entry {
    name: &'static str,
    about: &'static str,
    source: Option<&'static str>,
    backends: &'static [&'static str],
    /// Whether it is of the feature `catalogue`, with which this command is built.
    catalogue: bool,
}

#[derive(Serialize)]
struct Json {
    broad_phases: Vec<Entry>,
    traversals: Vec<Entry>,
    builders: Vec<Entry>,
    volumes: Vec<Entry>,
    pipelines: Vec<Entry>,
    schedulers: Vec<Entry>,
    fronts: Vec<Entry>,
}

fn entries<T: Catalogued>() -> Vec<Entry> {
    let entry = |row: &Row<T>| {
        let &Row { name, about, source, backends, .. } = row;
        Entry { name, about, source, backends, catalogue: !T::ALWAYS.contains(&name) }
    };
    T::ROWS.iter().map(entry).collect()
}

impl List {
    pub fn run(&self) -> Outcome {
        let all = Json {
            broad_phases: entries::<BroadPhaseMethod>(),
            traversals: entries::<Traversal>(),
            builders: entries::<Builder>(),
            volumes: entries::<Volume>(),
            pipelines: entries::<Pipeline>(),
            schedulers: entries::<Scheduler>(),
            fronts: entries::<Front>(),
        };
        if self.json {
            output::json(&all)?;
        } else {
            print::<BroadPhaseMethod>("Broad phases, --broad-phase NAME", &all.broad_phases);
            print::<Builder>("Builders of trees, --builder NAME", &all.builders);
            print::<Traversal>("Traversals of trees, --traversal NAME", &all.traversals);
            print::<Volume>("Volumes of trees, --volume NAME", &all.volumes);
            print::<Pipeline>("Pipelines, --pipeline NAME", &all.pipelines);
            let users = "of blocks, and of trees by pairs of nodes";
            print::<Scheduler>(&format!("Schedulers {users}, --scheduler NAME"), &all.schedulers);
            print::<Front>(&format!("Fronts {users}, --front NAME"), &all.fronts);
            output::say!(
                "* what is used without the option; without a scheduler, blocks on a CPU begin"
            );
            output::say!("  with a share of tasks for each worker, and a GPU goes level by level");
            output::say!("+ always in this command; the library needs the feature `catalogue`");
        }
        output::flush();
        Ok(false)
    }
}

fn print<T: Catalogued + Default>(title: &str, entries: &[Entry]) {
    let default = T::default().row().name;
    output::say!("{title}");
    for Entry { name, about, source, backends, catalogue } in entries {
        let source = source.map_or(String::new(), |source| format!(" [{source}]"));
        let mark = match catalogue {
            true => '+',
            false if *name == default => '*',
            false => ' ',
        };
        output::say!("{mark} {name:<23} {:<8} {about}{source}", backends.join(" "));
    }
    output::say!("");
}
