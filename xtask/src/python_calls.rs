//! Public calls of the facade, each with its row in `docs/python-calls.md`: Python's name, or why
//! there is none.
//!
//! Calls are read from the sources: functions, constants, and of types the functions and fields.
//! Modules for which Python has something else (`WHOLE`) have one row each, and so have the calls
//! that a type of `any` shares with that of the root.

use crate::circles::{Path, code, uses};
use std::collections::{BTreeMap, BTreeSet};

/// The table.
const TABLE: &str = "docs/python-calls.md";
/// Root of the facade.
const FACADE: &str = "src/lib.rs";
/// Crates that the facade re-exports from, the core first; `backend/` is the project's own.
const CRATES: [(&str, &str); 2] = [("ccd_core", "ccd-core/src/"), ("ccd_cpu", "ccd-cpu/src/")];
/// Modules of the facade that have one row each.
const WHOLE: [&str; 5] = ["geometry", "gpu", "group", "positions", "scenes"];

type Files = [(String, String)];

/// A line for each call without a row, and each row without a call. `files`: names from the root
/// of the repository, and their texts.
pub fn check(files: &Files) -> Vec<String> {
    let Some((_, table)) = files.iter().find(|(name, _)| name == TABLE) else {
        return vec![format!("{TABLE}: is not there")];
    };
    let (calls, mut rows) = (calls(files), BTreeMap::new());
    let mut problems = Vec::new();
    for (at, line) in table.lines().enumerate().filter(|(_, line)| line.starts_with("| `")) {
        let (rust, python) = line[2..].split_once(" | ").unwrap_or_default();
        if !python.contains('`') && !python.starts_with("none: ") {
            problems.push(format!("{TABLE}:{}: neither a name nor `none: ` and why", at + 1));
        }
        for call in rust.split('`').skip(1).step_by(2) {
            if rows.insert(call.to_owned(), at + 1).is_some() {
                problems.push(format!("{TABLE}:{}: {call} has another row", at + 1));
            }
        }
    }
    let missing = calls.iter().filter(|call| !rows.contains_key(*call));
    problems.extend(missing.map(|call| format!("{TABLE}: {call} has no row")));
    let unknown = rows.iter().filter(|(call, _)| !calls.contains(*call));
    problems.extend(unknown.map(|(call, at)| format!("{TABLE}:{at}: there is no {call}")));
    problems
}

/// Names of all calls below the facade: `step`, `exact::vertex_face`, `Session::step`.
fn calls(files: &Files) -> BTreeSet<String> {
    let files: Vec<(&str, String)> = files
        .iter()
        .filter(|(file, _)| file.ends_with(".rs") && !file.contains("/backend/"))
        .map(|(file, text)| (file.as_str(), code(text)))
        .collect();
    let text = |name: &str| files.iter().find(|(file, _)| *file == name).map(|(_, text)| text);
    let mut all = BTreeSet::new();
    for (module, body) in modules(text(FACADE).map_or("", |text| text)) {
        if WHOLE.contains(&&module[..]) {
            all.insert(module);
            continue;
        }
        // A module in a file of its own.
        let folder = format!("src/{module}/");
        let of_file = || text(&format!("{folder}mod.rs")).cloned();
        let body = body.or_else(of_file).unwrap_or_default();
        let before = if module.is_empty() { String::new() } else { format!("{module}::") };
        let mut add = |name: &str, place: &str| {
            if name.starts_with(|c: char| c.is_lowercase()) || name == name.to_uppercase() {
                all.insert(format!("{before}{name}"));
                return;
            }
            for member in members(&files, place, name) {
                let call = format!("{name}::{member}");
                if module.is_empty() || !all.contains(&call) {
                    all.insert(format!("{before}{call}"));
                }
            }
        };
        for path in public_uses(&body).iter().filter(|path| path.len() > 1) {
            match CRATES.iter().find(|(of, _)| *of == path[0]) {
                Some((_, of_crate)) => {
                    let root = text(&format!("{of_crate}lib.rs")).map_or("", |text| text);
                    add(path.last().map_or("", |name| name), &place(of_crate, root, &path[1..]));
                }
                None => add(path.last().map_or("", |name| name), &folder),
            }
        }
        body.lines().filter_map(defined).for_each(|name| add(name, &folder));
    }
    all.retain(|call| !call.starts_with("any::Engine::"));
    all
}

