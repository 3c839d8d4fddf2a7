//! Backends: the GPU against the CPU, which of them is used, and what is said of a GPU.

use crate::{ccd, check_refused, json, text};
use serde_json::Value;
use std::path::Path;
use std::process::Command;

pub fn the_gpu_finds_what_the_cpu_finds() {
    let dir = tempfile::tempdir().unwrap();
    let [a, b] = crumpled_sheet(dir.path(), 20);
    let csv = dir.path().join("out.csv");
    let csv = csv.to_str().unwrap();
    let rows = |args: &[&str]| -> (Value, String) {
        let value = json(&ccd(&[args, &["--json", "--contacts", csv]].concat()));
        (value, std::fs::read_to_string(csv).unwrap())
    };
    for (precision, shaders) in [("f32", &["--shaders", "wgsl"][..]), ("f64", &[])] {
        let check = ["check", a.as_str(), &b];
        let by_triangles =
            [&check[..], &["--pipeline", "triangles", "--free-regions", "on"]].concat();
        let sequence = ["sequence", a.as_str(), &b, &a];
        let by_workers = [&sequence[..], &["--scheduler", "static", "--front", "on"]].concat();
        for command in [&check[..], &sequence, &by_workers, &by_triangles] {
            // By default a GPU has other times.
            let args = [command, &["--precision", precision, "--mode", "conservative"]].concat();
            let (cpu, want) = rows(&[&args[..], &["--backend", "cpu"]].concat());
            assert!(want.lines().count() > 20, "{want}");
            assert_eq!((&cpu["backend"], &cpu["adapter"]), (&"cpu".into(), &Value::Null));
            let (gpu, found) = rows(&[&args[..], &["--backend", "gpu"], shaders].concat());
            let wgsl = json(&ccd(&[&["info", "--json"], shaders].concat()))["shaders"] == "wgsl";
            check_same_contacts(&found, &want, wgsl, &format!("{args:?} {shaders:?}"));
            assert_eq!((&gpu["backend"], &gpu["threads"]), (&"gpu".into(), &Value::Null));
            assert!(!gpu["adapter"].as_str().unwrap().is_empty());
            for key in ["contacts", "candidates", "undecided"] {
                assert_eq!(gpu[key], cpu[key], "{key}");
            }
            let step = |of: &Value| of["steps"].get(1).unwrap_or(of).clone();
            let (gpu, cpu) = (step(&gpu), step(&cpu));
            assert_eq!(gpu["triangles"], cpu["triangles"]);
            for part in ["build", "traverse", "narrow"] {
                let ms = [&gpu, &cpu].map(|of| of["times_ms"][part].is_number());
                assert_eq!(ms, [false, true], "{part}: {gpu}");
                assert!(gpu["times_ms"].get(part).is_some(), "{gpu}");
            }
            let kept = [&gpu, &cpu].map(|of| of["front"]["pairs"].as_u64());
            let is_kept = command.contains(&"--front");
            assert!(kept.iter().all(|kept| (*kept > Some(0)) == is_kept), "{gpu} {cpu}");
        }
    }
    // A refusal of the input is the same refusal, with the file's name.
    let far = crate::obj(dir.path(), "far.obj", 1e200);
    let says = "far.obj: line 5: `-1000";
    check_refused(&["check", &a, &far, "--backend", "gpu"], says);
    let [a, b] = [1.0f32, 2.5].map(|x| {
        let path = dir.path().join(format!("{x}.bin"));
        let boxes: Vec<u8> = (0..300)
            .flat_map(|i| [x * i as f32, 0.0, 0.0, x * i as f32 + 3.0, 1.0, 1.0])
            .flat_map(f32::to_le_bytes)
            .collect();
        std::fs::write(&path, boxes).unwrap();
        path.to_str().unwrap().to_owned()
    });
    for files in [&[a.as_str()][..], &[&a, &b]] {
        let pairs = |backend: &str| {
            json(&ccd(&[&["boxes", "--json", "--runs", "2", "--backend", backend], files].concat()))
                ["pairs"]
                .as_u64()
        };
        assert_eq!(pairs("gpu"), pairs("cpu"));
        assert!(pairs("gpu") > Some(100));
    }
}

