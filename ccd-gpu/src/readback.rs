//! From the device: parts of buffers are copied into one that the host can map.

use crate::device::Device;
use crate::error::Error;

/// A buffer that is mapped for reading; grows, is kept.
pub struct Readback {
    buffer: Option<wgpu::Buffer>,
    used: u64,
}

/// A part of what was read.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    at: u64,
    bytes: u64,
}

impl Readback {
    pub fn new() -> Self {
        Self { buffer: None, used: 0 }
    }

    /// Plans parts of these sizes and makes room for them.
    pub fn plan(&mut self, device: &Device, sizes: &[u64]) -> Result<Vec<Part>, Error> {
        self.used = 0;
        let parts = sizes
            .iter()
            .map(|&bytes| {
                let part = Part { at: self.used, bytes };
                self.used += bytes.next_multiple_of(8);
                part
            })
            .collect();
        if self.buffer.as_ref().is_none_or(|b| b.size() < self.used) {
            let bytes = self.used + self.used / 4 + 4096;
            let limit = device.info().limits.max_buffer_size;
            let size = bytes.min(limit).next_multiple_of(8);
            if self.used > limit {
                return Err(Error::TooLarge { what: "results", bytes: self.used, limit });
            }
            let usage = wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST;
            let descriptor = wgpu::BufferDescriptor { label: Some("results"), size, usage, mapped_at_creation: false };
            self.buffer = Some(device.guarded("results", size, || device.wgpu().create_buffer(&descriptor))?);
        }
        Ok(parts)
    }

    /// Records the copy of a part from byte `first` of `from` on.
    pub fn copy(&self, recorder: &mut crate::recorder::Recorder, part: Part, from: &wgpu::Buffer, first: u64) {
        if let Some(buffer) = &self.buffer
            && part.bytes > 0
        {
            recorder.copy(from, first, buffer, part.at, part.bytes);
        }
    }

    /// Waits and reads all parts.
    pub fn read(&self, device: &Device, parts: &[Part]) -> Result<Vec<Vec<u8>>, Error> {
        let read = |bytes: &[u8]| parts.iter().map(|p| p.of(bytes).to_vec()).collect();
        self.with(device, read).map(Option::unwrap_or_default)
    }

    /// Waits and calls `read` with what was planned, from which each part takes its own.
    pub fn with<T>(&self, device: &Device, read: impl FnOnce(&[u8]) -> T) -> Result<Option<T>, Error> {
        self.buffer.as_ref().map(|buffer| map(device, buffer, self.used, read)).transpose()
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
pub fn map<T>(device: &Device, buffer: &wgpu::Buffer, bytes: u64, read: impl FnOnce(&[u8]) -> T) -> Result<T, Error> {
    let slice = buffer.slice(..bytes);
    device.guarded("results", bytes, || slice.map_async(wgpu::MapMode::Read, |_| {}))?;
    device.wait()?;
    let view = slice.get_mapped_range().map_err(|e| Error::Lost { why: e.to_string() })?;
    let out = read(&view);
    drop(view);
    buffer.unmap();
    Ok(out)
}
