//! Boxes of 28 sizes by 12 shapes, by every method and every way to schedule it, against brute
//! force: three calls on one broad phase, so that what it keeps meets other boxes.

use super::{Counts, Place, fewest};
use ccd::any::BroadPhase;
use ccd::method::{BroadPhaseMethod, Scheduling};
use ccd::{Aabb, Pair};
use ccd_testkit::brute;
use ccd_testkit::grazing::random::Random;
use serde::{Deserialize, Serialize};

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
    ("line", |r, i, _| Aabb { min: [i as f32, 0.0, 0.0], max: [i as f32 + length(r), 0.0, 0.0] }),
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

fn length(r: &mut Random) -> f32 {
    [0.5, 1.0, 1.5][r.below(3)]
}

fn cube(at: [f32; 3], side: f32) -> Aabb<f32> {
    Aabb { min: at, max: at.map(|c| c + side) }
}

fn make(random: &mut Random, counts: &mut Counts) -> Boxes {
    let (n, (shape, make)) = (SIZES[random.below(28)], SHAPES[random.below(12)]);
    counts.add(&format!("sets of {shape}"), 1);
    (0..n).map(|i| make(random, i, n)).map(|b| [b.min, b.max]).collect()
}

/// The corners of boxes.
type Boxes = Vec<[[f32; 3]; 2]>;

/// Calls of one broad phase: pairs within the first set, or between both.
#[derive(Clone, Serialize, Deserialize)]
pub struct Case {
    method: BroadPhaseMethod,
    scheduling: Scheduling,
    threads: usize,
    calls: Vec<(Boxes, Option<Boxes>)>,
}

fn boxes(corners: &Boxes) -> Vec<Aabb<f32>> {
    corners.iter().map(|&[min, max]| Aabb { min, max }).collect()
}

/// Boxes with zero for bounds below the smallest normal number.
fn flushed(boxes: &[Aabb<f32>]) -> Vec<Aabb<f32>> {
    let flush = |x: f32| if x.is_subnormal() { 0.0 } else { x };
    boxes.iter().map(|b| Aabb { min: b.min.map(flush), max: b.max.map(flush) }).collect()
}

fn brute(a: &[Aabb<f32>], b: Option<&[Aabb<f32>]>) -> Vec<Pair> {
    b.map_or_else(|| brute::self_pairs(a), |b| brute::pairs(a, b))
}

impl super::Case for Case {
    const NAME: &str = "boxes";

    fn make(place: &Place, number: u64, mut random: Random, counts: &mut Counts) -> Self {
        let with = |method| place.schedulings(method).into_iter().map(move |s| (method, s));
        let all: Vec<_> = ccd::method::every(place.backend()).flat_map(with).collect();
        // A step that shares no factor with their number visits all of them.
        let (method, scheduling) = all[(number.wrapping_mul(7919) % all.len() as u64) as usize];
        let threads = 1 + random.below(2);
        let mut call = || {
            let a = make(&mut random, counts);
            (a, (random.below(2) == 0).then(|| make(&mut random, counts)))
        };
        Self { method, scheduling, threads, calls: vec![call(), call(), call()] }
    }

    fn check(&self, place: &Place, counts: &mut Counts) -> Result<(), String> {
        let &Self { method, scheduling, threads, .. } = self;
        let failed = |what: String| format!("{method}, {scheduling}, {threads} threads: {what}");
        let mut broad = BroadPhase::scheduled(&place.choice, threads, method, scheduling)
            .map_err(|e| failed(format!("refused: {e}")))?;
        for (a, b) in &self.calls {
            let (a, b) = (boxes(a), b.as_ref().map(boxes));
            let found = match &b {
                None => broad.self_pairs(&a),
                Some(b) => broad.pairs(&a, b),
            };
            let mut found = match found {
                Ok(pairs) => pairs.into_vec(),
                Err(e) => return Err(failed(format!("an error: {e}"))),
            };
            let want = brute(&a, b.as_deref());
            let key = |p: &Pair| (p.a, p.b);
            found.sort_unstable_by_key(key);
            counts.add("pairs", want.len() as u64);
            if let Some(two) = found.windows(2).find(|two| two[0] == two[1]) {
                return Err(failed(format!("a pair twice: {:?}", two[0])));
            }
            let without = |all: &[Pair], pairs: &[Pair]| {
                pairs.iter().find(|p| all.binary_search_by_key(&key(p), key).is_err()).copied()
            };
            if let Some(pair) = without(&found, &want) {
                return Err(failed(format!("a pair is missing: {pair:?}")));
            }
            // A device may take bounds below the smallest normal number as zero, as is documented.
            let most = match place.choice.device() {
                None => want,
                Some(_) => brute(&flushed(&a), b.as_deref().map(flushed).as_deref()),
            };
            if let Some(pair) = without(&most, &found) {
                return Err(failed(format!("a pair too much: {pair:?}")));
            }
        }
        counts.add("calls", self.calls.len() as u64);
        Ok(())
    }

    /// Fewer calls, then fewer boxes.
    fn shrunk(self, fails: &dyn Fn(&Self) -> bool) -> Self {
        let with_calls = |calls: &[_]| Self { calls: calls.to_vec(), ..self.clone() };
        let mut calls = fewest(&self.calls, |calls| fails(&with_calls(calls)));
        for i in 0..calls.len() {
            let with = |a: &[_], b: Option<&[_]>| {
                let mut less = calls.clone();
                less[i] = (a.to_vec(), b.map(<[_]>::to_vec));
                with_calls(&less)
            };
            let (a, b) = calls[i].clone();
            let a = fewest(&a, |a| fails(&with(a, b.as_deref())));
            let b = b.map(|b| fewest(&b, |b| fails(&with(&a, Some(b)))));
            calls[i] = (a, b);
        }
        with_calls(&calls)
    }
}
