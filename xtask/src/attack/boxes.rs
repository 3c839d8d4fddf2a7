//! Boxes of 28 sizes by 12 shapes, by every method and every way to schedule it, against brute
//! force: two calls on one broad phase, so that what it keeps meets other boxes.

use super::{Counts, Found, Place, caught, fewest};
use ccd::any::{BroadPhase, Error};
use ccd::{Aabb, BroadPhaseMethod, Pair, Scheduler, Scheduling, gpu};
use ccd_testkit::brute;
use ccd_testkit::grazing::random::Random;

/// Numbers of boxes: around those at which blocks, lanes and workgroups are full.
const SIZES: [usize; 28] = [
    0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 15, 16, 17, 31, 32, 33, 63, 64, 65, 127, 128, 129, 255, 256, 257,
    511, 513, 1025,
];

type Shape = fn(&mut Random, usize, usize) -> Aabb<f32>;

/// Box `i` of `n`.
const SHAPES: [(&str, Shape); 12] = [
    ("anywhere", |r, _, n| cube(corner(r), 0.7 / (n as f32 + 1.0).cbrt())),
    ("points", |r, _, _| cube(corner(r).map(|c| (c * 8.0).trunc()), 0.0)),
    ("equal", |_, _, _| cube([0.25; 3], 0.5)),
    ("line", |r, i, _| Aabb { min: [i as f32, 0.0, 0.0], max: [i as f32 + one(r), 0.0, 0.0] }),
    ("sheets", |r, i, _| {
        let at = [i as f32 % 16.0, (i / 16) as f32, (r.below(3)) as f32];
        Aabb { min: at, max: [at[0] + 1.0, at[1] + 1.0, at[2]] }
    }),
    ("touching", |r, i, _| {
        // The next number: what is apart by least.
        let at = [i % 8, i / 8 % 8, i / 64].map(|c| c as f32);
        let side = if r.below(4) == 0 { 1f32.next_down() } else { 1.0 };
        cube(at, side)
    }),
    ("clusters", |r, i, _| {
        let at = (i % 7) as f32 * 1000.0;
        cube(corner(r).map(|c| at + c), 0.1)
    }),
    ("greatest", |r, _, _| cube(corner(r).map(|c| (c - 0.5) * 3.4e38), 4e37)),
    ("least", |r, _, _| {
        let at = corner(r).map(|c| f32::from_bits((c * 64.0) as u32) - f32::from_bits(32));
        cube(at, f32::from_bits(r.below(12) as u32))
    }),
    ("needles", |r, i, _| {
        let (mut b, at) = (cube(corner(r), 0.001), r.below(3));
        b.max[at] += if i % 3 == 0 { 1.0 } else { 0.1 };
        b
    }),
    ("nested", |r, i, _| {
        let half = (i + 1) as f32 * (1.0 + r.below(2) as f32);
        Aabb { min: [-half; 3], max: [half; 3] }
    }),
    ("all sizes", |r, i, _| {
        let side = if i == 0 { 1.0 } else { r.power(-14.0, -1.0) as f32 };
        cube(corner(r), side)
    }),
];

fn corner(r: &mut Random) -> [f32; 3] {
    std::array::from_fn(|_| r.unit() as f32)
}

fn one(r: &mut Random) -> f32 {
    [0.5, 1.0, 1.5][r.below(3)]
}

fn cube(at: [f32; 3], side: f32) -> Aabb<f32> {
    Aabb { min: at, max: at.map(|c| c + side) }
}

fn make(random: &mut Random, counts: &mut Counts) -> Vec<Aabb<f32>> {
    let (n, (shape, make)) = (SIZES[random.below(28)], SHAPES[random.below(12)]);
    counts.add(&format!("sets of {shape}"), 1);
    (0..n).map(|i| make(random, i, n)).collect()
}

/// Every method of a place by itself, and with every scheduling that it takes.
fn methods(place: &Place) -> Vec<(BroadPhaseMethod, Scheduling)> {
    let device = place.choice.device();
    let native = device.is_none_or(|device| device.info().path == gpu::Path::Passthrough);
    let steals =
        |s: &Scheduling| matches!(s.scheduler, Some(Scheduler::Stealing | Scheduler::LazyStealing));
    let backend = place.backend();
    ccd::every(backend)
        .flat_map(|method| {
            let all = Scheduling::every(backend).filter(move |s| s.check(method).is_ok());
            let all = all.filter(move |s| native || !steals(s));
            std::iter::once(Scheduling::default()).chain(all).map(move |s| (method, s))
        })
        .collect()
}

/// Boxes of one call: pairs within the first set, or between both.
type Sets = (Vec<Aabb<f32>>, Option<Vec<Aabb<f32>>>);

struct Run<'a> {
    place: &'a Place,
    method: BroadPhaseMethod,
    scheduling: Scheduling,
    threads: usize,
}

pub fn case(
    place: &Place,
    number: u64,
    mut random: Random,
    counts: &mut Counts,
) -> Result<(), Found> {
    let methods = methods(place);
    // A step that shares no factor with their number visits all of them.
    let (method, scheduling) = methods[(number.wrapping_mul(7919) % methods.len() as u64) as usize];
    let run = Run { place, method, scheduling, threads: 1 + random.below(2) };
    let calls: Vec<Sets> = (0..3)
        .map(|_| {
            let a = make(&mut random, counts);
            (a, (random.below(2) == 0).then(|| make(&mut random, counts)))
        })
        .collect();
    match caught(|| run.check(&calls)) {
        Ok(n) => {
            counts.add("calls", calls.len() as u64);
            counts.add("pairs", n);
            Ok(())
        }
        Err(what) => Err(run.shrink(calls, what)),
    }
}

