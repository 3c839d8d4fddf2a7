//! What is made of every vertex of a step: checked coordinates, the table that filters read, boxes.

use super::Prepared;
use crate::simd::{RowSimd, WIDTH, Work};
use crate::step::positions::Ends;
use crate::threads::Threads;
use ccd_core::backend::broad_phase::swept_box;
use ccd_core::backend::quantization::{Table, margin};
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
        if !x.times.again {
            self.scan = self.scans.check(threads, (x.x0, x.x1), runs)?;
        }
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
        let part = |first: usize, out: &mut [Aabb<f32>]| {
            let of = first..first + out.len();
            let (x0, x1, times) = (&x.x0[of.clone()], &x.x1[of], [x.times.from, x.times.until]);
            crate::simd::run_rows!(Sweep { x0, x1, times, margin, out })
        };
        still.chunks(threads, boxes, &part);
    }
}

/// Boxes of vertices, written where they belong.
struct Sweep<'a, T> {
    x0: &'a [[T; 3]],
    x1: &'a [[T; 3]],
    times: [f64; 2],
    margin: T,
    out: &'a mut [Aabb<f32>],
}

impl<S: RowSimd, T: Real> Work<S> for Sweep<'_, T> {
    type Out = ();

    #[inline(always)]
    fn call(self, _: S) {
        swept_box::vertices(self.x0, self.x1, self.times, self.margin, self.out);
    }
}
