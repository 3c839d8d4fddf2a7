//! The bodies that vertices belong to, and which pairs of them are looked at.

use super::mesh::Mesh;
use crate::model::error::Error;
use alloc::vec::Vec;

/// Which body each vertex belongs to, which bodies stand still, and which pairs are wanted.
///
/// A pair of features is left out if both bodies are fixed, or if both are the same body and `self_contact` is off.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bodies {
    body_of_vertex: Vec<u32>,
    fixed: Vec<bool>,
    self_contact: bool,
}

impl Bodies {
    /// Bodies are numbered by `body_of_vertex`; those whose entry in `fixed` is true do not move (missing entries are false).
    /// With `self_contact` off, no pair within one body is looked at.
    pub fn new(body_of_vertex: &[u32], fixed: &[bool], self_contact: bool) -> Self {
        Self { body_of_vertex: body_of_vertex.to_vec(), fixed: fixed.to_vec(), self_contact }
    }

    /// Body of vertex `v`.
    #[inline]
    pub fn body(&self, v: u32) -> u32 {
        self.body_of_vertex[v as usize]
    }

    /// Whether body `b` does not move.
    #[inline]
    pub fn fixed(&self, b: u32) -> bool {
        self.fixed.get(b as usize).copied().unwrap_or(false)
    }

    /// Whether any body does not move.
    pub fn any_fixed(&self) -> bool {
        self.fixed.contains(&true)
    }

    /// Whether features of bodies `a` and `b` are to be tested against each other.
    #[inline]
    pub fn wants(&self, a: u32, b: u32) -> bool {
        (a != b || self.self_contact) && !(self.fixed(a) && self.fixed(b))
    }

    /// Checks that there is a body for every vertex and that no element joins two.
    pub fn check(&self, mesh: &Mesh) -> Result<(), Error> {
        if self.body_of_vertex.len() != mesh.n_vertices() {
            return Err(Error::BodyCount { expected: mesh.n_vertices(), found: self.body_of_vertex.len() });
        }
        let mixed = |element, at, v: &[u32]| {
            let first = self.body(v[0]);
            match v.iter().map(|&v| self.body(v)).find(|&b| b != first) {
                Some(other) => Err(Error::MixedBodies { element, at, bodies: [first, other] }),
                None => Ok(()),
            }
        };
        mesh.faces().iter().enumerate().try_for_each(|(at, f)| mixed("face", at, f))?;
        mesh.edges().iter().enumerate().try_for_each(|(at, e)| mixed("edge", at, e))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_select_pairs() {
        let bodies = Bodies::new(&[0, 0, 1, 2], &[false, true, true], false);
        assert!(bodies.wants(0, 1) && bodies.wants(2, 0));
        assert!(!bodies.wants(0, 0) && !bodies.wants(1, 2));
        let mesh = Mesh::new(4, &[[0, 1, 2]]).unwrap();
        assert_eq!(bodies.check(&mesh), Err(Error::MixedBodies { element: "face", at: 0, bodies: [0, 1] }));
    }
}
