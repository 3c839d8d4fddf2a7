//! Worlds of boxes on a device: which box and which leaf is of which, sorts that put one world
//! after the other, descents that leave out pairs of nodes without a common one.

use super::block_levels::Levels;
use crate::bind::{WorldBounds, WorldKeys};
use crate::device::Device;
use crate::error::Error;
use crate::recorder::Recorder;
use ccd_core::backend::broad_phase::{morton_key, worlds};
use ccd_core::backend::kernel::Id;
use ccd_core::backend::layout::{self, Dispatch, Frame, Params};
use ccd_core::backend::rules::Rules;
use ccd_core::model::mesh::Mesh;
use wgpu::BufferUsages as U;

/// The worlds of the boxes of a tree.
pub struct Worlds {
    /// By box, in the order of input.
    of_boxes: wgpu::Buffer,
    /// By leaf: known before any sort, because that puts one world after the other.
    pub of_leaves: wgpu::Buffer,
    bounds: wgpu::Buffer,
    bits: u32,
}

impl Worlds {
    /// Of the vertices, edges and faces of a mesh; `None` if they are of one world.
    pub fn new(
        device: &Device,
        mesh: &Mesh,
        rules: Option<&Rules>,
        levels: &Levels,
    ) -> Result<Option<Self>, Error> {
        let Some((rules, n)) = rules.and_then(|rules| Some((rules, rules.worlds()?))) else {
            return Ok(None);
        };
        let world = |&v: &u32| rules.world(v);
        let sets: [Vec<u32>; 3] = [
            (0..mesh.n_vertices() as u32).map(|v| world(&v)).collect(),
            mesh.edges().iter().map(|edge| world(&edge[0])).collect(),
            mesh.faces().iter().map(|face| world(&face[0])).collect(),
        ];
        let mut of_leaves = vec![0; levels.padded(0) as usize];
        for (set, worlds_of_set) in sets.iter().enumerate() {
            let first = (levels.slots[0][set] - levels.slots[0][0]) as usize;
            let leaves = &mut of_leaves[first..first + worlds_of_set.len()];
            leaves.copy_from_slice(worlds_of_set);
            leaves.sort_unstable();
        }
        let words = worlds::BOUND_WORDS as u64 * n as u64;
        Ok(Some(Self {
            of_boxes: device.sent("worlds of boxes", &sets.concat())?,
            of_leaves: device.sent("worlds of leaves", &of_leaves)?,
            bounds: device.buffer("bounds of worlds", 4 * words, U::STORAGE | U::COPY_DST)?,
            bits: worlds::bits(n),
        }))
    }

    /// What must be zero before [`Worlds::keys`].
    pub fn clear(&self, recorder: &mut Recorder) {
        recorder.clear(&self.bounds, self.bounds.size());
    }

    /// Keys and numbers of all boxes. Of the bounds of all boxes, those of the first `n_bounding`
    /// are enough.
    pub fn keys(
        &self,
        recorder: &mut Recorder,
        frame: &Frame,
        boxes: &wgpu::Buffer,
        n_bounding: u32,
        [keys, order]: [&wgpu::Buffer; 2],
    ) {
        let Self { of_boxes: worlds, bounds, bits, .. } = self;
        let dispatch = Dispatch { n: n_bounding, ..Dispatch::default() };
        let p = Params { frame: *frame, dispatch, args: layout::Worlds { bits: *bits } };
        let groups = n_bounding.div_ceil(Id::WorldBounds.threads() * morton_key::CHUNK as u32);
        recorder.dispatch(&WorldBounds { boxes, worlds, bounds }, &p, groups);
        recorder.each(&WorldKeys { boxes, worlds, bounds, keys, order }, &p, frame.start[3]);
    }
}
