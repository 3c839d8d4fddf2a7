//! From the caller's positions to what kernels read: paths in `f32` and, where those or boxes are
//! rounded, the exact numbers besides.

use crate::device::Device;
use crate::error::Error;
use crate::staging::{Each, Items, Staging, Write};
use ccd_core::backend::broad_phase::{placement, swept_box};
use ccd_core::backend::layout::{Frame, Path, Placing, split};
use ccd_core::backend::quantization::{Scan, Table, margin};
use ccd_core::math::real::Real;
use ccd_core::model::positions::Chosen;
use ccd_core::model::precision::{Given, Precision};
use ccd_core::model::session::Moved;
use ccd_core::{Aabb, Coordinate};
use items::{Scanned, Sent, both_ends, either_end, path, scan_chunks, wide};
use std::ops::Range;
use std::sync::atomic::AtomicBool;
use std::sync::atomic::Ordering::Relaxed;
use wgpu::BufferUsages as U;

mod items;

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
    /// Whether integers may read `wide`, because paths are not exact.
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
        if replaced.is_err() {
            self.staging.forget();
        }
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
        let is_whole = chosen.is_none() && runs.is_none();
        let ahead = if is_whole { self.send_as_before(device, x)? } else { None };
        let scan = match (chosen, ahead) {
            (Some(chosen), _) => *chosen.scan,
            (_, Some((_, scan))) => scan,
            _ => self.scan(x, runs),
        };
        let bounds = [scan.bounds.min, scan.bounds.max].map(|corner| corner.map(T::from_f64));
        let sent = Sent { x, chosen: chosen.map(|chosen| (chosen.vertices, bounds)) };
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
        let mut replaced = are_new;
        // Integers read positions as they were given, and so does what makes boxes on the device.
        let for_integers = self.boxes == Boxes::Sent && !self.exact && min_distance == 0.0;
        self.given = for_integers || self.boxes == Boxes::OfPositions;
        if self.given {
            let bytes = (2 * n * size_of::<[f64; 3]>()) as u64;
            replaced |= reserve(device, "positions in f64", &mut self.wide, bytes)?;
        }
        if self.boxes != Boxes::OfPaths {
            let bytes = (n * size_of::<[[u32; 2]; 6]>()) as u64;
            replaced |= reserve(device, "keys of exact boxes", &mut self.keys, bytes)?;
        }
        if ahead.is_some_and(|(boxes, _)| boxes == self.boxes) {
            return Ok(replaced);
        }

        let given = Each(|i| sent.position(i, n));
        // Two loops, because without arithmetic one takes half of the time.
        let paths_as_given = Each(|v| sent.path(v));
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
        if self.given {
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

    /// Sends positions, or paths, in one pass with their scan, if what is sent does not depend on
    /// what the scan finds where boxes are made as in the step before. Returns how those are made,
    /// and the scan.
    fn send_as_before<T: Coordinate>(
        &mut self,
        device: &Device,
        x: [&[[T; 3]]; 2],
    ) -> Result<Option<(Boxes, Scan)>, Error> {
        let (n, sent) = (x[0].len(), Sent { x, chosen: None });
        let positions = Scanned::new(x, either_end, |i: usize| sent.position(i, n));
        let paths = Scanned::new(x, both_ends, |v: usize| sent.path(v));
        let is_apart = !*self.lends.get_mut() && !self.of_caller;
        let (what, scan);
        let write = match self.boxes {
            Boxes::OfPositions => {
                (what, scan) = ("positions in f64", &positions.scan);
                Write { what, to: (&self.wide, 0), numbers: 0..2 * n, items: &positions }
            }
            Boxes::OfPaths if self.exact && is_apart => {
                (what, scan) = ("paths", &paths.scan);
                Write { what, to: (&self.own, 0), numbers: 0..n, items: &paths }
            }
            _ => return Ok(None),
        };
        // What is not staged could not be forgotten if the scan finds what is refused.
        if !write.is_staged() || write.bytes() > write.to.0.size() {
            return Ok(None);
        }
        self.staging.write(device, &[write])?;
        // What each chunk says by itself is not known now.
        self.scans.clear();
        Ok(Some((self.boxes, *scan.lock().unwrap_or_else(|e| e.into_inner()))))
    }

    /// What all positions say together. `runs`: vertices that may be elsewhere than when this was
    /// last asked; none: all may.
    fn scan<T: Coordinate>(&mut self, x: [&[[T; 3]]; 2], runs: Option<&[Range<u32>]>) -> Scan {
        let all = 0..x[0].len() as u32;
        let n_chunks = x[0].len().div_ceil(CHUNK);
        let runs = runs.filter(|_| self.scans.len() == n_chunks);
        self.scans.resize(n_chunks, Scan::NONE);
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
