//! A mesh stepped frame by frame on a device: everything of a frame in one submission, lists that grow when they were too short.

use crate::device::Device;
use crate::error::Error;
use crate::list::{HEADER_BYTES, List};
use crate::readback::Readback;
use crate::recorder::{Bench, Recorder};
use crate::tail;
use crate::tree::Tree;
use crate::upload::Positions;
use ccd_core::error::check_min_distance;
use ccd_core::kernel::{Id, decide};
use ccd_core::layout::{LIST_HEADER, Pair, Params, Path, Touch};
use ccd_core::report::{Contact, Kind, Options, PerKind, Report, State};
use ccd_core::topology::Mesh;
use ccd_core::{Num, Real};
use std::time::Instant;
use wgpu::BufferUsages as U;

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
}

/// Everything on the device.
struct Buffers {
    tree: Tree,
    positions: Positions,
    /// Paths up to the earliest time of impact so far.
    shortened: wgpu::Buffer,
    edges: wgpu::Buffer,
    faces: wgpu::Buffer,
    bodies: wgpu::Buffer,
    /// Pairs that the filters leave, by kind.
    survivors: [List; 2],
    /// Pairs that `f32` leaves open, by kind.
    undecided: [List; 2],
    contacts: List,
    /// Candidates, by kind; as small as possible until they are asked for.
    candidates: [List; 2],
    /// The key of the earliest time of impact.
    earliest: wgpu::Buffer,
    never: wgpu::Buffer,
}

/// What a frame is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Goal {
    Contacts,
    Earliest,
    Candidates,
}

