//! What a frame is on a device: all its buffers, and the dispatches from positions to results.

use crate::device::Device;
use crate::error::Error;
use crate::list::{HEADER_BYTES, List};
use crate::order::Order;
use crate::recorder::Recorder;
use crate::tree::Tree;
use crate::upload::{Boxes, Positions};
use ccd_core::Num;
use ccd_core::kernel::Id;
use ccd_core::layout::{Params, Path, Touch};
use ccd_core::report::Options;
use ccd_core::topology::{Bodies, Mesh};
use wgpu::BufferUsages as U;

/// Of how many pairs of blocks one is sampled to bound the earliest time of impact.
pub const SAMPLE: u32 = 64;

/// Everything on the device.
pub struct Buffers {
    pub tree: Tree,
    pub positions: Positions,
    /// Paths up to the earliest time of impact so far.
    pub shortened: wgpu::Buffer,
    pub edges: wgpu::Buffer,
    pub faces: wgpu::Buffer,
    pub bodies: wgpu::Buffer,
    /// What kernels are told of bodies.
    body_flags: u32,
    /// Pairs that the filters leave, by kind.
    pub survivors: [List; 2],
    /// Pairs that `f32` leaves open, by kind.
    pub undecided: [List; 2],
    pub contacts: List,
    /// Candidates, by kind; as small as possible until they are asked for.
    pub candidates: [List; 2],
    /// Contacts in order, where there are enough of them, and for how many the next frame does that.
    pub order: Option<Order>,
    pub to_order: u32,
    /// The keys of the earliest times of impact, by kind: a buffer each, so that no kind waits for the other.
    pub earliest: [wgpu::Buffer; 2],
    /// Candidates of the sample by which the earliest time is bounded, by kind.
    pub sample: wgpu::Buffer,
    pub never: wgpu::Buffer,
}

/// What a frame is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Goal {
    Contacts,
    /// With a sample first, and paths cut at what it finds.
    Earliest,
    /// In one pass over everything.
    EarliestAtOnce,
    Candidates,
}

impl Buffers {
    pub fn new(device: &Device, mesh: &Mesh, options: &Options) -> Result<Self, Error> {
        let count = [mesh.n_vertices(), mesh.edges().len(), mesh.faces().len()].map(|n| n as u32);
        let fixed = |what, bytes: &[u8]| -> Result<wgpu::Buffer, Error> {
            let buffer = device.buffer(what, bytes.len() as u64, U::STORAGE | U::COPY_SRC | U::COPY_DST)?;
            device.queue().write_buffer(&buffer, 0, bytes);
            Ok(buffer)
        };
        let (bodies, body_flags) = options.bodies.as_ref().map_or((Vec::new(), 0), |bodies| number_bodies(bodies, count[0]));
        let list = |what, words, room: u32| List::new(device, what, words, room.max(1024));
        let features = count[0] + count[1] + count[2];
        Ok(Self {
            tree: Tree::new(device, count)?,
            positions: Positions::new(device, mesh.n_vertices())?,
            shortened: device.buffer("paths", count[0] as u64 * size_of::<Path>() as u64, U::STORAGE)?,
            edges: fixed("edges", bytemuck::cast_slice(mesh.edges()))?,
            faces: fixed("faces", bytemuck::cast_slice(mesh.faces()))?,
            bodies: fixed("bodies", bytemuck::cast_slice(&bodies))?,
            body_flags,
            survivors: [list("filtered vertex-face pairs", 2, features / 2)?, list("filtered edge-edge pairs", 2, features)?],
            undecided: [list("undecided vertex-face pairs", 2, features / 2)?, list("undecided edge-edge pairs", 2, features)?],
            contacts: list("contacts", (size_of::<Touch>() / 4) as u32, features / 2)?,
            candidates: [list("vertex-face candidates", 2, 0)?, list("edge-edge candidates", 2, 0)?],
            order: None,
            to_order: 0,
            earliest: [fixed("time of impact", &[0; 4])?, fixed("time of impact", &[0; 4])?],
            sample: fixed("candidates of a sample", &[0; 8])?,
            never: fixed("no time of impact", &[0xff; 16])?,
        })
    }

    /// All lists: those that a frame ends with in the order that `Session::attempt` reads, then those of the descent.
    pub fn lists(&self) -> impl Iterator<Item = &List> {
        let ends = self.candidates.iter().chain(&self.survivors).chain(&self.undecided).chain([&self.contacts]);
        ends.chain(self.tree.lists())
    }

    pub fn lists_mut(&mut self) -> impl Iterator<Item = &mut List> {
        let ends = self.candidates.iter_mut().chain(&mut self.survivors).chain(&mut self.undecided).chain([&mut self.contacts]);
        ends.chain(self.tree.pairs.iter_mut().flatten())
    }

    /// Parameters that all kernels of a frame share.
    pub fn params(&self, options: &Options) -> Params {
        let mut params = self.tree.params();
        params.flags |= Params::FLAG_TOPOLOGY | self.body_flags;
        self.positions.params(&mut params, options.min_distance);
        params
    }

