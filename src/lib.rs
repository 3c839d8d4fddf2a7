//! facade
pub use ccd_core::topology::{Bodies, Mesh};
pub use ccd_core::{Aabb, EdgeEdge, Error, TOI_TOLERANCE, Verdict, VertexFace, edge_edge, vertex_face};
#[cfg(feature = "io")]
pub mod io;
pub use ccd_core::layout::Pair;
pub use ccd_cpu::{BroadPhase, Contact, Kind, Method, Options, Pairs, PerKind, Report, Session, State, Times};
