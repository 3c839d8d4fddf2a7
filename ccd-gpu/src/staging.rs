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
/// Buffers of a session: four of a step, while the device reads as many, and some more.
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

/// Whether so many bytes go through a buffer that stays mapped.
pub fn is_staged(bytes: u64) -> bool {
    // A browser maps a buffer when it likes to.
    bytes >= LEAST && BLOCKS
}

/// Items that a buffer is to have.
pub struct Write<'a> {
    /// What an error calls them.
    pub what: &'static str,
    /// The buffer, and the byte from which on they stand in it.
    pub to: (&'a wgpu::Buffer, u64),
    /// Their numbers.
    pub numbers: Range<usize>,
    /// What makes them.
    pub items: &'a dyn Items,
}

/// Makes items from their numbers.
pub trait Items: Sync {
    /// The size of an item.
    fn size(&self) -> usize;
    /// Writes the items of these numbers.
    fn write(&self, to: wgpu::WriteOnly<[u8]>, numbers: Range<usize>);
}

/// Items of which a function makes each.
pub struct Each<F>(pub F);

impl<T: Pod, F: Fn(usize) -> T + Sync> Items for Each<F> {
    fn size(&self) -> usize {
        const { assert!(size_of::<T>().is_multiple_of(wgpu::MAP_ALIGNMENT as usize)) };
        const { assert!(PART.is_multiple_of(size_of::<T>())) };
        size_of::<T>()
    }

    fn write(&self, mut to: wgpu::WriteOnly<[u8]>, numbers: Range<usize>) {
        let mut some = [T::zeroed(); ITEMS];
        for from in numbers.clone().step_by(ITEMS) {
            let until = (from + ITEMS).min(numbers.end);
            let some = &mut some[..until - from];
            some.iter_mut().zip(from..).for_each(|(some, i)| *some = self.0(i));
            let at = [from, until].map(|i| (i - numbers.start) * size_of::<T>());
            to.slice(at[0]..at[1]).copy_from_slice(bytemuck::cast_slice(some));
        }
    }
}

impl Write<'_> {
    pub fn bytes(&self) -> u64 {
        (self.numbers.len() * self.items.size()) as u64
    }

    /// Whether it goes through a buffer that stays mapped.
    pub fn is_staged(&self) -> bool {
        is_staged(self.bytes())
    }
}

impl Staging {
    /// Writes to buffers; all is there after [`Staging::submit`].
    pub fn write(&mut self, device: &Device, writes: &[Write]) -> Result<(), Error> {
        for write in writes.iter().filter(|write| !write.is_staged()) {
            write_once(device, write)?;
        }
        let large: Vec<&Write> = writes.iter().filter(|write| write.is_staged()).collect();
        let Some(first) = large.first() else { return Ok(()) };
        let bytes = large.iter().map(|write| write.bytes()).sum();
        device.run_callbacks();
        let mut mapped: Vec<Mapped> = Vec::with_capacity(large.len());
        for write in &large {
            mapped.push(self.free(device, write.bytes(), &mapped)?.clone());
        }
        let written = device.guarded(first.what, bytes, || {
            let views = mapped.iter().zip(&large);
            let view = |(mapped, write): (&Mapped, &&Write)| {
                mapped.buffer.get_mapped_range_mut(0..write.bytes())
            };
            let mut views = views.map(view).collect::<Result<Vec<_>, _>>()?;
            fill(views.iter_mut().map(|view| view.slice(..)).zip(large.iter().copied()));
            drop(views);
            let new = || device.wgpu().create_command_encoder(&Default::default());
            let copies = self.copies.get_or_insert_with(new);
            for (Mapped { buffer, is_free }, write) in mapped.iter().zip(&large) {
                buffer.unmap();
                is_free.store(false, Relaxed);
                let (to, at) = write.to;
                copies.copy_buffer_to_buffer(buffer, 0, to, at, write.bytes());
            }
            Ok::<_, wgpu::MapRangeError>(())
        })?;
        written.map_err(|e| Error::Lost { why: e.to_string() })?;
        self.filled.append(&mut mapped);
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

    /// Forgets what was staged since the last submission.
    pub fn forget(&mut self) {
        self.copies = None;
        for filled in self.filled.drain(..) {
            self.ring.retain(|mapped| mapped.buffer != filled.buffer);
        }
    }

    /// A mapped buffer that is large enough and none of these.
    fn free(&mut self, device: &Device, bytes: u64, taken: &[Mapped]) -> Result<&Mapped, Error> {
        let is_free = |mapped: &Mapped| mapped.is_free.load(Relaxed);
        let fits = |&at: &usize| {
            let mapped = &self.ring[at];
            let is_taken = taken.iter().any(|taken| taken.buffer == mapped.buffer);
            is_free(mapped) && !is_taken && mapped.buffer.size() >= bytes
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

/// Writes by memory that is not kept.
fn write_once(device: &Device, write: &Write) -> Result<(), Error> {
    let bytes = write.bytes();
    let Some(size) = wgpu::BufferSize::new(bytes) else { return Ok(()) };
    device.guarded(write.what, bytes, || {
        let (to, at) = write.to;
        // Without a view there is an error, which is noticed around this.
        let view = device.queue().write_buffer_with(to, at, size);
        view.into_iter().for_each(|mut view| fill([(view.slice(..), write)].into_iter()));
    })
}

/// Writes all items, on several threads, which wait for each other once.
fn fill<'a>(all: impl Iterator<Item = (wgpu::WriteOnly<'a, [u8]>, &'a Write<'a>)>) {
    let (mut parts, mut rests) = (Vec::new(), Vec::new());
    for (to, write) in all {
        let share = PART / write.items.size();
        let (of_write, rest) = to.into_chunks::<PART>();
        let Range { start, end } = write.numbers;
        rests.push((rest, write.items, start + of_write.len() * share..end));
        // Parts of a known size, because only those may be sent to another thread.
        let of_write = of_write.into_iter().zip((start..).step_by(share));
        parts.extend(of_write.map(|(part, first)| (part, write.items, first..first + share)));
    }
    threads::copy(parts.into_iter(), |(part, items, numbers)| items.write(part.into(), numbers));
    rests.into_iter().for_each(|(rest, items, numbers)| items.write(rest, numbers));
}
