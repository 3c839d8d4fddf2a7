//! Options that choose who expands pairs of nodes, and where a step begins.

use super::Failure;
use super::named::named;
use ccd::method::{Catalogued, Front, FrontOptions, Scheduler, Scheduling, WorkerOptions};
use clap::Args;
use clap::builder::TypedValueParser;

/// Options of schedulers and of fronts; `-h` shows none of them.
#[derive(Args)]
#[command(next_help_heading = "How pairs are found (all find the same contacts)")]
pub struct SchedulingOptions {
    /// How pairs of nodes are shared out among workers, by blocks and by trees with --traversal
    /// simultaneous and cut
    #[arg(long, value_name = "NAME", value_parser = named::<Scheduler>())]
    #[arg(hide_possible_values = true, hide_short_help = true)]
    scheduler: Option<Scheduler>,
    /// Whether a step begins at the pairs of nodes where the one before ended; for the methods of
    /// --scheduler
    #[arg(long, value_name = "NAME", value_parser = named::<Front>(), hide_short_help = true)]
    front: Option<Front>,
    /// Compare the front's length with its length N steps before [default: 16]
    #[arg(long, value_name = "N", allow_negative_numbers = true, hide_short_help = true)]
    #[arg(value_parser = within(1, u32::MAX))]
    front_period: Option<u32>,
    /// Give the front up if it is then below N percent of that length; 0: never [default: 0]
    #[arg(long, value_name = "N", allow_negative_numbers = true, hide_short_help = true)]
    front_threshold: Option<u32>,
    /// Give the front up if it is longer than N percent of its length after a step from the roots
    /// [default: 150]
    #[arg(long, value_name = "N", allow_negative_numbers = true, hide_short_help = true)]
    #[arg(value_parser = within(100, u32::MAX))]
    front_growth: Option<u32>,
    /// Most memory of all fronts in MiB; a longer one is given up [default: 512]
    #[arg(long, value_name = "N", allow_negative_numbers = true, hide_short_help = true)]
    #[arg(value_parser = within(1, FrontOptions::MAX_MEMORY))]
    front_memory: Option<u32>,
    /// Percentage of workers that must be idle for --scheduler balanced to deal out again
    /// [default: 50]
    #[arg(long, value_name = "N", allow_negative_numbers = true, hide_short_help = true)]
    #[arg(value_parser = within(1, 100))]
    idle: Option<u32>,
    /// Workers of --scheduler: threads, never more than --threads; workgroups of a GPU, from 16
    /// to 2048, rounded up to a power of two
    #[arg(long, value_name = "N", allow_negative_numbers = true, hide_short_help = true)]
    #[arg(value_parser = within(1, WorkerOptions::MAX_WORKERS))]
    workers: Option<u32>,
    /// Pairs of nodes that the stack of a GPU's worker holds, at most 1024; those of threads grow
    #[arg(long, value_name = "N", allow_negative_numbers = true, hide_short_help = true)]
    #[arg(value_parser = within(1, WorkerOptions::MAX_STACK))]
    stack: Option<u32>,
    /// Pairs of a batch of --scheduler lazy-stealing, and of stealing on a GPU, at most 64
    #[arg(long, value_name = "N", allow_negative_numbers = true, hide_short_help = true)]
    #[arg(value_parser = within(1, WorkerOptions::MAX_BATCH))]
    batch: Option<u32>,
    /// Length of a stack from which on --scheduler lazy-stealing, and stealing on a GPU, offers a
    /// batch to others, at most 1024
    #[arg(long, value_name = "N", allow_negative_numbers = true, hide_short_help = true)]
    #[arg(value_parser = within(1, WorkerOptions::MAX_STACK))]
    threshold: Option<u32>,
}

/// A parser of whole numbers.
pub fn within(least: u32, most: u32) -> impl TypedValueParser<Value = u32> {
    clap::value_parser!(u32).range(i64::from(least)..=i64::from(most))
}

impl SchedulingOptions {
    /// Scheduler and front.
    pub fn chosen(&self) -> Result<Scheduling, Failure> {
        let scheduler = match (self.scheduler, self.idle) {
            (Some(Scheduler::Balanced { .. }), Some(idle)) => Some(Scheduler::Balanced { idle }),
            (other, Some(_)) => {
                let name = other.map_or("the default", |other| other.row().name);
                return Err(Failure(format!("--idle is for --scheduler balanced, not {name}")));
            }
            (scheduler, None) => scheduler,
        };
        let scheduling =
            Scheduling::default().front(self.front()?).workers(self.workers(scheduler)?);
        Ok(scheduler.map_or(scheduling, |scheduler| scheduling.scheduler(scheduler)))
    }

    /// What was chosen of workers, which a scheduler must have been chosen for.
    fn workers(&self, scheduler: Option<Scheduler>) -> Result<WorkerOptions, Failure> {
        let steals = matches!(scheduler, Some(Scheduler::Stealing | Scheduler::LazyStealing));
        let of_stealing = "--scheduler lazy-stealing, and on a GPU for stealing";
        for (value, option, has, who) in [
            (self.workers, "--workers", scheduler.is_some(), "--scheduler NAME"),
            (self.stack, "--stack", scheduler.is_some(), "--scheduler NAME on a GPU"),
            (self.batch, "--batch", steals, of_stealing),
            (self.threshold, "--threshold", steals, of_stealing),
        ] {
            if value.is_some() && !has {
                return Err(Failure(format!("{option} is for {who}")));
            }
        }
        Ok(WorkerOptions::default()
            .workers(self.workers.unwrap_or(0))
            .stack(self.stack.unwrap_or(0))
            .batch(self.batch.unwrap_or(0))
            .threshold(self.threshold.unwrap_or(0)))
    }

    /// The front, with all that was chosen of it.
    fn front(&self) -> Result<Front, Failure> {
        let given = [
            (self.front_period, "--front-period"),
            (self.front_threshold, "--front-threshold"),
            (self.front_growth, "--front-growth"),
            (self.front_memory, "--front-memory"),
        ];
        match self.front.unwrap_or_default() {
            Front::On(front) => {
                let period = self.front_period.unwrap_or(front.period);
                let threshold = self.front_threshold.unwrap_or(front.threshold);
                let growth = self.front_growth.unwrap_or(front.growth);
                let memory = self.front_memory.unwrap_or(front.memory);
                let front = front.rebuild(period, threshold).growth(growth).memory(memory);
                Ok(Front::On(front))
            }
            other => match given.into_iter().find(|(value, _)| value.is_some()) {
                Some((_, option)) => Err(Failure(format!("{option} is for --front on"))),
                None => Ok(other),
            },
        }
    }
}
