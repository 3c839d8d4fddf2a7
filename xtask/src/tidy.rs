//! Rules that no compiler checks: what each crate may name, where `unsafe` may stand, how files
//! begin, how long and how wide they are, and that every source that is cited is listed.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Lines that a source file may have.
const MAX_LINES: usize = 400;
/// Columns that a line of Rust may have.
const MAX_COLUMNS: usize = 100;
/// Columns that a line of Markdown may have, rows of tables included.
pub const MAX_COLUMNS_MARKDOWN: usize = 100;
/// List of the sources that comments cite.
const REFERENCES: &str = "docs/REFERENCES.md";
/// The only files with `unsafe`: plain-data records, indices without a check in shaders,
/// instruction sets, compiled shaders and the features that take them, atomics and workgroup
/// memory, allocators, a variable of the environment, names that a WebAssembly module exports, the
/// C API.
const UNSAFE_FILES: [&str; 33] = [
    "ccd-c/src/bodies.rs",
    "ccd-c/src/memory.rs",
    "ccd-c/src/mesh.rs",
    "ccd-c/src/moving.rs",
    "ccd-c/src/options.rs",
    "ccd-c/src/session.rs",
    "ccd-c/src/status.rs",
    "ccd-c/tests/c_api.rs",
    "ccd-cli/src/environment.rs",
    "ccd-core/src/math/aabb.rs",
    "ccd-core/src/backend/kernel/memory.rs",
    "ccd-core/src/backend/kernel/stack.rs",
    "ccd-cpu/src/pages.rs",
    "ccd-cpu/src/simd/avx2.rs",
    "ccd-cpu/src/simd/avx2/ids.rs",
    "ccd-cpu/src/simd/avx512.rs",
    "ccd-cpu/src/simd/mod.rs",
    "ccd-cpu/src/simd/neon.rs",
    "ccd-cpu/src/simd/simd128.rs",
    "ccd-cpu/src/simd/sse2.rs",
    "ccd-cpu/src/simd/tests.rs",
    "ccd-cpu/src/threads.rs",
    "ccd-gpu/src/device.rs",
    "ccd-gpu/src/harness.rs",
    "ccd-gpu/src/pipeline.rs",
    "ccd-shaders/src/workgroup.rs",
    "examples/bare-metal/src/main.rs",
    "examples/engine.rs",
    "fuzz/fuzz_targets/memory.rs",
    "tests/allocations.rs",
    "tests/wasm/src/lib.rs",
    "tests/gpu/main.rs",
    "xtask/src/growth/heap.rs",
];
/// A word, and the only places where it may stand.
const OWNERS: [(&str, &[&str]); 4] = [
    ("rayon", &["ccd-cpu/", "ccd-gpu/src/threads.rs", "src/group/threads.rs", "xtask/"]),
    // A report asks how much a device holds.
    (
        "wgpu",
        &[
            "ccd-gpu/",
            "examples/",
            "src/any/",
            "ccd-cli/",
            "ccd-web/",
            "tests/",
            "xtask/src/growth/",
        ],
    ),
    ("spirv_std", &["ccd-shaders/"]),
    // `Device::write`, which reports that there is no memory.
    ("write_buffer", &["ccd-gpu/src/device.rs", "examples/", "tests/"]),
];

