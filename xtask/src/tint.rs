//! `cargo xtask tint`: what Chromium's compiler says of the WGSL. Kernels with `f64` are not for
//! browsers, and not in their language; native ones have no WGSL.

use crate::programs::{output, skipped};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Dawn's bindings for Node, of which Tint is a part.
const PACKAGE: &str = "webgpu@0.6.2";
/// Folder that npm installs it to.
const PREFIX: &str = "target/tint";
/// Status of the script where the bindings do not load.
const DOES_NOT_LOAD: i32 = 3;

/// WGSL that Tint must refuse, each for a reason of its own: a script that reports nothing would
/// accept anything.
const REFUSED: [(&str, &str); 3] = [
    ("no_wgsl", "fn f( {\n"),
    ("wrong_type", "fn f() -> u32 { return 1.5; }\n"),
    (
        "lonely_barrier",
        "@group(0) @binding(0) var<storage, read_write> a: array<u32>;\n\
         @compute @workgroup_size(64) fn f(@builtin(local_invocation_index) i: u32) {\n\
         if (a[i] > 7u) { workgroupBarrier(); } a[i] = i; }\n",
    ),
];

/// Has Tint read every kernel that is for browsers, and some that it must refuse.
pub fn run(root: &Path) -> Result<(), String> {
    let bindings = match install(root) {
        Ok(folder) => folder,
        Err(why) => {
            skipped(&format!("Tint did not read the WGSL: {why}"));
            return Ok(());
        }
    };
    let shaders = root.join("ccd-gpu/shaders");
    match read(root, &bindings, &shaders)? {
        Answer::Accepted(what) => println!("Tint accepts {what}"),
        Answer::Refused(why) => return Err(format!("Tint refuses a kernel:\n{why}")),
        Answer::DoesNotLoad(why) => {
            skipped(&format!("Tint did not read the WGSL: its bindings do not load: {why}"));
            return Ok(());
        }
    }
    for (name, text) in REFUSED {
        let folder = root.join(PREFIX).join("refused");
        let manifest =
            format!(r#"{{"kernels": [{{"name": "{name}", "wide": false, "native": false}}]}}"#);
        std::fs::create_dir_all(&folder).map_err(|e| e.to_string())?;
        std::fs::write(folder.join("manifest.json"), manifest).map_err(|e| e.to_string())?;
        std::fs::write(folder.join(format!("{name}.wgsl")), text).map_err(|e| e.to_string())?;
        if !matches!(read(root, &bindings, &folder)?, Answer::Refused(why) if why.contains(name)) {
            return Err(format!("Tint does not refuse {name}, so its word means nothing"));
        }
    }
    println!("Tint refuses {} kernels that are wrong on purpose", REFUSED.len());
    Ok(())
}

/// The folder of Dawn's bindings, which are fetched if they are not there.
pub fn install(root: &Path) -> Result<PathBuf, String> {
    output(Command::new("node").arg("--version"))?;
    let folder = root.join(PREFIX).join("node_modules/webgpu");
    if folder.is_dir() {
        return Ok(folder);
    }
    let how = ["--no-audit", "--no-fund", "--fetch-retries=1", "--fetch-timeout=60000"];
    let prefix = root.join(PREFIX);
    output(Command::new("npm").args(["install", PACKAGE]).args(how).arg("--prefix").arg(prefix))?;
    Ok(folder)
}

/// Result of the script for a folder.
enum Answer {
    Accepted(String),
    Refused(String),
    DoesNotLoad(String),
}

fn read(root: &Path, bindings: &Path, folder: &Path) -> Result<Answer, String> {
    let run = Command::new("node")
        .arg(root.join("xtask/src/tint.mjs"))
        .arg(bindings)
        .arg(folder)
        .output()
        .map_err(|e| format!("cannot run node, which runs Tint: {e}"))?;
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).trim().to_owned();
    Ok(match run.status.code() {
        Some(0) => Answer::Accepted(text(&run.stdout)),
        Some(DOES_NOT_LOAD) => Answer::DoesNotLoad(text(&run.stderr)),
        _ => Answer::Refused(text(&run.stderr)),
    })
}
