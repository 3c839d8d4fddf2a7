//! The answers of every scene by every way of finding pairs, as `answers.mjs` prints them: written
//! to a file, with which `cargo xtask wasm` compares.

use ccd_wasm_test::{answer, n_contacts, n_scenes, n_ways};
use std::fmt::Write;

#[test]
fn answers_of_this_machine() {
    let mut text = String::new();
    for scene in 0..n_scenes() {
        let n = n_contacts(scene);
        assert!(n > 0 && n < u64::MAX, "scene {scene}: {n} contacts show nothing");
        writeln!(text, "scene {scene}: {n} contacts").expect("a string");
        for way in 0..n_ways() {
            let in_f32 = (scene + way) % 2;
            let answer = answer(scene, way, in_f32, 1);
            writeln!(text, "{scene} {way} {in_f32} {answer:016x}").expect("a string");
        }
    }
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    std::fs::write(folder.join("answers.txt"), text).expect("a file");
}
