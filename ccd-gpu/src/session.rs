//! A mesh stepped frame by frame on a device: everything of a frame in one submission, lists that
//! grow when they were too short.

use crate::device::Device;
use crate::error::Error;
use crate::growable_list::{HEADER_BYTES, List, read_header, read_pairs};
use crate::readback::{Plan, Readback, word};
use crate::recorder::{Bench, Timing, submit};
use crate::step::buffers::Buffers;
use crate::step::contact_order::{self, ContactOrder};
use crate::step::{Goal, SAMPLE, cpu_fallback};
use ccd_core::Coordinate;
use ccd_core::layout::{Pair, Touch};
use ccd_core::model::contact::{Kind, PerKind, State};
use ccd_core::model::mesh::Mesh;
use ccd_core::model::method::BroadPhaseMethod;
use ccd_core::model::options::Options;
use ccd_core::model::precision::{Given, Points, Precision};
use ccd_core::model::report::Report;
use ccd_core::narrow_phase::decide;
use std::time::Instant;

/// Continuous collision detection of one mesh over many steps, on a GPU.
pub struct Session {
    device: Device,
    mesh: Mesh,
    options: Options,
    buffers: Buffers,
    bench: Bench,
    readback: Readback,
    report: Report,
    stages: Vec<(&'static str, f64)>,
    grown: u32,
    /// Contacts that the device found in the last step: about as many are read with the results of
    /// the next.
    expected: u32,
    /// Calls for which the earliest time is looked for at once, because a sample did not pay the
    /// last time.
    at_once: u32,
    left_open: PerKind,
}

/// Results where a device has them, for work that goes on there. Valid until the session's next
/// call.
///
/// A list is a header of four words, of which the first is the number of entries, then the entries.
/// That number may exceed the room of a list in [`OnDevice::lists`]: then results are incomplete,
/// and [`Session::step`] must be called instead, which makes room.
#[derive(Clone, Debug)]
pub struct OnDevice<'a> {
    /// Contacts: entries are [`Touch`].
    pub contacts: &'a List,
    /// Pairs of vertices and faces, and of edges, that `f32` could not decide, to be treated as
    /// contacts; empty where `f64` is used on the device.
    pub undecided: [&'a List; 2],
    /// Every list of the frame, also those between stages: if the first word of any of them exceeds
    /// its room, results are incomplete.
    pub lists: Vec<&'a List>,
    /// By kind, one word: the bits of the earliest time of impact as `f32`, rounded down; greater
    /// than those of 1 if there is none. Without the undecided pairs.
    pub earliest: [&'a wgpu::Buffer; 2],
}

/// Candidates of a step: pairs of features whose swept boxes overlap, in no order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Candidates {
    /// Vertex, face.
    pub vf: Vec<Pair>,
    /// Two edges, the lesser id first.
    pub ee: Vec<Pair>,
}

impl Session {
    /// A session for `mesh` on `device`.
    pub fn new(device: &Device, mesh: Mesh, options: Options) -> Result<Self, Error> {
        options.check(&mesh)?;
        if options.broad_phase != BroadPhaseMethod::Blocks {
            let name = options.broad_phase.row().name;
            return Err(ccd_core::Error::Method { name, backend: "gpu" }.into());
        }
        Ok(Self {
            buffers: Buffers::new(device, &mesh, &options)?,
            bench: Bench::new(device)?,
            device: device.clone(),
            mesh,
            options,
            readback: Readback::default(),
            report: Report::default(),
            stages: Vec::new(),
            grown: 0,
            expected: 0,
            at_once: 0,
            left_open: PerKind::default(),
        })
    }

    /// Goes on with another device, after the last one was lost.
    pub fn move_to(&mut self, device: &Device) -> Result<(), Error> {
        self.buffers = Buffers::new(device, &self.mesh, &self.options)?;
        self.bench = Bench::new(device)?;
        self.readback = Readback::default();
        self.device = device.clone();
        Ok(())
    }

    /// The mesh.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// The options.
    pub fn options(&self) -> &Options {
        &self.options
    }

    /// The device.
    pub fn device(&self) -> &Device {
        &self.device
    }

    /// What the last step found. Of its times, `total` is wall clock; stages are in
    /// [`Session::stages`].
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// What each call times on the device from now on.
    pub fn set_timing(&mut self, timing: Timing) -> Result<(), Error> {
        self.bench.set_timing(timing)
    }

