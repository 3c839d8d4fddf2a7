//! The compiled shaders, one SPIR-V and one WGSL file a kernel; `cargo xtask shaders` writes them.

use ccd_core::kernel::Id;

/// The two forms of a kernel.
pub struct Module {
    pub spirv: &'static [u8],
    pub wgsl: &'static str,
}

macro_rules! modules {
    ($($(#[$doc:meta])* $id:ident = $name:ident $about:tt $buffers:tt)*) => {
        /// The module of a kernel.
        pub fn module(id: Id) -> Module {
            match id {
                $(Id::$id => Module {
                    spirv: include_bytes!(concat!("../shaders/", stringify!($name), ".spv")),
                    wgsl: include_str!(concat!("../shaders/", stringify!($name), ".wgsl")),
                },)*
            }
        }
    };
}

ccd_core::kernels!(modules);
