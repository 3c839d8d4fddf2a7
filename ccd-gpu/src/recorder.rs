//! Recording: dispatches by the kernel table, their parameters, bind groups that are kept, stages
//! that are timed.

use crate::bind::{Bind, PARAMS_BYTES};
use crate::device::Device;
use crate::error::Error;
use crate::readback::{Part, Reading, map};
use ccd_core::kernel::Id;
use ccd_core::layout::Params;
use std::collections::HashMap;

/// Bytes between the parameters of two dispatches.
const PARAMS_STRIDE: u64 = PARAMS_BYTES as u64;
/// Dispatches of one recording, at most.
const MAX_DISPATCHES: u64 = 2048;
/// Stages of one recording, at most.
const MAX_STAGES: u32 = 32;

/// What timestamps of the device tell.
///
/// ```no_run
/// use ccd_gpu::{Error, Session, Timing};
///
/// fn show(session: &mut Session, x: &[[f32; 3]]) -> Result<(), Error> {
///     session.set_timing(Timing::Stages)?;
///     session.step(x, x)?;
///     session.stages().iter().for_each(|(name, ms)| println!("{name}: {ms:.3} ms"));
///     Ok(())
/// }
/// # let _ = show;
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Timing {
    /// Nothing.
    #[default]
    Off,
    /// All kernels of a call together. Nothing waits for this.
    Whole,
    /// Each stage by itself: none begins before the last has ended, so together they take longer
    /// than the whole.
    Stages,
    /// Kernels rather than stages, where a stage has several.
    Kernels,
}

/// Buffers for parameters and timestamps, bind groups; kept between recordings.
pub struct Bench {
    device: Device,
    params: wgpu::Buffer,
    /// Dispatches for which there are parameters.
    most: u64,
    groups: HashMap<(Id, Vec<wgpu::Buffer>), wgpu::BindGroup>,
    timing: Timing,
    timer: Option<Timer>,
    /// Workgroups of a row of the grid, at most.
    pub fold: u32,
}

struct Timer {
    queries: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    read: wgpu::Buffer,
}

impl Bench {
    pub fn new(device: &Device) -> Result<Self, Error> {
        Self::of(device, MAX_DISPATCHES)
    }

    /// For recordings of at most so many dispatches.
    pub fn of(device: &Device, most: u64) -> Result<Self, Error> {
        use wgpu::BufferUsages as U;
        let params = device.buffer("parameters", PARAMS_STRIDE * most, U::STORAGE | U::COPY_DST)?;
        Ok(Self {
            device: device.clone(),
            params,
            most,
            groups: HashMap::new(),
            timing: Timing::Off,
            timer: None,
            fold: device.info().limits.max_compute_workgroups_per_dimension.min(65_535),
        })
    }

    /// Sets what is timed; where there are no timestamps, nothing is.
    pub fn set_timing(&mut self, timing: Timing) -> Result<(), Error> {
        self.timing = if self.device.info().timestamps { timing } else { Timing::Off };
        if self.timing == Timing::Off || self.timer.is_some() {
            return Ok(());
        }
        use wgpu::BufferUsages as U;
        let bytes = MAX_STAGES as u64 * 16;
        let queries = wgpu::QuerySetDescriptor {
            label: Some("stages"),
            ty: wgpu::QueryType::Timestamp,
            count: 2 * MAX_STAGES,
        };
        self.timer = Some(Timer {
            queries: self
                .device
                .guarded("timestamps", bytes, || self.device.wgpu().create_query_set(&queries))?,
            resolved: self.device.buffer("timestamps", bytes, U::QUERY_RESOLVE | U::COPY_SRC)?,
            read: self.device.buffer("timestamps", bytes, U::MAP_READ | U::COPY_DST)?,
        });
        Ok(())
    }

    /// Forgets bind groups: call when a buffer was replaced.
    pub fn forget(&mut self) {
        self.groups.clear();
    }

    /// Starts recording into `encoder`.
    pub fn record<'a>(&'a mut self, encoder: &'a mut wgpu::CommandEncoder) -> Recorder<'a> {
        Recorder {
            bench: self,
            encoder,
            pass: None,
            params: Vec::new(),
            stages: Vec::new(),
            ended: false,
        }
    }