    /// Milliseconds on the device, from the first kernel to the last: of each stage or of all
    /// together.
    pub fn stages(&self) -> &[(&'static str, f64)] {
        &self.stages
    }

    /// Pairs of the last call that `f32` on the device left open and the CPU decided.
    pub fn left_open(&self) -> PerKind {
        self.left_open
    }

    /// How often a list was too short since the session began, so that a frame ran again.
    pub fn grown(&self) -> u32 {
        self.grown
    }

    /// Makes room for so many entries in every list, more or less than there is: less makes the
    /// next step grow them, more spares it that.
    pub fn reserve(&mut self, entries: u32) -> Result<(), Error> {
        for list in self.buffers.lists_mut().into_vec() {
            *list = list.resized(&self.device, entries)?;
        }
        self.bench.forget();
        Ok(())
    }

    /// Every contact while vertices move on straight lines from `x0` to `x1`, one position per
    /// vertex of the mesh.
    pub fn step<T: Coordinate>(&mut self, x0: &[[T; 3]], x1: &[[T; 3]]) -> Result<&Report, Error> {
        self.run(T::slices::<Points, 2>([x0, x1]), Goal::Contacts)?;
        Ok(&self.report)
    }

    /// The earliest time of impact of the step, without the list of contacts: cheaper than
    /// [`Session::step`]. `None`: the whole step is free.
    ///
    /// It is not later than the earliest contact, and rounded down to an `f32`.
    pub fn earliest_toi<T: Coordinate>(
        &mut self,
        x0: &[[T; 3]],
        x1: &[[T; 3]],
    ) -> Result<Option<f64>, Error> {
        let goal = if self.at_once > 0 { Goal::EarliestAtOnce } else { Goal::Earliest };
        self.at_once = self.at_once.saturating_sub(1);
        self.run(T::slices::<Points, 2>([x0, x1]), goal)?;
        Ok(self.report.toi)
    }

    /// Lists all candidates of the step: pairs of features whose swept boxes overlap, without those
    /// that share a vertex or that the bodies rule out.
    pub fn candidates<T: Coordinate>(
        &mut self,
        x0: &[[T; 3]],
        x1: &[[T; 3]],
    ) -> Result<Candidates, Error> {
        self.list(T::slices::<Points, 2>([x0, x1]))
    }

    /// Lists candidates.
    #[inline(never)]
    fn list(&mut self, given: Given) -> Result<Candidates, Error> {
        self.run(given, Goal::Candidates)?;
        let Self { buffers, bench, readback, device, report, .. } = self;
        let PerKind { vf, ee } = report.candidates;
        let mut plan = Plan::default();
        let [of_vf, of_ee] = &buffers.candidates;
        let (part_vf, part_ee) =
            (plan.part(of_vf.bytes(vf as u32)), plan.part(of_ee.bytes(ee as u32)));
        let reading = readback.prepare(device, plan)?;
        submit(device, bench, |recorder| {
            recorder.read(&reading, part_vf, of_vf.buffer(), 0);
            recorder.read(&reading, part_ee, of_ee.buffer(), 0);
        })?;
        reading.with(device, |bytes| Candidates {
            vf: read_pairs(part_vf.of(bytes)),
            ee: read_pairs(part_ee.of(bytes)),
        })
    }

    /// As [`Session::candidates`], but leaves the pairs on the device: vertex-face and edge-edge,
    /// until the next call. All of them fit.
    pub fn candidates_on_device<T: Coordinate>(
        &mut self,
        x0: &[[T; 3]],
        x1: &[[T; 3]],
    ) -> Result<[&List; 2], Error> {
        self.run(T::slices::<Points, 2>([x0, x1]), Goal::Candidates)?;
        let [vf, ee] = &self.buffers.candidates;
        Ok([vf, ee])
    }

    /// The buffer of positions that [`Session::record`] reads: one [`ccd_core::layout::Path`] per
    /// vertex. May be written by copies and by kernels.
    pub fn paths(&self) -> &wgpu::Buffer {
        &self.buffers.positions.paths
    }

    /// Records a whole step, from the paths in [`Session::paths`] to the lists of [`OnDevice`],
    /// into an encoder of the caller's; nothing is read back.
    ///
    /// The paths are taken as exact and must be finite. Submit the encoder before the session's
    /// next call. With a minimum distance, it is rounded to `f32`.
    pub fn record(&mut self, encoder: &mut wgpu::CommandEncoder) -> Result<OnDevice<'_>, Error> {
        self.buffers.positions.take_paths();
        self.buffers.to_order = 0;
        let (device, bench, buffers) = (&self.device, &mut self.bench, &self.buffers);
        let frame = buffers.describe(&self.options);
        device.guarded("a frame", 0, || -> Result<(), Error> {
            let mut recorder = bench.record(encoder);
            buffers.record(&mut recorder, &frame, Goal::Contacts, device.info().wide);
            recorder.finish().map(|_| ())
        })??;
        let b = &self.buffers;
        let lists = b.lists().into_vec();
        Ok(OnDevice {
            contacts: &b.contacts,
            undecided: [&b.undecided[0], &b.undecided[1]],
            lists,
            earliest: b.earliest.each_ref(),
        })
    }

