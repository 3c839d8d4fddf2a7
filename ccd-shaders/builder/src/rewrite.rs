//! What modules need before they run elsewhere than in rust-gpu's own runner: the memory model that
//! hosts enable, no contraction, and no function that a driver may not inline.

use super::instructions::{self, instructions, opcode};
use std::collections::HashSet;

const OP_NO_LINE: u32 = 317;
const OP_LINE: u32 = 8;
const OP_EXTENSION: u32 = 10;
const OP_MEMORY_MODEL: u32 = 14;
const OP_CAPABILITY: u32 = 17;
const OP_TYPE_INT: u32 = 21;
const OP_TYPE_FLOAT: u32 = 22;
const OP_CONSTANT: u32 = 43;
const OP_FUNCTION: u32 = 54;
const OP_LOAD: u32 = 61;
const OP_STORE: u32 = 62;
const OP_DECORATE: u32 = 71;
/// Negation, sum, difference, product, quotient, remainders, product of a vector and a number.
const OP_ARITHMETIC: [u32; 8] = [127, 129, 131, 133, 136, 140, 141, 142];
const OP_CONTROL_BARRIER: u32 = 224;
const OP_MEMORY_BARRIER: u32 = 225;
const OP_ATOMICS: std::ops::RangeInclusive<u32> = 227..=242;
const OP_ATOMIC_STORE: u32 = 228;
const OP_ATOMIC_COMPARE_EXCHANGE: u32 = 230;
const CAPABILITY_FLOAT64: u32 = 10;
const CAPABILITY_INT64: u32 = 11;
/// Those of operations between the threads of a subgroup, and the operations.
const CAPABILITIES_SUBGROUP: std::ops::RangeInclusive<u32> = 61..=68;
const OPS_SUBGROUP: std::ops::RangeInclusive<u32> = 333..=366;
const CAPABILITIES_VULKAN_MEMORY_MODEL: [u32; 2] = [5345, 5346];
const DECORATION_NO_CONTRACTION: u32 = 42;
const GLSL450: u32 = 1;
const SCOPE_DEVICE: u32 = 1;
const SCOPE_QUEUE_FAMILY: u32 = 5;
const SEMANTICS_AVAILABLE_VISIBLE: u32 = 0x2000 | 0x4000 | 0x8000;

/// Without line numbers of sources, which would name the folders of whoever built them.
pub fn without_lines(words: &[u32]) -> Vec<u32> {
    let mut out = words[..5].to_vec();
    instructions(words)
        .filter(|i| ![OP_LINE, OP_NO_LINE].contains(&opcode(i)))
        .for_each(|i| out.extend_from_slice(i));
    out
}

/// Replaces the Vulkan memory model by GLSL's, which needs no feature of the device: drops its
/// capabilities and those of unused number types and subgroups, widens the scope of a queue family
/// to the device, strips availability and visibility (implied there).
pub fn glsl_memory_model(words: &[u32]) -> Result<Vec<u32>, String> {
    let uses = |op: u32, bits: u32| instructions(words).any(|i| opcode(i) == op && i[2] == bits);
    let (float64, int64) = (uses(OP_TYPE_FLOAT, 64), uses(OP_TYPE_INT, 64));
    let subgroups = instructions(words).any(|i| OPS_SUBGROUP.contains(&opcode(i)));
    let uint = instructions(words)
        .find(|i| opcode(i) == OP_TYPE_INT && i[2] == 32 && i[3] == 0)
        .map(|i| i[1]);
    let constant = |id: u32| {
        instructions(words).find(|i| opcode(i) == OP_CONSTANT && i[2] == id).map(|i| i[3])
    };
    let mut bound = words[3];
    let mut added: Vec<[u32; 4]> = Vec::new();
    let mut of_value = |value: u32| -> Result<u32, String> {
        if let Some(known) = added.iter().find(|c| c[3] == value) {
            return Ok(known[2]);
        }
        let uint = uint.ok_or("a module with atomics and no u32")?;
        bound += 1;
        added.push([4 << 16 | OP_CONSTANT, uint, bound - 1, value]);
        Ok(bound - 1)
    };
    let mut body: Vec<Vec<u32>> = Vec::new();
    for instruction in instructions(words) {
        let op = opcode(instruction);
        let mut instruction = instruction.to_vec();
        let (scopes, semantics): (Vec<usize>, Vec<usize>) = match op {
            OP_CAPABILITY => {
                let unused = instruction[1] == CAPABILITY_FLOAT64 && !float64
                    || instruction[1] == CAPABILITY_INT64 && !int64
                    || CAPABILITIES_SUBGROUP.contains(&instruction[1]) && !subgroups;
                if unused || CAPABILITIES_VULKAN_MEMORY_MODEL.contains(&instruction[1]) {
                    continue;
                }
                (vec![], vec![])
            }
            OP_EXTENSION => {
                let text: Vec<u8> = instruction[1..].iter().flat_map(|w| w.to_le_bytes()).collect();
                if text.starts_with(b"SPV_KHR_vulkan_memory_model") {
                    continue;
                }
                (vec![], vec![])
            }
            OP_MEMORY_MODEL => {
                instruction[2] = GLSL450;
                (vec![], vec![])
            }
            OP_LOAD if instruction.len() > 4 && instruction[4] & 0x38 != 0 => {
                return Err("a load with memory operands".into());
            }
            OP_STORE if instruction.len() > 3 && instruction[3] & 0x38 != 0 => {
                return Err("a store with memory operands".into());
            }
            OP_CONTROL_BARRIER => (vec![1, 2], vec![3]),
            OP_MEMORY_BARRIER => (vec![1], vec![2]),
            OP_ATOMIC_STORE => (vec![2], vec![3]),
            OP_ATOMIC_COMPARE_EXCHANGE => (vec![4], vec![5, 6]),
            _ if OP_ATOMICS.contains(&op) => (vec![4], vec![5]),
            _ => (vec![], vec![]),
        };
        for at in scopes {
            if constant(instruction[at]) == Some(SCOPE_QUEUE_FAMILY) {
                instruction[at] = of_value(SCOPE_DEVICE)?;
            }
        }
        for at in semantics {
            let value = constant(instruction[at]).ok_or("memory semantics that are no constant")?;
            if value & SEMANTICS_AVAILABLE_VISIBLE != 0 {
                instruction[at] = of_value(value & !SEMANTICS_AVAILABLE_VISIBLE)?;
            }
        }
        body.push(instruction);
    }
    let mut out = words[..5].to_vec();
    out[3] = bound;
    let mut constants = Some(added);
    for instruction in body {
        if opcode(&instruction) == OP_FUNCTION {
            constants.take().into_iter().flatten().for_each(|c| out.extend_from_slice(&c));
        }
        out.extend_from_slice(&instruction);
    }
    Ok(out)
}

