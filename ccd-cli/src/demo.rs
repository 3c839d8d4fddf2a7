//! `ccd demo`: the experiment of [Tian and Wan], run, checked and drawn.

use super::backend::BackendOptions;
use super::cloth::{Cloth, PUSH_DISTANCE, Size};
use super::look::{Look, Zoom};
use super::method::MethodOptions;
use super::pixels::Picture;
use super::plot::Series;
use super::{
    Failure, Outcome, backend, in_file, interrupt, mesh_file, output, picture, plot, progress,
};
use ccd::Mesh;
use clap::Args;
use std::path::PathBuf;

#[derive(Args)]
pub struct Demo {
    /// Frames to simulate, 60 to a second
    #[arg(long, value_name = "N", default_value_t = 90, allow_negative_numbers = true)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=10_000))]
    frames: u32,
    /// Frames after those, in which the cloth loses its velocity and comes to rest
    #[arg(long, value_name = "N", default_value_t = 0, allow_negative_numbers = true)]
    #[arg(value_parser = clap::value_parser!(u32).range(0..=10_000))]
    settle: u32,
    /// How fine the meshes are
    #[arg(long, value_enum, default_value_t = Size::Large)]
    size: Size,
    /// Folder for the picture of the last frame and the plots; made if it is not there
    #[arg(long, value_name = "DIR", default_value = "ccd-demo")]
    out: PathBuf,
    /// What the picture of the last frame shows
    #[arg(long, value_enum, default_value_t = Zoom::Auto)]
    zoom: Zoom,
    /// Write the frames, the first one too, as PLY: FOLDER/frame-00000.ply and so on; made if it is
    /// not there
    ///
    /// `ccd sequence FOLDER --fixed 1` checks them: the sphere is body 1, whose vertices along its
    /// seam and at its poles are there twice, which are contacts at t = 0 unless it is fixed.
    #[arg(long, value_name = "FOLDER")]
    frames_out: Option<PathBuf>,
    #[command(flatten)]
    backend: BackendOptions,
    #[command(flatten)]
    method: MethodOptions,
}

/// Steps of the simulation a frame.
const STEPS: usize = 8;

impl Demo {
    pub fn run(&self) -> Outcome {
        output::go_on();
        if let Some(folder) = &self.frames_out {
            std::fs::create_dir_all(folder).map_err(|e| in_file(folder, e))?;
        }
        std::fs::create_dir_all(&self.out).map_err(|e| in_file(&self.out, e))?;
        let (last, plots) = (self.out.join("last-frame.png"), self.out.join("times.png"));
        let [to_picture, to_plots] = [Picture::create(&last)?, Picture::create(&plots)?];
        let mut cloth = Cloth::new(self.size, &self.backend, &self.method)?;
        self.write_frame(0, &cloth)?;
        output::line("scene", output::MeshSize::of(&cloth.mesh));
        let n_frames = self.frames + self.settle;
        let bar = progress::bar(n_frames as usize, "frames");
        let (mut times, mut contacts) = (Vec::new(), Vec::new());
        let mut n_calls = 0;
        for frame in 0..n_frames {
            for _ in 0..STEPS {
                interrupt::check()?;
                cloth.step(frame >= self.frames)?;
            }
            self.write_frame(frame + 1, &cloth)?;
            times.push(cloth.ccd_ms);
            contacts.push(cloth.contacts.len() as f64);
            n_calls += cloth.n_calls;
            (cloth.ccd_ms, cloth.n_calls) = (0.0, 0);
            bar.inc(1);
        }
        bar.finish_and_clear();
        let (place, backend) = (cloth.place(), cloth.place().backend().to_uppercase());
        let distance = format!("minimum distance {PUSH_DISTANCE}");
        let title =
            format!("a cloth on a sphere, {n_frames} frames; {distance}; {backend}: {place}");
        let [x0, x1] = &cloth.step;
        let scene = picture::Scene {
            title: &title,
            mesh: &cloth.mesh,
            x: [x0, x1],
            contacts: &cloth.contacts,
            total: cloth.contacts.len(),
            window: [0.0, 1.0],
            look: Look { zoom: self.zoom, ..Look::default() },
        };
        picture::write(to_picture, &scene)?;
        plot::write(
            to_plots,
            &title,
            ("frame", 0),
            [
                Series::new("collision detection, ms a frame", &times),
                Series::new("contacts within 6 mm in the last step of a frame", &contacts),
            ],
        )?;
        let total: f64 = times.iter().sum();
        output::line(
            "collisions",
            format_args!(
                "{} for {n_calls} steps, {} a step",
                output::milliseconds(total),
                output::milliseconds(total / n_calls as f64)
            ),
        );
        output::line("", format_args!("on {}", cloth.place()));
        backend::print_compilation(cloth.compilation());
        output::line("contacts", format_args!("{} in the last step", cloth.contacts.len()));
        output::line("speed", format_args!("{:.3} m/s at most", cloth.speed()));
        let n = penetrations(&cloth.mesh, &cloth.x, cloth.n_cloth());
        output::line(
            "penetration",
            if n == 0 {
                "none: no edge passes through a face (checked exactly)".to_string()
            } else {
                format!("{n} edges pass through faces")
            },
        );
        let frames = self.frames_out.as_deref().map_or(String::new(), |folder| {
            format!(", {} ({} frames)", folder.display(), n_frames + 1)
        });
        output::line("written", format_args!("{}, {}{frames}", last.display(), plots.display()));
        if n > 0 {
            return Err(Failure(format!("{n} penetrations after {n_frames} frames")));
        }
        output::flush();
        Ok(!cloth.contacts.is_empty())
    }

