//! Contacts in their canonical order: by kind, `a`, `b`, sorted as numbers rather than compared.

use crate::sort::{self, RadixSort};
use crate::threads::Threads;
use ccd_core::model::contact::{Contact, Kind};
use ccd_core::model::mesh::Mesh;

/// From this many contacts on, counting digits takes less time than comparing.
const FEWEST: usize = 1024;
/// Bits of a key that the radix sort takes.
const KEY_BITS: u32 = 63;

/// Buffers of the sort, kept between steps.
#[derive(Debug, Default)]
pub struct ContactOrder {
    radix: RadixSort,
    order: Vec<u32>,
    /// How many contacts the lists before each list have.
    first: Vec<usize>,
    found: Vec<Contact>,
    /// Milliseconds in which the last contacts were joined.
    #[cfg_attr(not(feature = "catalogue"), allow(dead_code, reason = "what reports alone ask"))]
    pub ms: f64,
}

impl ContactOrder {
    /// Puts contacts of `mesh` from all lists, of which no two are the same, into an empty one.
    pub fn join<L: Sync>(
        &mut self,
        threads: &Threads,
        mesh: &Mesh,
        lists: &[L],
        of: impl Fn(&L) -> &[Contact] + Sync,
        contacts: &mut Vec<Contact>,
    ) {
        let Self { radix, order, first, found, .. } = self;
        let mut n = 0;
        first.clear();
        for list in lists {
            first.push(n);
            n += of(list).len();
        }
        let any = |i: usize| {
            let list = first.partition_point(|&first| first <= i) - 1;
            of(&lists[list])[i - first[list]]
        };
        // Comparing takes no memory.
        if n < FEWEST || n > sort::MOST || threads.stop.is_limited() {
            contacts.extend((0..n).map(any));
            threads.sort(contacts, |c: &Contact| (c.kind, c.a, c.b));
            return;
        }
        let [v, e, f] = [mesh.n_vertices(), mesh.edges().len(), mesh.faces().len()];
        let key = key_of([v.max(e), e.max(f)]);
        found.clear();
        threads.append(found, n, any);
        radix.sort(threads, n, |i| key(&found[i]), order);
        threads.append(contacts, n, |i| found[order[i] as usize]);
    }
}

/// The key of a contact whose ids are less than these: its numbers side by side, the first in the
/// highest of [`KEY_BITS`].
fn key_of(limits: [usize; 2]) -> impl Fn(&Contact) -> u64 + Sync {
    let [of_a, of_b] = limits.map(|limit| usize::BITS - limit.leading_zeros());
    let unused = KEY_BITS - (1 + of_a + of_b);
    move |c| {
        let kind = (c.kind == Kind::EdgeEdge) as u64;
        ((kind << of_a | c.a as u64) << of_b | c.b as u64) << unused
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ccd_core::model::contact::State;

    /// Contacts in no order, with ids below a limit.
    fn contacts(n: usize, limit: u32) -> Vec<Contact> {
        let mut state = 1u32;
        let mut next = || {
            state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            (state >> 1) % limit
        };
        (0..n)
            .map(|i| {
                let kind = if next() % 2 == 0 { Kind::VertexFace } else { Kind::EdgeEdge };
                Contact::new(kind, State::Hit, next(), next(), i as f64)
            })
            .collect()
    }

    #[test]
    fn keys_are_in_the_order_of_contacts() {
        // The greatest limit is that of a mesh.
        for limit in [1 << 4, 1 << 14, i32::MAX as u32] {
            let key = key_of([limit as usize; 2]);
            let mut all = contacts(3000, limit);
            all.sort_unstable_by_key(|c| (c.kind, c.a, c.b));
            let keys: Vec<u64> = all.iter().map(key).collect();
            assert!(keys.is_sorted() && keys.iter().all(|&key| key < 1 << KEY_BITS));
            let same = |w: &[Contact]| (w[0].kind, w[0].a, w[0].b) == (w[1].kind, w[1].a, w[1].b);
            for (w, k) in all.windows(2).zip(keys.windows(2)) {
                assert_eq!(same(w), k[0] == k[1], "{w:?}");
            }
        }
    }

    #[test]
    fn many_contacts_are_sorted_as_few_are() {
        let n = 2000;
        let faces: Vec<[u32; 3]> = (0..n).map(|i| [i, i + 1, i + 2]).collect();
        let mesh = Mesh::new(n as usize + 2, &faces).unwrap();
        let mut order = ContactOrder::default();
        for n_threads in [1, 2] {
            let threads = Threads::new(n_threads).unwrap();
            for n in [0, 1, FEWEST - 1, FEWEST, 5000] {
                let mut got = contacts(n, 2000);
                got.sort_unstable_by_key(|c| (c.kind, c.b, c.a));
                got.dedup_by_key(|c| (c.kind, c.b, c.a));
                let mut want = got.clone();
                want.sort_unstable_by_key(|c| (c.kind, c.a, c.b));
                // Lists of many lengths, some empty.
                let ends = [0, got.len() / 3, got.len() / 3, got.len()];
                let lists: Vec<_> = ends.windows(2).map(|w| &got[w[0]..w[1]]).collect();
                let mut joined = Vec::new();
                order.join(&threads, &mesh, &lists, |list| list, &mut joined);
                assert_eq!(joined, want, "{n} contacts on {n_threads} threads");
            }
        }
    }
}
