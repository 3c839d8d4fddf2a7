//! The end of a step on the CPU: every contact is taken from the list that the device wrote and
//! counted, with the earliest time of all; what the device left open is decided; and contacts get
//! their canonical order, where they do not have it.

use crate::threads;
use bytemuck::Pod;
use ccd_core::Real;
use ccd_core::backend::layout::{Pair, Touch};
use ccd_core::model::contact::{Contact, Kind, PerKind, State};
use ccd_core::model::decision::Decider;
use ccd_core::model::mesh::Mesh;

/// Contacts of a device's list that are worth another thread.
const TOUCHES: usize = 2048;
/// Exact times that are: each takes a third of a microsecond.
const TIMES: usize = 512;
/// Where only the earliest time is wanted, so many pairs are decided at once: the others may all be
/// later than a contact among these.
const ROUNDS: [usize; 3] = [8, 64, usize::MAX];

/// What contacts say together.
#[derive(Clone, Debug)]
pub struct Summary {
    /// The earliest time of those that are certain; infinity of none.
    pub toi: f64,
    /// Places of those that are undecided.
    pub undecided: Vec<u32>,
}

impl Default for Summary {
    fn default() -> Self {
        Self { toi: f64::INFINITY, undecided: Vec::new() }
    }
}

impl Summary {
    /// Adds those of contacts that come after these.
    fn join(&mut self, mut other: Self) {
        self.toi = self.toi.min(other.toi);
        self.undecided.append(&mut other.undecided);
    }

    /// Adds contacts, of which the first has this place.
    fn add(&mut self, first: usize, contacts: &[Contact]) {
        for (contact, at) in contacts.iter().zip(first..) {
            match contact.state {
                State::Undecided => self.undecided.push(at as u32),
                _ => self.toi = self.toi.min(contact.toi),
            }
        }
    }
}

/// The first `n` contacts as a device wrote them, in records of which `touch` makes one, without a
/// header. In the memory of others: what stands there is overwritten, and nothing is written twice.
pub fn take_touches<R: Pod>(
    bytes: &[u8],
    n: usize,
    touch: impl Fn(R) -> Touch + Sync,
    spare: &mut Vec<Contact>,
) -> (Vec<Contact>, Summary) {
    const NONE: Contact = Contact::new(Kind::VertexFace, State::Hit, 0, 0, 0.0);
    let mut out = std::mem::take(spare);
    out.resize(n, NONE);
    let share = threads::share(n).max(TOUCHES);
    let mut summaries = vec![Summary::default(); out.len().div_ceil(share)];
    let parts = out.chunks_mut(share).zip(bytes.chunks(share * size_of::<R>()));
    threads::copy(parts.zip(&mut summaries).enumerate(), |(part, ((out, bytes), summary))| {
        // Several minima, because each of a chain of them waits for the one before.
        let (mut least, mut any_open) = ([f64::INFINITY; 4], false);
        let records = bytes.chunks_exact(size_of::<R>());
        for (i, (contact, record)) in out.iter_mut().zip(records).enumerate() {
            *contact = Contact::from(&touch(bytemuck::pod_read_unaligned(record)));
            let (is_open, least) = (contact.state == State::Undecided, &mut least[i % 4]);
            *least = if !is_open && contact.toi < *least { contact.toi } else { *least };
            any_open |= is_open;
        }
        if any_open {
            summary.add(part * share, out);
        }
        summary.toi = least.into_iter().fold(summary.toi, f64::min);
    });
    let all = summaries.into_iter().reduce(|mut all, part| {
        all.join(part);
        all
    });
    (out, all.unwrap_or_default())
}

/// Contacts with what they say together.
pub type Listed<'a> = (&'a mut Vec<Contact>, &'a mut Summary);

/// What decides pairs on the host.
pub struct Host<'a, T> {
    pub mesh: &'a Mesh,
    /// Positions as they were given.
    pub x: [&'a [[T; 3]]; 2],
    pub decider: &'a Decider,
}

