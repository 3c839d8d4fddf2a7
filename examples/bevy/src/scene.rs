//! What there is to see: a cloth above a sphere, a camera, a light. Bevy's two meshes and ccd's one
//! have the same vertices.

use crate::contacts::Scene;
use bevy::asset::RenderAssetUsages;
use bevy::camera::visibility::NoFrustumCulling;
use bevy::core_pipeline::tonemapping::Tonemapping;
use bevy::mesh::{Indices, PrimitiveTopology, VertexAttributeValues};
use bevy::prelude::*;
use bevy::render::storage::ShaderBuffer;

/// Vertices on a side of the cloth.
const SIDE: u32 = 60;
/// Metres between two of them.
const SPACING: f32 = 0.035;
/// Metres.
const RADIUS: f32 = 0.7;

/// Spawns all of it. `read_paths`: see [`Scene`].
pub fn spawn(world: &mut World, read_paths: bool) -> Result<Scene> {
    let half = SPACING * (SIDE - 1) as f32 / 2.0;
    let at = |v: u32| [v % SIDE, v / SIDE].map(|i| i as f32 * SPACING - half);
    let cloth = |v| -> [f32; 3] { [at(v)[0], RADIUS + 0.1, at(v)[1]] };
    let mut positions: Vec<[f32; 3]> = (0..SIDE * SIDE).map(cloth).collect();
    let quads = (0..SIDE * (SIDE - 1)).filter(|v| v % SIDE != SIDE - 1);
    let mut indices: Vec<u32> =
        quads.flat_map(|v| [v, v + SIDE, v + 1, v + 1, v + SIDE, v + SIDE + 1]).collect();
    let drawn = Mesh::new(PrimitiveTopology::TriangleList, RenderAssetUsages::RENDER_WORLD)
        .with_inserted_attribute(Mesh::ATTRIBUTE_NORMAL, vec![[0.0, 1.0, 0.0]; positions.len()])
        .with_inserted_attribute(Mesh::ATTRIBUTE_POSITION, positions.clone())
        .with_inserted_indices(Indices::U32(indices.clone()));

    let sphere = Sphere::new(RADIUS).mesh().ico(12)?;
    let (n_cloth, first) = (positions.len(), positions.len() as u32);
    if let Some(VertexAttributeValues::Float32x3(more)) = sphere.attribute(Mesh::ATTRIBUTE_POSITION)
    {
        positions.extend(more);
    }
    indices.extend(sphere.indices().ok_or("no indices")?.iter().map(|i| first + i as u32));
    let body: Vec<u32> = (0..positions.len()).map(|v| (v >= n_cloth) as u32).collect();

    let mut buffers = world.resource_mut::<Assets<ShaderBuffer>>();
    let results = buffers.add(Scene::results(positions.len(), read_paths));
    let mut meshes = world.resource_mut::<Assets<Mesh>>();
    let (cloth, sphere) = (meshes.add(drawn), meshes.add(sphere));
    let mut materials = world.resource_mut::<Assets<StandardMaterial>>();
    let linen = materials.add(StandardMaterial {
        base_color: Color::srgb(0.25, 0.4, 0.65),
        perceptual_roughness: 0.9,
        double_sided: true,
        cull_mode: None,
        ..default()
    });
    let stone = materials.add(Color::srgb(0.75, 0.7, 0.65));
    // Bevy does not know where the GPU moves the cloth.
    world.spawn((Mesh3d(cloth.clone()), MeshMaterial3d(linen), NoFrustumCulling));
    world.spawn((Mesh3d(sphere), MeshMaterial3d(stone)));
    world.spawn((
        Camera3d::default(),
        // The default one needs tables that are a feature of Bevy.
        Tonemapping::AcesFitted,
        AmbientLight { brightness: 700.0, ..default() },
        Transform::from_xyz(1.0, 0.75, 2.1).looking_at(Vec3::new(-0.03, -0.03, 0.0), Vec3::Y),
    ));
    world.spawn((
        DirectionalLight { shadow_maps_enabled: true, illuminance: 6000.0, ..default() },
        Transform::from_xyz(0.0, 3.0, 2.5).looking_at(Vec3::ZERO, Vec3::Y),
    ));
    // Lines lie over what they are on.
    let mut gizmos = world.resource_mut::<GizmoConfigStore>();
    let (config, _) = gizmos.config_mut::<DefaultGizmoConfigGroup>();
    config.depth_bias = -0.01;

    Ok(Scene {
        mesh: ccd::Mesh::new(positions.len(), bytemuck::cast_slice::<u32, [u32; 3]>(&indices))?,
        options: ccd::Options::default().with_bodies(ccd::Bodies::new(&body).with_fixed(1, true)),
        positions,
        side: SIDE,
        spacing: SPACING,
        cloth,
        results,
        read_paths,
    })
}
