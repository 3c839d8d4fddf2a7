//! Overlapping pairs to candidates, which are listed, or filtered as they are found.

use super::buffers::Buffers;
use super::source::Source;
use crate::bind::{FilterEdgeEdge, FilterListed, FilterVertexFace, ListCandidates, ListListed};
use crate::broad_phase::block_bvh::Pass;
use crate::recorder::Recorder;
use ccd_core::backend::layout::Frame;

impl Buffers {
    /// Lists candidates of a kind.
    pub fn list(&self, recorder: &mut Recorder, frame: &Frame, kind: usize) {
        let (bodies, keys, list) = (&self.bodies, &self.positions.keys, &self.candidates[kind]);
        let output = list.buffer();
        match &self.source {
            Source::Blocks(tree) => {
                let (nodes, leaves, pairs) = (&tree.nodes, &tree.leaves, tree.block_pairs(kind));
                let input = pairs.buffer();
                let kernel = ListCandidates { nodes, leaves, bodies, keys, input, output };
                let pass = Pass { kind: kind as u32, level: 1, step: 1 };
                tree.each_part(frame, pass, pairs, list, |p| {
                    recorder.dispatch(&kernel, p, tree.groups.min(pairs.capacity()));
                });
            }
            Source::Features(_, listed) | Source::Triangles(_, listed) => {
                let (boxes, input) = (self.source.finder().boxes(), listed.pairs[kind].buffer());
                let elements = self.elements(kind);
                let kernel = ListListed { boxes, elements, bodies, keys, input, output };
                listed.each_part(frame, kind, list, |p, groups| {
                    recorder.dispatch(&kernel, p, groups);
                });
            }
        }
    }

    /// Filters candidates of a kind. `step`: of every so many-th pair of blocks.
    pub fn filter(
        &self,
        recorder: &mut Recorder,
        frame: &Frame,
        paths: &wgpu::Buffer,
        kind: usize,
        step: u32,
    ) {
        let (bodies, keys, list) = (&self.bodies, &self.positions.keys, &self.survivors[kind]);
        let output = list.buffer();
        match &self.source {
            Source::Blocks(tree) => {
                let (nodes, leaves, pairs) = (&tree.nodes, &tree.leaves, tree.block_pairs(kind));
                let (input, groups) = (pairs.buffer(), tree.groups.min(pairs.capacity()));
                let pass = Pass { kind: kind as u32, level: 1, step };
                tree.each_part(frame, pass, pairs, list, |p| match kind {
                    0 => recorder.dispatch(
                        &FilterVertexFace { nodes, leaves, bodies, keys, paths, input, output },
                        p,
                        groups,
                    ),
                    _ => recorder.dispatch(
                        &FilterEdgeEdge { nodes, leaves, bodies, keys, paths, input, output },
                        p,
                        groups,
                    ),
                });
            }
            Source::Features(_, listed) | Source::Triangles(_, listed) => {
                let (boxes, input) = (self.source.finder().boxes(), listed.pairs[kind].buffer());
                let elements = self.elements(kind);
                let kernel = FilterListed { boxes, elements, bodies, keys, paths, input, output };
                listed.each_part(frame, kind, list, |p, groups| {
                    recorder.dispatch(&kernel, p, groups);
                });
            }
        }
    }
}
