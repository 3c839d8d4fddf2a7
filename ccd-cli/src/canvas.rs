//! A small rasteriser: orthographic, with depth, shaded by the angle to the viewer.

use super::camera::{SAMPLES, View};
use ccd::geometry::vec3::{cross, dot, lerp, scale, sub};

pub type Colour = [f64; 3];

const BACKGROUND: Colour = [0.97, 0.97, 0.98];
/// Colours of faces from their front, where corners go round counterclockwise, and from their back.
pub const FACE: Colour = [0.62, 0.68, 0.76];
pub const BACK: Colour = [0.70, 0.66, 0.60];

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
            Shape::Square => {
                let line = (0.35 * radius).max(1.5);
                square <= 0.9 * radius && square >= 0.9 * radius - line
            }
            Shape::Ring => round <= radius && round >= radius * (5.0 / 6.0),
        }
    }
}

/// Samples of a picture: what is nearest at each of them.
pub struct Canvas {
    view: View,
    /// Numbers of samples in a row and in a column.
    size: [usize; 2],
    colour: Vec<Colour>,
    depth: Vec<f64>,
    /// Whether the nearest face shows its back.
    is_back: Vec<bool>,
}

/// The samples from `low` to `high` of `size`.
fn range(low: f64, high: f64, size: usize) -> std::ops::Range<usize> {
    let (low, high) = (low.max(0.0) as usize, (high.max(-1.0) + 1.0) as usize);
    low.min(size)..high.min(size)
}

impl Canvas {
    pub fn new(view: View) -> Self {
        let size = view.size().map(|n| n * SAMPLES);
        let n = size[0] * size[1];
        let (colour, depth) = (vec![BACKGROUND; n], vec![f64::NEG_INFINITY; n]);
        Self { view, size, colour, depth, is_back: vec![false; n] }
    }

    /// A face, with thin dark lines along its sides where it is large enough.
    pub fn triangle(&mut self, corners: [[f64; 3]; 3]) {
        let [row, rows] = self.size;
        // In samples: squares of squares of lengths neither overflow nor vanish.
        let side = |k: usize| scale(sub(corners[k], corners[0]), self.view.zoom());
        let n = cross(side(1), side(2));
        let length = dot(n, n).sqrt();
        let facing = if length > 0.0 { dot(n, self.view.direction()) / length } else { 0.0 };
        let light = 0.35 + 0.65 * facing.abs();
        let colour = scale(if facing >= 0.0 { FACE } else { BACK }, light);
        let [a, b, c] = corners.map(|p| self.view.project(p));
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if area == 0.0 {
            return;
        }
        // In lines' widths.
        let unit = self.view.unit();
        let size = area.abs() / (unit * unit);
        // Edges of triangles that are hardly larger than lines would darken all of a surface.
        let edges = 1.0 - 0.25 * ((size - 80.0) / 240.0).clamp(0.0, 1.0);
        let over = |k: usize, size| range(a[k].min(b[k]).min(c[k]), a[k].max(b[k]).max(c[k]), size);
        for y in over(1, rows) {
            for x in over(0, row) {
                let (px, py) = (x as f64 + 0.5, y as f64 + 0.5);
                let edge = |p: [f64; 3], q: [f64; 3]| {
                    ((q[0] - p[0]) * (py - p[1]) - (q[1] - p[1]) * (px - p[0])) / area
                };
                let w = [edge(b, c), edge(c, a), edge(a, b)];
                if w.iter().all(|&w| w >= 0.0) {
                    let depth = w[0] * a[2] + w[1] * b[2] + w[2] * c[2];
                    let i = y * row + x;
                    if depth > self.depth[i] {
                        self.is_back[i] = facing < 0.0;
                        self.depth[i] = depth;
                        let side = w.iter().fold(1.0f64, |m, &w| m.min(w)) * size.sqrt();
                        self.colour[i] = if side < 0.8 { scale(colour, edges) } else { colour };
                    }
                }
            }
        }
    }

    /// Whether backs of faces are to be seen, and not only between two faces that nearly meet.
    pub fn shows_backs(&self) -> bool {
        let n = self.is_back.iter().filter(|&&is_back| is_back).count();
        n > self.is_back.len() / 2000
    }

