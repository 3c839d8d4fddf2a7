//! What there is to choose from, each of it chosen, and combinations that mean nothing.

use crate::{ccd, check_refused, json, obj, text};
use ::ccd::{BroadPhaseMethod, Builder, Catalogued, Front, Pipeline, Scheduler, Traversal, Volume};
use serde_json::Value;

pub fn the_list_names_every_choice() {
    let all = json(&ccd(&["list", "--json"]));
    let output = text(&ccd(&["list"]).stdout);
    for (key, names) in [
        ("broad_phases", names::<BroadPhaseMethod>()),
        ("builders", names::<Builder>()),
        ("traversals", names::<Traversal>()),
        ("volumes", names::<Volume>()),
        ("pipelines", names::<Pipeline>()),
        ("schedulers", names::<Scheduler>()),
        ("fronts", names::<Front>()),
    ] {
        let listed: Vec<&str> =
            all[key].as_array().unwrap().iter().map(|e| e["name"].as_str().unwrap()).collect();
        assert_eq!(listed, names, "{key}");
        for entry in all[key].as_array().unwrap() {
            let keys: Vec<&String> = entry.as_object().unwrap().keys().collect();
            assert_eq!(keys, ["about", "backends", "catalogue", "name", "source"]);
            assert!(!entry["backends"].as_array().unwrap().is_empty(), "{entry} runs nowhere");
            assert!(output.contains(entry["about"].as_str().unwrap()), "{output}");
        }
    }
}

fn names<T: Catalogued>() -> Vec<&'static str> {
    T::ROWS.iter().map(|row| row.name).collect()
}

pub fn every_choice_finds_the_same() {
    let dir = tempfile::tempdir().unwrap();
    let (a, b) = (obj(dir.path(), "a.obj", 0.0), obj(dir.path(), "b.obj", 1.0));
    let (a, b) = (a.to_str().unwrap(), b.to_str().unwrap());
    let all = json(&ccd(&["list", "--json"]));
    let options = [
        ("broad_phases", "--broad-phase"),
        ("builders", "--builder"),
        ("traversals", "--traversal"),
        ("volumes", "--volume"),
        ("pipelines", "--pipeline"),
        ("schedulers", "--scheduler"),
        ("fronts", "--front"),
    ];
    let mut n_choices = 0;
    for (key, option) in options {
        for entry in all[key].as_array().unwrap() {
            let name = entry["name"].as_str().unwrap();
            if !entry["backends"].as_array().unwrap().contains(&"cpu".into()) {
                continue;
            }
            n_choices += 1;
            let found = json(&ccd(&["check", a, b, "--json", "--backend", "cpu", option, name]));
            assert_eq!(found["contacts"]["vf"], 1, "{option} {name}");
            let frames = ["sequence", a, b, a, "--json", "--backend", "cpu", option, name];
            let steps = json(&ccd(&frames));
            assert_eq!(steps["summary"]["contacts"], 2, "{option} {name}");
        }
    }
    assert!(n_choices > 4);
    // Settings reach their method.
    for settings in [
        &["--traversal", "cut", "--cut", "3", "--descent", "both"][..],
        &["--builder", "ploc", "--radius", "2", "--broad-phase", "tree"],
        &["--pipeline", "triangles", "--orphans", "off", "--cones", "on"],
        &["--scheduler", "balanced", "--idle", "100", "--front", "on"],
        &["--scheduler", "stealing", "--traversal", "cut"],
    ] {
        let known = settings.iter().all(|s| s.starts_with('-') || known(&all, s));
        if known {
            let found: Value = json(&ccd(&[&["check", a, b, "--json"], settings].concat()));
            assert_eq!(found["contacts"]["vf"], 1, "{settings:?}");
        }
    }
}

/// A number, or a name that the list has.
fn known(all: &Value, word: &str) -> bool {
    let here = |key: &str| all[key].as_array().unwrap().iter().any(|e| e["name"] == word);
    word.parse::<u32>().is_ok()
        || ["both", "larger", "on", "off"].contains(&word)
        || ["broad_phases", "builders", "traversals", "pipelines", "schedulers"]
            .into_iter()
            .any(here)
}

pub fn combinations_that_mean_nothing_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    let a = obj(dir.path(), "a.obj", 0.0);
    let a = a.to_str().unwrap();
    let refused = |options: &[&str], why: &str| {
        check_refused(&[&["check", a, a, "--backend", "cpu"], options].concat(), why);
    };
    refused(&["--broad-phase", "blocks", "--builder", "lbvh"], "blocks has none");
    refused(&["--broad-phase", "brute-force", "--volume", "aabb"], "brute-force has none");
    refused(&["--builder", "lbvh", "--radius", "8"], "--radius is for --builder ploc, not lbvh");
    refused(&["--limit", "8"], "--limit is for --builder nearest-pair, not lbvh");
    refused(&["--traversal", "half", "--cut", "8"], "--cut is for --traversal cut, not half");
    refused(&["--descent", "both"], "--descent is for --traversal simultaneous and cut, not half");
    refused(&["--traversal", "cut", "--cut", "0"], "it must be from 1 to 1024");
    refused(&["--broad-phase", "by hand"], "by hand");
    refused(&["--cones", "on"], "--cones is for --pipeline triangles, not features");
    refused(&["--scheduler", "stealing", "--traversal", "half"], "`half` has none");
    refused(&["--front", "on", "--broad-phase", "uniform-grid"], "that descend pairs of nodes");
    refused(&["--scheduler", "static", "--idle", "9"], "--idle is for --scheduler balanced");
    refused(&["--scheduler", "balanced", "--idle", "0"], "it must be from 1 to 100");
    let boxes = dir.path().join("boxes.bin");
    std::fs::write(&boxes, [0u8; 24]).unwrap();
    let boxes = boxes.to_str().unwrap();
    check_refused(&["boxes", boxes, "--pipeline", "triangles"], "boxes alone have none");
}
