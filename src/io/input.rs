//! Input of a reader of meshes: bytes of a file or of a stream, unpacked if they are compressed.

use super::ReadErrorKind;
use flate2::read::MultiGzDecoder;
use std::io::{BufReader, Cursor, Read, Result};

/// Bytes of a mesh file.
pub(super) type Input<'a> = BufReader<Box<dyn Read + 'a>>;

/// Bytes by which a format is told; that many characters of comments may come before the `OFF` of a
/// file of this format.
const HEAD: u64 = 1024;

/// Bytes of a line, with those that it goes on in: a compressed file may unpack to one without end.
pub(super) const LONGEST_LINE: u64 = 1 << 24;

/// The error of a line, counted from 1, that is longer.
pub(super) fn too_long(line: usize) -> ReadErrorKind {
    let what = format!("is longer than {} MiB", LONGEST_LINE >> 20);
    ReadErrorKind::Line { line, what }
}

/// The bytes of a file or stream, without gzip's compression, and the first of them.
pub(super) fn open<'a>(from: impl Read + 'a) -> Result<(Input<'a>, Vec<u8>)> {
    let (head, all) = peeked(from)?;
    let (head, all) = match head.starts_with(b"\x1f\x8b") {
        true => peeked(MultiGzDecoder::new(BufReader::with_capacity(1 << 16, all)))?,
        false => (head, all),
    };
    Ok((BufReader::with_capacity(1 << 16, all), head))
}

/// The first bytes, and all of them.
fn peeked<'a>(mut from: impl Read + 'a) -> Result<(Vec<u8>, Box<dyn Read + 'a>)> {
    let mut head = Vec::new();
    from.by_ref().take(HEAD).read_to_end(&mut head)?;
    Ok((head.clone(), Box::new(Cursor::new(head).chain(from))))
}

/// The format of a mesh that begins so: what no other one begins with, or OBJ.
pub(super) fn format_of(head: &[u8]) -> &'static str {
    let text = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head).trim_ascii_start();
    let lines = text.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii_start);
    let first = lines.into_iter().find(|line| !line.is_empty() && !line.starts_with(b"#"));
    let word = first.and_then(|line| line.split(u8::is_ascii_whitespace).next());
    match head {
        [b'p', b'l', b'y', ..] => "ply",
        [b'g', b'l', b'T', b'F', ..] => "glb",
        _ if text.starts_with(b"{") => "gltf",
        _ if word.is_some_and(|word| word.ends_with(b"OFF")) => "off",
        // Binary files of this format may begin with anything, but have bytes that are no text.
        _ if text.starts_with(b"solid") || head.contains(&0) => "stl",
        _ => "obj",
    }
}

/// What a file that could not be read is, if its first bytes say that it is not of its format.
pub(super) fn foreign(head: &[u8], format: &str) -> Option<String> {
    let is = |start: &[u8]| head.starts_with(start);
    let what = match format {
        _ if head.is_empty() => "empty",
        _ if is(b"\xff\xfe") || is(b"\xfe\xff") => "text in UTF-16; save it as UTF-8",
        _ if is(b"\x1f\x8b") => "compressed by gzip twice; unpack it",
        _ if is(b"PK\x03\x04") => "an archive (zip); unpack it",
        _ if is(b"\x89PNG") => "a picture (PNG)",
        "ply" if head.len() >= 3 && !is(b"ply") => "no PLY: it does not begin with `ply`",
        "gltf" | "glb"
            if head.len() >= 4 && !is(b"glTF") && !head.trim_ascii_start().starts_with(b"{") =>
        {
            "no glTF: it begins neither with `glTF` nor with `{`"
        }
        _ => return None,
    };
    Some(format!("the file is {what}"))
}
