//! The chosen method: the one place where a choice becomes code.

use crate::broad_phase::block_pairs::BlockSource;
use crate::broad_phase::leaf_boxes::{LeafBoxes, Order, Sides};
use crate::broad_phase::pair_source::{PairSink, PairSource};
use crate::broad_phase::rows::{HandOn, Row, RowSource, Rows, Scratch};
use crate::broad_phase::tasks::Shares;
use crate::broad_phase::tree::TreeSource;
#[cfg(feature = "catalogue")]
use crate::broad_phase::{
    brute_force::BruteForce, descend::PairsOfNodes, scheduled::Scheduled,
    sweep_and_prune::SweepAndPrune, sweep_and_tiniest_queue::SweepAndTiniestQueue,
    sweep_in_strips::SweepInStrips, uniform_grid::UniformGrid,
};
use crate::threads::{Own, Threads};
use ccd_core::Error;
use ccd_core::model::catalogue::Catalogued;
use ccd_core::model::method::BroadPhaseMethod;
use ccd_core::model::report::FrontCounts;
use ccd_core::model::scheduling::{Scheduler, Scheduling};
use ccd_core::model::tree_statistics::TreeStatistics;

/// One of the sources of pairs that this backend has.
#[derive(Debug)]
#[allow(clippy::large_enum_variant, reason = "a session has one, mostly the largest")]
pub enum Method {
    /// The default, which is compiled into every sink.
    Blocks(BlockSource),
    /// Pairs of nodes by a scheduler that was chosen.
    #[cfg(feature = "catalogue")]
    Scheduled(Scheduled),
    /// Any other.
    Listed(Listed),
}

impl Method {
    /// The source of a choice, if there is one here.
    pub fn new(choice: BroadPhaseMethod, scheduling: Scheduling) -> Result<Self, Error> {
        choice.check()?;
        scheduling.check(choice)?;
        if let Some(name) = choice.lacking("cpu").or(scheduling.lacking("cpu")) {
            return Err(Error::Method { name, backend: "cpu" });
        }
        #[cfg(feature = "catalogue")]
        if is_chosen(scheduling, choice) {
            let source: Box<dyn PairsOfNodes> = match choice {
                BroadPhaseMethod::Tree(options) => Box::new(TreeSource::new(options)?),
                _ => Box::new(BlockSource::default()),
            };
            return Ok(Self::Scheduled(Scheduled::new(source, scheduling)?));
        }
        if is_chosen(scheduling, choice) {
            let by = scheduling.scheduler.filter(|by| !Scheduler::ALWAYS.contains(&by.row().name));
            let name = by.map_or("front", |by| by.row().name);
            return Err(Error::NotCompiled { name, backend: "cpu" });
        }
        let source: Box<dyn RowSource> = match choice {
            BroadPhaseMethod::Blocks => return Ok(Self::Blocks(BlockSource::default())),
            BroadPhaseMethod::Tree(options) => Box::new(TreeSource::new(options)?),
            #[cfg(feature = "catalogue")]
            BroadPhaseMethod::BruteForce => Box::new(BruteForce),
            #[cfg(feature = "catalogue")]
            BroadPhaseMethod::SweepAndPrune => Box::new(SweepAndPrune::default()),
            #[cfg(feature = "catalogue")]
            BroadPhaseMethod::SweepAndTiniestQueue => Box::new(SweepAndTiniestQueue::default()),
            #[cfg(feature = "catalogue")]
            BroadPhaseMethod::SweepInStrips => Box::new(SweepInStrips::default()),
            #[cfg(feature = "catalogue")]
            BroadPhaseMethod::UniformGrid => Box::new(UniformGrid::default()),
            other => return Err(Error::NotCompiled { name: other.row().name, backend: "cpu" }),
        };
        Ok(Self::Listed(Listed { source, buffers: Vec::new(), shares: Shares::default() }))
    }

    /// Calls three functions, each with the order of its set: at once where sets share nothing, as
    /// by blocks, else one after the other.
    pub fn each_set(&mut self, threads: &Threads, [a, b, c]: [&mut OfSet; 3]) {
        match self {
            Self::Blocks(source) => {
                let [mut of_a, mut of_b, mut of_c] = source.orders();
                threads.together(|| a(&mut of_a), || b(&mut of_b), || c(&mut of_c));
            }
            _ => [a, b, c].into_iter().for_each(|of_set| of_set(self.order())),
        }
    }