pub fn without_a_gpu() {
    let dir = tempfile::tempdir().unwrap();
    let [a, b] = crumpled_sheet(dir.path(), 12);
    let other = tempfile::tempdir().unwrap();
    let large = crumpled_sheet(other.path(), 90);
    let command = |args: &[&str]| {
        let mut ccd = Command::new(env!("CARGO_BIN_EXE_ccd"));
        ccd.args(args).env("WGPU_BACKEND", "noop").env_remove("CCD_ADAPTER");
        ccd
    };
    let without = |args: &[&str]| command(args).output().unwrap();
    let check = |quiet: &[&str]| {
        let output = without(&[&["check", &large[0], &large[1], "--json"], quiet].concat());
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        assert_eq!(json(&output)["backend"], "cpu");
        text(&output.stderr)
    };
    assert_eq!(check(&[]), "ccd: no GPU found; going on with the CPU (`ccd info` says why)\n");
    assert_eq!(check(&["--quiet"]), "");
    let named = command(&["check", &large[0], &large[1]]).env("CCD_ADAPTER", "nowhere").output();
    let said = text(&named.unwrap().stderr);
    assert!(said.contains("CCD_ADAPTER: no adapter has") && said.contains("nowhere"), "{said}");
    // `info` says what there is and what to do.
    let output = without(&["info"]);
    let said = text(&output.stdout);
    assert!(output.status.success() && said.contains("To use a GPU:"), "{said}");
    assert!(said.starts_with("processor"), "{said}");
    let info = json(&without(&["info", "--json"]));
    assert!(info["no_gpu"].is_string() && info["adapter"].is_null(), "{info}");
    // Who names one wants that one.
    for by_hand in [&["check", &a, &b][..], &["check", &a, &b, "--backend", "gpu"], &["info"]] {
        check_refused(&[by_hand, &["--adapter", "no such adapter"]].concat(), "no such adapter");
    }
}

/// OpenGL accepts every kernel and finds nothing, at least in one driver: a missed contact is the
/// worst that can happen, so it is refused.
pub fn opengl_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let [a, b] = crumpled_sheet(dir.path(), 90);
    let run = |backend: &str| {
        let args = ["check", &a, &b, "--json", "--backend", backend];
        Command::new(env!("CARGO_BIN_EXE_ccd"))
            .args(args)
            .env("WGPU_BACKEND", "gl")
            .output()
            .unwrap()
    };
    let refused = run("gpu");
    assert_eq!(refused.status.code(), Some(2));
    assert!(text(&refused.stderr).contains("no GPU"), "{}", text(&refused.stderr));
    assert_eq!(json(&run("auto"))["backend"], "cpu");
}

pub fn info_says_what_there_is() {
    let said = text(&ccd(&["info"]).stdout);
    for word in ["adapter", "backend", "shaders", "timestamps", "flushed", "there are"] {
        assert!(said.contains(word), "{word}: {said}");
    }
    let value = json(&ccd(&["info", "--json", "--shaders", "wgsl"]));
    let name = value["adapter"]["name"].as_str().unwrap();
    assert_eq!(value["shaders"], "wgsl");
    assert!(value["flushed"].is_array(), "{value}");
    assert!(value["adapters"].as_array().unwrap().iter().any(|a| a["name"] == name), "{value}");
    for by in [name, "0"] {
        let one = json(&ccd(&["info", "--json", "--adapter", by]));
        let all = one["adapters"].as_array().unwrap();
        let want = if by == "0" { &all[0]["name"] } else { &value["adapter"]["name"] };
        assert_eq!(&one["adapter"]["name"], want);
    }
    let line = said.lines().find(|line| line.starts_with("there are   0: ")).expect("a list");
    let listed = &line["there are   ".len()..];
    check_refused(&["info", "--adapter", "99"], &format!("\"99\"; there are: {listed}"));
}

/// The answers of built-in scenes, which are checked; those of the CPU are in a snapshot.
pub fn bench_checks_its_answers_on_the_gpu() {
    let answers = |backend: &str| {
        let value =
            json(&ccd(&["bench", "--runs", "1", "--small", "--json", "--backend", backend]));
        let rows = value["rows"].as_array().unwrap().iter();
        let rows = rows.filter(|row| row["what"] != "check and send" && row["what"] != "earliest");
        assert_eq!(value["backend"], backend);
        rows.map(|row| (row["what"].clone(), row["answer"].clone())).collect::<Vec<_>>()
    };
    assert_eq!(answers("gpu"), answers("cpu"));
}

