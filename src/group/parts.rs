//! A mesh in parts, so that each pair of features that can touch is whole in one of them.
//!
//! An element is a face, an edge of no face, or a vertex of no edge. Elements are ordered by the
//! Morton codes of their boxes and cut into parts of as many each, and parts into chunks. A chunk
//! has a box around all places where its vertices may be while the parts hold. Where boxes of two
//! chunks of different parts overlap, one of both parts, the smaller one, has the other's chunk as
//! well: its halo.
//!
//! Why every pair is found: features that touch have elements whose chunks are in one part, or
//! whose boxes overlap, since they have room for both features, for half of the minimum distance
//! and for what backends round. Why no other is: elements are whole, with their vertices and edges,
//! so that what is a rod or a particle in a part is one in the mesh; two features share a vertex in
//! both or in neither. Why their order is the same: ids of a part ascend as those of the mesh do,
//! so that features and their vertices have the same order.

use crate::method::BroadPhaseMethod;
use crate::positions::Precision;
use crate::{Aabb, Bodies, BroadPhase, Coordinate, Error, Kind, Mesh};
use ccd_core::math::morton::{MortonGrid, morton63};
use ccd_core::model::codimensional::edges_of_no_face;
use ccd_core::model::error::check_coordinates;
use ccd_core::model::precision::Given;
use std::ops::Range;
use std::sync::Arc;

/// Elements of a chunk: more make a halo thicker, fewer take longer to be compared.
const CHUNK: usize = 64;
/// By this part of a scene's longest side vertices may leave the places for which parts were made.
const SLACK: f64 = 1.0 / 128.0;
/// At most by this part, where they move far in a step.
const MOST_SLACK: f64 = 1.0 / 16.0;
/// Boxes of backends are larger by less than this part of the greatest coordinate and distance.
const ROUNDING: f64 = 1.0 / (1 << 18) as f64;

/// All parts of a mesh.
pub struct Parts {
    /// One for each member.
    pub all: Vec<Arc<Part>>,
    /// The minimum distance that halos have room for.
    pub min_distance: f64,
}

/// Some elements of a mesh, as a mesh of their own.
pub struct Part {
    /// The mesh.
    pub mesh: Arc<Mesh>,
    /// Of each vertex, edge and face the id in the whole mesh, ascending.
    vertices: Vec<u32>,
    edges: Vec<u32>,
    faces: Vec<u32>,
    /// Of each vertex where it may be.
    room: Vec<Aabb<f32>>,
}

impl Parts {
    /// Parts for positions, and for others that are not far from them.
    ///
    /// # Errors
    /// [`Error::Coordinate`]; [`Error::TooMany`] elements of all kinds together.
    pub fn new(
        elements: &Elements,
        x: Given,
        n_parts: usize,
        min_distance: f64,
    ) -> Result<Self, Error> {
        let boxes = match x {
            Precision::F32(x) => swept(x)?,
            Precision::F64(x) => swept(x)?,
        };
        let scene = boxes.iter().fold(Aabb::EMPTY, |all, b| all.union(b));
        let longest =
            |b: &Aabb<f32>| (0..3).map(|k| b.max[k] as f64 - b.min[k] as f64).fold(0.0, f64::max);
        let side = longest(&scene);
        let travel = boxes.iter().map(longest).fold(0.0, f64::max);
        let slack = (4.0 * travel).clamp(SLACK * side, MOST_SLACK * side);
        let room: Vec<Aabb<f32>> = boxes.iter().map(|b| grown(b, slack)).collect();
        let greatest = scene
            .min
            .iter()
            .chain(&scene.max)
            .fold(0.0, |most: f64, &x| most.max((x as f64).abs()));
        let reach = 0.5 * min_distance + ROUNDING * (greatest + min_distance);

        let order = elements.in_order(&room, &scene)?;
        let cuts: Vec<usize> = (0..=n_parts).map(|p| p * order.len() / n_parts).collect();
        let own: Vec<&[u32]> = cuts.windows(2).map(|cut| &order[cut[0]..cut[1]]).collect();
        let halos = halos(&own, |element| {
            let of_vertices = elements.vertices(element).iter().map(|&v| room[v as usize]);
            grown(&of_vertices.fold(Aabb::EMPTY, |all, b| all.union(&b)), reach)
        })?;
        let all = std::thread::scope(|scope| {
            let of_part = |(own, halo): (&&[u32], Vec<&[u32]>)| {
                let all: Vec<u32> = halo.into_iter().flatten().chain(*own).copied().collect();
                let room = &room;
                scope.spawn(move || Part::new(elements, all, room))
            };
            let all: Vec<_> = own.iter().zip(halos).map(of_part).collect();
            all.into_iter()
                .map(|part| part.join().map(|part| part.map(Arc::new)))
                .collect::<Vec<_>>()
        });
        let all = all.into_iter().map(|part| part.unwrap_or_else(|e| std::panic::resume_unwind(e)));
        Ok(Self { all: all.collect::<Result<_, _>>()?, min_distance })
    }
}

