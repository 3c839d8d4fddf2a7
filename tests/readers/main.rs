//! Every format of meshes and of positions over time: what is read, and what is refused with which
//! words.

mod gltf;
#[path = "../../fuzz/fuzz_targets/memory.rs"]
mod memory;
mod over_time;
mod refused;
mod texts;

use ccd::io::{Frame, read_frame, read_frame_as, read_frame_from};
use std::io::Read;
use std::path::{Path, PathBuf};

fn write(dir: &Path, name: &str, content: &[u8]) -> PathBuf {
    let path = dir.join(name);
    std::fs::write(&path, content).unwrap();
    path
}

fn read(name: &str, content: &[u8]) -> Result<Frame, String> {
    let dir = tempfile::tempdir().unwrap();
    read_frame(&write(dir.path(), name, content)).map_err(|e| {
        let text = e.to_string();
        assert!(text.contains(name), "{text:?} names the file");
        text
    })
}

fn check_refused(name: &str, content: &[u8], says: &str) {
    let text = read(name, content).expect_err(says);
    assert!(text.contains(says), "{text:?} does not say {says:?}");
}

fn gzip(content: &[u8]) -> Vec<u8> {
    let mut packed = flate2::write::GzEncoder::new(Vec::new(), Default::default());
    std::io::Write::write_all(&mut packed, content).unwrap();
    packed.finish().unwrap()
}

/// A square of one polygon and a triangle beside it.
const POSITIONS: [[f64; 3]; 5] =
    [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.25], [2.0, 0.0, 0.1]];
const FACES: [[u32; 3]; 3] = [[0, 1, 2], [0, 2, 3], [1, 4, 2]];

#[test]
fn polygons_are_remembered() {
    let ply = "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\n\
        property double z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n\
        0 0 0\n1 0 0\n1 1 0\n0 1 0.25\n2 0 0.1\n4 0 1 2 3\n3 1 4 2\n";
    let obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.25\nv 2 0 0.1\nf 1 2 3 4\nf 2 5 3\n";
    let off = "OFF\n# a comment\n5 2 0\n0 0 0\n1 0 0 # here, too\n1 1 0\n\n0 1 0.25\n2 0 0.1\n\
        4 0 1 2 3 255 0 0\n3 1 4 2\n";
    for (name, text) in [("a.ply", ply), ("a.obj", obj), ("a.off", off)] {
        let frame = read(name, text.as_bytes()).unwrap();
        assert_eq!(frame.positions, POSITIONS, "{name}");
        assert_eq!((&frame.faces[..], &frame.polygons[..]), (&FACES[..], &[0, 0, 1][..]), "{name}");
    }
}

/// A triangle without area does not hide that the one behind it turns against the one before.
#[test]
fn polygons_that_fold_are_counted() {
    for (corners, folded) in [("1 2 3 4", 0), ("2 3 4 1", 1), ("2 3 4 4 1", 1), ("2 2 3 4 1", 1)] {
        let text = format!("v 0 0 0\nv 2 0 0\nv 0.5 0.5 0\nv 0 2 0\nf {corners}\nf 1 3 2\n");
        assert_eq!(read("a.obj", text.as_bytes()).unwrap().folded_polygons(), folded, "{corners}");
    }
}

