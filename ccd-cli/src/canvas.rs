//! A small rasteriser: orthographic, with depth, shaded by the angle to the viewer.

use ccd::geometry::vec3::{cross, dot, lerp, scale, sub};

/// Size of what is drawn in pixels.
pub const WIDTH: usize = 1280;
pub const HEIGHT: usize = 880;
/// Samples per pixel and axis.
const SAMPLES: usize = 2;
const ROW: usize = WIDTH * SAMPLES;
const ROWS: usize = HEIGHT * SAMPLES;
/// Distance of what is shown from the border, as a part of the picture.
const BORDER: f64 = 0.04;
/// Towards the viewer, and up.
const VIEW: [f64; 3] = [0.45, 0.42, 0.79];
const UP: [f64; 3] = [0.0, 1.0, 0.0];

pub type Colour = [f64; 3];

const BACKGROUND: Colour = [0.97, 0.97, 0.98];
const FACE: Colour = [0.62, 0.68, 0.76];
const BACK: Colour = [0.70, 0.66, 0.60];

/// Shape of a mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    Disc,
    /// A square that is empty inside.
    Square,
    Ring,
}

impl Shape {
    /// Whether it covers the point at this offset from its centre, in samples.
    fn covers(self, [x, y]: [f64; 2], radius: f64) -> bool {
        let (round, square) = (x.hypot(y), x.abs().max(y.abs()));
        match self {
            Shape::Disc => round <= radius,
            Shape::Square => square <= 0.9 * radius && square >= 0.9 * radius - stroke(radius),
            Shape::Ring => round <= radius && round >= radius - 5.0,
        }
    }
}

/// The width of the line of an empty mark.
fn stroke(radius: f64) -> f64 {
    (0.35 * radius).max(1.5)
}

/// Direction of view and visible part of the scene.
#[derive(Clone, Copy, Debug)]
pub struct View {
    axes: [[f64; 3]; 3],
    centre: [f64; 2],
    /// Samples a unit of length.
    zoom: f64,
    /// Longest side of the shown points.
    extent: f64,
}

impl View {
    /// A view of all these points, at least `least` long; one unit if that has no length.
    pub fn of(points: impl Iterator<Item = [f64; 3]>, least: f64) -> Self {
        let view = unit(VIEW);
        let right = unit(cross(UP, view));
        let axes = [right, cross(view, right), view];
        let (mut min, mut max) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for p in points {
            for k in 0..3 {
                let x = dot(p, axes[k]);
                min[k] = min[k].min(x);
                max[k] = max[k].max(x);
            }
        }
        if !(min[0] <= max[0]) {
            (min, max) = ([-1.0; 3], [1.0; 3]);
        }
        let length = |k: usize| (max[k] - min[k]).max(least);
        let extent = (0..3).map(length).fold(0.0, f64::max);
        let shortest = if extent > 0.0 { 1e-300 } else { 1.0 };
        let sides = [0, 1].map(|k| length(k).max(shortest));
        let fit = |k: usize, n: usize| n as f64 * (1.0 - 2.0 * BORDER) / sides[k];
        Self {
            axes,
            centre: [0.5 * (min[0] + max[0]), 0.5 * (min[1] + max[1])],
            zoom: fit(0, ROW).min(fit(1, ROWS)),
            extent,
        }
    }

    /// Pixels a unit of length.
    pub fn scale(&self) -> f64 {
        self.zoom / SAMPLES as f64
    }

    /// The longest side of the shown points.
    pub fn extent(&self) -> f64 {
        self.extent
    }

    /// Extent of another view in samples of this one.
    pub fn samples_of(&self, other: &Self) -> f64 {
        other.extent * self.zoom
    }

    /// Sample coordinates and depth (greater is nearer) of a point.
    fn project(&self, p: [f64; 3]) -> [f64; 3] {
        let [right, up, view] = self.axes;
        let x = (dot(p, right) - self.centre[0]) * self.zoom + 0.5 * ROW as f64;
        let y = 0.5 * ROWS as f64 - (dot(p, up) - self.centre[1]) * self.zoom;
        [x, y, dot(p, view)]
    }
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    scale(a, 1.0 / dot(a, a).sqrt())
}

