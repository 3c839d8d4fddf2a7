//! Map: the verdict of one pair that the filters left, from the buffers of a device.

use super::cascade::ends;
use crate::broad_phase::placement::given;
use crate::kernel::memory::{Stored, at};
use crate::layout::VERTEX_FACE;
use crate::layout::{Frame, IntegerDecision, Pair, Path, elements, join, split};
use crate::math::q62::Q62;
use crate::math::real::Real;
use crate::narrow_phase::approach::Approach;
use crate::narrow_phase::integer_search::{self, Found, NO_UNIT, Window};
use crate::narrow_phase::query::{self, Verdict};
use crate::narrow_phase::relative_motion::{Motion, Patch};
use crate::narrow_phase::search::{Answer, Search};

/// A verdict in words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Verdicts {
    /// Contact, or not decided.
    pub touches: bool,
    /// 1 if not decided.
    pub undecided: u32,
    /// The word of [`Approach`].
    pub approach: u32,
    /// Time of impact: bits of an `f64`, low word first.
    pub toi: [u32; 2],
}

impl Verdicts {
    /// No contact.
    pub const NONE: Self = Self { touches: false, undecided: 0, approach: 0, toi: [0; 2] };
    /// Not decided.
    pub const OPEN: Self = Self { touches: true, undecided: 1, ..Self::NONE };
}

/// What a frame has its `f32` kernels look for: times that hold those that are wanted.
///
/// Contacts are left only where the first time is an `f32`. A rounded first time is earlier, and
/// so would be the distance that a departure is compared with: features that come back to that
/// distance may be nearer than at the true first time, or in contact again. Such contacts are not
/// left but open, and `f64` decides.
#[inline(always)]
pub fn search_of(frame: &Frame) -> Search<f32> {
    let from = widen(frame.from);
    let starts = from[0] == frame.from_bits[0] && from[1] == frame.from_bits[1];
    Search {
        min_distance: frame.min_distance,
        tolerance: frame.tolerance,
        from: frame.from,
        until: frame.until,
        latest: frame.until,
        leaves: frame.has(Frame::FLAG_LEAVES) && starts,
    }
}

/// What it has its `f64` kernels look for.
#[inline(always)]
pub fn wide_search_of(frame: &Frame) -> Search<f64> {
    Search {
        min_distance: join(frame.distance_bits),
        tolerance: join(frame.tolerance_bits),
        from: join(frame.from_bits),
        until: join(frame.until_bits),
        latest: join(frame.until_bits),
        leaves: frame.has(Frame::FLAG_LEAVES),
    }
}

/// Rounds that workgroup `group` of `groups` needs for its share of `n` items.
#[inline(always)]
pub fn rounds(n: u32, group: u32, groups: u32, threads: u32) -> u32 {
    let tiles = n.div_ceil(threads);
    if tiles > group { (tiles - group).div_ceil(groups) } else { 0 }
}

/// A time of impact in `[0, 1]` as an integer of the same order, rounded down: the upper bits of
/// its `f64`, which start at 2^-126 like those of `f32`.
///
/// The bits of the `f32` next below, for `toi >= 2^-126`; 0 for lesser ones, also for -0.
#[inline(always)]
pub fn earliest_key(toi: [u32; 2]) -> u32 {
    // 11 bits of exponent, bias 1023, to 8 bits, bias 127; the 29 lowest bits of the fraction fall
    // away.
    let exponent = toi[1] >> 20 & 0x7ff;
    if exponent <= 1023 - 127 {
        return 0;
    }
    (exponent - (1023 - 127)) << 23 | (toi[1] & 0xf_ffff) << 3 | toi[0] >> 29
}

/// The key while there is no time of impact.
pub const NEVER: u32 = u32::MAX;

/// The time of a key; 1 if there is none.
#[inline(always)]
pub fn until(key: u32) -> f32 {
    if key < 0x3f80_0000 { f32::from_bits(key) } else { 1.0 }
}

/// The bits of an `f32` as those of an `f64`; a denormal becomes 0, which of times is earlier.
#[inline(always)]
pub fn widen(x: f32) -> [u32; 2] {
    let bits = x.to_bits();
    let size = bits & 0x7fff_ffff;
    if size < 0x0080_0000 {
        return [0; 2];
    }
    [bits << 29, (bits ^ size) | ((size >> 3) + ((1023 - 127) << 20))]
}

