//! Near-degenerate queries in units from 2^-149 to 2^120, against the CPU.

use crate::random;
use crate::step::{OnDevice, Query, Step, in_f64, wrong};
use ccd_core::Verdict;
use ccd_core::backend::layout::split;
use ccd_core::narrow_phase::decide::Verdicts;
use ccd_core::narrow_phase::relative_motion::Patch;

/// Exponents of units: all near the smallest numbers, and some of the others.
pub fn exponents() -> impl Iterator<Item = i32> {
    (-149..=-108).chain([-100, -90, -80, -75, -74, -73, -60, -20, 0, 30, 60, 90, 110, 120])
}

/// Whole numbers at random.
pub struct Random(random::Random);

impl Random {
    pub fn new(seed: u32) -> Self {
        Self(random::Random::new(seed))
    }

    pub fn below(&mut self, n: u32) -> u32 {
        self.0.below(n)
    }

    /// From `-n` to `n`.
    pub fn whole(&mut self, n: u32) -> f64 {
        self.below(2 * n + 1) as f64 - n as f64
    }

    pub fn one_of<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len() as u32) as usize]
    }
}

/// The minimum distances that are tried, from a small part of the unit of coordinates to many.
pub const DISTANCES: [f64; 8] = [0.0, 0.0, 0.0, 0.0, 1.0 / 1024.0, 0.25, 1.0, 16.0];

/// Points of a lattice, where much touches or is flat, with axes that may be much longer than
/// others, near the origin or not; what is hit may rest, and all may.
fn lattice(random: &mut Random) -> (Step, Query) {
    let n = random.one_of(&[1, 2, 4, 16, 100]);
    let axes: [f64; 3] =
        std::array::from_fn(|_| random.one_of(&[1.0, 1.0, 1.0, 16.0, 1024.0, 68_719_476_736.0]));
    let shift: [f64; 3] = std::array::from_fn(|_| random.one_of(&[0.0, 0.0, 1600.0]));
    let mut point =
        || -> [f64; 3] { std::array::from_fn(|k| random.whole(n) * axes[k] + shift[k]) };
    let x0: Vec<_> = (0..4).map(|_| point()).collect();
    let mut x1: Vec<_> = (0..4).map(|_| point()).collect();
    let patch = random.one_of(&[Patch::Triangle, Patch::Parallelogram]);
    match random.below(4) {
        0 => x1[1..].copy_from_slice(&x0[1..]),
        1 => x1[..2].copy_from_slice(&x0[..2]),
        2 if random.below(4) == 0 => x1.copy_from_slice(&x0),
        _ => {}
    }
    let min_distance = random.one_of(&DISTANCES);
    (Step { x0, x1, min_distance }, (patch, [0, 1, 2, 3]))
}

/// A vertex that goes through a face at half time, just inside of a side or just outside, in
/// sixteenths of the size of the face.
fn beside(random: &mut Random) -> (Step, Query) {
    let power = |random: &mut Random, most: u32| 2f64.powi(random.below(most + 1) as i32);
    let (y, z) = (power(random, 10), power(random, 10));
    let (y, z) = if random.below(4) == 0 { (y * 2f64.powi(36), z * 2f64.powi(36)) } else { (y, z) };
    let shift = random.one_of(&[0.0, 0.0, 1600.0]);
    let at = |p: [f64; 3]| [p[0] + shift, p[1] * y + shift, p[2] * z];
    let v = [random.whole(3) + 12.0 * random.below(2) as f64, 32.0, 64.0];
    let face = [[0.0; 3], [64.0, 0.0, 0.0], [16.0, 64.0, 0.0]];
    let x0 = vec![at(v), at(face[0]), at(face[1]), at(face[2])];
    let x1 = vec![at([v[0], v[1], -64.0]), x0[1], x0[2], x0[3]];
    let min_distance = random.one_of(&DISTANCES);
    (Step { x0, x1, min_distance }, (Patch::Triangle, [0, 1, 2, 3]))
}

/// Counts of what was seen.
#[derive(Debug, Default)]
struct Seen {
    queries: usize,
    hits: usize,
    /// Left open by `f32` in the unit 1, and in all lesser ones.
    open_in_one: usize,
    open_below: usize,
}

