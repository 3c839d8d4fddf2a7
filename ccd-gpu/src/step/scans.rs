//! What coordinates say together, by several threads: bounds, and whether each number is an `f32`.

use crate::threads;
use ccd_core::Coordinate;
use ccd_core::backend::quantization::Scan;
use std::ops::Range;
use std::sync::Mutex;

/// Vertices that are scanned together.
pub const CHUNK: usize = 2048;
/// Chunks that are worth another thread.
const SHARE: usize = 4;

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

/// What positions of a part say together.
///
/// # Errors
/// Cancelled, where the part is not for these.
pub fn look_at_all(n: usize, look: &Look) -> Result<Scan, ccd_core::Error> {
    let seen = Seen::new(look);
    let some = CHUNK * SHARE;
    threads::copy(0..n.div_ceil(some), |i| seen.look(i * some..n.min((i + 1) * some)));
    seen.all()
}

/// See [`Chosen::look`](ccd_core::model::positions::Chosen::look).
pub type Look<'a> = dyn Fn(Range<usize>) -> Option<Scan> + Sync + 'a;

/// What positions say that were looked at, by any threads.
pub struct Seen<'a> {
    look: &'a Look<'a>,
    all: Mutex<Option<Scan>>,
}

impl<'a> Seen<'a> {
    pub fn new(look: &'a Look<'a>) -> Self {
        Self { look, all: Mutex::new(Some(Scan::NONE)) }
    }

    pub fn look(&self, these: Range<usize>) {
        let of_these = (self.look)(these);
        let mut all = self.all.lock().unwrap_or_else(|e| e.into_inner());
        *all = all.zip(of_these).map(|(all, of_these)| all.merged(&of_these));
    }

    pub fn all(self) -> Result<Scan, ccd_core::Error> {
        let all = self.all.into_inner().unwrap_or_else(|e| e.into_inner());
        all.ok_or(ccd_core::Error::Cancelled)
    }
}
