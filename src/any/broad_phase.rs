//! A broad phase on either backend, and the pairs that either lists.

use super::{Choice, Either, Error, Place, Turn, gpu};
use crate::method::{BroadPhaseMethod, Scheduling};
use crate::{Aabb, Pair};

/// Finds overlapping boxes, on the CPU or on a GPU: the calls of [`crate::BroadPhase`].
///
/// ```
/// use ccd::any::{Backend, BroadPhase};
/// use ccd::{Aabb, Pair, method::BroadPhaseMethod};
///
/// let boxes = [Aabb { min: [0.0f32; 3], max: [1.0; 3] }; 2];
/// let choice = Backend::Auto.choose(boxes.len())?;
/// let mut broad_phase = BroadPhase::new(&choice, 0, BroadPhaseMethod::default())?;
/// assert_eq!(broad_phase.self_pairs(&boxes)?.into_vec(), [Pair { a: 0, b: 1 }]);
/// # Ok::<(), ccd::any::Error>(())
/// ```
pub struct BroadPhase {
    on: Either<crate::BroadPhase, gpu::BroadPhase>,
    /// Name of the adapter, if it is a GPU.
    adapter: String,
    /// Arguments for a broad phase on the CPU that takes over.
    threads: usize,
    method: BroadPhaseMethod,
    scheduling: Scheduling,
}

impl BroadPhase {
    /// A broad phase where the choice wants it. `threads`: of the CPU.
    ///
    /// # Errors
    /// Those of [`BroadPhase::scheduled`].
    pub fn new(choice: &Choice, threads: usize, method: BroadPhaseMethod) -> Result<Self, Error> {
        Self::scheduled(choice, threads, method, Scheduling::default())
    }

    /// A broad phase with a scheduling.
    ///
    /// # Errors
    /// Those of [`crate::BroadPhase::scheduled`], and, where the choice was a GPU alone, what that
    /// refuses.
    pub fn scheduled(
        choice: &Choice,
        threads: usize,
        method: BroadPhaseMethod,
        scheduling: Scheduling,
    ) -> Result<Self, Error> {
        let options = crate::Options::default().with_broad_phase(method);
        let choice = &choice.for_options(&options.with_scheduling(scheduling));
        let on_cpu = || crate::BroadPhase::scheduled(threads, method, scheduling);
        let on_gpu = |device: &_| gpu::BroadPhase::scheduled(device, method, scheduling);
        let on = Either::new(choice, on_cpu, on_gpu)?;
        let adapter = choice.device.as_ref().map(|device| gpu::name(device).into());
        Ok(Self { on, adapter: adapter.unwrap_or_default(), threads, method, scheduling })
    }

    /// Pairs within one set, each once, lesser index first.
    ///
    /// # Errors
    /// [`Error::Input`] with those of [`crate::BroadPhase::self_pairs`], and, where the choice was
    /// a GPU alone, what that refuses.
    pub fn self_pairs(&mut self, boxes: &[Aabb<f32>]) -> Result<Pairs<'_>, Error> {
        let &mut Self { threads, method, scheduling, .. } = self;
        let on_cpu = |_: &mut _| crate::BroadPhase::scheduled(threads, method, scheduling);
        match self.on.run(|on| on.self_pairs(boxes), on_cpu)? {
            Turn::Done(pairs) => Ok(Pairs::owned(pairs)),
            Turn::Cpu(on) => Ok(Pairs::lent(on.self_pairs(boxes)?)),
        }
    }

    /// Pairs of a box of `a` with a box of `b`.
    ///
    /// # Errors
    /// [`Error::Input`] with those of [`crate::BroadPhase::self_pairs`], and, where the choice was
    /// a GPU alone, what that refuses.
    pub fn pairs(&mut self, a: &[Aabb<f32>], b: &[Aabb<f32>]) -> Result<Pairs<'_>, Error> {
        let &mut Self { threads, method, scheduling, .. } = self;
        let on_cpu = |_: &mut _| crate::BroadPhase::scheduled(threads, method, scheduling);
        match self.on.run(|on| on.pairs(a, b), on_cpu)? {
            Turn::Done(pairs) => Ok(Pairs::owned(pairs)),
            Turn::Cpu(on) => Ok(Pairs::lent(on.pairs(a, b)?)),
        }
    }

    /// Where it runs.
    pub fn place(&self) -> Place {
        match &self.on {
            Either::Cpu(on) => Place::Cpu { threads: on.threads() },
            Either::Gpu { .. } => Place::Gpu { adapter: self.adapter.clone() },
        }
    }

    /// The GPU's broad phase, for what only a GPU does; `None` on the CPU.
    #[cfg(feature = "gpu")]
    pub fn gpu(&mut self) -> Option<&mut gpu::BroadPhase> {
        match &mut self.on {
            Either::Cpu(_) => None,
            Either::Gpu { on, .. } => Some(on),
        }
    }
}

/// Pairs as a backend lists them: on the CPU they stay in its lists until the next call.
///
/// ```
/// use ccd::any::{Backend, BroadPhase};
/// use ccd::{Aabb, method::BroadPhaseMethod};
///
/// let boxes = [Aabb { min: [0.0f32; 3], max: [1.0; 3] }; 3];
/// let choice = Backend::Cpu.choose(boxes.len())?;
/// let mut broad_phase = BroadPhase::new(&choice, 1, BroadPhaseMethod::default())?;
/// let pairs = broad_phase.self_pairs(&boxes)?;
/// assert_eq!((pairs.len(), pairs.iter().count()), (3, 3));
/// # Ok::<(), ccd::any::Error>(())
/// ```
pub struct Pairs<'a>(Listed<'a>);

enum Listed<'a> {
    Lent(crate::Pairs<'a>),
    Owned(Vec<Pair>),
}

impl<'a> Pairs<'a> {
    pub(super) fn lent(pairs: crate::Pairs<'a>) -> Self {
        Self(Listed::Lent(pairs))
    }

    pub(super) fn owned(pairs: Vec<Pair>) -> Self {
        Self(Listed::Owned(pairs))
    }

    /// Number of pairs.
    pub fn len(&self) -> usize {
        match &self.0 {
            Listed::Lent(pairs) => pairs.len(),
            Listed::Owned(pairs) => pairs.len(),
        }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// All pairs; on a GPU in no order.
    pub fn iter(&self) -> impl Iterator<Item = Pair> {
        let (lent, owned) = match &self.0 {
            Listed::Lent(pairs) => (Some(pairs.iter()), &[][..]),
            Listed::Owned(pairs) => (None, &pairs[..]),
        };
        lent.into_iter().flatten().chain(owned.iter().copied())
    }

    /// A copy, or the list itself where it is one.
    pub fn into_vec(self) -> Vec<Pair> {
        match self.0 {
            Listed::Lent(pairs) => pairs.to_vec(),
            Listed::Owned(pairs) => pairs,
        }
    }
}
