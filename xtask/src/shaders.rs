//! `cargo xtask shaders`: from the entry points of ccd-shaders to the files that ccd-gpu embeds.
//!
//! The nightly builds SPIR-V (ccd-shaders/builder); naga validates it and translates it to WGSL; a
//! manifest says what there is and what it was made from. The products are committed. A test here,
//! on stable, compares hashes of the sources and of the products with those of the manifest.

use crate::programs::channel;
#[cfg(any(feature = "shaders", test))]
use crate::programs::files_below;
#[cfg(any(feature = "shaders", test))]
use sha2::{Digest, Sha256};
#[cfg(any(feature = "shaders", test))]
use std::collections::BTreeMap;
use std::path::Path;
#[cfg(any(feature = "shaders", test))]
use std::path::PathBuf;
use std::process::Command;

/// Folder of the products.
#[cfg(any(feature = "shaders", test))]
const PRODUCTS: &str = "ccd-gpu/shaders";
#[cfg(any(feature = "shaders", test))]
const MANIFEST: &str = "ccd-gpu/shaders/manifest.json";

/// The first line of every WGSL file.
#[cfg(any(feature = "shaders", test))]
const GENERATED: &str = "// Generated from ccd-shaders by `cargo xtask shaders`: not to be edited.";
/// For tools that leave out what is generated.
#[cfg(feature = "shaders")]
const ATTRIBUTES: &str = "** linguist-generated\n*.spv binary\n*.z binary\n";

/// Inputs of the products: folders (all files below) and files.
#[cfg(any(feature = "shaders", test))]
const INPUTS: [&str; 8] = [
    "ccd-core/src",
    "ccd-shaders/Cargo.lock",
    "ccd-shaders/Cargo.toml",
    "ccd-shaders/builder/Cargo.lock",
    "ccd-shaders/builder/Cargo.toml",
    "ccd-shaders/builder/src",
    "ccd-shaders/rust-toolchain.toml",
    "ccd-shaders/src",
];

/// SHA-256 of the names and contents of all inputs.
#[cfg(any(feature = "shaders", test))]
fn hash_of_inputs(root: &Path) -> Result<String, String> {
    let mut files = Vec::new();
    for input in INPUTS {
        files.extend(files_below(&root.join(input))?);
    }
    Ok(hash_of(read(root, &files)?.iter()))
}

/// SHA-256 of the names and contents of all products.
#[cfg(any(feature = "shaders", test))]
fn hash_of_products(products: &Files) -> String {
    hash_of(products.iter().filter(|(name, _)| *name != "manifest.json"))
}

/// Contents by name.
#[cfg(any(feature = "shaders", test))]
type Files = BTreeMap<String, Vec<u8>>;

/// The contents of files by their names below a folder.
#[cfg(any(feature = "shaders", test))]
fn read(root: &Path, files: &[PathBuf]) -> Result<Files, String> {
    let name = |file: &Path| -> Result<String, String> {
        let name = file.strip_prefix(root).map_err(|e| e.to_string())?;
        Ok(name.to_string_lossy().replace('\\', "/"))
    };
    let text = |file: &Path| std::fs::read(file).map_err(|e| format!("{}: {e}", file.display()));
    files.iter().map(|file| Ok((name(file)?, text(file)?))).collect()
}

#[cfg(any(feature = "shaders", test))]
fn hash_of<'a>(files: impl Iterator<Item = (&'a String, &'a Vec<u8>)>) -> String {
    let mut hash = Sha256::new();
    for (name, text) in files {
        hash.update(name.as_bytes());
        hash.update([0]);
        hash.update((text.len() as u64).to_le_bytes());
        hash.update(text);
    }
    hash.finalize().iter().map(|b| format!("{b:02x}")).collect()
}

/// Why shaders cannot be rebuilt here, if they cannot.
pub fn missing(root: &Path) -> Result<Option<String>, String> {
    let toolchain = toolchain(root)?;
    Ok((!installed(&toolchain)).then(|| {
        format!(
            "shaders were not rebuilt, {toolchain} is not installed (rustup toolchain install with \
             the components of ccd-shaders/rust-toolchain.toml)"
        )
    }))
}

fn toolchain(root: &Path) -> Result<String, String> {
    channel(&root.join("ccd-shaders"))
}

fn installed(toolchain: &str) -> bool {
    // Asked of rustup, because running rustc would install the toolchain.
    let list = Command::new("rustup").args(["toolchain", "list"]).output();
    list.is_ok_and(|o| String::from_utf8_lossy(&o.stdout).lines().any(|l| l.starts_with(toolchain)))
}

#[cfg(feature = "shaders")]
pub use build::run;

#[cfg(feature = "shaders")]
mod build {
    use super::{
        ATTRIBUTES, Files, GENERATED, MANIFEST, PRODUCTS, hash_of_inputs, hash_of_products,
        missing, toolchain,
    };
    use crate::instructions::{instructions, opcode, words};
    use ccd_core::backend::kernel::TABLE;
    use serde_json::{Value, json};
    use std::collections::BTreeMap;
    use std::path::Path;
    use std::process::Command;

