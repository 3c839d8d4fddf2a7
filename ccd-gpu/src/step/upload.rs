//! From the caller's positions to what kernels read: paths in `f32` and, where those or boxes are
//! rounded, the exact numbers besides.

use crate::device::Device;
use crate::error::Error;
use crate::staging::{Each, Items, Staging, Write};
use crate::threads;
use ccd_core::backend::broad_phase::{placement, swept_box};
use ccd_core::backend::layout::{Frame, Path, Placing, split};
use ccd_core::backend::quantization::{Scan, Table, margin};
use ccd_core::math::real::Real;
use ccd_core::model::positions::Chosen;
use ccd_core::model::precision::{Given, Precision};
use ccd_core::model::session::Moved;
use ccd_core::{Aabb, Coordinate};
use std::ops::Range;
use std::sync::atomic::AtomicBool;
use std::sync::atomic::Ordering::Relaxed;
use wgpu::BufferUsages as U;

/// Positions on the device.
pub struct Positions {
    /// Paths of steps, which uploads write.
    own: wgpu::Buffer,
    /// Whether a caller was given that buffer, and so may write it at any time. The next upload
    /// leaves it to the caller and makes another.
    lends: AtomicBool,
    /// The buffer that was left to the caller.
    lent: Option<wgpu::Buffer>,
    /// Whether the paths are those that the caller has written.
    of_caller: bool,
    /// As given, in `f64`: all at the start of the step, then all at its end.
    pub wide: wgpu::Buffer,
    pub keys: wgpu::Buffer,
    /// How the last upload left boxes of vertices.
    pub boxes: Boxes,
    /// Whether paths are exact.
    pub exact: bool,
    /// Whether integers may read `wide`, because paths are not exact and the device has no `f64`.
    pub given: bool,
    /// Origin, unit and error of paths.
    table: Table,
    slack: f32,
    /// Bound of the coordinates of paths.
    pub reach: f32,
    /// The number of the last call that was told what moved in it, as far as it came.
    call: Option<u64>,
    /// Of every [`CHUNK`] vertices.
    scans: Vec<Scan>,
    staging: Staging,
}

/// Positions of a step, and what is known of them.
#[derive(Clone, Copy)]
pub struct Input<'a> {
    pub given: Given<'a>,
    pub moved: Option<Moved<'a>>,
    /// Which of the positions are those of the mesh; none: all.
    pub chosen: Option<Chosen<'a>>,
}

impl<'a> Input<'a> {
    /// Of a mesh of all these vertices.
    pub fn new(given: Given<'a>, moved: Option<Moved<'a>>) -> Self {
        Self { given, moved, chosen: None }
    }
}

/// Vertices that are scanned together.
const CHUNK: usize = 2048;
/// Chunks that are worth another thread.
const SHARE: usize = 4;
/// From this many runs on, one copy of all paths takes less than one of each.
const MANY_RUNS: usize = 64;

/// What makes the boxes of vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Boxes {
    /// A kernel, from paths.
    OfPaths,
    /// A kernel, from positions in `f64`, from which it makes paths and keys, too.
    OfPositions,
    /// The host has sent them.
    Sent,
}

impl Positions {
    /// For the paths of `n` vertices, with the buffers of others as far as they are large enough.
    pub fn new(device: &Device, n: usize, old: Option<&Self>) -> Result<Self, Error> {
        let usage = U::STORAGE | U::COPY_DST | U::COPY_SRC;
        let buffer = |old, what, bytes| device.buffer_or(old, what, bytes, usage);
        let [own, wide, keys] = match old {
            Some(old) => [&old.own, &old.wide, &old.keys].map(Some),
            None => [None; 3],
        };
        let bytes = (n * size_of::<Path>()) as u64;
        let own = buffer(own, "paths", bytes)?;
        let lends = old.is_some_and(|old| old.lends.load(Relaxed) && old.own == own);
        let lent = old.and_then(|old| old.lent.clone()).filter(|lent| lent.size() >= bytes);
        Ok(Self {
            own,
            lends: AtomicBool::new(lends),
            lent,
            of_caller: false,
            // Grow when they are needed.
            wide: buffer(wide, "positions in f64", 0)?,
            keys: buffer(keys, "keys of exact boxes", 0)?,
            boxes: Boxes::OfPaths,
            exact: true,
            given: false,
            table: Table::AS_GIVEN,
            slack: 0.0,
            reach: 0.0,
            call: None,
            scans: Vec::new(),
            staging: Staging::default(),
        })
    }

