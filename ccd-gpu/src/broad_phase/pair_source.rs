//! A source of pairs: any way to find overlapping boxes on a device.
//!
//! Boxes of up to three sets lie in one buffer, which the caller fills; a source records dispatches
//! that list pairs of their ids. What takes the pairs (the caller of a broad phase, or the filters
//! of a step) serves every source, and a new one is a file and an arm in `method.rs`.

use super::scheduled::Scheduled;
use super::worker_counts::Counted;
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::{Header, List};
use crate::recorder::Recorder;
use ccd_core::Aabb;
use ccd_core::backend::layout::Frame;
use ccd_core::model::report::FrontCounts;
use std::ops::Range;
use wgpu::BufferUsages as U;

/// A search for pairs, in one recording.
#[derive(Clone, Copy)]
pub struct Search<'a> {
    /// How many boxes each set has, and where they begin.
    pub frame: &'a Frame,
    /// Which pairs: 0: of set 0 with set 2, 1: within set 1.
    pub kinds: &'a [u32],
    /// The first so many boxes have the bounds of all.
    pub n_bounding: u32,
    /// By kind: where pairs of ids go.
    pub pairs: [&'a List; 2],
    /// Whether the order of boxes, and what is built in that order, is that of the search before,
    /// which was complete: boxes have moved, and nothing else has changed. Never in the first
    /// search, nor in one that follows an error.
    pub keeps_order: bool,
}

impl Search<'_> {
    /// The name of a stage: of a kind of pairs where several are looked for, else of all.
    pub fn stage(&self, all: &'static str, kinds: [&'static str; 2], kind: u32) -> &'static str {
        if self.kinds.len() > 1 { kinds[kind as usize] } else { all }
    }
}

/// Finds overlapping boxes on a device.
pub trait PairSource: Send + Sync {
    /// The boxes of all sets, one set after the other. The caller writes them.
    fn boxes(&self) -> &wgpu::Buffer;

    /// Clears everything to which kernels of the source add, but the headers of lists, which the
    /// caller clears.
    fn clear(&self, recorder: &mut Recorder);

    /// Records everything from boxes to pairs: all that overlap, each once, as ids; within a set
    /// the lesser first. Every dispatch has a bounded part of the work. A list that is too short
    /// counts what it lacks.
    fn find(&self, recorder: &mut Recorder, search: &Search);

    /// Lists between the stages of the source, which may have to grow.
    fn lists(&self) -> Vec<&List> {
        Vec::new()
    }

    /// The same, to be replaced by larger ones.
    fn lists_mut(&mut self) -> Vec<&mut List> {
        Vec::new()
    }

    /// Pairs of nodes that the last search took up, as the headers of [`PairSource::lists`] say: by
    /// their number it is seen how good an order still is. `None` if the source has no order that
    /// outlasts motion, and sorts in every search.
    fn work(&self, _headers: &[Header]) -> Option<u64> {
        None
    }

    /// What shares out pairs of nodes among workers, and keeps fronts; `None` without such.
    fn scheduled(&self) -> Option<&Scheduled> {
        None
    }

    /// Bytes of buffers that are read when a search is over, for [`PairSource::settle`].
    fn counters(&self) -> Vec<(&wgpu::Buffer, Range<u64>)> {
        self.scheduled().map(Scheduled::counters).unwrap_or_default()
    }

    /// A search is over, and its results were read: `counted` are the words of
    /// [`PairSource::counters`]. If a list was too short it is not `complete`: that list has grown,
    /// and the search runs again. Returns whether buffers were replaced.
    ///
    /// A search that is recorded without this call is not one after which order is kept. There is
    /// no default, so that a source that wraps another cannot forget to hand this on: a search that
    /// left pairs would run again with as few rounds.
    fn settle(
        &mut self,
        device: &Device,
        counted: &[Vec<u32>],
        complete: bool,
    ) -> Result<bool, Error>;

    /// What fronts the last search left; `None` without any.
    fn front(&self) -> Option<FrontCounts> {
        self.scheduled().and_then(Scheduled::front)
    }

    /// Where workers count what they do, by kind of pairs.
    fn worker_counts(&self) -> Vec<Counted<'_>> {
        self.scheduled().map(Scheduled::worker_counts).unwrap_or_default()
    }
}

/// A frame over sets of so many boxes; the caller sets the rest.
pub fn frame_of(count: [u32; 3]) -> Frame {
    let [v, e, f] = count;
    Frame { count, start: [0, v, v + e, v + e + f], ..Frame::default() }
}

/// A buffer for the boxes of all sets; that of other sets, if it is large enough.
pub fn boxes(
    device: &Device,
    count: [u32; 3],
    old: Option<&wgpu::Buffer>,
) -> Result<wgpu::Buffer, Error> {
    let n: u64 = count.iter().map(|&c| c as u64).sum();
    let bytes = n * size_of::<Aabb>() as u64;
    device.buffer_or(old, "boxes", bytes, U::STORAGE | U::COPY_DST | U::COPY_SRC)
}
