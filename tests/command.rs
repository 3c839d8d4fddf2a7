//! The command as a user runs it: text, JSON, CSV, pictures, exit status, errors.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A square of two triangles and a triangle above it; `drop` lowers the triangle.
fn obj(dir: &Path, name: &str, drop: f64) -> PathBuf {
    let y = |h: f64| h - drop;
    let text = format!(
        "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 1 0 1\nv 0.3 {} 0.3\nv 0.2 {} 0.3\nv 0.4 {} 0.3\nf 1 2 3\nf 3 2 4\nf 5 6 7\n",
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
    serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("{e}: {}{}", text(&output.stdout), text(&output.stderr)))
}

/// Exit status 2 and a message that says `what`.
fn check_refused(args: &[&str], what: &str) {
    let output = ccd(args);
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{args:?}: {message}");
    assert!(message.contains(what), "{args:?}: {message:?} does not say {what:?}");
    assert!(output.stdout.is_empty(), "{args:?} printed {}", text(&output.stdout));
}

#[test]
fn check_finds_the_contact() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name).to_string_lossy().into_owned();
    let (a, b) = (obj(dir.path(), "a.obj", 0.0), obj(dir.path(), "b.obj", 1.0));
    let (a, b) = (a.to_str().unwrap(), b.to_str().unwrap());
    let (csv, png) = (at("out.csv"), at("out.png"));
    for precision in ["f32", "f64"] {
        let output = ccd(&["check", a, b, "--json", "--contacts", &csv, "--picture", &png, "--precision", precision, "--threads", "2"]);
        assert_eq!(output.status.code(), Some(0));
        let value = json(&output);
        assert_eq!(value["mesh"], serde_json::json!({"vertices": 7, "edges": 8, "faces": 3}));
        assert_eq!(value["contacts"], serde_json::json!({"vf": 1, "ee": 0}));
        assert_eq!((&value["undecided"], &value["backend"], &value["threads"]), (&0.into(), &"cpu".into(), &2.into()));
        assert_eq!(value["precision"], precision);
        let toi = value["toi"].as_f64().unwrap();
        assert!(toi <= 0.5 && toi > 0.5 - 1e-6, "{toi}");
        for key in ["load", "boxes", "build", "traverse", "narrow", "total"] {
            assert!(value["times_ms"][key].as_f64().unwrap() >= 0.0, "{key}");
        }
        let rows = std::fs::read_to_string(&csv).unwrap();
        assert_eq!(rows, format!("kind,a,b,toi,state\nvf,4,0,{toi:?},hit\n"));
        assert_eq!(&std::fs::read(&png).unwrap()[1..4], b"PNG");
    }
    assert_eq!(ccd(&["check", a, b, "--fail-on-contact"]).status.code(), Some(1));
    let free = ccd(&["check", a, a, "--fail-on-contact", "--json"]);
    assert_eq!((free.status.code(), &json(&free)["toi"]), (Some(0), &Value::Null));
    assert!(text(&ccd(&["check", a, b]).stdout).contains("1 vertex-face, 0 edge-edge (0 undecided)"));
    // A contact at a distance comes earlier.
    let near = json(&ccd(&["check", a, b, "--json", "--min-distance", "0.1"]));
    assert!((near["toi"].as_f64().unwrap() - 0.4).abs() < 1e-5, "{near}");
}

#[test]
fn sequence_steps_through_frames() {
    let dir = tempfile::tempdir().unwrap();
    let frames: Vec<String> = (0..5).map(|i| obj(dir.path(), &format!("{i}.obj"), 0.3 * i as f64).to_str().unwrap().to_owned()).collect();
    let (csv, png) = (dir.path().join("out.csv"), dir.path().join("out.png"));
    let mut args = vec!["sequence", "--json", "--contacts", csv.to_str().unwrap(), "--picture", png.to_str().unwrap()];
    args.extend(frames.iter().map(String::as_str));
    let value = json(&ccd(&args));
    let steps = value["steps"].as_array().unwrap();
    assert_eq!(steps.len(), 4);
    assert_eq!(steps[1]["contacts"]["vf"], 1);
    assert_eq!((&value["summary"]["contacts"], &value["summary"]["free_steps"]), (&1.into(), &3.into()));
    assert!(std::fs::read_to_string(&csv).unwrap().starts_with("frame,kind,a,b,toi,state\n1,vf,4,0,"));
    assert_eq!(&std::fs::read(&png).unwrap()[1..4], b"PNG");
    args.retain(|a| *a != "--json");
    assert!(text(&ccd(&args).stdout).contains("4 steps, 3 of them free; 1 contacts"));
}

