//! How much memory a reader takes at most: an allocator that counts.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

struct Counting;

thread_local! {
    /// Bytes that this thread has taken less those that it gave back, and the most of them so far.
    static BYTES: Cell<[isize; 2]> = const { Cell::new([0; 2]) };
}

fn grown(by: isize) {
    let [now, most] = BYTES.get();
    BYTES.set([now + by, most.max(now + by)]);
}

#[allow(unsafe_code, reason = "the trait of allocators is unsafe; this one only counts")]
// SAFETY: every call goes to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        grown(layout.size() as isize);
        // SAFETY: the caller's promises are passed on.
        unsafe { System.alloc(layout) }
    }
    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        grown(layout.size() as isize);
        // SAFETY: the caller's promises are passed on.
        unsafe { System.alloc_zeroed(layout) }
    }
    unsafe fn dealloc(&self, p: *mut u8, layout: Layout) {
        grown(-(layout.size() as isize));
        // SAFETY: the caller's promises are passed on.
        unsafe { System.dealloc(p, layout) }
    }
    unsafe fn realloc(&self, p: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        grown(size as isize);
        grown(-(layout.size() as isize));
        // SAFETY: the caller's promises are passed on.
        unsafe { System.realloc(p, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Runs a reader on a file of so many bytes; panics if it takes more than `times` as many at once
/// and `more` besides.
pub fn bounded<T>(length: usize, times: usize, more: usize, read: impl FnOnce() -> T) -> T {
    let [before, _] = BYTES.get();
    BYTES.set([before; 2]);
    let out = read();
    let most = (BYTES.get()[1] - before) as usize;
    assert!(most <= times * length + more, "{most} bytes of memory for a file of {length}");
    out
}
