//! Where work runs: in the calling thread, on rayon's current pool, or on a pool of a wanted size.
#![allow(unsafe_code, reason = "threads write to parts of one slice")]

use crate::pages;
use crate::stop::Stop;
use ccd_core::Error;
use ccd_core::model::options::Options;
use rayon::prelude::*;
use std::marker::PhantomData;
use std::mem::MaybeUninit;
use std::ops::Range;
use std::process;
use std::sync::{Arc, OnceLock};

/// What one worker owns, alone on its cache lines: workers that write into neighbouring ones would
/// slow each other down.
#[derive(Debug, Default)]
#[repr(align(128))]
pub struct Own<T>(pub T);

/// Whether there can be no thread but the calling one: on WebAssembly without shared memory.
const ALONE: bool = cfg!(all(target_family = "wasm", not(target_feature = "atomics")));

/// A number of threads and the pool that has them.
#[derive(Debug)]
pub struct Threads {
    pool: Option<Arc<rayon::ThreadPool>>,
    count: usize,
    /// What ends their work early.
    pub stop: Arc<Stop>,
}

/// Whether rayon's pool may be that of the process which this one was forked from: its threads are
/// not here, and would be waited for without end.
fn is_orphaned() -> bool {
    static FIRST: OnceLock<u32> = OnceLock::new();
    cfg!(unix)
        && *FIRST.get_or_init(process::id) != process::id()
        && rayon::current_thread_index().is_none()
}

impl Threads {
    /// `count` threads; 0 means the pool that rayon uses at the place of the call; 1 means the
    /// calling thread, with no pool at all, and so does 0 where threads cannot be. In a process
    /// that was forked from one that has used rayon's pool, 0 means a new one.
    pub fn new(count: usize) -> Result<Self, Error> {
        let threads = |pool, count| Ok(Self { pool, count, stop: Arc::default() });
        match count {
            0 if ALONE => threads(None, 1),
            2.. if ALONE => Err(Error::Threads { count, limit: 1 }),
            0 if is_orphaned() => {
                let all = std::thread::available_parallelism().map_or(1, usize::from);
                Self::new(all.min(Options::MAX_THREADS))
            }
            0 => threads(None, rayon::current_num_threads()),
            1 => threads(None, 1),
            _ => {
                let limit = Options::MAX_THREADS;
                let refused = Error::Threads { count, limit };
                if count > limit {
                    return Err(refused);
                }
                let pool = rayon::ThreadPoolBuilder::new().num_threads(count).build();
                threads(Some(Arc::new(pool.map_err(|_| refused)?)), count)
            }
        }
    }

    /// The same threads, for work that something else ends.
    pub fn shared(&self, stop: Arc<Stop>) -> Self {
        Self { pool: self.pool.clone(), count: self.count, stop }
    }

    /// The calling thread alone, for work that ends with these.
    pub fn alone(&self) -> Self {
        Self { pool: None, count: 1, stop: self.stop.clone() }
    }

    /// Number of threads.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Whether there is one; where there can be no more, rayon is not compiled.
    #[inline(always)]
    fn is_alone(&self) -> bool {
        ALONE || self.count == 1
    }

    /// Runs `f` in one of these threads, so that the parallel calls inside of it use them.
    ///
    /// A parallel call from a thread that is none of them would hand its work over and sleep until
    /// it is done: twice a change of threads, and on a busy machine twice a wait for a processor. A
    /// step makes some forty such calls; this way it waits once.
    pub fn enter<R: Send>(&self, f: impl FnOnce() -> R + Send) -> R {
        let (mut f, mut result) = (Some(f), None);
        self.inside(&mut || result = f.take().map(|f| f()));
        result.expect("called once")
    }

    fn inside(&self, f: &mut (dyn FnMut() + Send)) {
        match &self.pool {
            _ if ALONE => f(),
            Some(pool) => pool.install(f),
            None if self.count == 1 || rayon::current_thread_index().is_some() => f(),
            None => rayon::scope(|_| f()),
        }
    }

