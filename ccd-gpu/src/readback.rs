//! Reading from the device: parts of buffers are copied into one that the host can map.

use crate::device::Device;
use crate::error::Error;

/// A buffer that is mapped for reading; grows, is kept.
#[derive(Default)]
pub struct Readback {
    buffer: Option<wgpu::Buffer>,
}

/// Parts that are to be read together.
#[derive(Debug, Default)]
pub struct Plan {
    bytes: u64,
}

/// A part of what is read.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    pub at: u64,
    pub bytes: u64,
}

/// A plan with its buffer.
#[derive(Clone, Debug)]
pub struct Reading {
    pub buffer: wgpu::Buffer,
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
        let buffer = match self.buffer.take().filter(|b| b.size() >= bytes) {
            Some(buffer) => buffer,
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
                device.guarded("results", size, || device.wgpu().create_buffer(&descriptor))?
            }
        };
        self.buffer = Some(buffer.clone());
        Ok(Reading { buffer, bytes })
    }
}

impl Reading {
    /// Waits and calls `read` with the bytes of all parts; see [`Part::of`].
    pub fn with<T>(&self, device: &Device, read: impl FnOnce(&[u8]) -> T) -> Result<T, Error> {
        map(device, &self.buffer, self.bytes, read)
    }
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

/// Waits for the device and calls `read` with the first bytes of a mappable buffer.
pub fn map<T>(
    device: &Device,
    buffer: &wgpu::Buffer,
    bytes: u64,
    read: impl FnOnce(&[u8]) -> T,
) -> Result<T, Error> {
    if bytes == 0 {
        return Ok(read(&[]));
    }
    let slice = buffer.slice(..bytes);
    device.guarded("results", bytes, || slice.map_async(wgpu::MapMode::Read, |_| {}))?;
    device.wait()?;
    let view = slice.get_mapped_range().map_err(|e| Error::Lost { why: e.to_string() })?;
    let out = read(&view);
    drop(view);
    buffer.unmap();
    Ok(out)
}