    /// The paths that frames read.
    pub fn paths(&self) -> &wgpu::Buffer {
        self.lent.as_ref().filter(|_| self.of_caller).unwrap_or(&self.own)
    }

    /// The buffer of paths for a caller.
    pub fn lend_paths(&self) -> &wgpu::Buffer {
        self.lent.as_ref().unwrap_or_else(|| {
            self.lends.store(true, Relaxed);
            &self.own
        })
    }

    /// Has steps have paths that no caller writes, also while they are in flight: a frame whose
    /// lists were too short is submitted again, and reads them again. Returns whether these are
    /// new.
    fn keep_apart(&mut self, device: &Device, n: usize) -> Result<bool, Error> {
        let lends = *self.lends.get_mut();
        if lends {
            let usage = U::STORAGE | U::COPY_DST | U::COPY_SRC;
            let own = device.buffer("paths", (n * size_of::<Path>()) as u64, usage)?;
            self.lent = Some(std::mem::replace(&mut self.own, own));
            self.lends = AtomicBool::new(false);
        }
        self.of_caller = false;
        Ok(lends)
    }

    /// Checks and uploads. Returns whether a buffer was replaced. `boxes`: where boxes of vertices
    /// go if kernels cannot make them.
    pub fn upload(
        &mut self,
        device: &Device,
        input: Input,
        min_distance: f64,
        boxes: &wgpu::Buffer,
    ) -> Result<bool, Error> {
        let Input { given, moved, chosen } = input;
        let runs = moved.filter(|&moved| self.follows(moved)).map(|moved| moved.runs);
        self.call = None;
        let replaced = match given {
            Precision::F32(x) => self.take(device, (x, chosen), runs, min_distance, boxes),
            Precision::F64(x) => self.take(device, (x, chosen), runs, min_distance, boxes),
        };
        // Also what was written before something failed: what is written next comes behind it.
        self.staging.submit(device)?;
        let replaced = replaced?;
        self.call = moved.map(|moved| moved.call);
        Ok(replaced)
    }

    /// Whether the positions that are here are those before this call, or of it.
    pub fn follows(&self, moved: Moved) -> bool {
        moved.follows(self.call)
    }

