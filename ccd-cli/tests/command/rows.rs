//! Rows of numbers in files: queries, boxes.

use crate::{ccd, check_refused, json, text};
use ::ccd::{BroadPhaseMethod, Catalogued};

pub fn queries_are_counted_against_their_answers() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("some-vf.csv");
    // A vertex through a face, and past it; the second answer is wrong on purpose.
    let rows = |x: &str| {
        format!(
            "{x},4,1,1,1,4,1\n0,1,0,1,0,1,1\n1,1,0,1,0,1,1\n0,1,0,1,1,1,1\n\
             {x},4,-1,1,1,4,1\n0,1,0,1,0,1,1\n1,1,0,1,0,1,1\n0,1,0,1,1,1,1\n"
        )
    };
    std::fs::write(&path, rows("1") + &rows("17")).unwrap();
    for precision in ["f32", "f64"] {
        let value =
            json(&ccd(&["queries", path.to_str().unwrap(), "--json", "--precision", precision]));
        let total = &value["total"];
        let count = |key: &str| total[key].as_u64().unwrap();
        assert_eq!([count("queries"), count("hits"), count("misses")], [2, 1, 1]);
        assert_eq!([count("false_positives"), count("false_negatives")], [0, 1]);
        assert!(total["ns_per_query"].as_f64().unwrap() > 0.0);
        assert_eq!(value["files"][0]["queries"], 2);
        assert_eq!(value["files"][0]["file"], path.to_str().unwrap());
    }
}