    /// Everything from positions to results.
    pub fn frame(&self, recorder: &mut Recorder, params: &Params, goal: Goal, wide: bool) {
        self.clear(recorder);
        for earliest in &self.earliest {
            recorder.copy(&self.never, 0, earliest, 0, 4);
        }
        self.tree.clear_bounds(recorder);
        recorder.stage("boxes");
        self.sweep(recorder, params, &self.positions.paths, self.positions.boxes);
        self.tree.sort(recorder, params, params.count[0]);
        recorder.stage("build");
        self.tree.fit(recorder, params, &self.edges, &self.faces);
        match goal {
            Goal::Candidates => self.pairs(recorder, params, |recorder, p| self.list(recorder, p)),
            Goal::Contacts => {
                let p = Params { flags: params.flags | Params::FLAG_KEEP, ..*params };
                self.contacts(recorder, &p, &self.positions.paths, 1, wide);
                if let Some(order) = self.order.as_ref().filter(|_| self.to_order > 0) {
                    recorder.stage("order contacts");
                    order.run(recorder, &p, &self.contacts, self.to_order);
                }
            }
            Goal::EarliestAtOnce => self.contacts(recorder, params, &self.positions.paths, 1, wide),
            Goal::Earliest => {
                // A part of the block pairs first; what it finds bounds the time that matters, and shorter paths have smaller boxes.
                self.contacts(recorder, params, &self.positions.paths, SAMPLE, wide);
                recorder.copy(self.survivors[0].buffer(), 4, &self.sample, 0, 4);
                recorder.copy(self.survivors[1].buffer(), 4, &self.sample, 4, 4);
                let error = params.path_error + self.positions.reach * (16.0 * f32::UNIT) + f32::MIN_NORMAL;
                let cut = Params {
                    path_error: error,
                    margin: (params.margin + error).next_up(),
                    flags: params.flags & !Params::FLAG_CONFIRM,
                    ..*params
                };
                self.clear(recorder);
                recorder.stage("shorten");
                let buffers = [&self.positions.paths, &self.earliest[0], &self.earliest[1], &self.shortened];
                recorder.each(Id::Shorten, &cut, &buffers, cut.count[0]);
                self.sweep(recorder, &cut, &self.shortened, Boxes::OfPaths);
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

    fn sweep(&self, recorder: &mut Recorder, params: &Params, paths: &wgpu::Buffer, of_vertices: Boxes) {
        let [v, e, f] = params.count;
        let Positions { wide, keys, .. } = &self.positions;
        match of_vertices {
            Boxes::OfPaths => recorder.each(Id::SweepVertices, params, &[paths, &self.tree.boxes], v),
            Boxes::OfPositions => recorder.each(Id::PlaceVertices, params, &[wide, paths, keys, &self.tree.boxes], v),
            Boxes::Sent => {}
        }
        recorder.each(Id::SweepEdges, params, &[&self.edges, &self.tree.boxes], e);
        recorder.each(Id::SweepFaces, params, &[&self.faces, &self.tree.boxes], f);
    }

    /// Descends for both kinds, then calls `leaves` for each.
    fn pairs(&self, recorder: &mut Recorder, params: &Params, mut leaves: impl FnMut(&mut Recorder, &Params)) {
        recorder.stage("block pairs");
        self.tree.descend(recorder, params, &[0, 1]);
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
            let p = Params {
                kind: kind as u32,
                room_in: input.room(),
                room_out: self.contacts.room(),
                n: self.undecided[kind].room(),
                path_error: self.positions.path_error,
                ..*params
            };
            let groups = self.tree.groups.min(input.room().div_ceil(64));
            // Where contacts are not kept, a list that stays as it is and that the other kind does not have, so that a device works on both at once.
            let contacts = if params.has(Params::FLAG_KEEP) { &self.contacts } else { &self.candidates[kind] }.buffer();
            let (paths, survivors, earliest) = (&self.positions.paths, input.buffer(), &self.earliest[kind]);
            if wide {
                let buffers = [paths, &self.positions.wide, elements, survivors, contacts, earliest];
                recorder.dispatch([Id::DecideVertexFaceWide, Id::DecideEdgeEdgeWide][kind], &p, &buffers, groups);
            } else {
                let buffers = [paths, elements, survivors, contacts, self.undecided[kind].buffer(), earliest];
                recorder.dispatch([Id::DecideVertexFace, Id::DecideEdgeEdge][kind], &p, &buffers, groups);
            }
        }
    }
}

/// For each of `n` vertices twice the number of its body, plus one if that is fixed; and the flags that go with that. Bodies are numbered anew, because
/// their own numbers may need all bits of a word.
fn number_bodies(bodies: &Bodies, n: u32) -> (Vec<u32>, u32) {
    let mut names: Vec<u32> = (0..n).map(|v| bodies.body(v)).collect();
    names.sort_unstable();
    names.dedup();
    // A body against itself is wanted if it is wanted of any.
    let self_contact = names.iter().any(|&b| !bodies.fixed(b) && bodies.wants(b, b));
    let number = |name: u32| names.partition_point(|&n| n < name) as u32;
    let words = (0..n).map(|v| number(bodies.body(v)) << 1 | bodies.fixed(bodies.body(v)) as u32).collect();
    (words, Params::FLAG_BODIES | if self_contact { Params::FLAG_SELF_CONTACT } else { 0 })
}
