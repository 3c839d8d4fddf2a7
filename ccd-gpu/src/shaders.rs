//! The compiled shaders, one SPIR-V and one WGSL module a kernel; `cargo xtask shaders` writes
//! them, and both of a kernel packed, as they are embedded.
//!
//! **Packed**, and then compressed: the number of SPIR-V's words, each word, the text of WGSL.
//! Numbers are LEB128. A word from 256 to 65535 is mostly an id, and the next one is near it: it is
//! the difference to the last such word, zigzag, with a low bit of 1; any other word stands for
//! itself, with a low bit of 0. That takes 380 KB for 970 of deflate alone.

use crate::adapter::Path;
use crate::error::Error;
use ccd_core::backend::kernel::Id;
use miniz_oxide::inflate::decompress_to_vec;

macro_rules! embedded {
    (product, $name:ident) => {
        include_bytes!(concat!("../shaders/", stringify!($name), ".z"))
    };
    (catalogue, $name:ident) => {
        embedded!("catalogue", $name)
    };
    (tests, $name:ident) => {
        embedded!("test-kernels", $name)
    };
    ($feature:literal, $name:ident) => {{
        #[cfg(feature = $feature)]
        const BYTES: &[u8] = embedded!(product, $name);
        #[cfg(not(feature = $feature))]
        const BYTES: &[u8] = &[];
        BYTES
    }};
}

macro_rules! modules {
    ($($group:ident {
        $($(#[$doc:meta])* $id:ident = $name:ident $about:tt $buffers:tt)*
    })*) => {
        /// Both modules of a kernel, packed; empty for one that is not compiled in.
        pub fn packed(id: Id) -> &'static [u8] {
            match id {
                $($(Id::$id => embedded!($group, $name),)*)*
            }
        }
    };
}

ccd_core::kernels!(modules);

/// The module of a kernel for a path, SPIR-V or WGSL; nothing of one that is not compiled in.
pub fn module(id: Id, path: Path) -> Vec<u8> {
    let bytes = decompress_to_vec(packed(id)).unwrap_or_default();
    let mut rest = bytes.as_slice();
    let spirv = spirv(&mut rest);
    match path {
        Path::Passthrough => spirv,
        Path::Wgsl => rest.to_vec(),
    }
}

/// Takes the words of SPIR-V from the front of unpacked bytes.
fn spirv(bytes: &mut &[u8]) -> Vec<u8> {
    let n_words = varint(bytes) as usize;
    let mut id = 0;
    let mut word = || {
        let value = varint(bytes);
        if value & 1 == 0 {
            return (value >> 1) as u32;
        }
        let zigzag = (value >> 1) as u32;
        id = (zigzag >> 1 ^ 0u32.wrapping_sub(zigzag & 1)).wrapping_add(id);
        id
    };
    (0..n_words).flat_map(|_| word().to_le_bytes()).collect()
}

/// Takes a number from the front of bytes; of bytes that end too early, what there is.
fn varint(bytes: &mut &[u8]) -> u64 {
    let mut value = 0;
    for shift in (0..64).step_by(7) {
        let Some((&byte, rest)) = bytes.split_first() else { break };
        *bytes = rest;
        value |= u64::from(byte & 127) << shift;
        if byte < 128 {
            break;
        }
    }
    value
}

/// Refuses a kernel that is not compiled in.
pub fn check(id: Id) -> Result<(), Error> {
    if packed(id).is_empty() {
        let name = id.row().name;
        return Err(Error::Unavailable { why: format!("the kernel `{name}` is not compiled in") });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    macro_rules! ids {
        ($($group:ident {
            $($(#[$doc:meta])* $id:ident = $name:ident $about:tt $buffers:tt)*
        })*) => {
            [$($(Id::$id,)*)*]
        };
    }

    /// In the repository, where both stand beside them.
    #[test]
    fn modules_are_those_of_the_files() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/shaders");
        let ids = ccd_core::kernels!(ids).into_iter().filter(|id| check(*id).is_ok());
        for id in ids {
            for (path, ending) in [(Path::Passthrough, "spv"), (Path::Wgsl, "wgsl")] {
                let file = std::fs::read(format!("{folder}/{}.{ending}", id.row().name)).unwrap();
                assert!(!file.is_empty() && module(id, path) == file, "{id:?} {path:?}");
            }
        }
    }
}
