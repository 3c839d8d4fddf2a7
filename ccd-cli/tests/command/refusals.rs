//! What is refused: bad use, bad input, each with what is wrong in words.

use crate::{ccd, check_refused, json, obj};
use serde_json::Value;

pub fn bad_use_and_bad_input_end_with_status_2() {
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
    check_refused(&["check", a, a, "--min-distance", "1e300"], "is 1e300; it must be from 0 to");
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
        "triangle 3 (counted from 1)",
    );
    check_refused(&["check", a, &write("more.obj", &format!("{full}v 0 0 0\n"))], "8 vertices");
    check_refused(
        &["check", a, &write("nan.obj", &full.replace("v 1 0 1", "v 1 nan 1"))],
        "nan.obj: line 4: `nan`",
    );
    check_refused(
        &["check", a, &write("far.obj", &full.replace("v 1 0 1", "v 1 1e200 1"))],
        "far.obj: line 4: `1e200` is beyond 1e100",
    );
    check_refused(
        &[
            "check",
            a,
            &write("wide.obj", &full.replace("v 1 0 1", "v 1 1e99 1")),
            "--precision",
            "f32",
        ],
        "wide.obj: vertex 4 (counted from 1): y = inf in f32",
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
        "nan.ply: vertex 1 (counted from 1): y = NaN",
    );
    check_refused(
        &["check", &point, &ply("inf.ply", f64::INFINITY)],
        "inf.ply: vertex 1 (counted from 1): y = inf",
    );
    check_refused(
        &["check", &write("index.obj", &full.replace("f 5 6 7", "f 5 6 70")), a],
        "index.obj: line 10: vertex index 70 names no vertex",
    );
    check_refused(&["check", a, &write("dir.txt", "x")], ".ply, .obj, .off, .stl, .gltf or .glb");
    check_refused(&["sequence", a], "a.obj: a sequence needs two frames or more");
    check_refused(&["queries", &write("none.csv", "1,1\n")], "vertex-face");
    check_refused(&["check", a, a, "--contacts", "/nowhere/out.csv"], "/nowhere/out.csv");
    assert_eq!(ccd(&["--help"]).status.code(), Some(0));
    let empty = write(
        "empty.ply",
        "ply\nformat ascii 1.0\nelement vertex 0\n\
         property float x\nproperty float y\nproperty float z\nend_header\n",
    );
    let value = json(&ccd(&["check", &empty, &empty, "--json"]));
    assert_eq!((&value["mesh"]["vertices"], &value["toi"]), (&0.into(), &Value::Null));
}
