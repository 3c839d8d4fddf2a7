//! Scenes of glTF: nodes, ways to list triangles, where bytes come from.

use crate::read;

/// A scene of one mesh with three positions, or what is put in its place.
struct Scene {
    nodes: &'static str,
    primitive: &'static str,
    accessors: String,
    uri: String,
}

/// Four points, the last where the second is, and the indices 0, 1, 2, 2, 3, 0 as `u16`.
fn bytes() -> Vec<u8> {
    let points = [[0.0f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [1.0, 0.0, 0.0]];
    let points = points.as_flattened().iter().flat_map(|c| c.to_le_bytes());
    points.chain([0u16, 1, 2, 2, 3, 0].iter().flat_map(|i| i.to_le_bytes())).collect()
}

fn base64(bytes: &[u8]) -> String {
    let sextets = |three: &[u8]| {
        let word = three.iter().fold(0u32, |word, &b| word << 8 | b as u32);
        [18, 12, 6, 0].map(|shift| (word >> shift & 63) as usize)
    };
    let letters = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    bytes.chunks_exact(3).flat_map(sextets).map(|i| letters[i] as char).collect()
}

impl Default for Scene {
    fn default() -> Self {
        Self {
            nodes: r#"{"mesh": 0}"#,
            primitive: r#"{"attributes": {"POSITION": 0}, "indices": 1}"#,
            accessors: r#"{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
                "min": [0, 0, 0], "max": [1, 2, 0]},
                {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}"#
                .into(),
            uri: format!("data:application/octet-stream;base64,{}", base64(&bytes())),
        }
    }
}

impl Scene {
    fn json(&self) -> String {
        let Self { nodes, primitive, accessors, uri } = self;
        let buffer = if uri.is_empty() { String::new() } else { format!(", \"uri\": \"{uri}\"") };
        format!(
            r#"{{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}],
            "nodes": [{nodes}], "meshes": [{{"primitives": [{primitive}]}}],
            "accessors": [{accessors}],
            "bufferViews": [{{"buffer": 0, "byteLength": 48}},
                {{"buffer": 0, "byteOffset": 48, "byteLength": 12}}],
            "buffers": [{{"byteLength": 60{buffer}}}]}}"#
        )
    }
}

#[test]
fn a_scene_is_read_with_its_nodes() {
    let frame = read("a.gltf", Scene::default().json().as_bytes()).unwrap();
    assert_eq!(frame.positions, [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0]]);
    assert_eq!((&frame.faces[..], &frame.polygons[..]), (&[[0, 1, 2], [2, 1, 0]][..], &[0, 1][..]));
    // A child of a node that moves and scales; both have the mesh, and are apart.
    let nodes = r#"{"mesh": 0, "translation": [0, 0, 5], "children": [1]},
        {"mesh": 0, "scale": [2, 2, 2]}"#;
    let moved = read("b.gltf", Scene { nodes, ..Scene::default() }.json().as_bytes()).unwrap();
    assert_eq!(moved.positions[..2], [[0.0, 0.0, 5.0], [1.0, 0.0, 5.0]]);
    assert_eq!(moved.positions[3..], [[0.0, 0.0, 5.0], [2.0, 0.0, 5.0], [0.0, 4.0, 5.0]]);
    assert_eq!(moved.faces[2..], [[3, 4, 5], [5, 4, 3]]);
}

#[test]
fn nodes_are_where_the_file_says_in_all_digits() {
    let nodes = r#"{"mesh": 0, "translation": [0, 0.1, 4500000.3], "rotation": [0, 0, 0.6, 0.8]}"#;
    let frame = read("a.gltf", Scene { nodes, ..Scene::default() }.json().as_bytes()).unwrap();
    assert_eq!(frame.positions[0], [0.0, 0.1, 4500000.3]);
    // By an angle whose cosine is 0.28 and sine 0.96.
    let [x, y, _] = frame.positions[1];
    assert!((x - 0.28).abs() < 1e-15 && (y - 1.06).abs() < 1e-15, "{x} {y}");
    let nodes = r#"{"mesh": 0, "matrix": [0,3,0,0, -1,0,0,0, 0,0,1,0, 0.1,0,0,1]}"#;
    let frame = read("a.gltf", Scene { nodes, ..Scene::default() }.json().as_bytes()).unwrap();
    assert_eq!(frame.positions[1..], [[0.1, 3.0, 0.0], [-1.9, 0.0, 0.0]]);
}

/// A list of positions may serve several meshes.
#[test]
fn what_no_index_names_is_no_vertex() {
    let accessors = Scene::default().accessors.replace("\"count\": 6", "\"count\": 2");
    let primitive = r#"{"attributes": {"POSITION": 0}, "indices": 1, "mode": 1}"#;
    let scene = Scene { accessors, primitive, ..Scene::default() };
    let frame = read("a.gltf", scene.json().as_bytes()).unwrap();
    assert_eq!(frame.positions, [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]);
    assert_eq!((&frame.edges[..], &frame.merged[..]), (&[[0, 1]][..], &[0, 1][..]));
}

/// Vertices are numbered in the order of the list, however indices jump in it.
#[test]
fn some_of_a_list_are_its_vertices() {
    let indices = "\"byteOffset\": 4, \"componentType\": 5123, \"count\": 4";
    let accessors = Scene::default().accessors;
    let accessors = accessors.replace("\"componentType\": 5123, \"count\": 6", indices);
    let primitive = r#"{"attributes": {"POSITION": 0}, "indices": 1, "mode": 1}"#;
    let scene = Scene { accessors, primitive, ..Scene::default() };
    let frame = read("a.gltf", scene.json().as_bytes()).unwrap();
    assert_eq!(frame.positions, [[0.0, 0.0, 0.0], [0.0, 2.0, 0.0], [1.0, 0.0, 0.0]]);
    assert_eq!((&frame.edges[..], &frame.merged[..]), (&[[1, 1], [2, 0]][..], &[0, 1, 2][..]));
}

