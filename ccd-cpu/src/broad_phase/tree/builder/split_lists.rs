//! LBVH by split lists: neighbours of the sorted Morton codes part at a level each, and every level
//! has a list of where they did [Lauterbach 2009].
//!
//! What the lists are is said in [`ccd_core::backend::broad_phase::split_lists`]. Here they are one
//! array, sorted by level and then by place, as in the paper: every thread counts how many entries
//! its places have on each level, the sums of the counts say where they go, and every thread writes
//! its own. The tree is that of [`super::lbvh`], node by node.
//!
//! Cost: the sort of the codes, and per box the two to four entries that it has on the lists; up to
//! as many as there are different levels where close neighbours lie among far ones. When to choose
//! it: to learn how trees were built from codes before every node could be found by itself; [Karras
//! 2012] needs no lists.

use super::TreeBuilder;
use crate::broad_phase::curve_order::CurveOrder;
use crate::broad_phase::tree::shared_words::{Shared, copy, copy_branches};
use crate::threads::Threads;
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::node_numbering::{BRANCH, store_branch};
use ccd_core::backend::broad_phase::split_lists::{MAX_LEVELS, NONE, branch, last_level, level};
use ccd_core::backend::kernel::Words;
use ccd_core::backend::layout::Branch;
use std::sync::atomic::AtomicU32;

/// Places that a task counts and writes.
const CHUNK: usize = 4096;

/// The lists of all levels; buffers are kept.
#[derive(Debug, Default)]
pub struct SplitLists {
    codes: Vec<[u32; 2]>,
    levels: Vec<u32>,
    chunks: Vec<Chunk>,
    written: Vec<AtomicU32>,
    list: Vec<u32>,
    branches: Vec<AtomicU32>,
}

/// Of some places: which levels they have, and how many entries on each; then where the next goes.
#[derive(Debug)]
struct Chunk {
    present: u128,
    entries: [usize; MAX_LEVELS],
}

impl TreeBuilder for SplitLists {
    fn build(
        &mut self,
        threads: &Threads,
        morton: &mut CurveOrder,
        boxes: &[Aabb<f32>],
        order: &mut Vec<u32>,
        branches: &mut Vec<Branch>,
    ) {
        let (n, codes) = (boxes.len(), &mut self.codes);
        morton.sort_codes(threads, boxes, order, codes);
        self.levels.resize(n.saturating_sub(1), 0);
        threads.fill(&mut self.levels, |i| level(i, 0, codes));
        let begins = self.write_lists(threads);
        let Self { levels, list, branches: words, .. } = self;
        words.resize_with(levels.len() * BRANCH, AtomicU32::default);
        let words = Shared(words);
        for (level, begin_end) in begins.windows(2).enumerate() {
            let (begin, end) = (begin_end[0], begin_end[1]);
            threads.fill(&mut vec![(); end - begin], |k| {
                let n_internal = levels.len() as u32;
                let (number, branch) =
                    branch(begin + k, level as u32, [begin, end], n_internal, list, levels);
                if number != NONE {
                    store_branch(number, &branch, &words);
                }
            });
        }
        copy_branches(threads, words.0, branches);
    }
}

impl SplitLists {
    /// Numbers the levels that occur without gaps, and writes their lists one after the other;
    /// returns where each begins, and where the last ends.
    fn write_lists(&mut self, threads: &Threads) -> [usize; MAX_LEVELS + 1] {
        let Self { levels, chunks, written, list, .. } = self;
        let n = levels.len();
        chunks.resize_with(n.div_ceil(CHUNK), || Chunk { present: 0, entries: [0; MAX_LEVELS] });
        let range = |k: usize| k * CHUNK..((k + 1) * CHUNK).min(n);
        threads.each(chunks, &|k, chunk| {
            chunk.present = levels[range(k)].iter().fold(0, |all, &level| all | 1 << level);
        });
        let present = chunks.iter().fold(0, |all, chunk| all | chunk.present);
        let rank = |level: u32| (present & ((1 << level) - 1)).count_ones();
        threads.update(levels, rank);
        threads.each(chunks, &|k, chunk| {
            chunk.entries.fill(0);
            for i in range(k) {
                for level in levels[i]..=last_level(i, n, levels) {
                    chunk.entries[level as usize] += 1;
                }
            }
        });
        let mut begins = [0; MAX_LEVELS + 1];
        let mut total = 0;
        for level in 0..MAX_LEVELS {
            begins[level] = total;
            for chunk in chunks.iter_mut() {
                let here = chunk.entries[level];
                chunk.entries[level] = total;
                total += here;
            }
        }
        begins[MAX_LEVELS] = total;
        written.resize_with(total, AtomicU32::default);
        let out = Shared(written);
        threads.each(chunks, &|k, chunk| {
            for i in range(k) {
                for level in levels[i]..=last_level(i, n, levels) {
                    let entry = &mut chunk.entries[level as usize];
                    out.store(*entry, i as u32);
                    *entry += 1;
                }
            }
        });
        copy(threads, written, list);
        begins
    }
}