/// Results where a device has them, for work that goes on there. Valid until the session's next call.
///
/// A list is a header of four words, of which the first is the number of entries, then the entries. That number may exceed the room: then entries are missing, and
/// [`Session::step`] must be called instead, which makes room.
#[derive(Clone, Debug)]
pub struct OnDevice<'a> {
    /// Contacts: entries are [`Touch`].
    pub contacts: &'a List,
    /// Pairs of vertices and faces, and of edges, that `f32` could not decide, to be treated as contacts; empty where `f64` is used on the device.
    pub undecided: [&'a List; 2],
    /// One word: the bits of the earliest time of impact as `f32`, rounded down; greater than those of 1 if there is none. Without the undecided pairs.
    pub earliest: &'a wgpu::Buffer,
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
        check_min_distance(options.min_distance)?;
        if let Some(bodies) = &options.bodies {
            bodies.check(&mesh)?;
        }
        Ok(Self {
            buffers: Buffers::new(device, &mesh, &options)?,
            bench: Bench::new(device)?,
            device: device.clone(),
            mesh,
            options,
            readback: Readback::new(),
            report: Report::default(),
            stages: Vec::new(),
            grown: 0,
        })
    }

    /// Goes on with another device, after the last one was lost.
    pub fn move_to(&mut self, device: &Device) -> Result<(), Error> {
        self.buffers = Buffers::new(device, &self.mesh, &self.options)?;
        self.bench = Bench::new(device)?;
        self.readback = Readback::new();
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

    /// What the last step found. Of its times, `total` is wall clock; stages are in [`Session::stages`].
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// Starts or stops timing the stages of each step with timestamps of the device; each stage becomes a pass of its own, which costs a little.
    pub fn time_stages(&mut self, on: bool) -> Result<(), Error> {
        self.bench.time_stages(on)
    }

    /// Milliseconds on the device by stage, if they are timed.
    pub fn stages(&self) -> &[(&'static str, f64)] {
        &self.stages
    }

    /// How often a list was too short since the session began, so that a frame ran again.
    pub fn grown(&self) -> u32 {
        self.grown
    }

    /// Makes room for so many entries in every list, more or less than there is: less makes the next step grow them, more spares it that.
    pub fn reserve(&mut self, entries: u32) -> Result<(), Error> {
        for list in self.buffers.lists_mut() {
            *list = list.resized(&self.device, entries)?;
        }
        for kind in [0, 1] {
            let room = self.buffers.survivors[kind].room();
            self.buffers.undecided[kind].grow(&self.device, room)?;
        }
        self.bench.forget();
        Ok(())
    }

    /// Every contact while vertices move on straight lines from `x0` to `x1`, one position per vertex of the mesh.
    pub fn step<T: Real>(&mut self, x0: &[[T; 3]], x1: &[[T; 3]]) -> Result<&Report, Error> {
        self.run(x0, x1, Goal::Contacts)?;
        Ok(&self.report)
    }

    /// The earliest time of impact of the step, without the list of contacts: cheaper than [`Session::step`]. `None`: the whole step is free.
    ///
    /// It is not later than the earliest contact, and rounded down to an `f32`.
    pub fn earliest_toi<T: Real>(&mut self, x0: &[[T; 3]], x1: &[[T; 3]]) -> Result<Option<f64>, Error> {
        self.run(x0, x1, Goal::Earliest)?;
        Ok(self.report.toi)
    }

    /// Lists all candidates of the step: pairs of features whose swept boxes overlap, without those that share a vertex or that the bodies rule out.
    pub fn candidates<T: Real>(&mut self, x0: &[[T; 3]], x1: &[[T; 3]]) -> Result<Candidates, Error> {
        self.run(x0, x1, Goal::Candidates)?;
        let Self { buffers, bench, readback, device, report, .. } = self;
        let PerKind { vf, ee } = report.candidates;
        let sizes = [buffers.candidates[0].bytes(vf as u32), buffers.candidates[1].bytes(ee as u32)];
        let parts = readback.plan(device, &sizes)?;
        submit(device, bench, |recorder| {
            for (part, list) in parts.iter().zip(&buffers.candidates) {
                readback.copy(recorder, *part, list.buffer());
            }
        })?;
        let mut lists = readback.read(device, &parts)?.into_iter().map(|bytes| bytemuck::pod_collect_to_vec::<u8, Pair>(&bytes[HEADER_BYTES as usize..]));
        Ok(Candidates { vf: lists.next().unwrap_or_default(), ee: lists.next().unwrap_or_default() })
    }

    /// The buffer of positions that [`Session::record`] reads: one [`Path`] per vertex. May be written by copies and by kernels.
    pub fn paths(&self) -> &wgpu::Buffer {
        &self.buffers.positions.paths
    }

    /// Records a whole step, from the paths in [`Session::paths`] to the lists of [`OnDevice`], into an encoder of the caller's; nothing is read back.
    ///
    /// The paths are taken as exact and must be finite. Submit the encoder before the session's next call. With a minimum distance, it is rounded to `f32`.
    pub fn record(&mut self, encoder: &mut wgpu::CommandEncoder) -> Result<OnDevice<'_>, Error> {
        let positions = &mut self.buffers.positions;
        (positions.exact, positions.path_error, positions.slack) = (true, 0.0, 0.0);
        let (device, bench, buffers) = (&self.device, &mut self.bench, &self.buffers);
        let params = frame_params(buffers, &self.options, &self.mesh);
        device.guarded("a frame", 0, || -> Result<(), Error> {
            let mut recorder = bench.record(encoder);
            buffers.frame(&mut recorder, &params, Goal::Contacts, device.info().wide);
            recorder.finish().map(|_| ())
        })??;
        let b = &self.buffers;
        Ok(OnDevice { contacts: &b.contacts, undecided: [&b.undecided[0], &b.undecided[1]], earliest: &b.earliest })
    }

    fn run<T: Real>(&mut self, x0: &[[T; 3]], x1: &[[T; 3]], goal: Goal) -> Result<(), Error> {
        let expected = self.mesh.n_vertices();
        for (time, found) in [(0, x0.len()), (1, x1.len())] {
            if expected != found {
                return Err(ccd_core::Error::VertexCount { time, expected, found }.into());
            }
        }
        let start = Instant::now();
        let distance = self.options.min_distance;
        let Buffers { positions, tree, .. } = &mut self.buffers;
        self.device.check_lost()?;
        if positions.upload(&self.device, x0, x1, distance, &tree.boxes)? {
            self.bench.forget();
        }
        let last = self.report.contacts.len() as u32;
        self.report = Report { contacts: std::mem::take(&mut self.report.contacts), rebuilt: true, ..Report::default() };
        self.report.contacts.clear();
        let uploaded = start.elapsed();
        let found = loop {
            match self.attempt(goal, last)? {
                Some(found) => break found,
                None => self.grown += 1,
            }
        };
        self.report.times.boxes = uploaded.as_secs_f64() * 1e3;
        self.take(found, goal, x0, x1);
        self.report.times.total = start.elapsed().as_secs_f64() * 1e3;
        Ok(())
    }

    /// Runs a frame; `None` if a list was too short and has been replaced. `expected`: contacts that are read back at once.
    fn attempt(&mut self, goal: Goal, expected: u32) -> Result<Option<Found>, Error> {
        let Self { device, buffers, bench, readback, .. } = self;
        let params = frame_params(buffers, &self.options, &self.mesh);
        let heads: Vec<List> = buffers.lists().cloned().collect();
        let guess = (expected + expected / 4 + 256).min(buffers.contacts.room());
        let mut sizes = vec![4];
        sizes.extend(heads.iter().map(|_| HEADER_BYTES));
        sizes.push(buffers.contacts.bytes(guess));
        let parts = readback.plan(device, &sizes)?;
        let wide = device.info().wide;
        let stages = submit(device, bench, |recorder| {
            buffers.frame(recorder, &params, goal, wide);
            recorder.stage("read back");
            readback.copy(recorder, parts[0], &buffers.earliest);
            for (part, list) in parts[1..].iter().zip(&heads) {
                readback.copy(recorder, *part, list.buffer());
            }
            if goal == Goal::Contacts {
                readback.copy(recorder, parts[parts.len() - 1], buffers.contacts.buffer());
            }
        })?;
        let read = readback.read(device, &parts)?;
        self.stages = bench.times(&stages)?;
        let word = |bytes: &[u8], i: usize| bytes[4 * i..4 * i + 4].iter().rev().fold(0, |w, &b| w << 8 | b as u32);
        let wanted: Vec<u32> = read[1..=heads.len()].iter().map(|h| word(h, 0)).collect();
        let mut grown = false;
        for (list, &wanted) in buffers.lists_mut().zip(&wanted) {
            grown |= list.grow(device, wanted)?;
        }
        // What is left open is written without looking at the room: there must be as much as for what is decided.
        for kind in [0, 1] {
            buffers.undecided[kind].grow(device, buffers.survivors[kind].room())?;
        }
        if grown {
            bench.forget();
            return Ok(None);
        }
        // The lists in the order of `Buffers::lists`: five that a frame ends with, then those of the descent.
        let [c0, c1, s0, s1, u0, u1, n_contacts] = wanted[..7] else { return Ok(None) };
        let mut found = Found { earliest: word(&read[0], 0), ..Found::default() };
        found.filtered = PerKind { vf: s0 as u64, ee: s1 as u64 };
        found.candidates = if goal == Goal::Candidates {
            PerKind { vf: c0 as u64, ee: c1 as u64 }
        } else {
            PerKind { vf: word(&read[3], 1) as u64, ee: word(&read[4], 1) as u64 }
        };
        let mut contacts = read.into_iter().next_back().unwrap_or_default();
        let open = !wide && u0 + u1 > 0;
        if goal == Goal::Contacts && n_contacts > guess || open {
            let sizes = [buffers.contacts.bytes(n_contacts), buffers.undecided[0].bytes(u0), buffers.undecided[1].bytes(u1)];
            let parts = readback.plan(device, &sizes)?;
            submit(device, bench, |recorder| {
                for (part, list) in parts.iter().zip([&buffers.contacts, &buffers.undecided[0], &buffers.undecided[1]]) {
                    readback.copy(recorder, *part, list.buffer());
                }
            })?;
            let mut read = readback.read(device, &parts)?.into_iter();
            contacts = read.next().unwrap_or_default();
            found.open = [0, 1].map(|_| read.next().map(|b| bytemuck::pod_collect_to_vec(&b[HEADER_BYTES as usize..])).unwrap_or_default());
        }
        if goal == Goal::Contacts {
            let words: Vec<u32> = bytemuck::pod_collect_to_vec(&contacts);
            let entries = &words[LIST_HEADER..LIST_HEADER + n_contacts as usize * size_of::<Touch>() / 4];
            found.touches = bytemuck::cast_slice(entries).to_vec();
        }
        Ok(Some(found))
    }

    /// Decides what the device left open, and makes the report.
    fn take<T: Real>(&mut self, found: Found, goal: Goal, x0: &[[T; 3]], x1: &[[T; 3]]) {
        let report = &mut self.report;
        report.candidates = found.candidates;
        report.filtered = found.filtered;
        let contacts = &mut report.contacts;
        contacts.extend(found.touches.iter().map(contact));
        for (kind, open) in [Kind::VertexFace, Kind::EdgeEdge].into_iter().zip(&found.open) {
            tail::decide(&self.mesh, kind, open, x0, x1, self.options.min_distance, contacts);
        }
        report.toi = contacts.iter().map(|c| c.toi).reduce(f64::min);
        if goal == Goal::Earliest {
            // Contacts that the device counted are not in the list; their earliest time is.
            let device = (found.earliest != decide::NEVER).then(|| f32::from_bits(found.earliest) as f64);
            report.toi = report.toi.into_iter().chain(device).reduce(f64::min);
            contacts.clear();
        }
        report.undecided = contacts.iter().filter(|c| c.state == State::Undecided).count() as u64;
        tail::sort(contacts, &self.mesh);
    }
}

