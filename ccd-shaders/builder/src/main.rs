//! Compiles `ccd-shaders` to one SPIR-V module per entry point. Arguments: the shader crate, the folder for the modules.
//!
//! Runs under the nightly of `ccd-shaders/rust-toolchain.toml`, because the code generator is a part of that compiler. What comes out
//! is not yet what is shipped: `cargo xtask shaders` calls this program, then rewrites and validates the modules.

use spirv_builder::{Capability, ModuleResult, ShaderPanicStrategy, SpirvBuilder, SpirvMetadata};
use std::error::Error;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    let mut args = std::env::args_os().skip(1);
    let (Some(shaders), Some(out)) = (args.next(), args.next()) else {
        return Err("usage: ccd-shaders-builder SHADER_CRATE OUT_FOLDER".into());
    };
    let out = PathBuf::from(out);
    let mut builder = SpirvBuilder::new(PathBuf::from(shaders), "spirv-unknown-vulkan1.2")
        .multimodule(true)
        .capability(Capability::Int64)
        .capability(Capability::Float64)
        .spirv_metadata(SpirvMetadata::NameVariables)
        .shader_panic_strategy(ShaderPanicStrategy::SilentExit);
    builder.build_script.defaults = false;
    // spirv-opt folds floating-point expressions: what it does to (x + C) - C undoes the error bounds.
    builder.optimizer.preserve_bindings = true;
    builder.extra_args.push("--no-spirv-opt".into());
    let result = builder.build()?;
    std::fs::create_dir_all(&out)?;
    match result.module {
        ModuleResult::MultiModule(modules) => {
            for (entry, path) in modules {
                std::fs::copy(path, out.join(format!("{entry}.spv")))?;
            }
        }
        ModuleResult::SingleModule(path) => return Err(format!("one module instead of many: {}", path.display()).into()),
    }
    Ok(())
}
