//! Meshes written to files: PLY, binary, little-endian, positions as `f64`.

use super::files::Output;
use super::{Failure, in_file};
use ccd::Mesh;
use std::io::{BufWriter, Write};
use std::path::Path;

/// Writes the vertices and faces of a mesh at positions `x`.
pub fn write_ply(path: &Path, mesh: &Mesh, x: &[[f64; 3]]) -> Result<(), Failure> {
    write(path, mesh, x).map_err(|e| in_file(path, e))
}

fn write(path: &Path, mesh: &Mesh, x: &[[f64; 3]]) -> std::io::Result<()> {
    let mut out = BufWriter::new(Output::beside(path)?);
    write!(
        out,
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\n\
         property double y\nproperty double z\nelement face {}\n\
         property list uchar int vertex_indices\nend_header\n",
        x.len(),
        mesh.faces().len()
    )?;
    for c in x.as_flattened() {
        out.write_all(&c.to_le_bytes())?;
    }
    for face in mesh.faces() {
        out.write_all(&[3])?;
        for v in face {
            out.write_all(&v.to_le_bytes())?;
        }
    }
    out.into_inner()?.done()
}
