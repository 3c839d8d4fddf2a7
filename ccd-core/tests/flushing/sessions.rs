//! Whole steps of small meshes in units from 2^-149 to 2^120: the contacts of all their pairs are
//! those in the unit 1.

use crate::queries::{DISTANCES, Random, exponents};
use crate::step::{OnDevice, Query, Step, wrong};
use ccd_core::Verdict;
use ccd_core::narrow_phase::relative_motion::Patch;

/// Triangles of a lattice, some of them small and near the middle, without common vertices.
fn soup(random: &mut Random) -> Step {
    let n = 6;
    let (mut x0, mut x1) = (Vec::new(), Vec::new());
    for _ in 0..n {
        let size = random.one_of(&[2, 8, 60]);
        let moves = random.one_of(&[0, 1, 8, 60]);
        let middle: [f64; 3] = std::array::from_fn(|_| random.whole(size));
        let travel: [f64; 3] = std::array::from_fn(|_| random.whole(moves));
        for _ in 0..3 {
            let p: [f64; 3] = std::array::from_fn(|k| middle[k] + random.whole(size));
            x0.push(p);
            x1.push(std::array::from_fn(|k| p[k] + travel[k]));
        }
    }
    Step { x0, x1, min_distance: random.one_of(&DISTANCES) }
}

fn pairs(n: u32) -> impl Iterator<Item = Query> {
    let sides = move |f: u32| (0..3).map(move |k| [3 * f + k, 3 * f + (k + 1) % 3]);
    let vertex_face = (0..n).flat_map(move |f| {
        let others = (0..3 * n).filter(move |v| v / 3 != f);
        others.map(move |v| (Patch::Triangle, [v, 3 * f, 3 * f + 1, 3 * f + 2]))
    });
    let edge_edge =
        (0..n).flat_map(move |f| (0..f).map(move |g| (f, g))).flat_map(move |(f, g)| {
            let of = move |[a, b]: [u32; 2]| sides(g).map(move |[c, d]| [a, b, c, d]);
            sides(f).flat_map(of).map(|ids| (Patch::Parallelogram, ids))
        });
    vertex_face.chain(edge_edge)
}

#[test]
fn steps_have_the_same_contacts_in_all_units() {
    let mut random = Random::new(9);
    let (mut n, mut hits, mut open) = (0, 0, 0);
    for _ in 0..40 {
        let step = soup(&mut random);
        let truths: Vec<(Query, Verdict<f64>)> =
            pairs(6).map(|query| (query, step.truth(query))).collect();
        for e in exponents() {
            let Some(scaled) = step.times(2f64.powi(e)) else { continue };
            let device = OnDevice::new(&scaled, false);
            for &(query, truth) in &truths {
                let mut got = device.narrow(query);
                n += 1;
                hits += matches!(truth, Verdict::Hit { .. }) as usize;
                open += got.undecided as usize;
                if got.undecided == 1 {
                    got = device.wide(query);
                }
                let why = wrong(truth, &got);
                assert!(why.is_none(), "{why:?} at 2^{e}: {got:?}, {truth:?} {query:?} {step:?}");
            }
        }
    }
    println!("{n} pairs, {hits} hits, {open} open in f32");
    assert!(hits * 50 > n && open * 10 < n, "{n} pairs, {hits} hits, {open} open in f32");
}
