//! Recording: dispatches by the kernel table, their parameters, bind groups that are kept, stages
//! that are timed. Commands are kept until all are known, so that kernels which are used for the
//! first time compile side by side; then they are encoded.

use crate::bind::{Bind, PARAMS_BYTES};
use crate::device::Device;
use crate::error::Error;
use crate::readback::{Part, Reading};
use ahead::Encoded;
use ccd_core::backend::kernel::Id;
use ccd_core::backend::layout::Params;
use encoding::Encoding;
use std::collections::HashMap;

mod ahead;
mod encoding;
mod times;

pub use ahead::{submit, submit_frame};
pub use times::Times;

/// Bytes between the parameters of two dispatches.
const PARAMS_STRIDE: u64 = PARAMS_BYTES as u64;
/// Dispatches of one recording, at most.
const MAX_DISPATCHES: u64 = 2048;
/// Stages of one recording, at most: two for each of 16 rounds of both kinds, and others.
const MAX_STAGES: u32 = 128;

/// What timestamps of the device measure.
///
/// ```no_run
/// use ccd::gpu::{Error, Session, Timing};
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
    /// What the next frame is likely to do, by its goal.
    ahead: HashMap<u32, Encoded>,
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
            ahead: HashMap::new(),
            timing: Timing::Off,
            timer: None,
            fold: device.info().limits.max_compute_workgroups_per_dimension.min(65_535),
        })
    }

    /// What is timed.
    pub fn timing(&self) -> Timing {
        self.timing
    }

    /// Sets what is timed; where there are no timestamps, nothing is.
    pub fn set_timing(&mut self, timing: Timing) -> Result<(), Error> {
        let timing = if self.device.info().timestamps { timing } else { Timing::Off };
        if timing != self.timing {
            self.ahead.clear();
        }
        self.timing = timing;
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

    /// Goes on with a device of the same adapter that counts and reports by itself.
    pub fn use_device(&mut self, device: &Device) {
        self.device = device.clone();
        self.forget();
    }

    /// Forgets bind groups and commands: call when a buffer was replaced.
    pub fn forget(&mut self) {
        self.groups.clear();
        self.ahead.clear();
    }

    /// The bind groups of the kernels among commands, in their order.
    fn bind_groups(&mut self, commands: &[Command]) -> Result<Vec<wgpu::BindGroup>, Error> {
        let Self { device, params, groups, .. } = self;
        let group = |command: &Command| {
            let Command::Run { id, buffers, .. } = command else { return None };
            let entry = groups.entry((*id, buffers.clone()));
            let new = || bind_group(device, *id, params, buffers);
            Some(entry.or_insert_with(new).clone())
        };
        let made = device.guarded("bindings", 0, || commands.iter().filter_map(group).collect());
        if made.is_err() {
            // A bind group that the device refused exists all the same, and is of no use.
            self.forget();
        }
        made
    }

    /// Encodes commands whose kernels are compiled, with their bind groups. Returns the stages.
    fn encode(
        &self,
        commands: &[Command],
        groups: Vec<wgpu::BindGroup>,
        encoder: &mut wgpu::CommandEncoder,
    ) -> Vec<&'static str> {
        let mut encoding = Encoding::new(self, groups, encoder);
        encoding.encode(commands);
        encoding.finish()
    }

    /// Starts a recording.
    pub fn record(&mut self) -> Recorder<'_> {
        Recorder { bench: self, commands: Vec::new(), params: Vec::new() }
    }
}

/// One recording.
pub struct Recorder<'a> {
    bench: &'a mut Bench,
    commands: Vec<Command>,
    params: Vec<u8>,
}

/// A recorded command.
#[derive(PartialEq)]
enum Command {
    /// A stage begins.
    Stage(&'static str),
    /// The last kernel was recorded.
    EndOfWork,
    Clear {
        buffer: wgpu::Buffer,
        bytes: u64,
    },
    Copy {
        from: (wgpu::Buffer, u64),
        to: (wgpu::Buffer, u64),
        bytes: u64,
    },
    Run {
        id: Id,
        buffers: Vec<wgpu::Buffer>,
        groups: u32,
    },
    /// The last `n` kernels again, with the same parameters, until each ran so many times.
    Repeat {
        n: usize,
        times: u32,
    },
}

impl Recorder<'_> {
    /// A new stage begins: dispatches without copies between them, which are one pass. One without
    /// dispatches is not listed.
    pub fn stage(&mut self, name: &'static str) {
        if matches!(self.bench.timing, Timing::Stages | Timing::Kernels) {
            self.commands.push(Command::Stage(name));
        }
    }