/// In all units, in a unit of the table and as given.
fn check(step: &Step, query: Query, seen: &mut Seen) {
    let truth = step.truth(query);
    for e in exponents() {
        let Some(scaled) = step.times(2f64.powi(e)) else { continue };
        for as_given in [false, true] {
            let device = OnDevice::new(&scaled, as_given);
            let what = |e| format!("2^{e}, as given: {as_given}: {truth:?}, {query:?} {step:?}");
            let got = device.narrow(query);
            if let Some(why) = wrong(truth, &got) {
                panic!("{why}: {got:?} at {}", what(e));
            }
            if got.undecided == 1 {
                let got = device.wide(query);
                if let Some(why) = wrong(truth, &got) {
                    panic!("{why} in f64: {got:?} at {}", what(e));
                }
                let open = matches!(truth, Verdict::Undecided { .. });
                assert!(open || got.undecided == 0, "open in f64: {got:?} at {}", what(e));
            }
            if !as_given {
                seen.queries += 1;
                seen.hits += matches!(truth, Verdict::Hit { .. }) as usize;
                let of = if e < 0 { &mut seen.open_below } else { &mut seen.open_in_one };
                *of += if e > 0 { 0 } else { got.undecided as usize };
            }
        }
    }
    // The same of f64 and its smallest numbers.
    for e in (-1074..-1000).step_by(3) {
        let unit = 2f64.powi(e / 2) * 2f64.powi(e - e / 2);
        let Some(got) = in_f64(step, query, unit) else { continue };
        let words = |touches, undecided, toi: f64| Verdicts {
            touches,
            undecided,
            approach: 0,
            toi: split(toi),
        };
        let words = match got {
            Verdict::Miss => words(false, 0, 0.0),
            Verdict::Hit { toi } => words(true, 0, toi),
            Verdict::Undecided { toi } => words(true, 1, toi),
        };
        let why = wrong(truth, &words);
        assert!(why.is_none(), "{why:?} at 2^{e}: {got:?}, {truth:?} {query:?} {step:?}");
    }
}

fn run(make: fn(&mut Random) -> (Step, Query), cases: usize) {
    let mut random = Random::new(3);
    let mut seen = Seen::default();
    for _ in 0..cases {
        let (step, query) = make(&mut random);
        check(&step, query, &mut seen);
    }
    println!("{seen:?}");
    let Seen { queries, hits, open_in_one, open_below } = seen;
    assert!(hits * 20 > queries, "{hits} hits of {queries} show nothing");
    // Positions are rounded there.
    let (below, most) = (exponents().filter(|&e| e < 0).count(), open_in_one + cases / 10);
    assert!(
        open_below <= below * most,
        "{open_in_one} are open, but {open_below} in {below} units"
    );
}

#[test]
fn points_of_a_lattice_are_decided_alike_in_all_units() {
    run(lattice, 2000);
}

#[test]
fn what_passes_a_side_is_decided_alike_in_all_units() {
    run(beside, 500);
}

/// A vertex and a face, which rests.
fn vertex_face(v0: [f64; 3], v1: [f64; 3], face: [[f64; 3]; 3], min_distance: f64) {
    let of = |v| [&[v][..], &face].concat();
    let step = Step { x0: of(v0), x1: of(v1), min_distance };
    let mut seen = Seen::default();
    check(&step, (Patch::Triangle, [0, 1, 2, 3]), &mut seen);
    assert!(seen.queries > 40);
}

/// It was missed in `f32`, and where the numbers were denormals, in `f64`.
#[test]
fn differences_that_are_flushed_decide_nothing() {
    for (shift, times) in [(0.0, 1.0), (100.0, 1.0), (0.0, 1024.0), (0.0, 68_719_476_736.0)] {
        let at = |p: [f64; 3]| [p[0] + shift, p[1] * times + shift, p[2] * times];
        let face = [[0.0; 3], [4.0, 0.0, 0.0], [1.0, 4.0, 0.0]];
        vertex_face(at([0.9375, 2.0, 4.0]), at([0.9375, 2.0, -4.0]), face.map(at), 0.0);
    }
}

/// It was a contact at a distance that is not reached.
#[test]
fn a_distance_that_is_raised_certifies_nothing() {
    let corner = [[4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]];
    vertex_face([1.0; 3], [1.0; 3], corner, 1.0 / 64.0);
}
