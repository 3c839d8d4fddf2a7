//! Pointers of the caller as references and slices. Checked: NULL, alignment, sizes that no memory
//! has. Not checked: whether there is memory behind a pointer.

use crate::status::{CcdStatus, Failure};
use std::ffi::{CStr, c_char};
use std::sync::{Mutex, MutexGuard, TryLockError};

/// What a pointer that may not be NULL points to.
///
/// # Safety
/// NULL, or valid for reads for as long as the reference lives, and written by nobody meanwhile.
pub unsafe fn shared<'a, T>(pointer: *const T, name: &str) -> Result<&'a T, Failure> {
    check(pointer, name)?;
    // SAFETY: not NULL and aligned; the rest is the caller's duty.
    Ok(unsafe { &*pointer })
}

/// Writes an output, which may not be NULL.
///
/// # Safety
/// NULL, or valid for a write.
pub unsafe fn write<T>(pointer: *mut T, name: &str, value: T) -> Result<(), Failure> {
    check(pointer, name)?;
    // SAFETY: not NULL and aligned; the rest is the caller's duty. What was there has no destructor
    // that C would expect to run.
    unsafe { pointer.write(value) };
    Ok(())
}

/// An array; NULL if it is empty.
///
/// # Safety
/// NULL, or valid for reads of `count` elements for as long as the slice lives.
pub unsafe fn list<'a, T>(pointer: *const T, count: usize, name: &str) -> Result<&'a [T], Failure> {
    if count == 0 {
        return Ok(&[]);
    }
    check(pointer, name)?;
    bytes_of(count, size_of::<T>(), size_of::<T>(), name)?;
    // SAFETY: not NULL, aligned, of a size that memory can have; the rest is the caller's duty.
    Ok(unsafe { std::slice::from_raw_parts(pointer, count) })
}

/// The bytes from the first element, of `size` bytes, to the end of the last one, with a stride.
///
/// # Safety
/// NULL, or valid for reads of these bytes for as long as the slice lives.
pub unsafe fn bytes<'a>(
    pointer: *const u8,
    [count, stride, size]: [usize; 3],
    name: &str,
) -> Result<&'a [u8], Failure> {
    if count == 0 {
        return Ok(&[]);
    }
    check(pointer, name)?;
    let length = bytes_of(count, stride, size, name)?;
    // SAFETY: not NULL, of a size that memory can have; the rest is the caller's duty.
    Ok(unsafe { std::slice::from_raw_parts(pointer, length) })
}

/// Rows of `N` indices, the first of each row a stride after that of the row before; 0 stands for
/// rows without a gap. They may lie at any address.
///
/// # Safety
/// As [`bytes`].
pub unsafe fn rows<const N: usize>(
    pointer: *const u32,
    count: usize,
    stride: usize,
    name: &str,
) -> Result<Vec<[u32; N]>, Failure> {
    let size = size_of::<[u32; N]>();
    let stride = if stride == 0 { size } else { stride };
    if stride < size {
        let why = format!("{name} have a stride of {stride} bytes; a row takes {size}");
        return Err(Failure::argument(why));
    }
    // SAFETY: the caller's duty.
    let bytes = unsafe { bytes(pointer.cast(), [count, stride, size], name)? };
    let index = |row: &[u8], i: usize| {
        let (four, _) = row[4 * i..].split_first_chunk().expect("a row has N indices");
        u32::from_ne_bytes(*four)
    };
    let rows = bytes.chunks(stride).take(count);
    Ok(rows.map(|row| std::array::from_fn(|i| index(row, i))).collect())
}

/// Text that ends with 0; `None` for NULL.
///
/// # Safety
/// NULL, or a text that ends with 0 and lives as long as the slice.
pub unsafe fn string<'a>(pointer: *const c_char, name: &str) -> Result<Option<&'a str>, Failure> {
    if pointer.is_null() {
        return Ok(None);
    }
    // SAFETY: not NULL; the rest is the caller's duty.
    let text = unsafe { CStr::from_ptr(pointer) };
    let text = text.to_str().map_err(|why| Failure::argument(format!("{name}: {why}")))?;
    Ok(Some(text))
}

/// What one call at a time may use.
pub fn lock<'a, T>(mutex: &'a Mutex<T>, name: &str) -> Result<MutexGuard<'a, T>, Failure> {
    mutex.try_lock().map_err(|why| match why {
        TryLockError::WouldBlock => {
            Failure::new(CcdStatus::Busy, format!("another call uses this {name} at the moment"))
        }
        TryLockError::Poisoned(_) => {
            let why = format!("an earlier call with this {name} panicked: create another one");
            Failure::new(CcdStatus::Panicked, why)
        }
    })
}

fn check<T>(pointer: *const T, name: &str) -> Result<(), Failure> {
    if pointer.is_null() {
        Err(Failure::argument(format!("{name} is NULL")))
    } else if !pointer.is_aligned() {
        let align = align_of::<T>();
        Err(Failure::argument(format!("{name} is no multiple of {align}, as its type needs")))
    } else {
        Ok(())
    }
}

/// Bytes from the first of `count` elements, at least one, to the end of the last.
fn bytes_of(count: usize, stride: usize, size: usize, name: &str) -> Result<usize, Failure> {
    let length = (count - 1).checked_mul(stride).and_then(|start| start.checked_add(size));
    // The most that an object may take in memory.
    length.filter(|&length| length <= isize::MAX as usize).ok_or_else(|| {
        Failure::argument(format!("{name}: {count} times {stride} bytes is more than memory"))
    })
}
