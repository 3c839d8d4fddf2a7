//! Pages of 2 MiB for memory that is about to be filled.
#![cfg_attr(target_os = "linux", allow(unsafe_code, reason = "a call of the system"))]

use std::mem::MaybeUninit;

/// Asks for large pages where `memory` has whole ones. To touch a page of 4 KiB for the first time
/// takes longer than to fill it, most of all on a virtual machine.
///
/// Linux gives them where `/sys/kernel/mm/transparent_hugepage/enabled` says `madvise` (mostly) or
/// `always`; other systems are not asked.
pub fn large<T>(memory: &mut [MaybeUninit<T>]) {
    #[cfg(target_os = "linux")]
    {
        const PAGE: usize = 2 << 20;
        let start = memory.as_mut_ptr() as usize;
        let (first, end) = (start.next_multiple_of(PAGE), start + size_of_val(memory));
        if end / PAGE > first / PAGE {
            let len = end / PAGE * PAGE - first;
            // SAFETY: advice on memory that is borrowed here alone; it changes no content. If it
            // is refused, pages stay small.
            unsafe { libc::madvise(first as *mut libc::c_void, len, libc::MADV_HUGEPAGE) };
        }
    }
    #[cfg(not(target_os = "linux"))]
    let _ = memory;
}
