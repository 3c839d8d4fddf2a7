//! What errors say.

use super::Error;
use crate::narrow_phase::query::LEAST_TOLERANCE;

impl core::fmt::Display for Error {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let axis_name = |axis: u8| ["x", "y", "z"][axis.min(2) as usize];
        match *self {
            Error::Coordinate { time, vertex, axis, value } => {
                write!(
                    f,
                    "vertex {vertex} at t{time} has {} = {value}; \
                     coordinates must be finite and at most {:e}",
                    axis_name(axis),
                    Self::MAX_COORDINATE
                )
            }
            Error::Index { element, at, vertex, n_vertices } => {
                write!(
                    f,
                    "{element} {at} refers to vertex {vertex}, \
                     but there are {n_vertices} vertices (0 to {})",
                    n_vertices.saturating_sub(1)
                )
            }
            Error::VertexCount { time, expected, found } => {
                write!(f, "t{time} has {found} vertices, the mesh has {expected}")
            }
            Error::Stride { time, stride, least } => {
                write!(f, "t{time} has a stride of {stride} bytes; a position takes {least}")
            }
            Error::Bytes { time, vertex, end, found } => {
                write!(
                    f,
                    "vertex {vertex} at t{time} ends at byte {end}, but there are {found} bytes"
                )
            }
            Error::Pose { time, vertex, body, n_poses } => {
                write!(
                    f,
                    "vertex {vertex} at t{time} is of body {body}, \
                     but there are {n_poses} matrices (0 to {})",
                    n_poses.saturating_sub(1)
                )
            }
            Error::Projection { time, body, row } => {
                write!(
                    f,
                    "the matrix of body {body} at t{time} has the last row {row:?}; \
                     it must be 0, 0, 0, 1"
                )
            }
            Error::TooMany { element, count, limit } => {
                write!(f, "{count} {element}: at most {limit} are possible")
            }
            Error::MinDistance { value } => {
                write!(f, "minimum distance or inflation is {value:?}; it must be from 0 to 1e100")
            }
            Error::ExactDistance { value } => {
                write!(
                    f,
                    "minimum distance is {value}; exact decisions are of touching, distance 0"
                )
            }
            Error::Tolerance { value } => {
                write!(f, "tolerance is {value}; it must be from {LEAST_TOLERANCE:e} to 1")
            }
            Error::Window { from, until } => {
                write!(f, "times from {from} to {until}; they must be in order, and in [0, 1]")
            }
            Error::Box { at, axis, min, max } => {
                write!(f, "box {at} has {} from {min} to {max}", axis_name(axis))
            }
            Error::BodyCount { expected, found } => {
                write!(f, "{found} body ids for {expected} vertices")
            }
            Error::MixedBodies { element, at, bodies } => {
                write!(f, "{element} {at} joins vertices of bodies {} and {}", bodies[0], bodies[1])
            }
            Error::NoBody { body } => write!(f, "no vertex belongs to body {body}"),
            Error::NoFeature { element, id, n } => {
                write!(f, "a rule names {element} {id}, but the mesh has only {n}, counted from 0")
            }
            Error::FixedMoves { vertex } => {
                write!(
                    f,
                    "vertex {vertex} moves, and its body is fixed or sleeps: wake it, or allow \
                     bodies that stand still to be moved"
                )
            }
            Error::Filter { backend } => {
                write!(
                    f,
                    "the {backend} cannot call a filter: exclude bodies or features by lists, or \
                     use the CPU"
                )
            }
            Error::Method { name, backend } => {
                let why = match (name, backend) {
                    ("blocking-queue" | "lock-free-queue", _) => ": its workgroups must not wait",
                    ("stealing-abp", _) => ": its fences have no sequential consistency",
                    (_, "cpu") => ", which is for a GPU",
                    _ => ", which is for a CPU",
                };
                let place = if backend == "cpu" { "CPU" } else { "GPU" };
                // Names of methods are one word each.
                match name.contains(' ') {
                    true => write!(f, "the {place} has no {name}"),
                    false => write!(f, "the {place} has no method `{name}`{why}"),
                }
            }
            Error::NotCompiled { name, backend } => write!(
                f,
                "`{name}` of the {backend} is not compiled in: build with the feature `catalogue`"
            ),
            Error::NoPairsOfNodes { method } => {
                write!(
                    f,
                    "schedulers and fronts are for methods that descend pairs of nodes, which are \
                     `blocks`, and `tree` with the traversals `simultaneous` and `cut`; \
                     `{method}` has none"
                )
            }
            Error::Setting { name, value, least, greatest } => {
                write!(f, "{name}: {value}; it must be from {least} to {greatest}")
            }
            Error::Threads { count, limit } => {
                write!(f, "cannot start {count} threads; at most {limit} are possible")
            }
            Error::Memory { what, bytes, held, limit } => {
                write!(
                    f,
                    "the limit of {limit} bytes would be exceeded: {what} need {bytes} bytes \
                     besides the {held} in use"
                )
            }
            Error::Beyond { time, vertex } => {
                write!(
                    f,
                    "vertex {vertex} at t{time} is outside of the inflation of these candidates: \
                     find others for this step"
                )
            }
            Error::NoPositions => {
                f.write_str("there are no positions yet: call `set_positions` before bodies move")
            }
            Error::BodyPositions { body, time, expected, found } => {
                write!(
                    f,
                    "body {body} at t{time} has {found} positions, and {expected} vertices in the \
                     mesh"
                )
            }
            Error::RepeatedBody { body } => write!(f, "body {body} has two motions in one step"),
            Error::MixedPrecision { body } => {
                write!(f, "body {body} moves in f64, and the positions of the mesh are in f32")
            }
            Error::Cancelled => f.write_str("cancelled"),
        }
    }
}
