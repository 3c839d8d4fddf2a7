//! Frames of a session on its device: one submission each, what is read with it, lists that grow
//! when they were too short.

use super::buffers::Buffers;
use super::contact_geometry::Geometry;
use super::contact_order::{self, ContactOrder};
use super::kept_order::KeptOrder;
use super::triangle_pairs::{COUNT_BYTES, TrianglePairs, read_counts};
use super::{Goal, SAMPLE, WHOLE, cpu_fallback};
use crate::broad_phase::worker_counts::{self, WorkerCounts};
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::{HEADER_BYTES, Header, List, read_header, read_pairs, until_complete};
use crate::readback::{Part, Plan, Readback, word};
use crate::recorder::{Bench, submit};
use ccd_core::backend::layout::{Pair, Touch};
use ccd_core::model::cancel::CancelToken;
use ccd_core::model::contact::{Contact, PerKind};
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use ccd_core::model::precision::Given;
use ccd_core::model::report::TriangleCounts;
use ccd_core::model::session::Moved;

mod changes;

/// Buffers of all frames, and what one learns from the frame before.
pub struct Frames {
    pub buffers: Buffers,
    pub bench: Bench,
    readback: Readback,
    /// Milliseconds on the device in the last frame.
    pub stages: Vec<(&'static str, f64)>,
    /// How often a list was too short, so that a frame ran again.
    pub grown: u32,
    /// Contacts that the device found in the last step: about as many are read with the results of
    /// the next.
    expected: u32,
    /// Whether edges and faces on the device may be those of a mesh that was not taken.
    stale: bool,
    /// Calls for which the earliest time is looked for at once, because a sample did not pay the
    /// last time.
    at_once: u32,
    order: KeptOrder,
    /// Of the contacts on the device.
    pub geometry: Geometry,
    /// Ends frames before they are submitted.
    pub cancel: Option<CancelToken>,
    /// Bytes of the last bodies that were set, if there is a limit of memory.
    of_bodies: u64,
}

/// Results of a frame.
#[derive(Clone, Debug, Default)]
pub struct Found {
    pub earliest: u32,
    /// Candidates of the sample.
    pub sampled: u64,
    /// Whether boxes were sorted, rather than kept in the order of the frame before.
    pub sorted: bool,
    pub candidates: PerKind,
    pub filtered: PerKind,
    /// If pairs of triangles were looked for.
    pub triangles: Option<TriangleCounts>,
    pub open: [Vec<Pair>; 2],
    /// Whether contacts are in their order already.
    pub in_order: bool,
}

impl Frames {
    pub fn new(device: &Device, mesh: &Mesh, options: &Options) -> Result<Self, Error> {
        Ok(Self {
            buffers: Buffers::new(device, mesh, options, None)?,
            bench: Bench::new(device)?,
            readback: Readback::default(),
            stages: Vec::new(),
            grown: 0,
            expected: 0,
            stale: false,
            at_once: 0,
            order: KeptOrder::default(),
            geometry: Geometry::default(),
            cancel: None,
            of_bodies: 0,
        })
    }

    /// How the earliest time is looked for in the next frame.
    pub fn goal_of_earliest(&mut self) -> Goal {
        let at_once = self.at_once > 0 || !self.buffers.source.samples();
        let goal = if at_once { Goal::EarliestAtOnce } else { Goal::Earliest };
        self.at_once = self.at_once.saturating_sub(1);
        goal
    }

    /// Positions of the next frame.
    pub fn upload(
        &mut self,
        device: &Device,
        mesh: &Mesh,
        (given, moved): (Given, Option<Moved>),
        distance: f64,
    ) -> Result<(), Error> {
        self.geometry.listed = false;
        self.refresh(device, mesh)?;
        let Buffers { positions, source, .. } = &mut self.buffers;
        if positions.upload(device, (given, moved), distance, source.finder().boxes())? {
            self.bench.forget();
        }
        if let Some(triangles) = source.triangles_mut() {
            triangles.certify(device, mesh, given)?;
        }
        Ok(())
    }

