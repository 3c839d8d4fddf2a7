//! Operations on lists of pairs of nodes, compiled once for each tree of pairs: splitting into
//! tasks, expanding down to rows of leaves, resuming at a front.
//!
//! Twin: `broad_phase/scheduler` of ccd-shaders, which expands pairs where workgroups find them.

use crate::broad_phase::front::Writer;
use crate::broad_phase::leaf_boxes::{Order, Sides};
use crate::broad_phase::pair_tree::PairTree;
use crate::broad_phase::rows::{Gathered, IntoRows};
use crate::simd::{RowSimd, Work};
use crate::threads::Threads;
use ccd_core::backend::broad_phase::pair_descent::NodePair;

/// Output of expansions besides the pairs that are still to be expanded.
pub struct Traces<'t, 'r, 'a, 'f> {
    /// Rows of leaves.
    pub rows: &'t mut Gathered<'r, 'a>,
    /// Where the descent ended, if that is kept.
    pub front: Option<Writer<'f>>,
    /// Pairs that were expanded.
    pub n_expanded: u64,
}

/// Depth of a pair relative to the deepest possible front.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Its children may be in a front.
    Above,
    /// It stays in every front that has come this far, and what is below it is found anew each
    /// time.
    At,
    /// It is never in a front.
    Below,
}

/// A tree of pairs that can be begun at a front.
pub trait FrontTree: PairTree {
    /// Whether a row of leaves comes once with all of its lanes, rather than in pieces.
    const WHOLE_ROWS: bool;
    /// Where a pair is.
    fn place(self, pair: NodePair) -> Place;
    /// Whether the volumes of both nodes overlap, and there is anything below the pair.
    fn meets(self, pair: NodePair) -> bool;
    /// As [`PairTree::expand`] of a pair above all fronts; children that are apart are written to
    /// the front. Those that can have no pair of leaves, whatever the boxes are, are in neither.
    fn expand_all<S: RowSimd>(
        self,
        simd: S,
        pair: NodePair,
        out: &mut Vec<NodePair>,
        front: &mut Writer,
    );
}

/// A tree of pairs behind a pointer.
pub trait Descend: Sync {
    /// Keeps pairs that meet; those that are apart are the front.
    fn keep_meeting(&self, pairs: &mut Vec<NodePair>, front: &mut Option<Writer>);

    /// Appends the children that meet of all pairs that are no leaves, and the leaves. Returns how
    /// many it expanded.
    fn split(&self, pairs: &[NodePair], out: &mut Vec<NodePair>, front: &mut Option<Writer>)
    -> u64;

    /// Expands pairs that meet: rows of leaves go to the traces, other children that meet to `out`.
    fn expand(&self, pairs: &[NodePair], out: &mut Vec<NodePair>, traces: &mut Traces);

    /// Begins at pairs of a front: those that are apart stay in it, those at its deepest stay and
    /// are looked into, all others that meet go to `out`, to be expanded.
    fn resume(&self, pairs: &[NodePair], out: &mut Vec<NodePair>, traces: &mut Traces);
}

/// A source of pairs of nodes, which any scheduler shares out among workers.
pub trait PairsOfNodes: Order {
    /// Calls `run` with the pairs of nodes of these sides.
    fn descend(&mut self, threads: &Threads, sides: Sides, run: &mut dyn FnMut(Pairs));
}

/// Pairs of nodes of two trees, or of one with itself.
pub struct Pairs<'a> {
    /// What descends them.
    pub tree: &'a dyn Descend,
    /// Where a descent begins: every pair of leaves is below exactly one.
    pub roots: &'a [NodePair],
    /// Numbers of the builds of the trees; each build has its own.
    pub builds: [u64; 2],
}

impl<T: FrontTree> Descend for T {
    fn keep_meeting(&self, pairs: &mut Vec<NodePair>, front: &mut Option<Writer>) {
        pairs.retain(|&pair| {
            let meets = self.meets(pair);
            if !meets {
                keep(front, pair);
            }
            meets
        });
    }

    fn split(
        &self,
        pairs: &[NodePair],
        out: &mut Vec<NodePair>,
        front: &mut Option<Writer>,
    ) -> u64 {
        crate::simd::run_rows!(Split { tree: *self, pairs, out, front })
    }

    fn expand(&self, pairs: &[NodePair], out: &mut Vec<NodePair>, traces: &mut Traces) {
        let Traces { rows, front, n_expanded } = traces;
        let tree = *self;
        let work = Whole::<_, false> { tree, pairs, out, rows, front };
        *n_expanded += crate::simd::run_rows!(work);
    }

