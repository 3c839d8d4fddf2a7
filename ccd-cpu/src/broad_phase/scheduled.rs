//! A source of pairs of nodes and the scheduler that was chosen for it, with a front or without
//! one: what joins both into a source of pairs.

use crate::broad_phase::descend::{Descend, Pairs, PairsOfNodes, Traces};
use crate::broad_phase::descent_times::{DescentTimes, WorkerTimes};
use crate::broad_phase::front::{Fronts, List};
use crate::broad_phase::leaf_boxes::{Order, Sides};
use crate::broad_phase::pair_source::{PairSink, PairSource};
use crate::broad_phase::rows::{Gathered, HandOn, Row, Rows};
use crate::broad_phase::scheduler::abp_stealing::abp_stealing;
use crate::broad_phase::scheduler::balanced::{Balanced, NEVER};
use crate::broad_phase::scheduler::frontier::Frontier;
use crate::broad_phase::scheduler::lazy_stealing::LazyStealing;
use crate::broad_phase::scheduler::self_scheduling::SelfScheduling;
use crate::broad_phase::scheduler::shared_queue::{self, blocking, lock_free};
use crate::broad_phase::scheduler::stealing::{self, stealing};
use crate::broad_phase::scheduler::{Hand, Lists, PAIRS_OF_NODES, Schedule};
use crate::broad_phase::tasks::{MIN_TASKS, Shares};
use crate::clock::{Instant, milliseconds};
use crate::stop::Stop;
use crate::threads::{Own, Threads};
use ccd_core::Error;
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use ccd_core::model::catalogue::Catalogued;
use ccd_core::model::report::FrontCounts;
use ccd_core::model::scheduling::{Front, Scheduler, Scheduling, WorkerOptions};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// Finds pairs by a scheduler.
#[derive(Debug)]
pub struct Scheduled {
    source: Box<dyn PairsOfNodes>,
    descent: Descent,
    buffers: Vec<Own<Buffers>>,
    /// Workers that share out pairs, at most; 0: as many as there are.
    most_workers: usize,
    /// Rows in order, for sinks that want one.
    rows: Vec<Row>,
    shares: Shares,
    /// Times of all descents since this was set.
    times: Option<DescentTimes>,
}

/// The part of a search that does not depend on the sink.
#[derive(Debug)]
struct Descent {
    schedule: Box<dyn Schedule>,
    fronts: Option<Fronts>,
    tasks: Vec<NodePair>,
    next: Vec<NodePair>,
    /// Pairs of a front, as each worker reads them, and what of them is to be expanded.
    pieces: Lists,
    resumed: Lists,
    n_split: u64,
}

/// Buffers and counts of a worker.
#[derive(Debug, Default)]
struct Buffers {
    worker: usize,
    list: Vec<Row>,
    /// All rows that it found, if they are to be put in order.
    all: Vec<Row>,
    n_expanded: u64,
    times: WorkerTimes,
}

/// Where a worker's rows go.
struct Outlet<'o, 'r, 'a> {
    worker: usize,
    rows: &'o mut Gathered<'r, 'a>,
    n_expanded: &'o mut u64,
    /// Of this worker, if the clock is asked.
    times: Option<&'o WorkerTimes>,
}

impl Scheduled {
    /// A source with the scheduler and the front that were chosen.
    pub fn new(source: Box<dyn PairsOfNodes>, choice: Scheduling) -> Result<Self, Error> {
        let descent = Descent {
            schedule: scheduler_of(choice.scheduler.unwrap_or_default(), choice.workers)?,
            fronts: match choice.front {
                Front::On(options) => Some(Fronts::new(options)),
                _ => None,
            },
            tasks: Vec::new(),
            next: Vec::new(),
            pieces: Lists::default(),
            resumed: Lists::default(),
            n_split: 0,
        };
        let (buffers, rows, shares) = (Vec::new(), Vec::new(), Shares::default());
        let most_workers = choice.workers.workers as usize;
        Ok(Self { source, descent, buffers, most_workers, rows, shares, times: None })
    }

    /// From now on, whether the clock is asked where the time of descents goes; from zero.
    pub fn set_timed(&mut self, timed: bool) {
        self.times = timed.then(DescentTimes::default);
    }

    /// Times since [`Scheduled::set_timed`]; `None` if the clock is not asked.
    pub fn times(&self) -> Option<DescentTimes> {
        self.times
    }

    /// Pairs of nodes that the last search expanded.
    pub fn visits(&self) -> u64 {
        let by_workers = self.buffers.iter().map(|Own(buffer)| buffer.n_expanded).sum::<u64>();
        self.descent.n_split + by_workers
    }

    /// The same of each worker.
    #[cfg(test)]
    pub fn visits_by_worker(&self) -> Vec<u64> {
        self.buffers.iter().map(|Own(buffer)| buffer.n_expanded).collect()
    }

    /// What fronts the last step left, if any are kept.
    pub fn front(&self) -> Option<FrontCounts> {
        self.descent.fronts.as_ref().map(Fronts::counts)
    }

    /// The source itself.
    pub fn source(&self) -> &dyn PairsOfNodes {
        &*self.source
    }
}