/// A second process takes kernels from the file that the first one left; without a folder to keep
/// them it compiles.
pub fn kernels_are_kept() {
    let dir = tempfile::tempdir().unwrap();
    let [a, b] = crumpled_sheet(dir.path(), 12);
    let run = |cache: &Path| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_ccd"));
        command.args(["check", &a, &b, "--backend", "gpu"]).env_remove("XDG_RUNTIME_DIR");
        // Mesa's own cache, on which nothing here depends: with it only the first run compiles.
        command.env("MESA_SHADER_CACHE_DIR", dir.path().join("mesa"));
        let output =
            command.env("XDG_CACHE_HOME", cache).env("HOME", "/dev/null").output().unwrap();
        assert!(output.status.success(), "{}", text(&output.stderr));
        assert_eq!(text(&output.stderr), "", "nothing is said that was not asked for");
        let said = text(&output.stdout);
        let line =
            said.lines().find(|line| line.starts_with("kernels")).expect("a line").to_owned();
        assert!(line.contains("compiled in "), "{line}");
        line.contains("earlier run")
    };
    let cache = dir.path().join("cache");
    assert!(!run(&cache));
    let files = || std::fs::read_dir(cache.join("ccd")).unwrap().map(|e| e.unwrap().path());
    let kept: Vec<_> = files().collect();
    assert_eq!(kept.len(), 1, "one file, and no part of one: {kept:?}");
    assert!(run(&cache));
    let whole = std::fs::read(&kept[0]).unwrap();
    std::fs::write(&kept[0], &whole[..whole.len() - 1]).unwrap();
    assert!(!run(&cache), "a file that is cut is not used");
    assert!(run(&cache), "and is replaced");
    // Where its folder cannot be made nothing is kept, and nothing is said.
    let other = dir.path().join("other");
    std::fs::create_dir(&other).unwrap();
    std::fs::write(other.join("ccd"), "").unwrap();
    assert!(!run(&other) && !run(&other));
}

/// Two frames of a crumpled grid of `n x n` vertices: contacts everywhere, none of them degenerate.
fn crumpled_sheet(dir: &Path, n: usize) -> [String; 2] {
    let mut random = ccd_testkit::generate::Random::new(7);
    let mut frame = |name: &str| {
        let mut text = String::new();
        for i in 0..n * n {
            let mut jitter = || (random.unit() - 0.5) * 1.5 / n as f64;
            let (u, v) = ((i % n) as f64 / n as f64, (i / n) as f64 / n as f64);
            text += &format!("v {} {} {}\n", u + jitter(), jitter(), v + jitter());
        }
        for i in (0..n * (n - 1)).filter(|i| i % n != n - 1) {
            let [a, b, c, d] = [i + 1, i + 2, i + n + 1, i + n + 2];
            text += &format!("f {a} {c} {b}\nf {b} {c} {d}\n");
        }
        let path = dir.join(name);
        std::fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    [frame("sheet0.obj"), frame("sheet1.obj")]
}

/// The same contacts in files of contacts. A driver may fuse products and sums of WGSL, so with
/// `wgsl` times may differ, within their tolerance.
fn check_same_contacts(found: &str, want: &str, wgsl: bool, input: &str) {
    if !wgsl {
        assert!(found == want, "{input}: found\n{found}want\n{want}");
        return;
    }
    let rows = |text: &str| -> Vec<(String, f64)> {
        // The columns before the time say which contact it is; what is behind depends on it.
        let head = text.lines().next().unwrap().split(',');
        let at = head.clone().position(|name| name == "toi").unwrap();
        let split = |line: &str| line.split(',').map(str::to_owned).collect::<Vec<_>>();
        let row = |c: Vec<String>| (format!("{:?}", (&c[..at], &c[at + 1..at + 7])), c[at].parse());
        text.lines().skip(1).map(split).map(row).map(|(name, toi)| (name, toi.unwrap())).collect()
    };
    let (found, want) = (rows(found), rows(want));
    assert_eq!(found.len(), want.len(), "{input}");
    for (f, w) in found.iter().zip(&want) {
        assert!(
            f.0 == w.0 && (f.1 - w.1).abs() <= ccd::TOI_TOLERANCE,
            "{input}: {f:?}, want {w:?}"
        );
    }
}
