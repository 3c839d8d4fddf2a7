//! Pairs by every method are those of brute force.

use super::*;
use ccd_core::backend::layout::Pair;
use ccd_core::model::catalogue::{Catalogued, every};
use ccd_core::model::method::{Builder, Descent, Traversal, TreeOptions, Volume};
#[cfg(feature = "catalogue")]
use ccd_core::model::scheduling::{Scheduler, WorkerOptions};

/// Bounds at and beyond the greatest that a rounded box has, and ordinary ones.
const BOUNDS: [f32; 13] = [
    f32::NEG_INFINITY,
    f32::MIN,
    -3.2e38,
    -2.95e38,
    -2.9e38,
    -1.0,
    0.0,
    1.0,
    2.9e38,
    2.95e38,
    3.2e38,
    f32::MAX,
    f32::INFINITY,
];

/// Random numbers in [0, 1), the same on every machine.
pub(super) fn random(mut state: u32) -> impl FnMut() -> f32 {
    move || {
        state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        (state >> 8) as f32 / 16_777_216.0
    }
}

#[test]
fn the_table_says_which_methods_are_here() {
    for row in BroadPhaseMethod::ROWS {
        let here = row.backends.contains(&"cpu");
        assert_eq!(BroadPhase::new(1, row.value).is_ok(), here, "{}", row.name);
    }
    for method in every("cpu") {
        assert!(BroadPhase::new(1, method).is_ok(), "{method}");
    }
    assert!(every("cpu").count() >= 2);
}

/// Those, and trees with settings that are not in the table.
fn methods_and_settings() -> impl Iterator<Item = BroadPhaseMethod> {
    let settings = [
        Traversal::Simultaneous(Descent::Both),
        Traversal::Cut { nodes: 1, descent: Descent::Larger },
        Traversal::Cut { nodes: 7, descent: Descent::Both },
        Traversal::Cut { nodes: Traversal::MAX_CUT, descent: Descent::Both },
    ];
    let has = |method: &BroadPhaseMethod| method.lacking("cpu").is_none();
    let trees = Builder::ROWS.iter().flat_map(move |row| {
        let tree = TreeOptions::default().builder(row.value);
        settings.map(|traversal| BroadPhaseMethod::Tree(tree.traversal(traversal)))
    });
    every("cpu").chain(trees.filter(has))
}

/// Every method with its settings on one thread and on two, kept from one check to the next.
pub(super) struct Searches(Vec<(BroadPhaseMethod, [BroadPhase; 2])>);

impl Searches {
    fn new() -> Self {
        Self::by(methods_and_settings())
    }

    pub(super) fn by(methods: impl Iterator<Item = BroadPhaseMethod>) -> Self {
        let both = |method| [1, 2].map(|threads| BroadPhase::new(threads, method).unwrap());
        Self(methods.map(|method| (method, both(method))).collect())
    }

    /// Pairs by all methods are those of brute force, in the precision of the boxes; the number of
    /// visits does not depend on threads. Returns the numbers of pairs within `a` and between both.
    pub(super) fn check<T: Coordinate>(&mut self, a: &[Aabb<T>], b: &[Aabb<T>]) -> [usize; 2] {
        let pair = |i: usize, j: usize| Pair { a: i as u32, b: j as u32 };
        let (mut within, mut between) = (Vec::new(), Vec::new());
        for (i, x) in a.iter().enumerate() {
            within.extend((i + 1..a.len()).filter(|&j| x.overlaps(&a[j])).map(|j| pair(i, j)));
            between.extend((0..b.len()).filter(|&j| x.overlaps(&b[j])).map(|j| pair(i, j)));
        }
        for (method, broad_phases) in &mut self.0 {
            let visits = broad_phases.each_mut().map(|broad| {
                check_same(method, broad.self_pairs(a).unwrap(), &within, a, a);
                let visits = broad.visits();
                check_same(method, broad.pairs(a, b).unwrap(), &between, a, b);
                [visits, broad.visits()]
            });
            assert_eq!(visits[0], visits[1], "{method:?}: visits of {} boxes", a.len());
            let is_tree = matches!(method, BroadPhaseMethod::Tree(_));
            assert!(a.len() < 2 || (visits[0][0] > 0) == is_tree, "{method:?}: {visits:?} visits");
        }
        [within.len(), between.len()]
    }

    /// The same of boxes of which some overlap, and not all.
    fn check_some<T: Coordinate>(&mut self, a: &[Aabb<T>], b: &[Aabb<T>]) {
        let (n, [n_within, _]) = (a.len(), self.check(a, b));
        assert!(n_within > 0 && n_within < n * (n - 1) / 2, "all or none overlap");
    }
}

