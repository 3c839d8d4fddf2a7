//! PLY through `ply-rs-bw`, straight into positions and triangles.

use super::input::{LONGEST_LINE, too_long};
use super::{Frame, Input, ReadErrorKind, of_comma, quote};
use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{
    ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult, PropertyType,
};
use std::collections::HashSet;
use std::io::{BufRead, ErrorKind, Read};
use std::path::Path;

/// An element while it is read; a property that the file lacks stays `None`.
#[derive(Default)]
struct Element {
    position: [Option<f64>; 3],
    /// An index that is no `u32` stays as it is for the message.
    corners: Option<Vec<i64>>,
    ends: [Option<i64>; 2],
}

/// Bytes of a header: a compressed file may unpack to one without end.
const LONGEST_HEADER: u64 = 1 << 20;

/// Names of the list of a face's vertices.
const LISTS: [&str; 2] = ["vertex_indices", "vertex_index"];

impl PropertyAccess for Element {
    fn new() -> Self {
        Self::default()
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        match name {
            "x" => self.position[0] = number(&property),
            "y" => self.position[1] = number(&property),
            "z" => self.position[2] = number(&property),
            _ if LISTS.contains(&name) => self.corners = integers(property),
            "vertex1" => self.ends[0] = integer(&property),
            "vertex2" => self.ends[1] = integer(&property),
            _ => return PropertyAccessResult::Ignored,
        }
        PropertyAccessResult::Set
    }
}

impl Element {
    fn corners(self) -> Result<Vec<u32>, String> {
        let corners = self.corners.ok_or("has no list vertex_indices of integers")?;
        if corners.len() < 3 {
            return Err(format!("has {} vertices, fewer than 3", corners.len()));
        }
        corners.into_iter().map(index).collect()
    }

    fn ends(self) -> Result<[u32; 2], String> {
        let [Some(v), Some(w)] = self.ends else {
            return Err("has no integers vertex1 and vertex2".into());
        };
        Ok([index(v)?, index(w)?])
    }
}

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

fn integer(property: &Property) -> Option<i64> {
    let is_float = matches!(property, Property::Float(_) | Property::Double(_));
    number(property).filter(|_| !is_float).map(|x| x as i64)
}

fn integers(property: Property) -> Option<Vec<i64>> {
    Some(match property {
        Property::ListChar(v) => v.into_iter().map(i64::from).collect(),
        Property::ListUChar(v) => v.into_iter().map(i64::from).collect(),
        Property::ListShort(v) => v.into_iter().map(i64::from).collect(),
        Property::ListUShort(v) => v.into_iter().map(i64::from).collect(),
        Property::ListInt(v) => v.into_iter().map(i64::from).collect(),
        Property::ListUInt(v) => v.into_iter().map(i64::from).collect(),
        _ => return None,
    })
}

pub(super) fn read(mut input: Input, _: &Path) -> Result<Frame, ReadErrorKind> {
    let (header, line) = header(&mut input)?;
    if !header.elements.contains_key("vertex") {
        return Err(ReadErrorKind::Header("there is no element named vertex".into()));
    }
    let encoding = header.encoding;
    let mut payload = Payload { rest: input, line, encoding };
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
                    let [x, y, z] = payload.next("vertex", at, element)?.position;
                    let (Some(x), Some(y), Some(z)) = (x, y, z) else {
                        let what = "x, y or z is missing".into();
                        return Err(ReadErrorKind::Element { element: "vertex", at, what });
                    };
                    frame.positions.push([x, y, z]);
                }
            }
            "face" => {
                for at in n {
                    let corners = payload.next("face", at, element)?.corners();
                    let bad = |what| ReadErrorKind::Element { element: "face", at, what };
                    frame.push_polygon(&corners.map_err(bad)?);
                }
            }
            "edge" => {
                for at in n {
                    let ends = payload.next("edge", at, element)?.ends();
                    let bad = |what| ReadErrorKind::Element { element: "edge", at, what };
                    frame.edges.push(ends.map_err(bad)?);
                }
            }
            // What has no properties takes no bytes, however many there are.
            _ if element.properties.is_empty() && encoding != Encoding::Ascii => {}
            name if LISTS.iter().any(|&list| element.properties.contains_key(list)) => {
                let what = format!(
                    "element `{}` has lists of vertices; triangles and polygons are read from an \
                     element named face",
                    quote(name)
                );
                return Err(ReadErrorKind::Header(what));
            }
            _ => {
                for at in n {
                    payload.next("element", at, element)?;
                }
            }
        }
    }
    payload.nothing_left()?;
    Ok(frame)
}

