//! From pairs of blocks to pairs of boxes that overlap, where boxes are all that there is: no
//! features, no bodies, no times.
//!
//! Most of such boxes overlap no other, and in half of the pairs of blocks no box of the second
//! reaches into the first. So there is no pool of hits as in `block_pairs`: a team of 32 threads
//! takes a pair of blocks, and a thread writes what its box overlaps.
//!
//! Two kernels have this body. In one, teams share through workgroup memory, and all of a workgroup
//! wait for each other. In the other a team is a subgroup, and goes on to its next pair at once.
//!
//! Twin: on a CPU `block_pairs.rs`.

use super::block_candidates::ids;
use super::block_pairs::{Places, entries};
use crate::entry::{Thread, kernel};
use crate::records::{BoxWords, box_at};
use crate::workgroup::{
    add_shared, barrier, get, or_shared, read_pair, reserve, reserve_by_subgroup, set,
    subgroup_barrier, write_pair,
};
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::block_bvh::{TEAMS, WIDTH, sets};
use ccd_core::backend::kernel::memory::at;
use ccd_core::backend::kernel::sort::before;
use ccd_core::backend::layout::{Blocks, EDGE_EDGE, Params};
use spirv_std::arch::subgroup_ballot;

/// What the 32 threads of a team do together. All threads of the workgroup make each call, or, of a
/// team that is [alone](Self::IS_ALONE), all threads of the team.
trait Team {
    /// Whether no other team waits for it.
    const IS_ALONE: bool;
    /// A barrier: what the team wrote to workgroup memory before is seen after.
    fn wait(&self);
    /// The threads of the team for which `is_one` is true, as bits. A barrier as well.
    fn threads(&mut self, is_one: bool) -> u32;
    /// Reserves `n` entries of a list for each thread. Returns the first, or any number if `n` is
    /// 0.
    fn reserve(&mut self, n: u32, list: &mut [u32], params: &Params<Blocks>) -> u32;
}

/// A team that shares through workgroup memory. By team: threads as bits and entries that they
/// reserve, both zero at first, and the first of these entries.
struct Shared<'a> {
    lane: u32,
    threads: &'a mut [u32; 4],
    entries: &'a mut [u32; 4],
    first: &'a mut [u32; 4],
}

impl Team for Shared<'_> {
    const IS_ALONE: bool = false;

    #[inline(always)]
    fn wait(&self) {
        barrier();
    }

    #[inline(always)]
    fn threads(&mut self, is_one: bool) -> u32 {
        if is_one {
            or_shared(self.threads, self.lane / WIDTH, 1 << (self.lane % WIDTH));
        }
        barrier();
        get(self.threads, self.lane / WIDTH)
    }

    #[inline(always)]
    fn reserve(&mut self, n: u32, list: &mut [u32], params: &Params<Blocks>) -> u32 {
        let team = self.lane / WIDTH;
        let before = add_shared(self.entries, team, n);
        barrier();
        if self.lane.is_multiple_of(WIDTH) {
            let all = get(self.entries, team);
            if all > 0 {
                set(self.first, team, reserve(list, all, params));
            }
            set(self.entries, team, 0);
            set(self.threads, team, 0);
        }
        barrier();
        get(self.first, team) + before
    }
}

/// A team that is a subgroup of 32 threads.
struct Subgroup {
    child: u32,
}

impl Team for Subgroup {
    const IS_ALONE: bool = true;

    #[inline(always)]
    fn wait(&self) {
        subgroup_barrier();
    }

    #[inline(always)]
    fn threads(&mut self, is_one: bool) -> u32 {
        subgroup_barrier();
        subgroup_ballot(is_one).x
    }

    #[inline(always)]
    fn reserve(&mut self, n: u32, list: &mut [u32], params: &Params<Blocks>) -> u32 {
        reserve_by_subgroup(list, n, self.child, params)
    }
}

/// Boxes of a workgroup's teams, and which of their blocks they are.
type Columns<'a> = (&'a mut [Aabb; 128], &'a mut [u32; 128]);

