//! What tests, benches and the report share: real scenes with their ground truth, generated scenes, brute force, an exact oracle.

pub mod brute;
pub mod compare;
pub mod data;
pub mod generate;
pub mod oracle;