/// Beginning of the names of files in which an item may stand: those of the deepest module that
/// its path names, from the root of a crate or by what the root re-exports.
fn place(of_crate: &str, root: &str, path: &[String]) -> String {
    let at_root = public_uses(root).into_iter().find(|to| to.len() > 1 && to.last() == path.last());
    let path = at_root.filter(|_| path.len() == 1).unwrap_or_else(|| path.to_vec());
    let modules = &path[..path.len().saturating_sub(1)];
    format!("{of_crate}{}", modules.join("/"))
}

/// Public modules of a file with what stands in them, if that is in the file; first the file itself
/// as one without a name.
fn modules(code: &str) -> Vec<(String, Option<String>)> {
    let mut all = vec![(String::new(), Some(String::new()))];
    let mut inside = false;
    for line in code.lines() {
        if let Some(name) = line.strip_prefix("pub mod ") {
            inside = name.ends_with('{');
            all.push((word(name).to_owned(), inside.then(String::new)));
        } else if let Some(module) = line.strip_prefix("pub use ccd_gpu as ") {
            all.push((word(module).to_owned(), None));
        } else {
            let at = if inside { all.len() - 1 } else { 0 };
            if let Some(body) = &mut all[at].1 {
                body.extend([line, "\n"]);
            }
            inside &= line != "}";
        }
    }
    all
}

/// Paths that a text re-exports.
fn public_uses(code: &str) -> Vec<Path> {
    let attributes = |line: &&str| !line.trim_start().starts_with("#[");
    let text: Vec<&str> = code.lines().filter(attributes).collect();
    let text = text.join("\n");
    let public = text.split_inclusive(';').filter(|s| s.trim_start().starts_with("pub use "));
    uses(&public.map(|s| format!("{}\n", s.trim_start())).collect::<String>())
}

/// The name that a line without indentation makes public.
fn defined(line: &str) -> Option<&str> {
    let rest = line.strip_prefix("pub ")?;
    let kinds = ["fn ", "const fn ", "const ", "struct ", "enum ", "trait ", "type "];
    Some(word(kinds.iter().find_map(|kind| rest.strip_prefix(kind))?))
}

/// Functions, constants and fields of a type, or of a trait. `place`: where it is defined, or
/// re-exported.
fn members(files: &[(&str, String)], place: &str, name: &str) -> BTreeSet<String> {
    let mut all = BTreeSet::new();
    let of_crate = place.split_once("src/").map_or(place.len(), |(before, _)| before.len() + 4);
    let in_crate = files.iter().filter(|(file, _)| file.starts_with(&place[..of_crate]));
    let mut is_there = false;
    for (file, text) in in_crate {
        let defines = text.lines().any(|line| defined(line) == Some(name));
        if defines && !file.starts_with(place) {
            // Another one of that name.
            continue;
        }
        is_there |= defines;
        let mut lines = text.lines();
        while let Some(line) = lines.next() {
            let rest = line.strip_prefix("pub type ").filter(|rest| word(rest) == name);
            if let Some(of) = rest {
                // An alias of a type of the core, with the engine that its calls are found in too.
                all.extend(members(files, CRATES[0].1, name));
                if of.contains("Engine") {
                    all.extend(members(files, place, "Engine"));
                }
            } else if !line.ends_with(['}', ';']) && opens(line, name) {
                let is_trait = line.starts_with("pub trait ");
                all.extend(of_body(lines.by_ref().take_while(|l| !l.starts_with('}')), is_trait));
            }
        }
    }
    // What re-exports it says no more than the crate, or another one.
    match (is_there, &place[..of_crate]) {
        (false, root) if root != place => members(files, root, name),
        (false, root) if root != CRATES[0].1 => members(files, CRATES[0].1, name),
        _ => all,
    }
}

/// Whether a line begins a type's definition, or an `impl` of it and of no trait.
fn opens(line: &str, name: &str) -> bool {
    if let Some(rest) = line.strip_prefix("impl").filter(|_| !line.contains(" for ")) {
        let rest = rest.strip_prefix('<').map_or(rest, after_angles);
        return word(rest.trim_start()) == name;
    }
    ["pub struct ", "pub trait "]
        .iter()
        .any(|kind| line.strip_prefix(kind).is_some_and(|rest| word(rest) == name))
}