/// Decorates every result of floating-point arithmetic with `NoContraction`, so that no driver
/// fuses or reorders it.
pub fn forbid_contraction(words: &[u32]) -> Vec<u32> {
    let decorated: HashSet<u32> = instructions(words)
        .filter(|i| opcode(i) == OP_DECORATE && i[2] == DECORATION_NO_CONTRACTION)
        .map(|i| i[1])
        .collect();
    let results = instructions(words).filter(|i| OP_ARITHMETIC.contains(&opcode(i))).map(|i| i[2]);
    let missing: Vec<u32> = results.filter(|id| !decorated.contains(id)).collect();
    let mut out = words[..5].to_vec();
    let mut missing = Some(missing);
    for instruction in instructions(words) {
        // Decorations stand together; types, which come next, are never the first thing that is
        // decorated here.
        let types = (19..=46).contains(&opcode(instruction)) || opcode(instruction) == 59;
        if types && let Some(ids) = missing.take() {
            ids.iter().for_each(|&id| {
                out.extend_from_slice(&[3 << 16 | OP_DECORATE, id, DECORATION_NO_CONTRACTION])
            });
        }
        out.extend_from_slice(instruction);
    }
    out
}

/// Leaves it to drivers what they inline, which may be all. NVIDIA's (580.159, an H100) returns
/// wrong numbers from functions marked `DontInline` whose parameters are integers.
pub fn may_be_inlined(words: &[u32]) -> Vec<u32> {
    const NONE: u32 = 0;
    let mut out = words[..5].to_vec();
    for instruction in instructions(words) {
        let at = out.len();
        out.extend_from_slice(instruction);
        if opcode(instruction) == OP_FUNCTION {
            out[at + 3] = NONE;
        }
    }
    out
}

/// Names the entry point by the last part of its path.
pub fn plain_name(words: &[u32]) -> Vec<u32> {
    const OP_ENTRY_POINT: u32 = 15;
    let mut out = words[..5].to_vec();
    for instruction in instructions(words) {
        if opcode(instruction) != OP_ENTRY_POINT {
            out.extend_from_slice(instruction);
            continue;
        }
        let bytes: Vec<u8> = instruction[3..].iter().flat_map(|w| w.to_le_bytes()).collect();
        let end = bytes.iter().position(|&b| b == 0).unwrap_or(bytes.len());
        let name = &bytes[..end];
        let start = name.windows(2).rposition(|w| w == b"::").map_or(0, |i| i + 2);
        let mut short = name[start..].to_vec();
        short.resize(short.len() / 4 * 4 + 4, 0);
        let interface = &instruction[3 + end / 4 + 1..];
        out.push(((3 + short.len() / 4 + interface.len()) as u32) << 16 | OP_ENTRY_POINT);
        out.extend_from_slice(&instruction[1..3]);
        out.extend(instructions::words(&short));
        out.extend_from_slice(interface);
    }
    out
}