impl PairSource for Scheduled {
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
        let Self { source, descent, buffers, most_workers, rows, shares, times } = self;
        descent.n_split = 0;
        prepare(buffers, workers.len());
        if sides.0.is_empty() || sides.1.is_some_and(|b| b.is_empty()) {
            return;
        }
        let sets = [Some(sides.0.set().index), sides.1.map(|b| b.set().index)];
        let timed = times.is_some();
        let n = if *most_workers == 0 { workers.len() } else { workers.len().min(*most_workers) };
        source.descend(threads, sides, &mut |pairs| {
            descent.run((n, &threads.stop), sets, pairs, part, times, &mut |job| {
                let (workers, buffers) = (&mut workers[..n], &mut buffers[..n]);
                threads.each_with(workers, buffers, &|_, worker, Own(buffer)| {
                    let mut hand_on =
                        |rows: &[Row]| crate::simd::run_rows!(HandOn { rows, sink, worker });
                    buffer.work(K::ORDERED, timed, &threads.stop, &mut hand_on, job);
                });
            });
        });
        if let Some(times) = times {
            times.add_workers(buffers.iter().map(|Own(buffer)| &buffer.times));
        }
        if K::ORDERED {
            put_in_order(threads, buffers, rows);
            let run = |k: usize, worker: &mut K::Worker, _: &mut Own<Buffers>| {
                sink.begin(worker, k);
                let rows = &rows[k * Rows::CAPACITY..((k + 1) * Rows::CAPACITY).min(rows.len())];
                crate::simd::run_rows!(HandOn { rows, sink, worker });
            };
            let n = rows.len().div_ceil(Rows::CAPACITY);
            shares.run(threads, n, workers, buffers, &run, &|worker| sink.end(worker));
        } else {
            threads.each(workers, &|_, worker| sink.end(worker));
        }
    }
}

/// The scheduler of a choice, if there is one here.
pub fn scheduler_of(choice: Scheduler, options: WorkerOptions) -> Result<Box<dyn Schedule>, Error> {
    Ok(match choice {
        Scheduler::SelfScheduling => Box::new(SelfScheduling::default()),
        Scheduler::Frontier => Box::new(Frontier::default()),
        Scheduler::Static => Box::new(Balanced::new(NEVER)),
        Scheduler::Balanced { idle } => Box::new(Balanced::new(idle)),
        Scheduler::BlockingQueue => Box::new(blocking(shared_queue::CAPACITY)),
        Scheduler::LockFreeQueue => Box::new(lock_free(shared_queue::CAPACITY)),
        Scheduler::Stealing => Box::new(stealing(stealing::CAPACITY)),
        Scheduler::StealingAbp => Box::new(abp_stealing(stealing::CAPACITY)),
        Scheduler::LazyStealing => Box::new(LazyStealing::new(LazyStealing::CAPACITY, options)),
        other => return Err(Error::Method { name: other.row().name, backend: "cpu" }),
    })
}

/// Most pairs of nodes that one is expanded to: of eight boxes with eight.
const MOST_CHILDREN: usize = 64;
/// The name of lists in [`Error::Memory`].
const ROWS: &str = "rows of overlaps";

/// Does something with the outlet of every worker.
type Work<'w> = &'w (dyn Fn(&mut Outlet) + Sync);

impl Descent {
    /// Finds all pairs of leaves, or those below every `part`-th task.
    fn run(
        &mut self,
        (n_workers, stop): (usize, &Stop),
        sets: [Option<usize>; 2],
        pairs: Pairs,
        part: usize,
        times: &mut Option<DescentTimes>,
        launch: &mut dyn FnMut(Work),
    ) {
        let mut watch = Watch { times, last: Instant::now() };
        let Self { schedule, fronts, tasks, next, pieces, resumed, n_split } = self;
        let Pairs { tree, roots, builds } = pairs;
        // A sample leaves no front, and must not begin at one: tasks are to be the same as ever.
        let fronts_at = fronts.as_mut().filter(|_| part == 1).map(|fronts| {
            let at = fronts.of(sets, builds, n_workers);
            (&mut *fronts, at)
        });
        let front = fronts_at.as_ref().map(|(fronts, at)| fronts.at(*at));
        let written = front.and_then(|front| front.next());
        tasks.clear();
        if let Some(kept) = front.and_then(|front| front.kept()) {
            pieces.prepare(n_workers);
            resumed.prepare(n_workers);
            resume(tree, kept, written, [pieces, resumed], stop, launch);
            resumed.gather(tasks, stop);
            watch.lap(|times| &mut times.shared_out);
        } else {
            tasks.extend_from_slice(roots);
            let mut writer = written.map(|list| list.writer(0));
            tree.keep_meeting(tasks, &mut writer);
            loop {
                if tasks.is_empty() || tasks.len() >= MIN_TASKS {
                    break;
                }
                next.clear();
                let n = tree.split(tasks, next, &mut writer);
                std::mem::swap(tasks, next);
                *n_split += n;
                if n == 0 {
                    break;
                }
            }
            every(part, tasks);
            watch.last = Instant::now();
        }
        schedule.run(n_workers, tasks, stop, &mut |job| {
            launch(&|outlet| {
                let Outlet { worker, rows, n_expanded, times } = outlet;
                let front = written.map(|list| list.writer(*worker));
                let mut traces = Traces { rows, front, n_expanded: 0 };
                let mut expand = |pairs: &[NodePair], out: &mut Vec<NodePair>| {
                    let capacity = pairs.len() * MOST_CHILDREN;
                    if stop.is_stopped() || !stop.reserve(PAIRS_OF_NODES, out, capacity) {
                        return;
                    }
                    let mut expand = || tree.expand(pairs, out, &mut traces);
                    match times {
                        Some(times) => times.expanding(expand),
                        None => expand(),
                    }
                };
                job(&mut Hand { worker: *worker, expand: &mut expand });
                **n_expanded += traces.n_expanded;
            });
        });
        watch.lap(|times| &mut times.shared_out);
        // Of a search that is not complete no front is kept; that of the one before still holds.
        if let Some((fronts, at)) = fronts_at.filter(|_| !stop.is_stopped()) {
            fronts.end(at, stop);
        }
        watch.lap(|times| &mut times.keep);
    }
}

