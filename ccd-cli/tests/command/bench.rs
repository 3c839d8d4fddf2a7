//! Built-in scenes that are timed: their answers are checked.

use crate::{ccd, json, text};
use serde_json::Value;

pub fn bench_checks_its_answers() {
    check_bench("cpu");
    let output = ccd(&["bench", "--runs", "1", "--size", "0.1", "--backend", "cpu"]);
    assert!(text(&output.stdout).contains("320 pairs"));
}

pub fn bench_checks_its_answers_on_the_gpu() {
    check_bench("gpu");
}

fn check_bench(backend: &str) {
    let output = ccd(&["bench", "--runs", "1", "--small", "--json", "--backend", backend]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let value = json(&output);
    assert_eq!(value["backend"], backend);
    let rows = value["rows"].as_array().unwrap();
    let answer = |row: &Value| (row["what"].clone(), row["answer"].clone());
    let answers: Vec<(Value, Value)> = rows.iter().map(answer).collect();
    let want = [("candidates", "6,571 vf, 22,876 ee"), ("all contacts", "108 vf, 499 ee")];
    assert_eq!(answers[..2], want.map(|(what, answer)| (what.into(), answer.into())));
    assert_eq!(answers[2].0, "earliest");
    // Every method of the table, in its order.
    let sent = ("check and send", "0.2 MB");
    let boxes =
        [sent, ("blocks", "2 pairs"), ("tree", "2 pairs")].map(|(w, a)| (w.into(), a.into()));
    assert_eq!(answers[3..], boxes[(backend == "cpu") as usize..]);
    assert!(rows.iter().all(|r| r["median_ms"].as_f64().unwrap() > 0.0));
}
