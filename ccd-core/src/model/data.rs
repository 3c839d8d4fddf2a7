//! Meshes and bodies as data (feature `serde`): what their constructors take, so that what is read
//! is checked as what is given.

use super::bodies::{Bodies, Body};
use super::contact::Kind;
use super::error::Error;
use super::groups::Groups;
use super::mesh::Mesh;
use alloc::vec;
use alloc::vec::Vec;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// What [`Mesh::with_edges`] takes. `edges`: those that no face has; one that joins a vertex with
/// itself stands for each that was given so, because these are counted.
#[derive(Serialize, Deserialize)]
#[serde(rename = "Mesh", deny_unknown_fields)]
struct MeshData<Faces, Edges> {
    n_vertices: usize,
    faces: Faces,
    #[serde(default)]
    edges: Edges,
}

impl Serialize for Mesh {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (n_vertices, faces) = (self.n_vertices(), self.faces());
        let of_faces = Mesh::new(n_vertices, faces).map_err(serde::ser::Error::custom)?;
        let key = |&[a, b]: &[u32; 2]| (b, a);
        let is_side = |e: &[u32; 2]| of_faces.edges().binary_search_by_key(&key(e), key).is_ok();
        let mut edges = vec![[0, 0]; self.n_degenerate() - of_faces.n_degenerate()];
        edges.extend(self.edges().iter().filter(|edge| !is_side(edge)));
        MeshData { n_vertices, faces, edges }.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Mesh {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let data = MeshData::<Vec<[u32; 3]>, Vec<[u32; 2]>>::deserialize(deserializer)?;
        Mesh::with_edges(data.n_vertices, &data.faces, &data.edges).map_err(D::Error::custom)
    }
}

/// Bodies by name, each with its rules, and what is excluded.
#[derive(Serialize, Deserialize)]
#[serde(rename = "Bodies", deny_unknown_fields)]
struct BodiesData<Numbers> {
    body_of_vertex: Numbers,
    /// Of those that are left out, all is as by default.
    #[serde(default)]
    bodies: Vec<BodyData>,
    #[serde(default)]
    excluded_bodies: Vec<[u32; 2]>,
    #[serde(default)]
    excluded_features: Vec<(Kind, [u32; 2])>,
    #[serde(default)]
    fixed_may_move: bool,
}

/// The rules of one body.
#[derive(Serialize, Deserialize, PartialEq)]
#[serde(rename = "Body", default, deny_unknown_fields)]
struct BodyData {
    body: u32,
    self_contact: bool,
    fixed: bool,
    sleeping: bool,
    groups: Groups,
    world: u32,
}

impl Default for BodyData {
    fn default() -> Self {
        let (fixed, sleeping) = (false, false);
        Self { body: 0, self_contact: true, fixed, sleeping, groups: Groups::ALL, world: 0 }
    }
}

impl Serialize for Bodies {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if let Some(body) = self.unknown() {
            return Err(serde::ser::Error::custom(Error::NoBody { body }));
        }
        let names = self.names();
        let data = |(&body, rules): (&u32, &Body)| {
            let Body { self_contact, fixed, sleeping, groups, world } = *rules;
            BodyData { body, self_contact, fixed, sleeping, groups, world }
        };
        let differs =
            |data: &BodyData| *data != BodyData { body: data.body, ..BodyData::default() };
        let (excluded_bodies, excluded_features) =
            (self.excluded_bodies(), self.excluded_features());
        let name = |&[i, j]: &[u32; 2]| [names[i as usize], names[j as usize]];
        let data = BodiesData {
            body_of_vertex: self.body_of_vertex(),
            bodies: names.iter().zip(self.all()).map(data).filter(differs).collect(),
            excluded_bodies: excluded_bodies.iter().map(name).collect(),
            excluded_features: excluded_features.to_vec(),
            fixed_may_move: self.fixed_may_move(),
        };
        data.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Bodies {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let data = BodiesData::<Vec<u32>>::deserialize(deserializer)?;
        let mut bodies = Bodies::new(&data.body_of_vertex)
            .with_excluded_bodies(&data.excluded_bodies)
            .with_fixed_motion(data.fixed_may_move);
        for rules in data.bodies {
            bodies = bodies
                .with_self_contact(rules.body, rules.self_contact)
                .with_fixed(rules.body, rules.fixed)
                .with_sleeping(rules.body, rules.sleeping)
                .with_groups(rules.body, rules.groups)
                .with_world(rules.body, rules.world);
        }
        for kind in Kind::ALL {
            let all = data.excluded_features.iter();
            let pairs: Vec<_> = all.filter(|pair| pair.0 == kind).map(|pair| pair.1).collect();
            bodies = bodies.with_excluded_features(kind, &pairs);
        }
        match bodies.unknown() {
            Some(body) => Err(D::Error::custom(Error::NoBody { body })),
            None => Ok(bodies),
        }
    }
}
