//! The device: opening it, its buffers, and what happens when it fails.

mod compilation;
mod memory;
mod waiting;

pub use compilation::Compilation;

use crate::adapter::{self, DeviceOptions, Info, Path};
use crate::error::{Error, Faults};
use crate::kernel_cache::Cache;
use crate::pipeline::{Checked, Pipeline};
use bytemuck::Pod;
use ccd_core::backend::kernel::TABLE;
use memory::Memory;
use std::fmt;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock};
pub(crate) use waiting::BLOCKS;
use waiting::{Unchecked, at_once};
use wgpu::Features as F;

/// A GPU, its queue, and the compiled kernels. Clones share them.
///
/// ```no_run
/// use ccd::gpu::{Device, DeviceOptions};
///
/// let device = Device::open(&DeviceOptions::default())?;
/// println!("{}", device.info());
/// # Ok::<(), ccd::gpu::Error>(())
/// ```
#[derive(Clone)]
pub struct Device {
    inner: Arc<Inner>,
    /// What buffers may take, if there is a limit.
    memory: Option<Arc<Memory>>,
    /// What the device has still to report of the commands of one session.
    unchecked: Arc<Unchecked>,
}

struct Inner {
    device: wgpu::Device,
    queue: wgpu::Queue,
    info: Info,
    lost: Arc<Mutex<Option<String>>>,
    pipelines: Vec<OnceLock<Pipeline>>,
    cache: Option<Cache>,
    compilation: Mutex<Compilation>,
    faults: Mutex<Faults>,
    checked: Option<Checked>,
}

/// Keeps what was compiled for the next process.
impl Drop for Inner {
    fn drop(&mut self) {
        let any = self.compilation.get_mut().is_ok_and(|done| done.kernels > 0);
        if let Some(cache) = self.cache.as_ref().filter(|_| any) {
            cache.keep();
        }
    }
}

impl fmt::Debug for Device {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Device")
            .field("adapter", &self.inner.info.adapter.name)
            .field("path", &self.inner.info.path)
            .finish_non_exhaustive()
    }
}

/// Bytes of a buffer at most, whatever the device has: kernels count words by `u32`, and ids of
/// boxes have their highest bit free for a mark.
const MOST_BYTES: u64 = 1 << 32;

impl Device {
    /// What an application should ask of its own device so that [`Device::from_wgpu`] can use all
    /// of it; intersect with what its adapter has.
    pub fn features() -> wgpu::Features {
        adapter::wanted_features(&DeviceOptions::default())
    }

    /// Opens a device. Blocks until it is there.
    ///
    /// # Errors
    /// [`Error::Unavailable`] with what was looked for and what there is; what the device refuses;
    /// [`Error::CannotBlock`] in a browser.
    pub fn open(options: &DeviceOptions) -> Result<Self, Error> {
        at_once(Self::open_async(options)).unwrap_or(Err(Error::CannotBlock))
    }

    /// Opens every GPU of the type (discrete, say) and the GPU API of the one that [`Device::open`]
    /// takes, in the order of [`Device::adapters`]: for sessions on
    /// several devices at once.
    ///
    /// # Errors
    /// Those of [`Device::open`].
    pub fn open_all(options: &DeviceOptions) -> Result<Vec<Self>, Error> {
        let first = Self::open(options)?;
        let of = &first.info().adapter;
        let is_one = |info: &wgpu::AdapterInfo| {
            (info.backend, info.device_type) == (of.backend, of.device_type)
        };
        let all = Self::adapters().into_iter().enumerate().filter(|(_, info)| is_one(info));
        let open = |(number, _): (usize, _)| {
            let adapter = Some(number.to_string());
            Self::open(&DeviceOptions { adapter, ..options.clone() })
        };
        all.map(open).collect()
    }

    /// All adapters of this machine, once for every GPU API that reaches them; none in a browser,
    /// which lists none.
    pub fn adapters() -> Vec<wgpu::AdapterInfo> {
        at_once(adapter::instance().enumerate_adapters(wgpu::Backends::all()))
            .iter()
            .flatten()
            .map(|a| a.get_info())
            .collect()
    }

