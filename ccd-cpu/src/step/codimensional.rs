//! Particles and rods: pairs of features that belong to nothing of a higher dimension.
//!
//! Their boxes, in `f64`, go through a broad phase of their own, and every pair is decided at
//! once: no filter is worth its table for two or three vertices.

use crate::broad_phase::BroadPhase;
use crate::step::candidates::Given;
use crate::step::narrow_phase::CONTACTS;
use crate::step::selection::Selection;
use crate::threads::Threads;
use ccd_core::backend::layout::Pair;
use ccd_core::model::codimensional::{Codimensional as Features, KINDS};
use ccd_core::model::contact::{Contact, Kind};
use ccd_core::model::decision::Decider;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use ccd_core::model::precision::Precision;
use ccd_core::{Aabb, Error};

/// Finds such pairs, and keeps its buffers between steps.
#[derive(Debug)]
pub struct Codimensional {
    features: Features,
    broad_phase: BroadPhase,
    vertices: Vec<Aabb<f64>>,
    edges: Vec<Aabb<f64>>,
    /// Candidates of the last step: vertex-edge, vertex-vertex; sorted.
    pub pairs: [Vec<Pair>; 2],
    /// Of a part of them: contacts, in their places.
    decided: Vec<Option<Contact>>,
    contacts: Vec<Contact>,
}

impl Codimensional {
    /// For steps of a mesh; `None` if it has no such pairs.
    pub fn new(mesh: &Mesh, options: &Options) -> Result<Option<Box<Self>>, Error> {
        let features = Features::of(mesh);
        if features.is_empty() {
            return Ok(None);
        }
        // Inside of a step, the session's threads are those of the pool.
        let threads = if options.threads == 1 { 1 } else { 0 };
        Ok(Some(Box::new(Self {
            features,
            broad_phase: BroadPhase::scheduled(threads, options.broad_phase, options.scheduling)?,
            vertices: Vec::new(),
            edges: Vec::new(),
            pairs: [Vec::new(), Vec::new()],
            decided: Vec::new(),
            contacts: Vec::new(),
        })))
    }

    /// Lists the candidates of a step whose coordinates were checked.
    pub fn list(
        &mut self,
        threads: &Threads,
        mesh: &Mesh,
        (options, selection): (&Options, &Selection),
        given: Given,
    ) -> Result<(), Error> {
        let Self { features, broad_phase, vertices, edges, pairs, .. } = self;
        let distance = options.min_distance;
        broad_phase.join(threads);
        vertices.resize(features.vertices.len(), NOTHING);
        threads.fill(vertices, |i| match given {
            Precision::F32(x) => features.vertex_box(i, x, distance),
            Precision::F64(x) => features.vertex_box(i, x, distance),
        });
        edges.resize(features.edges.len(), NOTHING);
        threads.fill(edges, |i| match given {
            Precision::F32(x) => features.edge_box(i, mesh, x, distance),
            Precision::F64(x) => features.edge_box(i, mesh, x, distance),
        });
        for (kind, out) in KINDS.into_iter().zip(pairs) {
            let found = match kind {
                Kind::VertexEdge => broad_phase.pairs(vertices, edges)?,
                _ => broad_phase.self_pairs(vertices)?,
            };
            out.clear();
            if !threads.stop.reserve("candidates", out, found.len()) {
                break;
            }
            features.candidates(kind, found.iter(), (mesh, selection.rules.as_ref()), out);
            if let Some(filter) = &selection.filter {
                out.retain(|pair| filter(kind, pair.a, pair.b));
            }
        }
        threads.stop.check()
    }

    /// Decides the candidates that were listed; contacts in their order. Part by part: most
    /// candidates are no contact, and a contact takes six times the memory of one.
    ///
    /// # Errors
    /// Those of [`Stop::check`](crate::stop::Stop::check).
    pub fn decide(
        &mut self,
        threads: &Threads,
        mesh: &Mesh,
        decider: &Decider,
        given: Given,
    ) -> Result<&[Contact], Error> {
        let Self { pairs, decided, contacts, .. } = self;
        contacts.clear();
        for (kind, pairs) in KINDS.into_iter().zip(pairs) {
            for part in pairs.chunks(PART) {
                decided.clear();
                decided.resize(part.len(), None);
                threads.fill(decided, |i| match given {
                    Precision::F32(x) => decider.contact(mesh, kind, part[i], x),
                    Precision::F64(x) => decider.contact(mesh, kind, part[i], x),
                });
                let n = decided.iter().flatten().count();
                threads.stop.check()?;
                if threads.stop.reserve(CONTACTS, contacts, n) {
                    contacts.extend(decided.iter().copied().flatten());
                }
            }
        }
        threads.stop.check()?;
        Ok(contacts)
    }
}

/// Candidates that are decided at once.
const PART: usize = 1 << 14;
const NOTHING: Aabb<f64> = Aabb { min: [0.0; 3], max: [0.0; 3] };
