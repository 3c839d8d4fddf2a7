//! The command as a user runs it: text, JSON, CSV, pictures, exit status, errors.

mod backends;
mod bench;
mod files;
#[cfg(unix)]
mod interrupted;
mod meshes;
mod methods;
mod outputs;
mod parts;
mod refusals;
mod rows;
mod streams;

use libtest_mimic::{Arguments, Completion, Failed, Trial};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Tests that run anywhere.
const ANYWHERE: &[(&str, fn())] = &[
    ("check_finds_the_contact", meshes::check_finds_the_contact),
    ("check_reads_every_line_end_of_obj", meshes::check_reads_every_line_end_of_obj),
    ("sequence_steps_through_frames", meshes::sequence_steps_through_frames),
    ("queries_are_counted_against_their_answers", rows::queries_are_counted_against_their_answers),
    ("boxes_are_paired", rows::boxes_are_paired),
    ("bad_use_and_bad_input_end_with_status_2", refusals::bad_use_and_bad_input_end_with_status_2),
    ("the_demo_ends_without_penetration", meshes::the_demo_ends_without_penetration),
    ("auto_goes_on_with_the_cpu", backends::auto_goes_on_with_the_cpu),
    ("opengl_is_refused", backends::opengl_is_refused),
    ("the_list_names_every_choice", methods::the_list_names_every_choice),
    ("every_choice_finds_the_same", methods::every_choice_finds_the_same),
    (
        "combinations_that_mean_nothing_are_refused",
        methods::combinations_that_mean_nothing_are_refused,
    ),
    ("bench_checks_its_answers", bench::bench_checks_its_answers),
    ("contacts_go_to_standard_output", streams::contacts_go_to_standard_output),
    ("output_that_fails_is_no_panic", streams::output_that_fails_is_no_panic),
    ("sequences_are_folders_and_patterns", streams::sequences_are_folders_and_patterns),
    ("bodies_select_contacts", streams::bodies_select_contacts),
    ("shells_and_man_have_something_to_read", streams::shells_and_man_have_something_to_read),
    ("contacts_say_where_they_are", outputs::contacts_say_where_they_are),
    ("candidates_are_listed", outputs::candidates_are_listed),
    ("pairs_of_boxes_are_written", outputs::pairs_of_boxes_are_written),
    ("people_are_told_what_it_means", outputs::people_are_told_what_it_means),
    (
        "a_first_frame_that_intersects_itself_is_told",
        outputs::a_first_frame_that_intersects_itself_is_told,
    ),
    ("the_demo_writes_its_frames", outputs::the_demo_writes_its_frames),
    ("parts_are_joined_to_the_whole", parts::parts_are_joined_to_the_whole),
    ("slurm_says_which_part", parts::slurm_says_which_part),
    ("positions_over_time_are_a_sequence", parts::positions_over_time_are_a_sequence),
    ("verdicts_on_queries_are_written", rows::verdicts_on_queries_are_written),
    ("outputs_never_lie_over_files", files::outputs_never_lie_over_files),
    ("everything_goes_to_standard_output", files::everything_goes_to_standard_output),
    ("contacts_of_parts_are_joined", files::contacts_of_parts_are_joined),
    #[cfg(unix)]
    ("ctrl_c_leaves_whole_files_or_none", interrupted::ctrl_c_leaves_whole_files_or_none),
    #[cfg(unix)]
    ("a_second_ctrl_c_ends_at_once", interrupted::a_second_ctrl_c_ends_at_once),
    #[cfg(unix)]
    ("memory_is_limited", interrupted::memory_is_limited),
];
/// Tests that need a GPU: without one they are ignored with the reason, and counted.
const WITH_GPU: &[(&str, fn())] = &[
    ("info_says_what_there_is", backends::info_says_what_there_is),
    ("the_gpu_finds_what_the_cpu_finds", backends::the_gpu_finds_what_the_cpu_finds),
    ("kernels_are_kept", backends::kernels_are_kept),
    ("bench_checks_its_answers_on_the_gpu", bench::bench_checks_its_answers_on_the_gpu),
];

fn main() {
    let passes = |test: fn()| {
        move || {
            test();
            Ok::<_, Failed>(())
        }
    };
    let mut trials: Vec<Trial> = Vec::new();
    trials.extend(ANYWHERE.iter().map(|&(name, test)| Trial::test(name, passes(test))));
    let info = ccd(&["info"]);
    let missing = (!info.status.success()).then(|| text(&info.stderr).trim().to_owned());
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
fn obj(dir: &Path, name: &str, drop: f64) -> PathBuf {
    let y = |h: f64| h - drop;
    let text = format!(
        "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 1 0 1\n\
         v 0.3 {} 0.3\nv 0.2 {} 0.3\nv 0.4 {} 0.3\n\
         f 1 2 3\nf 3 2 4\nf 5 6 7\n",
        y(0.5),
        y(2.0),
        y(2.0)
    );
    let path = dir.join(name);
    std::fs::write(&path, text).unwrap();
    path
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
