//! Both modules of a kernel in few bytes; `shaders.rs` of ccd-gpu has the format and unpacks.

/// The words of SPIR-V and the text of WGSL, packed and compressed.
pub fn packed(spirv: &[u32], wgsl: &[u8]) -> Vec<u8> {
    let mut out = Vec::new();
    push_varint(&mut out, spirv.len() as u64);
    let mut id = 0;
    for &word in spirv {
        if (256..65536).contains(&word) {
            let step = i64::from(word) - i64::from(id);
            push_varint(&mut out, ((step << 1 ^ step >> 63) as u64) << 1 | 1);
            id = word;
        } else {
            push_varint(&mut out, u64::from(word) << 1);
        }
    }
    out.extend(wgsl);
    miniz_oxide::deflate::compress_to_vec(&out, 10)
}

/// LEB128: seven bits a byte, the lowest first; the eighth says that another byte follows.
fn push_varint(out: &mut Vec<u8>, mut value: u64) {
    while value >= 128 {
        out.push(value as u8 | 128);
        value >>= 7;
    }
    out.push(value as u8);
}
