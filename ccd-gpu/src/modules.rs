//! The compiled shaders, one SPIR-V and one WGSL file a kernel; `cargo xtask shaders` writes them.

use ccd_core::kernel::Id;

/// The two forms of a kernel.
pub struct Module {
    pub spirv: &'static [u8],
    pub wgsl: &'static str,
}

macro_rules! modules {
    ($($id:ident $name:literal,)*) => {
        /// The module of a kernel.
        pub fn module(id: Id) -> Module {
            match id {
                $(Id::$id => Module {
                    spirv: include_bytes!(concat!("../shaders/", $name, ".spv")),
                    wgsl: include_str!(concat!("../shaders/", $name, ".wgsl")),
                },)*
            }
        }
    };
}

modules! {
    PlaceVertices "place_vertices",
    SweepVertices "sweep_vertices",
    SweepEdges "sweep_edges",
    SweepFaces "sweep_faces",
    Shorten "shorten",
    SceneBounds "scene_bounds",
    Morton "morton",
    SortCount "sort_count",
    SortScan "sort_scan",
    SortScatter "sort_scatter",
    FitLeaves "fit_leaves",
    FitLevel "fit_level",
    Branches "branches",
    BranchBoxes "branch_boxes",
    TraverseHalf "traverse_half",
    TraverseAgainst "traverse_against",
    NodePairs "node_pairs",
    ListCandidates "list_candidates",
    FilterVertexFace "filter_vertex_face",
    FilterEdgeEdge "filter_edge_edge",
    DecideVertexFace "decide_vertex_face",
    DecideEdgeEdge "decide_edge_edge",
    DecideVertexFaceWide "decide_vertex_face_wide",
    DecideEdgeEdgeWide "decide_edge_edge_wide",
    ContactKeys "contact_keys",
    OrderContacts "order_contacts",
    ProbeLayout "probe_layout",
    ProbeScalars "probe_scalars",
    ProbeWide "probe_wide",
}
