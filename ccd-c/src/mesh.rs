//! Meshes and positions: topology by indices with a stride, positions by bytes with a stride.

use crate::memory::{bytes, list, rows, shared, write};
use crate::results::{CcdPair, CcdPairs};
use crate::status::{CcdStatus, Failure, guard, guard_value};
use ccd::positions::{AsPositions, PositionView, Precision, Strided};
use ccd::{Coordinate, Mesh};
use std::ffi::c_void;
use std::ptr::{null, null_mut};
use std::sync::Arc;

/// Topology of a triangle mesh, which stays the same while vertices move. Not changed once it is
/// made, so many threads and sessions may use it at once.
pub struct CcdMesh {
    pub(crate) mesh: Arc<Mesh>,
}

/// Type of coordinates.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CcdComponent {
    /// `float`
    F32 = 0,
    /// `double`
    F64 = 1,
}

/// Positions of vertices: x, y, z one behind the other, the next vertex a stride later. They are
/// read where they are if they are aligned and without gaps, else copied.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct CcdPositions {
    /// The first coordinate of the first vertex; any address. NULL if there are no vertices.
    pub data: *const c_void,
    /// Bytes from one vertex to the next; 0 for those without a gap. No bytes are needed behind the
    /// last vertex.
    pub stride: usize,
    /// Number of vertices: that of the mesh.
    pub count: usize,
    /// A CcdComponent; the same at both ends of a step.
    pub component: u32,
}

/// Makes a mesh.
///
/// `triangles`: three indices of vertices a triangle, `triangle_stride` bytes from one triangle to
/// the next (0: 12). Edges are derived. A triangle that names a vertex twice is kept.
///
/// Fails with CCD_STATUS_INVALID_INPUT for an index out of range and for more than 2^31 - 1
/// elements.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_mesh_create(
    vertex_count: usize,
    triangles: *const u32,
    triangle_count: usize,
    triangle_stride: usize,
    mesh: *mut *mut CcdMesh,
) -> CcdStatus {
    let (n, stride) = (triangle_count, triangle_stride);
    // SAFETY: the caller's pointers, by the header's first comment.
    unsafe { ccd_mesh_create_with_edges(vertex_count, triangles, n, stride, null(), 0, 0, mesh) }
}

/// Makes a mesh with edges that no triangle has (rods, wires) besides those of the triangles: two
/// indices of vertices an edge, `edge_stride` bytes from one edge to the next (0: 8). Repeated
/// edges count once. All else as ccd_mesh_create.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_mesh_create_with_edges(
    vertex_count: usize,
    triangles: *const u32,
    triangle_count: usize,
    triangle_stride: usize,
    edges: *const u32,
    edge_count: usize,
    edge_stride: usize,
    mesh: *mut *mut CcdMesh,
) -> CcdStatus {
    guard(|| {
        // SAFETY: the caller's pointers, by the header's first comment.
        unsafe {
            write(mesh, "mesh", null_mut())?;
            let triangles = rows(triangles, triangle_count, triangle_stride, "triangles")?;
            let edges = rows(edges, edge_count, edge_stride, "edges")?;
            let new = Mesh::with_edges(vertex_count, &triangles, &edges)?;
            write(mesh, "mesh", Box::into_raw(Box::new(CcdMesh { mesh: Arc::new(new) })))
        }
    })
}

/// Destroys a mesh; NULL is ignored. Sessions that have it go on.
#[unsafe(no_mangle)]
pub extern "C" fn ccd_mesh_destroy(mesh: Option<Box<CcdMesh>>) {
    guard_value((), || drop(mesh));
}

/// Number of vertices, those of no triangle too; 0 of NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_mesh_vertex_count(mesh: *const CcdMesh) -> usize {
    // SAFETY: the caller's pointer, by the header's first comment.
    guard_value(0, || unsafe { shared(mesh, "mesh") }.map_or(0, |of| of.mesh.n_vertices()))
}

/// Number of triangles; 0 of NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_mesh_triangle_count(mesh: *const CcdMesh) -> usize {
    // SAFETY: the caller's pointer, by the header's first comment.
    guard_value(0, || unsafe { shared(mesh, "mesh") }.map_or(0, |of| of.mesh.faces().len()))
}

/// Edges: vertices `a < b`, sorted by `b`, then by `a`; the index is the id of the edge. Valid
/// until the mesh is destroyed; empty of NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_mesh_edges(mesh: *const CcdMesh) -> CcdPairs {
    guard_value(CcdPairs::EMPTY, || {
        // SAFETY: the caller's pointer, by the header's first comment.
        let of = unsafe { shared(mesh, "mesh") };
        // A pair is two numbers, as `[u32; 2]` is.
        of.map_or(CcdPairs::EMPTY, |of| {
            let edges = of.mesh.edges();
            CcdPairs { data: edges.as_ptr().cast::<CcdPair>(), count: edges.len() }
        })
    })
}

/// Positions at both ends of a step.
pub(crate) type Ends<'a> = Precision<[Points<'a, f32>; 2], [Points<'a, f64>; 2]>;

/// Positions where the caller has them.
#[derive(Clone, Copy)]
pub(crate) enum Points<'a, T> {
    InPlace(&'a [[T; 3]]),
    Strided(Strided<'a, T>),
}

impl<T: Coordinate> AsPositions for Points<'_, T> {
    type Scalar = T;

    fn as_positions(&self) -> PositionView<'_, T> {
        match self {
            Self::InPlace(points) => points.as_positions(),
            Self::Strided(points) => points.as_positions(),
        }
    }
}

/// Positions of both ends, in one precision.
///
/// # Safety
/// What is given is valid for reads, and written by nobody, for as long as `'a`.
pub(crate) unsafe fn ends<'a>(x0: &CcdPositions, x1: &CcdPositions) -> Result<Ends<'a>, Failure> {
    let component = x0.component;
    if component != x1.component {
        return Err(Failure::argument("x0 and x1 have different components"));
    }
    // SAFETY: the caller's duty.
    unsafe {
        if component == CcdComponent::F32 as u32 {
            Ok(Precision::F32([points(0, x0)?, points(1, x1)?]))
        } else if component == CcdComponent::F64 as u32 {
            Ok(Precision::F64([points(0, x0)?, points(1, x1)?]))
        } else {
            let why = format!("component is {component}; it must be a CcdComponent");
            Err(Failure::argument(why))
        }
    }
}

/// # Safety
/// As [`ends`].
unsafe fn points<'a, T: Coordinate>(time: u8, x: &CcdPositions) -> Result<Points<'a, T>, Failure> {
    let size = size_of::<[T; 3]>();
    let stride = if x.stride == 0 { size } else { x.stride };
    if stride < size {
        return Err(ccd::Error::Stride { time, stride, least: size }.into());
    }
    let name = ["x0.data", "x1.data"][usize::from(time)];
    let first = x.data.cast::<[T; 3]>();
    // SAFETY: the caller's duty. Every pattern of bits is a number.
    unsafe {
        if stride == size && first.is_aligned() {
            return Ok(Points::InPlace(list(first, x.count, name)?));
        }
        let bytes = bytes(x.data.cast(), [x.count, stride, size], name)?;
        Ok(Points::Strided(Strided::new(bytes, stride).count(x.count)))
    }
}

/// A call for positions of either precision.
macro_rules! with_ends {
    ($x:expr, |$x0:ident, $x1:ident| $call:expr) => {
        match $x {
            ccd::positions::Precision::F32([$x0, $x1]) => $call,
            ccd::positions::Precision::F64([$x0, $x1]) => $call,
        }
    };
}
pub(crate) use with_ends;
