//! The parts of a worker's turn; see `ccd_core::backend::broad_phase::pair_workers`. A scheduler of
//! its own has another [`plan`].

use super::pair_tree::{INNER, LEAF, PairTree};
use super::shared::{
    BELOW, ENDED, ENDED_BASE, EXPANDED, FIRST, FROM_STACK, FROM_TASKS, LEAVES, LEAVES_BASE, NEXT,
    NODES, REST, REST_BASE, Round, SPILL_BASE, STRIDE, Shared, Stack, TO_STACK, TOP, TURNS,
};
use crate::broad_phase::pair_descent::{count_front, reserve, write_front};
use crate::workgroup::{add, add_shared, count, get, load, raise, read_pair, set, write_pair};
use ccd_core::backend::broad_phase::pair_descent::{NO_PAIR, NodePair};
use ccd_core::backend::broad_phase::pair_workers::{
    LEFT, QUANTUM, STACK, THREADS, idle, is_over, listed, piece, share, taken,
};
use ccd_core::backend::layout::{NodeDescent, Pair};

/// What a worker does next.
pub(super) const WORKS: u32 = 0;
/// It has found nothing more.
pub(super) const ENDS: u32 = 1;
/// It leaves what it has to the next round.
pub(super) const STOPS: u32 = 2;

/// The first thread says what its worker does in this turn, by what is on the stack and what tasks
/// there are: returns whether it works at all.
#[inline(always)]
pub(super) fn plan<T: PairTree>(
    args: &NodeDescent,
    round: Round,
    turn: u32,
    shared: &mut Shared,
    control: &mut [u32],
) -> u32 {
    let from_stack = get(shared, TOP).min(T::WIDTH);
    let mut state = WORKS;
    if args.idle > 0 && turn >= QUANTUM {
        if is_over(load(control, idle(round.number)), round.workers, args.idle) {
            state = STOPS;
        }
    }
    let mut from_tasks = 0;
    let capacity = T::WIDTH - from_stack;
    if state == WORKS && capacity > 0 {
        let next = get(shared, NEXT);
        if args.tasks == NodeDescent::TASKS_DEALT {
            from_tasks = (share(round.tasks, round.me, round.workers) - next).min(capacity);
            set(shared, FIRST, round.me + (next << round.workers));
            set(shared, STRIDE, 1 << round.workers);
            set(shared, NEXT, next + from_tasks);
        } else if next == 0 {
            let wanted = piece(round.tasks, round.workers, args.piece).min(capacity);
            let first = add(control, taken(round.number), wanted);
            from_tasks = round.tasks - first.min(round.tasks);
            from_tasks = from_tasks.min(wanted);
            set(shared, FIRST, first);
            set(shared, STRIDE, 1);
            set(shared, NEXT, (from_tasks < wanted) as u32);
        }
    }
    if state == WORKS && from_stack + from_tasks == 0 {
        state = ENDS;
        if args.idle > 0 {
            add(control, idle(round.number), 1);
        }
    }
    set(shared, FROM_STACK, from_stack);
    set(shared, FROM_TASKS, from_tasks);
    set(shared, NODES, 0);
    set(shared, LEAVES, 0);
    set(shared, ENDED, 0);
    T::begin(shared);
    state
}

/// Pair `i` of those that are expanded in this turn, from the top of the stack or from the tasks.
#[inline(always)]
pub(super) fn take(i: u32, input: u32, shared: &Shared, stack: &Stack, nodes: &[u32]) -> NodePair {
    let (from_stack, from_tasks) = (get(shared, FROM_STACK), get(shared, FROM_TASKS));
    let mut out = NO_PAIR;
    if i < from_stack {
        let place = 2 * (get(shared, TOP) - 1 - i);
        out = [get(stack, place), get(stack, place + 1)];
    } else if i < from_stack + from_tasks {
        let task = get(shared, FIRST) + (i - from_stack) * get(shared, STRIDE);
        let pair = read_pair(nodes, input + task);
        out = [pair.a, pair.b];
    }
    out
}

/// A child of a pair, and what becomes of it.
#[derive(Clone, Copy)]
pub(super) struct Child {
    pub pair: NodePair,
    pub fate: u32,
}

impl Child {
    pub(super) const NONE: Self = Self { pair: NO_PAIR, fate: 0 };
}

/// Counts a pair in its worker; returns the number that it has among its like, and in the front.
#[inline(always)]
pub(super) fn claim(fate: u32, capacity_front: u32, shared: &mut Shared) -> [u32; 2] {
    let mut to = [0, 0];
    if fate == INNER {
        to[0] = add_shared(shared, NODES, 1);
    } else if fate == LEAF {
        to[0] = add_shared(shared, LEAVES, 1);
    }
    if fate >= LEAF && capacity_front > 0 {
        to[1] = add_shared(shared, ENDED, 1);
    }
    to
}