/// What is read of a file is read of it when it is compressed, and of a stream, by its first bytes.
#[test]
fn compressed_files_and_streams_are_read() {
    let solid: String = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
        .map(|p| format!("vertex {} {} {}\n", p[0], p[1], p[2]))
        .concat();
    let solid =
        format!("solid\nfacet normal 0 0 1\nouter loop\n{solid}endloop\nendfacet\nendsolid\n");
    let mut binary = vec![b' '; 80];
    binary.extend(1u32.to_le_bytes());
    binary
        .extend([0f32, 0., 1., 0., 0., 0., 1., 0., 0., 0., 1., 0.].map(f32::to_le_bytes).concat());
    binary.extend([0; 2]);
    let ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
        property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
        0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    let off = "\u{feff}# by hand\n\n  # again\nCOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    let obj = "\u{feff}# solid\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let data = "data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    let gltf = format!(
        r#" {{"asset":{{"version":"2.0"}},"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
        "min":[0,0,0],"max":[1,1,0]}}],"bufferViews":[{{"buffer":0,"byteLength":36}}],
        "buffers":[{{"byteLength":36,"uri":"{data}"}}]}}"#
    );
    let files: [(&str, &[u8]); 6] = [
        ("a.ply", ply.as_bytes()),
        ("a.obj", obj.as_bytes()),
        ("a.off", off.as_bytes()),
        ("a.stl", solid.as_bytes()),
        ("b.stl", &binary),
        ("a.gltf", gltf.as_bytes()),
    ];
    for (name, content) in files {
        let want = read(name, content).unwrap();
        assert_eq!(want.positions, [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], "{name}");
        assert_eq!(want.faces, [[0, 1, 2]], "{name}");
        let packed = gzip(content);
        // In several members, as `cat a.gz b.gz` has them.
        let parts = [gzip(&content[..9]), gzip(&content[9..])].concat();
        for (ending, content) in [(".gz", &packed), (".GZ", &parts), ("", &packed)] {
            let frame = read(&format!("{name}{ending}"), content);
            assert_eq!(frame.as_ref(), Ok(&want), "{name}{ending}");
        }
        let end = name.rsplit('.').next();
        for (content, format) in [(content, None), (&packed, None), (content, end)] {
            // In pieces, as a pipe has them.
            let (first, rest) = content.split_at(1);
            let frame = read_frame_from(first.chain(rest), "-".as_ref(), format);
            assert_eq!(frame.map_err(|e| e.to_string()), Ok(want.clone()), "{name} {format:?}");
        }
        let (cut, mut changed) = (&packed[..packed.len() - 9], packed.clone());
        *changed.iter_mut().nth_back(7).unwrap() ^= 1;
        for broken in [cut, &changed] {
            assert!(read(&format!("{name}.gz"), broken).is_err(), "{name}");
        }
    }
    let why = read_frame_from(ply.as_bytes(), "a stream".as_ref(), Some("doc")).unwrap_err();
    assert!(why.to_string().starts_with("a stream: unknown kind of file; expected .ply"), "{why}");
}

#[test]
fn off_is_read_in_its_variants() {
    let body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    let want = read("a.off", format!("OFF\n3 1 3\n{body}").as_bytes()).unwrap();
    assert_eq!(want.faces, [[0, 1, 2]]);
    let colours = "COFF\r\n3 1\r\n0 0 0 1 0 0 1\r\n1 0 0 0 1 0 1\r\n0 1 0 0 0 1 1\r\n3 0 1 2\r\n";
    for text in
        [format!("OFF 3 1 3\n{body}"), format!("# x\nNOFF\n3 1 0 # y\n{body}"), colours.into()]
    {
        assert_eq!(read("a.off", text.as_bytes()).unwrap(), want, "{text:?}");
    }
    check_refused("bad.off", b"", "empty");
    check_refused("bad.off", b"OFF\n2 0 0\n0 0 0\n", "vertex 1 (counted from 0): the file ends");
}

/// Two triangles with a common side: six corners, four vertices.
const TRIANGLES: [[[f32; 3]; 3]; 2] = [
    [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.5]],
    [[0.0, 1.0, 0.5], [1.0, -0.0, 0.0], [1.0, 1.0, 0.0]],
];

