//! A step of points in some unit as a session brings it to a device, and what the device makes of
//! its pairs.

use crate::number::Flushed;
use ccd_core::backend::broad_phase::placement::{exact_box, path, rounded};
use ccd_core::backend::broad_phase::swept_box::swept;
use ccd_core::backend::layout::{Frame, Pair, Path, join, split};
use ccd_core::backend::quantization::{Scan, Table, margin};
use ccd_core::narrow_phase::cascade::apart;
use ccd_core::narrow_phase::decide::{self, Verdicts, by, narrow_verdicts, search_of};
use ccd_core::narrow_phase::query::{TOI_TOLERANCE, search};
use ccd_core::narrow_phase::relative_motion::{Motion, Patch};
use ccd_core::narrow_phase::search::{Answer, Search};
use ccd_core::{Aabb, Verdict};

/// Positions of vertices at both ends and a minimum distance: numbers that stay exact in every unit
/// here.
#[derive(Clone, Debug)]
pub struct Step {
    pub x0: Vec<[f64; 3]>,
    pub x1: Vec<[f64; 3]>,
    pub min_distance: f64,
}

/// Four vertices: `v f0 f1 f2`, or `ea0 ea1 eb0 eb1`.
pub type Query = (Patch, [u32; 4]);

impl Step {
    /// In another unit, a power of two; `None` if `f32` does not have all of it.
    pub fn times(&self, unit: f64) -> Option<Self> {
        let all = |x: &[[f64; 3]]| x.iter().map(|p| p.map(|c| c * unit)).collect::<Vec<_>>();
        let is_single = |x: &[[f64; 3]]| x.iter().flatten().all(|&c| c as f32 as f64 == c);
        let (x0, x1) = (all(&self.x0), all(&self.x1));
        let fits = is_single(&x0) && is_single(&x1);
        fits.then_some(Self { x0, x1, min_distance: self.min_distance * unit })
    }

    fn ends(&self, ids: [u32; 4]) -> [[[f64; 3]; 4]; 2] {
        [&self.x0, &self.x1].map(|x| ids.map(|i| x[i as usize]))
    }

    /// What the CPU says.
    pub fn truth(&self, (patch, ids): Query) -> Verdict<f64> {
        let [t0, t1] = self.ends(ids);
        let motion = Motion::new(patch, &t0, &t1, 0.0);
        search(&motion, patch, &Search::whole(self.min_distance)).verdict
    }
}

/// The step on a device.
pub struct OnDevice {
    frame: Frame,
    paths: Vec<Path>,
    boxes: Vec<Aabb<Flushed<f32>>>,
    given: Vec<[f64; 3]>,
}

impl OnDevice {
    /// `as_given`: not in another unit, as in a session in which some other vertex is far away.
    pub fn new(step: &Step, as_given: bool) -> Self {
        let Step { x0, x1, min_distance } = step;
        let mut scan = Scan::NONE;
        scan.take_all(x0, x1);
        if as_given {
            scan.take([1.0; 3]);
        }
        let table = scan.table(true);
        let exact = table == Table::AS_GIVEN;
        let frame = Frame {
            count: [x0.len() as u32, 0, 0],
            flags: if exact { Frame::FLAG_EXACT } else { 0 },
            path_error: table.error,
            min_distance: table.distance(*min_distance),
            margin: margin(min_distance * table.scale),
            distance_bits: split(*min_distance),
            margin_bits: split(margin(*min_distance)),
            origin: table.origin.map(split),
            scale_bits: split(table.scale),
            ..Frame::default()
        }
        .searching(&Search::whole(*min_distance));
        let paths = x0.iter().zip(x1).map(|(p, q)| path(*p, *q, &frame)).collect::<Vec<_>>();
        let point = |p: [f32; 4]| [p[0], p[1], p[2]].map(Flushed);
        let boxes = if exact {
            let of_path =
                |p: &Path| swept(point(p.t0), point(p.t1)).inflated(Flushed(frame.margin));
            paths.iter().map(of_path).collect()
        } else {
            let of_ends = |(p, q): (&[f64; 3], &[f64; 3])| {
                let b = rounded(&exact_box(*p, *q, &frame));
                Aabb { min: b.min.map(Flushed), max: b.max.map(Flushed) }
            };
            x0.iter().zip(x1).map(of_ends).collect()
        };
        Self { frame, paths, boxes, given: [&x0[..], x1].concat() }
    }

