//! Verdicts of what the filters left: by zeros of a cubic, in `f64`, or without it by integers;
//! then of what that leaves, by advancing time too, in `f64`, or without it in `f32`. What is still
//! open is listed as undecided, for the host.

use crate::entry::kernel;
use crate::records::PathWords;
use crate::workgroup::{add, add_shared, barrier, get, lower, part, read_pair, set, write_pair};
use ccd_core::backend::kernel::Id;
use ccd_core::backend::kernel::memory::put;
use ccd_core::backend::layout::elements::kind_of;
use ccd_core::backend::layout::{Dispatch, Frame, LIST_HEADER, Pair, TOUCH_WORDS};
use ccd_core::narrow_phase::decide::{self, Verdicts, by};
use ccd_core::narrow_phase::integer_search::Found;

const THREADS: u32 = Id::Decide.threads();

/// Appends to a list one entry of every thread that has one, in one addition for the workgroup.
/// Returns where this thread's goes.
#[inline(always)]
fn place(lane: u32, has: bool, counters: &mut [u32; 4], list: &mut [u32]) -> u32 {
    if lane == 0 {
        set(counters, 0, 0);
    }
    barrier();
    let mut slot = 0;
    if has {
        slot = add_shared(counters, 0, 1);
    }
    barrier();
    if lane == 0 {
        let n = get(counters, 0);
        if n > 0 {
            set(counters, 1, add(list, 0, n));
        }
    }
    barrier();
    get(counters, 1) + slot
}

#[inline(always)]
fn write_touch(list: &mut [u32], capacity: u32, i: u32, listed: Pair, v: &Verdicts) {
    if i < capacity {
        let (kind, pair) = kind_of(listed);
        let to = LIST_HEADER + TOUCH_WORDS * i as usize;
        put(list, to, kind);
        put(list, to + 1, v.undecided);
        put(list, to + 2, pair.a);
        put(list, to + 3, pair.b);
        put(list, to + 4, v.toi[0]);
        put(list, to + 5, v.toi[1]);
        put(list, to + 6, v.approach);
    }
}

/// Lists a verdict of this thread if it is one of contact; where contacts are not kept, if it is
/// open. `is_decided_again`: what is open is decided by the host, and may be none, so that its time
/// bounds nothing.
#[inline(always)]
fn list(
    lane: u32,
    (frame, dispatch): (&Frame, &Dispatch),
    (pair, verdict): (Pair, &Verdicts),
    is_decided_again: bool,
    counters: &mut [u32; 4],
    contacts: &mut [u32],
    earliest: &mut [u32],
) {
    let open = verdict.undecided != 0 && is_decided_again;
    let listed = verdict.touches && (open || frame.has(Frame::FLAG_KEEP));
    if verdict.touches && !open {
        lower(earliest, 0, decide::earliest_key(verdict.toi));
    }
    let to = place(lane, listed, counters, contacts);
    if listed {
        write_touch(contacts, dispatch.capacity_out, to, pair, verdict);
    }
}

/// The same of the first of two decisions: what is open, and no tie, goes to `left`, unless that
/// has no capacity.
#[inline(always)]
fn list_first(
    lane: u32,
    of: (&Frame, &Dispatch),
    (pair, verdict, is_tie): (Pair, &Verdicts, bool),
    capacity_left: u32,
    counters: &mut [u32; 4],
    contacts: &mut [u32],
    left: &mut [u32],
    earliest: &mut [u32],
) {
    let is_left = verdict.undecided != 0 && !is_tie && capacity_left > 0;
    let listed = if is_left { Verdicts::NONE } else { *verdict };
    list(lane, of, (pair, &listed), true, counters, contacts, earliest);
    barrier();
    // Counted also beyond the capacity, so that the host sees how many there are.
    let to = place(lane, is_left, counters, left);
    if is_left {
        write_pair(left, capacity_left, to, pair);
    }
}

kernel! {
    /// Thread `i` decides the `i`-th pair from `dispatch.first` on in `f64`, by zeros of the cubic;
    /// what these leave open goes to `left`.
    decide_wide[64](t; params: Decision; counters: [u32; 4]; paths: [PathWords],
        positions: [[f64; 3]], elements: [u32], input: [u32], mut contacts: [u32], mut left: [u32],
        mut earliest: [u32]) {
        let (len, frame) = (part(input, &params.dispatch), &params.frame);
        for round in 0..decide::rounds(len, t.group, t.groups, THREADS) {
            let i = (t.group + round * t.groups) * THREADS + t.lane;
            let (mut pair, mut verdict) = (Pair { a: 0, b: 0 }, Verdicts::NONE);
            if i < len {
                pair = read_pair(input, params.dispatch.first + i);
                let (kind, alone) = kind_of(pair);
                verdict = decide::wide::<{ by::ZEROS }, _>(
                    kind, alone, frame, paths, positions, elements,
                );
            }
            let (of, found) = ((frame, &params.dispatch), (pair, &verdict, false));
            list_first(
                t.lane, of, found, params.args.capacity_left, counters, contacts, left, earliest,
            );
        }
    }
}

