//! A picture of a mesh with its contacts: where and when each of them is, with a scale and a
//! legend.

use super::canvas::{Canvas, Colour, Shape};
use super::legend::{Frame, Legend, colour_of};
use super::look::{Look, Subject};
use super::output::{plural, thousands};
use super::pixels::{Failed, Picture};
use super::{Failure, start, toi};
use ccd::geometry::vec3::{dot, lerp, sub};
use ccd::{Contact, ContactGeometry, Mesh, State, TOI_TOLERANCE};
use std::collections::HashSet;

/// Contents of a picture.
pub struct Scene<'a> {
    /// First line: the scene, the minimum distance, and the backend that ran it.
    pub title: &'a str,
    pub mesh: &'a Mesh,
    /// Positions at the start and at the end of the step.
    pub x: [&'a [[f64; 3]]; 2],
    /// Those that are drawn: all, or the earliest.
    pub contacts: &'a [Contact],
    /// The number of all contacts.
    pub total: usize,
    /// The part of the step that they were looked for in.
    pub window: [f64; 2],
    pub look: Look,
}

const ROD: Colour = [0.20, 0.24, 0.32];
const RING: Colour = [0.03, 0.03, 0.06];
/// Radius of the ring around the earliest contact, and the least one of its mark, in samples.
const RING_RADIUS: f64 = 30.0;
const FIRST_RADIUS: f64 = 7.0;
/// Opacity of marks that nothing is before.
const SEEN: f64 = 0.92;
/// Up to this number of contacts their features are outlined.
const FEW: usize = 24;

/// Writes the picture: the mesh as it is at the earliest time of impact, and a mark for each
/// contact at its place and in the colour of its time.
pub fn write(to: Picture, scene: &Scene) -> Result<(), Failure> {
    to.save(scene.look.size.map(|n| n as u32).into(), draw(scene))
}

fn draw(scene: &Scene) -> Result<Vec<u8>, Failed> {
    let (mesh, [x0, x1]) = (scene.mesh, scene.x);
    let mut marks: Vec<(&Contact, ContactGeometry)> =
        scene.contacts.iter().map(|c| (c, c.geometry(mesh, x0, x1))).collect();
    marks.sort_by(|a, b| a.0.toi.total_cmp(&b.0.toi));
    let times = marks.first().zip(marks.last()).map(|(first, last)| {
        let [first, last] = [first.0.toi, last.0.toi];
        // Times are known to their tolerance: what differs by less has one colour.
        if last - first > TOI_TOLERANCE { [first, last] } else { [first, first] }
    });
    let shown = times.map_or(0.0, |[first, _]| first);
    let x: Vec<[f64; 3]> = x0.iter().zip(x1).map(|(&p, &q)| lerp(p, q, shown)).collect();
    let points: Vec<[f64; 3]> = marks.iter().map(|(_, at)| at.point).collect();
    let frame = Frame::of(scene.look.size);
    let features = size_of_features(scene);
    let subject = Subject { mesh, x: &x, points: &points, features };
    let view = scene.look.view(&subject, frame.area(), frame.unit);

    let mut canvas = Canvas::new(view);
    for &face in mesh.faces() {
        canvas.triangle(face.map(|v| x[v as usize]));
    }
    let backs = canvas.shows_backs();
    let (rods, particles) = loose(mesh);
    for [a, b] in rods {
        canvas.line(x[a as usize], x[b as usize], 4.0 * frame.unit, ROD, false);
    }
    for v in particles {
        let p = x[v as usize];
        if canvas.sees(p) {
            canvas.mark(p, Shape::Disc, 5.0 * frame.unit, ROD, SEEN);
        }
    }
    let spread = view.samples_of(&view.of_points(&points));
    draw_marks(&mut canvas, scene, &marks, times.unwrap_or([0.0; 2]), [spread, frame.unit]);

    let n_undecided = marks.iter().filter(|(c, _)| c.state == State::Undecided).count();
    let n_shown = counted(marks.len(), scene.total, scene.window);
    let mut text = n_shown.clone();
    if n_undecided > 0 {
        text += &format!(", {} of them undecided", thousands(n_undecided));
    }
    text += &match times {
        Some(_) => format!("; the mesh as it is at the earliest, t = {}", toi::plain(shown)),
        None => "; the mesh at the start of the step".into(),
    };
    let enlarged = view.scale() / view.of_points(&x).scale();
    if enlarged > 1.05 {
        text += &format!("; enlarged {enlarged:.1} times (all: --zoom all)");
    }
    let legend = Legend {
        frame,
        lines: [scene.title, &text],
        pixels_per_unit: view.scale(),
        times,
        nothing: &n_shown,
        undecided: n_undecided > 0,
        backs,
    };
    legend.around(&canvas.pixels())
}

/// How many contacts are drawn, of how many and from which part of the step.
fn counted(n: usize, total: usize, window: [f64; 2]) -> String {
    let plural = plural(total as u64);
    let all = match total {
        0 => "no contact".into(),
        _ => format!("{} contact{plural}", thousands(total)),
    };
    let text = match n {
        n if n == total => all,
        0 => format!("none of {all}"),
        1 => format!("the earliest of {all}"),
        n => format!("the {} earliest of {all}", thousands(n)),
    };
    text + &start::within(window)
}