/// The first thread makes room for what was found: `below` pairs are left on the stack.
#[inline(always)]
pub(super) fn reserve_results(
    args: &NodeDescent,
    number: u32,
    shared: &mut Shared,
    control: &mut [u32],
    nodes: &mut [u32],
    pairs: &mut [u32],
) {
    let (n_nodes, n_leaves) = (get(shared, NODES), get(shared, LEAVES));
    let n_ended = get(shared, ENDED);
    let (from_stack, from_tasks) = (get(shared, FROM_STACK), get(shared, FROM_TASKS));
    set(shared, TURNS, get(shared, TURNS) + 1);
    set(shared, EXPANDED, get(shared, EXPANDED) + from_stack + from_tasks);
    let below = get(shared, TOP) - from_stack;
    let to_stack = n_nodes.min(args.stack - below);
    set(shared, BELOW, below);
    set(shared, TO_STACK, to_stack);
    set(shared, TOP, below + to_stack);
    if n_nodes > to_stack {
        let base = spill(args, number, n_nodes - to_stack, control, nodes);
        set(shared, SPILL_BASE, base);
    }
    if n_leaves > 0 {
        set(shared, LEAVES_BASE, count(pairs, 0, n_leaves));
    }
    if n_ended > 0 {
        set(shared, ENDED_BASE, count_front(control, n_ended));
    }
}

/// Reserves places among the tasks of the next round.
#[inline(always)]
pub(super) fn spill(
    args: &NodeDescent,
    number: u32,
    n: u32,
    control: &mut [u32],
    nodes: &mut [u32],
) -> u32 {
    if args.last != 0 {
        raise(control, LEFT, u32::MAX);
    }
    reserve(control, listed(number + 1), nodes, n)
}

/// Writes a pair to where it belongs.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "naga refuses structures that hold views")]
pub(super) fn put_away<T: PairTree>(
    args: &NodeDescent,
    round: Round,
    child: Child,
    to: [u32; 2],
    a: &[T::Node],
    b: &[T::Node],
    shared: &Shared,
    stack: &mut Stack,
    nodes: &mut [u32],
    pairs: &mut [u32],
    front: &mut [u32],
) {
    let Child { pair, fate } = child;
    if fate == INNER {
        let to_stack = get(shared, TO_STACK);
        if to[0] < to_stack {
            let place = 2 * (get(shared, BELOW) + to[0]);
            set(stack, place, pair[0]);
            set(stack, place + 1, pair[1]);
        } else {
            let i = get(shared, SPILL_BASE) + to[0] - to_stack;
            write_task(args, round.output, nodes, i, pair);
        }
    } else if fate != 0 {
        put_ended::<T>(args, round.capacity_pairs, child, to, a, b, shared, pairs, front);
    }
}

/// Writes a pair at which the descent ends.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "as above")]
pub(super) fn put_ended<T: PairTree>(
    args: &NodeDescent,
    capacity_pairs: u32,
    child: Child,
    to: [u32; 2],
    a: &[T::Node],
    b: &[T::Node],
    shared: &Shared,
    pairs: &mut [u32],
    front: &mut [u32],
) {
    let Child { pair, fate } = child;
    if fate == LEAF {
        let found = T::result(args, pair, a, b);
        write_pair(pairs, capacity_pairs, get(shared, LEAVES_BASE) + to[0], found);
    }
    if args.capacity_front > 0 {
        write_front(args, front, get(shared, ENDED_BASE) + to[1], pair);
    }
}

/// Writes a task of the next round; one for which there is no room is only counted.
#[inline(always)]
pub(super) fn write_task(
    args: &NodeDescent,
    output: u32,
    nodes: &mut [u32],
    i: u32,
    pair: NodePair,
) {
    if i < args.capacity_nodes {
        write_pair(nodes, u32::MAX, output + i, Pair { a: pair[0], b: pair[1] });
    }
}

/// The first thread, when the worker has ended: room for its stack and for the rest of its part
/// among the tasks of the next round.
#[inline(always)]
pub(super) fn reserve_rest(
    args: &NodeDescent,
    round: Round,
    shared: &mut Shared,
    control: &mut [u32],
    nodes: &mut [u32],
) {
    let mut rest = 0;
    if args.tasks == NodeDescent::TASKS_DEALT {
        rest = share(round.tasks, round.me, round.workers) - get(shared, NEXT);
    }
    set(shared, REST, rest);
    let n = get(shared, TOP) + rest;
    if n > 0 {
        set(shared, REST_BASE, spill(args, round.number, n, control, nodes));
    }
}

/// Leaves what the worker has on its stack, and what is left of its part, to the next round; of
/// tasks by a counter, all that nobody takes any more.
#[inline(always)]
pub(super) fn leave_rest(
    args: &NodeDescent,
    round: Round,
    lane: u32,
    shared: &Shared,
    stack: &Stack,
    control: &mut [u32],
    nodes: &mut [u32],
) {
    let (top, base, rest) = (get(shared, TOP), get(shared, REST_BASE), get(shared, REST));
    for k in 0..STACK / THREADS {
        let i = k * THREADS + lane;
        if i < top {
            let pair = [get(stack, 2 * i), get(stack, 2 * i + 1)];
            write_task(args, round.output, nodes, base + i, pair);
        }
    }
    let next = get(shared, NEXT);
    for k in 0..rest.div_ceil(THREADS) {
        let i = k * THREADS + lane;
        if i < rest {
            let pair = read_pair(nodes, round.input + round.me + ((next + i) << round.workers));
            write_task(args, round.output, nodes, base + top + i, [pair.a, pair.b]);
        }
    }
    if args.tasks == NodeDescent::TASKS_COUNTED && next == 0 {
        // Each thread for itself, a task at a time: that is rare.
        for _ in 0..round.tasks {
            let i = add(control, taken(round.number), 1);
            if i >= round.tasks {
                break;
            }
            let pair = read_pair(nodes, round.input + i);
            let to = spill(args, round.number, 1, control, nodes);
            write_task(args, round.output, nodes, to, [pair.a, pair.b]);
        }
    }
}
