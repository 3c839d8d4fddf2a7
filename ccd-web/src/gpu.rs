//! A session on WebGPU, whose calls are awaited: the browser's thread may not wait for a device.

use crate::columns::{Columns, Places};
use crate::options::{RawMesh, RawOptions};
use crate::refused;
use crate::session::{Ends, shared, with_positions};
use crate::watch::watched;
use ccd::Aabb;
use ccd::gpu::wgpu::DeviceType;
use ccd::gpu::{BroadPhase, Device, DeviceOptions, Session};
use ccd::method::{BroadPhaseMethod, TreeOptions};
use wasm_bindgen::prelude::*;

/// A device of the browser.
#[wasm_bindgen]
pub struct RawDevice(Device);

#[wasm_bindgen]
impl RawDevice {
    /// The one that the browser prefers.
    pub async fn open() -> Result<RawDevice, JsError> {
        watched(Device::open_async(&DeviceOptions::default())).await.map(Self).map_err(refused)
    }

    /// The adapter's name, which a browser may keep to itself.
    pub fn name(&self) -> String {
        self.0.info().adapter.name.clone()
    }

    /// Whether a CPU plays the GPU.
    pub fn is_emulated(&self) -> bool {
        self.0.info().adapter.device_type == DeviceType::Cpu
    }

    /// Whether it was lost: no session on it works any more.
    pub fn is_lost(&self) -> bool {
        self.0.is_lost()
    }

    /// For tests: pairs of boxes that overlap, two ids each, by a tree, whose kernels even a
    /// browser without a GPU compiles in seconds. A box is its least coordinates, then its
    /// greatest.
    pub async fn box_pairs(&self, bounds: Vec<f32>) -> Result<Vec<u32>, JsError> {
        let (bounds, _) = bounds.as_chunks::<3>();
        let (boxes, _) = bounds.as_chunks::<2>();
        let boxes: Vec<Aabb<f32>> = boxes.iter().map(|&[min, max]| Aabb { min, max }).collect();
        let method = BroadPhaseMethod::Tree(TreeOptions::default());
        let mut broad = BroadPhase::new(&self.0, method).map_err(refused)?;
        let pairs = broad.self_pairs_async(&boxes).await.map_err(refused)?;
        Ok(pairs.iter().flat_map(|pair| [pair.a, pair.b]).collect())
    }
}

/// A session of the library on a device, with buffers for what goes in and comes out.
#[wasm_bindgen]
pub struct RawGpuSession {
    inner: Session,
    f32: Ends<f32>,
    f64: Ends<f64>,
    columns: Columns,
}

shared!(RawGpuSession);

#[wasm_bindgen]
impl RawGpuSession {
    #[wasm_bindgen(constructor)]
    pub fn new(
        device: &RawDevice,
        mesh: &RawMesh,
        options: &RawOptions,
    ) -> Result<RawGpuSession, JsError> {
        let inner = Session::new(&device.0, mesh.0.clone(), options.0.clone()).map_err(refused)?;
        let (f32, f64, columns) = Default::default();
        Ok(Self { inner, f32, f64, columns })
    }

    /// Finds the contacts in a window of time.
    pub async fn step(
        &mut self,
        in_f64: bool,
        from: f64,
        to: f64,
        geometry: bool,
    ) -> Result<(), JsError> {
        watched(self.fill(in_f64, [from, to], geometry)).await
    }

    /// The earliest time of impact.
    pub async fn earliest_toi(&mut self, in_f64: bool) -> Result<Option<f64>, JsError> {
        with_positions!(self, in_f64, session, x0, x1, {
            watched(session.earliest_toi_async(x0, x1)).await.map_err(refused)
        })
    }
}

impl RawGpuSession {
    /// Finds the contacts in a window of time, and fills the columns.
    async fn fill(
        &mut self,
        in_f64: bool,
        window: [f64; 2],
        geometry: bool,
    ) -> Result<(), JsError> {
        self.columns.clear();
        with_positions!(self, in_f64, session, x0, x1, {
            let report = session.step_window_async(x0, x1, window).await.map_err(refused)?;
            self.columns.fill(&report.contacts);
            if geometry {
                self.columns.fill_geometry(&report.contacts, report.mesh(), [x0, x1]);
            }
        });
        Ok(())
    }
}
