//! All interleavings of owners and thieves, within stated bounds, at the deques of `ccd-core`; and
//! at the printed ones, which the checker must refute.
//!
//! Every model runs in a process of its own, so that one that is refuted, or takes too long, ends
//! without the others. With `CCD_WHOLE=1` (`cargo xtask loom --whole`) the bounds are those of
//! docs/SCHEDULING.md, which takes minutes, instead of two preemptions.

mod kernels;
mod models;
mod printed;
mod queues;
mod words;

use ccd_core::backend::scheduling::stealing::Workers;
use kernels::{ENOUGH, Fault, Round, kernel};
use libtest_mimic::{Arguments, Failed, Trial};
use models::{EXECUTIONS, Ring, Steals, deque, workers};
use printed::{Abp, Defect, Lazy};
use queues::queue;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::{Command, ExitCode, Stdio};
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

/// Time for all models, on two idle cores.
const LIMIT: Duration = Duration::from_secs(300);
/// Printed by a model when all executions were as they should be.
const SOUND: &str = "every item once";
/// Preemptions of sound models without `CCD_WHOLE`: each defect below is seen with fewer.
const FEW: usize = 2;
/// The name of a model, for the process that runs it.
const MODEL: &str = "CCD_MODEL";

/// A model with its bounds and the result that it must have.
struct Model {
    name: &'static str,
    /// Most preemptions; `None`: all that make a difference.
    preemptions: Option<usize>,
    /// Panic that some execution must end with; `None`: every item once, in every execution.
    refuted: Option<&'static str>,
    run: fn(),
}

const ALL: Option<usize> = None;

const fn sound(name: &'static str, preemptions: Option<usize>, run: fn()) -> Model {
    Model { name, preemptions, refuted: None, run }
}

const fn refuted(
    name: &'static str,
    preemptions: Option<usize>,
    what: &'static str,
    run: fn(),
) -> Model {
    Model { name, preemptions, refuted: Some(what), run }
}

impl Model {
    fn bound(&self) -> Option<usize> {
        match (self.refuted, std::env::var("CCD_WHOLE").is_ok_and(|v| v == "1")) {
            (None, false) => Some(self.preemptions.map_or(FEW, |n| n.min(FEW))),
            _ => self.preemptions,
        }
    }
}

/// Two workers of a kernel that look around twice before they retire, or once if all are idle.
const ROUND: Round =
    Round { workers: of(2), depth: 2, most: 0, patience: 2, turns: ENOUGH, fault: None };

/// Workers whose deques hold two batches of one item each.
const fn of(n: u32) -> Workers {
    Workers { n, batches: 2, batch: 1 }
}

/// What takes longest comes first. Of a deque: its ring; what its owner does, which is to push a
/// batch of so many items or, 0, to pop one; and its thieves.
const MODELS: &[Model] = &[
    // Whole workers, until all have retired.
    sound("three-workers-task", Some(3), || workers(of(3), Steals::Task, 2)),
    sound("three-workers-lazy", Some(3), || workers(of(3), Steals::Lazily(2), 2)),
    // One deque: an owner and two thieves.
    sound("two-thieves", ALL, || deque(Ring::of(2, 1), &[1, 1], &[(1, 1), (1, 1)])),
    sound("ranges", Some(3), || deque(Ring::of(2, 1), &[1, 1, 1, 0, 1], &[(1, 2), (1, 2)])),
    sound("batches", Some(3), || deque(Ring::of(4, 2), &[2, 1, 0, 2], &[(1, 1), (1, 2)])),
    // The word of the ends takes the same values again and again.
    sound("old-values", Some(3), || {
        deque(Ring::of(2, 1), &[1, 0, 1, 0, 1, 0, 1], &[(1, 1), (1, 1)])
    }),
    // The ring is written over again, while a thief reads.
    sound("ring", ALL, || deque(Ring::of(2, 1), &[1, 1, 1], &[(2, 1)])),
    sound("longer-ring", Some(5), || deque(Ring::of(2, 1), &[1, 1, 1, 1, 1], &[(3, 1)])),
    sound("workers-task", ALL, || workers(of(2), Steals::Task, 2)),
    sound("workers-lazy", ALL, || workers(of(2), Steals::Lazily(2), 2)),
    // What kernels do: `try_pop`, retirement when all are idle, the drain, tasks (`most` 0).
    sound("kernel-task", Some(2), || kernel(ROUND)),
    sound("kernel-lazy", Some(2), || kernel(Round { most: 2, ..ROUND })),
    sound("kernel-task-drains", Some(3), || kernel(Round { turns: 3, ..ROUND })),
    sound("kernel-lazy-drains", Some(3), || kernel(Round { turns: 3, most: 2, ..ROUND })),
    // One queue of all workers.
    sound("queue", Some(3), || queue(2, &[&[1], &[1]], false)),
    sound("queue-laps", Some(3), || queue(1, &[&[1, 1], &[1]], false)),
    sound("queue-three-workers", Some(2), || queue(2, &[&[1], &[], &[]], false)),
    refuted("queue-without-acquire", ALL, "half of an item", || queue(2, &[&[1], &[]], true)),
    // As printed; the same scenes of what is sound.
    refuted("printed-3.13", ALL, "was taken 2 times", || deque(Lazy, &[3], &[(1, 1)])),
    sound("in-place-of-3.13", ALL, || deque(Ring::of(4, 1), &[1, 1, 1], &[(1, 1)])),
    sound("abp", ALL, || deque(Abp(None), &[2], &[(3, 1)])),
    sound("abp-two-thieves", Some(3), || deque(Abp(None), &[2, 0, 1], &[(1, 1), (1, 1)])),
    sound("abp-resets", Some(5), || deque(Abp(None), &[1, 0, 1, 0, 1], &[(2, 1)])),
    refuted("abp-without-fence-of-pop", ALL, "was taken 2 times", || {
        deque(Abp(Some(Defect::FenceOfPop)), &[2], &[(2, 1)])
    }),
    refuted("abp-without-fence-of-steal", ALL, "was taken 2 times", || {
        deque(Abp(Some(Defect::FenceOfSteal)), &[2], &[(2, 1)])
    }),
    refuted("abp-without-fence-of-reset", ALL, "was taken 2 times", || {
        deque(Abp(Some(Defect::FenceOfReset)), &[2], &[(3, 1)])
    }),
    refuted("abp-without-tag", ALL, "was taken 2 times", || {
        deque(Abp(Some(Defect::Tag)), &[1, 0, 1], &[(1, 1)])
    }),
    sound("in-place-of-3.6", ALL, || deque(Ring::of(4, 1), &[1, 1], &[(2, 1)])),
    // The sound one without what makes it so.
    refuted("given-back-early", ALL, "was taken", || {
        deque(Ring { early: true, ..Ring::of(2, 1) }, &[1, 1, 1, 1], &[(1, 1)])
    }),
    refuted("published-without-release", ALL, "was lost", || {
        deque(Ring { weak: true, ..Ring::of(2, 1) }, &[1], &[(1, 1)])
    }),
    // Kernels without what makes them so.
    refuted("kernel-drains-unseen", Some(3), "taken twice or lost", || {
        kernel(Round { turns: 3, fault: Some(Fault::DrainsUnseen), ..ROUND })
    }),
    refuted("kernel-stays-idle", Some(3), "who retired had work", || {
        kernel(Round { most: 2, fault: Some(Fault::StaysIdle), ..ROUND })
    }),
    // The rule's own assertion sees it first, where there are assertions.
    refuted("kernel-behind-hands", Some(3), BEHIND_HANDS, || {
        kernel(Round { patience: 1, fault: Some(Fault::BehindHands), ..ROUND })
    }),
];

