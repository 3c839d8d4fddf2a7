//! Builders of binary trees on a device, kernel by kernel: the trees of the CPU, and of
//! boxes that are hard for one of them.

use crate::builder_twin::{Built, figures, hard_boxes, in_cells, twins};
use crate::emulated::is_thin;
use crate::scenes::check_pairs;
use crate::support::{bytes, check_boxes, not_run, read, rounds_like_a_cpu, run, zeros};
use crate::twin::{Twin, union};
use ccd::Aabb;
use ccd::gpu::bind::{
    Branches, NumberLeaves, PairJoin, PairLeaves, PairNearest, PairSearch, PairSwap, PlocCount,
    PlocFinish, PlocJoin, PlocLeaves, PlocNearest, ScanRows, SplitBranches, SplitCount, SplitEmit,
    SplitLevels,
};
use ccd::gpu::wgpu::DeviceType;
use ccd::gpu::{BroadPhase, Device, Path, harness};
use ccd::method::{BroadPhaseMethod, Builder, Catalogued, Traversal, TreeOptions};
use ccd_core::backend::broad_phase::morton_key::shared_word;
use ccd_core::backend::broad_phase::nearest_pair::{GROUP, words};
use ccd_core::backend::broad_phase::ploc::{COUNTS, FEW, rounds};
use ccd_core::backend::kernel::prefix;
use ccd_core::backend::layout::{
    Blocks, Branch, Building, Cluster, Dispatch, LIST_HEADER, Params, SortPass,
};
use ccd_testkit::generate::uniform_boxes;
use ccd_testkit::{brute, compare};

pub const TESTS: crate::Tests = &[
    ("split_lists", check_split_lists),
    ("ploc", check_ploc),
    ("nearest_pair", check_nearest_pair),
    ("repeated_kernels", check_repeated),
    ("trees_of_the_cpu", check_trees_of_the_cpu),
    ("builders_and_hard_boxes", check_hard_boxes),
];

/// The bounds of all boxes as words.
fn bounds(twin: &Twin) -> Vec<u8> {
    let scene = union(twin.boxes.iter());
    let words: [u32; 8] = std::array::from_fn(|k| if k < 6 { shared_word(&scene, k) } else { 0 });
    bytes(&words)
}

fn params(twin: &Twin, dispatch: Dispatch, args: Building) -> Params<Building> {
    Params { frame: twin.frame, dispatch, args }
}

/// Numbers the nodes, and puts the leaves of a set in order.
fn number(device: &Device, twin: &Twin, set: usize, joins: Vec<u8>, sorted: u32) -> Built {
    let n = twin.frame.count[set];
    let args = Building { set: set as u32, sorted, ..Building::default() };
    let kernel = NumberLeaves {
        joins,
        order: bytes(&twin.order),
        ordered: zeros::<u32>(twin.order.len()),
        branches: zeros::<Branch>(n as usize - 1),
    };
    let p = params(twin, Dispatch::default(), args);
    let done = run(device, kernel, &p, n.div_ceil(256));
    let range = twin.frame.start[set] as usize..twin.frame.start[set + 1] as usize;
    (read::<u32>(&done.ordered)[range].to_vec(), read(&done.branches))
}