kernel! {
    /// The same by integers. `positions`: words of positions as given, if paths are not exact.
    decide_integers[64](t; params: IntegerDecision; counters: [u32; 4]; paths: [PathWords],
        positions: [u32], elements: [u32], input: [u32], mut contacts: [u32], mut left: [u32],
        mut earliest: [u32]) {
        let (len, frame, args) = (part(input, &params.dispatch), &params.frame, &params.args);
        for round in 0..decide::rounds(len, t.group, t.groups, THREADS) {
            let i = (t.group + round * t.groups) * THREADS + t.lane;
            let (mut pair, mut found) = (Pair { a: 0, b: 0 }, Found::Miss);
            if i < len {
                pair = read_pair(input, params.dispatch.first + i);
                let (kind, alone) = kind_of(pair);
                found = decide::by_integers(kind, alone, frame, args, paths, positions, elements);
            }
            let verdict = decide::found_verdicts(found, args.from);
            let (of, found) = ((frame, &params.dispatch), (pair, &verdict, found == Found::Tie));
            let capacity_left = args.of_pairs.capacity_left;
            list_first(
                t.lane, of, found, capacity_left, counters, contacts, left, earliest,
            );
        }
    }
}

/// Decides pairs in `f64`, `$how` of [`by`].
macro_rules! wide {
    ($(#[$doc:meta])* $name:ident, $how:expr) => {
        kernel! {
            $(#[$doc])*
            $name[64](t; params: Plain; counters: [u32; 4]; paths: [PathWords],
                positions: [[f64; 3]], elements: [u32], input: [u32], mut contacts: [u32],
                mut earliest: [u32]) {
                let (len, frame) = (part(input, &params.dispatch), &params.frame);
                for round in 0..decide::rounds(len, t.group, t.groups, THREADS) {
                    let i = (t.group + round * t.groups) * THREADS + t.lane;
                    let (mut pair, mut verdict) = (Pair { a: 0, b: 0 }, Verdicts::NONE);
                    if i < len {
                        pair = read_pair(input, params.dispatch.first + i);
                        let (kind, alone) = kind_of(pair);
                        verdict = decide::wide::<{ $how }, _>(
                            kind, alone, frame, paths, positions, elements,
                        );
                    }
                    let (of, again) = ((frame, &params.dispatch), $how != by::DISTANCE);
                    list(t.lane, of, (pair, &verdict), again, counters, contacts, earliest);
                }
            }
        }
    };
}

wide! {
    /// Thread `i` decides the `i`-th pair from `dispatch.first` on, which `decide_wide` left, in
    /// `f64`, and advances time where zeros do not tell.
    advance_wide, by::BOTH
}
wide! {
    /// The same of all pairs, by a minimum distance; no host decides these again.
    decide_near_wide, by::DISTANCE
}

/// Decides pairs in `f32`, `$how` of [`by`].
macro_rules! narrow {
    ($(#[$doc:meta])* $name:ident, $how:expr) => {
        kernel! {
            $(#[$doc])*
            $name[64](t; params: Plain; counters: [u32; 4]; paths: [PathWords],
                elements: [u32], input: [u32], mut contacts: [u32], mut earliest: [u32]) {
                let (len, frame) = (part(input, &params.dispatch), &params.frame);
                for round in 0..decide::rounds(len, t.group, t.groups, THREADS) {
                    let i = (t.group + round * t.groups) * THREADS + t.lane;
                    let (mut pair, mut verdict) = (Pair { a: 0, b: 0 }, Verdicts::NONE);
                    if i < len {
                        pair = read_pair(input, params.dispatch.first + i);
                        let (kind, alone) = kind_of(pair);
                        verdict = decide::narrow::<{ $how }, _>(
                            kind, alone, frame, paths, elements,
                        );
                    }
                    let of = (frame, &params.dispatch);
                    list(t.lane, of, (pair, &verdict), true, counters, contacts, earliest);
                }
            }
        }
    };
}

narrow! {
    /// Thread `i` decides the `i`-th pair from `dispatch.first` on in `f32`.
    decide, by::BOTH
}
narrow! {
    /// The same by a minimum distance.
    decide_near, by::DISTANCE
}