/// What stops a thread behind the last hand.
const BEHIND_HANDS: &str =
    if cfg!(debug_assertions) { "hand < HANDS" } else { "taken twice or lost" };

fn main() -> ExitCode {
    match std::env::var(MODEL) {
        Ok(name) => here(MODELS.iter().find(|m| m.name == name).expect("a model's name")),
        Err(_) => {
            let start = Instant::now();
            let trial = |m: &'static Model| Trial::test(m.name, move || judge(m, start));
            let trials = MODELS.iter().map(trial).collect();
            libtest_mimic::run(&Arguments::from_args(), trials).exit_code()
        }
    }
}

/// Runs a model in a process and compares its answer.
fn judge(model: &Model, start: Instant) -> Result<(), Failed> {
    let began = Instant::now();
    let mut child = Command::new(std::env::current_exe()?)
        .env(MODEL, model.name)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()?;
    // The output of a model fits into a pipe, so that it can be waited for before it is read.
    while child.try_wait()?.is_none() {
        if start.elapsed() > LIMIT {
            child.kill()?;
            return Err(format!("not finished when all models had taken {LIMIT:?}").into());
        }
        std::thread::sleep(Duration::from_millis(20));
    }
    let output = child.wait_with_output()?;
    let [text, error] = [output.stdout, output.stderr].map(String::from_utf8);
    let (text, error) = (text?, error?);
    let sound = output.status.success() && text.contains(SOUND);
    let as_wanted = model.refuted.map_or(sound, |what| !sound && text.contains(what));
    if !as_wanted {
        return Err(format!("wanted {}\n{text}\n{error}", model.refuted.unwrap_or(SOUND)).into());
    }
    print!("{}, {:.1} s: {text}", model.name, began.elapsed().as_secs_f64());
    Ok(())
}

/// Runs one model in this process and prints the result.
fn here(model: &Model) -> ExitCode {
    let mut builder = loom::model::Builder::new();
    builder.preemption_bound = model.bound();
    builder.max_branches = 100_000;
    // Either would end a check before all is seen, and say nothing.
    (builder.max_permutations, builder.max_duration) = (None, None);
    let run = model.run;
    let result = catch_unwind(AssertUnwindSafe(|| builder.check(run)));
    let preemptions = builder.preemption_bound.map_or("all".into(), |n| n.to_string());
    print!("{preemptions} preemptions, {} executions: ", EXECUTIONS.load(Ordering::Relaxed));
    let Err(panic) = result else {
        println!("{SOUND}");
        return ExitCode::SUCCESS;
    };
    let text = panic.downcast_ref::<String>().cloned();
    let text = text.or_else(|| panic.downcast_ref::<&str>().map(|s| (*s).to_owned()));
    println!("refuted, {}\n{}", text.unwrap_or_default(), words::story());
    ExitCode::FAILURE
}