/// PLOC on a device, and how many clusters reached each round but those of the last kernel.
fn ploc(device: &Device, twin: &Twin, set: usize, radius: u32) -> (Built, Vec<u32>) {
    let n = twin.frame.count[set];
    let wide = rounds(n, FEW);
    let args = Building { set: set as u32, radius, rounds: wide, ..Building::default() };
    let p = |first: u32, n: u32| params(twin, Dispatch { n, first, ..Dispatch::default() }, args);
    let groups = n.div_ceil(256);
    let kernel = PlocLeaves {
        boxes: bytes(&twin.boxes),
        bounds: bounds(twin),
        order: bytes(&twin.order),
        clusters: zeros::<Cluster>(n as usize),
        names: zeros::<u32>(n as usize),
        counts: zeros::<u32>(COUNTS + prefix::words(n) as usize),
    };
    let PlocLeaves { clusters, names, mut counts, .. } = run(device, kernel, &p(0, 0), groups);
    let cells = in_cells(twin, set);
    let first = twin.frame.start[set];
    let order = &twin.order[first as usize..(first + n) as usize];
    let of_leaves: Vec<Aabb> = order.iter().map(|&i| cells[(i - first) as usize]).collect();
    let of_device: Vec<Aabb> = read::<Cluster>(&clusters).iter().map(Cluster::aabb).collect();
    if rounds_like_a_cpu(device) {
        check_boxes("leaf", &of_leaves, &of_device);
    }
    // Of an even number of rounds, of an odd one.
    let mut both = [(clusters.clone(), names.clone()), (clusters, names)];
    let mut joins = zeros::<[u32; 4]>(2 * n as usize - 1);
    for round in 0..wide {
        let [(clusters, names), (clusters_out, names_out)] =
            [round % 2, 1 - round % 2].map(|half| both[half as usize].clone());
        let neighbours = zeros::<u32>(n as usize);
        let kernel = PlocNearest { clusters: clusters.clone(), neighbours, counts };
        let done = run(device, kernel, &p(round, 0), groups);
        let kernel = PlocCount { neighbours: done.neighbours, counts: done.counts };
        let done = run(device, kernel, &p(round, 0), groups);
        let (neighbours, so_far) = (done.neighbours, done.counts);
        let kernel = PlocJoin {
            neighbours,
            clusters,
            names,
            clusters_out,
            names_out,
            counts: so_far,
            joins,
        };
        let done = run(device, kernel, &p(round, 0), groups);
        both[1 - round as usize % 2] = (done.clusters_out, done.names_out);
        (counts, joins) = (done.counts, done.joins);
    }
    let [(even_clusters, even_names), (odd_clusters, odd_names)] = both;
    let kernel = PlocFinish {
        counts: counts.clone(),
        even_clusters,
        even_names,
        odd_clusters,
        odd_names,
        joins,
    };
    let done = run(device, kernel, &p(0, rounds(n, 1)), 1);
    let reached = read::<u32>(&counts)[..COUNTS].iter().copied().take_while(|&n| n > 0).collect();
    (number(device, twin, set, done.joins, 1), reached)
}

/// Nearest pairs on a device: so many targets of each level by the whole device, then so many a
/// dispatch.
fn nearest_pair(device: &Device, twin: &Twin, set: usize, wide: u32, part: u32) -> Built {
    let mut n = twin.frame.count[set];
    let p = |n: u32, first: u32, rounds: u32, made: u32| {
        let args = Building { set: set as u32, rounds, made, ..Building::default() };
        params(twin, Dispatch { n, first, ..Dispatch::default() }, args)
    };
    let mut joins = zeros::<[u32; 4]>(2 * n as usize - 1);
    let kernel = PairLeaves {
        boxes: bytes(&twin.boxes),
        bounds: bounds(twin),
        clusters: zeros::<Cluster>(n as usize),
        items: zeros::<[u32; 4]>(n as usize),
    };
    let done = run(device, kernel, &p(n, 0, 0, 0), n.div_ceil(256));
    let (mut clusters, mut items, mut made) = (done.clusters, done.items, 0);
    while n > 1 {
        let wide = wide.min(n / 2);
        // What is behind the place of the target before does not matter.
        let mut found = bytes(&vec![0u32; words(n) as usize]);
        found[4..].fill(0x77);
        for target in 0..wide {
            let groups = (n - 2 * target - 1).div_ceil(GROUP);
            let p = p(n, 0, 0, 0);
            let done = run(device, PairSearch { items, found }, &p, groups);
            let (items_in, found_in) = (done.items, done.found);
            let done = run(device, PairSwap { items: items_in, found: found_in }, &p, 1);
            (items, found) = (done.items, done.found);
            assert_eq!(read::<u32>(&found)[0], 2 * target + 2);
        }
        for target in (wide..n / 2).step_by(part as usize) {
            let p = p(n, 2 * target, part.min(n / 2 - target), 0);
            items = run(device, PairNearest { items }, &p, 1).items;
        }
        let (clusters_out, items_out) = (clusters.clone(), items.clone());
        let kernel = PairJoin { clusters, items, clusters_out, items_out, joins };
        let done = run(device, kernel, &p(n, 0, 0, made), n.div_ceil(512));
        (clusters, items, joins) = (done.clusters_out, done.items_out, done.joins);
        (made, n) = (made + n / 2, n.div_ceil(2));
    }
    number(device, twin, set, joins, 0)
}

