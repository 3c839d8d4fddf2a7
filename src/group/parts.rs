//! A mesh in parts, so that each pair of features that can touch is whole in one of them.
//!
//! Elements (`elements.rs`) are ordered by the Morton codes of their boxes and cut into parts of as
//! many each, and parts into chunks. Each vertex has a room, a cube in which it must be for the
//! parts to hold, but for a motion that all vertices have in common. A chunk has a box around all
//! rooms of its vertices. Where boxes of two chunks of different parts overlap, one of both parts,
//! the smaller one, has the other's chunk as well: its halo.
//!
//! Why every pair is found: features that touch have elements whose chunks are in one part, or
//! whose boxes overlap, since they have room for both features, for half of the minimum distance
//! and for what backends round. Why no other is: elements are whole, with their vertices and edges,
//! so that what is a rod or a particle in a part is one in the mesh; two features share a vertex in
//! both or in neither. Why their order is the same: ids of a part ascend as those of the mesh do,
//! so that features and their vertices have the same order.

use super::elements::Elements;
use super::threads::{Threads, each_alone};
use crate::method::BroadPhaseMethod;
use crate::positions::Precision;
use crate::{Aabb, Bodies, BroadPhase, Coordinate, Error, Kind, Mesh};
use ccd_core::Real;
use ccd_core::backend::quantization::Scan;
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
/// By this part of its longest side the bounds of a part may be beyond the last ones, which went
/// with the scene, for a guess to hold.
const LEEWAY: f64 = 1.0 / 64.0;
/// Vertices from which the motion of the whole scene is taken.
const SAMPLES: usize = 101;
/// Boxes of backends are larger by less than this part of the greatest coordinate and distance.
const ROUNDING: f64 = 1.0 / (1 << 18) as f64;

/// All parts of a mesh.
pub struct Parts {
    /// One for each member.
    pub all: Vec<Arc<Part>>,
    /// The minimum distance that halos have room for.
    pub min_distance: f64,
    /// So far the scene may go before boxes are rounded by more than halos have room for.
    farthest: f64,
    /// Some vertices, and their rooms.
    samples: Vec<(u32, Room)>,
    /// What the last positions that were looked at said.
    pub last: Known,
    /// So many steps are looked at before they begin, because a guess was wrong.
    pub no_guess: u32,
}

/// What is known, or guessed, of positions.
pub struct Known {
    /// What those of each part say together.
    pub scans: Vec<Scan>,
    /// The motion since parts were made that most of the scene has in common.
    common: [f64; 3],
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
    rooms: Vec<Room>,
}

