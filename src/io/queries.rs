//! Query files: eight rows a query (four points at `t0`, four at `t1`), coordinates as fractions in
//! six columns, and in a seventh, if there is one, the answer.
//!
//! The format of Wang et al., "A Large-Scale Benchmark and an Inclusion-Based Algorithm for
//! Continuous Collision Detection"; without answers it is that of the scenes of Belgrod et al.,
//! "Time of Impact Dataset for Continuous Collision Detection and a Scalable Conservative
//! Algorithm".

use super::{ReadError, ReadErrorKind, quote};
use crate::{EdgeEdge, Kind, VertexFace};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};
use std::path::Path;

/// An elemental query of either kind.
///
/// ```
/// use ccd::io::Query;
///
/// fn toi(query: &Query) -> Option<f64> {
///     match query {
///         Query::VertexFace(query) => ccd::vertex_face(query, 0.0).toi(),
///         Query::EdgeEdge(query) => ccd::edge_edge(query, 0.0).toi(),
///     }
/// }
/// let x = [[0.0; 3]; 4];
/// assert_eq!(toi(&Query::EdgeEdge(ccd::EdgeEdge { t0: x, t1: x })), Some(0.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Query {
    /// A vertex against a face.
    VertexFace(VertexFace<f64>),
    /// An edge against an edge.
    EdgeEdge(EdgeEdge<f64>),
}

/// The content of a query file.
///
/// ```
/// use ccd::io::Queries;
///
/// let none = Queries::default();
/// // Without answers, or one a query.
/// assert!(none.answers.is_empty() || none.answers.len() == none.queries.len());
/// ```
#[derive(Clone, Debug, Default)]
pub struct Queries {
    /// The queries in the order of the file.
    pub queries: Vec<Query>,
    /// Whether each is a contact, as the file says; empty if it does not.
    pub answers: Vec<bool>,
}

/// Reads a query file. Whether it holds vertex-face or edge-edge queries is told by its path: the
/// name of the file, or of the nearest folder, that contains `vertex-face`, `vf`, `edge-edge` or
/// `ee`.
///
/// ```no_run
/// use ccd::io::{Query, read_queries};
/// use std::path::Path;
///
/// let file = read_queries(Path::new("queries/vertex-face/0.csv"))?;
/// for (query, answer) in file.queries.iter().zip(&file.answers) {
///     let Query::VertexFace(query) = query else { continue };
///     println!("{:?}, the file says {answer}", ccd::vertex_face(query, 0.0));
/// }
/// # Ok::<(), ccd::io::ReadError>(())
/// ```
///
/// # Errors
/// As [`read_queries_of`], and a path that does not tell.
pub fn read_queries(path: &Path) -> Result<Queries, ReadError> {
    match kind_of(path) {
        Some(kind) => read_queries_of(path, kind),
        None => {
            let what = "the path says neither vertex-face (vf) nor edge-edge (ee): give the kind";
            // Where the file cannot be opened, that is the reason to give.
            let kind = match std::fs::File::open(path) {
                Ok(_) => ReadErrorKind::Format(what.into()),
                Err(e) => e.into(),
            };
            Err(ReadError { path: path.to_owned(), kind })
        }
    }
}

/// Reads a file of queries of one kind.
///
/// # Errors
/// A kind of other pairs; a row with other columns than six or seven, or than the first; a fraction
/// that is no `f64` exactly; an end within a query.
pub fn read_queries_of(path: &Path, kind: Kind) -> Result<Queries, ReadError> {
    read(path, kind).map_err(|kind| ReadError { path: path.to_owned(), kind })
}

