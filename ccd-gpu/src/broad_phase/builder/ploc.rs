//! PLOC: clusters of boxes along the Morton curve join their nearest neighbours, all at once, round
//! after round [Meister 2018].
//!
//! ```text
//! a round     nearest      count of what is left      join, and move together
//!             of each -->  by tiles, by 256 tiles --> what is left before it: its place
//! ... until 256 clusters are left, or fewer:  one workgroup, all other rounds, in its own memory
//! ```
//!
//! Clusters, fates and the rule of late rounds are those of
//! [`ccd_core::backend::broad_phase::ploc`], so the tree is that of a CPU wherever boxes have the
//! same order. How many rounds there are is known on the device alone: there are dispatches for as
//! many as there can be ([`rounds`]), and those after the last do nothing. No workgroup waits for
//! another.
//!
//! Cost: three dispatches a round; 3 to 5 rounds halve the clusters, and there are dispatches for
//! 6, so of a million boxes about 150 do something, and 70 nothing. Per box 32 bytes of joins, 72
//! of clusters of two rounds, 4 of neighbours. When to choose it: where few visited nodes matter
//! more than the build; see docs/ALGORITHMS.md.

use super::TreeBuilder;
use super::bottom_up::Joins;
use crate::bind::{PlocCount, PlocFinish, PlocJoin, PlocLeaves, PlocNearest};
use crate::broad_phase::block_bvh::Tree;
use crate::device::Device;
use crate::error::Error;
use crate::recorder::Recorder;
use ccd_core::backend::broad_phase::ploc::{COUNTS, FEW, clusters, rounds};
use ccd_core::backend::kernel::prefix;
use ccd_core::backend::layout::{Building, Cluster, Dispatch, Frame, Params};
use wgpu::BufferUsages as U;

/// Joins among so many neighbours to either side.
pub struct Ploc {
    radius: u32,
    joins: Joins,
    /// Of an even number of rounds, and of an odd one.
    clusters: [wgpu::Buffer; 2],
    names: [wgpu::Buffer; 2],
    neighbours: wgpu::Buffer,
    counts: wgpu::Buffer,
}

impl Ploc {
    pub fn new(device: &Device, set: usize, n: u32, radius: u32) -> Result<Self, Error> {
        let words = |what, n: u64| device.buffer(what, 4 * n, U::STORAGE);
        let clusters =
            || device.buffer("clusters", n as u64 * size_of::<Cluster>() as u64, U::STORAGE);
        let names = || words("names of clusters", n as u64);
        let bytes = 4 * (COUNTS as u64 + prefix::words(n) as u64);
        Ok(Self {
            radius,
            joins: Joins::new(device, set, n)?,
            clusters: [clusters()?, clusters()?],
            names: [names()?, names()?],
            neighbours: words("neighbours of clusters", n as u64)?,
            counts: device.buffer("counts of clusters", bytes, U::STORAGE | U::COPY_DST)?,
        })
    }
}

impl TreeBuilder for Ploc {
    fn height(&self) -> u32 {
        rounds(self.joins.n, 1).max(1)
    }

    fn clear(&self, recorder: &mut Recorder) {
        recorder.clear(&self.counts, 4 * COUNTS as u64);
    }

    fn build(
        &self,
        recorder: &mut Recorder,
        frame: &Frame,
        sorted: &Tree,
        branches: &wgpu::Buffer,
    ) {
        let Self { radius, joins, neighbours, counts, .. } = self;
        let [even_clusters, odd_clusters] = &self.clusters;
        let [even_names, odd_names] = &self.names;
        let n = joins.n;
        if n < 2 {
            return;
        }
        let wide = rounds(n, FEW);
        let args = Building {
            set: joins.set as u32,
            radius: *radius,
            rounds: wide,
            ..Building::default()
        };
        let params = |first: u32, n: u32| Params {
            frame: *frame,
            dispatch: Dispatch { n, first, ..Dispatch::default() },
            args,
        };
        let kernel = PlocLeaves {
            boxes: &sorted.boxes,
            bounds: sorted.bounds(),
            order: sorted.sorted()[1],
            clusters: even_clusters,
            names: even_names,
            counts,
        };
        recorder.each(&kernel, &params(0, 0), n);
        for round in 0..wide {
            let (from, to) = (round as usize % 2, 1 - round as usize % 2);
            let (clusters_in, names) = (&self.clusters[from], &self.names[from]);
            let (most, p) = (clusters(round, n), params(round, 0));
            let kernel = PlocNearest { clusters: clusters_in, neighbours, counts };
            recorder.each(&kernel, &p, most);
            recorder.each(&PlocCount { neighbours, counts }, &p, most);
            let kernel = PlocJoin {
                neighbours,
                clusters: clusters_in,
                names,
                clusters_out: &self.clusters[to],
                names_out: &self.names[to],
                counts,
                joins: &joins.words,
            };
            recorder.each(&kernel, &p, most);
        }
        let joins_out = &joins.words;
        let kernel = PlocFinish {
            counts,
            even_clusters,
            even_names,
            odd_clusters,
            odd_names,
            joins: joins_out,
        };
        recorder.dispatch(&kernel, &params(0, rounds(n, 1)), 1);
        joins.finish(recorder, frame, sorted, true, branches);
    }
}
