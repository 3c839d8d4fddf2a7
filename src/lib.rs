//! Continuous collision detection for triangle meshes: which vertices and faces, and which edges,
//! touch while every vertex moves on a straight line from its position at the start of a step to
//! that at its end, and when. No contact is missed, and no time of impact is late, rounding
//! included.
//!
//! ```
//! use ccd::{Kind, Mesh, Options, Session, State};
//!
//! // A square of two triangles, and a triangle whose first vertex falls through it.
//! let faces = [[0, 1, 2], [2, 1, 3], [4, 5, 6]];
//! let mesh = Mesh::new(7, &faces)?;
//! let before = [
//!     [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 1.0],
//!     [0.3, 0.5, 0.3], [0.2, 2.0, 0.3], [0.4, 2.0, 0.3f64],
//! ];
//! let mut after = before;
//! after[4][1] = -0.5;
//!
//! let mut session = Session::new(mesh, Options::default())?;
//! let report = session.step(&before, &after)?;
//! let contact = report.contacts[0];
//! assert_eq!((contact.kind, contact.a, contact.b), (Kind::VertexFace, 4, 0));
//! assert_eq!(contact.state, State::Hit);
//! assert!(contact.toi <= 0.5 && contact.toi > 0.5 - 1e-6);
//!
//! // The time that bounds a safe step, found faster than all contacts.
//! assert_eq!(session.earliest_toi(&before, &after)?, Some(contact.toi));
//! # Ok::<(), ccd::Error>(())
//! ```
//!
//! | to do | use |
//! |---|---|
//! | every contact of a step, once | [`step`] |
//! | the largest safe step | [`earliest_toi`] |
//! | the first contact, with point and normal | [`Session::first_contact`]: [`Hit`] |
//! | bodies that move while others stand still | [`Session::step_bodies`]: [`BodyMotion`] |
//! | frame after frame of one mesh | [`Session`] |
//! | several bodies, fixed bodies | [`Bodies`] in [`Options`] |
//! | contact at a distance | [`Options::min_distance`] |
//! | positions in a vertex buffer, `glam`, posed bodies | [`positions`] |
//! | another mesh, distance or options between steps | [`Session::set_mesh`], and its like |
//! | leave out neighbours, or pairs near at rest | [`Exclusions`], [`near_at_rest`] |
//! | a rule of your own for pairs | [`Session::set_filter`] (on the CPU) |
//! | end a call from another thread | [`CancelToken`]: [`Session::set_cancel_token`] |
//! | limit memory | [`Options::max_memory`] |
//! | one pair of features | [`vertex_face`], [`edge_edge`], [`vertex_edge`], [`vertex_vertex`] |
//! | how far a pair is apart at one moment | [`Mesh::distance`], [`Distance`] |
//! | its square with gradient and Hessian, for a barrier | [`squared_distance`] |
//! | where a mesh goes through itself at one moment | [`intersections`], [`has_intersections`] |
//! | particles and rods | [`Mesh::with_edges`]; [`Kind`] says what touches what |
//! | the candidate pairs of a step | [`Session::candidates`] |
//! | candidates for many steps, of a line search | [`CandidateSet`] |
//! | true times of impact, on a GPU too | [`Mode::Exact`]; [`exact`] for one pair |
//! | a time of impact as `f32`, or scaled | [`toi_to_f32`], [`scaled_toi`]: never later |
//! | boxes in, overlapping pairs out | [`BroadPhase`], by a [`method::BroadPhaseMethod`] |
//! | on a GPU where there is one, else on the CPU | [`any`]: `any::Session`, `any::BroadPhase` |
//! | on a GPU | `gpu` (feature `gpu`): `gpu::Device`, `gpu::Session`, `gpu::BroadPhase` |
//! | one mesh on several GPUs | `gpu::Group` (feature `gpu`) |
//! | where two features touch, along which normal | [`Contact::geometry`]: [`ContactGeometry`] |
//! | compute a response | [`geometry`] |
//! | read meshes, positions over time and query files | `io` (feature `io`) |
//! | scenes that are the same everywhere | `scenes` (feature `scenes`) |
//!
//! Coordinates are `f32` or `f64`, in any unit, finite and at most 1e100. What a caller may rely
//! on is listed in the README; how it is done, in ARCHITECTURE.md.
//!
//! # Features
//! None is enabled by default. `gpu` adds the GPU backend, `io` the readers, `scenes` generated
//! scenes, `glam` its vectors and matrices as positions, `serde` meshes, options, contacts and
//! reports as data, `catalogue` all methods beside those of the default ([`method`]).
//!
//! # WebAssembly
//! On `wasm32-unknown-unknown` the CPU's path runs as everywhere, in the calling thread:
//! [`Options::threads`] is 0 or 1, more is refused. There is no clock, so all [`Times`] are 0,
//! unless `set_clock` gives one, which exists there alone. The npm package is described in
//! `docs/browser.md`.
#![deny(unsafe_code)]
#![warn(clippy::missing_errors_doc, clippy::missing_panics_doc)]

