//! Whether a search looks at boxes at both ends, and these boxes.

use super::Prepared;
use crate::broad_phase::method::Method;
use crate::step::positions::Positions;
use crate::threads::Threads;
use ccd_core::model::options::Options;
use ccd_core::narrow_phase::cascade::needed_gap;

/// Boxes at both ends are compared where those around both are so many times longer than those at
/// the start: else they spare less than they cost.
const LONG: f64 = 1.25;

impl Prepared {
    /// The gap along an axis that keeps two features apart, in the unit of the table.
    pub(super) fn needed_gap(&self, options: &Options) -> f32 {
        needed_gap(self.units.error, self.units.distance(options.min_distance))
    }

    /// Makes boxes at both ends, if they may be apart where those of the step are not. Of a part
    /// of a step the method leaves out pairs of features that an axis keeps apart at all times that
    /// matter; they are not counted as candidates then. Pairs of triangles have their own.
    pub fn ends(
        &mut self,
        threads: &Threads,
        method: &mut Method,
        options: &Options,
        x: &Positions,
    ) {
        let gap = self.needed_gap(options);
        let Self { vertices, edges, faces, table, triangles, asks_ends, .. } = self;
        let (v, e, f) = (&mut vertices.leaves, &mut edges.leaves, &mut faces.leaves);
        if triangles.is_some() {
            return;
        }
        let table = &table[..];
        let (mut of_v, mut of_e, mut of_f) = ([0.0; 2], [0.0; 2], [0.0; 2]);
        threads.together(
            || of_v = v.lengths(table),
            || of_e = e.lengths(table),
            || of_f = f.lengths(table),
        );
        let lengths = [of_v, of_e, of_f];
        let [around_both, at_start] = [0, 1].map(|k| lengths.iter().map(|l| l[k]).sum::<f64>());
        *asks_ends = around_both > LONG * at_start;
        if !*asks_ends {
            return;
        }
        threads.together(
            || v.make_ends(threads, table),
            || e.make_ends(threads, table),
            || f.make_ends(threads, table),
        );
        if x.again {
            v.hand_on_ends(threads, method, gap);
            e.hand_on_ends(threads, method, gap);
            f.hand_on_ends(threads, method, gap);
        }
    }
}
