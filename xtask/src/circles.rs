//! Circles of files: two files that need each other cannot be read, tested or moved alone.
//!
//! A file needs another if it names that module or an item of it, in a `use` or after `crate`,
//! `self` or `super`; re-exports are followed. A module and its children may name each other: a
//! circle that goes down from a module to one below it and up again does not count.

use std::collections::{BTreeMap, BTreeSet};

/// Folders of crates.
const CRATES: [&str; 11] = [
    "ccd-c/src/",
    "ccd-cli/src/",
    "ccd-core/src/",
    "ccd-cpu/src/",
    "ccd-gpu/src/",
    "ccd-python/src/",
    "ccd-shaders/src/",
    "ccd-testkit/src/",
    "ccd-web/src/",
    "src/",
    "xtask/src/",
];

/// A module or an item: its names from the root of the crate, or from a crate.
pub type Path = Vec<String>;

struct Module<'a> {
    file: &'a str,
    code: String,
    /// Paths named by `use`.
    uses: Vec<Path>,
}

/// A line for each circle. `files`: names from the root of the repository, and their texts.
pub fn check(files: &[(String, String)]) -> Vec<String> {
    let mut found = BTreeSet::new();
    for folder in CRATES {
        let of_crate = files.iter().filter_map(|(name, text)| {
            Some((name.strip_prefix(folder)?.strip_suffix(".rs")?, name.as_str(), text.as_str()))
        });
        found.extend(circles(of_crate));
    }
    found.iter().map(|circle| format!("a circle of files: {}", circle.join(", "))).collect()
}

/// Circles of one crate, each sorted. Items: names without folder and ending, files, text.
fn circles<'a>(files: impl Iterator<Item = (&'a str, &'a str, &'a str)>) -> Vec<Vec<String>> {
    let mut modules = BTreeMap::new();
    for (name, file, text) in files {
        let mut path: Path = name.split('/').map(str::to_owned).collect();
        if path.last().is_some_and(|last| ["lib", "main", "mod"].contains(&last.as_str())) {
            path.pop();
        }
        let code = code(text);
        let uses = uses(&code);
        modules.insert(path, Module { file, code, uses });
    }
    let mut edges: Vec<(&Path, &Path)> = Vec::new();
    for (from, module) in modules.iter().filter(|(_, m)| !m.file.ends_with("tests.rs")) {
        for path in module.uses.iter().cloned().chain(named(&module.code)) {
            edges.extend(resolve(&modules, from, &path, 0).map(|to| (from, to)));
        }
    }
    edges.retain(|(from, to)| from != to);
    // A circle is one still if no file may name those below it, or none those above.
    let ways = |not: fn(&Path, &Path) -> bool| {
        let edges: Vec<_> = edges.iter().copied().filter(|(a, b)| !not(a, b)).collect();
        components(&edges)
    };
    let mut all = ways(|from, to| to.starts_with(from));
    all.extend(ways(|from, to| from.starts_with(to)));
    let files = |c: Vec<&Path>| {
        let mut files: Vec<String> = c.iter().map(|path| modules[*path].file.to_owned()).collect();
        files.sort();
        files
    };
    all.into_iter().map(files).collect()
}

/// Without comments, texts, and the tests at the end.
pub fn code(text: &str) -> String {
    let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or(text);
    let mut out = String::new();
    for line in text.lines() {
        let line = line.split("//").next().unwrap_or(line);
        // Every second part is between quotes.
        line.split('"').step_by(2).for_each(|part| out.push_str(part));
        out.push('\n');
    }
    out
}

/// Paths named by every `use` of a file.
pub fn uses(code: &str) -> Vec<Path> {
    let mut all = Vec::new();
    for line in code.match_indices("use ").filter_map(|(at, _)| {
        let before = code[..at].rsplit('\n').next().unwrap_or("").trim();
        (before.is_empty() || before.starts_with("pub")).then(|| &code[at + 4..])
    }) {
        let text: String = line.split(';').next().unwrap_or("").to_owned();
        expand(&text, &[], &mut all);
    }
    all
}

/// `a::{b, c::d}` as `a::b` and `a::c::d`.
fn expand(text: &str, before: &[String], all: &mut Vec<Path>) {
    let (head, group) = match text.split_once('{') {
        Some((head, rest)) => (head, rest.rsplit_once('}').map(|(group, _)| group)),
        None => (text.split(" as ").next().unwrap_or(text), None),
    };
    let names = head.split("::").map(str::trim).filter(|name| !name.is_empty());
    let path: Path = before.iter().cloned().chain(names.map(str::to_owned)).collect();
    let Some(group) = group else {
        if !head.trim().is_empty() {
            all.push(path);
        }
        return;
    };
    let (mut depth, mut start) = (0, 0);
    for (at, c) in group.char_indices().chain([(group.len(), ',')]) {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                expand(&group[start..at], &path, all);
                start = (at + 1).min(group.len());
            }
            _ => {}
        }
    }
}