pub mod any;
#[cfg(not(target_family = "wasm"))]
#[doc(hidden)]
pub mod group;
#[cfg(feature = "io")]
pub mod io;
#[cfg(feature = "scenes")]
pub mod scenes;

/// Exact decisions of single queries: contact or not, of the coordinates as they are.
pub mod exact {
    pub use ccd_core::narrow_phase::exact::{
        Exact, edge_edge, vertex_edge, vertex_face, vertex_vertex,
    };
}

/// How pairs are found, where the default is not enough: broad phases, trees, pipelines, scheduling
/// (`docs/METHODS.md`), each with its name and source ([`method::every`]).
pub mod method {
    pub use ccd_core::model::catalogue::{Catalogued, Row, every};
    pub use ccd_core::model::method::{
        BroadPhaseMethod, Builder, Descent, Traversal, TreeOptions, Volume,
    };
    pub use ccd_core::model::pipeline::{Pipeline, TriangleOptions};
    pub use ccd_core::model::report::{FrontCounts, TriangleCounts};
    pub use ccd_core::model::scheduling::{
        Front, FrontOptions, Scheduler, Scheduling, WorkerOptions,
    };
    pub use ccd_core::model::tree_statistics::TreeStatistics;
}

/// Squared distances of two features with gradient and Hessian, by the type of what is nearest.
pub mod squared_distance {
    pub use ccd_core::narrow_phase::squared_distance::{
        EdgeEdgeType, SquaredDistance, VertexFaceType,
    };
}

/// Building blocks of a contact response: vectors, a query as a vector against a moving patch, and
/// the nearest point of that patch.
pub mod geometry {
    pub use ccd_core::math::vec3;
    pub use ccd_core::narrow_phase::closest_point::closest;
    pub use ccd_core::narrow_phase::relative_motion::{Motion, Patch};
}

/// Positions as a session takes them: slices as they are, and what is gathered into slices first.
pub mod positions {
    pub use ccd_core::model::positions::{
        AsPositions, Ends, Matrix, Point, Posed, PositionView, Strided, ends,
    };
    pub use ccd_core::model::precision::Precision;
}

/// The GPU backend: [`gpu::Device`], [`gpu::Session`]; several GPUs of one host: [`gpu::Group`].
#[cfg(feature = "gpu")]
pub mod gpu {
    #[cfg(not(target_family = "wasm"))]
    pub use crate::group::Group;
    pub use ccd_gpu::*;
}

/// The README's examples are compiled and run with the documentation tests.
#[cfg(all(doctest, feature = "gpu"))]
#[doc = include_str!("../README.md")]
struct Readme;

/// The examples of docs/solver.md.
#[cfg(all(doctest, feature = "gpu"))]
#[doc = include_str!("../docs/solver.md")]
struct SolverPage;

/// The example of docs/coming-from.md.
#[cfg(all(doctest, feature = "gpu"))]
#[doc = include_str!("../docs/coming-from.md")]
struct ComingFromPage;

/// The Rust example of docs/cluster.md; its programs in Python are run by their tests.
#[cfg(all(doctest, feature = "gpu"))]
#[doc = include_str!("../docs/cluster.md")]
struct ClusterPage;

pub use ccd_core::model::bodies::Bodies;
pub use ccd_core::model::cancel::CancelToken;
pub use ccd_core::model::contact::{Approach, Contact, Kind, PerKind, State};
pub use ccd_core::model::digest::Digest;
pub use ccd_core::model::exclusions::Exclusions;
pub use ccd_core::model::groups::Groups;
pub use ccd_core::model::mesh::Mesh;
pub use ccd_core::model::options::{Mode, Options};
pub use ccd_core::model::positions::{AsPositions, Posed, Strided};
pub use ccd_core::model::report::{Report, Times};
pub use ccd_core::model::session::{BodyMotion, Hit};
pub use ccd_core::model::toi::{scaled_toi, toi_to_f32};
pub use ccd_core::narrow_phase::codimensional::{
    VertexEdge, VertexVertex, vertex_edge, vertex_vertex,
};
pub use ccd_core::narrow_phase::contact_geometry::ContactGeometry;
pub use ccd_core::narrow_phase::distance::Distance;
pub use ccd_core::records::Pair;
pub use ccd_core::{
    Aabb, Coordinate, EdgeEdge, Error, Real, TOI_TOLERANCE, Verdict, VertexFace, edge_edge,
    vertex_face,
};
#[cfg(all(target_family = "wasm", target_os = "unknown"))]
pub use ccd_cpu::set_clock;
pub use ccd_cpu::{
    BroadPhase, BroadPhaseTimes, CandidateSet, Candidates, Intersection, MAX_LOOSENESS, Pairs,
    Session, earliest_toi, has_intersections, instruction_set, intersections, near_at_rest,
    near_at_rest_on, step,
};
