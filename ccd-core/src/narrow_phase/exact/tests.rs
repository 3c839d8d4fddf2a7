//! Exact answers beside those of integers alone; moments, denormal times, windows.

use super::*;
use crate::random::Random;

const WHOLE: [f64; 2] = [0.0, 1.0];

/// What `f64` certifies to the last bit is what integers say.
#[test]
fn certified_contacts_are_those_of_integers() {
    let mut random = Random::new(17);
    let mut refined = 0;
    for i in 0..6000 {
        let scale = 2f64.powi(random.below(60) as i32 - 30);
        let mut four = || {
            [(); 4].map(|()| {
                [(); 3].map(|()| {
                    let x = (random.unit() + random.unit() / (1 << 24) as f64 - 0.5) * scale;
                    if i % 2 == 0 { x as f32 as f64 } else { x }
                })
            })
        };
        let (t0, t1) = (four(), four());
        let patch = if i % 4 < 2 { Patch::Triangle } else { Patch::Parallelogram };
        let window = [WHOLE, [0.1, 0.9]][i % 3 / 2];
        let found = of_patch(patch, [&t0, &t1], window);
        let want = by_integers::<Longest>(patch, [&t0, &t1], window);
        assert_eq!(found, want, "{patch:?} {window:?}: {t0:?} {t1:?}");
        if let Some(Exact::Contact([lo, hi])) = found {
            // Its geometry is there from its time on, and before the next; elsewhere there is none.
            let has_geometry = |t: f64| geometry::meeting(patch, [&t0, &t1], t).is_some();
            assert!(has_geometry(lo) && !has_geometry(hi), "{patch:?} {lo}: {t0:?} {t1:?}");
            assert!(lo == window[0] || !has_geometry(lo.next_down()), "{patch:?}: {t0:?} {t1:?}");
        }
        refined += matches!(found, Some(Exact::Contact([lo, _])) if lo > window[0]) as usize;
    }
    assert!(refined > 500, "{refined}");
}

/// Of features at rest on a lattice.
#[test]
fn a_moment_is_the_beginning() {
    let mut random = Random::new(19);
    let mut touching = 0;
    for i in 0..4000 {
        let scale = [1.0, 0.1, 1e-30, 3e200][i % 4];
        let x = [(); 4].map(|()| [(); 3].map(|()| random.below(3) as f64 * scale));
        for patch in [Patch::Triangle, Patch::Parallelogram] {
            let found = moment::touch(patch, &x);
            let want =
                by_integers::<Longest>(patch, [&x, &x], WHOLE).map(|found| found != Exact::Miss);
            assert_eq!(found, want, "{patch:?} {x:?}");
            touching += found.unwrap() as usize;
        }
    }
    assert!(touching > 500, "{touching}");
}

/// A face that rises onto a vertex which is next to it: the least times that there are.
#[test]
fn times_may_be_denormal() {
    let least = f64::from_bits(1);
    let at =
        |y: f64, vertex: f64| [[0.25, vertex, 0.25], [0.0, y, 0.0], [1.0, y, 0.0], [0.0, y, 1.0]];
    let query = |vertex: f64, to: f64| {
        let (t0, t1) = (at(0.0, vertex), at(to, vertex));
        vertex_face(&VertexFace { t0, t1 }, WHOLE)
    };
    for height in [least, 3.0 * least, f64::MIN_POSITIVE, 2f64.powi(-1000), 2f64.powi(-970)] {
        assert_eq!(query(height, 1.0), Some(Exact::Contact([height; 2])));
        // A third of the height, and of a denormal that is rounded.
        let Some(Exact::Contact([lo, hi])) = query(height, 3.0) else { panic!("{height:e}") };
        let third = height / 3.0;
        assert!(lo <= third && third <= hi && hi == lo.next_up() || third * 3.0 == height);
        assert!(hi <= lo.next_up(), "{height:e}: {lo:e} to {hi:e}");
    }
    assert_eq!(query(3.0 * least, 3.0), Some(Exact::Contact([least; 2])));
    assert_eq!(query(4.0 * least, 3.0), Some(Exact::Contact([least, 2.0 * least])));
}

