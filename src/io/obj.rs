//! OBJ: the statements `v`, `f` and `l`; other statements of the format are passed over, all else
//! is refused.
//!
//! Read here and not by a crate: contact lists name vertices by the file's own numbers, in `f64`,
//! and the maintained readers either renumber vertices per group or round to `f32`.
//!
//! Lines end with LF, CRLF or CR, also in turn; one that ends with `\` goes on in the next. `#`
//! starts a comment, which ends with its line. Names and comments may be in any encoding that has
//! ASCII's numbers, such as UTF-8, with or without a mark at its beginning, and Latin-1.
//! - `v x y z`, with a weight (`v x y z 1`), a colour (`v x y z r g b`) or a colour with alpha
//!   (seven numbers), all finite. A weight other than 1 is refused: it scales the point in some
//!   programs and means nothing outside of rational surfaces in others.
//! - `f` and `l`: words `v`, `v/vt`, `v//vn` or `v/vt/vn`; the last two numbers are not used.

use super::input::{LONGEST_LINE, too_long};
use super::{Frame, Input, ReadErrorKind, number, quote};
use std::io::{BufRead, Read};
use std::path::Path;

/// Statements that hold neither vertices nor what joins them: normals, texture coordinates,
/// groups, materials, points, and attributes.
const PASSED_OVER: &str = "\
    vn vt vp o g s mtllib usemtl p cstype deg parm trim hole scrv sp end \
    con mg bevel c_interp d_interp lod shadow_obj trace_obj ctech stech bmat step usemap \
    maplib";

/// Byte order mark that some editors put before text in UTF-8.
const MARK: &[u8] = b"\xef\xbb\xbf";

pub(super) fn read(mut reader: Input, _: &Path) -> Result<Frame, ReadErrorKind> {
    let mut frame = Frame::default();
    let mut chunk = Vec::new();
    // What is there of a statement that goes on in the next line, and where it began.
    let (mut begun, mut first) = (Vec::new(), 0);
    let (mut line, mut any) = (0, false);
    // The greatest vertex that is used so far, counted from 1, and where: it may come later.
    let mut most = (0, 0);
    loop {
        chunk.clear();
        let left = LONGEST_LINE.saturating_sub(begun.len() as u64);
        if reader.by_ref().take(left).read_until(b'\n', &mut chunk)? == 0 && left > 0 {
            break;
        }
        if chunk.len() as u64 == left {
            return Err(too_long(line + 1));
        }
        let text = chunk.strip_suffix(b"\n").unwrap_or(&chunk);
        let text = text.strip_suffix(b"\r").unwrap_or(text);
        let text = if line == 0 { text.strip_prefix(MARK).unwrap_or(text) } else { text };
        for text in text.split(|&byte| byte == b'\r') {
            line += 1;
            if begun.is_empty() {
                first = line;
            }
            begun.extend_from_slice(text);
            // The end of a comment, such as a path, is no sign for the line after it.
            if text.ends_with(b"\\") && !text.contains(&b'#') {
                begun.pop();
                begun.push(b' ');
                continue;
            }
            let bad = |what| ReadErrorKind::Line { line: first, what };
            let (n_faces, n_edges) = (frame.faces.len(), frame.edges.len());
            any |= statement(&begun, &mut frame).map_err(bad)?;
            let faces = frame.faces[n_faces..].iter().flatten();
            let used = faces.chain(frame.edges[n_edges..].iter().flatten()).max();
            if let Some(&v) = used.filter(|&&v| v >= most.0) {
                most = (v.saturating_add(1), first);
            }
            begun.clear();
        }
    }
    if !begun.is_empty() {
        let what = "goes on (`\\`), but the file ends".into();
        return Err(ReadErrorKind::Line { line: first, what });
    }
    let n_vertices = frame.positions.len();
    if most.0 as usize > n_vertices {
        let what = format!("vertex index {} names no vertex (there are {n_vertices})", most.0);
        return Err(ReadErrorKind::Line { line: most.1, what });
    }
    if !any {
        return Err(ReadErrorKind::Format("the file holds no statement of OBJ".into()));
    }
    Ok(frame)
}

/// Takes one line; whether it is more than a comment. `Err` says what is wrong with it.
fn statement(text: &[u8], frame: &mut Frame) -> Result<bool, String> {
    if text.iter().any(|&byte| byte.is_ascii_control() && byte != b'\t') {
        return Err("is not text".into());
    }
    let text = String::from_utf8_lossy(text);
    let text = text.split('#').next().unwrap_or_default();
    let words: Vec<&str> = text.split_whitespace().collect();
    let Some((&keyword, words)) = words.split_first() else { return Ok(false) };
    match keyword {
        "v" => frame.positions.push(vertex(words)?),
        "f" => frame.push_polygon(&corners(words, 3, frame.positions.len())?),
        "l" => {
            let corners = corners(words, 2, frame.positions.len())?;
            frame.edges.extend(corners.windows(2).map(|w| [w[0], w[1]]));
        }
        "curv" | "curv2" | "surf" => {
            return Err(format!("`{keyword}`: free-form curves and surfaces are not read"));
        }
        _ if PASSED_OVER.split(' ').any(|word| word == keyword) => {}
        _ => return Err(format!("`{}` is no statement of OBJ", quote(keyword))),
    }
    Ok(true)
}

/// The position of a vertex.
fn vertex(words: &[&str]) -> Result<[f64; 3], String> {
    let mut x = [0.0f64; 7];
    match words.len() {
        0..3 => return Err("a vertex needs three coordinates".into()),
        3 | 4 | 6 | 7 => {}
        n => return Err(format!("a vertex has 3, 4, 6 or 7 numbers, not {n}")),
    }
    for (x, word) in x.iter_mut().zip(words) {
        *x = number(word)?;
    }
    let limit = crate::Error::MAX_COORDINATE;
    if let Some(k) = (0..3).find(|&k| x[k].abs() > limit) {
        return Err(format!("`{}` is beyond {limit:e}", quote(words[k])));
    }
    if words.len() == 4 && x[3] != 1.0 {
        return Err(format!("the weight of a vertex is {}; only 1 is read", x[3]));
    }
    Ok([x[0], x[1], x[2]])
}

/// The vertices of a face or of a line, `least` or more.
fn corners(words: &[&str], least: usize, n_vertices: usize) -> Result<Vec<u32>, String> {
    if words.len() < least {
        return Err(format!("has {} vertices, fewer than {least}", words.len()));
    }
    words.iter().map(|word| vertex_index(word, n_vertices)).collect()
}

/// The vertex of `word` (`7`, `7/1`, `7//2`, `7/1/2`, `-1`), counted from 0.
fn vertex_index(word: &str, n_vertices: usize) -> Result<u32, String> {
    let bad = || format!("`{}` is not a vertex index", quote(word));
    let mut parts = word.split('/');
    let i: i64 = parts.next().and_then(|v| v.parse().ok()).ok_or_else(bad)?;
    for (k, unused) in parts.enumerate() {
        // A number may be left out, but not be 0 or something else.
        let fine = unused.is_empty() || unused.parse::<i64>().is_ok_and(|i| i != 0);
        if !fine || k >= 2 {
            return Err(bad());
        }
    }
    let at = if i < 0 { i.checked_add(n_vertices as i64) } else { i.checked_sub(1) };
    match at.map(u32::try_from) {
        Some(Ok(at)) if i != 0 => Ok(at),
        _ if i == 0 => Err("vertex index 0 names no vertex: OBJ counts from 1".into()),
        _ => Err(format!("vertex index {i} names no vertex (there are {n_vertices} so far)")),
    }
}
