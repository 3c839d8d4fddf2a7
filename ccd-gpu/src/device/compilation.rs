//! Kernels of a device, compiled when they are first used, by all threads of the host.

use super::{Device, Inner};
use crate::clock::Instant;
use crate::error::Error;
use crate::pipeline::Pipeline;
use crate::shaders::{check, packed};
use ccd_core::backend::kernel::Id;
use core::time::Duration;
use std::cmp::Reverse;
use std::sync::MutexGuard;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// What the kernels that a device has used so far took to compile.
///
/// ```no_run
/// use ccd::gpu::{Device, DeviceOptions};
///
/// // A folder that nobody else may write.
/// let kernel_folder = Some("/home/me/.cache/my-game".into());
/// let device = Device::open(&DeviceOptions { kernel_folder, ..DeviceOptions::default() })?;
/// // .. after the first step:
/// let done = device.compilation();
/// println!("{} kernels in {:?}, kept: {}", done.kernels, done.time, done.kept);
/// # Ok::<(), ccd::gpu::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Compilation {
    /// How many.
    pub kernels: usize,
    /// How long callers waited for them.
    pub time: Duration,
    /// Whether there was a file of kernels that an earlier process had compiled.
    pub kept: bool,
}

impl Device {
    /// What compiling kernels took so far; each is compiled when it is first used, side by side
    /// with others that a call uses for the first time.
    pub fn compilation(&self) -> Compilation {
        *self.compiled()
    }

    /// Compiles those of these kernels that are not compiled yet, by all threads of the host.
    ///
    /// # Errors
    /// What the device refuses.
    pub(crate) fn compile(&self, ids: impl Iterator<Item = Id>) -> Result<(), Error> {
        let mut missing: Vec<Id> =
            ids.filter(|&id| self.inner.pipelines[id as usize].get().is_none()).collect();
        if missing.is_empty() {
            return Ok(());
        }
        missing.iter().try_for_each(|&id| check(id))?;
        // Those that take longest first.
        missing.sort_unstable_by_key(|&id| (Reverse(packed(id).len()), id as usize));
        missing.dedup();
        let start = Instant::now();
        let next = AtomicUsize::new(0);
        let work = || -> Result<(), Error> {
            while let Some(&id) = missing.get(next.fetch_add(1, Ordering::Relaxed)) {
                // What a device says of a kernel, it says to the thread that asked. One that it
                // refuses is not kept.
                let compiled = self.guarded("a kernel", 0, || self.compiled_kernel(id))?;
                _ = self.inner.pipelines[id as usize].set(compiled);
            }
            Ok(())
        };
        let n_threads = thread::available_parallelism().map_or(1, |n| n.get()).min(missing.len());
        thread::scope(|scope| {
            let others: Vec<_> = (1..n_threads).map(|_| scope.spawn(work)).collect();
            let own = work();
            let join = |other: thread::ScopedJoinHandle<'_, _>| {
                other.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
            };
            others.into_iter().map(join).fold(own, Result::and)
        })?;
        self.compiled().time += start.elapsed();
        Ok(())
    }

    /// The pipeline of a kernel, compiled if [`Device::compile`] was not asked to.
    pub(crate) fn pipeline(&self, id: Id) -> &Pipeline {
        self.inner.pipelines[id as usize].get_or_init(|| self.compiled_kernel(id))
    }

    fn compiled_kernel(&self, id: Id) -> Pipeline {
        let Inner { device, info, cache, checked, .. } = &*self.inner;
        self.compiled().kernels += 1;
        let cache = cache.as_ref().map(|cache| &cache.kernels);
        Pipeline::compile(device, info, id, cache, checked.as_ref())
    }

    fn compiled(&self) -> MutexGuard<'_, Compilation> {
        self.inner.compilation.lock().unwrap_or_else(|e| e.into_inner())
    }
}