    /// Milliseconds between the first and the last timestamp of each stage that was recorded last;
    /// the work must be done.
    pub fn times(&self, stages: &[&'static str]) -> Result<Vec<(&'static str, f64)>, Error> {
        let Some(timer) = self.timer.as_ref().filter(|_| !stages.is_empty()) else {
            return Ok(Vec::new());
        };
        let ticks: Vec<u64> = map(&self.device, &timer.read, stages.len() as u64 * 16, |bytes| {
            bytes
                .chunks_exact(8)
                .map(|b| u64::from_le_bytes(b.try_into().unwrap_or_default()))
                .collect()
        })?;
        let period = self.device.queue().get_timestamp_period() as f64 * 1e-6;
        Ok(stages
            .iter()
            .zip(ticks.chunks_exact(2))
            .map(|(name, t)| (*name, t[1].saturating_sub(t[0]) as f64 * period))
            .collect())
    }
}

/// One recording.
pub struct Recorder<'a> {
    bench: &'a mut Bench,
    encoder: &'a mut wgpu::CommandEncoder,
    pass: Option<wgpu::ComputePass<'static>>,
    params: Vec<u8>,
    stages: Vec<&'static str>,
    /// Whether the timestamp at the end of the whole is recorded.
    ended: bool,
}

impl Recorder<'_> {
    /// A new stage begins: dispatches without copies between them, which are one pass.
    pub fn stage(&mut self, name: &'static str) {
        if matches!(self.bench.timing, Timing::Stages | Timing::Kernels)
            && self.stages.len() < MAX_STAGES as usize
        {
            self.pass = None;
            self.stages.push(name);
        }
    }

    /// A part of a stage, which is timed by itself if kernels are.
    pub fn detail(&mut self, name: &'static str) {
        if self.bench.timing == Timing::Kernels {
            self.stage(name);
        }
    }

    /// The last kernel was recorded; what comes now only hands results over.
    pub fn end_of_work(&mut self) {
        self.pass = None;
        if self.bench.timing == Timing::Whole
            && !self.stages.is_empty()
            && !self.ended
            && let Some(timer) = &self.bench.timer
        {
            let writes = wgpu::ComputePassTimestampWrites {
                query_set: &timer.queries,
                beginning_of_pass_write_index: None,
                end_of_pass_write_index: Some(1),
            };
            self.encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
                label: Some("end"),
                timestamp_writes: Some(writes),
            });
        }
        self.ended = true;
    }

    /// Sets the first `bytes` of a buffer to zero.
    pub fn clear(&mut self, buffer: &wgpu::Buffer, bytes: u64) {
        self.pass = None;
        self.encoder.clear_buffer(buffer, 0, Some(bytes));
    }

    /// Copies between buffers.
    pub fn copy(
        &mut self,
        from: &wgpu::Buffer,
        from_byte: u64,
        to: &wgpu::Buffer,
        to_byte: u64,
        bytes: u64,
    ) {
        self.pass = None;
        self.encoder.copy_buffer_to_buffer(from, from_byte, to, to_byte, bytes);
    }

    /// Copies a part of what is read back, from byte `first` of `from` on.
    pub fn read(&mut self, reading: &Reading, part: Part, from: &wgpu::Buffer, first: u64) {
        if part.bytes > 0 {
            self.copy(from, first, &reading.buffer, part.at, part.bytes);
        }
    }

    /// Runs a kernel with a thread for each of `n` items.
    pub fn each<'b, K: Bind<&'b wgpu::Buffer>>(
        &mut self,
        kernel: &K,
        params: &Params<K::Own>,
        n: u32,
    ) {
        self.dispatch(kernel, params, n.div_ceil(K::ID.threads()));
    }

    /// Runs a kernel with `groups` workgroups.
    pub fn dispatch<'b, K: Bind<&'b wgpu::Buffer>>(
        &mut self,
        kernel: &K,
        params: &Params<K::Own>,
        groups: u32,
    ) {
        let buffers: Vec<&wgpu::Buffer> = kernel.buffers().into_iter().copied().collect();
        self.run(K::ID, params.parts(), &buffers, groups);
    }

    /// Runs a kernel by its id. `params`: parts of [`Params`]; `buffers`: in the order of the
    /// table.
    pub fn run(&mut self, id: Id, params: [&[u8]; 3], buffers: &[&wgpu::Buffer], groups: u32) {
        if groups == 0 {
            return;
        }
        let bench = &mut *self.bench;
        let pipeline = bench.device.pipeline(id);
        let takes_params = id.row().params.is_some();
        let key = (id, buffers.iter().map(|&b| b.clone()).collect::<Vec<_>>());
        let group = bench.groups.entry(key).or_insert_with(|| {
            let size = wgpu::BufferSize::new(PARAMS_STRIDE);
            let params = wgpu::BufferBinding { buffer: &bench.params, offset: 0, size };
            let first = takes_params.then_some(wgpu::BindingResource::Buffer(params));
            let resources = first.into_iter().chain(buffers.iter().map(|b| b.as_entire_binding()));
            let entries: Vec<_> = resources
                .enumerate()
                .map(|(i, resource)| wgpu::BindGroupEntry { binding: i as u32, resource })
                .collect();
            let descriptor = wgpu::BindGroupDescriptor {
                label: Some(id.row().name),
                layout: &pipeline.layout,
                entries: &entries,
            };
            bench.device.wgpu().create_bind_group(&descriptor)
        });
        let pass = self.pass.get_or_insert_with(|| {
            let writes = match bench.timing {
                Timing::Off => None,
                // With the first kernel, because uploads arrive until then.
                Timing::Whole if self.stages.is_empty() => {
                    self.stages.push("whole");
                    Some((0, None))
                }
                Timing::Whole => None,
                Timing::Stages | Timing::Kernels => {
                    let last = self.stages.len().checked_sub(1).map(|last| 2 * last as u32);
                    last.map(|at| (at, Some(at + 1)))
                }
            };
            let timestamp_writes = bench.timer.as_ref().zip(writes).map(|(timer, (begin, end))| {
                wgpu::ComputePassTimestampWrites {
                    query_set: &timer.queries,
                    beginning_of_pass_write_index: Some(begin),
                    end_of_pass_write_index: end,
                }
            });
            self.encoder
                .begin_compute_pass(&wgpu::ComputePassDescriptor {
                    label: Some("ccd"),
                    timestamp_writes,
                })
                .forget_lifetime()
        });
        pass.set_pipeline(&pipeline.pipeline);
        if takes_params {
            let offset = self.params.len() as u32;
            params.iter().for_each(|part| self.params.extend_from_slice(part));
            self.params.resize(offset as usize + PARAMS_STRIDE as usize, 0);
            pass.set_bind_group(0, &*group, &[offset]);
        } else {
            pass.set_bind_group(0, &*group, &[]);
        }
        // Folded: the kernels take the number of a workgroup from both dimensions.
        let x = groups.min(bench.fold);
        pass.dispatch_workgroups(x, groups.div_ceil(x), 1);
    }

    /// Ends the recording: uploads the parameters. Returns the stages.
    pub fn finish(mut self) -> Result<Vec<&'static str>, Error> {
        self.end_of_work();
        let bytes = self.params.len() as u64;
        let limit = PARAMS_STRIDE * self.bench.most;
        if bytes > limit {
            return Err(Error::TooLarge { what: "parameters of dispatches", bytes, limit });
        }
        self.bench.device.queue().write_buffer(&self.bench.params, 0, &self.params);
        if let Some(timer) = &self.bench.timer
            && !self.stages.is_empty()
        {
            let n = self.stages.len() as u32;
            self.encoder.resolve_query_set(&timer.queries, 0..2 * n, &timer.resolved, 0);
            self.encoder.copy_buffer_to_buffer(&timer.resolved, 0, &timer.read, 0, n as u64 * 16);
        }
        Ok(self.stages)
    }
}

/// Records with `work`, submits, and returns the stages.
pub fn submit(
    device: &Device,
    bench: &mut Bench,
    work: impl FnOnce(&mut Recorder),
) -> Result<Vec<&'static str>, Error> {
    device.guarded("a frame", 0, || {
        let mut encoder = device
            .wgpu()
            .create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("ccd") });
        let mut recorder = bench.record(&mut encoder);
        work(&mut recorder);
        let stages = recorder.finish()?;
        device.queue().submit([encoder.finish()]);
        Ok(stages)
    })?
}
