//! The committed header is what cbindgen writes from the sources. `CCD_WRITE_HEADER=1 cargo test
//! --release --workspace --test header` writes it anew.

use std::path::Path;

const HEADER: &str = "include/ccd.h";
/// Sources with what is exported, in the order in which the header has it.
const SOURCES: [&str; 7] = ["status", "mesh", "bodies", "options", "results", "session", "moving"];

#[test]
fn the_header_is_that_of_the_sources() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
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
