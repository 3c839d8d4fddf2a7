//! Bad input is refused with what, where and the value; odd but valid input is handled.

use ccd::io::{ReadErrorKind, read_frame, read_queries};
use ccd::{Aabb, BroadPhase, BroadPhaseMethod, Error, Mesh, Options, Session, Verdict, VertexFace};
use std::path::{Path, PathBuf};

const TRIANGLE: [[f64; 3]; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

fn session(options: Options) -> Result<Session, Error> {
    Session::new(Mesh::new(3, &[[0, 1, 2]])?, options)
}

#[test]
fn coordinates_must_be_finite() {
    let mut session = session(Options::default()).unwrap();
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e200] {
        let mut x1 = TRIANGLE;
        x1[2][1] = bad;
        match session.step(&TRIANGLE, &x1) {
            Err(Error::Coordinate { time: 1, vertex: 2, axis: 1, value }) => {
                assert!(value == bad || bad.is_nan())
            }
            other => panic!("{other:?}"),
        }
        assert!(matches!(session.step(&x1, &TRIANGLE), Err(Error::Coordinate { time: 0, .. })));
    }
    assert!(
        session.step(&TRIANGLE, &TRIANGLE).unwrap().contacts.is_empty(),
        "the session goes on after an error"
    );
    let single = TRIANGLE.map(|p| p.map(|c| c as f32));
    let mut bad = single;
    bad[0][2] = f32::NAN;
    assert!(matches!(
        session.step(&single, &bad),
        Err(Error::Coordinate { time: 1, vertex: 0, axis: 2, .. })
    ));
}

#[test]
fn sizes_indices_and_distances_are_checked() {
    assert_eq!(
        Mesh::new(3, &[[0, 1, 3]]),
        Err(Error::Index { element: "face", at: 0, vertex: 3, n_vertices: 3 })
    );
    let mut good = session(Options::default()).unwrap();
    assert_eq!(
        good.step(&TRIANGLE[..2], &TRIANGLE).unwrap_err(),
        Error::VertexCount { time: 0, expected: 3, found: 2 }
    );
    for value in [-1.0, f64::NAN, f64::INFINITY] {
        let error = session(Options::default().with_min_distance(value)).unwrap_err();
        assert!(matches!(error, Error::MinDistance { .. }), "{error}");
    }
    let error = session(Options::default().with_threads(100_000)).unwrap_err();
    assert_eq!(error, Error::Threads { count: 100_000, limit: 1024 });
    assert!(matches!(
        Mesh::new(1 << 31, &[]),
        Err(Error::TooMany { element: "vertices", count: 2_147_483_648, .. })
    ));
    let mut broad = BroadPhase::new(1, BroadPhaseMethod::Blocks).unwrap();
    let bad =
        [Aabb { min: [0.0f32; 3], max: [1.0; 3] }, Aabb { min: [0.0, 2.0, 0.0], max: [1.0; 3] }];
    assert!(matches!(broad.self_pairs(&bad), Err(Error::Box { at: 1, axis: 1, .. })));
}

#[test]
fn empty_meshes_have_no_contacts() {
    for threads in [1, 2] {
        let mut session =
            Session::new(Mesh::new(0, &[]).unwrap(), Options::default().with_threads(threads))
                .unwrap();
        let none: [[f64; 3]; 0] = [];
        assert!(session.step(&none, &none).unwrap().contacts.is_empty());
        assert_eq!(session.earliest_toi(&none, &none).unwrap(), None);
        let mut points =
            Session::new(Mesh::new(5, &[]).unwrap(), Options::default().with_threads(threads))
                .unwrap();
        // Five particles, each in a place of its own.
        let at = |y: f64| [0.0, 1.0, 2.0, 3.0, 4.0].map(|x| [x, y, 0.0]);
        assert!(points.step(&at(0.0), &at(1.0)).unwrap().contacts.is_empty());
    }
}

