//! Lists of contacts in order become one, on several threads: each takes what is between two keys.

use super::threads::{at_once, contacts_a_thread};
use crate::{Contact, Kind, State};

/// Stands where contacts are still to be written.
pub const NO_CONTACT: Contact = Contact::new(Kind::VertexFace, State::Hit, 0, 0, 0.0);

fn key(c: &Contact) -> (Kind, u32, u32) {
    (c.kind, c.a, c.b)
}

/// Joins lists, each contact once, with the least of its times; `out` keeps its length where it
/// can, so that nothing is written twice. Returns how many are undecided.
pub fn merge(lists: &[&[Contact]], out: &mut Vec<Contact>) -> u64 {
    let Some(longest) = lists.iter().max_by_key(|list| list.len()) else { return 0 };
    let share = contacts_a_thread(longest.len());
    let first_keys = longest.iter().step_by(share).skip(1).map(key);
    let mut rest = lists.to_vec();
    let mut parts: Vec<Vec<&[Contact]>> = Vec::new();
    for least in first_keys {
        let cut = |list: &mut &'_ [Contact]| list.partition_point(|c| key(c) < least);
        let cuts: Vec<usize> = rest.iter_mut().map(cut).collect();
        parts.push(
            rest.iter_mut().zip(cuts).map(|(list, n)| list.split_off(..n).unwrap_or(&[])).collect(),
        );
    }
    parts.push(rest);
    let counts = at_once(parts.iter(), |lists| {
        let (mut n, mut undecided) = (0, 0);
        each_run(lists, |run| {
            n += run.len();
            undecided += run.iter().filter(|c| c.state == State::Undecided).count() as u64;
        });
        (n, undecided)
    });
    out.resize(counts.iter().map(|of| of.0).sum(), NO_CONTACT);
    let mut to = &mut out[..];
    let slices = counts.iter().map(|of| to.split_off_mut(..of.0).unwrap_or(&mut []));
    at_once(parts.iter().zip(slices), |(lists, to)| {
        let mut at = 0;
        each_run(lists, |run| {
            to[at..at + run.len()].copy_from_slice(run);
            at += run.len();
        });
    });
    counts.iter().map(|of| of.1).sum()
}

/// Calls `take` with one run of contacts after the other, in order, each contact once.
fn each_run<'a>(lists: &[&'a [Contact]], mut take: impl FnMut(&'a [Contact])) {
    let mut lists: Vec<&[Contact]> = lists.iter().copied().filter(|l| !l.is_empty()).collect();
    lists.sort_by_key(|list| key(&list[0]));
    while let [first, others @ ..] = &mut lists[..] {
        let Some(least) = others.first().map(|list| key(&list[0])) else { return take(first) };
        let n = first.iter().take_while(|c| key(c) < least).count();
        if n == 0 {
            // Both have the same one; the one with the later time is left out.
            let second = &mut others[0];
            let later = if second[0].toi < first[0].toi { first } else { second };
            *later = &later[1..];
        } else if let Some(run) = first.split_off(..n) {
            take(run);
        }
        lists.retain(|list| !list.is_empty());
        lists.sort_by_key(|list| key(&list[0]));
    }
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
        assert!(contacts_a_thread(lists[0].len()) < lists[0].len());
        let mut out = Vec::new();
        let n_undecided = merge(&lists.each_ref().map(|list| &list[..]), &mut out);
        assert!(out == want);
        assert_eq!(n_undecided, want.iter().filter(|c| c.state == State::Undecided).count() as u64);
    }
}