/// The boxes of vertices over a step.
fn swept<T: Coordinate>([x0, x1]: [&[[T; 3]]; 2]) -> Result<Vec<Aabb<f32>>, Error> {
    check_coordinates(0, x0)?;
    check_coordinates(1, x1)?;
    let point = |&p: &[T; 3]| Aabb::of_point(p);
    Ok(x0.iter().zip(x1).map(|(a, b)| point(a).union(&point(b)).round_out()).collect())
}

/// A box that is larger on all sides, rounded outward.
fn grown(b: &Aabb<f32>, by: f64) -> Aabb<f32> {
    let [min, max] = [b.min, b.max].map(|p| p.map(f64::from));
    Aabb { min, max }.inflated(by).round_out()
}

/// The elements of a mesh, numbered: faces, then edges of no face, then vertices of no edge.
pub struct Elements<'a> {
    mesh: &'a Mesh,
    /// Edges of no face.
    rods: Vec<u32>,
    /// Faces that are one vertex, of some edge, each with an element that has such an edge. A part
    /// has both, so that the vertex is one of an edge there, too.
    points: Vec<(u32, u32)>,
}

impl<'a> Elements<'a> {
    /// Of this mesh.
    pub fn new(mesh: &'a Mesh) -> Self {
        let mut elements = Self { mesh, rods: edges_of_no_face(mesh), points: Vec::new() };
        let faces = (0..).zip(mesh.faces());
        let points: Vec<(u32, u32)> =
            faces.filter(|(_, face)| is_point(&face[..])).map(|(f, face)| (f, face[0])).collect();
        if !points.is_empty() {
            let mut element_of = vec![None; mesh.n_vertices()];
            for element in 0..(mesh.faces().len() + elements.rods.len()) as u32 {
                let vertices = elements.vertices(element);
                if !is_point(vertices) {
                    vertices.iter().for_each(|&v| element_of[v as usize] = Some(element));
                }
            }
            let with = |(face, v): (u32, u32)| Some((face, element_of[v as usize]?));
            elements.points = points.into_iter().filter_map(with).collect();
        }
        elements
    }

    /// How many.
    pub fn len(&self) -> usize {
        self.mesh.faces().len() + self.rods.len() + self.mesh.isolated_vertices().len()
    }

    fn vertices(&self, element: u32) -> &[u32] {
        let (i, n_faces) = (element as usize, self.mesh.faces().len());
        let Some(i) = i.checked_sub(n_faces) else { return &self.mesh.faces()[i] };
        match i.checked_sub(self.rods.len()) {
            None => &self.mesh.edges()[self.rods[i] as usize],
            Some(i) => std::slice::from_ref(&self.mesh.isolated_vertices()[i]),
        }
    }

    /// Along a Morton curve.
    fn in_order(&self, boxes: &[Aabb<f32>], scene: &Aabb<f32>) -> Result<Vec<u32>, Error> {
        let n = checked_count(self.len())?;
        let grid = MortonGrid::new(scene, 21);
        let code = |element: u32| {
            let boxes = self.vertices(element).iter().map(|&v| &boxes[v as usize]);
            let [low, high] = morton63(grid.cell(&boxes.fold(Aabb::EMPTY, |all, b| all.union(b))));
            (high as u64) << 32 | low as u64
        };
        let mut keys: Vec<(u64, u32)> = (0..n).map(|e| (code(e), e)).collect();
        keys.sort_unstable();
        Ok(keys.into_iter().map(|(_, element)| element).collect())
    }
}