#[test]
fn stl_is_read_as_text_and_binary() {
    let mut text = String::from("solid first  solid\n");
    let mut binary = vec![b' '; 80];
    binary[..5].copy_from_slice(b"solid");
    binary.extend(2u32.to_le_bytes());
    for (k, corners) in TRIANGLES.iter().enumerate() {
        // A text may hold several solids.
        text += if k == 1 { "endsolid first\nSOLID\n" } else { "" };
        text += "  facet normal 0 0 1\n    outer loop\n";
        binary.extend([0u8; 12]);
        for p in corners {
            text += &format!("      vertex {:e} {} {}\n", p[0], p[1], p[2]);
            binary.extend(p.iter().flat_map(|c| c.to_le_bytes()));
        }
        text += "    endloop\n  endfacet\n";
        binary.extend([7, 0]);
    }
    text += "endsolid\n";
    let want = read("a.stl", &binary).unwrap();
    assert_eq!(want.positions.len(), 4, "vertices in one place are one, both zeros too");
    assert_eq!((&want.faces[..], &want.polygons[..]), (&[[0, 1, 2], [2, 1, 3]][..], &[0, 1][..]));
    assert_eq!(read("b.stl", text.as_bytes()).unwrap(), want);
    assert_eq!(read("crlf.stl", text.replace('\n', "\r\n").as_bytes()).unwrap(), want);
    let tenth = text.replace(" 0.5\n", " 0.1\n");
    assert_eq!(read("wide.stl", tenth.as_bytes()).unwrap().positions[2], [0.0, 1.0, 0.1]);

    check_refused("short.stl", &binary[..binary.len() - 1], "line 1");
    binary[0] = b'x';
    check_refused(
        "long.stl",
        &[&binary[..], &[0]].concat(),
        "promises 2 triangles, which take 184",
    );
    check_refused("open.stl", text.trim_end_matches("endsolid\n").as_bytes(), "ends within");
}

#[test]
fn files_that_are_cut_short_are_refused() {
    check_refused("a.glb", b"glTF\x02\0\0\0\x03\0\0\0", "the file is cut short");
    check_refused("a.glb", b"gl", "the file is cut short");
    check_refused("b.glb", b"glTF\x02\0\0\0\xff\0\0\0{", "the file is cut short");
    check_refused("a.ply", b"", "the file is empty");
    for (name, says) in [("garbage.ply", "garbage.ply"), ("garbage.obj", "line 1")] {
        check_refused(name, &[0xff, 0x00, 0x80, 0x9c, 0x0a, 0x13], says);
    }
    let why = read_frame(Path::new("nowhere.ply")).unwrap_err().kind;
    assert!(matches!(why, ccd::io::ReadErrorKind::Io(_)));
}

