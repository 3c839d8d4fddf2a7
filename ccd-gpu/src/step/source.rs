//! Where the candidates of a step come from: blocks, whose pairs are told as they are found, or any
//! other source, which lists pairs first, of features or of triangles.

use super::triangle_pairs::TrianglePairs;
use crate::broad_phase::block_bvh::{Features, Tree};
use crate::broad_phase::method;
use crate::broad_phase::pair_source::{PairSource, Search};
use crate::broad_phase::worlds::Worlds;
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use crate::recorder::Recorder;
use ccd_core::backend::kernel::Id;
use ccd_core::backend::layout::{Dispatch, Frame, Listing, Params};
use ccd_core::backend::rules::Rules;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::method::BroadPhaseMethod;
use ccd_core::model::options::Options;
use ccd_core::model::pipeline::Pipeline;
use std::ops::Range;

/// The source of a session.
pub enum Source {
    /// The default, whose overlapping pairs are never listed.
    Blocks(Box<Tree>),
    /// Any other.
    Features(Box<dyn PairSource>, Listed),
    /// Pairs of triangles, expanded into pairs of features.
    Triangles(Box<TrianglePairs>, Listed),
}

/// Pairs of features that a source lists.
pub struct Listed {
    /// Pairs of boxes that overlap, by kind.
    pub(super) pairs: [List; 2],
    groups: u32,
}

/// Listed pairs that one dispatch takes at most: some milliseconds of a small device, so that no
/// driver thinks that it hangs.
const DISPATCH_LIMIT: u32 = 1 << 22;

impl Source {
    /// The source for a mesh with these numbers of vertices, edges and faces, with buffers of
    /// another as far as they are large enough: all of blocks, and lists of every other. That one
    /// may be used again, if this fails.
    pub fn new(
        device: &Device,
        mesh: &Mesh,
        options: &Options,
        (rules, count): (Option<&Rules>, [u32; 3]),
        old: Option<&Self>,
    ) -> Result<Self, Error> {
        let old_tree = match old {
            Some(Self::Blocks(tree)) => Some(&**tree),
            _ => None,
        };
        // A feature overlaps some tens of others on real scenes; a list that is too short grows.
        let list = |what, n: u32| List::guessed(device, what, 2, n.saturating_mul(8).max(4096));
        let listed = || -> Result<Listed, Error> {
            let vf = list("overlapping vertices and faces", count[2])?;
            let pairs = [vf, list("overlapping edges", count[1])?];
            Ok(Listed { pairs, groups: device.groups() })
        };
        let (choice, scheduling) = (options.broad_phase, options.scheduling);
        let mut new = match options.pipeline {
            Pipeline::Triangles(triangles) => {
                let pairs = TrianglePairs::new(device, mesh, options, triangles, (rules, count))?;
                Self::Triangles(Box::new(pairs), listed()?)
            }
            _ if choice == BroadPhaseMethod::Blocks => {
                let mut tree = Tree::new(device, scheduling, count, true, old_tree)?;
                tree.worlds = Worlds::new(device, mesh, rules, &tree.levels)?;
                return Ok(Self::Blocks(Box::new(tree)));
            }
            _ => Self::Features(method::source(device, choice, scheduling, count)?, listed()?),
        };
        if let Some(old @ (Self::Features(..) | Self::Triangles(..))) = old {
            for (list, old) in new.lists_mut().into_iter().zip(old.lists()) {
                old.replace_shorter(list);
            }
        }
        Ok(new)
    }

    /// Takes other rules; the next frame sorts.
    pub fn set_bodies(
        &mut self,
        device: &Device,
        mesh: &Mesh,
        options: &Options,
        rules: Option<&Rules>,
    ) -> Result<(), Error> {
        match self {
            Self::Blocks(tree) => tree.worlds = Worlds::new(device, mesh, rules, &tree.levels)?,
            Self::Triangles(triangles, _) => {
                triangles.set_bodies(device, mesh, options, rules)?;
            }
            Self::Features(..) => {}
        }
        Ok(())
    }

    /// What finds overlapping boxes.
    pub fn finder(&self) -> &dyn PairSource {
        match self {
            Self::Blocks(tree) => &**tree,
            Self::Features(source, _) => &**source,
            Self::Triangles(source, _) => &**source,
        }
    }

    /// The same, for [`PairSource::settle`].
    pub fn finder_mut(&mut self) -> &mut dyn PairSource {
        match self {
            Self::Blocks(tree) => &mut **tree,
            Self::Features(source, _) => &mut **source,
            Self::Triangles(source, _) => &mut **source,
        }
    }

