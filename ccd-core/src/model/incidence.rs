//! Lists of what each of a number of features has, one list behind the other.

use alloc::vec;
use alloc::vec::Vec;

/// A list of numbers for each feature.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Incidence {
    starts: Vec<u32>,
    items: Vec<u32>,
}

impl Incidence {
    /// Lists for `n` features from pairs of a feature and an item, in the order of the pairs.
    /// `pairs` is called twice: to count, and to fill.
    pub fn new<I: Iterator<Item = (u32, u32)>>(n: usize, pairs: impl Fn() -> I) -> Self {
        let mut starts = vec![0u32; n + 1];
        pairs().for_each(|(feature, _)| starts[feature as usize + 1] += 1);
        for i in 0..n {
            starts[i + 1] += starts[i];
        }
        let mut next = starts.clone();
        let mut items = vec![0; starts[n] as usize];
        for (feature, item) in pairs() {
            let at = &mut next[feature as usize];
            items[*at as usize] = item;
            *at += 1;
        }
        Self { starts, items }
    }

    /// Vertices with the elements that have them, ascending.
    pub fn of_vertices<const N: usize>(n_vertices: usize, elements: &[[u32; N]]) -> Self {
        let vertices = |(i, element): (u32, &[u32; N])| element.map(|v| (v, i));
        Self::new(n_vertices, || (0..).zip(elements).flat_map(vertices))
    }

    /// The list of a feature.
    pub fn of(&self, feature: u32) -> &[u32] {
        let i = feature as usize;
        &self.items[self.starts[i] as usize..self.starts[i + 1] as usize]
    }
}
