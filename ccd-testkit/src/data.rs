//! The real scenes and their published answers, found through `CCD_DATA` or at `../shared/data`
//! beside the repository.

use ccd::io::{Frame, read_frame};
use std::path::{Path, PathBuf};

/// The folder with `scenes/`, `queries/`, `toi/`, `toi_f32/`; `Err` says why there is none.
pub fn data_dir() -> Result<PathBuf, String> {
    let dir = match std::env::var_os("CCD_DATA") {
        Some(dir) => PathBuf::from(dir),
        None => Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data"),
    };
    if dir.join("scenes").is_dir() {
        Ok(dir)
    } else {
        Err(format!("no data at {} (set CCD_DATA)", dir.display()))
    }
}

/// Two frames with exact candidate counts.
#[derive(Clone, Copy, Debug)]
pub struct Scene {
    /// Name of its folder.
    pub name: &'static str,
    /// File of the first frame.
    pub t0: &'static str,
    /// File of the second frame.
    pub t1: &'static str,
    /// Vertices, edges, faces.
    pub size: [usize; 3],
    /// Candidate pairs with `f64` boxes: vertex-face, edge-edge; only where they are published.
    pub candidates: Option<[u64; 2]>,
    /// Number that the files of its published contacts begin with.
    pub truth: Option<&'static str>,
}

/// All scenes of two frames.
pub const SCENES: [Scene; 7] = [
    Scene {
        name: "cloth-ball",
        t0: "frames/cloth_ball92.ply",
        t1: "frames/cloth_ball93.ply",
        size: [46_598, 138_825, 92_230],
        candidates: Some([1_655_541, 5_197_332]),
        truth: Some("92"),
    },
    Scene {
        name: "cloth-funnel",
        t0: "frames/227.ply",
        t1: "frames/228.ply",
        size: [9_450, 27_930, 18_484],
        candidates: Some([7_319, 33_770]),
        truth: Some("227"),
    },
    Scene {
        name: "rod-twist",
        t0: "frames/3036.ply",
        t1: "frames/3037.ply",
        size: [39_940, 119_796, 79_864],
        candidates: Some([448_270, 2_041_334]),
        truth: Some("3036"),
    },
    Scene {
        name: "rb-hashgrid",
        t0: "t0.ply",
        t1: "t1.ply",
        size: [7_656, 19_601, 13_066],
        candidates: Some([7_629, 26_856]),
        truth: None,
    },
    Scene {
        name: "debris-wall",
        t0: "frames/060.ply",
        t1: "frames/061.ply",
        size: [4_604, 9_249, 4_848],
        candidates: Some([48_008, 129_681]),
        truth: None,
    },
    Scene {
        name: "thick-cloth",
        t0: "t0.ply",
        t1: "t1.ply",
        size: [233, 0, 404],
        candidates: None,
        truth: None,
    },
    Scene {
        name: "two-cubes",
        t0: "two-cubes-far.ply",
        t1: "two-cubes-intersecting.ply",
        size: [244, 0, 480],
        candidates: None,
        truth: None,
    },
];

