//! Map: how contact `i` of a device's list meets at its time of impact.

use super::cascade::ends;
use super::contact_geometry::{ContactGeometry, contact_geometry};
use super::decide::{earliest_key, until, wide_ends, words_of_pair};
use crate::kernel::memory::at;
use crate::layout::{
    Frame, LIST_HEADER, Pair, Params, Path, Placing, TOUCH_WORDS, Touch, TouchGeometry, join,
};
use crate::math::vec3::{add, scale};
use crate::narrow_phase::relative_motion::Patch;

/// From paths, in `f32`.
#[inline(always)]
pub fn narrow(
    i: u32,
    params: &Params<Placing>,
    paths: &[Path],
    elements: &[u32],
    contacts: &[u32],
) -> TouchGeometry {
    let touch = entry(i, contacts);
    let (patch, ids) = features(&touch, &params.frame, elements);
    let (x0, x1) = ends(ids, paths);
    let toi = until(earliest_key(touch.toi));
    let g = contact_geometry(patch, &x0, &x1, toi, params.frame.path_error);
    let Placing { origin, unit } = params.args;
    TouchGeometry {
        point: add(scale(g.point, unit), origin),
        distance: g.distance * unit,
        normal: g.normal,
        state: touch.state,
        weights: g.weights,
        vertices: ids,
    }
}

/// From positions as they were given, in `f64`, rounded to `f32` at the end.
#[inline(always)]
pub fn wide(
    i: u32,
    params: &Params,
    paths: &[Path],
    positions: &[[f64; 3]],
    elements: &[u32],
    contacts: &[u32],
) -> TouchGeometry {
    let touch = entry(i, contacts);
    let (patch, ids) = features(&touch, &params.frame, elements);
    let (x0, x1) = wide_ends(ids, &params.frame, paths, positions);
    let g = contact_geometry(patch, &x0, &x1, join(touch.toi), 0.0);
    rounded(&g, touch.state, ids)
}

/// As a record.
#[inline(always)]
pub fn rounded(g: &ContactGeometry, state: u32, vertices: [u32; 4]) -> TouchGeometry {
    let three = |v: [f64; 3]| [v[0] as f32, v[1] as f32, v[2] as f32];
    let w = g.weights;
    TouchGeometry {
        point: three(g.point),
        distance: g.distance as f32,
        normal: three(g.normal),
        state,
        weights: [w[0] as f32, w[1] as f32, w[2] as f32, w[3] as f32],
        vertices,
    }
}

#[inline(always)]
fn entry(i: u32, contacts: &[u32]) -> Touch {
    let first = LIST_HEADER + TOUCH_WORDS * i as usize;
    Touch {
        kind: at(contacts, first),
        state: at(contacts, first + 1),
        a: at(contacts, first + 2),
        b: at(contacts, first + 3),
        toi: [at(contacts, first + 4), at(contacts, first + 5)],
        approach: at(contacts, first + 6),
    }
}

#[inline(always)]
fn features(touch: &Touch, frame: &Frame, elements: &[u32]) -> (Patch, [u32; 4]) {
    words_of_pair(touch.kind, Pair { a: touch.a, b: touch.b }, frame, elements)
}
