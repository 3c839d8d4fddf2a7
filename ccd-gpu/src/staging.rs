//! Writing many numbers to the device: several threads fill a buffer that stays mapped between
//! steps, and the device copies it.
//!
//! wgpu's `write_buffer` takes new memory for every call, whose pages the host first touches, and
//! copies with one thread: of 80 MB that is most of a step. Small writes go that way, which needs
//! no submission of their own.

use crate::device::{BLOCKS, Device};
use crate::error::Error;
use bytemuck::Pod;
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::sync::atomic::Ordering::Relaxed;
use wgpu::BufferUsages as U;

/// Bytes from which on a buffer that stays mapped pays.
const LEAST: u64 = 1 << 22;
/// Buffers of a session: one that is filled while the device reads another, and one more.
const MOST: usize = 3;
/// Bytes that another thread pays for.
const BYTES_A_THREAD: u64 = 1 << 20;
/// More threads wait for memory.
const MOST_THREADS: usize = 8;
/// Items that are computed before they are written, because mapped memory is not to be read.
const ITEMS: usize = 64;

/// The buffers.
#[derive(Default)]
pub struct Staging {
    ring: Vec<Mapped>,
}

struct Mapped {
    buffer: wgpu::Buffer,
    /// Whether the host may write it: the device has read what was in it.
    is_free: Arc<AtomicBool>,
}

impl Staging {
    /// Writes `n` items to a buffer from the byte `at` on. `scratch` is used for few.
    pub fn write<T: Pod + Send>(
        &mut self,
        device: &Device,
        what: &'static str,
        (to, at): (&wgpu::Buffer, u64),
        n: usize,
        scratch: &mut Vec<T>,
        item: impl Fn(usize) -> T + Sync,
    ) -> Result<(), Error> {
        const { assert!(size_of::<T>().is_multiple_of(wgpu::MAP_ALIGNMENT as usize)) };
        let bytes = (n * size_of::<T>()) as u64;
        // A browser maps a buffer when it likes to.
        if bytes < LEAST || !BLOCKS {
            scratch.clear();
            scratch.extend((0..n).map(item));
            return device.write(what, to, at, bytemuck::cast_slice(scratch));
        }
        device.run_callbacks();
        let Mapped { buffer, is_free } = self.free(device, bytes)?;
        let written = device.guarded(what, bytes, || {
            fill(buffer, n, &item)?;
            buffer.unmap();
            is_free.store(false, Relaxed);
            let mut encoder = device.wgpu().create_command_encoder(&Default::default());
            encoder.copy_buffer_to_buffer(buffer, 0, to, at, bytes);
            device.queue().submit([encoder.finish()]);
            let is_free = is_free.clone();
            buffer.map_async(wgpu::MapMode::Write, .., move |mapped| {
                is_free.store(mapped.is_ok(), Relaxed);
            });
            Ok::<_, wgpu::MapRangeError>(())
        })?;
        written.map_err(|e| Error::Lost { why: e.to_string() })
    }

    /// A mapped buffer that is large enough.
    fn free(&mut self, device: &Device, bytes: u64) -> Result<&Mapped, Error> {
        let is_free = |mapped: &Mapped| mapped.is_free.load(Relaxed);
        // What is too small now is of a smaller mesh, or less than this one needs in all.
        self.ring.retain(|mapped| mapped.buffer.size() >= bytes || !is_free(mapped));
        // One that was kept because it was busy may be free by now, and too small.
        let fits = |mapped: &Mapped| is_free(mapped) && mapped.buffer.size() >= bytes;
        if let Some(at) = self.ring.iter().position(fits) {
            return Ok(&self.ring[at]);
        }
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

/// Writes all items, on several threads.
fn fill<T: Pod>(
    buffer: &wgpu::Buffer,
    n: usize,
    item: &(impl Fn(usize) -> T + Sync),
) -> Result<(), wgpu::MapRangeError> {
    let share = n.div_ceil(threads((n * size_of::<T>()) as u64));
    let mut parts = Vec::new();
    for begin in (0..n).step_by(share) {
        let of = begin..(begin + share).min(n);
        let bytes = [of.start, of.end].map(|i| (i * size_of::<T>()) as u64);
        parts.push((of, buffer.get_mapped_range_mut(bytes[0]..bytes[1])?));
    }
    let write = |(of, mut to): (Range<usize>, wgpu::BufferViewMut)| {
        let mut some = [T::zeroed(); ITEMS];
        for from in of.clone().step_by(ITEMS) {
            let until = (from + ITEMS).min(of.end);
            let some = &mut some[..until - from];
            some.iter_mut().zip(from..).for_each(|(some, i)| *some = item(i));
            let at = [from, until].map(|i| (i - of.start) * size_of::<T>());
            to.slice(at[0]..at[1]).copy_from_slice(bytemuck::cast_slice(some));
        }
    };
    std::thread::scope(|scope| {
        let own = parts.pop();
        for part in parts {
            scope.spawn(move || write(part));
        }
        own.map(write);
    });
    Ok(())
}

/// How many threads work on so many bytes.
pub fn threads(bytes: u64) -> usize {
    let most = std::thread::available_parallelism().map_or(1, |n| n.get()).min(MOST_THREADS);
    ((bytes / BYTES_A_THREAD) as usize).clamp(1, most)
}
