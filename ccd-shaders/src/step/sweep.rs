//! Paths of vertices and swept boxes, an item a thread.

use crate::entry::kernel;
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::{placement, swept_box};
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::layout::Path;
use ccd_core::narrow_phase::decide;

kernel! {
    /// Thread `i` makes path and box of vertex `i`, and the keys of its exact box.
    place_vertices[256](t; params: Plain;; positions: [[f64; 3]], mut paths: [Path],
        mut keys: [[[u32; 2]; 6]], mut boxes: [Aabb]) {
        let i = t.i;
        if i < params.frame.count[0] {
            let (p, q) = placement::given(i, &params.frame, positions);
            let exact = placement::exact_box(p, q, &params.frame);
            put(paths, i as usize, placement::path(p, q, &params.frame));
            put(keys, i as usize, placement::keys(&exact));
            put(boxes, i as usize, placement::rounded(&exact));
        }
    }
}

kernel! {
    /// Thread `i` sweeps vertex `i`.
    sweep_vertices[256](t; params: Plain;; paths: [Path], mut boxes: [Aabb]) {
        let i = t.i;
        if i < params.frame.count[0] {
            put(boxes, i as usize, swept_box::path(&at(paths, i as usize), params.frame.margin));
        }
    }
}

kernel! {
    /// Thread `i` unites the boxes of the vertices of edge `i`.
    sweep_edges[256](t; params: Plain;; edges: [[u32; 2]], mut boxes: [Aabb]) {
        let i = t.i;
        if i < params.frame.count[1] {
            let swept = swept_box::edge(i as usize, edges, boxes);
            put(boxes, (params.frame.start[1] + i) as usize, swept);
        }
    }
}

kernel! {
    /// Thread `i` unites the boxes of the vertices of face `i`.
    sweep_faces[256](t; params: Plain;; faces: [[u32; 3]], mut boxes: [Aabb]) {
        let i = t.i;
        if i < params.frame.count[2] {
            let swept = swept_box::face(i as usize, faces, boxes);
            put(boxes, (params.frame.start[2] + i) as usize, swept);
        }
    }
}

kernel! {
    /// Thread `i` cuts path `i` to the times that matter, which end at the earliest time of impact
    /// so far; `of_vf` and `of_ee` hold the bits of those of each kind, or a greater number if
    /// there is none.
    shorten[256](t; params: Plain;; paths: [Path], of_vf: [u32], of_ee: [u32],
        mut shortened: [Path]) {
        let i = t.i;
        if i < params.frame.count[0] {
            let until = decide::until(at(of_vf, 0).min(at(of_ee, 0)));
            let until = if until < params.frame.until { until } else { params.frame.until };
            let path = swept_box::shorten(&at(paths, i as usize), params.frame.from, until);
            put(shortened, i as usize, path);
        }
    }
}
