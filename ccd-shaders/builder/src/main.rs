//! Compiles `ccd-shaders` to one SPIR-V module per entry point. Arguments: the shader crate, the
//! folder for the modules.
//!
//! Runs under the nightly of `ccd-shaders/rust-toolchain.toml`, because the code generator is a
//! part of that compiler. `cargo xtask shaders` calls this program and translates what it writes.

mod instructions;
mod rewrite;
mod selects;

use rewrite::{forbid_contraction, glsl_memory_model, may_be_inlined, plain_name, without_lines};
use spirv_builder::{Capability, ModuleResult, ShaderPanicStrategy, SpirvBuilder, SpirvMetadata};
use spirv_tools::opt::{Optimizer, Passes};
use spirv_tools::val::Validator;
use std::error::Error;
use std::path::PathBuf;

const ENVIRONMENT: spirv_tools::TargetEnv = spirv_tools::TargetEnv::Vulkan_1_1;

fn main() -> Result<(), Box<dyn Error>> {
    let mut args = std::env::args_os().skip(1);
    let (Some(shaders), Some(out)) = (args.next(), args.next()) else {
        return Err("usage: ccd-shaders-builder SHADER_CRATE OUT_FOLDER".into());
    };
    let out = PathBuf::from(out);
    let mut builder = SpirvBuilder::new(PathBuf::from(shaders), "spirv-unknown-vulkan1.1")
        .multimodule(true)
        .capability(Capability::Int64)
        .capability(Capability::Float64)
        .capability(Capability::GroupNonUniformBallot)
        .capability(Capability::GroupNonUniformArithmetic)
        .spirv_metadata(SpirvMetadata::NameVariables)
        .shader_panic_strategy(ShaderPanicStrategy::SilentExit)
        // The optimiser runs below, once it is told which operations it must leave alone.
        .extra_arg("--no-spirv-opt");
    builder.build_script.defaults = false;
    let ModuleResult::MultiModule(modules) = builder.build()?.module else {
        return Err("one module instead of one per entry point".into());
    };
    std::fs::create_dir_all(&out)?;
    for (entry, path) in modules {
        let words = instructions::words(&std::fs::read(path)?);
        let words = glsl_memory_model(&may_be_inlined(&plain_name(&words)))?;
        let words = forbid_contraction(&without_lines(&words));
        // What the optimiser creates anew needs the decoration too.
        let words = selects::selects(&optimize(&words)?);
        let words = forbid_contraction(&optimize(&words)?);
        spirv_tools::val::create(Some(ENVIRONMENT))
            .validate(&words, None)
            .map_err(|e| format!("{entry}: {e}"))?;
        let bytes: Vec<u8> = words.iter().flat_map(|w| w.to_le_bytes()).collect();
        let name = entry.rsplit("::").next().unwrap_or(&entry);
        std::fs::write(out.join(format!("{name}.spv")), bytes)?;
    }
    Ok(())
}

/// Passes that make modules small without moving code, which translators to structured languages
/// could not follow. They leave alone what is decorated with `NoContraction`.
const PASSES: [Passes; 16] = [
    Passes::EliminateDeadFunctions,
    Passes::DeadBranchElim,
    Passes::PrivateToLocal,
    Passes::LocalSingleBlockLoadStoreElim,
    Passes::LocalSingleStoreElim,
    Passes::AggressiveDCE,
    Passes::LocalAccessChainConvert,
    Passes::SSARewrite,
    Passes::ConditionalConstantPropagation,
    Passes::AggressiveDCE,
    Passes::VectorDCE,
    Passes::DeadInsertElim,
    Passes::DeadBranchElim,
    Passes::Simplification,
    Passes::DeadInsertElim,
    Passes::AggressiveDCE,
];

fn optimize(words: &[u32]) -> Result<Vec<u32>, Box<dyn Error>> {
    let mut optimizer = spirv_tools::opt::create(Some(ENVIRONMENT));

    for pass in PASSES {
        optimizer.register_pass(pass);
    }
    let options = spirv_tools::opt::Options { preserve_bindings: true, ..Default::default() };
    let binary = optimizer.optimize(
        words,
        &mut |message: spirv_tools::error::Message| eprintln!("spirv-opt: {}", message.message),
        Some(options),
    )?;
    Ok(binary.as_words().to_vec())
}
