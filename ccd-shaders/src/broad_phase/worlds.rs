//! Boxes of many worlds: bounds and keys of each, and pairs of nodes that have a world in common.

use super::block_pairs::{HITS, KEPT, clear, gather, reserve, rounds, team_pair};
use crate::records::{BoxWords, box_at};
use crate::workgroup::{add_shared, append, barrier, get, group, length, raise, set, write_pair};
use ccd_core::Aabb;
use ccd_core::broad_phase::block_bvh::{self, POOL, THREADS, WIDTH, pack, sets, unpack};
use ccd_core::broad_phase::morton_key;
use ccd_core::broad_phase::worlds::{self, BOUND_WORDS, meet, range};
use ccd_core::kernel::Id;
use ccd_core::kernel::memory::{at, put};
use ccd_core::layout::{Blocks, Pair, Params, Worlds};
use ccd_core::math::morton::MortonGrid;
use spirv_std::glam::UVec3;
use spirv_std::spirv;

const MAP_THREADS: u32 = Id::WorldKeys.threads();
/// Hits of the pool that a thread works on, at most.
const SHARE: u32 = POOL / THREADS;

/// Thread `i` merges `CHUNK` of the first `dispatch.n` boxes, those that follow each other in one
/// world at once, into six words a world, zero before.
#[spirv(compute(threads(256)))]
pub fn world_bounds(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<Worlds>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] boxes: &[BoxWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] worlds: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] words: &mut [u32],
) {
    let first = (group(id, n) * MAP_THREADS + lane) * morton_key::CHUNK as u32;
    let mut merged = Aabb::EMPTY;
    for k in 0..morton_key::CHUNK as u32 {
        let i = first + k;
        if i < params.dispatch.n {
            let world = at(worlds, i as usize);
            merged = merged.union(&box_at(boxes, i as usize));
            let mut is_last = k + 1 == morton_key::CHUNK as u32 || i + 1 == params.dispatch.n;
            if !is_last {
                is_last = at(worlds, i as usize + 1) != world;
            }
            if is_last {
                for axis in 0..BOUND_WORDS {
                    let word = morton_key::shared_word(&merged, axis);
                    raise(words, BOUND_WORDS * world as usize + axis, word);
                }
                merged = Aabb::EMPTY;
            }
        }
    }
}

/// Thread `i` writes the sort key of box `i`, and `i`.
#[spirv(compute(threads(256)))]
pub fn world_keys(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<Worlds>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] boxes: &[BoxWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] worlds: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] keys: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] order: &mut [u32],
) {
    let i = group(id, n) * MAP_THREADS + lane;
    if i < params.frame.start[3] {
        let set = block_bvh::set_of(&params.frame.start, i);
        let world = at(worlds, i as usize);
        let grid = MortonGrid::new(&worlds::bounds(words, world), 10);
        let key = worlds::sort_key(i as usize, set, world, params.own.bits, boxes, &grid);
        put(keys, i as usize, key);
        put(order, i as usize, i);
    }
}

/// As `node_pairs`, of nodes that have a world in common. `worlds`: of the leaves of level 0.
#[spirv(compute(threads(128)))]
pub fn node_pairs_of_worlds(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] columns: &mut [Aabb; 128],
    #[spirv(workgroup)] names: &mut [u32; 128],
    #[spirv(workgroup)] ranges: &mut [u32; 128],
    #[spirv(workgroup)] counters: &mut [u32; 8],
    #[spirv(workgroup)] hits: &mut [u32; 2048],
    #[spirv(workgroup)] firsts: &mut [u32; 8],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<Blocks>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &[BoxWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] worlds: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] input: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] output: &mut [u32],
) {
    let (own, groups) = (group(id, n), n.x * n.y);
    let there = length(input, params.dispatch.room_in);
    let (team, i) = (lane / WIDTH, lane % WIDTH);
    let [set_a, set_b] = sets(params.own.kind);
    let (n_a, n_b) = (params.frame.count[set_a], params.frame.count[set_b]);
    let level = params.own.level - 1;
    for round in 0..rounds(params, there, own, groups) {
        let (pair, some) = team_pair(params, input, there, own, groups, round, team);
        clear(lane, counters);
        if i == 0 {
            set(firsts, 2 * team, pair.a * WIDTH);
            set(firsts, 2 * team + 1, pair.b * WIDTH);
        }
        let of_row = range(&params.own, level, set_a, pair.a * WIDTH + i, n_a, worlds);
        let of_column = range(&params.own, level, set_b, pair.b * WIDTH + i, n_b, worlds);
        set(ranges, lane, of_column);
        let row = gather(lane, params, pair, some, nodes, columns, names, counters);
        let same = params.own.kind == 1 && pair.a == pair.b;
        for c in 0..get(counters, team) {
            let j = get(names, team * WIDTH + c);
            let is_once = !same || i <= j;
            if row.overlaps(&get(columns, team * WIDTH + c))
                && is_once
                && meet(of_row, get(ranges, team * WIDTH + j))
            {
                let to = add_shared(counters, HITS, 1);
                if to < POOL {
                    set(hits, to, pack(team, i, j));
                } else {
                    let beyond = Pair { a: pair.a * WIDTH + i, b: pair.b * WIDTH + j };
                    append(output, params.dispatch.room_out, beyond);
                }
            }
        }
        barrier();
        let n_hits = get(counters, HITS).min(POOL);
        if lane == 0 {
            set(counters, KEPT, n_hits);
        }
        let base = reserve(lane, counters, output);
        for s in 0..SHARE {
            let h = lane + s * THREADS;
            if h >= n_hits {
                break;
            }
            let [t, i, j] = unpack(get(hits, h));
            let pair = Pair { a: get(firsts, 2 * t) + i, b: get(firsts, 2 * t + 1) + j };
            write_pair(output, params.dispatch.room_out, base + h, pair);
        }
        barrier();
    }
}
