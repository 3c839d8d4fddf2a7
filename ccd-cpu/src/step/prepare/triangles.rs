//! What is made of every triangle of a step, if pairs of triangles are looked for.

use super::{MAX_LOOSENESS, Prepared};
use crate::broad_phase::method::Method;
use crate::broad_phase::pair_source::PairSource;
use crate::threads::Threads;
use ccd_core::Error;
use ccd_core::backend::rules::Rules;

impl Prepared {
    /// As [`Prepared::leaves`], of triangles.
    pub(super) fn triangle_leaves(
        &mut self,
        threads: &Threads,
        method: &mut Method,
        rules: Option<&Rules>,
        first: bool,
    ) -> Result<bool, Error> {
        let Self { vertices, triangles, table, built, contact_reach, .. } = self;
        let Some(leaves) = triangles else { return Ok(false) };
        leaves.sweep(threads, &vertices.boxes);
        let mut loose = !*built || !method.order().outlasts_motion();
        if !loose {
            loose = leaves.refit(threads, method) > MAX_LOOSENESS && first;
        }
        if loose {
            leaves.build(threads, method, rules)?;
            *built = true;
        }
        leaves.place(threads, &vertices.boxes, table);
        leaves.orient(threads, table, *contact_reach);
        Ok(loose)
    }
}
