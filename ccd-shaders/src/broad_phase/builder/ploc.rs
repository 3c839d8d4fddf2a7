//! Clusters along the Morton curve, joined in rounds with their nearest neighbours; see
//! `ccd_core::backend::broad_phase::ploc`. A round is three dispatches, until so few are left that
//! one workgroup does all further rounds in one.

use crate::entry::kernel;
use crate::records::{BoxWords, ClusterWords, box_at, cluster_at, put_join, put_root};
use crate::workgroup::{add, add_shared, barrier, get, or_shared, set};
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::morton_key::merged;
use ccd_core::backend::broad_phase::ploc::{
    COUNTS, FEW, Fate, Nearest, fate, fate_beside, is_late, neighbour, window,
};
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::kernel::prefix::{TILE, group_word, tile_word, tiles};
use ccd_core::backend::kernel::sort::before;
use ccd_core::backend::layout::{Building, Cluster, Params};
use ccd_core::math::morton::MortonGrid;

/// Clusters of the round of a dispatch; 0 if they are few, which the last dispatch joins.
#[inline(always)]
fn clusters_of(params: &Params<Building>, counts: &[u32]) -> u32 {
    let n = at(counts, params.dispatch.first as usize);
    if n > FEW { n } else { 0 }
}

kernel! {
    /// Thread `i` makes leaf `i` along the curve a cluster.
    ploc_leaves[256](t; params: Building;; boxes: [BoxWords], bounds: [u32], order: [u32],
        mut clusters: [ClusterWords], mut names: [u32], mut counts: [u32]) {
        let i = t.i;
        let tree = params.args.set as usize;
        let n_leaves = params.frame.count[tree];
        if i < n_leaves {
            let grid = MortonGrid::new(&merged(bounds), 10);
            let of_box = at(order, (params.frame.start[tree] + i) as usize);
            let aabb = grid.in_cells(&box_at(boxes, of_box as usize));
            put(clusters, i as usize, ClusterWords::of(&Cluster::new(&aabb, n_leaves - 1 + i, 1)));
            put(names, i as usize, i);
        }
        if i == 0 {
            put(counts, 0, n_leaves);
        }
    }
}

kernel! {
    /// Thread `i` finds the nearest neighbour of cluster `i`; the first thread of a group of tiles
    /// makes its sum zero.
    ploc_nearest[256](t; params: Building; near: [Aabb; 512]; clusters: [ClusterWords],
        mut neighbours: [u32], mut counts: [u32]) {
        let tile = t.group;
        let (n_clusters, radius) = (clusters_of(params, counts), params.args.radius);
        let i = tile * TILE + t.lane;
        // Entry `k` of `near` is the box of cluster `tile TILE - radius + k`.
        for half in 0..2 {
            let k = half * TILE + t.lane;
            let from = tile * TILE + k;
            let mut aabb = Aabb::EMPTY;
            if from >= radius && from - radius < n_clusters && k < TILE + 2 * radius {
                aabb = cluster_at(clusters, from - radius).aabb();
            }
            set(near, k, aabb);
        }
        barrier();
        if i < n_clusters {
            let n_leaves = params.frame.count[params.args.set as usize];
            let mut best = neighbour(i, n_clusters);
            if !is_late(params.dispatch.first, n_clusters, n_leaves) {
                let aabb = get(near, radius + t.lane);
                let range = window(i, n_clusters, radius);
                let mut nearest = Nearest::none(i);
                for j in range[0]..range[1] {
                    nearest.look(i, j, &aabb, &get(near, j + radius - tile * TILE));
                }
                best = nearest.best;
            }
            put(neighbours, i as usize, best);
            if t.lane == 0 && tile % TILE == 0 {
                put(counts, COUNTS + group_word(tile), 0);
            }
        }
    }
}

kernel! {
    /// A workgroup counts the clusters of its tile that are left after the round.
    ploc_count[256](t; params: Building; left: [u32; 2]; neighbours: [u32], mut counts: [u32]) {
        let tile = t.group;
        let n_clusters = clusters_of(params, counts);
        let i = tile * TILE + t.lane;
        if t.lane == 0 {
            set(left, 0, 0);
        }
        barrier();
        if i < n_clusters && fate(i, neighbours) != Fate::Ends {
            add_shared(left, 0, 1);
        }
        barrier();
        if t.lane == 0 && i < n_clusters {
            let n_leaves = params.frame.count[params.args.set as usize];
            put(counts, COUNTS + tile_word(tile, n_leaves), get(left, 0));
            add(counts, COUNTS + group_word(tile), get(left, 0));
        }
    }
}

/// A sum, 0 if it is not wanted.
#[inline(always)]
fn count_of(counts: &[u32], is_wanted: bool, i: usize) -> u32 {
    if is_wanted { at(counts, COUNTS + i) } else { 0 }
}

