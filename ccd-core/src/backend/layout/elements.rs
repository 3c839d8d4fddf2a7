//! Elements of a mesh as a device has them: the words of all edges, then those of all faces.

use super::{EDGE_EDGE, Pair, VERTEX_FACE};
use crate::kernel::memory::at;

/// The vertices of edge `i`.
#[inline(always)]
pub fn edge(i: u32, elements: &[u32]) -> [u32; 2] {
    let i = 2 * i as usize;
    [at(elements, i), at(elements, i + 1)]
}

/// The vertices of face `i`, behind so many edges.
#[inline(always)]
pub fn face(i: u32, n_edges: u32, elements: &[u32]) -> [u32; 3] {
    let i = 2 * n_edges as usize + 3 * i as usize;
    [at(elements, i), at(elements, i + 1), at(elements, i + 2)]
}

/// The vertices of element `i` of all; an edge repeats its last.
#[inline(always)]
pub fn vertices(i: u32, n_edges: u32, elements: &[u32]) -> [u32; 3] {
    if i < n_edges {
        let [a, b] = edge(i, elements);
        [a, b, b]
    } else {
        face(i - n_edges, n_edges, elements)
    }
}

/// The bit of `b` by which a pair that is listed among those of both kinds is one of edges. Ids are
/// smaller: a device binds no more than 2^32 bytes of boxes at once.
const EDGES: u32 = 1 << 31;

/// A pair as lists have it that hold pairs of both kinds: the highest bit of `b` is the kind.
#[inline(always)]
pub fn with_kind(kind: u32, pair: Pair) -> Pair {
    Pair { a: pair.a, b: pair.b | kind << 31 }
}

/// The kind of such a pair, and the pair alone.
#[inline(always)]
pub fn kind_of(pair: Pair) -> (u32, Pair) {
    let kind = if pair.b & EDGES == 0 { VERTEX_FACE } else { EDGE_EDGE };
    (kind, Pair { a: pair.a, b: pair.b & !EDGES })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_are_behind_edges() {
        let elements = [0, 1, 1, 2, 2, 3, 0, 1, 2, 1, 2, 3];
        assert_eq!([1, 2].map(|i| edge(i, &elements)), [[1, 2], [2, 3]]);
        assert_eq!([0, 1].map(|i| face(i, 3, &elements)), [[0, 1, 2], [1, 2, 3]]);
        assert_eq!([2, 3].map(|i| vertices(i, 3, &elements)), [[2, 3, 3], [0, 1, 2]]);
    }

    #[test]
    fn pairs_have_their_kind_in_a_bit() {
        for id in [0, 7, EDGES - 1] {
            let pair = Pair { a: id, b: id };
            for kind in [VERTEX_FACE, EDGE_EDGE] {
                assert_eq!(kind_of(with_kind(kind, pair)), (kind, pair));
            }
            assert_eq!(with_kind(VERTEX_FACE, pair), pair);
        }
    }
}
