//! What there is to choose from, and each of it chosen.

use crate::{ccd, json, obj, text};
use ::ccd::method::{
    BroadPhaseMethod, Builder, Catalogued, Front, Pipeline, Scheduler, Traversal, Volume,
};
use std::path::Path;

/// Keys of the list, options of the command, and names.
fn choices() -> [(&'static str, &'static str, Vec<&'static str>); 7] {
    [
        ("broad_phases", "--broad-phase", names::<BroadPhaseMethod>()),
        ("builders", "--builder", names::<Builder>()),
        ("traversals", "--traversal", names::<Traversal>()),
        ("volumes", "--volume", names::<Volume>()),
        ("pipelines", "--pipeline", names::<Pipeline>()),
        ("schedulers", "--scheduler", names::<Scheduler>()),
        ("fronts", "--front", names::<Front>()),
    ]
}

pub fn the_list_names_every_choice() {
    let all = json(&ccd(&["list", "--json"]));
    let output = text(&ccd(&["list"]).stdout);
    for (key, _, names) in choices() {
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
    let (a, b) = (&*obj(dir.path(), "a.obj", 0.0), &*obj(dir.path(), "b.obj", 1.0));
    let all = json(&ccd(&["list", "--json"]));
    let mut n_choices = 0;
    for (key, option, _) in choices() {
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
}

/// No option of a man page is without text, not even one that `-h` leaves out.
pub fn pages_describe_every_option() {
    let dir = tempfile::tempdir().unwrap();
    let written = ccd(&["man", dir.path().to_str().unwrap()]);
    assert!(written.status.success(), "{}", text(&written.stderr));
    let mut n_options = 0;
    for page in std::fs::read_dir(dir.path()).unwrap() {
        let path = page.unwrap().path();
        let page = std::fs::read_to_string(&path).unwrap();
        let lines: Vec<&str> = page.lines().collect();
        for at in (0..lines.len()).filter(|&at| lines[at] == ".TP") {
            let [option, what] = [lines[at + 1], lines[at + 2]];
            assert!(!what.is_empty() && !what.starts_with('.'), "{}: {option}", path.display());
            n_options += 1;
        }
    }
    assert!(n_options > 100, "{n_options} options");
}

/// The table of the documents names every choice, and no other; the files that it names are there.
pub fn the_documents_name_every_choice() {
    let page = include_str!("../../../docs/ALGORITHMS.md");
    let (_, page) = page.split_once("## The documents, system by system").expect("the section");
    let list = json(&ccd(&["list", "--json"]));
    let options = [
        ("broad_phases", "--broad-phase"),
        ("builders", "--builder"),
        ("traversals", "--traversal"),
        ("volumes", "--volume"),
        ("pipelines", "--pipeline"),
        ("schedulers", "--scheduler"),
        ("fronts", "--front"),
    ];
    let quoted: Vec<&str> = page.split('`').skip(1).step_by(2).collect();
    for (group, option) in options {
        let names = list[group].as_array().expect(group).iter();
        let names: Vec<&str> = names.map(|row| row["name"].as_str().expect("a name")).collect();
        let words: Vec<&str> = quoted.iter().flat_map(|text| text.split_whitespace()).collect();
        let named = words.windows(2).filter(|pair| pair[0] == option).map(|pair| pair[1]);
        let named: std::collections::BTreeSet<&str> = named.collect();
        assert_eq!(named, names.into_iter().collect(), "{option}");
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folders = ["", "ccd-core/src", "ccd-cpu/src/broad_phase", "ccd-shaders/src/broad_phase"];
    for file in quoted.iter().filter(|text| text.ends_with(".rs") || text.ends_with('/')) {
        assert!(folders.iter().any(|folder| root.join(folder).join(file).exists()), "{file}");
    }
}
