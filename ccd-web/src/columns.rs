//! Contacts as columns, which JavaScript views as typed arrays.

use ccd::{Contact, Coordinate, Mesh};
use wasm_bindgen::prelude::*;

/// Columns of the last report. Those from `vertices` on are empty if geometry was not asked for.
#[derive(Default)]
pub struct Columns {
    kind: Vec<u8>,
    state: Vec<u8>,
    /// Two a contact.
    ids: Vec<u32>,
    toi: Vec<f64>,
    /// Four a contact.
    vertices: Vec<u32>,
    /// Three a contact.
    point: Vec<f64>,
    /// Three a contact.
    normal: Vec<f64>,
    /// Four a contact.
    weights: Vec<f64>,
}

impl Columns {
    /// Those of these contacts.
    pub fn fill(&mut self, contacts: &[Contact]) {
        self.clear();
        self.kind.extend(contacts.iter().map(|c| c.kind as u8));
        self.state.extend(contacts.iter().map(|c| c.state as u8));
        self.ids.extend(contacts.iter().flat_map(|c| [c.a, c.b]));
        self.toi.extend(contacts.iter().map(|c| c.toi));
    }

    /// Besides, vertices and how they meet.
    pub fn fill_geometry<T: Coordinate>(
        &mut self,
        contacts: &[Contact],
        mesh: &Mesh,
        x: [&[[T; 3]]; 2],
    ) {
        self.vertices.extend(contacts.iter().flat_map(|c| c.vertices(mesh)));
        for contact in contacts {
            let at = contact.geometry(mesh, x[0], x[1]);
            self.point.extend(at.point);
            self.normal.extend(at.normal);
            self.weights.extend(at.weights);
        }
    }

    /// None.
    pub fn clear(&mut self) {
        self.kind.clear();
        self.state.clear();
        self.ids.clear();
        self.toi.clear();
        self.vertices.clear();
        self.point.clear();
        self.normal.clear();
        self.weights.clear();
    }

    /// Where the columns are, in the order of the fields.
    pub fn places(&self) -> Places {
        Places(vec![
            place(&self.kind),
            place(&self.state),
            place(&self.ids),
            place(&self.toi),
            place(&self.vertices),
            place(&self.point),
            place(&self.normal),
            place(&self.weights),
        ])
    }
}

/// Where lists are in memory, until the next call.
#[wasm_bindgen]
pub struct Places(pub(crate) Vec<[usize; 2]>);

#[wasm_bindgen]
impl Places {
    /// Address in bytes of a list, and number of its elements, one list after the other.
    pub fn all(&self) -> Vec<u32> {
        self.0.iter().flatten().map(|&word| word as u32).collect()
    }
}

/// Address and number of elements.
pub fn place<T>(list: &[T]) -> [usize; 2] {
    [list.as_ptr().addr(), list.len()]
}
