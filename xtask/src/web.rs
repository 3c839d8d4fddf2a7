//! `cargo xtask web`: the npm package, built into `ccd-web/pkg` and tested under Node, steps by
//! WebGPU as well; with `--page` in browsers, too, and its page.

use crate::programs::{command, command_with, has_target, output, skipped, target_folder};
use crate::wasm::SIMD;
use std::path::Path;
use std::process::Command;

const TARGET: &str = "wasm32-unknown-unknown";
const CRATE: &str = "meshccd-web";
const FOLDER: &str = "ccd-web";
/// Names of the modules, with their features: that of the CPU, and one that has the kernels, too.
const MODULES: [(&str, &[&str]); 2] = [("meshccd", &[]), ("meshccd_gpu", &["--features", "gpu"])];
/// Files of the package that are written by hand.
const FILES: [(&str, &str); 9] = [
    ("ccd-web/js/index.js", "index.js"),
    ("ccd-web/js/input.js", "input.js"),
    ("ccd-web/js/output.js", "output.js"),
    ("ccd-web/js/gpu.js", "gpu.js"),
    ("ccd-web/js/index.d.ts", "index.d.ts"),
    ("ccd-web/js/package.json", "package.json"),
    ("ccd-web/js/README.md", "README.md"),
    ("LICENSE-APACHE", "LICENSE-APACHE"),
    ("LICENSE-MIT", "LICENSE-MIT"),
];

pub fn run(root: &Path, page: bool) -> Result<(), String> {
    if !has_target(TARGET) {
        skipped(&format!("the npm package was not built: no target {TARGET} here"));
        return Ok(());
    }
    build(root)?;
    if let Err(why) = output(Command::new("node").arg("--version")) {
        skipped(&format!("the npm package was not tested: {why}"));
        return Ok(());
    }
    let folder = root.join(FOLDER);
    command(&folder, &["node", "tests/size.mjs"])?;
    command(&folder, &["npm", "run", "--silent", "test:node"])?;
    // The same versions as in package-lock.json.
    let install = ["ci", "--silent", "--no-audit", "--no-fund", "--fetch-retries=1"];
    if let Err(why) = output(Command::new("npm").args(install).current_dir(&folder)) {
        skipped(&format!("types of the npm package were not checked: {why}"));
        return Ok(());
    }
    command(&folder, &["npm", "run", "--silent", "test:types"])?;
    webgpu(root, &folder)?;
    if page {
        // The crate is empty on the target for which clippy checks the workspace.
        let clippy = ["cargo", "clippy", "--profile", "web", "-p", CRATE, "--target", TARGET];
        for (_, features) in MODULES {
            let clippy = [&clippy[..], features, &["--", "-D", "warnings"]].concat();
            command_with(root, &clippy, &SIMD)?;
        }
        command(&folder, &["npm", "run", "--silent", "test:page"])?;
    }
    Ok(())
}

/// Whole steps by WebGPU under Node.
fn webgpu(root: &Path, folder: &Path) -> Result<(), String> {
    let dawn = match crate::tint::install(root) {
        Ok(dawn) => dawn,
        Err(why) => {
            skipped(&format!("the npm package made no step by WebGPU: {why}"));
            return Ok(());
        }
    };
    let dawn = dawn.to_str().ok_or("the path of this checkout is not UTF-8")?;
    command_with(folder, &["npm", "run", "--silent", "test:gpu"], &[("DAWN", dawn)])
}

/// The modules and their bindings, and what is written by hand, into one folder.
fn build(root: &Path) -> Result<(), String> {
    let package = root.join(FOLDER).join("pkg");
    let failed = |what: &Path, e: std::io::Error| format!("{}: {e}", what.display());
    let _ = std::fs::remove_dir_all(&package);
    std::fs::create_dir_all(&package).map_err(|e| failed(&package, e))?;
    for (name, features) in MODULES {
        let build =
            ["cargo", "build", "--profile", "web", "-p", CRATE, "--lib", "--target", TARGET];
        command_with(root, &[&build[..], features].concat(), &SIMD)?;
        let module = target_folder(root).join(TARGET).join("web").join(CRATE.replace('-', "_"));
        let mut bindings = wasm_bindgen_cli_support::Bindgen::new();
        bindings.input_path(module.with_extension("wasm")).out_name(name).typescript(false);
        bindings.remove_name_section(true).remove_producers_section(true);
        let generated = bindings.web(true).and_then(|bindings| bindings.generate(&package));
        generated.map_err(|e| format!("wasm-bindgen: {e:#}"))?;
    }
    for (from, to) in FILES {
        let from = root.join(from);
        std::fs::copy(&from, package.join(to)).map_err(|e| failed(&from, e))?;
    }
    Ok(())
}