/// Branches of the sorted codes, every node by itself.
fn branches_of_codes(device: &Device, twin: &Twin, set: usize) -> Vec<Branch> {
    let n = twin.frame.count[set];
    let keys = bytes(&sorted_keys(twin));
    let kernel = Branches { keys, branches: zeros::<Branch>(n as usize - 1) };
    let args = Blocks { kind: set as u32, ..twin.tree };
    let p = Params { frame: twin.frame, dispatch: Dispatch::default(), args };
    read(&run(device, kernel, &p, n.div_ceil(256)).branches)
}

fn sorted_keys(twin: &Twin) -> Vec<u32> {
    twin.order.iter().map(|&i| twin.keys[i as usize]).collect()
}

/// Branches from split lists of this capacity, and how many entries they want.
fn split_lists(device: &Device, twin: &Twin, set: usize, capacity: u32) -> (Vec<Branch>, u32) {
    let n = twin.frame.count[set] - 1;
    let (groups, places) = (n.div_ceil(256), n as usize);
    let args = Building { set: set as u32, ..Building::default() };
    let p = params(twin, Dispatch { capacity_out: capacity, ..Dispatch::default() }, args);
    let keys = bytes(&sorted_keys(twin));
    let kernel = SplitLevels { keys, levels: zeros::<u32>(places), present: vec![0; 16] };
    let SplitLevels { keys, levels, present } = run(device, kernel, &p, groups);
    // What is in the table before does not matter.
    let table = bytes(&vec![77u32; 256 * (groups as usize + 1)]);
    let done = run(device, SplitCount { levels, present, table }, &p, groups);
    let args = SortPass { shift: 0, n_tiles: groups };
    let scan = Params { frame: twin.frame, dispatch: Dispatch::default(), args };
    let table = run(device, ScanRows { table: done.table }, &scan, 256).table;
    let (levels, present) = (done.levels, done.present);
    let list = vec![0; 4 * (LIST_HEADER + capacity as usize)];
    let entries = zeros::<u32>(places);
    let kernel = SplitEmit { levels, present, table, entries, list };
    let SplitEmit { levels, present, table, entries, list } = run(device, kernel, &p, groups);
    let header: Vec<u32> = read(&list);
    assert_eq!(header[1..LIST_HEADER], [0; 3]);
    let branches = zeros::<Branch>(places);
    let kernel = SplitBranches { keys, levels, present, table, entries, list, branches };
    (read(&run(device, kernel, &p, groups).branches), header[0])
}

/// Every leaf once, children split the range of their parent and have the numbers that say so.
pub fn check_well_formed(what: &str, twin: &Twin, set: usize, (order, branches): &Built) {
    let n_internal = branches.len() as u32;
    let mut leaves = order.clone();
    leaves.sort_unstable();
    assert!(leaves.into_iter().eq(twin.frame.start[set]..twin.frame.start[set + 1]), "{what}");
    let range = |node: u32| match branches.get(node as usize) {
        Some(branch) => (branch.first, branch.last),
        None => (node - n_internal, node - n_internal),
    };
    let (mut stack, mut seen) = (vec![0u32], 0);
    while let Some(node) = stack.pop() {
        let Some(branch) = branches.get(node as usize) else { continue };
        let (left, right) = (range(branch.left), range(branch.right));
        let (first, last) = range(node);
        assert_eq!((left.0, left.1 + 1, right.1), (first, right.0, last), "{what}: node {node}");
        let numbered = |child: u32, want: u32| child >= n_internal || child == want;
        assert!(numbered(branch.left, left.1) && numbered(branch.right, right.0), "{what}: {node}");
        stack.extend([branch.left, branch.right]);
        seen += 1;
    }
    assert_eq!(seen, n_internal, "{what}: nodes");
}

