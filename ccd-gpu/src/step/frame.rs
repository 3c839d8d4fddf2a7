//! Frames of a session on its device: one submission each, what is read with it, lists that grow
//! when they were too short.

use super::buffers::Buffers;
use super::contact_geometry::Geometry;
use super::cpu_fallback::Summary;
use super::kept_order::KeptOrder;
use super::triangle_pairs::TrianglePairs;
use super::upload::Input;
use super::{Goal, WHOLE};
use crate::broad_phase::worker_counts::{self, WorkerCounts};
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::{HEADER_BYTES, read_pairs};
use crate::readback::{Plan, Readback};
use crate::recorder::{Bench, submit};
use ccd_core::backend::layout::Pair;
use ccd_core::model::cancel::CancelToken;
use ccd_core::model::contact::{Contact, PerKind};
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use ccd_core::model::report::TriangleCounts;

mod attempt;
mod changes;
mod expected;
mod flight;

use expected::Expected;
use flight::Flight;

/// Buffers of all frames, and what one learns from the frame before.
pub struct Frames {
    pub buffers: Buffers,
    pub bench: Bench,
    readback: Readback,
    /// Milliseconds on the device in the last frame.
    pub stages: Vec<(&'static str, f64)>,
    /// How often a list was too short, so that a frame ran again.
    pub grown: u32,
    /// Contacts that are read with the results, by goal.
    contacts: [Expected; 4],
    /// Pairs that the first of two decisions in `f64` left, or would have left, by goal.
    left: [u32; 4],
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
    /// The frame that was submitted and whose results are not here yet.
    flight: Option<Flight>,
    /// Contacts of an earlier step, as memory for those of the next.
    pub spare: Vec<Contact>,
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
    /// Pairs that a first decision left to a second.
    pub left: u32,
    /// Of the contacts that the device listed.
    pub summary: Summary,
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
            contacts: Default::default(),
            left: [0; 4],
            stale: false,
            at_once: 0,
            order: KeptOrder::default(),
            geometry: Geometry::default(),
            cancel: None,
            of_bodies: 0,
            flight: None,
            spare: Vec::new(),
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
        input: Input,
        distance: f64,
    ) -> Result<(), Error> {
        self.geometry.listed = false;
        self.refresh(device, mesh)?;
        let Buffers { positions, source, .. } = &mut self.buffers;
        if positions.upload(device, input, distance, source.finder().boxes())? {
            self.bench.forget();
        }
        if let Some(triangles) = source.triangles_mut() {
            triangles.certify(device, mesh, input.given)?;
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
        self.buffers.decides_twice = true;
        let (bench, buffers) = (&mut self.bench, &self.buffers);
        let frame = buffers.describe(options, WHOLE);
        device.guarded("a frame", 0, || -> Result<(), Error> {
            let mut recorder = bench.record();
            buffers.lists().map(|list| recorder.clear(list.buffer(), HEADER_BYTES));
            buffers.record(&mut recorder, &frame, Goal::Contacts, device.info().wide);
            recorder.finish(encoder).map(|_| ())
        })??;
        self.geometry.listed = true;
        Ok(buffers)
    }

    /// What each worker did in the last frame; see `BroadPhase::worker_counts`.
    pub fn worker_counts(&mut self, device: &Device) -> Result<Vec<WorkerCounts>, Error> {
        let Self { buffers, bench, readback, .. } = self;
        worker_counts::read(device, bench, readback, &buffers.source.finder().worker_counts())
    }

    /// Reads the candidates of a frame: pairs of vertices and faces, pairs of edges.
    pub async fn read_candidates(
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
        let read = |bytes: &[u8]| [part_vf, part_ee].map(|part| read_pairs(part.of(bytes)));
        reading.with(device, read).await
    }
}
