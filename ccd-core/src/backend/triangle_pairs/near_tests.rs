//! Orphans and stand-ins as one list, once per mesh: the tests of features whose representatives
//! have a vertex in common.
//!
//! ```text
//!   | vertex-face stand-ins | vertex-face orphans | edge-edge orphans | edge-edge stand-ins |
//!                                           n_vf -^
//! ```
//!
//! Cost: on a regular mesh some 10 tests a triangle, 16 bytes each.

use super::Test;
use super::orphans::OrphanSets;
use super::representatives::Triangles;
use crate::layout::{NearTest, Pair};
use crate::model::contact::Kind;
use alloc::vec::Vec;

/// The tests of neighbours.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct NearTests {
    /// All of them.
    pub tests: Vec<NearTest>,
    /// The first so many are of a vertex and a face.
    pub n_vf: u32,
    /// Orphans are those from the first of these on, up to the second.
    pub orphans: [u32; 2],
}

impl NearTests {
    /// Those of a mesh, but for the pairs of triangles that `wanted` rules out.
    pub fn new(
        sets: &OrphanSets,
        triangles: &Triangles,
        wanted: impl Fn(Pair) -> bool,
    ) -> Option<Self> {
        let (mut vf, mut of_edges) = (Vec::new(), Vec::new());
        for t in 0..triangles.len() as u32 {
            // Listed for both of a pair.
            let later = sets.stand_ins(t).iter().filter(|stand_in| stand_in.other > t);
            for stand_in in later.filter(|stand_in| wanted(Pair { a: t, b: stand_in.other })) {
                let of = Pair { a: t, b: stand_in.other };
                for test in Test::all(stand_in.tests) {
                    let (kind, pair) = test.features(triangles, t, stand_in.other);
                    let list = if kind == Kind::VertexFace { &mut vf } else { &mut of_edges };
                    list.push(NearTest { pair, triangles: of });
                }
            }
        }
        let first = vf.len();
        let orphan =
            |pair: &Pair, of: Pair| wanted(of).then_some(NearTest { pair: *pair, triangles: of });
        vf.extend(sets.vf().iter().filter_map(|pair| {
            orphan(pair, Pair { a: triangles.of_vertex(pair.a)[0], b: pair.b })
        }));
        let n_vf = vf.len();
        vf.extend(sets.ee().iter().filter_map(|pair| {
            let [a, b] = [pair.a, pair.b].map(|e| triangles.of_edge(e)[0]);
            orphan(pair, Pair { a, b })
        }));
        let last = vf.len();
        vf.append(&mut of_edges);
        u32::try_from(vf.len()).ok()?;
        Some(Self { tests: vf, n_vf: n_vf as u32, orphans: [first as u32, last as u32] })
    }
}
