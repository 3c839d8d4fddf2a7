//! `cargo xtask shaders --checked`: the compiled kernels again, with a check of every index, for
//! tests with `CCD_CHECKED_SHADERS` alone.
//!
//! ```text
//!   before   p = AccessChain view 0 i          i not checked: what is there is the driver's affair
//!   after    ok = i < ArrayLength view         or, of an array, i < its length
//!            p = AccessChain view 0 (ok ? i : 0)
//!            failures += ok ? 0 : 1            of this thread
//!   return   status += failures               one word a kernel, in a binding behind all others
//! ```
//!
//! Works on `ccd-gpu/shaders/*.spv`, so that what is tested is what is shipped, and no nightly is
//! needed. No control flow is added: barriers stay where they are.

use crate::instructions::{instructions, opcode as op, words};
use std::collections::HashMap;
use std::path::Path;

/// Folder of the modules.
const OUT: &str = "target/shaders/checked";

const ENTRY_POINT: u32 = 15;
const TYPE_BOOL: u32 = 20;
const TYPE_INT: u32 = 21;
const TYPE_VECTOR: u32 = 23;
const TYPE_ARRAY: u32 = 28;
const TYPE_RUNTIME_ARRAY: u32 = 29;
const TYPE_STRUCT: u32 = 30;
const TYPE_POINTER: u32 = 32;
const CONSTANT: u32 = 43;
const FUNCTION: u32 = 54;
const PARAMETER: u32 = 55;
const VARIABLE: u32 = 59;
const LOAD: u32 = 61;
const STORE: u32 = 62;
const ACCESS_CHAINS: [u32; 2] = [65, 66];
const PTR_ACCESS_CHAINS: [u32; 2] = [67, 70];
const ARRAY_LENGTH: u32 = 68;
const DECORATE: u32 = 71;
const MEMBER_DECORATE: u32 = 72;
const ADD: u32 = 128;
const SELECT: u32 = 169;
const LESS: u32 = 176;
const ATOMIC_ADD: u32 = 234;
const RETURN: u32 = 253;
const PRIVATE: u32 = 6;
const STORAGE_BUFFER: u32 = 12;
const BLOCK: u32 = 2;
const BINDING: u32 = 33;
const DESCRIPTOR_SET: u32 = 34;
const OFFSET: u32 = 35;

/// Writes all modules.
pub fn run(root: &Path) -> Result<(), String> {
    let out = root.join(OUT);
    std::fs::create_dir_all(&out).map_err(|e| format!("{OUT}: {e}"))?;
    let (mut kernels, mut checks) = (0, 0);
    let files = std::fs::read_dir(root.join("ccd-gpu/shaders")).map_err(|e| e.to_string())?;
    for path in files.flatten().map(|file| file.path()) {
        if path.extension().is_some_and(|e| e == "spv") {
            let name = path.file_name().unwrap_or_default();
            let bytes = std::fs::read(&path).map_err(|e| e.to_string())?;
            let (module, n) =
                checked(&words(&bytes)).map_err(|e| format!("{}: {e}", name.display()))?;
            let bytes: Vec<u8> = module.iter().flat_map(|w| w.to_le_bytes()).collect();
            std::fs::write(out.join(name), bytes).map_err(|e| e.to_string())?;
            (kernels, checks) = (kernels + 1, checks + n);
        }
    }
    println!("{kernels} kernels with {checks} checks of indices in {OUT}");
    Ok(())
}

/// Instructions in the making.
struct Out {
    words: Vec<u32>,
    bound: u32,
}

impl Out {
    fn id(&mut self) -> u32 {
        self.bound += 1;
        self.bound - 1
    }

    fn put(&mut self, op: u32, operands: &[u32]) {
        self.words.push((operands.len() as u32 + 1) << 16 | op);
        self.words.extend_from_slice(operands);
    }

    /// An instruction with a result of a type.
    fn value(&mut self, op: u32, ty: u32, operands: &[u32]) -> u32 {
        let id = self.id();
        self.put(op, &[&[ty, id], operands].concat());
        id
    }

    /// A type.
    fn declare(&mut self, op: u32, operands: &[u32]) -> u32 {
        let id = self.id();
        self.put(op, &[&[id], operands].concat());
        id
    }
}

/// Instructions that define ids of types, constants and pointers.
struct Definitions<'a>(HashMap<u32, &'a [u32]>);

impl<'a> Definitions<'a> {
    fn of(words: &'a [u32]) -> Self {
        let id = |i: &[u32]| match op(i) {
            TYPE_BOOL..=TYPE_POINTER => Some(i[1]),
            CONSTANT | PARAMETER | VARIABLE => Some(i[2]),
            other if ACCESS_CHAINS.contains(&other) => Some(i[2]),
            _ => None,
        };
        Self(instructions(words).filter_map(|i| Some((id(i)?, i))).collect())
    }