/// Folders in which twins have one name: the core's first, whose files need none.
const TWIN_FOLDERS: [&str; 4] = [
    "ccd-core/src/backend/broad_phase/",
    "ccd-cpu/src/broad_phase/",
    "ccd-gpu/src/broad_phase/",
    "ccd-shaders/src/broad_phase/",
];
/// Beginning of the line that says why a file has no twin.
const TWIN: &str = "//! Twin:";
pub fn run(root: &Path) -> Result<(), String> {
    let mut problems = Vec::new();
    let mut files = Vec::new();
    collect(root, &mut files);
    let mut cited = BTreeSet::new();
    let mut sources = Vec::new();
    for path in &files {
        let name = path.strip_prefix(root).unwrap_or(path).to_string_lossy().replace('\\', "/");
        let text = std::fs::read_to_string(path).map_err(|e| format!("{name}: {e}"))?;
        let found = if name.ends_with(".md") { check_markdown(&text) } else { check(&name, &text) };
        problems.extend(found.into_iter().map(|p| format!("{name}{p}")));
        if name != REFERENCES && name != "xtask/src/tidy.rs" {
            cited.extend(citations(&text));
        }
        sources.push((name, text));
    }
    problems.extend(crate::circles::check(&sources));
    problems.extend(check_twins(&sources));
    problems.extend(crate::doc_examples::check(&sources));
    problems.extend(crate::python_calls::check(&sources));
    let text = std::fs::read_to_string(root.join(REFERENCES));
    let text = text.map_err(|e| format!("{REFERENCES}: {e}"))?;
    problems.extend(check_references(&cited, &text));
    if problems.is_empty() {
        println!("tidy: {} files", files.len());
        Ok(())
    } else {
        Err(format!("tidy:\n{}", problems.join("\n")))
    }
}

/// Files of these folders whose name no other folder has and whose head does not say why, in a line
/// that begins with [`TWIN`]; that of a folder's `mod.rs` holds for all files of the folder.
fn check_twins(files: &[(String, String)]) -> Vec<String> {
    let twins = files.iter().filter_map(|(name, text)| {
        let side = TWIN_FOLDERS.iter().find(|side| name.starts_with(**side))?;
        let stem = name.strip_suffix("/mod.rs").or(name.strip_suffix(".rs"))?.rsplit('/').next()?;
        Some((*side, stem, name.as_str(), text.lines().any(|line| line.starts_with(TWIN))))
    });
    let all: Vec<_> = twins.collect();
    let says_why = |name: &str| {
        let (folder, _) = name.rsplit_once('/').unwrap_or_default();
        let head = format!("{folder}/mod.rs");
        all.iter().any(|file| file.3 && (file.2 == name || file.2 == head))
    };
    let lonely = all.iter().filter(|(side, stem, name, _)| {
        let has_twin = all.iter().any(|other| other.1 == *stem && other.0 != *side);
        *side != TWIN_FOLDERS[0] && !stem.ends_with("tests") && !has_twin && !says_why(name)
    });
    let problem = |name: &str| format!("{name}: no other side has this name, and no `{TWIN} ..`");
    lonely.map(|file| problem(file.2)).collect()
}

/// Keys that a text cites: words in brackets that begin with a name and end with a year, as in
/// `[Karras 2012b]`, and the one source whose year is not known.
fn citations(text: &str) -> BTreeSet<String> {
    let year = |word: &str| {
        let digits = word.trim_end_matches(|c: char| c.is_ascii_lowercase());
        digits.len() == 4 && word.len() <= 5 && digits.bytes().all(|b| b.is_ascii_digit())
    };
    let is_key = |key: &str| {
        let fine = |c: char| c.is_alphanumeric() || c == ' ' || c == '\'';
        let mut words = key.rsplit(' ');
        let named = key.starts_with(char::is_alphabetic) && key.contains(char::is_uppercase);
        key.chars().all(fine) && named && words.next().is_some_and(year) || key == "Tian and Wan"
    };
    let parts = text.split('[').skip(1).filter_map(|rest| rest.split_once(']'));
    parts.map(|(key, _)| key.to_owned()).filter(|key| is_key(key)).collect()
}

/// Sources that are cited and not listed, or listed and not cited.
fn check_references(cited: &BTreeSet<String>, list: &str) -> Vec<String> {
    let entry = |line: &str| Some(line.strip_prefix("- **[")?.split_once("]**")?.0.to_owned());
    let listed: BTreeSet<String> = list.lines().filter_map(entry).collect();
    let missing = cited.difference(&listed).map(|key| format!("{REFERENCES}: [{key}] is missing"));
    let unused = listed.difference(cited).map(|key| format!("{REFERENCES}: [{key}] is not cited"));
    missing.chain(unused).collect()
}

