//! What a device takes as zero: asked by the kernels that try every scalar operation.

use crate::bind::{Bind, ProbeScalars, ProbeWide};
use crate::device::Device;
use crate::error::Error;
use crate::harness;
use bytemuck::{Pod, cast_slice, pod_read_unaligned};
use ccd_core::backend::layout::{Params, join, split};

/// The least normal `f32`, and half of it.
const NORMAL: u32 = 0x0080_0000;
const HALF: u32 = NORMAL / 2;

impl Device {
    /// What the device flushes, as words: where it takes a denormal, a number nearer to zero than
    /// any of full precision, as zero. Most flush those of `f32`. No answer depends on it; where a
    /// query is of that size more is left to `f64`, or undecided.
    ///
    /// # Errors
    /// What the device refuses.
    ///
    /// ```no_run
    /// let device = ccd::gpu::Device::open(&Default::default())?;
    /// println!("flushed to zero: {}", device.flushes()?.join(", "));
    /// # Ok::<(), ccd::gpu::Error>(())
    /// ```
    pub fn flushes(&self) -> Result<Vec<&'static str>, Error> {
        let inputs = [[HALF, NORMAL], [NORMAL + HALF, NORMAL]];
        let mut kernel =
            ProbeScalars { inputs: cast_slice(&inputs).to_vec(), results: vec![0; 2 * 24 * 4] };
        let [sum, difference] = self.try_all::<_, [[u32; 24]; 2]>(&mut kernel)?;
        let mut found = vec![
            ("operands of f32", sum[0] != NORMAL + HALF),
            ("results of f32", difference[1] != HALF),
        ];
        if self.info().wide {
            let (normal, half) = (f64::MIN_POSITIVE, f64::MIN_POSITIVE / 2.0);
            let single = f32::from_bits(HALF) as f64;
            let [[h, i], [n, o], [s, t]] = [half, normal, single].map(split);
            let [l, m] = split(normal + half);
            let inputs = [[h, i, n, o], [l, m, n, o], [s, t, n, o], [HALF, 0, n, o]];
            let mut kernel =
                ProbeWide { inputs: cast_slice(&inputs).to_vec(), results: vec![0; 4 * 28 * 4] };
            let [sum, difference, narrowed, widened] =
                self.try_all::<_, [[u32; 28]; 4]>(&mut kernel)?;
            let widened = join([widened[24], widened[25]]);
            found.extend([
                ("operands of f64", sum[..2] != [l, m]),
                ("results of f64", difference[2..4] != [h, i]),
                ("f64 that become f32", narrowed[26] != HALF),
                ("f32 that become f64", widened != single),
            ]);
        }
        Ok(found.into_iter().filter(|(_, flushed)| *flushed).map(|(what, _)| what).collect())
    }

    /// The results of a kernel, its second buffer.
    fn try_all<K: Bind<Vec<u8>>, R: Pod>(&self, kernel: &mut K) -> Result<R, Error>
    where
        K::Args: Default,
    {
        harness::run(self, kernel, &Params::default(), 1, 1)?;
        Ok(pod_read_unaligned(kernel.buffers()[1]))
    }
}
