//! The bodies that vertices belong to, and which pairs of them are looked at.

use super::mesh::Mesh;
use crate::broad_phase::candidate::bodies_meet;
use crate::model::error::Error;
use alloc::vec::Vec;

/// Which body each vertex belongs to, which bodies stand still, and which pairs are wanted.
///
/// A pair of features is left out if both bodies are fixed, or if both are the same body and
/// `self_contact` is off.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bodies {
    body_of_vertex: Vec<u32>,
    words: Vec<u32>,
    any_fixed: bool,
    self_contact: bool,
}

impl Bodies {
    /// Bodies are numbered by `body_of_vertex`; those whose entry in `fixed` is true do not move
    /// (missing entries are false). With `self_contact` off, no pair within one body is looked at.
    pub fn new(body_of_vertex: &[u32], fixed: &[bool], self_contact: bool) -> Self {
        // Numbered anew, because the caller's numbers may need all bits of a word.
        let mut names = body_of_vertex.to_vec();
        names.sort_unstable();
        names.dedup();
        let is_fixed = |name: u32| fixed.get(name as usize).copied().unwrap_or(false);
        let word = |&name: &u32| {
            (names.partition_point(|&n| n < name) as u32) << 1 | is_fixed(name) as u32
        };
        Self {
            words: body_of_vertex.iter().map(word).collect(),
            body_of_vertex: body_of_vertex.to_vec(),
            any_fixed: fixed.contains(&true),
            self_contact,
        }
    }

    /// Per vertex twice a number of its body, plus one if that does not move: what candidates are
    /// chosen by.
    pub fn words(&self) -> &[u32] {
        &self.words
    }

    /// The body of each vertex, by the numbers given.
    pub fn body_of_vertex(&self) -> &[u32] {
        &self.body_of_vertex
    }

    /// Whether features of one body are looked at.
    pub fn self_contact(&self) -> bool {
        self.self_contact
    }

    /// Whether the body of vertex `v` does not move.
    #[inline]
    pub fn is_fixed(&self, v: u32) -> bool {
        self.words[v as usize] & 1 == 1
    }

    /// Whether any body does not move.
    pub fn any_fixed(&self) -> bool {
        self.any_fixed
    }

    /// Whether features of the bodies of vertices `v` and `w` are to be tested against each other.
    #[inline]
    pub fn wants(&self, v: u32, w: u32) -> bool {
        bodies_meet(self.words[v as usize], self.words[w as usize], self.self_contact)
    }

    /// Checks that there is a body for every vertex and that no element joins two.
    ///
    /// # Errors
    /// [`Error::BodyCount`]; [`Error::MixedBodies`].
    pub fn check(&self, mesh: &Mesh) -> Result<(), Error> {
        if self.body_of_vertex.len() != mesh.n_vertices() {
            return Err(Error::BodyCount {
                expected: mesh.n_vertices(),
                found: self.body_of_vertex.len(),
            });
        }
        let mixed = |element, at, v: &[u32]| {
            let body = |v: u32| self.body_of_vertex[v as usize];
            let first = body(v[0]);
            match v.iter().map(|&v| body(v)).find(|&b| b != first) {
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
        assert!(bodies.wants(0, 2) && bodies.wants(3, 1));
        assert!(!bodies.wants(0, 1) && !bodies.wants(2, 3));
        assert_eq!(Bodies::new(&[u32::MAX, 7], &[], true).words(), [2, 0]);
        let mesh = Mesh::new(4, &[[0, 1, 2]]).unwrap();
        assert_eq!(
            bodies.check(&mesh),
            Err(Error::MixedBodies { element: "face", at: 0, bodies: [0, 1] })
        );
    }
}
