//! glTF 2.0 through the crate `gltf`: all meshes of the scene, where its nodes put them.
//!
//! The file's default scene, or its first, is read; positions are transformed by their nodes in
//! `f64`. Triangles, strips and fans are faces, lines are edges, points are vertices. Within a node
//! vertices with exactly the same position are one: files repeat a vertex for each of its normals.
//! Animations are not applied. What moves or multiplies vertices otherwise is refused: skins, morph
//! targets with weights, instances. Positions must be three `float`s.

use super::gltf_nodes::Nodes;
use super::weld::Weld;
use super::{Frame, Input, ReadErrorKind, quote};
use base64::Engine;
use gltf::accessor::sparse::Sparse;
use gltf::accessor::{DataType, Dimensions};
use gltf::mesh::Mode;
use std::io::Read;
use std::path::Path;

pub(super) fn read(mut input: Input, path: &Path) -> Result<Frame, ReadErrorKind> {
    let mut bytes = Vec::new();
    input.read_to_end(&mut bytes)?;
    let (mut blob, gltf, places) = parse(&bytes)?;
    let mut buffers = Vec::new();
    for buffer in gltf.buffers() {
        let bad = |what: String| ReadErrorKind::Element {
            element: "buffer",
            at: buffer.index(),
            what: quote(&what),
        };
        let data = match buffer.source() {
            gltf::buffer::Source::Bin => blob.take().ok_or_else(|| bad("has no data".into()))?,
            gltf::buffer::Source::Uri(uri) => fetch(path, uri, buffer.length()).map_err(bad)?,
        };
        if data.len() < buffer.length() {
            let (has, says) = (data.len(), buffer.length());
            return Err(bad(format!("has {has} bytes, not the {says} that it says")));
        }
        buffers.push(data);
    }
    let scene = gltf.default_scene().or_else(|| gltf.scenes().next());
    let scene = scene.ok_or_else(|| ReadErrorKind::Header("there is no scene".into()))?;
    let identity = [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| (i == j) as u8 as f64));
    let mut reading = Reading { buffers: &buffers, frame: Frame::default() };
    // Nodes to come, the next one last. A node has one parent.
    let mut nodes: Vec<_> = scene.nodes().map(|node| (node, identity)).collect();
    nodes.reverse();
    let mut seen = vec![false; gltf.nodes().count()];
    while let Some((node, parent)) = nodes.pop() {
        let at = node.index();
        if std::mem::replace(&mut seen[at], true) {
            return Err(ReadErrorKind::Header(format!("node {at} has two parents")));
        }
        let local = places.local(at);
        let local = local.map_err(|what| ReadErrorKind::Element { element: "node", at, what })?;
        let place = local.map(|column| apply(&parent, column));
        if let Some(mesh) = node.mesh() {
            let mut weld = Weld::default();
            for primitive in mesh.primitives() {
                reading.primitive(&primitive, &place, &mut weld).map_err(|what| {
                    ReadErrorKind::Element { element: "mesh", at: mesh.index(), what }
                })?;
            }
        }
        let at = nodes.len();
        nodes.extend(node.children().map(|child| (child, place)));
        nodes[at..].reverse();
    }
    Ok(reading.frame)
}

/// The data in a binary file, the document, and where its nodes are. Checked here is what the crate
/// takes as given: how long a binary file is, and that positions of a mesh are there.
fn parse(bytes: &[u8]) -> Result<(Option<Vec<u8>>, gltf::Document, Nodes), ReadErrorKind> {
    let cut = || ReadErrorKind::Format("the file is cut short".into());
    let bad = |e| match e {
        gltf::Error::Binary(gltf::binary::Error::Io(_)) => cut(),
        e => ReadErrorKind::Format(quote(&e.to_string())),
    };
    let mut whole = bytes;
    if bytes.starts_with(b"glTF") || b"glTF".starts_with(bytes) {
        let length = bytes.get(8..12).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]));
        let length = length.filter(|&length| length >= 12);
        whole = length.and_then(|length| bytes.get(..length as usize)).ok_or_else(cut)?;
    }
    let read = gltf::Gltf::from_slice_without_validation(whole).map_err(bad)?;
    let glb = gltf::binary::Glb::from_slice(whole).ok();
    let nodes = Nodes::new(glb.as_ref().map_or(whole, |glb| &glb.json));
    let nodes = nodes.map_err(|what| ReadErrorKind::Format(quote(&what)))?;
    let json = read.document.into_json();
    for (at, mesh) in json.meshes.iter().enumerate() {
        let mut lists = mesh.primitives.iter().flat_map(|primitive| primitive.attributes.values());
        if lists.any(|list| list.value() >= json.accessors.len()) {
            let what = "names a list that is not there".into();
            return Err(ReadErrorKind::Element { element: "mesh", at, what });
        }
    }
    Ok((read.blob, gltf::Document::from_json(json).map_err(bad)?, nodes))
}