/// Figures of a tree over set 1, of which that is all, are those of the CPU's tree; the device must
/// round like a CPU.
fn check_figures(what: &str, twin: &Twin, builder: Builder, got: &Built) {
    let method = BroadPhaseMethod::Tree(TreeOptions::default().builder(builder));
    let mut cpu = ccd::BroadPhase::new(1, method).unwrap();
    cpu.self_pairs(&twin.boxes).unwrap();
    let want = cpu.tree_statistics().unwrap();
    let (depth, cost) = figures(twin, got);
    assert_eq!(depth, want.depth, "{builder:?} of {what}");
    // Of points on a line no node has a surface.
    let error = (cost - want.sah_cost).abs();
    let fine = cost.is_nan() || error <= 1e-6 * want.sah_cost;
    assert!(fine, "{builder:?} of {what}: {cost}, {}", want.sah_cost);
}

fn check_split_lists(device: &Device) {
    for (what, twin, set) in twins() {
        let want = branches_of_codes(device, &twin, set);
        let (branches, n_entries) = split_lists(device, &twin, set, 20_000);
        assert!(branches == want, "{what}: other branches than by themselves");
        let order = &twin.order[twin.frame.start[set] as usize..];
        check_well_formed(&what, &twin, set, &(order.to_vec(), branches));
        let least = want.len() as u32;
        assert!((least..4 * least + 64).contains(&n_entries), "{what}: {n_entries} entries");
        // A list that is too short by one says so, and tells nothing.
        let (branches, n_wanted) = split_lists(device, &twin, set, n_entries - 1);
        assert!(branches == want && n_wanted == n_entries, "{what}: a short list");
    }
}

/// Trees of hard boxes are well formed; `check_trees_of_the_cpu` says that they are the right ones.
fn check_ploc(device: &Device) {
    for (what, twin, set) in twins() {
        for radius in [1, 16, 128] {
            let (got, reached) = ploc(device, &twin, set, radius);
            check_well_formed(&format!("{what}, radius {radius}"), &twin, set, &got);
            // Every round joins some.
            assert_eq!(reached[0], twin.frame.count[set], "{what}");
            assert!(reached.is_sorted_by(|a, b| a > b), "{what}: {reached:?} clusters by round");
        }
    }
    // The comparison sees another tree, and the check one that is none.
    let (_, twin, set) = twins().next().unwrap();
    let [(got, _), (other, _)] = [16, 1].map(|radius| ploc(device, &twin, set, radius));
    assert!(other.1 != got.1, "radii make no difference");
    for change in [|b: &mut Built| b.0[3] = b.0[4], |b: &mut Built| b.1.swap(3, 4)] {
        let mut wrong = got.clone();
        change(&mut wrong);
        let check = std::panic::AssertUnwindSafe(|| check_well_formed("", &twin, set, &wrong));
        assert!(compare::fails(check), "a tree that is none passes");
    }
}

/// The trees of the CPU, however many targets a dispatch has, and whoever looks for the nearest.
fn check_nearest_pair(device: &Device) {
    for (what, twin, set) in twins() {
        let all = [(0, 100), (0, 1000), (4, 1000)];
        let [got, other, of_device] =
            all.map(|(wide, part)| nearest_pair(device, &twin, set, wide, part));
        check_well_formed(&what, &twin, set, &got);
        assert!(got == other, "{what}: parts make a difference");
        check_well_formed(&what, &twin, set, &of_device);
        // Elsewhere two kernels may be contracted in different ways.
        let info = device.info();
        if info.path == Path::Passthrough || info.adapter.device_type == DeviceType::Cpu {
            assert!(got == of_device, "{what}: the whole device finds others");
        }
        if set == 1 && twin.boxes[0] != twin.boxes[1] && rounds_like_a_cpu(device) {
            check_figures(&what, &twin, Builder::NEAREST_PAIR, &got);
        }
    }
}