/// What a frame gave.
#[derive(Clone, Debug, Default)]
struct Found {
    earliest: u32,
    candidates: PerKind,
    filtered: PerKind,
    open: [Vec<Pair>; 2],
    touches: Vec<Touch>,
}

fn contact(touch: &Touch) -> Contact {
    Contact {
        kind: if touch.kind == 0 { Kind::VertexFace } else { Kind::EdgeEdge },
        state: if touch.state == 0 { State::Hit } else { State::Undecided },
        a: touch.a,
        b: touch.b,
        toi: ccd_core::layout::join(touch.toi),
    }
}

/// Records with `work`, submits, and returns the stages.
pub(crate) fn submit(device: &Device, bench: &mut Bench, work: impl FnOnce(&mut Recorder)) -> Result<Vec<&'static str>, Error> {
    device.guarded("a frame", 0, || {
        let mut encoder = device.wgpu().create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("ccd") });
        let mut recorder = bench.record(&mut encoder);
        work(&mut recorder);
        let stages = recorder.finish()?;
        device.queue().submit([encoder.finish()]);
        Ok(stages)
    })?
}

/// Parameters that all kernels of a frame share.
fn frame_params(buffers: &Buffers, options: &Options, mesh: &Mesh) -> Params {
    let mut params = buffers.tree.params();
    params.flags |= Params::FLAG_TOPOLOGY;
    buffers.positions.params(&mut params, options.min_distance);
    if let Some(bodies) = &options.bodies {
        params.flags |= Params::FLAG_BODIES;
        // A body against itself is wanted if it is wanted of any.
        let wanted = (0..mesh.n_vertices() as u32).map(|v| bodies.body(v)).any(|b| !bodies.fixed(b) && bodies.wants(b, b));
        params.flags |= if wanted { Params::FLAG_SELF_CONTACT } else { 0 };
    }
    params
}

