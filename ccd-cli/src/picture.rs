//! A picture of a mesh with its contacts: a small rasteriser, orthographic, shaded by the angle to
//! the viewer.

use super::{Failure, in_file};
use ccd::geometry::vec3::{cross, dot, lerp, scale, sub};
use ccd::{Contact, Kind, Mesh, State};
use std::path::Path;

/// Size of the picture in pixels.
const WIDTH: usize = 1280;
const HEIGHT: usize = 960;
/// Samples per pixel and axis.
const SAMPLES: usize = 2;
/// Distance of the mesh from the border, as a part of the picture.
const BORDER: f64 = 0.05;
/// Towards the viewer, and up.
const VIEW: [f64; 3] = [0.45, 0.42, 0.79];
const UP: [f64; 3] = [0.0, 1.0, 0.0];

const BACKGROUND: [f64; 3] = [0.97, 0.97, 0.98];
const FACE: [f64; 3] = [0.62, 0.68, 0.76];
const BACK: [f64; 3] = [0.70, 0.66, 0.60];
const HIT: [f64; 3] = [0.84, 0.10, 0.11];
const UNDECIDED: [f64; 3] = [0.95, 0.60, 0.05];

/// Writes the mesh as it is at the start of the step; marks are where features meet: red for hits,
/// orange for undecided ones, faint where the mesh hides them; a ring marks the earliest.
pub fn write(
    path: &Path,
    mesh: &Mesh,
    x0: &[[f64; 3]],
    contacts: &[Contact],
) -> Result<(), Failure> {
    let mut canvas = Canvas::new(x0);
    for &face in mesh.faces() {
        canvas.triangle(face.map(|v| x0[v as usize]));
    }
    // Few marks are large, many are small.
    let radius = (14.0 - 2.0 * (contacts.len().max(1) as f64).log10()).max(3.0);
    // So that many marks behind a surface do not add up to one before it.
    let hidden = (300.0 / contacts.len().max(1) as f64).clamp(0.01, 0.12);
    let order = |c: &&Contact| c.state == State::Hit;
    for c in contacts.iter().filter(|c| !order(c)).chain(contacts.iter().filter(order)) {
        let colour = if c.state == State::Hit { HIT } else { UNDECIDED };
        canvas.disc(place(c, mesh, x0), radius, colour, hidden);
    }
    if let Some(first) = contacts.iter().min_by(|a, b| a.toi.total_cmp(&b.toi)) {
        canvas.ring(place(first, mesh, x0), 26.0);
    }
    canvas.save(path)
}

/// Roughly where a contact is, on the mesh at the start: the vertex, or the middle between the
/// middles of the edges.
fn place(c: &Contact, mesh: &Mesh, x0: &[[f64; 3]]) -> [f64; 3] {
    let at = |v: u32| x0[v as usize];
    match c.kind {
        Kind::VertexFace => at(c.a),
        Kind::EdgeEdge => {
            let middle = |e: u32| {
                let [a, b] = mesh.edges()[e as usize];
                lerp(at(a), at(b), 0.5)
            };
            lerp(middle(c.a), middle(c.b), 0.5)
        }
    }
}

struct Canvas {
    colour: Vec<[f64; 3]>,
    depth: Vec<f64>,
    right: [f64; 3],
    up: [f64; 3],
    view: [f64; 3],
    centre: [f64; 2],
    zoom: f64,
    extent: f64,
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    scale(a, 1.0 / dot(a, a).sqrt())
}

impl Canvas {
    fn new(points: &[[f64; 3]]) -> Self {
        let view = unit(VIEW);
        let right = unit(cross(UP, view));
        let up = cross(view, right);
        let (mut min, mut max) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for &p in points {
            for (k, axis) in [right, up, view].iter().enumerate() {
                let x = dot(p, *axis);
                min[k] = min[k].min(x);
                max[k] = max[k].max(x);
            }
        }
        if points.is_empty() {
            (min, max) = ([-1.0; 3], [1.0; 3]);
        }
        let size = [(WIDTH * SAMPLES) as f64, (HEIGHT * SAMPLES) as f64];
        let fit = |k: usize| size[k] * (1.0 - 2.0 * BORDER) / (max[k] - min[k]).max(1e-300);
        let n = WIDTH * HEIGHT * SAMPLES * SAMPLES;
        Self {
            colour: vec![BACKGROUND; n],
            depth: vec![f64::NEG_INFINITY; n],
            right,
            up,
            view,
            centre: [0.5 * (min[0] + max[0]), 0.5 * (min[1] + max[1])],
            zoom: fit(0).min(fit(1)),
            extent: (0..3).map(|k| max[k] - min[k]).fold(0.0, f64::max),
        }
    }

