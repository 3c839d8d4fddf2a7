//! What is made of every vertex of a step: checked coordinates, the table that filters read, boxes.

use super::Prepared;
use crate::simd::WIDTH;
use crate::step::positions::Ends;
use crate::threads::Threads;
use ccd_core::backend::broad_phase::swept_box;
use ccd_core::backend::quantization::{Table, margin};
use ccd_core::math::vec3::max_abs;
use ccd_core::model::method::{BroadPhaseMethod, Volume};
use ccd_core::model::options::Options;
use ccd_core::{Aabb, Error, Real};

impl Prepared {
    /// Checks coordinates, fills the table and sweeps the boxes of vertices.
    pub(super) fn vertices<T: Real>(
        &mut self,
        threads: &Threads,
        options: &Options,
        x: &Ends<T>,
    ) -> Result<(), Error> {
        let call = self.call.take();
        let runs = x.times.moved.filter(|moved| moved.follows(call)).map(|moved| moved.runs);
        self.scan = self.scans.check(threads, (x.x0, x.x1), runs)?;
        self.still.look(threads, (x.x0, x.x1), options.min_distance, runs)?;
        self.call = x.times.moved.map(|to| to.call);
        self.units = self.fill_table(threads, x);
        self.contact_reach = match options.broad_phase {
            BroadPhaseMethod::Tree(tree) if tree.volume == Volume::Obb => {
                Some(self.units.contact_reach(options.min_distance))
            }
            _ => None,
        };
        self.sweep(threads, x, margin(options.min_distance));
        Ok(())
    }

    /// Fills the table that filters read; returns how far its numbers may be from the true ones
    /// (minus a common origin).
    fn fill_table<T: Real>(&mut self, threads: &Threads, x: &Ends<T>) -> Table {
        let table = self.scan.table(x.times.whole());
        threads.resize(&mut self.table, x.x0.len(), || [0.0; WIDTH]);
        self.still.look_at_table(table);
        self.still.fill_table(threads, &mut self.table, |i| {
            let [p, q] = x.ends(i).map(|p| table.place(p));
            [p[0], p[1], p[2], 0.0, q[0], q[1], q[2], 0.0]
        });
        table
    }

    /// Boxes of vertices.
    fn sweep<T: Real>(&mut self, threads: &Threads, x: &Ends<T>, margin: T) {
        let Self { vertices, still, .. } = self;
        let boxes = &mut vertices.boxes;
        threads.resize(boxes, x.x0.len(), || Aabb::EMPTY);
        if x.times.whole() {
            still.fill(threads, boxes, |i| swept_box::vertex(i, x.x0, x.x1, margin));
        } else {
            still.fill(threads, boxes, |i| {
                if x.x0[i] == x.x1[i] {
                    // Where it is at any time is exact; and so it stays the box of the whole step.
                    return swept_box::vertex(i, x.x0, x.x1, margin);
                }
                let [p, q] = x.ends(i);
                let largest = max_abs(x.x0[i].map(T::to_f64)).max(max_abs(x.x1[i].map(T::to_f64)));
                swept_box::swept(p, q)
                    .inflated(margin.to_f64() + swept_box::end_error(largest))
                    .round_out()
            });
        }
    }
}