    fn take<T: Coordinate>(
        &mut self,
        device: &Device,
        (x, chosen): ([&[[T; 3]]; 2], Option<Chosen>),
        runs: Option<&[Range<u32>]>,
        min_distance: f64,
        boxes: &wgpu::Buffer,
    ) -> Result<bool, Error> {
        let n = chosen.map_or(x[0].len(), |chosen| chosen.vertices.len());
        let scan = chosen.map_or_else(|| self.scan(x, runs), |chosen| *chosen.scan);
        let bounds = [scan.bounds.min, scan.bounds.max].map(|corner| corner.map(T::from_f64));
        let sent = Sent { x, chosen: chosen.map(|chosen| chosen.vertices), bounds };
        scan.check(x[0], x[1])?;
        let table = scan.table(true);
        let before = std::mem::replace(&mut self.table, table);
        let are_new = self.keep_apart(device, n)?;
        let paths_before = self.boxes != Boxes::OfPositions && before == table && !are_new;
        self.exact = table == Table::AS_GIVEN;
        let extent = (0..3).fold(0.0, |m: f64, k| m.max(scan.bounds.max[k] - scan.bounds.min[k]));
        self.reach = if self.exact { scan.greatest() } else { extent * table.scale }.round_up();
        // Boxes are made of paths only where those are the positions.
        let rounded = scan.rounds_boxes::<T>(min_distance) || !self.exact;
        self.slack = if rounded { scan.slack(min_distance) } else { 0.0 };
        self.boxes = match (rounded, device.info().wide) {
            (false, _) => Boxes::OfPaths,
            (true, true) => Boxes::OfPositions,
            (true, false) => Boxes::Sent,
        };
        // Integers read positions as they were given.
        self.given = self.boxes == Boxes::Sent && !self.exact && min_distance == 0.0;
        let mut replaced = are_new;
        let sends_given = self.given || self.boxes == Boxes::OfPositions;
        if sends_given {
            let bytes = (2 * n * size_of::<[f64; 3]>()) as u64;
            replaced |= reserve(device, "positions in f64", &mut self.wide, bytes)?;
        }
        if self.boxes != Boxes::OfPaths {
            let bytes = (n * size_of::<[[u32; 2]; 6]>()) as u64;
            replaced |= reserve(device, "keys of exact boxes", &mut self.keys, bytes)?;
        }

        let given = Each(|i: usize| wide(if i < n { sent.at(0, i) } else { sent.at(1, i - n) }));
        // Two loops, because without arithmetic one takes half of the time.
        let paths_as_given = Each(|v| {
            path(sent.ends(v), |p| {
                [p[0].to_f64() as f32, p[1].to_f64() as f32, p[2].to_f64() as f32]
            })
        });
        let paths_in_table = Each(|v| path(sent.ends(v), |p| table.place(wide(p))));
        let paths: &dyn Items = if self.exact { &paths_as_given } else { &paths_in_table };
        let margin: T = margin(min_distance);
        let exact_box = |[p, q]: [[T; 3]; 2]| swept_box::swept(p, q).inflated(margin);
        let keys = Each(|v| {
            let Aabb { min, max } = exact_box(sent.ends(v));
            placement::keys(&Aabb { min: wide(min), max: wide(max) })
        });
        let rounded_boxes = Each(|v| exact_box(sent.ends(v)).round_out());

        let mut writes = Vec::new();
        let mut write = |what, to, numbers: Range<usize>, items| {
            writes.push(Write { what, to, numbers, items });
        };
        if sends_given {
            write("positions in f64", (&self.wide, 0), 0..2 * n, &given);
        }
        if self.boxes != Boxes::OfPositions {
            let all = 0..n as u32;
            let runs = runs.filter(|runs| paths_before && runs.len() < MANY_RUNS);
            for run in runs.unwrap_or(std::slice::from_ref(&all)) {
                let at = u64::from(run.start) * size_of::<Path>() as u64;
                write("paths", (&self.own, at), run.start as usize..run.end as usize, paths);
            }
        }
        if self.boxes == Boxes::Sent {
            write("keys of exact boxes", (&self.keys, 0), 0..n, &keys);
            write("boxes", (boxes, 0), 0..n, &rounded_boxes);
        }
        self.staging.write(device, &writes)?;
        Ok(replaced)
    }

    /// What all positions say together. `runs`: vertices that may be elsewhere than when this was
    /// last asked; none: all may.
    fn scan<T: Coordinate>(&mut self, x: [&[[T; 3]]; 2], runs: Option<&[Range<u32>]>) -> Scan {
        let all = 0..x[0].len() as u32;
        self.scans.resize(x[0].len().div_ceil(CHUNK), Scan::NONE);
        for run in runs.unwrap_or(std::slice::from_ref(&all)) {
            let chunks = run.start as usize / CHUNK..(run.end as usize).div_ceil(CHUNK);
            scan_chunks(chunks.start, &mut self.scans[chunks], x);
        }
        self.scans.iter().fold(Scan::NONE, |all, scan| all.merged(scan))
    }

    /// How far a coordinate of a path may be from the true one.
    pub fn path_error(&self) -> f32 {
        self.table.error
    }

    /// How coordinates of paths become those of positions.
    pub fn placing(&self) -> Placing {
        let origin = self.table.origin.map(|c| c as f32);
        Placing { origin, unit: ((1.0 / self.table.scale) as f32).min(f32::MAX) }
    }

