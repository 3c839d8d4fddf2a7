//! Writing many numbers to the device: several threads fill memory that the device copies.
//!
//! Of few bytes it is wgpu's own, which is copied with the next submission but new for every call;
//! to touch its pages first takes most of a step when there are 80 MB of them. So of many bytes it
//! is a buffer that stays mapped between steps.

use crate::device::{BLOCKS, Device};
use crate::error::Error;
use crate::threads;
use bytemuck::Pod;
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::sync::atomic::Ordering::Relaxed;
use wgpu::BufferUsages as U;

/// Bytes from which on a buffer that stays mapped pays.
const LEAST: u64 = 1 << 18;
/// Buffers of a session: five of a step, while the device reads as many, and some more.
const MOST: usize = 12;
/// Bytes that are worth another thread; a multiple of the size of any item.
const PART: usize = 48 << 11;
/// Items that are computed before they are written, because mapped memory is not to be read.
const ITEMS: usize = 64;

/// The buffers.
#[derive(Default)]
pub struct Staging {
    /// The oldest first.
    ring: Vec<Mapped>,
    /// Copies that are not submitted yet, and the buffers that they read.
    copies: Option<wgpu::CommandEncoder>,
    filled: Vec<Mapped>,
}

#[derive(Clone)]
struct Mapped {
    buffer: wgpu::Buffer,
    /// Whether the host may write it: the device has read what was in it.
    is_free: Arc<AtomicBool>,
}

impl Staging {
    /// Writes `n` items to a buffer from the byte `at` on; they are there after
    /// [`Staging::submit`].
    pub fn write<T: Pod>(
        &mut self,
        device: &Device,
        what: &'static str,
        (to, at): (&wgpu::Buffer, u64),
        n: usize,
        item: impl Fn(usize) -> T + Sync,
    ) -> Result<(), Error> {
        const { assert!(size_of::<T>().is_multiple_of(wgpu::MAP_ALIGNMENT as usize)) };
        let bytes = (n * size_of::<T>()) as u64;
        // A browser maps a buffer when it likes to.
        if bytes < LEAST || !BLOCKS {
            return write_once(device, what, (to, at), n, item);
        }
        device.run_callbacks();
        let mapped = self.free(device, bytes)?.clone();
        let Mapped { buffer, is_free } = &mapped;
        let written = device.guarded(what, bytes, || {
            fill(buffer.get_mapped_range_mut(0..bytes)?.slice(..), n, &item);
            buffer.unmap();
            is_free.store(false, Relaxed);
            let new = || device.wgpu().create_command_encoder(&Default::default());
            let copies = self.copies.get_or_insert_with(new);
            copies.copy_buffer_to_buffer(buffer, 0, to, at, bytes);
            Ok::<_, wgpu::MapRangeError>(())
        })?;
        written.map_err(|e| Error::Lost { why: e.to_string() })?;
        self.filled.push(mapped);
        Ok(())
    }

    /// Lets the device copy what was written.
    pub fn submit(&mut self, device: &Device) -> Result<(), Error> {
        let Some(copies) = self.copies.take() else { return Ok(()) };
        let filled = std::mem::take(&mut self.filled);
        device.guarded("positions", 0, || {
            device.queue().submit([copies.finish()]);
            for Mapped { buffer, is_free } in filled {
                buffer.map_async(wgpu::MapMode::Write, .., move |mapped| {
                    is_free.store(mapped.is_ok(), Relaxed);
                });
            }
        })
    }

    /// A mapped buffer that is large enough.
    fn free(&mut self, device: &Device, bytes: u64) -> Result<&Mapped, Error> {
        let is_free = |mapped: &Mapped| mapped.is_free.load(Relaxed);
        let fits = |&at: &usize| {
            let mapped = &self.ring[at];
            is_free(mapped) && mapped.buffer.size() >= bytes
        };
        let all = 0..self.ring.len();
        if let Some(at) = all.filter(fits).min_by_key(|&at| self.ring[at].buffer.size()) {
            return Ok(&self.ring[at]);
        }
        // What is that much smaller is of a smaller mesh: those of one step differ by less.
        self.ring.retain(|mapped| mapped.buffer.size() >= bytes / 4 || !is_free(mapped));
        if self.ring.len() == MOST {
            self.ring.remove(0);
        }
        let limit = device.info().limits.max_buffer_size;
        if bytes > limit {
            return Err(Error::TooLarge { what: "positions", bytes, limit });
        }
        let descriptor = wgpu::BufferDescriptor {
            label: Some("staging"),
            size: bytes,
            usage: U::MAP_WRITE | U::COPY_SRC,
            mapped_at_creation: true,
        };
        let buffer =
            device.guarded("positions", bytes, || device.wgpu().create_buffer(&descriptor))?;
        self.ring.push(Mapped { buffer, is_free: Arc::new(AtomicBool::new(true)) });
        Ok(&self.ring[self.ring.len() - 1])
    }
}

/// Writes `n` items to a buffer from the byte `at` on, by memory that is not kept.
fn write_once<T: Pod>(
    device: &Device,
    what: &'static str,
    (to, at): (&wgpu::Buffer, u64),
    n: usize,
    item: impl Fn(usize) -> T + Sync,
) -> Result<(), Error> {
    let bytes = (n * size_of::<T>()) as u64;
    let Some(size) = wgpu::BufferSize::new(bytes) else { return Ok(()) };
    device.guarded(what, bytes, || {
        // Without a view there is an error, which is noticed around this.
        let view = device.queue().write_buffer_with(to, at, size);
        view.into_iter().for_each(|mut view| fill(view.slice(..), n, &item));
    })
}

/// Writes all items, on several threads.
fn fill<T: Pod>(to: wgpu::WriteOnly<[u8]>, n: usize, item: &(impl Fn(usize) -> T + Sync)) {
    const { assert!(PART.is_multiple_of(size_of::<T>())) };
    let share = PART / size_of::<T>();
    let (parts, rest) = to.into_chunks::<PART>();
    let first_of_rest = parts.len() * share;
    // Parts of a known size, because only those may be sent to another thread.
    let parts: Vec<_> = parts.into_iter().enumerate().collect();
    threads::copy(parts.into_iter(), |(i, part)| {
        write_items(part.into(), i * share..(i + 1) * share, item);
    });
    write_items(rest, first_of_rest..n, item);
}

/// Writes the items of these numbers.
fn write_items<T: Pod>(
    mut to: wgpu::WriteOnly<[u8]>,
    numbers: Range<usize>,
    item: &impl Fn(usize) -> T,
) {
    let mut some = [T::zeroed(); ITEMS];
    for from in numbers.clone().step_by(ITEMS) {
        let until = (from + ITEMS).min(numbers.end);
        let some = &mut some[..until - from];
        make_items(some, from, item);
        let at = [from, until].map(|i| (i - numbers.start) * size_of::<T>());
        to.slice(at[0]..at[1]).copy_from_slice(bytemuck::cast_slice(some));
    }
}

/// Makes the items from this number on. The only place that asks for an item, so that it is inlined
/// here, which halves what it takes.
#[inline(never)]
fn make_items<T>(some: &mut [T], from: usize, item: &impl Fn(usize) -> T) {
    some.iter_mut().zip(from..).for_each(|(some, i)| *some = item(i));
}
