//! Triangles first: any source lists pairs of triangles that overlap, and kernels expand these into
//! the pairs of features that they represent, lists like those of every other source.
//!
//! What is in them are candidates but for the rounding of boxes: no common vertex, bodies that are
//! wanted, boxes of their own that overlap. Regions that do not touch themselves are certified on
//! the host, where positions are as they were given; a word a triangle goes to the device.

use crate::bind;
use crate::broad_phase::block_bvh::DISPATCH_LIMIT;
use crate::broad_phase::method;
use crate::broad_phase::pair_source::{PairSource, Search, boxes, frame_of};
use crate::broad_phase::scheduled::{Scheduled, kinds_of};
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::{Header, List, parts};
use crate::readback::word;
use crate::recorder::Recorder;
use crate::threads;
use ccd_core::backend::kernel::Id;
use ccd_core::backend::layout::{Dispatch, Expansion, Frame, Pair, Params, Plain, Triangle};
use ccd_core::backend::rules::Rules;
use ccd_core::backend::triangle_pairs::feature_pairs::{COUNT_STRIDE, N_COUNTS};
use ccd_core::backend::triangle_pairs::free_regions::{FreeRegions, NONE};
use ccd_core::backend::triangle_pairs::near_tests::NearTests;
use ccd_core::backend::triangle_pairs::orphans::OrphanSets;
use ccd_core::backend::triangle_pairs::representatives::Triangles;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use ccd_core::model::pipeline::TriangleOptions;
use ccd_core::model::precision::Given;
use ccd_core::model::report::TriangleCounts;
use wgpu::BufferUsages as U;

/// Bytes of all counts.
pub const COUNT_BYTES: u64 = 4 * (N_COUNTS * COUNT_STRIDE) as u64;

/// A source of pairs of features, by way of triangles.
pub struct TrianglePairs {
    /// Boxes of all features.
    boxes: wgpu::Buffer,
    /// Finds pairs of triangles: one set of boxes.
    source: Box<dyn PairSource>,
    /// The frame of that source.
    frame: Frame,
    pairs: List,
    inputs: ExpansionInputs,
    /// Whether neighbours have tests of their own.
    orphans: bool,
    regions: Option<FreeRegions>,
    counts: wgpu::Buffer,
    groups: u32,
}

/// Inputs of the kernels that expand triangles, by the rules of bodies.
struct ExpansionInputs {
    triangles: wgpu::Buffer,
    /// Those of neighbours, and how many.
    tests: wgpu::Buffer,
    n_tests: u32,
    args: Expansion,
    /// The certified region of each triangle, then the table of rules.
    of_triangle: wgpu::Buffer,
}

impl ExpansionInputs {
    fn new(
        device: &Device,
        mesh: &Mesh,
        options: &Options,
        orphans: bool,
        (rules, has_regions): (Option<&Rules>, bool),
    ) -> Result<Self, Error> {
        let triangles = Triangles::new(mesh);
        let n = triangles.len() as u32;
        let body = |t: u32| rules.map_or(0, |rules| rules.word(triangles.corners(t)[0]));
        let records: Vec<Triangle> = (0..n).map(|t| triangles.record(t, body(t))).collect();
        let near = orphans.then(|| near_tests(mesh, options, &triangles)).flatten();
        // Where the list is too long for the device, neighbours are tested like all others.
        let near = match near {
            None => None,
            Some(near) => match device.sent("tests of neighbours", &near.tests) {
                Ok(buffer) => Some((near, buffer)),
                Err(e) if e.is_of_memory() => None,
                Err(e) => return Err(e),
            },
        };
        let mut args = Expansion::default();
        let (mut n_tests, mut tests) = (0, None);
        if let Some((near, buffer)) = near {
            args.flags |= Expansion::FLAG_ORPHANS;
            (args.n_vf, args.orphans) = (near.n_vf, near.orphans);
            (n_tests, tests) = (near.tests.len() as u32, Some(buffer));
        }
        let mut words = Vec::new();
        if has_regions {
            args.flags |= Expansion::FLAG_REGIONS;
            words.resize(n as usize, NONE);
        }
        args.rules = words.len() as u32;
        words.extend(rules.map_or(&[][..], Rules::table));
        Ok(Self {
            triangles: device.sent("triangles", &records)?,
            tests: tests.map_or_else(|| device.sent::<u32>("no tests of neighbours", &[]), Ok)?,
            n_tests,
            args,
            of_triangle: device.sent("free regions and rules", &words)?,
        })
    }
}

impl TrianglePairs {
    /// Takes other rules.
    pub fn set_bodies(
        &mut self,
        device: &Device,
        mesh: &Mesh,
        options: &Options,
        rules: Option<&Rules>,
    ) -> Result<(), Error> {
        let regions = self.regions.is_some();
        self.inputs = ExpansionInputs::new(device, mesh, options, self.orphans, (rules, regions))?;
        Ok(())
    }

    /// For a mesh with these numbers of vertices, edges and faces.
    pub fn new(
        device: &Device,
        mesh: &Mesh,
        options: &Options,
        args: TriangleOptions,
        (rules, count): (Option<&Rules>, [u32; 3]),
    ) -> Result<Self, Error> {
        let triangles = Triangles::new(mesh);
        let n = triangles.len();
        let limit = ccd_core::Error::MAX_ELEMENTS;
        if n as u64 > limit {
            let (element, count) = ("triangles", n as u64);
            return Err(ccd_core::Error::TooMany { element, count, limit }.into());
        }
        let n = n as u32;
        let frame = frame_of([0, n, 0]);
        let free_regions = args.free_regions && options.min_distance == 0.0;
        let regions = free_regions.then(|| FreeRegions::new(mesh, &triangles));
        let inputs =
            ExpansionInputs::new(device, mesh, options, args.orphans, (rules, regions.is_some()))?;
        // A triangle overlaps some tens of others on real scenes; a list that is too short grows.
        let capacity = n.saturating_mul(16).max(4096);
        Ok(Self {
            boxes: boxes(device, count, None)?,
            source: method::source(device, options.broad_phase, options.scheduling, frame.count)?,
            frame,
            pairs: List::guessed(device, "overlapping triangles", 2, capacity)?,
            inputs,
            orphans: args.orphans,
            regions,
            counts: device.buffer(
                "counts of triangles",
                COUNT_BYTES,
                U::STORAGE | U::COPY_DST | U::COPY_SRC,
            )?,
            groups: device.groups(),
        })
    }

