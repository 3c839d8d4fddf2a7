//! What Unix has: signals, readers that go away, links, pipes. Ctrl-C ends with status 130, SIGTERM
//! with 143, and both leave whole files or none.

use super::{ccd, check_refused, text};
use std::fs::File;
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

/// What waits for a file does not look at signals: it is ended a second after the first one, or at
/// once by a second one, and no part of a file is left.
pub fn a_second_ctrl_c_ends_at_once() {
    let dir = tempfile::tempdir().unwrap();
    let [pipe, contacts] =
        ["pipe.obj", "contacts.csv"].map(|name| dir.path().join(name).display().to_string());
    make_pipe(&pipe);
    let lasts = |n_signals: usize| {
        let child = start(&["check", &pipe, &pipe, "--contacts", &contacts]);
        let begun = || names(dir.path()).iter().any(|name| name.ends_with(".part"));
        wait_for("a file that is begun", begun);
        let first = Instant::now();
        for _ in 0..n_signals {
            send("-INT", &child);
            std::thread::sleep(Duration::from_millis(100));
        }
        let output = ended(child);
        assert_eq!(output.status.code(), Some(130), "{}", text(&output.stderr));
        assert_eq!(names(dir.path()), ["pipe.obj"]);
        (first.elapsed(), text(&output.stderr))
    };
    let (time, said) = lasts(1);
    assert!(time > Duration::from_millis(900) && said.contains("interrupted"), "{time:?}: {said}");
    // Where others keep the machine busy, at least one of several.
    assert!((0..5).any(|_| lasts(2).0 < Duration::from_millis(900)), "the second one waited");
}

fn make_pipe(path: &str) {
    assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
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
    let full = File::options().write(true).open("/dev/full").unwrap();
    std::fs::remove_file(&contacts).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_ccd"));
    command.args(["sequence", &a, &b, &c, "--contacts", &contacts]).stdout(full);
    assert_eq!(command.stderr(Stdio::null()).status().unwrap().code(), Some(2));
    assert_eq!(names(dir.path()), frames);
    // A demo is there for its pictures.
    let (out, small) = (path("demo"), ["--size", "small", "--frames", "1", "--backend", "cpu"]);
    let mut child = start(&[&["demo", "--out", &out][..], &small].concat());
    drop(child.stdout.take());
    let output = ended(child);
    assert_eq!((output.status.code(), text(&output.stderr).as_str()), (Some(0), ""));
    assert_eq!(names(&dir.path().join("demo")), ["last-frame.png", "times.png"]);
}

/// Where notices and errors cannot be written, the exit status is what it is otherwise.
pub fn what_cannot_be_told_changes_nothing() {
    let dir = tempfile::tempdir().unwrap();
    let (a, b) = (&*crate::obj(dir.path(), "a.obj", 0.0), &*crate::obj(dir.path(), "b.obj", 1.0));
    let told = ["check", a, b, "--json", "--backend", "cpu", "--front", "on"];
    assert!(text(&ccd(&told).stderr).starts_with("ccd: --front on"), "no notice");
    for (args, status) in
        [(&told[..], 0), (&["check", a, "missing.obj"], 2), (&["check", "--no-such-option"], 2)]
    {
        let full = File::options().write(true).open("/dev/full").unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_ccd"));
        let output = command.args(args).stderr(full).output().unwrap();
        assert_eq!(output.status.code(), Some(status), "{args:?}");
        assert_eq!(output.stdout.is_empty(), status != 0, "{args:?}");
    }
}

/// A link stays: what it leads to is written, even if that was not there. A pipe is opened once.
pub fn links_and_pipes_are_written_to() {
    let dir = tempfile::tempdir().unwrap();
    let (a, b) = (&*crate::obj(dir.path(), "a.obj", 0.0), &*crate::obj(dir.path(), "b.obj", 1.0));
    let [link, folder, new, pipe] = ["link.csv", "folder", "folder/new.csv", "pipe.png"]
        .map(|name| dir.path().join(name).display().to_string());
    std::fs::create_dir(&folder).unwrap();
    std::os::unix::fs::symlink("folder/new.csv", &link).unwrap();
    let both = ["check", a, b, "--contacts", &link, "--candidates", &new];
    check_refused(&both, "both write it");
    for _ in 0..2 {
        let output = ccd(&both[..5]);
        assert!(output.status.success(), "{}", text(&output.stderr));
        assert!(std::fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(names(folder.as_ref()), ["new.csv"]);
        assert!(std::fs::read_to_string(&new).unwrap().lines().count() > 1);
    }
    check_refused(&both, "both write it");
    make_pipe(&pipe);
    for picture in [["check", a, b, "--picture", &pipe], ["sequence", a, b, "--picture", &pipe]] {
        let child = start(&picture);
        let read = std::fs::read(&pipe).unwrap();
        assert!(read.starts_with(b"\x89PNG"), "{picture:?}: {} bytes", read.len());
        assert!(ended(child).status.success(), "{picture:?}");
    }
}
