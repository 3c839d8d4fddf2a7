//! The dispatches of a frame, from positions to results.

use super::buffers::Buffers;
use super::upload::{Boxes, Positions};
use super::{Goal, SAMPLE};
use crate::bind::{
    AdvanceWide, Decide, DecideIntegers, DecideNear, DecideNearWide, DecideWide, PlaceVertices,
    Shorten, SweepElements, SweepVertices,
};
use crate::broad_phase::block_bvh::Features;
use crate::growable_list::{HEADER_BYTES, List, parts};
use crate::recorder::Recorder;
use ccd_core::backend::broad_phase::swept_box;
use ccd_core::backend::kernel::Id;
use ccd_core::backend::layout::{Decision, Frame, IntegerDecision, Params};
use ccd_core::narrow_phase::decide;
use ccd_core::narrow_phase::integer_search::Window;

impl Buffers {
    /// Everything from positions to results.
    pub fn record(&self, recorder: &mut Recorder, frame: &Frame, goal: Goal, wide: bool) {
        self.clear(recorder, goal);
        recorder.copy(&self.never, 0, &self.earliest, 0, 4);
        self.source.clear(recorder, self.keeps_order);
        let contact_order = self.order.as_ref().filter(|_| self.to_order > 0);
        contact_order.inspect(|order| order.clear(recorder, frame));
        recorder.stage("boxes");
        let (mut paths, bodies) = (self.positions.paths(), &self.bodies);
        let mut window = self.sweep(recorder, frame, paths, (self.positions.boxes, true));
        let whole = frame.from <= 0.0 && frame.until >= 1.0;
        if !whole {
            window = self.shorten(recorder, frame, true);
        }
        let frame = &window;
        if !whole {
            paths = &self.shortened;
        }
        if !self.keeps_order {
            self.source.order(recorder, frame, &self.elements);
        }
        // The candidates of a sample are few, so that boxes at both ends do not pay.
        let ends = matches!(goal, Goal::Contacts | Goal::EarliestAtOnce);
        let frame = &self.source.fit(recorder, frame, Features { bodies, paths, ends });
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

    /// Cuts paths to the times that matter, up to the earliest time found, and sweeps them, as
    /// [`Buffers::sweep`] does. Returns what a frame then says.
    fn shorten(&self, recorder: &mut Recorder, frame: &Frame, is_first: bool) -> Frame {
        let paths = self.positions.paths();
        let error = self.positions.path_error() + swept_box::end_error(self.positions.reach);
        let cut = Frame {
            path_error: error,
            margin: (frame.margin + error).next_up(),
            flags: frame.flags & !(Frame::FLAG_CONFIRM | Frame::FLAG_SWEPT),
            ..*frame
        };
        recorder.stage("shorten");
        let Self { earliest, shortened, .. } = self;
        recorder.each(&Shorten { paths, earliest, shortened }, &plain(&cut), cut.count[0]);
        self.sweep(recorder, &cut, shortened, (Boxes::OfPaths, is_first))
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
        self.clear(recorder, Goal::Earliest);
        let cut = self.shorten(recorder, frame, false);
        let (bodies, paths) = (&self.bodies, &self.shortened);
        let cut = self.source.fit(recorder, &cut, Features { bodies, paths, ends: true });
        self.contacts(recorder, &cut, paths, 1, wide);
    }

    fn clear(&self, recorder: &mut Recorder, goal: Goal) {
        let lists = self.lists().zip(self.used(goal)).into_vec().into_iter();
        let used = lists.filter(|(_, is_used)| *is_used);
        used.for_each(|(list, _)| recorder.clear(list.buffer(), HEADER_BYTES));
    }

    /// All boxes that something reads: those of blocks in the order that they have are fitted from
    /// vertices, or from paths. `is_first`: the frame may sort after it. Returns what a frame then
    /// says.
    fn sweep(
        &self,
        recorder: &mut Recorder,
        frame: &Frame,
        paths: &wgpu::Buffer,
        (of_vertices, is_first): (Boxes, bool),
    ) -> Frame {
        let reads_all = is_first && !self.keeps_order || self.source.reads_elements();
        if !reads_all && of_vertices == Boxes::OfPaths {
            return Frame { flags: frame.flags | Frame::FLAG_SWEPT, ..*frame };
        }
        let ([v, e, f], p) = (frame.count, plain(frame));
        let Positions { wide, keys, .. } = &self.positions;
        let (elements, boxes) = (&self.elements, self.source.finder().boxes());
        match of_vertices {
            Boxes::OfPaths => recorder.each(&SweepVertices { paths, boxes }, &p, v),
            Boxes::OfPositions => {
                recorder.each(&PlaceVertices { positions: wide, paths, keys, boxes }, &p, v)
            }
            Boxes::Sent => {}
        }
        if reads_all {
            recorder.each(&SweepElements { elements, boxes }, &p, e + f);
        }
        *frame
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
        self.source.find(recorder, frame, self.keeps_order);
        self.filter(recorder, frame, paths, step);
        // What is open bounds nothing, and is found again after a sample.
        self.decide(recorder, frame, wide, self.decides_twice && (step == 1 || !wide));
    }

    /// Decides what the filters left. `twice`: and what a first decision leaves open, once more.
    fn decide(&self, recorder: &mut Recorder, frame: &Frame, wide: bool, twice: bool) {
        recorder.stage("decide");
        let frame = Frame { path_error: self.positions.path_error(), ..*frame };
        let is_near = frame.distance_bits != [0; 2];
        let Self { elements, earliest, .. } = self;
        let (paths, positions) = (self.positions.paths(), &self.positions.wide);
        let (contacts, left) = (self.contacts.buffer(), self.left.buffer());
        let threads = Id::Decide.threads();
        let limit = DISPATCH_LIMIT.min(self.groups * threads * PAIRS_A_THREAD);
        let parts_of = |list: &List| {
            parts(list.capacity(), limit, self.contacts.capacity())
                .map(|dispatch| (dispatch, self.groups.min(dispatch.n.div_ceil(threads))))
        };
        let mut decided = &self.survivors;
        let integers = if self.integers { self.integer_window(&frame) } else { None };
        if integers.is_some() || wide && !is_near {
            let input = decided.buffer();
            let args = Decision { capacity_left: if twice { self.left.capacity() } else { 0 } };
            for (dispatch, groups) in parts_of(decided) {
                if let Some(window) = integers {
                    let args = IntegerDecision::new(args, window);
                    let kernel = DecideIntegers {
                        paths,
                        positions,
                        elements,
                        input,
                        contacts,
                        left,
                        earliest,
                    };
                    recorder.dispatch(&kernel, &Params { frame, dispatch, args }, groups);
                } else {
                    let kernel =
                        DecideWide { paths, positions, elements, input, contacts, left, earliest };
                    recorder.dispatch(&kernel, &Params { frame, dispatch, args }, groups);
                }
            }
            if !twice {
                return;
            }
            decided = &self.left;
        }
        let input = decided.buffer();
        for (dispatch, groups) in parts_of(decided) {
            // One of four, so that a first step waits for no more than it needs.
            let params = Params { dispatch, ..plain(&frame) };
            match (wide, is_near) {
                (true, false) => {
                    let kernel =
                        AdvanceWide { paths, positions, elements, input, contacts, earliest };
                    recorder.dispatch(&kernel, &params, groups);
                }
                (true, true) => {
                    let kernel =
                        DecideNearWide { paths, positions, elements, input, contacts, earliest };
                    recorder.dispatch(&kernel, &params, groups);
                }
                (false, false) => {
                    let kernel = Decide { paths, elements, input, contacts, earliest };
                    recorder.dispatch(&kernel, &params, groups);
                }
                (false, true) => {
                    let kernel = DecideNear { paths, elements, input, contacts, earliest };
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
