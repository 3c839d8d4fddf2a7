//! Branches that only choose between values become `OpSelect`.
//!
//! rust-gpu compiles `if a < b { a } else { b }` to four blocks, and a translator to WGSL declares
//! a variable for it. There are hundreds in a kernel, and drivers take seconds over as many blocks.

use super::instructions::{instructions, opcode};
use std::collections::{HashMap, HashSet};

const OP_TYPE_BOOL: u32 = 20;
const OP_TYPE_FLOAT: u32 = 22;
const OP_TYPE_ARRAY: u32 = 28;
const OP_TYPE_STRUCT: u32 = 30;
const OP_CONSTANT: u32 = 43;
const OP_FUNCTION_END: u32 = 56;
const OP_COMPOSITE_CONSTRUCT: u32 = 80;
const OP_COMPOSITE_EXTRACT: u32 = 81;
const OP_SELECT: u32 = 169;
const OP_PHI: u32 = 245;
const OP_LOOP_MERGE: u32 = 246;
const OP_SELECTION_MERGE: u32 = 247;
const OP_LABEL: u32 = 248;
const OP_BRANCH: u32 = 249;
const OP_BRANCH_CONDITIONAL: u32 = 250;
const OP_SWITCH: u32 = 251;

/// Instructions of a side that are computed even if the other side is chosen.
const MOST: usize = 8;

/// Whether an instruction may be computed for nothing: it reads no memory, has no effect, and is
/// no division or call.
fn is_cheap(op: u32) -> bool {
    const COMPOSITES: [u32; 4] = [80, 81, 82, 83];
    const ARITHMETIC: [u32; 8] = [126, 127, 128, 129, 130, 131, 132, 133];
    COMPOSITES.contains(&op)
        || (109..=115).contains(&op) // Conversions.
        || op == 124 // Bits of another type.
        || ARITHMETIC.contains(&op)
        || [156, 157].contains(&op) // NaN and infinity.
        || (164..=191).contains(&op) // Logic, selection, comparisons.
        || (194..=200).contains(&op) // Shifts and bits.
}

struct Block {
    label: u32,
    /// Phis first, the terminator last.
    body: Vec<Vec<u32>>,
}

impl Block {
    fn terminator(&self) -> &[u32] {
        self.body.last().map_or(&[], |i| i)
    }

    fn targets(&self) -> Vec<u32> {
        let end = self.terminator();
        match end.first().map(|_| opcode(end)) {
            Some(OP_BRANCH) => vec![end[1]],
            Some(OP_BRANCH_CONDITIONAL) => vec![end[2], end[3]],
            // Literals are of one word: no kernel switches over 64 bits.
            Some(OP_SWITCH) => [end[2]].iter().chain(end[4..].iter().step_by(2)).copied().collect(),
            _ => vec![],
        }
    }

    fn has_merge(&self) -> bool {
        let before_end = self.body.iter().nth_back(1).map(|i| opcode(i));
        before_end.is_some_and(|op| [OP_SELECTION_MERGE, OP_LOOP_MERGE].contains(&op))
    }
}

/// The types of values that are selected, and the numbers of new values.
struct Values {
    /// The scalars that a type consists of: of a scalar itself, of a short structure or array its
    /// members.
    scalars: HashMap<u32, Vec<u32>>,
    bound: u32,
}

impl Values {
    fn of(words: &[u32]) -> Self {
        let mut constants = HashMap::new();
        let mut scalars: HashMap<u32, Vec<u32>> = HashMap::new();
        for i in instructions(words) {
            let members = match opcode(i) {
                OP_CONSTANT => {
                    constants.insert(i[2], i[3]);
                    continue;
                }
                OP_TYPE_BOOL..=OP_TYPE_FLOAT => vec![i[1]],
                OP_TYPE_ARRAY => vec![i[2]; constants.get(&i[3]).map_or(0, |&n| n as usize)],
                OP_TYPE_STRUCT => i[2..].to_vec(),
                _ => continue,
            };
            let is_scalar = |of: &u32| *of == i[1] || scalars.get(of).is_some_and(|m| m == &[*of]);
            if (1..=MOST).contains(&members.len()) && members.iter().all(is_scalar) {
                scalars.insert(i[1], members);
            }
        }
        Self { scalars, bound: words[3] }
    }