/// A cube: its middle, and half of its side.
type Room = [f32; 4];

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
        let samples = || (0..boxes.len()).step_by(boxes.len().div_ceil(SAMPLES).max(1));
        let motion = match x {
            Precision::F32(x) => greatest_motion(x, samples()),
            Precision::F64(x) => greatest_motion(x, samples()),
        };
        let slack = (4.0 * motion).clamp(SLACK * side, MOST_SLACK * side);
        let greatest = scene
            .min
            .iter()
            .chain(&scene.max)
            .fold(0.0, |most: f64, &x| most.max((x as f64).abs()));
        let rooms: Vec<Room> = boxes.iter().map(|b| room(b, slack + ROUNDING * greatest)).collect();
        let inside = |&[x, y, z, half]: &Room| grown(&Aabb::of_point([x, y, z]), half as f64);
        let boxes: Vec<Aabb<f32>> = rooms.iter().map(inside).collect();
        // Where the scene is now, and where it may go.
        let reach = 0.5 * min_distance + ROUNDING * (4.0 * greatest + min_distance);

        let order = elements.in_order(&boxes, &scene)?;
        let cuts: Vec<usize> = (0..=n_parts).map(|p| p * order.len() / n_parts).collect();
        let own: Vec<&[u32]> = cuts.windows(2).map(|cut| &order[cut[0]..cut[1]]).collect();
        let halos = halos(&own, |element| {
            let of_vertices = elements.vertices(element).iter().map(|&v| boxes[v as usize]);
            grown(&of_vertices.fold(Aabb::EMPTY, |all, b| all.union(&b)), reach)
        })?;
        let of_part = |(own, halo): (&&[u32], Vec<&[u32]>)| {
            let all: Vec<u32> = halo.into_iter().flatten().chain(*own).copied().collect();
            Part::new(elements, all, &rooms).map(Arc::new)
        };
        let all = each_alone(own.iter().zip(halos), of_part);
        let all = all.into_iter().collect::<Result<_, _>>()?;
        let samples = samples().map(|v| (v as u32, rooms[v])).collect();
        let last = Known { scans: Vec::new(), common: [0.0; 3] };
        Ok(Self { all, min_distance, farthest: greatest, samples, last, no_guess: 0 })
    }

    /// What positions are likely to say: what the last ones said, moved with the scene. None if a
    /// sample is not where it may be, and for some steps after a wrong guess.
    pub fn guess(&mut self, given: Given) -> Option<Known> {
        if self.no_guess > 0 {
            self.no_guess -= 1;
            return None;
        }
        let (common, near) = match given {
            Precision::F32(x) => self.look_at_samples(x),
            Precision::F64(x) => self.look_at_samples(x),
        };
        let by = [0, 1, 2].map(|k| common[k] - self.last.common[k]);
        let scans: Vec<Scan> = self.last.scans.iter().map(|of| of.guess(by, LEEWAY)).collect();
        // Far below what is infinite in `f32`: what is cut to a guess is a number.
        let fits = near && scans.iter().all(|scan| scan.greatest() < 1e38);
        fits.then_some(Known { scans, common })
    }

    /// Looks at all positions, and whether they are where they may be. A motion that all vertices
    /// have in common does not count: they are as near to each other as they were.
    pub fn look(&mut self, threads: &Threads, given: Given) -> bool {
        let looked: Vec<_> = (0..self.all.len()).map(|p| self.look_at(p, threads, given)).collect();
        self.last.scans = looked.iter().map(|(scan, _)| *scan).collect();
        self.last.common = match given {
            Precision::F32(x) => self.common_motion(x),
            Precision::F64(x) => self.common_motion(x),
        };
        looked.iter().all(|(_, holds)| *holds)
    }

    /// What the positions of one part say together, and whether they are where they may be.
    pub fn look_at(&self, p: usize, threads: &Threads, given: Given) -> (Scan, bool) {
        match given {
            Precision::F32(x) => self.look_at_slices(p, threads, x),
            Precision::F64(x) => self.look_at_slices(p, threads, x),
        }
    }

    fn look_at_slices<T: Coordinate>(
        &self,
        p: usize,
        threads: &Threads,
        x: [&[[T; 3]]; 2],
    ) -> (Scan, bool) {
        let (part, common) = (&self.all[p], self.common_motion(x));
        let n = part.vertices.len();
        let shares = (0..n).step_by(SHARE).map(|first| first..n.min(first + SHARE));
        let looked = threads.at_once(shares, |these| part.look(these, x, common));
        let all = (Scan::NONE, self.is_near(common));
        looked.iter().fold(all, |all, one| (all.0.merged(&one.0), all.1 & one.1))
    }

    /// The motion that the scene has in common, and whether the samples are where they may be.
    fn look_at_samples<T: Coordinate>(&self, [x0, x1]: [&[[T; 3]]; 2]) -> ([f64; 3], bool) {
        let common = self.common_motion([x0, x1]);
        let is_inside = |(v, room): &(u32, Room)| {
            [x0, x1].iter().all(|x| is_inside(room, common, x[*v as usize]))
        };
        (common, self.is_near(common) && self.samples.iter().all(is_inside))
    }

    /// Whether a motion of all is within what halos have room for.
    fn is_near(&self, common: [f64; 3]) -> bool {
        common.iter().all(|by| by.abs() <= self.farthest)
    }

    /// How far most of the scene went since parts were made.
    fn common_motion<T: Coordinate>(&self, [x0, x1]: [&[[T; 3]]; 2]) -> [f64; 3] {
        [0, 1, 2].map(|k| {
            let by = |&(v, room): &(u32, Room)| {
                let [p, q] = [x0, x1].map(|x| x[v as usize][k].to_f64());
                0.5 * (p + q) - room[k] as f64
            };
            median(self.samples.iter().map(by))
        })
    }
}

