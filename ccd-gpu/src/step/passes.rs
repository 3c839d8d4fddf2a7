//! The dispatches of a frame, from positions to results.

use super::buffers::Buffers;
use super::upload::{Boxes, Positions};
use super::{Goal, SAMPLE};
use crate::bind::{
    Decide, DecideIntegers, DecideNear, DecideNearWide, DecideWide, PlaceVertices, Shorten,
    SweepEdges, SweepFaces, SweepVertices,
};
use crate::broad_phase::block_bvh::Features;
use crate::growable_list::{HEADER_BYTES, List, parts};
use crate::recorder::Recorder;
use ccd_core::backend::broad_phase::swept_box;
use ccd_core::backend::kernel::Id;
use ccd_core::backend::layout::{Decision, Frame, IntegerDecision, Params};
use ccd_core::narrow_phase::decide;
use ccd_core::narrow_phase::integer_search::Window;

/// Stages by kind.
const DECIDE: [&str; 2] = ["decide vertex-face", "decide edge-edge"];

impl Buffers {
    /// Everything from positions to results.
    pub fn record(&self, recorder: &mut Recorder, frame: &Frame, goal: Goal, wide: bool) {
        self.clear(recorder, goal, wide);
        for earliest in &self.earliest {
            recorder.copy(&self.never, 0, earliest, 0, 4);
        }
        self.source.clear(recorder, self.keeps_order);
        let contact_order = self.order.as_ref().filter(|_| self.to_order > 0);
        contact_order.inspect(|order| order.clear(recorder, frame));
        recorder.stage("boxes");
        let mut paths = self.positions.paths();
        self.sweep(recorder, frame, paths, self.positions.boxes);
        let whole = frame.from <= 0.0 && frame.until >= 1.0;
        let window = if whole { *frame } else { self.shorten(recorder, frame) };
        let frame = &window;
        if !whole {
            paths = &self.shortened;
        }
        if !self.keeps_order {
            self.source.order(recorder, frame);
        }
        self.source.fit(recorder, frame, self.features());
        match goal {
            Goal::Candidates => {
                self.source.find(recorder, frame, self.keeps_order);
                self.list(recorder, frame);
            }
            Goal::Contacts => {
                let keep = Frame { flags: frame.flags | Frame::FLAG_KEEP, ..*frame };
                self.contacts(recorder, &keep, paths, 1, wide);
                if let Some(order) = contact_order {
                    recorder.stage("order contacts");
                    order.run(recorder, &keep, &self.contacts, self.to_order);
                }
            }
            Goal::EarliestAtOnce => self.contacts(recorder, frame, paths, 1, wide),
            Goal::Earliest => self.earliest(recorder, frame, paths, wide),
        }
    }

    /// Cuts paths to the times that matter, up to the earliest time found, and sweeps them. Returns
    /// what a frame then says.
    fn shorten(&self, recorder: &mut Recorder, frame: &Frame) -> Frame {
        let paths = self.positions.paths();
        let error = self.positions.path_error() + swept_box::end_error(self.positions.reach);
        let cut = Frame {
            path_error: error,
            margin: (frame.margin + error).next_up(),
            flags: frame.flags & !Frame::FLAG_CONFIRM,
            ..*frame
        };
        recorder.stage("shorten");
        let [of_vf, of_ee] = &self.earliest;
        let shortened = &self.shortened;
        recorder.each(&Shorten { paths, of_vf, of_ee, shortened }, &plain(&cut), cut.count[0]);
        self.sweep(recorder, &cut, shortened, Boxes::OfPaths);
        cut
    }

    /// A part of the block pairs first; what it finds bounds the time that matters, and shorter
    /// paths have smaller boxes.
    fn earliest(&self, recorder: &mut Recorder, frame: &Frame, paths: &wgpu::Buffer, wide: bool) {
        self.contacts(recorder, frame, paths, SAMPLE, wide);
        recorder.copy(self.candidates[0].buffer(), 4, &self.sample, 0, 4);
        recorder.copy(self.candidates[1].buffer(), 4, &self.sample, 4, 4);
        // Shorter paths say nothing about the order.
        for (to, list) in [8, 12].into_iter().zip(self.source.sampled()) {
            recorder.copy(list.buffer(), 0, &self.sample, to, 4);
        }
        self.clear(recorder, Goal::Earliest, wide);
        let cut = self.shorten(recorder, frame);
        self.source.fit(recorder, &cut, self.features());
        self.contacts(recorder, &cut, &self.shortened, 1, wide);
    }

    fn clear(&self, recorder: &mut Recorder, goal: Goal, wide: bool) {
        let lists = self.lists().zip(self.used(goal, wide)).into_vec().into_iter();
        let used = lists.filter(|(_, is_used)| *is_used);
        used.for_each(|(list, _)| recorder.clear(list.buffer(), HEADER_BYTES));
    }

