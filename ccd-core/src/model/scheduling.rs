//! Who descends which pairs of nodes, and where a step begins to: choices for methods that descend
//! pairs of nodes, the third beside method and pipeline. What each is is said in
//! [`catalogue`](super::catalogue).

use super::catalogue::{CPU, Catalogued, GPU, Row};
use super::error::{Error, check_setting};
use super::method::{BroadPhaseMethod, Traversal, TreeOptions};

mod workers;

pub use workers::WorkerOptions;

/// How pairs of nodes are shared out among workers, and whether the pairs at which a step ended
/// begin the next one; results do not depend on it.
///
/// It is for methods that descend pairs of nodes: blocks, and trees with the traversals
/// `simultaneous` and `cut`. Others make a query per box, or sort; they are refused with anything
/// but the default.
///
/// ```
/// use ccd::method::{BroadPhaseMethod, Front, Scheduler, Scheduling};
///
/// let stealing = Scheduling::default().scheduler(Scheduler::Stealing).front(Front::ON);
/// assert!(stealing.check(BroadPhaseMethod::Blocks).is_ok());
/// assert!(stealing.check(BroadPhaseMethod::SweepAndPrune).is_err());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[non_exhaustive]
pub struct Scheduling {
    /// `None`: as the method does it by itself. That is [`Scheduler::SelfScheduling`] on a CPU, of
    /// blocks with a share of neighbours for each worker [Markatos 1994], but for `simultaneous`,
    /// which one thread does; and [`Scheduler::Frontier`] on a GPU.
    pub scheduler: Option<Scheduler>,
    /// Where a step begins.
    pub front: Front,
    /// How many workers there are, and what each holds.
    pub workers: WorkerOptions,
}

/// How pairs of nodes that are to be expanded, of which nobody knows beforehand how many are below
/// them, are shared out among workers: threads of a CPU, workgroups of a GPU.
///
/// ```
/// use ccd::method::{Catalogued, Scheduler};
///
/// assert_eq!(Scheduler::named("stealing"), Some(Scheduler::Stealing));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum Scheduler {
    /// The upper levels are expanded into some thousand tasks; workers take the next one from a
    /// shared counter, and finish it [Tang 1986]. Of blocks on a CPU each begins with a share of
    /// neighbours instead, and then takes half of another's [Markatos 1994].
    #[default]
    SelfScheduling,
    /// All pairs of a level, then all of the next: no worker needs to know of another within a
    /// level, and all wait between two.
    Frontier,
    /// The tasks are dealt out evenly at the beginning, and nobody takes another's.
    Static,
    /// The same, until too many workers are idle; then all stop, and what is left is dealt out
    /// again [Lauterbach 2010].
    Balanced {
        /// Of all workers, in percent, so many must be idle: 1 to 100.
        idle: u32,
    },
    /// As [`Scheduler::Static`], but what the threads of a worker find is moved together by prefix
    /// sums of their counts, and not by a counter to which each adds; on a GPU [da Silva 2013].
    PrefixSums,
    /// All workers share one queue behind a lock: each takes the first pair and appends what it
    /// finds [Cederman 2009]; on a CPU.
    BlockingQueue,
    /// The same, lock-free: no worker waits for another [Cederman 2009], [Nikolaev 2019].
    LockFreeQueue,
    /// Every worker has a deque: its owner pushes and pops at one end, and whose own is empty takes
    /// from the other end of another's [Arora 1998], [Cederman 2009].
    Stealing,
    /// The same, by the deque as it is printed: its bottom in one word, its top with a tag in
    /// another, and fences [Arora 1998]; on a CPU.
    StealingAbp,
    /// Every worker has a stack of its own, and a deque for what is too much for it: pairs move in
    /// batches, and of batches that were stolen at once, one after the other is fetched when it is
    /// needed [da Silva 2013].
    LazyStealing,
}

impl Scheduler {
    /// [`Scheduler::Balanced`] when half of the workers are idle.
    pub const BALANCED: Self = Self::Balanced { idle: 50 };
}

/// Where the descent of a step begins.
///
/// ```
/// use ccd::method::{Front, FrontOptions, Scheduling};
///
/// let kept = Scheduling::default().front(Front::ON);
/// assert_eq!(kept.front, Front::On(FrontOptions::default()));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum Front {
    /// At the pair of roots.
    #[default]
    Off,
    /// At the pairs of nodes where the descent of the step before ended, its front [Tang 2010a], if
    /// the trees are still those: refitted, not built anew.
    On(FrontOptions),
}

impl Front {
    /// [`Front::On`] as it is by default.
    pub const ON: Self = Self::On(FrontOptions::DEFAULT);
}