/// The greatest motion of a vertex in a step, without the one that most of these have in common.
fn greatest_motion<T: Coordinate>(
    [x0, x1]: [&[[T; 3]]; 2],
    samples: impl Iterator<Item = usize> + Clone,
) -> f64 {
    let by = |v: usize, k: usize| x1[v][k].to_f64() - x0[v][k].to_f64();
    let common = [0, 1, 2].map(|k| median(samples.clone().map(|v| by(v, k))));
    let apart = |v| (0..3).map(|k| (by(v, k) - common[k]).abs()).fold(0.0, f64::max);
    (0..x0.len()).map(apart).fold(0.0, f64::max)
}

/// The middle one of some numbers; 0 of none.
fn median(numbers: impl Iterator<Item = f64>) -> f64 {
    let mut sorted: Vec<f64> = numbers.collect();
    sorted.sort_unstable_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(0.0)
}

/// The room of a vertex that goes through this box: larger on all sides, rounded outward.
fn room(b: &Aabb<f32>, by: f64) -> Room {
    let [min, max] = [b.min, b.max].map(|p| p.map(f64::from));
    let middle = [0, 1, 2].map(|k| (0.5 * (min[k] + max[k])) as f32);
    let beside = |k: usize| (max[k] - middle[k] as f64).max(middle[k] as f64 - min[k]);
    let half = by + (0..3).map(beside).fold(0.0, f64::max);
    [middle[0], middle[1], middle[2], half.round_up()]
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
    fn new(elements: &Elements, mut all: Vec<u32>, rooms: &[Room]) -> Result<Self, Error> {
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
        let rooms = vertices.iter().map(|&v| rooms[v as usize]).collect();
        Ok(Self { mesh: Arc::new(mesh), vertices, edges, faces, rooms })
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

    /// Of each vertex its number in the whole mesh.
    pub fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    /// What the positions of these vertices say together, and whether all are in their rooms, which
    /// went `by` from where they were.
    fn look<T: Coordinate>(
        &self,
        these: Range<usize>,
        [x0, x1]: [&[[T; 3]]; 2],
        by: [f64; 3],
    ) -> (Scan, bool) {
        // Copied first: a scan takes slices.
        let mut some = [[[T::splat(0.0); 3]; BATCH]; 2];
        let (mut scan, mut holds) = (Scan::NONE, true);
        let vertices = self.vertices[these.clone()].chunks(BATCH);
        for (vertices, rooms) in vertices.zip(self.rooms[these].chunks(BATCH)) {
            let [some0, some1] = &mut some;
            for (i, (&v, room)) in vertices.iter().zip(rooms).enumerate() {
                (some0[i], some1[i]) = (x0[v as usize], x1[v as usize]);
                holds &= is_inside(room, by, some0[i]) & is_inside(room, by, some1[i]);
            }
            scan.take_all(&some0[..vertices.len()], &some1[..vertices.len()]);
        }
        (scan, holds)
    }
}

/// Whether a position is in a room that went `by` from where it was. Not if it is NaN.
#[inline(always)]
fn is_inside<T: Coordinate>(room: &Room, by: [f64; 3], p: [T; 3]) -> bool {
    let mut inside = true;
    for k in 0..3 {
        inside &= (p[k].to_f64() - (room[k] as f64 + by[k])).abs() <= room[3] as f64;
    }
    inside
}

/// Vertices that are worth a thread.
const SHARE: usize = 1 << 15;
/// Vertices whose positions are copied together.
const BATCH: usize = 128;
