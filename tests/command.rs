//! The command as a user runs it: text, JSON, CSV, pictures, exit status, errors.

use libtest_mimic::{Arguments, Completion, Failed, Trial};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Tests that run anywhere.
const ANYWHERE: &[(&str, fn())] = &[
    ("check_finds_the_contact", check_finds_the_contact),
    ("check_reads_every_line_end_of_obj", check_reads_every_line_end_of_obj),
    ("sequence_steps_through_frames", sequence_steps_through_frames),
    ("queries_are_counted_against_their_answers", queries_are_counted_against_their_answers),
    ("boxes_are_paired", boxes_are_paired),
    ("bad_use_and_bad_input_end_with_status_2", bad_use_and_bad_input_end_with_status_2),
    ("the_demo_ends_without_penetration", the_demo_ends_without_penetration),
    ("auto_goes_on_with_the_cpu", auto_goes_on_with_the_cpu),
    ("opengl_is_refused", opengl_is_refused),
    ("bench_checks_its_answers", bench_checks_its_answers),
];
/// Tests that need a GPU: without one they are ignored with the reason, and counted.
const WITH_GPU: &[(&str, fn())] = &[
    ("info_says_what_there_is", info_says_what_there_is),
    ("the_gpu_finds_what_the_cpu_finds", the_gpu_finds_what_the_cpu_finds),
    ("bench_checks_its_answers_on_the_gpu", bench_checks_its_answers_on_the_gpu),
];

fn main() {
    let passes = |test: fn()| {
        move || {
            test();
            Ok::<_, Failed>(())
        }
    };
    let mut trials: Vec<Trial> = Vec::new();
    trials.extend(ANYWHERE.iter().map(|&(name, test)| Trial::test(name, passes(test))));
    let info = ccd(&["info"]);
    let missing = (!info.status.success()).then(|| text(&info.stderr).trim().to_owned());
    let required = std::env::var("CCD_GPU").is_ok_and(|v| v == "require");
    for &(name, test) in WITH_GPU {
        let missing = missing.clone();
        trials.push(Trial::ignorable_test(name, move || match missing {
            None => {
                test();
                Ok(Completion::Completed)
            }
            Some(why) if required => Err(Failed::from(format!("CCD_GPU=require, but: {why}"))),
            Some(why) => Ok(Completion::ignored_with(why)),
        }));
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

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
    serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|e| panic!("{e}: {}{}", text(&output.stdout), text(&output.stderr)))
}

/// Exit status 2 and a message that says `what`.
fn check_refused(args: &[&str], what: &str) {
    let output = ccd(args);
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{args:?}: {message}");
    assert!(message.contains(what), "{args:?}: {message:?} does not say {what:?}");
    assert!(output.stdout.is_empty(), "{args:?} printed {}", text(&output.stdout));
}

