//! What commands write to files: contacts and candidates as rows, pairs of boxes, frames of the
//! demo; and what they say to people.

use crate::{ccd, check_refused, json, obj, text};
use std::path::Path;

/// The rows of a CSV file, without its first line, split.
fn rows(path: &Path) -> (String, Vec<Vec<String>>) {
    let text = std::fs::read_to_string(path).unwrap();
    let (head, rest) = text.split_once('\n').unwrap();
    let split = |line: &str| line.split(',').map(str::to_owned).collect();
    (head.to_owned(), rest.lines().map(split).collect())
}

const COLUMNS: &str = "kind,a,b,toi,state,v0,v1,v2,v3,polygon,px,py,pz,nx,ny,nz,w0,w1,w2,w3";

/// Every column, against the positions in the files.
pub fn contacts_say_where_they_are() {
    let dir = tempfile::tempdir().unwrap();
    // A square as one polygon, a triangle that falls onto it, an edge that falls across its side.
    let frame = |name: &str, y: f64| {
        let text = format!(
            "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0.25 {} 0.5\nv 0.2 2 0.5\nv 0.4 2 0.5\n\
             v -0.5 {} 0.25\nv 0.5 {} 0.25\nf 5 6 7\nf 1 2 3 4\nl 8 9\n",
            y, y, y
        );
        let path = dir.path().join(name);
        std::fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let (a, b) = (frame("a.obj", 0.75), frame("b.obj", -0.25));
    let csv = dir.path().join("out.csv");
    for precision in ["f32", "f64"] {
        let args = ["check", &a, &b, "--contacts", csv.to_str().unwrap(), "--precision", precision];
        assert!(ccd(&args).status.success());
        let (head, rows) = rows(&csv);
        assert_eq!(head, COLUMNS);
        let number = |cell: &String| cell.parse::<f64>().unwrap();
        let of = |from: &[String]| from.iter().map(number).collect::<Vec<f64>>();
        let vf: Vec<_> = rows.iter().filter(|row| row[0] == "vf").collect();
        assert_eq!(vf.len(), 2, "the triangle's corner and the end of the edge: {rows:?}");
        // Faces: the triangle, then the square as two; its second has vertices 0, 2, 3.
        assert_eq!(vf[0][..3], ["vf", "4", "2"]);
        assert_eq!(vf[0][4..10], ["hit", "4", "0", "2", "3", "1"]);
        let close =
            |found: &[f64], want: &[f64]| found.iter().zip(want).all(|(f, w)| (f - w).abs() < 1e-5);
        assert!(close(&[number(&vf[0][3])], &[0.75]), "{vf:?}");
        assert!(close(&of(&vf[0][10..]), &[0.25, 0.0, 0.5, 0.0, 1.0, 0.0, 1.0, 0.5, 0.25, 0.25]));
        let ee: Vec<_> = rows.iter().filter(|row| row[0] == "ee").collect();
        // The side from 0 to 3 is edge 3 of those sorted by the greater vertex.
        let side = ee.iter().find(|row| row[5..9] == ["0", "3", "7", "8"]).expect("the side");
        assert_eq!(side[9], "", "an edge is of no polygon");
        let geometry = of(&side[10..]);
        assert!(close(&geometry[..3], &[0.0, 0.0, 0.25]), "{geometry:?}");
        assert!(
            close(&geometry[3..6], &[0.0, -1.0, 0.0]),
            "from the edge to the side: {geometry:?}"
        );
        assert!(close(&geometry[6..], &[0.75, 0.25, 0.5, 0.5]), "{geometry:?}");
    }
    let sequence = dir.path().join("sequence.csv");
    assert!(
        ccd(&["sequence", &a, &b, &a, "--contacts", sequence.to_str().unwrap()]).status.success()
    );
    let (head, all) = rows(&sequence);
    assert_eq!(head, format!("frame,{COLUMNS}"));
    let first: Vec<_> =
        all.iter().filter(|row| row[0] == "0").map(|row| row[1..].to_vec()).collect();
    assert_eq!(first, rows(&csv).1);
    assert!(all.iter().any(|row| row[0] == "1"));
}

pub fn candidates_are_listed() {
    let dir = tempfile::tempdir().unwrap();
    let (a, b) = (obj(dir.path(), "a.obj", 0.0), obj(dir.path(), "b.obj", 1.0));
    let (a, b) = (a.to_str().unwrap(), b.to_str().unwrap());
    let csv = dir.path().join("out.csv");
    let out = csv.to_str().unwrap();
    for method in ["blocks", "brute-force", "tree"] {
        for precision in ["f32", "f64"] {
            let args = ["check", a, b, "--json", "--candidates", out, "--broad-phase", method];
            let value = json(&ccd(&[&args[..], &["--precision", precision]].concat()));
            let (head, rows) = rows(&csv);
            assert_eq!(head, "kind,a,b");
            let n = |kind: &str| rows.iter().filter(|row| row[0] == kind).count() as u64;
            let counts = serde_json::json!({"vf": n("vf"), "ee": n("ee")});
            assert_eq!(value["candidates"], counts, "{method}");
            assert!(rows.contains(&vec!["vf".into(), "4".into(), "0".into()]), "{rows:?}");
            let key = |row: &Vec<String>| {
                (row[0] == "ee", row[1].parse::<u32>().unwrap(), row[2].parse::<u32>().unwrap())
            };
            assert!(rows.windows(2).all(|w| key(&w[0]) < key(&w[1])), "sorted: {rows:?}");
            assert_eq!(value["contacts"]["vf"], 1, "the step after it is the same");
        }
    }
    let listed = text(&ccd(&["check", a, b, "--candidates", "-"]).stdout);
    assert_eq!(listed, std::fs::read_to_string(&csv).unwrap());
    check_refused(&["check", a, b, "--candidates", "-", "--json"], "standard output");
    check_refused(&["check", a, b, "--candidates", "-", "--contacts", "-"], "standard output");
    check_refused(&["check", a, b, "--candidates", "out.txt"], ".csv");
}

pub fn pairs_of_boxes_are_written() {
    let dir = tempfile::tempdir().unwrap();
    // A row of boxes of which each meets the next two.
    let boxes = |name: &str, n: usize| {
        let number = |i: usize| [i as f32, 0.0, 0.0, i as f32 + 2.0, 1.0, 1.0];
        let bytes: Vec<u8> = (0..n).flat_map(number).flat_map(f32::to_le_bytes).collect();
        let path = dir.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let (a, b) = (boxes("a.bin", 100), boxes("b.bin", 3));
    let out = dir.path().join("pairs.bin");
    let run = |files: &[&str]| -> Vec<[u32; 2]> {
        let args = [&["boxes", "--json", "--pairs", out.to_str().unwrap()], files].concat();
        let n = json(&ccd(&args))["pairs"].as_u64().unwrap();
        let bytes = std::fs::read(&out).unwrap();
        assert_eq!(bytes.len() as u64, 8 * n);
        let number = |b: &[u8]| u32::from_le_bytes([b[0], b[1], b[2], b[3]]);
        bytes.chunks_exact(8).map(|b| [number(b), number(&b[4..])]).collect()
    };
    let near = |a: u32| (a + 1..100.min(a + 3)).map(move |b| [a, b]);
    assert_eq!(run(&[&a]), (0..100).flat_map(near).collect::<Vec<_>>());
    let want =
        (0..5).flat_map(|a: u32| (0..3).filter(move |&b| a.abs_diff(b) <= 2).map(move |b| [a, b]));
    assert_eq!(run(&[&a, &b]), want.collect::<Vec<_>>());
    check_refused(&["boxes", &a, "--pairs", "pairs.csv"], ".bin");
}

pub fn people_are_told_what_it_means() {
    let dir = tempfile::tempdir().unwrap();
    let [a, b, c, low] = [("a", 0.0), ("b", 1.0), ("c", 0.1), ("low", 0.5)].map(|(name, drop)| {
        obj(dir.path(), &format!("{name}.obj"), drop).to_str().unwrap().to_owned()
    });
    let said = |args: &[&str]| {
        let output = ccd(args);
        assert!(output.status.success(), "{args:?}: {}", text(&output.stderr));
        let said = text(&output.stdout);
        for line in said.lines() {
            assert!(line.chars().count() <= 80, "{args:?}: {line:?}");
        }
        said
    };
    let found = said(&["check", &a, &b]);
    // Contact is at 0.5, the time found a little earlier.
    assert!(found.starts_with("First contact just before 50 % of the step.\nmesh"), "{found}");
    assert!(found.contains("(swept boxes overlap)"), "{found}");
    assert!(said(&["check", &a, &c]).starts_with("No contact: the whole step is free.\n"));
    // The corner lies in the square from the start.
    let start = said(&["check", &low, &b]);
    assert!(start.starts_with("There are contacts from the start of the step on.\n"), "{start}");
    assert!(
        start.contains("at t = 0: the first frame may touch or pass through itself"),
        "{start}"
    );
    assert!(start.contains("the first frame touches or passes through itself: 2 pairs\n"));
    let near = said(&["check", &low, &b, "--min-distance", "0.01"]);
    assert!(near.contains("at t = 0: the first frame is or may be within the minimum"), "{near}");
    assert!(start.contains("undecided: too close to tell"), "{start}");
    let steps = said(&["sequence", &a, &c, &b]);
    assert!(steps.contains("First contact after 44.4 % of step 1, to b.obj.\n"), "{steps}");
    let steps = said(&["sequence", &a, &b, &low]);
    assert!(steps.contains("First contact just before 50 % of step 0, to b.obj.\n"), "{steps}");
    assert!(steps.contains(" 4.9999e-1 "), "{steps}");
    assert!(said(&["sequence", &a, &c]).contains("No contact in any step.\n"));
    assert!(!steps.contains(" vv "), "{steps}");
    // Particles have contacts of kinds of their own, in columns that other meshes need not.
    let particles = [0.0, 1.0].map(|x| {
        let path = dir.path().join(format!("{x}.obj"));
        std::fs::write(&path, format!("v {x} 0 0\nv {} 0 0\nv 0 9 0\n", 1.0 - x)).unwrap();
        path.to_str().unwrap().to_owned()
    });
    let steps = said(&["sequence", &particles[0], &particles[1]]);
    let cells = |at: usize| {
        let line = steps.lines().nth(at).unwrap();
        line.split_whitespace().take(6).collect::<Vec<_>>().join(" ")
    };
    assert_eq!([cells(1), cells(2)], ["step vf ee ve vv undec.", "0 0 0 0 1 0"], "{steps}");
}

/// Of a triangle that sticks in another no feature meets one of its kind: there is no contact while
/// they stand still, which is not the same as that they are apart.
pub fn a_first_frame_that_intersects_itself_is_told() {
    let dir = tempfile::tempdir().unwrap();
    let write = |name: &str, [x, y]: [f64; 2]| {
        let path = dir.path().join(name);
        let corners = format!("v {x} -1 .2\nv {x} 1 .2\nv 5 {y} 5\n");
        let text = format!("v 0 0 0\nv 1 0 0\nv 0 0 1\n{corners}f 1 2 3\nf 4 5 6\n");
        std::fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let (inside, deep, apart) =
        (write("0.obj", [0.2, 1.0]), write("1.obj", [0.2, 2.0]), write("2.obj", [3.0, 1.0]));
    let found = serde_json::json!({
        "pairs": 2, "undecided": 0, "example": {"edge": [1, 2], "face": [3, 4, 5]}
    });
    let none = serde_json::json!({"pairs": 0, "undecided": 0, "example": null});
    let status = |args: &[&str]| ccd(&[args, &["--fail-on-contact"]].concat()).status.code();
    for (first, last, want) in [(&inside, &inside, &found), (&apart, &apart, &none)] {
        let value = json(&ccd(&["check", first, last, "--json"]));
        assert_eq!((&value["toi"], &value["intersections"]), (&serde_json::Value::Null, want));
        let is_found = want["pairs"] != 0;
        let text = text(&ccd(&["check", first, last]).stdout);
        assert_eq!(text.starts_with("No contact, but the first frame touches or"), is_found);
        assert_eq!(text.contains("such as edge 1 2 and face 3 4 5 ("), is_found, "{text}");
        assert_eq!(text.contains("whole step is free"), !is_found, "{text}");
        assert_eq!(text.contains("the first frame does not intersect itself"), !is_found);
        assert_eq!(status(&["check", first, last]), Some(is_found as i32));
        assert_eq!(status(&["sequence", first, last]), Some(is_found as i32));
        let text = self::text(&ccd(&["sequence", first, last]).stdout);
        assert_eq!(text.contains("No contact in any step, but the first"), is_found, "{text}");
        // The first part says it, also one without a step; a later frame is the steps' to judge.
        let parts = ["1/3", "2/3", "3/3"].map(|part| {
            let frames = ["sequence", first, &deep, "--json-lines", "--part", part];
            let path = dir.path().join(format!("{}.jsonl", &part[..1]));
            std::fs::write(&path, ccd(&frames).stdout).unwrap();
            path.to_str().unwrap().to_owned()
        });
        let last_line = |args: &[&str]| -> serde_json::Value {
            let lines = self::text(&ccd(args).stdout);
            serde_json::from_str(lines.lines().last().unwrap()).unwrap()
        };
        let read = |path: &str| std::fs::read_to_string(path).unwrap();
        let told = parts.each_ref().map(|path| read(path).contains("\"intersections\""));
        assert_eq!(told, [true, false, false]);
        let merged = last_line(&["merge", &parts[2], &parts[0], &parts[1]]);
        let whole = last_line(&["sequence", first, &deep, "--json-lines"]);
        assert_eq!((&merged["intersections"], &whole["intersections"]), (want, want));
    }
    // Bodies that are not looked at are not looked at here.
    let bodies = dir.path().join("bodies.txt");
    std::fs::write(&bodies, "0 0 0 0 0 0").unwrap();
    let of_bodies = ["--bodies", bodies.to_str().unwrap(), "--no-self-contact"];
    assert_eq!(status(&[&["check", &inside, &deep], &of_bodies[..]].concat()), Some(0));
}

pub fn the_demo_writes_its_frames() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let (out, frames) = (at("out"), at("frames/of/it"));
    let output = ccd(&["demo", "--frames", "2", "--out", &out, "--frames-out", &frames]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let value = json(&ccd(&["sequence", &frames, "--json"]));
    let steps = value["steps"].as_array().unwrap();
    assert_eq!(steps.len(), 2);
    assert!(steps[1]["file"].as_str().unwrap().ends_with("frame-00002.ply"), "{value}");
    assert_eq!(value["mesh"]["vertices"], 4096 + 16384);
    check_refused(&["demo", "--out", &out, "--frames-out", "/dev/null/x"], "/dev/null/x");
}
