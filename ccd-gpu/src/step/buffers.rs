//! Everything that a session has on a device.

use super::Goal;
use super::contact_order::ContactOrder;
use super::lists::Lists;
use super::part_limits::{PartLimits, of_part};
use super::source::Source;
use super::upload::Positions;
use crate::broad_phase::pair_source::frame_of;
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use ccd_core::backend::layout::{Frame, Path, Touch};
use ccd_core::backend::rules::Rules;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use wgpu::BufferUsages as U;

/// Words of a contact.
const TOUCH_WORDS: u32 = (size_of::<Touch>() / 4) as u32;

/// Everything on the device.
pub struct Buffers {
    pub source: Source,
    pub count: [u32; 3],
    /// Most workgroups of a kernel that loops over a list.
    pub groups: u32,
    pub positions: Positions,
    /// Paths up to the earliest time of impact so far.
    pub shortened: wgpu::Buffer,
    /// Vertices of edges, then of faces.
    pub elements: wgpu::Buffer,
    /// A word a vertex, then the table of rules.
    pub bodies: wgpu::Buffer,
    /// Flags of the frame that say what kernels read of bodies.
    body_flags: u32,
    pub rules: Option<Rules>,
    /// Pairs that the filters leave, of both kinds, as in the two lists that follow.
    pub survivors: List,
    /// Of these, pairs that the first of two decisions leaves to the second.
    pub left: List,
    /// Whether the next frame looks at those.
    pub decides_twice: bool,
    /// Whether integers decide first, if they can.
    pub integers: bool,
    /// Contacts, undecided ones among them; alone where only an earliest time is wanted.
    pub contacts: List,
    /// Candidates, by kind: of a part of a step, or all that were asked for.
    pub candidates: [List; 2],
    /// How large the parts of a step are.
    pub part_limits: PartLimits,
    /// Contacts in order, where there are enough of them, and for how many the next frame does
    /// that.
    pub order: Option<ContactOrder>,
    pub to_order: u32,
    /// Whether the next frame keeps the order of boxes.
    pub keeps_order: bool,
    /// The key of the earliest time of impact.
    pub earliest: wgpu::Buffer,
    /// Of the sample by which the earliest time is bounded: candidates by kind, then pairs of nodes
    /// from which it was taken.
    pub sample: wgpu::Buffer,
    pub never: wgpu::Buffer,
}

impl Buffers {
    /// For this mesh, with the buffers of another as far as they are large enough. Those may be
    /// used again, if this fails, after [`Buffers::write_mesh`]: nothing else that frames read of
    /// them is written before all is there.
    pub fn new(
        device: &Device,
        mesh: &Mesh,
        options: &Options,
        old: Option<&Self>,
    ) -> Result<Self, Error> {
        let count = [mesh.n_vertices(), mesh.edges().len(), mesh.faces().len()].map(|n| n as u32);
        let usage = U::STORAGE | U::COPY_SRC | U::COPY_DST;
        let capacity = |field: fn(&Self) -> &wgpu::Buffer, what, bytes: usize| {
            device.buffer_or(old.map(field), what, bytes as u64, usage)
        };
        let rules = options.bodies.as_ref().map(Rules::new).transpose()?;
        let (bodies, body_flags) = bodies_of(device, rules.as_ref())?;
        let list = |field: fn(&Self) -> &List, what, words, capacity: u32| {
            List::reusing(device, old.map(field), what, words, capacity.max(1024))
        };
        let features = count[0] + count[1] + count[2];
        let pairs = features.saturating_add(features / 2);
        let old_positions = old.map(|old| &old.positions);
        let new = Self {
            count,
            groups: device.groups(),
            positions: Positions::new(device, mesh.n_vertices(), old_positions)?,
            shortened: device.buffer_or(
                old.map(|old| &old.shortened),
                "paths",
                count[0] as u64 * size_of::<Path>() as u64,
                U::STORAGE,
            )?,
            elements: capacity(
                |old| &old.elements,
                "edges and faces",
                size_of_val(mesh.edges()) + size_of_val(mesh.faces()),
            )?,
            bodies,
            body_flags,
            survivors: list(|old| &old.survivors, "filtered pairs", 2, pairs)?,
            left: list(|old| &old.left, "pairs left by the first decision", 2, pairs)?,
            decides_twice: true,
            integers: device.info().integers,
            contacts: list(|old| &old.contacts, "contacts", TOUCH_WORDS, features / 2)?,
            candidates: [
                list(|old| &old.candidates[0], "vertex-face candidates", 2, of_part(8, count[2]))?,
                list(|old| &old.candidates[1], "edge-edge candidates", 2, of_part(12, count[1]))?,
            ],
            part_limits: PartLimits::default(),
            order: old.and_then(|old| old.order.clone()),
            to_order: 0,
            keeps_order: false,
            earliest: capacity(|old| &old.earliest, "time of impact", 4)?,
            sample: capacity(|old| &old.sample, "numbers of a sample", 16)?,
            never: capacity(|old| &old.never, "no time of impact", 16)?,
            source: {
                let old = old.map(|old| &old.source);
                Source::new(device, mesh, options, (rules.as_ref(), count), old)?
            },
            rules,
        };
        device.write("numbers of a sample", &new.sample, 0, &[0; 16])?;
        device.write("no time of impact", &new.never, 0, &[0xff; 16])?;
        new.write_mesh(device, mesh)?;
        Ok(new)
    }

