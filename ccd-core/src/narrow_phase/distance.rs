//! How far two features are from each other at one moment, between two bounds that are certain.

use crate::math::real::{Num, Real};
use crate::math::vec3::{dot, scale, sum_abs};
use crate::narrow_phase::closest_point::closest;
use crate::narrow_phase::conservative_advancement::Field;
use crate::narrow_phase::exact_distance;
use crate::narrow_phase::relative_motion::{Motion, Patch, in_unit};

/// The distance of two features, in the unit of the coordinates: between these, both included.
///
/// They are apart by at most 1e-7 of it, and the last bit of each. Only where a coordinate is not
/// zero and below 2^-200 of the greatest one, or a difference of coordinates overflows, there may
/// be more between them.
///
/// ```
/// use ccd::Distance;
///
/// let d = Distance::vertex_vertex([[0.0, 0.0, 0.0], [3.0, 4.0, 0.0]]);
/// assert!(d.least <= 5.0 && d.greatest >= 5.0 && d.greatest - d.least < 1e-12);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distance {
    /// It is at least this.
    pub least: f64,
    /// It is at most this.
    pub greatest: f64,
}

/// The most that may be between the bounds, as a part of the greater one.
const WIDTH: f64 = 1e-7;

impl Distance {
    /// Of a vertex and a face, `v f0 f1 f2`.
    ///
    /// ```
    /// use ccd::Distance;
    ///
    /// let face = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    /// let d = Distance::vertex_face([[0.2, 0.5, 0.2], face[0], face[1], face[2]]);
    /// assert!(d.least <= 0.5 && d.greatest >= 0.5 && d.greatest - d.least < 1e-13);
    /// ```
    pub fn vertex_face(x: [[f64; 3]; 4]) -> Self {
        Self::of(&x, Patch::Triangle)
    }

    /// Of two edges, `ea0 ea1 eb0 eb1`.
    pub fn edge_edge(x: [[f64; 3]; 4]) -> Self {
        Self::of(&x, Patch::Parallelogram)
    }

    /// Of a vertex and an edge, `v e0 e1`.
    pub fn vertex_edge([v, e0, e1]: [[f64; 3]; 3]) -> Self {
        Self::edge_edge([e0, e1, v, v])
    }

    /// Of two vertices.
    pub fn vertex_vertex([v, w]: [[f64; 3]; 2]) -> Self {
        Self::vertex_edge([v, w, w])
    }

    /// By rounded numbers, and without rounding where that leaves too much open.
    fn of(x: &[[f64; 3]; 4], patch: Patch) -> Self {
        let rounded = Self::rounded(&Motion::new(patch, x, x, 0.0), patch);
        if rounded.greatest - rounded.least <= WIDTH * rounded.greatest {
            return rounded;
        }
        let exact = exact_distance::bounds(x, patch);
        exact.map_or(rounded, |[least, greatest]| Self { least, greatest })
    }

    /// Features that are near for their size, or nearly parallel, have no direction that is known
    /// well: then `least` is far below.
    fn rounded(m: &Motion<f64>, patch: Patch) -> Self {
        let (m, unit) = in_unit(m, 1.0);
        let nearest = closest(m.a[0], m.b[0], m.c[0], patch);
        let error = m.corner_error();
        // Of three components that err.
        let greatest = dot(nearest, nearest).sqrt_up() * (1.0 + 8.0 * f64::UNIT) + error * 2.0;
        // What vanishes when it is brought back to the unit of the input was not nothing.
        let (least, greatest) = (least_along(&m, patch, nearest) / unit, greatest / unit);
        // Coordinates whose differences overflow, or that are none, may be at any distance.
        let greatest = if greatest >= 0.0 { Real::next_up(greatest) } else { f64::INFINITY };
        Self { least: Num::max(Real::next_down(least), 0.0), greatest }
    }
}

/// How far the features are certainly apart along `w`. The bound on an excess covers what it and
/// this quotient round; a direction that is off costs the square of its angle.
fn least_along(m: &Motion<f64>, patch: Patch, w: [f64; 3]) -> f64 {
    let sum = sum_abs(w);
    if !(sum > 0.0 && sum.is_finite()) {
        return 0.0;
    }
    let corners = m.corners(patch, 0);
    let field = Field { corners: [corners; 2], slack: m.corner_error(), min_distance: 0.0 };
    let w = scale(w, 1.0 / sum);
    field.along(w).least_at(0.0) / dot(w, w).sqrt_up()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    /// That the bounds hold is tested in exact arithmetic (`tests/bounds/moment.rs`).
    #[test]
    fn bounds_are_narrow() {
        let mut random = Random::new(3);
        for round in 0..2000 {
            let scale = [1.0, 1e-3, 1e9, 1e90, 1e-150][round % 5];
            let mut x = [(); 4].map(|()| random.point().map(|c| c - 0.5));
            if round % 7 == 0 {
                // Parallel, or without an area.
                x[3] = core::array::from_fn(|k| x[2][k] + (x[1][k] - x[0][k]) * 0.5);
            }
            let x = x.map(|p| p.map(|c| c * scale));
            for d in [
                Distance::vertex_face(x),
                Distance::edge_edge(x),
                Distance::vertex_edge([x[0], x[1], x[2]]),
                Distance::vertex_vertex([x[0], x[1]]),
            ] {
                let wide = d.greatest - d.least;
                assert!(wide >= 0.0 && wide <= 1e-9 * scale, "{d:?} {x:?}");
            }
        }
        let touching = Distance::vertex_vertex([[1e-300; 3]; 2]);
        assert_eq!(touching, Distance { least: 0.0, greatest: 0.0 });
        for x in [f64::MAX, f64::NAN, f64::INFINITY] {
            let d = Distance::vertex_vertex([[x; 3], [-x; 3]]);
            assert!(d.least == 0.0 && d.greatest == f64::INFINITY, "{d:?}");
        }
    }
}
