//! PLY through `ply-rs-bw`, straight into positions and triangles.

use super::{Frame, ReadErrorKind, quote};
use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{Encoding, Header, Property, PropertyAccess, PropertyAccessResult};
use std::io::BufRead;
use std::path::Path;

/// A vertex while it is read; a coordinate that the file lacks stays `None`.
struct Vertex([Option<f64>; 3]);

/// A polygon while it is read; an index that is no `u32` stays as it is for the message.
struct Face(Option<Vec<i64>>);

/// The two ends of an edge while it is read.
struct Edge([Option<i64>; 2]);

/// What is read of elements that are not used.
struct Ignored;

fn number(property: &Property) -> Option<f64> {
    Some(match *property {
        Property::Char(x) => x.into(),
        Property::UChar(x) => x.into(),
        Property::Short(x) => x.into(),
        Property::UShort(x) => x.into(),
        Property::Int(x) => x.into(),
        Property::UInt(x) => x.into(),
        Property::Float(x) => x.into(),
        Property::Double(x) => x,
        _ => return None,
    })
}

impl PropertyAccess for Vertex {
    fn new() -> Self {
        Vertex([None; 3])
    }
    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        let axis = match name {
            "x" => 0,
            "y" => 1,
            "z" => 2,
            _ => return PropertyAccessResult::Ignored,
        };
        self.0[axis] = number(&property);
        PropertyAccessResult::Set
    }
}

impl PropertyAccess for Face {
    fn new() -> Self {
        Face(None)
    }
    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        if name != "vertex_indices" && name != "vertex_index" {
            return PropertyAccessResult::Ignored;
        }
        self.0 = match property {
            Property::ListChar(v) => Some(v.into_iter().map(i64::from).collect()),
            Property::ListUChar(v) => Some(v.into_iter().map(i64::from).collect()),
            Property::ListShort(v) => Some(v.into_iter().map(i64::from).collect()),
            Property::ListUShort(v) => Some(v.into_iter().map(i64::from).collect()),
            Property::ListInt(v) => Some(v.into_iter().map(i64::from).collect()),
            Property::ListUInt(v) => Some(v.into_iter().map(i64::from).collect()),
            _ => None,
        };
        PropertyAccessResult::Set
    }
}

impl PropertyAccess for Edge {
    fn new() -> Self {
        Edge([None; 2])
    }
    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        let end = match name {
            "vertex1" => 0,
            "vertex2" => 1,
            _ => return PropertyAccessResult::Ignored,
        };
        self.0[end] = number(&property).map(|x| x as i64);
        PropertyAccessResult::Set
    }
}

impl PropertyAccess for Ignored {
    fn new() -> Self {
        Ignored
    }
    fn set_property(&mut self, _: &str, _: Property) -> PropertyAccessResult {
        PropertyAccessResult::Ignored
    }
}