    /// Calls `f` once with each of `0..n`, at most `most` of them in one task.
    ///
    /// Here and in what calls it `f` does much, so that rayon is compiled once, not into each use.
    fn calls(&self, n: usize, most: usize, f: &(dyn Fn(usize) + Sync)) {
        if self.is_alone() {
            (0..n).for_each(f);
        } else {
            (0..n).into_par_iter().with_max_len(most).for_each(f);
        }
    }

    /// Runs three things at once, whose own parallel calls then wait for threads at once, too.
    pub fn together(
        &self,
        a: impl FnOnce() + Send,
        b: impl FnOnce() + Send,
        c: impl FnOnce() + Send,
    ) {
        if self.is_alone() {
            a();
            b();
            c();
        } else {
            rayon::join(a, || rayon::join(b, c));
        }
    }

    /// Runs `f(k, worker)` once per worker, in parallel; workers pull their work from what `f`
    /// shares.
    pub fn each<W: Send>(&self, workers: &mut [W], f: &(dyn Fn(usize, &mut W) + Sync)) {
        let workers = Parts::new(workers, 1);
        // SAFETY: `calls` gives each number to one call.
        self.calls(workers.count(), 1, &|k| f(k, &mut unsafe { workers.part(k) }[0]));
    }

    /// As [`Threads::each`], with a second thing of its own for every worker.
    pub fn each_with<W: Send, S: Send>(
        &self,
        workers: &mut [W],
        scratch: &mut [S],
        f: &(dyn Fn(usize, &mut W, &mut S) + Sync),
    ) {
        assert_eq!(workers.len(), scratch.len());
        let scratch = Parts::new(scratch, 1);
        // SAFETY: `each` gives each number to one call.
        self.each(workers, &|k, worker| f(k, worker, &mut unsafe { scratch.part(k) }[0]));
    }

    /// Fills `out[i] = f(i)`.
    pub fn fill<T: Send>(&self, out: &mut [T], f: impl Fn(usize) -> T + Sync) {
        self.chunks(out, &|first, part| {
            for (i, slot) in part.iter_mut().enumerate() {
                *slot = f(first + i);
            }
        });
    }

    /// Fills `(out[i], other[i]) = f(i)`, where `f` takes half a microsecond or so.
    pub fn fill_both<T: Send, S: Send>(
        &self,
        out: &mut [T],
        other: &mut [S],
        f: impl Fn(usize) -> (T, S) + Sync,
    ) {
        assert_eq!(out.len(), other.len());
        let n = 32;
        let (out, other) = (Parts::new(out, n), Parts::new(other, n));
        self.calls(out.count(), usize::MAX, &|k| {
            // SAFETY: `calls` gives each number to one call.
            let (out, other) = unsafe { (out.part(k), other.part(k)) };
            for (i, slots) in out.iter_mut().zip(other).enumerate() {
                (*slots.0, *slots.1) = f(k * n + i);
            }
        });
    }

    /// Appends `f(0)`, `f(1)`, .., `n` items.
    pub fn append<T: Send>(&self, out: &mut Vec<T>, n: usize, f: impl Fn(usize) -> T + Sync) {
        out.reserve(n);
        self.fill(&mut out.spare_capacity_mut()[..n], |i| MaybeUninit::new(f(i)));
        // SAFETY: so many more items have been written.
        unsafe { out.set_len(out.len() + n) };
    }

    /// As [`Vec::resize`]; memory that is new is first touched by all threads, which takes longer
    /// than to fill it.
    pub fn resize<T: Send>(&self, out: &mut Vec<T>, n: usize, new: impl Fn() -> T + Sync) {
        out.truncate(n);
        if out.len() < n {
            out.reserve_exact(n - out.len());
            pages::large(out.spare_capacity_mut());
            self.append(out, n - out.len(), |_| new());
        }
    }

    /// Replaces every `x` by `f(x)`.
    pub fn update<T: Copy + Send>(&self, items: &mut [T], f: impl Fn(T) -> T + Sync) {
        self.chunks(items, &|_, part| part.iter_mut().for_each(|x| *x = f(*x)));
    }