#[test]
fn files_of_other_kinds_are_named() {
    let utf16: Vec<u8> = "v 0 0 0\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    check_refused("a.obj", &[b"\xff\xfe", &utf16[..]].concat(), "UTF-16");
    check_refused("a.ply", b"\x89PNG\r\n\x1a\n", "a picture (PNG)");
    check_refused("a.stl", &gzip(b"\x1f\x8b\x08\0"), "gzip twice");
    check_refused("a.off", b"PK\x03\x04", "zip");
    check_refused("a.ply", b"OFF\n3 1 0\n", "no PLY");
    let head = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n\
                property float z\nend_header\n0,5 1 2\n";
    check_refused("b.ply", head.as_bytes(), "written with a point");
    // What can be read is read: the header of a binary STL may be anything.
    let mut stl = [b"\xff\xfe", &[0; 78][..], &1u32.to_le_bytes()].concat();
    let corners = [[0.0f32; 3], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    corners.as_flattened().iter().for_each(|x| stl.extend(x.to_le_bytes()));
    stl.extend([0; 2]);
    assert_eq!(read("c.stl", &stl).map(|frame| frame.faces.len()), Ok(1));
}

/// Reads a small file, which must not take more memory than its bytes and some buffers.
fn small<T>(content: &[u8], read: impl FnOnce() -> T) -> T {
    memory::bounded(content.len(), 64, 1 << 20, read)
}

#[test]
fn lines_have_an_end() {
    let blanks = vec![b' '; 17 << 20];
    let more: Vec<u8> = b" 0".repeat(1 << 19).into_iter().chain(*b"\\\n").collect();
    let head = b"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n";
    let comments = [&b"ply\ncomment"[..], &blanks].concat();
    let error = read("a.ply", &comments).unwrap_err();
    assert!(error.contains("header: is longer than 1 MiB"), "{error}");
    for (name, line, content) in [
        ("a.obj", 1, blanks.clone()),
        ("b.obj", 17, [&b"v 0 0 0\n"[..], &more.repeat(17)].concat()),
        ("a.ply", 6, [&head[..], &blanks].concat()),
    ] {
        let error = read(name, &content).unwrap_err();
        assert!(error.contains(&format!("line {line}: is longer than 16 MiB")), "{error}");
    }
}

#[test]
fn counts_of_ply_are_not_trusted() {
    let body = "element nothing 2000000000\nelement vertex 1000000\n";
    let text = format!("ply\nformat binary_little_endian 1.0\n{body}end_header\n");
    let error = small(text.as_bytes(), || read("a.ply", text.as_bytes())).unwrap_err();
    assert!(error.contains("vertex 0 (counted from 0): x, y or z is missing"), "{error}");
    for format in ["ascii", "binary_big_endian"] {
        let text = format!(
            "ply\nformat {format} 1.0\nelement vertex 2000000000\nproperty char x\n\
             property char y\nproperty char z\nend_header\n0 0 0\n0 0 0\n"
        );
        let error = small(text.as_bytes(), || read("a.ply", text.as_bytes())).unwrap_err();
        assert!(error.contains("file ends here; the header promises 2000000000"), "{error}");
    }
}

#[test]
fn integers_of_queries_are_not_too_long() {
    let dir = tempfile::tempdir().unwrap();
    let row = |n: usize| format!("{}1,1,0,1,0,1\n", "0".repeat(n));
    let read = |text: String| {
        let path = write(dir.path(), "vf.csv", text.as_bytes());
        ccd::io::read_queries(&path).map_err(|e| e.to_string())
    };
    assert_eq!(read(row(300).repeat(8)).unwrap().queries.len(), 1);
    let error = read(row(1_000_000).repeat(8)).unwrap_err();
    assert!(error.contains("has more than 4096 digits"), "{error}");
}

/// Two triangles with a side in common, and a body beside them, `gap` away at one corner.
fn stl_with_gap(gap: f64) -> String {
    let facet = |corners: [[f64; 3]; 3]| {
        let line = |[x, y, z]: [f64; 3]| format!("vertex {x} {y} {z}\n");
        format!("facet normal 0 0 1\nouter loop\n{}endloop\nendfacet\n", corners.map(line).concat())
    };
    let (a, b, c, d) = ([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.5]);
    let body = [[1.0, 1.0, 0.5 + gap], [2.0, 1.0, 3.0], [1.0, 2.0, 3.0]];
    format!("solid\n{}{}{}endsolid\n", facet([a, b, c]), facet([c, b, d]), facet(body))
}

#[test]
fn a_later_frame_is_merged_as_the_first() {
    let dir = tempfile::tempdir().unwrap();
    let file = |name: &str, gap: f64| write(dir.path(), name, stl_with_gap(gap).as_bytes());
    let (apart, touching) = (file("apart.stl", 0.5), file("touching.stl", 0.0));
    let first = read_frame(&apart).unwrap();
    assert_eq!(first.merged, [0, 1, 2, 2, 1, 3, 4, 5, 6]);
    let alone = read_frame(&touching).unwrap();
    assert_eq!((alone.positions.len(), first.positions.len()), (6, 7));
    let later = read_frame_as(&touching, &first).unwrap();
    assert_eq!((&later.faces, &later.merged), (&first.faces, &first.merged));
    assert_eq!(later.positions[3], later.positions[4]);
    assert_eq!(later.positions[4], [1.0, 1.0, 0.5]);
    // What the first frame made one vertex cannot come apart.
    let why = read_frame_as(&apart, &alone).unwrap_err().to_string();
    assert!(why.contains("apart.stl: vertex 6 (counted from 0): was at the place"), "{why}");
    // Another mesh stays what it is, also with as many vertices in its file.
    let text = stl_with_gap(0.5).replacen("vertex 0 1 0", "vertex 0 0 0", 1);
    let other = write(dir.path(), "other.stl", text.as_bytes());
    assert_eq!(read_frame_as(&other, &first).unwrap_err().path, other);
    let off = write(dir.path(), "other.off", b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    assert_eq!(read_frame_as(&off, &first).unwrap(), read_frame(&off).unwrap());
}
