//! Every public type may go to another thread and be looked at from several; the compiler says so.

use ccd::{any, gpu, io, method, positions, scenes};

const fn is<T: Send + Sync>() {}

macro_rules! are {
    ($($t:ty),* $(,)?) => {
        const _: () = { $(is::<$t>();)* };
    };
}

are! {
    ccd::Aabb, ccd::Approach, ccd::Bodies, ccd::BodyMotion<'static>, ccd::BroadPhase,
    method::BroadPhaseMethod, ccd::BroadPhaseTimes, method::Builder, ccd::Candidates<'static>,
    ccd::CandidateSet, ccd::squared_distance::SquaredDistance,
    ccd::squared_distance::EdgeEdgeType, ccd::squared_distance::VertexFaceType,
    ccd::Contact, ccd::ContactGeometry, method::Descent, ccd::CancelToken, ccd::Digest,
    ccd::Distance, ccd::EdgeEdge<f64>, ccd::Error, ccd::Exclusions, method::Front,
    method::FrontCounts, method::FrontOptions, ccd::Groups, ccd::Hit, ccd::Intersection, ccd::Kind,
    ccd::Mesh, ccd::Mode, ccd::Options, ccd::Pair, ccd::Pairs<'static>, ccd::PerKind,
    method::Pipeline, ccd::Posed<'static, f32>, ccd::Report, method::Row<method::Scheduler>,
    method::Scheduler, method::Scheduling, ccd::Session, ccd::State, ccd::Strided<'static, f64>,
    ccd::Times, method::Traversal, method::TreeOptions, method::TreeStatistics,
    method::TriangleCounts, method::TriangleOptions, ccd::Verdict<f64>, ccd::VertexEdge<f64>,
    ccd::VertexFace<f32>, ccd::VertexVertex<f64>, method::Volume, method::WorkerOptions,
    ccd::geometry::Motion<f64>, ccd::geometry::Patch, ccd::exact::Exact, positions::Ends<'static>,
    positions::PositionView<'static, f32>, positions::Precision<u8, u8>,
}
are! {
    any::Backend, any::BroadPhase, any::Candidates<'static>, any::Choice, any::Error,
    any::Pairs<'static>, any::Place, any::Session,
}
are! {
    gpu::BroadPhase, gpu::Candidates, gpu::Device, gpu::DeviceOptions, gpu::Error, gpu::Group,
    gpu::Info, gpu::List, gpu::OnDevice<'static>, gpu::Path, gpu::Session, gpu::Sorter, gpu::Timing,
    gpu::WorkerCounts,
}
are! {
    io::Frame, io::Queries, io::Query, io::ReadError, io::ReadErrorKind, scenes::Random,
    scenes::Sequence, scenes::Step,
}

const TRAITS: [&str; 6] = ["AsPositions", "Catalogued", "Coordinate", "Matrix", "Point", "Real"];

/// What is here is what there is: every type that the library's root exports has a line above.
#[test]
fn every_type_at_the_root_is_named() {
    let source = include_str!("../../src/lib.rs");
    let here = include_str!("send_sync.rs");
    let exports = source.split("pub use ").skip(1).filter_map(|rest| rest.split(';').next());
    let mut n = 0;
    for word in exports.flat_map(|part| part.split(|c: char| !c.is_alphanumeric() && c != '_')) {
        let is_type = word.starts_with(char::is_uppercase) && word.contains(char::is_lowercase);
        let is_trait = TRAITS.contains(&word);
        if is_type && !is_trait {
            let named = [format!("::{word},"), format!("::{word}<")];
            assert!(named.iter().any(|name| here.contains(name)), "{word} is not asserted");
            n += 1;
        }
    }
    assert!(n > 30, "{n} types found");
}
