//! Boxes in the order of a key as a source of pairs: sort and sweep, a uniform grid, brute force.
//! What a method is stands in `ccd_core::backend::broad_phase::key_intervals`.

use super::pair_source::{PairSource, Search, boxes, frame_of};
use super::stages::PAIRS;
use crate::bind::{
    IntervalKeys, IntervalPairs, IntervalWork, OrderBoxes, SceneBounds, SurveyAxis, SurveySides,
};
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::{List, parts};
use crate::recorder::Recorder;
use crate::sort::Sort;
use ccd_core::backend::broad_phase::key_intervals::{
    BRUTE_FORCE, GROUP, MOST_BOXES, SURVEY_WORDS, SWEEP_AND_PRUNE, UNIFORM_GRID, asks, rows_a_step,
    rows_a_turn, turns,
};
use ccd_core::backend::broad_phase::morton_key;
use ccd_core::backend::kernel::Id;
use ccd_core::backend::layout::{Dispatch, Frame, Intervals, Params, Plain};
use wgpu::BufferUsages as U;

/// Pieces of work that one dispatch takes at most, 2^17 tests each: some milliseconds of a small
/// device, so that no driver thinks that it hangs.
const DISPATCH_LIMIT: u32 = 1 << 14;

/// Pieces of work that a workgroup takes at most: each takes a thread up to 1,232 rounds of its
/// loops, see [`Device::groups`].
const WORK_A_GROUP: u32 = 48;

/// Stages in which intervals are cut into pieces of work.
const WORK: [&str; 2] = ["work vertex-face", "work edge-edge"];

/// Boxes of each thread of a survey.
const SURVEY_SHARE: u32 = 32;

/// A method by keys, over sets of so many boxes.
pub struct IntervalSource {
    method: u32,
    boxes: wgpu::Buffer,
    sorted: wgpu::Buffer,
    survey: wgpu::Buffer,
    sort: Sort,
    /// Pieces of work, by kind.
    work: [List; 2],
    groups: u32,
}

impl IntervalSource {
    /// `method`: a constant of `key_intervals`. Of more than `MOST_BOXES` boxes an error.
    pub fn new(device: &Device, method: u32, count: [u32; 3]) -> Result<Self, Error> {
        check_count(count)?;
        let frame = frame_of(count);
        let work = |kind: u32| {
            // A few pieces for each group and row of a level; a list that is too short grows.
            let n_groups: u32 =
                (0..turns(method, kind)).map(|turn| asking(&frame, method, kind, turn)).sum();
            let n = n_groups.saturating_mul(4 * rows_a_step(method));
            List::new(device, "pieces of work", 2, n.max(256))
        };
        let boxes = boxes(device, count, None)?;
        Ok(Self {
            method,
            sorted: device.buffer("sorted boxes", boxes.size(), U::STORAGE)?,
            boxes,
            survey: device.buffer(
                "a survey of boxes",
                4 * SURVEY_WORDS as u64,
                U::STORAGE | U::COPY_DST | U::COPY_SRC,
            )?,
            sort: Sort::new(device, frame.start[3], None)?,
            work: [work(0)?, work(1)?],
            groups: device.groups(),
        })
    }

    /// What all boxes have in common, and their keys.
    fn keys(&self, recorder: &mut Recorder, search: &Search) {
        let Self { method, boxes, survey, .. } = self;
        let frame = search.frame;
        let n = frame.start[3];
        let params = |n: u32| Params {
            frame: *frame,
            dispatch: Dispatch { n, ..Dispatch::default() },
            args: Plain::default(),
        };
        match *method {
            SWEEP_AND_PRUNE => {
                survey_axis(recorder, frame, boxes, survey);
            }
            UNIFORM_GRID => {
                let n_bounding = search.n_bounding;
                let share = Id::SceneBounds.threads() * morton_key::CHUNK as u32;
                let kernel = SceneBounds { boxes, bounds: survey };
                recorder.dispatch(&kernel, &params(n_bounding), n_bounding.div_ceil(share));
                let share = Id::SurveySides.threads() * SURVEY_SHARE;
                recorder.dispatch(&SurveySides { boxes, survey }, &params(n), n.div_ceil(share));
            }
            _ => {}
        }
        let [keys, order] = self.sort.half(0);
        let p = self.params(frame, 0, 0, Dispatch::default());
        recorder.each(&IntervalKeys { boxes, survey, keys, order }, &p, n);
    }

    fn params(&self, frame: &Frame, kind: u32, row: u32, dispatch: Dispatch) -> Params<Intervals> {
        let args = Intervals { method: self.method, kind, row };
        Params { frame: *frame, dispatch, args }
    }

