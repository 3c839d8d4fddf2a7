//! Simultaneous traversal of block trees by a scheduler's workers; without one it is a level a
//! dispatch, [`Tree::descend`](super::block_bvh::Tree::descend).
//!
//! ```text
//!   all pairs of a level with few nodes, or a front
//!              |  those that meet
//!         tasks of workers   each pair by 32 threads
//!              |
//!     pairs of blocks of 32 boxes, as every descent leaves them
//! ```

use super::block_levels::Levels;
use super::descended::{BlockTrees, Descended, Trees};
use super::scheduled::Scheduled;
use crate::bind::FirstBlockPairs;
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use crate::recorder::Recorder;
use ccd_core::backend::broad_phase::block_bvh::{TEAMS, WIDTH, sets};
use ccd_core::backend::layout::{Frame, NodeDescent};
use ccd_core::model::scheduling::Scheduling;

/// What shares out the pairs of blocks between sets of so many boxes.
pub fn scheduled(
    device: &Device,
    scheduling: Scheduling,
    count: [u32; 3],
) -> Result<Scheduled, Error> {
    // Of nodes of level 2 and above, each overlaps some tens of others; a list that is too short
    // grows.
    let capacity = |n: u32| (n / (WIDTH * WIDTH)).saturating_mul(40).max(4096);
    // A front has pairs of blocks, of which there are more, and grows as well.
    let front = (count[1] / WIDTH).max(count[2] / WIDTH).saturating_mul(40);
    Scheduled::new(device, scheduling, TEAMS, count, capacity, front)
}

/// Lists the pairs of blocks of a kind that overlap, from the pairs of `first` on: all those of the
/// level where a descent begins. `boxes`: of the nodes, which are where `levels` says.
pub fn run(
    scheduled: &Scheduled,
    recorder: &mut Recorder,
    (frame, kind, keeps_order): (&Frame, u32, bool),
    (levels, boxes): (&Levels, &wgpu::Buffer),
    first: &List,
    pairs: &List,
) {
    let slots = levels.slots.map(|slots| sets(kind).map(|set| slots[set]));
    let trees = BlockTrees { boxes, slots };
    let descent = Descended { frame, kind, trees: Trees::Blocks(trees), pairs };
    scheduled.run(recorder, &descent, keeps_order, |recorder, written, (control, tasks)| {
        let args = NodeDescent { capacity_nodes: tasks.capacity(), ..written.args };
        let p = descent.params(args, levels.start(kind), first.capacity());
        let (first, nodes, front) = (first.buffer(), tasks.buffer(), written.front);
        let pairs = pairs.buffer();
        let kernel = FirstBlockPairs { boxes, first, control, nodes, pairs, front };
        recorder.each(&kernel, &trees.params(&p), p.dispatch.n);
    });
}