    /// Records a frame that starts from paths on the device; nothing is read.
    pub fn record(
        &mut self,
        device: &Device,
        (mesh, options): (&Mesh, &Options),
        encoder: &mut wgpu::CommandEncoder,
    ) -> Result<&Buffers, Error> {
        if self.buffers.source.triangles().is_some_and(TrianglePairs::certifies) {
            return Err(Error::PathsUnseen);
        }
        self.geometry.listed = false;
        self.refresh(device, mesh)?;
        self.buffers.positions.take_paths();
        self.buffers.to_order = 0;
        // The caller may submit the encoder or not.
        self.order.forget();
        self.buffers.keeps_order = false;
        let (bench, buffers) = (&mut self.bench, &self.buffers);
        let frame = buffers.describe(options, WHOLE);
        device.guarded("a frame", 0, || -> Result<(), Error> {
            let mut recorder = bench.record(encoder);
            buffers.lists().map(|list| recorder.clear(list.buffer(), HEADER_BYTES));
            buffers.record(&mut recorder, &frame, Goal::Contacts, device.info().wide);
            recorder.finish().map(|_| ())
        })??;
        self.geometry.listed = true;
        Ok(buffers)
    }

    /// Runs frames over a window of the step until every list was long enough. Contacts of the
    /// device go to `contacts`.
    pub fn run(
        &mut self,
        device: &Device,
        options: &Options,
        (goal, window): (Goal, [f64; 2]),
        contacts: &mut Vec<Contact>,
    ) -> Result<Found, Error> {
        let found = until_complete(|| {
            if self.cancel.as_ref().is_some_and(CancelToken::is_cancelled) {
                // What was uploaded is in no order yet.
                self.order.forget();
                return Err(ccd_core::Error::Cancelled.into());
            }
            let found = self.attempt(device, options, (goal, window), contacts)?;
            self.grown += found.is_none() as u32;
            Ok(found)
        })?;
        self.geometry.listed = goal == Goal::Contacts;
        Ok(found)
    }

    /// What each worker did in the last frame; see `BroadPhase::worker_counts`.
    pub fn worker_counts(&mut self, device: &Device) -> Result<Vec<WorkerCounts>, Error> {
        let Self { buffers, bench, readback, .. } = self;
        worker_counts::read(device, bench, readback, &buffers.source.finder().worker_counts())
    }

    /// Reads the candidates of a frame: pairs of vertices and faces, pairs of edges.
    pub fn read_candidates(
        &mut self,
        device: &Device,
        count: PerKind,
    ) -> Result<[Vec<Pair>; 2], Error> {
        let Self { buffers, bench, readback, .. } = self;
        let PerKind { vf, ee, .. } = count;
        let mut plan = Plan::default();
        let [of_vf, of_ee] = &buffers.candidates;
        let (part_vf, part_ee) =
            (plan.part(of_vf.bytes(vf as u32)), plan.part(of_ee.bytes(ee as u32)));
        let reading = readback.prepare(device, plan)?;
        submit(device, bench, |recorder| {
            recorder.read(&reading, part_vf, of_vf.buffer(), 0);
            recorder.read(&reading, part_ee, of_ee.buffer(), 0);
        })?;
        reading.with(device, |bytes| [part_vf, part_ee].map(|part| read_pairs(part.of(bytes))))
    }

    /// Makes buffers for the order of as many contacts as are expected, if they are many. Returns
    /// how many are to be read at once.
    fn plan_contacts(&mut self, device: &Device, goal: Goal) -> Result<u32, Error> {
        let Self { buffers, bench, expected, .. } = self;
        let n = if goal == Goal::Contacts {
            (*expected + *expected / 4 + 256).min(buffers.contacts.capacity())
        } else {
            0
        };
        buffers.to_order = if *expected >= contact_order::FEWEST { n } else { 0 };
        if buffers.order.as_ref().map_or(0, ContactOrder::capacity) < buffers.to_order {
            device.give_back(buffers.order.take().map_or(0, |old| old.bytes));
            bench.forget();
            // As for lists: some more, or else just enough; where there is no memory even for that,
            // the host sorts.
            let with_some_more = ContactOrder::new(device, n + n / 4);
            match with_some_more.or_else(|_| ContactOrder::new(device, n)) {
                Ok(order) => buffers.order = Some(order),
                Err(e) if e.is_of_memory() => buffers.to_order = 0,
                Err(e) => return Err(e),
            }
        }
        Ok(n)
    }