/// Whether all vertices of an element are one.
fn is_point(vertices: &[u32]) -> bool {
    vertices.iter().all(|&v| v == vertices[0])
}

/// So many elements, if each has a number: a mesh has fewer of each kind than half of these.
fn checked_count(count: usize) -> Result<u32, Error> {
    let (element, limit) = ("elements of a group's mesh", u32::MAX as u64);
    u32::try_from(count).map_err(|_| Error::TooMany { element, count: count as u64, limit })
}

/// For each part the chunks of others that it has as well.
fn halos<'a>(
    own: &[&'a [u32]],
    of_element: impl Fn(u32) -> Aabb<f32>,
) -> Result<Vec<Vec<&'a [u32]>>, Error> {
    let chunks: Vec<Vec<&[u32]>> = own.iter().map(|own| own.chunks(CHUNK).collect()).collect();
    let around = |chunk: &&[u32]| {
        chunk.iter().fold(Aabb::EMPTY, |all, &element| all.union(&of_element(element)))
    };
    let boxes: Vec<Vec<Aabb<f32>>> =
        chunks.iter().map(|chunks| chunks.iter().map(around).collect()).collect();
    let none: Vec<Vec<bool>> = chunks.iter().map(|chunks| vec![false; chunks.len()]).collect();
    let mut is_halo = vec![none; own.len()];
    let mut size: Vec<usize> = own.iter().map(|own| own.len()).collect();
    let mut broad_phase = BroadPhase::new(0, BroadPhaseMethod::default())?;
    for q in 1..own.len() {
        for p in 0..q {
            let mut pairs = broad_phase.pairs(&boxes[p], &boxes[q])?.to_vec();
            pairs.sort_unstable_by_key(|pair| (pair.a, pair.b));
            for pair in pairs {
                let (a, b) = (pair.a as usize, pair.b as usize);
                if is_halo[p][q][b] || is_halo[q][p][a] {
                    continue;
                }
                let (to, from, chunk) = if size[p] <= size[q] { (p, q, b) } else { (q, p, a) };
                is_halo[to][from][chunk] = true;
                size[to] += chunks[from][chunk].len();
            }
        }
    }
    let of_part = |p: usize| {
        let others = (0..own.len()).filter(move |&q| q != p);
        let of_other = |q: usize| chunks[q].iter().zip(&is_halo[p][q]);
        others.flat_map(of_other).filter(|(_, is)| **is).map(|(chunk, _)| *chunk).collect()
    };
    Ok((0..own.len()).map(of_part).collect())
}

impl Part {
    fn new(elements: &Elements, mut all: Vec<u32>, room: &[Aabb<f32>]) -> Result<Self, Error> {
        let (whole, n_faces) = (elements.mesh, elements.mesh.faces().len());
        let with = |e: &u32| {
            let at = elements.points.binary_search_by_key(e, |point| point.0).ok()?;
            Some(elements.points[at].1)
        };
        let others: Vec<u32> = all.iter().filter_map(with).collect();
        all.extend(others);
        all.sort_unstable();
        all.dedup();
        let mut place = vec![u32::MAX; whole.n_vertices()];
        all.iter().flat_map(|&e| elements.vertices(e)).for_each(|&v| place[v as usize] = 0);
        let vertices: Vec<u32> =
            (0..).zip(&place).filter(|(_, place)| **place == 0).map(|(v, _)| v).collect();
        (0..).zip(&vertices).for_each(|(i, &v)| place[v as usize] = i);
        let local = |v: u32| place[v as usize];
        let faces = all.partition_point(|&e| (e as usize) < n_faces);
        let (faces, others) = (all[..faces].to_vec(), &all[faces..]);
        let of_faces: Vec<[u32; 3]> =
            faces.iter().map(|&f| whole.faces()[f as usize].map(local)).collect();
        let rods: Vec<[u32; 2]> = others
            .iter()
            .filter_map(|&e| elements.vertices(e).try_into().ok())
            .map(|rod: [u32; 2]| rod.map(local))
            .collect();
        let mesh = Mesh::with_edges(vertices.len(), &of_faces, &rods)?;
        // Edges of both are in one order.
        let mut edges = Vec::with_capacity(mesh.edges().len());
        let mut all = (0..).zip(whole.edges());
        for edge in mesh.edges() {
            let edge = edge.map(|v| vertices[v as usize]);
            edges.extend(all.find(|(_, other)| **other == edge).map(|(e, _)| e));
        }
        let room = vertices.iter().map(|&v| room[v as usize]).collect();
        Ok(Self { mesh: Arc::new(mesh), vertices, edges, faces, room })
    }

