//! What devices that flush denormals make of boxes, filters and decisions. A number type that
//! flushes what goes into an operation and what comes out of it plays the device.

mod boxes;
mod number;
mod queries;
#[path = "../../../src/scenes/random.rs"]
#[allow(dead_code, reason = "these tests need a part of it")]
mod random;
mod sessions;
mod step;