#[test]
fn degenerate_features_are_closed_sets() {
    // A vertex that falls onto a face of no area, onto its line, and beside it.
    let needle = |x: f64| VertexFace {
        t0: [[x, 1.0, 0.0], [0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]],
        t1: [[x, -1.0, 0.0], [0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]],
    };
    let toi = ccd::vertex_face(&needle(1.5), 0.0).toi().unwrap();
    assert!(toi <= 0.5 && toi > 0.5 - 1e-6, "{toi}");
    assert_eq!(ccd::vertex_face(&needle(2.5), 0.0), Verdict::Miss);
    // All points in one place.
    let point = VertexFace { t0: [[1.0; 3]; 4], t1: [[1.0; 3]; 4] };
    assert_eq!(ccd::vertex_face(&point, 0.0).toi(), Some(0.0));
    let mesh = Mesh::new(7, &[[0, 1, 1], [2, 2, 2], [4, 5, 6]]).unwrap();
    assert_eq!((mesh.n_degenerate(), mesh.edges().len()), (2, 4));
    let report = ccd::step(&mesh, &[[0.5f64; 3]; 7], &[[0.5; 3]; 7], &Options::default()).unwrap();
    assert_eq!(report.toi, Some(0.0));
}

fn write(dir: &Path, name: &str, content: &[u8]) -> PathBuf {
    let path = dir.join(name);
    std::fs::write(&path, content).unwrap();
    path
}

const ASCII: &str = "ply\nformat ascii 1.0\ncomment x\nelement vertex 4\n\
    property double x\nproperty float y\nproperty float z\n\
    property uchar red\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
    0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0.1 1\n4 0 1 2 3\n";

#[test]
fn meshes_are_read_in_every_encoding() {
    let dir = tempfile::tempdir().unwrap();
    let want = read_frame(&write(dir.path(), "a.ply", ASCII.as_bytes())).unwrap();
    assert_eq!(want.faces, [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(want.positions[3], [0.0, 1.0, 0.1f32 as f64]);
    for (format, big) in [("binary_little_endian", false), ("binary_big_endian", true)] {
        let (head, _) = ASCII.split_once("end_header\n").unwrap();
        let mut bytes = format!("{}end_header\n", head.replace("ascii", format)).into_bytes();
        for p in &want.positions {
            bytes.extend(if big { p[0].to_be_bytes() } else { p[0].to_le_bytes() });
            for c in &p[1..] {
                bytes.extend(if big {
                    (*c as f32).to_be_bytes()
                } else {
                    (*c as f32).to_le_bytes()
                });
            }
            bytes.push(1);
        }
        bytes.push(4);
        (0..4i32).for_each(|i| bytes.extend(if big { i.to_be_bytes() } else { i.to_le_bytes() }));
        assert_eq!(read_frame(&write(dir.path(), "b.ply", &bytes)).unwrap(), want, "{format}");
        let error =
            read_frame(&write(dir.path(), "cut.ply", &bytes[..bytes.len() - 30])).unwrap_err();
        assert!(error.to_string().contains("cut.ply"), "{error}");
        let longer = [&bytes[..], &[4]].concat();
        let error = read_frame(&write(dir.path(), "longer.ply", &longer)).unwrap_err();
        assert!(error.to_string().contains("more than the header promises"), "{error}");
        let ended = [&bytes[..], b"\r\n\n"].concat();
        assert_eq!(read_frame(&write(dir.path(), "ended.ply", &ended)).unwrap(), want);
    }
    let obj =
        "# a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvn 0 0 1\nv 0 1 0.10000000149011612\nf 1/1/1 2//1 3 -1\n";
    assert_eq!(read_frame(&write(dir.path(), "a.obj", obj.as_bytes())).unwrap(), want);
}

/// A square of two triangles and a line, with every way to say it, one statement a line.
const STATEMENTS: [&str; 9] = [
    "# a comment, and an empty line",
    "",
    "v 0 0 0",
    "v 1 0 0 1.0 # a weight",
    "v 1 1 0 0.5 0.25 1",
    "vn 0 0 1",
    "\tv  0 1 0.5 1 1 1 0.5 ",
    "f 1/1/1 2//1 3/2 -1",
    "l 1 2/7 3",
];

#[test]
fn obj_lines_end_in_three_ways() {
    let dir = tempfile::tempdir().unwrap();
    for (name, end) in [("lf", "\n"), ("crlf", "\r\n"), ("cr", "\r")] {
        for last in ["", end] {
            let text = STATEMENTS.join(end) + last;
            let frame = read_frame(&write(dir.path(), "a.obj", text.as_bytes())).unwrap();
            let want = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.5]];
            assert_eq!(frame.positions, want, "{name}");
            assert_eq!(
                (&frame.faces[..], &frame.edges[..]),
                (&[[0, 1, 2], [0, 2, 3]][..], &[[0, 1], [1, 2]][..]),
                "{name}"
            );
        }
    }
    // Any mixture, and the number of a line counts all ends before it.
    let mixed = "v 0 0 0\rv 1 0 0\r\n\nv 0 1 0\r\r\nf 1 2 x\r";
    let error = read_frame(&write(dir.path(), "mixed.obj", mixed.as_bytes())).unwrap_err();
    assert!(error.to_string().contains("line 6: `x`"), "{error}");
}