/// Each of many meshes takes the time of its own vertices, not of the list that all of them share.
#[test]
fn a_list_may_serve_many_meshes() {
    let uri = format!("data:;base64,{}", "A".repeat(1 << 22));
    let scene = Scene { uri, ..Scene::default() };
    let json = scene.json().replace("\"count\": 4", "\"count\": 262144");
    let json = json.replace("\"byteLength\": 48}", "\"byteLength\": 3145728}");
    let json = json.replace("\"byteLength\": 60", "\"byteLength\": 3145728");
    let json = json.replace(scene.primitive, &[scene.primitive; 4096].join(","));
    let frame = read("a.gltf", json.as_bytes()).unwrap();
    assert_eq!((frame.positions.len(), frame.faces.len()), (1, 2 * 4096));
}

#[test]
fn every_mode_is_read() {
    let faces = |primitive| {
        let frame = read("a.gltf", Scene { primitive, ..Scene::default() }.json().as_bytes());
        let frame = frame.unwrap();
        (frame.faces, frame.edges)
    };
    let strip = faces(r#"{"attributes": {"POSITION": 0}, "mode": 5}"#).0;
    assert_eq!(strip, [[0, 1, 2], [1, 1, 2]]);
    let fan = faces(r#"{"attributes": {"POSITION": 0}, "mode": 6}"#).0;
    assert_eq!(fan, [[1, 2, 0], [2, 1, 0]]);
    let lines = faces(r#"{"attributes": {"POSITION": 0}, "mode": 1}"#);
    assert_eq!(lines, (vec![], vec![[0, 1], [2, 1]]));
    let strip = faces(r#"{"attributes": {"POSITION": 0}, "mode": 3}"#).1;
    assert_eq!(strip, [[0, 1], [1, 2], [2, 1]]);
    let ring = faces(r#"{"attributes": {"POSITION": 0}, "mode": 2}"#).1;
    assert_eq!(ring, [[0, 1], [1, 2], [2, 1], [1, 0]]);
    let points = faces(r#"{"attributes": {"POSITION": 0}, "mode": 0}"#);
    assert_eq!(points, (vec![], vec![]));
}

#[test]
fn bytes_are_beside_the_file_or_in_it() {
    let want = read("a.gltf", Scene::default().json().as_bytes()).unwrap();
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("the bytes.bin"), bytes()).unwrap();
    let path = dir.path().join("a.gltf");
    let scene = Scene { uri: "the%20bytes.bin".into(), ..Scene::default() };
    std::fs::write(&path, scene.json()).unwrap();
    assert_eq!(ccd::io::read_frame(&path).unwrap(), want);

    let mut json = Scene { uri: String::new(), ..Scene::default() }.json().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let word = |n: usize| (n as u32).to_le_bytes();
    let mut glb: Vec<u8> = b"glTF".to_vec();
    glb.extend(word(2).into_iter().chain(word(12 + 8 + json.len() + 8 + 60)));
    glb.extend(word(json.len()).into_iter().chain(*b"JSON").chain(json));
    glb.extend(word(60).into_iter().chain(*b"BIN\0").chain(bytes()));
    assert_eq!(read("a.glb", &glb).unwrap(), want);
    assert!(read("cut.glb", &glb[..glb.len() - 3]).is_err());
}

#[test]
fn other_versions_and_rotations_are_refused() {
    let scene = Scene::default().json();
    assert!(scene.contains(r#""version": "2.0""#), "{scene}");
    let other = scene.replace(r#""version": "2.0""#, r#""version": "3.0""#);
    let error = read("a.gltf", other.as_bytes()).unwrap_err();
    assert!(error.contains("version 3.0"), "{error}");
    let nodes = r#"{"mesh": 0, "rotation": [1, 2, 3, 4]}"#;
    let error = read("a.gltf", Scene { nodes, ..Scene::default() }.json().as_bytes()).unwrap_err();
    assert!(error.contains("rotation of length 5.4"), "{error}");
}

#[test]
fn lists_of_zeros_are_as_long_as_the_file() {
    let sparse = r#""sparse": {"count": 2, "indices": {"bufferView": 1, "componentType": 5123},
        "values": {"bufferView": 0}}"#;
    let scene = |count: usize| {
        let positions = format!(
            r#"{{"componentType": 5126, "count": {count}, "type": "VEC3", "min": [0, 0, 0],
            "max": [1, 2, 0], {sparse}}}, {{"bufferView": 1, "componentType": 5123, "count": 6,
            "type": "SCALAR"}}"#
        );
        Scene { accessors: positions, ..Scene::default() }.json()
    };
    // The second of six is what the file says; the others are zero.
    assert_eq!(read("a.gltf", scene(6).as_bytes()).unwrap().positions.len(), 2);
    let long = scene(1 << 22);
    let error = super::small(long.as_bytes(), || read("b.gltf", long.as_bytes())).unwrap_err();
    assert!(error.contains("beyond the end"), "{error}");
    // 2 2 and 3 0 do not rise, and of one element 1 is none.
    let from = |at: usize| scene(6).replace("5123},", &format!("5123, \"byteOffset\": {at}}},"));
    for text in [from(4), from(8), scene(1)] {
        let error = read("c.gltf", text.as_bytes()).unwrap_err();
        assert!(error.contains("indices do not rise, or are beyond its end"), "{error}");
    }
}
