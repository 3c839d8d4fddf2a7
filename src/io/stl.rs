//! STL, binary or as text: triangles alone, whose vertices are merged where they have exactly the
//! same position.
//!
//! Read here and not by a crate: the maintained one stops behind the first solid of a text, rounds
//! to `f32` and names no lines. A file is binary if it is as long as its number of triangles says;
//! else it is text. Normals and attributes are not used.

use super::weld::Weld;
use super::{Frame, Input, ReadErrorKind, number, quote};
use std::io::Read;
use std::path::Path;

/// Bytes of the comment and the number of triangles, and of a triangle.
const HEADER: usize = 84;
const TRIANGLE: usize = 50;

pub(super) fn read(mut input: Input, _: &Path) -> Result<Frame, ReadErrorKind> {
    let mut bytes = Vec::new();
    input.read_to_end(&mut bytes)?;
    let n = bytes.get(80..HEADER).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]) as usize);
    let is_text = bytes.trim_ascii_start().starts_with(b"solid");
    match n {
        Some(n) if (bytes.len() - HEADER) as u64 == n as u64 * TRIANGLE as u64 => {
            Ok(binary(&bytes[HEADER..]))
        }
        _ if is_text => text(&String::from_utf8_lossy(&bytes)),
        Some(n) => {
            let what = format!(
                "the header promises {n} triangles, which take {} bytes; the file has {}",
                HEADER as u64 + n as u64 * TRIANGLE as u64,
                bytes.len()
            );
            Err(ReadErrorKind::Header(what))
        }
        None => Err(ReadErrorKind::Header("the file is neither binary STL nor its text".into())),
    }
}

fn binary(triangles: &[u8]) -> Frame {
    let (mut frame, mut weld) = (Frame::default(), Weld::default());
    for triangle in triangles.chunks_exact(TRIANGLE) {
        let number = |at: usize| {
            let b = &triangle[at..at + 4];
            f32::from_le_bytes([b[0], b[1], b[2], b[3]]) as f64
        };
        // A normal comes first.
        let corner = |k: usize| [0, 4, 8].map(|axis| number(12 + 12 * k + axis));
        let corners = [0, 1, 2].map(|k| weld.vertex(corner(k), &mut frame));
        frame.push_polygon(&corners);
    }
    frame
}

/// Whether the words behind the name of a solid are those of a facet.
fn has_facet<'a>(words: impl Iterator<Item = &'a str> + Clone) -> bool {
    let is = |word: &str, name: &str| word.eq_ignore_ascii_case(name);
    words.clone().zip(words.skip(1)).any(|(a, b)| is(a, "facet") && is(b, "normal"))
}

/// `solid` .. `facet normal` .. `outer loop`, three times `vertex x y z`, `endloop`, `endfacet` ..
/// `endsolid`, and again.
fn text(text: &str) -> Result<Frame, ReadErrorKind> {
    let (mut frame, mut weld) = (Frame::default(), Weld::default());
    let mut corners: Vec<u32> = Vec::new();
    let (mut in_solid, mut in_facet) = (false, false);
    for (at, line) in text.lines().enumerate() {
        let bad = |what: String| ReadErrorKind::Line { line: at + 1, what };
        let mut words = line.split_whitespace();
        let Some(word) = words.next() else { continue };
        match word.to_ascii_lowercase().as_str() {
            "solid" | "endsolid" if has_facet(words.clone()) => {
                return Err(bad("a facet begins in a line of its own".into()));
            }
            "solid" if !in_solid => in_solid = true,
            "endsolid" if in_solid && !in_facet => in_solid = false,
            "facet" if in_solid && !in_facet => in_facet = true,
            "outer" if in_facet && corners.is_empty() => {}
            "vertex" if in_facet => {
                let mut next = || number(words.next().ok_or("a vertex needs three coordinates")?);
                let mut position = [0.0; 3];
                for x in &mut position {
                    *x = next().map_err(bad)?;
                }
                if words.next().is_some() {
                    return Err(bad(format!(
                        "`{}` has more than three numbers",
                        quote(line.trim())
                    )));
                }
                corners.push(weld.vertex(position, &mut frame));
            }
            "endloop" if in_facet => {}
            "endfacet" if in_facet => {
                if corners.len() != 3 {
                    return Err(bad(format!("the facet has {} vertices, not 3", corners.len())));
                }
                frame.push_polygon(&corners);
                corners.clear();
                in_facet = false;
            }
            _ => return Err(bad(format!("`{}` is not expected here", quote(line.trim())))),
        }
    }
    if in_solid {
        let line = text.lines().count();
        return Err(ReadErrorKind::Line { line, what: "the file ends within a solid".into() });
    }
    Ok(frame)
}
