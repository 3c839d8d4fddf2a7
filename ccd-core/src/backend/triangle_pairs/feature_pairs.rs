//! Emit: a pair of triangles as the pairs of features that both represent, one pair a thread of a
//! device; and pairs of features whose representatives are neighbours, from a list.
//!
//! ```text
//!   boxes of triangles -> pairs of triangles -+-> vertex-face -+-> as pairs of features go on
//!                                              `> edge-edge   -+
//!   once per mesh:        tests of neighbours ----------------'
//! ```
//!
//! Tests are numbered as in [`Test`](super::Test). One is a hit if the features have no vertex in
//! common and their own boxes overlap; whether they do so in the precision of the input is asked of
//! the pairs that come out, as of all listed pairs.
//!
//! A CPU looks up stand-ins by the pair of triangles at hand. Here they are a list, once per mesh,
//! with the orphans: a thread each, which asks whether the boxes of the triangles that stand in
//! overlap, so that these tests are made for the same pairs of triangles.

use crate::broad_phase::candidate::{bodies_meet, is_corner, share_vertex};
use crate::broad_phase::pair_rules::classes_meet;
use crate::kernel::memory::at;
use crate::layout::{Expansion, Frame, NearTest, Pair, Triangle};
use crate::math::aabb::Aabb;

/// The first so many tests are of a vertex and a face.
pub const N_VERTEX_FACE: u32 = 6;

/// Numbers of a step that are counted, in the order of
/// [`TriangleCounts`](crate::model::report::TriangleCounts).
pub const N_COUNTS: usize = 5;
/// Words between two counts: low word, then, two words on, how often it ran over.
pub const COUNT_STRIDE: usize = 4;

/// What becomes of a pair of triangles, or of a test of neighbours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Expanded {
    /// What it adds to each count.
    pub counts: [u32; N_COUNTS],
    /// Bits of the tests that hit.
    pub hits: u32,
}

impl Expanded {
    const NOTHING: Self = Self { counts: [0; N_COUNTS], hits: 0 };
    const ADJACENT: Self = Self { counts: [1, 1, 0, 0, 0], hits: 0 };
    const FREE: Self = Self { counts: [1, 0, 1, 0, 0], hits: 0 };
}

/// Expands a pair of triangles whose boxes overlap. `regions`: the certified region of each
/// triangle, read with [`Expansion::FLAG_REGIONS`] alone, then the table of rules, with
/// [`Frame::FLAG_RULES`]; `boxes`: of all features.
#[inline(always)]
pub fn expand(
    pair: Pair,
    frame: &Frame,
    args: &Expansion,
    triangles: &[Triangle],
    regions: &[u32],
    boxes: &[Aabb<f32>],
) -> Expanded {
    let (s, t) = (at(triangles, pair.a as usize), at(triangles, pair.b as usize));
    if frame.has(Frame::FLAG_BODIES) && !bodies_meet(s.body, t.body) {
        return Expanded::NOTHING;
    }
    if frame.has(Frame::FLAG_RULES) && !classes_meet(s.body, t.body, regions, args.rules as usize) {
        return Expanded::NOTHING;
    }
    if args.has(Expansion::FLAG_ORPHANS) && adjacent(&s.corners, &t.corners) {
        return Expanded::ADJACENT;
    }
    if in_one_region(pair, args, regions) {
        return Expanded::FREE;
    }
    let (n_s, n_t) = ((s.represents & 7).count_ones(), (t.represents & 7).count_ones());
    let (mut hits, mut represented) = (0, 0);
    if pair.b < frame.count[2] && n_s > 0 {
        represented += n_s;
        let face = at(boxes, (frame.start[2] + pair.b) as usize);
        hits |= corners(&s, &t, &face, boxes);
    }
    if pair.a < frame.count[2] && n_t > 0 {
        represented += n_t;
        let face = at(boxes, (frame.start[2] + pair.a) as usize);
        hits |= corners(&t, &s, &face, boxes) << 3;
    }
    let (n_s, n_t) = ((s.represents >> 3).count_ones(), (t.represents >> 3).count_ones());
    if n_s > 0 && n_t > 0 {
        represented += n_s * n_t;
        hits |= sides(&s, &t, frame.start[1], boxes) << N_VERTEX_FACE;
    }
    Expanded { counts: [1, 0, 0, represented, 0], hits }
}

/// The features of a test of two triangles.
#[inline(always)]
pub fn features(test: u32, pair: Pair, triangles: &[Triangle]) -> Pair {
    let (s, t) = (at(triangles, pair.a as usize), at(triangles, pair.b as usize));
    if test < 3 {
        Pair { a: pick(s.corners, test), b: pair.b }
    } else if test < N_VERTEX_FACE {
        Pair { a: pick(t.corners, test - 3), b: pair.a }
    } else {
        let sides = test - N_VERTEX_FACE;
        Pair::ordered(pick(s.sides, sides / 3), pick(t.sides, sides % 3))
    }
}

