//! Rows of CSV: contacts with their geometry, candidates, verdicts of queries.

use super::{Failure, files};
use ccd::{Contact, Kind, Mesh, State};
use std::io::{BufWriter, Write};
use std::path::Path;

/// A step: the mesh, its positions at the start and at the end, and the polygon of the file that
/// each face is a part of.
pub struct Step<'a> {
    pub mesh: &'a Mesh,
    pub x0: &'a [[f64; 3]],
    pub x1: &'a [[f64; 3]],
    pub polygons: &'a [u32],
}

/// Columns of a contact, behind the number of the step where there are several.
const COLUMNS: &str = "kind,a,b,toi,state,v0,v1,v2,v3,polygon,px,py,pz,nx,ny,nz,w0,w1,w2,w3";

/// A file of rows, or standard output.
pub struct Rows<'a> {
    path: &'a Path,
    writer: BufWriter<files::Output>,
}

impl<'a> Rows<'a> {
    /// Opens the file, or standard output for `-`, and writes the names of columns.
    pub fn create(path: &'a Path, columns: &str) -> Result<Self, Failure> {
        Self::ending(path, &["csv"], columns)
    }

    /// The same, where the name may end in any of these.
    fn ending(path: &'a Path, extensions: &[&str], columns: &str) -> Result<Self, Failure> {
        let writer = BufWriter::with_capacity(1 << 16, files::create(path, extensions)?);
        let mut rows = Self { path, writer };
        rows.row(format_args!("{columns}"))?;
        rows.flush()?;
        Ok(rows)
    }

    /// A file of contacts, of many steps with their numbers in front. Those of one step may also be
    /// points of a PLY file, which is not opened here: a name that is neither is told both.
    pub fn of_contacts(path: &'a Path, frames: bool) -> Result<Self, Failure> {
        match frames {
            true => Self::create(path, &format!("frame,{COLUMNS}")),
            false => Self::ending(path, &["csv", "ply"], COLUMNS),
        }
    }

    pub fn row(&mut self, text: std::fmt::Arguments) -> Result<(), Failure> {
        let written = self.writer.write_fmt(text).and_then(|()| self.writer.write_all(b"\n"));
        written.map_err(|e| files::failed(self.path, e))
    }

    pub fn flush(&mut self) -> Result<(), Failure> {
        self.writer.flush().map_err(|e| files::failed(self.path, e))
    }

    /// Puts the file in its place.
    pub fn done(self) -> Result<(), Failure> {
        let written = self.writer.into_inner().map_err(|e| e.into_error());
        written.and_then(|out| out.done()).map_err(|e| files::failed(self.path, e))
    }

    /// Appends the contacts of a step, with its number where there are several.
    pub fn contacts(
        &mut self,
        frame: Option<usize>,
        contacts: &[Contact],
        step: &Step,
    ) -> Result<(), Failure> {
        let frame = frame.map_or(String::new(), |frame| format!("{frame},"));
        for c in contacts {
            let polygon = match c.kind {
                Kind::VertexFace => step.polygons.get(c.b as usize).map(u32::to_string),
                _ => None,
            };
            let (kind, state) = (kind(c.kind), state(c.state));
            let n = n_vertices(c.kind);
            let [v0, v1, v2, v3] = only(n, c.vertices(step.mesh).map(|v| v.to_string()));
            let at = c.geometry(step.mesh, step.x0, step.x1);
            let ([px, py, pz], [nx, ny, nz]) = (at.point, at.normal);
            let [w0, w1, w2, w3] = only(n, at.weights.map(|w| format!("{w:?}")));
            self.row(format_args!(
                "{frame}{kind},{},{},{:?},{state},{v0},{v1},{v2},{v3},{},\
                 {px:?},{py:?},{pz:?},{nx:?},{ny:?},{nz:?},{w0},{w1},{w2},{w3}",
                c.a,
                c.b,
                c.toi,
                polygon.unwrap_or_default()
            ))?;
        }
        self.flush()
    }

    /// Appends pairs of one kind, kind, a, b, sorted.
    pub fn pairs(
        &mut self,
        kind: Kind,
        pairs: impl Iterator<Item = ccd::Pair>,
    ) -> Result<(), Failure> {
        let mut pairs: Vec<(u32, u32)> = pairs.map(|pair| (pair.a, pair.b)).collect();
        pairs.sort_unstable();
        let kind = self::kind(kind);
        for (a, b) in pairs {
            self.row(format_args!("{kind},{a},{b}"))?;
        }
        self.flush()
    }
}

/// Vertices of a pair.
fn n_vertices(kind: Kind) -> usize {
    match kind {
        Kind::VertexFace | Kind::EdgeEdge => 4,
        Kind::VertexEdge => 3,
        Kind::VertexVertex => 2,
    }
}

/// The first `n`; the others are empty.
fn only(n: usize, mut cells: [String; 4]) -> [String; 4] {
    cells[n..].iter_mut().for_each(String::clear);
    cells
}

pub fn kind(kind: Kind) -> &'static str {
    match kind {
        Kind::VertexFace => "vf",
        Kind::EdgeEdge => "ee",
        Kind::VertexEdge => "ve",
        Kind::VertexVertex => "vv",
    }
}

fn state(state: State) -> &'static str {
    match state {
        State::Hit => "hit",
        State::Undecided => "undecided",
    }
}
