//! Fifteen axes along which two oriented boxes may be apart; the bound is derived in [`super`].

use super::{Obb, along, reach};
use crate::math::aabb::Aabb;
use crate::math::real::{Num, Real};
use crate::math::vec3::{sub, sum_abs};

impl<N: Num> Obb<N> {
    /// Positive only if the two certainly have no point in common. The size means nothing.
    #[inline(always)]
    pub fn gap(&self, other: &Self) -> N {
        let pair = Placement::of_two(self, other);
        pair.along_normals().max(pair.along_edges()) - pair.margin
    }
}

impl<T: Real> Obb<T> {
    /// Whether the two certainly have no point in common; edges are looked at where normals do not
    /// tell.
    #[inline]
    pub fn separated(&self, other: &Self) -> bool {
        Placement::of_two(self, other).separates()
    }

    /// Whether the box and one along the coordinates certainly have no point in common.
    #[inline]
    pub fn separated_from_box(&self, other: &Aabb<T>) -> bool {
        Placement::of_box(&Self::of_box(other), self).separates()
    }
}

/// How two boxes lie to each other.
struct Placement<N> {
    /// Scalar products of the axes of the first with those of the second.
    c: [[N; 3]; 3],
    /// From centre to centre, along the axes of the first and of the second.
    ta: [N; 3],
    tb: [N; 3],
    ha: [N; 3],
    hb: [N; 3],
    /// What a separation must exceed.
    margin: N,
}

impl<N: Num> Placement<N> {
    #[inline(always)]
    fn of_two(a: &Obb<N>, b: &Obb<N>) -> Self {
        let t = sub(b.centre, a.centre);
        let c = [along(&b.axes, a.axes[0]), along(&b.axes, a.axes[1]), along(&b.axes, a.axes[2])];
        Self {
            c,
            ta: along(&a.axes, t),
            tb: along(&b.axes, t),
            ha: a.half,
            hb: b.half,
            margin: margin(t, a, b),
        }
    }

    /// The first along the coordinates: its scalar products are components.
    #[inline(always)]
    fn of_box(a: &Obb<N>, b: &Obb<N>) -> Self {
        let t = sub(b.centre, a.centre);
        let [p, q, r] = b.axes;
        Self {
            c: [[p[0], q[0], r[0]], [p[1], q[1], r[1]], [p[2], q[2], r[2]]],
            ta: t,
            tb: along(&b.axes, t),
            ha: a.half,
            hb: b.half,
            margin: margin(t, a, b),
        }
    }

    /// The greatest separation along the normals of either.
    #[inline(always)]
    fn along_normals(&self) -> N {
        // No closures: they would not be compiled for the instruction set of the caller.
        let [[c00, c01, c02], [c10, c11, c12], [c20, c21, c22]] = self.c;
        let (a, b) = (self.ha, self.hb);
        let of_a = [
            self.ta[0].abs() - (a[0] + reach([c00, c01, c02], b)),
            self.ta[1].abs() - (a[1] + reach([c10, c11, c12], b)),
            self.ta[2].abs() - (a[2] + reach([c20, c21, c22], b)),
        ];
        let of_b = [
            self.tb[0].abs() - (b[0] + reach([c00, c10, c20], a)),
            self.tb[1].abs() - (b[1] + reach([c01, c11, c21], a)),
            self.tb[2].abs() - (b[2] + reach([c02, c12, c22], a)),
        ];
        greatest(of_a).max(greatest(of_b))
    }

    /// The greatest separation along the products of edges.
    #[inline(always)]
    fn along_edges(&self) -> N {
        let of_0 = [self.along::<0, 0>(), self.along::<0, 1>(), self.along::<0, 2>()];
        let of_1 = [self.along::<1, 0>(), self.along::<1, 1>(), self.along::<1, 2>()];
        let of_2 = [self.along::<2, 0>(), self.along::<2, 1>(), self.along::<2, 2>()];
        greatest(of_0).max(greatest(of_1)).max(greatest(of_2))
    }

    /// The separation along `c[p][J] a_q - c[q][J] a_p`, where `p` and `q` follow `I`.
    #[inline(always)]
    fn along<const I: usize, const J: usize>(&self) -> N {
        let Self { c, ta, ha, hb, .. } = self;
        let ([p, q], [r, s]) = (const { others(I) }, const { others(J) });
        let apart = c[p][J] * ta[q] - c[q][J] * ta[p];
        let of_a = c[q][J].abs() * ha[p] + c[p][J].abs() * ha[q];
        let of_b = c[I][s].abs() * hb[r] + c[I][r].abs() * hb[s];
        apart.abs() - (of_a + of_b)
    }
}

impl<T: Real> Placement<T> {
    #[inline(always)]
    fn separates(&self) -> bool {
        self.along_normals() > self.margin || self.along_edges() > self.margin
    }
}

/// What a separation must exceed, see the head of the file.
#[inline(always)]
fn margin<N: Num>(t: [N; 3], a: &Obb<N>, b: &Obb<N>) -> N {
    let twice = (sum_abs(t) + (sum_abs(a.half) + sum_abs(b.half))) * N::splat(2.0);
    twice * (N::UNIT * N::splat(128.0)) + N::MIN_NORMAL * N::splat(128.0)
}

/// The axes of a box but the one of this number.
const fn others(i: usize) -> [usize; 2] {
    [(i + 1) % 3, (i + 2) % 3]
}

#[inline(always)]
fn greatest<N: Num>(x: [N; 3]) -> N {
    x[0].max(x[1]).max(x[2])
}