    /// The ids in the whole mesh of a pair of features of this one.
    pub fn ids(&self, kind: Kind, [a, b]: [u32; 2]) -> [u32; 2] {
        let (vertex, edge) = (|v: u32| self.vertices[v as usize], |e: u32| self.edges[e as usize]);
        match kind {
            Kind::VertexFace => [vertex(a), self.faces[b as usize]],
            Kind::EdgeEdge => [edge(a), edge(b)],
            Kind::VertexEdge => [vertex(a), edge(b)],
            Kind::VertexVertex => [vertex(a), vertex(b)],
        }
    }

    /// The bodies of this part.
    pub fn bodies(&self, whole: &Bodies) -> Bodies {
        whole.of_part(&self.vertices, &self.edges, &self.faces)
    }

    /// Copies the positions of its vertices, on so many threads; whether they are all where they
    /// may be.
    pub fn gather<T: Coordinate>(
        &self,
        x: [&[[T; 3]]; 2],
        to: &mut [Vec<[T; 3]>; 2],
        n_threads: usize,
    ) -> bool {
        let n = self.vertices.len();
        to.iter_mut().for_each(|to| to.resize(n, [T::splat(0.0); 3]));
        let [mut to0, mut to1] = to.each_mut().map(|to| &mut to[..]);
        let share = n.div_ceil(n_threads).max(1);
        std::thread::scope(|scope| {
            let mut others = Vec::new();
            let mut begin = 0;
            while begin < n {
                let of = begin..(begin + share).min(n);
                let (now0, now1);
                (now0, to0) = to0.split_at_mut(of.len());
                (now1, to1) = to1.split_at_mut(of.len());
                begin = of.end;
                if begin < n {
                    others.push(scope.spawn(move || self.copy(of, x, [now0, now1])));
                } else {
                    let holds = self.copy(of, x, [now0, now1]);
                    return others.into_iter().fold(holds, |holds, other| {
                        other.join().unwrap_or_else(|e| std::panic::resume_unwind(e)) && holds
                    });
                }
            }
            true
        })
    }

    fn copy<T: Coordinate>(
        &self,
        of: Range<usize>,
        [x0, x1]: [&[[T; 3]]; 2],
        [to0, to1]: [&mut [[T; 3]]; 2],
    ) -> bool {
        let mut holds = true;
        for (i, of) in of.enumerate() {
            let (v, room) = (self.vertices[of] as usize, &self.room[of]);
            (to0[i], to1[i]) = (x0[v], x1[v]);
            for k in 0..3 {
                let [a, b] = [x0[v][k], x1[v][k]].map(T::to_f64);
                let [min, max] = [room.min[k], room.max[k]].map(f64::from);
                holds &= min <= a && a <= max && min <= b && b <= max;
            }
        }
        holds
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A mesh of 2^31 - 1 faces, rods and particles each would have more.
    #[cfg(target_pointer_width = "64")]
    #[test]
    fn elements_have_numbers() {
        assert_eq!(checked_count(u32::MAX as usize), Ok(u32::MAX));
        let why = checked_count(u32::MAX as usize + 1);
        assert!(matches!(why, Err(Error::TooMany { count: 4_294_967_296, .. })), "{why:?}");
    }
}
