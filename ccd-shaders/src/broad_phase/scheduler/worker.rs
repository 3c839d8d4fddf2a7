//! A worker and the parts of its turn; see `ccd_core::backend::broad_phase::pair_workers`. A
//! scheduler of its own has another [`Worker::plan`].
//!
//! A worker moves pairs of nodes, two words each, between its stack, lists and deques. A
//! [`PairTree`] says what a pair is, which of its children meet, and how many threads expand it:
//! two binary trees, the block trees of two sets, or one of either with itself.

use super::shared::{
    BELOW, ENDED, ENDED_BASE, EXPANDED, FIRST, FROM_STACK, FROM_TASKS, LEAVES, LEAVES_BASE, NEXT,
    NODES, SPILL_BASE, STRIDE, Shared, Stack, TO_STACK, TOP, TURNS,
};
use crate::broad_phase::pair_descent::{count_front, reserve, write_front};
use crate::broad_phase::volume::{INNER, LEAF};
use crate::entry::Thread;
use crate::workgroup::{
    add, add_shared, barrier, count, get, load, raise, read_pair, set, write_pair,
};
use ccd_core::backend::broad_phase::balanced::part;
use ccd_core::backend::broad_phase::pair_descent::{NO_PAIR, NodePair};
use ccd_core::backend::broad_phase::pair_workers::{
    LEFT, QUANTUM, idle, is_over, listed, piece, share, taken, thieves,
};
use ccd_core::backend::broad_phase::stack_traversal::NONE;
use ccd_core::backend::kernel::memory::at;
use ccd_core::backend::layout::{Dispatch, NodeDescent, Pair};
use ccd_core::backend::scheduling::stealing::Workers;

/// A tree of pairs of nodes: a view of the nodes of both sides, with the parameters of a kernel.
pub(super) trait PairTree: Copy {
    /// Children that a thread found, and where they go.
    type Found: Copy;
    type Places: Copy;

    /// Pairs that a worker expands in a turn.
    const WIDTH: u32;

    /// The record that is the same for all trees of pairs.
    fn descent(self) -> NodeDescent;

    /// The record of the dispatch.
    fn dispatch(self) -> Dispatch;

    /// On which of the pairs of a turn a thread works.
    fn index(lane: u32) -> u32;

    /// The first thread, before a turn.
    fn begin(shared: &mut Shared);

    /// The children of a pair that this thread is to find. All threads of a worker call it, also
    /// those that have [`NO_PAIR`]: there may be barriers in it.
    fn expand(self, lane: u32, pair: NodePair, shared: &mut Shared) -> Self::Found;

    /// Children that a thread found: inner pairs, pairs of leaves, and where a front is kept ends.
    fn counts(found: Self::Found, capacity_front: u32) -> [u32; 3];

    /// Where they go, from the first place of each on.
    fn places(found: Self::Found, first: [u32; 3]) -> Self::Places;

    /// Writes them to where they belong.
    fn put_away(worker: &mut Worker<Self>, found: Self::Found, to: Self::Places, stack: &mut Stack);

    /// What becomes of a pair.
    fn fate(self, pair: NodePair) -> u32;

    /// The entry of a pair of leaves in the list of results.
    fn result(self, pair: NodePair) -> Pair;
}

/// States of a worker: it works, it has found nothing more, it leaves what it has to the next
/// round.
pub(super) const WORKS: u32 = 0;
pub(super) const ENDS: u32 = 1;
pub(super) const STOPS: u32 = 2;

/// A child of a pair, and what becomes of it.
#[derive(Clone, Copy)]
pub(super) struct Child {
    pub pair: NodePair,
    pub fate: u32,
}

impl Child {
    pub(super) const NONE: Self = Self { pair: NO_PAIR, fate: 0 };
}

/// Counts a pair in its worker; returns its number among those of its fate, and in the front.
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

/// A worker in a round, as one of its threads sees it.
pub(super) struct Worker<'a, T> {
    pub trees: T,
    pub args: NodeDescent,
    /// All workers, if they steal from each other.
    pub workers: Workers,
    /// Number of the worker, and of the thread in it.
    pub me: u32,
    pub lane: u32,
    /// Number of the round.
    pub round: u32,
    /// Tasks of the round.
    pub tasks: u32,
    /// First entry of these tasks in the list, and of those of the next round.
    pub input: u32,
    pub output: u32,
    pub shared: &'a mut Shared,
    pub control: &'a mut [u32],
    pub nodes: &'a mut [u32],
    pub pairs: &'a mut [u32],
    pub front: &'a mut [u32],
}