/// When a front is given up: dropped, so that the next step begins at the roots and leaves a new
/// one.
///
/// Pairs that meet are replaced by those below them; pairs that separate stay where they are, so
/// that a front only gets deeper. One that is too deep is more work than it saves.
///
/// ```
/// use ccd::method::{Front, FrontOptions, Scheduling};
///
/// let kept = FrontOptions::default().growth(200).memory(64);
/// assert_ne!(Scheduling::default().front(Front::On(kept)), Scheduling::default());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[non_exhaustive]
pub struct FrontOptions {
    /// Steps `p` after which the number of pairs is compared with that of `p` steps before, at
    /// least 1 [da Silva 2013].
    pub period: u32,
    /// The front is given up if it has then become less than this many times as large, in percent:
    /// it did not change much, so that it is taken to be deeper than the scene asks for, `rt`
    /// there. 0: never.
    pub threshold: u32,
    /// The front is given up once it is this many times as large, in percent, as the last one that
    /// began at the roots: 100 or more.
    pub growth: u32,
    /// Most memory for all fronts of a session, in MiB, 1 to [`FrontOptions::MAX_MEMORY`]. A front
    /// that would take more is dropped: the next step begins at the roots.
    pub memory: u32,
}

impl FrontOptions {
    const DEFAULT: Self = Self { period: 16, threshold: 0, growth: 150, memory: 512 };
    /// Most MiB of a front: 64 GiB.
    pub const MAX_MEMORY: u32 = 1 << 16;

    /// The same with this period and this threshold in percent.
    pub const fn rebuild(self, period: u32, threshold: u32) -> Self {
        Self { period, threshold, ..self }
    }

    /// The same with this bound of its growth in percent.
    pub const fn growth(self, growth: u32) -> Self {
        Self { growth, ..self }
    }

    /// The same with this bound of its memory in MiB.
    pub const fn memory(self, memory: u32) -> Self {
        Self { memory, ..self }
    }
}

impl Default for FrontOptions {
    fn default() -> Self {
        Self::DEFAULT
    }
}

impl Scheduling {
    /// The same with this scheduler.
    pub const fn scheduler(self, scheduler: Scheduler) -> Self {
        Self { scheduler: Some(scheduler), ..self }
    }

    /// The same with this front.
    pub const fn front(self, front: Front) -> Self {
        Self { front, ..self }
    }

    /// Checks settings that have a range, and that the method descends pairs of nodes if anything
    /// was chosen.
    ///
    /// # Errors
    /// [`Error::Setting`]; [`Error::NoPairsOfNodes`].
    pub fn check(self, method: BroadPhaseMethod) -> Result<(), Error> {
        if let Some(Scheduler::Balanced { idle }) = self.scheduler {
            check_setting("idle workers in percent", idle, 1, 100)?;
        }
        if let Front::On(front) = self.front {
            check_setting("period of the front", front.period, 1, u32::MAX)?;
            check_setting("growth of the front in percent", front.growth, 100, u32::MAX)?;
            check_setting("memory of the front in MiB", front.memory, 1, FrontOptions::MAX_MEMORY)?;
        }
        self.workers.check()?;
        if self == Self::default() || descends_pairs(method) {
            return Ok(());
        }
        let name = match method {
            BroadPhaseMethod::Tree(TreeOptions { traversal, .. }) => traversal.row().name,
            other => other.row().name,
        };
        Err(Error::NoPairsOfNodes { method: name })
    }

    /// Whether a backend has the scheduler, the front, and what was chosen of its workers; if not,
    /// the name of what it lacks.
    pub fn lacking(self, backend: &str) -> Option<&'static str> {
        let scheduler = self.scheduler.and_then(|scheduler| scheduler.row().lacking(backend));
        let front = || self.front.row().lacking(backend).map(|_| "front");
        scheduler.or_else(front).or_else(|| self.lacking_of_workers(backend))
    }

    /// Every scheduler of a backend, with a front and without one.
    pub fn every(backend: &str) -> impl Iterator<Item = Self> {
        let all = Scheduler::ROWS.iter().flat_map(|row| {
            let scheduling = Self::default().scheduler(row.value);
            Front::ROWS.iter().map(move |row| scheduling.front(row.value))
        });
        all.filter(move |scheduling| scheduling.lacking(backend).is_none())
    }
}

/// Whether a method descends pairs of nodes.
fn descends_pairs(method: BroadPhaseMethod) -> bool {
    match method {
        BroadPhaseMethod::Blocks => true,
        BroadPhaseMethod::Tree(TreeOptions { traversal, .. }) => {
            matches!(traversal, Traversal::Simultaneous(_) | Traversal::Cut { .. })
        }
        _ => false,
    }
}

/// The name of the scheduler on a command line, and whether there is a front.
impl core::fmt::Display for Scheduling {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.scheduler.map_or("default", |scheduler| scheduler.row().name))?;
        f.write_str(if self.front == Front::Off { "" } else { "-front" })
    }
}

