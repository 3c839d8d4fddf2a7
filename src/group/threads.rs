//! Work of a group on threads of this host.

/// Vertices from which on positions are copied by several threads a member.
const FEWEST_FOR_THREADS: usize = 100_000;
/// Threads that copy for one member.
const MOST_THREADS: usize = 8;

/// How many threads copy the positions of `n_vertices` for each of so many members.
pub fn threads_a_member(n_vertices: usize, n_members: usize) -> usize {
    let few = n_vertices < FEWEST_FOR_THREADS;
    if few { 1 } else { (available() / n_members).clamp(1, MOST_THREADS) }
}

fn available() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// Contacts that another thread pays for.
const CONTACTS_A_THREAD: usize = 50_000;

/// How many contacts each of some threads takes.
pub fn contacts_a_thread(n: usize) -> usize {
    n.div_ceil(available().min(MOST_THREADS)).max(CONTACTS_A_THREAD)
}

/// Each on a thread of its own, the first on this one; results in order.
pub fn at_once<T: Send, R: Send>(
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
