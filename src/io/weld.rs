//! Vertices that have exactly the same position become one; in a later frame of the same mesh,
//! those that became one in the first.

use super::{Frame, ReadErrorKind};
use std::collections::HashMap;

/// Positions seen so far, by their bits; both zeros are one.
#[derive(Default)]
pub(super) struct Weld {
    seen: HashMap<[u64; 3], u32>,
}

impl Weld {
    /// The vertex at a position, which is appended to the frame if there is none yet.
    pub fn vertex(&mut self, position: [f64; 3], frame: &mut Frame) -> u32 {
        let bits = position.map(|x| (x + 0.0).to_bits());
        let vertex = *self.seen.entry(bits).or_insert_with(|| {
            frame.positions.push(position);
            frame.positions.len() as u32 - 1
        });
        frame.merged.push(vertex);
        vertex
    }
}

impl Frame {
    /// This frame with the vertices of `first`, another frame of its mesh: vertices of STL and glTF
    /// files are merged as they are there, so that bodies which touch in one of the frames alone do
    /// not change the mesh. A frame of another mesh stays as it is, with its own topology.
    ///
    /// # Errors
    /// [`ReadErrorKind::Element`] with a vertex that was at the place of another one in `first`,
    /// and is not here.
    pub fn merged_as(self, first: &Frame) -> Result<Frame, ReadErrorKind> {
        merged_as(self, first)
    }
}

fn merged_as(mut frame: Frame, first: &Frame) -> Result<Frame, ReadErrorKind> {
    if first.merged.is_empty() || frame.merged.len() != first.merged.len() {
        return Ok(frame);
    }
    let mut positions: Vec<Option<[f64; 3]>> = vec![None; first.positions.len()];
    for (at, (&of_first, &own)) in first.merged.iter().zip(&frame.merged).enumerate() {
        let position = frame.positions[own as usize];
        if *positions[of_first as usize].get_or_insert(position) != position {
            let what = "was at the place of another one in the first frame, which made them one \
                        vertex, and is not here: use a format that keeps vertices (PLY, OBJ)";
            return Err(ReadErrorKind::Element { element: "vertex", at, what: what.into() });
        }
    }
    let positions: Vec<[f64; 3]> = positions.into_iter().flatten().collect();
    let same = |a: u32, b: u32| frame.positions.get(a as usize) == positions.get(b as usize);
    let faces = frame.faces.iter().flatten().zip(first.faces.iter().flatten());
    let edges = frame.edges.iter().flatten().zip(first.edges.iter().flatten());
    let counts = |frame: &Frame| [frame.faces.len(), frame.edges.len()];
    if counts(&frame) == counts(first) && faces.chain(edges).all(|(&a, &b)| same(a, b)) {
        let Frame { faces, edges, merged, .. } = first;
        (frame.faces, frame.edges) = (faces.clone(), edges.clone());
        (frame.merged, frame.positions) = (merged.clone(), positions);
    }
    Ok(frame)
}