impl Buffers {
    fn new(device: &Device, mesh: &Mesh, options: &Options) -> Result<Self, Error> {
        let count = [mesh.n_vertices(), mesh.edges().len(), mesh.faces().len()].map(|n| n as u32);
        let fixed = |what, bytes: &[u8]| -> Result<wgpu::Buffer, Error> {
            let buffer = device.buffer(what, bytes.len() as u64, U::STORAGE | U::COPY_SRC | U::COPY_DST)?;
            device.queue().write_buffer(&buffer, 0, bytes);
            Ok(buffer)
        };
        let bodies: Vec<u32> = match &options.bodies {
            Some(b) => (0..count[0]).map(|v| b.body(v) << 1 | b.fixed(b.body(v)) as u32).collect(),
            None => Vec::new(),
        };
        let list = |what, words, room: u32| List::new(device, what, words, room.max(1024));
        let features = count[0] + count[1] + count[2];
        Ok(Self {
            tree: Tree::new(device, count)?,
            positions: Positions::new(device, mesh.n_vertices())?,
            shortened: device.buffer("paths", count[0] as u64 * size_of::<Path>() as u64, U::STORAGE)?,
            edges: fixed("edges", bytemuck::cast_slice(mesh.edges()))?,
            faces: fixed("faces", bytemuck::cast_slice(mesh.faces()))?,
            bodies: fixed("bodies", bytemuck::cast_slice(&bodies))?,
            survivors: [list("filtered vertex-face pairs", 2, features / 2)?, list("filtered edge-edge pairs", 2, features)?],
            undecided: [list("undecided vertex-face pairs", 2, features / 2)?, list("undecided edge-edge pairs", 2, features)?],
            contacts: list("contacts", (size_of::<Touch>() / 4) as u32, features / 2)?,
            candidates: [list("vertex-face candidates", 2, 0)?, list("edge-edge candidates", 2, 0)?],
            earliest: fixed("time of impact", &[0; 4])?,
            never: fixed("no time of impact", &[0xff; 16])?,
        })
    }