    fn resume(&self, pairs: &[NodePair], out: &mut Vec<NodePair>, traces: &mut Traces) {
        let Traces { rows, front, n_expanded } = traces;
        let tree = *self;
        let work = Whole::<_, true> { tree, pairs, out, rows, front };
        *n_expanded += crate::simd::run_rows!(work);
    }
}

/// Children of a pair that is no leaf; what is apart, and the pair itself if it stays, goes to the
/// front.
#[inline(always)]
fn expand_one<S: RowSimd, T: FrontTree>(
    tree: T,
    simd: S,
    pair: NodePair,
    out: &mut Vec<NodePair>,
    front: &mut Option<Writer>,
) {
    match front {
        Some(front) => match tree.place(pair) {
            Place::Above => tree.expand_all(simd, pair, out, front),
            Place::At => {
                front.push(pair);
                tree.expand(simd, pair, out);
            }
            Place::Below => tree.expand(simd, pair, out),
        },
        None => tree.expand(simd, pair, out),
    }
}

struct Split<'s, 'f, T> {
    tree: T,
    pairs: &'s [NodePair],
    out: &'s mut Vec<NodePair>,
    front: &'s mut Option<Writer<'f>>,
}

impl<S: RowSimd, T: FrontTree> Work<S> for Split<'_, '_, T> {
    type Out = u64;

    #[inline(always)]
    fn call(self, simd: S) -> u64 {
        let Self { tree, pairs, out, front } = self;
        let mut n_expanded = 0;
        for &pair in pairs {
            if tree.is_leaf(pair) {
                out.push(pair);
            } else {
                n_expanded += 1;
                expand_one(tree, simd, pair, out, front);
            }
        }
        n_expanded
    }
}

/// Expands pairs, or, if they are of a front, what of them meets.
struct Whole<'w, 'r, 'a, 'f, T, const OF_FRONT: bool> {
    tree: T,
    pairs: &'w [NodePair],
    out: &'w mut Vec<NodePair>,
    rows: &'w mut Gathered<'r, 'a>,
    front: &'w mut Option<Writer<'f>>,
}

impl<S: RowSimd, T: FrontTree, const OF_FRONT: bool> Work<S>
    for Whole<'_, '_, '_, '_, T, OF_FRONT>
{
    type Out = u64;

    #[inline(always)]
    fn call(self, simd: S) -> u64 {
        let Self { tree, pairs, out, rows, front } = self;
        let mut n_expanded = 0;
        for &pair in pairs {
            let first = out.len();
            if OF_FRONT {
                let (stays, meets) = (tree.place(pair) == Place::At, tree.meets(pair));
                if !meets {
                    keep(front, pair);
                    continue;
                }
                if !stays {
                    out.push(pair);
                    continue;
                }
                keep(front, pair);
                if !tree.is_leaf(pair) {
                    n_expanded += 1;
                    tree.expand(simd, pair, out);
                }
            } else if !tree.is_leaf(pair) {
                n_expanded += 1;
                expand_one(tree, simd, pair, out, front);
            } else {
                note_leaf(tree, front, pair);
            }
            if tree.is_leaf(pair) {
                emit(tree, simd, pair, rows);
            }
            // Leaves are done at once, so that no list has them.
            let mut n_kept = first;
            for k in first..out.len() {
                let child = out[k];
                if tree.is_leaf(child) {
                    note_leaf(tree, front, child);
                    emit(tree, simd, child, rows);
                } else {
                    out[n_kept] = child;
                    n_kept += 1;
                }
            }
            out.truncate(n_kept);
        }
        n_expanded
    }
}

#[inline(always)]
fn keep(front: &mut Option<Writer>, pair: NodePair) {
    if let Some(front) = front {
        front.push(pair);
    }
}

/// A pair of leaves that was met stays in the front, if it reaches so deep.
#[inline(always)]
fn note_leaf<T: FrontTree>(tree: T, front: &mut Option<Writer>, pair: NodePair) {
    if tree.place(pair) == Place::At {
        keep(front, pair);
    }
}

#[inline(always)]
fn emit<S: RowSimd, T: FrontTree>(tree: T, simd: S, pair: NodePair, rows: &mut Gathered) {
    if T::WHOLE_ROWS {
        tree.rows(simd, pair, &IntoRows::<true>::default(), rows);
    } else {
        tree.rows(simd, pair, &IntoRows::<false>::default(), rows);
    }
}
