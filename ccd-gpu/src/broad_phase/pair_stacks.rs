//! Simultaneous traversal of binary trees with a thread for each pair of two cuts, and a stack for
//! each thread; see `ccd_core::backend::broad_phase::pair_stacks`.
//!
//! ```text
//!   cuts --round 0--> pairs left --round 1--> pairs left --..--> none
//!             |                       |
//!        pairs of leaves         pairs of leaves
//! ```
//!
//! A round leaves what finds a stack full, and what a thread has not come to after so many turns,
//! so that no dispatch takes long. If pairs are left after the last round the search is not
//! complete, and runs again with twice as many turns.

use super::binary_tree::BinaryTree;
use super::descended::{BinaryTrees, Descended, Trees};
use super::pair_descent::{cut_buffer, cut_nodes, n_levels};
use crate::bind::DescendStacks;
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use crate::recorder::Recorder;
use ccd_core::backend::broad_phase::pair_stacks::{CAPACITY, rounds};
use ccd_core::backend::layout::{Frame, NodeDescent};
use ccd_core::model::method::Descent;
use wgpu::BufferUsages as U;

/// Pairs of nodes that a thread expands in a round: more than there are below a pair of a cut of
/// any scene that was measured, and a tenth of a second of a slow thread.
const TURNS: u32 = 1 << 16;
/// Turns on a device that is a CPU, at first and at most: a driver may end the loops of a thread
/// after 65,535 rounds of all of them together ([`Device::groups`]).
const TURNS_ON_CPU: u32 = 1 << 14;
/// Rounds beyond those that stacks need, for what turns leave.
const SPARE: u32 = 2;
/// Most of them: there is a word for each round.
const MOST_SPARE: u32 = 64;
/// Bytes of the words of a kind of pairs: more rounds than there can be, of trees of `2^31` boxes
/// by any builder.
const BYTES: u64 = 4 * 256;

/// Cuts, and the pairs that a round leaves to the next.
pub struct PairStacks {
    nodes: u32,
    rule: Descent,
    cuts: wgpu::Buffer,
    /// By kind: pairs that each round takes from its list.
    rounds: [wgpu::Buffer; 2],
    /// What rounds leave, in turn.
    lists: [List; 2],
    /// A list without entries, for the last round.
    left: List,
    turns: u32,
    most_turns: u32,
    spare: u32,
}

impl PairStacks {
    /// From cuts of so many nodes on.
    pub fn new(device: &Device, nodes: u32, rule: Descent) -> Result<Self, Error> {
        let usage = U::STORAGE | U::COPY_DST;
        let words = || device.buffer("pairs of nodes of each round", BYTES, usage);
        let list = || List::new(device, "pairs of nodes", 2, 4096);
        let short = device.faults().short_rounds;
        let is_cpu = device.info().adapter.device_type == wgpu::DeviceType::Cpu;
        let most_turns = if is_cpu { TURNS_ON_CPU } else { u32::MAX };
        Ok(Self {
            nodes,
            rule,
            cuts: cut_buffer(device)?,
            rounds: [words()?, words()?],
            lists: [list()?, list()?],
            left: List::new(device, "pairs that are left", 0, 0)?,
            turns: if short { 1 } else { TURNS.min(most_turns) },
            most_turns,
            spare: if short { 0 } else { SPARE },
        })
    }

    /// What must be zero before [`PairStacks::run`].
    pub fn clear(&self, recorder: &mut Recorder) {
        self.rounds.iter().for_each(|words| recorder.clear(words, BYTES));
    }

    /// Lists all pairs of leaves of two trees, or of one given twice; by their oriented boxes, too,
    /// if there are.
    pub fn run(
        &self,
        recorder: &mut Recorder,
        (frame, kind): (&Frame, u32),
        trees: [&BinaryTree; 2],
        oriented: Option<&wgpu::Buffer>,
        pairs: &List,
    ) {
        let [a_nodes, b_nodes] = trees.map(|tree| &tree.nodes);
        let n_levels = n_levels(self.rule, trees);
        let larger = (self.rule == Descent::Larger) as u32;
        let both = BinaryTrees { a_nodes, b_nodes, oriented, n_levels, larger };
        let descent = Descended { frame, kind, trees: Trees::Binary(both), pairs };
        let args = NodeDescent {
            nodes: self.nodes,
            stack: CAPACITY as u32,
            turns: self.turns,
            ..NodeDescent::default()
        };
        cut_nodes(recorder, &descent, args, trees, &self.cuts);
        let n_rounds = rounds(n_levels, args.stack) + self.spare;
        let (rounds, pairs) = (&self.rounds[kind as usize], pairs.buffer());
        for round in 0..n_rounds {
            let before = &self.lists[(round as usize + 1) % 2];
            let (input, n) = match round {
                0 => (&self.cuts, self.nodes * self.nodes),
                _ => (before.buffer(), before.capacity()),
            };
            let is_last = round + 1 == n_rounds;
            let output = if is_last { &self.left } else { &self.lists[round as usize % 2] };
            let args = NodeDescent { capacity_nodes: output.capacity(), ..args };
            let mut p = descent.params(args, round, n);
            p.dispatch.capacity_in = before.capacity();
            let output = output.buffer();
            let kernel = DescendStacks { a_nodes, b_nodes, input, rounds, output, pairs };
            recorder.each_variant(&kernel, oriented, &p, n);
        }
    }

    pub fn lists(&self) -> impl Iterator<Item = &List> {
        self.lists.iter().chain([&self.left])
    }

    pub fn lists_mut(&mut self) -> impl Iterator<Item = &mut List> {
        self.lists.iter_mut().chain([&mut self.left])
    }

    /// A search is over, and [`List::grow_all`] has seen what was wanted of each list.
    pub fn settle(&mut self) {
        if self.left.was_short() {
            self.turns = self.turns.saturating_mul(2).min(self.most_turns);
            self.spare = (2 * self.spare + 1).min(MOST_SPARE);
        }
    }
}
