//! Free regions in the order of leaves: pairs of triangles in one of them are skipped.

use crate::broad_phase::leaf_boxes::LeafBoxes;
use crate::simd::WIDTH;
use crate::step::candidates::Given;
use crate::threads::Threads;
use ccd_core::backend::triangle_pairs::free_regions;
use ccd_core::backend::triangle_pairs::representatives::Triangles;
use ccd_core::model::mesh::Mesh;

pub use ccd_core::backend::triangle_pairs::free_regions::NONE;

/// Regions, and which of them are certified for the current step.
#[derive(Debug)]
pub struct FreeRegions {
    regions: free_regions::FreeRegions,
    /// The certified region of each leaf, or [`NONE`].
    pub of_leaf: Vec<[u32; WIDTH]>,
}

impl FreeRegions {
    /// The regions of a mesh, none of them certified.
    pub fn new(mesh: &Mesh, triangles: &Triangles) -> Self {
        let regions = free_regions::FreeRegions::new(mesh, triangles);
        Self { regions, of_leaf: Vec::new() }
    }

    /// Certifies what can be for a step.
    pub fn certify(&mut self, threads: &Threads, mesh: &Mesh, given: Given) {
        let each = |roots: &mut [_], certify: &(dyn Fn(&mut free_regions::Root) + Sync)| {
            threads.each(roots, &|_, root| certify(root));
        };
        self.regions.certify(mesh, given, each);
    }

    /// Puts regions in the order of leaves.
    pub fn place(&mut self, threads: &Threads, leaves: &LeafBoxes) {
        let of_face = self.regions.of_face();
        self.of_leaf.resize(leaves.blocks().len(), [NONE; WIDTH]);
        threads.fill(&mut self.of_leaf, |i| {
            leaves.ids(i).map(|t| of_face.get(t as usize).copied().unwrap_or(NONE))
        });
    }

    /// Whether two triangles are in one certified region.
    pub fn hold_both(&self, s: u32, t: u32) -> bool {
        self.regions.hold_both(s, t)
    }
}
