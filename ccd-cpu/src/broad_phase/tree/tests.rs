//! Trees of every builder are well formed, the same on any number of threads, no deeper than their
//! builder says; and whatever reads a tree takes any depth.

use super::binary_tree::BinaryTree;
use super::builder::bottom_up::{Joins, Subtree};
use super::*;
use crate::broad_phase::leaf_boxes::Set;
use crate::broad_phase::tests::random;
use ccd_core::backend::broad_phase::ploc;
use ccd_core::backend::broad_phase::radix_tree::MAX_DEPTH;
use ccd_core::backend::broad_phase::stack_traversal::NONE;
use ccd_core::math::obb::Obb;
use ccd_core::model::catalogue::Catalogued;
use ccd_core::model::method::{BroadPhaseMethod, Builder, TreeOptions, Volume};

/// Sets of `n` boxes that are hard for some builder.
fn sets(n: usize) -> Vec<(&'static str, Vec<Aabb<f32>>)> {
    let mut unit = random(5);
    let points = |p: &mut dyn FnMut(usize) -> [f32; 3]| {
        (0..n).map(|i| Aabb::of_point(p(i))).collect::<Vec<_>>()
    };
    let around = |size: &dyn Fn(usize) -> f32| {
        (0..n).map(|i| Aabb { min: [-size(i); 3], max: [size(i); 3] }).collect::<Vec<_>>()
    };
    let doubled = |n: usize, p: &mut dyn FnMut() -> f32| {
        let one: Vec<_> = (0..n.div_ceil(2)).map(|_| [p(), p(), p()]).collect();
        (0..n).map(|i| Aabb::of_point(one[i / 2])).collect::<Vec<_>>()
    };
    vec![
        ("random", points(&mut |_| [unit(), unit(), unit()])),
        ("each twice", doubled(n, &mut unit)),
        ("a bit each", points(&mut |i| [0.5f32.powi(i as i32 % 21), 0.0, 0.0])),
        ("equal", points(&mut |_| [1.0; 3])),
        ("on a line", points(&mut |i| [i as f32, 0.0, 0.0])),
        ("inside of each other", around(&|i| (1e-20 * 1.02f64.powi(i as i32)) as f32)),
        ("around each other", around(&|i| (1e20 * 0.98f64.powi(i as i32)) as f32)),
        ("huge", points(&mut |_| [unit(), unit(), unit()].map(|x| (2.0 * x - 1.0) * 2.9e38))),
        ("tiny", points(&mut |_| [unit(), unit(), unit()].map(|x| x * 1e-37))),
    ]
}

/// Children split the range of their parent and have the numbers that say so, boxes are exactly
/// those of the boxes and of both children, every box is one leaf, no way down has more than
/// `max_depth` nodes.
fn check_well_formed(
    tree: &BinaryTree,
    order: &[u32],
    boxes: &[Aabb<f32>],
    max_depth: usize,
) -> Result<(), String> {
    let require = |holds: bool, what: &str, node: u32| {
        if holds { Ok(()) } else { Err(format!("{what} of node {node}")) }
    };
    let n_internal = boxes.len() - 1;
    let mut seen = vec![false; boxes.len()];
    let range = |node: u32| match tree.branches.get(node as usize) {
        Some(branch) => (branch.first, branch.last),
        None => (node - n_internal as u32, node - n_internal as u32),
    };
    let boxed = |node: u32| tree.nodes()[node as usize].aabb();
    let numbered = |node: u32, want: u32| node >= n_internal as u32 || node == want;
    let mut stack = vec![(0u32, 1usize)];
    while let Some((node, depth)) = stack.pop() {
        require(depth <= max_depth, "depth", node)?;
        let (first, last) = range(node);
        match tree.branches.get(node as usize) {
            Some(branch) => {
                let (left, right) = (range(branch.left), range(branch.right));
                let fit = (left.0, left.1 + 1, right.1) == (first, right.0, last);
                require(fit, "children", node)?;
                let numbers = numbered(branch.left, left.1) && numbered(branch.right, right.0);
                require(numbers, "numbers of the children", node)?;
                let both = boxed(branch.left).union(&boxed(branch.right));
                require(boxed(node) == both, "box", node)?;
                stack.extend([(branch.left, depth + 1), (branch.right, depth + 1)]);
            }
            None => {
                require(tree.nodes()[node as usize].is_leaf(), "kind", node)?;
                require(tree.nodes()[node as usize].left == first, "place", node)?;
                let id = order[first as usize] as usize;
                require(boxed(node) == boxes[id], "box", node)?;
                require(!std::mem::replace(&mut seen[id], true), "uniqueness", node)?;
            }
        }
    }
    require(seen.iter().all(|&s| s), "completeness", 0)
}

