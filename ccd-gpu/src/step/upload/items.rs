//! What is sent of positions: themselves in `f64`, or paths; and what one pass over them finds.

use super::CHUNK;
use crate::staging::{Each, Items};
use crate::threads;
use bytemuck::Pod;
use ccd_core::Coordinate;
use ccd_core::backend::layout::Path;
use ccd_core::backend::quantization::Scan;
use ccd_core::math::real::Real;
use std::ops::Range;
use std::sync::Mutex;

/// Chunks that are worth another thread.
const SHARE: usize = 4;

/// Positions of both ends of a step, as they are sent.
///
/// What is done for each vertex is inlined by force, and without `array::map`, which is not
/// inlined: otherwise the loops take twice as long.
#[derive(Clone, Copy)]
pub struct Sent<'a, T> {
    pub x: [&'a [[T; 3]]; 2],
    /// Which of them, if not all, and what these are in, or are brought into: kernels meet no NaN,
    /// and nothing larger than what their bounds of rounding are for, also in a step that is
    /// forgotten once its positions were looked at.
    pub chosen: Option<(&'a [u32], [[T; 3]; 2])>,
}

impl<T: Real> Sent<'_, T> {
    #[inline(always)]
    pub fn at(&self, end: usize, v: usize) -> [T; 3] {
        let Some((chosen, [min, max])) = self.chosen else { return self.x[end][v] };
        let p = self.x[end][chosen[v] as usize];
        let inside = |k: usize| if p[k] >= min[k] && p[k] <= max[k] { p[k] } else { min[k] };
        [inside(0), inside(1), inside(2)]
    }

    #[inline(always)]
    pub fn ends(&self, v: usize) -> [[T; 3]; 2] {
        [self.at(0, v), self.at(1, v)]
    }

    /// Position `i` of the `n` at the start and then those at the end.
    #[inline(always)]
    pub fn position(&self, i: usize, n: usize) -> [f64; 3] {
        wide(if i < n { self.at(0, i) } else { self.at(1, i - n) })
    }

    /// The path of a vertex whose coordinates are exact.
    #[inline(always)]
    pub fn path(&self, v: usize) -> Path {
        path(self.ends(v), |p| [p[0].to_f64() as f32, p[1].to_f64() as f32, p[2].to_f64() as f32])
    }
}

/// The path between two ends, each made a place by `end`.
#[inline(always)]
pub fn path<T>([p, q]: [[T; 3]; 2], end: impl Fn([T; 3]) -> [f32; 3]) -> Path {
    let [p, q] = [end(p), end(q)];
    Path { t0: [p[0], p[1], p[2], 0.0], t1: [q[0], q[1], q[2], 0.0] }
}

#[inline(always)]
pub fn wide<T: Real>(p: [T; 3]) -> [f64; 3] {
    [p[0].to_f64(), p[1].to_f64(), p[2].to_f64()]
}

/// Items that are made of positions, which are scanned as they are written.
pub struct Scanned<'a, T, F> {
    x: [&'a [[T; 3]]; 2],
    /// Of those that are written.
    pub scan: Mutex<Scan>,
    items: Each<F>,
    made_of: MadeOf,
}

/// The positions at both ends that items of these numbers are made of; all vertices.
type MadeOf = fn(Range<usize>, usize) -> [Range<usize>; 2];

/// An item of each vertex.
pub fn both_ends(numbers: Range<usize>, _: usize) -> [Range<usize>; 2] {
    [numbers.clone(), numbers]
}

/// An item of each position: first all at the start.
pub fn either_end(Range { start, end }: Range<usize>, n: usize) -> [Range<usize>; 2] {
    [start.min(n)..end.min(n), start.max(n) - n..end.max(n) - n]
}

impl<'a, T, F> Scanned<'a, T, F> {
    pub fn new(x: [&'a [[T; 3]]; 2], made_of: MadeOf, item: F) -> Self {
        Self { x, scan: Mutex::new(Scan::NONE), items: Each(item), made_of }
    }
}

impl<T: Coordinate, I: Pod, F: Fn(usize) -> I + Sync> Items for Scanned<'_, T, F> {
    fn size(&self) -> usize {
        self.items.size()
    }

    fn write(&self, to: wgpu::WriteOnly<[u8]>, numbers: Range<usize>) {
        let [x0, x1] = self.x;
        let [at0, at1] = (self.made_of)(numbers.clone(), x0.len());
        let mut scan = Scan::NONE;
        scan.take_all(&x0[at0], &x1[at1]);
        self.items.write(to, numbers);
        let mut all = self.scan.lock().unwrap_or_else(|e| e.into_inner());
        *all = all.merged(&scan);
    }
}

/// Scans chunks of vertices, of which the first has this number.
pub fn scan_chunks<T: Coordinate>(first: usize, scans: &mut [Scan], [x0, x1]: [&[[T; 3]]; 2]) {
    threads::copy(scans.chunks_mut(SHARE).enumerate(), |(part, scans)| {
        for (scan, i) in scans.iter_mut().zip(first + part * SHARE..) {
            let chunk = i * CHUNK..((i + 1) * CHUNK).min(x0.len());
            *scan = Scan::NONE;
            scan.take_all(&x0[chunk.clone()], &x1[chunk]);
        }
    });
}
