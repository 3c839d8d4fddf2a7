//! Contacts as points of a PLY file, for Blender, MeshLab or ParaView: where they are at the time
//! of impact, coloured by it as a picture is.

use super::legend::colour_of;
use super::rows::Step;
use super::{Failure, files};
use ccd::{Contact, State};
use std::io::{BufWriter, Write};
use std::path::Path;

const HEAD: &str = "property double x\nproperty double y\nproperty double z\n\
    property float nx\nproperty float ny\nproperty float nz\n\
    property uchar red\nproperty uchar green\nproperty uchar blue\n\
    property double toi\nproperty uchar undecided\nproperty uint a\nproperty uint b\nend_header\n";

/// Whether contacts are written as points there.
pub fn are_wanted(path: &Path) -> bool {
    files::has_extension(path, &["ply"])
}

/// A file of contacts, which is opened before any work.
pub struct Points<'a> {
    path: &'a Path,
    out: BufWriter<files::Output>,
}

impl<'a> Points<'a> {
    pub fn create(path: &'a Path) -> Result<Self, Failure> {
        Ok(Self { path, out: BufWriter::new(files::create(path, &["ply"])?) })
    }

    /// Writes the contacts of a step, and puts the file in its place.
    pub fn write(self, contacts: &[Contact], step: &Step) -> Result<(), Failure> {
        let path = self.path;
        self.all(contacts, step).map_err(|e| files::failed(path, e))
    }

    fn all(mut self, contacts: &[Contact], step: &Step) -> std::io::Result<()> {
        let out = &mut self.out;
        let n = contacts.len();
        write!(out, "ply\nformat binary_little_endian 1.0\nelement vertex {n}\n{HEAD}")?;
        let times = || contacts.iter().map(|c| c.toi);
        let first = times().fold(f64::INFINITY, f64::min);
        let length = times().fold(first, f64::max) - first;
        for c in contacts {
            let at = c.geometry(step.mesh, step.x0, step.x1);
            let part = if length > 0.0 { (c.toi - first) / length } else { 0.0 };
            let colour = colour_of(part).map(|x| (255.0 * x).round() as u8);
            out.write_all(at.point.map(f64::to_le_bytes).as_flattened())?;
            out.write_all(at.normal.map(|x| (x as f32).to_le_bytes()).as_flattened())?;
            out.write_all(&colour)?;
            out.write_all(&c.toi.to_le_bytes())?;
            out.write_all(&[(c.state == State::Undecided) as u8])?;
            out.write_all([c.a, c.b].map(u32::to_le_bytes).as_flattened())?;
        }
        self.out.into_inner()?.done()
    }
}