    /// Runs `f` for parts of `out` that begin at the given index.
    pub fn chunks<T: Send>(&self, out: &mut [T], f: &(dyn Fn(usize, &mut [T]) + Sync)) {
        // Elements a task, at most some 64 KiB: small enough to balance, large enough to amortise.
        let most = if size_of::<T>() > 64 { 256 } else { 2048 };
        let n = out.len().div_ceil(4 * self.count).clamp(most / 8, most);
        let parts = Parts::new(out, n);
        // SAFETY: `calls` gives each number to one call.
        self.calls(parts.count(), usize::MAX, &|k| f(k * n, unsafe { parts.part(k) }));
    }

    /// As [`Threads::chunks`], of those items alone that are in `runs`, which are sorted and apart:
    /// at the cost of what lies between the first and the last of them.
    pub fn chunks_in<T: Send>(
        &self,
        out: &mut [T],
        runs: &[Range<usize>],
        f: &(dyn Fn(usize, &mut [T]) + Sync),
    ) {
        let (Some(first), Some(last)) = (runs.first(), runs.last()) else { return };
        let start = first.start;
        self.chunks(&mut out[start..last.end], &|from, chunk| {
            let of = start + from..start + from + chunk.len();
            let next = runs.partition_point(|run| run.end <= of.start);
            for run in runs[next..].iter().take_while(|run| run.start < of.end) {
                let part = run.start.max(of.start)..run.end.min(of.end);
                f(part.start, &mut chunk[part.start - of.start..part.end - of.start]);
            }
        });
    }

    /// Fills `out[i] = f(i)` for every `i` in `runs`, see [`Threads::chunks_in`].
    pub fn fill_in<T: Send>(
        &self,
        out: &mut [T],
        runs: &[Range<usize>],
        f: impl Fn(usize) -> T + Sync,
    ) {
        self.chunks_in(out, runs, &|first, part| {
            for (i, slot) in part.iter_mut().enumerate() {
                *slot = f(first + i);
            }
        });
    }

    /// Merges what `measure` says of parts of all sets, in the same order for any number of
    /// threads.
    #[cfg(feature = "catalogue")]
    pub fn fold<X: Sync, T: Copy + Send>(
        &self,
        sets: &[&[X]],
        none: T,
        parts: &mut Vec<T>,
        measure: &(dyn Fn(&[X]) -> T + Sync),
        merged: &dyn Fn(&T, &T) -> T,
    ) -> T {
        /// Items that one thread takes together.
        const CHUNK: usize = 4096;
        sets.iter().fold(none, |all, items| {
            parts.resize(items.len().div_ceil(CHUNK), none);
            let part = |i: usize| &items[i * CHUNK..((i + 1) * CHUNK).min(items.len())];
            self.each(parts, &|i, slot| *slot = measure(part(i)));
            parts.iter().fold(all, |all, part| merged(&all, part))
        })
    }

    /// Sorts in place by a key that no two items share.
    pub fn sort<T: Send, K: Ord>(&self, items: &mut [T], key: impl Fn(&T) -> K + Sync) {
        if self.is_alone() {
            items.sort_unstable_by_key(key)
        } else {
            items.par_sort_unstable_by_key(key)
        }
    }
}

/// A slice in parts that threads take by their number.
struct Parts<'a, T> {
    items: *mut T,
    len: usize,
    /// Items of each part, but for the last one.
    size: usize,
    slice: PhantomData<&'a mut [T]>,
}

// SAFETY: who shares this reaches an item only by `part`, whose caller has that part alone.
unsafe impl<T: Send> Sync for Parts<'_, T> {}

impl<'a, T> Parts<'a, T> {
    fn new(items: &'a mut [T], size: usize) -> Self {
        Self { items: items.as_mut_ptr(), len: items.len(), size, slice: PhantomData }
    }

    fn count(&self) -> usize {
        self.len.div_ceil(self.size)
    }

    /// Part `k`.
    ///
    /// # Safety
    ///
    /// No other slice of this part may exist.
    #[allow(clippy::mut_from_ref, reason = "each part is another slice")]
    unsafe fn part(&self, k: usize) -> &mut [T] {
        let first = k * self.size;
        assert!(first < self.len);
        // SAFETY: within the slice that this borrows; disjoint from all other parts.
        unsafe {
            std::slice::from_raw_parts_mut(self.items.add(first), self.size.min(self.len - first))
        }
    }
}
