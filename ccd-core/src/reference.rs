//! A step as plainly as it can be written: on one thread, in the precision of the input, without a
//! standard library, SIMD, trees or filters. Every backend finds what it finds.
//!
//! 1. Each vertex sweeps a box; the box of a face or an edge is the union of those of its vertices.
//! 2. Sweep and prune finds boxes that overlap; features with a common vertex, and those that the
//!    rules of bodies exclude, are no candidates.
//! 3. Each candidate is decided in `f64`, or exactly.
//!
//! Cost: `n log n` to sort, and all pairs of boxes whose intervals along x overlap. Backends are
//! some hundred times as fast; this one is for reading, for tests, and for devices without an
//! operating system.

use crate::backend::broad_phase::candidate::{is_corner, share_vertex};
use crate::backend::broad_phase::swept_box::swept;
use crate::backend::quantization::margin;
use crate::backend::rules::Rules;
use crate::layout::Pair;
use crate::math::aabb::Aabb;
use crate::math::real::Real;
use crate::model::codimensional::Codimensional;
use crate::model::contact::Kind;
use crate::model::decision::Decider;
use crate::model::error::{Error, check_coordinates};
use crate::model::mesh::Mesh;
use crate::model::options::Options;
use crate::model::report::Report;
use alloc::sync::Arc;
use alloc::vec::Vec;

/// All contacts of a step, with [`Report::candidates`] counted; [`Report::filtered`] and times stay
/// 0. Of the options, methods and their scheduling have no effect.
///
/// ```
/// use ccd::{Mesh, Options};
///
/// // A triangle, and a vertex of another one that falls through it.
/// let mesh = Mesh::new(6, &[[0, 1, 2], [3, 4, 5]])?;
/// let x0 = [
///     [0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0],
///     [0.5, 0.5, 1.0], [0.5, 0.5, 3.0], [0.5, 1.0, 3.0f32],
/// ];
/// let mut x1 = x0;
/// x1[3][2] = -1.0;
/// let report = ccd_core::reference::step(&mesh.into(), &x0, &x1, &Options::default())?;
/// assert!(report.toi.is_some_and(|toi| toi <= 0.5 && toi > 0.5 - 1e-6));
/// # Ok::<(), ccd::Error>(())
/// ```
///
/// # Errors
/// What [`Options::check`] and [`Mesh::check_positions`] refuse; [`Error::Coordinate`];
/// [`Error::FixedMoves`]; [`Error::TooMany`] bodies.
pub fn step<T: Real>(
    mesh: &Arc<Mesh>,
    x0: &[[T; 3]],
    x1: &[[T; 3]],
    options: &Options,
) -> Result<Report, Error> {
    options.check(mesh)?;
    mesh.check_positions(x0, x1)?;
    check_coordinates(0, x0)?;
    check_coordinates(1, x1)?;
    let rules = options.bodies.as_ref().map(Rules::new).transpose()?;
    rules.as_ref().map_or(Ok(()), |rules| rules.check_still(x0, x1, None))?;

    let decider = Decider::new(options, [0.0, 1.0]);
    let mut report = Report::default();
    report.set_mesh(mesh);
    for kind in Kind::ALL {
        let mut pairs = candidates(mesh, kind, [x0, x1], options.min_distance);
        pairs.retain(|&pair| {
            let vertices = mesh.vertices_of(kind, pair);
            let (v, w) = (vertices[0], vertices[kind.n_first()]);
            let excludes =
                |rules: &Rules| !rules.wants(v, w) || rules.excludes(kind, pair.a, pair.b);
            !rules.as_ref().is_some_and(excludes)
        });
        pairs.sort_unstable();
        *report.candidates.of(kind) = pairs.len() as u64;
        for pair in pairs {
            if let Some(contact) = decider.contact(mesh, kind, pair, [x0, x1]) {
                report.add(contact, true);
            }
        }
    }
    Ok(report)
}

