//! From the caller's positions to what kernels read: paths in `f32` and, where those are not exact, the exact numbers besides.

use crate::device::Device;
use crate::error::Error;
use ccd_core::input::{Scan, margin};
use ccd_core::kernel::{blocks::bound_key, sweep};
use ccd_core::layout::{Params, Path, WidePath, split};
use ccd_core::real::Real;
use ccd_core::{Aabb, error};
use wgpu::BufferUsages as U;

/// Positions on the device.
pub struct Positions {
    pub paths: wgpu::Buffer,
    pub wide: wgpu::Buffer,
    pub keys: wgpu::Buffer,
    /// Numbers of the last upload.
    pub exact: bool,
    pub path_error: f32,
    pub slack: f32,
    /// Greatest absolute coordinate of paths.
    pub reach: f32,
    host_paths: Vec<Path>,
    host_wide: Vec<WidePath>,
    host_keys: Vec<[[u32; 2]; 6]>,
    host_boxes: Vec<Aabb>,
}

impl Positions {
    /// Room for the paths of `n` vertices.
    pub fn new(device: &Device, n: usize) -> Result<Self, Error> {
        let usage = U::STORAGE | U::COPY_DST | U::COPY_SRC;
        Ok(Self {
            paths: device.buffer("paths", (n * size_of::<Path>()) as u64, usage)?,
            // Made when first needed.
            wide: device.buffer("positions in f64", 0, usage)?,
            keys: device.buffer("keys of exact boxes", 0, usage)?,
            exact: true,
            path_error: 0.0,
            slack: 0.0,
            reach: 0.0,
            host_paths: Vec::new(),
            host_wide: Vec::new(),
            host_keys: Vec::new(),
            host_boxes: Vec::new(),
        })
    }

    /// Checks and uploads. Returns whether a buffer was replaced. `boxes`: where boxes of vertices go if kernels cannot make them.
    pub fn upload<T: Real>(
        &mut self,
        device: &Device,
        x0: &[[T; 3]],
        x1: &[[T; 3]],
        min_distance: f64,
        boxes: &wgpu::Buffer,
    ) -> Result<bool, Error> {
        let mut scan = Scan::NONE;
        for (p, q) in x0.iter().zip(x1) {
            scan.take(*p);
            scan.take(*q);
        }
        if !scan.finite {
            error::check_coordinates(0, x0)?;
            error::check_coordinates(1, x1)?;
        }
        let table = scan.table(true);
        self.exact = table.error == 0.0;
        self.path_error = table.error;
        let wide = |p: &[T; 3]| [p[0].to_f64(), p[1].to_f64(), p[2].to_f64()];
        let place = |p: &[T; 3]| {
            let p = table.place(wide(p));
            [p[0], p[1], p[2], 0.0]
        };
        self.host_paths.clear();
        self.host_paths.extend(x0.iter().zip(x1).map(|(p, q)| Path { t0: place(p), t1: place(q) }));
        let reach = if self.exact { scan.greatest() } else { (0..3).fold(0.0, |m: f64, k| m.max(scan.bounds.max[k] - scan.bounds.min[k])) };
        self.reach = reach.round_up();
        let queue = device.queue();
        queue.write_buffer(&self.paths, 0, bytemuck::cast_slice(&self.host_paths));
        // Rounded boxes: by rounding the input, or by growing exact ones.
        let rounded = scan.rounds_boxes::<T>(min_distance);
        self.slack = if rounded { scan.slack(min_distance) } else { 0.0 };
        let mut replaced = false;
        if !self.exact {
            self.host_wide.clear();
            self.host_wide.extend(x0.iter().zip(x1).map(|(p, q)| WidePath { t0: wide(p), t1: wide(q) }));
            replaced |= fill(device, "positions in f64", &mut self.wide, bytemuck::cast_slice(&self.host_wide))?;
        }
        if rounded {
            let margin: T = margin(min_distance);
            self.host_keys.clear();
            self.host_boxes.clear();
            for (p, q) in x0.iter().zip(x1) {
                let exact = sweep::swept(*p, *q).inflated(margin);
                let key = |x: T| bound_key(x.to_f64());
                let (min, max) = (exact.min, exact.max);
                self.host_keys.push([key(min[0]), key(min[1]), key(min[2]), key(max[0]), key(max[1]), key(max[2])]);
                self.host_boxes.push(exact.round_out());
            }
            replaced |= fill(device, "keys of exact boxes", &mut self.keys, bytemuck::cast_slice(&self.host_keys))?;
            queue.write_buffer(boxes, 0, bytemuck::cast_slice(&self.host_boxes));
        }
        Ok(replaced)
    }

    /// Whether boxes of vertices were uploaded.
    pub fn boxes_uploaded(&self) -> bool {
        self.slack > 0.0
    }

    /// Sets what kernels must know of the positions.
    pub fn params(&self, params: &mut Params, min_distance: f64) {
        params.path_error = self.path_error;
        params.slack = self.slack;
        params.margin = margin(min_distance);
        params.min_distance = min_distance.round_up();
        params.distance_bits = split(min_distance);
        params.flags |= if self.exact { Params::FLAG_EXACT } else { 0 };
        params.flags |= if self.slack > 0.0 { Params::FLAG_CONFIRM } else { 0 };
    }
}

/// Writes to the front of a buffer, which is replaced if it is too small. Returns whether it was.
fn fill(device: &Device, what: &'static str, buffer: &mut wgpu::Buffer, bytes: &[u8]) -> Result<bool, Error> {
    let replaced = buffer.size() < bytes.len() as u64;
    if replaced {
        *buffer = device.buffer(what, bytes.len() as u64, U::STORAGE | U::COPY_DST | U::COPY_SRC)?;
    }
    device.queue().write_buffer(buffer, 0, bytes);
    Ok(replaced)
}
