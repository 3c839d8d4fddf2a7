//! Regions of a mesh that certainly do not touch themselves during the step at hand, the largest
//! first.
//!
//! Of a region that is certified nothing inside needs to be looked at; of one that is not, its
//! parts are. Which regions there are is found once per mesh ([`patches`](super::patches)), what
//! they are certified by is said in [`region_certificate`](super::region_certificate).
//!
//! Both backends certify on the CPU: from the positions as they are given, in their precision, by a
//! loop over a rim that ends at the first crossing; and a region is certified for a whole step, so
//! what is shortened afterwards needs no other certificate.

use super::patches::Patches;
use super::region_certificate::{Paths, Point, Region, View, mean_normal, reach};
use super::representatives::Triangles;
use crate::math::vec3::{add, sub};
use crate::model::mesh::Mesh;
use crate::model::precision::{Given, Precision};
use alloc::vec::Vec;
use core::ops::Range;

/// Of no region.
pub const NONE: u32 = u32::MAX;

/// Regions, and which of them are certified for the current step.
#[derive(Debug)]
pub struct FreeRegions {
    patches: Patches,
    roots: Vec<Root>,
    of_face: Vec<u32>,
}

/// One of the largest regions with all in it: a piece of work for a thread.
#[derive(Debug)]
pub struct Root {
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
                seen: alloc::vec![[[0.0; 2]; 2]; longest],
                normals: Vec::with_capacity(patches.faces(regions.start).len() + 1),
            }
        };
        let roots = patches.roots().iter().map(root).collect();
        Self { patches, roots, of_face: alloc::vec![NONE; mesh.faces().len()] }
    }

    /// Certifies what can be for a step. `each` runs what it is given once for every root, by
    /// whatever threads.
    pub fn certify(
        &mut self,
        mesh: &Mesh,
        given: Given,
        each: impl FnOnce(&mut [Root], &(dyn Fn(&mut Root) + Sync)),
    ) {
        let (patches, faces) = (&self.patches, mesh.faces());
        each(&mut self.roots, &|root| match given {
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

    /// The certified region of each face, or [`NONE`]; triangles that are no faces have none.
    pub fn of_face(&self) -> &[u32] {
        &self.of_face
    }

    /// Whether two triangles are in one certified region.
    pub fn hold_both(&self, s: u32, t: u32) -> bool {
        let region = |t: u32| self.of_face.get(t as usize).copied().unwrap_or(NONE);
        region(s) != NONE && region(s) == region(t)
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
            let range = &patches.patch(at).faces;
            let normal = sub(self.normals[range.end - start], self.normals[range.start - start]);
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
