//! Sort and sweep with a thread an end point; see
//! `ccd_core::backend::broad_phase::sweep_by_end_points`.

use crate::entry::kernel;
use crate::records::{BoxWords, box_at};
use crate::workgroup::append;
use ccd_core::backend::broad_phase::block_bvh::set_of;
use ccd_core::backend::broad_phase::key_intervals::FOUND;
use ccd_core::backend::broad_phase::stack_traversal::NONE;
use ccd_core::backend::broad_phase::sweep_by_end_points::{
    self, Walk, kind_of, may_pair, pair, range,
};
use ccd_core::backend::kernel::memory::{at, put};

kernel! {
    /// Thread `i` writes both end points of box `i`, and their keys.
    end_point_keys[256](t; params: Plain;; boxes: [BoxWords], survey: [u32], mut keys: [u32],
        mut points: [u32]) {
        let i = t.i;
        if i < params.frame.start[3] {
            let set = set_of(&params.frame.start, i) as u32;
            let axis = at(survey, FOUND);
            let of_box = sweep_by_end_points::keys(set, &box_at(boxes, i as usize), axis);
            let [start, end] = sweep_by_end_points::points(i);
            put(keys, start as usize, of_box[0]);
            put(keys, end as usize, of_box[1]);
            put(points, start as usize, start);
            put(points, end as usize, end);
        }
    }
}

kernel! {
    /// Thread `i` walks from end point `dispatch.first + i`, if a box starts there, to the end of
    /// that box, and lists the boxes that start on the way and overlap it.
    sweep_end_points[128](t; params: Plain;; boxes: [BoxWords], points: [u32], mut pairs: [u32]) {
        if t.i < params.dispatch.n {
            let (k, start) = (params.dispatch.first + t.i, &params.frame.start);
            let kind = kind_of(k, &params.frame.count);
            let [_, end] = range(kind, &params.frame.count);
            let mut walk = Walk::new(points, k);
            let i = walk.box_idx();
            let query = box_at(boxes, i as usize);
            for _ in k + 1..end {
                if !walk.goes_on {
                    break;
                }
                let j = walk.step(points);
                if j != NONE
                    && may_pair(kind, start, i, j)
                    && query.overlaps(&box_at(boxes, j as usize))
                {
                    append(pairs, params.dispatch.capacity_out, pair(kind, start, i, j));
                }
            }
        }
    }
}