/// All corners of a box are in an oriented one.
fn check_holds(oriented: &Obb, b: &Aabb<f32>) {
    for k in 0..3 {
        let axis = oriented.axes[k].map(f64::from);
        let farthest = (0..8).map(|corner| {
            let along = |i: usize| {
                let x = [b.min[i], b.max[i]][corner >> i & 1];
                axis[i] * (x as f64 - oriented.centre[i] as f64)
            };
            (along(0) + along(1) + along(2)).abs()
        });
        let farthest = farthest.fold(0.0, f64::max);
        assert!(farthest <= oriented.half[k] as f64, "{b:?} is not in {oriented:?}");
    }
}

#[test]
fn oriented_boxes_hold_all_leaves_below() {
    for n in [2, 3, 300] {
        for (_, mut boxes) in sets(n) {
            for n_threads in [1, 2] {
                let options = TreeOptions::default().volume(Volume::Obb);
                let mut source = TreeSource::new(options).unwrap();
                let mut leaves = LeafBoxes::new(Set { index: 0, searched: true });
                let threads = Threads::new(n_threads).unwrap();
                threads.enter(|| leaves.build(&threads, &mut source, &boxes, Marks::default()));
                for _ in 0..2 {
                    let tree = source.tree(0);
                    assert_eq!(tree.oriented().len(), n - 1);
                    for (node, oriented) in tree.oriented().iter().enumerate() {
                        for leaf in tree.range(node as u32) {
                            check_holds(oriented, &boxes[leaves.order()[leaf as usize] as usize]);
                        }
                    }
                    boxes.iter_mut().for_each(|b| b.max[1] += 0.25);
                    threads.enter(|| leaves.refit(&threads, &mut source, &boxes));
                }
            }
        }
    }
}

/// What the pages of the builders say.
fn max_depth(builder: Builder, n: usize) -> usize {
    match builder {
        Builder::NearestPair { .. } => n.next_power_of_two().ilog2() as usize + 1,
        Builder::Ploc { .. } => ploc::rounds(n as u32, 1) as usize + 1,
        _ => MAX_DEPTH,
    }
}

/// A tree and the order of its leaves.
fn built(builder: Builder, n_threads: usize, boxes: &[Aabb<f32>]) -> (TreeSource, LeafBoxes) {
    let mut source = TreeSource::new(TreeOptions::default().builder(builder)).unwrap();
    let mut leaves = LeafBoxes::new(Set { index: 0, searched: true });
    let threads = Threads::new(n_threads).unwrap();
    threads.enter(|| leaves.build(&threads, &mut source, boxes, Marks::default()));
    (source, leaves)
}

fn builders() -> impl Iterator<Item = Builder> {
    let here = Builder::ROWS.iter().filter(|row| row.backends.contains(&"cpu"));
    here.map(|row| row.value).chain([Builder::Ploc { radius: 1 }, Builder::Ploc { radius: 128 }])
}

#[test]
fn trees_of_every_builder_are_well_formed() {
    let mut unit = random(7);
    for n in [2, 3, 10, 1000, 5000] {
        for (name, boxes) in sets(n) {
            for builder in builders() {
                let deepest = max_depth(builder, n);
                let trees = [1, 2].map(|n_threads| {
                    let what = format!("{builder:?}, {n} boxes {name}, {n_threads} threads");
                    let (mut source, mut leaves) = built(builder, n_threads, &boxes);
                    let check = |source: &TreeSource, leaves: &LeafBoxes, boxes: &[Aabb<f32>]| {
                        check_well_formed(source.tree(0), leaves.order(), boxes, deepest)
                            .unwrap_or_else(|e| panic!("{what}: {e}"))
                    };
                    check(&source, &leaves, &boxes);
                    let mut moved = boxes.clone();
                    moved.iter_mut().for_each(|b| b.max[1] += unit());
                    let threads = Threads::new(n_threads).unwrap();
                    threads.enter(|| leaves.refit(&threads, &mut source, &moved));
                    check(&source, &leaves, &moved);
                    (source.tree(0).branches.clone(), leaves.order().to_vec())
                });
                assert!(trees[0] == trees[1], "{builder:?}, {n} boxes {name}: threads matter");
            }
        }
    }
}