    /// Nodes of binary trees, or pairs of them, that the last search visited.
    pub fn visits(&self) -> u64 {
        match self {
            Self::Blocks(_) => 0,
            #[cfg(feature = "catalogue")]
            Self::Scheduled(source) => source.visits(),
            Self::Listed(source) => source.buffers.iter().map(|Own(buffer)| buffer.0.visits).sum(),
        }
    }

    /// What fronts the last step left; `None` if none are kept.
    pub fn front(&self) -> Option<FrontCounts> {
        match self {
            #[cfg(feature = "catalogue")]
            Self::Scheduled(source) => source.front(),
            _ => None,
        }
    }

    /// See [`Order::tree_statistics`].
    pub fn tree_statistics(&self, threads: &Threads, leaves: &LeafBoxes) -> Option<TreeStatistics> {
        match self {
            Self::Blocks(_) => None,
            #[cfg(feature = "catalogue")]
            Self::Scheduled(source) => source.source().tree_statistics(threads, leaves),
            Self::Listed(Listed { source, .. }) => source.tree_statistics(threads, leaves),
        }
    }

    /// As [`PairSource::find`], of two pairs of sides without a common side, each with its sink.
    /// By blocks workers share the tasks of both.
    pub fn find_two<K: PairSink, L: PairSink<Worker = K::Worker>>(
        &mut self,
        threads: &Threads,
        first: (Sides, &K),
        second: (Sides, &L),
        part: usize,
        workers: &mut [K::Worker],
    ) {
        match self {
            Self::Blocks(source) => source.find_two(threads, first, second, part, workers),
            _ => {
                self.find(threads, first.0, part, first.1, workers);
                self.find(threads, second.0, part, second.1, workers);
            }
        }
    }
}

impl PairSource for Method {
    fn order(&mut self) -> &mut dyn Order {
        match self {
            Self::Blocks(source) => source.order(),
            #[cfg(feature = "catalogue")]
            Self::Scheduled(source) => source.order(),
            Self::Listed(source) => source.order(),
        }
    }

    fn find<K: PairSink>(
        &mut self,
        threads: &Threads,
        sides: Sides,
        part: usize,
        sink: &K,
        workers: &mut [K::Worker],
    ) {
        match self {
            Self::Blocks(source) => source.find(threads, sides, part, sink, workers),
            #[cfg(feature = "catalogue")]
            Self::Scheduled(source) => source.find(threads, sides, part, sink, workers),
            Self::Listed(source) => source.find(threads, sides, part, sink, workers),
        }
    }
}

/// What is done with the order of one set.
pub type OfSet<'a> = dyn FnMut(&mut dyn Order) + Send + 'a;

/// Whether a scheduler or a front was chosen that the method does not have by itself. By blocks
/// self-scheduling without a front is what they do by themselves (`tasks.rs`).
fn is_chosen(scheduling: Scheduling, method: BroadPhaseMethod) -> bool {
    let by_itself = method == BroadPhaseMethod::Blocks
        && scheduling == Scheduling::default().scheduler(Scheduler::SelfScheduling);
    scheduling != Scheduling::default() && !by_itself
}

/// A source that lists rows, and the buffers of its threads.
#[derive(Debug)]
pub struct Listed {
    source: Box<dyn RowSource>,
    buffers: Vec<Own<(Scratch, Vec<Row>)>>,
    shares: Shares,
}

impl PairSource for Listed {
    fn order(&mut self) -> &mut dyn Order {
        &mut *self.source
    }

    fn find<K: PairSink>(
        &mut self,
        threads: &Threads,
        sides: Sides,
        part: usize,
        sink: &K,
        workers: &mut [K::Worker],
    ) {
        self.buffers.iter_mut().for_each(|Own((scratch, _))| scratch.visits = 0);
        if sides.0.is_empty() || sides.1.is_some_and(|b| b.is_empty()) {
            return;
        }
        let n_tasks = self.source.begin(threads, sides);
        let source = &*self.source;
        self.buffers.resize_with(workers.len(), Own::default);
        let run = |k: usize, worker: &mut K::Worker, buffers: &mut Own<(Scratch, Vec<Row>)>| {
            let (k, Own((scratch, list))) = (k * part, buffers);
            sink.begin(worker, k);
            let mut hand_on = |rows: &[Row]| {
                // A task may be all of the search.
                if !threads.stop.is_stopped() {
                    crate::simd::run_rows!(HandOn { rows, sink, worker })
                }
            };
            let mut rows = Rows::new(list, &mut hand_on);
            source.task(k, sides, scratch, &mut rows);
            rows.flush();
        };
        let (n, buffers) = (n_tasks.div_ceil(part), &mut self.buffers);
        self.shares.run(threads, n, workers, buffers, &run, &|worker| sink.end(worker));
    }
}