/// A stopwatch; does nothing if the clock is not asked.
struct Watch<'t> {
    times: &'t mut Option<DescentTimes>,
    last: Instant,
}

impl Watch<'_> {
    fn lap(&mut self, sum: impl FnOnce(&mut DescentTimes) -> &mut f64) {
        if let Some(times) = self.times {
            *sum(times) += milliseconds(self.last);
            self.last = Instant::now();
        }
    }
}

/// Begins at the front of the step before: pairs to be expanded go to `resumed`, the others to the
/// front of this step.
fn resume(
    tree: &dyn Descend,
    kept: &List,
    written: Option<&List>,
    [pieces, resumed]: [&Lists; 2],
    stop: &Stop,
    launch: &mut dyn FnMut(Work),
) {
    let counter = AtomicUsize::new(0);
    launch(&|outlet| {
        let (mut piece, mut out) = (pieces.of(outlet.worker), resumed.of(outlet.worker));
        let front = written.map(|list| list.writer(outlet.worker));
        let mut traces = Traces { rows: outlet.rows, front, n_expanded: 0 };
        loop {
            let k = counter.fetch_add(1, Relaxed);
            if k >= kept.n_pieces() {
                break;
            }
            piece.clear();
            kept.piece(k, &mut piece);
            if stop.is_stopped() || !stop.reserve(PAIRS_OF_NODES, &mut out, piece.len()) {
                break;
            }
            let mut resume = || tree.resume(&piece, &mut out, &mut traces);
            match outlet.times {
                Some(times) => times.front(resume),
                None => resume(),
            }
        }
        *outlet.n_expanded += traces.n_expanded;
    });
}

/// Keeps the tasks `0`, `part`, `2 part` ..
fn every(part: usize, tasks: &mut Vec<NodePair>) {
    let n = tasks.len().div_ceil(part);
    for k in 0..n {
        tasks[k] = tasks[k * part];
    }
    tasks.truncate(n);
}

fn prepare(buffers: &mut Vec<Own<Buffers>>, n_workers: usize) {
    buffers.resize_with(n_workers, Own::default);
    for (worker, Own(buffer)) in buffers.iter_mut().enumerate() {
        (buffer.worker, buffer.n_expanded, buffer.times) = (worker, 0, WorkerTimes::default());
        buffer.all.clear();
    }
}

impl Buffers {
    /// Does work whose rows are handed on, or kept if they are to be put in order.
    fn work(
        &mut self,
        keep: bool,
        timed: bool,
        stop: &Stop,
        hand_on: &mut (dyn FnMut(&[Row]) + Send),
        work: Work,
    ) {
        let Self { worker, list, all, n_expanded, times } = self;
        let mut keep_them = |rows: &[Row]| {
            if stop.reserve(ROWS, all, rows.len()) {
                all.extend_from_slice(rows);
            }
        };
        let times = timed.then_some(&*times);
        let mut timed = |rows: &[Row]| match times {
            Some(times) => times.rows(|| hand_on(rows)),
            None => hand_on(rows),
        };
        let mut rows = Rows::new(list, if keep { &mut keep_them } else { &mut timed });
        let mut gathered = Gathered::new(&mut rows);
        work(&mut Outlet { worker: *worker, rows: &mut gathered, n_expanded, times });
        gathered.finish();
        rows.flush();
    }
}

/// All rows by leaf and block, each once: an order that depends on boxes alone.
fn put_in_order(threads: &Threads, buffers: &mut [Own<Buffers>], rows: &mut Vec<Row>) {
    rows.clear();
    for Own(buffer) in buffers {
        if threads.stop.reserve(ROWS, rows, buffer.all.len()) {
            rows.append(&mut buffer.all);
        }
    }
    threads.sort(rows, |row| (row.a, row.b, row.mask));
    rows.dedup_by(|next, row| {
        let same = (next.a, next.b) == (row.a, row.b);
        if same {
            row.mask |= next.mask;
        }
        same
    });
}
