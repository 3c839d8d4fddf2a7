//! Distances at one moment: the exact one is between the bounds that are told, of features near and
//! far, large and thin, in the least units that there are.

use crate::common::Points;
use crate::common::exact_distance::{exact, square};
use crate::common::random::Random;
use ccd_core::narrow_phase::distance::Distance;
use ccd_core::narrow_phase::relative_motion::Patch;

/// Points of which the first, or the first two, are a gap above the others: in the middle, beside
/// or beyond them, in any axes.
fn points(random: &mut Random, patch: Patch) -> Points<f64> {
    let (gap, thin) = (random.power(-40.0, 1.0), random.power(-40.0, 0.0));
    let (s, r) = (random.between(-0.25, 1.0), random.between(-0.25, 1.0));
    let flat: Points<f64> = match patch {
        Patch::Triangle => [[s, r * thin, gap], [0.0; 3], [1.0, 0.0, 0.0], [s, thin, 0.0]],
        // Parallel, if thin, but for little.
        Patch::Parallelogram => {
            [[-s, 0.0, 0.0], [1.0 - s, 0.0, 0.0], [-r, -r * thin, gap], [1.0 - r, thin, gap]]
        }
    };
    let axes = [random.vector(), random.vector(), random.vector()];
    let offset = if random.below(2) == 0 { random.vector() } else { [0.0; 3] };
    flat.map(|p| {
        std::array::from_fn(|k| {
            p[0] * axes[0][k] + p[1] * axes[1][k] + p[2] * axes[2][k] + offset[k]
        })
    })
}

#[test]
fn exact_distances_are_between_their_bounds() {
    let mut random = Random::new(1);
    let n = 1_600;
    // A power itself would be the inverse of one that overflows.
    let least_unit = 2f64.powi(-530) * 2f64.powi(-530);
    // Exact distances below and above the middle of the bounds.
    let mut count = [0; 2];
    for i in 0..n {
        let patch = if random.below(2) == 0 { Patch::Triangle } else { Patch::Parallelogram };
        let unit = [1.0, 1.0, 2f64.powi(-30), 2f64.powi(300), least_unit][i % 5];
        let x = points(&mut random, patch).map(|p| p.map(|c| c * unit));
        let [v, e0, e1] = [x[0], x[2], x[3]];
        let (d, patch, x) = match (random.below(6), patch) {
            (0, _) => (Distance::vertex_edge([v, e0, e1]), Patch::Parallelogram, [v, v, e0, e1]),
            (1, _) => (Distance::vertex_vertex([v, e0]), Patch::Parallelogram, [v, v, e0, e0]),
            (_, Patch::Parallelogram) => (Distance::edge_edge(x), patch, x),
            (_, Patch::Triangle) => (Distance::vertex_face(x), patch, x),
        };
        let [least, greatest] = [d.least, d.greatest].map(exact);
        let truth = square(patch, &x, &x, &exact(0.0));
        let tell = || format!("{d:?} of {patch:?} {x:?}");
        assert!(&least * &least <= truth, "nearer: {}", tell());
        assert!(&greatest * &greatest >= truth, "further: {}", tell());
        let middle = (&least + &greatest) / exact(2.0);
        count[(&middle * &middle < truth) as usize] += 1;
        let bits = 3.0 * f64::from_bits(1);
        assert!(d.greatest - d.least <= 1e-7 * d.greatest + bits, "wide: {}", tell());
    }
    println!("below the middle, above it, of {n}: {count:?}");
    assert!(count.iter().all(|k| *k > n / 20), "{count:?} of {n} show little");
}