/// One vertex through a face, one near it, one far away.
pub fn verdicts_on_queries_are_written() {
    // A name that ends in neither `vf` nor `ee` by chance.
    let dir = tempfile::Builder::new().suffix("-x").tempdir().unwrap();
    let rows = |x: &str, answer: &str| {
        let face = "0,1,0,1,0,1\n1,1,0,1,0,1\n0,1,0,1,1,1\n".replace('\n', &format!("{answer}\n"));
        format!("{x},4,1,1,1,4{answer}\n{face}{x},4,-1,1,1,4{answer}\n{face}")
    };
    let all = |answers: [&str; 3]| {
        ["1", "7", "17"].iter().zip(answers).map(|(x, a)| rows(x, a)).collect::<String>()
    };
    let path = |name: &str, text: &str| {
        let path = dir.path().join(name);
        std::fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let with = path("a, b-vf.csv", &all([",1", ",0", ",0"]));
    let without = path("numbers.csv", &all(["", "", ""]));
    let listed = |args: &[&str]| text(&ccd(&[&["queries", "--out", "-"], args].concat()).stdout);
    for precision in ["f32", "f64"] {
        let precision = ["--precision", precision];
        let rows = listed(&[&[with.as_str()], &precision[..]].concat());
        let rows: Vec<&str> = rows.lines().collect();
        assert_eq!(rows[0], "file,query,kind,verdict,toi,answer");
        let toi = rows[1].split(',').nth_back(1).unwrap().parse::<f64>().unwrap();
        assert!(toi <= 0.5 && toi > 0.5 - 1e-6, "{rows:?}");
        assert!(rows[1].starts_with(&format!("\"{with}\",0,vf,hit,0.4")), "{rows:?}");
        assert!(rows[2].ends_with("b-vf.csv\",1,vf,far,,0"), "{rows:?}");
        assert!(rows[3].ends_with("b-vf.csv\",2,vf,far,,0"), "{rows:?}");
        // The second passes the corner (1, 0, 0) by (0.75, 0.25), its box that of the face by 0.75.
        let near = |d: &str| {
            let args = [&without, "--kind", "vf", "--min-distance", d];
            let rows = listed(&[&args[..], &precision].concat());
            rows.lines()
                .skip(1)
                .map(|l| l.split(',').nth(3).unwrap().to_owned())
                .collect::<Vec<_>>()
        };
        assert_eq!(near("0.8"), ["hit", "hit", "far"]);
        assert_eq!(near("0.76"), ["hit", "miss", "far"]);
        assert_eq!(near("0.7"), ["hit", "far", "far"]);
        let total =
            |args: &[&str]| json(&ccd(&[&["queries", "--json"], args].concat()))["total"].clone();
        let none = serde_json::Value::Null;
        let of = total(&[&without, "--kind", "vf"]);
        assert_eq!(
            (&of["far"], &of["false_positives"], &of["false_negatives"]),
            (&2.into(), &none, &none)
        );
        let of = total(&[&with, "--min-distance", "0.8"]);
        assert_eq!(
            (&of["hits"], &of["false_positives"], &of["false_negatives"]),
            (&2.into(), &none, &0.into())
        );
        let of = total(&[&with]);
        assert_eq!(
            (&of["far"], &of["misses"], &of["false_positives"]),
            (&2.into(), &2.into(), &0.into())
        );
    }
    check_refused(&["queries", &without], "neither vertex-face");
    check_refused(&["queries", &with, "--min-distance", "-1"], "minimum distance is -1");
    check_refused(&["queries", &with, "--out", "-", "--json"], "standard output");
    // Files of one name are told apart by their folders, without those that all are in.
    let [one, other] = ["one", "other"].map(|folder| {
        let folder = dir.path().join(folder);
        std::fs::create_dir(&folder).unwrap();
        let path = folder.join("vf.csv");
        std::fs::copy(&with, &path).unwrap();
        path.to_str().unwrap().to_owned()
    });
    let names = |files: &[&str]| {
        let said = text(&ccd(&[&["queries"], files].concat()).stdout);
        let name = |line: &str| line.rsplit("  ").next().unwrap().to_owned();
        said.lines().skip(1).take(files.len()).map(name).collect::<Vec<_>>().join(" ")
    };
    assert_eq!(names(&[&one]), "vf.csv");
    assert_eq!(names(&[&one, &other]), "one/vf.csv other/vf.csv");
    let edges = listed(&[&without, "--kind", "ee"]);
    assert!(edges.lines().nth(1).unwrap().contains(",0,ee,"), "{edges}");
}

pub fn boxes_are_paired() {
    let dir = tempfile::tempdir().unwrap();
    let write = |name: &str, boxes: &[[f32; 6]]| {
        let path = dir.path().join(name);
        std::fs::write(
            &path,
            boxes.iter().flatten().flat_map(|c| c.to_le_bytes()).collect::<Vec<_>>(),
        )
        .unwrap();
        path.to_str().unwrap().to_owned()
    };
    let a = write(
        "a.bin",
        &[
            [0.0, 0.0, 0.0, 1.0, 1.0, 1.0],
            [1.0, 1.0, 1.0, 2.0, 2.0, 2.0],
            [3.0, 0.0, 0.0, 4.0, 1.0, 1.0],
        ],
    );
    let b = write("b.bin", &[[0.5, 0.5, 0.5, 3.0, 0.75, 0.75]]);
    for method in BroadPhaseMethod::ROWS.iter().map(|row| row.name) {
        let within = json(&ccd(&["boxes", &a, "--json", "--broad-phase", method]));
        assert_eq!((&within["pairs"], &within["boxes"]), (&1.into(), &serde_json::json!([3, 0])));
        let between = json(&ccd(&["boxes", &a, &b, "--json", "--broad-phase", method]));
        assert_eq!(between["pairs"], 2);
        assert!(between["times_ms"]["median"].as_f64().unwrap() >= 0.0);
    }
    check_refused(&["boxes", &a, "--broad-phase", "by hand"], "by hand");
    let broken = dir.path().join("broken.bin");
    std::fs::write(&broken, [0u8; 25]).unwrap();
    check_refused(&["boxes", broken.to_str().unwrap()], "25 bytes");
    let nan = write("nan.bin", &[[f32::NAN, 0.0, 0.0, 1.0, 1.0, 1.0]]);
    check_refused(&["boxes", &nan], "nan.bin: box 1 (counted from 1) has x from NaN to 1");
    check_refused(&["boxes", &a, &nan], "nan.bin: box 1");
}
