//! Threads and what they share: numbers of threads and workgroups, atomics, lists.
//!
//! No index is checked here; see `ccd_core::backend::kernel::memory`. One past the end of a buffer
//! stays inside by the device's robustness; of workgroup memory nothing bounds it.
#![allow(unsafe_code, reason = "atomics and indices without a check have no safe form")]

use ccd_core::backend::kernel::Words;
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::layout::{Dispatch, Frame, LIST_HEADER, Pair, Params};
use core::marker::PhantomData;
use spirv_std::arch::{
    IndexUnchecked, atomic_compare_exchange, atomic_i_add, atomic_load, atomic_or, atomic_store,
    atomic_u_max, atomic_u_min, control_barrier, subgroup_ballot, subgroup_broadcast_first,
    subgroup_exclusive_i_add, subgroup_i_add,
};
use spirv_std::glam::UVec3;
use spirv_std::memory::{Scope, Semantics};

const DEVICE: u32 = Scope::QueueFamily as u32;
const WORKGROUP: u32 = Scope::Workgroup as u32;
const RELAXED: u32 = Semantics::NONE.bits();
const ACQUIRE: u32 = Semantics::ACQUIRE.bits() | Semantics::UNIFORM_MEMORY.bits();
const ACQUIRE_RELEASE: u32 = Semantics::ACQUIRE_RELEASE.bits() | Semantics::UNIFORM_MEMORY.bits();

/// Number of this workgroup; grids of more than 65,535 are folded into two dimensions.
#[inline(always)]
pub fn group(id: UVec3, n: UVec3) -> u32 {
    id.y * n.x + id.x
}

/// Adds to a word of a buffer and returns the old value.
#[inline(always)]
pub fn add(words: &mut [u32], i: usize, value: u32) -> u32 {
    // SAFETY: callers' indices are in range, and robustBufferAccess bounds them; the scope and the
    // order are valid for storage buffers.
    unsafe { atomic_i_add::<u32, DEVICE, RELAXED>(words.get_unchecked_mut(i), value) }
}

/// Adds to word 0 or 1 of a list's header and returns the old value; the word two behind it counts
/// overflows.
#[inline(always)]
pub fn count(list: &mut [u32], i: usize, value: u32) -> u32 {
    let old = add(list, i, value);
    if old.wrapping_add(value) < old {
        add(list, i + 2, 1);
    }
    old
}

/// Reserves `n` entries of a list of candidates, and returns the first. With
/// [`Frame::FLAG_IN_PARTS`] the third word of its header is the most that was wanted, if that is
/// more than fits.
#[inline(always)]
pub fn reserve<A>(list: &mut [u32], n: u32, params: &Params<A>) -> u32 {
    if !params.frame.has(Frame::FLAG_IN_PARTS) {
        return count(list, 0, n);
    }
    let first = add(list, 0, n);
    let end = first.wrapping_add(n);
    let wanted = if end < first { u32::MAX } else { end };
    if wanted > params.dispatch.capacity_out {
        raise(list, 2, wanted);
    }
    first
}

/// The same for each thread of a subgroup of 32 threads. `child`: its number there.
#[inline(always)]
pub fn reserve_by_subgroup<A>(list: &mut [u32], n: u32, child: u32, params: &Params<A>) -> u32 {
    if subgroup_ballot(n != 0).x == 0 {
        return 0;
    }
    let all = subgroup_i_add(n);
    let first = if child == 0 { reserve(list, all, params) } else { 0 };
    subgroup_broadcast_first(first) + subgroup_exclusive_i_add(n)
}

/// Raises a word of a buffer.
#[inline(always)]
pub fn raise(words: &mut [u32], i: usize, value: u32) {
    // SAFETY: as above.
    unsafe { atomic_u_max::<u32, DEVICE, RELAXED>(words.get_unchecked_mut(i), value) };
}

/// Lowers a word of a buffer.
#[inline(always)]
pub fn lower(words: &mut [u32], i: usize, value: u32) {
    // SAFETY: as above.
    unsafe { atomic_u_min::<u32, DEVICE, RELAXED>(words.get_unchecked_mut(i), value) };
}

/// Sets bits of a word of a buffer.
#[inline(always)]
pub fn or(words: &mut [u32], i: usize, bits: u32) {
    // SAFETY: as above.
    unsafe { atomic_or::<u32, DEVICE, RELAXED>(words.get_unchecked_mut(i), bits) };
}

