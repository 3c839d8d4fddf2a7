//! One session and one broad phase over both backends, for programs that use a GPU where there is
//! one: a [`Backend`] makes a [`Choice`], and the choice makes a [`Session`] or a [`BroadPhase`].
//!
//! The rule of [`Backend::Auto`]: a GPU if there is one and work enough for it, else the CPU. If
//! that GPU fails later, for whatever reason but bad input, the CPU takes over for good; the call
//! in which it happens returns the CPU's answer. A choice that was not free fails instead.
//!
//! ```
//! use ccd::any::{Backend, Error, Session};
//! use ccd::{Mesh, Options};
//!
//! let mesh = Mesh::new(4, &[[0, 1, 2]])?;
//! let before = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.2, 1.0, 0.2f32]];
//! let mut after = before;
//! after[3][1] = -1.0;
//!
//! let choice = Backend::Auto.choose(mesh.edges().len())?;
//! let choice = choice.with_notice(|why| eprintln!("{why}; going on with the CPU"));
//! let mut session = Session::new(&choice, mesh, Options::default())?;
//! assert_eq!(session.step(&before, &after)?.contacts.len(), 1);
//! // So little is no work for a GPU.
//! assert_eq!(session.place().backend(), "cpu");
//! # Ok::<(), Error>(())
//! ```
//!
//! Without the feature `gpu` everything here runs on the CPU, and [`Backend::Gpu`] is an error.

mod broad_phase;
#[cfg(not(feature = "gpu"))]
mod no_gpu;
mod session;

pub use broad_phase::{BroadPhase, Pairs};
pub use session::{Candidates, Engine, FEW_CANDIDATES, FEW_VERTICES, Session};

#[cfg(feature = "gpu")]
pub use ccd_gpu::Error;
#[cfg(not(feature = "gpu"))]
pub use no_gpu::Error;

/// The GPU's types: those of `ccd-gpu`, or ones without a value.
#[cfg(feature = "gpu")]
mod gpu {
    pub use ccd_gpu::{BroadPhase, Device, DeviceOptions, Session};

    /// The adapter's name.
    pub fn name(device: &Device) -> &str {
        &device.info().adapter.name
    }

    /// Whether threads of this machine do a GPU's work.
    pub fn is_emulated(device: &Device) -> bool {
        device.info().adapter.device_type == ccd_gpu::wgpu::DeviceType::Cpu
    }
}
#[cfg(not(feature = "gpu"))]
use no_gpu as gpu;

/// Edges of a mesh, or boxes, from which on [`Backend::Auto`] asks for a GPU: below, threads are
/// done in about the millisecond that submitting a step and waiting for it takes, and opening the
/// device takes longer than many steps.
pub const FEWEST_FOR_GPU: usize = 20_000;

/// Backend asked for.
///
/// ```
/// use ccd::any::Backend;
///
/// // Too little work for a GPU, and no error without one.
/// assert!(Backend::Auto.choose(100).is_ok());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Backend {
    /// Threads of this machine.
    Cpu,
    /// A GPU; an error if there is none, or if it fails.
    Gpu,
    /// A GPU if there is one and work enough for it, and for as long as it does not fail; else the
    /// CPU.
    #[default]
    Auto,
}

impl Backend {
    /// Chooses. `size`: edges of the mesh, or boxes.
    ///
    /// # Errors
    /// [`Error::Unavailable`] for [`Backend::Gpu`] where there is none.
    pub fn choose(self, size: usize) -> Result<Choice, Error> {
        self.decide(size, &gpu::DeviceOptions::default())
    }

    /// Chooses a device where these options want it. With a named adapter, `Auto` takes it whatever
    /// it is and however little work there is.
    ///
    /// # Errors
    /// Those of [`Backend::choose`]; [`Error::Unavailable`] for a named adapter that is not there.
    #[cfg(feature = "gpu")]
    pub fn choose_with(self, size: usize, options: &gpu::DeviceOptions) -> Result<Choice, Error> {
        self.decide(size, options)
    }

    fn decide(self, size: usize, options: &gpu::DeviceOptions) -> Result<Choice, Error> {
        let named = options.adapter.is_some();
        let auto = self == Backend::Auto;
        if self == Backend::Cpu || (auto && !named && size < FEWEST_FOR_GPU) {
            return Ok(Choice::default());
        }
        match gpu::Device::open(options) {
            // An emulated GPU is slower than the threads that emulate it; only who names it wants
            // it.
            Ok(device) if auto && !named && gpu::is_emulated(&device) => Ok(Choice::default()),
            Ok(device) => Ok(Choice { device: Some(device), free: auto, ..Choice::default() }),
            Err(why) if auto && !named => Ok(Choice { failure: Some(why), ..Choice::default() }),
            Err(why) => Err(why),
        }
    }
}

/// Backend chosen for the work; by default the CPU.
///
/// ```
/// use ccd::any::Backend;
///
/// let choice = Backend::Auto.choose(100)?.with_notice(|why| eprintln!("{why}"));
/// # drop(choice);
/// # Ok::<(), ccd::any::Error>(())
/// ```
#[derive(Clone, Default)]
pub struct Choice {
    /// `None`: the CPU.
    device: Option<gpu::Device>,
    /// Whether the CPU takes over where the GPU fails.
    free: bool,
    /// Why it is not the GPU that was looked for.
    failure: Option<Error>,
    notice: Option<Notice>,
}