kernel! {
    /// Thread `i` joins cluster `i` with its neighbour if it is to take that in, and moves what is
    /// left of both to its place in the next round.
    ploc_join[256](t; params: Building; sums: [u32; 2], masks: [u32; 8]; neighbours: [u32],
        clusters: [ClusterWords], names: [u32], mut clusters_out: [ClusterWords],
        mut names_out: [u32], mut counts: [u32], mut joins: [u32]) {
        let tile = t.group;
        let n_clusters = clusters_of(params, counts);
        let n_leaves = params.frame.count[params.args.set as usize];
        let i = tile * TILE + t.lane;
        if t.lane < 2 {
            set(sums, t.lane, 0);
        }
        if t.lane < TILE / 32 {
            set(masks, t.lane, 0);
        }
        barrier();
        // What is left of earlier tiles, and of all.
        let n_tiles = tiles(n_clusters);
        let n_groups = tiles(n_tiles);
        let of_group = tile / TILE * TILE + t.lane;
        let is_earlier = of_group < tile && of_group < n_tiles;
        let of_tiles = count_of(counts, is_earlier, tile_word(of_group, n_leaves));
        let (mut earlier, mut later) = (0, 0);
        for round in 0..tiles(n_groups) {
            let k = round * TILE + t.lane;
            let sum = count_of(counts, k < n_groups, k as usize);
            earlier += if k < tile / TILE { sum } else { 0 };
            later += if k < tile / TILE { 0 } else { sum };
        }
        // Sums, because naga refuses what a loop leaves as the operand of an atomic.
        add_shared(sums, 0, earlier + of_tiles);
        add_shared(sums, 1, earlier + later);
        let active = i < n_clusters;
        // A thread without a cluster looks at the first one.
        let cluster = if active { i } else { 0 };
        let j = at(neighbours, cluster as usize);
        let fate = fate_beside(cluster, j, at(neighbours, j as usize));
        let is_left = active && fate != Fate::Ends;
        if is_left {
            or_shared(masks, t.lane / 32, 1 << (t.lane % 32));
        }
        barrier();
        if is_left {
            let mut to = get(sums, 0) + before(get(masks, t.lane / 32), t.lane);
            for word in 0..t.lane / 32 {
                to += get(masks, word).count_ones();
            }
            let mut cluster = cluster_at(clusters, i);
            if fate == Fate::Joins {
                let other = cluster_at(clusters, j);
                let node = at(names, j as usize) - 1;
                let (children, leaves) =
                    ([cluster.node, other.node], [cluster.leaves, other.leaves]);
                put_join(joins, node, children, leaves);
                let both = cluster.aabb().union(&other.aabb());
                cluster = Cluster::new(&both, node, leaves[0] + leaves[1]);
            }
            put(clusters_out, to as usize, ClusterWords::of(&cluster));
            put(names_out, to as usize, at(names, i as usize));
        }
        if i == 0 && n_clusters > 0 {
            put(counts, params.dispatch.first as usize + 1, get(sums, 1));
        }
    }
}

kernel! {
    /// One workgroup does all rounds that are left when there are as few clusters as it has
    /// threads. Those are where the last round with any has left them: of an even number of rounds,
    /// or of an odd one. `args.rounds`: rounds that have had dispatches; `dispatch.n`: all that
    /// there may be.
    ploc_finish[256](t; params: Building; boxes: [Aabb; 256], nodes: [u32; 256], leaves: [u32; 256],
        names: [u32; 256], neighbours: [u32; 256], masks: [u32; 8]; counts: [u32],
        even_clusters: [ClusterWords], even_names: [u32], odd_clusters: [ClusterWords],
        odd_names: [u32], mut joins: [u32]) {
        let n_leaves = params.frame.count[params.args.set as usize];
        let mut done = 0;
        for round in 0..params.args.rounds {
            if at(counts, round as usize + 1) > 0 {
                done = round + 1;
            }
        }
        let mut n = at(counts, done as usize).min(FEW);
        if t.lane < n {
            let is_odd = done % 2 == 1;
            let cluster = if is_odd {
                cluster_at(odd_clusters, t.lane)
            } else {
                cluster_at(even_clusters, t.lane)
            };
            let name = if is_odd {
                at(odd_names, t.lane as usize)
            } else {
                at(even_names, t.lane as usize)
            };
            set(boxes, t.lane, cluster.aabb());
            set(nodes, t.lane, cluster.node);
            set(leaves, t.lane, cluster.leaves);
            set(names, t.lane, name);
        }
        barrier();
        for round in 0..params.dispatch.n {
            let active = t.lane < n;
            let mut j = t.lane;
            if active {
                j = neighbour(t.lane, n);
                if !is_late(done + round, n, n_leaves) {
                    let aabb = get(boxes, t.lane);
                    let range = window(t.lane, n, params.args.radius);
                    let mut nearest = Nearest::none(t.lane);
                    for k in range[0]..range[1] {
                        nearest.look(t.lane, k, &aabb, &get(boxes, k));
                    }
                    j = nearest.best;
                }
                set(neighbours, t.lane, j);
            }
            if t.lane < TILE / 32 {
                set(masks, t.lane, 0);
            }
            barrier();
            let mut is_left = false;
            let mut aabb = Aabb::EMPTY;
            let (mut node, mut below, mut name) = (0, 0, 0);
            if active {
                let fate = fate_beside(t.lane, j, get(neighbours, j));
                is_left = fate != Fate::Ends;
                aabb = get(boxes, t.lane);
                node = get(nodes, t.lane);
                below = get(leaves, t.lane);
                name = get(names, t.lane);
                if fate == Fate::Joins {
                    let parent = get(names, j) - 1;
                    let of_both = [below, get(leaves, j)];
                    put_join(joins, parent, [node, get(nodes, j)], of_both);
                    aabb = aabb.union(&get(boxes, j));
                    node = parent;
                    below = of_both[0] + of_both[1];
                }
            }
            if is_left {
                or_shared(masks, t.lane / 32, 1 << (t.lane % 32));
            }
            barrier();
            let (mut to, mut left) = (before(get(masks, t.lane / 32), t.lane), 0);
            for word in 0..TILE / 32 {
                let ones = get(masks, word).count_ones();
                left += ones;
                if word < t.lane / 32 {
                    to += ones;
                }
            }
            if is_left {
                set(boxes, to, aabb);
                set(nodes, to, node);
                set(leaves, to, below);
                set(names, to, name);
            }
            n = left;
            barrier();
        }
        if t.lane == 0 {
            put_root(joins, get(nodes, 0));
        }
    }
}