    /// The stage that began last, if stages are timed.
    pub fn current_stage(&self) -> Option<&'static str> {
        self.commands.iter().rev().find_map(|command| match command {
            Command::Stage(name) => Some(*name),
            _ => None,
        })
    }

    /// A part of a stage, which is timed by itself if kernels are.
    pub fn detail(&mut self, name: &'static str) {
        if self.bench.timing == Timing::Kernels {
            self.stage(name);
        }
    }

    /// The last kernel was recorded; what comes now only hands results over.
    pub fn end_of_work(&mut self) {
        self.commands.push(Command::EndOfWork);
    }

    /// Sets the first `bytes` of a buffer to zero.
    pub fn clear(&mut self, buffer: &wgpu::Buffer, bytes: u64) {
        self.commands.push(Command::Clear { buffer: buffer.clone(), bytes });
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
        let (from, to) = ((from.clone(), from_byte), (to.clone(), to_byte));
        self.commands.push(Command::Copy { from, to, bytes });
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
        params: &Params<K::Args>,
        n: u32,
    ) {
        self.dispatch(kernel, params, n.div_ceil(K::ID.threads()));
    }

    /// Runs a kernel with `groups` workgroups, by subgroups if it can and the device has them.
    pub fn dispatch<'b, K: Bind<&'b wgpu::Buffer>>(
        &mut self,
        kernel: &K,
        params: &Params<K::Args>,
        groups: u32,
    ) {
        let buffers: Vec<&wgpu::Buffer> = kernel.buffers().into_iter().copied().collect();
        let by_subgroups = self.bench.device.info().subgroups;
        let id = if by_subgroups { K::ID.of_subgroups() } else { K::ID };
        self.run(id, params.parts(), &buffers, groups);
    }

    /// The same, over trees of oriented boxes if there are some.
    pub fn each_variant<'b, K: Bind<&'b wgpu::Buffer>>(
        &mut self,
        kernel: &K,
        oriented: Option<&'b wgpu::Buffer>,
        params: &Params<K::Args>,
        n: u32,
    ) {
        self.dispatch_variant(kernel, (oriented, false), params, n.div_ceil(K::ID.threads()));
    }

    /// Runs a variant of a kernel; see [`Id::variant`]. `oriented`: the buffer of oriented boxes.
    pub fn dispatch_variant<'b, K: Bind<&'b wgpu::Buffer>>(
        &mut self,
        kernel: &K,
        (oriented, steals): (Option<&'b wgpu::Buffer>, bool),
        params: &Params<K::Args>,
        groups: u32,
    ) {
        let id = K::ID.variant(oriented.is_some(), steals);
        let mut buffers: Vec<&wgpu::Buffer> = kernel.buffers().into_iter().copied().collect();
        let place = id.row().buffers.iter().position(|(name, _)| *name == "oriented");
        if let Some((place, oriented)) = place.zip(oriented) {
            buffers.insert(place, oriented);
        }
        self.run(id, params.parts(), &buffers, groups);
    }

    /// Runs the kernels that `work` records so many times, one after the other and from the first
    /// again, with the same parameters: what changes is in their buffers. Kernels alone.
    pub fn repeat(&mut self, times: u32, work: impl FnOnce(&mut Self)) {
        if times == 0 {
            return;
        }
        let before = self.commands.len();
        work(self);
        let n = self.commands.len() - before;
        debug_assert!(self.commands[before..].iter().all(|c| matches!(c, Command::Run { .. })));
        self.commands.push(Command::Repeat { n, times });
    }

    /// Runs a kernel by its id. `params`: parts of [`Params`]; `buffers`: in the order of the
    /// table.
    pub fn run(&mut self, id: Id, params: [&[u8]; 3], buffers: &[&wgpu::Buffer], groups: u32) {
        if groups == 0 {
            return;
        }
        if id.row().params.is_some() {
            let end = self.params.len() + PARAMS_STRIDE as usize;
            params.iter().for_each(|part| self.params.extend_from_slice(part));
            self.params.resize(end, 0);
        }
        let buffers = buffers.iter().map(|&b| b.clone()).collect();
        self.commands.push(Command::Run { id, buffers, groups });
    }

    /// Ends the recording: encodes its commands. Returns the stages.
    pub fn finish(
        mut self,
        encoder: &mut wgpu::CommandEncoder,
    ) -> Result<Vec<&'static str>, Error> {
        let commands = self.prepare()?;
        // Before anything is encoded, so that the encoder is a caller's as it was if one fails.
        let groups = self.bench.bind_groups(&commands)?;
        Ok(self.bench.encode(&commands, groups, encoder))
    }

    /// Compiles what is not compiled yet and uploads the parameters. Returns the commands.
    fn prepare(&mut self) -> Result<Vec<Command>, Error> {
        self.end_of_work();
        let Self { bench, commands, params } = self;
        let bytes = params.len() as u64;
        let limit = PARAMS_STRIDE * bench.most;
        if bytes > limit {
            return Err(Error::TooLarge { what: "parameters of dispatches", bytes, limit });
        }
        bench.device.compile(commands.iter().filter_map(|command| match command {
            Command::Run { id, .. } => Some(*id),
            _ => None,
        }))?;
        bench.device.write("parameters of dispatches", &bench.params, 0, params)?;
        Ok(std::mem::take(commands))
    }
}

/// The bindings of a kernel: its parameters, at the offset of a dispatch, and its buffers.
fn bind_group(
    device: &Device,
    id: Id,
    params: &wgpu::Buffer,
    buffers: &[wgpu::Buffer],
) -> wgpu::BindGroup {
    let size = wgpu::BufferSize::new(PARAMS_STRIDE);
    let params = wgpu::BufferBinding { buffer: params, offset: 0, size };
    let takes_params = id.row().params.is_some();
    let first = takes_params.then_some(wgpu::BindingResource::Buffer(params));
    let resources = first.into_iter().chain(buffers.iter().map(|b| b.as_entire_binding()));
    let resources = resources.chain(device.checked().map(|checked| checked.word(id)));
    let entries: Vec<_> = (0..)
        .zip(resources)
        .map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource })
        .collect();
    device.wgpu().create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some(id.row().name),
        layout: &device.pipeline(id).layout,
        entries: &entries,
    })
}
