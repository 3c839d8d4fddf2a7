//! OBJ: the lines `v`, `f` and `l`; everything else is passed over.
//!
//! Read here and not by a crate: contact lists name vertices by the file's own numbers, in `f64`, and the maintained readers either
//! renumber vertices per group or round to `f32`.

use super::{Frame, ReadErrorKind, push_polygon};
use std::io::BufRead;
use std::path::Path;

pub(super) fn read(path: &Path) -> Result<Frame, ReadErrorKind> {
    let mut reader = std::io::BufReader::new(std::fs::File::open(path)?);
    let mut frame = Frame::default();
    let mut corners = Vec::new();
    let mut text = Vec::new();
    let mut n_known = 0;
    for line in 1.. {
        text.clear();
        if reader.read_until(b'\n', &mut text)? == 0 {
            break;
        }
        let bad = |what: String| ReadErrorKind::Line { line, what };
        let text = std::str::from_utf8(&text).map_err(|_| bad("is not text".into()))?;
        let mut words = text.split_whitespace();
        let keyword = words.next().unwrap_or("#");
        match keyword {
            "v" => {
                let mut p = [0.0; 3];
                for x in &mut p {
                    let word = words.next().ok_or_else(|| bad("a vertex needs three coordinates".into()))?;
                    *x = word.parse().map_err(|_| bad(format!("`{word}` is not a number")))?;
                }
                frame.positions.push(p);
                n_known += 1;
            }
            "f" | "l" => {
                corners.clear();
                for word in words {
                    corners.push(vertex_index(word, frame.positions.len()).map_err(bad)?);
                }
                let least = if keyword == "f" { 3 } else { 2 };
                if corners.len() < least {
                    return Err(bad(format!("has {} vertices, fewer than {least}", corners.len())));
                }
                if keyword == "f" {
                    push_polygon(&mut frame.faces, &corners);
                } else {
                    frame.edges.extend(corners.windows(2).map(|w| [w[0], w[1]]));
                }
                n_known += 1;
            }
            // Comments, normals, texture coordinates, groups, materials, curves and surfaces.
            _ if keyword.starts_with('#') => {}
            "vn" | "vt" | "vp" | "o" | "g" | "s" | "mtllib" | "usemtl" | "p" | "cstype" | "deg" | "curv" | "curv2" | "surf" | "parm"
            | "trim" | "hole" | "scrv" | "sp" | "end" | "con" | "mg" | "bevel" | "c_interp" | "d_interp" | "lod" | "shadow_obj"
            | "trace_obj" | "ctech" | "stech" | "bmat" | "step" | "usemap" | "maplib" => n_known += 1,
            _ => return Err(bad(format!("`{}` is no statement of OBJ", keyword.chars().take(20).collect::<String>()))),
        }
    }
    if n_known == 0 {
        return Err(ReadErrorKind::Header("the file holds no statement of OBJ".into()));
    }
    Ok(frame)
}

/// The vertex of `word` (`7`, `7/1`, `7//2`, `-1`), counted from 0.
fn vertex_index(word: &str, n_vertices: usize) -> Result<u32, String> {
    let digits = word.split('/').next().unwrap_or(word);
    let i: i64 = digits.parse().map_err(|_| format!("`{word}` is not a vertex index"))?;
    let at = if i < 0 { n_vertices as i64 + i } else { i - 1 };
    match u32::try_from(at) {
        Ok(at) if i != 0 => Ok(at),
        _ => Err(format!("vertex index {i} names no vertex (there are {n_vertices} so far)")),
    }
}