impl<'a, T: PairTree> Worker<'a, T> {
    /// Worker `t.group` of round `dispatch.first`.
    #[inline(always)]
    pub(super) fn new(
        trees: T,
        t: Thread,
        shared: &'a mut Shared,
        control: &'a mut [u32],
        nodes: &'a mut [u32],
        pairs: &'a mut [u32],
        front: &'a mut [u32],
    ) -> Self {
        let (args, round) = (trees.descent(), trees.dispatch().first);
        let (capacity, is_odd) = (args.capacity_nodes, round % 2);
        Self {
            trees,
            args,
            workers: thieves(&args),
            me: t.group,
            lane: t.lane,
            round,
            tasks: at(control, listed(round)).min(capacity),
            input: is_odd * capacity,
            output: (1 - is_odd) * capacity,
            shared,
            control,
            nodes,
            pairs,
            front,
        }
    }

    /// A word that the threads share.
    #[inline(always)]
    pub(super) fn get(&self, word: u32) -> u32 {
        get(self.shared, word)
    }

    #[inline(always)]
    pub(super) fn set(&mut self, word: u32, value: u32) {
        set(self.shared, word, value);
    }

    /// The first thread, before the first turn.
    #[inline(always)]
    pub(super) fn clear(&mut self) {
        self.set(TOP, 0);
        self.set(NEXT, 0);
        self.set(TURNS, 0);
        self.set(EXPANDED, 0);
    }

    /// The first thread decides what its worker does in this turn, by what is on the stack and
    /// what tasks there are: returns its state.
    #[inline(always)]
    pub(super) fn plan(&mut self, turn: u32) -> u32 {
        let args = self.args;
        let from_stack = self.get(TOP).min(T::WIDTH);
        let mut state = WORKS;
        if args.idle > 0 && turn >= QUANTUM {
            if is_over(load(self.control, idle(self.round)), args.workers, args.idle) {
                state = STOPS;
            }
        }
        let mut from_tasks = 0;
        let capacity = T::WIDTH - from_stack;
        if state == WORKS && capacity > 0 {
            let next = self.get(NEXT);
            if args.tasks == NodeDescent::TASKS_DEALT {
                from_tasks = (share(self.tasks, self.me, args.workers) - next).min(capacity);
                self.set(FIRST, self.me + (next << args.workers));
                self.set(STRIDE, 1 << args.workers);
                self.set(NEXT, next + from_tasks);
            } else if args.tasks == NodeDescent::TASKS_BALANCED {
                let [first, n] = part(self.tasks, self.me, args.workers);
                from_tasks = (n - next).min(capacity);
                self.set(FIRST, first + next);
                self.set(STRIDE, 1);
                self.set(NEXT, next + from_tasks);
            } else if next == 0 {
                let wanted = piece(self.tasks, args.workers, args.piece).min(capacity);
                let first = add(self.control, taken(self.round), wanted);
                from_tasks = self.tasks - first.min(self.tasks);
                from_tasks = from_tasks.min(wanted);
                self.set(FIRST, first);
                self.set(STRIDE, 1);
                self.set(NEXT, (from_tasks < wanted) as u32);
            }
        }
        if state == WORKS && from_stack + from_tasks == 0 {
            state = ENDS;
            if args.idle > 0 {
                add(self.control, idle(self.round), 1);
            }
        }
        self.set(FROM_STACK, from_stack);
        self.set(FROM_TASKS, from_tasks);
        self.set(NODES, 0);
        self.set(LEAVES, 0);
        self.set(ENDED, 0);
        T::begin(self.shared);
        state
    }

    /// Pair `i` of those that are expanded in this turn, from the top of the stack or from the
    /// tasks.
    #[inline(always)]
    pub(super) fn take(&self, i: u32, stack: &Stack) -> NodePair {
        let (from_stack, from_tasks) = (self.get(FROM_STACK), self.get(FROM_TASKS));
        let mut out = NO_PAIR;
        if i < from_stack {
            let place = 2 * (self.get(TOP) - 1 - i);
            out = [get(stack, place), get(stack, place + 1)];
        } else if i < from_stack + from_tasks {
            let task = self.get(FIRST) + (i - from_stack) * self.get(STRIDE);
            let pair = read_pair(self.nodes, self.input + task);
            out = [pair.a, pair.b];
        }
        out
    }