/// Paths in code that begin with `crate`, `self` or `super`.
fn named(code: &str) -> impl Iterator<Item = Path> {
    let words = code.split(|c: char| !c.is_alphanumeric() && c != '_' && c != ':');
    let paths = words.map(|word| word.trim_matches(':').split("::").map(str::to_owned).collect());
    paths.filter(|path: &Path| {
        path.len() > 1 && ["crate", "self", "super"].contains(&path[0].as_str())
    })
}

/// The module in which stands what a path names, seen from a module.
fn resolve<'m>(
    modules: &'m BTreeMap<Path, Module>,
    from: &Path,
    path: &[String],
    depth: usize,
) -> Option<&'m Path> {
    let mut at = from.clone();
    let mut names = path.iter().filter(|name| *name != "self").peekable();
    match path.first()?.as_str() {
        "crate" => {
            at.clear();
            names.next();
        }
        "super" | "self" => {}
        // A child by its name; what else there is belongs to another crate.
        first => _ = modules.get(&[&at[..], &[first.to_owned()]].concat())?,
    }
    while let Some(name) = names.peek() {
        let below = [&at[..], &[(*name).clone()]].concat();
        match name.as_str() {
            "super" => _ = at.pop(),
            _ if modules.contains_key(&below) => at = below,
            _ => break,
        }
        names.next();
    }
    let (at, module) = modules.get_key_value(&at)?;
    let Some(item) = names.next().filter(|name| *name != "*" && depth < 6) else { return Some(at) };
    let defines = |m: &Module| {
        let kinds = ["fn", "struct", "enum", "trait", "const", "type", "static", "macro_rules!"];
        kinds.iter().any(|kind| {
            m.code.match_indices(&format!("{kind} {item}")).any(|(i, all)| {
                !m.code[i + all.len()..].starts_with(|c: char| c.is_alphanumeric() || c == '_')
            })
        })
    };
    let elsewhere = module.uses.iter().filter_map(|path| match path.split_last()? {
        (last, _) if last == item => resolve(modules, at, path, depth + 1),
        (last, most) if last == "*" => {
            resolve(modules, at, most, depth + 1).filter(|to| defines(&modules[*to]))
        }
        _ => None,
    });
    Some(elsewhere.into_iter().next().unwrap_or(at))
}

/// Strongly connected components of more than one node: what reaches each other.
fn components<'m>(edges: &[(&'m Path, &'m Path)]) -> Vec<Vec<&'m Path>> {
    let reached = |start: &'m Path, forward: bool| {
        let (mut seen, mut next) = (BTreeSet::new(), vec![start]);
        while let Some(at) = next.pop() {
            for &(a, b) in edges {
                let (a, b) = if forward { (a, b) } else { (b, a) };
                if a == at && seen.insert(b) {
                    next.push(b);
                }
            }
        }
        seen
    };
    let mut left: BTreeSet<&Path> = edges.iter().flat_map(|&(a, b)| [a, b]).collect();
    let mut all = Vec::new();
    while let Some(start) = left.pop_first() {
        let circle: BTreeSet<_> =
            reached(start, true).intersection(&reached(start, false)).copied().collect();
        left.retain(|path| !circle.contains(path));
        all.extend((circle.len() > 1).then(|| circle.into_iter().collect()));
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(files: &[(&str, &str)]) -> Vec<String> {
        let named = files.iter().map(|(name, text)| (*name, *name, *text));
        circles(named).into_iter().map(|circle| circle.join(" ")).collect()
    }

    #[test]
    fn circles_are_found_and_a_parent_with_its_children_is_none() {
        let a = ("a", "use crate::b::{self, C};\n");
        assert_eq!(of(&[a, ("b", "fn f() { super::a::g() }\n")]), ["a b"; 2]);
        assert_eq!(of(&[a, ("b", "// crate::a\nconst A: &str = \"crate::a\";\n")]), [""; 0]);
        assert_eq!(
            of(&[a, ("b", "#[cfg(test)]\nmod tests {\n    use crate::a::X;\n}\n")]),
            [""; 0]
        );
        // Through what another file re-exports.
        let lib = ("lib", "mod a;\nmod b;\npub use b::C;\n");
        let b = ("b", "pub struct C;\npub use crate::a::X;\n");
        assert_eq!(of(&[lib, ("a", "use crate::C;\n"), b]), ["a b"; 2]);
        // A module and those below it; but not by way of another.
        let d = ("d/mod", "mod e;\npub use e::E;\nfn f() { self::e::f() }\n");
        assert_eq!(of(&[lib, d, ("d/e", "use super::f;\n")]), [""; 0]);
        let e = ("d/e", "use crate::g::G;\n");
        assert_eq!(of(&[lib, d, e, ("g", "use crate::d::f;\n")]), ["d/e d/mod g"]);
    }

    #[test]
    fn a_circle_is_reported_once() {
        let two = |a: &str, b: &str| (format!("src/{a}.rs"), format!("use crate::{b}::X;\n"));
        let problems = check(&[two("a", "b"), two("b", "a")]);
        assert_eq!(problems, ["a circle of files: src/a.rs, src/b.rs"]);
    }
}
