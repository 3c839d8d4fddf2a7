//! Blocks as a source that lists pairs: sort, fit, descent, and the boxes of each pair of blocks.

use super::block_bvh::{ALL, Pass, Tree};
use super::pair_source::{PairSource, Search};
use super::scheduled::Scheduled;
use crate::bind::{ListCandidates, ListOverlaps, ListWanted};
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::{Header, List};
use crate::recorder::Recorder;
use ccd_core::backend::layout::Frame;

impl Tree {
    /// Candidates of the pairs of blocks that a pass looks at. `bodies`, and keys of exact boxes:
    /// any buffers where a frame asks for neither.
    pub fn list(
        &self,
        recorder: &mut Recorder,
        frame: &Frame,
        pass: &Pass,
        [bodies, keys]: [&wgpu::Buffer; 2],
        list: &List,
    ) {
        let (nodes, leaves, ends) = (&self.nodes, &self.leaves, self.ends());
        let pairs = self.block_pairs(pass.kind as usize);
        let (input, output) = (pairs.buffer(), list.buffer());
        let groups = self.groups.min(pairs.capacity());
        let by_rules = frame.has(Frame::FLAG_BODIES | Frame::FLAG_CONFIRM);
        self.each_part(frame, pass, pairs, list, |p| {
            if by_rules {
                let kernel = ListWanted { nodes, leaves, ends, bodies, keys, input, output };
                recorder.dispatch(&kernel, p, groups);
            } else {
                let kernel = ListCandidates { nodes, leaves, ends, input, output };
                recorder.dispatch(&kernel, p, groups);
            }
        });
    }
}

impl PairSource for Tree {
    fn boxes(&self) -> &wgpu::Buffer {
        &self.boxes
    }

    fn clear(&self, recorder: &mut Recorder) {
        self.clear_bounds(recorder);
        self.clear_descent(recorder);
    }

    fn find(&self, recorder: &mut Recorder, search: &Search) {
        // Boxes alone: what flags say of bodies and positions does not concern them.
        let frame = &Frame { flags: 0, ..*search.frame };
        if !search.keeps_order {
            recorder.stage("codes");
            self.sort(recorder, frame, search.n_bounding);
        }
        recorder.stage("build");
        self.fit_boxes(recorder, frame);
        recorder.stage("block pairs");
        self.descend(recorder, frame, search.kinds, search.keeps_order);
        recorder.stage("pairs");
        for &kind in search.kinds {
            let pass = Pass { kind, level: 1, step: 1, range: ALL };
            let (pairs, list) = (self.block_pairs(kind as usize), search.pairs[kind as usize]);
            let (nodes, [_, order]) = (&self.nodes, self.sorted());
            let (input, output) = (pairs.buffer(), list.buffer());
            self.each_part(frame, &pass, pairs, list, |p| {
                let kernel = ListOverlaps { nodes, order, input, output };
                recorder.dispatch(&kernel, p, self.groups.min(pairs.capacity()));
            });
        }
    }

    fn work(&self, headers: &[Header]) -> Option<u64> {
        let firsts = [(0, &self.pairs[0]), (self.pairs[0].len(), &self.pairs[1])];
        let used = firsts.into_iter().filter(|(_, lists)| !lists.is_empty());
        let found = used.filter_map(|(first, _)| headers.get(first));
        Some(found.map(|header| header.wanted as u64).sum())
    }

    fn lists(&self) -> Vec<&List> {
        let of_workers = self.scheduled().map(Scheduled::lists).unwrap_or_default();
        self.pairs.iter().flatten().chain(of_workers).collect()
    }

    fn lists_mut(&mut self) -> Vec<&mut List> {
        let Self { pairs, descent, .. } = self;
        let of_workers = descent.as_mut().map(Scheduled::lists_mut);
        pairs.iter_mut().flatten().chain(of_workers.unwrap_or_default()).collect()
    }

    fn scheduled(&self) -> Option<&Scheduled> {
        self.descent.as_ref()
    }

    fn settle(
        &mut self,
        device: &Device,
        counted: &[Vec<u32>],
        complete: bool,
    ) -> Result<bool, Error> {
        match &mut self.descent {
            Some(scheduled) => scheduled.settle(device, counted, complete),
            None => Ok(false),
        }
    }
}
