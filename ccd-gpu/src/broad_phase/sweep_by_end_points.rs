//! Sort and sweep with a thread an end point as a source of pairs; see
//! `ccd_core::backend::broad_phase::sweep_by_end_points`.

use super::key_intervals::survey_axis;
use super::pair_source::{PairSource, Search, boxes, frame_of};
use super::stages::PAIRS;
use crate::bind::{EndPointKeys, SweepEndPoints};
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::parts;
use crate::recorder::Recorder;
use crate::sort::Sort;
use ccd_core::backend::broad_phase::key_intervals::SURVEY_WORDS;
use ccd_core::backend::broad_phase::sweep_by_end_points::range;
use ccd_core::backend::layout::{Dispatch, Params};
use wgpu::BufferUsages as U;

/// End points of one dispatch, at least: where each box overlaps ten thousand others along the
/// axis, some 10^9 steps, so that no driver thinks that it hangs.
const DISPATCH_LIMIT: u32 = 1 << 16;

/// Dispatches of one kind of pairs, at most: a recording has a limit of them.
const MOST_DISPATCHES: u32 = 512;

/// A sweep over sets of so many boxes.
pub struct EndPointSource {
    boxes: wgpu::Buffer,
    survey: wgpu::Buffer,
    sort: Sort,
}

impl EndPointSource {
    pub fn new(device: &Device, count: [u32; 3]) -> Result<Self, Error> {
        // Two end points a box, of which there are fewer than 2^31.
        let n_points = 2 * frame_of(count).start[3];
        Ok(Self {
            boxes: boxes(device, count, None)?,
            survey: device.buffer("a survey of boxes", 4 * SURVEY_WORDS as u64, U::STORAGE)?,
            sort: Sort::new(device, n_points, None)?,
        })
    }
}

impl PairSource for EndPointSource {
    fn boxes(&self) -> &wgpu::Buffer {
        &self.boxes
    }

    fn clear(&self, _: &mut Recorder) {}

    fn find(&self, recorder: &mut Recorder, search: &Search) {
        let Self { boxes, survey, sort } = self;
        let (frame, n) = (search.frame, search.frame.start[3]);
        let params = |dispatch| Params { frame: *frame, dispatch, ..Params::default() };
        recorder.stage("keys");
        survey_axis(recorder, frame, boxes, survey);
        let [keys, points] = sort.half(0);
        let kernel = EndPointKeys { boxes, survey, keys, points };
        recorder.each(&kernel, &params(Dispatch::default()), n);
        recorder.stage("sort");
        sort.run(recorder, 2 * n);
        for &kind in search.kinds {
            recorder.stage(search.stage("pairs", PAIRS, kind));
            let list = search.pairs[kind as usize];
            let [first, end] = range(kind, &frame.count);
            let limit = DISPATCH_LIMIT.max((end - first).div_ceil(MOST_DISPATCHES));
            for part in parts(end - first, limit, list.capacity()) {
                let p = params(Dispatch { first: first + part.first, ..part });
                let kernel = SweepEndPoints { boxes, points, pairs: list.buffer() };
                recorder.each(&kernel, &p, part.n);
            }
        }
    }

    fn settle(&mut self, _: &Device, _: &[Vec<u32>], _: bool) -> Result<bool, Error> {
        Ok(false)
    }
}
