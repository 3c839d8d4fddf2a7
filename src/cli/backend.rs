//! What runs the work of a command: threads of this machine or a GPU, chosen once and, where the choice was free, changed when the GPU fails.

use super::Failure;
use ccd::gpu::{self, Device, DeviceOptions, wgpu};
use ccd::{Aabb, Mesh, Method, Options, PerKind, Real, Report};
use clap::{Args, ValueEnum};

/// Edges of a mesh, or boxes, from which on `auto` asks for a GPU: below, threads are done in about the millisecond that submitting a step and waiting
/// for it takes, and opening the device takes longer than many steps.
const FEWEST: usize = 20_000;

/// What runs the work.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Backend {
    /// Threads of this machine
    Cpu,
    /// A GPU; an error if there is none
    Gpu,
    /// A GPU if there is one, and work enough for it; else the CPU
    Auto,
}

/// How shaders reach the driver.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Shaders {
    /// SPIR-V as compiled, Vulkan only
    Passthrough,
    /// WGSL, every GPU API
    Wgsl,
}

/// Options of every command that can use a GPU.
#[derive(Args)]
pub struct AdapterOptions {
    /// Use the GPU whose name contains NAME, whatever it is and however small the mesh (`ccd info` lists names)
    #[arg(long, value_name = "NAME")]
    adapter: Option<String>,
    /// How shaders reach the driver; without it the first that is possible
    #[arg(long, value_enum)]
    shaders: Option<Shaders>,
}

impl AdapterOptions {
    /// The device, or why there is none.
    pub fn open(&self) -> Result<Device, gpu::Error> {
        let path = self.shaders.map(|s| match s {
            Shaders::Passthrough => gpu::Path::Passthrough,
            Shaders::Wgsl => gpu::Path::Wgsl,
        });
        Device::open(&DeviceOptions { adapter: self.adapter.clone(), path, narrow: false })
    }
}

/// Options of every command that works on either.
#[derive(Args)]
pub struct BackendOptions {
    /// What runs the work
    #[arg(long, value_enum, default_value_t = Backend::Auto)]
    backend: Backend,
    #[command(flatten)]
    adapter: AdapterOptions,
}

/// What was chosen to run the work.
pub struct Choice {
    /// `None`: the CPU.
    device: Option<Device>,
    /// Whether the CPU goes on where the GPU fails.
    may_fall_back: bool,
}

impl BackendOptions {
    /// Chooses. `size`: edges of the mesh, or boxes.
    pub fn choose(&self, size: usize) -> Result<Choice, Failure> {
        let named = self.adapter.adapter.is_some();
        let auto = self.backend == Backend::Auto;
        if self.backend == Backend::Cpu || (auto && !named && size < FEWEST) {
            return Ok(Choice { device: None, may_fall_back: false });
        }
        match self.adapter.open() {
            // A GPU that is emulated by threads of this machine is slower than those threads; only who names it wants it.
            Ok(device) if auto && !named && device.info().adapter.device_type == wgpu::DeviceType::Cpu => {
                Ok(Choice { device: None, may_fall_back: false })
            }
            Ok(device) => Ok(Choice { device: Some(device), may_fall_back: auto }),
            Err(e) if auto => {
                say_fallen_back(&e);
                Ok(Choice { device: None, may_fall_back: false })
            }
            Err(e) => Err(Failure(format!("--backend gpu: {e}"))),
        }
    }
}

impl Choice {
    /// From now on an error of the GPU is an error.
    pub fn final_choice(self) -> Self {
        Self { may_fall_back: false, ..self }
    }

    /// The device, if it is a GPU.
    pub fn device(&self) -> Option<&Device> {
        self.device.as_ref()
    }
}

fn say_fallen_back(e: &gpu::Error) {
    eprintln!("ccd: {e}; going on with the CPU");
}

/// Whether the CPU can do better than fail in the same way.
fn is_of_gpu(e: &gpu::Error) -> bool {
    !matches!(e, gpu::Error::Input(_))
}

/// Where work runs.
pub struct Place {
    /// Threads that are used; `None` on a GPU.
    pub threads: Option<usize>,
    /// Name of the GPU; `None` on the CPU.
    pub adapter: Option<String>,
}

impl Place {
    /// "cpu" or "gpu".
    pub fn backend(&self) -> &'static str {
        if self.adapter.is_some() { "gpu" } else { "cpu" }
    }
}

/// "2 threads", or the name of the GPU.
impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match &self.adapter {
            Some(name) => f.write_str(name),
            None => write!(f, "{} threads", self.threads.unwrap_or(1)),
        }
    }
}

/// A session on either.
pub enum AnySession {
    Cpu(Box<ccd::Session>),
    Gpu { session: Box<gpu::Session>, may_fall_back: bool },
}

