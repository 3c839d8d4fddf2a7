//! A mesh stepped frame by frame on a device: what callers ask, what they get, and what the CPU
//! decides of it.

use crate::broad_phase::method;
use crate::broad_phase::worker_counts::WorkerCounts;
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use crate::recorder::Timing;
use crate::step::frame::{Found, Frames};
use crate::step::{Goal, cpu_fallback};
use ccd_core::Coordinate;
use ccd_core::layout::Pair;
use ccd_core::model::contact::{Kind, PerKind};
use ccd_core::model::mesh::Mesh;
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
    frames: Frames,
    report: Report,
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
    /// Contacts: entries are [`Touch`](ccd_core::layout::Touch).
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
        method::check(options.broad_phase)?;
        method::check_scheduling(options.broad_phase, options.scheduling)?;
        if let Some(name) = options.pipeline.lacking("gpu") {
            return Err(ccd_core::Error::Method { name, backend: "gpu" }.into());
        }
        Ok(Self {
            frames: Frames::new(device, &mesh, &options)?,
            device: device.clone(),
            mesh,
            options,
            report: Report::default(),
            left_open: PerKind::default(),
        })
    }

    /// Goes on with another device, after the last one was lost.
    pub fn move_to(&mut self, device: &Device) -> Result<(), Error> {
        self.frames.move_to(device, &self.mesh, &self.options)?;
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
        self.frames.bench.set_timing(timing)
    }

    /// Milliseconds on the device, from the first kernel to the last: of each stage or of all
    /// together.
    pub fn stages(&self) -> &[(&'static str, f64)] {
        &self.frames.stages
    }

    /// What each worker did in the last call, those of one kind of pairs after those of the other;
    /// empty where the scheduler has no workers.
    pub fn worker_counts(&mut self) -> Result<Vec<WorkerCounts>, Error> {
        self.frames.worker_counts(&self.device)
    }

    /// Pairs of the last call that `f32` on the device left open and the CPU decided.
    pub fn left_open(&self) -> PerKind {
        self.left_open
    }

    /// How often a list was too short since the session began, so that a frame ran again.
    pub fn grown(&self) -> u32 {
        self.frames.grown
    }

    /// Makes room for so many entries in every list, more or less than there is: less makes the
    /// next step grow them, more spares it that.
    pub fn reserve(&mut self, entries: u32) -> Result<(), Error> {
        self.frames.reserve(&self.device, entries)
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
        let goal = self.frames.goal_of_earliest();
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
        let [vf, ee] = self.frames.read_candidates(&self.device, self.report.candidates)?;
        Ok(Candidates { vf, ee })
    }

    /// As [`Session::candidates`], but leaves the pairs on the device: vertex-face and edge-edge,
    /// until the next call. All of them fit.
    pub fn candidates_on_device<T: Coordinate>(
        &mut self,
        x0: &[[T; 3]],
        x1: &[[T; 3]],
    ) -> Result<[&List; 2], Error> {
        self.run(T::slices::<Points, 2>([x0, x1]), Goal::Candidates)?;
        let [vf, ee] = &self.frames.buffers.candidates;
        Ok([vf, ee])
    }

    /// The buffer of positions that [`Session::record`] reads: one [`ccd_core::layout::Path`] per
    /// vertex. May be written by copies and by kernels.
    pub fn paths(&self) -> &wgpu::Buffer {
        &self.frames.buffers.positions.paths
    }

    /// Records a whole step, from the paths in [`Session::paths`] to the lists of [`OnDevice`],
    /// into an encoder of the caller's; nothing is read back.
    ///
    /// The paths are taken as exact and must be finite. Submit the encoder before the session's
    /// next call. With a minimum distance, it is rounded to `f32`. Refused with normal cones, which
    /// are certified from positions on the host.
    pub fn record(&mut self, encoder: &mut wgpu::CommandEncoder) -> Result<OnDevice<'_>, Error> {
        let b = self.frames.record(&self.device, &self.options, encoder)?;
        Ok(OnDevice {
            contacts: &b.contacts,
            undecided: [&b.undecided[0], &b.undecided[1]],
            lists: b.lists().into_vec(),
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
        self.device.check_lost()?;
        self.frames.upload(&self.device, &self.mesh, given, self.options.min_distance)?;
        self.report =
            Report { contacts: std::mem::take(&mut self.report.contacts), ..Report::default() };
        self.report.contacts.clear();
        let uploaded = start.elapsed();
        let contacts = &mut self.report.contacts;
        let found = self.frames.run(&self.device, &self.options, goal, contacts)?;
        self.report.times.boxes = uploaded.as_secs_f64() * 1e3;
        self.take(found, goal, given);
        self.report.times.total = start.elapsed().as_secs_f64() * 1e3;
        Ok(())
    }

    /// Decides what the device left open, and makes the report.
    fn take(&mut self, found: Found, goal: Goal, given: Given) {
        let report = &mut self.report;
        self.left_open = PerKind { vf: found.open[0].len() as u64, ee: found.open[1].len() as u64 };
        report.rebuilt = found.sorted;
        report.candidates = found.candidates;
        report.filtered = found.filtered;
        report.triangles = found.triangles;
        report.front = self.frames.buffers.source.front();
        let contacts = &mut report.contacts;
        for (kind, open) in [Kind::VertexFace, Kind::EdgeEdge].into_iter().zip(&found.open) {
            let (mesh, distance) = (&self.mesh, self.options.min_distance);
            match given {
                Precision::F32(x) => cpu_fallback::decide(mesh, kind, open, x, distance, contacts),
                Precision::F64(x) => cpu_fallback::decide(mesh, kind, open, x, distance, contacts),
            }
        }
        (report.toi, report.undecided) = cpu_fallback::summary(contacts);
        if goal.is_earliest() {
            // Contacts that the device counted are not in the list; their earliest time is.
            let device =
                (found.earliest != decide::NEVER).then(|| f32::from_bits(found.earliest) as f64);
            report.toi = report.toi.into_iter().chain(device).reduce(f64::min);
        }
        if goal != Goal::Contacts {
            contacts.clear();
            report.undecided = 0;
        }
        if !found.in_order || found.open.iter().any(|open| !open.is_empty()) {
            cpu_fallback::sort(contacts);
        }
    }
}
