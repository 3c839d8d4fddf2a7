//! Verdicts of what the filters left: in `f64`, or without it, by integers and in `f32`, with what
//! these cannot decide passed on.

use crate::entry::kernel;
use crate::records::PathWords;
use crate::workgroup::{add, add_shared, barrier, get, lower, part, read_pair, set, write_pair};
use ccd_core::backend::kernel::Id;
use ccd_core::backend::kernel::memory::put;
use ccd_core::backend::layout::{Frame, LIST_HEADER, Pair, TOUCH_WORDS, Touch};
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
fn write_touch(list: &mut [u32], capacity: u32, i: u32, touch: &Touch) {
    if i < capacity {
        let to = LIST_HEADER + TOUCH_WORDS * i as usize;
        put(list, to, touch.kind);
        put(list, to + 1, touch.state);
        put(list, to + 2, touch.a);
        put(list, to + 3, touch.b);
        put(list, to + 4, touch.toi[0]);
        put(list, to + 5, touch.toi[1]);
        put(list, to + 6, touch.approach);
    }
}

macro_rules! decide_wide {
    ($(#[$doc:meta])* $name:ident, near: $near:literal) => {
        kernel! {
            $(#[$doc])*
            $name[64](t; params: Decision; counters: [u32; 4]; paths: [PathWords],
                positions: [[f64; 3]], elements: [u32], input: [u32], mut contacts: [u32],
                mut earliest: [u32]) {
                let len = part(input, &params.dispatch);
                for round in 0..decide::rounds(len, t.group, t.groups, THREADS) {
                    let i = (t.group + round * t.groups) * THREADS + t.lane;
                    let (kind, keep) = (params.args.kind, params.frame.has(Frame::FLAG_KEEP));
                    let mut listed = false;
                    let mut touch = Touch { kind, state: 0, a: 0, b: 0, toi: [0; 2], approach: 0 };
                    if i < len {
                        let pair = read_pair(input, params.dispatch.first + i);
                        let frame = &params.frame;
                        let Verdicts { touches, undecided, approach, toi } = decide::wide::<$near, _>(
                            kind, pair, frame, paths, positions, elements,
                        );
                        // An open pair is decided by the host, and may be none: its time bounds
                        // nothing.
                        let open = undecided != 0 && !$near;
                        listed = touches && (keep || open);
                        touch.a = pair.a;
                        touch.b = pair.b;
                        touch.state = undecided;
                        touch.toi = toi;
                        touch.approach = approach;
                        if touches && !open {
                            lower(earliest, 0, decide::earliest_key(toi));
                        }
                    }
                    let to = place(t.lane, listed, counters, contacts);
                    if listed && keep {
                        write_touch(contacts, params.dispatch.capacity_out, to, &touch);
                    } else if listed {
                        let pair = Pair { a: touch.a, b: touch.b };
                        write_pair(contacts, params.args.capacity_open, to, pair);
                    }
                }
            }
        }
    };
}

macro_rules! decide_narrow {
    ($(#[$doc:meta])* $name:ident, near: $near:literal) => {
        kernel! {
            $(#[$doc])*
            $name[64](t; params: IntegerDecision; counters: [u32; 4]; paths: [PathWords],
                positions: [u32], elements: [u32], input: [u32], mut contacts: [u32],
                mut undecided: [u32], mut earliest: [u32]) {
                let len = part(input, &params.dispatch);
                for round in 0..decide::rounds(len, t.group, t.groups, THREADS) {
                    let i = (t.group + round * t.groups) * THREADS + t.lane;
                    let args = &params.args.of_pairs;
                    let (mut certain, mut open) = (false, false);
                    let mut touch =
                        Touch { kind: args.kind, state: 0, a: 0, b: 0, toi: [0; 2], approach: 0 };
                    if i < len {
                        let pair = read_pair(input, params.dispatch.first + i);
                        let (frame, args) = (&params.frame, &params.args);
                        let verdict = decide::narrow::<$near, _>(
                            pair, frame, args, paths, positions, elements,
                        );
                        certain = verdict.touches && verdict.undecided == 0;
                        open = verdict.undecided != 0;
                        touch.a = pair.a;
                        touch.b = pair.b;
                        touch.toi = verdict.toi;
                        touch.approach = verdict.approach;
                        if certain {
                            lower(earliest, 0, decide::earliest_key(verdict.toi));
                        }
                    }
                    if params.frame.has(Frame::FLAG_KEEP) {
                        let to = place(t.lane, certain, counters, contacts);
                        if certain {
                            write_touch(contacts, params.dispatch.capacity_out, to, &touch);
                        }
                    }
                    barrier();
                    // Counted also beyond the capacity, so that the host sees how many there are.
                    let to = place(t.lane, open, counters, undecided);
                    if open {
                        let pair = Pair { a: touch.a, b: touch.b };
                        write_pair(undecided, args.capacity_open, to, pair);
                    }
                }
            }
        }
    };
}

decide_wide! {
    /// Thread `i` decides the `i`-th pair from `dispatch.first` on in `f64`. `elements`: of faces,
    /// or of edges, as the kind has them. Without `FLAG_KEEP` the list of contacts is one of
    /// pairs, those that the host decides again.
    decide_wide, near: false
}

decide_wide! {
    /// The same by a minimum distance: no host decides these again.
    decide_near_wide, near: true
}

decide_narrow! {
    /// Thread `i` decides the `i`-th pair from `dispatch.first` on without `f64`; what that leaves
    /// open goes to `undecided`. `elements`: of faces, or of edges, as the kind has them.
    /// `positions`: words of positions as given, if paths are not exact.
    decide, near: false
}

decide_narrow! {
    /// The same by a minimum distance.
    decide_near, near: true
}