impl Scene {
    /// The scene of that name.
    pub fn named(name: &str) -> &'static Scene {
        SCENES.iter().find(|s| s.name == name).unwrap_or_else(|| panic!("no scene {name}"))
    }

    /// Both frames.
    pub fn load(&self, data: &Path) -> [Frame; 2] {
        [self.t0, self.t1].map(|file| {
            let path = data.join("scenes").join(self.name).join(file);
            read_frame(&path).unwrap_or_else(|e| panic!("{e}"))
        })
    }

    /// All published pairs of a kind (`"vf"` or `"ee"`) with their answers and exact times.
    pub fn contacts(&self, data: &Path, kind: &str) -> Vec<Truth> {
        let number =
            self.truth.unwrap_or_else(|| panic!("{} has no published contacts", self.name));
        let folder = data.join("scenes").join(self.name);
        let pairs = json(&folder.join(format!("boxes/{number}{kind}.json")));
        let answers = json(&folder.join(format!("mma_bool/{number}{kind}_mma_bool.json")));
        let times =
            read_times(&data.join("toi").join(format!("{}_queries_{number}{kind}.csv", self.name)));
        let [n_vertices, n_edges, _] = self.size.map(|n| n as u64);
        let (pairs, answers) =
            (pairs.as_array().expect("a list"), answers.as_array().expect("a list"));
        assert_eq!(
            (pairs.len(), answers.len()),
            (times.len(), times.len()),
            "{} {kind}",
            self.name
        );
        let id = |v: &serde_json::Value| v.as_u64().expect("an id");
        (0..pairs.len())
            .map(|i| {
                let (a, b) = (id(&pairs[i][0]), id(&pairs[i][1]));
                let hit = answers[i].as_bool().expect("a Boolean");
                let (a, b) = if kind == "vf" {
                    (a.min(b), a.max(b) - n_vertices - n_edges)
                } else {
                    (a.min(b) - n_vertices, a.max(b) - n_vertices)
                };
                Truth { a: a as u32, b: b as u32, hit, toi: times[i].toi }
            })
            .collect()
    }
}

/// A published pair.
#[derive(Clone, Copy, Debug)]
pub struct Truth {
    /// Vertex, or lesser edge id.
    pub a: u32,
    /// Face, or greater edge id.
    pub b: u32,
    /// Whether it is a contact.
    pub hit: bool,
    /// Lower end of the exact earliest time, if it is one.
    pub toi: Option<f64>,
}

/// A row of a file of exact times.
#[derive(Clone, Copy, Debug)]
pub struct Time {
    /// The exact answer for the coordinates that the folder stands for.
    pub hit: bool,
    /// Lower end of the exact earliest time.
    pub toi: Option<f64>,
}

/// Reads a file of `toi/` or `toi_f32/`.
pub fn read_times(path: &Path) -> Vec<Time> {
    let text = std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    text.lines()
        .skip(1)
        .map(|line| {
            let column: Vec<&str> = line.split(',').collect();
            Time { hit: column[2] == "1", toi: column[3].parse().ok() }
        })
        .collect()
}

/// The sets of published queries, and how many may end undecided in `f64` and, rounded to `f32`
/// first, in `f32` and then `f64`: what was seen when this was written, upper limits.
pub const QUERY_SETS: [(&str, [u64; 2]); 11] = [
    ("erleben-cube-cliff-edges", [252, 252]),
    ("erleben-cube-internal-edges", [38, 38]),
    ("erleben-sliding-spike", [0, 0]),
    ("erleben-sliding-wedge", [0, 0]),
    ("erleben-spike-crack", [0, 0]),
    ("erleben-spike-hole", [0, 0]),
    ("erleben-spike-wedge", [0, 18]),
    ("erleben-spikes", [33, 72]),
    ("erleben-wedge-crack", [0, 0]),
    ("erleben-wedges", [4, 136]),
    ("unit-tests", [52, 52]),
];

/// All query files with their name in `toi/`.
pub fn query_files(data: &Path) -> Vec<(PathBuf, String)> {
    let root = data.join("queries/sample-queries");
    let mut out = Vec::new();
    let sets = std::fs::read_dir(&root).unwrap_or_else(|e| panic!("{}: {e}", root.display()));
    for set in sets.map(|s| s.expect("a folder").path()).filter(|p| p.is_dir()) {
        for kind in ["vertex-face", "edge-edge"] {
            let files = std::fs::read_dir(set.join(kind)).expect("a folder of queries");
            for file in files.map(|f| f.expect("a file").path()) {
                let name = |p: &Path| p.file_name().expect("a name").to_string_lossy().into_owned();
                out.push((file.clone(), format!("{}_{kind}_{}", name(&set), name(&file))));
            }
        }
    }
    out.sort();
    out
}

fn json(path: &Path) -> serde_json::Value {
    let text = std::fs::read(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    serde_json::from_slice(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}
