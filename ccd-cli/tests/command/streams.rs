//! Where output goes and what comes of it if it cannot; frames from folders; bodies; what shells
//! read.

use crate::{ccd, check_refused, json, obj, text};
use std::io::Read;
use std::process::{Command, Stdio};

pub fn contacts_go_to_standard_output() {
    let dir = tempfile::tempdir().unwrap();
    let (a, b) = (obj(dir.path(), "a.obj", 0.0), obj(dir.path(), "b.obj", 1.0));
    let (a, b) = (a.to_str().unwrap(), b.to_str().unwrap());
    let rows = text(&ccd(&["check", a, b, "--contacts", "-"]).stdout);
    assert!(rows.starts_with("kind,a,b,toi,state,") && rows.contains("\nvf,4,0,0.4"), "{rows}");
    assert_eq!(rows.lines().count(), 2, "{rows}");
    check_refused(&["check", a, b, "--json", "--contacts", "-"], "both go to standard output");
    check_refused(&["check", a, b, "--contacts", "contacts.txt"], ".csv");
    check_refused(&["check", a, b, "--picture", "picture.jpg"], ".png");
    // Before any work: the frames are not even there.
    let nowhere = dir.path().join("no/folder/out.csv");
    check_refused(&["check", "x.ply", "y.ply", "--contacts", nowhere.to_str().unwrap()], "out.csv");
    check_refused(&["check", "x.ply", "y.ply", "--picture", "no/such/folder/a.png"], "a.png");
    // A picture of an earlier run stays until there is another.
    let picture = dir.path().join("a.png");
    std::fs::write(&picture, "earlier").unwrap();
    check_refused(&["check", "x.ply", "y.ply", "--picture", picture.to_str().unwrap()], "x.ply");
    assert_eq!(std::fs::read(&picture).unwrap(), b"earlier");
}

/// A reader that goes away ends the command quietly; a full disk is an error.
#[cfg(target_os = "linux")]
pub fn output_that_fails_is_no_panic() {
    for args in [&["list"][..], &["--help"], &["check", "--help"], &["--version"]] {
        let full = std::fs::File::options().write(true).open("/dev/full").unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_ccd"));
        let output = command.args(args).stdout(full).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{args:?}");
        assert!(text(&output.stderr).contains("standard output: No space"), "{:?}", output.stderr);
    }

    let mut gone = Command::new(env!("CARGO_BIN_EXE_ccd"));
    let gone = gone.args(["completions", "bash"]).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = gone.spawn().unwrap();
    drop(child.stdout.take());
    let mut said = String::new();
    child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
    assert_eq!((child.wait().unwrap().code(), said.as_str()), (Some(0), ""));
}

#[cfg(not(target_os = "linux"))]
pub fn output_that_fails_is_no_panic() {}

pub fn sequences_are_folders_and_patterns() {
    let dir = tempfile::tempdir().unwrap();
    for (name, drop) in [("f1.obj", 0.0), ("f2.obj", 0.3), ("f10.obj", 0.9)] {
        obj(dir.path(), name, drop);
    }
    let folder = dir.path().to_str().unwrap();
    let pattern = format!("{folder}/f*.obj");
    for given in [folder, &pattern] {
        let value = json(&ccd(&["sequence", given, "--json"]));
        let steps = value["steps"].as_array().unwrap();
        assert_eq!(steps.len(), 2);
        assert!(steps[0]["file"].as_str().unwrap().ends_with("f2.obj"), "{value}");
        assert_eq!(
            (&steps[0]["contacts"]["vf"], &steps[1]["contacts"]["vf"]),
            (&0.into(), &1.into())
        );
    }
    let [first, last] = ["f1.obj", "f10.obj"].map(|name| format!("{folder}/{name}"));
    let output = ccd(&["sequence", &last, &first, "--json-lines"]);
    assert!(text(&output.stderr).contains("order of the numbers"), "{:?}", output.stderr);
    let lines = text(&output.stdout);
    let lines: Vec<serde_json::Value> =
        lines.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!((lines.len(), &lines[0]["frame"], &lines[1]["steps"]), (2, &0.into(), &1.into()));
    check_refused(&["sequence", &first], "two frames or more");
    check_refused(&["sequence", &format!("{folder}/*.ply")], "no file fits");
}

pub fn bodies_select_contacts() {
    let dir = tempfile::tempdir().unwrap();
    let (a, b) = (obj(dir.path(), "a.obj", 0.0), obj(dir.path(), "b.obj", 1.0));
    let (a, b) = (a.to_str().unwrap(), b.to_str().unwrap());
    let file = dir.path().join("bodies.txt");
    std::fs::write(&file, "3 3 3 3\n7,7,7\n").unwrap();
    let file = file.to_str().unwrap();
    let contacts = |more: &[&str]| {
        let value = json(&ccd(&[&["check", a, b, "--json"], more].concat()));
        value["contacts"]["vf"].as_u64().unwrap()
    };
    // The square is one part, the triangle above it another.
    assert_eq!(contacts(&["--no-self-contact"]), 1);
    assert_eq!(contacts(&["--no-self-contact", "--bodies", file]), 1);
    std::fs::write(file, "0 0 0 0 0 0 0").unwrap();
    assert_eq!(contacts(&["--bodies", file]), 1);
    assert_eq!(contacts(&["--bodies", file, "--no-self-contact"]), 0);
    assert_eq!(contacts(&["--fixed", "0"]), 1);
    check_refused(&["check", a, b, "--fixed", "2"], "no body 2");
    std::fs::write(file, "0 0 0 0 0 0\nx").unwrap();
    check_refused(&["check", a, b, "--bodies", file], "line 2: `x`");
    let says = "b.obj: vertex 5 (counted from 1) is not where it is in";
    check_refused(&["check", a, b, "--fixed", "1"], says);
    std::fs::write(file, "\u{feff}0 0 0 0 1 1 1").unwrap();
    assert_eq!(contacts(&["--bodies", file]), 1);
    std::fs::write(file, "0 0 0 0 1 1 2").unwrap();
    let says = format!("{file}: triangle 3 (counted from 1) joins bodies 1 and 2");
    check_refused(&["check", a, b, "--bodies", file], &says);
    std::fs::write(file, "0 0").unwrap();
    check_refused(&["check", a, b, "--bodies", file], "2 bodies for 7 vertices");
}

pub fn shells_and_man_have_something_to_read() {
    let dir = tempfile::tempdir().unwrap();
    let bash = text(&ccd(&["completions", "bash"]).stdout);
    assert!(bash.contains("--min-distance") && bash.contains("_ccd()"), "{bash}");
    assert!(ccd(&["man", dir.path().to_str().unwrap()]).status.success());
    let page = std::fs::read_to_string(dir.path().join("ccd-check.1")).unwrap();
    assert!(page.contains("min\\-distance") && page.contains("\n.nf\nEXAMPLES:"), "{page}");
    check_refused(&["man", "/no/such/folder"], "/no/such/folder");
}