impl AnySession {
    pub fn new(choice: &Choice, mesh: Mesh, options: Options) -> Result<Self, Failure> {
        let Some(device) = &choice.device else { return Ok(Self::Cpu(Box::new(ccd::Session::new(mesh, options)?))) };
        match gpu::Session::new(device, mesh.clone(), options.clone()) {
            Ok(session) => Ok(Self::Gpu { session: Box::new(session), may_fall_back: choice.may_fall_back }),
            Err(e) if choice.may_fall_back && is_of_gpu(&e) => {
                say_fallen_back(&e);
                Ok(Self::Cpu(Box::new(ccd::Session::new(mesh, options)?)))
            }
            Err(e) => Err(e.into()),
        }
    }

    /// Every contact of a step.
    pub fn step<T: Real + Send + Sync>(&mut self, x0: &[[T; 3]], x1: &[[T; 3]]) -> Result<&Report, gpu::Error> {
        self.run(|s| s.step(x0, x1).map(|_| ()), |s| s.step(x0, x1).map(|_| ()))?;
        Ok(self.report())
    }

    /// The earliest time of impact of a step.
    pub fn earliest<T: Real + Send + Sync>(&mut self, x0: &[[T; 3]], x1: &[[T; 3]]) -> Result<Option<f64>, gpu::Error> {
        self.run(|s| s.earliest_toi(x0, x1), |s| s.earliest_toi(x0, x1))
    }

    /// How many candidates a step has; all of them are listed.
    pub fn candidates<T: Real + Send + Sync>(&mut self, x0: &[[T; 3]], x1: &[[T; 3]]) -> Result<PerKind, gpu::Error> {
        let count = |vf: usize, ee: usize| PerKind { vf: vf as u64, ee: ee as u64 };
        self.run(
            |s| s.candidates(x0, x1).map(|c| count(c.vf.len(), c.ee.len())),
            |s| s.candidates(x0, x1).map(|c| count(c.vf.len(), c.ee.len())),
        )
    }

    /// Runs the one or the other; where the GPU fails and may, the CPU takes over for good.
    fn run<R>(
        &mut self,
        on_cpu: impl Fn(&mut ccd::Session) -> Result<R, ccd::Error>,
        on_gpu: impl FnOnce(&mut gpu::Session) -> Result<R, gpu::Error>,
    ) -> Result<R, gpu::Error> {
        match self {
            Self::Cpu(session) => Ok(on_cpu(session)?),
            Self::Gpu { session, may_fall_back } => match on_gpu(session) {
                Err(e) if *may_fall_back && is_of_gpu(&e) => {
                    say_fallen_back(&e);
                    let mut cpu = ccd::Session::new(session.mesh().clone(), session.options().clone())?;
                    let out = on_cpu(&mut cpu)?;
                    *self = Self::Cpu(Box::new(cpu));
                    Ok(out)
                }
                other => other,
            },
        }
    }

    /// What the last step found.
    pub fn report(&self) -> &Report {
        match self {
            Self::Cpu(session) => session.report(),
            Self::Gpu { session, .. } => session.report(),
        }
    }

    pub fn mesh(&self) -> &Mesh {
        match self {
            Self::Cpu(session) => session.mesh(),
            Self::Gpu { session, .. } => session.mesh(),
        }
    }

    /// Where steps run.
    pub fn place(&self) -> Place {
        match self {
            Self::Cpu(session) => Place { threads: Some(session.threads()), adapter: None },
            Self::Gpu { session, .. } => Place { threads: None, adapter: Some(session.device().info().adapter.name.clone()) },
        }
    }
}

/// A broad phase on either.
pub enum AnyBroadPhase {
    Cpu(Box<ccd::BroadPhase>),
    Gpu { broad: Box<gpu::BroadPhase>, adapter: String, may_fall_back: bool, threads: usize, method: Method },
}

impl AnyBroadPhase {
    /// `threads`: of the CPU.
    pub fn new(choice: &Choice, threads: usize, method: Method) -> Result<Self, Failure> {
        let on_cpu = || Ok(Self::Cpu(Box::new(ccd::BroadPhase::new(threads, method)?)));
        let Some(device) = &choice.device else { return on_cpu() };
        let (adapter, may_fall_back) = (device.info().adapter.name.clone(), choice.may_fall_back);
        match gpu::BroadPhase::new(device, method) {
            Ok(broad) => Ok(Self::Gpu { broad: Box::new(broad), adapter, may_fall_back, threads, method }),
            Err(e) if may_fall_back && is_of_gpu(&e) => {
                say_fallen_back(&e);
                on_cpu()
            }
            Err(e) => Err(e.into()),
        }
    }

