//! Triangles in the order of the method that was chosen, eight side by side, with the boxes of the
//! features that each represents: what pairs of triangles are expanded from.
//!
//! A feature that a triangle does not test has the empty box there, which overlaps nothing, so that
//! no test asks who represents what.

use crate::broad_phase::keep;
use crate::broad_phase::leaf_boxes::{LeafBoxes, Set};
use crate::broad_phase::method::Method;
use crate::broad_phase::pair_source::PairSource;
use crate::simd::{Block, EMPTY, WIDTH, set_lane};
use crate::step::candidates::Given;
use crate::step::leaf_ends::ends;
use crate::step::leaves::{Side, feature_box};
use crate::step::selection::BlockBodies;
use crate::step::stand_ins::StandIns;
use crate::threads::Threads;
use ccd_core::backend::broad_phase::swept_box;
use ccd_core::backend::rules::Rules;
use ccd_core::backend::triangle_pairs::free_regions::{FreeRegions, NONE, Root};
use ccd_core::backend::triangle_pairs::orphans::OrphanSets;
use ccd_core::backend::triangle_pairs::representatives::Triangles;
use ccd_core::math::obb::Obb;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::pipeline::TriangleOptions;
use ccd_core::{Aabb, Error};

/// The triangles of a mesh, their leaves, and what belongs to these.
#[derive(Debug)]
pub struct TriangleLeaves {
    pub triangles: Triangles,
    /// Whether a triangle tests what others represent, too.
    pub repeats: bool,
    /// `None`: neighbours are expanded like all others.
    pub orphans: Option<OrphanSets>,
    pub stand_ins: StandIns,
    /// Pairs in one of them are skipped.
    pub regions: Option<FreeRegions>,
    /// The certified region of each leaf, or [`NONE`].
    pub region_of_leaf: Vec<[u32; WIDTH]>,
    swept: Vec<Aabb<f32>>,
    pub boxes: LeafBoxes,
    pub blocks: Vec<TriangleBlock>,
    pub bodies: BlockBodies,
    /// Boxes of tested features during the step: three corners, three sides.
    pub features: Vec<[Block; 6]>,
    /// Boxes at the start and at the end, of the positions in the table: corners, sides, the face.
    pub ends: Vec<Ends>,
    /// Oriented boxes of the triangles during the step, of the positions in the table, grown so
    /// that those of triangles in contact meet; empty by another volume.
    pub oriented: Vec<[Obb<f32>; WIDTH]>,
}

/// Features of eight triangles.
#[derive(Clone, Copy, Debug)]
pub struct TriangleBlock {
    /// The triangles; those that are faces have their ids.
    pub ids: [u32; WIDTH],
    /// Vertices.
    pub corners: [[u32; WIDTH]; 3],
    /// Edges, from corner 0 to 1, 1 to 2, 2 to 0.
    pub sides: [[u32; WIDTH]; 3],
    /// Bits of the triangles that represent each corner, then each side.
    pub represents: [u32; 6],
    /// Bits of those that test it: the same, or all that have it.
    pub tests: [u32; 6],
    /// Bits of the triangles that are faces.
    pub faces: u32,
}

impl TriangleBlock {
    const NONE: Self = Self {
        ids: [0; WIDTH],
        corners: [[0; WIDTH]; 3],
        sides: [[0; WIDTH]; 3],
        represents: [0; 6],
        tests: [0; 6],
        faces: 0,
    };

    /// The vertices of side `k` of each.
    #[inline(always)]
    pub fn side(&self, k: usize) -> [&[u32; WIDTH]; 2] {
        [&self.corners[k], &self.corners[(k + 1) % 3]]
    }
}

/// Boxes at both ends of the features of eight triangles.
#[derive(Clone, Copy, Debug)]
pub struct Ends {
    pub corners: [[Block; 2]; 3],
    pub sides: [[Block; 2]; 3],
    pub face: [Block; 2],
}

impl TriangleLeaves {
    /// The triangles of a mesh, without boxes yet.
    pub fn new(mesh: &Mesh, options: TriangleOptions, min_distance: f64) -> Self {
        let triangles = Triangles::new(mesh);
        let repeats = !options.representatives;
        let skips = options.orphans && !repeats;
        let orphans = skips.then(|| OrphanSets::new(mesh, &triangles)).flatten();
        let free_regions = options.free_regions && min_distance == 0.0;
        let regions = free_regions.then(|| FreeRegions::new(mesh, &triangles));
        Self {
            triangles,
            repeats,
            orphans,
            stand_ins: StandIns::default(),
            regions,
            region_of_leaf: Vec::new(),
            swept: Vec::new(),
            boxes: LeafBoxes::new(Set { index: 0, searched: true }),
            blocks: Vec::new(),
            bodies: BlockBodies::default(),
            features: Vec::new(),
            ends: Vec::new(),
            oriented: Vec::new(),
        }
    }

