//! Signals: Ctrl-C ends with status 130, SIGTERM with 143, and both leave whole files or none.

use super::{ccd, text};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

/// A long sequence: so many frames of a sheet that bends, as one file, and its mesh.
fn long_sequence(dir: &Path) -> [String; 2] {
    let n = 40;
    let (mesh, cache) = (dir.join("sheet.obj"), dir.join("sheet.pc2"));
    let mut obj = String::new();
    for v in 0..n * n {
        obj += &format!("v {} 0 {}\n", v % n, v / n);
    }
    for (i, j) in (0..n - 1).flat_map(|i| (0..n - 1).map(move |j| (i, j))) {
        let v = i * n + j + 1;
        obj += &format!("f {} {} {}\nf {} {} {}\n", v, v + 1, v + n, v + 1, v + n + 1, v + n);
    }
    std::fs::write(&mesh, obj).unwrap();
    let n_frames = 4000u32;
    let mut bytes = b"POINTCACHE2\0".to_vec();
    bytes.extend([1u32, (n * n) as u32, 0, 0, n_frames].iter().flat_map(|x| x.to_le_bytes()));
    for frame in 0..n_frames {
        for v in 0..n * n {
            let (x, z) = ((v % n) as f32, (v / n) as f32);
            let y = (x * 0.3 + frame as f32 * 0.01).sin() * 3.0;
            bytes.extend([x, y, z].iter().flat_map(|c| c.to_le_bytes()));
        }
    }
    std::fs::write(&cache, bytes).unwrap();
    [mesh, cache].map(|path| path.to_str().unwrap().to_owned())
}

fn start(args: &[&str]) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ccd"));
    command.args(args).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command.spawn().unwrap()
}

fn send(signal: &str, child: &Child) {
    let sent = Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
}

/// Waits until something is true, a minute at most.
fn wait_for(what: &str, is: impl Fn() -> bool) {
    let start = Instant::now();
    while !is() {
        assert!(start.elapsed() < Duration::from_secs(60), "{what}");
        std::thread::sleep(Duration::from_millis(5));
    }
}

fn names(dir: &Path) -> Vec<String> {
    let names = std::fs::read_dir(dir).unwrap().map(|of| of.unwrap().file_name());
    let mut names: Vec<String> = names.map(|name| name.into_string().unwrap()).collect();
    names.sort();
    names
}

fn ended(child: Child) -> Output {
    child.wait_with_output().unwrap()
}

pub fn ctrl_c_leaves_whole_files_or_none() {
    let dir = tempfile::tempdir().unwrap();
    let [mesh, cache] = long_sequence(dir.path());
    let out = tempfile::tempdir().unwrap();
    let [contacts, picture] = ["contacts.csv", "times.png"]
        .map(|name| out.path().join(name).to_str().unwrap().to_owned());
    let args = [
        ["sequence", &cache, "--mesh", &mesh],
        ["--backend", "cpu", "--min-distance", "0.01"],
        ["--contacts", &contacts, "--picture", &picture],
    ]
    .concat();
    for before in [None, Some("what was there\n")] {
        if let Some(text) = before {
            std::fs::write(&contacts, text).unwrap();
        }
        let child = start(&args);
        let begun = || names(out.path()).iter().any(|name| name.ends_with(".part"));
        wait_for("a file that is begun", begun);
        std::thread::sleep(Duration::from_millis(200));
        let (signal, status) = if before.is_none() { ("-INT", 130) } else { ("-TERM", 143) };
        send(signal, &child);
        let output = ended(child);
        assert_eq!(output.status.code(), Some(status), "{}", text(&output.stderr));
        assert!(text(&output.stderr).contains("interrupted"), "{}", text(&output.stderr));
        assert!(!text(&output.stdout).contains("summary"), "it was done before");
        match before {
            None => assert_eq!(names(out.path()), [""; 0]),
            Some(text) => {
                assert_eq!(names(out.path()), ["contacts.csv"]);
                assert_eq!(std::fs::read_to_string(&contacts).unwrap(), text);
            }
        }
    }
    // The control: without it there are both.
    let part = [&args[..], &["--part", "1/400"]].concat();
    let output = ccd(&part);
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert_eq!(names(out.path()), ["contacts.csv", "times.png"]);
}

/// The first Ctrl-C is not looked at while a file is waited for; the second does not wait.
pub fn a_second_ctrl_c_ends_at_once() {
    let dir = tempfile::tempdir().unwrap();
    let pipe = dir.path().join("pipe.obj");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let contacts = dir.path().join("contacts.csv");
    let (pipe, out) = (pipe.to_str().unwrap(), contacts.to_str().unwrap());
    let mut child = start(&["check", pipe, pipe, "--contacts", out]);
    let begun = || names(dir.path()).iter().any(|name| name.ends_with(".part"));
    wait_for("a file that is begun", begun);
    send("-INT", &child);
    std::thread::sleep(Duration::from_millis(300));
    assert!(child.try_wait().unwrap().is_none(), "the first ended it");
    send("-INT", &child);
    assert_eq!(ended(child).status.code(), Some(130));
    assert!(!contacts.exists());
}

pub fn a_reader_that_goes_away_ends_quietly() {
    let mut child = start(&["completions", "bash"]);
    drop(child.stdout.take());
    let output = ended(child);
    assert_eq!((output.status.code(), text(&output.stderr).as_str()), (Some(0), ""));
    let bash = text(&ccd(&["completions", "bash"]).stdout);
    assert!(bash.contains("--min-distance") && bash.contains("_ccd()"), "{bash}");
}

/// Whoever wants files or a status gets them, whether what is printed is read or not.
pub fn a_reader_that_goes_away_leaves_files_and_status() {
    let dir = tempfile::tempdir().unwrap();
    let frames = ["f0.obj", "f1.obj", "f2.obj"];
    for (name, drop) in frames.iter().zip([0.0, 1.0, 0.0]) {
        crate::obj(dir.path(), name, drop);
    }
    let path = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let ([a, b, c], contacts) = (frames.map(path), path("contacts.csv"));
    let mut child = start(&["sequence", &a, &b, &c, "--contacts", &contacts, "--fail-on-contact"]);
    drop(child.stdout.take());
    let output = ended(child);
    assert_eq!((output.status.code(), text(&output.stderr).as_str()), (Some(1), ""));
    assert_eq!(names(dir.path()), ["contacts.csv", "f0.obj", "f1.obj", "f2.obj"]);
    assert!(std::fs::read_to_string(&contacts).unwrap().lines().count() > 2);
    // The same where rows are what is printed.
    let picture = path("times.png");
    let mut child =
        start(&["check", &a, &b, "--contacts", "-", "--picture", &picture, "--fail-on-contact"]);
    drop(child.stdout.take());
    let output = ended(child);
    assert_eq!((output.status.code(), text(&output.stderr).as_str()), (Some(1), ""));
    std::fs::remove_file(&picture).unwrap();
    // What cannot be printed for another reason ends it, and leaves no part of a file.
    let full = std::fs::File::options().write(true).open("/dev/full").unwrap();
    std::fs::remove_file(&contacts).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_ccd"));
    command.args(["sequence", &a, &b, &c, "--contacts", &contacts]).stdout(full);
    assert_eq!(command.stderr(Stdio::null()).status().unwrap().code(), Some(2));
    assert_eq!(names(dir.path()), frames);
}
