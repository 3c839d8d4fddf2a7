//! `cargo xtask report --schedulers`: every scheduler with a front and without one, over sequences,
//! in the tables of docs/SCHEDULING.md, whose text stays as it is, and plots beside it: tables 4.1
//! to 4.5 of [da Silva 2013] measured again.
//!
//! A table stands between two comments, as in docs/ALGORITHMS.md. Every step is checked: it has as
//! many pairs as the default finds.

mod measure;
mod plot;
mod rules;
mod scenes;
mod tables;
mod workers;

use crate::ChoiceOptions;
use crate::cells::Cells;
use crate::markdown::{rewrite, rewrite_alone};
use crate::measure::Place;
use ccd::method::{Pipeline, Scheduling, Volume};
use measure::{Effort, Measured, Structure, WARM, WATCHED};
use scenes::Scene;
use std::path::Path;
use std::time::{Duration, Instant};

/// Measures all and rewrites the tables of SCHEDULING.md.
pub fn run(root: &Path, mut options: ChoiceOptions, mut cells: Cells) -> Result<(), String> {
    if options.threads.is_empty() {
        options.threads = vec![1, 2];
    }
    let folder = root.join(&options.folder);
    let plots = folder.join("scheduling");
    std::fs::create_dir_all(&plots).map_err(|e| format!("{plots:?}: {e}"))?;
    let start = Instant::now();
    let effort = if options.quick {
        Effort { steps: 2, least: 2, enough: Duration::ZERO }
    } else {
        Effort { steps: 12, least: 12, enough: Duration::ZERO }
    };
    let is_small = |name: &str| ["BART64", "BART256", "BART1024", "funnel"].contains(&name);
    let wanted = |name: &str| {
        let named = options.scenes.iter().any(|part| name.contains(part.as_str()));
        if options.scenes.is_empty() { !options.quick || is_small(name) } else { named }
    };
    let scenes = scenes::all(&wanted, WARM + effort.steps + WATCHED + 1)?;
    let cpus = options.threads.iter().map(|&threads| Place::Cpu { threads });
    let gpu = if options.no_gpu { None } else { Place::gpu() };
    let places: Vec<Place> = cpus.chain(gpu).collect();
    let of_workers = workers::table(&scenes, &places, effort, &mut cells)?;
    if options.workers {
        let path = folder.join("SCHEDULING.md");
        let is_whole = cells.are_complete();
        return if is_whole { rewrite_alone(&path, "workers", &of_workers) } else { Ok(()) };
    }
    let mut all = Vec::new();
    for scene in &scenes {
        let measured = Results::of(scene, &places, effort, &mut cells)?;
        println!("{}: {:.0} s", scene.name, start.elapsed().as_secs_f64());
        all.push(measured);
    }
    let threads = options.threads.iter().copied().max().unwrap_or(1);
    let rules = rules::table(threads, &wanted, options.quick, &plots, &mut cells)?;
    println!("all after {:.0} s", start.elapsed().as_secs_f64());
    if !cells.are_complete() {
        return Ok(());
    }
    let names: Vec<String> = places.iter().map(Place::name).collect();
    let steps = effort.steps;
    let machine = format!("Places: {}. Medians of {steps} steps.\n", names.join("; "));
    // Of all numbers of threads the last, and the GPU.
    let is_shown = |k: &usize| *k + 1 == places.len() || *k + 1 == options.threads.len();
    let shown: Vec<(usize, &str)> =
        (0..places.len()).filter(is_shown).map(|k| (k, names[k].as_str())).collect();
    let sections = [
        ("machine", machine),
        ("summary", tables::summary(&all, &names)),
        ("speedup", tables::speedup(&all, &places)),
        ("workers", of_workers),
        ("fronts", tables::fronts(&all)),
        ("times", tables::times(&all, &names)),
        ("shares", tables::shares(&all, &shown)),
        ("plots", plot::all(&all, &shown, &plots)?),
        ("rules", rules),
    ];
    rewrite(&folder.join("SCHEDULING.md"), &sections)
}

/// A scheduler, or what the method does by itself.
pub struct Row {
    pub name: String,
    pub scheduling: Scheduling,
}

/// Measurements of one structure at one place, a cell each row.
pub struct Group {
    pub structure: Structure,
    /// Number of the place.
    pub place: usize,
    pub rows: Vec<(Row, Option<Measured>)>,
}

/// All of one scene.
pub struct Results<'s> {
    pub scene: &'s Scene,
    pub groups: Vec<Group>,
    /// The default by pairs of features, at each place.
    pub features: Vec<Option<Measured>>,
}

/// The schedulings of a backend: by itself, and every scheduler with a front and without.
fn rows(backend: &str) -> Vec<Row> {
    let row = |scheduling: Scheduling| Row {
        name: scheduling.to_string().replace("-front", ", front"),
        scheduling,
    };
    let by_itself = Row { name: "by itself".into(), scheduling: Scheduling::default() };
    std::iter::once(by_itself).chain(Scheduling::every(backend).map(row)).collect()
}

impl<'s> Results<'s> {
    fn of(
        scene: &'s Scene,
        places: &[Place],
        effort: Effort,
        cells: &mut Cells,
    ) -> Result<Self, String> {
        let (mut groups, mut features) = (Vec::new(), Vec::new());
        for (k, place) in places.iter().enumerate() {
            for structure in Structure::ALL {
                // With oriented boxes a large scene takes a second a step by one thread.
                let is_last = k + 1 == places.len() || !matches!(places[k + 1], Place::Cpu { .. });
                let is_large = scene.mesh.faces().len() > 50_000;
                if structure == Structure::Tree(Volume::Obb) && is_large && !is_last {
                    continue;
                }
                let rows = rows(place.backend());
                let all: Vec<Scheduling> = rows.iter().map(|row| row.scheduling).collect();
                let measured = measure::kept(cells, place, scene, structure, &all, effort)?;
                groups.push(Group {
                    structure,
                    place: k,
                    rows: rows.into_iter().zip(measured).collect(),
                });
            }
            let default = if scene.pipeline == Pipeline::Features {
                None
            } else {
                let scene = scene.by_features()?;
                let all = [Scheduling::default()];
                let mut one = measure::kept(cells, place, &scene, Structure::Blocks, &all, effort)?;
                one.pop().flatten()
            };
            features.push(default);
        }
        Ok(Self { scene, groups, features })
    }

    /// One cell.
    pub fn cell(&self, place: usize, structure: Structure, name: &str) -> Option<&Measured> {
        let group = self.groups.iter().find(|g| (g.place, g.structure) == (place, structure))?;
        group.rows.iter().find(|(row, _)| row.name == name)?.1.as_ref()
    }

    /// The default of a session at this place.
    pub fn default(&self, place: usize) -> Option<&Measured> {
        let default = || self.cell(place, Structure::Blocks, "by itself");
        self.features[place].as_ref().or_else(default)
    }

    /// The fastest cell at a place, the default of a session among them, with its name.
    pub fn best(&self, place: usize) -> Option<(String, &Measured)> {
        let cells = self.groups.iter().filter(|group| group.place == place).flat_map(|group| {
            group.rows.iter().filter_map(|(row, cell)| {
                Some((format!("{}, {}", group.structure.name(), row.name), cell.as_ref()?))
            })
        });
        let default = self.features[place].as_ref().map(|cell| ("default".to_owned(), cell));
        cells.chain(default).min_by(|a, b| a.1.ms().total_cmp(&b.1.ms()))
    }
}
