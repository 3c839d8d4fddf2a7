//! How a picture looks at a scene: from which side, at how much of it, in how many pixels.

use super::OUTPUT;
use super::camera::{Camera, DIRECTION, View};
use super::canvas::Canvas;
use ccd::Mesh;
use clap::{Args, ValueEnum};

/// Visible part of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Zoom {
    /// The contacts, if they fill less than a tenth of a picture of all
    #[default]
    Auto,
    /// All of the mesh
    All,
    /// Where the contacts are
    Contacts,
}

/// Options of a picture of contacts.
#[derive(Args, Clone, Copy)]
pub struct Look {
    /// What the picture shows
    #[arg(long, value_enum, default_value_t = Zoom::Auto, requires = "picture")]
    #[arg(hide_short_help = true, help_heading = OUTPUT)]
    pub zoom: Zoom,
    /// Draw the picture as seen from this direction
    ///
    /// 0,0,1 looks from the front, 1,0,0 from the right, 0,1,0 from above. Without it a direction
    /// is chosen from which most contacts are to be seen.
    #[arg(long, value_name = "X,Y,Z", value_parser = direction, allow_hyphen_values = true)]
    #[arg(requires = "picture", hide_short_help = true, help_heading = OUTPUT)]
    pub view: Option<[f64; 3]>,
    /// Width and height of the picture in pixels, 640 to 4096
    #[arg(long, value_name = "WxH", value_parser = size, default_value = "1280x1020")]
    #[arg(requires = "picture", hide_short_help = true, help_heading = OUTPUT)]
    pub size: [usize; 2],
}

impl Default for Look {
    fn default() -> Self {
        Self { zoom: Zoom::default(), view: None, size: [1280, 1020] }
    }
}

/// Three numbers, not all of them zero.
fn direction(text: &str) -> Result<[f64; 3], String> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|x| x.trim().parse().ok()).collect();
    let direction = numbers.and_then(|numbers| <[f64; 3]>::try_from(numbers).ok());
    let is_one = |d: &[f64; 3]| d.iter().all(|x| x.is_finite()) && *d != [0.0; 3];
    direction
        .filter(is_one)
        .ok_or("three numbers with commas, not all of them 0, such as 0,0,1".into())
}

/// Two numbers of pixels.
fn size(text: &str) -> Result<[usize; 2], String> {
    let side = |text: &str| text.parse().ok().filter(|n| (640..=4096).contains(n));
    let sides = text.split_once('x').and_then(|(w, h)| Some([side(w)?, side(h)?]));
    sides.ok_or("two numbers from 640 to 4096 with an x, such as 1920x1080".into())
}

/// What is looked at.
pub struct Subject<'a> {
    pub mesh: &'a Mesh,
    pub x: &'a [[f64; 3]],
    /// Places of contacts, the earliest first.
    pub points: &'a [[f64; 3]],
    /// Length of their features.
    pub features: f64,
}

/// Contacts that are looked for when a direction is chosen: of many a part is as good.
const MOST: usize = 2000;
/// Elevations of the directions that are tried, in degrees, eight directions for each.
const ELEVATIONS: [f64; 3] = [25.0, 65.0, -25.0];

impl Look {
    /// The view, in an area of so many pixels in which lines are by a factor larger.
    pub fn view(&self, subject: &Subject, area: [usize; 2], unit: f64) -> View {
        let direction = self.view.unwrap_or_else(|| self.turned(subject, area));
        self.zoomed(subject, &Camera::new(direction, area, unit))
    }

    /// What a camera shows.
    fn zoomed(&self, subject: &Subject, camera: &Camera) -> View {
        let Subject { x, points, features, .. } = *subject;
        let all = x.iter().chain(points).copied();
        let whole = camera.view(all, 0.0);
        if self.zoom == Zoom::All || points.is_empty() {
            return whole;
        }
        // Large features in contact do not make it show less closely than all.
        let least = if features > 0.0 { 2.0 * features } else { 0.1 * whole.extent() };
        let near = camera.view(points.iter().copied(), least);
        // Little is gained by less than half as large again, and borders are cut off.
        let least = if self.zoom == Zoom::Contacts { 1.0 } else { 1.5 };
        let is_small = self.zoom == Zoom::Contacts || whole.part_of(&near) < 0.1;
        if is_small && near.scale() > least * whole.scale() { near } else { whole }
    }

