//! The chosen method: the one place where a choice becomes code.

use crate::broad_phase::block_pairs::BlockSource;
use crate::broad_phase::leaf_boxes::{LeafBoxes, Set};
use crate::broad_phase::pair_source::{Fixed, PairSink, PairSource};
use crate::broad_phase::radix_tree::RadixSource;
use crate::threads::Threads;
use ccd_core::model::method::BroadPhaseMethod;
use ccd_core::{Aabb, Error};

/// One of the sources of pairs that this backend has.
#[derive(Debug)]
pub enum Method {
    /// [`BroadPhaseMethod::Blocks`].
    Blocks(BlockSource),
    /// [`BroadPhaseMethod::Tree`].
    Tree(RadixSource),
}

impl Method {
    /// The source of a choice, if there is one here.
    pub fn new(choice: BroadPhaseMethod) -> Result<Self, Error> {
        match choice {
            BroadPhaseMethod::Blocks => Ok(Self::Blocks(BlockSource::default())),
            BroadPhaseMethod::Tree => Ok(Self::Tree(RadixSource::default())),
            other => Err(Error::Method { name: other.row().name, backend: "cpu" }),
        }
    }
}

/// Does the same with whichever source there is.
macro_rules! each {
    ($method:expr, $source:ident => $do:expr) => {
        match $method {
            Method::Blocks($source) => $do,
            Method::Tree($source) => $do,
        }
    };
}

impl PairSource for Method {
    fn sort(
        &mut self,
        threads: &Threads,
        set: Set,
        boxes: &[Aabb<f32>],
        fixed: Option<Fixed>,
        order: &mut Vec<u32>,
    ) {
        each!(self, source => source.sort(threads, set, boxes, fixed, order));
    }

    fn fit(&mut self, threads: &Threads, leaves: &LeafBoxes) -> f64 {
        each!(self, source => source.fit(threads, leaves))
    }

    fn find<K: PairSink>(
        &mut self,
        threads: &Threads,
        sides: (&LeafBoxes, Option<&LeafBoxes>),
        part: usize,
        sink: &K,
        workers: &mut [K::Worker],
    ) {
        each!(self, source => source.find(threads, sides, part, sink, workers));
    }
}