    /// Builds all products. `check`: compares them with the committed ones instead of writing them.
    pub fn run(root: &Path, check: bool) -> Result<(), String> {
        match missing(root)? {
            Some(why) if check => crate::programs::skipped(&why),
            Some(why) => return Err(why),
            None => build(root, check)?,
        }
        crate::tint::run(root)
    }

    fn build(root: &Path, check: bool) -> Result<(), String> {
        let toolchain = toolchain(root)?;
        let modules = root.join("target/shaders/modules");
        let _ = std::fs::remove_dir_all(&modules);
        build_modules(root, &toolchain, &modules)?;
        let products = translate(root, &modules, &toolchain)?;
        if check { compare(root, &products) } else { write(root, &products) }
    }

    /// Runs the builder under the nightly. Its first build takes minutes (it compiles the code
    /// generator and SPIRV-Tools); the target folder keeps it.
    fn build_modules(root: &Path, toolchain: &str, out: &Path) -> Result<(), String> {
        let status = Command::new("cargo")
            .args(["run", "--release", "--locked", "--manifest-path", "builder/Cargo.toml", "--"])
            .arg(root.join("ccd-shaders"))
            .arg(out)
            .current_dir(root.join("ccd-shaders"))
            .env("RUSTUP_TOOLCHAIN", toolchain)
            .env("RUST_MIN_STACK", "33554432")
            // Jump threading copies code into the branches that lead to it, also a barrier into
            // branches that threads take differently. (rust-gpu switches off the other pass itself;
            // the last list counts.)
            .env("RUSTGPU_RUSTFLAGS", "-Zmir-enable-passes=-GVN,-JumpThreading")
            .env("CARGO_TARGET_DIR", root.join("target/shaders/builder"))
            // Set by the outer cargo for its own toolchain.
            .env_remove("CARGO")
            .env_remove("RUSTC")
            .env_remove("LD_LIBRARY_PATH")
            .status()
            .map_err(|e| format!("cannot run cargo: {e}"))?;
        if status.success() { Ok(()) } else { Err("the shader builder failed".into()) }
    }

    /// All products by file name.
    fn translate(root: &Path, modules: &Path, toolchain: &str) -> Result<Files, String> {
        let mut products = BTreeMap::new();
        let mut kernels = Vec::new();
        let mut names: Vec<_> = std::fs::read_dir(modules)
            .map_err(|e| e.to_string())?
            .flatten()
            .map(|e| e.path())
            .collect();
        names.sort();
        for path in names {
            let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            let spirv = std::fs::read(&path).map_err(|e| e.to_string())?;
            let module = naga::front::spv::parse_u8_slice(&spirv, &Default::default())
                .map_err(|e| format!("{name}: naga: {e}"))?;
            let row = describe(&name, &module, &spirv);
            check_barriers(&name, &row)?;
            let native = row["native"] == true;
            kernels.push(row);
            let wgsl = if native {
                NO_WGSL.into()
            } else {
                crate::wgsl::translate(module).map_err(|e| format!("{name}: {e}"))?
            };
            let wgsl = format!("{GENERATED}\n{wgsl}").into_bytes();
            products.insert(format!("{name}.z"), crate::packed::packed(&words(&spirv), &wgsl));
            products.insert(format!("{name}.spv"), spirv);
            products.insert(format!("{name}.wgsl"), wgsl);
        }
        products.insert(".gitattributes".into(), ATTRIBUTES.into());
        let manifest = json!({
            "inputs": hash_of_inputs(root)?,
            "products": hash_of_products(&products),
            "toolchain": toolchain,
            "kernels": kernels,
        });
        let text = serde_json::to_string_pretty(&manifest).map_err(|e| e.to_string())? + "\n";
        products.insert("manifest.json".into(), text.into_bytes());
        Ok(products)
    }

    /// Text of a native kernel instead of WGSL.
    const NO_WGSL: &str = "// None: it needs acquire and release between workgroups.\n";

    /// Compares with the barriers of the kernel table, which are those written in ccd-shaders. A
    /// copy of one may stand where not all threads of a workgroup come by, and no validator sees
    /// that.
    fn check_barriers(name: &str, row: &Value) -> Result<(), String> {
        let kernel = TABLE.iter().find(|kernel| kernel.name == name);
        let written =
            kernel.ok_or(format!("{name} has no row in the kernel table"))?.barriers as u64;
        let found = row["barriers"].as_u64().unwrap_or(0);
        if found == written {
            Ok(())
        } else {
            Err(format!(
                "{name} has {found} barriers, its source {written}: \
                 a compiler copied or dropped one"
            ))
        }
    }