pub struct Canvas {
    view: View,
    colour: Vec<Colour>,
    depth: Vec<f64>,
}

/// The samples from `low` to `high` of `size`.
fn range(low: f64, high: f64, size: usize) -> std::ops::Range<usize> {
    let (low, high) = (low.max(0.0) as usize, (high.max(-1.0) + 1.0) as usize);
    low.min(size)..high.min(size)
}

impl Canvas {
    pub fn new(view: View) -> Self {
        let n = ROW * ROWS;
        Self { view, colour: vec![BACKGROUND; n], depth: vec![f64::NEG_INFINITY; n] }
    }

    /// A face, with thin dark lines along its sides where it is large enough.
    pub fn triangle(&mut self, corners: [[f64; 3]; 3]) {
        // In samples: squares of squares of lengths neither overflow nor vanish.
        let side = |k: usize| scale(sub(corners[k], corners[0]), self.view.zoom);
        let n = cross(side(1), side(2));
        let length = dot(n, n).sqrt();
        let facing = if length > 0.0 { dot(n, self.view.axes[2]) / length } else { 0.0 };
        let light = 0.35 + 0.65 * facing.abs();
        let colour = scale(if facing >= 0.0 { FACE } else { BACK }, light);
        let [a, b, c] = corners.map(|p| self.view.project(p));
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if area == 0.0 {
            return;
        }
        // Edges of triangles that are hardly larger than lines would darken all of a surface.
        let edges = 1.0 - 0.25 * ((area.abs() - 80.0) / 240.0).clamp(0.0, 1.0);
        let over = |k: usize, size| range(a[k].min(b[k]).min(c[k]), a[k].max(b[k]).max(c[k]), size);
        for y in over(1, ROWS) {
            for x in over(0, ROW) {
                let (px, py) = (x as f64 + 0.5, y as f64 + 0.5);
                let edge = |p: [f64; 3], q: [f64; 3]| {
                    ((q[0] - p[0]) * (py - p[1]) - (q[1] - p[1]) * (px - p[0])) / area
                };
                let w = [edge(b, c), edge(c, a), edge(a, b)];
                if w.iter().all(|&w| w >= 0.0) {
                    let depth = w[0] * a[2] + w[1] * b[2] + w[2] * c[2];
                    let i = y * ROW + x;
                    if depth > self.depth[i] {
                        self.depth[i] = depth;
                        let side = w.iter().fold(1.0f64, |m, &w| m.min(w)) * area.abs().sqrt();
                        self.colour[i] = if side < 0.8 { scale(colour, edges) } else { colour };
                    }
                }
            }
        }
    }

    /// A line of a width in samples, hidden by what is before it; or, with `over`, part of which
    /// shows through.
    pub fn line(&mut self, p: [f64; 3], q: [f64; 3], width: f64, colour: Colour, over: bool) {
        let (a, b) = (self.view.project(p), self.view.project(q));
        // The part of it that is in the picture.
        let (mut from, mut to) = (0.0f64, 1.0f64);
        for (k, size) in [(0, ROW), (1, ROWS)] {
            let step = b[k] - a[k];
            if step.abs() < 1e-9 {
                continue;
            }
            let (s, t) = ((-width - a[k]) / step, (size as f64 + width - a[k]) / step);
            (from, to) = (from.max(s.min(t)), to.min(s.max(t)));
        }
        if !(from <= to) {
            return;
        }
        let (a, b) = (lerp(a, b, from), lerp(a, b, to));
        let n = (b[0] - a[0]).abs().max((b[1] - a[1]).abs()).max(1.0).ceil();
        let (radius, bias) = (0.5 * width, 1e-3 * self.view.extent);
        for i in 0..=n as usize {
            let [cx, cy, depth] = lerp(a, b, i as f64 / n);
            for y in range(cy - radius, cy + radius, ROWS) {
                for x in range(cx - radius, cx + radius, ROW) {
                    let at = y * ROW + x;
                    let off = (x as f64 + 0.5 - cx).hypot(y as f64 + 0.5 - cy);
                    let seen = depth + bias >= self.depth[at];
                    if off <= radius.max(0.71) && (seen || over && (x + y) % 4 == 0) {
                        self.depth[at] = self.depth[at].max(depth);
                        self.colour[at] = colour;
                    }
                }
            }
        }
    }

