//! Schedulers of a device: which workgroup expands which pairs of nodes, of binary trees or of
//! blocks, where the number of pairs below one is not known beforehand.
//!
//! Twin: on a CPU `scheduler/` has a file for each way to share out work.
//!
//! | scheduler | a pair that was found goes to | a worker without pairs |
//! |---|---|---|
//! | `frontier` ([`levels`]) | the list of the next level, a dispatch | takes the next of that |
//! | `static` ([`workers`]) | the worker's own stack | is done |
//! | `prefix-sums` ([`workers`]) | the worker's own stack, by a scan | is done |
//! | `self-scheduling` ([`workers`]) | the worker's own stack | takes the next piece of the tasks |
//! | `balanced` ([`workers`]) | the worker's own stack | is done, until all is dealt out again |
//! | `stealing` ([`workers`]) | its own stack or deque | takes a batch of another's deque |
//! | `lazy-stealing` ([`workers`]) | its own stack or deque | takes ranges of many others' |
//!
//! The first five pass nothing but counters between workgroups inside a dispatch, so that they run
//! wherever WebGPU does. Those that steal need the native path and are refused elsewhere. A search
//! is a number of rounds, recorded one after the other; the host sees whether any pair is left
//! after the last one, and then runs a search of more rounds.
//!
//! Levels are those of binary trees; of blocks they are [`Tree::descend`], and `frontier` with a
//! front is workers without stacks, for either.
//!
//! docs/SCHEDULING.md compares them.
//!
//! [`Tree::descend`]: super::block_bvh::Tree::descend

pub mod levels;
pub mod workers;

use super::descended::{Descended, Written};
use super::worker_counts::Counted;
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use crate::recorder::Recorder;
use ccd_core::model::catalogue::Catalogued;
use ccd_core::model::scheduling::{Front, Scheduler, Scheduling};
use levels::Levels;
use workers::{Rule, Workers};

/// Expands tasks, and all that is found below them, of pairs of one kind.
pub trait Schedule: Send + Sync {
    /// Where tasks are put before [`Schedule::run`]: the counters, of which word 0 says how many,
    /// and the list.
    fn tasks(&self) -> (&wgpu::Buffer, &List);

    /// Clears all counters.
    fn clear(&self, recorder: &mut Recorder);

    /// Records the rounds. What ends goes to the front that is written, if one is.
    fn run(&self, recorder: &mut Recorder, descent: &Descended, written: Written);

    /// Lists that may have to grow.
    fn lists(&self) -> Vec<&List>;

    /// The same, to be replaced by larger ones.
    fn lists_mut(&mut self) -> Vec<&mut List>;

    /// A search is over, and [`List::grow_all`] has seen what was wanted of each list; if it is
    /// `complete`, everything fitted.
    fn settle(&mut self, complete: bool);

    /// What each worker counted in the last search.
    fn counts(&self) -> Option<Counted<'_>>;
}

/// Whether it is level by level, without a front.
pub fn is_by_levels(choice: Scheduling) -> bool {
    let is_frontier = choice.scheduler.is_none_or(|other| other == Scheduler::Frontier);
    is_frontier && choice.front == Front::Off
}

/// The schedule of a choice, for about `n` tasks, of which a worker expands `width` in a turn.
pub fn new(
    device: &Device,
    choice: Scheduling,
    width: u32,
    n: u32,
) -> Result<Box<dyn Schedule>, Error> {
    if is_by_levels(choice) {
        return Ok(Box::new(Levels::new(device, n)?));
    }
    let rule = match choice.scheduler.unwrap_or(Scheduler::Frontier) {
        Scheduler::Frontier => Rule::FRONTIER,
        Scheduler::Static => Rule::STATIC,
        Scheduler::PrefixSums => Rule::PREFIX_SUMS,
        Scheduler::SelfScheduling => Rule::SELF_SCHEDULING,
        Scheduler::Balanced { idle } => Rule { idle, ..Rule::BALANCED },
        Scheduler::Stealing => Rule::STEALING,
        Scheduler::LazyStealing => Rule::LAZY_STEALING,
        other => {
            let name = other.row().name;
            return Err(ccd_core::Error::Method { name, backend: "gpu" }.into());
        }
    };
    Ok(Box::new(Workers::new(device, rule.with(choice.workers)?, width, n)?))
}
