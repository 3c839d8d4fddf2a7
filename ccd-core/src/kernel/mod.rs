//! Kernel bodies: one pure function per stage, called once per thread, the same on a CPU and on a GPU.
//!
//! Three shapes: *map* (thread `i` returns what it owns), *meet* (threads share words, through [`Words`]) and *emit* (an unknown number
//! of results: the body says which there are, its caller appends them to a list that counts also those for which it has no room). [`TABLE`] lists them.

pub mod contact_order;
pub mod memory;
pub mod probe;
pub mod sort;

/// Shared 32-bit words, as a kernel sees them: atomics on a CPU, a storage buffer on a GPU.
pub trait Words {
    /// Relaxed load of word `i`.
    fn load(&self, i: usize) -> u32;
    /// Relaxed store to word `i`.
    fn store(&self, i: usize, value: u32);
    /// Adds and returns the old value; acquires what others released by this call on the same word, releases what this thread
    /// stored before.
    fn add_acquire_release(&self, i: usize, value: u32) -> u32;
}

/// How results of two backends must compare.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parity {
    /// Equal bytes: integers, minima, maxima, comparisons.
    Exact,
    /// The same set, in any order.
    ExactSet,
    /// Every true contact is reported, with a time of impact that is not later than the exact one.
    NotLater,
}

/// What a kernel does with a buffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// Reads one [`crate::layout::Params`].
    Params,
    /// Reads.
    Read,
    /// Reads and writes, or adds to it atomically.
    Write,
}

/// A row of the kernel table.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    /// Name of the entry point.
    pub name: &'static str,
    /// Threads of a workgroup on a GPU.
    pub workgroup: u32,
    /// Buffers in the order of their bindings, from 0.
    pub bindings: &'static [Access],
    /// How backends compare.
    pub parity: Parity,
    /// Whether it needs `f64` and 64-bit integers.
    pub wide: bool,
}

macro_rules! table {
    ($($(#[$doc:meta])* $id:ident $name:literal $workgroup:literal [$($access:ident)*] $parity:ident $wide:literal;)*) => {
        /// A kernel of the table.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Id {
            $($(#[$doc])* $id,)*
        }

        /// Every kernel with an entry point, in the order of [`Id`]: pipelines, bind groups and parity tests are made from it.
        pub const TABLE: &[Kernel] = &[
            $(Kernel { name: $name, workgroup: $workgroup, bindings: &[$(Access::$access),*], parity: Parity::$parity, wide: $wide },)*
        ];
    };
}

table! {
    /// Vertices in `f64`: params, positions; paths, keys, boxes.
    PlaceVertices "place_vertices" 256 [Params Read Write Write Write] Exact true;
    /// Boxes of vertices: params, paths; boxes.
    SweepVertices "sweep_vertices" 256 [Params Read Write] Exact false;
    /// Boxes of edges: params, edges; boxes.
    SweepEdges "sweep_edges" 256 [Params Read Write] Exact false;
    /// Boxes of faces: params, faces; boxes.
    SweepFaces "sweep_faces" 256 [Params Read Write] Exact false;
    /// Paths up to the earliest time of impact so far: params, paths, time by kind; paths.
    Shorten "shorten" 256 [Params Read Read Read Write] NotLater false;
    /// Bounds of all boxes: params, boxes; six words.
    SceneBounds "scene_bounds" 256 [Params Read Write] Exact false;
    /// Sort keys: params, boxes, bounds; keys, values.
    Morton "morton" 256 [Params Read Read Write Write] Exact false;
    /// Digits of each tile: params, keys; table.
    SortCount "sort_count" 128 [Params Read Write] Exact false;
    /// Sums of the table: params; table.
    SortScan "sort_scan" 256 [Params Write] Exact false;
    /// One pass of the sort: params, table, keys, values; keys, values.
    SortScatter "sort_scatter" 128 [Params Read Read Read Write Write] Exact false;
    /// Leaves in order and the nodes above: params, boxes, order, edges, faces; nodes, leaves.
    FitLeaves "fit_leaves" 256 [Params Read Read Read Read Write Write] Exact false;
    /// Nodes of the next level: params; nodes.
    FitLevel "fit_level" 256 [Params Write] Exact false;
    /// Internal nodes of a binary tree over set 1, the only one: params, keys; branches.
    Branches "branches" 256 [Params Read Write] Exact false;
    /// Boxes of a binary tree: params, branches, block nodes, leaves; nodes.
    BranchBoxes "branch_boxes" 256 [Params Read Read Read Write] Exact false;
    /// Leaves of a binary tree that overlap each other: params, nodes, branches; pairs.
    TraverseHalf "traverse_half" 128 [Params Read Read Write] ExactSet false;
    /// Loose boxes that overlap leaves of a binary tree: params, boxes, nodes, branches; pairs.
    TraverseAgainst "traverse_against" 128 [Params Read Read Read Write] ExactSet false;
    /// Pairs of nodes to pairs of their children: params, nodes, pairs; pairs.
    NodePairs "node_pairs" 128 [Params Read Read Write] ExactSet false;
    /// Pairs of blocks to candidates: params, nodes, leaves, bodies, keys, pairs; pairs.
    ListCandidates "list_candidates" 128 [Params Read Read Read Read Read Write] ExactSet false;
    /// Pairs of blocks to filtered vertex-face candidates: params, nodes, leaves, bodies, keys, paths, pairs; pairs.
    FilterVertexFace "filter_vertex_face" 128 [Params Read Read Read Read Read Read Write] NotLater false;
    /// Pairs of blocks to filtered edge-edge candidates: as for vertices and faces.
    FilterEdgeEdge "filter_edge_edge" 128 [Params Read Read Read Read Read Read Write] NotLater false;
    /// Verdicts in `f32`: params, paths, faces, pairs; contacts, undecided pairs, time.
    DecideVertexFace "decide_vertex_face" 64 [Params Read Read Read Write Write Write] NotLater false;
    /// Verdicts in `f32`: params, paths, edges, pairs; contacts, undecided pairs, time.
    DecideEdgeEdge "decide_edge_edge" 64 [Params Read Read Read Write Write Write] NotLater false;
    /// Verdicts in `f64`: params, paths, wide paths, faces, pairs; contacts, time.
    DecideVertexFaceWide "decide_vertex_face_wide" 64 [Params Read Read Read Read Write Write] NotLater true;
    /// Verdicts in `f64`: params, paths, wide paths, edges, pairs; contacts, time.
    DecideEdgeEdgeWide "decide_edge_edge_wide" 64 [Params Read Read Read Read Write Write] NotLater true;
    /// Keys of contacts, and their numbers in the first of two sorts: params, contacts; keys, order.
    ContactKeys "contact_keys" 256 [Params Read Write Write] Exact false;
    /// Contacts in order: params, contacts, order; contacts.
    OrderContacts "order_contacts" 256 [Params Read Read Write] Exact false;
    /// For tests: fields of records: params, paths, leaves, contacts, pairs; words.
    ProbeLayout "probe_layout" 64 [Params Read Read Read Read Write] Exact false;
    /// For tests: scalar operations: inputs; results.
    ProbeScalars "probe_scalars" 64 [Read Write] Exact false;
    /// For tests: scalar operations in `f64`: inputs; results.
    ProbeWide "probe_wide" 64 [Read Write] Exact true;
}

impl Id {
    /// The kernel's row.
    pub fn row(self) -> &'static Kernel {
        &TABLE[self as usize]
    }
}