    /// Runs a frame; `None` if a list was too short and has been replaced.
    fn attempt(
        &mut self,
        device: &Device,
        options: &Options,
        (goal, window): (Goal, [f64; 2]),
        contacts: &mut Vec<Contact>,
    ) -> Result<Option<Found>, Error> {
        let guess = self.plan_contacts(device, goal)?;
        // Without an order until this frame has come to a good end.
        let mut order = std::mem::take(&mut self.order);
        let kept = order.holds(self.buffers.n_boxes());
        let Self { buffers, bench, readback, .. } = self;
        buffers.keeps_order = kept;
        let frame = buffers.describe(options, window);
        let mut plan = Plan::default();
        let wide = device.info().wide;
        let asked = |is: bool, bytes: u64| if is { bytes } else { 0 };
        let of_earliest = [(); 2].map(|()| plan.part(asked(goal.is_earliest(), 4)));
        let of_sample = plan.part(asked(goal == Goal::Earliest, 16));
        let of_lists = buffers.used(goal, wide).map(|used| plan.part(asked(used, HEADER_BYTES)));
        let of_contacts = plan.part(guess as u64 * size_of::<Touch>() as u64);
        let counters = buffers.source.finder().counters();
        let of_counters: Vec<_> =
            counters.iter().map(|(_, range)| plan.part(range.end - range.start)).collect();
        let of_counts = plan.part(buffers.source.triangles().map_or(0, |_| COUNT_BYTES));
        let reading = readback.prepare(device, plan)?;
        let stages = submit(device, bench, |recorder| {
            buffers.record(recorder, &frame, goal, wide);
            recorder.end_of_work();
            for (part, earliest) in of_earliest.iter().zip(&buffers.earliest) {
                recorder.read(&reading, *part, earliest, 0);
            }
            recorder.read(&reading, of_sample, &buffers.sample, 0);
            let lists = buffers.lists().zip(of_lists.clone());
            lists.map(|(list, part)| recorder.read(&reading, part, list.buffer(), 0));
            for (part, (counters, range)) in of_counters.iter().zip(&counters) {
                recorder.read(&reading, *part, counters, range.start);
            }
            if let Some(triangles) = buffers.source.triangles() {
                recorder.read(&reading, of_counts, triangles.counts(), 0);
            }
            match &buffers.order {
                Some(order) if buffers.to_order > 0 => {
                    recorder.read(&reading, of_contacts, &order.ordered, 0)
                }
                _ => recorder.read(&reading, of_contacts, buffers.contacts.buffer(), HEADER_BYTES),
            }
        })?;
        let mut found = Found { sorted: !kept, ..Found::default() };
        let mut sampled_of = 0;
        let (headers, counted) = reading.with(device, |bytes| {
            if goal.is_earliest() {
                let [vf, ee] = of_earliest.map(|part| word(part.of(bytes), 0));
                found.earliest = vf.min(ee);
            }
            if goal == Goal::Earliest {
                let at = |i| word(of_sample.of(bytes), i) as u64;
                (found.sampled, sampled_of) = (at(0) + at(1), at(2) + at(3));
            }
            let headers = of_lists.try_map(|part| match part.bytes {
                0 => Ok(Header::default()),
                _ => read_header(part.of(bytes)),
            })?;
            let n = headers.contacts.wanted.min(guess) as usize;
            cpu_fallback::take_touches(&of_contacts.of(bytes)[..n * size_of::<Touch>()], contacts);
            let triangles = buffers.source.triangles();
            found.triangles = triangles.map(|_| read_counts(of_counts.of(bytes)));
            let words = |part: &Part| bytemuck::pod_collect_to_vec(part.of(bytes));
            let counted: Vec<Vec<u32>> = of_counters.iter().map(words).collect();
            Ok::<_, Error>((headers, counted))
        })??;
        self.stages = bench.times(&stages)?;
        let lists = buffers.lists_mut().zip(headers.clone()).into_vec();
        let lists = lists.into_iter().map(|(list, header)| (list, header.wanted));
        let grown = List::grow_all(device, lists);
        let complete = matches!(grown, Ok(false));
        // Also where a list cannot grow: the source learns that the search was not complete.
        let settled = buffers.source.finder_mut().settle(device, &counted, complete);
        if !complete || !matches!(settled, Ok(false)) {
            bench.forget();
        }
        if !complete {
            contacts.clear();
        }
        let grown = grown?;
        settled?;
        if grown {
            return Ok(None);
        }
        let of_lists = buffers.source.finder().work(&headers.source);
        order.took(
            kept,
            if goal == Goal::Earliest { of_lists.and(Some(sampled_of)) } else { of_lists },
        );
        self.order = order;
        let [vf, ee] = &headers.survivors;
        found.filtered = PerKind::new(vf.wanted as u64, ee.wanted as u64);
        found.candidates = if goal == Goal::Candidates {
            let [vf, ee] = &headers.candidates;
            PerKind::new(vf.wanted as u64, ee.wanted as u64)
        } else {
            PerKind::new(vf.looked_at as u64, ee.looked_at as u64)
        };
        if goal == Goal::Earliest && found.candidates.total() > found.sampled * SAMPLE as u64 / 4 {
            self.at_once = AT_ONCE;
        }
        let n_contacts = headers.contacts.wanted;
        let n_open = headers.undecided.map(|header| header.wanted);
        let beyond = n_contacts > guess;
        if goal == Goal::Contacts {
            self.expected = n_contacts;
        }
        found.in_order = !beyond && buffers.to_order > 0;
        if beyond || n_open != [0, 0] {
            let n_contacts = if beyond { n_contacts } else { 0 };
            found.open = self.read_rest(device, n_contacts, n_open, contacts)?;
        }
        Ok(Some(found))
    }