impl<T: Real> Host<'_, T> {
    /// Finds exact times, if they are wanted, and decides what a device left open, if it `is_left`
    /// to the host. Returns how many pairs that decided.
    ///
    /// `earliest`: if only the earliest time is wanted, that of contacts which are not in the list,
    /// or infinity. Where the host decides, the list is empty afterwards.
    pub fn finish(
        &self,
        is_left: bool,
        earliest: Option<f64>,
        (contacts, summary): Listed,
    ) -> PerKind {
        if self.decider.has_exact_times() {
            self.time((contacts, summary));
        }
        match earliest {
            _ if !is_left => PerKind::default(),
            None => self.settle((contacts, summary)),
            Some(latest) => self.settle_earliest(latest, (contacts, summary)),
        }
    }

    /// Puts exact times into contacts of which a device is certain. Those whose time `f64` does not
    /// find are undecided again.
    fn time(&self, (contacts, summary): Listed) {
        let share = threads::share(contacts.len()).max(TIMES);
        threads::each(contacts.chunks_mut(share), |contacts| {
            for contact in contacts {
                if contact.state == State::Hit {
                    match self.decider.with_exact_time(self.mesh, contact, self.x) {
                        Some(timed) => *contact = timed,
                        None => contact.state = State::Undecided,
                    }
                }
            }
        });
        *summary = Summary::default();
        summary.add(0, contacts);
    }

    /// Decides, of what a device left undecided, what may be the earliest contact: the time of an
    /// undecided one is a lower bound.
    fn settle_earliest(&self, latest: f64, (contacts, summary): Listed) -> PerKind {
        let open = summary.undecided.iter().map(|&at| contacts[at as usize]);
        let mut open: Vec<Contact> = open.collect();
        open.sort_unstable_by(|a, b| a.toi.total_cmp(&b.toi));
        let (mut toi, mut rest, mut n) = (summary.toi, &open[..], PerKind::default());
        for most in ROUNDS {
            let before = rest.partition_point(|contact| contact.toi < toi.min(latest));
            let (now, later) = rest.split_at(before.min(most));
            contacts.clear();
            contacts.extend_from_slice(now);
            *summary = Summary::default();
            summary.add(0, contacts);
            n = n.plus(self.settle((contacts, summary)));
            toi = contacts.iter().map(|contact| contact.toi).fold(toi, f64::min);
            rest = later;
        }
        contacts.clear();
        *summary = Summary { toi, ..Summary::default() };
        n
    }

    /// Decides again, in place, the contacts that a device left undecided, and drops those that are
    /// none. Returns how many there were.
    fn settle(&self, (contacts, summary): Listed) -> PerKind {
        let open = std::mem::take(&mut summary.undecided);
        let share = threads::share(open.len());
        let none = (Summary::default(), Vec::new(), PerKind::default());
        let mut settled = vec![none; open.len().div_ceil(share)];
        let (mut parts, mut rest, mut first) = (Vec::new(), &mut contacts[..], 0);
        for (open, settled) in open.chunks(share).zip(&mut settled) {
            // They ascend, so that each part has contacts of its own.
            let end = open.last().map_or(first, |&last| last as usize + 1);
            let (part, after) = rest.split_at_mut(end - first);
            parts.push((open, part, first, settled));
            (rest, first) = (after, end);
        }
        threads::each(parts.into_iter(), |(open, contacts, first, (summary, dropped, n))| {
            for at in open.iter().map(|&at| at as usize) {
                let contact = &mut contacts[at - first];
                match contact.kind {
                    Kind::VertexFace => n.vf += 1,
                    _ => n.ee += 1,
                }
                let pair = Pair { a: contact.a, b: contact.b };
                match self.decider.contact(self.mesh, contact.kind, pair, self.x) {
                    Some(settled) => {
                        *contact = settled;
                        summary.add(at, &[settled]);
                    }
                    None => dropped.push(at),
                }
            }
        });
        let (vf, ee) = settled.iter().fold((0, 0), |(vf, ee), (.., n)| (vf + n.vf, ee + n.ee));
        let n_open = PerKind::new(vf, ee);
        let mut dropped = settled.iter().flat_map(|(_, dropped, _)| dropped).copied().peekable();
        if dropped.peek().is_none() {
            settled.into_iter().for_each(|(part, ..)| summary.join(part));
            return n_open;
        }
        let mut at = 0;
        contacts.retain(|_| {
            let is_dropped = dropped.next_if_eq(&at).is_some();
            at += 1;
            !is_dropped
        });
        *summary = Summary::default();
        summary.add(0, contacts);
        n_open
    }
}

/// Puts contacts in their canonical order; it takes less if most are.
pub fn sort(contacts: &mut [Contact]) {
    contacts.sort_by_key(|c| (c.kind, c.a, c.b));
}

#[cfg(test)]
mod tests {
    use super::*;
    use ccd_core::model::options::{Mode, Options};