    fn overlap(&self, (patch, ids): Query) -> bool {
        let of = |ids: &[u32]| {
            let boxes = ids.iter().map(|&i| self.boxes[i as usize]);
            boxes.reduce(|a, b| a.union(&b)).expect("a vertex")
        };
        let (a, b) = ids.split_at(if patch == Patch::Triangle { 1 } else { 2 });
        of(a).overlaps(&of(b))
    }

    /// What it says in `f32`, by boxes, filters and the search.
    pub fn narrow(&self, query @ (patch, ids): Query) -> Verdicts {
        let ends = [0, 1].map(|end| {
            ids.map(|i| {
                let p = &self.paths[i as usize];
                let p = if end == 0 { p.t0 } else { p.t1 };
                [p[0], p[1], p[2]].map(Flushed)
            })
        });
        let wanted = search_of(&self.frame);
        let motion = Motion::new(patch, &ends[0], &ends[1], Flushed(self.frame.path_error));
        let out = !self.overlap(query) || apart(&motion, patch, Flushed(wanted.min_distance));
        if out {
            return narrow_verdicts(Answer::from(Verdict::Miss), &self.frame);
        }
        let Search { min_distance, tolerance, from, until, latest, leaves } = wanted;
        let [min_distance, tolerance, from, until, latest] =
            [min_distance, tolerance, from, until, latest].map(Flushed);
        let wanted = Search { min_distance, tolerance, from, until, latest, leaves };
        let Answer { verdict, approach } = search(&motion, patch, &wanted);
        let verdict = match verdict {
            Verdict::Miss => Verdict::Miss,
            Verdict::Hit { toi } => Verdict::Hit { toi: toi.0 },
            Verdict::Undecided { toi } => Verdict::Undecided { toi: toi.0 },
        };
        narrow_verdicts(Answer { verdict, approach }, &self.frame)
    }

    /// What it says of the same in `f64`.
    pub fn wide(&self, (patch, ids): Query) -> Verdicts {
        let (frame, paths, given) = (&self.frame, &self.paths, &self.given);
        let (kind, pair, elements) = match patch {
            Patch::Triangle => (0, Pair { a: ids[0], b: 0 }, &ids[1..]),
            Patch::Parallelogram => (1, Pair { a: 0, b: 1 }, &ids[..]),
        };
        if frame.distance_bits != [0; 2] {
            return decide::wide::<{ by::DISTANCE }, _>(kind, pair, frame, paths, given, elements);
        }
        let first = decide::wide::<{ by::ZEROS }, _>(kind, pair, frame, paths, given, elements);
        if first.undecided == 0 {
            return first;
        }
        decide::wide::<{ by::BOTH }, _>(kind, pair, frame, paths, given, elements)
    }
}

/// Why `got` is wrong where the CPU says `truth`.
pub fn wrong(truth: Verdict<f64>, got: &Verdicts) -> Option<&'static str> {
    let certain = got.touches && got.undecided == 0;
    let toi = join(got.toi);
    match truth {
        Verdict::Miss => certain.then_some("a false hit"),
        Verdict::Hit { .. } if !got.touches => Some("missed"),
        Verdict::Hit { toi: first } if toi > first + TOI_TOLERANCE => Some("late"),
        Verdict::Hit { toi: first } if certain && toi < first - TOI_TOLERANCE => Some("early"),
        _ => None,
    }
}

/// The same numbers in a unit near the smallest normal `f64` rather than `f32`.
pub fn in_f64(step: &Step, (patch, ids): Query, unit: f64) -> Option<Verdict<f64>> {
    let fits = |x: &[[f64; 3]]| x.iter().flatten().all(|&c| c * unit / unit == c);
    if !fits(&step.x0) || !fits(&step.x1) {
        return None;
    }
    let [t0, t1] = step.ends(ids).map(|x| x.map(|p| p.map(|c| Flushed(c * unit))));
    let motion = Motion::new(patch, &t0, &t1, Flushed(0.0));
    // As hosts send it.
    let distance = step.min_distance * unit;
    let distance = if distance > 0.0 { distance.max(f64::MIN_POSITIVE) } else { 0.0 };
    let distance = Flushed(distance);
    Some(match search(&motion, patch, &Search::whole(distance)).verdict {
        Verdict::Miss => Verdict::Miss,
        Verdict::Hit { toi } => Verdict::Hit { toi: toi.0 },
        Verdict::Undecided { toi } => Verdict::Undecided { toi: toi.0 },
    })
}