    fn sweep(
        &self,
        recorder: &mut Recorder,
        frame: &Frame,
        paths: &wgpu::Buffer,
        of_vertices: Boxes,
    ) {
        let ([v, e, f], p) = (frame.count, plain(frame));
        let Positions { wide, keys, .. } = &self.positions;
        let (edges, faces, boxes) = (&self.edges, &self.faces, self.source.finder().boxes());
        match of_vertices {
            Boxes::OfPaths => recorder.each(&SweepVertices { paths, boxes }, &p, v),
            Boxes::OfPositions => {
                recorder.each(&PlaceVertices { positions: wide, paths, keys, boxes }, &p, v)
            }
            Boxes::Sent => {}
        }
        recorder.each(&SweepEdges { edges, boxes }, &p, e);
        recorder.each(&SweepFaces { faces, boxes }, &p, f);
    }

    /// Filters candidates of every `step`-th block pair and decides what is left.
    fn contacts(
        &self,
        recorder: &mut Recorder,
        frame: &Frame,
        paths: &wgpu::Buffer,
        step: u32,
        wide: bool,
    ) {
        // A sample reads few leaves.
        let with_ends =
            if step == 1 { self.source.fit_ends(recorder, frame, paths) } else { *frame };
        self.source.find(recorder, frame, self.keeps_order);
        self.filter(recorder, &with_ends, paths, step);
        [0, 1].into_iter().for_each(|kind| self.decide(recorder, frame, kind, wide));
    }

    fn decide(&self, recorder: &mut Recorder, frame: &Frame, kind: usize, wide: bool) {
        recorder.stage(DECIDE[kind]);
        let (survivors, open) = (&self.survivors[kind], &self.undecided[kind]);
        let frame = Frame { path_error: self.positions.path_error(), ..*frame };
        let is_near = decide::is_near(&frame);
        // Where contacts are not kept, a list that the other kind does not have, so that a device
        // works on both at once: of pairs in `f64`, else one that stays as it is.
        let kept = if wide { open } else { &self.candidates[kind] };
        let keep = frame.has(Frame::FLAG_KEEP);
        let contacts = if keep { &self.contacts } else { kept }.buffer();
        let paths = self.positions.paths();
        let Positions { wide: positions, .. } = &self.positions;
        let (elements, args) =
            (self.elements(kind), Decision { kind: kind as u32, capacity_open: open.capacity() });
        let (undecided, earliest) = (open.buffer(), &self.earliest[kind]);
        let threads = Id::Decide.threads();
        let limit = DISPATCH_LIMIT.min(self.groups * threads * PAIRS_A_THREAD);
        let parts_of = |list: &List| {
            parts(list.capacity(), limit, self.contacts.capacity())
                .map(|dispatch| (dispatch, self.groups.min(dispatch.n.div_ceil(threads))))
        };
        let mut decided = survivors;
        if let (false, Some(window)) = (wide, self.integer_window(&frame)) {
            let (input, list) = (survivors.buffer(), &self.left[kind]);
            let args = Decision { capacity_open: list.capacity(), ..args };
            let (left, args) = (list.buffer(), IntegerDecision::new(args, window));
            for (dispatch, groups) in parts_of(survivors) {
                let kernel =
                    DecideIntegers { paths, positions, elements, input, contacts, left, earliest };
                recorder.dispatch(&kernel, &Params { frame, dispatch, args }, groups);
            }
            decided = list;
        }
        let input = decided.buffer();
        for (dispatch, groups) in parts_of(decided) {
            // One of four, so that a first step waits for no more than it needs.
            let params = Params { frame, dispatch, args };
            match (wide, is_near) {
                (true, false) => {
                    let kernel =
                        DecideWide { paths, positions, elements, input, contacts, earliest };
                    recorder.dispatch(&kernel, &params, groups);
                }
                (true, true) => {
                    let kernel =
                        DecideNearWide { paths, positions, elements, input, contacts, earliest };
                    recorder.dispatch(&kernel, &params, groups);
                }
                (false, false) => {
                    let kernel = Decide { paths, elements, input, contacts, undecided, earliest };
                    recorder.dispatch(&kernel, &params, groups);
                }
                (false, true) => {
                    let kernel =
                        DecideNear { paths, elements, input, contacts, undecided, earliest };
                    recorder.dispatch(&kernel, &params, groups);
                }
            }
        }
    }

    /// What integers look for, if they can.
    fn integer_window(&self, frame: &Frame) -> Option<Window> {
        let exact = self.positions.exact || self.positions.given;
        if exact { Window::of(&decide::wide_search_of(frame)) } else { None }
    }

    fn features(&self) -> Features<'_> {
        Features { edges: &self.edges, faces: &self.faces, bodies: &self.bodies }
    }

    /// Faces, or edges, as pairs of a kind have them.
    pub(super) fn elements(&self, kind: usize) -> &wgpu::Buffer {
        if kind == 0 { &self.faces } else { &self.edges }
    }
}

/// Entries of a list that one dispatch decides, or describes, at most: each takes some thousand
/// operations, in `f64` where it is there, so that a small device is done long before its driver
/// thinks that it hangs (2 s), and the largest scenes that we know take one or two.
pub const DISPATCH_LIMIT: u32 = 1 << 21;

/// Pairs that a thread decides at most: each takes some tens of rounds of its loops, few a
/// thousand, see [`Device::groups`](crate::device::Device::groups).
const PAIRS_A_THREAD: u32 = 16;

/// Parameters of a kernel that reads the frame alone.
fn plain(frame: &Frame) -> Params {
    Params { frame: *frame, ..Params::default() }
}