/// Called with the reason when the CPU takes over from a GPU.
type Notice = fn(&Error);

impl Choice {
    /// A device of the caller's. `free`: the CPU takes over where it fails.
    #[cfg(feature = "gpu")]
    pub fn of_device(device: &gpu::Device, free: bool) -> Self {
        Self { device: Some(device.clone()), free, ..Self::default() }
    }

    /// Has a function called with the reason whenever the CPU takes over from a GPU; at once if it
    /// has already, because there was a reason to look for a GPU and none could be opened.
    pub fn with_notice(self, notice: fn(&Error)) -> Self {
        if let Some(why) = &self.failure {
            notice(why);
        }
        Self { notice: Some(notice), ..self }
    }

    /// The same, but the CPU at once if the choice was free and a GPU lacks what these options
    /// choose.
    fn for_options(&self, options: &crate::Options) -> Self {
        if self.free && options.lacking("gpu").is_some() {
            Self { notice: self.notice, ..Self::default() }
        } else {
            self.clone()
        }
    }

    /// From now on an error of the GPU is an error.
    pub fn fixed(self) -> Self {
        Self { free: false, ..self }
    }

    /// The device, if it is a GPU.
    #[cfg(feature = "gpu")]
    pub fn device(&self) -> Option<&gpu::Device> {
        self.device.as_ref()
    }
}

/// Place of the work.
///
/// ```
/// use ccd::any::Place;
///
/// let place = Place::Cpu { threads: 2 };
/// assert_eq!((place.backend(), place.to_string()), ("cpu", "2 threads".to_string()));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// Threads of this machine.
    Cpu {
        /// Their number.
        threads: usize,
    },
    /// A GPU.
    Gpu {
        /// The adapter's name.
        adapter: String,
    },
}

impl Place {
    /// `"cpu"` or `"gpu"`.
    pub fn backend(&self) -> &'static str {
        match self {
            Place::Cpu { .. } => "cpu",
            Place::Gpu { .. } => "gpu",
        }
    }

    /// Number of threads, on the CPU.
    pub fn threads(&self) -> Option<usize> {
        match self {
            Place::Cpu { threads } => Some(*threads),
            Place::Gpu { .. } => None,
        }
    }

    /// Name of the adapter, on a GPU.
    pub fn adapter(&self) -> Option<&str> {
        match self {
            Place::Cpu { .. } => None,
            Place::Gpu { adapter } => Some(adapter),
        }
    }
}

/// "2 threads", or the name of the adapter.
impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Place::Cpu { threads: 1 } => f.write_str("1 thread"),
            Place::Cpu { threads } => write!(f, "{threads} threads"),
            Place::Gpu { adapter } => f.write_str(adapter),
        }
    }
}

/// A session or broad phase of either backend.
enum Either<C, G> {
    Cpu(Box<C>),
    Gpu { on: Box<G>, free: bool, notice: Option<Notice> },
}

/// Whose turn it is: the GPU is done, or the CPU has still to work.
enum Turn<'a, C, R> {
    Done(R),
    Cpu(&'a mut C),
}

impl<C, G> Either<C, G> {
    fn new(
        choice: &Choice,
        on_cpu: impl FnOnce() -> Result<C, crate::Error>,
        on_gpu: impl FnOnce(&gpu::Device) -> Result<G, Error>,
    ) -> Result<Self, Error> {
        let &Choice { free, notice, .. } = choice;
        if let Some(device) = &choice.device {
            match on_gpu(device) {
                Ok(on) => return Ok(Self::Gpu { on: Box::new(on), free, notice }),
                Err(why) => give_up(why, free, notice)?,
            }
        }
        Ok(Self::Cpu(Box::new(on_cpu()?)))
    }

    /// Has the GPU work, if this is on one. If that fails and may, what `on_cpu` makes takes its
    /// place for good, and it is the CPU's turn.
    fn run<R>(
        &mut self,
        work: impl Fn(&mut G) -> Result<R, Error>,
        on_cpu: impl Fn(&mut G) -> Result<C, crate::Error>,
    ) -> Result<Turn<'_, C, R>, Error> {
        loop {
            match self {
                Self::Cpu(cpu) => return Ok(Turn::Cpu(cpu)),
                Self::Gpu { on, free, notice } => {
                    match work(on) {
                        Ok(done) => return Ok(Turn::Done(done)),
                        Err(why) => give_up(why, *free, *notice)?,
                    }
                    *self = Self::Cpu(Box::new(on_cpu(on)?));
                }
            }
        }
    }
}

/// Tells why the CPU takes over, or returns it as the error that it is: bad input is that on
/// either, if it is no filter and nothing that is not compiled in, and a choice that was not free
/// stands.
fn give_up(why: Error, free: bool, notice: Option<Notice>) -> Result<(), Error> {
    use crate::Error::{Filter, NotCompiled, TooMany};
    // Of what is too much for a CPU as well it says so itself.
    let of_gpu = matches!(why, Error::Input(Filter { .. } | NotCompiled { .. } | TooMany { .. }));
    if !free || matches!(why, Error::Input(_)) && !of_gpu {
        return Err(why);
    }
    if let Some(notice) = notice {
        notice(&why);
    }
    Ok(())
}
