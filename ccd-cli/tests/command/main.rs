//! The command as a user runs it: text, JSON, CSV, pictures, exit status, errors.

mod backends;
#[cfg(unix)]
mod interrupted;
mod methods;
mod transcripts;

use libtest_mimic::{Arguments, Completion, Failed, Trial};
use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};

/// Tests that run anywhere.
const ANYWHERE: &[(&str, fn())] = &[
    ("without_a_gpu", backends::without_a_gpu),
    ("opengl_is_refused", backends::opengl_is_refused),
    ("the_list_names_every_choice", methods::the_list_names_every_choice),
    ("the_documents_name_every_choice", methods::the_documents_name_every_choice),
    ("every_choice_finds_the_same", methods::every_choice_finds_the_same),
    ("pages_describe_every_option", methods::pages_describe_every_option),
    #[cfg(unix)]
    ("a_reader_that_goes_away_ends_quietly", interrupted::a_reader_that_goes_away_ends_quietly),
    #[cfg(unix)]
    ("a_reader_that_goes_away", interrupted::a_reader_that_goes_away_leaves_files_and_status),
    #[cfg(unix)]
    ("ctrl_c_leaves_whole_files_or_none", interrupted::ctrl_c_leaves_whole_files_or_none),
    #[cfg(unix)]
    ("a_second_ctrl_c_ends_at_once", interrupted::a_second_ctrl_c_ends_at_once),
    #[cfg(unix)]
    ("what_cannot_be_told_changes_nothing", interrupted::what_cannot_be_told_changes_nothing),
    #[cfg(unix)]
    ("links_and_pipes_are_written_to", interrupted::links_and_pipes_are_written_to),
];
/// Tests that need a GPU: without one they are ignored with the reason, and counted.
const WITH_GPU: &[(&str, fn())] = &[
    ("info_says_what_there_is", backends::info_says_what_there_is),
    ("the_gpu_finds_what_the_cpu_finds", backends::the_gpu_finds_what_the_cpu_finds),
    ("kernels_are_kept", backends::kernels_are_kept),
    ("bench_checks_its_answers_on_the_gpu", backends::bench_checks_its_answers_on_the_gpu),
];

fn main() {
    let passes = |test: fn()| {
        move || {
            test();
            Ok::<_, Failed>(())
        }
    };
    let mut trials = transcripts::trials();
    trials.extend(ANYWHERE.iter().map(|&(name, test)| Trial::test(name, passes(test))));
    let missing = json(&ccd(&["info", "--json"]))["no_gpu"].as_str().map(str::to_owned);
    let required = std::env::var("CCD_GPU").is_ok_and(|v| v == "require");
    for &(name, test) in WITH_GPU {
        let missing = missing.clone();
        trials.push(Trial::ignorable_test(name, move || match missing {
            None => {
                test();
                Ok(Completion::Completed)
            }
            Some(why) if required => Err(Failed::from(format!("CCD_GPU=require, but: {why}"))),
            Some(why) => Ok(Completion::ignored_with(why)),
        }));
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

/// A square of two triangles and a triangle above it; `drop` lowers the triangle.
fn obj(dir: &Path, name: &str, drop: f64) -> String {
    let [y, z] = [0.5, 2.0].map(|height| height - drop);
    let text = format!(
        "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 1 0 1\nv 0.3 {y} 0.3\nv 0.2 {z} 0.3\nv 0.4 {z} 0.3\n\
         f 1 2 3\nf 3 2 4\nf 5 6 7\n"
    );
    let path = dir.join(name);
    std::fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

fn ccd(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ccd")).args(args).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|e| panic!("{e}: {}{}", text(&output.stdout), text(&output.stderr)))
}

/// Exit status 2 and a message that says `what`.
fn check_refused(args: &[&str], what: &str) {
    let output = ccd(args);
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{args:?}: {message}");
    assert!(message.contains(what), "{args:?}: {message:?} does not say {what:?}");
    assert!(output.stdout.is_empty(), "{args:?} printed {}", text(&output.stdout));
}
