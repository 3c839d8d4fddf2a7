//! Rows of numbers in files: queries, boxes.

use crate::{ccd, check_refused, json};
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
    check_refused(&["boxes", &nan], "box 0");
}
