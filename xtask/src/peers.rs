//! Times of other libraries.

/// Those of a scene.
pub struct Peer {
    pub scene: &'static str,
    pub kitten: [&'static str; 2],
    pub scalable: &'static str,
}

/// Times of other libraries on an NVIDIA H200, on another day: Kitten's build and query over the
/// boxes of edges and of faces, and all stages of Scalable-CCD [Belgrod 2023], in milliseconds.
pub const PEERS: [Peer; 3] = [
    Peer { scene: "cloth-ball", kitten: ["2.07", "1.92"], scalable: "138" },
    Peer { scene: "rod-twist", kitten: ["1.13", "0.96"], scalable: "59" },
    Peer { scene: "cloth-funnel", kitten: ["0.34", ""], scalable: "23" },
];