    /// The direction from which most contacts are to be seen: the usual one, unless from another
    /// one there are clearly more, or the earliest, which counts as a quarter of all.
    fn turned(&self, subject: &Subject, area: [usize; 2]) -> [f64; 3] {
        let Some(&first) = subject.points.first() else { return DIRECTION };
        let small = area.map(|n| n.div_ceil(8));
        let step = subject.points.len().div_ceil(MOST);
        let seen = |direction: [f64; 3]| {
            let mut canvas = Canvas::new(self.zoomed(subject, &Camera::new(direction, small, 1.0)));
            for &face in subject.mesh.faces() {
                canvas.triangle(face.map(|v| subject.x[v as usize]));
            }
            let some = subject.points.iter().step_by(step);
            let n_seen = some.clone().filter(|&&p| canvas.sees(p)).count();
            n_seen as f64 / some.len() as f64 + if canvas.sees(first) { 0.25 } else { 0.0 }
        };
        let around = (0..8).map(|i| 30.0 + 45.0 * i as f64);
        let others = around.flat_map(|a| ELEVATIONS.map(|e| (f64::to_radians(a), e.to_radians())));
        let others = others.map(|(a, e): (f64, f64)| {
            // From below is unusual.
            let worth = if e < 0.0 { 0.6 } else { 0.8 };
            ([e.cos() * a.sin(), e.sin(), e.cos() * a.cos()], worth)
        });
        // All at once: 92,000 faces take 0.03 s each.
        let values: Vec<([f64; 3], f64)> = std::thread::scope(|scope| {
            let all = std::iter::once((DIRECTION, 1.0)).chain(others);
            let seen = &seen;
            let value = |(direction, worth): ([f64; 3], f64)| {
                scope.spawn(move || (direction, seen(direction) * worth))
            };
            let threads: Vec<_> = all.map(value).collect();
            threads.into_iter().filter_map(|thread| thread.join().ok()).collect()
        });
        let mut best = (DIRECTION, f64::NEG_INFINITY);
        for (direction, value) in values {
            if value > best.1 {
                best = (direction, value);
            }
        }
        best.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points on the outside of one face of a cube: the camera goes where it sees them.
    #[test]
    fn the_camera_turns_to_the_contacts() {
        let x: Vec<[f64; 3]> =
            (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2 & 1].map(f64::from)).collect();
        let faces = [[0, 1, 3], [0, 3, 2], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4]];
        let more = [[2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 3, 7], [1, 7, 5]];
        let mesh = Mesh::new(8, &[faces, more].concat()).unwrap();
        for (axis, side) in [(0, 0.0), (0, 1.0), (1, 1.0), (1, 0.0), (2, 0.0), (2, 1.0)] {
            let mut points = [[0.5; 3], [0.4; 3], [0.6; 3]];
            points.iter_mut().for_each(|p| p[axis] = side);
            let subject = Subject { mesh: &mesh, x: &x, points: &points, features: 1.0 };
            let chosen = Look::default().turned(&subject, [640, 440]);
            let towards = (chosen[axis] > 0.0) == (side > 0.0);
            assert!(towards, "{chosen:?} does not see axis {axis}, side {side}");
            // The usual direction sees the greater side of each axis.
            assert_eq!(chosen == DIRECTION, side > 0.0, "{axis} {side}");
        }
    }

    #[test]
    fn few_contacts_in_one_spot_are_shown_closely() {
        let x: Vec<[f64; 3]> = (0..100).map(|i| [i % 10, i / 10, 0].map(f64::from)).collect();
        let mesh = Mesh::new(x.len(), &[]).unwrap();
        let camera = Camera::new([0.0, 0.0, 1.0], [900, 900], 1.0);
        // Of a picture of nine by nine units, the part of a square is its area.
        for (side, is_near) in [(0.1, true), (2.6, true), (3.2, false), (9.0, false)] {
            let points = [[0.0; 3], [side, side, 0.0]];
            let subject = Subject { mesh: &mesh, x: &x, points: &points, features: 0.1 };
            let scale = |zoom| Look { zoom, ..Look::default() }.zoomed(&subject, &camera).scale();
            let [auto, all, near] = [Zoom::Auto, Zoom::All, Zoom::Contacts].map(scale);
            assert_eq!(auto, if is_near { near } else { all }, "{side}");
            assert!(near > all || side == 9.0);
        }
    }

    #[test]
    fn directions_and_sizes_are_numbers() {
        assert_eq!(direction("-1, 0,2.5"), Ok([-1.0, 0.0, 2.5]));
        for bad in ["", "1,2", "1,2,3,4", "0,0,0", "nan,0,1", "1,inf,0", "front"] {
            assert!(direction(bad).is_err(), "{bad}");
        }
        assert_eq!(size("640x4096"), Ok([640, 4096]));
        for bad in ["", "1280", "639x800", "800x4097", "axb", "800X800", "-800x800"] {
            assert!(size(bad).is_err(), "{bad}");
        }
    }
}
