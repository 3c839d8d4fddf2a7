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
        let boxes = prepared.of_vertices();
        let sink = TrianglePairs { scene, leaves, boxes, only, worker: PhantomData };
        method.find(threads, (&leaves.boxes, None), part, &sink, workers);
        if part == 1 {
            sink.orphans(threads, workers);
        }
        return;
    }
    let Prepared { vertices, edges, faces, .. } = prepared;
    let (vertices, edges, faces) = (&vertices.leaves, &edges.leaves, &faces.leaves);
    let sides_vf = (&vertices.boxes, Some(&faces.boxes));
    let sink_vf = FeaturePairs { scene, a: vertices, b: faces, worker: PhantomData };
    let sides_ee = (&edges.boxes, None);
    let sink_ee = FeaturePairs { scene, a: edges, b: edges, worker: PhantomData };
    match only {
        Some(Kind::EdgeEdge) => method.find(threads, sides_ee, part, &sink_ee, workers),
        Some(_) => method.find(threads, sides_vf, part, &sink_vf, workers),
        None => {
            method.find_two(threads, (sides_vf, &sink_vf), (sides_ee, &sink_ee), part, workers);
        }
    }
}