/// A word of a buffer to which others may write at the same time, if by atomics.
#[inline(always)]
pub fn load(words: &[u32], i: usize) -> u32 {
    // SAFETY: as above.
    unsafe { atomic_load::<u32, DEVICE, RELAXED>(words.get_unchecked(i)) }
}

/// Sets a word of a buffer that others may read at the same time, if by atomics.
#[inline(always)]
pub fn store(words: &mut [u32], i: usize, value: u32) {
    // SAFETY: as above.
    unsafe { atomic_store::<u32, DEVICE, RELAXED>(words.get_unchecked_mut(i), value) };
}

/// Adds to a word of workgroup memory and returns the old value.
#[inline(always)]
pub fn add_shared<const N: usize>(words: &mut [u32; N], i: u32, value: u32) -> u32 {
    // SAFETY: callers' indices are in range, and nothing else bounds them; the scope is that of the
    // memory.
    unsafe { atomic_i_add::<u32, WORKGROUP, RELAXED>(words.index_unchecked_mut(i as usize), value) }
}

/// Sets bits of a word of workgroup memory.
#[inline(always)]
pub fn or_shared<const N: usize>(words: &mut [u32; N], i: u32, bits: u32) {
    // SAFETY: as above.
    unsafe { atomic_or::<u32, WORKGROUP, RELAXED>(words.index_unchecked_mut(i as usize), bits) };
}

/// Raises a word of workgroup memory.
#[inline(always)]
pub fn raise_shared<const N: usize>(words: &mut [u32; N], i: u32, value: u32) {
    // SAFETY: as above.
    unsafe {
        atomic_u_max::<u32, WORKGROUP, RELAXED>(words.index_unchecked_mut(i as usize), value)
    };
}

/// Lowers a word of workgroup memory.
#[inline(always)]
pub fn lower_shared<const N: usize>(words: &mut [u32; N], i: u32, value: u32) {
    // SAFETY: as above.
    unsafe {
        atomic_u_min::<u32, WORKGROUP, RELAXED>(words.index_unchecked_mut(i as usize), value)
    };
}

/// Element `i` of an array in workgroup memory.
#[inline(always)]
pub fn get<T: Copy, const N: usize>(shared: &[T; N], i: u32) -> T {
    // SAFETY: callers' indices are in range, and nothing else bounds them.
    unsafe { *shared.index_unchecked(i as usize) }
}

/// Sets element `i` of an array in workgroup memory.
#[inline(always)]
pub fn set<T: Copy, const N: usize>(shared: &mut [T; N], i: u32, value: T) {
    // SAFETY: as above.
    unsafe { *shared.index_unchecked_mut(i as usize) = value };
}

/// Waits for the workgroup; what its threads wrote to workgroup memory before is seen after.
#[inline(always)]
pub fn barrier() {
    spirv_std::arch::workgroup_memory_barrier_with_group_sync();
}

/// Waits for the subgroup; what its threads wrote to workgroup memory before is seen after.
#[inline(always)]
pub fn subgroup_barrier() {
    const SUBGROUP: u32 = Scope::Subgroup as u32;
    const ORDER: u32 = Semantics::ACQUIRE_RELEASE.bits() | Semantics::WORKGROUP_MEMORY.bits();
    control_barrier::<SUBGROUP, SUBGROUP, ORDER>();
}

/// A word of workgroup memory by which all threads decide alike, also whether they reach a barrier.
/// Two barriers; the translation to WGSL knows the three instructions by their order, and makes
/// them a `workgroupUniformLoad`, so that browsers see it. No atomics on that memory.
#[inline(always)]
pub fn get_uniform<const N: usize>(shared: &[u32; N], i: u32) -> u32 {
    barrier();
    let word = get(shared, i);
    barrier();
    word
}

/// Length of a list: the entries wanted, at most its capacity.
#[inline(always)]
pub fn length(list: &[u32], capacity: u32) -> u32 {
    at(list, 0).min(capacity)
}

/// Entries of a list from `dispatch.first` on that one dispatch takes, at most `dispatch.n`.
#[inline(always)]
pub fn part(list: &[u32], dispatch: &Dispatch) -> u32 {
    let len = length(list, dispatch.capacity_in);
    let left = if len > dispatch.first { len - dispatch.first } else { 0 };
    left.min(dispatch.n)
}