    /// All lists: those that a frame ends with in the order that `Session::attempt` reads, then those of the descent.
    fn lists(&self) -> impl Iterator<Item = &List> {
        let ends = self.candidates.iter().chain(&self.survivors).chain(&self.undecided).chain([&self.contacts]);
        ends.chain(self.tree.lists())
    }

    fn lists_mut(&mut self) -> impl Iterator<Item = &mut List> {
        let ends = self.candidates.iter_mut().chain(&mut self.survivors).chain(&mut self.undecided).chain([&mut self.contacts]);
        ends.chain(self.tree.pairs.iter_mut().flatten())
    }

    /// Everything from positions to results.
    fn frame(&self, recorder: &mut Recorder, params: &Params, goal: Goal, wide: bool) {
        self.clear(recorder);
        recorder.copy(&self.never, 0, &self.earliest, 0, 4);
        self.tree.clear_bounds(recorder);
        recorder.stage("boxes");
        self.sweep(recorder, params, &self.positions.paths, self.positions.boxes_uploaded());
        self.tree.sort(recorder, params, params.count[0]);
        recorder.stage("build");
        self.tree.fit(recorder, params, &self.edges, &self.faces);
        match goal {
            Goal::Candidates => self.pairs(recorder, params, |recorder, p| self.list(recorder, p)),
            Goal::Contacts => {
                let p = Params { flags: params.flags | Params::FLAG_KEEP, ..*params };
                self.contacts(recorder, &p, &self.positions.paths, 1, wide);
            }
            Goal::Earliest => {
                // A part of the block pairs first; what it finds bounds the time that matters, and shorter paths have smaller boxes.
                self.contacts(recorder, params, &self.positions.paths, SAMPLE, wide);
                let error = params.path_error + self.positions.reach * (16.0 * f32::UNIT) + f32::MIN_NORMAL;
                let cut = Params { path_error: error, margin: (params.margin + error).next_up(), flags: params.flags & !Params::FLAG_CONFIRM, ..*params };
                recorder.stage("shorten");
                recorder.dispatch(Id::Shorten, &cut, &[&self.positions.paths, &self.earliest, &self.shortened], cut.count[0].div_ceil(256));
                self.clear(recorder);
                self.sweep(recorder, &cut, &self.shortened, false);
                self.tree.fit(recorder, &cut, &self.edges, &self.faces);
                self.contacts(recorder, &cut, &self.shortened, 1, wide);
            }
        }
    }

