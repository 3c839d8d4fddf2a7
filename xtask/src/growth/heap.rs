//! Bytes of the host that a piece of work takes: the allocator of this program, which counts while
//! it is asked to.

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicBool, AtomicI64, Ordering::Relaxed};

static COUNTS: AtomicBool = AtomicBool::new(false);
/// Bytes taken and not given back since the count began; below 0 where older ones are given back.
static LIVE: AtomicI64 = AtomicI64::new(0);
/// The most that these were.
static MOST: AtomicI64 = AtomicI64::new(0);

/// The result of `work`, and the most bytes that it held at one time beyond those held before. All
/// threads count; one piece of work at a time is counted.
pub fn counted<T>(work: impl FnOnce() -> T) -> (u64, T) {
    LIVE.store(0, Relaxed);
    MOST.store(0, Relaxed);
    COUNTS.store(true, Relaxed);
    let done = work();
    COUNTS.store(false, Relaxed);
    (MOST.load(Relaxed).unsigned_abs(), done)
}

fn count(bytes: i64) {
    if COUNTS.load(Relaxed) {
        let live = LIVE.fetch_add(bytes, Relaxed) + bytes;
        MOST.fetch_max(live, Relaxed);
    }
}

struct Counting;

#[allow(unsafe_code, reason = "the trait of allocators is unsafe; this one only counts")]
// SAFETY: every call goes to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count(layout.size() as i64);
        // SAFETY: the caller's promises are passed on.
        unsafe { System.alloc(layout) }
    }
    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        count(layout.size() as i64);
        // SAFETY: the caller's promises are passed on.
        unsafe { System.alloc_zeroed(layout) }
    }
    unsafe fn dealloc(&self, p: *mut u8, layout: Layout) {
        count(-(layout.size() as i64));
        // SAFETY: the caller's promises are passed on.
        unsafe { System.dealloc(p, layout) }
    }
    unsafe fn realloc(&self, p: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count(size as i64 - layout.size() as i64);
        // SAFETY: the caller's promises are passed on.
        unsafe { System.realloc(p, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_most_is_counted() {
        let (most, kept) = counted(|| {
            drop(vec![1u8; 3 << 20]);
            vec![1u8; 1 << 20]
        });
        // Other tests may allocate meanwhile.
        assert!(most >= 3 << 20 && kept.len() == 1 << 20, "{most}");
    }
}
