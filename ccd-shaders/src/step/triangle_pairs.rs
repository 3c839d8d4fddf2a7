//! Pairs of triangles to pairs of features: boxes of triangles, pairs that their boxes make, tests
//! of neighbours; features go to one list a kind, appended by the workgroup.

use crate::entry::kernel;
use crate::workgroup::{add_shared, barrier, count, get, part, read_pair, set, write_pair};
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::swept_box;
use ccd_core::backend::kernel::Id;
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::layout::{NearTest, Pair, Triangle};
use ccd_core::backend::triangle_pairs::feature_pairs::{
    COUNT_STRIDE, Expanded, N_COUNTS, N_VERTEX_FACE, expand, features, near,
};
use ccd_core::narrow_phase::decide;

const THREADS: u32 = Id::ExpandTriangles.threads();

/// Words of `shared` behind the counts: pairs of a vertex and a face, of edges, where they go.
const VF: u32 = N_COUNTS as u32;
const EE: u32 = VF + 1;
const BASE_VF: u32 = VF + 2;
const BASE_EE: u32 = VF + 3;
const ALL_VF: u32 = (1 << N_VERTEX_FACE) - 1;

kernel! {
    /// Thread `i` unites the boxes of the vertices of triangle `i`.
    sweep_triangles[256](t; params: Plain;; triangles: [Triangle], boxes: [Aabb],
        mut swept: [Aabb]) {
        let i = t.i;
        if i < params.dispatch.n {
            let corners = at(triangles, i as usize).corners;
            put(swept, i as usize, swept_box::triangle(corners, boxes));
        }
    }
}

kernel! {
    /// Thread `i` expands the `i`-th pair of triangles that is listed.
    expand_triangles[128](t; params: Expansion; shared: [u32; 12]; triangles: [Triangle],
        regions: [u32], boxes: [Aabb], input: [u32], mut vf: [u32], mut ee: [u32],
        mut counts: [u32]) {
        let (dispatch, capacity_ee) = (&params.dispatch, params.args.capacity_ee);
        let len = part(input, dispatch);
        clear(t.lane, shared);
        barrier();
        for round in 0..decide::rounds(len, t.group, t.groups, THREADS) {
            let i = (t.group + round * t.groups) * THREADS + t.lane;
            if t.lane == 0 {
                set(shared, VF, 0);
                set(shared, EE, 0);
            }
            barrier();
            let mut pair = Pair { a: 0, b: 0 };
            let (mut hits, mut to_vf, mut to_ee) = (0, 0, 0);
            if i < len {
                pair = read_pair(input, dispatch.first + i);
                let one = expand(pair, &params.frame, &params.args, triangles, regions, boxes);
                add_counts(&one, shared);
                hits = one.hits;
                if hits != 0 {
                    to_vf = add_shared(shared, VF, (hits & ALL_VF).count_ones());
                    to_ee = add_shared(shared, EE, (hits & !ALL_VF).count_ones());
                }
            }
            barrier();
            place(t.lane, shared, vf, ee);
            barrier();
            if hits != 0 {
                to_vf += get(shared, BASE_VF);
                to_ee += get(shared, BASE_EE);
                for test in 0..N_VERTEX_FACE {
                    if hits >> test & 1 == 1 {
                        let found = features(test, pair, triangles);
                        write_pair(vf, dispatch.capacity_out, to_vf, found);
                        to_vf += 1;
                    }
                }
                for test in N_VERTEX_FACE..15 {
                    if hits >> test & 1 == 1 {
                        write_pair(ee, capacity_ee, to_ee, features(test, pair, triangles));
                        to_ee += 1;
                    }
                }
            }
        }
        barrier();
        hand_over(t.lane, shared, counts);
    }
}

kernel! {
    /// Thread `i` makes the `i`-th test of neighbours.
    near_tests[128](t; params: Expansion; shared: [u32; 12]; tests: [NearTest], regions: [u32],
        swept: [Aabb], boxes: [Aabb], mut vf: [u32], mut ee: [u32], mut counts: [u32]) {
        let dispatch = &params.dispatch;
        clear(t.lane, shared);
        barrier();
        for round in 0..decide::rounds(dispatch.n, t.group, t.groups, THREADS) {
            let i = (t.group + round * t.groups) * THREADS + t.lane;
            if t.lane == 0 {
                set(shared, VF, 0);
                set(shared, EE, 0);
            }
            barrier();
            let mut pair = Pair { a: 0, b: 0 };
            let (mut hit, mut is_vf, mut to) = (0, false, 0);
            if i < dispatch.n {
                let number = dispatch.first + i;
                let test = at(tests, number as usize);
                pair = test.pair;
                let one = near(number, &test, &params.frame, &params.args, regions, swept, boxes);
                add_counts(&one, shared);
                hit = one.hits;
                is_vf = number < params.args.n_vf;
                if hit != 0 {
                    to = add_shared(shared, if is_vf { VF } else { EE }, 1);
                }
            }
            barrier();
            place(t.lane, shared, vf, ee);
            barrier();
            if hit != 0 {
                if is_vf {
                    write_pair(vf, dispatch.capacity_out, get(shared, BASE_VF) + to, pair);
                } else {
                    write_pair(ee, params.args.capacity_ee, get(shared, BASE_EE) + to, pair);
                }
            }
        }
        barrier();
        hand_over(t.lane, shared, counts);
    }
}

/// Sets the counts of a workgroup to zero.
#[inline(always)]
fn clear(lane: u32, shared: &mut [u32; 12]) {
    if lane < N_COUNTS as u32 {
        set(shared, lane, 0);
    }
}

/// Adds what a thread counts; below 2^32, because a dispatch takes a bounded part.
#[inline(always)]
fn add_counts(one: &Expanded, shared: &mut [u32; 12]) {
    let [pairs, adjacent, free, represented, orphans] = one.counts;
    if pairs != 0 {
        add_shared(shared, 0, pairs);
    }
    if adjacent != 0 {
        add_shared(shared, 1, adjacent);
    }
    if free != 0 {
        add_shared(shared, 2, free);
    }
    if represented != 0 {
        add_shared(shared, 3, represented);
    }
    if orphans != 0 {
        add_shared(shared, 4, orphans);
    }
}

/// Finds a place in both lists for what a workgroup has.
#[inline(always)]
fn place(lane: u32, shared: &mut [u32; 12], vf: &mut [u32], ee: &mut [u32]) {
    if lane == 0 {
        let (n_vf, n_ee) = (get(shared, VF), get(shared, EE));
        if n_vf > 0 {
            set(shared, BASE_VF, count(vf, 0, n_vf));
        }
        if n_ee > 0 {
            set(shared, BASE_EE, count(ee, 0, n_ee));
        }
    }
}

/// Adds the counts of a workgroup to those of all.
#[inline(always)]
fn hand_over(lane: u32, shared: &mut [u32; 12], counts: &mut [u32]) {
    if lane < N_COUNTS as u32 {
        let n = get(shared, lane);
        if n > 0 {
            count(counts, lane as usize * COUNT_STRIDE, n);
        }
    }
}