/// An `f32` as an `f64`, exactly: by its bits, because a device may take a denormal as zero where
/// it converts.
#[inline(always)]
pub fn widened(x: f32) -> f64 {
    let bits = x.to_bits();
    let size = bits & 0x7fff_ffff;
    if size >= 0x0080_0000 {
        return join(widen(x));
    }
    // A multiple of 2^-149.
    let least = join([0, (1023 - 149) << 20]);
    if bits == size { size as f64 * least } else { -(size as f64 * least) }
}

#[inline(always)]
fn verdicts<R>(answer: Answer<R>, bits: impl Fn(R) -> [u32; 2]) -> Verdicts {
    let approach = answer.approach.word();
    match answer.verdict {
        Verdict::Miss => Verdicts { approach, ..Verdicts::NONE },
        Verdict::Hit { toi } => Verdicts { touches: true, undecided: 0, approach, toi: bits(toi) },
        Verdict::Undecided { toi } => {
            Verdicts { touches: true, undecided: 1, approach, toi: bits(toi) }
        }
    }
}

/// An answer in `f32` of which less is taken as certain where `f64` may know more: hits in a window
/// whose ends are no `f32`, which may be outside of it, and contacts at the start that were not
/// left.
#[inline(always)]
pub fn narrow_verdicts(answer: Answer<f32>, frame: &Frame) -> Verdicts {
    let v = verdicts(answer, widen);
    let at_start = v.toi[0] == widen(frame.from)[0] && v.toi[1] == widen(frame.from)[1];
    let open = frame.has(Frame::FLAG_WINDOW_ROUNDED) || frame.has(Frame::FLAG_LEAVES) && at_start;
    let undecided = if v.touches && open { 1 } else { v.undecided };
    Verdicts { undecided, ..v }
}

/// Decides a pair of a kind by integers. `elements`: see [`layout::elements`](elements).
/// `positions`: words of positions as given, if paths are not exact.
#[inline(always)]
pub fn by_integers<P: Stored<Path>>(
    kind: u32,
    pair: Pair,
    frame: &Frame,
    args: &IntegerDecision,
    paths: &[P],
    positions: &[u32],
    elements: &[u32],
) -> Found {
    let (patch, ids) = words_of_pair(kind, pair, frame, elements);
    let (x0, x1) = ends(ids, paths);
    let unit = integer_search::unit(&Motion::new(patch, &x0, &x1, frame.path_error));
    if unit == NO_UNIT {
        return Found::Open;
    }
    let exact = frame.has(Frame::FLAG_EXACT);
    // The scale of paths is a power of two.
    let scale = (frame.scale_bits[1] >> 20) as i32 - 1023;
    let unit = if exact { unit } else { unit - scale };
    let (mut points, mut ids) = ([[[Q62::ZERO; 3]; 2]; 4], ids);
    // One after the other, because a kernel takes as long to compile as it has conversions; and
    // read again, because an index that is computed would put paths into memory.
    for _ in 0..4 {
        let id = ids[0] as usize;
        let (x0, x1) = if exact {
            let path = P::load(paths, id);
            (words(path.t0), words(path.t1))
        } else {
            let end = frame.count[0] as usize + id;
            (given_words(positions, 6 * id), given_words(positions, 6 * end))
        };
        points = [points[1], points[2], points[3], [in_units(x0, unit), in_units(x1, unit)]];
        ids = [ids[1], ids[2], ids[3], ids[0]];
    }
    let IntegerDecision { from, until, tolerance, .. } = *args;
    integer_search::search(patch, &points, &Window { from, until, tolerance })
}

/// What integers found in a window that begins at `from`.
#[inline(always)]
pub fn found_verdicts(found: Found, from: u32) -> Verdicts {
    match found {
        Found::Miss => Verdicts::NONE,
        Found::Hit(toi) => {
            let nears = if toi > from { Approach::Approaching } else { Approach::Unknown };
            let (approach, toi) = (nears.word(), time_of(toi));
            Verdicts { touches: true, approach, toi, ..Verdicts::NONE }
        }
        Found::Open | Found::Tie => Verdicts::OPEN,
    }
}

