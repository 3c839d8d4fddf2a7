//! Oriented boxes in integer arithmetic: what is in them, and whether two have a point in common.

use super::exact::integers;
use ccd_core::Real;
use ccd_core::math::obb::Obb;
use num_bigint::BigInt;
use num_traits::{Signed, Zero};

type Vector = [BigInt; 3];

fn dot(a: &Vector, b: &Vector) -> BigInt {
    (0..3).map(|k| &a[k] * &b[k]).sum()
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        &a[i] * &b[j] - &a[j] * &b[i]
    })
}

/// The same box, with nothing lost.
pub fn widen<T: Real>(b: &Obb<T>) -> Obb<f64> {
    Obb {
        centre: b.centre.map(|x| x.to_f64()),
        axes: b.axes.map(|a| a.map(|x| x.to_f64())),
        half: b.half.map(|x| x.to_f64()),
    }
}

/// All numbers of a box, times one power of two.
struct Exact {
    centre: Vector,
    axes: [Vector; 3],
    /// In the unit of a product of two others.
    half: Vector,
}

impl Exact {
    fn new(x: &[BigInt], one: &BigInt) -> Self {
        let vector = |i: usize| -> Vector { std::array::from_fn(|k| x[i + k].clone()) };
        Self {
            centre: vector(0),
            axes: [vector(3), vector(6), vector(9)],
            half: vector(12).map(|h| h * one),
        }
    }

    fn holds(&self, p: &Vector, divisor: &BigInt) -> bool {
        let d: Vector = std::array::from_fn(|k| &p[k] - &self.centre[k] * divisor);
        (0..3).all(|k| dot(&self.axes[k], &d).abs() <= &self.half[k] * divisor)
    }

    /// The directions of its edges.
    fn edges(&self) -> [Vector; 3] {
        let [a, b, c] = &self.axes;
        [cross(b, c), cross(c, a), cross(a, b)]
    }

    /// Its corners, times a positive number that is returned with them.
    fn corners(&self) -> (Vec<Vector>, BigInt) {
        let edges = self.edges();
        let determinant = dot(&self.axes[0], &edges[0]);
        assert!(!determinant.is_zero(), "a box without a volume");
        let size = determinant.abs();
        let corners = (0..8).map(|corner| {
            std::array::from_fn(|k| {
                let mut x = &self.centre[k] * &determinant;
                for (i, edge) in edges.iter().enumerate() {
                    let way = &self.half[i] * &edge[k];
                    if corner >> i & 1 == 0 { x += way } else { x -= way }
                }
                if determinant.is_negative() { -x } else { x }
            })
        });
        (corners.collect(), size)
    }
}

fn flat(b: &Obb<f64>) -> [f64; 15] {
    let mut all = b.centre.into_iter().chain(b.axes.into_iter().flatten()).chain(b.half);
    std::array::from_fn(|_| all.next().unwrap())
}

fn two(a: &Obb<f64>, b: &Obb<f64>) -> (Exact, Exact) {
    let (a, b) = (flat(a), flat(b));
    let x: [f64; 31] = std::array::from_fn(|i| match i {
        0..15 => a[i],
        15..30 => b[i - 15],
        _ => 1.0,
    });
    let x = integers(x);
    (Exact::new(&x[..15], &x[30]), Exact::new(&x[15..30], &x[30]))
}

/// Whether a point is in a box.
pub fn holds(b: &Obb<f64>, p: [f64; 3]) -> bool {
    let b = flat(b);
    let x: [f64; 19] = std::array::from_fn(|i| match i {
        0..15 => b[i],
        15..18 => p[i - 15],
        _ => 1.0,
    });
    let x = integers(x);
    let p = std::array::from_fn(|k| x[15 + k].clone());
    Exact::new(&x[..15], &x[18]).holds(&p, &BigInt::from(1))
}

/// Whether all of `b` is in `a`.
pub fn holds_box(a: &Obb<f64>, b: &Obb<f64>) -> bool {
    let (a, b) = two(a, b);
    let (corners, size) = b.corners();
    corners.iter().all(|p| a.holds(p, &size))
}

/// Whether two boxes have no point in common.
pub fn disjoint(a: &Obb<f64>, b: &Obb<f64>) -> bool {
    let (a, b) = two(a, b);
    let ((p, p_size), (q, q_size)) = (a.corners(), b.corners());
    let mut directions: Vec<Vector> = a.axes.iter().chain(&b.axes).cloned().collect();
    for e in a.edges() {
        directions.extend(b.edges().iter().map(|f| cross(&e, f)));
    }
    directions.iter().any(|w| {
        let ends = |corners: &[Vector], other: &BigInt| {
            let x: Vec<BigInt> = corners.iter().map(|p| dot(w, p) * other).collect();
            (x.iter().min().unwrap().clone(), x.iter().max().unwrap().clone())
        };
        let ((p0, p1), (q0, q1)) = (ends(&p, &q_size), ends(&q, &p_size));
        p1 < q0 || q1 < p0
    })
}

/// The greatest difference of a scalar product of axes from that of orthonormal ones, in units of
/// roundoff of `T`.
pub fn skew<T: Real>(b: &Obb<T>) -> f64 {
    let b = flat(&widen(b));
    let x: [f64; 10] = std::array::from_fn(|i| if i < 9 { b[3 + i] } else { 1.0 });
    let x = integers(x);
    let one = &x[9] * &x[9];
    let mut worst = 0f64;
    for i in 0..3 {
        for j in 0..3 {
            let product: BigInt = (0..3).map(|k| &x[3 * i + k] * &x[3 * j + k]).sum();
            let off: BigInt = if i == j { product - &one } else { product };
            // In units of 2^-80.
            let parts = (off.abs() << 80usize) / &one;
            let parts: f64 = parts.to_string().parse().unwrap();
            worst = worst.max((parts + 1.0) * 0.5f64.powi(80) / T::UNIT.to_f64());
        }
    }
    worst
}

#[test]
fn known_boxes() {
    let turned = Obb {
        centre: [0.0; 3],
        axes: [[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0], [0.0, 0.0, 1.0]],
        half: [1.0, 0.5, 0.25],
    };
    // The squares of the doubles nearest to 0.6 and 0.8 add up to 1 + 4e-17, which rounds to 1.
    assert!(!holds(&turned, [0.6, 0.8, 0.25]));
    assert!(holds(&turned, [0.59, 0.79, 0.25]) && !holds(&turned, [0.61, 0.81, 0.25]));
    let at = |x: f64| Obb { centre: [x, 0.0, 0.0], ..turned };
    // The corner reaches 0.6 + 0.4 along x.
    assert!(disjoint(&turned, &at(2.5)) && !disjoint(&turned, &at(0.5)));
    assert!(holds_box(&Obb { half: [1.25; 3], ..turned }, &at(0.0625)));
    assert!(!holds_box(&Obb { half: [1.0, 0.5, 0.3], ..turned }, &at(0.0625)));
    // Closed: boxes along the coordinates that share a face.
    let cube = |x: f64| Obb {
        centre: [x, 0.0, 0.0],
        axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        half: [0.5; 3],
    };
    assert!(!disjoint(&cube(0.0), &cube(1.0)) && disjoint(&cube(0.0), &cube(1.0f64.next_up())));
}