impl Catalogued for Scheduler {
    const ALWAYS: &'static [&'static str] = &["self-scheduling"];
    const ROWS: &'static [Row<Self>] = &[
        Row::new(Self::SelfScheduling, "self-scheduling")
            .about("Workers take some thousand tasks, one after the other, from a shared counter")
            .source("Tang 1986"),
        Row::new(Self::Frontier, "frontier")
            .about("Queues by level: all pairs of one, then all of the next"),
        Row::new(Self::Static, "static")
            .about("Tasks are dealt out at the beginning")
            .source("Cederman 2009"),
        Row::new(Self::BALANCED, "balanced")
            .about("Dealt out, and dealt out again whenever too many workers are idle")
            .source("Lauterbach 2010"),
        Row::new(Self::PrefixSums, "prefix-sums")
            .about("As static; places of results are prefix sums instead of atomic counters")
            .source("da Silva 2013")
            .on(GPU),
        Row::new(Self::BlockingQueue, "blocking-queue")
            .about("One queue of all workers behind a lock, which a workgroup must not wait for")
            .source("Cederman 2009")
            .on(CPU),
        Row::new(Self::LockFreeQueue, "lock-free-queue")
            .about("The same without a lock; tries again until it succeeds, which no kernel may do")
            .source("Cederman 2009")
            .on(CPU),
        Row::new(Self::Stealing, "stealing")
            .about("A deque per worker; idle workers steal from others; GPU: passthrough only")
            .source("Arora 1998"),
        Row::new(Self::StealingAbp, "stealing-abp")
            .about("Stealing by the deque as published; it needs fences that kernels of a GPU lack")
            .source("Arora 1998")
            .on(CPU),
        Row::new(Self::LazyStealing, "lazy-stealing")
            .about("Stacks and deques; batches stolen, fetched singly; GPU: passthrough only")
            .source("da Silva 2013"),
    ];
}

impl Catalogued for Front {
    const ALWAYS: &'static [&'static str] = &["off"];
    const ROWS: &'static [Row<Self>] = &[
        Row::new(Self::Off, "off").about("Every step begins at the roots"),
        Row::new(Self::ON, "on")
            .about("A step begins at the pairs of nodes where the one before ended")
            .source("Tang 2010a"),
    ];
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::catalogue::every;

    #[test]
    fn what_descends_no_pairs_is_refused_with_the_reason() {
        let chosen = [
            Scheduling::default().scheduler(Scheduler::SelfScheduling),
            Scheduling::default().front(Front::ON),
        ];
        let mut n_taken = 0;
        for method in every("cpu") {
            assert_eq!(Scheduling::default().check(method), Ok(()), "{method}");
            for scheduling in chosen {
                match scheduling.check(method) {
                    Ok(()) => n_taken += 1,
                    Err(e) => {
                        let text = std::format!("{e}");
                        assert!(text.contains("pairs of nodes"), "{method}: {text}");
                        assert!(!descends_pairs(method));
                    }
                }
            }
        }
        assert!(n_taken > 2, "{n_taken}");
        for scheduling in Scheduling::every("cpu") {
            assert_eq!(scheduling.check(BroadPhaseMethod::default()), Ok(()));
        }
    }

    #[test]
    fn settings_have_their_ranges() {
        let check = |scheduling: Scheduling| scheduling.check(BroadPhaseMethod::Blocks);
        let balanced = |idle| Scheduling::default().scheduler(Scheduler::Balanced { idle });
        assert!(check(balanced(1)).is_ok() && check(balanced(100)).is_ok());
        let front = |front| check(Scheduling::default().front(Front::On(front)));
        let fine = FrontOptions::default();
        assert!(front(fine).is_ok() && front(fine.growth(100).memory(1).rebuild(1, 0)).is_ok());
        let bad = [
            check(balanced(0)),
            check(balanced(101)),
            front(fine.growth(99)),
            front(fine.memory(0)),
            front(fine.memory(FrontOptions::MAX_MEMORY + 1)),
            front(fine.rebuild(0, 100)),
        ];
        for result in bad {
            assert!(matches!(result, Err(Error::Setting { .. })), "{result:?}");
        }
    }

    #[test]
    fn a_backend_has_all_or_says_what_it_lacks() {
        // All but prefix sums.
        assert_eq!(Scheduling::every("cpu").count(), 2 * (Scheduler::ROWS.len() - 1));
        // All but queues that workers share, and the deque with fences.
        assert_eq!(Scheduling::every("gpu").count(), 2 * (Scheduler::ROWS.len() - 3));
        assert_eq!(Scheduling::default().lacking("gpu"), None);
        let cpu_alone =
            [Scheduler::BlockingQueue, Scheduler::LockFreeQueue, Scheduler::StealingAbp];
        for only in cpu_alone {
            let name = Scheduling::default().scheduler(only).lacking("gpu").expect("refused");
            let error = std::format!("{}", Error::Method { name, backend: "gpu" });
            assert!(error.contains(": its "), "no reason: {error}");
        }
        let front = Scheduling::default().front(Front::ON);
        assert_eq!(front.lacking("cpu"), None);
        assert_eq!(front.lacking("abacus"), Some("front"));
        assert_eq!(front.scheduler(Scheduler::Static).lacking("abacus"), Some("static"));
    }
}