    /// Whether what is found depends on certificates of the host.
    pub fn certifies(&self) -> bool {
        self.regions.is_some()
    }

    /// Certifies regions for a step by all threads of the host, and sends them.
    pub fn certify(&mut self, device: &Device, mesh: &Mesh, given: Given) -> Result<(), Error> {
        let Some(regions) = &mut self.regions else { return Ok(()) };
        regions.certify(mesh, given, |roots, certify| {
            threads::each(roots.iter_mut(), certify);
        });
        let words = bytemuck::cast_slice(regions.of_face());
        device.write("free regions", &self.inputs.of_triangle, 0, words)
    }

    /// What was counted, [`COUNT_BYTES`] bytes.
    pub fn counts(&self) -> &wgpu::Buffer {
        &self.counts
    }

    /// Calls `run` with the parameters of each dispatch over `n` items, and its workgroups.
    fn each_part(
        &self,
        n: u32,
        search: &Search,
        threads: u32,
        mut run: impl FnMut(&Params<Expansion>, u32),
    ) {
        let [vf, ee] = search.pairs;
        let args = Expansion { capacity_ee: ee.capacity(), ..self.inputs.args };
        for dispatch in parts(n, DISPATCH_LIMIT, vf.capacity()) {
            let groups = dispatch.n.div_ceil(threads).min(self.groups);
            run(&Params { frame: *search.frame, dispatch, args }, groups);
        }
    }
}

/// The numbers of a step, from bytes that were read.
pub fn read_counts(bytes: &[u8]) -> TriangleCounts {
    let at = |k: usize| {
        let first = k * COUNT_STRIDE;
        (word(bytes, first + 2) as u64) << 32 | word(bytes, first) as u64
    };
    let mut counts = TriangleCounts::default();
    (counts.pairs, counts.adjacent, counts.free) = (at(0), at(1), at(2));
    (counts.represented, counts.orphans) = (at(3), at(4));
    counts
}

/// The tests of neighbours, if there are not too many.
fn near_tests(mesh: &Mesh, options: &Options, triangles: &Triangles) -> Option<NearTests> {
    let wanted = |pair: Pair| {
        let [a, b] = [pair.a, pair.b].map(|t| triangles.corners(t)[0]);
        options.bodies.as_ref().is_none_or(|bodies| bodies.wants(a, b))
    };
    let sets = OrphanSets::new(mesh, triangles)?;
    NearTests::new(&sets, triangles, wanted)
}

impl PairSource for TrianglePairs {
    fn boxes(&self) -> &wgpu::Buffer {
        &self.boxes
    }

    fn clear(&self, recorder: &mut Recorder) {
        self.source.clear(recorder);
        recorder.clear(&self.counts, COUNT_BYTES);
    }

    fn find(&self, recorder: &mut Recorder, search: &Search) {
        let Self { boxes, source, frame, inputs, counts, .. } = self;
        let ExpansionInputs { triangles, tests, .. } = inputs;
        let (n, swept, regions) = (frame.count[1], source.boxes(), &self.inputs.of_triangle);
        let dispatch = Dispatch { n, ..Dispatch::default() };
        let p = Params { frame: *search.frame, dispatch, args: Plain::default() };
        recorder.each(&bind::SweepTriangles { triangles, boxes, swept }, &p, n);
        let kinds: Vec<u32> = kinds_of(frame.count).collect();
        let pairs = [&self.pairs; 2];
        let keeps_order = search.keeps_order;
        source.find(recorder, &Search { frame, kinds: &kinds, n_bounding: n, pairs, keeps_order });
        recorder.stage("expand");
        let (input, [vf, ee]) = (self.pairs.buffer(), search.pairs.map(List::buffer));
        let kernel = bind::ExpandTriangles { triangles, regions, boxes, input, vf, ee, counts };
        let (n, threads) = (self.pairs.capacity(), Id::ExpandTriangles.threads());
        self.each_part(n, search, threads, |p, groups| recorder.dispatch(&kernel, p, groups));
        recorder.detail("neighbours");
        let kernel = bind::NearTests { tests, regions, swept, boxes, vf, ee, counts };
        let (n, threads) = (inputs.n_tests, Id::NearTests.threads());
        self.each_part(n, search, threads, |p, groups| recorder.dispatch(&kernel, p, groups));
    }

    fn lists(&self) -> Vec<&List> {
        self.source.lists().into_iter().chain([&self.pairs]).collect()
    }

    fn lists_mut(&mut self) -> Vec<&mut List> {
        self.source.lists_mut().into_iter().chain([&mut self.pairs]).collect()
    }

    fn scheduled(&self) -> Option<&Scheduled> {
        self.source.scheduled()
    }

    fn settle(
        &mut self,
        device: &Device,
        counted: &[Vec<u32>],
        complete: bool,
    ) -> Result<bool, Error> {
        self.source.settle(device, counted, complete)
    }

    fn work(&self, headers: &[Header]) -> Option<u64> {
        self.source.work(headers)
    }
}
