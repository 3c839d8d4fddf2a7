//! Options of the commands that can use a GPU, and the choice that they make.

use super::method::{Choices, choice};
use super::{Failure, output};
use ccd::Options;
use ccd::any::{self, Backend, Choice};
use ccd::gpu::{self, Compilation, Device, DeviceOptions};
use clap::Args;
use std::path::PathBuf;

const BACKENDS: Choices<Backend, 3> = [
    ("cpu", "Threads of this machine", Backend::Cpu),
    ("gpu", "A GPU; an error if there is none", Backend::Gpu),
    ("auto", "A GPU from 20,000 edges or boxes on, if there is one; else the CPU", Backend::Auto),
];

// What the help says of `auto`.
const _: () = assert!(any::FEWEST_FOR_GPU == 20_000);

const SHADERS: Choices<gpu::Path, 2> = [
    ("passthrough", "SPIR-V as compiled, Vulkan only", gpu::Path::Passthrough),
    ("wgsl", "WGSL, every GPU API", gpu::Path::Wgsl),
];

/// Heading of these options in the help.
pub const PLACE: &str = "Where it runs";

/// Options of every command that can use a GPU.
#[derive(Args)]
pub struct AdapterOptions {
    /// Use this GPU: its number in `ccd info`, or a part of its name
    ///
    /// Or its PCI id. Used even if it is a software adapter or the mesh is small; an error if there
    /// is none.
    #[arg(long, value_name = "GPU", help_heading = PLACE)]
    adapter: Option<String>,
    /// How shaders reach the driver; without it the first that is possible
    #[arg(long, value_parser = choice(SHADERS), hide_short_help = true, help_heading = PLACE)]
    shaders: Option<gpu::Path>,
}

impl AdapterOptions {
    fn of_device(&self) -> DeviceOptions {
        let (adapter, path, kernel_folder) = (self.adapter.clone(), self.shaders, kernel_folder());
        DeviceOptions { adapter, path, kernel_folder, ..DeviceOptions::default() }
    }

    /// Whether one GPU and no other is wanted.
    pub fn is_named(&self) -> bool {
        self.adapter.is_some()
    }

    /// The device, or why there is none.
    pub fn open(&self) -> Result<Device, gpu::Error> {
        Device::open(&self.of_device())
    }
}

/// Folder of compiled kernels: `ccd` in the user's folder of caches.
pub fn kernel_folder() -> Option<PathBuf> {
    let folder = |name: &str| {
        std::env::var_os(name).map(PathBuf::from).filter(|folder| folder.is_absolute())
    };
    let caches = if cfg!(windows) {
        folder("LOCALAPPDATA")
    } else if cfg!(target_os = "macos") {
        folder("HOME").map(|home| home.join("Library/Caches"))
    } else {
        folder("XDG_CACHE_HOME").or_else(|| folder("HOME").map(|home| home.join(".cache")))
    };
    caches.map(|caches| caches.join("ccd"))
}

/// Compilation of a session's kernels; `None` on the CPU.
pub fn compilation(session: &mut any::Session) -> Option<Compilation> {
    session.gpu().map(|session| session.device().compilation())
}

/// Prints how long kernels took to compile.
pub fn print_compilation(compilation: Option<Compilation>) {
    let Some(Compilation { kernels, time, kept, .. }) = compilation else { return };
    let seconds = time.as_secs_f64();
    let time = match seconds < 0.1 {
        true => output::milliseconds(seconds * 1e3),
        false => format!("{seconds:.1} s"),
    };
    let text = match kept {
        true => format!("{kernels} loaded or compiled in {time} (an earlier run kept some)"),
        false => format!("{kernels} compiled in {time}"),
    };
    output::line("kernels", text);
}

/// Options of every command that works on either.
#[derive(Args)]
pub struct BackendOptions {
    /// Where the work runs
    #[arg(short, long, value_parser = choice(BACKENDS), default_value = "auto")]
    #[arg(help_heading = PLACE)]
    backend: Backend,
    #[command(flatten)]
    adapter: AdapterOptions,
    /// Threads on the CPU; 0: one per processor
    #[arg(short, long, value_name = "N", default_value_t = 0, allow_negative_numbers = true)]
    #[arg(value_parser = clap::value_parser!(u32).range(0..=Options::MAX_THREADS as i64))]
    #[arg(help_heading = PLACE)]
    threads: u32,
}

impl BackendOptions {
    /// Threads on the CPU; 0: one per processor.
    pub fn threads(&self) -> usize {
        self.threads as usize
    }

    /// Chooses. `size`: edges of the mesh, or boxes.
    pub fn choose(&self, size: usize) -> Result<Choice, Failure> {
        if self.backend == Backend::Cpu && self.adapter.is_named() {
            return Err(Failure("--adapter names a GPU, --backend cpu uses none".into()));
        }
        if self.backend == Backend::Cpu && self.adapter.shaders.is_some() {
            return Err(Failure("--shaders are for a GPU, --backend cpu uses none".into()));
        }
        let choice = self.backend.choose_with(size, &self.adapter.of_device());
        let option = if self.adapter.is_named() { "--adapter" } else { "--backend gpu" };
        let choice = choice.map_err(|e| Failure(format!("{option}: {e}")))?;
        Ok(choice.with_notice(|why| match why {
            // Most machines have none; `ccd info` says why.
            gpu::Error::Unavailable { .. }
                if std::env::var("CCD_ADAPTER").unwrap_or_default().is_empty() =>
            {
                output::notice!("no GPU found; going on with the CPU (`ccd info` says why)")
            }
            _ => output::notice!("{why}; going on with the CPU"),
        }))
    }
}