    #[inline(never)]
    fn run(&mut self, given: Given, goal: Goal) -> Result<(), Error> {
        match given {
            Precision::F32([x0, x1]) => self.mesh.check_positions(x0, x1),
            Precision::F64([x0, x1]) => self.mesh.check_positions(x0, x1),
        }?;
        let start = Instant::now();
        let distance = self.options.min_distance;
        let Buffers { positions, tree, .. } = &mut self.buffers;
        self.device.check_lost()?;
        if positions.upload(&self.device, given, distance, &tree.boxes)? {
            self.bench.forget();
        }
        self.report = Report {
            contacts: std::mem::take(&mut self.report.contacts),
            rebuilt: true,
            ..Report::default()
        };
        self.report.contacts.clear();
        let uploaded = start.elapsed();
        let found = loop {
            match self.attempt(goal)? {
                Some(found) => break found,
                None => self.grown += 1,
            }
        };
        self.report.times.boxes = uploaded.as_secs_f64() * 1e3;
        self.take(found, goal, given);
        self.report.times.total = start.elapsed().as_secs_f64() * 1e3;
        Ok(())
    }

    /// Makes room for the order of as many contacts as are expected, if they are many. Returns how
    /// many are to be read at once.
    fn plan_contacts(&mut self, goal: Goal) -> Result<u32, Error> {
        let Self { device, buffers, bench, expected, .. } = self;
        let n = if goal == Goal::Contacts {
            (*expected + *expected / 4 + 256).min(buffers.contacts.room())
        } else {
            0
        };
        buffers.to_order = if *expected >= contact_order::FEWEST { n } else { 0 };
        if buffers.order.as_ref().map_or(0, ContactOrder::room) < buffers.to_order {
            buffers.order = None;
            bench.forget();
            // As for lists: some more, or else just enough; where there is no memory even for that,
            // the host sorts.
            let with_some_more = ContactOrder::new(device, n + n / 4);
            match with_some_more.or_else(|_| ContactOrder::new(device, n)) {
                Ok(order) => buffers.order = Some(order),
                Err(Error::TooLarge { .. } | Error::OutOfMemory { .. }) => buffers.to_order = 0,
                Err(e) => return Err(e),
            }
        }
        Ok(n)
    }

    /// Runs a frame; `None` if a list was too short and has been replaced.
    fn attempt(&mut self, goal: Goal) -> Result<Option<Found>, Error> {
        let guess = self.plan_contacts(goal)?;
        let Self { device, buffers, bench, readback, report, .. } = self;
        let frame = buffers.describe(&self.options);
        let mut plan = Plan::default();
        let of_earliest = [plan.part(4), plan.part(4)];
        let of_sample = plan.part(8);
        let of_lists = buffers.lists().map(|_| plan.part(HEADER_BYTES));
        let of_contacts = plan.part(guess as u64 * size_of::<Touch>() as u64);
        let reading = readback.prepare(device, plan)?;
        let wide = device.info().wide;
        let stages = submit(device, bench, |recorder| {
            buffers.record(recorder, &frame, goal, wide);
            recorder.end_of_work();
            for (part, earliest) in of_earliest.iter().zip(&buffers.earliest) {
                recorder.read(&reading, *part, earliest, 0);
            }
            recorder.read(&reading, of_sample, &buffers.sample, 0);
            let lists = buffers.lists().zip(of_lists.clone());
            lists.map(|(list, part)| recorder.read(&reading, part, list.buffer(), 0));
            match &buffers.order {
                Some(order) if buffers.to_order > 0 => {
                    recorder.read(&reading, of_contacts, &order.ordered, 0)
                }
                _ => recorder.read(&reading, of_contacts, buffers.contacts.buffer(), HEADER_BYTES),
            }
        })?;
        let mut found = Found::default();
        let headers = reading.with(device, |bytes| {
            let [vf, ee] = of_earliest.map(|part| word(part.of(bytes), 0));
            found.earliest = vf.min(ee);
            found.sampled =
                word(of_sample.of(bytes), 0) as u64 + word(of_sample.of(bytes), 1) as u64;
            let headers = of_lists.try_map(|part| read_header(part.of(bytes)))?;
            let n = headers.contacts.wanted.min(guess) as usize;
            cpu_fallback::take_touches(
                &of_contacts.of(bytes)[..n * size_of::<Touch>()],
                &mut report.contacts,
            );
            Ok::<_, Error>(headers)
        })??;
        self.stages = bench.times(&stages)?;
        let mut grown = false;
        let lists = buffers.lists_mut().zip(headers.each_ref());
        // Kernels look at the room of every list, so what cannot grow is an error and nothing
        // worse.
        let all_grew = lists.try_map(|(list, header)| {
            grown |= list.grow(device, header.wanted)?;
            Ok::<_, Error>(())
        });
        if grown {
            bench.forget();
            report.contacts.clear();
        }
        all_grew?;
        if grown {
            return Ok(None);
        }
        let [vf, ee] = &headers.survivors;
        found.filtered = PerKind { vf: vf.wanted as u64, ee: ee.wanted as u64 };
        found.candidates = if goal == Goal::Candidates {
            let [vf, ee] = &headers.candidates;
            PerKind { vf: vf.wanted as u64, ee: ee.wanted as u64 }
        } else {
            PerKind { vf: vf.looked_at as u64, ee: ee.looked_at as u64 }
        };
        if goal == Goal::Earliest && found.candidates.total() > found.sampled * SAMPLE as u64 / 4 {
            self.at_once = AT_ONCE;
        }
        let n_contacts = headers.contacts.wanted;
        let n_open = headers.undecided.map(|header| header.wanted);
        let beyond = goal == Goal::Contacts && n_contacts > guess;
        if goal == Goal::Contacts {
            self.expected = n_contacts;
        }
        found.in_order = !beyond && buffers.to_order > 0;
        if beyond || !wide && n_open != [0, 0] {
            self.read_rest(&mut found, if beyond { n_contacts } else { 0 }, n_open)?;
        }
        Ok(Some(found))
    }