#[test]
fn obj_lines_that_cannot_be_understood_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    let before = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let check = |line: &str, says: &str| {
        let text = format!("{before}{line}\nf 1 2 3\n");
        let found = read_frame(&write(dir.path(), "a.obj", text.as_bytes()));
        let text = found.expect_err(line).to_string();
        assert!(
            text.contains("line 4: ") && text.contains(says),
            "{line:?}: {text:?} does not say {says:?}"
        );
    };
    check("v", "three coordinates");
    check("v 1 2", "three coordinates");
    check("v 1 2 # 3", "three coordinates");
    check("v 1 2 3 x", "`x` is not a number");
    check("v 1 2 3 v 4 5 6", "`v` is not a number");
    check("v 1 2 3 4 5 6 7 8", "not 8");
    check("v 1 2 3 4 5", "not 5");
    check("v 1 2 3 0.5", "weight of a vertex is 0.5");
    check("v 1 2 3 0 0 blue", "`blue`");
    check("v 1 2 3 0 0 0 inf", "`inf` is not a finite number");
    check("v 1 nan 3", "`nan` is not a finite number");
    check("v 1 1e999 3", "`1e999` is not a finite number");
    check("v 1,2,3", "three coordinates");
    check("v 1 2 3\u{b}v 4 5 6", "not text");
    check("v 1 2 \\\n", "three coordinates");
    check("v 1 2 \\\n x", "`x` is not a number");
    check("v 1 2#3", "three coordinates");
    check("vertex 1 2 3", "`vertex`");
    check("1 2 3", "`1`");
    check("f 1 2", "fewer than 3");
    check("f 1 2 3 v 0 0 0", "`v`");
    check("f 1 2 3.0", "`3.0`");
    check("f 1 2 3/x", "`3/x`");
    check("f 1 2 3/0", "`3/0`");
    check("f 1 2 3/1/1/1", "`3/1/1/1`");
    check("f 1 2 /3", "`/3`");
    check("f 1 2 -4", "index -4");
    check("f 1 2 -9223372036854775808", "index -9223372036854775808");
    check("f 1 2 99999999999999999999", "`99999999999999999999`");
    check("l 1", "fewer than 2");
    check("l 1 two", "`two`");
    // The line before is the control: with a line that is fine the same file is read.
    let text = format!("{before}v 0 0 1\nf 1 2 3\n");
    assert_eq!(
        read_frame(&write(dir.path(), "a.obj", text.as_bytes())).unwrap().positions.len(),
        4
    );
}

