//! What a step prepares before anything is compared: checked coordinates, boxes, trees, the table
//! that filters read.

mod ends;
mod triangles;
mod vertices;

use crate::broad_phase::leaf_boxes::Keeps;
use crate::broad_phase::method::Method;
use crate::broad_phase::pair_source::PairSource;
use crate::simd::WIDTH;
use crate::step::candidates::Scene;
use crate::step::leaves::Feature;
use crate::step::movers::IS_TOLD;
use crate::step::positions::{Ends, Positions};
use crate::step::rigid::RigidTrees;
use crate::step::scans::Scans;
use crate::step::selection::Selection;
use crate::step::still::Still;
use crate::step::triangle_leaves::TriangleLeaves;
use crate::stop::Stop;
use crate::threads::Threads;
use ccd_core::backend::broad_phase::swept_box;
use ccd_core::backend::quantization::{Scan, Table};
use ccd_core::backend::rules::Rules;
use ccd_core::model::decision::Decider;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use ccd_core::model::pipeline::Pipeline;
use ccd_core::model::precision::Precision;
use ccd_core::model::session::Moved;
use ccd_core::{Aabb, Error};

/// Blocks may become this much looser than after the last build before trees are built anew:
/// building costs about a tenth of a step, and traversal grows with looseness.
pub const MAX_LOOSENESS: f64 = 1.15;

/// Boxes, leaves and tables of a mesh; buffers are kept between steps.
#[derive(Debug)]
pub struct Prepared {
    built: bool,
    /// Whether the last step was prepared to the end, so that all parts of this are of one step.
    whole: bool,
    /// The number of the last call whose positions were told by what moved in it.
    call: Option<u64>,
    scans: Scans,
    scan: Scan,
    table: Vec<[f32; WIDTH]>,
    units: Table,
    /// Whether there are boxes of this call's leaves at both ends.
    asks_ends: bool,
    /// How far oriented boxes of triangles are grown, if they have any.
    contact_reach: Option<f32>,
    pub vertices: Feature<1>,
    pub edges: Feature<2>,
    pub faces: Feature<3>,
    /// If pairs of triangles are looked for.
    pub triangles: Option<TriangleLeaves>,
    still: Still,
    rigid: RigidTrees,
}

impl Prepared {
    /// For steps of a mesh.
    pub fn new(mesh: &Mesh, options: &Options) -> Self {
        let distance = options.min_distance;
        let triangles = match options.pipeline {
            Pipeline::Triangles(options) => Some(TriangleLeaves::new(mesh, options, distance)),
            _ => None,
        };
        Self {
            built: false,
            whole: true,
            call: None,
            scans: Scans::default(),
            scan: Scan::NONE,
            table: Vec::new(),
            units: Table::AS_GIVEN,
            contact_reach: None,
            asks_ends: false,
            // Vertices are only sought in faces.
            vertices: Feature::new(0, false),
            edges: Feature::new(1, true),
            faces: Feature::new(2, true),
            triangles,
            still: Still::default(),
            rigid: RigidTrees::default(),
        }
    }

    /// Takes other rules; the next step sorts boxes anew.
    pub fn set_rules(&mut self, rules: Option<&Rules>) {
        self.still.set(rules);
        self.rigid.clear();
        self.forget_order();
    }

    /// Has the next step sort boxes anew.
    pub fn forget_order(&mut self) {
        self.built = false;
    }

    /// From now on steps of another mesh, or by another pipeline; buffers stay.
    pub fn set_mesh(&mut self, mesh: &Mesh, options: &Options) {
        self.forget_order();
        self.rigid.clear();
        match (options.pipeline, &mut self.triangles) {
            (Pipeline::Triangles(args), Some(kept)) => {
                kept.set_mesh(mesh, args, options.min_distance);
            }
            (Pipeline::Triangles(args), none) => {
                *none = Some(TriangleLeaves::new(mesh, args, options.min_distance));
            }
            (_, triangles) => *triangles = None,
        }
    }

    /// From now on another minimum distance. Boxes are swept with it in every step, and an order
    /// holds for boxes of any size; only regions that are free without one are not with one.
    pub fn set_min_distance(&mut self, mesh: &Mesh, options: &Options) {
        if let (Pipeline::Triangles(args), Some(triangles)) =
            (options.pipeline, &mut self.triangles)
        {
            triangles.set_min_distance(mesh, args, options.min_distance);
        }
    }

    /// Whether the last call was the one before this, so that what did not move is there.
    pub fn precedes(&self, moved: &Moved) -> bool {
        moved.follows(self.call)
    }

    /// Whether what did not move since the last call is not made again: by the default method.
    pub fn keeps_rest(&self, method: &Method) -> bool {
        IS_TOLD && self.triangles.is_none() && matches!(method, Method::Blocks(_))
    }