/// Decides a pair of a kind in `f32`. `HOW`: see [`by`].
#[inline(always)]
pub fn narrow<const HOW: u32, P: Stored<Path>>(
    kind: u32,
    pair: Pair,
    frame: &Frame,
    paths: &[P],
    elements: &[u32],
) -> Verdicts {
    let (patch, ids) = words_of_pair(kind, pair, frame, elements);
    let (x0, x1) = ends(ids, paths);
    let motion = Motion::new(patch, &x0, &x1, frame.path_error);
    narrow_verdicts(answer::<HOW, _>(&motion, patch, &search_of(frame)), frame)
}

#[inline(always)]
fn in_units([x, y, z]: [[u32; 2]; 3], unit: i32) -> [Q62; 3] {
    [Q62::of(x, unit), Q62::of(y, unit), Q62::of(z, unit)]
}

#[inline(always)]
fn words([x, y, z, _]: [f32; 4]) -> [[u32; 2]; 3] {
    [widen(x), widen(y), widen(z)]
}

#[inline(always)]
fn given_words(words: &[u32], i: usize) -> [[u32; 2]; 3] {
    let of = |i: usize| [at(words, i), at(words, i + 1)];
    [of(i), of(i + 2), of(i + 4)]
}

/// A time in 2^-31 of the step, as bits of an `f64`, low word first.
#[inline(always)]
fn time_of(units: u32) -> [u32; 2] {
    if units == 0 {
        return [0; 2];
    }
    let zeros = units.leading_zeros();
    // Without the first one. Two shifts, because one by 32 is none.
    let fraction = (units << zeros) << 1;
    [fraction << 20, ((1023 - zeros) << 20) | (fraction >> 12)]
}

/// How a kernel decides. One for each takes half as long to compile as one for all.
pub mod by {
    /// Contact, by zeros of the cubic: what these do not tell is open.
    pub const ZEROS: u32 = 0;
    /// Contact, by zeros and, where they do not tell, by advancing time.
    pub const BOTH: u32 = 1;
    /// A minimum distance.
    pub const DISTANCE: u32 = 2;
}

/// Decides a pair of a kind in `f64`. `HOW`: see [`by`].
#[inline(always)]
pub fn wide<const HOW: u32, P: Stored<Path>>(
    kind: u32,
    pair: Pair,
    frame: &Frame,
    paths: &[P],
    positions: &[[f64; 3]],
    elements: &[u32],
) -> Verdicts {
    let (patch, ids) = words_of_pair(kind, pair, frame, elements);
    let (x0, x1) = wide_ends(ids, frame, paths, positions);
    let motion = Motion::new(patch, &x0, &x1, 0.0);
    verdicts(answer::<HOW, _>(&motion, patch, &wide_search_of(frame)), split)
}

#[inline(always)]
fn answer<const HOW: u32, R: Real>(
    motion: &Motion<R>,
    patch: Patch,
    search: &Search<R>,
) -> Answer<R> {
    match HOW {
        by::ZEROS => query::by_zeros::<false, R>(motion, patch, search),
        by::BOTH => query::contact(motion, patch, search),
        _ => query::near(motion, patch, search),
    }
}

/// Positions as given: in `f32` if those are exact.
#[inline(always)]
pub(super) fn wide_ends<P: Stored<Path>>(
    ids: [u32; 4],
    frame: &Frame,
    paths: &[P],
    positions: &[[f64; 3]],
) -> ([[f64; 3]; 4], [[f64; 3]; 4]) {
    if frame.has(Frame::FLAG_EXACT) {
        let (p, q) = ends(ids, paths);
        (all_widened(p), all_widened(q))
    } else {
        let (v0, v1) = (given(ids[0], frame, positions), given(ids[1], frame, positions));
        let (v2, v3) = (given(ids[2], frame, positions), given(ids[3], frame, positions));
        ([v0.0, v1.0, v2.0, v3.0], [v0.1, v1.1, v2.1, v3.1])
    }
}

#[inline(always)]
fn all_widened(x: [[f32; 3]; 4]) -> [[f64; 3]; 4] {
    let wide = |p: [f32; 3]| [widened(p[0]), widened(p[1]), widened(p[2])];
    [wide(x[0]), wide(x[1]), wide(x[2]), wide(x[3])]
}

