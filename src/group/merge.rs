//! Lists of contacts in order become one, on several threads: each takes what is between two keys.

use super::threads::Threads;
use crate::{Contact, Kind, State};
use std::cmp::Ordering;

/// Stands where contacts are still to be written.
const NO_CONTACT: Contact = Contact::new(Kind::VertexFace, State::Hit, 0, 0, 0.0);
/// Contacts of one list that are worth a thread.
const SHARE: usize = 1 << 12;

/// What is left of a list, with its number.
type Rest<'a> = (usize, &'a [Contact]);

/// Joins lists, each contact once, with the least of its times. `ids`: those of a contact of this
/// list that all lists share, by which they are in order, too. `out` keeps its length where it can,
/// so that nothing is written twice. Returns how many are undecided.
pub fn merge(
    threads: &Threads,
    lists: &[&[Contact]],
    ids: impl Fn(usize, &Contact) -> [u32; 2] + Sync,
    out: &mut Vec<Contact>,
) -> u64 {
    let order = |(i, c): (usize, &Contact), (j, d): (usize, &Contact)| {
        c.kind.cmp(&d.kind).then_with(|| ids(i, c).cmp(&ids(j, d)))
    };
    let mut rest: Vec<Rest> = lists.iter().copied().enumerate().collect();
    let Some(&(longest, by)) = rest.iter().max_by_key(|(_, list)| list.len()) else { return 0 };
    let mut parts: Vec<Vec<Rest>> = Vec::new();
    for least in by.iter().step_by(SHARE).skip(1) {
        let mut below = Vec::new();
        for (of, list) in &mut rest {
            let n = list.partition_point(|c| order((*of, c), (longest, least)).is_lt());
            below.push((*of, list.split_off(..n).unwrap_or(&[])));
        }
        parts.push(below);
    }
    parts.push(rest);
    let lengths = threads.at_once(parts.iter(), |lists| {
        let mut n = 0;
        each_run(lists, order, |_, run| n += run.len());
        n
    });
    out.resize(lengths.iter().sum(), NO_CONTACT);
    let mut to = &mut out[..];
    let slices = lengths.iter().map(|&n| to.split_off_mut(..n).unwrap_or(&mut []));
    let undecided = threads.at_once(parts.iter().zip(slices), |(lists, mut to)| {
        let mut undecided = 0;
        each_run(lists, order, |of, run| {
            let to = to.split_off_mut(..run.len()).unwrap_or(&mut []);
            for (to, c) in to.iter_mut().zip(run) {
                let [a, b] = ids(of, c);
                *to = Contact::new(c.kind, c.state, a, b, c.toi).with_approach(c.approach);
                undecided += (c.state == State::Undecided) as u64;
            }
        });
        undecided
    });
    undecided.into_iter().sum()
}

/// Calls `take` with one run of contacts of a list after the other, in order, each contact once.
fn each_run<'a>(
    lists: &[Rest<'a>],
    order: impl Fn((usize, &Contact), (usize, &Contact)) -> Ordering,
    mut take: impl FnMut(usize, &'a [Contact]),
) {
    let by_first = |&(i, c): &Rest, &(j, d): &Rest| order((i, &c[0]), (j, &d[0]));
    let mut lists: Vec<Rest> = lists.iter().copied().filter(|(_, l)| !l.is_empty()).collect();
    lists.sort_by(by_first);
    while let [(of, first), others @ ..] = &mut lists[..] {
        let Some((j, second)) = others.first_mut() else { return take(*of, first) };
        let n = first_that(first, |c| order((*of, c), (*j, &second[0])).is_ge());
        let mut changed = 0;
        if n > 0 {
            take(*of, first.split_off(..n).unwrap_or(&[]));
        } else if second[0].toi < first[0].toi {
            // Both have the same one; the one with the later time is left out.
            *first = &first[1..];
        } else {
            *second = &second[1..];
            changed = 1;
        }
        to_its_place(&mut lists, changed, by_first);
    }
}

/// Moves a list back whose first contact is another than it was; one without contacts leaves.
fn to_its_place(lists: &mut Vec<Rest>, mut at: usize, order: impl Fn(&Rest, &Rest) -> Ordering) {
    if lists[at].1.is_empty() {
        lists.remove(at);
        return;
    }
    while at + 1 < lists.len() && order(&lists[at], &lists[at + 1]).is_gt() {
        lists.swap(at, at + 1);
        at += 1;
    }
}

/// Index of the first contact for which `holds`, or the length; it holds for all after that one.
/// Galloping search: fast where the index is small.
fn first_that(list: &[Contact], holds: impl Fn(&Contact) -> bool) -> usize {
    let mut until = 1;
    while until < list.len() && !holds(&list[until - 1]) {
        until *= 2;
    }
    let from = until / 2;
    from + list[from..until.min(list.len())].partition_point(|c| !holds(c))
}

#[cfg(all(test, feature = "scenes"))]
mod tests {
    use super::*;
    use crate::scenes::Random;

    /// So many that several threads take a share each; one in two stands in two lists or more, with
    /// another time in each, of which the least counts.
    #[test]
    fn lists_become_one_list_in_order() {
        let mut random = Random::new(4);
        let contact = |i: u32, toi: f64| {
            let state = if i.is_multiple_of(7) { State::Undecided } else { State::Hit };
            Contact::new(Kind::ALL[i as usize / 200_000], state, i / 3, i % 3, toi)
        };
        let mut lists = [(); 3].map(|()| Vec::new());
        let mut want = Vec::new();
        for i in 0..500_000 {
            let of = random.below(8);
            let times = [(); 3].map(|()| random.below(4) as f64 / 8.0);
            let of = (0..3).filter(|k| of >> k & 1 == 1);
            of.clone().for_each(|k| lists[k].push(contact(i, times[k])));
            want.extend(of.map(|k| times[k]).reduce(f64::min).map(|toi| contact(i, toi)));
        }
        assert!(SHARE < lists[0].len());
        // Ids of list `k` are `k` more than those that lists share.
        for (k, list) in lists.iter_mut().enumerate() {
            list.iter_mut().for_each(|c: &mut Contact| c.a += k as u32);
        }
        let ids = |k: usize, c: &Contact| [c.a - k as u32, c.b];
        let (mut out, lists) = (Vec::new(), lists.each_ref().map(|list| &list[..]));
        let n_undecided = merge(&Threads::new(), &lists, ids, &mut out);
        assert!(out == want);
        assert_eq!(n_undecided, want.iter().filter(|c| c.state == State::Undecided).count() as u64);
    }
}