    /// Takes what moves rigidly in a step, if the method keeps trees of it; first of all.
    pub fn rigid(
        &mut self,
        threads: &Threads,
        mesh: &Mesh,
        rules: Option<&Rules>,
        method: &Method,
        x: &Positions,
    ) {
        let takes = self.keeps_rest(method);
        let Self { rigid, still, .. } = self;
        let changes = match x.moved.filter(|_| takes).map(|moved| moved.rigids) {
            Some(Precision::F32(rigids)) => rigid.begin(threads, mesh, rules, rigids),
            Some(Precision::F64(rigids)) => rigid.begin(threads, mesh, rules, rigids),
            None => rigid.begin_plain(),
        };
        let is_posed = |v: u32| rigid.has(v);
        match (rules, x.moved.filter(|_| takes)) {
            // Where trees of bodies come or go, or are paused, other boxes are made than before.
            (Some(rules), Some(moved)) if !changes && rigid.is_on() == rigid.is_there() => {
                still.movers.begin(rules, moved.runs, is_posed);
            }
            _ => still.movers.pause(),
        }
        if changes {
            self.forget_order();
        }
    }

    /// Checks coordinates, fills the table and sweeps the boxes of vertices.
    pub fn boxes(
        &mut self,
        threads: &Threads,
        options: &Options,
        x: &Positions,
    ) -> Result<(), Error> {
        if !std::mem::replace(&mut self.whole, false) {
            self.forget_order();
            self.still.forget();
        }
        if x.moved.is_none() {
            self.rigid.pause();
        }
        let made = match x.given {
            Precision::F32([x0, x1]) => self.vertices(threads, options, &Ends { x0, x1, times: x }),
            Precision::F64([x0, x1]) => self.vertices(threads, options, &Ends { x0, x1, times: x }),
        };
        if made.is_err() {
            // Nothing else has changed.
            self.still.forget();
            self.whole = true;
        }
        made
    }