    fn get(&self, id: u32) -> Result<&'a [u32], String> {
        self.0.get(&id).copied().ok_or(format!("id {id} is nothing that is known here"))
    }

    fn constant(&self, id: u32) -> Option<u32> {
        self.0.get(&id).filter(|i| op(i) == CONSTANT).map(|i| i[3])
    }

    /// The structure whose last member is the array that a pointer means, and which member that is.
    fn owner(&self, pointer: u32) -> Result<[u32; 2], String> {
        let chain = self.get(pointer)?;
        match (ACCESS_CHAINS.contains(&op(chain)), chain) {
            (true, &[_, _, _, base, member]) => self.constant(member).map(|m| [base, m]),
            _ => None,
        }
        .ok_or(format!("the length of what {pointer} points to is not known"))
    }
}

/// A module with checks, and how many.
fn checked(words: &[u32]) -> Result<(Vec<u32>, usize), String> {
    let known = Definitions::of(words);
    let find = |what: &dyn Fn(&[u32]) -> bool| instructions(words).find(|i| what(i));
    let uint = find(&|i| op(i) == TYPE_INT && i[2] == 32 && i[3] == 0).ok_or("no u32")?[1];
    let boolean = find(&|i| op(i) == TYPE_BOOL).map(|i| i[1]);
    let entry = find(&|i| op(i) == ENTRY_POINT).ok_or("no entry point")?[2];
    let binding = instructions(words)
        .filter(|i| op(i) == DECORATE && i[2] == BINDING)
        .map(|i| i[3] + 1)
        .max()
        .unwrap_or(0);

    let mut new = Out { words: Vec::new(), bound: words[3] };
    let boolean = boolean.unwrap_or_else(|| new.declare(TYPE_BOOL, &[]));
    let [zero, one] = [0, 1].map(|n| new.value(CONSTANT, uint, &[n]));
    let of_failures = new.declare(TYPE_POINTER, &[PRIVATE, uint]);
    let failures = new.value(VARIABLE, of_failures, &[PRIVATE, zero]);
    let record = new.declare(TYPE_STRUCT, &[uint]);
    let of_record = new.declare(TYPE_POINTER, &[STORAGE_BUFFER, record]);
    let of_word = new.declare(TYPE_POINTER, &[STORAGE_BUFFER, uint]);
    let status = new.value(VARIABLE, of_record, &[STORAGE_BUFFER]);
    let declarations = std::mem::take(&mut new.words);
    new.put(DECORATE, &[record, BLOCK]);
    new.put(MEMBER_DECORATE, &[record, 0, OFFSET, 0]);
    new.put(DECORATE, &[status, DESCRIPTOR_SET, 0]);
    new.put(DECORATE, &[status, BINDING, binding]);
    let decorations = std::mem::take(&mut new.words);

    new.words.extend_from_slice(&words[..5]);
    let (mut decorations, mut declarations) = (Some(decorations), Some(declarations));
    let (mut function, mut checks) = (0, 0);
    for i in instructions(words) {
        if (19..=46).contains(&op(i)) || op(i) == VARIABLE {
            new.words.extend(decorations.take().into_iter().flatten());
        }
        match op(i) {
            FUNCTION => {
                new.words.extend(declarations.take().into_iter().flatten());
                function = i[2];
            }
            RETURN if function == entry => {
                let n = new.value(LOAD, uint, &[failures]);
                let word = new.value(ACCESS_CHAINS[0], of_word, &[status, zero]);
                // Scope 1 is the device; no order.
                new.value(ATOMIC_ADD, uint, &[word, one, zero, n]);
            }
            other if PTR_ACCESS_CHAINS.contains(&other) => return Err("pointer arithmetic".into()),
            other if ACCESS_CHAINS.contains(&other) => {
                let mut chain = i.to_vec();
                let mut ty = known.get(known.get(i[3])?[1])?[3];
                for at in 4..i.len() {
                    let (index, list) = (i[at], known.get(ty)?);
                    let constant = known.constant(index);
                    let length = match op(list) {
                        TYPE_STRUCT => {
                            ty = list[2 + constant.ok_or("a member that is no constant")? as usize];
                            continue;
                        }
                        TYPE_ARRAY if constant.is_some() && constant < known.constant(list[3]) => {
                            ty = list[2];
                            continue;
                        }
                        TYPE_VECTOR if constant.is_some_and(|i| i < list[3]) => continue,
                        TYPE_ARRAY => list[3],
                        TYPE_RUNTIME_ARRAY => {
                            let [base, member] = match at {
                                4 => known.owner(i[3])?,
                                5 => [i[3], known.constant(i[4]).ok_or("no member")?],
                                _ => return Err("a list inside of a record".into()),
                            };
                            new.value(ARRAY_LENGTH, uint, &[base, member])
                        }
                        other => return Err(format!("an index into a type of opcode {other}")),
                    };
                    ty = list[2];
                    let fits = new.value(LESS, boolean, &[index, length]);
                    chain[at] = new.value(SELECT, uint, &[fits, index, zero]);
                    let failed = new.value(SELECT, uint, &[fits, zero, one]);
                    let before = new.value(LOAD, uint, &[failures]);
                    let after = new.value(ADD, uint, &[before, failed]);
                    new.put(STORE, &[failures, after]);
                    checks += 1;
                }
                new.words.extend_from_slice(&chain);
                continue;
            }
            _ => {}
        }
        new.words.extend_from_slice(i);
    }
    new.words[3] = new.bound;
    Ok((new.words, checks))
}
