//! Nodes paired bottom up, each with the nearest one that is free, sought by the whole device or,
//! among few, by one workgroup; see `ccd_core::backend::broad_phase::nearest_pair`.

use crate::entry::kernel;
use crate::records::{BoxWords, ClusterWords, box_at, cluster_at, put_join, put_root};
use crate::workgroup::{barrier, get, lower_shared, set};
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::morton_key::merged;
use ccd_core::backend::broad_phase::nearest_pair::{
    FAR, Found, beginning, centre, distance, nearer, parents,
};
use ccd_core::backend::kernel::Id;
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::layout::Cluster;
use ccd_core::math::morton::MortonGrid;
use spirv_std::glam::UVec4;

const THREADS: u32 = Id::PairNearest.threads();

/// Entries of `shared`: the target, what was after it, what comes there.
const TARGET: u32 = 0;
const NEXT: u32 = 1;
const PARTNER: u32 = 2;

/// The centre of a box and the number of its node in the level.
#[inline(always)]
fn item(b: &Aabb, i: u32) -> UVec4 {
    let c = centre(b);
    UVec4::new(c[0].to_bits(), c[1].to_bits(), c[2].to_bits(), i)
}

#[inline(always)]
fn centre_of(item: UVec4) -> [f32; 3] {
    [f32::from_bits(item.x), f32::from_bits(item.y), f32::from_bits(item.z)]
}

kernel! {
    /// Thread `i` makes box `i` of set `args.set` a node of the lowest level.
    pair_leaves[256](t; params: Building;; boxes: [BoxWords], bounds: [u32],
        mut clusters: [ClusterWords], mut items: [UVec4]) {
        let i = t.i;
        let tree = params.args.set as usize;
        let n_leaves = params.frame.count[tree];
        if i < n_leaves {
            let grid = MortonGrid::new(&merged(bounds), 10);
            let aabb = grid.in_cells(&box_at(boxes, (params.frame.start[tree] + i) as usize));
            let cluster = Cluster::new(&aabb, n_leaves - 1 + i, 1);
            put(clusters, i as usize, ClusterWords::of(&cluster));
            put(items, i as usize, item(&aabb, i));
        }
    }
}

/// Entries of `found` of a search by the whole device: the place of the target, then the least
/// distance of each workgroup, and where.
const PLACE: usize = 0;

#[inline(always)]
fn word_of(group: u32) -> usize {
    (1 + 2 * group) as usize
}

/// Leaves the nearest of what the threads of a workgroup found in `least`, which the first of them
/// has cleared before a barrier.
macro_rules! least_of {
    ($best:ident, $least:ident) => {
        // Numbers that are not negative have the order of their bits.
        lower_shared($least, 0, $best.0.to_bits());
        barrier();
        if $best.0.to_bits() == get($least, 0) {
            lower_shared($least, 1, $best.1);
        }
        barrier();
    };
}

#[inline(always)]
fn clear<const N: usize>(least: &mut [u32; N]) {
    set(least, 0, FAR.to_bits());
    set(least, 1, u32::MAX);
}

kernel! {
    /// Thread `i` looks how far node `i` after the target is, of a level of `dispatch.n`; each
    /// workgroup writes the nearest of its own.
    pair_search[256](t; params: Building; least: [u32; 2]; items: [UVec4], mut found: [u32]) {
        let target = at(found, PLACE);
        if t.lane == 0 {
            clear(least);
        }
        barrier();
        let mut best = beginning(target + 1);
        let i = target + 1 + t.i;
        if i < params.dispatch.n {
            let centre = centre_of(at(items, target as usize));
            best = nearer(best, (distance(centre, centre_of(at(items, i as usize))), i));
        }
        least_of!(best, least);
        if t.lane == 0 {
            put(found, word_of(t.group), get(least, 0));
            put(found, word_of(t.group) + 1, get(least, 1));
        }
    }
}

