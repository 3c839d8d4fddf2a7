//! Rules that no compiler checks: what each crate may name, where `unsafe` may stand, how files begin and how long they are.

use std::path::{Path, PathBuf};

/// Lines that a source file may have.
const MAX_LINES: usize = 420;
/// Columns that a line may have.
const MAX_COLUMNS: usize = 180;
/// The only files with `unsafe`: plain-data records, indices without a check in shaders, instruction sets, compiled shaders and the features that take
/// them, atomics and workgroup memory, a counting allocator.
const UNSAFE_FILES: [&str; 7] = [
    "ccd-core/src/aabb.rs",
    "ccd-core/src/slice.rs",
    "ccd-cpu/src/simd.rs",
    "ccd-gpu/src/device.rs",
    "ccd-shaders/src/workgroup.rs",
    "examples/engine.rs",
    "tests/allocations.rs",
];
/// A word, and the only places where it may stand.
const OWNERS: [(&str, &[&str]); 3] =
    [("rayon", &["ccd-cpu/", "xtask/"]), ("wgpu", &["ccd-gpu/", "examples/", "src/cli/", "tests/"]), ("spirv_std", &["ccd-shaders/"])];

pub fn run(root: &Path) -> Result<(), String> {
    let mut problems = Vec::new();
    let mut files = Vec::new();
    collect(root, &mut files);
    for path in &files {
        let name = path.strip_prefix(root).unwrap_or(path).to_string_lossy().replace('\\', "/");
        let text = std::fs::read_to_string(path).map_err(|e| format!("{name}: {e}"))?;
        problems.extend(check(&name, &text).into_iter().map(|p| format!("{name}{p}")));
    }
    if problems.is_empty() {
        println!("tidy: {} files", files.len());
        Ok(())
    } else {
        Err(format!("tidy:\n{}", problems.join("\n")))
    }
}

/// What is wrong with a file, each with `:line: ` or `: ` in front.
fn check(name: &str, text: &str) -> Vec<String> {
    let mut out = Vec::new();
    if !text.starts_with("//!") {
        out.push(": the first line does not say what the file is (`//! ..`)".into());
    }
    let n_lines = text.lines().count();
    if n_lines > MAX_LINES {
        out.push(format!(": {n_lines} lines, more than {MAX_LINES}"));
    }
    let rules = name != "xtask/src/tidy.rs";
    for (i, line) in text.lines().enumerate() {
        let mut say = |what: &str| out.push(format!(":{}: {what}", i + 1));
        if line.chars().count() > MAX_COLUMNS {
            say("the line is too long");
        }
        if line.trim_end() != line {
            say("white space at the end");
        }
        let code = line.split("//").next().unwrap_or(line);
        if rules && ["TODO", "FIXME", "XXX"].iter().any(|w| line.contains(w)) {
            say("unfinished");
        }
        if rules && code.split(|c: char| !c.is_alphanumeric() && c != '_').any(|w| w == "unsafe") && !UNSAFE_FILES.contains(&name) {
            say("`unsafe` outside of the files that may have it");
        }
        for (word, places) in OWNERS {
            let named = code.split(|c: char| !c.is_alphanumeric() && c != '_').any(|w| w == word);
            if rules && named && !places.iter().any(|p| name.starts_with(p)) {
                say(&format!("`{word}` belongs to {}", places.join(", ")));
            }
        }
        if code.contains("#[allow") && !code.contains("reason") {
            say("`allow` without a reason");
        }
    }
    out
}

/// Rust sources below `dir`, without build folders.
fn collect(dir: &Path, out: &mut Vec<PathBuf>) {
    let Ok(entries) = std::fs::read_dir(dir) else { return };
    let mut entries: Vec<_> = entries.flatten().map(|e| e.path()).collect();
    entries.sort();
    for path in entries {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if path.is_dir() && name != "target" && !name.starts_with('.') {
            collect(&path, out);
        } else if name.ends_with(".rs") {
            out.push(path);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_rule_can_fail() {
        assert!(check("ccd-core/src/a.rs", "//! Fine.\nfn f() {}\n").is_empty());
        let bad = [
            "fn f() {}\n",
            "//! A.\nunsafe fn f() {}\n",
            "//! A.\nuse rayon::join;\n",
            "//! A.\n#[allow(dead_code)]\n",
            "//! A.\n// TODO\n",
            "//! A.\nlet x = 1; \n",
        ];
        for text in bad {
            assert_eq!(check("ccd-core/src/a.rs", text).len(), 1, "{text:?}");
        }
        assert_eq!(check("a.rs", &format!("//! A.\n{}", "\n".repeat(MAX_LINES))).len(), 1);
        assert_eq!(check("a.rs", &format!("//! {}\n", "x".repeat(MAX_COLUMNS))).len(), 1);
    }
}