    /// Reads what the frame's own reading left: all contacts, if they were more than expected, and
    /// pairs that are left open.
    fn read_rest(
        &mut self,
        device: &Device,
        n_contacts: u32,
        n_open: [u32; 2],
        contacts: &mut Vec<Contact>,
    ) -> Result<[Vec<Pair>; 2], Error> {
        let Self { buffers, bench, readback, .. } = self;
        let Buffers { contacts: list, undecided: [vf, ee], .. } = buffers;
        let mut plan = Plan::default();
        let of_contacts = plan.part(list.bytes(n_contacts));
        let (of_vf, of_ee) = (plan.part(vf.bytes(n_open[0])), plan.part(ee.bytes(n_open[1])));
        let reading = readback.prepare(device, plan)?;
        submit(device, bench, |recorder| {
            for (part, list) in [(of_contacts, &*list), (of_vf, vf), (of_ee, ee)] {
                recorder.read(&reading, part, list.buffer(), 0);
            }
        })?;
        reading.with(device, |bytes| {
            if n_contacts > 0 {
                contacts.clear();
                cpu_fallback::take_touches(
                    &of_contacts.of(bytes)[HEADER_BYTES as usize..],
                    contacts,
                );
            }
            [read_pairs(of_vf.of(bytes)), read_pairs(of_ee.of(bytes))]
        })
    }
}

/// If more than a quarter of the candidates is left after paths were cut, so many of the next calls
/// do without: what is cut takes less time than the sample, the cut and the second fit only where
/// most candidates go.
const AT_ONCE: u32 = 63;
