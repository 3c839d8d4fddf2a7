//! Sizes one after another: what is measured of each, and which are left out.

use super::measure::{self, Cell, Step};
use crate::cells::Cells;
use crate::exponents::size;
use crate::measure::Place;
use ccd::method::BroadPhaseMethod;
use ccd_testkit::generate::{crumpled_sheet, uniform_boxes};
use std::sync::Arc;

/// Work whose growth is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Work {
    /// All pairs of uniform boxes, by blocks or by the tree.
    Boxes(BroadPhaseMethod),
    /// A step of a crumpled sheet: all contacts, or the earliest time alone.
    Step { earliest: bool },
}

impl Work {
    pub const BOXES: [Self; 2] =
        [Self::Boxes(BroadPhaseMethod::Blocks), Self::Boxes(BroadPhaseMethod::TREE)];
    pub const STEPS: [Self; 2] = [Self::Step { earliest: false }, Self::Step { earliest: true }];

    pub fn name(self) -> &'static str {
        match self {
            Self::Boxes(BroadPhaseMethod::Blocks) => "blocks",
            Self::Boxes(_) => "tree",
            Self::Step { earliest: false } => "step",
            Self::Step { earliest: true } => "earliest",
        }
    }
}

/// Sizes, by powers of the root of ten; of a sheet the number of triangles, which is near them.
pub fn sizes(of_boxes: bool, quick: bool) -> Vec<usize> {
    let n = match (of_boxes, quick) {
        (true, false) => 9,
        (false, false) => 7,
        (_, true) => 3,
    };
    let power = |k: i32| 10f64.powf(4.0 + 0.5 * f64::from(k));
    (0..n).map(power).map(|n| if of_boxes { n.round() as usize } else { triangles(n) }).collect()
}

/// Vertices along a side of the sheet of about so many triangles.
fn side(n: f64) -> usize {
    (n / 2.0).sqrt().round() as usize + 1
}

fn triangles(n: f64) -> usize {
    2 * (side(n) - 1).pow(2)
}

/// Measurements of one kind of work at one place, one a size.
pub struct Series {
    pub work: Work,
    /// Number of the place.
    pub place: usize,
    pub cells: Vec<Cell>,
}

/// Limits of what is begun.
pub struct Limits {
    /// Most milliseconds that a call may be expected to take.
    pub call: f64,
}

/// The scene of a size, made when it is first needed.
#[derive(Default)]
struct Scene {
    boxes: Option<Vec<ccd::Aabb<f32>>>,
    step: Option<Step>,
}

impl Scene {
    fn measure(&mut self, place: &Place, work: Work, n: usize) -> Result<Cell, String> {
        match work {
            Work::Boxes(method) => {
                let boxes = self.boxes.get_or_insert_with(|| uniform_boxes(n));
                measure::boxes(place, boxes, method)
            }
            Work::Step { earliest } => {
                let step = self.step.get_or_insert_with(|| {
                    let step = crumpled_sheet(side(n as f64), 1);
                    let x = step.rounded();
                    Step { mesh: Arc::new(step.mesh), x }
                });
                measure::step(place, step, earliest)
            }
        }
    }
}

/// Bytes of an element of the input on the host.
fn input(work: Work) -> u64 {
    match work {
        Work::Boxes(_) => 24,
        // A triangle has half a vertex, in two precisions while it is made, and one and a half
        // edges, with what finds them.
        Work::Step { .. } => 200,
    }
}

/// All sizes at all places; every answer is compared with that of the first place. A `Cell` is
/// missing, and `cells` incomplete, if there was no more time.
pub fn all(
    places: &[Place],
    works: &[Work],
    sizes: &[usize],
    limits: &Limits,
    cells: &mut Cells,
) -> Result<Vec<Series>, String> {
    let mut all: Vec<Series> = Vec::new();
    for place in 0..places.len() {
        all.extend(works.iter().map(|&work| Series { work, place, cells: Vec::new() }));
    }
    for (i, &n) in sizes.iter().enumerate() {
        let (mut scene, mut first) = (Scene::default(), Vec::new());
        for series in &mut all {
            let (work, place) = (series.work, &places[series.place]);
            let last = i.checked_sub(1).map(|last| (sizes[last], series.cells.get(last)));
            let too_much = match last {
                Some((last, Some(cell))) => too_much(cell, work, [last, n], limits),
                _ => None,
            };
            let name = format!("{}|{n}|{}", work.name(), place.name());
            let cell: Option<Cell> = cells.get(&name, || {
                if let Some(why) = too_much {
                    return Ok(Err(why));
                }
                let cell = scene.measure(place, work, n).map_err(|e| format!("{name}: {e}"))?;
                println!("{name}: {cell:?}");
                Ok(cell)
            })?;
            let Some(cell) = cell else { continue };
            if let Ok(cell) = &cell {
                // All methods find the same pairs.
                let has_same =
                    |of: Work| of == work || matches!((of, work), (Work::Boxes(_), Work::Boxes(_)));
                let want = first.iter().find(|(of, _): &&(Work, _)| has_same(*of));
                match want {
                    Some((_, want)) if !cell.answer.agrees(want) => {
                        return Err(format!("{name}: {:?}, elsewhere {want:?}", cell.answer));
                    }
                    Some(_) => {}
                    None => first.push((work, cell.answer.clone())),
                }
            }
            series.cells.push(cell);
        }
        println!("{} done", size(n));
    }
    Ok(all)
}

/// Why a size is not begun, by what the size before took.
fn too_much(last: &Cell, work: Work, [from, to]: [usize; 2], limits: &Limits) -> Option<String> {
    let last = match last {
        Ok(last) => last,
        // Left out before: so is a larger one. What a device refuses, it may say again.
        Err(why) => return why.starts_with(LEFT_OUT).then(|| why.clone()),
    };
    let grown = to as f64 / from as f64;
    // Somewhat more than linear.
    let expected = last.wall * grown.powf(1.1);
    if expected > limits.call {
        let most = limits.call / 1e3;
        return Some(format!("{LEFT_OUT} a call is expected to take more than {most:.0} s"));
    }
    let bytes = (last.on_host as f64 + (from as u64 * input(work)) as f64) * grown;
    let free = free_memory()?;
    (bytes > 0.9 * free).then(|| {
        let gib = |bytes: f64| bytes / f64::from(1 << 30);
        let (bytes, free) = (gib(bytes), gib(free));
        format!("{LEFT_OUT} the host needs {bytes:.0} GiB, of which {free:.0} are free")
    })
}

const LEFT_OUT: &str = "not begun:";

/// Bytes that the host has free, by its kernel and by the limit of this container; `None` where
/// neither says it.
fn free_memory() -> Option<f64> {
    let number = |path: &str| -> Option<f64> {
        std::fs::read_to_string(path).ok()?.trim().parse::<f64>().ok()
    };
    let all = std::fs::read_to_string("/proc/meminfo").ok();
    let of_host = all.and_then(|text| {
        let line = text.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?;
        Some(line.trim().strip_suffix("kB")?.trim().parse::<f64>().ok()? * 1024.0)
    });
    let of_group = number("/sys/fs/cgroup/memory.max")
        .zip(number("/sys/fs/cgroup/memory.current"))
        .map(|(most, now)| most - now);
    of_host.into_iter().chain(of_group).reduce(f64::min)
}
