//! The bodies of a part of a mesh.

use super::Bodies;
use crate::model::contact::Kind;
use alloc::vec::Vec;

impl Bodies {
    /// The same rules for a mesh of some of the vertices, edges and faces: which pairs of those are
    /// looked at does not change. Each list has the ids in this mesh, ascending; what has the place
    /// `i` in it is `i` there.
    #[doc(hidden)]
    pub fn of_part(&self, vertices: &[u32], edges: &[u32], faces: &[u32]) -> Self {
        let names: Vec<u32> = vertices.iter().map(|&v| self.body_of_vertex[v as usize]).collect();
        let mut out = Self::new(&names);
        out.fixed_may_move = self.fixed_may_move;
        // Its bodies are some of these, in the same order.
        let numbers: Vec<usize> = out.names.iter().filter_map(|&name| self.number(name)).collect();
        out.rules = numbers.iter().map(|&number| self.rules[number]).collect();
        let place = |of: &[u32], id: u32| of.binary_search(&id).ok().map(|i| i as u32);
        let body = |number: u32| numbers.binary_search(&(number as usize)).ok().map(|i| i as u32);
        let bodies = self.excluded_bodies.iter();
        out.excluded_bodies = bodies.filter_map(|&[a, b]| Some([body(a)?, body(b)?])).collect();
        let features = self.excluded_features.iter();
        out.excluded_features = features
            .filter_map(|&(kind, [a, b])| {
                let [of_a, of_b] = match kind {
                    Kind::VertexFace => [vertices, faces],
                    Kind::EdgeEdge => [edges; 2],
                    Kind::VertexEdge => [vertices, edges],
                    Kind::VertexVertex => [vertices; 2],
                };
                Some((kind, [place(of_a, a)?, place(of_b, b)?]))
            })
            .collect();
        out
    }
}
