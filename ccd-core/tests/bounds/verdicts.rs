//! Whole queries in adversarial arithmetic: a contact that is there is never missed and never
//! answered late.

use crate::common::Points;
use crate::common::adversary::{Adversarial, UNIT, under};
use crate::common::random::Random;
use ccd_core::narrow_phase::conservative_advancement::{Advance, advance, within};
use ccd_core::narrow_phase::containment::{Inside, inside};
use ccd_core::narrow_phase::query::solve;
use ccd_core::narrow_phase::relative_motion::{Motion, Patch};

type V = [f64; 3];

/// A query with a contact at a known time, as `a b c` at both ends: `a = s b + r c` there.
struct Touch {
    patch: Patch,
    x: [[V; 2]; 3],
    t: f64,
}

fn at(x: &[V; 2], t: f64) -> V {
    std::array::from_fn(|k| x[0][k] * (1.0 - t) + x[1][k] * t)
}

/// Contact inside of the patch, on a side, or in a corner; at any time, or at an end; planar,
/// parallel or general.
fn touch(random: &mut Random) -> Touch {
    let patch = if random.below(2) == 0 { Patch::Triangle } else { Patch::Parallelogram };
    let t = [0.0, 1.0, 0.5, random.unit()][random.below(4)];
    let mut pair =
        |size: f64| [random.vector().map(|c| c * size), random.vector().map(|c| c * size)];
    let (mut b, mut c, mut a) = (pair(1.0), pair(1.0), pair(1.0));
    let small = random.power(-12.0, 0.0);
    match random.below(6) {
        0 => c = b.map(|v| v.map(|x| x * 0.5)),
        1 => [&mut a, &mut b, &mut c].into_iter().flatten().for_each(|p| p[2] = 0.0),
        2 => a = a.map(|v| v.map(|x| x * small)),
        3 => [a[0], a[1]] = [a[0], a[0]],
        _ => {}
    }
    let mut inside = || [0.0, 1.0, random.unit(), random.unit()][random.below(4)];
    let (s, mut r) = (inside(), inside());
    if matches!(patch, Patch::Triangle) {
        r = if random.below(3) == 0 { 1.0 - s } else { r * (1.0 - s) };
    }
    let (bt, ct, now) = (at(&b, t), at(&c, t), at(&a, t));
    for k in 0..3 {
        let by = s * bt[k] + r * ct[k] - now[k];
        a.iter_mut().for_each(|v| v[k] += by);
    }
    Touch { patch, x: [a, b, c], t }
}

impl Touch {
    fn motion(&self) -> Motion<Adversarial> {
        let [a, b, c] = self.x.map(|v| v.map(|p| p.map(Adversarial)));
        Motion { a, b, c, error: Adversarial(0.0) }
    }

    /// The features as points, seen from a point `origin`.
    fn points(&self, origin: V) -> [Points<Adversarial>; 2] {
        [0, 1].map(|i| {
            let [a, b, c] = self.x.map(|v| v[i]);
            let points = match self.patch {
                Patch::Triangle => [a, [0.0; 3], b, c],
                Patch::Parallelogram => [[0.0; 3], b, a, std::array::from_fn(|k| a[k] - c[k])],
            };
            points.map(|p| std::array::from_fn(|k| Adversarial(p[k] + origin[k])))
        })
    }
}

/// Choices of an adversary: anything, mostly one way, or nothing at all.
fn choices(random: &mut Random) -> Vec<i8> {
    let kind = random.below(4);
    (0..600)
        .map(|i| match kind {
            0 => 0,
            1 => random.below(3) as i8 - 1,
            2 => 1 - 2 * (i % 2) as i8,
            _ => 1 - 2 * (random.below(2) as i8),
        })
        .collect()
}

/// No bound of a time is later than the contact by more than the rounding of the coordinates in
/// `f64`.
const LATE: f64 = 1e-9;

#[test]
fn no_contact_is_missed() {
    let mut random = Random::new(1);
    let mut n_late = 0;
    for _ in 0..8_000 {
        let q = touch(&mut random);
        let ways = choices(&mut random);
        let flush = random.below(2) == 0;
        let origin = if random.below(2) == 0 { [0.0; 3] } else { random.vector() };
        let [t0, t1] = q.points(origin);
        let (verdict, _) = under(&ways, flush, || {
            let zero = Adversarial(0.0);
            let m = Motion::new(q.patch, &t0, &t1, zero);
            solve(&m, q.patch, zero)
        });
        let early = verdict.toi().is_some_and(|toi| toi.0 <= q.t + LATE);
        let (t, patch) = (q.t, q.patch);
        assert!(early, "{t}, but {verdict:?}: {patch:?} {t0:?} {t1:?} {flush} {ways:?}");
        n_late += verdict.toi().is_some_and(|toi| toi.0 > 0.1) as usize;
    }
    assert!(n_late > 400, "{n_late} that were decided at all");
}

