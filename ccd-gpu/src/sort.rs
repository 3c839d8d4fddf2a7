//! The radix sort on the device: its buffers and dispatches.

use crate::bind::{SortCount, SortScatter, SortScatterBySubgroups};
use crate::device::Device;
use crate::error::Error;
use crate::readback::{Plan, Readback};
use crate::recorder::{Bench, Recorder, Timing, submit};
use ccd_core::backend::kernel::sort;
use ccd_core::backend::layout::{Dispatch, Frame, Params, SortPass};
use wgpu::BufferUsages as U;

/// Keys with values, twice, and the table of digits.
#[derive(Clone)]
pub struct Sort {
    keys: [wgpu::Buffer; 2],
    values: [wgpu::Buffer; 2],
    table: wgpu::Buffer,
    capacity: u32,
    /// Keys of a workgroup.
    tile: u32,
}

impl Sort {
    /// Capacity for `n` pairs; the buffers of another sort, if they are large enough.
    pub fn new(device: &Device, n: u32, old: Option<&Self>) -> Result<Self, Error> {
        if let Some(old) = old.filter(|old| old.capacity >= n) {
            return Ok(old.clone());
        }
        let words =
            |what, n: u64| device.buffer(what, 4 * n, U::STORAGE | U::COPY_SRC | U::COPY_DST);
        if n > sort::MOST_KEYS {
            let [bytes, limit] = [n, sort::MOST_KEYS].map(|n| 4 * n as u64);
            return Err(Error::TooLarge { what: "sort keys", bytes, limit });
        }
        let tile = if device.info().subgroups { sort::SUBGROUP_TILE } else { sort::TILE };
        let (table, n) = (sort::first_row(2, n.div_ceil(tile)) as u64, n as u64);
        Ok(Self {
            keys: [words("sort keys", n)?, words("sort keys", n)?],
            values: [words("sort values", n)?, words("sort values", n)?],
            table: words("sort table", table)?,
            capacity: n as u32,
            tile,
        })
    }

    /// Keys and values of one of both halves.
    pub fn half(&self, half: usize) -> [&wgpu::Buffer; 2] {
        [&self.keys[half], &self.values[half]]
    }

    /// Sorts the first `n` pairs of the first half by their keys, stable; the result is there too.
    pub fn run(&self, recorder: &mut Recorder, n: u32) {
        let n_tiles = n.div_ceil(self.tile);
        let table = &self.table;
        recorder.clear(table, 4 * sort::first_row(1, n_tiles) as u64);
        for pass in 0..sort::PASSES {
            let p = Params {
                frame: Frame::default(),
                dispatch: Dispatch { n, ..Dispatch::default() },
                args: SortPass { shift: 8 * pass, n_tiles },
            };
            let from = pass as usize % 2;
            let ([keys, values], [keys_out, values_out]) = (self.half(from), self.half(1 - from));
            if pass == 0 {
                recorder.detail("sort_count");
                let rounds = n.div_ceil(sort::COUNT_THREADS * sort::COUNT_KEYS);
                recorder.dispatch(&SortCount { keys, table }, &p, rounds.min(sort::COUNT_GROUPS));
            }
            recorder.detail("sort_scatter");
            if self.tile == sort::SUBGROUP_TILE {
                let pass = SortScatterBySubgroups { keys, values, table, keys_out, values_out };
                recorder.dispatch(&pass, &p, n_tiles);
            } else {
                let pass = SortScatter { keys, values, table, keys_out, values_out };
                recorder.dispatch(&pass, &p, n_tiles);
            }
        }
    }
}

/// Sorts keys with their values on a device, for tests and benches.
///
/// ```no_run
/// use ccd::gpu::{Device, DeviceOptions, Sorter};
///
/// let device = Device::open(&DeviceOptions::default())?;
/// let sorted = Sorter::new(&device, 3)?.sort(&[7, 1, 7], &[0, 1, 2])?;
/// assert_eq!(sorted, (vec![1, 7, 7], vec![1, 0, 2]));
/// # Ok::<(), ccd::gpu::Error>(())
/// ```
pub struct Sorter {
    device: Device,
    bench: Bench,
    sort: Sort,
    source: [wgpu::Buffer; 2],
    n: u32,
}

impl Sorter {
    /// A sorter of `n` pairs.
    ///
    /// # Errors
    /// What the device refuses.
    pub fn new(device: &Device, n: u32) -> Result<Self, Error> {
        let source =
            |what| device.buffer(what, 4 * n as u64, U::STORAGE | U::COPY_SRC | U::COPY_DST);
        let mut bench = Bench::new(device)?;
        bench.set_timing(Timing::Kernels)?;
        Ok(Self {
            bench,
            sort: Sort::new(device, n, None)?,
            source: [source("keys")?, source("values")?],
            device: device.clone(),
            n,
        })
    }

    /// Sorts; returns the sorted keys and values.
    ///
    /// # Errors
    /// What the device refuses.
    ///
    /// # Panics
    /// If the number of keys or values is not that of [`Sorter::new`].
    pub fn sort(&mut self, keys: &[u32], values: &[u32]) -> Result<(Vec<u32>, Vec<u32>), Error> {
        assert!(
            keys.len() == self.n as usize && values.len() == keys.len(),
            "another number of pairs than the sorter was made for"
        );
        for (to, words) in self.source.iter().zip([keys, values]) {
            self.device.write("keys and values", to, 0, bytemuck::cast_slice(words))?;
        }
        self.again()?;
        let mut plan = Plan::default();
        let [of_keys, of_values] = [(); 2].map(|()| plan.part(4 * self.n as u64));
        let reading = Readback::default().prepare(&self.device, plan)?;
        let [keys, values] = self.sort.half(0);
        submit(&self.device, &mut self.bench, |recorder| {
            recorder.read(&reading, of_keys, keys, 0);
            recorder.read(&reading, of_values, values, 0);
        })?;
        reading.wait_with(&self.device, |bytes| {
            (
                bytemuck::pod_collect_to_vec(of_keys.of(bytes)),
                bytemuck::pod_collect_to_vec(of_values.of(bytes)),
            )
        })
    }

    /// Sorts the last input once more; milliseconds by kernel, if the device has timestamps.
    ///
    /// # Errors
    /// What the device refuses.
    pub fn again(&mut self) -> Result<Vec<(&'static str, f64)>, Error> {
        let Self { device, bench, sort, source, n } = self;
        let [keys, values] = sort.half(0);
        let stages = submit(device, bench, |recorder| {
            recorder.copy(&source[0], 0, keys, 0, 4 * *n as u64);
            recorder.copy(&source[1], 0, values, 0, 4 * *n as u64);
            sort.run(recorder, *n);
        })?;
        device.wait()?;
        device.block_on(bench.begin_times(stages)?.read())
    }
}
