//! Boxes that overlap ask for each other once, by every method and in every row.

use super::*;
use crate::broad_phase::morton_key::{order_key, shared_word};
use crate::random::Random;
use alloc::vec::Vec;

/// The survey of some boxes: bounds and sides, or bounds and an axis.
fn survey(method: u32, axis: u32, boxes: &[Aabb<f32>]) -> Vec<u32> {
    let all = boxes.iter().fold(Aabb::EMPTY, |all, b| all.union(b));
    let mut words: Vec<u32> = (0..6).map(|k| shared_word(&all, k)).collect();
    for k in 0..3 {
        let all = boxes.iter().fold(Sizes::NONE, |all, b| all.merged(&Sizes::of(b)));
        words.push(if method == SWEEP_AND_PRUNE { axis } else { order_key(all.half[k]) });
    }
    words
}

/// The rows among `some` in which either box asks for the other.
fn asking(
    (method, kind): (u32, u32),
    some: impl Fn(u32) -> bool,
    boxes: [&Aabb<f32>; 2],
    survey: &[u32],
) -> Vec<u32> {
    let [a, b] = sets(kind).map(|set| set as u32);
    let keys = [key(method, a, boxes[0], survey), key(method, b, boxes[1], survey)];
    let mut out = Vec::new();
    for row in (0..rows(method, kind)).filter(|&row| some(row)) {
        for i in 0..2 {
            let [asking, asked] = asks(method, kind, row);
            // Within a set the box of the lesser key asks, of equal ones the first.
            let may = if kind == EDGE_EDGE {
                (keys[i], i) < (keys[1 - i], 1 - i)
            } else {
                asking == [a, b][i]
            };
            let (key, b, step) = (keys[i], boxes[i], step_of(method, row));
            let level = asked_level(method, row, step, key);
            let cell = asked_cell(method, step, key, b, survey);
            let [from, to] = interval(method, kind, row, asked, key, b, survey, level, cell);
            if may && (from..=to).contains(&keys[1 - i]) {
                out.push(row);
            }
        }
    }
    out
}

#[test]
fn boxes_that_overlap_ask_for_each_other_once() {
    let mut random = Random::new(9);
    // Zeros of both signs, in turn.
    let zero = |n: usize| if n.is_multiple_of(2) { 0.0 } else { -0.0 };
    let grown = |p: [f32; 3], by: f32| Aabb { min: p, max: p.map(|c| c + by) };
    // In general position; on a lattice, so that boxes touch and places are equal; huge; tiny;
    // all in one plane; zeros of both signs. Then of several levels, of many, on a lattice, and
    // around what a device flushes.
    let scenes: [(f32, f32, f32, u32); 11] = [
        (1.0, 0.05, 0.0, 0),
        (8.0, 1.0, 1.0, 0),
        (3.3e38, 2e37, 0.0, 0),
        (1e-37, 1e-38, 0.0, 0),
        (0.0, 0.0, 0.0, 0),
        (1.0, 0.1, 0.0, 4),
        (1.0, 1.0, 0.0, 12),
        (8.0, 4.0, 0.125, 5),
        (2e38, 1e38, 0.0, 11),
        (1e-27, 1e-27, 0.0, 14),
        (1e-37, 1e-37, 0.0, 14),
    ];
    // Pairs that one row of coarser levels finds, by row, by step, and by turn.
    let (mut by_row, mut by_step, mut by_turn) = ([0; 9], [0; LEVELS as usize], [0; 2]);
    for (side, size, lattice, span) in scenes {
        let mut point = |n: usize| -> [f32; 3] {
            core::array::from_fn(|_| {
                let x = (random.unit() as f32 - 0.5) * side;
                let x = if lattice > 0.0 { (x / lattice) as i32 as f32 * lattice } else { x };
                if x == 0.0 { zero(n) } else { x }
            })
        };
        let mut boxes: Vec<_> = (0..120).map(|n| grown(point(n), size)).collect();
        for i in (0..boxes.len()).filter(|_| span > 0) {
            // Some long along an axis. Every second has a corner at one of the box before.
            let (small, before) = (random.below(span + 1), boxes[i.saturating_sub(1)]);
            for k in 0..3 {
                let small = if random.below(9) == 0 { 0 } else { small };
                let by = size / (1u32 << small) as f32;
                let b = &mut boxes[i];
                b.min[k] = match random.below(2) {
                    _ if i % 2 == 0 => b.min[k],
                    0 => before.min[k] - by,
                    _ => before.max[k],
                };
                b.max[k] = b.min[k] + by;
            }
        }
        boxes.extend((0..9).map(|n| Aabb::of_point([zero(n); 3])));
        for method in [BRUTE_FORCE, SWEEP_AND_PRUNE, UNIFORM_GRID] {
            let words = survey(method, 1, &boxes);
            let (a_turn, a_step, mut n_pairs) = (rows_a_turn(method), rows_a_step(method), 0);
            for (i, j) in (0..boxes.len()).flat_map(|i| (0..i).map(move |j| (i, j))) {
                let pair = [&boxes[i], &boxes[j]];
                let want = boxes[i].overlaps(&boxes[j]);
                n_pairs += want as u32;
                // A level of few boxes is one row, of many several.
                for (kind, n_boxes) in [(0, 5), (1, 5), (0, 500), (1, 500)] {
                    let [first, end] = rows_taken(method, n_boxes);
                    let taken = |row| (first..end).contains(&(row % a_step));
                    let rows = asking((method, kind), taken, pair, &words);
                    assert!(
                        rows.len() <= 1 && rows.len() >= want as usize,
                        "method {method}, kind {kind}: {rows:?} {pair:?} of {side}"
                    );
                    if want && method == UNIFORM_GRID && n_boxes == 500 {
                        let (turn, row) = (rows[0] / a_turn, rows[0] % a_turn);
                        by_step[(row / a_step) as usize] += 1;
                        if row >= a_step {
                            by_row[(row % a_step) as usize] += 1;
                            by_turn[turn as usize] += 1;
                        }
                    }
                }
            }
            assert!(n_pairs > 25, "{n_pairs} pairs in {side} show nothing");
        }
    }
    // The control: without any one of them, pairs would be missed.
    let counts = [&by_row[..], &by_step, &by_turn];
    assert!(counts.iter().all(|of| of.iter().all(|&n| n > 4)), "{counts:?}");
}

#[test]
fn work_packs() {
    for work in [[159, 8, (1 << 24) - 1, MOST_BOXES - 1], [0, 1, 0, 0], [4, 3, 77, 99]] {
        let [row, tiles, group, first] = work;
        assert_eq!(unpack(pack(row, tiles, group, first)), work);
    }
    let keys = [1, 3, 3, 7];
    assert_eq!([0, 3, 4, 8].map(|key| lower_bound(&keys, 4, key)), [0, 1, 3, 4]);
}