    /// A line of a width in samples, hidden by what is before it; or, with `over`, part of which
    /// shows through.
    pub fn line(&mut self, p: [f64; 3], q: [f64; 3], width: f64, colour: Colour, over: bool) {
        let [row, rows] = self.size;
        let (a, b) = (self.view.project(p), self.view.project(q));
        // The part of it that is in the picture.
        let (mut from, mut to) = (0.0f64, 1.0f64);
        for (k, size) in [(0, row), (1, rows)] {
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
        let (radius, bias) = (0.5 * width, 1e-3 * self.view.extent());
        for i in 0..=n as usize {
            let [cx, cy, depth] = lerp(a, b, i as f64 / n);
            for y in range(cy - radius, cy + radius, rows) {
                for x in range(cx - radius, cx + radius, row) {
                    let at = y * row + x;
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

    /// Whether nothing is before a point, as far as samples tell.
    pub fn sees(&self, p: [f64; 3]) -> bool {
        let [x, y, depth] = self.view.project(p);
        let at = |c: f64, size: usize| (c >= 0.0 && c < size as f64).then_some(c as usize);
        let [row, rows] = self.size;
        let before = at(x, row).zip(at(y, rows)).map(|(x, y)| self.depth[y * row + x]);
        // A surface that rises by three times the width of a sample does not hide what is on it.
        let bias = (0.004 * self.view.extent()).max(3.0 / self.view.zoom());
        before.is_none_or(|before| depth + bias >= before)
    }

    /// A mark of a radius in samples and of an opacity, which surfaces do not cut.
    pub fn mark(&mut self, p: [f64; 3], shape: Shape, radius: f64, colour: Colour, opacity: f64) {
        let [row, rows] = self.size;
        let [cx, cy, _] = self.view.project(p);
        for y in range(cy - radius, cy + radius, rows) {
            for x in range(cx - radius, cx + radius, row) {
                if shape.covers([x as f64 + 0.5 - cx, y as f64 + 0.5 - cy], radius) {
                    let i = y * row + x;
                    self.colour[i] = lerp(self.colour[i], colour, opacity);
                }
            }
        }
    }

    /// The picture: three bytes a pixel, row by row.
    pub fn pixels(&self) -> Vec<u8> {
        let [width, height] = self.view.size();
        let mut out = Vec::with_capacity(width * height * 3);
        for y in 0..height {
            for x in 0..width {
                let first = y * SAMPLES * self.size[0] + x * SAMPLES;
                for k in 0..3 {
                    let row = |j: usize| -> f64 {
                        (0..SAMPLES).map(|i| self.colour[first + j * self.size[0] + i][k]).sum()
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
    use super::super::camera::{Camera, DIRECTION};
    use super::*;

    const SIZE: [usize; 2] = [1280, 880];

    fn view_of(points: &[[f64; 3]]) -> View {
        Camera::new(DIRECTION, SIZE, 1.0).view(points.iter().copied(), 0.0)
    }

    #[test]
    fn lines_far_beyond_the_picture_end() {
        let mut canvas = Canvas::new(view_of(&[[0.0; 3], [1.0; 3]]));
        let before = canvas.pixels();
        canvas.line([-1e9, 50.0, 0.0], [1e9, 50.0, 0.0], 3.0, [0.0; 3], false);
        assert_eq!(canvas.pixels(), before);
        let middle = lerp([0.0; 3], [1.0; 3], 0.5);
        canvas.line([-1e9, 0.5, 0.5], [1e9, 0.5, 0.5], 3.0, [0.0; 3], false);
        canvas.mark(middle, Shape::Disc, 20.0, [1.0, 0.0, 0.0], 0.92);
        let pixels = canvas.pixels();
        let at = (SIZE[1] / 2 * SIZE[0] + SIZE[0] / 2) * 3;
        assert!(pixels != before && pixels[at] > 200 && pixels[at + 1] < 60);
    }

    #[test]
    fn pictures_are_the_same_at_every_scale() {
        let picture = |unit: f64| {
            let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.2, 1.0]];
            let corners = corners.map(|p| scale(p, unit));
            let mut canvas = Canvas::new(view_of(&corners));
            canvas.triangle(corners);
            assert!(!canvas.shows_backs(), "its front is seen");
            canvas.triangle([corners[1], corners[0], corners[2]].map(|p| scale(p, 0.5)));
            assert!(!canvas.shows_backs(), "what is behind it is not");
            let mut turned = Canvas::new(view_of(&corners));
            turned.triangle([corners[1], corners[0], corners[2]]);
            assert!(turned.shows_backs());
            canvas.pixels()
        };
        // Powers of two, so that nothing is rounded otherwise.
        let want = picture(1.0);
        assert!(want.iter().any(|&c| c < 180), "the triangle is there");
        for power in [-900, 320] {
            assert!(picture(2f64.powi(power)) == want, "2^{power}");
        }
    }
}
