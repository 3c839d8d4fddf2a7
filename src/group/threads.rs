//! Work of a group on threads of this host, which are kept: to start one takes as long as copying
//! 50,000 positions.

use rayon::{ThreadPool, ThreadPoolBuilder};

/// The threads.
pub struct Threads {
    /// All but the calling one; none if they could not be started.
    others: Option<ThreadPool>,
}

impl Threads {
    /// As many as the host runs at a time.
    pub fn new() -> Self {
        let n = std::thread::available_parallelism().map_or(1, usize::from) - 1;
        let named =
            ThreadPoolBuilder::new().num_threads(n).thread_name(|i| format!("ccd-group {i}"));
        Self { others: (n > 0).then(|| named.build().ok()).flatten() }
    }

    /// Each at once as far as there are threads, the first on this one; results in order.
    pub fn at_once<T: Send, R: Send>(
        &self,
        all: impl ExactSizeIterator<Item = T>,
        of: impl Fn(T) -> R + Sync,
    ) -> Vec<R> {
        let Some(others) = &self.others else { return all.map(of).collect() };
        let mut results: Vec<Option<R>> = Vec::new();
        results.resize_with(all.len(), || None);
        let mut each = all.zip(&mut results);
        let work = |(each, result): (T, &mut Option<R>)| *result = Some(of(each));
        if let Some(first) = each.next() {
            others.in_place_scope(|scope| {
                let work = &work;
                each.for_each(|other| scope.spawn(move |_| work(other)));
                work(first);
            });
        }
        results.into_iter().flatten().collect()
    }
}

/// Each on a thread of its own, the first on this one; results in order. For work that waits: a
/// kept thread that waits takes other work meanwhile, which may be all of another device's step.
pub fn each_alone<T: Send, R: Send>(
    mut all: impl Iterator<Item = T>,
    of: impl Fn(T) -> R + Sync,
) -> Vec<R> {
    let of = &of;
    std::thread::scope(|scope| {
        let first = all.next();
        let others: Vec<_> = all.map(|each| scope.spawn(move || of(each))).collect();
        let joined = |other: std::thread::ScopedJoinHandle<R>| {
            other.join().unwrap_or_else(|e| std::panic::resume_unwind(e))
        };
        first.map(of).into_iter().chain(others.into_iter().map(joined)).collect()
    })
}