/// What a pair of a kind is: over which patch, and its vertex ids, `v f0 f1 f2` or
/// `ea0 ea1 eb0 eb1`.
#[inline(always)]
pub fn words_of_pair(kind: u32, pair: Pair, frame: &Frame, elements: &[u32]) -> (Patch, [u32; 4]) {
    if kind == VERTEX_FACE {
        let face = elements::face(pair.b, frame.count[1], elements);
        (Patch::Triangle, [pair.a, face[0], face[1], face[2]])
    } else {
        let (a, b) = (elements::edge(pair.a, elements), elements::edge(pair.b, elements));
        (Patch::Parallelogram, [a[0], a[1], b[0], b[1]])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    /// Times of a window and the tolerance are rounded so that nothing is lost, and contacts are
    /// left from the first time alone.
    #[test]
    fn narrow_searches_hold_the_wide_ones() {
        let mut random = Random::new(1);
        let mut unit = || random.unit() + random.unit() / (1 << 24) as f64;
        let ends = [0.0, 1e-320, 1e-40, 0.5, 0.5f64.next_up(), 1.0f64.next_down(), 1.0];
        for i in 0..4000 {
            let mut time = || if i % 3 == 0 { ends[(unit() * 7.0) as usize] } else { unit() };
            let (a, b) = (time(), time());
            let (from, until) = (a.min(b), a.max(b));
            let tolerance = 1e-12f64.max(unit().powi(9));
            for leaves in [false, true] {
                let (whole, latest) = (Search::whole(0.0), until);
                let wide = Search { from, until, latest, tolerance, leaves, ..whole };
                let frame = Frame::default().searching(&wide);
                let wanted = search_of(&frame);
                assert!(wanted.from as f64 <= from && wanted.until as f64 >= until, "{wide:?}");
                assert!(wanted.tolerance as f64 <= tolerance && wanted.tolerance > 0.0);
                let is_start = wanted.from as f64 == from;
                assert!(wanted.leaves == (leaves && is_start) || from < 1e-37, "{wide:?}");
                assert!(!wanted.leaves || leaves && is_start, "{wide:?}");
                let found = wide_search_of(&frame);
                let wide = Search { min_distance: found.min_distance, ..wide };
                assert_eq!(found, wide);
            }
        }
        let leaves = |from: f64| Search { leaves: true, from, ..Search::whole(0.0) };
        let of = |from: f64| search_of(&Frame::default().searching(&leaves(from))).leaves;
        assert_eq!([0.0, 0.25, 0.1f32 as f64, 0.1].map(of), [true, true, true, false]);
    }

    #[test]
    fn keys_are_the_bits_of_f32_rounded_down() {
        let below_1 = 1.0 - f64::EPSILON;
        for toi in [0.0, -0.0, 1e-300, 1.2e-38, 7.49207e-6, 0.1, 1.0 / 3.0, 0.5, below_1, 1.0] {
            let want = if toi < f32::MIN_POSITIVE as f64 { 0.0 } else { Real::round_down(toi) };
            assert_eq!(f32::from_bits(earliest_key(split(toi))), want, "{toi:e}");
        }
        for toi in [0.0f32, 1e-40, 1.2e-38, 7.49207e-6, 0.1, 1.0] {
            let want = if toi < f32::MIN_POSITIVE { 0.0 } else { toi as f64 };
            assert_eq!(join(widen(toi)), want, "{toi:e}");
        }
    }

    #[test]
    fn times_by_integers_are_f64() {
        for units in (0..32).flat_map(|i| [0, 1, 1 << i >> 1, (1 << i) - 1u32, 0x4321_8765 >> i]) {
            let want = units as f64 / (1u64 << 31) as f64;
            assert_eq!(join(time_of(units)), want, "{units}");
        }
    }

    #[test]
    fn numbers_are_widened_as_the_standard_library_does() {
        let all = (0..24).map(|i| 1u32 << i).chain((0..=254).map(|e| e << 23 | 0x12_3457));
        for bits in all.chain([0, 0x7f_ffff, 0x7f7f_ffff]) {
            for x in [f32::from_bits(bits), -f32::from_bits(bits)] {
                assert_eq!(widened(x), f64::from(x), "{x:e}");
            }
        }
    }
}
