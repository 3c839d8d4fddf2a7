//! A SPIR-V module as instructions; `cargo xtask` reads modules by the same file.

/// The words of a module.
pub fn words(bytes: &[u8]) -> Vec<u32> {
    bytes.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect()
}

/// The instructions after the header of five words.
pub fn instructions(words: &[u32]) -> impl Iterator<Item = &[u32]> {
    let mut rest = &words[5..];
    std::iter::from_fn(move || {
        let n = (*rest.first()? >> 16) as usize;
        let (one, others) = rest.split_at(n.max(1));
        rest = others;
        Some(one)
    })
}

pub fn opcode(instruction: &[u32]) -> u32 {
    instruction[0] & 0xffff
}