    /// What workers read of a step whose boxes and trees are there, to find contacts in `window`.
    pub fn scene<'a>(
        &'a self,
        (mesh, options): (&'a Mesh, &'a Options),
        selection: &'a Selection,
        x: &Positions<'a>,
        window: [f64; 2],
        keep_contacts: bool,
        stop: &'a Stop,
    ) -> Scene<'a> {
        let rounds_boxes = match x.given {
            Precision::F32(_) => self.scan.rounds_boxes::<f32>(options.min_distance),
            Precision::F64(_) => self.scan.rounds_boxes::<f64>(options.min_distance),
        };
        // A shorter time has boxes of its own, which nobody compares with those of the input.
        let rounded = rounds_boxes && x.whole();
        Scene {
            mesh,
            selection,
            given: x.given,
            table: &self.table,
            table_error: self.units.error,
            table_distance: self.units.distance(options.min_distance),
            needed_gap: self.needed_gap(options),
            asks_ends: self.asks_ends || self.triangles.is_some(),
            min_distance: options.min_distance,
            decider: Decider::new(options, window),
            slack: rounded.then(|| self.scan.slack(options.min_distance)),
            latest: 1.0,
            keep_contacts,
            stop,
        }
    }

    /// Has the method take the boxes: in the order that it has, or in a new one if it has none yet
    /// or has become too loose. Returns whether the order is new. Boxes of a time that was
    /// shortened in a step say nothing about looseness and never bring a new order.
    pub fn leaves(
        &mut self,
        threads: &Threads,
        method: &mut Method,
        (mesh, options): (&Mesh, &Options),
        rules: Option<&Rules>,
        x: &Positions,
    ) -> Result<bool, Error> {
        let first = !x.again;
        self.asks_ends = false;
        if let Some(triangles) = &mut self.triangles {
            // What is free during the whole step is free during a shorter one.
            if first {
                triangles.certify(threads, mesh, x.given);
            }
            let rebuilt = self.triangle_leaves(threads, method, rules, first)?;
            self.whole = true;
            return Ok(rebuilt);
        }
        let Self { whole, vertices, edges, faces, still, rigid, .. } = self;
        let mut keeps = Keeps { still: still.holds(), posed: rigid.is_on(), free: None };
        let mut loose = !self.built || !method.order().outlasts_motion();
        if !loose {
            let mut of_sets = [keeps; 3];
            if let (true, Some(rules)) = (still.movers.is_on(), rules) {
                let (v, e, f) = (&vertices.leaves, &edges.leaves, &faces.leaves);
                still.movers.find_blocks(
                    rules,
                    [&|i| v.first_of_free(i), &|i| e.first_of_free(i), &|i| f.first_of_free(i)],
                );
                let blocks = |set| Some(still.movers.blocks(set));
                of_sets = [0, 1, 2].map(|set| Keeps { free: blocks(set), ..keeps });
            }
            let of_vertices = &vertices.boxes[..];
            let (v, e, f) = (&mut vertices.leaves, &mut edges.leaves, &mut faces.leaves);
            threads.together(
                || v.sweep(threads, of_vertices, of_sets[0]),
                || e.sweep(threads, of_vertices, of_sets[1]),
                || f.sweep(threads, of_vertices, of_sets[2]),
            );
            let mut looseness = [0.0; 3];
            let [of_v, of_e, of_f] = &mut looseness;
            method.each_set(
                threads,
                [
                    &mut |order| *of_v = v.fit(threads, order),
                    &mut |order| *of_e = e.fit(threads, order),
                    &mut |order| *of_f = f.fit(threads, order),
                ],
            );
            loose = first && looseness.into_iter().fold(0.0, f64::max) > MAX_LOOSENESS;
        }
        if loose {
            let (of_edges, of_faces) = (mesh.edges(), mesh.faces());
            let (of_vertices, e, f) = (&vertices.boxes[..], &mut edges.boxes, &mut faces.boxes);
            threads.resize(e, of_edges.len(), || Aabb::EMPTY);
            threads.resize(f, of_faces.len(), || Aabb::EMPTY);
            threads.together(
                || threads.fill(e, |i| swept_box::edge(i, of_edges, of_vertices)),
                || threads.fill(f, |i| swept_box::face(i, of_faces, of_vertices)),
                || {},
            );
            let sets: [&[_]; 3] = [of_vertices, e, f];
            method.order().survey(threads, &sets)?;
            // What stands where it stood keeps its order.
            let keep = (self.built && keeps.still, &*rigid);
            self.built = true;
            method.each_set(
                threads,
                [
                    &mut |order| vertices.build(threads, order, rules, keep, |v| [v]),
                    &mut |order| edges.build(threads, order, rules, keep, |e| of_edges[e as usize]),
                    &mut |order| faces.build(threads, order, rules, keep, |f| of_faces[f as usize]),
                ],
            );
            keeps.still = false;
            still.movers.forget_order();
        }
        if IS_TOLD && let (true, Some(rules), Some(moved)) = (keeps.posed, rules, &x.moved) {
            if let (true, Method::Blocks(source)) = (first, &*method) {
                let [v, e, f] = &source.trees[..] else { unreachable!("a tree for each set") };
                let leaves = (&vertices.leaves.boxes, &edges.leaves.boxes, &faces.leaves.boxes);
                let trees = [(v, leaves.0), (e, leaves.1), (f, leaves.2)];
                rigid.look(threads, rules, moved, options.min_distance, trees);
            }
            let ([v, e, f], still) = (rigid.runs(), keeps.still);
            let Feature { boxes, leaves } = vertices;
            edges.leaves.pose(threads, method, e, boxes, still);
            faces.leaves.pose(threads, method, f, boxes, still);
            leaves.pose(threads, method, v, boxes, still);
        }
        let holds = !loose && still.holds_table();
        vertices.leaves.change_ends(holds);
        edges.leaves.change_ends(holds);
        faces.leaves.change_ends(holds);
        *whole = true;
        Ok(loose)
    }

    /// The same for edges and faces alone, in whichever order there is; without pairs of triangles.
    pub fn edges_and_faces(
        &mut self,
        threads: &Threads,
        method: &mut Method,
        (mesh, options): (&Mesh, &Options),
        rules: Option<&Rules>,
        x: &Positions,
    ) -> Result<(), Error> {
        if !self.built || !method.order().outlasts_motion() {
            return self.leaves(threads, method, (mesh, options), rules, x).map(|_| ());
        }
        let Self { vertices, edges, faces, .. } = self;
        edges.leaves.sweep(threads, &vertices.boxes, Keeps::default());
        edges.leaves.fit(threads, method.order());
        faces.leaves.sweep(threads, &vertices.boxes, Keeps::default());
        faces.leaves.fit(threads, method.order());
        // Everything else is of an earlier step.
        self.still.forget();
        self.whole = true;
        Ok(())
    }

    /// About how many boxes were swept: those that a shorter time has anew.
    pub fn n_swept(&self, mesh: &Mesh) -> usize {
        let leaves = match &self.triangles {
            Some(triangles) => [triangles.boxes.changed(), &[]],
            None => [self.edges.leaves.boxes.changed(), self.faces.leaves.boxes.changed()],
        };
        let n_blocks: usize = leaves.iter().copied().flatten().map(|run| run.len()).sum();
        self.still.n_made(mesh.n_vertices()) + WIDTH * n_blocks
    }

    /// Swept boxes of vertices.
    pub fn of_vertices(&self) -> &[Aabb<f32>] {
        &self.vertices.boxes
    }
}
