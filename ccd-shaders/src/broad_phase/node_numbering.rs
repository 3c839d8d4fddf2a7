//! Numbers of the nodes of a tree that was joined bottom up; see
//! `ccd_core::broad_phase::node_numbering`.

use crate::records::branch_words;
use crate::workgroup::group;
use ccd_core::broad_phase::node_numbering::{above, place};
use ccd_core::kernel::Id;
use ccd_core::kernel::memory::{at, put};
use ccd_core::layout::{Building, Params};
use spirv_std::glam::{UVec3, UVec4};
use spirv_std::spirv;

const THREADS: u32 = Id::NumberLeaves.threads();

/// Thread `i` finds the place of leaf `i`, puts its box there in the order of the leaves, and
/// writes the branches of the nodes of which it is the first leaf.
#[spirv(compute(threads(256)))]
pub fn number_leaves(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<Building>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] joins: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] order: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] ordered: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] branches: &mut [UVec4],
) {
    let i = group(id, n) * THREADS + lane;
    let set = params.own.set as usize;
    let (first, n_leaves) = (params.frame.start[set], params.frame.count[set]);
    if i < n_leaves {
        let n_internal = n_leaves - 1;
        let to = place(i, n_internal, joins);
        let mut of_box = first + i;
        if params.own.sorted != 0 {
            of_box = at(order, (first + i) as usize);
        }
        put(ordered, (first + to) as usize, of_box);
        let mut node = n_internal + i;
        for _ in 0..n_internal {
            let up = above(node, to, n_internal, joins);
            if !up.there {
                break;
            }
            put(branches, up.number as usize, branch_words(&up.branch));
            node = up.node;
        }
    }
}