/// What the lines of a type's body make public and its documentation shows.
fn of_body<'a>(lines: impl Iterator<Item = &'a str>, is_trait: bool) -> BTreeSet<String> {
    let (mut all, mut hidden) = (BTreeSet::new(), false);
    for line in lines {
        let Some(line) = line.strip_prefix("    ") else { continue };
        hidden |= line.starts_with("#[doc(hidden)]");
        let public = if is_trait { Some(line) } else { line.strip_prefix("pub ") };
        let kinds = ["fn ", "const fn ", "const "];
        let function = |line| kinds.iter().find_map(|kind| str::strip_prefix(line, kind));
        let name = match public {
            Some(line) => word(function(line).unwrap_or(if is_trait { "" } else { line })),
            None => "",
        };
        if !name.is_empty() && !std::mem::take(&mut hidden) {
            all.insert(name.to_owned());
        }
    }
    all
}

fn word(text: &str) -> &str {
    text.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or("")
}

/// What stands behind generics, whose opening bracket has been read.
fn after_angles(text: &str) -> &str {
    let mut depth = 1;
    for (at, c) in text.char_indices() {
        depth += i32::from(c == '<') - i32::from(c == '>');
        if depth == 0 {
            return &text[at + 1..];
        }
    }
    ""
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOURCES: [(&str, &str); 5] = [
        (
            FACADE,
            "pub mod any;\npub mod exact {\n    pub use ccd_core::exact::{face, Exact};\n}\n\
             pub mod positions {\n    pub use ccd_core::View;\n}\n\
             pub use ccd_core::model::mesh::Mesh;\npub use ccd_cpu::{Session, step};\n",
        ),
        ("src/any/mod.rs", "pub type Session = core::Session<Engine>;\npub fn choose() {}\n"),
        (
            "ccd-core/src/model/mesh.rs",
            "pub struct Mesh {\n    faces: u8,\n    pub edges: u8,\n}\nimpl Mesh {\n    \
             pub const fn new() {\n        pub fn inner() {}\n    }\n    #[doc(hidden)]\n    \
             pub fn hidden() {}\n    fn private() {}\n}\nimpl Clone for Mesh {\n    \
             pub fn clone() {}\n}\n",
        ),
        (
            "ccd-core/src/model/session.rs",
            "pub struct Session<E> {\n}\nimpl<E: Into<Vec<u8>>> Session<E> {\n    \
             pub fn go() {}\n}\npub struct Mesh {\n    pub of_session: u8,\n}\n",
        ),
        (
            "ccd-cpu/src/session.rs",
            "pub type Session = session::Session<Engine>;\npub struct Engine {\n}\n\
             impl Engine {\n    pub fn threads() {}\n}\n",
        ),
    ];

    fn with(table: &str) -> Vec<String> {
        let table = (TABLE, format!("| Rust | Python |\n|---|---|\n{table}"));
        let sources = SOURCES.map(|(name, text)| (name.to_owned(), text.to_owned()));
        check(&[&sources[..], &[(table.0.to_owned(), table.1)]].concat())
    }

    #[test]
    fn every_call_has_a_row() {
        let rows = [
            "| `Mesh::new`, `Mesh::edges` | `Mesh(faces)` |\n",
            "| `Session::go`, `step` | `Session.go` |\n",
            "| `Session::threads`, `any::choose` | none: a reason |\n",
            "| `exact::face`, `positions` | `exact.face` |\n",
        ];
        assert_eq!(with(&rows.concat()), [""; 0]);
        for (i, n_calls) in [2, 2, 2, 2].into_iter().enumerate() {
            let less: String =
                rows.iter().enumerate().filter(|(k, _)| *k != i).map(|r| *r.1).collect();
            let problems = with(&less);
            assert_eq!(problems.len(), n_calls, "{problems:?}");
            assert!(problems.iter().all(|p| p.ends_with("has no row")), "{problems:?}");
        }
        for (row, want) in [
            ("| `Mesh::hidden` | `Mesh` |\n", "there is no Mesh::hidden"),
            ("| `step` | `Mesh` |\n", "step has another row"),
        ] {
            let problems = with(&(rows.concat() + row));
            assert!(problems.len() == 1 && problems[0].ends_with(want), "{problems:?}");
        }
        let vague = rows.concat().replace("none: a reason", "none");
        assert!(with(&vague)[0].contains("neither a name nor"), "{:?}", with(&vague));
    }
}