    /// The same for another mesh; buffers of leaves stay.
    pub fn set_mesh(&mut self, mesh: &Mesh, options: TriangleOptions, min_distance: f64) {
        let Self { triangles, repeats, orphans, regions, .. } =
            Self::new(mesh, options, min_distance);
        (self.triangles, self.repeats) = (triangles, repeats);
        (self.orphans, self.regions) = (orphans, regions);
    }

    /// Regions, if they are wanted and nothing is to keep a distance; or none.
    pub fn set_min_distance(&mut self, mesh: &Mesh, options: TriangleOptions, min_distance: f64) {
        let free_regions = options.free_regions && min_distance == 0.0;
        if !free_regions {
            self.regions = None;
        } else if self.regions.is_none() {
            self.regions = Some(FreeRegions::new(mesh, &self.triangles));
        }
    }

    /// Boxes of all triangles.
    pub fn sweep(&mut self, threads: &Threads, vertices: &[Aabb<f32>]) {
        let corners = self.triangles.all_corners();
        self.swept.resize(corners.len(), Aabb::EMPTY);
        threads.fill(&mut self.swept, |i| swept_box::face(i, corners, vertices));
    }

    /// A new order of leaves.
    pub fn build(
        &mut self,
        threads: &Threads,
        method: &mut Method,
        rules: Option<&Rules>,
    ) -> Result<(), Error> {
        method.order().survey(threads, &[&self.swept])?;
        let corners = self.triangles.all_corners();
        let vertex = |t: usize| corners[t][0];
        self.boxes.build_by_rules(threads, method.order(), &self.swept, rules, vertex, (0, None));
        let Self { triangles, repeats, orphans, stand_ins, boxes, blocks, bodies, .. } = self;
        if let Some(sets) = orphans {
            stand_ins.order(sets, boxes);
        }
        blocks.resize(boxes.len().div_ceil(WIDTH), TriangleBlock::NONE);
        threads.fill(blocks, |i| block(triangles, *repeats, boxes, i));
        bodies.fill(rules, blocks.iter().map(|block| &block.corners[0]));
        Ok(())
    }

    /// The same order for boxes that moved; returns how much looser the source has become.
    pub fn refit(&mut self, threads: &Threads, method: &mut Method) -> f64 {
        self.boxes.refit(threads, method.order(), &self.swept)
    }

    /// Certifies regions for a whole step.
    pub fn certify(&mut self, threads: &Threads, mesh: &Mesh, given: Given) {
        if let Some(regions) = &mut self.regions {
            regions.certify(mesh, given, |roots: &mut [Root], certify| {
                threads.each(roots, &|_, root| certify(root));
            });
        }
    }

    /// Boxes of features, during the step and at its ends, and regions.
    pub fn place(&mut self, threads: &Threads, of_vertices: &[Aabb<f32>], table: &[[f32; WIDTH]]) {
        let (blocks, boxes) = (&self.blocks, &self.boxes);
        if let Some(regions) = &self.regions {
            let of_face = regions.of_face();
            self.region_of_leaf.resize(blocks.len(), [NONE; WIDTH]);
            threads.fill(&mut self.region_of_leaf, |i| {
                boxes.ids(i).map(|t| of_face.get(t as usize).copied().unwrap_or(NONE))
            });
        }
        self.features.resize(blocks.len(), [EMPTY; 6]);
        threads.fill(&mut self.features, |i| features(&blocks[i], of_vertices));
        let none = Ends { corners: [[EMPTY; 2]; 3], sides: [[EMPTY; 2]; 3], face: [EMPTY; 2] };
        self.ends.resize(blocks.len(), none);
        threads.fill(&mut self.ends, |i| {
            let [a, b, c] = blocks[i].corners;
            Ends {
                corners: [ends(table, &[a]), ends(table, &[b]), ends(table, &[c])],
                sides: [ends(table, &[a, b]), ends(table, &[b, c]), ends(table, &[c, a])],
                face: ends(table, &[a, b, c]),
            }
        });
    }

