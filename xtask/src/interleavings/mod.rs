//! `cargo xtask loom`: all interleavings of owners and thieves, within stated bounds, at the deques
//! of `ccd-core`; and at the printed ones, which the checker must refute.
//!
//! Every model runs in a process of its own, so that one that is refuted, or takes too long, ends
//! without the others; two at a time.

mod kernels;
mod models;
mod printed;
mod words;

use ccd_core::backend::scheduling::stealing::Workers;
use kernels::{ENOUGH, Fault, Round, kernel};
use models::{EXECUTIONS, Ring, Steals, deque, workers};
use printed::{Lazy, Task};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::{Command, Output, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// Time for all models, on two idle cores.
const LIMIT: Duration = Duration::from_secs(300);
/// What the process of a model says when all executions were as they should be.
const SOUND: &str = "every item once";
/// Preemptions of sound models unless all is asked for: each defect below is seen with fewer.
const FEW: usize = 2;

/// A model: what is run, within which bounds, and what must come of it.
struct Model {
    name: &'static str,
    /// How often threads are interrupted at most; without a number, whenever it makes a difference.
    preemptions: Option<usize>,
    /// What must happen in some execution; nothing: every item once, in every execution.
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
    fn bound(&self, whole: bool) -> Option<usize> {
        match (self.refuted, whole) {
            (None, false) => Some(self.preemptions.map_or(FEW, |n| n.min(FEW))),
            _ => self.preemptions,
        }
    }
}

/// Two workers of a kernel that look around twice before they retire, or once if all are idle.
const ROUND: Round =
    Round { workers: of(2), depth: 2, most: 0, patience: 2, turns: ENOUGH, fault: None };

/// Workers with room for two batches of one item each in a deque.
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
    // As printed; the same scenes of what is sound.
    refuted("printed-3.13", ALL, "was taken 2 times", || deque(Lazy, &[3], &[(1, 1)])),
    sound("in-place-of-3.13", ALL, || deque(Ring::of(4, 1), &[1, 1, 1], &[(1, 1)])),
    refuted("printed-3.6-acquire-release", ALL, "was taken 2 times", || {
        deque(Task { sequential: false }, &[2], &[(2, 1)])
    }),
    sound("printed-3.6-sequential", ALL, || deque(Task { sequential: true }, &[2], &[(2, 1)])),
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
    refuted("kernel-behind-hands", Some(3), "taken twice or lost", || {
        kernel(Round { patience: 1, fault: Some(Fault::BehindHands), ..ROUND })
    }),
];

/// Runs all models whose name contains `name`; an error if one does not answer as it must.
pub fn run(name: &str, whole: bool) -> Result<(), String> {
    let chosen: Vec<&Model> = MODELS.iter().filter(|m| m.name.contains(name)).collect();
    if chosen.is_empty() {
        return Err(format!("no model has a name that contains `{name}`"));
    }
    let (start, next, problems) = (Instant::now(), AtomicUsize::new(0), Mutex::new(Vec::new()));
    println!("{:28} {:>11} {:>10} {:>8}  answer", "model", "preemptions", "executions", "time");
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                while let Some(model) = chosen.get(next.fetch_add(1, Ordering::Relaxed)) {
                    if let Err(e) = judge(model, whole, start) {
                        problems.lock().expect("no panic").push(format!("{}: {e}", model.name));
                    }
                }
            });
        }
    });
    let problems = problems.into_inner().expect("no panic");
    let n = chosen.len();
    println!("{n} models in {:.1} s", start.elapsed().as_secs_f64());
    if problems.is_empty() { Ok(()) } else { Err(problems.join("\n")) }
}

/// Runs one model in a process and compares its answer.
fn judge(model: &Model, whole: bool, start: Instant) -> Result<(), String> {
    let began = Instant::now();
    let output = process(model, whole, start)?;
    let text = String::from_utf8_lossy(&output.stdout);
    let executions = text.lines().find_map(|l| l.strip_prefix("executions: ")).unwrap_or("none");
    let preemptions = model.bound(whole).map_or("all".into(), |n| n.to_string());
    let time = began.elapsed().as_secs_f64();
    let sound = output.status.success() && text.contains(SOUND);
    let line = |answer: &str| {
        println!("{:28} {preemptions:>11} {executions:>10} {time:>6.1} s  {answer}", model.name);
    };
    match model.refuted {
        None if sound => line(SOUND),
        Some(what) if !sound && text.contains(what) => {
            let story: Vec<&str> = text.lines().skip(1).collect();
            line(&format!("refuted, as it must be:\n    {}", story.join("\n    ")));
        }
        want => {
            return Err(format!(
                "wanted {}\n{text}\n{}",
                want.unwrap_or(SOUND),
                String::from_utf8_lossy(&output.stderr)
            ));
        }
    }
    Ok(())
}

fn process(model: &Model, whole: bool, start: Instant) -> Result<Output, String> {
    let exe = std::env::current_exe().map_err(|e| e.to_string())?;
    let mut child = Command::new(exe)
        .args(["loom", "--here", model.name])
        .args(whole.then_some("--whole"))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|e| e.to_string())?;
    // What a model says fits into a pipe, so that it can be waited for before it is read.
    while child.try_wait().map_err(|e| e.to_string())?.is_none() {
        if start.elapsed() > LIMIT {
            child.kill().map_err(|e| e.to_string())?;
            return Err(format!("not finished when all models had taken {LIMIT:?}"));
        }
        std::thread::sleep(Duration::from_millis(20));
    }
    child.wait_with_output().map_err(|e| e.to_string())
}

/// Runs one model in this process; says what it came to.
pub fn here(name: &str, whole: bool) -> Result<(), String> {
    let model = MODELS.iter().find(|m| m.name == name).ok_or("no such model")?;
    let mut builder = loom::model::Builder::new();
    builder.preemption_bound = model.bound(whole);
    builder.max_branches = 100_000;
    // Either would end a check before all is seen, and say nothing.
    (builder.max_permutations, builder.max_duration) = (None, None);
    let run = model.run;
    let result = catch_unwind(AssertUnwindSafe(|| builder.check(run)));
    println!("executions: {}", EXECUTIONS.load(Ordering::Relaxed));
    match result {
        Ok(()) => {
            println!("{SOUND}");
            Ok(())
        }
        Err(panic) => {
            let text = panic.downcast_ref::<String>().cloned();
            let text = text.or_else(|| panic.downcast_ref::<&str>().map(|s| (*s).to_owned()));
            println!("{}\n{}", text.unwrap_or_default(), words::story());
            Err("refuted".into())
        }
    }
}