/// Makes test `i` of neighbours; bit 0 of the hits says whether it hits. `swept`: the boxes of all
/// triangles.
#[inline(always)]
pub fn near(
    i: u32,
    test: &NearTest,
    frame: &Frame,
    args: &Expansion,
    regions: &[u32],
    swept: &[Aabb<f32>],
    boxes: &[Aabb<f32>],
) -> Expanded {
    let (pair, triangles) = (test.pair, test.triangles);
    if in_one_region(triangles, args, regions)
        || !at(swept, triangles.a as usize).overlaps(&at(swept, triangles.b as usize))
    {
        return Expanded::NOTHING;
    }
    let (mut a, mut b) = (pair.a, frame.start[2] + pair.b);
    if i >= args.n_vf {
        a += frame.start[1];
        b = frame.start[1] + pair.b;
    }
    let hits = at(boxes, a as usize).overlaps(&at(boxes, b as usize)) as u32;
    let orphan = (i >= args.orphans[0] && i < args.orphans[1]) as u32;
    Expanded { counts: [0, 0, 0, 1 - orphan, orphan], hits }
}

/// Whether two triangles have a vertex in common.
#[inline(always)]
fn adjacent(s: &[u32; 3], t: &[u32; 3]) -> bool {
    is_corner(s[0], *t) | is_corner(s[1], *t) | is_corner(s[2], *t)
}

/// Whether a certified region holds both of two triangles.
#[inline(always)]
fn in_one_region(pair: Pair, args: &Expansion, regions: &[u32]) -> bool {
    if !args.has(Expansion::FLAG_REGIONS) {
        return false;
    }
    let (a, b) = (at(regions, pair.a as usize), at(regions, pair.b as usize));
    // That of no region.
    a == b && a != u32::MAX
}

/// Bits of the represented corners of `of` that hit a face, whose box is given.
#[inline(always)]
fn corners(triangle: &Triangle, face: &Triangle, aabb: &Aabb<f32>, boxes: &[Aabb<f32>]) -> u32 {
    corner(triangle, 0, triangle.corners[0], face, aabb, boxes)
        | corner(triangle, 1, triangle.corners[1], face, aabb, boxes)
        | corner(triangle, 2, triangle.corners[2], face, aabb, boxes)
}

#[inline(always)]
fn corner(
    triangle: &Triangle,
    k: u32,
    v: u32,
    face: &Triangle,
    aabb: &Aabb<f32>,
    boxes: &[Aabb<f32>],
) -> u32 {
    let mut bit = 0;
    if triangle.represents >> k & 1 == 1 && !is_corner(v, face.corners) {
        bit = (at(boxes, v as usize).overlaps(aabb) as u32) << k;
    }
    bit
}

/// An edge that a triangle represents; else a box that overlaps nothing.
#[derive(Clone, Copy)]
struct Side {
    ends: [u32; 2],
    aabb: Aabb<f32>,
}

/// Bit `3 i + j` for each represented side `i` of `s` that hits side `j` of `t`; boxes of edges
/// begin at `start`.
#[inline(always)]
fn sides(s: &Triangle, t: &Triangle, start: u32, boxes: &[Aabb<f32>]) -> u32 {
    let ([a, b, c], [e, f, g]) = (t.corners, t.sides);
    let (t0, t1) = (side(t, 3, e, [a, b], start, boxes), side(t, 4, f, [b, c], start, boxes));
    let t2 = side(t, 5, g, [c, a], start, boxes);
    let ([a, b, c], [e, f, g]) = (s.corners, s.sides);
    let s0 = side(s, 3, e, [a, b], start, boxes);
    let mut bits = meet(&s0, &t0) | meet(&s0, &t1) << 1 | meet(&s0, &t2) << 2;
    let s1 = side(s, 4, f, [b, c], start, boxes);
    bits |= meet(&s1, &t0) << 3 | meet(&s1, &t1) << 4 | meet(&s1, &t2) << 5;
    let s2 = side(s, 5, g, [c, a], start, boxes);
    bits | meet(&s2, &t0) << 6 | meet(&s2, &t1) << 7 | meet(&s2, &t2) << 8
}

#[inline(always)]
fn side(t: &Triangle, bit: u32, id: u32, ends: [u32; 2], start: u32, boxes: &[Aabb<f32>]) -> Side {
    let mut aabb = Aabb::EMPTY;
    if t.represents >> bit & 1 == 1 {
        aabb = at(boxes, (start + id) as usize);
    }
    Side { ends, aabb }
}

#[inline(always)]
fn meet(a: &Side, b: &Side) -> u32 {
    (!share_vertex(a.ends, b.ends) & a.aabb.overlaps(&b.aabb)) as u32
}

/// One of three.
#[inline(always)]
fn pick(three: [u32; 3], k: u32) -> u32 {
    if k == 0 {
        three[0]
    } else if k == 1 {
        three[1]
    } else {
        three[2]
    }
}
