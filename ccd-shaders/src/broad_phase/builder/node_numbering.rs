//! Numbers of the nodes of a tree that was joined bottom up; see
//! `ccd_core::backend::broad_phase::node_numbering`.

use crate::entry::kernel;
use crate::records::branch_words;
use ccd_core::backend::broad_phase::node_numbering::{above, place};
use ccd_core::backend::kernel::memory::{at, put};
use spirv_std::glam::UVec4;

kernel! {
    /// Thread `i` finds the place of leaf `i`, puts its box there in the order of the leaves, and
    /// writes the branches of the nodes of which it is the first leaf.
    number_leaves[256](t; params: Building;; joins: [u32], order: [u32], mut ordered: [u32],
        mut branches: [UVec4]) {
        let i = t.i;
        let set = params.args.set as usize;
        let (first, n_leaves) = (params.frame.start[set], params.frame.count[set]);
        if i < n_leaves {
            let n_internal = n_leaves - 1;
            let to = place(i, n_internal, joins);
            let mut of_box = first + i;
            if params.args.sorted != 0 {
                of_box = at(order, (first + i) as usize);
            }
            put(ordered, (first + to) as usize, of_box);
            let mut node = n_internal + i;
            for _ in 0..n_internal {
                let up = above(node, to, n_internal, joins);
                if !up.exists {
                    break;
                }
                put(branches, up.number as usize, branch_words(&up.branch));
                node = up.node;
            }
        }
    }
}