/// A kernel that is recorded once runs as often as was asked for, each time on what it has left.
fn check_repeated(device: &Device) {
    for times in [0, 1, 2, 7] {
        let items: Vec<[u32; 4]> = (0..40).map(|i| [i; 4]).collect();
        // The nearest node is always at place 20.
        let mut kernel = PairSwap { items: bytes(&items), found: bytes(&[0u32, 0, 20]) };
        let args = Building::default();
        let dispatch = Dispatch { n: 40, ..Dispatch::default() };
        let p = Params { frame: Default::default(), dispatch, args };
        harness::repeat(device, &mut kernel, &p, 1, 65_535, times).unwrap();
        let (mut want, mut place) = (items, 0);
        for _ in 0..times {
            want.swap(place + 1, 20);
            place += 2;
        }
        assert_eq!(read::<u32>(&kernel.found)[0] as usize, place, "{times} times");
        assert_eq!(read::<[u32; 4]>(&kernel.items), want, "{times} times");
    }
}

/// Where no two boxes have the code of 30 bits in common, they are in the order of a CPU, which
/// sorts by 63: then the trees are those of the CPU.
fn check_trees_of_the_cpu(device: &Device) {
    if !rounds_like_a_cpu(device) {
        return not_run("the device does not round like a CPU, so its trees may be others");
    }
    let all: Vec<Aabb> = uniform_boxes(1500).iter().map(|b| b.inflated(0.003)).collect();
    for boxes in [&all[..], &all[..257], &all[..256], &all[..3], &all[..2]] {
        let twin = Twin::new([&[], boxes, &[]], |_, i| [i; 3]);
        assert!(sorted_keys(&twin).windows(2).all(|w| w[0] < w[1]), "a code comes twice");
        for radius in [1, 3, 16, 128] {
            let (got, _) = ploc(device, &twin, 1, radius);
            let what = format!("{} boxes", boxes.len());
            check_figures(&what, &twin, Builder::Ploc { radius }, &got);
        }
        let nearest = nearest_pair(device, &twin, 1, 20, 400);
        check_figures("uniform boxes", &twin, Builder::NEAREST_PAIR, &nearest);
    }
}

/// Pairs of whole calls are those of brute force, of any builder, on hard boxes, few and none.
fn check_hard_boxes(device: &Device) {
    let loose: Vec<Aabb> = uniform_boxes(70).iter().map(|b| b.inflated(0.1)).collect();
    let mut sets = hard_boxes();
    sets.extend([("one", loose[..1].to_vec()), ("none", Vec::new())]);
    for builder in Builder::ROWS.iter().map(|row| row.value) {
        let all = [Traversal::Half, Traversal::CUT];
        for &traversal in if is_thin(device) { &all[..1] } else { &all } {
            let options = TreeOptions::default().builder(builder).traversal(traversal);
            let mut broad = BroadPhase::new(device, BroadPhaseMethod::Tree(options)).unwrap();
            for (name, boxes) in &sets {
                let what = format!("{options:?}, {name}");
                let want = brute::self_pairs(boxes);
                // Levels of so many pairs of nodes take an emulated device minutes.
                if traversal == Traversal::CUT && want.len() > 20_000 {
                    continue;
                }
                check_pairs(&what, want, broad.self_pairs(boxes).unwrap());
                let want = brute::pairs(&loose, boxes);
                check_pairs(&what, want, broad.pairs(&loose, boxes).unwrap());
            }
        }
    }
    let limit =
        BroadPhaseMethod::Tree(TreeOptions::default().builder(Builder::NearestPair { limit: 100 }));
    let mut broad = BroadPhase::new(device, limit).unwrap();
    let refused = broad.self_pairs(&uniform_boxes(101)).unwrap_err().to_string();
    assert!(refused.contains("nearest-pair") && refused.contains("100"), "{refused}");
    assert!(broad.self_pairs(&uniform_boxes(100)).is_ok());
}
