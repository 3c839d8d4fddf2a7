//! A sequence in parts, joined; and sequences whose positions are in one file.

use crate::{ccd, check_refused, json, obj, text};
use serde_json::Value;
use std::path::Path;
use std::process::Command;

fn frames(dir: &Path, n: usize) -> String {
    let folder = dir.join("frames");
    std::fs::create_dir(&folder).unwrap();
    for i in 0..n {
        obj(&folder, &format!("f{i}.obj"), 0.09 * i as f64);
    }
    folder.to_str().unwrap().to_owned()
}

/// Lines without what differs from run to run: times, and whether trees were built anew.
fn lines(text: &str) -> Vec<Value> {
    let clean = |line: &str| {
        let mut value: Value = serde_json::from_str(line).unwrap();
        for key in ["times_ms", "rebuilt", "median_ms", "total_ms"] {
            value.as_object_mut().unwrap().remove(key);
        }
        value
    };
    text.lines().map(clean).collect()
}

pub fn parts_are_joined_to_the_whole() {
    let dir = tempfile::tempdir().unwrap();
    let folder = frames(dir.path(), 12);
    let whole = text(&ccd(&["sequence", &folder, "--json-lines"]).stdout);
    let write = |name: &str, text: &str| {
        let path = dir.path().join(name);
        std::fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let part = |i: usize, n: usize| {
        let output = ccd(&["sequence", &folder, "--json-lines", "--part", &format!("{i}/{n}")]);
        assert!(output.status.success(), "{}", text(&output.stderr));
        write(&format!("{i}of{n}.jsonl"), &text(&output.stdout))
    };
    // Of 20 parts of 11 steps some are empty.
    for n in [1, 3, 20] {
        let parts: Vec<String> = (1..=n).rev().map(|i| part(i, n)).collect();
        let args: Vec<&str> = ["merge"].into_iter().chain(parts.iter().map(|p| &p[..])).collect();
        let output = ccd(&args);
        assert!(output.status.success(), "{}", text(&output.stderr));
        assert_eq!(lines(&text(&output.stdout)), lines(&whole), "{n} parts");
    }
    let [a, b, c] = [1, 2, 3].map(|i| part(i, 3));
    check_refused(&["merge", &a, &c], "of 3 parts these are missing: 2");
    check_refused(&["merge", &a, &b, &c, &a], "is part 1 of 3, as is");
    check_refused(&["merge", &a, &b, &part(3, 20)], "is one of 20 parts");
    let of_b = std::fs::read_to_string(&b).unwrap();
    let n_lines = of_b.lines().count();
    let cut: String = of_b.lines().take(n_lines - 1).map(|line| format!("{line}\n")).collect();
    check_refused(&["merge", &a, &write("cut.jsonl", &cut), &c], "was not finished");
    let gap: String = of_b.lines().skip(1).map(|line| format!("{line}\n")).collect();
    check_refused(&["merge", &a, &write("gap.jsonl", &gap), &c], "line 1: step 4 is not expected");
    let twice = format!("{}\n{of_b}", of_b.lines().next().unwrap());
    check_refused(&["merge", &a, &write("two.jsonl", &twice), &c], "line 2: step 3 is not");
    check_refused(&["merge", &write("whole.jsonl", &whole)], "without --part");
    check_refused(&["merge", &write("text.jsonl", "hello\n")], "was not finished");
    for (from, to) in [("\"index\":2", "\"index\":0"), ("\"of\":3", "\"of\":0")] {
        assert!(of_b.contains(from), "{of_b}");
        let path = write("none.jsonl", &of_b.replace(from, to));
        check_refused(&["merge", &path], "the first is 1");
    }
    check_refused(&["sequence", &folder, "--part", "4/3"], "i from 1 to n");
    let said = text(&ccd(&["sequence", &folder, "--part", "2/3"]).stdout);
    assert!(said.contains("2 of 3: steps 3 to 6 of 11"), "{said}");
    let none = text(&ccd(&["sequence", &folder, "--part", "1/20"]).stdout);
    assert!(none.contains("\nNo step in this part.\n") && !none.contains("-0"), "{none}");
}

/// The variables of Slurm do nothing unless they are asked for.
pub fn slurm_says_which_part() {
    let dir = tempfile::tempdir().unwrap();
    let folder = frames(dir.path(), 12);
    let run = |part: &[&str], variables: &[(&str, &str)]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_ccd"));
        command.args(["sequence", &folder, "--json"]).args(part);
        for name in ["ID", "COUNT", "MIN", "STEP"] {
            command.env_remove(format!("SLURM_ARRAY_TASK_{name}"));
        }
        command.envs(variables.iter().map(|(name, v)| (format!("SLURM_ARRAY_TASK_{name}"), v)));
        command.output().unwrap()
    };
    let task = [("ID", "7"), ("COUNT", "4"), ("MIN", "5")];
    let all = json(&run(&[], &task));
    assert_eq!((all["steps"].as_array().unwrap().len(), &all["part"]), (11, &Value::Null));
    let third = json(&run(&["--part", "slurm"], &task));
    assert_eq!(third["part"], serde_json::json!({"index": 3, "of": 4, "all_steps": 11}));
    assert_eq!(third["steps"][0]["frame"], 5);
    let output = run(&["--part", "slurm"], &[]);
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("SLURM_ARRAY_TASK_ID is not set"));
}

/// Frames in one file hold the contacts that they hold in files of their own.
pub fn positions_over_time_are_a_sequence() {
    let dir = tempfile::tempdir().unwrap();
    let folder = frames(dir.path(), 4);
    let mesh = format!("{folder}/f0.obj");
    let mut numbers: Vec<f32> = Vec::new();
    for i in 0..4 {
        let frame = ccd::io::read_frame(format!("{folder}/f{i}.obj").as_ref()).unwrap();
        numbers.extend(frame.positions_f32().as_flattened());
    }
    let mut bytes = b"POINTCACHE2\0".to_vec();
    bytes.extend([1u32, 7, 0, 0, 4].iter().flat_map(|n| n.to_le_bytes()));
    bytes.extend(numbers.iter().flat_map(|x| x.to_le_bytes()));
    let cache = dir.path().join("a.pc2");
    std::fs::write(&cache, bytes).unwrap();
    let cache = cache.to_str().unwrap();
    let precision = ["--json", "--precision", "f32"];
    let of = |args: &[&str]| json(&ccd(&[&["sequence"], args, &precision].concat()));
    let (files, one) = (of(&[&folder]), of(&[cache, "--mesh", &mesh]));
    for (at, (f, o)) in
        files["steps"].as_array().unwrap().iter().zip(one["steps"].as_array().unwrap()).enumerate()
    {
        assert_eq!((&f["contacts"], &f["toi"]), (&o["contacts"], &o["toi"]), "step {at}");
        assert_eq!(o["file"], format!("{cache}[{}]", at + 1));
    }
    assert_eq!(files["summary"]["steps"], one["summary"]["steps"]);
    check_refused(&["sequence", cache], "--mesh says");
    check_refused(&["sequence", "nowhere.npz", "--mesh", &mesh], "nowhere.npz: there is no such");
    check_refused(&["sequence", &folder, "--mesh", &mesh], "is for one file");
    let other = dir.path().join("b.obj");
    std::fs::write(&other, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    check_refused(&["sequence", cache, "--mesh", other.to_str().unwrap()], "has 7 vertices");
}
