//! Prints the answers of every scene by every way of finding pairs, as `answers.mjs` does.

use ccd_wasm_test::{answer, n_contacts, n_scenes, n_ways};

fn main() {
    for scene in 0..n_scenes() {
        println!("scene {scene}: {} contacts", n_contacts(scene));
        for way in 0..n_ways() {
            let in_f32 = (scene + way) % 2;
            println!("{scene} {way} {in_f32} {:016x}", answer(scene, way, in_f32, 1));
        }
    }
}