    /// Oriented boxes during the step, grown by `reach`; or none.
    pub fn orient(&mut self, threads: &Threads, table: &[[f32; WIDTH]], reach: Option<f32>) {
        let Some(reach) = reach else { return self.oriented.clear() };
        let Self { blocks, oriented, .. } = self;
        oriented.resize(blocks.len(), [Obb::everything(); WIDTH]);
        threads.fill(oriented, |i| {
            std::array::from_fn(|j| {
                let [p, q, r] = blocks[i].corners.map(|ids| table[ids[j] as usize]);
                let at = |k: usize| [p, q, r].map(|x| [x[k], x[k + 1], x[k + 2]]);
                Obb::of_moving_triangle(&at(0), &at(4)).grown(reach)
            })
        });
    }

    /// The lanes of `mask` whose triangles in block `b` are apart from that of a lane of `a`.
    #[inline(never)]
    pub fn apart(&self, (a, lane): (usize, usize), b: usize, mask: u32) -> u32 {
        if self.oriented.is_empty() {
            return 0;
        }
        let (one, others) = (&self.oriented[a][lane], &self.oriented[b]);
        keep(mask, |j| one.separated(&others[j]))
    }

    /// Corner `k` of each triangle of a block.
    #[inline(always)]
    pub fn corner(&self, block: usize, k: usize) -> TriangleSide<'_, 1> {
        let features = &self.blocks[block];
        TriangleSide {
            vertices: [&features.corners[k]],
            ids: &features.corners[k],
            boxes: &self.features[block][k],
            ends: &self.ends[block].corners[k],
        }
    }

    /// Side `k` of each triangle of a block.
    #[inline(always)]
    pub fn side(&self, block: usize, k: usize) -> TriangleSide<'_, 2> {
        let features = &self.blocks[block];
        TriangleSide {
            vertices: features.side(k),
            ids: &features.sides[k],
            boxes: &self.features[block][3 + k],
            ends: &self.ends[block].sides[k],
        }
    }

    /// The triangles of a block.
    #[inline(always)]
    pub fn face(&self, block: usize) -> TriangleSide<'_, 3> {
        let [a, b, c] = &self.blocks[block].corners;
        TriangleSide {
            vertices: [a, b, c],
            ids: &self.blocks[block].ids,
            boxes: &self.boxes.blocks()[block],
            ends: &self.ends[block].face,
        }
    }
}

/// One feature of each triangle of a block.
#[derive(Clone, Copy)]
pub struct TriangleSide<'a, const N: usize> {
    vertices: [&'a [u32; WIDTH]; N],
    ids: &'a [u32; WIDTH],
    boxes: &'a Block,
    ends: &'a [Block; 2],
}

impl<'a, const N: usize> Side<'a, N> for TriangleSide<'a, N> {
    #[inline(always)]
    fn vertices(self) -> [&'a [u32; WIDTH]; N] {
        self.vertices
    }

    #[inline(always)]
    fn ids(self) -> &'a [u32; WIDTH] {
        self.ids
    }

    #[inline(always)]
    fn boxes(self) -> &'a Block {
        self.boxes
    }

    #[inline(always)]
    fn ends(self) -> &'a [Block; 2] {
        self.ends
    }
}

/// The features of block `i`; lanes without a box represent nothing.
fn block(triangles: &Triangles, repeats: bool, boxes: &LeafBoxes, i: usize) -> TriangleBlock {
    let mut block = TriangleBlock { ids: *boxes.ids(i), ..TriangleBlock::NONE };
    for (j, t) in block.ids.into_iter().enumerate() {
        let (corners, sides) = (triangles.corners(t), triangles.sides(t));
        for k in 0..3 {
            block.corners[k][j] = corners[k];
            block.sides[k][j] = sides[k];
        }
        if boxes.has_box(i * WIDTH + j) {
            let represents = triangles.represents(t) as u32;
            let tests = if repeats { triangles.has(t) as u32 } else { represents };
            for k in 0..6 {
                block.represents[k] |= (represents >> k & 1) << j;
                block.tests[k] |= (tests >> k & 1) << j;
            }
            block.faces |= (triangles.is_face(t) as u32) << j;
        }
    }
    block
}

/// Boxes of what the triangles of a block test.
fn features(block: &TriangleBlock, of_vertices: &[Aabb<f32>]) -> [Block; 6] {
    let mut out = [EMPTY; 6];
    for (k, into) in out.iter_mut().enumerate() {
        let mut rest = block.tests[k];
        while rest != 0 {
            let j = rest.trailing_zeros() as usize;
            rest &= rest - 1;
            let aabb = if k < 3 {
                feature_box([block.corners[k][j]], of_vertices)
            } else {
                feature_box(block.side(k - 3).map(|ids| ids[j]), of_vertices)
            };
            set_lane(into, j, &aabb);
        }
    }
    out
}
