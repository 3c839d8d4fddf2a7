//! One size of one kind of work at one place: times, bytes, and the answer to be compared.

use super::heap;
use crate::measure::{Place, median, timed, warm};
use ccd::any::{self, BroadPhase, Session};
use ccd::gpu::{Timing, wgpu};
use ccd::method::BroadPhaseMethod;
use ccd::{Aabb, Digest, Mesh, Options};
use ccd_testkit::compare::contact_digest;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Runs of each measurement: as many as take so many milliseconds, within bounds.
const ENOUGH: f64 = 2000.0;
const RUNS: std::ops::RangeInclusive<usize> = 3..=9;
/// Milliseconds of a call after which no other is needed for a warm-up.
const LONG: f64 = 1000.0;

/// Medians in milliseconds, and bytes.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Measured {
    /// By the clock, from the input on the host to the answer there.
    pub wall: f64,
    /// All kernels, by the timestamps of the device.
    pub device: Option<f64>,
    /// Bytes of the device that are held after the first call.
    pub on_device: Option<u64>,
    /// Most bytes of the host's heap at one time until the first answer, without the input.
    pub on_host: u64,
    /// The answer: a digest of pairs, or a time.
    pub answer: Answer,
}

/// What was found.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub enum Answer {
    /// How many pairs, and their digest.
    Pairs(u64, String),
    Toi(Option<f64>),
}

impl Answer {
    /// Whether two places found the same: on a GPU an earliest time is rounded down to `f32`.
    pub fn agrees(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Toi(Some(a)), Self::Toi(Some(b))) => (a - b).abs() <= 2.0 * ccd::TOI_TOLERANCE,
            // Not every call has a digest.
            (Self::Pairs(n, a), Self::Pairs(m, b)) => {
                n == m && (a == b || a.is_empty() || b.is_empty())
            }
            _ => self == other,
        }
    }
}

/// Measurements, or why there are none: what a place does not take.
pub type Cell = Result<Measured, String>;

/// Runs of a call that takes so many milliseconds.
fn runs(ms: f64) -> usize {
    ((ENOUGH / ms.max(1e-3)) as usize).clamp(*RUNS.start(), *RUNS.end())
}

/// Results of `runs` calls after a warm-up, for which a call of so many milliseconds is enough.
fn after<T, E>(ms: f64, runs: usize, mut run: impl FnMut() -> Result<T, E>) -> Result<Vec<T>, E> {
    if ms > LONG { (0..runs).map(|_| run()).collect() } else { warm(runs, run) }
}

/// Bytes of the device that buffers hold, those of calls that are over given back.
fn bytes_of(place: &Place) -> Option<u64> {
    let Place::Gpu { device, .. } = place else { return None };
    let _ = device.wgpu().poll(wgpu::PollType::wait_indefinitely());
    device.wgpu().generate_allocator_report().map(|report| report.total_allocated_bytes)
}

/// Why there is no measurement: for a cell if the place does not take the size, else to end the
/// report.
fn refused(error: any::Error) -> Result<Cell, String> {
    use any::Error::{Incomplete, Input, OutOfMemory, Refused, TooLarge};
    match &error {
        TooLarge { .. } | OutOfMemory { .. } | Refused { .. } | Incomplete { .. } => {
            Ok(Err(error.to_string()))
        }
        Input(ccd::Error::TooMany { .. } | ccd::Error::Memory { .. }) => Ok(Err(error.to_string())),
        _ => Err(error.to_string()),
    }
}

/// Something that can be called again and again.
trait Work {
    /// The whole call; what was found, with a digest of pairs if that is asked for, which takes
    /// time.
    fn call(&mut self, with_digest: bool) -> Result<Answer, any::Error>;
    /// Sets what a GPU times, calls without reading pairs, and returns the milliseconds on the
    /// device; `None` on a CPU.
    fn on_device(&mut self, timing: Timing) -> Result<Option<f64>, any::Error>;
}