fn read(path: &Path, kind: Kind) -> Result<Queries, ReadErrorKind> {
    let query = match kind {
        Kind::VertexFace => |t0, t1| Query::VertexFace(VertexFace { t0, t1 }),
        Kind::EdgeEdge => |t0, t1| Query::EdgeEdge(EdgeEdge { t0, t1 }),
        _ => {
            let what = "query files hold vertex-face or edge-edge queries, of four points";
            return Err(ReadErrorKind::Format(what.into()));
        }
    };
    let file = std::fs::File::open(path)?;
    let mut reader = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(file);
    let mut out = Queries::default();
    let mut points = [[0.0; 3]; 8];
    let mut n_rows = 0;
    let mut record = csv::StringRecord::new();
    let (mut answer, mut n_columns) = (false, 0);
    loop {
        let next = reader.position().line() as usize;
        let unread = |e: csv::Error| ReadErrorKind::Line { line: next, what: e.to_string() };
        if !reader.read_record(&mut record).map_err(unread)? {
            break;
        }
        // Blank lines count, too.
        let line = record.position().map_or(next, |at| at.line() as usize);
        let bad = |what: String| ReadErrorKind::Line { line, what };
        n_columns = if n_rows == 0 { record.len() } else { n_columns };
        if record.len() != n_columns || !(n_columns == 6 || n_columns == 7) {
            let expected = if n_rows == 0 { "6 or 7".into() } else { n_columns.to_string() };
            return Err(bad(format!("has {} columns, expected {expected}", record.len())));
        }
        for axis in 0..3 {
            points[n_rows % 8][axis] =
                fraction(&record[2 * axis], &record[2 * axis + 1]).map_err(bad)?;
        }
        let row_answer = match record.get(6).map(str::trim) {
            None | Some("0") => false,
            Some("1") => true,
            Some(other) => {
                return Err(bad(format!("the answer is `{}`, expected 0 or 1", quote(other))));
            }
        };
        if n_rows % 8 != 0 && row_answer != answer {
            return Err(bad("the rows of one query have different answers".into()));
        }
        answer = row_answer;
        n_rows += 1;
        if n_rows % 8 == 0 {
            let t0 = [points[0], points[1], points[2], points[3]];
            let t1 = [points[4], points[5], points[6], points[7]];
            out.queries.push(query(t0, t1));
            if n_columns == 7 {
                out.answers.push(answer);
            }
        }
    }
    if n_rows % 8 != 0 {
        let what = format!("the file ends within a query ({n_rows} rows, not a multiple of 8)");
        return Err(ReadErrorKind::Line { line: n_rows, what });
    }
    Ok(out)
}

/// Nearest component of the path first.
fn kind_of(path: &Path) -> Option<Kind> {
    path.iter().rev().find_map(|part| {
        let part = part.to_string_lossy().to_ascii_lowercase();
        // `227ee`, `vertex_face`, but not `coffee`.
        let words: Vec<&str> = part
            .split(|c: char| !c.is_ascii_alphabetic())
            .filter(|word| !word.is_empty())
            .collect();
        let names = |short: &str, long: [&str; 2]| {
            words.contains(&short) || words.windows(2).any(|two| two == long)
        };
        let (ee, vf) = (names("ee", ["edge", "edge"]), names("vf", ["vertex", "face"]));
        (ee != vf).then_some(if ee { Kind::EdgeEdge } else { Kind::VertexFace })
    })
}

/// Digits of an integer: those of the longest that a reduced fraction needs are 324.
const LONGEST: usize = 4096;

/// `numerator / denominator`, refused if it is no `f64` exactly: a rounded query would be another
/// query.
///
/// Longer integers than [`LONGEST`] are refused before that is known, which would take long.
fn fraction(numerator: &str, denominator: &str) -> Result<f64, String> {
    let parse = |s: &str| {
        if s.len() > LONGEST {
            return Err(format!("`{}` has more than {LONGEST} digits", quote(s)));
        }
        s.trim().parse::<BigInt>().map_err(|_| format!("`{}` is not an integer", quote(s)))
    };
    let (n, d) = (parse(numerator)?, parse(denominator)?);
    if d.is_zero() {
        return Err("the denominator is 0".into());
    }
    let exact = BigRational::new(n, d);
    match exact.to_f64() {
        Some(value)
            if value.is_finite() && BigRational::from_float(value).as_ref() == Some(&exact) =>
        {
            Ok(value)
        }
        _ => {
            let fraction = quote(&format!("{numerator}/{denominator}"));
            Err(format!("{fraction} is not a double-precision number"))
        }
    }
}
