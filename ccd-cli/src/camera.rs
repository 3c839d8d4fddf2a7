//! The camera of a picture: direction of view, size in pixels, and the part of the scene that is
//! shown. Orthographic.

use ccd::geometry::vec3::{cross, dot, scale};

/// Samples per pixel and axis.
pub const SAMPLES: usize = 2;
/// Distance of what is shown from the border, as a part of the picture.
const BORDER: f64 = 0.04;
/// Towards the viewer, unless another direction is chosen.
pub const DIRECTION: [f64; 3] = [0.45, 0.42, 0.79];

/// Direction of view, and size of the picture.
#[derive(Clone, Copy, Debug)]
pub struct Camera {
    /// To the right, up, towards the viewer.
    axes: [[f64; 3]; 3],
    /// Width and height in pixels.
    size: [usize; 2],
    /// Factor by which lines and marks are larger than their sizes in the code.
    unit: f64,
}

impl Camera {
    /// A camera that looks from a direction, which is not zero, at the origin; `y` is up, and from
    /// above or below `z` is down or up.
    pub fn new(direction: [f64; 3], size: [usize; 2], unit: f64) -> Self {
        // Squares of its numbers must neither overflow nor vanish.
        let most = direction.iter().fold(0.0f64, |most, x| most.max(x.abs()));
        let view = length_one(direction.map(|x| x / most));
        let up = if view[1].abs() < 0.999 { [0.0, 1.0, 0.0] } else { [0.0, 0.0, -view[1]] };
        let right = length_one(cross(up, view));
        Self { axes: [right, cross(view, right), view], size, unit }
    }

    /// A view of all these points, at least `least` long; one unit if that has no length.
    pub fn view(&self, points: impl Iterator<Item = [f64; 3]>, least: f64) -> View {
        let axes = self.axes;
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
        let [columns, rows] = self.size.map(|n| n * SAMPLES);
        let fit = |k: usize, n: usize| n as f64 * (1.0 - 2.0 * BORDER) / sides[k];
        View {
            camera: *self,
            centre: [0.5 * (min[0] + max[0]), 0.5 * (min[1] + max[1])],
            zoom: fit(0, columns).min(fit(1, rows)),
            extent,
            spread: [max[0] - min[0], max[1] - min[1]],
        }
    }
}

/// The visible part of a scene.
#[derive(Clone, Copy, Debug)]
pub struct View {
    camera: Camera,
    centre: [f64; 2],
    /// Samples a unit of length.
    zoom: f64,
    extent: f64,
    /// Sides of the rectangle around the shown points.
    spread: [f64; 2],
}

impl View {
    /// Pixels a unit of length.
    pub fn scale(&self) -> f64 {
        self.zoom / SAMPLES as f64
    }

    /// Samples a unit of length.
    pub fn zoom(&self) -> f64 {
        self.zoom
    }

    /// Width and height in pixels.
    pub fn size(&self) -> [usize; 2] {
        self.camera.size
    }

    /// Factor by which lines and marks are larger than their sizes in the code.
    pub fn unit(&self) -> f64 {
        self.camera.unit
    }

    /// Towards the viewer.
    pub fn direction(&self) -> [f64; 3] {
        self.camera.axes[2]
    }

    /// The longest side of the shown points.
    pub fn extent(&self) -> f64 {
        self.extent
    }

    /// A view by the same camera of these points alone.
    pub fn of_points(&self, points: &[[f64; 3]]) -> Self {
        self.camera.view(points.iter().copied(), 0.0)
    }

    /// Extent of another view in samples of this one.
    pub fn samples_of(&self, other: &Self) -> f64 {
        other.extent * self.zoom
    }

    /// The part of this picture that the rectangle around the points of another view takes.
    pub fn part_of(&self, other: &Self) -> f64 {
        let part = |k: usize| other.spread[k] * self.scale() / self.camera.size[k] as f64;
        part(0) * part(1)
    }

    /// Sample coordinates and depth (greater is nearer) of a point.
    pub fn project(&self, p: [f64; 3]) -> [f64; 3] {
        let [right, up, view] = self.camera.axes;
        let [columns, rows] = self.camera.size.map(|n| (n * SAMPLES) as f64);
        let x = (dot(p, right) - self.centre[0]) * self.zoom + 0.5 * columns;
        let y = 0.5 * rows - (dot(p, up) - self.centre[1]) * self.zoom;
        [x, y, dot(p, view)]
    }
}

fn length_one(a: [f64; 3]) -> [f64; 3] {
    scale(a, 1.0 / dot(a, a).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_is_seen_from_some_distance() {
        let view = Camera::new(DIRECTION, [1280, 880], 1.0).view([[3.0; 3]].into_iter(), 0.0);
        assert!(view.scale() > 100.0 && view.scale() < 2000.0, "{}", view.scale());
        assert_eq!(view.samples_of(&view), 0.0);
    }

    /// From each side of a cube its axes are where a hand holds them: right, up, near.
    #[test]
    fn a_camera_looks_from_every_side() {
        let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
        let minus = |a: [f64; 3]| a.map(|x| 0.0 - x);
        for (direction, want) in [
            (z, [x, y, z]),
            (minus(z), [minus(x), y, minus(z)]),
            (x, [minus(z), y, x]),
            (minus(x), [z, y, minus(x)]),
            (y, [x, minus(z), y]),
            (minus(y), [x, z, minus(y)]),
        ] {
            for length in [1.0, 1e-200, 1e200] {
                let camera = Camera::new(scale(direction, length), [100, 50], 1.0);
                assert_eq!(camera.axes, want, "{direction:?} {length:e}");
            }
        }
        let view = Camera::new(x, [100, 50], 1.0).view([[0.0; 3], [2.0; 3]].into_iter(), 0.0);
        let [centre, nearer] = [[1.0; 3], [2.0, 1.0, 1.0]].map(|p| view.project(p));
        assert_eq!([centre[0], centre[1]], [100.0, 50.0]);
        assert!(nearer[2] > centre[2] && view.project([1.0, 1.0, 0.0])[0] > centre[0]);
        assert!(view.project([1.0, 2.0, 1.0])[1] < centre[1]);
    }
}
