//! Candidates on their way from the source of pairs to the workers, by the pipeline that was
//! chosen.

use crate::broad_phase::method::Method;
use crate::broad_phase::pair_source::PairSource;
use crate::step::candidates::{FeaturePairs, Scene, Take};
use crate::step::prepare::Prepared;
use crate::step::triangle_pairs::TrianglePairs;
use crate::threads::Threads;
use ccd_core::model::contact::Kind;
use std::marker::PhantomData;

/// Hands candidates to the workers: of the kind `only`, or of both.
pub fn find<W: Take>(
    only: Option<Kind>,
    threads: &Threads,
    method: &mut Method,
    prepared: &Prepared,
    scene: &Scene,
    part: usize,
    workers: &mut [W],
) {
    if let Some(leaves) = &prepared.triangles {
        let boxes = prepared.feature_boxes();
        let sink = TrianglePairs { scene, leaves, boxes, only, worker: PhantomData };
        method.find(threads, (&leaves.boxes, None), part, &sink, workers);
        if part == 1 {
            sink.orphans(threads, workers);
        }
        return;
    }
    let Prepared { vertices, edges, faces, .. } = prepared;
    let (vertices, edges, faces) = (&vertices.leaves, &edges.leaves, &faces.leaves);
    if only != Some(Kind::EdgeEdge) {
        let sink = FeaturePairs { scene, a: vertices, b: faces, worker: PhantomData };
        method.find(threads, (&vertices.boxes, Some(&faces.boxes)), part, &sink, workers);
    }
    if only != Some(Kind::VertexFace) {
        let sink = FeaturePairs { scene, a: edges, b: edges, worker: PhantomData };
        method.find(threads, (&edges.boxes, None), part, &sink, workers);
    }
}
