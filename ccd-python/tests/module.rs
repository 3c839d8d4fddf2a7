//! The module's library, which cargo builds for this test: it is there, where `cargo xtask python`
//! takes it from, and has the function that an interpreter calls first.

use std::path::Path;

#[test]
fn an_interpreter_finds_the_module() {
    let program = std::env::current_exe().expect("a path");
    let folder = program.parent().expect("target/release/deps");
    let file = format!("{}_native{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
    let path = folder.join(file);
    assert!(exports(&path, b"PyInit__native"), "{}", path.display());
    assert!(!exports(&path, b"PyInit__other"), "a name that is nowhere is found");
}

fn exports(library: &Path, name: &[u8]) -> bool {
    let bytes = std::fs::read(library).expect("the library");
    bytes.windows(name.len()).any(|window| window == name)
}