/// Opens and measures: first bytes, with the first call, then times.
fn measure<W: Work>(
    place: &Place,
    open: impl FnOnce() -> Result<W, any::Error>,
) -> Result<Cell, String> {
    let before = bytes_of(place);
    let (on_host, opened) = heap::counted(|| {
        let mut work = open()?;
        let (first, found) = timed(|| work.call(false));
        found?;
        Ok((work, first))
    });
    let (mut work, first) = match opened {
        Ok(opened) => opened,
        Err(e) => return refused(e),
    };
    let on_device = bytes_of(place).zip(before).map(|(after, before)| after.saturating_sub(before));
    // On a GPU the first call compiles kernels.
    let (second, done) = timed(|| work.call(true));
    let runs = runs(first.min(second));
    let times = done.and_then(|answer| {
        let wall = after(second, runs, || {
            let (ms, found) = timed(|| work.call(false));
            found.map(|found| (ms, found))
        })?;
        if work.on_device(Timing::Whole)?.is_none() {
            return Ok((answer, wall, None));
        }
        let device = after(second, runs, || work.on_device(Timing::Whole))?;
        Ok((answer, wall, Some(median(device.into_iter().flatten()))))
    });
    let (answer, wall, device) = match times {
        Ok(times) => times,
        Err(e) => return refused(e),
    };
    if let Some((_, other)) = wall.iter().find(|(_, found)| !found.agrees(&answer)) {
        return Err(format!("{}: {answer:?}, then {other:?}", place.name()));
    }
    let wall = median(wall.into_iter().map(|(ms, _)| ms));
    Ok(Ok(Measured { wall, device, on_device, on_host, answer }))
}

/// A broad phase over boxes.
struct Boxes<'a>(BroadPhase, &'a [Aabb<f32>]);

impl Work for Boxes<'_> {
    fn call(&mut self, with_digest: bool) -> Result<Answer, any::Error> {
        let pairs = self.0.self_pairs(self.1)?;
        let digest = || Digest::of(0, pairs.iter()).to_string();
        let digest = if with_digest { digest() } else { String::new() };
        Ok(Answer::Pairs(pairs.len() as u64, digest))
    }

    fn on_device(&mut self, timing: Timing) -> Result<Option<f64>, any::Error> {
        let Some(on) = self.0.gpu() else { return Ok(None) };
        on.set_timing(timing)?;
        on.again()?;
        Ok(Some(on.stages().iter().map(|stage| stage.1).sum()))
    }
}

/// All overlapping pairs of boxes.
pub fn boxes(place: &Place, boxes: &[Aabb<f32>], method: BroadPhaseMethod) -> Result<Cell, String> {
    measure(place, || Ok(Boxes(BroadPhase::new(&place.choice(), place.threads(), method)?, boxes)))
}

/// Step of a mesh, in the precision that it is given in.
pub struct Step {
    pub mesh: Arc<Mesh>,
    pub x: [Vec<[f32; 3]>; 2],
}

/// All contacts of a step, or its earliest time of impact.
struct Steps<'a> {
    session: Session,
    x: &'a [Vec<[f32; 3]>; 2],
    earliest: bool,
}

impl Work for Steps<'_> {
    fn call(&mut self, with_digest: bool) -> Result<Answer, any::Error> {
        let [x0, x1] = self.x;
        if self.earliest {
            return self.session.earliest_toi(x0, x1).map(Answer::Toi);
        }
        let contacts = &self.session.step(x0, x1)?.contacts;
        let digest = || contact_digest(contacts).to_string();
        let digest = if with_digest { digest() } else { String::new() };
        Ok(Answer::Pairs(contacts.len() as u64, digest))
    }

    fn on_device(&mut self, timing: Timing) -> Result<Option<f64>, any::Error> {
        let Some(on) = self.session.gpu() else { return Ok(None) };
        on.set_timing(timing)?;
        self.call(false)?;
        let on = self.session.gpu();
        Ok(on.map(|on| on.stages().iter().map(|stage| stage.1).sum()))
    }
}

/// All contacts of a step, or its earliest time.
pub fn step(place: &Place, step: &Step, earliest: bool) -> Result<Cell, String> {
    measure(place, || {
        let options = Options::default().with_threads(place.threads());
        let session = Session::new(&place.choice(), step.mesh.clone(), options)?;
        Ok(Steps { session, x: &step.x, earliest })
    })
}