#[test]
fn split_lists_give_the_tree_of_karras() {
    for n in [0, 1, 2, 3, 10, 5000, 20_000] {
        for (name, boxes) in sets(n) {
            let [a, b] = [Builder::Lbvh, Builder::SplitLists].map(|b| built(b, 2, &boxes));
            assert_eq!(a.1.order(), b.1.order(), "{n} boxes {name}");
            assert!(a.0.tree(0).branches == b.0.tree(0).branches, "{n} boxes {name}");
        }
    }
}

#[test]
fn a_check_sees_what_is_wrong() {
    let (_, boxes) = &sets(100)[0];
    let change = |change: &dyn Fn(&mut BinaryTree)| {
        let (mut source, leaves) = built(Builder::PLOC, 1, boxes);
        change(&mut source.trees[0]);
        check_well_formed(&source.trees[0], leaves.order(), boxes, 100)
    };
    assert_eq!(change(&|_| ()), Ok(()));
    assert!(change(&|tree| tree.branches[0].left = tree.branches[0].right).is_err());
    assert!(change(&|tree| tree.branches[7].first ^= 1).is_err());
    assert!(change(&|tree| tree.branches.swap(3, 4)).is_err());
    let (source, leaves) = built(Builder::PLOC, 1, boxes);
    let mut order = leaves.order().to_vec();
    order[3] = order[4];
    assert!(check_well_formed(source.tree(0), &order, boxes, 100).is_err());
    assert!(check_well_formed(source.tree(0), leaves.order(), boxes, 5).is_err());
}

#[test]
fn a_search_for_the_nearest_may_be_shared() {
    // So many that two threads share the first searches.
    let (_, boxes) = sets(18_000).remove(0);
    let [a, b] = [1, 2].map(|n_threads| built(Builder::NEAREST_PAIR, n_threads, &boxes));
    assert!(a.1.order() == b.1.order() && a.0.tree(0).branches == b.0.tree(0).branches);
}

#[test]
fn figures_are_there_after_a_call() {
    let (_, boxes) = sets(1000).remove(0);
    for method in ccd_core::model::catalogue::every("cpu") {
        let mut broad = crate::BroadPhase::new(1, method).unwrap();
        assert_eq!(broad.tree_statistics(), None, "{method}");
        broad.self_pairs(&boxes).unwrap();
        let figures = broad.tree_statistics();
        assert_eq!(figures.is_some(), matches!(method, BroadPhaseMethod::Tree(_)), "{method}");
        let Some(figures) = figures else { continue };
        assert_eq!(figures.nodes, 1999, "{method}");
        broad.pairs(&boxes[..10], &boxes[10..]).unwrap();
        assert_eq!(broad.tree_statistics().unwrap().nodes, 1979, "{method}");
    }
}

#[test]
fn nearest_pairs_are_refused_above_their_limit() {
    let (_, boxes) = sets(100).remove(0);
    let build = |limit: u32| {
        let builder = Builder::NearestPair { limit };
        let method = BroadPhaseMethod::Tree(TreeOptions::default().builder(builder));
        let mut broad = crate::BroadPhase::new(1, method).unwrap();
        broad.self_pairs(&boxes).map(|pairs| pairs.len())
    };
    assert_eq!(build(100), Ok(0));
    match build(99) {
        Err(Error::TooMany { count: 100, limit: 99, .. }) => (),
        other => panic!("{other:?}"),
    }
}

