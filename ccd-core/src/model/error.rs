//! What can be wrong with input, and limits that a caller set: what, where, and the value.

mod checks;
mod text;

pub use checks::{
    check_boxes, check_coordinates, check_min_distance, check_setting, check_tolerance,
    check_window,
};

/// Why there is no answer: input was refused, and nothing was computed from it; or a limit that
/// the caller set ended the call, [`Error::Memory`] or [`Error::Cancelled`].
///
/// ```
/// use ccd::{Error, Mesh};
///
/// let error = Mesh::new(3, &[[0, 1, 2], [0, 7, 2]]).unwrap_err();
/// assert!(matches!(error, Error::Index { at: 1, vertex: 7, .. }));
/// let text = "face 1 refers to vertex 7, but there are 3 vertices (0 to 2)";
/// assert_eq!(error.to_string(), text);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum Error {
    /// A coordinate is NaN, infinite, or beyond [`Error::MAX_COORDINATE`].
    Coordinate {
        /// 0 for the start of the step, 1 for its end.
        time: u8,
        /// Index of the vertex (or of the box).
        vertex: usize,
        /// 0, 1, 2 for x, y, z.
        axis: u8,
        /// The offending value.
        value: f64,
    },
    /// A face or edge names a vertex that does not exist.
    Index {
        /// `"face"` or `"edge"`.
        element: &'static str,
        /// Index of the face or edge.
        at: usize,
        /// The vertex index that is out of range.
        vertex: u32,
        /// How many vertices there are.
        n_vertices: usize,
    },
    /// Positions for another number of vertices than the mesh has.
    VertexCount {
        /// 0 for the start of the step, 1 for its end.
        time: u8,
        /// Vertices of the mesh.
        expected: usize,
        /// Positions that were given.
        found: usize,
    },
    /// Positions in bytes with a stride that is shorter than a position.
    Stride {
        /// 0 for the start of the step, 1 for its end.
        time: u8,
        /// The stride given, in bytes.
        stride: usize,
        /// Bytes of a position.
        least: usize,
    },
    /// Positions beyond the bytes that they are to be read from.
    Bytes {
        /// 0 for the start of the step, 1 for its end.
        time: u8,
        /// The first vertex whose position does not end within the bytes.
        vertex: usize,
        /// Where it would end.
        end: usize,
        /// Bytes that there are.
        found: usize,
    },
    /// A vertex of a body for which there is no matrix.
    Pose {
        /// 0 for the start of the step, 1 for its end.
        time: u8,
        /// Index of the vertex.
        vertex: usize,
        /// Its body.
        body: u32,
        /// How many matrices there are.
        n_poses: usize,
    },
    /// A matrix of a body that is not affine.
    Projection {
        /// 0 for the start of the step, 1 for its end.
        time: u8,
        /// Index of the matrix.
        body: usize,
        /// Its last row, which must be 0, 0, 0, 1.
        row: [f64; 4],
    },
    /// More elements than 32-bit ids can name.
    TooMany {
        /// What there are too many of.
        element: &'static str,
        /// How many there are.
        count: u64,
        /// How many there may be.
        limit: u64,
    },
    /// A minimum distance, or an inflation of candidates, that is negative, NaN or infinite.
    MinDistance {
        /// The value given.
        value: f64,
    },
    /// A minimum distance above 0 in [`Mode::Exact`](super::options::Mode::Exact): when features
    /// come that near is decided by polynomials of a far higher degree.
    ExactDistance {
        /// The value given.
        value: f64,
    },
    /// A tolerance of times of impact that is out of its range, or NaN.
    Tolerance {
        /// The value given.
        value: f64,
    },
    /// Times that are no window of a step: not `0 <= from <= until <= 1`.
    Window {
        /// The first time.
        from: f64,
        /// The last time.
        until: f64,
    },
    /// A box with a NaN or with `min > max`.
    Box {
        /// Index of the box.
        at: usize,
        /// Axis of the bad bound.
        axis: u8,
        /// The lower bound.
        min: f64,
        /// The upper bound.
        max: f64,
    },
    /// Bodies for another number of vertices than the mesh has.
    BodyCount {
        /// Vertices of the mesh.
        expected: usize,
        /// Body ids that were given.
        found: usize,
    },
    /// A face or edge with vertices of two bodies.
    MixedBodies {
        /// `"face"` or `"edge"`.
        element: &'static str,
        /// Index of the face or edge.
        at: usize,
        /// The two bodies.
        bodies: [u32; 2],
    },
    /// A body that no vertex belongs to.
    NoBody {
        /// Its name.
        body: u32,
    },
    /// A rule for a feature that the mesh does not have.
    NoFeature {
        /// `"vertex"`, `"edge"` or `"face"`.
        element: &'static str,
        /// Its id.
        id: u32,
        /// How many there are.
        n: usize,
    },
    /// A vertex moves in a step, and its body is fixed or sleeps.
    FixedMoves {
        /// Index of the vertex.
        vertex: usize,
    },
    /// A filter of pairs where pairs are found on a device, which cannot call it.
    Filter {
        /// The backend.
        backend: &'static str,
    },
    /// A method that this backend does not have.
    Method {
        /// Its name.
        name: &'static str,
        /// The backend.
        backend: &'static str,
    },
    /// A method that this backend has by the feature `catalogue`, without which it was built.
    NotCompiled {
        /// Its name.
        name: &'static str,
        /// The backend.
        backend: &'static str,
    },
    /// A scheduler or a front for a method that has no pairs of nodes to schedule or to keep.
    NoPairsOfNodes {
        /// Its name, or that of its traversal.
        method: &'static str,
    },
    /// A setting of a method that is out of its range.
    Setting {
        /// Which.
        name: &'static str,
        /// The value given.
        value: u64,
        /// The least that it may be.
        least: u64,
        /// The greatest that it may be.
        greatest: u64,
    },
    /// A thread pool of the wanted size is too large, or could not be started.
    Threads {
        /// Threads asked for.
        count: usize,
        /// Most that are possible.
        limit: usize,
    },
    /// A session would hold more memory than [`Options::max_memory`](super::options::Options)
    /// allows. It was not allocated.
    Memory {
        /// What the memory is for.
        what: &'static str,
        /// Bytes wanted for it, besides those that are held.
        bytes: u64,
        /// Bytes that the session holds.
        held: u64,
        /// Bytes that it may hold.
        limit: u64,
    },
    /// A vertex is farther from the step that candidates were found for than their inflation.
    Beyond {
        /// 0 for the start of the step, 1 for its end.
        time: u8,
        /// Index of the vertex.
        vertex: usize,
    },
    /// Bodies were to move before anybody said where all vertices are.
    NoPositions,
    /// Positions of another number of vertices than a body has that was to move.
    BodyPositions {
        /// Its name.
        body: u32,
        /// 0 for the start of the step, 1 for its end.
        time: u8,
        /// Vertices of the body.
        expected: usize,
        /// Positions that were given.
        found: usize,
    },
    /// A body was to move twice in one step.
    RepeatedBody {
        /// Its name.
        body: u32,
    },
    /// A body was to move by positions in `f64` where those of all vertices are in `f32`.
    MixedPrecision {
        /// Its name.
        body: u32,
    },
    /// The session's cancel token was cancelled.
    Cancelled,
}

impl Error {
    /// Most vertices, edges, faces or boxes: ids are 32 bits, and a tree over `n` boxes numbers
    /// `2 n - 1` nodes.
    pub const MAX_ELEMENTS: u64 = (1 << 31) - 1;
    /// Greatest absolute coordinate that is accepted: cubes of differences must stay finite in
    /// `f64`.
    pub const MAX_COORDINATE: f64 = 1e100;
}

impl core::error::Error for Error {}