    fn write_frame(&self, frame: u32, cloth: &Cloth) -> Result<(), Failure> {
        let Some(folder) = &self.frames_out else { return Ok(()) };
        mesh_file::write_ply(&folder.join(format!("frame-{frame:05}.ply")), &cloth.mesh, &cloth.x)
    }
}

/// Edges of the cloth through faces of anything, and edges of anything through faces of the cloth,
/// in the state `x`: every edge against every face, by exact orientation tests [Shewchuk 1997].
/// Shares nothing with the detection that it checks.
fn penetrations(mesh: &Mesh, x: &[[f64; 3]], n_cloth: usize) -> usize {
    let of_cloth = |v: u32| (v as usize) < n_cloth;
    let bounds = |ids: &[u32]| {
        let mut b = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
        for &v in ids {
            for k in 0..3 {
                b[0][k] = b[0][k].min(x[v as usize][k]);
                b[1][k] = b[1][k].max(x[v as usize][k]);
            }
        }
        b
    };
    // Sorted along x, so that an edge meets only the faces that begin before it ends.
    let mut faces: Vec<_> = mesh.faces().iter().map(|f| (bounds(f), f)).collect();
    faces.sort_by(|a, b| a.0[0][0].total_cmp(&b.0[0][0]));
    let mut n = 0;
    for e in mesh.edges() {
        let b = bounds(e);
        let end = faces.partition_point(|f| f.0[0][0] <= b[1][0]);
        for (fb, f) in &faces[..end] {
            let near = (0..3).all(|k| fb[0][k] <= b[1][k] && b[0][k] <= fb[1][k]);
            if near
                && (of_cloth(e[0]) || of_cloth(f[0]))
                && !f.contains(&e[0])
                && !f.contains(&e[1])
            {
                n += pierces(e.map(|v| x[v as usize]), f.map(|v| x[v as usize])) as usize;
            }
        }
    }
    n
}

/// Whether a segment has a point in common with a triangle that is not coplanar with it.
fn pierces(e: [[f64; 3]; 2], f: [[f64; 3]; 3]) -> bool {
    let p = |x: [f64; 3]| robust::Coord3D { x: x[0], y: x[1], z: x[2] };
    let side = |a, b, c, d| robust::orient3d(p(a), p(b), p(c), p(d));
    let (above, below) = (side(f[0], f[1], f[2], e[0]), side(f[0], f[1], f[2], e[1]));
    if above * below > 0.0 || (above == 0.0 && below == 0.0) {
        return false;
    }
    let around =
        [side(e[0], e[1], f[0], f[1]), side(e[0], e[1], f[1], f[2]), side(e[0], e[1], f[2], f[0])];
    around.iter().all(|&s| s >= 0.0) || around.iter().all(|&s| s <= 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_check_sees_a_penetration() {
        let f = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        assert!(pierces([[0.2, 0.2, -1.0], [0.2, 0.2, 1.0]], f));
        assert!(!pierces([[0.2, 0.2, 0.1], [0.2, 0.2, 1.0]], f));
        assert!(!pierces([[2.0, 0.2, -1.0], [2.0, 0.2, 1.0]], f));
    }
}