/// A tree of a joined chain of `n` leaves, as deep as there are leaves; `to_left`: on which side
/// the long part is.
fn chain(
    n: usize,
    threads: &Threads,
    to_left: &(dyn Fn(usize) -> bool + Sync),
) -> (BinaryTree, Vec<u32>) {
    let mut joins = Joins::default();
    joins.begin(n);
    let mut all: Subtree = joins.leaf(0);
    for i in 1..n {
        let (a, b) = if to_left(i) { (all, joins.leaf(i)) } else { (joins.leaf(i), all) };
        all = joins.join(i as u32 - 1, a, b);
    }
    let (mut tree, mut order) = (BinaryTree::default(), Vec::new());
    let root = n as u32 - 2;
    joins.finish(threads, root, |i| i as u32, &mut order, &mut tree.branches);
    tree.link(threads, n);
    (tree, order)
}

/// An order of leaves that was made elsewhere.
#[derive(Debug)]
struct Given(Vec<u32>);

impl Order for Given {
    fn sort(&mut self, _: &Threads, _: Set, _: &[Aabb<f32>], _: &Marks, order: &mut Vec<u32>) {
        order.clone_from(&self.0);
    }
}

/// A tree that is a chain of `n` leaves, and what reads it.
fn check_chain(n: usize, to_left: &(dyn Fn(usize) -> bool + Sync), boxes: &[Aabb<f32>]) {
    let threads = Threads::new(1).unwrap();
    let (mut tree, order) = chain(n, &threads, to_left);
    let mut leaves = LeafBoxes::new(Set { index: 0, searched: true });
    leaves.build(&threads, &mut Given(order.clone()), boxes, Marks::default());
    tree.fit(&threads, &leaves);
    check_well_formed(&tree, &order, boxes, n).unwrap();
    let figures = statistics(&tree, &threads, &leaves);
    assert_eq!((figures.nodes, figures.depth), (2 * n - 1, n));
    for leaf in [0, 1, n / 2, n - 1] {
        let (query, mut found) = (leaves.get(leaf), Vec::new());
        tree.query(&query, NONE, &mut found);
        found.sort_unstable();
        let all = (0..n as u32).filter(|&i| leaves.get(i as usize).overlaps(&query));
        assert!(found.iter().copied().eq(all), "query {leaf}");
    }
}

#[test]
fn trees_may_be_as_deep_as_they_have_leaves() {
    let n = 5000;
    let sides: [&(dyn Fn(usize) -> bool + Sync); 3] = [&|_| true, &|_| false, &|i| i % 3 == 0];
    let check = move || {
        let sets = sets(n).into_iter();
        for (_, boxes) in
            sets.filter(|(name, _)| ["on a line", "inside of each other"].contains(name))
        {
            sides.iter().for_each(|to_left| check_chain(n, to_left, &boxes));
        }
    };
    // In a thread whose own stack would not hold a call for every level.
    std::thread::Builder::new().stack_size(1 << 18).spawn(check).unwrap().join().unwrap();
}

#[test]
fn figures_of_a_tree_are_those_of_its_definition() {
    // Four boxes on a line, of which the middle ones touch: nodes 0 (0..=3), 1 (0..=1), 2 (2..=3).
    let at = |x: f32| Aabb { min: [x, 0.0, 0.0], max: [x + 1.0, 1.0, 1.0] };
    let boxes = [at(0.0), at(3.0), at(4.0), at(7.0)];
    let (source, leaves) = built(Builder::Lbvh, 1, &boxes);
    let threads = Threads::new(1).unwrap();
    let figures = statistics(source.tree(0), &threads, &leaves);
    // Half surfaces: a box of length x has 1 + 2 x. All: 17; inner nodes: 9 each; leaves: 3 each.
    let want = TreeStatistics {
        nodes: 7,
        depth: 3,
        sah_cost: (17.0 + 2.0 * 9.0 + 4.0 * 3.0) / 17.0,
        // The root, and one child each for the outer boxes, both for those in the middle.
        visited_per_query: (2.0 + 3.0 + 3.0 + 2.0) / 4.0,
    };
    assert_eq!(figures, want);
    for (n, nodes, depth) in [(0, 0, 0), (1, 1, 1)] {
        let (source, leaves) = built(Builder::PLOC, 1, &boxes[..n]);
        let figures = statistics(source.tree(0), &threads, &leaves);
        assert_eq!((figures.nodes, figures.depth), (nodes, depth));
        assert!(figures.sah_cost == n as f64 && figures.visited_per_query == 0.0);
    }
}