    /// Opens a device, as [`Device::open`] does, without blocking: in a browser the only way.
    ///
    /// ```no_run
    /// use ccd::gpu::{Device, DeviceOptions, Error};
    ///
    /// async fn open() -> Result<Device, Error> {
    ///     Device::open_async(&DeviceOptions::default()).await
    /// }
    /// # let _ = open;
    /// ```
    ///
    /// # Errors
    /// [`Error::Unavailable`] with what was looked for and what there is; what the device refuses.
    pub async fn open_async(options: &DeviceOptions) -> Result<Self, Error> {
        let instance = adapter::instance();
        let chosen = adapter::choose(&instance, options).await?;
        let info = chosen.get_info();
        let mut features = adapter::wanted_features(options) & chosen.features();
        // It lets drivers choose the size of subgroups, which is of no use elsewhere.
        features.set(F::SUBGROUP, features.contains(F::SUBGROUP) && adapter::are_of_32(&info));
        let refused = |e: wgpu::RequestDeviceError| Error::Unavailable {
            why: format!("{} gives no device: {e}", info.name),
        };
        let experimental_features = if features.contains(F::PASSTHROUGH_SHADERS) {
            // SAFETY: passthrough is the one experimental feature asked for; what it needs is said
            // at `Pipeline::compile`.
            #[allow(unsafe_code, reason = "wgpu passes shaders through as an experiment only")]
            unsafe {
                wgpu::ExperimentalFeatures::enabled()
            }
        } else {
            wgpu::ExperimentalFeatures::disabled()
        };
        let (device, queue) = chosen
            .request_device(&wgpu::DeviceDescriptor {
                label: Some("ccd"),
                required_features: features,
                required_limits: chosen.limits(),
                experimental_features,
                ..Default::default()
            })
            .await
            .map_err(refused)?;
        let out = Self::from_wgpu(device, queue, info, options)?;
        let lost = out.inner.lost.clone();
        out.inner.device.set_device_lost_callback(move |reason, message| {
            *lost.lock().unwrap_or_else(|e| e.into_inner()) = Some(format!("{reason:?} {message}"));
        });
        Ok(out)
    }

    /// Uses a device that an application owns; see [`Device::features`]. The application keeps its
    /// callbacks for errors and for the loss of the device. On Vulkan it has `robustBufferAccess`
    /// on, as every device that wgpu opens.
    ///
    /// # Errors
    /// [`Error::Unavailable`] for a device through OpenGL, one with less than the limits of WebGPU,
    /// or a path that it does not have.
    pub fn from_wgpu(
        device: wgpu::Device,
        queue: wgpu::Queue,
        adapter: wgpu::AdapterInfo,
        options: &DeviceOptions,
    ) -> Result<Self, Error> {
        let features = device.features();
        let can_pass =
            adapter.backend == wgpu::Backend::Vulkan && features.contains(F::PASSTHROUGH_SHADERS);
        let (path, why) = match options.path {
            Some(Path::Passthrough) if !can_pass => {
                let why =
                    format!("{} ({}) has no passthrough of shaders", adapter.name, adapter.backend);
                return Err(Error::Unavailable { why });
            }
            Some(path) => (path, "as asked"),
            None if can_pass => (Path::Passthrough, "the device takes compiled shaders"),
            None => (Path::Wgsl, "the device takes no compiled shaders"),
        };
        if adapter.backend == wgpu::Backend::Gl {
            // Its kernels were seen to end without results and without an error.
            let why = format!(
                "{} through OpenGL: kernels do not run there; Vulkan, Metal and DX12 are supported",
                adapter.name
            );
            return Err(Error::Unavailable { why });
        }
        let limits = device.limits();
        adapter::check_limits(&adapter, &limits)?;
        let wide_features = F::SHADER_F64 | F::SHADER_INT64;
        let wide = !options.narrow && features.contains(wide_features);
        let integers = options.integers.unwrap_or_else(|| !adapter::has_fast_f64(&adapter));
        let info = Info {
            path,
            why,
            wide,
            integers: integers || !wide,
            subgroups: adapter::has_subgroups(&adapter, &limits, features, path),
            timestamps: features.contains(F::TIMESTAMP_QUERY),
            adapter,
            limits,
        };
        let pipelines = TABLE.iter().map(|_| OnceLock::new()).collect();
        let folder = options.kernel_folder.as_ref();
        let folder = folder.filter(|_| features.contains(F::PIPELINE_CACHE));
        let cache = folder.and_then(|folder| Cache::open(&device, folder, &info.adapter));
        let kept = cache.as_ref().is_some_and(Cache::was_kept);
        let compilation = Mutex::new(Compilation { kept, ..Compilation::default() });
        let lost = Arc::default();
        let faults = Mutex::default();
        let inner = Inner {
            device,
            queue,
            info,
            lost,
            pipelines,
            cache,
            compilation,
            faults,
            checked: None,
        };
        Ok(Self { inner: Arc::new(inner), memory: None, unchecked: Arc::default() })
    }

    /// What the device is and how it is used.
    pub fn info(&self) -> &Info {
        &self.inner.info
    }

    /// The wgpu device.
    pub fn wgpu(&self) -> &wgpu::Device {
        &self.inner.device
    }

    /// Its queue.
    pub fn queue(&self) -> &wgpu::Queue {
        &self.inner.queue
    }

    /// Whether kernels may pass data from one workgroup to another inside a dispatch, or why not.
    ///
    /// # Errors
    /// [`Error::NoStealing`].
    pub fn check_native(&self) -> Result<(), Error> {
        let info = self.info();
        match info.path {
            Path::Passthrough => Ok(()),
            Path::Wgsl => Err(Error::NoStealing { adapter: info.adapter.name.clone() }),
        }
    }

