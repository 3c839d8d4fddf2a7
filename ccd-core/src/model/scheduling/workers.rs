//! How many workers a scheduler has, and what each of them holds.

use super::super::error::{Error, check_setting};
use super::{Front, Scheduler, Scheduling};

/// How many workers a [`Scheduler`] has, and what each of them holds. 0 is what the backend takes
/// by itself; what a scheduler does not have is refused.
///
/// ```
/// use ccd::method::{Scheduler, Scheduling, WorkerOptions};
///
/// let few = WorkerOptions::default().workers(2).batch(8);
/// let lazy = Scheduling::default().scheduler(Scheduler::LazyStealing).workers(few);
/// assert_eq!(lazy.lacking("cpu"), None);
/// let lacks = "setting `batch` for this scheduler";
/// assert_eq!(lazy.scheduler(Scheduler::Static).lacking("cpu"), Some(lacks));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[non_exhaustive]
pub struct WorkerOptions {
    /// Workers, at most [`WorkerOptions::MAX_WORKERS`]: threads of a CPU, never more than the
    /// session has; workgroups of a GPU, at least 16, the next power of two.
    pub workers: u32,
    /// Pairs of nodes that the stack of a GPU's worker may hold, at most
    /// [`WorkerOptions::MAX_STACK`]; what does not fit is left to the next round. The stacks of a
    /// CPU grow.
    pub stack: u32,
    /// Pairs of a batch of lazy stealing, and of stealing on a GPU, at most
    /// [`WorkerOptions::MAX_BATCH`]. On blocks of a GPU a 32nd of it, as of the threshold.
    pub batch: u32,
    /// Pairs on a stack from which on a batch of them goes to the deque, at most
    /// [`WorkerOptions::MAX_STACK`]; fewer than two batches count as two.
    pub threshold: u32,
}

impl WorkerOptions {
    /// Most workers.
    pub const MAX_WORKERS: u32 = 2048;
    /// Most pairs of a stack.
    pub const MAX_STACK: u32 = 1024;
    /// Most pairs of a batch.
    pub const MAX_BATCH: u32 = 64;

    /// The same with so many workers.
    pub const fn workers(self, workers: u32) -> Self {
        Self { workers, ..self }
    }

    /// The same with stacks of so many pairs.
    pub const fn stack(self, stack: u32) -> Self {
        Self { stack, ..self }
    }

    /// The same with batches of so many pairs.
    pub const fn batch(self, batch: u32) -> Self {
        Self { batch, ..self }
    }

    /// The same with this threshold.
    pub const fn threshold(self, threshold: u32) -> Self {
        Self { threshold, ..self }
    }

    /// Checks ranges.
    pub(super) fn check(self) -> Result<(), Error> {
        let WorkerOptions { workers, stack, batch, threshold } = self;
        check_setting("workers of a scheduler", workers, 0, WorkerOptions::MAX_WORKERS)?;
        check_setting("pairs of a stack", stack, 0, WorkerOptions::MAX_STACK)?;
        check_setting("pairs of a batch", batch, 0, WorkerOptions::MAX_BATCH)?;
        check_setting("threshold of a stack in pairs", threshold, 0, WorkerOptions::MAX_STACK)?;
        Ok(())
    }
}

impl Scheduling {
    /// The same with these workers.
    pub const fn workers(self, workers: WorkerOptions) -> Self {
        Self { workers, ..self }
    }

    /// The name of what was chosen of workers and a backend's scheduler does not have.
    pub(super) fn lacking_of_workers(self, backend: &str) -> Option<&'static str> {
        let (scheduler, on_gpu) = (self.scheduler, backend == "gpu");
        let is_frontier = scheduler.is_none_or(|other| other == Scheduler::Frontier);
        let steals = scheduler == Some(Scheduler::LazyStealing)
            || on_gpu && scheduler == Some(Scheduler::Stealing);
        // A GPU without scheduler and front expands a level a dispatch.
        let by_levels = on_gpu && is_frontier && self.front == Front::Off;
        let has_workers = scheduler.is_some() && !by_levels;
        let WorkerOptions { workers, stack, batch, threshold } = self.workers;
        [
            (workers > 0 && !has_workers, "setting `workers` for this scheduler"),
            (stack > 0 && (!on_gpu || is_frontier), "setting `stack` for this scheduler"),
            (batch > 0 && !steals, "setting `batch` for this scheduler"),
            (threshold > 0 && !steals, "setting `threshold` for this scheduler"),
        ]
        .into_iter()
        .find_map(|(is_lacking, name)| is_lacking.then_some(name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::method::BroadPhaseMethod;

    #[test]
    fn settings_have_their_ranges() {
        let any = WorkerOptions::default();
        let check = |workers| {
            let scheduling = Scheduling::default().scheduler(Scheduler::Static);
            scheduling.workers(workers).check(BroadPhaseMethod::Blocks)
        };
        assert!(check(any.workers(2048).stack(1024).batch(64).threshold(1024)).is_ok());
        for bad in [any.workers(2049), any.stack(1025), any.batch(65), any.threshold(1025)] {
            assert!(matches!(check(bad), Err(Error::Setting { .. })), "{bad:?}");
        }
    }

    #[test]
    fn what_a_scheduler_does_not_have_is_refused() {
        let any = WorkerOptions::default();
        let [workers, stack, batch] = [any.workers(16), any.stack(9), any.batch(4)];
        let threshold = any.threshold(64);
        let all = [workers, stack, batch, threshold];
        // Which of these each has: on a CPU, on a GPU.
        let table = [
            (None, [false, false, false, false], [false, false, false, false]),
            (Some(Scheduler::Frontier), [true, false, false, false], [false; 4]),
            (Some(Scheduler::Static), [true, false, false, false], [true, true, false, false]),
            (Some(Scheduler::Stealing), [true, false, false, false], [true; 4]),
            (Some(Scheduler::LazyStealing), [true, false, true, true], [true; 4]),
        ];
        for (scheduler, on_cpu, on_gpu) in table {
            for (backend, want) in [("cpu", on_cpu), ("gpu", on_gpu)] {
                let has = all.map(|workers| {
                    let scheduling = Scheduling { scheduler, ..Scheduling::default() };
                    scheduling.workers(workers).lacking(backend).is_none()
                });
                assert_eq!(has, want, "{scheduler:?}, {backend}");
            }
        }
        let frontier = Scheduling::default().scheduler(Scheduler::Frontier).front(Front::ON);
        assert_eq!(frontier.workers(workers).lacking("gpu"), None);
    }
}
