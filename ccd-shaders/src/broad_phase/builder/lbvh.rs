//! LBVH: every internal node finds its range by itself [Karras 2012].

use crate::entry::kernel;
use crate::records::branch_words;
use ccd_core::backend::broad_phase::radix_tree;
use ccd_core::backend::kernel::memory::put;
use spirv_std::glam::UVec4;

kernel! {
    /// Thread `i` finds children and range of internal node `i` of the tree over set `args.kind`.
    branches[256](t; params: Blocks;; keys: [u32], mut branches: [UVec4]) {
        let i = t.i;
        let set = params.args.kind as usize;
        let n_leaves = params.frame.count[set];
        if i + 1 < n_leaves {
            let branch = radix_tree::branch_from(i, params.frame.start[set], n_leaves, keys);
            put(branches, i as usize, branch_words(&branch));
        }
    }
}
