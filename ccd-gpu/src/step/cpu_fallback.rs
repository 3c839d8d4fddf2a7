//! The end of a step on the CPU: every contact is taken from the list that the device wrote and
//! counted, with the earliest time of all; what the device left open is decided; and contacts get
//! their canonical order, where they do not have it.

use ccd_core::Real;
use ccd_core::backend::layout::{Pair, Touch};
use ccd_core::model::contact::{Contact, Kind, State};
use ccd_core::model::decision::Decider;
use ccd_core::model::mesh::Mesh;

/// Pairs that a thread takes at least: what a device leaves open are mostly ties, of which one
/// takes as long as to start a thread.
const MIN_SHARE: usize = 16;
/// Contacts that `f64` left open, of the same; some take tens of microseconds.
const MIN_OPEN: usize = 8;

/// Contacts that a thread takes at least as a device wrote them.
const MIN_TOUCHES: usize = 25_000;

/// Decides pairs on all cores and appends those that touch or stay undecided.
pub fn decide<T: Real>(
    mesh: &Mesh,
    kind: Kind,
    pairs: &[Pair],
    x: [&[[T; 3]]; 2],
    decider: &Decider,
    out: &mut Vec<Contact>,
) {
    let one = |&pair: &Pair| decider.contact(mesh, kind, pair, x);
    let share = pairs.len().div_ceil(cores()).max(MIN_SHARE);
    // Also where there is one thread, which can start no other: in a browser.
    if pairs.len() <= share {
        out.extend(pairs.iter().filter_map(one));
        return;
    }
    std::thread::scope(|scope| {
        let threads: Vec<_> = pairs
            .chunks(share)
            .map(|part| scope.spawn(move || part.iter().filter_map(one).collect::<Vec<_>>()))
            .collect();
        for thread in threads {
            match thread.join() {
                Ok(found) => out.extend(found),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
    });
}

/// Decides again, in place, the `n_open` contacts that a device left undecided, at least one, and
/// drops what is no contact.
pub fn settle<T: Real>(
    mesh: &Mesh,
    x: [&[[T; 3]]; 2],
    decider: &Decider,
    n_open: usize,
    contacts: &mut Vec<Contact>,
) {
    // NaN: none; no contact has such a time.
    let settle = |part: &mut [Contact]| {
        for contact in part.iter_mut().filter(|contact| contact.state == State::Undecided) {
            let pair = Pair { a: contact.a, b: contact.b };
            match decider.contact(mesh, contact.kind, pair, x) {
                Some(decided) => *contact = decided,
                None => contact.toi = f64::NAN,
            }
        }
    };
    let share = contacts.len().div_ceil(n_open.div_ceil(MIN_OPEN).min(cores()));
    std::thread::scope(|scope| {
        let mut parts = contacts.chunks_mut(share);
        let own = parts.next();
        for part in parts {
            scope.spawn(move || settle(part));
        }
        own.map(settle)
    });
    contacts.retain(|contact| !contact.toi.is_nan());
}

fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, |n| n.get())
}

/// The contacts of a list as a device wrote them, without its header, in the memory of others: what
/// stands there is overwritten, by several threads, and nothing is written twice.
pub fn take_touches(bytes: &[u8], spare: &mut Vec<Contact>) -> Vec<Contact> {
    const NONE: Contact = Contact::new(Kind::VertexFace, State::Hit, 0, 0, 0.0);
    let mut out = std::mem::take(spare);
    out.resize(bytes.len() / size_of::<Touch>(), NONE);
    let take = |(out, bytes): (&mut [Contact], &[u8])| {
        for (contact, touch) in out.iter_mut().zip(bytes.chunks_exact(size_of::<Touch>())) {
            *contact = Contact::from(&bytemuck::pod_read_unaligned::<Touch>(touch));
        }
    };
    let share = out.len().div_ceil(cores()).max(MIN_TOUCHES);
    std::thread::scope(|scope| {
        let mut parts = out.chunks_mut(share).zip(bytes.chunks(share * size_of::<Touch>()));
        let own = parts.next();
        for part in parts {
            scope.spawn(move || take(part));
        }
        own.map(take)
    });
    out
}

/// Contacts that a thread looks through in the time that it takes to start it.
const MANY: usize = 100_000;

/// The earliest time of all contacts, and how many are undecided.
pub fn summary(contacts: &[Contact]) -> (Option<f64>, u64) {
    let share = contacts.len().div_ceil(cores()).max(MANY);
    let found = std::thread::scope(|scope| {
        let mut parts = contacts.chunks(share);
        let own = parts.next();
        let others: Vec<_> = parts.map(|part| scope.spawn(move || summary_of(part))).collect();
        let joined = |other: std::thread::ScopedJoinHandle<_>| {
            other.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
        };
        own.map(summary_of).into_iter().chain(others.into_iter().map(joined)).reduce(
            |(toi, undecided): (f64, u64), other: (f64, u64)| {
                (toi.min(other.0), undecided + other.1)
            },
        )
    });
    (found.map(|found| found.0), found.map_or(0, |found| found.1))
}

/// The same of some. In one pass, and by several minima at once, because each of a chain of minima
/// waits for the one before.
fn summary_of(contacts: &[Contact]) -> (f64, u64) {
    let (mut least, mut undecided) = ([f64::INFINITY; 8], 0);
    for some in contacts.chunks(least.len()) {
        for (least, contact) in least.iter_mut().zip(some) {
            *least = least.min(contact.toi);
            undecided += (contact.state == State::Undecided) as u64;
        }
    }
    (least.into_iter().fold(f64::INFINITY, f64::min), undecided)
}

/// Puts contacts in their canonical order.
pub fn sort(contacts: &mut [Contact]) {
    contacts.sort_unstable_by_key(|c| (c.kind, c.a, c.b));
}