/// Pair `i` of a list.
#[inline(always)]
pub fn read_pair(list: &[u32], i: u32) -> Pair {
    let from = LIST_HEADER + 2 * i as usize;
    Pair { a: at(list, from), b: at(list, from + 1) }
}

/// Writes pair `i` of a list; one beyond the capacity is only counted.
#[inline(always)]
pub fn write_pair(list: &mut [u32], capacity: u32, i: u32, pair: Pair) {
    if i < capacity {
        let to = LIST_HEADER + 2 * i as usize;
        put(list, to, pair.a);
        put(list, to + 1, pair.b);
    }
}

/// Counts and writes one pair.
#[inline(always)]
pub fn append(list: &mut [u32], capacity: u32, pair: Pair) {
    let i = count(list, 0, 1);
    write_pair(list, capacity, i, pair);
}

/// As [`barrier`], also for what the threads of the workgroup stored to buffers and loaded from
/// them: what comes after it in one thread, as seen by other workgroups, comes after what came
/// before it in all.
#[inline(always)]
pub fn barrier_of_buffers() {
    control_barrier::<WORKGROUP, DEVICE, { ACQUIRE_RELEASE | Semantics::WORKGROUP_MEMORY.bits() }>(
    );
}

/// Words of a buffer that workgroups pass to each other inside a dispatch, in order. For the native
/// path alone: WGSL has no order between workgroups.
///
/// Every access is an atomic operation at the scope of the device, also of words that are data: a
/// plain load may be served from a cache that other workgroups do not write through. An operation
/// that acquires or releases does so for the thread that runs it. What its neighbours stored is
/// released with it only behind [`barrier_of_buffers`], which orders their stores before the
/// barrier and with it before all that follows; what they load is acquired if such a barrier stands
/// between the operation and their loads. So a worker of many threads puts one before each word
/// that it publishes or gives back, and one behind each that it takes.
///
/// An operation that acquires or releases does not stand in a loop that some threads of a
/// workgroup leave before others: lavapipe (Mesa 22.3) takes it for a barrier of the workgroup, and
/// the threads that went around once more come late to all barriers that follow.
pub struct DeviceWords<'a> {
    words: *mut [u32],
    first: usize,
    lifetime: PhantomData<&'a mut [u32]>,
}

impl<'a> DeviceWords<'a> {
    /// The words of a binding that is written, from word `first` on.
    #[inline(always)]
    pub fn behind(words: &'a mut [u32], first: usize) -> Self {
        Self { words, first, lifetime: PhantomData }
    }

    /// Word `i`, for an atomic operation.
    #[inline(always)]
    #[allow(clippy::mut_from_ref, reason = "what atomics of the device take")]
    fn word(&self, i: usize) -> &mut u32 {
        // SAFETY: callers' indices are in range, and robustBufferAccess bounds them; all access to
        // these words is atomic.
        unsafe { (&mut *self.words).get_unchecked_mut(self.first + i) }
    }
}

impl Words for DeviceWords<'_> {
    #[inline(always)]
    fn load(&self, i: usize) -> u32 {
        // SAFETY: as above; the scope and the order are valid for storage buffers.
        unsafe { atomic_load::<u32, DEVICE, RELAXED>(self.word(i)) }
    }
    #[inline(always)]
    fn store(&self, i: usize, value: u32) {
        // SAFETY: as above.
        unsafe { atomic_store::<u32, DEVICE, RELAXED>(self.word(i), value) }
    }
    #[inline(always)]
    fn add_acquire_release(&self, i: usize, value: u32) -> u32 {
        // SAFETY: as above.
        unsafe { atomic_i_add::<u32, DEVICE, ACQUIRE_RELEASE>(self.word(i), value) }
    }
    #[inline(always)]
    fn load_acquire(&self, i: usize) -> u32 {
        // SAFETY: as above.
        unsafe { atomic_load::<u32, DEVICE, ACQUIRE>(self.word(i)) }
    }
    #[inline(always)]
    fn compare_exchange(&self, i: usize, old: u32, new: u32) -> u32 {
        // SAFETY: as above.
        unsafe {
            atomic_compare_exchange::<u32, DEVICE, ACQUIRE_RELEASE, RELAXED>(self.word(i), new, old)
        }
    }
}