/// Fails with the first pair that is in one of two lists and not in the other.
fn check_same<T: Coordinate>(
    method: &BroadPhaseMethod,
    got: Pairs,
    want: &[Pair],
    a: &[Aabb<T>],
    b: &[Aabb<T>],
) {
    let mut got = got.to_vec();
    got.sort_unstable();
    let i = got.iter().zip(want).take_while(|(p, q)| p == q).count();
    let boxes = |p: &Pair| (*p, a[p.a as usize], b[p.b as usize]);
    let (found, right) = (got.get(i).map(boxes), want.get(i).map(boxes));
    let what = format!("{method:?}, {} against {} boxes", a.len(), b.len());
    assert!(found.is_none() && right.is_none(), "{what}: {found:?} instead of {right:?}");
}

#[test]
fn trees_of_any_depth_are_searched() {
    let at = |min: f32, max: f32| Aabb { min: [min, 0.25, 0.25], max: [max, 0.5, 0.5] };
    // One in another, and one behind another: each half as large as the one before, so that each
    // bit of a code parts one from the rest; in the end many have one code.
    let nested = |n: usize| Vec::from_iter((0..n as i32).map(|i| at(0.0, 0.5f32.powi(i % 140))));
    let apart = |n: usize| {
        let part = |i: i32| at(0.5f32.powi(i % 22 + 1) * 1.1, 0.5f32.powi(i % 22));
        Vec::from_iter((0..n as i32).map(part))
    };
    let equal = |n: usize| vec![at(0.25, 0.75); n];
    let mut searches = Searches::new();
    let mut n_pairs = 0;
    for n in [150, 0, 1, 2, 3] {
        for a in [nested(n), apart(n), equal(n)] {
            for m in [1, 60] {
                n_pairs += searches.check(&a, &nested(m))[0];
            }
            n_pairs += searches.check(&a, &equal(3))[0];
            n_pairs += searches.check(&a, &apart(40))[0];
        }
    }
    searches.check(&nested(150), &[]);
    assert!(n_pairs > 10_000, "{n_pairs} pairs show nothing");
}

#[test]
fn fewer_visits_find_the_same() {
    let mut unit = random(5);
    let mut one = || {
        let min = [unit(), unit(), unit()];
        Aabb { min, max: min.map(|c| c + 0.1) }
    };
    let boxes: Vec<_> = (0..2000).map(|_| one()).collect();
    let visits = |traversal: Traversal| {
        let tree = TreeOptions::default().traversal(traversal);
        let mut broad = BroadPhase::new(1, BroadPhaseMethod::Tree(tree)).unwrap();
        let n_pairs = broad.self_pairs(&boxes).unwrap().len();
        (n_pairs, broad.visits())
    };
    let [recursive, iterative, in_order, half, simultaneous, cut] = [
        Traversal::Recursive,
        Traversal::Iterative,
        Traversal::LeafOrder,
        Traversal::Half,
        Traversal::SIMULTANEOUS,
        Traversal::CUT,
    ]
    .map(visits);
    assert!(recursive == iterative && iterative == in_order, "{recursive:?} {iterative:?}");
    assert!(half.1 < in_order.1 * 2 / 3, "{half:?} of {in_order:?}");
    assert!(simultaneous.1 < half.1, "{simultaneous:?} of {half:?}");
    let all: [(usize, u64); 3] = [half, simultaneous, cut];
    assert!(all.iter().all(|of| of.0 == in_order.0), "{all:?}");
    // A method without a tree takes none, and a search in nothing forgets those of the one before.
    let mut broad = BroadPhase::new(1, BroadPhaseMethod::TREE).unwrap();
    broad.self_pairs(&boxes).unwrap();
    let before = broad.visits();
    broad.self_pairs::<f32>(&[]).unwrap();
    assert!(before > 0 && broad.visits() == 0);
}

