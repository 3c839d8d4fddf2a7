//! OFF: the word `OFF`, the numbers of vertices, faces and edges, a line for each vertex, a line
//! for each face. `#` starts a comment.
//!
//! Read here and not by a crate: the one that there is rounds to `f32`. The keywords `COFF`,
//! `NOFF`, `CNOFF`, `STOFF` and so on put colours, normals or texture coordinates behind a vertex,
//! which are not used; points in four or `n` dimensions (`4OFF`, `nOFF`) and binary files are
//! refused.

use super::{Frame, Input, ReadErrorKind, number, quote};
use std::io::Read;
use std::path::Path;

pub(super) fn read(mut input: Input, _: &Path) -> Result<Frame, ReadErrorKind> {
    let mut bytes = Vec::new();
    input.read_to_end(&mut bytes)?;
    let text = String::from_utf8_lossy(&bytes);
    // Lines that hold something, without comments, by their numbers.
    let lines = text.lines().enumerate().map(|(at, line)| {
        (at + 1, line.trim_start_matches('\u{feff}').split('#').next().unwrap_or_default().trim())
    });
    let mut lines = lines.filter(|(_, line)| !line.is_empty()).peekable();
    let (line, first) = lines.next().ok_or(ReadErrorKind::Header("the file is empty".into()))?;
    let counts = header(first).map_err(|what| ReadErrorKind::Line { line, what })?;
    let (line, counts) = match counts {
        Some(counts) => (line, counts),
        None => lines.next().ok_or(ReadErrorKind::Header("there are no counts".into()))?,
    };
    let [n_vertices, n_faces] =
        numbers_of(counts).map_err(|what| ReadErrorKind::Line { line, what })?;
    let mut frame = Frame::default();
    for (element, count) in [("vertex", n_vertices), ("face", n_faces)] {
        for at in 0..count {
            let Some((line, text)) = lines.next() else {
                let what = format!("the file ends here; its head promises {count}");
                return Err(ReadErrorKind::Element { element, at, what });
            };
            let read = if element == "vertex" { vertex } else { face };
            read(text, &mut frame).map_err(|what| ReadErrorKind::Line { line, what })?;
        }
    }
    match lines.next() {
        None => Ok(frame),
        Some((line, text)) => {
            let what = format!("`{}` is more than the head promises", quote(text));
            Err(ReadErrorKind::Line { line, what })
        }
    }
}

/// Rest of the keyword's line, if there is any.
fn header(line: &str) -> Result<Option<&str>, String> {
    let (keyword, rest) = match line.split_once(char::is_whitespace) {
        Some((keyword, rest)) => (keyword, rest.trim()),
        None => (line, ""),
    };
    let Some(kind) = keyword.strip_suffix("OFF") else {
        return Err(format!("`{}` is not OFF", quote(keyword)));
    };
    if kind.contains(['4', 'n']) {
        return Err(format!("`{}` has points of other than three dimensions", quote(keyword)));
    }
    if rest.starts_with("BINARY") {
        return Err("binary OFF is not read".into());
    }
    Ok((!rest.is_empty()).then_some(rest))
}

/// Numbers of vertices and faces; the number of edges may be missing.
fn numbers_of(line: &str) -> Result<[usize; 2], String> {
    let words: Vec<&str> = line.split_whitespace().collect();
    if words.len() < 2 || words.len() > 3 {
        return Err(format!("`{}` is not the numbers of vertices, faces and edges", quote(line)));
    }
    let count = |word: &str| {
        let limit = crate::Error::MAX_ELEMENTS;
        let n = word.parse().ok().filter(|&n: &u64| n <= limit);
        n.map(|n| n as usize).ok_or_else(|| format!("`{}` is no number of elements", quote(word)))
    };
    Ok([count(words[0])?, count(words[1])?])
}

fn vertex(line: &str, frame: &mut Frame) -> Result<(), String> {
    let mut words = line.split_whitespace();
    let mut next = || number(words.next().ok_or("a vertex needs three coordinates")?);
    let position = [next()?, next()?, next()?];
    // What is behind them must at least be numbers: else this is no vertex.
    words.try_for_each(|word| number(word).map(|_| ()))?;
    frame.positions.push(position);
    Ok(())
}

/// `n v1 .. vn`, and perhaps a colour.
fn face(line: &str, frame: &mut Frame) -> Result<(), String> {
    let mut words = line.split_whitespace();
    let n_vertices = frame.positions.len();
    let n: usize = words.next().and_then(|word| word.parse().ok()).ok_or_else(|| {
        format!("`{}` does not begin with the number of a face's vertices", quote(line))
    })?;
    if n < 3 {
        return Err(format!("has {n} vertices, fewer than 3"));
    }
    let corners = words.by_ref().take(n).map(|word| {
        let v = word.parse().ok().filter(|&v: &u32| (v as usize) < n_vertices);
        let word = quote(word);
        v.ok_or_else(|| format!("`{word}` is none of the {n_vertices} vertices, counted from 0"))
    });
    let corners: Vec<u32> = corners.collect::<Result<_, _>>()?;
    if corners.len() < n {
        return Err(format!("has {} vertices, not the {n} that it says", corners.len()));
    }
    words.try_for_each(|word| number(word).map(|_| ()))?;
    frame.push_polygon(&corners);
    Ok(())
}
