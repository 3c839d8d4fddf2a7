//! What parts of a mesh are made of: a face, an edge of no face, or a vertex of no edge.

use crate::{Aabb, Error, Mesh};
use ccd_core::math::morton::{MortonGrid, morton63};
use ccd_core::model::codimensional::edges_of_no_face;

/// The elements of a mesh, numbered: faces, then edges of no face, then vertices of no edge.
pub struct Elements<'a> {
    pub mesh: &'a Mesh,
    /// Edges of no face.
    rods: Vec<u32>,
    /// Faces that are one vertex, of some edge, each with an element that has such an edge. A part
    /// has both, so that the vertex is one of an edge there, too.
    pub points: Vec<(u32, u32)>,
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

    /// Those of an element.
    pub fn vertices(&self, element: u32) -> &[u32] {
        let (i, n_faces) = (element as usize, self.mesh.faces().len());
        let Some(i) = i.checked_sub(n_faces) else { return &self.mesh.faces()[i] };
        match i.checked_sub(self.rods.len()) {
            None => &self.mesh.edges()[self.rods[i] as usize],
            Some(i) => std::slice::from_ref(&self.mesh.isolated_vertices()[i]),
        }
    }

    /// Along a Morton curve.
    pub fn in_order(&self, boxes: &[Aabb<f32>], scene: &Aabb<f32>) -> Result<Vec<u32>, Error> {
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
