//! NPY, the format of NumPy's arrays: where the numbers begin, what they are, how many.
//!
//! Versions 1 to 3; `f4` and `f8` of either byte order, in C order, in three dimensions of which
//! the last is 3.

use super::{ReadErrorKind, quote};
use std::io::{Error, ErrorKind::UnexpectedEof, Read};

/// An array of frames.
pub(super) struct Header {
    /// Bytes before the numbers.
    pub start: u64,
    pub n_frames: u64,
    pub n_vertices: u64,
    /// Whether numbers are `f64`, and whether their most significant byte comes first.
    pub wide: bool,
    pub big_endian: bool,
}

/// The longest header that is read: NumPy writes less than a thousandth of it.
const LONGEST: u32 = 1 << 16;

impl Header {
    /// Bytes of all numbers, unless they overflow.
    pub fn n_bytes(&self) -> Option<u64> {
        let numbers = self.n_vertices.checked_mul(if self.wide { 24 } else { 12 })?;
        self.n_frames.checked_mul(numbers)
    }
}

pub(super) fn header(from: &mut impl Read) -> Result<Header, ReadErrorKind> {
    look(from).map_err(|(why, _)| why)
}

/// The header, or why it is not read; the second part says whether it may be of positions over time
/// all the same, in another order or of other numbers.
pub(super) fn look(from: &mut impl Read) -> Result<Header, (ReadErrorKind, bool)> {
    let text = text(from).map_err(|why| (why, false))?;
    let shape = value(&text.0, "shape").unwrap_or_default();
    let is_like = match sizes(shape).as_deref() {
        Ok([.., 3]) => shape.matches(',').count() > 1,
        _ => false,
    };
    parse(text).map_err(|why| (why, is_like))
}

/// The dictionary of a header, and where it ends.
fn text(from: &mut impl Read) -> Result<(String, u64), ReadErrorKind> {
    let bad = |what: &str| ReadErrorKind::Header(what.into());
    let ends = |e: Error, what| if e.kind() == UnexpectedEof { bad(what) } else { e.into() };
    let mut first = [0; 8];
    from.read_exact(&mut first).map_err(|e| ends(e, "the file is no array of NumPy"))?;
    if &first[..6] != b"\x93NUMPY" || !(1..=3).contains(&first[6]) {
        return Err(bad("the file is no array of NumPy, version 1 to 3"));
    }
    let mut size = [0; 4];
    let n_bytes = if first[6] == 1 { 2 } else { 4 };
    from.read_exact(&mut size[..n_bytes]).map_err(|e| ends(e, "the file ends in its header"))?;
    let length = u32::from_le_bytes(size);
    if length > LONGEST {
        return Err(bad(&format!("takes {length} bytes, more than {LONGEST}")));
    }
    let mut text = Vec::new();
    from.take(length.into()).read_to_end(&mut text)?;
    if text.len() as u64 != u64::from(length) {
        return Err(bad("the file ends in its header"));
    }
    let end = 8 + n_bytes as u64 + u64::from(length);
    Ok((String::from_utf8_lossy(&text).into_owned(), end))
}

/// The numbers of a shape.
fn sizes(shape: &str) -> Result<Vec<u64>, std::num::ParseIntError> {
    let sizes = shape.trim_matches(['(', ')']).split(',').map(str::trim);
    sizes.filter(|s| !s.is_empty()).map(str::parse).collect()
}

fn parse((text, start): (String, u64)) -> Result<Header, ReadErrorKind> {
    let bad = |what: &str| ReadErrorKind::Header(what.into());
    let missing = |key: &str| bad(&format!("has no {key}: {}", quote(text.trim())));
    let kind = value(&text, "descr").ok_or_else(|| missing("descr"))?;
    let kind = kind.trim_matches(['\'', '"']);
    let (wide, big_endian) = match kind {
        "<f4" => (false, false),
        "<f8" => (true, false),
        ">f4" => (false, true),
        ">f8" => (true, true),
        _ => {
            let what = format!("numbers are `{}`; float32 or float64 are read", quote(kind));
            return Err(ReadErrorKind::Header(what));
        }
    };
    if value(&text, "fortran_order").ok_or_else(|| missing("fortran_order"))? != "False" {
        return Err(bad("is in Fortran order; numpy.ascontiguousarray makes one that is read"));
    }
    let shape = value(&text, "shape").ok_or_else(|| missing("shape"))?;
    match sizes(shape).as_deref() {
        Ok(&[n_frames, n_vertices, 3]) => {
            Ok(Header { start, n_frames, n_vertices, wide, big_endian })
        }
        _ => {
            let shape = quote(shape);
            Err(ReadErrorKind::Header(format!("the shape is {shape}, expected (frames, n, 3)")))
        }
    }
}

/// Value of a key in the header, a dictionary as Python writes it.
fn value<'a>(text: &'a str, key: &str) -> Option<&'a str> {
    let at = ['\'', '"'].iter().find_map(|quote| {
        let name = format!("{quote}{key}{quote}");
        text.find(&name).map(|at| at + name.len())
    })?;
    let rest = text[at..].trim_start().strip_prefix(':')?.trim_start();
    let end = if rest.starts_with('(') { rest.find(')')? + 1 } else { rest.find([',', '}'])? };
    Some(rest[..end].trim())
}