    /// What pairs of triangles are expanded by, if they are what is looked for.
    pub fn triangles(&self) -> Option<&TrianglePairs> {
        match self {
            Self::Triangles(triangles, _) => Some(triangles),
            _ => None,
        }
    }

    /// The same, for [`TrianglePairs::certify`].
    pub fn triangles_mut(&mut self) -> Option<&mut TrianglePairs> {
        match self {
            Self::Triangles(triangles, _) => Some(triangles),
            _ => None,
        }
    }

    /// Whether a part of the pairs can be filtered before all others.
    pub fn samples(&self) -> bool {
        matches!(self, Self::Blocks(tree) if tree.scheduled().is_none())
    }

    /// All lists.
    pub fn lists(&self) -> Vec<&List> {
        let pairs = match self {
            Self::Blocks(_) => &[][..],
            Self::Features(_, listed) | Self::Triangles(_, listed) => &listed.pairs,
        };
        self.finder().lists().into_iter().chain(pairs).collect()
    }

    /// The same, to be replaced by larger ones.
    pub fn lists_mut(&mut self) -> Vec<&mut List> {
        let (lists, pairs) = match self {
            Self::Blocks(tree) => (tree.lists_mut(), &mut [][..]),
            Self::Features(source, listed) => (source.lists_mut(), &mut listed.pairs[..]),
            Self::Triangles(source, listed) => (source.lists_mut(), &mut listed.pairs[..]),
        };
        lists.into_iter().chain(pairs).collect()
    }

    /// The lists whose headers [`PairSource::work`] adds up, where a sample is taken from them.
    pub fn sampled(&self) -> Vec<&List> {
        match self {
            Self::Blocks(tree) => tree.pairs.iter().filter_map(|lists| lists.first()).collect(),
            _ => Vec::new(),
        }
    }

    /// What must be zero besides the headers of lists.
    pub fn clear(&self, recorder: &mut Recorder, keeps_order: bool) {
        match self {
            Self::Blocks(tree) => {
                tree.clear_descent(recorder);
                if !keeps_order {
                    tree.clear_bounds(recorder);
                }
            }
            _ => self.finder().clear(recorder),
        }
    }

    /// The order of boxes, as far as it is kept when they shrink.
    pub fn order(&self, recorder: &mut Recorder, frame: &Frame, elements: &wgpu::Buffer) {
        if let Self::Blocks(tree) = self {
            tree.sort(recorder, frame, frame.count[0]);
            tree.place(recorder, frame, elements);
        }
    }

    /// Whether a frame that keeps the order reads boxes of edges and faces.
    pub fn reads_elements(&self) -> bool {
        !matches!(self, Self::Blocks(_))
    }

    /// What is built over boxes. Returns what a frame then says.
    pub fn fit(&self, recorder: &mut Recorder, frame: &Frame, features: Features) -> Frame {
        match self {
            Self::Blocks(tree) => {
                recorder.stage("build");
                tree.fit(recorder, frame, features)
            }
            _ => *frame,
        }
    }

    /// Pairs of blocks, or of boxes, of both kinds.
    pub fn find(&self, recorder: &mut Recorder, frame: &Frame, keeps_order: bool) {
        match self {
            Self::Blocks(tree) => {
                recorder.stage("block pairs");
                tree.descend(recorder, frame, &[0, 1], keeps_order);
            }
            Self::Features(_, listed) | Self::Triangles(_, listed) => {
                let pairs = &listed.pairs;
                let n_bounding = frame.count[0];
                let search = Search {
                    frame,
                    kinds: &[0, 1],
                    n_bounding,
                    pairs: pairs.each_ref(),
                    keeps_order,
                };
                self.finder().find(recorder, &search);
            }
        }
    }
}

impl Listed {
    /// Calls `run` with the parameters of each dispatch over a range of the listed pairs, and its
    /// workgroups.
    pub(super) fn each_part(
        &self,
        frame: &Frame,
        kind: usize,
        range: Range<u32>,
        output: &List,
        mut run: impl FnMut(&Params<Listing>, u32),
    ) {
        let (capacity_in, capacity_out) = (self.pairs[kind].capacity(), output.capacity());
        let end = range.end.min(capacity_in);
        for first in (range.start..end).step_by(DISPATCH_LIMIT as usize) {
            let n = DISPATCH_LIMIT.min(end - first);
            let groups = n.div_ceil(Id::ListListed.threads()).min(self.groups);
            let dispatch = Dispatch { n, first, capacity_in, capacity_out };
            let args = Listing { kind: kind as u32 };
            run(&Params { frame: *frame, dispatch, args }, groups);
        }
    }
}
