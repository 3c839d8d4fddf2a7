//! `cargo xtask loom`: all interleavings of owners and thieves, within stated bounds, at the deques
//! of `ccd-core`; and at the printed ones, which the checker must refute.
//!
//! Every model runs in a process of its own, so that one that is refuted, or takes too long, ends
//! without the others; two at a time.

mod kernels;
mod models;
mod printed;
mod words;

use ccd_core::scheduling::stealing::Workers;
use kernels::{ENOUGH, Fault, Round, kernel};
use models::Do::{Pop, Push};
use models::{EXECUTIONS, Scene, Sound, Steals, deque, workers};
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

/// What the checker must say of a model.
#[derive(Clone, Copy, Debug)]
enum Want {
    /// Every item once, in every execution.
    Sound,
    /// In some execution, this.
    Refuted(&'static str),
}

/// A model: what is run, within which bounds, and what must come of it.
struct Model {
    name: &'static str,
    /// How often threads are interrupted at most; without a number, whenever it makes a difference.
    preemptions: Option<usize>,
    want: Want,
    run: fn(),
}

const TWICE: Want = Want::Refuted("was taken 2 times");

/// Two workers of a kernel that look around twice before they retire, or once if all are idle.
const ROUND: Round =
    Round { workers: of(2), depth: 2, most: 0, patience: 2, turns: ENOUGH, fault: None };

/// Workers with room for two batches of one item each in a deque.
const fn of(n: u32) -> Workers {
    Workers { n, batches: 2, batch: 1 }
}

const MODELS: &[Model] = &[
    // What takes longest comes first. Whole workers, until all have retired.
    Model {
        name: "three-workers-task",
        preemptions: Some(3),
        want: Want::Sound,
        run: || workers(of(3), Steals::Task, 2),
    },
    Model {
        name: "three-workers-lazy",
        preemptions: Some(3),
        want: Want::Sound,
        run: || workers(of(3), Steals::Lazily(2), 2),
    },
    // One deque: an owner and two thieves.
    Model {
        name: "two-thieves",
        preemptions: None,
        want: Want::Sound,
        run: || {
            let owner = &[Push(1), Push(1)];
            deque(Sound::<2, 1>, Scene { owner, thieves: &[(1, 1), (1, 1)] });
        },
    },
    Model {
        name: "ranges",
        preemptions: Some(3),
        want: Want::Sound,
        run: || {
            let owner = &[Push(1), Push(1), Push(1), Pop, Push(1)];
            deque(Sound::<2, 1>, Scene { owner, thieves: &[(1, 2), (1, 2)] });
        },
    },
    Model {
        name: "batches",
        preemptions: Some(3),
        want: Want::Sound,
        run: || {
            let owner = &[Push(2), Push(1), Pop, Push(2)];
            deque(Sound::<4, 2>, Scene { owner, thieves: &[(1, 1), (1, 2)] });
        },
    },
    // The word of the ends takes the same values again and again.
    Model {
        name: "old-values",
        preemptions: Some(3),
        want: Want::Sound,
        run: || {
            let owner = &[Push(1), Pop, Push(1), Pop, Push(1), Pop, Push(1)];
            deque(Sound::<2, 1>, Scene { owner, thieves: &[(1, 1), (1, 1)] });
        },
    },
    // The ring is written over again, while a thief reads.
    Model {
        name: "ring",
        preemptions: None,
        want: Want::Sound,
        run: || {
            let owner = &[Push(1), Push(1), Push(1)];
            deque(Sound::<2, 1>, Scene { owner, thieves: &[(2, 1)] });
        },
    },
    Model {
        name: "longer-ring",
        preemptions: Some(5),
        want: Want::Sound,
        run: || {
            let owner = &[Push(1), Push(1), Push(1), Push(1), Push(1)];
            deque(Sound::<2, 1>, Scene { owner, thieves: &[(3, 1)] });
        },
    },
    Model {
        name: "workers-task",
        preemptions: None,
        want: Want::Sound,
        run: || workers(of(2), Steals::Task, 2),
    },
    Model {
        name: "workers-lazy",
        preemptions: None,
        want: Want::Sound,
        run: || workers(of(2), Steals::Lazily(2), 2),
    },
    // What kernels do: `try_pop`, retirement when all are idle, the drain, tasks (`most` 0).
    Model { name: "kernel-task", preemptions: Some(2), want: Want::Sound, run: || kernel(ROUND) },
    Model {
        name: "kernel-lazy",
        preemptions: Some(2),
        want: Want::Sound,
        run: || kernel(Round { most: 2, ..ROUND }),
    },
    Model {
        name: "kernel-task-drains",
        preemptions: Some(3),
        want: Want::Sound,
        run: || kernel(Round { turns: 3, ..ROUND }),
    },
    Model {
        name: "kernel-lazy-drains",
        preemptions: Some(3),
        want: Want::Sound,
        run: || kernel(Round { turns: 3, most: 2, ..ROUND }),
    },
    // As printed; the same scenes of what is sound.
    Model {
        name: "printed-3.13",
        preemptions: None,
        want: TWICE,
        run: || deque(Lazy, Scene { owner: &[Push(3)], thieves: &[(1, 1)] }),
    },
    Model {
        name: "in-place-of-3.13",
        preemptions: None,
        want: Want::Sound,
        run: || {
            let owner = &[Push(1), Push(1), Push(1)];
            deque(Sound::<4, 1>, Scene { owner, thieves: &[(1, 1)] });
        },
    },
    Model {
        name: "printed-3.6-acquire-release",
        preemptions: None,
        want: TWICE,
        run: || deque(Task::<false>, Scene { owner: &[Push(2)], thieves: &[(2, 1)] }),
    },
    Model {
        name: "printed-3.6-sequential",
        preemptions: None,
        want: Want::Sound,
        run: || deque(Task::<true>, Scene { owner: &[Push(2)], thieves: &[(2, 1)] }),
    },
    Model {
        name: "in-place-of-3.6",
        preemptions: None,
        want: Want::Sound,
        run: || {
            let owner = &[Push(1), Push(1)];
            deque(Sound::<4, 1>, Scene { owner, thieves: &[(2, 1)] });
        },
    },
    // The sound one without what makes it so.
    Model {
        name: "given-back-early",
        preemptions: None,
        want: Want::Refuted("was taken"),
        run: || {
            let owner = &[Push(1), Push(1), Push(1), Push(1)];
            deque(models::Fault::<true>, Scene { owner, thieves: &[(1, 1)] });
        },
    },
    Model {
        name: "published-without-release",
        preemptions: None,
        want: Want::Refuted("was lost"),
        run: || deque(models::Fault::<false>, Scene { owner: &[Push(1)], thieves: &[(1, 1)] }),
    },
    // Kernels without what makes them so.
    Model {
        name: "kernel-drains-unseen",
        preemptions: Some(3),
        want: Want::Refuted("taken twice or lost"),
        run: || kernel(Round { turns: 3, fault: Some(Fault::DrainsUnseen), ..ROUND }),
    },
    Model {
        name: "kernel-stays-idle",
        preemptions: Some(3),
        want: Want::Refuted("who retired had work"),
        run: || kernel(Round { most: 2, fault: Some(Fault::StaysIdle), ..ROUND }),
    },
    Model {
        name: "kernel-behind-hands",
        preemptions: Some(3),
        want: Want::Refuted("taken twice or lost"),
        run: || kernel(Round { patience: 1, fault: Some(Fault::BehindHands), ..ROUND }),
    },
];

/// Runs all models whose name contains `name`; an error if one does not answer as it must.
pub fn run(name: &str) -> Result<(), String> {
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
                    if let Err(e) = judge(model, start) {
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
fn judge(model: &Model, start: Instant) -> Result<(), String> {
    let began = Instant::now();
    let output = process(model, start)?;
    let text = String::from_utf8_lossy(&output.stdout);
    let executions = text.lines().find_map(|l| l.strip_prefix("executions: ")).unwrap_or("none");
    let preemptions = model.preemptions.map_or("all".into(), |n| n.to_string());
    let time = began.elapsed().as_secs_f64();
    let sound = output.status.success() && text.contains(SOUND);
    let line = |answer: &str| {
        println!("{:28} {preemptions:>11} {executions:>10} {time:>6.1} s  {answer}", model.name);
    };
    match model.want {
        Want::Sound if sound => line(SOUND),
        Want::Refuted(what) if !sound && text.contains(what) => {
            let story: Vec<&str> = text.lines().skip(1).collect();
            line(&format!("refuted, as it must be:\n    {}", story.join("\n    ")));
        }
        want => {
            return Err(format!(
                "wanted {want:?}\n{text}\n{}",
                String::from_utf8_lossy(&output.stderr)
            ));
        }
    }
    Ok(())
}

fn process(model: &Model, start: Instant) -> Result<Output, String> {
    let exe = std::env::current_exe().map_err(|e| e.to_string())?;
    let mut child = Command::new(exe)
        .args(["loom", "--here", model.name])
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
pub fn here(name: &str) -> Result<(), String> {
    let model = MODELS.iter().find(|m| m.name == name).ok_or("no such model")?;
    let mut builder = loom::model::Builder::new();
    builder.preemption_bound = model.preemptions;
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
