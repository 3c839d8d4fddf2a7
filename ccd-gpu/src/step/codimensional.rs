//! Particles and rods: pairs of features that belong to nothing of a higher dimension.
//!
//! Their boxes go through a broad phase on the device; what overlaps is compared again in `f64` and
//! decided on the host, one pair after the other.

use crate::broad_phase::BroadPhase;
use crate::device::{BLOCKS, Device};
use crate::error::Error;
use ccd_core::backend::layout::Pair;
use ccd_core::backend::rules::Rules;
use ccd_core::model::codimensional::{Codimensional as Features, KINDS};
use ccd_core::model::contact::Contact;
use ccd_core::model::decision::Decider;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use ccd_core::model::precision::{Given, Precision};
use ccd_core::{Aabb, Real};

/// Finds such pairs.
pub struct Codimensional {
    features: Features,
    /// Of vertices with edges, and of vertices.
    broad_phases: [BroadPhase; 2],
    /// Candidates of the last step: vertex-edge, vertex-vertex; sorted.
    pub pairs: [Vec<Pair>; 2],
}

impl Codimensional {
    /// For steps of a mesh; `None` if it has no such pairs.
    pub fn new(device: &Device, mesh: &Mesh, options: &Options) -> Result<Option<Self>, Error> {
        let features = Features::of(mesh);
        if features.is_empty() {
            return Ok(None);
        }
        if !BLOCKS {
            return Err(Error::Particles);
        }
        let (method, scheduling) = (options.broad_phase, options.scheduling);
        let broad_phase = || BroadPhase::of_session(device, method, scheduling);
        let broad_phases = [broad_phase()?, broad_phase()?];
        Ok(Some(Self { features, broad_phases, pairs: [Vec::new(), Vec::new()] }))
    }

    /// Lists the candidates of a step whose coordinates were checked.
    /// `distance`: that at which features are in contact.
    pub fn list(
        &mut self,
        mesh: &Mesh,
        (rules, distance): (Option<&Rules>, f64),
        given: Given,
    ) -> Result<(), Error> {
        match given {
            Precision::F32(x) => self.list_of(mesh, (rules, distance), x),
            Precision::F64(x) => self.list_of(mesh, (rules, distance), x),
        }
    }

    fn list_of<T: Real>(
        &mut self,
        mesh: &Mesh,
        (rules, distance): (Option<&Rules>, f64),
        x: [&[[T; 3]]; 2],
    ) -> Result<(), Error> {
        let Self { features, broad_phases: [mixed, own], pairs } = self;
        let vertices: Vec<Aabb<f64>> =
            (0..features.vertices.len()).map(|i| features.vertex_box(i, x, distance)).collect();
        let edges: Vec<Aabb<f64>> =
            (0..features.edges.len()).map(|i| features.edge_box(i, mesh, x, distance)).collect();
        let rounded = |boxes: &[Aabb<f64>]| boxes.iter().map(Aabb::round_out).collect::<Vec<_>>();
        let (points, segments) = (rounded(&vertices), rounded(&edges));
        let all =
            [(mixed.pairs(&points, &segments)?, &edges), (own.self_pairs(&points)?, &vertices)];
        for ((kind, (found, second)), out) in KINDS.into_iter().zip(all).zip(pairs) {
            let overlap = |at: &Pair| vertices[at.a as usize].overlaps(&second[at.b as usize]);
            let found = found.into_iter().filter(overlap);
            features.candidates(kind, found, (mesh, rules), out);
        }
        Ok(())
    }

    /// The contacts among the candidates that were listed, in their order.
    pub fn contacts<'a>(
        &'a self,
        mesh: &'a Mesh,
        decider: &'a Decider,
        given: Given<'a>,
    ) -> impl Iterator<Item = Contact> + use<'a> {
        let kinds = KINDS.into_iter().zip(&self.pairs);
        kinds.flat_map(|(kind, pairs)| pairs.iter().map(move |&pair| (kind, pair))).filter_map(
            move |(kind, pair)| match given {
                Precision::F32(x) => decider.contact(mesh, kind, pair, x),
                Precision::F64(x) => decider.contact(mesh, kind, pair, x),
            },
        )
    }
}
