//! Text and bytes in every way that editors and programs write them.

use crate::{check_refused, read, write};
use ccd::io::read_queries;

const ASCII: &str = "ply\nformat ascii 1.0\ncomment x\nelement vertex 4\n\
    property double x\nproperty float y\nproperty float z\n\
    property uchar red\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
    0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0.1 1\n4 0 1 2 3\n";

#[test]
fn meshes_are_read_in_every_encoding() {
    let want = read("a.ply", ASCII.as_bytes()).unwrap();
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
        assert_eq!(read("b.ply", &bytes).unwrap(), want, "{format}");
        check_refused("cut.ply", &bytes[..bytes.len() - 30], "cut.ply");
        let longer = [&bytes[..], &[4]].concat();
        check_refused("longer.ply", &longer, "more than the header promises");
        let ended = [&bytes[..], b"\r\n\n"].concat();
        assert_eq!(read("ended.ply", &ended).unwrap(), want);
    }
    let obj =
        "# a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvn 0 0 1\nv 0 1 0.10000000149011612\nf 1/1/1 2//1 3 -1\n";
    assert_eq!(read("a.obj", obj.as_bytes()).unwrap(), want);
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
    for (name, end) in [("lf", "\n"), ("crlf", "\r\n"), ("cr", "\r")] {
        for last in ["", end] {
            let text = STATEMENTS.join(end) + last;
            let frame = read("a.obj", text.as_bytes()).unwrap();
            let want = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.5]];
            assert_eq!(frame.positions, want, "{name}");
            assert_eq!(frame.faces, [[0, 1, 2], [0, 2, 3]], "{name}");
            assert_eq!(frame.edges, [[0, 1], [1, 2]], "{name}");
        }
    }
    // Any mixture, and the number of a line counts all ends before it.
    let mixed = b"v 0 0 0\rv 1 0 0\r\n\nv 0 1 0\r\r\nf 1 2 x\r";
    check_refused("mixed.obj", mixed, "line 6: `x`");
}

#[test]
fn obj_is_read_whatever_editor_wrote_it() {
    let read = |text: &[u8]| read("a.obj", text);
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
    // The time of a line is its own, however much there is of its statement already.
    let [head, lines] = [b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 ".to_vec(), b"\\\n".repeat(1 << 20)];
    assert_eq!(read(&[head, lines, b"3\n".to_vec()].concat()).unwrap(), plain);
}

#[test]
fn ply_is_read_whatever_program_wrote_it() {
    let plain = read("a.ply", ASCII.as_bytes()).unwrap();
    let latin_1 = ASCII.replace("comment x", "comment W~rfel");
    let latin_1: Vec<u8> = latin_1.bytes().map(|b| if b == b'~' { 0xfc } else { b }).collect();
    let points = ASCII.replace("\n1 1 0 1\n", "\n1. +1.e0 -.0 1\n").replace(" 0.1 1\n", "\t.1 1\n");
    for text in [&latin_1[..], points.as_bytes()] {
        assert_eq!(read("a.ply", text).unwrap(), plain);
    }
}

#[test]
fn rows_of_queries_are_whole() {
    let dir = tempfile::tempdir().unwrap();
    let queries = |rows: &str| read_queries(&write(dir.path(), "q-vf.csv", rows.as_bytes()));
    let rows = "0,1,0,1,0,1\n".repeat(8);
    let without = queries(&rows).unwrap();
    assert_eq!((without.queries.len(), without.answers.len()), (1, 0));
    for (rows, says) in [
        ("0,1,0,1,0,1,1\n".repeat(7), "multiple of 8"),
        (format!("{rows}0,1,0,1,0,1,1\n"), "line 9: has 7 columns, expected 6"),
        ("0,1,0,1,0\n".to_owned(), "has 5 columns, expected 6 or 7"),
        ("1,3,0,1,0,1,1\n".to_owned(), "1/3"),
    ] {
        let error = queries(&rows).unwrap_err().to_string();
        assert!(error.contains(says), "{error}");
    }
}
