//! Reading from the device: parts of buffers are copied into one that the host can map.

use crate::device::{BLOCKS, Device};
use crate::error::Error;
use std::future::poll_fn;
use std::sync::atomic::AtomicBool;
use std::sync::atomic::Ordering::Relaxed;
use std::sync::{Arc, Mutex, MutexGuard};
use std::task::{Context, Poll, Waker, ready};

/// A buffer that is mapped for reading; grows, is kept.
///
/// A mapping that is dropped before its bytes are here spoils the buffer, which is not used again:
/// wgpu keeps the first wish to map it, and fulfils the next one when the first's commands are
/// done, before those of the next.
#[derive(Default)]
pub struct Readback {
    buffer: Option<Mappable>,
}

/// A buffer, and whether a mapping of it was dropped before its bytes were here.
#[derive(Clone, Debug)]
struct Mappable {
    buffer: wgpu::Buffer,
    spoiled: Arc<AtomicBool>,
}

/// Parts that are to be read together.
#[derive(Debug, Default)]
pub struct Plan {
    bytes: u64,
}

/// A part of what is read.
#[derive(Clone, Copy, Debug, Default)]
pub struct Part {
    pub at: u64,
    pub bytes: u64,
}

/// A plan with its buffer.
#[derive(Clone, Debug)]
pub struct Reading {
    pub buffer: wgpu::Buffer,
    spoiled: Arc<AtomicBool>,
    bytes: u64,
}

impl Plan {
    /// A part of so many bytes.
    pub fn part(&mut self, bytes: u64) -> Part {
        let part = Part { at: self.bytes, bytes };
        self.bytes += bytes.next_multiple_of(8);
        part
    }
}

impl Readback {
    /// Makes the buffer large enough for a plan.
    pub fn prepare(&mut self, device: &Device, plan: Plan) -> Result<Reading, Error> {
        let Plan { bytes } = plan;
        let fits = |b: &Mappable| b.buffer.size() >= bytes && !b.spoiled.load(Relaxed);
        let mappable = match self.buffer.take().filter(fits) {
            Some(mappable) => mappable,
            None => {
                let limit = device.info().limits.max_buffer_size;
                if bytes > limit {
                    return Err(Error::TooLarge { what: "results", bytes, limit });
                }
                let size = (bytes + bytes / 4 + 4096).min(limit).next_multiple_of(8);
                let usage = wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST;
                let descriptor = wgpu::BufferDescriptor {
                    label: Some("results"),
                    size,
                    usage,
                    mapped_at_creation: false,
                };
                let buffer =
                    device.guarded("results", size, || device.wgpu().create_buffer(&descriptor))?;
                Mappable { buffer, spoiled: Arc::default() }
            }
        };
        self.buffer = Some(mappable.clone());
        let Mappable { buffer, spoiled } = mappable;
        Ok(Reading { buffer, spoiled, bytes })
    }
}

impl Reading {
    /// Asks for the bytes of all parts; see [`Part::of`].
    pub fn begin(&self, device: &Device) -> Result<Mapping, Error> {
        Mapping::new(device, &self.buffer, &self.spoiled, self.bytes)
    }

    /// Waits and calls `read` with the bytes of all parts.
    pub async fn with<T>(
        &self,
        device: &Device,
        read: impl FnOnce(&[u8]) -> T,
    ) -> Result<T, Error> {
        let mapping = self.begin(device)?;
        mapping.arrived().await?;
        mapping.read(read)
    }

    /// The same, and blocks.
    pub fn wait_with<T>(&self, device: &Device, read: impl FnOnce(&[u8]) -> T) -> Result<T, Error> {
        device.block_on(self.with(device, read))
    }
}

/// Bytes on their way to the host. When this is dropped, the buffer can be written again, whether
/// they arrived or not.
pub struct Mapping {
    device: Device,
    buffer: wgpu::Buffer,
    bytes: u64,
    arrival: Arc<Mutex<Arrival>>,
    spoiled: Arc<AtomicBool>,
}

enum Arrival {
    /// Still on the device; whom to wake.
    Underway(Option<Waker>),
    Here,
    Failed(String),
}