    fn clear(&self, recorder: &mut Recorder) {
        for list in self.lists() {
            recorder.clear(list.buffer(), HEADER_BYTES);
        }
    }

    fn sweep(&self, recorder: &mut Recorder, params: &Params, paths: &wgpu::Buffer, vertices_done: bool) {
        let [v, e, f] = params.count;
        if !vertices_done {
            recorder.dispatch(Id::SweepVertices, params, &[paths, &self.tree.boxes], v.div_ceil(256));
        }
        recorder.dispatch(Id::SweepEdges, params, &[&self.edges, &self.tree.boxes], e.div_ceil(256));
        recorder.dispatch(Id::SweepFaces, params, &[&self.faces, &self.tree.boxes], f.div_ceil(256));
    }

    /// Descends for both kinds, then calls `leaves` for each.
    fn pairs(&self, recorder: &mut Recorder, params: &Params, mut leaves: impl FnMut(&mut Recorder, &Params)) {
        recorder.stage("block pairs");
        for kind in [0, 1] {
            self.tree.descend(recorder, &Params { kind, ..*params });
        }
        for kind in [0, 1] {
            leaves(recorder, &Params { kind, ..*params });
        }
    }

    fn list(&self, recorder: &mut Recorder, params: &Params) {
        recorder.stage(["list vertex-face", "list edge-edge"][params.kind as usize]);
        let (tree, output) = (&self.tree, &self.candidates[params.kind as usize]);
        let input = tree.block_pairs(params.kind as usize);
        tree.each_part(params, 1, input, output.room(), 1, |p| {
            let buffers = [&tree.nodes, &tree.leaves, &self.bodies, &self.positions.keys, input.buffer(), output.buffer()];
            recorder.dispatch(Id::ListCandidates, p, &buffers, self.tree.groups.min(input.room()));
        });
    }

    /// Filters candidates of every `step`-th block pair and decides what is left.
    fn contacts(&self, recorder: &mut Recorder, params: &Params, paths: &wgpu::Buffer, step: u32, wide: bool) {
        self.pairs(recorder, params, |recorder, params| {
            let kind = params.kind as usize;
            recorder.stage(["filter vertex-face", "filter edge-edge"][kind]);
            let (tree, output) = (&self.tree, &self.survivors[kind]);
            let input = tree.block_pairs(kind);
            tree.each_part(params, 1, input, output.room(), step, |p| {
                let buffers = [&tree.nodes, &tree.leaves, &self.bodies, &self.positions.keys, paths, input.buffer(), output.buffer()];
                recorder.dispatch([Id::FilterVertexFace, Id::FilterEdgeEdge][kind], p, &buffers, self.tree.groups.min(input.room()));
            });
        });
        for kind in [0, 1] {
            recorder.stage(["decide vertex-face", "decide edge-edge"][kind]);
            let input = &self.survivors[kind];
            let elements = [&self.faces, &self.edges][kind];
            let p = Params { kind: kind as u32, room_in: input.room(), room_out: self.contacts.room(), path_error: self.positions.path_error, ..*params };
            let groups = self.tree.groups.min(input.room().div_ceil(64));
            let (paths, survivors, contacts) = (&self.positions.paths, input.buffer(), self.contacts.buffer());
            if wide {
                let buffers = [paths, &self.positions.wide, elements, survivors, contacts, &self.earliest];
                recorder.dispatch([Id::DecideVertexFaceWide, Id::DecideEdgeEdgeWide][kind], &p, &buffers, groups);
            } else {
                let buffers = [paths, elements, survivors, contacts, self.undecided[kind].buffer(), &self.earliest];
                recorder.dispatch([Id::DecideVertexFace, Id::DecideEdgeEdge][kind], &p, &buffers, groups);
            }
        }
    }
}

/// Of how many pairs of blocks one is sampled to bound the earliest time of impact.
const SAMPLE: u32 = 64;
