//! Verdicts of what the filters left: in `f64`; or without it by integers, and what these leave in
//! `f32`. What that cannot decide is for the host.

use crate::entry::kernel;
use crate::records::PathWords;
use crate::workgroup::{add, add_shared, barrier, get, lower, part, read_pair, set, write_pair};
use ccd_core::backend::kernel::Id;
use ccd_core::backend::kernel::memory::put;
use ccd_core::backend::layout::elements::kind_of;
use ccd_core::backend::layout::{Decision, Frame, LIST_HEADER, Pair, Params, TOUCH_WORDS};
use ccd_core::narrow_phase::decide::{self, Verdicts};

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

/// Lists a verdict of this thread, if it is one of contact, as a contact or as a pair. `pair`: with
/// its kind.
/// `is_decided_again`: what is open is decided by the host, and may be none, so that its time
/// bounds nothing.
#[inline(always)]
fn list_wide(
    lane: u32,
    params: &Params<Decision>,
    pair: Pair,
    verdict: &Verdicts,
    is_decided_again: bool,
    counters: &mut [u32; 4],
    contacts: &mut [u32],
    earliest: &mut [u32],
) {
    let keep = params.frame.has(Frame::FLAG_KEEP);
    let open = verdict.undecided != 0 && is_decided_again;
    let listed = verdict.touches && (keep || open);
    if verdict.touches && !open {
        lower(earliest, 0, decide::earliest_key(verdict.toi));
    }
    let to = place(lane, listed, counters, contacts);
    if listed && keep {
        write_touch(contacts, params.dispatch.capacity_out, to, pair, verdict);
    } else if listed {
        write_pair(contacts, params.args.capacity_open, to, pair);
    }
}

/// Lists a verdict of this thread, if it is one of contact: as a contact if it is certain, else as
/// a pair for the host.
#[inline(always)]
fn list_narrow<A>(
    lane: u32,
    params: &Params<A>,
    args: &Decision,
    pair: Pair,
    verdict: &Verdicts,
    counters: &mut [u32; 4],
    contacts: &mut [u32],
    undecided: &mut [u32],
    earliest: &mut [u32],
) {
    let open = verdict.undecided != 0;
    let certain = verdict.touches && !open;
    if certain {
        lower(earliest, 0, decide::earliest_key(verdict.toi));
    }
    if params.frame.has(Frame::FLAG_KEEP) {
        let to = place(lane, certain, counters, contacts);
        if certain {
            write_touch(contacts, params.dispatch.capacity_out, to, pair, verdict);
        }
    }
    barrier();
    // Counted also beyond the capacity, so that the host sees how many there are.
    let to = place(lane, open, counters, undecided);
    if open {
        write_pair(undecided, args.capacity_open, to, pair);
    }
}

/// Decides pairs in `f64`, `$near`: by a minimum distance.
macro_rules! wide {
    ($(#[$doc:meta])* $name:ident, $near:literal) => {
        kernel! {
            $(#[$doc])*
            $name[64](t; params: Decision; counters: [u32; 4]; paths: [PathWords],
                positions: [[f64; 3]], elements: [u32], input: [u32], mut contacts: [u32],
                mut earliest: [u32]) {
                let len = part(input, &params.dispatch);
                for round in 0..decide::rounds(len, t.group, t.groups, THREADS) {
                    let i = (t.group + round * t.groups) * THREADS + t.lane;
                    let (mut pair, mut verdict) = (Pair { a: 0, b: 0 }, Verdicts::NONE);
                    if i < len {
                        pair = read_pair(input, params.dispatch.first + i);
                        let (kind, alone) = kind_of(pair);
                        verdict = decide::wide::<$near, _>(
                            kind, alone, &params.frame, paths, positions, elements,
                        );
                    }
                    list_wide(t.lane, params, pair, &verdict, !$near, counters, contacts, earliest);
                }
            }
        }
    };
}

wide! {
    /// Thread `i` decides the `i`-th pair from `dispatch.first` on in `f64`. Without `FLAG_KEEP`
    /// the list of contacts is one of pairs, those that the host decides again.
    decide_wide, false
}
wide! {
    /// The same by a minimum distance; no host decides these again.
    decide_near_wide, true
}

kernel! {
    /// Thread `i` decides the `i`-th pair from `dispatch.first` on by integers; what these leave
    /// open goes to `left`, ties with a mark. `positions`: words of positions as given, if paths
    /// are not exact.
    decide_integers[64](t; params: IntegerDecision; counters: [u32; 4]; paths: [PathWords],
        positions: [u32], elements: [u32], input: [u32], mut contacts: [u32], mut left: [u32],
        mut earliest: [u32]) {
        let (len, args) = (part(input, &params.dispatch), &params.args.of_pairs);
        for round in 0..decide::rounds(len, t.group, t.groups, THREADS) {
            let i = (t.group + round * t.groups) * THREADS + t.lane;
            let (mut pair, mut verdict) = (Pair { a: 0, b: 0 }, Verdicts::NONE);
            if i < len {
                pair = read_pair(input, params.dispatch.first + i);
                let (frame, args) = (&params.frame, &params.args);
                let (kind, alone) = kind_of(pair);
                let found =
                    decide::by_integers(kind, alone, frame, args, paths, positions, elements);
                verdict = decide::found_verdicts(found, args.from);
                pair = decide::left_pair(pair, found);
            }
            list_narrow(t.lane, params, args, pair, &verdict, counters, contacts, left, earliest);
        }
    }
}

/// Decides pairs in `f32`, `$near`: by a minimum distance.
macro_rules! narrow {
    ($(#[$doc:meta])* $name:ident, $near:literal) => {
        kernel! {
            $(#[$doc])*
            $name[64](t; params: Decision; counters: [u32; 4]; paths: [PathWords],
                elements: [u32], input: [u32], mut contacts: [u32], mut undecided: [u32],
                mut earliest: [u32]) {
                let (len, args) = (part(input, &params.dispatch), &params.args);
                for round in 0..decide::rounds(len, t.group, t.groups, THREADS) {
                    let i = (t.group + round * t.groups) * THREADS + t.lane;
                    let (mut pair, mut verdict) = (Pair { a: 0, b: 0 }, Verdicts::NONE);
                    if i < len {
                        let left = read_pair(input, params.dispatch.first + i);
                        let (listed, is_tie) = decide::was_left(left);
                        pair = listed;
                        verdict = Verdicts::OPEN;
                        if !is_tie {
                            let (kind, alone) = kind_of(pair);
                            verdict = decide::narrow::<$near, _>(
                                kind, alone, &params.frame, paths, elements,
                            );
                        }
                    }
                    list_narrow(
                        t.lane, params, args, pair, &verdict, counters, contacts, undecided,
                        earliest,
                    );
                }
            }
        }
    };
}

narrow! {
    /// Thread `i` decides the `i`-th pair from `dispatch.first` on in `f32`; what that leaves open
    /// goes to `undecided`.
    decide, false
}
narrow! {
    /// The same by a minimum distance.
    decide_near, true
}