    fn new(&mut self) -> u32 {
        self.bound += 1;
        self.bound - 1
    }

    /// `id`, of a type, as the one or the other value, member by member: whole structures can be
    /// selected from SPIR-V 1.4 on.
    fn select(&mut self, [ty, id]: [u32; 2], condition: u32, sides: [u32; 2]) -> Vec<Vec<u32>> {
        let members = self.scalars[&ty].clone();
        if members == [ty] {
            return vec![vec![6 << 16 | OP_SELECT, ty, id, condition, sides[0], sides[1]]];
        }
        let mut out = Vec::new();
        let mut whole = vec![(3 + members.len() as u32) << 16 | OP_COMPOSITE_CONSTRUCT, ty, id];
        for (i, &member) in members.iter().enumerate() {
            let of = sides.map(|side| {
                let id = self.new();
                out.push(vec![5 << 16 | OP_COMPOSITE_EXTRACT, member, id, side, i as u32]);
                id
            });
            let id = self.new();
            out.push(vec![6 << 16 | OP_SELECT, member, id, condition, of[0], of[1]]);
            whole.push(id);
        }
        out.push(whole);
        out
    }
}

/// The module with a selection for every branch that two short sides without effects lead from.
pub fn selects(words: &[u32]) -> Vec<u32> {
    let mut values = Values::of(words);
    let mut out = words[..5].to_vec();
    let mut blocks: Vec<Block> = Vec::new();
    let mut inside = false;
    for instruction in instructions(words) {
        match opcode(instruction) {
            OP_LABEL => {
                inside = true;
                blocks.push(Block { label: instruction[1], body: Vec::new() });
            }
            OP_FUNCTION_END => {
                inside = false;
                while fold(&mut blocks, &mut values) {}
                for block in blocks.drain(..) {
                    out.extend([2 << 16 | OP_LABEL, block.label]);
                    block.body.iter().for_each(|i| out.extend_from_slice(i));
                }
                out.extend_from_slice(instruction);
            }
            _ => match blocks.last_mut().filter(|_| inside) {
                Some(block) => block.body.push(instruction.to_vec()),
                None => out.extend_from_slice(instruction),
            },
        }
    }
    out[3] = values.bound;
    out
}

/// What a pass over a function asks of it.
struct Flow {
    /// Where the block of a label stands.
    at: HashMap<u32, usize>,
    /// The blocks that lead to a label.
    before: HashMap<u32, Vec<u32>>,
    /// How many selections and loops a label ends, or goes on with.
    ends: HashMap<u32, usize>,
}

impl Flow {
    fn of(blocks: &[Block]) -> Self {
        let at = blocks.iter().enumerate().map(|(i, b)| (b.label, i)).collect();
        let mut flow = Self { at, before: HashMap::new(), ends: HashMap::new() };
        for block in blocks {
            for target in block.targets() {
                flow.before.entry(target).or_default().push(block.label);
            }
            for i in &block.body {
                let ended: &[u32] = match opcode(i) {
                    OP_SELECTION_MERGE => &i[1..2],
                    OP_LOOP_MERGE => &i[1..3],
                    _ => &[],
                };
                ended.iter().for_each(|&label| *flow.ends.entry(label).or_default() += 1);
            }
        }
        flow
    }

    /// Whether block `to` comes after `from` alone and ends at most `ended` selections.
    fn follows(&self, to: u32, from: u32, ended: usize) -> bool {
        self.before[&to] == [from] && self.ends.get(&to).copied().unwrap_or(0) <= ended
    }
}