#[test]
fn advancement_stops_before_a_contact() {
    let mut random = Random::new(2);
    let mut n_far = 0;
    for _ in 0..8_000 {
        let q = touch(&mut random);
        let ways = choices(&mut random);
        let (m, zero, one) = (q.motion(), Adversarial(0.0), Adversarial(1.0));
        let (got, _) =
            under(&ways, false, || advance(&m, q.patch, zero, one, zero, Adversarial(1e-6)));
        let stops = matches!(got, Advance::Stuck(t) if t.0 <= q.t + LATE);
        assert!(stops, "contact at {}, but {got:?}: {:?} {:?} {ways:?}", q.t, q.patch, q.x);
        n_far += matches!(got, Advance::Stuck(t) if t.0 > 0.1) as usize;
    }
    assert!(n_far > 400, "{n_far} that advanced at all");
}

#[test]
fn containment_is_certain() {
    let mut random = Random::new(3);
    let mut n = [0; 3];
    for i in 0..20_000 {
        let q = touch(&mut random);
        let m = q.motion();
        let width = [0.0, 8.0 * UNIT, 1e-3, 0.1][i % 4];
        let lo = (q.t - width * random.unit()).clamp(0.0, 1.0);
        let hi = (lo + width).max(q.t).min(1.0);
        let ways = choices(&mut random);
        let (got, _) =
            under(&ways, i % 3 == 0, || inside(&m, q.patch, Adversarial(lo), Adversarial(hi)));
        // It touches at a time within the interval, so it is not outside.
        let tell = |t: f64| format!("{:?} {:?} at {t} in [{lo}, {hi}] {ways:?}", q.patch, q.x);
        assert!(got != Inside::Outside, "{}", tell(q.t));
        n[got as usize] += 1;
        if got == Inside::Inside {
            // The projected point is in the patch all the time: at both ends too, by exact signs of
            // the same fractions.
            for t in [lo, q.t, hi] {
                assert!(in_patch(&q, t), "{}", tell(t));
            }
        }
    }
    assert!(n[1] > 400 && n[2] > 400, "{n:?}");
}

/// Whether the projection along some axis has the point in the patch, up to rounding in `f64`.
fn in_patch(q: &Touch, t: f64) -> bool {
    let [a, b, c] = [0, 1, 2].map(|i| at(&q.x[i], t));
    (0..3).any(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let cross = |p: V, q: V| p[i] * q[j] - p[j] * q[i];
        let d = cross(b, c);
        let (s, r) = (cross(a, c) / d, cross(b, a) / d);
        let rest = match q.patch {
            Patch::Triangle => 1.0 - s - r,
            Patch::Parallelogram => (1.0 - s).min(1.0 - r),
        };
        s.min(r).min(rest) > -1e-9
    })
}

#[test]
fn a_witness_is_near() {
    let mut random = Random::new(4);
    let mut n = [0; 2];
    for _ in 0..8_000 {
        // The vector from the patch to the point at the time is a normal of known length, so this
        // is the distance.
        let q = touch(&mut random);
        let [_, b, c] = [0, 1, 2].map(|i| at(&q.x[i], q.t));
        let normal =
            [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
        let length = normal.iter().map(|c| c * c).sum::<f64>().sqrt();
        if length < 1e-3 {
            continue;
        }
        let gap = random.power(-20.0, 0.0);
        let mut apart = Touch { x: q.x, ..q };
        apart.x[0].iter_mut().for_each(|v| (0..3).for_each(|k| v[k] += normal[k] * gap / length));
        let ways = choices(&mut random);
        let distance = gap * (1.0 + random.power(-24.0, -1.0) * random.sign());
        let m = apart.motion();
        let run = || within(&m, apart.patch, Adversarial(apart.t), Adversarial(distance));
        let (near, _) = under(&ways, false, run);
        let holds = !near || gap <= distance * (1.0 + 1e-9);
        assert!(holds, "{gap} is not within {distance}: {:?} {ways:?}", apart.x);
        n[near as usize] += 1;
    }
    assert!(n[0] > 400 && n[1] > 400, "{n:?}");
}