kernel! {
    /// One workgroup finds the nearest of those: it changes places with the node after the target,
    /// and the one after that is the next target.
    pair_swap[256](t; params: Building; least: [u32; 3]; mut items: [UVec4], mut found: [u32]) {
        if t.lane == 0 {
            clear(least);
            // This thread alone reads the word, which it changes below: a barrier orders workgroup
            // memory only.
            set(least, 2, at(found, PLACE) + 1);
        }
        barrier();
        let next = get(least, 2);
        let n_groups = (params.dispatch.n - next).div_ceil(THREADS);
        let mut best = beginning(next);
        for k in 0..n_groups.div_ceil(THREADS) {
            let group = k * THREADS + t.lane;
            if group < n_groups {
                let word = word_of(group);
                let of_group: Found = (f32::from_bits(at(found, word)), at(found, word + 1));
                best = nearer(best, of_group);
            }
        }
        least_of!(best, least);
        if t.lane == 0 {
            let partner = get(least, 1) as usize;
            let (before, nearest) = (at(items, next as usize), at(items, partner));
            put(items, partner, before);
            put(items, next as usize, nearest);
            put(found, PLACE, next + 1);
        }
    }
}

kernel! {
    /// One workgroup pairs `args.rounds` targets of a level of `dispatch.n` nodes, from the target
    /// at place `dispatch.first` on: each with the nearest of those after it, which comes to the
    /// place after the target. Only the thread of a place reads or writes it.
    pair_nearest[256](t; params: Building; shared: [UVec4; 4], found: [u32; 2];
        mut items: [UVec4]) {
        let n = params.dispatch.n;
        for round in 0..params.args.rounds {
            let target = params.dispatch.first + 2 * round;
            let next = target + 1;
            if t.lane == target % THREADS {
                set(shared, TARGET, at(items, target as usize));
            }
            if t.lane == 0 {
                clear(found);
            }
            barrier();
            let centre = centre_of(get(shared, TARGET));
            let mut best = beginning(next);
            // The first place of this thread after the target.
            let first = next + (t.lane + THREADS - next % THREADS) % THREADS;
            if first < n {
                for k in 0..(n - first).div_ceil(THREADS) {
                    let i = first + k * THREADS;
                    best = nearer(best, (distance(centre, centre_of(at(items, i as usize))), i));
                }
            }
            least_of!(best, found);
            let partner = get(found, 1);
            let (is_next, is_partner) = (t.lane == next % THREADS, t.lane == partner % THREADS);
            if is_next {
                set(shared, NEXT, at(items, next as usize));
            }
            if is_partner {
                set(shared, PARTNER, at(items, partner as usize));
            }
            barrier();
            if is_next {
                put(items, next as usize, get(shared, PARTNER));
            }
            if is_partner && partner != next {
                put(items, partner as usize, get(shared, NEXT));
            }
        }
    }
}

kernel! {
    /// Thread `i` makes node `i` of the level above a level of `dispatch.n` nodes, which lie in
    /// pairs; a last one without a partner goes there as it is. The only node of a level is the
    /// root.
    pair_join[256](t; params: Building;; clusters: [ClusterWords], items: [UVec4],
        mut clusters_out: [ClusterWords], mut items_out: [UVec4], mut joins: [u32]) {
        let i = t.i;
        let below = params.dispatch.n;
        let n_parents = parents(below as usize) as u32;
        if i < n_parents {
            let a = cluster_at(clusters, at(items, 2 * i as usize).w);
            let mut node = a;
            if 2 * i + 1 < below {
                let b = cluster_at(clusters, at(items, 2 * i as usize + 1).w);
                let made = params.args.made + i;
                put_join(joins, made, [a.node, b.node], [a.leaves, b.leaves]);
                node = Cluster::new(&a.aabb().union(&b.aabb()), made, a.leaves + b.leaves);
            }
            put(clusters_out, i as usize, ClusterWords::of(&node));
            put(items_out, i as usize, item(&node.aabb(), i));
            if n_parents == 1 {
                put_root(joins, node.node);
            }
        }
    }
}
