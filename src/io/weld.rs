//! Vertices that have exactly the same position become one.

use std::collections::HashMap;

/// Positions seen so far, by their bits; both zeros are one.
#[derive(Default)]
pub(super) struct Weld {
    seen: HashMap<[u64; 3], u32>,
}

impl Weld {
    /// The vertex at a position, which is appended to `positions` if there is none yet.
    pub fn vertex(&mut self, position: [f64; 3], positions: &mut Vec<[f64; 3]>) -> u32 {
        let bits = position.map(|x| (x + 0.0).to_bits());
        *self.seen.entry(bits).or_insert_with(|| {
            positions.push(position);
            positions.len() as u32 - 1
        })
    }
}
