//! What there is as data (feature `serde`): written and read, it is the same; what is read is
//! checked.

use ccd::method::{
    BroadPhaseMethod, Builder, Front, FrontOptions, Pipeline, Scheduler, Scheduling, Traversal,
    TreeOptions, Volume,
};
use ccd::{Bodies, Groups, Kind, Mesh, Options, Report, State};
use serde::{Serialize, de::DeserializeOwned};

fn round<T: Serialize + DeserializeOwned>(value: &T) -> T {
    let text = serde_json::to_string(value).expect("it can be written");
    serde_json::from_str(&text).unwrap_or_else(|e| panic!("{e}: {text}"))
}

fn refused<T: DeserializeOwned>(text: &str) -> String {
    serde_json::from_str::<T>(text).err().expect("it is refused").to_string()
}

#[test]
fn meshes_are_checked() {
    let faces = [[4, 2, 1], [1, 2, 0], [3, 3, 0]];
    let plain = Mesh::new(5, &faces).unwrap();
    let text = serde_json::to_string(&plain).unwrap();
    assert_eq!(text, r#"{"n_vertices":5,"faces":[[4,2,1],[1,2,0],[3,3,0]],"edges":[]}"#);
    let wires = Mesh::with_edges(9, &faces, &[[8, 7], [4, 2], [5, 5], [6, 6], [0, 4]]).unwrap();
    for mesh in [plain, wires, Mesh::default(), Mesh::with_edges(3, &[], &[[2, 2]]).unwrap()] {
        assert_eq!(round(&mesh), mesh);
    }
    let why = refused::<Mesh>(r#"{"n_vertices":3,"faces":[[0,1,2],[0,7,2]]}"#);
    assert!(why.contains("face 1 refers to vertex 7, but there are 3 vertices"), "{why}");
    let why = refused::<Mesh>(r#"{"n_vertices":3,"faces":[],"edges":[[0,3]]}"#);
    assert!(why.contains("edge 0 refers to vertex 3"), "{why}");
    let why = refused::<Mesh>(r#"{"n_vertices":4294967296,"faces":[]}"#);
    assert!(why.contains("vertices: at most"), "{why}");
    refused::<Mesh>(r#"{"n_vertices":3,"faces":[[0,1,-2]]}"#);
}

#[test]
fn options_may_be_partial_but_not_misspelt() {
    let groups = Groups { memberships: 1, filter: 6 };
    let bodies = Bodies::new(&[7, 7, 3, 900])
        .with_fixed(3, true)
        .with_self_contacts(false)
        .with_sleeping(7, true)
        .with_groups(900, groups)
        .with_world(900, 2)
        .with_excluded_bodies(&[[900, 3]])
        .with_excluded_features(Kind::EdgeEdge, &[[9, 4]])
        .with_excluded_features(Kind::VertexFace, &[[3, 0]])
        .with_fixed_motion(true);
    let tree = TreeOptions::default().builder(Builder::PLOC).volume(Volume::Obb);
    let front = Front::On(FrontOptions::default().growth(200));
    let options = Options::default()
        .with_min_distance(0.1 + 0.2)
        .with_bodies(bodies)
        .with_pipeline(Pipeline::TRIANGLES)
        .with_broad_phase(BroadPhaseMethod::Tree(tree.traversal(Traversal::CUT)))
        .with_scheduling(Scheduling::default().scheduler(Scheduler::BALANCED).front(front));
    assert_eq!(round(&options), options);
    assert_eq!(round(&Options::default()), Options::default());
    for method in ccd::method::every("cpu") {
        assert_eq!(round(&method), method);
    }
    for scheduling in Scheduling::every("cpu") {
        assert_eq!(round(&scheduling), scheduling);
    }
    let read: Options =
        serde_json::from_str(r#"{"min_distance":0.5,"broad_phase":"sweep-and-prune"}"#).unwrap();
    let want =
        Options::default().with_min_distance(0.5).with_broad_phase(BroadPhaseMethod::SweepAndPrune);
    assert_eq!(read, want);
    let why = refused::<Options>(r#"{"min_distanse":0.5}"#);
    assert!(why.contains("min_distanse"), "{why}");
    let why = refused::<Bodies>(r#"{"body_of_vertex":[0,0],"bodies":[{"body":1,"fixed":true}]}"#);
    assert!(why.contains('1'), "{why}");
    // Values are checked where they are used, as those that a program sets.
    let bad: Options = serde_json::from_str(r#"{"min_distance":-1.0}"#).unwrap();
    assert!(bad.check(&Mesh::default()).is_err());
}

#[test]
fn reports_and_errors_are_data() {
    let step = ccd::scenes::crumpled_sheet(8, 1);
    let options = Options::default().with_pipeline(Pipeline::TRIANGLES);
    let report = ccd::step(&step.mesh, &step.x0, &step.x1, &options).unwrap();
    let read: Report = round(&report);
    assert!(!report.contacts.is_empty() && read.contacts == report.contacts);
    assert_eq!(
        (read.toi, read.candidates, read.triangles),
        (report.toi, report.candidates, report.triangles)
    );
    assert_eq!(read.times, report.times);
    // The mesh is written where it is wanted, not with every step.
    assert_eq!((report.mesh(), read.mesh().n_vertices()), (&step.mesh, 0));
    let words = serde_json::to_string(&[Kind::VertexFace, Kind::EdgeEdge]).unwrap();
    assert_eq!(words, r#"["vertex-face","edge-edge"]"#);
    assert_eq!(round(&State::Undecided), State::Undecided);
    let error = Mesh::new(1, &[[0, 0, 5]]).unwrap_err();
    let text = serde_json::to_string(&error).unwrap();
    assert_eq!(text, r#"{"index":{"element":"face","at":0,"vertex":5,"n_vertices":1}}"#);
}