/// Marks of contacts, which are sorted by their times: the latest first, so that the earlier are
/// not covered. `spread`: the length of all contacts in samples; `unit`: that of the frame.
fn draw_marks(
    canvas: &mut Canvas,
    scene: &Scene,
    marks: &[(&Contact, ContactGeometry)],
    [first, last]: [f64; 2],
    [spread, unit]: [f64; 2],
) {
    let n = marks.len().max(1) as f64;
    // Few marks are large, many are small, and smaller where all are in one spot.
    let mut radius = (14.0 - 2.0 * n.log10()).max(3.0) * unit;
    if marks.len() > FEW {
        radius = radius.min((0.02 * spread).max(2.0 * unit));
    }
    // So that many marks behind a surface do not add up to one before it.
    let hidden = (300.0 / n).clamp(0.01, 0.25);
    let colour = |c: &Contact| match last > first {
        true => colour_of((c.toi - first) / (last - first)),
        false => colour_of(0.0),
    };
    if marks.len() <= FEW {
        for (c, _) in marks.iter().rev() {
            outline(canvas, scene, c, colour(c), 3.0 * unit);
        }
    }
    let shape = |c: &Contact| if c.state == State::Hit { Shape::Disc } else { Shape::Square };
    for (c, at) in marks.iter().skip(1).rev() {
        let opacity = if canvas.sees(at.point) { SEEN } else { hidden };
        canvas.mark(at.point, shape(c), radius, colour(c), opacity);
    }
    // The earliest is opaque wherever it is, as its ring is.
    if let Some((c, at)) = marks.first() {
        canvas.mark(at.point, shape(c), radius.max(FIRST_RADIUS * unit), colour(c), 1.0);
        canvas.mark(at.point, Shape::Ring, RING_RADIUS * unit, RING, 1.0);
    }
}

/// The two features of a contact where they are at its time.
fn outline(canvas: &mut Canvas, scene: &Scene, c: &Contact, colour: Colour, width: f64) {
    let [x0, x1] = scene.x;
    let p = c.vertices(scene.mesh).map(|v| lerp(x0[v as usize], x1[v as usize], c.toi));
    let sides: &[[usize; 2]] =
        if c.kind.n_first() == 1 { &[[1, 2], [2, 3], [3, 1]] } else { &[[0, 1], [2, 3]] };
    for &[i, j] in sides {
        canvas.line(p[i], p[j], width, colour, true);
    }
}

/// The length that half of the features in contact do not have: of the longest side of each.
fn size_of_features(scene: &Scene) -> f64 {
    let (x, mesh) = (scene.x[0], scene.mesh);
    let length = |a: u32, b: u32| {
        let d = sub(x[a as usize], x[b as usize]);
        dot(d, d).sqrt()
    };
    let size = |c: &Contact| {
        let v = c.vertices(mesh);
        if c.kind.n_first() == 1 {
            length(v[1], v[2]).max(length(v[2], v[3])).max(length(v[3], v[1]))
        } else {
            length(v[0], v[1]).max(length(v[2], v[3]))
        }
    };
    let mut sizes: Vec<f64> = scene.contacts.iter().map(size).collect();
    sizes.sort_unstable_by(f64::total_cmp);
    sizes.get(sizes.len() / 2).copied().unwrap_or(0.0)
}

/// Edges of no face, and vertices of no edge.
fn loose(mesh: &Mesh) -> (Vec<[u32; 2]>, Vec<u32>) {
    let ordered = |[a, b]: [u32; 2]| if a < b { [a, b] } else { [b, a] };
    let sides: HashSet<[u32; 2]> =
        mesh.faces().iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]].map(ordered)).collect();
    let mut alone = vec![true; mesh.n_vertices()];
    for &v in mesh.edges().iter().flatten().chain(mesh.faces().iter().flatten()) {
        alone[v as usize] = false;
    }
    let rods = mesh.edges().iter().copied().filter(|e| !sides.contains(e)).collect();
    (rods, (0..mesh.n_vertices() as u32).filter(|&v| alone[v as usize]).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_drawn_is_counted() {
        for (n, total, window, want) in [
            (0, 0, [0.0, 1.0], "no contact"),
            (1, 1, [0.0, 1.0], "1 contact"),
            (1234, 1234, [0.0, 1.0], "1,234 contacts"),
            (3, 308, [0.0, 1.0], "the 3 earliest of 308 contacts"),
            (1, 2, [0.0, 1.0], "the earliest of 2 contacts"),
            (0, 1, [0.0, 1.0], "none of 1 contact"),
            (0, 0, [0.0, 0.1], "no contact from 0 to 0.1 of the step"),
            (2, 8, [0.5, 1.0], "the 2 earliest of 8 contacts from 0.5 to 1 of the step"),
        ] {
            assert_eq!(counted(n, total, window), want);
        }
    }
}