pub(super) fn read(path: &Path) -> Result<Frame, ReadErrorKind> {
    let file = std::fs::File::open(path)?;
    let mut reader = Reader::new(std::io::BufReader::with_capacity(1 << 16, file));
    let header = Parser::<Ignored>::new().read_header(&mut reader).map_err(stopped)?;
    let mut frame = Frame::default();
    if !header.elements.contains_key("vertex") {
        return Err(ReadErrorKind::Header("there is no element named vertex".into()));
    }
    for element in header.elements.values() {
        let (count, limit) = (element.count as u64, crate::Error::MAX_ELEMENTS);
        if count > limit {
            let element = if element.name == "face" { "faces" } else { "vertices" };
            return Err(crate::Error::TooMany { element, count, limit }.into());
        }
        match element.name.as_str() {
            "vertex" => {
                for (at, v) in
                    payload::<Vertex>(&mut reader, element, &header)?.into_iter().enumerate()
                {
                    let missing = || ReadErrorKind::Element {
                        element: "vertex",
                        at,
                        what: "x, y or z is missing".into(),
                    };
                    let [x, y, z] = v.0;
                    frame.positions.push([
                        x.ok_or_else(missing)?,
                        y.ok_or_else(missing)?,
                        z.ok_or_else(missing)?,
                    ]);
                }
            }
            "face" => {
                for (at, f) in
                    payload::<Face>(&mut reader, element, &header)?.into_iter().enumerate()
                {
                    let bad = |what: String| ReadErrorKind::Element { element: "face", at, what };
                    let corners =
                        f.0.ok_or_else(|| bad("has no list vertex_indices of integers".into()))?;
                    let corners = corners
                        .into_iter()
                        .map(|i| index(i).map_err(bad))
                        .collect::<Result<Vec<_>, _>>()?;
                    if corners.len() < 3 {
                        return Err(bad(format!("has {} vertices, fewer than 3", corners.len())));
                    }
                    frame.push_polygon(&corners);
                }
            }
            "edge" => {
                for (at, e) in
                    payload::<Edge>(&mut reader, element, &header)?.into_iter().enumerate()
                {
                    let bad = |what: String| ReadErrorKind::Element { element: "edge", at, what };
                    let end = |i: Option<i64>| {
                        index(i.ok_or_else(|| bad("has no vertex1 or vertex2".into()))?)
                            .map_err(bad)
                    };
                    frame.edges.push([end(e.0[0])?, end(e.0[1])?]);
                }
            }
            _ => {
                payload::<Ignored>(&mut reader, element, &header)?;
            }
        }
    }
    nothing_left(reader, header.encoding == Encoding::Ascii)?;
    Ok(frame)
}

/// Refuses what follows the last element, but for blank lines: a face that the header does not
/// count would be left out.
fn nothing_left(reader: Reader<impl BufRead>, is_text: bool) -> Result<(), ReadErrorKind> {
    let (mut line, mut rest) = (reader.line(), reader.into_inner());
    loop {
        let bytes = rest.fill_buf()?;
        if let Some(at) = bytes.iter().position(|byte| !byte.is_ascii_whitespace()) {
            line += bytes[..at].iter().filter(|&&byte| byte == b'\n').count();
            let what = "there is more than the header promises".to_owned();
            return Err(match is_text {
                true => ReadErrorKind::Line { line, what },
                false => ReadErrorKind::Format(what),
            });
        }
        line += bytes.iter().filter(|&&byte| byte == b'\n').count();
        match bytes.len() {
            0 => return Ok(()),
            n => rest.consume(n),
        }
    }
}

/// The message of the parser in one line: what is wrong, and the text there.
fn stopped(e: ply_rs_bw::parser::ParseError) -> ReadErrorKind {
    let text = e.to_string();
    let mut lines = text.lines().map(str::trim);
    let what = lines.next().unwrap_or_default().trim_end_matches('.').replacen("Line", "line", 1);
    let there = lines.next().and_then(|line| line.strip_prefix("String: "));
    let there = there.map(|there| there.trim_matches('\'')).filter(|there| !there.is_empty());
    ReadErrorKind::Format(match there {
        Some(there) => format!("{}: `{}`", quote(&what), quote(there)),
        None => quote(&what),
    })
}

fn index(i: i64) -> Result<u32, String> {
    u32::try_from(i).map_err(|_| format!("vertex index {i} is not in 0 .. 2^32"))
}

fn payload<E: PropertyAccess>(
    reader: &mut Reader<impl BufRead>,
    element: &ply_rs_bw::ply::ElementDef,
    header: &Header,
) -> Result<Vec<E>, ReadErrorKind> {
    let items = Parser::<E>::new().read_payload_for_element(reader, element, header);
    let items = items.map_err(stopped)?;
    if items.len() != element.count {
        let what = format!("the file ends here; the header promises {}", element.count);
        let name = if element.name == "face" { "face" } else { "vertex" };
        return Err(ReadErrorKind::Element { element: name, at: items.len(), what });
    }
    Ok(items)
}