    /// Workgroups of kernels that take one item after another: enough for the largest GPUs; few
    /// where a CPU plays one, because each costs it some time to start.
    ///
    /// lavapipe (gallivm's `LP_MAX_TGSI_LOOP_ITERATIONS`) ends the loops of a thread after 65,535
    /// rounds of all of them together, and what would come then is lost. So a dispatch has so few
    /// items a workgroup that this is not reached; with the workgroups of a GPU the bound is above
    /// what any dispatch has.
    pub(crate) fn groups(&self) -> u32 {
        if self.info().adapter.device_type == wgpu::DeviceType::Cpu { 64 } else { 8192 }
    }

    /// Whether it is lost: sessions on it fail from then on, until they move to another. Never of a
    /// device from [`Device::from_wgpu`]: its application is told.
    pub fn is_lost(&self) -> bool {
        self.check_lost().is_err()
    }

    /// Fails once the device is lost.
    pub(crate) fn check_lost(&self) -> Result<(), Error> {
        match &*self.inner.lost.lock().unwrap_or_else(|e| e.into_inner()) {
            Some(why) => Err(Error::Lost { why: why.clone() }),
            None => Ok(()),
        }
    }

    /// The same device for a session of its own, which may hold so many bytes of buffers, and
    /// holds none yet.
    pub(crate) fn limited(&self, limit: Option<u64>) -> Self {
        let memory = limit.map(|limit| Arc::new(Memory::new(limit)));
        Self { inner: self.inner.clone(), memory, unchecked: Arc::default() }
    }

    /// What buffers may take, if there is a limit.
    pub(crate) fn memory(&self) -> Option<&Memory> {
        self.memory.as_deref()
    }

    /// A buffer, or why there is none.
    pub(crate) fn buffer(
        &self,
        what: &'static str,
        bytes: u64,
        usage: wgpu::BufferUsages,
    ) -> Result<wgpu::Buffer, Error> {
        // A binding is never empty, and at least as large as one record of any kind.
        let bytes = bytes.max(256).next_multiple_of(16);
        let limits = &self.inner.info.limits;
        let limit = limits.max_storage_buffer_binding_size.min(limits.max_buffer_size);
        let limit = limit.min(MOST_BYTES);
        if bytes > limit {
            return Err(Error::TooLarge { what, bytes, limit });
        }
        if let Some(memory) = self.memory() {
            memory.take(what, bytes)?;
        }
        let descriptor = wgpu::BufferDescriptor {
            label: Some(what),
            size: bytes,
            usage,
            mapped_at_creation: false,
        };
        let made = self.guarded(what, bytes, || self.inner.device.create_buffer(&descriptor));
        if made.is_err() {
            self.give_back(bytes);
        }
        made
    }

    /// A buffer that holds these words.
    pub(crate) fn sent<T: Pod>(
        &self,
        what: &'static str,
        words: &[T],
    ) -> Result<wgpu::Buffer, Error> {
        let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST;
        let buffer = self.buffer(what, size_of_val(words) as u64, usage)?;
        self.write(what, &buffer, 0, bytemuck::cast_slice(words))?;
        Ok(buffer)
    }

    /// Writes to a buffer from byte `at` on. The only place that does: memory on the way to the
    /// device may be lacking, which outside of [`Device::guarded`] ends the process.
    pub(crate) fn write(
        &self,
        what: &'static str,
        buffer: &wgpu::Buffer,
        at: u64,
        bytes: &[u8],
    ) -> Result<(), Error> {
        if bytes.is_empty() {
            return Ok(());
        }
        self.guarded(what, bytes.len() as u64, || {
            self.inner.queue.write_buffer(buffer, at, bytes);
        })
    }

    /// A buffer that was made for the same purpose, if it is there and large enough; else a new
    /// one.
    pub(crate) fn buffer_or(
        &self,
        old: Option<&wgpu::Buffer>,
        what: &'static str,
        bytes: u64,
        usage: wgpu::BufferUsages,
    ) -> Result<wgpu::Buffer, Error> {
        match old {
            Some(old) if old.size() >= bytes && old.usage().contains(usage) => Ok(old.clone()),
            _ => self.buffer(what, bytes, usage),
        }
    }

    /// What tests make fail.
    pub(crate) fn faults(&self) -> MutexGuard<'_, Faults> {
        self.inner.faults.lock().unwrap_or_else(|e| e.into_inner())
    }

    /// The modules that check their indices, if it has such.
    pub(crate) fn checked(&self) -> Option<&Checked> {
        self.inner.checked.as_ref()
    }

    /// Gives them to a device that nobody else has yet.
    pub(crate) fn set_checked(&mut self, checked: Checked) {
        if let Some(inner) = Arc::get_mut(&mut self.inner) {
            inner.checked = Some(checked);
        }
    }
}