    /// The pieces of work of a kind of pairs.
    fn work(&self, recorder: &mut Recorder, frame: &Frame, kind: u32) {
        let Self { method, sorted, survey, work, .. } = self;
        let ([keys, _], list) = (self.sort.half(0), &work[kind as usize]);
        for turn in 0..turns(*method, kind) {
            let dispatch = Dispatch { capacity_out: list.capacity(), ..Dispatch::default() };
            let p = self.params(frame, kind, turn * rows_a_turn(*method), dispatch);
            let kernel = IntervalWork { sorted, keys, survey, work: list.buffer() };
            recorder.dispatch(&kernel, &p, asking(frame, *method, kind, turn));
        }
    }

    /// Does the work of a kind of pairs.
    fn pairs(&self, recorder: &mut Recorder, frame: &Frame, kind: u32, pairs: &List) {
        let Self { sorted, survey, work, .. } = self;
        let ([keys, order], list) = (self.sort.half(0), &work[kind as usize]);
        let limit = DISPATCH_LIMIT.min(self.groups * WORK_A_GROUP);
        for dispatch in parts(list.capacity(), limit, pairs.capacity()) {
            let p = self.params(frame, kind, 0, dispatch);
            let (work, pairs) = (list.buffer(), pairs.buffer());
            let kernel = IntervalPairs { sorted, keys, order, survey, work, pairs };
            recorder.dispatch(&kernel, &p, self.groups.min(dispatch.n));
        }
    }
}

/// Records that the axis along which boxes vary most is written to a survey.
pub fn survey_axis(
    recorder: &mut Recorder,
    frame: &Frame,
    boxes: &wgpu::Buffer,
    survey: &wgpu::Buffer,
) {
    let n = frame.start[3];
    let first = n.div_ceil(Id::SurveyAxis.threads() * SURVEY_SHARE);
    let dispatch = Dispatch { n, first, ..Dispatch::default() };
    let p = Params { frame: *frame, dispatch, args: Plain::default() };
    recorder.dispatch(&SurveyAxis { boxes, survey }, &p, 1);
}

/// Groups that ask in a turn.
fn asking(frame: &Frame, method: u32, kind: u32, turn: u32) -> u32 {
    let [set, _] = asks(method, kind, turn * rows_a_turn(method));
    frame.count[set as usize].div_ceil(GROUP)
}

/// Refuses more boxes than a piece of work has room for.
fn check_count(count: [u32; 3]) -> Result<(), Error> {
    let (count, limit) = (count.iter().map(|&n| n as u64).sum(), MOST_BOXES as u64);
    if count > limit {
        let element = "boxes of grids, sweep and prune or brute force on a GPU";
        return Err(ccd_core::Error::TooMany { element, count, limit }.into());
    }
    Ok(())
}

impl PairSource for IntervalSource {
    fn boxes(&self) -> &wgpu::Buffer {
        &self.boxes
    }

    fn clear(&self, recorder: &mut Recorder) {
        recorder.clear(&self.survey, 4 * SURVEY_WORDS as u64);
    }

    fn find(&self, recorder: &mut Recorder, search: &Search) {
        let (frame, n) = (search.frame, search.frame.start[3]);
        recorder.stage("keys");
        self.keys(recorder, search);
        if self.method != BRUTE_FORCE {
            recorder.stage("sort");
            self.sort.run(recorder, n);
        }
        recorder.stage("build");
        let Self { boxes, sorted, .. } = self;
        let ([_, order], p) = (self.sort.half(0), Params { frame: *frame, ..Params::default() });
        recorder.each(&OrderBoxes { boxes, order, sorted }, &p, n);
        for &kind in search.kinds {
            recorder.stage(search.stage("work", WORK, kind));
            self.work(recorder, frame, kind);
        }
        for &kind in search.kinds {
            recorder.stage(search.stage("pairs", PAIRS, kind));
            self.pairs(recorder, frame, kind, search.pairs[kind as usize]);
        }
    }

    fn lists(&self) -> Vec<&List> {
        self.work.iter().collect()
    }

    fn lists_mut(&mut self) -> Vec<&mut List> {
        self.work.iter_mut().collect()
    }

    fn settle(&mut self, _: &Device, _: &[Vec<u32>], _: bool) -> Result<bool, Error> {
        Ok(false)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_boxes_than_a_piece_of_work_names_are_refused() {
        assert!(check_count([MOST_BOXES - 7, 0, 7]).is_ok());
        let n = MOST_BOXES / 2;
        let text = check_count([n, n, 1]).unwrap_err().to_string();
        assert!(text.contains(&(MOST_BOXES + 1).to_string()), "{text}");
        assert!(check_count([u32::MAX; 3]).is_err());
    }
}
