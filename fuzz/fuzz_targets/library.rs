//! What must hold of the readers of `ccd::io`.

use crate::memory::bounded;
use ccd::Kind;
use ccd::io::{Frame, PointCache, Queries, Query, ReadError, read_frame, read_queries_of};
use std::path::Path;

/// Memory that is not counted per byte of a file: buffers.
pub const BUFFERS: usize = 1 << 20;

/// A mesh that is accepted can be used, and reading it twice is the same.
pub fn mesh(path: &Path, length: usize) {
    // The shortest object of glTF, `{}`, is a node or an accessor of some hundred bytes.
    let times = if path.extension().is_some_and(|e| e == "gltf" || e == "glb") { 512 } else { 64 };
    let frame = bounded(length, times, BUFFERS, || read_frame(path));
    if let Some(frame) = same(frame, read_frame(path)) {
        check(&frame);
    }
}

fn check(frame: &Frame) {
    let fine = |x: &f64| x.abs() <= ccd::Error::MAX_COORDINATE;
    assert!(frame.positions.as_flattened().iter().all(fine));
    let n = frame.positions.len() as u32;
    let corners = frame.faces.as_flattened().iter().chain(frame.edges.as_flattened());
    assert!(corners.into_iter().all(|&v| v < n));
    assert_eq!(frame.polygons.len(), frame.faces.len());
    assert!(frame.polygons.is_sorted_by(|a, b| b - a <= 1));
    if let Ok(mesh) = frame.mesh() {
        assert_eq!(mesh.faces().len(), frame.faces.len());
        assert!(mesh.edges().iter().all(|&[v, w]| v < w && w < n));
    }
}

/// Frames are as large as promised, and the same twice.
pub fn cache(path: &Path, length: usize) {
    // What is compressed may be a thousand times as long.
    let times = if path.extension().is_some_and(|e| e == "npz") { 1100 } else { 64 };
    let open = || bounded(length, times, BUFFERS, || PointCache::open(path));
    let (mut first, mut second) = match (open(), open()) {
        (Ok(first), Ok(second)) => (first, second),
        (first, second) => return different(first.err(), second.err()),
    };
    let n = first.n_frames();
    for at in [0, 1, n / 2, n.saturating_sub(1)].into_iter().filter(|&at| at < n) {
        let frame = bounded(length, times, BUFFERS, || first.frame(at));
        if let Some(positions) = same(frame, second.frame(at)) {
            assert_eq!(positions.len(), first.n_vertices());
            check(&Frame { positions, ..Frame::default() });
        }
    }
}

/// Queries are the same twice, of finite numbers, with an answer each or none at all.
pub fn queries(path: &Path, length: usize) {
    let all = |of: Result<Queries, ReadError>| of.map(|all| (all.queries, all.answers));
    let read = |kind| bounded(length, 64, BUFFERS, || all(read_queries_of(path, kind)));
    let Some((queries, answers)) = same(read(Kind::VertexFace), read(Kind::VertexFace)) else {
        assert!(read(Kind::EdgeEdge).is_err());
        return;
    };
    assert!(answers.is_empty() || answers.len() == queries.len());
    let others = read(Kind::EdgeEdge).expect("the kind changes nothing");
    assert_eq!((others.0.len(), others.1), (queries.len(), answers));
    for query in queries {
        let Query::VertexFace(query) = query else { panic!("a query of another kind") };
        let points = [query.t0, query.t1];
        assert!(points.as_flattened().as_flattened().iter().all(|x| x.is_finite()));
    }
}

/// What was read, if it was; reading again must be the same.
fn same<T: PartialEq + std::fmt::Debug>(
    first: Result<T, ReadError>,
    second: Result<T, ReadError>,
) -> Option<T> {
    match (first, second) {
        (Ok(first), Ok(second)) => {
            assert_eq!(first, second, "reading twice");
            Some(first)
        }
        (first, second) => {
            different(first.err(), second.err());
            None
        }
    }
}

/// Two refusals: in the same words, and not in too many.
fn different(first: Option<ReadError>, second: Option<ReadError>) {
    let text = |e: Option<ReadError>| e.map(|e| e.to_string()).expect("refused once, read once");
    let (first, second) = (text(first), text(second));
    assert_eq!(first, second, "reading twice");
    assert!(first.chars().count() < 1000, "a long message: {first}");
}
