//! Overlapping pairs to candidates, and these to the pairs that the filters leave.
//!
//! Where a step has too many candidates for a list, they are listed and filtered a part at a time,
//! and the list of each part takes the place of the last.

use super::Goal;
use super::buffers::Buffers;
use super::part_limits::MOST;
use super::source::Source;
use crate::bind::{FilterPairs, ListListed};
use crate::broad_phase::block_bvh::{ALL, Pass};
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::{Header, parts};
use crate::recorder::Recorder;
use ccd_core::backend::kernel::Id;
use ccd_core::backend::layout::{Dispatch, Filtering, Frame, Params};
use ccd_core::narrow_phase::cascade::PAIRS_A_THREAD;
use std::ops::Range;

/// Stages by kind.
const LIST: [&str; 2] = ["list vertex-face", "list edge-edge"];

/// Candidates that one dispatch filters at most: some hundredths of a second of a small device, so
/// that no driver thinks that it hangs, and one dispatch a part.
const DISPATCH_LIMIT: u32 = 1 << 25;

impl Buffers {
    /// Lists all candidates of both kinds.
    pub fn list(&self, recorder: &mut Recorder, frame: &Frame) {
        for kind in [0, 1] {
            recorder.stage(LIST[kind]);
            self.list_part(recorder, frame, (kind, 1), ALL);
        }
    }

    /// Filters candidates of both kinds. `step`: of every so many-th pair of blocks.
    pub fn filter(&self, recorder: &mut Recorder, frame: &Frame, paths: &wgpu::Buffer, step: u32) {
        let frame = &Frame { flags: frame.flags | Frame::FLAG_IN_PARTS, ..*frame };
        let limits = [0, 1].map(|kind| self.part_limits.of(kind, self.n_pairs(kind)));
        let n_parts = [0, 1].map(|kind| self.n_pairs(kind).div_ceil(step).div_ceil(limits[kind]));
        for part in 0..n_parts[0].max(n_parts[1]) {
            if part > 0 {
                // Also that of which no part is left.
                self.candidates.iter().for_each(|list| recorder.clear(list.buffer(), 4));
            }
            for kind in [0, 1].into_iter().filter(|&kind| part < n_parts[kind]) {
                recorder.stage(LIST[kind]);
                let first = part * limits[kind];
                let range = first..first.saturating_add(limits[kind]);
                self.list_part(recorder, frame, (kind, step), range);
            }
            recorder.stage("filter");
            self.filter_part(recorder, frame, paths);
        }
    }

    /// Makes lists of candidates longer that were too short in a step, by what their headers say,
    /// or its parts smaller where a list would be larger than [`MOST`] or than there is memory for.
    /// Then the headers want no more than there is. Returns whether there were some.
    pub fn grow_candidates(
        &mut self,
        device: &Device,
        goal: Goal,
        headers: &mut [Header; 2],
    ) -> Result<bool, Error> {
        let most = match device.faults().most_candidates {
            0 => MOST,
            most => most,
        };
        let mut grown = Ok(false);
        for (kind, header) in headers.iter_mut().enumerate() {
            let n_pairs = self.n_pairs(kind);
            let Self { candidates, part_limits, .. } = self;
            let list = &mut candidates[kind];
            if header.wanted > list.capacity() {
                let mut wanted = header.wanted;
                if wanted > most && part_limits.shrink(kind, wanted, n_pairs, most) {
                    wanted = most;
                }
                let longer = match list.grow(device, wanted) {
                    Err(e) if e.is_of_memory() => {
                        let capacity = list.capacity();
                        let shrinks = part_limits.shrink(kind, header.wanted, n_pairs, capacity);
                        if shrinks { Ok(true) } else { Err(e) }
                    }
                    other => other.map(|_| true),
                };
                grown = grown.and_then(|any| Ok(any | longer?));
                header.wanted = 0;
            } else if goal != Goal::Earliest && header.second <= list.capacity() {
                // All of them fit into the list; of paths that were cut there are fewer.
                part_limits.reset(kind);
            }
        }
        grown
    }

    /// Pairs that may be looked at.
    fn n_pairs(&self, kind: usize) -> u32 {
        match &self.source {
            Source::Blocks(tree) => tree.block_pairs(kind).capacity(),
            Source::Features(_, listed) | Source::Triangles(_, listed) => {
                listed.pairs[kind].capacity()
            }
        }
    }

    /// Lists candidates of a kind in a range of the pairs, of which every `step`-th is looked at.
    fn list_part(
        &self,
        recorder: &mut Recorder,
        frame: &Frame,
        (kind, step): (usize, u32),
        range: Range<u32>,
    ) {
        let (bodies, keys, list) = (&self.bodies, &self.positions.keys, &self.candidates[kind]);
        match &self.source {
            Source::Blocks(tree) => {
                let pass = Pass { kind: kind as u32, level: 1, step, range };
                tree.list(recorder, frame, &pass, [bodies, keys], list);
            }
            Source::Features(_, listed) | Source::Triangles(_, listed) => {
                let (boxes, input) = (self.source.finder().boxes(), listed.pairs[kind].buffer());
                let (elements, output) = (&self.elements, list.buffer());
                let kernel = ListListed { boxes, elements, bodies, keys, input, output };
                listed.each_part(frame, kind, range, list, |p, groups| {
                    recorder.dispatch(&kernel, p, groups);
                });
            }
        }
    }

    /// Filters the candidates that were listed.
    fn filter_part(&self, recorder: &mut Recorder, frame: &Frame, paths: &wgpu::Buffer) {
        let ([vf, ee], output) = (&self.candidates, &self.survivors);
        let pool = PAIRS_A_THREAD * Id::FilterPairs.threads();
        let n_pools = [vf, ee].map(|list| list.capacity().div_ceil(pool)).into_iter().sum();
        let args = Filtering { capacity_ee: ee.capacity() };
        for dispatch in parts(n_pools, DISPATCH_LIMIT / pool, output.capacity()) {
            let groups = dispatch.n.min(self.groups);
            let dispatch = Dispatch { capacity_in: vf.capacity(), ..dispatch };
            let kernel = FilterPairs {
                elements: &self.elements,
                paths,
                vf: vf.buffer(),
                ee: ee.buffer(),
                output: output.buffer(),
            };
            recorder.dispatch(&kernel, &Params { frame: *frame, dispatch, args }, groups);
        }
    }
}