/// A matrix, by columns, times a vector.
fn apply(matrix: &[[f64; 4]; 4], v: [f64; 4]) -> [f64; 4] {
    [0, 1, 2, 3].map(|row| (0..4).map(|k| matrix[k][row] * v[k]).sum())
}

/// The bytes that an address means: the first so many of a file beside this one, or the address's
/// own.
fn fetch(path: &Path, uri: &str, length: usize) -> Result<Vec<u8>, String> {
    if let Some(rest) = uri.strip_prefix("data:") {
        let (_, text) = rest.split_once(";base64,").ok_or("its data are not base64")?;
        return base64::engine::general_purpose::STANDARD.decode(text).map_err(|e| e.to_string());
    }
    if uri.contains(':') {
        return Err(format!("`{uri}` is no file beside this one"));
    }
    let name = urlencoding::decode(uri).map_err(|e| format!("`{uri}`: {e}"))?;
    let (path, mut bytes) = (path.with_file_name(&*name), Vec::new());
    // A device may have no end, and a pipe may wait for ever.
    let is_file = std::fs::metadata(&path).map(|data| data.is_file());
    let read = is_file.and_then(|is_file| match is_file {
        true => std::fs::File::open(path)?.take(length as u64).read_to_end(&mut bytes),
        false => Err(std::io::Error::other("is no regular file")),
    });
    read.map(|_| bytes).map_err(|e| format!("`{name}`: {e}"))
}

const OUTSIDE: &str = "has a list beyond the end of its buffer";

struct Reading<'a> {
    buffers: &'a [Vec<u8>],
    frame: Frame,
}

