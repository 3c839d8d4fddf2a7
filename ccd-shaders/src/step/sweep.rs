//! Paths of vertices and swept boxes, an item a thread.

use crate::entry::kernel;
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::{placement, swept_box};
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::layout::{Path, elements};
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
    /// Thread `i` unites the boxes of the vertices of element `i`: of edges, then of faces.
    sweep_elements[256](t; params: Plain;; elements: [u32], mut boxes: [Aabb]) {
        let (i, [_, n_edges, n_faces]) = (t.i, params.frame.count);
        if i < n_edges + n_faces {
            let vertices = elements::vertices(i, n_edges, elements);
            put(boxes, (params.frame.start[1] + i) as usize, swept_box::triangle(vertices, boxes));
        }
    }
}

kernel! {
    /// Thread `i` cuts path `i` to the times that matter, which end at the earliest time of impact
    /// so far: `earliest` holds its bits, or a greater number if there is none.
    shorten[256](t; params: Plain;; paths: [Path], earliest: [u32], mut shortened: [Path]) {
        let i = t.i;
        if i < params.frame.count[0] {
            let until = decide::until(at(earliest, 0));
            let until = if until < params.frame.until { until } else { params.frame.until };
            let path = swept_box::shorten(&at(paths, i as usize), params.frame.from, until);
            put(shortened, i as usize, path);
        }
    }
}