impl Mapping {
    /// Asks for the first bytes of a mappable buffer. `spoiled` is set if the mapping is dropped
    /// before they are here; see [`Readback`].
    pub fn new(
        device: &Device,
        buffer: &wgpu::Buffer,
        spoiled: &Arc<AtomicBool>,
        bytes: u64,
    ) -> Result<Self, Error> {
        let arrival = if bytes == 0 { Arrival::Here } else { Arrival::Underway(None) };
        let arrival = Arc::new(Mutex::new(arrival));
        if bytes > 0 {
            let here = arrival.clone();
            let arrived = move |mapped: Result<(), wgpu::BufferAsyncError>| {
                let now = match mapped {
                    Ok(()) => Arrival::Here,
                    Err(e) => Arrival::Failed(e.to_string()),
                };
                if let Arrival::Underway(Some(waker)) = std::mem::replace(&mut *lock(&here), now) {
                    waker.wake();
                }
            };
            let slice = buffer.slice(..bytes);
            device.guarded("results", bytes, || {
                slice.map_async(wgpu::MapMode::Read, arrived);
                if cfg!(target_arch = "wasm32") {
                    // Firefox looks for what is done when something is submitted, and else every
                    // 100 ms.
                    device.queue().submit([]);
                }
            })?;
        }
        let (device, buffer, spoiled) = (device.clone(), buffer.clone(), spoiled.clone());
        Ok(Self { device, buffer, bytes, arrival, spoiled })
    }

    /// Whether the bytes are here and the device has reported of all commands, or an error.
    pub fn poll(&self, context: &mut Context) -> Poll<Result<(), Error>> {
        if !self.is_settled(context) {
            self.device.run_callbacks();
            self.device.check_lost()?;
            if !self.is_settled(context) {
                if BLOCKS {
                    // Callbacks run when the device is polled, and nobody else may do that.
                    context.waker().wake_by_ref();
                }
                return Poll::Pending;
            }
        }
        ready!(self.device.poll_reports(context))?;
        self.device.check_lost()?;
        Poll::Ready(match &*lock(&self.arrival) {
            Arrival::Failed(why) => Err(Error::Lost { why: why.clone() }),
            _ => Ok(()),
        })
    }

    fn is_settled(&self, context: &mut Context) -> bool {
        match &mut *lock(&self.arrival) {
            Arrival::Underway(waker) => {
                *waker = Some(context.waker().clone());
                false
            }
            _ => true,
        }
    }

    /// Waits for them.
    pub async fn arrived(&self) -> Result<(), Error> {
        poll_fn(|context| self.poll(context)).await
    }

    /// Calls `read` with the bytes, which have arrived.
    pub fn read<T>(self, read: impl FnOnce(&[u8]) -> T) -> Result<T, Error> {
        if self.bytes == 0 {
            return Ok(read(&[]));
        }
        let view = self.buffer.slice(..self.bytes).get_mapped_range();
        let view = view.map_err(|e| Error::Lost { why: e.to_string() })?;
        Ok(read(&view))
    }
}

impl Drop for Mapping {
    fn drop(&mut self) {
        if matches!(&*lock(&self.arrival), Arrival::Underway(_)) {
            self.spoiled.store(true, Relaxed);
        }
        if self.bytes > 0 && !matches!(&*lock(&self.arrival), Arrival::Failed(_)) {
            // Of a lost device it is not mapped any more.
            self.device.quietly(|| self.buffer.unmap());
        }
    }
}

fn lock(arrival: &Mutex<Arrival>) -> MutexGuard<'_, Arrival> {
    arrival.lock().unwrap_or_else(|e| e.into_inner())
}

impl Part {
    /// The part's bytes among all that was planned.
    pub fn of(self, bytes: &[u8]) -> &[u8] {
        &bytes[self.at as usize..(self.at + self.bytes) as usize]
    }
}

/// Word `i` of what was read.
pub fn word(bytes: &[u8], i: usize) -> u32 {
    bytes[4 * i..4 * i + 4].iter().rev().fold(0, |w, &b| w << 8 | b as u32)
}