/// The header, and the number of the line after it. Comments may be in any encoding.
fn header(input: &mut Input) -> Result<(Header, usize), ReadErrorKind> {
    let (mut bytes, mut begin) = (Vec::new(), 0);
    // Of a header without an end the parser says so.
    while input.by_ref().take(LONGEST_HEADER - begin as u64).read_until(b'\n', &mut bytes)? > 0 {
        if bytes[begin..].trim_ascii_end() == b"end_header" {
            break;
        }
        begin = bytes.len();
    }
    if begin as u64 == LONGEST_HEADER {
        return Err(ReadErrorKind::Header(format!("is longer than {} MiB", LONGEST_HEADER >> 20)));
    }
    let text = String::from_utf8_lossy(&bytes);
    let mut reader = Reader::new(text.as_bytes());
    let header = Parser::<Element>::new().read_header(&mut reader).map_err(stopped)?;
    check_names(&text)?;
    Ok((header, reader.line().max(1)))
}

/// Refuses a header with two elements, or two properties of one, of the same name: the parser keeps
/// one of them.
fn check_names(text: &str) -> Result<(), ReadErrorKind> {
    let (mut elements, mut properties) = (HashSet::new(), HashSet::new());
    for (at, line) in text.lines().enumerate() {
        let words: Vec<&str> = line.split_ascii_whitespace().collect();
        let (name, kind, is_new) = match words[..] {
            ["element", name, ..] => {
                properties.clear();
                (name, "elements", elements.insert(name))
            }
            ["property", .., name] => (name, "properties", properties.insert(name)),
            _ => continue,
        };
        if !is_new {
            let what = format!("`{}` is the name of two {kind}", quote(name));
            return Err(ReadErrorKind::Line { line: at + 1, what });
        }
    }
    Ok(())
}

/// Elements after the header, read one by one: its counts are not trusted.
struct Payload<R> {
    rest: R,
    /// Number of the next line, where this is text.
    line: usize,
    encoding: Encoding,
}

impl<R: BufRead> Payload<R> {
    fn next(
        &mut self,
        name: &'static str,
        at: usize,
        element: &ElementDef,
    ) -> Result<Element, ReadErrorKind> {
        let ends = || {
            let what = format!("the file ends here; the header promises {}", element.count);
            ReadErrorKind::Element { element: name, at, what }
        };
        let parser = Parser::new();
        let read = match self.encoding {
            Encoding::BinaryBigEndian => parser.read_big_endian_element(&mut self.rest, element),
            Encoding::BinaryLittleEndian => {
                parser.read_little_endian_element(&mut self.rest, element)
            }
            Encoding::Ascii => {
                let (mut text, line) = (String::new(), self.line);
                if self.rest.by_ref().take(LONGEST_LINE).read_line(&mut text)? == 0 {
                    return Err(ends());
                }
                if text.len() as u64 == LONGEST_LINE {
                    return Err(too_long(line));
                }
                self.line += 1;
                if has_more(&text, element) {
                    let what =
                        format!("`{}` has more numbers than the header says", quote(text.trim()));
                    return Err(ReadErrorKind::Line { line, what });
                }
                let read = parser.read_ascii_element(&text, element).or_else(|_| {
                    let words = text.trim_end().split([' ', '\t']);
                    let words: Vec<String> = words.map(filled).collect();
                    parser.read_ascii_element(&words.join(" "), element)
                });
                return read.map_err(|_| {
                    let (name, comma) = (quote(&element.name), of_comma(&text));
                    let what = format!("`{}` is no {name}{comma}", quote(text.trim()));
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

/// A number with digits on both sides of its point, without which the parser refuses it.
fn filled(word: &str) -> String {
    let is_digit = |c: char| c.is_ascii_digit();
    match word.split_once('.') {
        Some((whole, rest)) if word.parse::<f64>().is_ok() => {
            let before = if whole.ends_with(is_digit) { "" } else { "0" };
            let behind = if rest.starts_with(is_digit) { "" } else { "0" };
            format!("{whole}{before}.{behind}{rest}")
        }
        _ => word.to_owned(),
    }
}

/// Whether a line has more words than an element of its properties.
fn has_more(text: &str, element: &ElementDef) -> bool {
    let mut words = text.split_ascii_whitespace();
    for property in element.properties.values() {
        let n = match property.data_type {
            PropertyType::Scalar(_) => 1,
            // A count that is none is refused where the line is read.
            PropertyType::List(..) => words.next().and_then(|n| n.parse().ok()).unwrap_or(0),
        };
        if n > 0 && words.nth(n - 1).is_none() {
            return false;
        }
    }
    words.next().is_some()
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