    /// Reads what the frame's own reading left: all contacts, if they were more than expected, and
    /// pairs that are left open.
    fn read_rest(
        &mut self,
        found: &mut Found,
        n_contacts: u32,
        n_open: [u32; 2],
    ) -> Result<(), Error> {
        let Self { device, buffers, bench, readback, report, .. } = self;
        let Buffers { contacts, undecided: [vf, ee], .. } = buffers;
        let mut plan = Plan::default();
        let of_contacts = plan.part(contacts.bytes(n_contacts));
        let (of_vf, of_ee) = (plan.part(vf.bytes(n_open[0])), plan.part(ee.bytes(n_open[1])));
        let reading = readback.prepare(device, plan)?;
        submit(device, bench, |recorder| {
            for (part, list) in [(of_contacts, contacts), (of_vf, vf), (of_ee, ee)] {
                recorder.read(&reading, part, list.buffer(), 0);
            }
        })?;
        found.open = reading.with(device, |bytes| {
            if n_contacts > 0 {
                report.contacts.clear();
                cpu_fallback::take_touches(
                    &of_contacts.of(bytes)[HEADER_BYTES as usize..],
                    &mut report.contacts,
                );
            }
            [read_pairs(of_vf.of(bytes)), read_pairs(of_ee.of(bytes))]
        })?;
        Ok(())
    }

    /// Decides what the device left open, and makes the report.
    fn take(&mut self, found: Found, goal: Goal, given: Given) {
        let report = &mut self.report;
        self.left_open = PerKind { vf: found.open[0].len() as u64, ee: found.open[1].len() as u64 };
        report.candidates = found.candidates;
        report.filtered = found.filtered;
        let contacts = &mut report.contacts;
        for (kind, open) in [Kind::VertexFace, Kind::EdgeEdge].into_iter().zip(&found.open) {
            let (mesh, distance) = (&self.mesh, self.options.min_distance);
            match given {
                Precision::F32(x) => cpu_fallback::decide(mesh, kind, open, x, distance, contacts),
                Precision::F64(x) => cpu_fallback::decide(mesh, kind, open, x, distance, contacts),
            }
        }
        report.toi = contacts.iter().map(|c| c.toi).reduce(f64::min);
        if goal != Goal::Contacts {
            // Contacts that the device counted are not in the list; their earliest time is.
            let device =
                (found.earliest != decide::NEVER).then(|| f32::from_bits(found.earliest) as f64);
            report.toi = report.toi.into_iter().chain(device).reduce(f64::min);
            contacts.clear();
        }
        if !found.in_order || found.open.iter().any(|open| !open.is_empty()) {
            cpu_fallback::sort(contacts);
        }
        report.undecided = contacts.iter().filter(|c| c.state == State::Undecided).count() as u64;
    }
}

/// What a frame gave.
#[derive(Clone, Debug, Default)]
struct Found {
    earliest: u32,
    /// Candidates of the sample.
    sampled: u64,
    candidates: PerKind,
    filtered: PerKind,
    open: [Vec<Pair>; 2],
    /// Whether contacts are in their order already.
    in_order: bool,
}

/// If more than a quarter of the candidates is left after paths were cut, so many of the next calls
/// do without: what is cut takes less time than the sample, the cut and the second fit only where
/// most candidates go.
const AT_ONCE: u32 = 63;
