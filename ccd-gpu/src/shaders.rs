//! The compiled shaders, one SPIR-V and one WGSL module a kernel; `cargo xtask shaders` writes
//! them, and both of a kernel compressed, as they are embedded.

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
        /// Both modules of a kernel, compressed: the length of the first, then both. Empty for one
        /// that is not compiled in.
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
    let mut bytes = decompress_to_vec(packed(id)).unwrap_or_default();
    let n = bytes.first_chunk().map_or(0, |n| u32::from_le_bytes(*n) as usize);
    let wgsl = bytes.split_off((4 + n).min(bytes.len()));
    match path {
        Path::Passthrough => bytes.split_off(4.min(bytes.len())),
        Path::Wgsl => wgsl,
    }
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
