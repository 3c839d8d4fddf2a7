//! Which boxes a call makes anew where it is told what moves: those of the bodies that move in it
//! or moved in the call before. All others are where they were, in boxes, in leaves and in the
//! table.

use crate::broad_phase::runs::join;
use crate::simd::WIDTH;
use ccd_core::backend::rules::Rules;
use ccd_core::model::session::RunsOfBodies;
use std::ops::Range;

/// Where more than one vertex of so many is elsewhere than in the call before, all boxes are made:
/// in one pass over all, not in many over some.
const ONE_OF: usize = 4;

/// Whether calls may be told what moves. Not on WebAssembly: the npm package, whose size counts,
/// has no such call.
pub const IS_TOLD: bool = !cfg!(target_family = "wasm");

/// What moves; sets are vertices, edges, faces.
#[derive(Debug, Default)]
pub struct Movers {
    /// Whether boxes of all else hold in this call.
    on: bool,
    /// Whether few vertices are elsewhere than in the call before.
    few: bool,
    /// The bodies of these, by number, and those of them that are not moved by their trees.
    bodies: Vec<u32>,
    unposed: Vec<u32>,
    /// Vertices that have new boxes.
    vertices: Vec<Range<usize>>,
    /// By set: blocks of leaves that do.
    blocks: [Vec<Range<usize>>; 3],
    /// By body: vertices, and by set blocks of leaves. Made when they are needed.
    of_bodies: Option<RunsOfBodies>,
    leaves: Option<[RunsOfBodies; 3]>,
}

impl Movers {
    /// Begins a call in which vertices in `runs`, each of one body, are elsewhere than before.
    /// `posed`: whether a vertex is of a body whose edges and faces are moved by its tree.
    pub fn begin(&mut self, rules: &Rules, runs: &[Range<u32>], posed: impl Fn(u32) -> bool) {
        self.pause();
        let most = rules.words().len() / ONE_OF;
        // A vertex that moves in both calls is in two runs.
        if runs.iter().map(|run| run.len()).sum::<usize>() > 2 * most {
            return;
        }
        let number = |v: u32| rules.word(v) >> 2;
        let Self { bodies, unposed, .. } = self;
        bodies.clear();
        unposed.clear();
        for run in runs.iter().filter(|run| !run.is_empty()) {
            bodies.push(number(run.start));
            if !posed(run.start) {
                unposed.push(number(run.start));
            }
        }
        for bodies in [bodies, unposed] {
            bodies.sort_unstable();
            bodies.dedup();
        }
        let of_bodies = self.of_bodies.get_or_insert_with(|| {
            RunsOfBodies::new((0..).zip(rules.words()).map(|(v, word)| (word >> 2, v)))
        });
        // Also vertices of what is posed.
        gather(of_bodies, &self.bodies, &mut self.vertices);
        self.few = self.vertices.iter().map(|run| run.len()).sum::<usize>() <= most;
    }

    /// Has a call make all boxes.
    pub fn pause(&mut self) {
        (self.few, self.on) = (false, false);
    }

    /// Whether all other boxes hold, if those of the call before do.
    pub fn turn(&mut self, holds: bool) {
        self.on = self.few && holds;
    }

    /// Whether all other boxes hold.
    pub fn is_on(&self) -> bool {
        IS_TOLD && self.on
    }

    /// Vertices that have new boxes.
    pub fn vertices(&self) -> &[Range<usize>] {
        &self.vertices
    }

    /// Forgets the order of leaves.
    pub fn forget_order(&mut self) {
        self.leaves = None;
    }

    /// Finds the blocks of leaves that are made anew. By set, of the leaves that are neither posed
    /// nor still: the first vertices of each block.
    pub fn find_blocks<'a>(
        &mut self,
        rules: &Rules,
        first: [&dyn Fn(usize) -> Option<&'a [u32; WIDTH]>; 3],
    ) {
        let leaves = self.leaves.get_or_insert_with(|| {
            first.map(|of| {
                let blocks = (0..).map_while(|i| Some((i as u32, of(i)?)));
                RunsOfBodies::new(blocks.flat_map(|(i, ids)| {
                    let numbers = ids.map(|v| rules.word(v) >> 2);
                    let is_new = move |lane: &usize| !numbers[..*lane].contains(&numbers[*lane]);
                    (0..WIDTH).filter(is_new).map(move |lane| (numbers[lane], i))
                }))
            })
        });
        for (of, blocks) in leaves.iter().zip(&mut self.blocks) {
            gather(of, &self.unposed, blocks);
        }
    }

    /// Blocks of leaves of a set that are made anew, among those that are neither posed nor still.
    pub fn blocks(&self, set: usize) -> &[Range<usize>] {
        &self.blocks[set]
    }
}

/// All that these bodies have, in `runs`, sorted and apart.
fn gather(all: &RunsOfBodies, bodies: &[u32], runs: &mut Vec<Range<usize>>) {
    runs.clear();
    for &body in bodies {
        let of_body = all.of(body as usize).iter();
        runs.extend(of_body.map(|run| run.start as usize..run.end as usize));
    }
    runs.sort_unstable_by_key(|run| run.start);
    join(runs);
}