impl Reading<'_> {
    /// Refuses a list that the buffers do not hold, which the crate takes as given.
    fn check(&self, list: &gltf::Accessor) -> Result<(), &'static str> {
        let all = |view: gltf::buffer::View, offset: usize, count: usize, size: usize| {
            let bytes = self.buffers.get(view.buffer().index()).map_or(0, Vec::len);
            let stride = view.stride().unwrap_or(size);
            let last = count.checked_sub(1).and_then(|last| last.checked_mul(stride));
            let end = last.and_then(|last| last.checked_add(offset)?.checked_add(size));
            let view_end = view.offset().checked_add(view.length());
            stride >= size
                && end.is_some_and(|end| end <= view.length())
                && view_end.is_some_and(|end| end <= bytes)
        };
        let sparse = list.sparse();
        let holds_sparse = sparse.as_ref().is_none_or(|sparse| {
            let (indices, values, n) = (sparse.indices(), sparse.values(), sparse.count());
            all(indices.view(), indices.offset(), n, indices.index_type().size())
                && all(values.view(), values.offset(), n, list.size())
        });
        // Without a view it is all zeros but for the sparse ones: no more than there are bytes.
        let most = self.buffers.iter().map(Vec::len).max().unwrap_or(0);
        let holds_list = match list.view() {
            Some(view) => all(view, list.offset(), list.count(), list.size()),
            None => sparse.is_some() && list.count() <= most,
        };
        match (holds_list && holds_sparse, sparse) {
            (false, _) => Err(OUTSIDE),
            (true, Some(sparse)) if !self.rise(&sparse, list.count()) => {
                Err("has a sparse list whose indices do not rise, or are beyond its end")
            }
            _ => Ok(()),
        }
    }

    /// Whether the indices of sparse values, which the buffers hold, rise and are below `count`:
    /// the crate passes over values from the first one on whose index does not.
    fn rise(&self, sparse: &Sparse, count: usize) -> bool {
        let indices = sparse.indices();
        let (view, size) = (indices.view(), indices.index_type().size());
        let bytes = &self.buffers[view.buffer().index()][view.offset() + indices.offset()..];
        let index = |b: &[u8]| b[..size].iter().rev().fold(0usize, |i, &b| i << 8 | b as usize);
        let all = bytes.chunks(view.stride().unwrap_or(size)).take(sparse.count()).map(index);
        all.clone().is_sorted_by(|i, j| i < j) && all.max() < Some(count)
    }

    fn primitive(
        &mut self,
        primitive: &gltf::Primitive,
        place: &[[f64; 4]; 4],
        weld: &mut Weld,
    ) -> Result<(), String> {
        let accessor = primitive.get(&gltf::Semantic::Positions).ok_or("has no positions")?;
        if (accessor.data_type(), accessor.dimensions()) != (DataType::F32, Dimensions::Vec3) {
            return Err("has positions that are not three floats".into());
        }
        let is_index = |a: &gltf::Accessor| {
            let kind = matches!(a.data_type(), DataType::U8 | DataType::U16 | DataType::U32);
            kind && a.dimensions() == Dimensions::Scalar
        };
        let indices = primitive.indices();
        if indices.as_ref().is_some_and(|indices| !is_index(indices)) {
            return Err("has indices that are no unsigned integers".into());
        }
        for list in [Some(&accessor), indices.as_ref()].into_iter().flatten() {
            if list.count() == 0 {
                return Err("has a list of no elements".into());
            }
            self.check(list)?;
        }
        let buffers = self.buffers;
        let reader = primitive.reader(|buffer| buffers.get(buffer.index()).map(|b| &b[..]));
        let mut positions = reader.read_positions().ok_or(OUTSIDE)?;
        let named: Vec<u32> = match indices {
            None => (0..accessor.count() as u32).collect(),
            Some(_) => reader.read_indices().ok_or(OUTSIDE)?.into_u32().collect(),
        };
        // A list may serve many meshes: what no index of this one names is none of its vertices,
        // and is not read.
        let mut used = named.clone();
        used.sort_unstable();
        used.dedup();
        if used.last().is_some_and(|&last| last as usize >= accessor.count()) {
            return Err("names a vertex that is not there".into());
        }
        let (mut vertices, mut next) = (Vec::new(), 0);
        for &i in &used {
            let p = positions.nth(i as usize - next).ok_or(OUTSIDE)?;
            next = i as usize + 1;
            let p = apply(place, [p[0] as f64, p[1] as f64, p[2] as f64, 1.0]);
            vertices.push(weld.vertex([p[0], p[1], p[2]], &mut self.frame));
        }
        let vertex = |i: &u32| vertices[used.partition_point(|before| before < i)];
        let order: Vec<u32> = named.iter().map(vertex).collect();
        let frame = &mut self.frame;
        let n = order.len();
        match primitive.mode() {
            Mode::Triangles if n.is_multiple_of(3) => {
                order.chunks_exact(3).for_each(|corners| frame.push_polygon(corners));
            }
            Mode::TriangleStrip => {
                for (i, w) in order.windows(3).enumerate() {
                    // Every second one is wound the other way.
                    let (b, c) = if i % 2 == 0 { (w[1], w[2]) } else { (w[2], w[1]) };
                    frame.push_polygon(&[w[0], b, c]);
                }
            }
            Mode::TriangleFan => {
                for w in order[1..].windows(2) {
                    frame.push_polygon(&[w[0], w[1], order[0]]);
                }
            }
            Mode::Lines if n.is_multiple_of(2) => {
                frame.edges.extend(order.chunks_exact(2).map(|e| [e[0], e[1]]));
            }
            Mode::LineStrip | Mode::LineLoop => {
                frame.edges.extend(order.windows(2).map(|e| [e[0], e[1]]));
                if primitive.mode() == Mode::LineLoop {
                    frame.edges.push([order[n - 1], order[0]]);
                }
            }
            Mode::Points => {}
            Mode::Triangles | Mode::Lines => {
                return Err(format!("has {n} indices, no whole number of triangles or lines"));
            }
        }
        Ok(())
    }
}