/// Boxes with zero for bounds below the smallest normal number.
fn flushed(boxes: &[Aabb<f32>]) -> Vec<Aabb<f32>> {
    let flush = |x: f32| if x.is_subnormal() { 0.0 } else { x };
    boxes.iter().map(|b| Aabb { min: b.min.map(flush), max: b.max.map(flush) }).collect()
}

impl Run<'_> {
    /// The number of pairs.
    fn check(&self, calls: &[Sets]) -> Result<u64, String> {
        let &Self { place, method, scheduling, threads } = self;
        let mut broad = BroadPhase::scheduled(&place.choice, threads, method, scheduling)
            .map_err(|e| format!("refused: {e}"))?;
        let mut n = 0;
        for (a, b) in calls {
            let found = match b {
                None => broad.self_pairs(a),
                Some(b) => broad.pairs(a, b),
            };
            let mut found = match found {
                Ok(pairs) => pairs.into_vec(),
                // A grid is refused where its cells are crowded, which is documented.
                Err(Error::Input(ccd::Error::CrowdedCells { .. })) => continue,
                Err(e) => return Err(format!("an error: {e}")),
            };
            let want = b.as_ref().map_or_else(|| brute::self_pairs(a), |b| brute::pairs(a, b));
            let key = |p: &Pair| (p.a, p.b);
            found.sort_unstable_by_key(key);
            n += want.len() as u64;
            if let Some(two) = found.windows(2).find(|two| two[0] == two[1]) {
                return Err(format!("a pair twice: {:?}", two[0]));
            }
            let without = |all: &[Pair], of: &[Pair]| {
                of.iter().find(|p| all.binary_search_by_key(&key(p), key).is_err()).copied()
            };
            if let Some(pair) = without(&found, &want) {
                return Err(format!("a pair is missing: {pair:?}"));
            }
            // A device may take bounds below the smallest normal number as zero, as is documented.
            let most = match place.choice.device() {
                None => want,
                Some(_) => b.as_ref().map_or_else(
                    || brute::self_pairs(&flushed(a)),
                    |b| brute::pairs(&flushed(a), &flushed(b)),
                ),
            };
            if let Some(pair) = without(&most, &found) {
                return Err(format!("a pair too much: {pair:?}"));
            }
        }
        Ok(n)
    }

    /// Fewer calls, then fewer boxes.
    fn shrink(&self, calls: Vec<Sets>, what: String) -> Found {
        let fails = |calls: &[Sets]| caught(|| self.check(calls)).is_err();
        let mut calls = fewest(&calls, fails);
        for i in 0..calls.len() {
            let with = |a: &[_], b: Option<&[_]>| {
                let mut less = calls.clone();
                less[i] = (a.to_vec(), b.map(<[_]>::to_vec));
                less
            };
            let (a, b) = calls[i].clone();
            let a = fewest(&a, |a| fails(&with(a, b.as_deref())));
            let b = b.map(|b| fewest(&b, |b| fails(&with(&a, Some(b)))));
            calls[i] = (a, b);
        }
        let what = caught(|| self.check(&calls)).err().unwrap_or(what);
        let &Self { place, method, scheduling, threads } = self;
        let mut code = place.code();
        let backend = place.backend();
        code += &format!(
            "let mut methods = ccd::every({backend:?});\n\
             let method = methods.find(|m| m.to_string() == \"{method}\").unwrap();\n"
        );
        code += &if scheduling == Scheduling::default() {
            "let scheduling = ccd::Scheduling::default();\n".into()
        } else {
            let every = format!("ccd::Scheduling::every({backend:?})");
            format!(
                "let scheduling = {every}.find(|s| s.to_string() == \"{scheduling}\").unwrap();\n"
            )
        };
        code += "let mut broad =\n    ccd::any::BroadPhase::scheduled";
        code += &format!("(&choice, {threads}, method, scheduling).unwrap();\n");
        for (a, b) in &calls {
            let list = |name: &str, boxes: &[Aabb<f32>]| {
                let all: Vec<String> = boxes.iter().map(|b| format!("    ccd::{b:?},\n")).collect();
                format!("let {name}: Vec<ccd::Aabb<f32>> = vec![\n{}];\n", all.concat())
            };
            code += &list("a", a);
            code += &match b {
                None => "let found = broad.self_pairs(&a);\n\
                         let want = ccd_testkit::brute::self_pairs(&a);\n"
                    .into(),
                Some(b) => {
                    list("b", b)
                        + "let found = broad.pairs(&a, &b);\n\
                           let want = ccd_testkit::brute::pairs(&a, &b);\n"
                }
            };
            code += "let mut found = found.unwrap().into_vec();\n";
            code += "found.sort_unstable_by_key(|p| (p.a, p.b));\nassert_eq!(found, want);\n";
        }
        Found { what: format!("{method}, {scheduling}, {threads} threads: {what}"), code }
    }
}
