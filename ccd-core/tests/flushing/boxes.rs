//! Boxes on devices that flush denormals: no pair within the minimum distance is lost.

use crate::number::Flushed;
use crate::random::Random;
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::swept_box::swept;
use ccd_core::backend::quantization::margin;

/// Numbers from far below the smallest normal one to some way above it, of both signs.
fn number(random: &mut Random) -> f32 {
    // Exponents 0 (denormal) to 3; denormals of all sizes.
    let bits = random.bits();
    let small = bits & 0x01ff_ffff;
    let small = if small < 0x0080_0000 { small >> random.below(24) } else { small };
    f32::from_bits(bits & 0x8000_0000 | small)
}

/// The box that a device makes of a point, grown by half of the distance as the host sends that.
fn device_box(x: f32, min_distance: f64) -> Aabb<Flushed<f32>> {
    swept([Flushed(x); 3], [Flushed(x); 3]).inflated(Flushed(margin::<f32>(min_distance)))
}

fn check_pair(x: f32, y: f32, min_distance: f64) {
    let (a, b) = (device_box(x, min_distance), device_box(y, min_distance));
    assert!(
        a.overlaps(&b),
        "{x:e} and {y:e} at a distance of {min_distance:e} are lost: {a:?} {b:?}"
    );
}

#[test]
fn pairs_within_the_distance_overlap_where_denormals_are_flushed() {
    // A margin that is flushed itself; a coordinate that is flushed and moves inward by nearly the
    // margin.
    check_pair(1.175_494_4e-38, 1.175_494_6e-38, 1e-40);
    check_pair(3.4e-38, 1.0e-38, 2.45e-38);
    check_pair(-3.4e-38, -1.0e-38, 2.45e-38);
    let mut random = Random::new(1);
    for _ in 0..1_000_000 {
        let (x, y) = (number(&mut random), number(&mut random));
        // Exactly the gap, which is a number of `f64`, and somewhat more.
        let gap = (x as f64 - y as f64).abs();
        check_pair(x, y, gap);
        check_pair(x, y, gap * 1.01);
    }
}

/// The model finds what it is for: without growing, and with the half of the distance alone, pairs
/// are lost.
#[test]
fn the_model_loses_pairs_that_are_grown_by_half_of_the_distance_alone() {
    let lost = |x: f32, y: f32, margin: f32| {
        let of = |x: f32| swept([Flushed(x); 3], [Flushed(x); 3]).inflated(Flushed(margin));
        !of(x).overlaps(&of(y))
    };
    assert!(lost(1.175_494_4e-38, 1.175_494_6e-38, 0.5e-40));
    assert!(lost(3.4e-38, 1.0e-38, 1.23e-38));
    assert!(!lost(3.4e-38, 1.5e-38, 1.23e-38));
}
