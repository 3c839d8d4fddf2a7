//! The end of a step on the CPU: every contact is taken from the list that the device wrote and
//! counted, with the earliest time of all; what the device left open is decided; and contacts get
//! their canonical order, where they do not have it.

use crate::threads;
use bytemuck::Pod;
use ccd_core::Real;
use ccd_core::backend::layout::{Pair, Touch};
use ccd_core::model::contact::{Contact, Kind, State};
use ccd_core::model::decision::Decider;
use ccd_core::model::mesh::Mesh;

/// Contacts of a device's list that are worth another thread.
const TOUCHES: usize = 2048;
/// Exact times that are: each takes a third of a microsecond.
const TIMES: usize = 512;

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
    let all = summaries.into_iter().reduce(|mut all, mut part| {
        all.toi = all.toi.min(part.toi);
        all.undecided.append(&mut part.undecided);
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
    /// Finds exact times, if they are wanted, and decides what a device left open: contacts that it
    /// wrote as undecided, unless there is a minimum distance, and pairs of both kinds.
    pub fn finish(&self, min_distance: f64, open: &[Vec<Pair>; 2], (contacts, summary): Listed) {
        if self.decider.has_exact_times() {
            self.time((contacts, summary));
        }
        if min_distance == 0.0 {
            self.settle((contacts, summary));
        }
        for (kind, pairs) in [Kind::VertexFace, Kind::EdgeEdge].into_iter().zip(open) {
            self.decide(kind, pairs, (contacts, summary));
        }
    }

    fn contact(&self, kind: Kind, pair: Pair) -> Option<Contact> {
        self.decider.contact(self.mesh, kind, pair, self.x)
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

    /// Decides again, in place, the contacts that a device left undecided, and drops those that are
    /// none.
    fn settle(&self, (contacts, summary): Listed) {
        let open = std::mem::take(&mut summary.undecided);
        let mut settled = vec![None; open.len()];
        let share = threads::share(open.len());
        let parts = open.chunks(share).zip(settled.chunks_mut(share));
        threads::each(parts, |(open, settled)| {
            for (&at, settled) in open.iter().zip(settled) {
                let Contact { kind, a, b, .. } = contacts[at as usize];
                *settled = self.contact(kind, Pair { a, b });
            }
        });
        // In order, so that what is kept moves to a place that is free already.
        let (mut kept, mut next) = (0, 0);
        for (at, settled) in open.into_iter().map(|at| at as usize).zip(settled) {
            contacts.copy_within(next..at, kept);
            (kept, next) = (kept + at - next, at + 1);
            if let Some(contact) = settled {
                summary.add(kept, &[contact]);
                contacts[kept] = contact;
                kept += 1;
            }
        }
        contacts.copy_within(next.., kept);
        contacts.truncate(kept + contacts.len() - next);
    }

    /// Decides pairs and appends those that touch or stay undecided.
    fn decide(&self, kind: Kind, pairs: &[Pair], (contacts, summary): Listed) {
        let before = contacts.len();
        let share = threads::share(pairs.len());
        let mut parts = vec![Vec::new(); pairs.len().div_ceil(share)];
        threads::each(pairs.chunks(share).zip(&mut parts), |(pairs, found)| {
            found.extend(pairs.iter().filter_map(|&pair| self.contact(kind, pair)));
        });
        parts.iter().for_each(|found| contacts.extend_from_slice(found));
        summary.add(before, &contacts[before..]);
    }
}

/// Puts contacts in their canonical order; it takes less if most are.
pub fn sort(contacts: &mut [Contact]) {
    contacts.sort_by_key(|c| (c.kind, c.a, c.b));
}