#[test]
fn obj_is_read_whatever_editor_wrote_it() {
    let dir = tempfile::tempdir().unwrap();
    let read = |text: &[u8]| read_frame(&write(dir.path(), "a.obj", text));
    let plain = read(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let others: [&[u8]; 6] = [
        b"# C:\\\nv 0 0 0\nv 1 0 0 # D:\\\nv 0 \\\n1 0 # E:\\\nf 1 2 3\n",
        b"\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
        b"# W\xfcrfel\no W\xfcrfel\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
        b"v 0 0 0#a\nv 1 0 0 # b\nv 0 1 0 #\nf 1 2 3#1 2 3\n",
        b"v 0 0 \\\n0\nv 1 0 0\nv \\\r\n0 \\\r\n1 0\r\nf 1 2 \\\n3",
        b"v 0 0 \\\r0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
    ];
    for text in others {
        let name = String::from_utf8_lossy(text);
        assert_eq!(read(text).unwrap_or_else(|e| panic!("{name:?}: {e}")), plain, "{name:?}");
    }
    let error = read(b"v 0 0 0\nv 1 0 \\").unwrap_err().to_string();
    assert!(error.contains("line 2: goes on"), "{error}");
}

#[test]
fn bad_files_are_named_with_the_place() {
    let dir = tempfile::tempdir().unwrap();
    let check = |name: &str, content: &[u8], says: &str| {
        let error = read_frame(&write(dir.path(), name, content)).and_then(|f| {
            f.mesh()
                .map_err(|e| ccd::io::ReadError { path: name.into(), kind: ReadErrorKind::Mesh(e) })
        });
        let text = error.expect_err(name).to_string();
        assert!(text.contains(name) && text.contains(says), "{text:?} does not say {says:?}");
    };
    check("garbage.ply", &[0xff, 0x00, 0x80, 0x9c, 0x0a, 0x13], "garbage.ply");
    check("garbage.obj", &[0xff, 0x00, 0x80, 0x9c, 0x0a, 0x13], "line 1");
    check("empty.ply", b"", "end of file");
    check("short.ply", &ASCII.as_bytes()[..ASCII.len() - 12], "line 15: ");
    check("more.ply", format!("{ASCII}\n4 0 1 2 3\n").as_bytes(), "line 18: there is more than");
    check("index.ply", ASCII.replace("4 0 1 2 3", "4 0 1 2 9").as_bytes(), "vertex 9");
    check("negative.ply", ASCII.replace("4 0 1 2 3", "4 0 1 2 -3").as_bytes(), "-3");
    check("two.ply", ASCII.replace("4 0 1 2 3", "2 0 1").as_bytes(), "fewer than 3");
    check(
        "many.ply",
        ASCII.replace("element vertex 4", "element vertex 4294967299").as_bytes(),
        "4294967299",
    );
    check("word.obj", b"v 0 0 zero\n", "line 1: `zero`");
    check("index.obj", b"v 0 0 0\nf 1 2 3\n", "line 2: vertex index 3");
    check("zero.obj", b"v 0 0 0\nf 0 1 1\n", "line 2");
    check("x.txt", b"solid", ".ply, .obj, .off");
    assert!(matches!(read_frame(Path::new("nowhere.ply")).unwrap_err().kind, ReadErrorKind::Io(_)));
    let rows = "0,1,0,1,0,1,1\n".repeat(7);
    let error = read_queries(&write(dir.path(), "q-vf.csv", rows.as_bytes())).unwrap_err();
    assert!(error.to_string().contains("multiple of 8"), "{error}");
    let queries = |name: &str, rows: &str| read_queries(&write(dir.path(), name, rows.as_bytes()));
    let rows = "0,1,0,1,0,1\n".repeat(8);
    let without = queries("q-vf.csv", &rows).unwrap();
    assert_eq!((without.queries.len(), without.answers.len()), (1, 0));
    let error = queries("q-vf.csv", &format!("{rows}0,1,0,1,0,1,1\n")).unwrap_err();
    assert!(error.to_string().contains("line 9: has 7 columns, expected 6"), "{error}");
    let error = queries("q-vf.csv", "0,1,0,1,0\n").unwrap_err();
    assert!(error.to_string().contains("has 5 columns, expected 6 or 7"), "{error}");
    let error = read_queries(&write(dir.path(), "third-ee.csv", b"1,3,0,1,0,1,1\n")).unwrap_err();
    assert!(error.to_string().contains("1/3"), "{error}");
}
