//! PLY through `ply-rs-bw`, straight into positions and triangles.

use super::{Frame, ReadErrorKind, quote};
use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{ElementDef, Encoding, Property, PropertyAccess, PropertyAccessResult};
use std::io::{BufRead, ErrorKind};
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

impl Face {
    fn corners(self) -> Result<Vec<u32>, String> {
        let corners = self.0.ok_or("has no list vertex_indices of integers")?;
        if corners.len() < 3 {
            return Err(format!("has {} vertices, fewer than 3", corners.len()));
        }
        corners.into_iter().map(index).collect()
    }
}

impl Edge {
    fn ends(self) -> Result<[u32; 2], String> {
        let [Some(v), Some(w)] = self.0 else { return Err("has no vertex1 or vertex2".into()) };
        Ok([index(v)?, index(w)?])
    }
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
    if !header.elements.contains_key("vertex") {
        return Err(ReadErrorKind::Header("there is no element named vertex".into()));
    }
    let (encoding, line) = (header.encoding, reader.line().max(1));
    let mut payload = Payload { rest: reader.into_inner(), line, encoding };
    let mut frame = Frame::default();
    for element in header.elements.values() {
        let (count, limit) = (element.count as u64, crate::Error::MAX_ELEMENTS);
        if count > limit {
            let element = if element.name == "face" { "faces" } else { "vertices" };
            return Err(crate::Error::TooMany { element, count, limit }.into());
        }
        let n = 0..element.count;
        match element.name.as_str() {
            "vertex" => {
                for at in n {
                    let [x, y, z] = payload.next::<Vertex>("vertex", at, element)?.0;
                    let (Some(x), Some(y), Some(z)) = (x, y, z) else {
                        let what = "x, y or z is missing".into();
                        return Err(ReadErrorKind::Element { element: "vertex", at, what });
                    };
                    frame.positions.push([x, y, z]);
                }
            }
            "face" => {
                for at in n {
                    let corners = payload.next::<Face>("face", at, element)?.corners();
                    let bad = |what| ReadErrorKind::Element { element: "face", at, what };
                    frame.push_polygon(&corners.map_err(bad)?);
                }
            }
            "edge" => {
                for at in n {
                    let ends = payload.next::<Edge>("edge", at, element)?.ends();
                    let bad = |what| ReadErrorKind::Element { element: "edge", at, what };
                    frame.edges.push(ends.map_err(bad)?);
                }
            }
            // What has no properties takes no bytes, however many there are.
            _ if element.properties.is_empty() && encoding != Encoding::Ascii => {}
            _ => {
                for at in n {
                    payload.next::<Ignored>("element", at, element)?;
                }
            }
        }
    }
    payload.nothing_left()?;
    Ok(frame)
}

/// What follows the header, taken one by one: its counts are not trusted.
struct Payload<R> {
    rest: R,
    /// Number of the next line, where this is text.
    line: usize,
    encoding: Encoding,
}

impl<R: BufRead> Payload<R> {
    fn next<E: PropertyAccess>(
        &mut self,
        name: &'static str,
        at: usize,
        of: &ElementDef,
    ) -> Result<E, ReadErrorKind> {
        let ends = || {
            let what = format!("the file ends here; the header promises {}", of.count);
            ReadErrorKind::Element { element: name, at, what }
        };
        let parser = Parser::new();
        let read = match self.encoding {
            Encoding::BinaryBigEndian => parser.read_big_endian_element(&mut self.rest, of),
            Encoding::BinaryLittleEndian => parser.read_little_endian_element(&mut self.rest, of),
            Encoding::Ascii => {
                let (mut text, line) = (String::new(), self.line);
                if self.rest.read_line(&mut text)? == 0 {
                    return Err(ends());
                }
                self.line += 1;
                return parser.read_ascii_element(&text, of).map_err(|_| {
                    let what = format!("`{}` is no {}", quote(text.trim()), quote(&of.name));
                    ReadErrorKind::Line { line, what }
                });
            }
        };
        read.map_err(|e| if e.kind() == ErrorKind::UnexpectedEof { ends() } else { stopped(e) })
    }

    /// Refuses what follows the last element, but for blank lines: a face that the header does not
    /// count would be left out.
    fn nothing_left(self) -> Result<(), ReadErrorKind> {
        let Self { mut rest, mut line, encoding } = self;
        loop {
            let bytes = rest.fill_buf()?;
            if let Some(at) = bytes.iter().position(|byte| !byte.is_ascii_whitespace()) {
                line += bytes[..at].iter().filter(|&&byte| byte == b'\n').count();
                let what = "there is more than the header promises".to_owned();
                return Err(match encoding {
                    Encoding::Ascii => ReadErrorKind::Line { line, what },
                    _ => ReadErrorKind::Format(what),
                });
            }
            line += bytes.iter().filter(|&&byte| byte == b'\n').count();
            match bytes.len() {
                0 => return Ok(()),
                n => rest.consume(n),
            }
        }
    }
}

/// The message of the parser in one line: what is wrong, and the text there.
fn stopped(e: ply_rs_bw::parser::ParseError) -> ReadErrorKind {
    let text = e.to_string();
    let mut lines = text.lines().map(str::trim);
    let what = lines.next().unwrap_or_default().trim_end_matches('.').replacen("Line", "line", 1);
    let found = lines.next().and_then(|line| line.strip_prefix("String: "));
    let found = found.map(|found| found.trim_matches('\'')).filter(|found| !found.is_empty());
    ReadErrorKind::Format(match found {
        Some(found) => format!("{}: `{}`", quote(&what), quote(found)),
        None => quote(&what),
    })
}

fn index(i: i64) -> Result<u32, String> {
    u32::try_from(i).map_err(|_| format!("vertex index {i} is not in 0 .. 2^32"))
}