/// Times that are numbers, in windows of which they are no dyadic part.
#[test]
fn times_that_are_numbers_are_found_in_any_window() {
    let at = |y: f64| [[0.25, y, 0.25], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    let query = VertexFace { t0: at(1.0), t1: at(-1.0) };
    for window in [WHOLE, [0.1, 0.9], [0.3, 0.7], [0.5, 0.9], [0.1, 0.5], [0.5; 2]] {
        assert_eq!(vertex_face(&query, window), Some(Exact::Contact([0.5; 2])), "{window:?}");
        let found = by_integers::<[u64; 8]>(Patch::Triangle, [&query.t0, &query.t1], window);
        assert_eq!(found, Some(Exact::Contact([0.5; 2])), "{window:?}");
    }
}

/// A window begins at a tiny time, and does not make the numbers longer.
#[test]
fn windows_of_any_length_are_decided() {
    let t0 = [[1.0, -2.0, 2.0], [1.0, 0.0, -1.0], [-1.0, 2.0, 0.0], [-2.0, 0.0, -1.0]];
    let t1 = [[-2.0, -1.0, 1.0], [0.0, -2.0, 1.0], [1.0, -1.0, 2.0], [2.0, -2.0, 1.0]];
    let want = edge_edge(&EdgeEdge { t0, t1 }, [0.0, 0.7]);
    assert!(want.is_some());
    for from in [1e-30, 1e-60, 1e-200, f64::from_bits(1)] {
        assert_eq!(edge_edge(&EdgeEdge { t0, t1 }, [from, 0.7]), want, "{from:e}");
    }
    let t0 = [[-1.0, 1e-20, 0.0], [0.0; 3], [1e-20, -1.0, 0.0], [0.0, 0.0, 1.0]];
    let t1 = [[1.0, 1e-20, 0.0], [0.0; 3], [1e-20, 1.0, 0.0], [0.0, 1.0, -1.3]];
    let found = vertex_face(&VertexFace { t0, t1 }, [1e-30, 1.0]);
    assert_eq!(found, vertex_face(&VertexFace { t0, t1 }, WHOLE));
    assert!(matches!(found, Some(Exact::Contact([0.5, _]))), "{found:?}");
}

/// Flat ground, but for what rounding has left on one axis: each axis has its own unit.
#[test]
fn axes_of_unlike_sizes_are_decided() {
    for rest in [1e-17, 1e-300, f64::from_bits(1)] {
        let t0 = [[0.2, 0.1, rest], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let t1 = [[0.6, 0.4, -rest], [0.1, 0.0, 0.0], [1.3, 0.7, 0.0], [0.3, 1.0, 0.0]];
        let found = vertex_face(&VertexFace { t0, t1 }, WHOLE);
        assert_eq!(found, Some(Exact::Contact([0.5; 2])), "{rest:e}");
    }
}

/// Of a window whose times do not fit no sign is read: with fewer words it is none.
#[test]
fn windows_that_do_not_fit_are_none() {
    let least = f64::from_bits(1);
    for window in [[0.0, least], [least, 1.0], [least, least], [0.0, 2f64.powi(-600)]] {
        assert!(Window::<[u64; 8]>::new(window).is_none(), "{window:?}");
        assert!(Window::<[u64; 24]>::new(window).is_some(), "{window:?}");
    }
}

/// Two contacts between a time and the next `f64`: the geometry is that of the first.
#[test]
fn the_first_of_two_contacts_that_are_close_counts() {
    let p = |e: i32| 2f64.powi(e);
    let face = |z: f64| [[0.0; 3], [1.0, 0.0, z], [0.0, 1.0, 0.0]];
    let query = |vertices: [[f64; 3]; 2], z: [f64; 2]| {
        let of = |k: usize| {
            let [a, b, c] = face(z[k]);
            [vertices[k], a, b, c]
        };
        [of(0), of(1)]
    };
    // At 1/2 - 2^-55 from above, and at 1/2 from below.
    let far = [-(p(49) - 0.25), p(49) + 0.25];
    let vertices = [[far[0], 0.25, 1.75 * p(-54)], [far[1], 0.25, -1.75 * p(-54)]];
    let [t0, t1] = query(vertices, [p(-51), -p(-51)]);
    let Some(Exact::Contact([toi, _])) = vertex_face(&VertexFace { t0, t1 }, WHOLE) else {
        panic!("no contact")
    };
    assert_eq!(toi, 0.5 - p(-54));
    let meeting = geometry::meeting(Patch::Triangle, [&t0, &t1], toi).expect("geometry");
    assert_eq!(meeting.weights, [1.0, 0.53125, 0.21875, 0.25]);
    assert!(meeting.normal.expect("a normal")[2] > 0.9, "{meeting:?}");
    let vertices = [[-0.25, 0.25, 0.125 - p(-56)], [0.75, 0.25, -0.125 + p(-56)]];
    let [t0, t1] = query(vertices, [0.5, -0.5]);
    let Some(Exact::Contact([toi, _])) = vertex_face(&VertexFace { t0, t1 }, WHOLE) else {
        panic!("no contact")
    };
    let meeting = geometry::meeting(Patch::Triangle, [&t0, &t1], toi).expect("geometry");
    assert!(meeting.normal.expect("a normal")[2] > 0.0, "{meeting:?}");
}

/// Of a contact at the beginning with one tiny coordinate at the end.
#[test]
fn geometry_at_the_beginning_needs_no_times() {
    let tiny = f64::from_bits(0x03b8_f2b0_61ae_a072);
    assert!(tiny > 0.0 && tiny < 1e-280);
    let t0 = [[-28.0, 0.0, 6.0], [-72.0, 0.0, 48.0], [-24.0, 0.0, -48.0], [72.0, 0.0, 36.0]];
    let t1 = [[-25.0, 2.0, 7.0], [-72.0, 0.0, 47.0], [-25.0, 2.0, -49.0], [74.0, -1.0, tiny]];
    let meeting = geometry::meeting(Patch::Triangle, [&t0, &t1], 0.0).expect("geometry");
    assert_eq!(meeting.weights, [1.0, 5.0 / 12.0, 5.0 / 12.0, 1.0 / 6.0]);
}

/// Times of zeros in order, equal ones of different forms too.
#[test]
fn times_have_an_order() {
    let window = zeros::Window::<[u64; 24]>::new(WHOLE).expect("a window");
    let number = |x: i64| integer::Integer::<[u64; 24]>::new(x, 0);
    let third = form::Form::linear([number(-1), number(2)]);
    let half = form::Form::linear([number(-1), number(1)]);
    let other = form::Form::linear([number(-3), number(5)]);
    let thirds = third.times(&other);
    let time = |form: &form::Form<[u64; 24]>| {
        let [first, ..] = zeros::zeros(form, &window).expect("zeros");
        first.expect("one")
    };
    let mut of = zeros::zeros(&thirds, &window).expect("zeros");
    let [Some(a), Some(b), None] = &mut of else { panic!("two zeros") };
    if b.is_before(a).expect("an order") {
        std::mem::swap(a, b);
    }
    // 1/3 and 3/8 of one form, 1/3 of another, and 1/2.
    let (mut again, mut middle) = (time(&third), time(&half));
    assert!(!a.is_before(&mut again).unwrap() && !again.is_before(a).unwrap());
    assert!(again.is_before(b).unwrap() && !b.is_before(&mut again).unwrap());
    assert!(b.is_before(&mut middle).unwrap() && !middle.is_before(b).unwrap());
    assert!(a.is_before(b).unwrap() && !middle.is_before(&mut time(&half)).unwrap());
}

/// Numbers far apart where a cubic has a double zero: `28 W` bits are enough.
#[test]
fn a_zero_beside_a_double_one_is_short() {
    for k in [100, 153, 170, 200] {
        let e = 2f64.powi(-k);
        let (f, g) = ([3.0 * e; 3], [5.0 * e; 3]);
        let t0 = [[1.0, 1.0, 0.25], f, [f[0], 1.0, f[2]], [f[0], f[1], 1.0]];
        let t1 = [[-1.0, -1.0, -0.75], g, [g[0], -3.0, g[2]], [g[0], g[1], -3.0]];
        // As in a core without a heap.
        let found = by_integers::<[u64; 96]>(Patch::Triangle, [&t0, &t1], WHOLE);
        assert_eq!(found, of_patch(Patch::Triangle, [&t0, &t1], WHOLE));
        let Some(Exact::Contact([lo, hi])) = found else { panic!("2^-{k}: {found:?}") };
        assert!(lo < 0.5 && 0.5 <= hi && hi - lo < 1e-15, "2^-{k}: {lo:?} {hi:?}");
    }
}

#[test]
fn a_form_has_its_values_over_a_part() {
    let mut random = Random::new(23);
    let number = |x: i64| Integer::<[u64; 24]>::new(x, 0);
    for i in 0..400 {
        let mut linear = || Form::linear([(); 2].map(|()| number(random.bits() as i32 as i64)));
        let form = (0..i % 4).fold(linear(), |form, _| form.times(&linear()));
        let [from, to] = [(); 2].map(|()| {
            let v = random.below(1 << 20) as i64;
            [number((1 << 20) - v), number(v)]
        });
        let [x, y] = [random.below(100), random.below(100)].map(|x| number(x as i64));
        let there = [0, 1].map(|k| &from[k] * &x + &to[k] * &y);
        let difference = form.over(&from, &to).at(&[x, y]) - form.at(&there);
        assert!(difference.is_exact() && difference.sign() == 0, "{form:?} {from:?} {to:?}");
    }
}