    /// Sends edges and faces. If that fails, those of another mesh in the same buffers must be sent
    /// again.
    pub fn write_mesh(&self, device: &Device, mesh: &Mesh) -> Result<(), Error> {
        let (edges, faces) = (mesh.edges(), mesh.faces());
        device.write("edges", &self.elements, 0, bytemuck::cast_slice(edges))?;
        let behind = size_of_val(edges) as u64;
        device.write("faces", &self.elements, behind, bytemuck::cast_slice(faces))
    }

    /// Takes the bodies of these options; if that fails, all is as before.
    pub fn set_bodies(
        &mut self,
        device: &Device,
        mesh: &Mesh,
        options: &Options,
    ) -> Result<(), Error> {
        let rules = options.bodies.as_ref().map(Rules::new).transpose()?;
        let (bodies, body_flags) = bodies_of(device, rules.as_ref())?;
        self.source.set_bodies(device, mesh, options, rules.as_ref())?;
        (self.bodies, self.body_flags, self.rules) = (bodies, body_flags, rules);
        Ok(())
    }

    /// Vertices, edges and faces together.
    pub fn n_boxes(&self) -> u32 {
        self.count.iter().sum()
    }

    /// All lists.
    pub fn lists(&self) -> Lists<&List> {
        Lists {
            candidates: self.candidates.each_ref(),
            survivors: &self.survivors,
            left: &self.left,
            contacts: &self.contacts,
            source: self.source.lists(),
        }
    }

    /// All lists, to be replaced by larger ones.
    pub fn lists_mut(&mut self) -> Lists<&mut List> {
        Lists {
            candidates: self.candidates.each_mut(),
            survivors: &mut self.survivors,
            left: &mut self.left,
            contacts: &mut self.contacts,
            source: self.source.lists_mut(),
        }
    }

    /// Which lists a frame uses. What is not used is neither cleared nor read: each costs as much
    /// as a small kernel.
    pub fn used(&self, goal: Goal) -> Lists<bool> {
        let filters = goal != Goal::Candidates;
        Lists {
            candidates: [true; 2],
            survivors: filters,
            left: filters && self.decides_twice,
            contacts: filters,
            source: vec![true; self.source.lists().len()],
        }
    }

    /// What a frame says to all kernels. `window`: the times that matter.
    pub fn describe(&self, options: &Options, window: [f64; 2]) -> Frame {
        let mut frame = frame_of(self.count);
        frame.flags |= self.body_flags;
        self.positions.describe(&mut frame, options.min_distance);
        frame.searching(&options.search(window))
    }
}

/// What kernels read of bodies, and the flags that say so.
fn bodies_of(device: &Device, rules: Option<&Rules>) -> Result<(wgpu::Buffer, u32), Error> {
    let (words, table) = rules.map_or((&[][..], &[][..]), |rules| (rules.words(), rules.table()));
    let buffer = device.sent("bodies", &[words, table].concat())?;
    let flag = |is: fn(&Rules) -> bool, flag| if rules.is_some_and(is) { flag } else { 0 };
    let of_table = flag(Rules::has_table, Frame::FLAG_RULES);
    let still = flag(|rules| !rules.still().is_empty(), Frame::FLAG_STILL);
    Ok((buffer, flag(|_| true, Frame::FLAG_BODIES) | of_table | still))
}