#[test]
fn queries_are_counted_against_their_answers() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("some-vf.csv");
    // A vertex through a face, and past it; the second answer is wrong on purpose.
    let rows = |x: &str| {
        format!(
            "{x},4,1,1,1,4,1\n0,1,0,1,0,1,1\n1,1,0,1,0,1,1\n0,1,0,1,1,1,1\n{x},4,-1,1,1,4,1\n0,1,0,1,0,1,1\n1,1,0,1,0,1,1\n0,1,0,1,1,1,1\n"
        )
    };
    std::fs::write(&path, rows("1") + &rows("17")).unwrap();
    for precision in ["f32", "f64"] {
        let value = json(&ccd(&["queries", path.to_str().unwrap(), "--json", "--precision", precision]));
        let total = &value["total"];
        let count = |key: &str| total[key].as_u64().unwrap();
        assert_eq!([count("queries"), count("hits"), count("misses")], [2, 1, 1]);
        assert_eq!([count("false_positives"), count("false_negatives")], [0, 1]);
        assert!(total["ns_per_query"].as_f64().unwrap() > 0.0);
        assert_eq!(value["files"][0]["queries"], 2);
        assert_eq!(value["files"][0]["file"], path.to_str().unwrap());
    }
}

#[test]
fn boxes_are_paired() {
    let dir = tempfile::tempdir().unwrap();
    let write = |name: &str, boxes: &[[f32; 6]]| {
        let path = dir.path().join(name);
        std::fs::write(&path, boxes.iter().flatten().flat_map(|c| c.to_le_bytes()).collect::<Vec<_>>()).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let a = write("a.bin", &[[0.0, 0.0, 0.0, 1.0, 1.0, 1.0], [1.0, 1.0, 1.0, 2.0, 2.0, 2.0], [3.0, 0.0, 0.0, 4.0, 1.0, 1.0]]);
    let b = write("b.bin", &[[0.5, 0.5, 0.5, 3.0, 0.75, 0.75]]);
    for method in ["blocks", "tree"] {
        let within = json(&ccd(&["boxes", &a, "--json", "--method", method]));
        assert_eq!((&within["pairs"], &within["boxes"]), (&1.into(), &serde_json::json!([3, 0])));
        let between = json(&ccd(&["boxes", &a, &b, "--json", "--method", method]));
        assert_eq!(between["pairs"], 2);
        assert!(between["times_ms"]["median"].as_f64().unwrap() >= 0.0);
    }
    let broken = dir.path().join("broken.bin");
    std::fs::write(&broken, [0u8; 25]).unwrap();
    check_refused(&["boxes", broken.to_str().unwrap()], "25 bytes");
    let nan = write("nan.bin", &[[f32::NAN, 0.0, 0.0, 1.0, 1.0, 1.0]]);
    check_refused(&["boxes", &nan], "box 0");
}

#[test]
fn bad_use_and_bad_input_end_with_status_2() {
    let dir = tempfile::tempdir().unwrap();
    let a = obj(dir.path(), "a.obj", 0.0);
    let a = a.to_str().unwrap();
    let write = |name: &str, content: &str| {
        let path = dir.path().join(name);
        std::fs::write(&path, content).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let full = std::fs::read_to_string(a).unwrap();
    check_refused(&["check", a], "T1");
    check_refused(&["check", a, "nowhere.ply"], "nowhere.ply");
    check_refused(&["check", a, a, "--min-distance", "-1"], "minimum distance is -1");
    check_refused(&["check", a, a, "--min-distance", "NaN"], "minimum distance is NaN");
    check_refused(&["check", a, a, "--backend", "gpu"], "GPU");
    check_refused(&["check", a, a, "--precision", "f16"], "f16");
    check_refused(&["check", a, &write("short.obj", &full.replace("f 5 6 7\n", ""))], "has 2 faces");
    check_refused(&["check", a, &write("other.obj", &full.replace("f 5 6 7", "f 5 7 6"))], "face 2");
    check_refused(&["check", a, &write("more.obj", &format!("{full}v 0 0 0\n"))], "8 vertices");
    check_refused(&["check", a, &write("nan.obj", &full.replace("v 1 0 1", "v 1 nan 1"))], "vertex 3 at t1 has y = NaN");
    check_refused(&["check", a, &write("inf.obj", &full.replace("v 1 0 1", "v 1 1e999 1"))], "vertex 3 at t1 has y = inf");
    check_refused(&["check", &write("index.obj", &full.replace("f 5 6 7", "f 5 6 70")), a], "face 2 refers to vertex 69");
    check_refused(&["check", a, &write("dir.txt", "x")], ".ply or .obj");
    check_refused(&["sequence", a], "2 values");
    check_refused(&["queries", &write("none.csv", "1,1\n")], "vertex-face");
    check_refused(&["check", a, a, "--contacts", "/nowhere/out.csv"], "/nowhere/out.csv");
    assert_eq!(ccd(&["--help"]).status.code(), Some(0));
    let empty =
        write("empty.ply", "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nend_header\n");
    let value = json(&ccd(&["check", &empty, &empty, "--json"]));
    assert_eq!((&value["mesh"]["vertices"], &value["toi"]), (&0.into(), &Value::Null));
}

#[test]
fn the_demo_ends_without_penetration() {
    let dir = tempfile::tempdir().unwrap();
    let output = ccd(&["demo", "--frames", "2", "--out", dir.path().to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert!(text(&output.stdout).contains("penetration none"), "{}", text(&output.stdout));
    for name in ["last-frame.png", "times.png"] {
        assert_eq!(&std::fs::read(dir.path().join(name)).unwrap()[1..4], b"PNG");
    }
}
