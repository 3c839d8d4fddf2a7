//! Where the candidates of a step come from: blocks, whose pairs are filtered as they are found, or
//! any other source, which lists pairs first, of features or of triangles.

use super::triangle_pairs::TrianglePairs;
use crate::broad_phase::block_bvh::Tree;
use crate::broad_phase::method;
use crate::broad_phase::pair_source::{PairSource, Search};
use crate::broad_phase::worlds::Worlds;
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::{List, parts};
use crate::recorder::Recorder;
use ccd_core::backend::kernel::Id;
use ccd_core::backend::layout::{Decision, Frame, Params};
use ccd_core::backend::rules::Rules;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::method::BroadPhaseMethod;
use ccd_core::model::options::Options;
use ccd_core::model::pipeline::Pipeline;

/// The source of a session.
pub enum Source {
    /// The default, whose pairs are never listed.
    Blocks(Box<Tree>),
    /// Any other.
    Listed(Listed),
}

/// A source with the pairs of features that it lists.
pub struct Listed {
    finder: Finder,
    /// Pairs of boxes that overlap, by kind.
    pub(super) pairs: [List; 2],
    groups: u32,
}

/// What lists pairs of features.
enum Finder {
    Features(Box<dyn PairSource>),
    Triangles(Box<TrianglePairs>),
}

/// Listed pairs that one dispatch takes at most: some milliseconds of a small device, so that no
/// driver thinks that it hangs.
const DISPATCH_LIMIT: u32 = 1 << 22;

impl Source {
    /// Room for a mesh with these numbers of vertices, edges and faces, with buffers of another
    /// source: all of blocks, and lists of every other, as far as they are large enough. That one
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
        let choice = options.broad_phase;
        let finder = match options.pipeline {
            Pipeline::Triangles(triangles) => {
                let pairs = TrianglePairs::new(device, mesh, options, triangles, (rules, count))?;
                Finder::Triangles(Box::new(pairs))
            }
            _ if choice == BroadPhaseMethod::Blocks => {
                let mut tree = Tree::new(device, options.scheduling, count, old_tree)?;
                tree.worlds = Worlds::new(device, mesh, rules, &tree.levels)?;
                return Ok(Self::Blocks(Box::new(tree)));
            }
            _ => Finder::Features(method::source(device, choice, options.scheduling, count)?),
        };
        // A feature overlaps some tens of others on real scenes; a list that is too short grows.
        let list = |what, n: u32| List::new(device, what, 2, n.saturating_mul(8).max(4096));
        let mut new = Self::Listed(Listed {
            finder,
            pairs: [
                list("overlapping vertices and faces", count[2])?,
                list("overlapping edges", count[1])?,
            ],
            groups: device.groups(),
        });
        if let Some(old @ Self::Listed(_)) = old {
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
            Self::Listed(Listed { finder: Finder::Triangles(triangles), .. }) => {
                triangles.set_bodies(device, mesh, options, rules)?;
            }
            Self::Listed(_) => {}
        }
        Ok(())
    }

    /// What finds overlapping boxes.
    pub fn finder(&self) -> &dyn PairSource {
        match self {
            Self::Blocks(tree) => &**tree,
            Self::Listed(Listed { finder: Finder::Features(source), .. }) => &**source,
            Self::Listed(Listed { finder: Finder::Triangles(source), .. }) => &**source,
        }
    }

    /// The same, to be told how a search came out.
    pub fn finder_mut(&mut self) -> &mut dyn PairSource {
        match self {
            Self::Blocks(tree) => &mut **tree,
            Self::Listed(Listed { finder: Finder::Features(source), .. }) => &mut **source,
            Self::Listed(Listed { finder: Finder::Triangles(source), .. }) => &mut **source,
        }
    }

    /// What pairs of triangles are expanded by, if they are what is looked for.
    pub fn triangles(&self) -> Option<&TrianglePairs> {
        match self {
            Self::Listed(Listed { finder: Finder::Triangles(triangles), .. }) => Some(triangles),
            _ => None,
        }
    }

    /// The same, to be told of positions.
    pub fn triangles_mut(&mut self) -> Option<&mut TrianglePairs> {
        match self {
            Self::Listed(Listed { finder: Finder::Triangles(triangles), .. }) => Some(triangles),
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
            Self::Listed(listed) => &listed.pairs,
        };
        self.finder().lists().into_iter().chain(pairs).collect()
    }

    /// The same, to be replaced by larger ones.
    pub fn lists_mut(&mut self) -> Vec<&mut List> {
        let (lists, pairs) = match self {
            Self::Blocks(tree) => (tree.lists_mut(), &mut [][..]),
            Self::Listed(Listed { finder: Finder::Features(source), pairs, .. }) => {
                (source.lists_mut(), &mut pairs[..])
            }
            Self::Listed(Listed { finder: Finder::Triangles(source), pairs, .. }) => {
                (source.lists_mut(), &mut pairs[..])
            }
        };
        lists.into_iter().chain(pairs).collect()
    }

    /// The lists whose headers [`PairSource::work`] adds up, where a sample is taken from them.
    pub fn sampled(&self) -> Vec<&List> {
        match self {
            Self::Blocks(tree) => tree.pairs.iter().filter_map(|lists| lists.first()).collect(),
            Self::Listed(_) => Vec::new(),
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
            Self::Listed(_) => self.finder().clear(recorder),
        }
    }

    /// The order of boxes, as far as it is kept when they shrink.
    pub fn order(&self, recorder: &mut Recorder, frame: &Frame) {
        if let Self::Blocks(tree) = self {
            tree.sort(recorder, frame, frame.count[0]);
        }
    }

    /// What is built over boxes.
    pub fn fit(
        &self,
        recorder: &mut Recorder,
        frame: &Frame,
        edges: &wgpu::Buffer,
        faces: &wgpu::Buffer,
    ) {
        if let Self::Blocks(tree) = self {
            recorder.stage("build");
            tree.fit(recorder, frame, edges, faces);
        }
    }

    /// Pairs of blocks, or of boxes, of both kinds.
    pub fn find(&self, recorder: &mut Recorder, frame: &Frame, keeps_order: bool) {
        match self {
            Self::Blocks(tree) => {
                recorder.stage("block pairs");
                tree.descend(recorder, frame, &[0, 1], keeps_order);
            }
            Self::Listed(listed) => {
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
    /// Calls `run` with the parameters of each dispatch over listed pairs, and its workgroups.
    pub(super) fn each_part(
        &self,
        frame: &Frame,
        kind: usize,
        output: &List,
        mut run: impl FnMut(&Params<Decision>, u32),
    ) {
        for dispatch in parts(self.pairs[kind].capacity(), DISPATCH_LIMIT, output.capacity()) {
            let groups = dispatch.n.div_ceil(Id::FilterListed.threads()).min(self.groups);
            let args = Decision { kind: kind as u32, capacity_open: 0 };
            run(&Params { frame: *frame, dispatch, args }, groups);
        }
    }
}