/// Folds what can be folded in one pass over a function; whether anything was.
fn fold(blocks: &mut Vec<Block>, values: &mut Values) -> bool {
    let mut flow = Flow::of(blocks);
    let mut gone: HashSet<u32> = HashSet::new();
    for head in 0..blocks.len() {
        let label = blocks[head].label;
        if gone.contains(&label) {
            continue;
        }
        // The selection that this block ends in, if it was one, is no more.
        let mut ended = 0;
        if let Some((merge, sides)) = choose(blocks, head, &flow, values) {
            gone.extend(sides);
            flow.before.insert(merge, vec![label]);
            ended = 1;
        }
        while let [next] = blocks[head].targets()[..]
            && !blocks[head].has_merge()
            && next != label
            && flow.follows(next, label, ended)
            && blocks[flow.at[&next]].body.first().is_some_and(|i| opcode(i) != OP_PHI)
        {
            ended = 0;
            let rest = std::mem::take(&mut blocks[flow.at[&next]].body);
            blocks[head].body.pop();
            blocks[head].body.extend(rest);
            gone.insert(next);
            let renamed = |of: &mut u32| {
                if *of == next {
                    *of = label;
                }
            };
            for target in blocks[head].targets() {
                flow.before.entry(target).or_default().iter_mut().for_each(renamed);
                let phis = blocks[flow.at[&target]].body.iter_mut();
                for phi in phis.take_while(|i| opcode(i) == OP_PHI) {
                    phi[4..].iter_mut().step_by(2).for_each(renamed);
                }
            }
        }
    }
    blocks.retain(|block| !gone.contains(&block.label));
    !gone.is_empty()
}

/// Replaces the branch at the end of a block, if both of its sides are short and meet again.
/// Returns where they meet and the blocks that are no more.
fn choose(
    blocks: &mut [Block],
    head: usize,
    flow: &Flow,
    values: &mut Values,
) -> Option<(u32, Vec<u32>)> {
    let label = blocks[head].label;
    let [.., selection, branch] = &blocks[head].body[..] else { return None };
    let is_branch =
        opcode(selection) == OP_SELECTION_MERGE && opcode(branch) == OP_BRANCH_CONDITIONAL;
    if !is_branch || branch[2] == branch[3] {
        return None;
    }
    let (merge, condition, sides) = (selection[1], branch[1], [branch[2], branch[3]]);
    // Where a side comes from, and what is computed in it.
    let side = |side: u32| {
        if side == merge {
            return Some((label, Vec::new()));
        }
        let (end, body) = blocks[flow.at[&side]].body.split_last()?;
        let is_short = body.len() <= MOST && body.iter().all(|i| is_cheap(opcode(i)));
        let leads_on = opcode(end) == OP_BRANCH && end[1] == merge;
        (is_short && leads_on && flow.follows(side, label, 0)).then(|| (side, body.to_vec()))
    };
    let [(from, then), (_, other)] = [side(sides[0])?, side(sides[1])?];
    let meeting = &blocks[flow.at[&merge]].body;
    let phis = meeting.iter().take_while(|i| opcode(i) == OP_PHI).count();
    let can_be_chosen = meeting[..phis].iter().all(|phi| values.scalars.contains_key(&phi[1]));
    if flow.before[&merge].len() != 2 || !can_be_chosen {
        return None;
    }
    let phis: Vec<Vec<u32>> = blocks[flow.at[&merge]].body.drain(..phis).collect();
    let body = &mut blocks[head].body;
    body.truncate(body.len() - 2);
    body.extend(then.into_iter().chain(other));
    for phi in phis {
        let sides = if phi[4] == from { [phi[3], phi[5]] } else { [phi[5], phi[3]] };
        body.extend(values.select([phi[1], phi[2]], condition, sides));
    }
    body.push(vec![2 << 16 | OP_BRANCH, merge]);
    Some((merge, sides.into_iter().filter(|&side| side != merge).collect()))
}