/// Pairs of features of a kind, without a common vertex, whose swept boxes overlap; each once.
fn candidates<T: Real>(mesh: &Mesh, kind: Kind, x: [&[[T; 3]]; 2], min_distance: f64) -> Vec<Pair> {
    let paths: Vec<Aabb<T>> = x[0].iter().zip(x[1]).map(|(&p, &q)| swept(p, q)).collect();
    let around = |vertices: &[u32]| {
        let boxes = vertices.iter().map(|&v| paths[v as usize]);
        let all = boxes.reduce(|a, b| a.union(&b)).unwrap_or(paths[0]);
        all.inflated(margin(min_distance))
    };
    let (faces, edges) = (mesh.faces(), mesh.edges());
    let mut pairs = Vec::new();
    let mut add = |a: u32, b: u32| pairs.push(Pair { a, b });
    match kind {
        Kind::VertexFace => {
            let vertices: Vec<_> = (0..paths.len() as u32).map(|v| around(&[v])).collect();
            let boxes: Vec<_> = faces.iter().map(|face| around(face)).collect();
            overlaps(&vertices, &boxes, |v, f| {
                if !is_corner(v, faces[f as usize]) {
                    add(v, f);
                }
            });
        }
        Kind::EdgeEdge => {
            let boxes: Vec<_> = edges.iter().map(|edge| around(edge)).collect();
            self_overlaps(&boxes, |a, b| {
                if !share_vertex(edges[a as usize], edges[b as usize]) {
                    add(a, b);
                }
            });
        }
        Kind::VertexEdge | Kind::VertexVertex => {
            let alone = Codimensional::of(mesh);
            let n = alone.vertices.len();
            let vertices: Vec<_> = (0..n).map(|i| alone.vertex_box(i, x, min_distance)).collect();
            let id = |i: u32| alone.vertices[i as usize];
            if kind == Kind::VertexVertex {
                self_overlaps(&vertices, |a, b| add(id(a), id(b)));
            } else {
                let rods = (0..alone.edges.len()).map(|i| alone.edge_box(i, mesh, x, min_distance));
                let rods: Vec<_> = rods.collect();
                overlaps(&vertices, &rods, |v, e| add(id(v), alone.edges[e as usize]));
            }
        }
    }
    pairs
}

/// Calls `found` for each box of `a` and box of `b` that overlap.
fn overlaps<T: Real>(a: &[Aabb<T>], b: &[Aabb<T>], mut found: impl FnMut(u32, u32)) {
    // Of two intervals that overlap, one begins within the other.
    let (in_a, in_b) = (by_begin(a), by_begin(b));
    for (i, x) in (0..).zip(a) {
        let first = in_b.partition_point(|&j| b[j as usize].min[0] < x.min[0]);
        until_end(x, b, &in_b[first..], |j| found(i, j));
    }
    for (j, y) in (0..).zip(b) {
        let first = in_a.partition_point(|&i| a[i as usize].min[0] <= y.min[0]);
        until_end(y, a, &in_a[first..], |i| found(i, j));
    }
}

/// Calls `found` for each two boxes that overlap, the lesser index first.
fn self_overlaps<T: Real>(boxes: &[Aabb<T>], mut found: impl FnMut(u32, u32)) {
    let order = by_begin(boxes);
    for (k, &i) in order.iter().enumerate() {
        until_end(&boxes[i as usize], boxes, &order[k + 1..], |j| found(i.min(j), i.max(j)));
    }
}

/// Indices of boxes in the order in which they begin along x.
fn by_begin<T: Real>(boxes: &[Aabb<T>]) -> Vec<u32> {
    let begin = |&i: &u32| boxes[i as usize].min[0].to_f64();
    let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
    order.sort_unstable_by(|i, j| begin(i).total_cmp(&begin(j)));
    order
}

/// Calls `found` for the boxes that overlap `x`, of those in `order` that begin before its end.
fn until_end<T: Real>(x: &Aabb<T>, boxes: &[Aabb<T>], order: &[u32], mut found: impl FnMut(u32)) {
    for &j in order {
        let y = &boxes[j as usize];
        if y.min[0] > x.max[0] {
            break;
        }
        if x.overlaps(y) {
            found(j);
        }
    }
}
