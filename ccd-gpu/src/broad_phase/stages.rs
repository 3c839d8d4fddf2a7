//! Names of stages, by kind of pairs.
//!
//! Twin: none; a CPU takes the time of descents instead (`descent_times.rs`).

/// Stages in which pairs are found.
pub const PAIRS: [&str; 2] = ["pairs vertex-face", "pairs edge-edge"];
/// Stages in which the pairs of a front are tested.
pub const FRONT: [&str; 2] = ["front vertex-face", "front edge-edge"];
/// Stages in which what workers have left is dealt out again, and expanded.
pub const BALANCING: [&str; 2] = ["balancing vertex-face", "balancing edge-edge"];