    /// Workgroup size, bindings, bytes of workgroup memory, and whether `f64` is needed.
    fn describe(name: &str, module: &naga::Module, spirv: &[u8]) -> Value {
        let entry = &module.entry_points[0];
        let mut bindings = BTreeMap::new();
        let mut shared = 0;
        for (_, variable) in module.global_variables.iter() {
            match (variable.space, &variable.binding) {
                (naga::AddressSpace::Storage { access }, Some(at)) => {
                    let access =
                        if access.contains(naga::StorageAccess::STORE) { "write" } else { "read" };
                    bindings.insert(at.binding, access);
                }
                (naga::AddressSpace::WorkGroup, _) => {
                    shared += module.types[variable.ty].inner.size(module.to_ctx())
                }
                _ => {}
            }
        }
        let wide =
            module.types.iter().any(|(_, ty)| ty.inner.scalar().is_some_and(|s| s.width == 8));
        json!({
            "name": name,
            "entry": entry.name,
            "workgroup": entry.workgroup_size[0],
            "bindings": bindings.into_values().collect::<Vec<_>>(),
            "shared_bytes": shared,
            "wide": wide,
            "native": TABLE.iter().any(|kernel| kernel.name == name && kernel.native),
            "barriers": count_barriers(spirv),
        })
    }

    fn count_barriers(spirv: &[u8]) -> usize {
        const OP_CONTROL_BARRIER: u32 = 224;
        instructions(&words(spirv)).filter(|i| opcode(i) == OP_CONTROL_BARRIER).count()
    }

    fn write(root: &Path, products: &Files) -> Result<(), String> {
        let folder = root.join(PRODUCTS);
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(&folder).map_err(|e| e.to_string())?;
        for (name, bytes) in products {
            std::fs::write(folder.join(name), bytes).map_err(|e| format!("{name}: {e}"))?;
        }
        println!("{} files in {PRODUCTS}", products.len());
        Ok(())
    }

    fn compare(root: &Path, products: &Files) -> Result<(), String> {
        let folder = root.join(PRODUCTS);
        let mut different: Vec<_> = products
            .iter()
            .filter(|(name, bytes)| std::fs::read(folder.join(name)).ok().as_ref() != Some(*bytes))
            .map(|(n, _)| n.clone())
            .collect();
        for entry in std::fs::read_dir(&folder).map_err(|e| format!("{PRODUCTS}: {e}"))?.flatten() {
            let name = entry.file_name().to_string_lossy().into_owned();
            if !products.contains_key(&name) {
                different.push(name);
            }
        }
        if different.is_empty() {
            println!(
                "{} files in {PRODUCTS} are what the sources give, byte for byte",
                products.len()
            );
            return Ok(());
        }
        Err(format!(
            "{} of {PRODUCTS} differ from what the sources give ({MANIFEST}): \
             run `cargo xtask shaders`",
            different.join(", ")
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root() -> &'static Path {
        Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
    }

    #[test]
    fn products_are_of_these_sources() {
        let manifest = std::fs::read_to_string(root().join(MANIFEST)).expect(MANIFEST);
        let manifest: serde_json::Value = serde_json::from_str(&manifest).expect(MANIFEST);
        let want = hash_of_inputs(root()).unwrap();
        assert_eq!(
            manifest["inputs"],
            want.as_str(),
            "a shader source changed: run `cargo xtask shaders`"
        );
        let folder = root().join(PRODUCTS);
        let products = read(&folder, &files_below(&folder).unwrap()).unwrap();
        assert_eq!(
            manifest["products"],
            hash_of_products(&products).as_str(),
            "a product changed: run `cargo xtask shaders`"
        );
    }

    #[test]
    fn shaders_say_that_they_are_generated() {
        let files = std::fs::read_dir(root().join("ccd-gpu/shaders"))
            .unwrap()
            .map(|entry| entry.unwrap().path());
        let wgsl: Vec<PathBuf> =
            files.filter(|path| path.extension().is_some_and(|e| e == "wgsl")).collect();
        assert!(!wgsl.is_empty());
        for path in wgsl {
            let text = std::fs::read_to_string(&path).unwrap();
            assert_eq!(text.lines().next(), Some(GENERATED), "{}", path.display());
        }
        let attributes =
            std::fs::read_to_string(root().join("ccd-gpu/shaders/.gitattributes")).unwrap();
        assert!(attributes.starts_with("** linguist-generated"), "{attributes}");
    }

    #[test]
    fn another_source_has_another_hash() {
        let copy = tempfile::tempdir().unwrap();
        for input in INPUTS {
            let (from, to) = (root().join(input), copy.path().join(input));
            for file in files_below(&from).unwrap() {
                let to = to.join(file.strip_prefix(&from).unwrap());
                let to = if file == from { copy.path().join(input) } else { to };
                std::fs::create_dir_all(to.parent().unwrap()).unwrap();
                std::fs::copy(&file, &to).unwrap();
            }
        }
        let same = hash_of_inputs(copy.path()).unwrap();
        assert_eq!(same, hash_of_inputs(root()).unwrap());
        let changed = copy.path().join("ccd-core/src/lib.rs");
        let text = std::fs::read_to_string(&changed).unwrap();
        std::fs::write(&changed, text + " ").unwrap();
        assert_ne!(same, hash_of_inputs(copy.path()).unwrap());
    }
}
