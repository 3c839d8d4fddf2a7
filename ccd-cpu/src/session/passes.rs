//! A pass over all candidates, or over a part of them, and what becomes of the workers' results.

use crate::broad_phase::method::Method;
use crate::clock::{Instant, milliseconds};
use crate::step::candidates::Scene;
use crate::step::contact_order::ContactOrder;
use crate::step::find::find;
use crate::step::narrow_phase::{CONTACTS, Worker, decide_open};
use crate::step::positions::Positions;
use crate::step::prepare::Prepared;
use crate::step::selection::Selection;
use crate::threads::Threads;
use ccd_core::Error;
use ccd_core::model::contact::{Contact, PerKind, State};
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use ccd_core::model::report::{Report, TriangleCounts};
use std::time::Duration;

/// The first contact that any worker found.
pub fn first_contact(workers: &[Worker]) -> Option<Contact> {
    workers.iter().filter_map(|worker| worker.first).min_by(Contact::by_time)
}

/// Up to when boxes are swept for contacts whose time is at most `toi`. A time may be early by the
/// tolerance (not in exact mode): by the end of it the features of such a pair touch.
pub fn swept_until(toi: f64, options: &Options) -> f64 {
    (toi + options.tolerance).next_up().min(1.0)
}

/// Boxes and trees of a step up to the time that matters.
///
/// # Errors
/// Those of the positions and of the method, and of [`Stop::check`](crate::stop::Stop::check).
pub fn prepare(
    threads: &Threads,
    prepared: &mut Prepared,
    method: &mut Method,
    mesh: &Mesh,
    (options, selection): (&Options, &Selection),
    x: &Positions,
    report: &mut Report,
) -> Result<(), Error> {
    let start = Instant::now();
    if !x.again {
        prepared.rigid(threads, mesh, selection.rules.as_ref(), method, x);
    }
    prepared.boxes(threads, options, x)?;
    report.times.boxes += milliseconds(start);
    threads.stop.check()?;
    let start = Instant::now();
    let rebuilt = prepared.leaves(threads, method, (mesh, options), selection.rules.as_ref(), x)?;
    report.rebuilt = rebuilt || (report.rebuilt && x.again);
    report.times.build += milliseconds(start);
    threads.stop.check()
}

/// Boxes at both ends, see [`Prepared::ends`], as a part of the time that trees take.
pub fn ends(
    threads: &Threads,
    prepared: &mut Prepared,
    method: &mut Method,
    options: &Options,
    x: &Positions,
    report: &mut Report,
) {
    let start = Instant::now();
    prepared.ends(threads, method, options, x);
    report.times.build += milliseconds(start);
}

/// Finds and decides all candidates, or those of every `part`-th task.
pub fn detect(
    threads: &Threads,
    method: &mut Method,
    prepared: &Prepared,
    scene: &Scene,
    part: usize,
    workers: &mut [Worker],
    report: &mut Report,
) {
    let start = Instant::now();
    let narrow = |workers: &[Worker]| workers.iter().map(|w| w.narrow).sum::<Duration>();
    let before = narrow(workers);
    // If a sample came before, the last pass counts.
    workers.iter_mut().for_each(Worker::restart_counts);
    find(None, threads, method, prepared, scene, part, workers);
    decide_open(threads, scene, workers);
    count(workers, report, prepared.triangles.is_some());
    let narrow = (narrow(workers) - before).as_secs_f64() * 1e3 / threads.count() as f64;
    report.times.narrow += narrow;
    report.times.traverse += (milliseconds(start) - narrow).max(0.0);
}

/// Adds up what the workers counted.
fn count(workers: &[Worker], report: &mut Report, triangles: bool) {
    let (mut candidates, mut filtered) = (PerKind::default(), PerKind::default());
    let mut counts = TriangleCounts::default();
    for worker in workers {
        candidates = candidates.plus(worker.candidates);
        filtered = filtered.plus(worker.filtered);
        counts = counts.plus(worker.triangles);
    }
    (report.candidates, report.filtered) = (candidates, filtered);
    report.triangles = triangles.then_some(counts);
}

/// Joins the workers' contacts in their order.
///
/// # Errors
/// Those of [`Stop::check`](crate::stop::Stop::check).
pub fn collect(
    threads: &Threads,
    mesh: &Mesh,
    workers: &mut [Worker],
    order: &mut ContactOrder,
    report: &mut Report,
) -> Result<(), Error> {
    let (start, stop) = (Instant::now(), &threads.stop);
    let total: usize = workers.iter().map(|w| w.contacts.len()).sum();
    if !stop.reserve(CONTACTS, &mut report.contacts, total) {
        return stop.check();
    }
    order.join(threads, mesh, workers, |worker| &worker.contacts, &mut report.contacts);
    for worker in workers.iter_mut() {
        // Any worker may find all of them next time.
        worker.contacts.clear();
        if !stop.is_limited() {
            worker.contacts.reserve(total + total / 8);
        }
    }
    order.ms = milliseconds(start);
    report.begin_with(first_contact(workers));
    report.undecided = workers.iter().map(|worker| worker.undecided).sum();
    report.times.narrow += order.ms;
    Ok(())
}

/// Keeps one of equal contacts, which are sorted: tests that were made more than once.
pub fn drop_repeated(report: &mut Report) {
    report.contacts.dedup_by_key(|c| (c.kind, c.a, c.b));
    report.undecided =
        report.contacts.iter().filter(|c| c.state == State::Undecided).count() as u64;
}
