//! Examples of documentation name what the facade re-exports by the facade: a page of `ccd` shows
//! the examples of the crate that has the item, and what it shows must compile when pasted.

use crate::circles::{Path, code, uses};

/// Root of the facade.
const FACADE: &str = "src/lib.rs";
/// Crates that the facade re-exports from.
const CRATES: [(&str, &str); 3] =
    [("ccd-core/src/", "ccd_core"), ("ccd-cpu/src/", "ccd_cpu"), ("ccd-gpu/src/", "ccd_gpu")];

/// A line for each path of an example that the facade has too. `files`: names from the root of the
/// repository, and their texts.
pub fn check(files: &[(String, String)]) -> Vec<String> {
    let re_exported = re_exported(files);
    let mut problems = Vec::new();
    for (file, text) in files {
        if CRATES.iter().any(|(folder, _)| file.starts_with(folder)) {
            let named = examples(text).into_iter().flat_map(|(line, example)| {
                paths(&example).into_iter().map(move |path| (line, path))
            });
            let wrong = named.filter(|(_, path)| re_exported.iter().any(|p| path.starts_with(p)));
            problems.extend(wrong.map(|(line, path)| {
                let path = path.join("::");
                format!("{file}:{line}: the example names {path}, which `ccd` re-exports")
            }));
        }
    }
    problems
}

/// Paths that the facade re-exports; of an item that a crate has in a module and at its root, both.
fn re_exported(files: &[(String, String)]) -> Vec<Path> {
    let uses_of = |name: &str| {
        let file = files.iter().find(|(file, _)| file == name);
        file.map(|(_, text)| uses(&code(text))).unwrap_or_default()
    };
    let mut all = uses_of(FACADE);
    for (folder, name) in CRATES {
        for path in uses_of(&format!("{folder}lib.rs")) {
            let name = name.to_owned();
            let at_root: Path = [&name].into_iter().chain(path.last()).cloned().collect();
            let in_module: Path = [&name].into_iter().chain(&path).cloned().collect();
            if all.contains(&at_root) {
                all.push(in_module);
            } else if all.contains(&in_module) {
                all.push(at_root);
            }
        }
    }
    all.retain(|path| CRATES.iter().any(|(_, name)| path.first().is_some_and(|p| p == name)));
    all
}

/// Code in doc comments, without the marks of hidden lines; each with the number of its first line.
fn examples(text: &str) -> Vec<(usize, String)> {
    let mut all: Vec<(usize, String)> = Vec::new();
    let mut inside = false;
    for (i, line) in text.lines().enumerate() {
        let line = line.trim_start();
        let Some(line) = line.strip_prefix("///").or(line.strip_prefix("//!")) else {
            inside = false;
            continue;
        };
        let line = line.trim();
        if line.starts_with("```") {
            inside = !inside;
            if inside {
                all.push((i + 2, String::new()));
            }
        } else if let Some((_, example)) = all.last_mut().filter(|_| inside) {
            example.push_str(line.strip_prefix("# ").unwrap_or(line));
            example.push('\n');
        }
    }
    all
}

/// Paths that an example names, in a `use` or in full.
fn paths(example: &str) -> Vec<Path> {
    let mut all = uses(example);
    for line in example.lines().filter(|line| !line.starts_with("use ")) {
        let words = line.split(|c: char| !c.is_alphanumeric() && c != '_' && c != ':');
        all.extend(words.map(|w| w.trim_matches(':').split("::").map(str::to_owned).collect()));
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn examples_name_the_facade() {
        let facade = "pub mod geometry { pub use ccd_core::math::vec3; }\n\
            pub use ccd_core::{Aabb, model::mesh::Mesh};\npub use ccd_gpu as gpu;\n";
        let core = "mod math;\npub use math::aabb::Aabb;\n";
        let n_wrong = |folder: &str, example: &str| {
            let files = [
                (FACADE, facade.to_owned()),
                ("ccd-core/src/lib.rs", core.to_owned()),
                (folder, format!("//! A.\n/// ```\n{example}/// ```\nuse ccd_core::Aabb;\n")),
            ];
            check(&files.map(|(name, text)| (name.to_owned(), text))).len()
        };
        for (example, want) in [
            ("/// use ccd::{Aabb, Mesh};\n", 0),
            ("/// use ccd_core::reference::step;\n", 0),
            ("/// use ccd_core::model::mesh::Other;\n", 0),
            ("/// ```\n/// `ccd_core::Aabb`, in prose.\n/// ```\n", 0),
            ("/// use ccd_core::Aabb;\n", 1),
            ("/// use ccd_core::math::aabb::Aabb;\n", 1),
            ("/// # use ccd_core::math::vec3::dot;\n", 1),
            (
                "/// use ccd_core::{\n///     Aabb, model::{mesh::Mesh, bodies::Bodies},\n/// };\n",
                2,
            ),
            ("/// # Ok::<(), ccd_gpu::Error>(())\n", 1),
        ] {
            assert_eq!(n_wrong("ccd-cpu/src/a.rs", example), want, "{example}");
            assert_eq!(n_wrong("ccd-cli/src/a.rs", example), 0, "{example}");
        }
    }
}
