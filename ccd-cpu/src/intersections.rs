//! Where a mesh goes through itself at one moment: edges through faces, exactly.

use crate::broad_phase::BroadPhase;
use crate::threads::Threads;
use ccd_core::layout::Pair;
use ccd_core::model::contact::State;
use ccd_core::model::error::check_coordinates;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use ccd_core::model::precision::{Points, Precision, Slices};
use ccd_core::narrow_phase::intersection::segment_meets_triangle;
use ccd_core::{Aabb, Coordinate, Error, Real};

/// An edge and a face without a common vertex that have a point in common.
///
/// ```
/// use ccd_core::model::{contact::State, mesh::Mesh, options::Options};
/// use ccd_cpu::intersections;
///
/// // An edge whose end is in a face: touching counts.
/// let mesh = Mesh::with_edges(5, &[[0, 1, 2]], &[[3, 4]])?;
/// let x = [
///     [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0],
///     [0.25, 0.0, 0.25], [0.25, 1.0, 0.25],
/// ];
/// let found = intersections(&mesh, &x, &Options::default())?;
/// assert_eq!((found[0].face, found[0].state), (0, State::Hit));
/// assert_eq!(mesh.edges()[found[0].edge as usize], [3, 4]);
/// # Ok::<(), ccd_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Intersection {
    /// The edge.
    pub edge: u32,
    /// The face.
    pub face: u32,
    /// [`State::Undecided`]: not certainly apart, with coordinates beyond 2^200, or below 2^-200
    /// and not zero, for which nothing is calculated exactly.
    pub state: State,
}

/// Edges and faces of `mesh` at positions `x` that have a point in common but no vertex, sorted by
/// edge, then by face. A mesh without any does not intersect itself.
///
/// Both are closed: touching counts. Nothing is rounded. Of the options, bodies, threads and the
/// broad phase count.
///
/// ```
/// use ccd_core::model::{mesh::Mesh, options::Options};
/// use ccd_cpu::intersections;
///
/// let mesh = Mesh::new(6, &[[0, 1, 2], [3, 4, 5]])?;
/// let x = [
///     [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0],
///     [0.2, -1.0, 0.2], [0.2, 1.0, 0.2], [5.0, 1.0, 5.0],
/// ];
/// let found = intersections(&mesh, &x, &Options::default())?;
/// let edges: Vec<_> = found.iter().map(|i| mesh.edges()[i.edge as usize]).collect();
/// assert_eq!(edges, [[1, 2], [3, 4]]);
/// # Ok::<(), ccd_core::Error>(())
/// ```
///
/// # Errors
/// Positions for another number of vertices, or that are not finite; options that are none.
pub fn intersections<T: Coordinate>(
    mesh: &Mesh,
    x: &[[T; 3]],
    options: &Options,
) -> Result<Vec<Intersection>, Error> {
    find(mesh, T::slices::<Points, 1>([x]), options)
}

#[inline(never)]
fn find(mesh: &Mesh, x: Slices<Points, 1>, options: &Options) -> Result<Vec<Intersection>, Error> {
    options.check(mesh)?;
    let x: Vec<[f64; 3]> = match x {
        Precision::F32([x]) => checked(mesh, x)?,
        Precision::F64([x]) => checked(mesh, x)?,
    };
    let threads = Threads::new(options.threads)?;
    threads.enter(|| {
        let count = if options.threads == 1 { 1 } else { 0 };
        let mut boxes = BroadPhase::scheduled(count, options.broad_phase, options.scheduling)?;
        let [edges, faces] = [
            mesh.edges().iter().map(|ids| around(&x, ids)).collect::<Vec<_>>(),
            mesh.faces().iter().map(|ids| around(&x, ids)).collect(),
        ];
        let pairs = boxes.pairs(&edges, &faces)?;
        let meet = |pair: &Pair| {
            let (edge, face) = (mesh.edges()[pair.a as usize], mesh.faces()[pair.b as usize]);
            let is_wanted = options.bodies.as_ref().is_none_or(|b| b.wants(edge[0], face[0]));
            if edge.iter().any(|v| face.contains(v)) || !is_wanted {
                return None;
            }
            let at = |v: u32| x[v as usize];
            let state = match segment_meets_triangle(edge.map(at), face.map(at)) {
                Some(true) => State::Hit,
                Some(false) => return None,
                None => State::Undecided,
            };
            Some(Intersection { edge: pair.a, face: pair.b, state })
        };
        let parts: Vec<&[Pair]> = pairs.runs().flat_map(|run| run.chunks(4096)).collect();
        let mut found = vec![Vec::new(); parts.len()];
        threads.each(&mut found, &|k, out| out.extend(parts[k].iter().filter_map(meet)));
        let mut all: Vec<Intersection> = found.into_iter().flatten().collect();
        all.sort_unstable_by_key(|i| (i.edge, i.face));
        Ok(all)
    })
}

fn checked<T: Real>(mesh: &Mesh, x: &[[T; 3]]) -> Result<Vec<[f64; 3]>, Error> {
    mesh.check_positions(x, x)?;
    check_coordinates(0, x)?;
    Ok(x.iter().map(|p| p.map(Real::to_f64)).collect())
}

fn around(x: &[[f64; 3]], ids: &[u32]) -> Aabb<f64> {
    let first = Aabb::of_point(x[ids[0] as usize]);
    ids[1..].iter().fold(first, |all, &v| all.union(&Aabb::of_point(x[v as usize])))
}