fn check_finds_the_contact() {
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
        assert_eq!(rows, format!("kind,a,b,toi,state\nvf,4,0,{toi:?},hit\n"));
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
fn check_reads_every_line_end_of_obj() {
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

fn sequence_steps_through_frames() {
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
    assert!(
        std::fs::read_to_string(&csv).unwrap().starts_with("frame,kind,a,b,toi,state\n1,vf,4,0,")
    );
    assert_eq!(&std::fs::read(&png).unwrap()[1..4], b"PNG");
    args.retain(|a| *a != "--json");
    assert!(text(&ccd(&args).stdout).contains("4 steps, 3 of them free; 1 contacts"));
}

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

fn boxes_are_paired() {
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
    for method in ccd::METHODS.iter().map(|row| row.name) {
        let within = json(&ccd(&["boxes", &a, "--json", "--method", method]));
        assert_eq!((&within["pairs"], &within["boxes"]), (&1.into(), &serde_json::json!([3, 0])));
        let between = json(&ccd(&["boxes", &a, &b, "--json", "--method", method]));
        assert_eq!(between["pairs"], 2);
        assert!(between["times_ms"]["median"].as_f64().unwrap() >= 0.0);
    }
    check_refused(&["boxes", &a, "--method", "by hand"], "by hand");
    let broken = dir.path().join("broken.bin");
    std::fs::write(&broken, [0u8; 25]).unwrap();
    check_refused(&["boxes", broken.to_str().unwrap()], "25 bytes");
    let nan = write("nan.bin", &[[f32::NAN, 0.0, 0.0, 1.0, 1.0, 1.0]]);
    check_refused(&["boxes", &nan], "box 0");
}

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
    check_refused(&["check", a, a, "--backend", "tpu"], "tpu");
    check_refused(
        &["check", a, a, "--backend", "gpu", "--adapter", "no such adapter"],
        "no such adapter",
    );
    check_refused(&["info", "--adapter", "no such adapter"], "no such adapter");
    check_refused(&["bench", "--size", "0"], "0.0001");
    check_refused(&["check", a, a, "--precision", "f16"], "f16");
    check_refused(
        &["check", a, &write("short.obj", &full.replace("f 5 6 7\n", ""))],
        "has 2 faces",
    );
    check_refused(
        &["check", a, &write("other.obj", &full.replace("f 5 6 7", "f 5 7 6"))],
        "face 2",
    );
    check_refused(&["check", a, &write("more.obj", &format!("{full}v 0 0 0\n"))], "8 vertices");
    check_refused(
        &["check", a, &write("nan.obj", &full.replace("v 1 0 1", "v 1 nan 1"))],
        "nan.obj: line 4: `nan`",
    );
    check_refused(
        &["check", a, &write("far.obj", &full.replace("v 1 0 1", "v 1 1e200 1"))],
        "far.obj: vertex 3 at t1 has y = 10",
    );
    // What text cannot say, bytes can.
    let ply = |name: &str, y: f64| {
        let head = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty double x\n\
            property double y\nproperty double z\nend_header\n";
        let numbers = [0.0, y, 0.0].into_iter().flat_map(f64::to_le_bytes);
        let path = dir.path().join(name);
        std::fs::write(&path, head.bytes().chain(numbers).collect::<Vec<u8>>()).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let point = ply("point.ply", 0.0);
    check_refused(
        &["check", &point, &ply("nan.ply", f64::NAN)],
        "nan.ply: vertex 0 at t1 has y = NaN",
    );
    check_refused(
        &["check", &point, &ply("inf.ply", f64::INFINITY)],
        "inf.ply: vertex 0 at t1 has y = inf",
    );
    check_refused(
        &["check", &write("index.obj", &full.replace("f 5 6 7", "f 5 6 70")), a],
        "face 2 refers to vertex 69",
    );
    check_refused(&["check", a, &write("dir.txt", "x")], ".ply or .obj");
    check_refused(&["sequence", a], "2 values");
    check_refused(&["queries", &write("none.csv", "1,1\n")], "vertex-face");
    check_refused(&["check", a, a, "--contacts", "/nowhere/out.csv"], "/nowhere/out.csv");
    assert_eq!(ccd(&["--help"]).status.code(), Some(0));
    let empty = write(
        "empty.ply",
        "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nend_header\n",
    );
    let value = json(&ccd(&["check", &empty, &empty, "--json"]));
    assert_eq!((&value["mesh"]["vertices"], &value["toi"]), (&0.into(), &Value::Null));
}

fn the_demo_ends_without_penetration() {
    let dir = tempfile::tempdir().unwrap();
    let output = ccd(&["demo", "--frames", "2", "--out", dir.path().to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert!(text(&output.stdout).contains("penetration none"), "{}", text(&output.stdout));
    for name in ["last-frame.png", "times.png"] {
        assert_eq!(&std::fs::read(dir.path().join(name)).unwrap()[1..4], b"PNG");
    }
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
            text += &format!(
                "f {} {} {}\nf {} {} {}\n",
                i + 1,
                i + n + 1,
                i + 2,
                i + 2,
                i + n + 1,
                i + n + 2
            );
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
        // The column of the time, in either kind of file, is the last but one.
        let split = |line: &str| line.rsplit(',').map(str::to_owned).collect::<Vec<_>>();
        text.lines()
            .skip(1)
            .map(split)
            .map(|c| (format!("{:?}", (&c[0], &c[2..])), c[1].parse().unwrap()))
            .collect()
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

fn the_gpu_finds_what_the_cpu_finds() {
    let dir = tempfile::tempdir().unwrap();
    let [a, b] = crumpled_sheet(dir.path(), 20);
    let csv = dir.path().join("out.csv");
    let csv = csv.to_str().unwrap();
    let rows = |args: &[&str]| -> (Value, String) {
        let value = json(&ccd(&[args, &["--json", "--contacts", csv]].concat()));
        (value, std::fs::read_to_string(csv).unwrap())
    };
    for precision in ["f32", "f64"] {
        for command in [&["check", &a, &b][..], &["sequence", &a, &b, &a]] {
            let args = [command, &["--precision", precision]].concat();
            let (cpu, want) = rows(&[&args[..], &["--backend", "cpu"]].concat());
            assert!(want.lines().count() > 20, "{want}");
            assert_eq!((&cpu["backend"], &cpu["adapter"]), (&"cpu".into(), &Value::Null));
            for shaders in [&[][..], &["--shaders", "wgsl"]] {
                let (gpu, found) = rows(&[&args[..], &["--backend", "gpu"], shaders].concat());
                let wgsl =
                    json(&ccd(&[&["info", "--json"], shaders].concat()))["shaders"] == "wgsl";
                check_same_contacts(&found, &want, wgsl, &format!("{args:?} {shaders:?}"));
                assert_eq!((&gpu["backend"], &gpu["threads"]), (&"gpu".into(), &Value::Null));
                assert!(!gpu["adapter"].as_str().unwrap().is_empty());
                for key in ["contacts", "candidates", "undecided"] {
                    assert_eq!(gpu[key], cpu[key], "{key}");
                }
            }
        }
    }
    // A refusal of the input is the same refusal, with the file's name.
    let text = std::fs::read_to_string(&b).unwrap();
    let (first, rest) = text.split_once('\n').unwrap();
    let words: Vec<&str> = first.split(' ').collect();
    let far = dir.path().join("far.obj");
    std::fs::write(&far, format!("v 1e200 {} {}\n{rest}", words[2], words[3])).unwrap();
    check_refused(
        &["check", &a, far.to_str().unwrap(), "--backend", "gpu"],
        "far.obj: vertex 0 at t1 has x = 10",
    );
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

fn auto_goes_on_with_the_cpu() {
    let dir = tempfile::tempdir().unwrap();
    let [a, b] = crumpled_sheet(dir.path(), 12);
    let args = ["check", &a, &b, "--backend", "auto", "--adapter", "no such adapter"];
    let output = ccd(&args);
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{message}");
    assert!(
        message.contains("no such adapter") && message.contains("going on with the CPU"),
        "{message}"
    );
    assert_eq!(json(&ccd(&[&args[..], &["--json"]].concat()))["backend"], "cpu");
    // Where nothing is asked for, a small mesh is no work for a GPU, and that is no news.
    let output = ccd(&["check", &a, &b, "--json"]);
    assert_eq!((&json(&output)["backend"], text(&output.stderr).as_str()), (&"cpu".into(), ""));
}

/// OpenGL accepts every kernel and finds nothing, at least in one driver: a missed contact is the
/// worst that can happen, so it is refused.
fn opengl_is_refused() {
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

fn info_says_what_there_is() {
    let said = text(&ccd(&["info"]).stdout);
    for word in ["adapter", "backend", "shaders", "timestamps", "there are"] {
        assert!(said.contains(word), "{word}: {said}");
    }
    let value = json(&ccd(&["info", "--json", "--shaders", "wgsl"]));
    let name = value["adapter"]["name"].as_str().unwrap();
    assert_eq!(value["shaders"], "wgsl");
    assert!(value["adapters"].as_array().unwrap().iter().any(|a| a["name"] == name), "{value}");
    assert!(json(&ccd(&["info", "--json", "--adapter", name]))["adapter"]["name"] == name);
}

fn bench_checks_its_answers() {
    check_bench("cpu");
    let output = ccd(&["bench", "--runs", "1", "--size", "0.1", "--backend", "cpu"]);
    assert!(text(&output.stdout).contains("320 pairs"));
}

fn bench_checks_its_answers_on_the_gpu() {
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
    let pairs = ccd::METHODS.iter().map(|row| (row.name.into(), "2 pairs".into()));
    assert_eq!(answers[3..], pairs.collect::<Vec<(Value, Value)>>());
    assert!(rows.iter().all(|r| r["median_ms"].as_f64().unwrap() > 0.0));
}
