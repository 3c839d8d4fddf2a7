//! Steps of meshes: two frames, many frames, a simulation.

use crate::{ccd, check_refused, json, obj, text};
use serde_json::Value;

pub fn check_finds_the_contact() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name).to_string_lossy().into_owned();
    let (a, b) = (obj(dir.path(), "a.obj", 0.0), obj(dir.path(), "b.obj", 1.0));
    let (a, b) = (a.to_str().unwrap(), b.to_str().unwrap());
    let (csv, png) = (at("out.csv"), at("out.png"));
    for precision in ["f32", "f64"] {
        let output = ccd(&[
            "check",
            a,
            b,
            "--json",
            "--contacts",
            &csv,
            "--picture",
            &png,
            "--precision",
            precision,
            "--threads",
            "2",
        ]);
        assert_eq!(output.status.code(), Some(0));
        let value = json(&output);
        assert_eq!(value["mesh"], serde_json::json!({"vertices": 7, "edges": 8, "faces": 3}));
        assert_eq!(value["contacts"], serde_json::json!({"vf": 1, "ee": 0}));
        assert_eq!(
            (&value["undecided"], &value["backend"], &value["threads"]),
            (&0.into(), &"cpu".into(), &2.into())
        );
        assert_eq!(value["precision"], precision);
        let toi = value["toi"].as_f64().unwrap();
        assert!(toi <= 0.5 && toi > 0.5 - 1e-6, "{toi}");
        for key in ["load", "boxes", "build", "traverse", "narrow", "total"] {
            assert!(value["times_ms"][key].as_f64().unwrap() >= 0.0, "{key}");
        }
        let rows = std::fs::read_to_string(&csv).unwrap();
        let row = format!("\nvf,4,0,{toi:?},hit,4,0,1,2,0,0.3");
        assert!(rows.starts_with("kind,a,b,toi,state,") && rows.contains(&row), "{rows}");
        assert_eq!(rows.lines().count(), 2);
        assert_eq!(&std::fs::read(&png).unwrap()[1..4], b"PNG");
    }
    assert_eq!(ccd(&["check", a, b, "--fail-on-contact"]).status.code(), Some(1));
    let free = ccd(&["check", a, a, "--fail-on-contact", "--json"]);
    assert_eq!((free.status.code(), &json(&free)["toi"]), (Some(0), &Value::Null));
    assert!(
        text(&ccd(&["check", a, b]).stdout).contains("1 vertex-face, 0 edge-edge (0 undecided)")
    );
    // A contact at a distance comes earlier.
    let near = json(&ccd(&["check", a, b, "--json", "--min-distance", "0.1"]));
    assert!((near["toi"].as_f64().unwrap() - 0.4).abs() < 1e-5, "{near}");
}

/// The same files with line ends of old Macs hold the same contact; a line that is not understood
/// ends the command.
pub fn check_reads_every_line_end_of_obj() {
    let dir = tempfile::tempdir().unwrap();
    let frames = [obj(dir.path(), "a.obj", 0.0), obj(dir.path(), "b.obj", 1.0)];
    let texts = frames.each_ref().map(|path| std::fs::read_to_string(path).unwrap());
    let [a, b] = frames.each_ref().map(|path| path.to_str().unwrap());
    for end in ["\n", "\r\n", "\r"] {
        for (path, text) in frames.iter().zip(&texts) {
            std::fs::write(path, text.replace('\n', end)).unwrap();
        }
        let output = ccd(&["check", a, b, "--json", "--fail-on-contact"]);
        assert_eq!(output.status.code(), Some(1), "{end:?}: {}", text(&output.stderr));
        assert_eq!(json(&output)["contacts"], serde_json::json!({"vf": 1, "ee": 0}), "{end:?}");
    }
    std::fs::write(&frames[1], texts[1].replacen("v 1 0 0", "v 1 0 0 x", 1)).unwrap();
    check_refused(&["check", a, b], "b.obj: line 2: `x` is not a number");
}

pub fn sequence_steps_through_frames() {
    let dir = tempfile::tempdir().unwrap();
    let frames: Vec<String> = (0..5)
        .map(|i| obj(dir.path(), &format!("{i}.obj"), 0.3 * i as f64).to_str().unwrap().to_owned())
        .collect();
    let (csv, png) = (dir.path().join("out.csv"), dir.path().join("out.png"));
    let mut args = vec![
        "sequence",
        "--json",
        "--contacts",
        csv.to_str().unwrap(),
        "--picture",
        png.to_str().unwrap(),
    ];
    args.extend(frames.iter().map(String::as_str));
    let value = json(&ccd(&args));
    let steps = value["steps"].as_array().unwrap();
    assert_eq!(steps.len(), 4);
    assert_eq!(steps[1]["contacts"]["vf"], 1);
    assert_eq!(
        (&value["summary"]["contacts"], &value["summary"]["free_steps"]),
        (&1.into(), &3.into())
    );
    let rows = std::fs::read_to_string(&csv).unwrap();
    assert!(
        rows.starts_with("frame,kind,a,b,toi,state,") && rows.contains("\n1,vf,4,0,"),
        "{rows}"
    );
    assert_eq!(&std::fs::read(&png).unwrap()[1..4], b"PNG");
    args.retain(|a| *a != "--json");
    assert!(text(&ccd(&args).stdout).contains("4 steps, 3 of them free; 1 contacts"));
}

pub fn the_demo_ends_without_penetration() {
    let dir = tempfile::tempdir().unwrap();
    let output = ccd(&["demo", "--frames", "2", "--out", dir.path().to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert!(text(&output.stdout).contains("penetration none"), "{}", text(&output.stdout));
    for name in ["last-frame.png", "times.png"] {
        assert_eq!(&std::fs::read(dir.path().join(name)).unwrap()[1..4], b"PNG");
    }
}