/// The pairs of boxes of all pairs of blocks of a dispatch. `columns`: those boxes of the second
/// block that reach into the first.
#[inline(always)]
fn list<T: Team>(
    mut team: T,
    t: Thread,
    params: &Params<Blocks>,
    (columns, names): Columns,
    (nodes, order): (&[BoxWords], &[u32]),
    (input, output): (&[u32], &mut [u32]),
) {
    let Params { frame, dispatch, args } = params;
    let (n, slots) = (entries(params, input), Places::of(args, 1));
    let (child, first) = (t.lane % WIDTH, t.lane / WIDTH * WIDTH);
    let [a, b] = sets(args.kind);
    let (a, b) = (frame.start[a], frame.start[b]);
    let mut four = t.group;
    while four < n.div_ceil(TEAMS) {
        let i = four * TEAMS + t.lane / WIDTH;
        four += t.groups;
        let some = i < n;
        let pair = read_pair(input, dispatch.first + if some { i * args.step } else { 0 });
        let is_one_block = some && args.kind == EDGE_EDGE && pair.a == pair.b;
        let (row_name, name) = (pair.a * WIDTH + child, pair.b * WIDTH + child);
        let block = box_at(nodes, (slots.nodes + pair.a) as usize);
        let column = box_at(nodes, (slots.columns + name) as usize);
        let is_column = is_one_block || some && column.overlaps(&block);
        let chosen = team.threads(is_column);
        if !T::IS_ALONE || chosen != 0 {
            let row = box_at(nodes, (slots.rows + row_name) as usize);
            if is_column {
                let to = first + before(chosen, child);
                set(columns, to, column);
                set(names, to, name);
            }
            team.wait();
            // Within one block a box is tested against the 16 that come after it, around the end,
            // so that each pair is tested once: of two that are opposite, by the first.
            let (turn, n_columns) =
                if is_one_block { (child + 1, WIDTH / 2) } else { (0, chosen.count_ones()) };
            let mut hits = 0;
            // Not `div_ceil`, which takes twice as many instructions.
            for four in 0..(n_columns + 3) / 4 {
                let c = 4 * four;
                let hit =
                    |k: u32| row.overlaps(&get(columns, first + (turn + c + k) % WIDTH)) as u32;
                hits |= (hit(0) | hit(1) << 1 | hit(2) << 2 | hit(3) << 3) << c;
            }
            if is_one_block {
                hits &= 0xffff >> (child / (WIDTH / 2));
            } else if n_columns < WIDTH {
                // Behind the last stands what did before.
                hits &= (1 << n_columns) - 1;
            }
            hits = hits.rotate_left(turn);
            let mut to = team.reserve(hits.count_ones(), output, params);
            if hits != 0 {
                let p = at(order, (a + row_name) as usize) - a;
                while hits != 0 {
                    let name = get(names, first + hits.trailing_zeros());
                    hits &= hits - 1;
                    let q = at(order, (b + name) as usize) - b;
                    write_pair(
                        output,
                        dispatch.capacity_out,
                        to,
                        ids(args.kind == EDGE_EDGE, p, q),
                    );
                    to += 1;
                }
            }
        }
    }
}

kernel! {
    /// From pairs of nodes of level 1 to pairs of boxes that overlap.
    list_overlaps[128](t; params: Blocks; columns: [Aabb; 128], names: [u32; 128],
        threads: [u32; 4], entries: [u32; 4], first: [u32; 4];
        nodes: [BoxWords], order: [u32], input: [u32], mut output: [u32]) {
        if t.lane < TEAMS {
            set(threads, t.lane, 0);
            set(entries, t.lane, 0);
        }
        barrier();
        let team = Shared { lane: t.lane, threads, entries, first };
        list(team, t, params, (columns, names), (nodes, order), (input, output));
    }
}

kernel! {
    /// The same, where subgroups have 32 threads.
    list_overlaps_by_subgroups[128 by (subgroup, lane_of_subgroup)](t; params: Blocks;
        columns: [Aabb; 128], names: [u32; 128];
        nodes: [BoxWords], order: [u32], input: [u32], mut output: [u32]) {
        let team = Subgroup { child: t.lane % WIDTH };
        list(team, t, params, (columns, names), (nodes, order), (input, output));
    }
}