/// Problems of a Markdown file, each with `:line: ` in front.
fn check_markdown(text: &str) -> Vec<String> {
    let mut out = Vec::new();
    for (i, line) in text.lines().enumerate() {
        let n = line.chars().count();
        if n > MAX_COLUMNS_MARKDOWN {
            out.push(format!(":{}: {n} columns, more than {MAX_COLUMNS_MARKDOWN}", i + 1));
        }
        if line.trim_end() != line {
            out.push(format!(":{}: white space at the end", i + 1));
        }
    }
    out
}

/// Problems of a source file, each with `:line: ` or `: ` in front.
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
        if rules
            && code.split(|c: char| !c.is_alphanumeric() && c != '_').any(|w| w == "unsafe")
            && !UNSAFE_FILES.contains(&name)
        {
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

/// Rust sources and Markdown below `dir`, without build folders.
fn collect(dir: &Path, out: &mut Vec<PathBuf>) {
    let Ok(entries) = std::fs::read_dir(dir) else { return };
    let mut entries: Vec<_> = entries.flatten().map(|e| e.path()).collect();
    entries.sort();
    for path in entries {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let built = ["target", "node_modules", "pkg"].contains(&&*name);
        if path.is_dir() && !built && !name.starts_with('.') {
            collect(&path, out);
        } else if name.ends_with(".rs") || name.ends_with(".md") {
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
            "//! A.\nqueue.write_buffer(b, 0, x);\n",
            "//! A.\n#[allow(dead_code)]\n",
            "//! A.\n// TODO\n",
            "//! A.\nlet x = 1; \n",
        ];
        for text in bad {
            assert_eq!(check("ccd-core/src/a.rs", text).len(), 1, "{text:?}");
        }
        assert_eq!(check("a.rs", &format!("//! A.\n{}", "\n".repeat(MAX_LINES))).len(), 1);
        assert_eq!(check("a.rs", &format!("//! {}\n", "x".repeat(MAX_COLUMNS))).len(), 1);
        assert!(check_markdown(&format!("{}\n", "é".repeat(MAX_COLUMNS_MARKDOWN))).is_empty());
        assert_eq!(check_markdown(&"x".repeat(MAX_COLUMNS_MARKDOWN + 1)).len(), 1);
        assert_eq!(check_markdown("| a | \n").len(), 1);
    }

    #[test]
    fn twins_have_the_same_names_or_say_why() {
        let file = |at: usize, name: &str, text: &str| {
            (format!("{}{name}", TWIN_FOLDERS[at]), format!("//! A.\n{text}"))
        };
        let check = |files: &[(String, String)]| check_twins(files).len();
        let lonely = file(1, "tree/half.rs", "");
        assert_eq!(check(std::slice::from_ref(&lonely)), 1);
        assert_eq!(check(&[lonely.clone(), file(2, "half.rs", "")]), 0);
        assert_eq!(check(&[lonely, file(1, "tree/mod.rs", "//! Twin: none.\n")]), 0);
        assert_eq!(check(&[file(3, "a.rs", "//! Twin: none.\n"), file(0, "b.rs", "")]), 0);
    }

    #[test]
    fn sources_are_listed_and_cited() {
        let cited = |text: &str| citations(text).into_iter().collect::<Vec<_>>();
        let text = "see [da Silva 2013], [Karras 2012b] and [Tian and Wan]; \
            not [1, 2], [2012], x[i 2012], [A](b)";
        assert_eq!(cited(text), ["Karras 2012b", "Tian and Wan", "da Silva 2013"]);
        assert_eq!(cited("[`a`] [x; 2012] [name] [Name 20123] [O'Neill 2014]"), ["O'Neill 2014"]);
        let list = "# A\n- **[Karras 2012]** T. Karras.\n";
        let check = |text: &str| check_references(&citations(text), list).len();
        assert_eq!([check("[Karras 2012]"), check(""), check("[Karras 2013]")], [0, 1, 2]);
    }
}
