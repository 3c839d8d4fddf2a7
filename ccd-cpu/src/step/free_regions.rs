//! Regions of a mesh that certainly do not touch themselves during the step at hand, the largest
//! first: pairs of triangles in one of them are skipped.
//!
//! Of a region that is certified nothing inside needs to be looked at; of one that is not, its
//! parts are. Which regions there are is found once per mesh
//! ([`ccd_core::triangle_pairs::patches`]), what they are certified by is said in
//! [`ccd_core::triangle_pairs::normal_cone`].

use crate::broad_phase::leaf_boxes::LeafBoxes;
use crate::simd::WIDTH;
use crate::step::candidates::Given;
use crate::threads::Threads;
use ccd_core::math::vec3::{add, sub};
use ccd_core::model::mesh::Mesh;
use ccd_core::model::precision::Precision;
use ccd_core::triangle_pairs::normal_cone::{Paths, Point, Region, View, mean_normal, reach};
use ccd_core::triangle_pairs::patches::Patches;
use ccd_core::triangle_pairs::representatives::Triangles;
use std::ops::Range;

/// Of no region.
pub const NONE: u32 = u32::MAX;

/// Regions, and which of them are certified for the current step.
#[derive(Debug)]
pub struct FreeRegions {
    patches: Patches,
    roots: Vec<Root>,
    of_face: Vec<u32>,
    /// The certified region of each leaf, or [`NONE`].
    pub of_leaf: Vec<[u32; WIDTH]>,
}

/// One of the largest regions with all in it.
#[derive(Debug)]
struct Root {
    regions: Range<usize>,
    certified: Vec<u32>,
    seen: Vec<Point>,
    normals: Vec<[f64; 3]>,
}

impl FreeRegions {
    /// The regions of a mesh, none of them certified.
    pub fn new(mesh: &Mesh, triangles: &Triangles) -> Self {
        let patches = Patches::new(mesh, triangles);
        let root = |regions: &Range<usize>| {
            let longest = regions.clone().map(|r| patches.rim(r).len()).fold(0, usize::max);
            Root {
                regions: regions.clone(),
                certified: Vec::with_capacity(regions.len()),
                seen: vec![[[0.0; 2]; 2]; longest],
                normals: Vec::with_capacity(patches.faces(regions.start).len() + 1),
            }
        };
        let roots = patches.roots().iter().map(root).collect();
        Self { patches, roots, of_face: vec![NONE; mesh.faces().len()], of_leaf: Vec::new() }
    }

    /// Certifies what can be for a step.
    pub fn certify(&mut self, threads: &Threads, mesh: &Mesh, given: Given) {
        let (patches, faces) = (&self.patches, mesh.faces());
        threads.each(&mut self.roots, &|_, root| match given {
            Precision::F32(x) => root.certify(patches, faces, &x),
            Precision::F64(x) => root.certify(patches, faces, &x),
        });
        self.of_face.fill(NONE);
        for &region in self.roots.iter().flat_map(|root| &root.certified) {
            for &face in patches.faces(region as usize) {
                self.of_face[face as usize] = region;
            }
        }
    }

    /// Puts regions in the order of leaves.
    pub fn place(&mut self, threads: &Threads, leaves: &LeafBoxes) {
        let of_face = &self.of_face;
        self.of_leaf.resize(leaves.blocks().len(), [NONE; WIDTH]);
        threads.fill(&mut self.of_leaf, |i| {
            leaves.ids(i).map(|t| of_face.get(t as usize).copied().unwrap_or(NONE))
        });
    }

    /// Whether two triangles are in one certified region.
    pub fn hold_both(&self, s: u32, t: u32) -> bool {
        let of = |t: u32| self.of_face.get(t as usize).copied().unwrap_or(NONE);
        of(s) != NONE && of(s) == of(t)
    }
}

impl Root {
    fn certify<P: Paths>(&mut self, patches: &Patches, faces: &[[u32; 3]], x: &P) {
        self.certified.clear();
        let all = patches.faces(self.regions.start);
        let Some(&first) = all.first() else { return };
        let origin = x.at(faces[first as usize][0])[0];
        let Some(reach) = reach(x, faces, all, origin) else { return };
        // Sums of normals up to each face: the normal of a region is a difference of two.
        self.normals.clear();
        let mut sum = [0.0; 3];
        self.normals.push(sum);
        for &face in all {
            sum = add(sum, mean_normal(x, faces[face as usize]));
            self.normals.push(sum);
        }
        let start = patches.patch(self.regions.start).faces.start;
        let mut at = self.regions.start;
        while at < self.regions.end {
            let (triangles, rim) = (patches.faces(at), patches.rim(at));
            let of = &patches.patch(at).faces;
            let normal = sub(self.normals[of.end - start], self.normals[of.start - start]);
            let region = Region { faces, triangles, rim };
            let free = |view| region.free(x, &view, &mut self.seen);
            if !rim.is_empty() && View::along(normal, origin, reach).is_some_and(free) {
                self.certified.push(at as u32);
                at += patches.patch(at).n_inside;
            }
            at += 1;
        }
    }
}
