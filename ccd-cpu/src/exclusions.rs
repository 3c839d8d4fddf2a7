//! Pairs of features that are near each other at rest.

use crate::broad_phase::pair_list::Pairs;
use crate::session::Session;
use ccd_core::backend::layout::Pair;
use ccd_core::model::contact::Kind;
use ccd_core::model::exclusions::Exclusions;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use ccd_core::{Coordinate, Error, Real};

/// Pairs of `mesh` that are, or may be, within `distance` of each other at the positions `rest`: of
/// a mesh whose edges are shorter than the minimum distance these would be in contact wherever it
/// is whole. Vertices against faces and edges against edges: particles near rods or
/// each other are not listed.
///
/// ```
/// use ccd::{Mesh, near_at_rest};
///
/// // Two squares, one above the other.
/// let mesh = Mesh::new(8, &[[0, 1, 2], [2, 1, 3], [4, 5, 6], [6, 5, 7]])?;
/// let rest: Vec<[f64; 3]> =
///     (0..8).map(|i| [(i % 2) as f64, (i / 4) as f64 * 0.5, (i / 2 % 2) as f64]).collect();
/// assert_eq!(near_at_rest(&mesh, &rest, 0.4)?.vf, [[0u32; 2]; 0]);
/// assert_eq!(near_at_rest(&mesh, &rest, 0.6)?.vf.len(), 12);
/// # Ok::<(), ccd::Error>(())
/// ```
///
/// # Errors
/// Positions for another number of vertices, or that are not finite; a distance that is negative or
/// not finite.
pub fn near_at_rest<T: Coordinate>(
    mesh: &Mesh,
    rest: &[[T; 3]],
    distance: f64,
) -> Result<Exclusions, Error> {
    near_at_rest_on(0, mesh, rest, distance)
}

/// [`near_at_rest`] on so many threads, as [`Options::threads`] counts them.
#[doc(hidden)]
pub fn near_at_rest_on<T: Coordinate>(
    threads: usize,
    mesh: &Mesh,
    rest: &[[T; 3]],
    distance: f64,
) -> Result<Exclusions, Error> {
    let options = Options::default().with_min_distance(distance).with_threads(threads);
    let mut session = Session::new(mesh.clone(), options)?;
    let wide: Vec<[f64; 3]> = rest.iter().map(|p| p.map(Real::to_f64)).collect();
    let all = session.candidates(&wide, &wide)?;
    let near = |kind: Kind, pairs: Pairs| {
        let within = |pair: &Pair| mesh.distance(kind, *pair, &wide).least <= distance;
        pairs.iter().filter(within).map(|pair| [pair.a, pair.b]).collect()
    };
    Ok(Exclusions::new(near(Kind::VertexFace, all.vf), near(Kind::EdgeEdge, all.ee)))
}