    /// A mark of a radius in samples. `hidden`: its opacity if something is before its centre;
    /// surfaces do not cut it.
    pub fn mark(&mut self, at: [f64; 3], shape: Shape, radius: f64, colour: Colour, hidden: f64) {
        let [cx, cy, depth] = self.view.project(at);
        let at = |c: f64, size: usize| (c >= 0.0 && c < size as f64).then_some(c as usize);
        let before = at(cx, ROW).zip(at(cy, ROWS)).map(|(x, y)| self.depth[y * ROW + x]);
        let is_seen = before.is_none_or(|before| depth + 0.004 * self.view.extent >= before);
        let opacity = if is_seen { 0.92 } else { hidden };
        for y in range(cy - radius, cy + radius, ROWS) {
            for x in range(cx - radius, cx + radius, ROW) {
                let i = y * ROW + x;
                if shape.covers([x as f64 + 0.5 - cx, y as f64 + 0.5 - cy], radius) {
                    self.colour[i] = lerp(self.colour[i], colour, opacity);
                }
            }
        }
    }

    /// The picture: three bytes a pixel, row by row.
    pub fn pixels(&self) -> Vec<u8> {
        let mut out = Vec::with_capacity(WIDTH * HEIGHT * 3);
        for y in 0..HEIGHT {
            for x in 0..WIDTH {
                let first = y * SAMPLES * ROW + x * SAMPLES;
                for k in 0..3 {
                    let row = |j: usize| -> f64 {
                        (0..SAMPLES).map(|i| self.colour[first + j * ROW + i][k]).sum()
                    };
                    let sum: f64 = (0..SAMPLES).map(row).sum();
                    out.push((sum / (SAMPLES * SAMPLES) as f64 * 255.0).clamp(0.0, 255.0) as u8);
                }
            }
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_far_beyond_the_picture_end() {
        let view = View::of([[0.0; 3], [1.0; 3]].into_iter(), 0.0);
        let mut canvas = Canvas::new(view);
        let before = canvas.pixels();
        canvas.line([-1e9, 50.0, 0.0], [1e9, 50.0, 0.0], 3.0, [0.0; 3], false);
        assert_eq!(canvas.pixels(), before);
        let middle = lerp([0.0; 3], [1.0; 3], 0.5);
        canvas.line([-1e9, 0.5, 0.5], [1e9, 0.5, 0.5], 3.0, [0.0; 3], false);
        canvas.mark(middle, Shape::Disc, 20.0, [1.0, 0.0, 0.0], 0.1);
        let pixels = canvas.pixels();
        let at = (HEIGHT / 2 * WIDTH + WIDTH / 2) * 3;
        assert!(pixels != before && pixels[at] > 200 && pixels[at + 1] < 60);
    }
    #[test]
    fn pictures_are_the_same_at_every_scale() {
        let picture = |unit: f64| {
            let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.2, 1.0]];
            let corners = corners.map(|p| scale(p, unit));
            let mut canvas = Canvas::new(View::of(corners.into_iter(), 0.0));
            canvas.triangle(corners);
            canvas.pixels()
        };
        // Powers of two, so that nothing is rounded otherwise.
        let want = picture(1.0);
        assert!(want.iter().any(|&c| c < 180), "the triangle is there");
        for power in [-900, 320] {
            assert!(picture(2f64.powi(power)) == want, "2^{power}");
        }
    }

    #[test]
    fn a_point_is_seen_from_some_distance() {
        let view = View::of([[3.0; 3]].into_iter(), 0.0);
        assert!(view.scale() > 100.0 && view.scale() < 2000.0, "{}", view.scale());
        assert_eq!(view.samples_of(&view), 0.0);
    }
}