    /// Vertices above a face each: every third stays there, the others fall through. Of every
    /// second the device is certain, right or wrong.
    #[test]
    fn what_is_undecided_is_decided_in_its_place_or_dropped() {
        for (n, stays) in [(1, 3), (2, 1), (50, 3), (1000, 3), (1000, 1000), (1000, 1)] {
            let faces: Vec<[u32; 3]> = (0..n).map(|i| [4 * i, 4 * i + 1, 4 * i + 2]).collect();
            let mesh = Mesh::new(4 * n as usize, &faces).expect("a mesh");
            let group = |i: u32, end: f64| {
                let y = if i.is_multiple_of(stays) { 1.0 } else { 1.0 - 2.0 * end };
                [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.2, y, 0.2]]
            };
            let x = [0.0, 1.0].map(|end| (0..n).flat_map(|i| group(i, end)).collect::<Vec<_>>());
            let state = |i| if i % 2 == 0 { State::Undecided } else { State::Hit };
            let of = |i: u32, state, toi| Contact::new(Kind::VertexFace, state, 4 * i + 3, i, toi);
            let mut contacts: Vec<Contact> = (0..n).map(|i| of(i, state(i), 0.25)).collect();
            let mut summary = Summary::default();
            summary.add(0, &contacts);

            let decider =
                &Decider::new(&Options::default().with_mode(Mode::Conservative), [0.0, 1.0]);
            let x = x.each_ref().map(|x| &x[..]);
            let n_open = Host { mesh: &mesh, x, decider }.settle((&mut contacts, &mut summary));
            assert_eq!(n_open, PerKind::new(n.div_ceil(2) as u64, 0));
            let is_left = |&i: &u32| i % 2 == 1 || !i.is_multiple_of(stays);
            let ids: Vec<u32> = contacts.iter().map(|contact| contact.b).collect();
            assert_eq!(ids, (0..n).filter(is_left).collect::<Vec<u32>>(), "{n}, {stays}");
            assert!(contacts.iter().all(|contact| contact.state == State::Hit));
            let decided = contacts.iter().filter(|contact| contact.b % 2 == 0);
            assert!(decided.into_iter().all(|contact| contact.toi > 0.49 && contact.toi <= 0.5));
            let toi = contacts.iter().map(|contact| contact.toi).fold(f64::INFINITY, f64::min);
            assert_eq!((summary.toi, summary.undecided), (toi, Vec::new()));
        }
    }

    /// Vertices above a face each, which fall through it at `1 / fall`, or stay. The device is
    /// certain of none; its bounds are nine tenths of these times, or 0.
    #[test]
    fn the_earliest_contact_needs_few_decisions() {
        let n = 1000;
        let fall = |i: u32| (i % 50) as f64;
        let faces: Vec<[u32; 3]> = (0..n).map(|i| [4 * i, 4 * i + 1, 4 * i + 2]).collect();
        let mesh = Mesh::new(4 * n as usize, &faces).expect("a mesh");
        let group = |y: f64| [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.2, y, 0.2]];
        let x = [0.0, 1.0].map(|end| (0..n).flat_map(|i| group(1.0 - end * fall(i))).collect());
        let x: [Vec<[f64; 3]>; 2] = x;
        let open = |i: u32| {
            let toi = if fall(i) > 0.0 { 0.9 / fall(i) } else { 0.0 };
            Contact::new(Kind::VertexFace, State::Undecided, 4 * i + 3, i, toi)
        };
        let options = Options::default().with_mode(Mode::Conservative);
        let decider = &Decider::new(&options, [0.0, 1.0]);
        let host = Host { mesh: &mesh, x: x.each_ref().map(|x| &x[..]), decider };
        let given = || {
            let contacts: Vec<Contact> = (0..n).map(open).collect();
            let mut summary = Summary::default();
            summary.add(0, &contacts);
            (contacts, summary)
        };
        let (mut contacts, mut of_all) = given();
        assert_eq!(host.settle((&mut contacts, &mut of_all)).total(), 1000);
        assert!((0.02..0.0205).contains(&(of_all.toi + 1e-6)), "{}", of_all.toi);
        // Of 20 each that stay, or whose bound is before the earliest contact; or before another.
        for (latest, counts, want) in
            [(f64::INFINITY, 0..=120, of_all.toi), (0.015, 20..=20, f64::INFINITY)]
        {
            let (mut contacts, mut summary) = given();
            let decided = host.settle_earliest(latest, (&mut contacts, &mut summary)).total();
            assert!(counts.contains(&decided), "{latest}: {decided}");
            assert_eq!((summary.toi, contacts.len(), summary.undecided.len()), (want, 0, 0));
        }
    }
}