    /// Takes the paths that are there, which the caller has written, as exact.
    pub fn take_paths(&mut self) {
        (self.boxes, self.exact, self.table) = (Boxes::OfPaths, true, Table::AS_GIVEN);
        self.given = false;
        self.call = None;
        self.slack = 0.0;
        self.of_caller = true;
    }

    /// Sets what kernels read of the positions.
    pub fn describe(&self, frame: &mut Frame, min_distance: f64) {
        frame.path_error = self.table.error;
        frame.slack = self.slack;
        frame.margin = margin(min_distance * self.table.scale);
        frame.min_distance = self.table.distance(min_distance);
        // A device may take less as zero; within this nothing certainly is.
        let wide = if min_distance > 0.0 { min_distance.max(f64::MIN_POSITIVE) } else { 0.0 };
        frame.distance_bits = split(wide);
        frame.origin = self.table.origin.map(split);
        frame.scale_bits = split(self.table.scale);
        frame.margin_bits = split(margin(min_distance));
        frame.flags |= if self.exact { Frame::FLAG_EXACT } else { 0 };
        frame.flags |= if self.slack > 0.0 { Frame::FLAG_CONFIRM } else { 0 };
    }
}

/// Positions of both ends of a step, as they are sent.
///
/// What is done for each vertex is inlined by force, and without `array::map`, which is not
/// inlined: otherwise the loops take twice as long.
#[derive(Clone, Copy)]
struct Sent<'a, T> {
    x: [&'a [[T; 3]]; 2],
    /// Which of them, if not all.
    chosen: Option<&'a [u32]>,
    /// What chosen ones are in, or are brought into: kernels meet no NaN, and nothing larger than
    /// what their bounds of rounding are for, also in a step that is forgotten once its positions
    /// were looked at.
    bounds: [[T; 3]; 2],
}

impl<T: Real> Sent<'_, T> {
    #[inline(always)]
    fn at(&self, end: usize, v: usize) -> [T; 3] {
        let Some(chosen) = self.chosen else { return self.x[end][v] };
        let (p, [min, max]) = (self.x[end][chosen[v] as usize], self.bounds);
        let inside = |k: usize| if p[k] >= min[k] && p[k] <= max[k] { p[k] } else { min[k] };
        [inside(0), inside(1), inside(2)]
    }

    #[inline(always)]
    fn ends(&self, v: usize) -> [[T; 3]; 2] {
        [self.at(0, v), self.at(1, v)]
    }
}

/// The path between two ends, each made a place by `end`.
#[inline(always)]
fn path<T>([p, q]: [[T; 3]; 2], end: impl Fn([T; 3]) -> [f32; 3]) -> Path {
    let [p, q] = [end(p), end(q)];
    Path { t0: [p[0], p[1], p[2], 0.0], t1: [q[0], q[1], q[2], 0.0] }
}

#[inline(always)]
fn wide<T: Real>(p: [T; 3]) -> [f64; 3] {
    [p[0].to_f64(), p[1].to_f64(), p[2].to_f64()]
}

/// Scans chunks of vertices, of which the first has this number.
fn scan_chunks<T: Coordinate>(first: usize, scans: &mut [Scan], [x0, x1]: [&[[T; 3]]; 2]) {
    threads::copy(scans.chunks_mut(SHARE).enumerate(), |(part, scans)| {
        for (scan, i) in scans.iter_mut().zip(first + part * SHARE..) {
            let chunk = i * CHUNK..((i + 1) * CHUNK).min(x0.len());
            *scan = Scan::NONE;
            scan.take_all(&x0[chunk.clone()], &x1[chunk]);
        }
    });
}

/// Replaces a buffer that is too small. Returns whether it was.
fn reserve(
    device: &Device,
    what: &'static str,
    buffer: &mut wgpu::Buffer,
    bytes: u64,
) -> Result<bool, Error> {
    let too_small = buffer.size() < bytes;
    if too_small {
        *buffer = device.buffer(what, bytes, U::STORAGE | U::COPY_DST | U::COPY_SRC)?;
    }
    Ok(too_small)
}