/// Static lists give each worker some of the tasks, and nobody takes another's: so as many expand
/// pairs as there are, by option at most that number, and never more than threads.
#[test]
#[cfg(feature = "catalogue")]
fn workers_are_as_many_as_were_chosen() {
    let at = |i: u32| [i % 32, i / 32 % 32, i / 1024].map(|c| c as f32);
    let boxes: Vec<_> =
        (0..1 << 17).map(|i| Aabb { min: at(i), max: at(i).map(|c| c + 1.5) }).collect();
    let cut = BroadPhaseMethod::Tree(TreeOptions::default().traversal(Traversal::CUT));
    for method in [BroadPhaseMethod::Blocks, cut] {
        let mut n_pairs = None;
        for (chosen, want) in [(0, 4), (1, 1), (2, 2), (3, 3), (4, 4), (9, 4)] {
            let options = WorkerOptions::default().workers(chosen);
            let by = Scheduling::default().scheduler(Scheduler::Static).workers(options);
            let mut broad = BroadPhase::scheduled(4, method, by).unwrap();
            let n = broad.self_pairs(&boxes).unwrap().len();
            assert_eq!(*n_pairs.get_or_insert(n), n, "{method}, {chosen} workers");
            let Method::Scheduled(scheduled) = &broad.method else { panic!("no scheduler") };
            let visits = scheduled.visits_by_worker();
            let busy: Vec<bool> = visits.iter().map(|&n| n > 0).collect();
            assert_eq!(busy, [0, 1, 2, 3].map(|k| k < want), "{method}, {chosen}: {visits:?}");
        }
    }
}

#[test]
fn huge_and_infinite_bounds_are_compared_as_they_are() {
    let apart = [(2.95e38f32, 3.0e38), (3.2e38, 3.3e38), (0.0, 3.1e38)]
        .map(|(min, max)| Aabb { min: [min, 0.0, 0.0], max: [max, 1.0, 1.0] });
    let mut searches = Searches::new();
    searches.check_some(&apart, &apart);
    let mut x = 11u32;
    let mut bound = || {
        x = x.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        (x >> 16) as usize % BOUNDS.len()
    };
    for n in [3usize, 8, 40] {
        for _ in 0..20 {
            let mut side = || (bound(), bound());
            let mut one = || {
                let sides: [_; 3] = std::array::from_fn(|_| side());
                Aabb {
                    min: sides.map(|(p, q)| BOUNDS[p.min(q)]),
                    max: sides.map(|(p, q)| BOUNDS[p.max(q)]),
                }
            };
            // The first two are apart, the third and the fourth overlap.
            let endless = Aabb { min: [f32::NEG_INFINITY; 3], max: [f32::INFINITY; 3] };
            let mut boxes = vec![apart[0], apart[1], apart[2], apart[2], endless];
            boxes.extend((0..n).map(|_| one()));
            let others: Vec<_> = (0..n).map(|_| one()).collect();
            searches.check_some(&boxes, &others);
            let wide =
                |b: &Aabb<f32>| Aabb { min: b.min.map(f64::from), max: b.max.map(f64::from) };
            let far = |b: &Aabb<f32>| {
                let wide = wide(b);
                Aabb { min: wide.min.map(|x| x * 1e60), max: wide.max.map(|x| x * 1e60) }
            };
            for to_f64 in [&wide as &dyn Fn(&Aabb<f32>) -> Aabb<f64>, &far] {
                let all = |boxes: &[Aabb<f32>]| boxes.iter().map(to_f64).collect::<Vec<_>>();
                searches.check_some(&all(&boxes), &all(&others));
            }
        }
    }
}

/// A slanted strand of boxes against one that lies beside it, and in parts on it.
#[test]
fn oriented_boxes_spare_steps_where_things_are_slanted() {
    let at = |i: i32, offset: f32| {
        let x = i as f32 / 64.0;
        let min = [x + offset, x - offset, x + offset];
        Aabb { min, max: min.map(|c| c + 0.017) }
    };
    let strand = Vec::from_iter((0..1000).map(|i| at(i, 0.0)));
    let beside = Vec::from_iter((0..1000).map(|i| at(i, if i % 50 == 0 { 0.0 } else { 0.05 })));
    let traversals = [Traversal::Recursive, Traversal::Half, Traversal::SIMULTANEOUS];
    for traversal in traversals.into_iter().chain([Traversal::CUT]) {
        let [aabb, obb] = [Volume::Aabb, Volume::Obb].map(|volume| {
            let tree = TreeOptions::default().traversal(traversal).volume(volume);
            let mut broad = BroadPhase::new(1, BroadPhaseMethod::Tree(tree)).unwrap();
            let n_pairs = broad.pairs(&beside, &strand).unwrap().len();
            (n_pairs, broad.visits())
        });
        assert!(aabb.0 == obb.0 && aabb.0 > 50, "{traversal:?}: {aabb:?} {obb:?}");
        // The cut counts the pairs with which it begins.
        let most = if traversal == Traversal::CUT { aabb.1 } else { aabb.1 / 2 };
        assert!(obb.1 <= most, "{traversal:?}: {aabb:?} {obb:?}");
    }
}