    /// The first thread reserves places for what was found.
    #[inline(always)]
    pub(super) fn reserve_results(&mut self) {
        let (n_nodes, n_leaves) = (self.get(NODES), self.get(LEAVES));
        let n_ended = self.get(ENDED);
        let (from_stack, from_tasks) = (self.get(FROM_STACK), self.get(FROM_TASKS));
        self.set(TURNS, self.get(TURNS) + 1);
        self.set(EXPANDED, self.get(EXPANDED) + from_stack + from_tasks);
        let below = self.get(TOP) - from_stack;
        let to_stack = n_nodes.min(self.args.stack - below);
        self.set(BELOW, below);
        self.set(TO_STACK, to_stack);
        self.set(TOP, below + to_stack);
        if n_nodes > to_stack {
            let base = self.spill(n_nodes - to_stack);
            self.set(SPILL_BASE, base);
        }
        if n_leaves > 0 {
            set(self.shared, LEAVES_BASE, count(self.pairs, 0, n_leaves));
        }
        if n_ended > 0 {
            set(self.shared, ENDED_BASE, count_front(self.control, n_ended));
        }
    }

    /// Reserves places among the tasks of the next round.
    #[inline(always)]
    pub(super) fn spill(&mut self, n: u32) -> u32 {
        if self.args.last != 0 {
            raise(self.control, LEFT, u32::MAX);
        }
        reserve(self.control, listed(self.round + 1), self.nodes, n)
    }

    /// Writes a pair to the stack, the tasks of the next round, the results or the front.
    #[inline(always)]
    pub(super) fn put_away(&mut self, child: Child, to: [u32; 2], stack: &mut Stack) {
        let Child { pair, fate } = child;
        if fate == INNER {
            let to_stack = self.get(TO_STACK);
            if to[0] < to_stack {
                let place = 2 * (self.get(BELOW) + to[0]);
                set(stack, place, pair[0]);
                set(stack, place + 1, pair[1]);
            } else {
                let i = self.get(SPILL_BASE) + to[0] - to_stack;
                self.write_task(self.output, i, pair);
            }
        } else if fate != 0 {
            self.put_ended(child, to);
        }
    }

    /// Writes a pair at which the descent ends.
    #[inline(always)]
    fn put_ended(&mut self, child: Child, to: [u32; 2]) {
        let Child { pair, fate } = child;
        if fate == LEAF {
            let (found, capacity) = (self.trees.result(pair), self.trees.dispatch().capacity_out);
            write_pair(self.pairs, capacity, get(self.shared, LEAVES_BASE) + to[0], found);
        }
        if self.args.capacity_front > 0 {
            write_front(&self.args, self.front, get(self.shared, ENDED_BASE) + to[1], pair);
        }
    }

    /// Writes a task of a round whose tasks begin at entry `first`; one beyond the capacity is only
    /// counted.
    #[inline(always)]
    pub(super) fn write_task(&mut self, first: u32, i: u32, pair: NodePair) {
        if i < self.args.capacity_nodes {
            write_pair(self.nodes, u32::MAX, first + i, Pair { a: pair[0], b: pair[1] });
        }
    }

    /// A thread looks at a pair at which a search may begin, if it has one: it becomes a task, or
    /// ends here.
    #[inline(always)]
    pub(super) fn begin(&mut self, pair: NodePair) {
        if self.lane == 0 {
            self.set(NODES, 0);
            self.set(LEAVES, 0);
            self.set(ENDED, 0);
        }
        barrier();
        let mut fate = 0;
        if pair[0] != NONE {
            fate = self.trees.fate(pair);
        }
        let to = claim(fate, self.args.capacity_front, self.shared);
        barrier();
        if self.lane == 0 {
            let (n_nodes, n_leaves) = (self.get(NODES), self.get(LEAVES));
            if n_nodes > 0 {
                let base = reserve(self.control, listed(0), self.nodes, n_nodes);
                self.set(SPILL_BASE, base);
            }
            if n_leaves > 0 {
                set(self.shared, LEAVES_BASE, count(self.pairs, 0, n_leaves));
            }
            if self.get(ENDED) > 0 {
                let n = self.get(ENDED);
                set(self.shared, ENDED_BASE, count_front(self.control, n));
            }
        }
        barrier();
        if fate == INNER {
            self.write_task(0, self.get(SPILL_BASE) + to[0], pair);
        } else if fate != 0 {
            self.put_ended(Child { pair, fate }, to);
        }
    }
}
