//! Reading and writing slices by index: checked on a CPU, without a check in a shader.
//!
//! A failed check is an early return in a shader, so a barrier behind it would not be reached by
//! every thread. Kernels keep their indices in range by construction; on a CPU, where the same
//! bodies run, every access is still checked. What bounds an access of a kernel that is wrong: of a
//! storage buffer, where wgpu has opened the device for SPIR-V, Vulkan's `robustBufferAccess`,
//! which the device has on, by which it stays inside of the binding or of the buffer's memory;
//! through WGSL, the checks that naga writes; of workgroup memory and local arrays, through SPIR-V,
//! nothing. Tests run all kernels with a check of every index (`cargo xtask shaders --checked`).

/// Element `i`.
#[inline(always)]
pub fn at<T: Copy>(slice: &[T], i: usize) -> T {
    #[cfg(not(target_arch = "spirv"))]
    return slice[i];
    // SAFETY: the callers' indices are in range, which CPU builds of the same bodies check, and
    // tests of entry points with checked modules; what bounds one that is not, see above.
    #[cfg(target_arch = "spirv")]
    #[allow(unsafe_code, reason = "a failed check would leave before a barrier")]
    return unsafe { *slice.get_unchecked(i) };
}

/// What a slice is made of that holds records `T`: the records themselves, or, on a device, words
/// of two and four numbers, which it reads in one piece each.
pub trait Stored<T>: Copy {
    /// Record `i`.
    fn load(slice: &[Self], i: usize) -> T;
}

impl<T: Copy> Stored<T> for T {
    #[inline(always)]
    fn load(slice: &[Self], i: usize) -> T {
        at(slice, i)
    }
}

/// Sets element `i`.
#[inline(always)]
pub fn put<T: Copy>(slice: &mut [T], i: usize, value: T) {
    #[cfg(not(target_arch = "spirv"))]
    {
        slice[i] = value;
    }
    // SAFETY: as above.
    #[cfg(target_arch = "spirv")]
    #[allow(unsafe_code, reason = "a failed check would leave before a barrier")]
    unsafe {
        *slice.get_unchecked_mut(i) = value;
    }
}