    /// How many pairs there are within `a`, or of a box of `a` with one of `b`; all of them are listed.
    pub fn count(&mut self, a: &[Aabb<f32>], b: Option<&[Aabb<f32>]>) -> Result<usize, gpu::Error> {
        let on_cpu = |broad: &mut ccd::BroadPhase| match b {
            None => broad.self_pairs(a).map(|p| p.len()),
            Some(b) => broad.pairs(a, b).map(|p| p.len()),
        };
        match self {
            Self::Cpu(broad) => Ok(on_cpu(broad)?),
            Self::Gpu { broad, may_fall_back, threads, method, .. } => {
                let found = match b {
                    None => broad.self_pairs(a),
                    Some(b) => broad.pairs(a, b),
                };
                match found {
                    Err(e) if *may_fall_back && is_of_gpu(&e) => {
                        say_fallen_back(&e);
                        let mut cpu = ccd::BroadPhase::new(*threads, *method)?;
                        let n = on_cpu(&mut cpu)?;
                        *self = Self::Cpu(Box::new(cpu));
                        Ok(n)
                    }
                    other => other.map(|pairs| pairs.len()),
                }
            }
        }
    }

    /// Where it runs.
    pub fn place(&self) -> Place {
        match self {
            Self::Cpu(broad) => Place { threads: Some(broad.threads()), adapter: None },
            Self::Gpu { adapter, .. } => Place { threads: None, adapter: Some(adapter.clone()) },
        }
    }
}

/// What can be timed on a device.
pub trait OnDevice {
    /// Sets what is timed, if there is a device.
    fn set_timing(&mut self, timing: gpu::Timing) -> Result<(), gpu::Error>;
    /// What was timed of the last call.
    fn stages(&self) -> &[(&'static str, f64)];
    /// Finds pairs of boxes once more without sending anything, and says how many; `None` if that cannot be.
    fn again(&mut self) -> Result<Option<usize>, gpu::Error>;
}

impl OnDevice for AnySession {
    fn set_timing(&mut self, timing: gpu::Timing) -> Result<(), gpu::Error> {
        match self {
            Self::Cpu(_) => Ok(()),
            Self::Gpu { session, .. } => session.set_timing(timing),
        }
    }

    fn stages(&self) -> &[(&'static str, f64)] {
        match self {
            Self::Cpu(_) => &[],
            Self::Gpu { session, .. } => session.stages(),
        }
    }

    fn again(&mut self) -> Result<Option<usize>, gpu::Error> {
        Ok(None)
    }
}

impl OnDevice for AnyBroadPhase {
    fn set_timing(&mut self, timing: gpu::Timing) -> Result<(), gpu::Error> {
        match self {
            Self::Cpu(_) => Ok(()),
            Self::Gpu { broad, .. } => broad.set_timing(timing),
        }
    }

    fn stages(&self) -> &[(&'static str, f64)] {
        match self {
            Self::Cpu(_) => &[],
            Self::Gpu { broad, .. } => broad.stages(),
        }
    }

    fn again(&mut self) -> Result<Option<usize>, gpu::Error> {
        match self {
            Self::Cpu(_) => Ok(None),
            Self::Gpu { broad, .. } => broad.again().map(|n| Some(n as usize)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cpu_takes_over_from_a_lost_gpu_if_the_choice_was_free() {
        let device = match (AdapterOptions { adapter: None, shaders: None }).open() {
            Ok(device) => device,
            Err(e) => {
                assert!(std::env::var("CCD_GPU").as_deref() != Ok("require"), "CCD_GPU=require, but: {e}");
                println!("SKIPPED the loss of a GPU: {e}");
                return;
            }
        };
        let mesh = Mesh::new(4, &[[0, 1, 2]]).expect("a valid mesh");
        let x0 = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.2, 1.0, 0.2f32]];
        let mut x1 = x0;
        x1[3][1] = -1.0;
        let choose = |may_fall_back| Choice { device: Some(device.clone()), may_fall_back };
        let [mut free, mut fixed] =
            [true, false].map(|free| AnySession::new(&choose(free), mesh.clone(), Options::default()).expect("a session"));
        let mut boxes = AnyBroadPhase::new(&choose(true), 0, Method::Blocks).expect("a broad phase");
        let want = free.step(&x0, &x1).expect("a step").contacts.clone();
        assert_eq!((want.len(), free.place().backend()), (1, "gpu"));
        // Bad input is that on either.
        assert!(matches!(free.step(&x0[..3], &x1), Err(gpu::Error::Input(_))));
        assert_eq!(free.place().backend(), "gpu");

        device.wgpu().destroy();
        assert_eq!(free.step(&x0, &x1).expect("a step on the CPU").contacts, want);
        assert_eq!(free.place().backend(), "cpu");
        assert!(fixed.step(&x0, &x1).is_err_and(|e| is_of_gpu(&e)));
        let overlapping = [Aabb { min: [0.0; 3], max: [1.0; 3] }; 2];
        assert_eq!(boxes.count(&overlapping, None).expect("pairs of the CPU"), 1);
        assert_eq!(boxes.place().backend(), "cpu");
    }
}
