//! The committed header of the C API is what cbindgen writes from the sources, and docs/c.md names
//! its functions and has the text of an example that CMake compiles. `CCD_WRITE_HEADER=1 cargo test
//! --release --workspace --test header` writes it anew.

use std::collections::BTreeSet;
use std::path::Path;

const C_API: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../ccd-c");
const HEADER: &str = "include/ccd.h";
/// Sources with what is exported, in the order in which the header has it.
const SOURCES: [&str; 7] = ["status", "mesh", "bodies", "options", "results", "session", "moving"];

#[test]
fn the_header_is_that_of_the_sources() {
    let root = Path::new(C_API);
    let config = cbindgen::Config::from_file(root.join("cbindgen.toml")).expect("cbindgen.toml");
    let builder = cbindgen::Builder::new().with_config(config);
    let source = |name: &&str| root.join(format!("src/{name}.rs"));
    let builder = SOURCES.iter().map(source).fold(builder, |builder, file| builder.with_src(file));
    let mut want = Vec::new();
    builder.generate().expect("the sources are Rust").write(&mut want);
    let want = String::from_utf8(want).expect("text");

    if std::env::var_os("CCD_WRITE_HEADER").is_some() {
        std::fs::write(root.join(HEADER), &want).expect("the header can be written");
    }
    let have = std::fs::read_to_string(root.join(HEADER)).unwrap_or_default();
    if let Some(why) = difference(&have.replace("\r\n", "\n"), &want) {
        panic!("{HEADER} is not that of the sources; CCD_WRITE_HEADER=1 writes it anew.\n{why}");
    }
    let long = want.lines().find(|line| line.chars().count() > 100);
    assert_eq!(long, None, "a line of more than 100 columns");
}

#[test]
fn the_page_has_every_function() {
    let root = Path::new(C_API);
    let read = |name: &str| std::fs::read_to_string(root.join(name)).expect(name);
    let (header, page) = (read(HEADER), read("../docs/c.md"));
    let declared = functions(&header, |after| after.starts_with('('));
    assert!(declared.len() > 40, "{declared:?}");
    let (_, table) = page.split_once("## Functions").expect("a table");
    let (table, _) = table.split_once("\n## ").expect("what follows the table");
    assert_eq!(functions(table, |_| true), declared);
    let example = read("examples/first_steps.cpp").replace("\r\n", "\n");
    assert!(page.replace("\r\n", "\n").contains(&format!("```cpp\n{example}```")));
}

/// Names that begin with `ccd_` and are followed by what is wanted; the parentheses of comments are
/// those of functions too.
fn functions(text: &str, wanted: impl Fn(&str) -> bool) -> BTreeSet<&str> {
    let begins = text.match_indices("ccd_").map(|(at, _)| at);
    let names = begins.filter_map(|at| {
        let rest = &text[at..];
        let end = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_')?;
        wanted(&rest[end..]).then_some(&rest[..end])
    });
    names.collect()
}

/// The first line that differs.
fn difference(have: &str, want: &str) -> Option<String> {
    let (ours, theirs): (Vec<_>, Vec<_>) = (have.lines().collect(), want.lines().collect());
    let at = (0..ours.len().max(theirs.len())).find(|&i| ours.get(i) != theirs.get(i))?;
    let line = |lines: &[&str]| lines.get(at).map_or("nothing".into(), |line| format!("{line:?}"));
    let n = at + 1;
    Some(format!("line {n}: the file has {}, the sources say {}", line(&ours), line(&theirs)))
}

#[test]
fn another_header_is_seen() {
    assert_eq!(difference("a\nb\n", "a\nb\n"), None);
    for other in ["", "a\n", "a\nc\n", "a\nb\nc\n"] {
        assert!(difference(other, "a\nb\n").is_some(), "{other:?}");
    }
}