    /// Sample coordinates and depth (greater is nearer) of a point.
    fn project(&self, p: [f64; 3]) -> [f64; 3] {
        let x = (dot(p, self.right) - self.centre[0]) * self.zoom + 0.5 * (WIDTH * SAMPLES) as f64;
        let y = 0.5 * (HEIGHT * SAMPLES) as f64 - (dot(p, self.up) - self.centre[1]) * self.zoom;
        [x, y, dot(p, self.view)]
    }

    fn triangle(&mut self, corners: [[f64; 3]; 3]) {
        let n = cross(sub(corners[1], corners[0]), sub(corners[2], corners[0]));
        let length = dot(n, n).sqrt();
        let facing = if length > 0.0 { dot(n, self.view) / length } else { 0.0 };
        let light = 0.35 + 0.65 * facing.abs();
        let colour = scale(if facing >= 0.0 { FACE } else { BACK }, light);
        let [a, b, c] = corners.map(|p| self.project(p));
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if area == 0.0 {
            return;
        }
        let range = |k: usize, size: usize| {
            let low = a[k].min(b[k]).min(c[k]).max(0.0) as usize;
            let high = (a[k].max(b[k]).max(c[k]).max(0.0) as usize + 1).min(size);
            low.min(high)..high
        };
        for y in range(1, HEIGHT * SAMPLES) {
            for x in range(0, WIDTH * SAMPLES) {
                let (px, py) = (x as f64 + 0.5, y as f64 + 0.5);
                let edge = |p: [f64; 3], q: [f64; 3]| {
                    ((q[0] - p[0]) * (py - p[1]) - (q[1] - p[1]) * (px - p[0])) / area
                };
                let w = [edge(b, c), edge(c, a), edge(a, b)];
                if w.iter().all(|&w| w >= 0.0) {
                    let depth = w[0] * a[2] + w[1] * b[2] + w[2] * c[2];
                    let i = y * WIDTH * SAMPLES + x;
                    if depth > self.depth[i] {
                        self.depth[i] = depth;
                        // A thin dark line along the sides shows the triangles where they are large
                        // enough.
                        let side = w.iter().fold(1.0f64, |m, &w| m.min(w)) * area.abs().sqrt();
                        self.colour[i] = if side < 0.8 && area.abs() > 150.0 {
                            scale(colour, 0.75)
                        } else {
                            colour
                        };
                    }
                }
            }
        }
    }

    fn disc(&mut self, at: [f64; 3], radius: f64, colour: [f64; 3], hidden: f64) {
        let bias = 0.004 * self.extent;
        self.stamp(at, radius, |canvas, i, _, depth| {
            let opacity = if depth + bias >= canvas.depth[i] { 0.9 } else { hidden };
            canvas.colour[i] = lerp(canvas.colour[i], colour, opacity);
        });
    }

    fn ring(&mut self, at: [f64; 3], radius: f64) {
        self.stamp(at, radius, |canvas, i, distance, _| {
            if distance > radius - 5.0 {
                canvas.colour[i] = [0.05, 0.05, 0.10];
            }
        });
    }

    /// Calls `paint` with the index, the distance from the centre and the depth of the centre for
    /// the samples around a point.
    fn stamp(&mut self, at: [f64; 3], radius: f64, paint: impl Fn(&mut Self, usize, f64, f64)) {
        let [cx, cy, depth] = self.project(at);
        let range = |c: f64, size: usize| {
            (c - radius).max(0.0) as usize..((c + radius + 1.0).max(0.0) as usize).min(size)
        };
        for y in range(cy, HEIGHT * SAMPLES) {
            for x in range(cx, WIDTH * SAMPLES) {
                let distance =
                    ((x as f64 + 0.5 - cx).powi(2) + (y as f64 + 0.5 - cy).powi(2)).sqrt();
                if distance <= radius {
                    paint(self, y * WIDTH * SAMPLES + x, distance, depth);
                }
            }
        }
    }

    fn save(&self, path: &Path) -> Result<(), Failure> {
        let image = image::RgbImage::from_fn(WIDTH as u32, HEIGHT as u32, |x, y| {
            let mut sum = [0.0; 3];
            for j in 0..SAMPLES {
                for i in 0..SAMPLES {
                    let c = self.colour
                        [(y as usize * SAMPLES + j) * WIDTH * SAMPLES + x as usize * SAMPLES + i];
                    (0..3).for_each(|k| sum[k] += c[k]);
                }
            }
            image::Rgb(
                sum.map(|c| (c / (SAMPLES * SAMPLES) as f64 * 255.0).clamp(0.0, 255.0) as u8),
            )
        });
        image.save_with_format(path, image::ImageFormat::Png).map_err(|e| in_file(path, e))
    }
}
