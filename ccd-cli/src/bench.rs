//! `ccd bench`: times of two built-in scenes on any machine. A time counts only with the right
//! answer, so every run's answer is checked.

use super::backend::BackendOptions;
use super::method::MethodOptions;
use super::{Failure, Outcome, output, toi};
use ccd::any::{BroadPhase, Choice, Error, Session};
use ccd::gpu::Timing;
use ccd::method::{BroadPhaseMethod, Catalogued};
use ccd::scenes::{crumpled_sheet, uniform_boxes};
use ccd::{Options, PerKind, TOI_TOLERANCE};
use clap::Args;
use serde::Serialize;
use std::time::{Duration, Instant};

#[derive(Args)]
pub struct Bench {
    /// Boxes in millions, instead of 0.1 and 1; may be given several times
    #[arg(long, value_name = "N", value_parser = millions, allow_negative_numbers = true)]
    size: Vec<usize>,
    /// Ten million boxes, too
    #[arg(long)]
    large: bool,
    /// Only a small sheet and ten thousand boxes: whether all works, rather than how fast
    #[arg(long, conflicts_with_all = ["size", "large"])]
    small: bool,
    /// Runs after the warm-up; the median time is reported
    #[arg(long, value_name = "N", default_value_t = 5, allow_negative_numbers = true)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=1000))]
    runs: u32,
    /// Print one JSON object instead of text
    #[arg(short, long)]
    json: bool,
    #[command(flatten)]
    backend: BackendOptions,
    // Last: the options behind it would stand below its heading.
    #[command(flatten)]
    method: MethodOptions,
}

fn millions(text: &str) -> Result<usize, String> {
    let n: f64 = text.parse().map_err(|e| format!("{e}"))?;
    if n >= 1e-4 && n <= 100.0 {
        Ok((n * 1e6).round() as usize)
    } else {
        Err("must be from 0.0001 to 100".into())
    }
}

/// Vertices along a side of the sheet, and what is found in it: candidates, contacts, the earliest
/// time of impact. Contacts are those of the CPU, whose steps are tested against exact arithmetic.
const SHEET: Sheet = Sheet {
    n: 316,
    candidates: PerKind::new(434_528, 1_529_787),
    contacts: PerKind::new(8_077, 33_665),
    toi: 1.529_644_729_393_303e-5,
};
const SMALL_SHEET: Sheet = Sheet {
    n: 40,
    candidates: PerKind::new(6_571, 22_876),
    contacts: PerKind::new(108, 499),
    toi: 1.587_933_107_876_525e-3,
};

/// Work before a measurement: a device that was idle needs about this long to reach its clock
/// again, and the caches of a processor are warm much sooner.
const WARM_UP: Duration = Duration::from_millis(300);

/// Seed of both sheets.
const SEED: u32 = 0;

struct Sheet {
    n: usize,
    candidates: PerKind,
    contacts: PerKind,
    toi: f64,
}

/// Methods that are timed where none is chosen.
const DEFAULT: [BroadPhaseMethod; 2] = [BroadPhaseMethod::Blocks, BroadPhaseMethod::TREE];

/// Pairs of so many uniform boxes.
const PAIRS: [(usize, usize); 4] =
    [(10_000, 2), (100_000, 320), (1_000_000, 25_417), (10_000_000, 255_457)];

#[derive(Serialize)]
struct Json<'a> {
    machine: String,
    #[serde(flatten)]
    place: output::Place<'a>,
    runs: u32,
    rows: Vec<Row>,
}

#[derive(Serialize)]
struct Row {
    scene: String,
    what: &'static str,
    answer: String,
    median_ms: f64,
    min_ms: f64,
    /// By timestamps of the device; `None` on the CPU and where there are none.
    device_ms: Option<f64>,
}

impl Bench {
    pub fn run(&self) -> Outcome {
        // The choice stands: numbers of two backends must not mix.
        let choice = self.backend.choose(usize::MAX)?.fixed();
        let place =
            BroadPhase::new(&choice, self.backend.threads(), BroadPhaseMethod::Blocks)?.place();
        let machine = output::processor();
        if !self.json {
            output::line("machine", &machine);
            output::line("runs on", &place);
            output::line(
                "times",
                format_args!(
                    "medians of {} after {} ms to warm up; every answer is checked",
                    self.runs,
                    self.warm_up().as_millis()
                ),
            );
            if let Some(device) = choice.device() {
                let stamps = if device.info().timestamps {
                    "beside them what the device itself says, boxes being there"
                } else {
                    "the device has no timestamps"
                };
                output::line("", format_args!("with uploads and results read back; {stamps}"));
            }
            output::say!(
                "\n{:<34} {:<15} {:>30} {:>9} {:>9}",
                "scene",
                "what",
                "answer",
                "time",
                "device"
            );
        }
        let mut rows = Vec::new();
        self.sheet(&choice, &mut rows)?;
        for n in self.sizes() {
            self.boxes(&choice, n, &mut rows)?;
        }
        if self.json {
            output::json(&Json {
                machine,
                place: output::Place::new(&place, None),
                runs: self.runs,
                rows,
            })?;
        }
        output::flush();
        Ok(false)
    }

    fn sizes(&self) -> Vec<usize> {
        let mut sizes = match (self.small, self.size.as_slice()) {
            (true, _) => vec![10_000],
            (false, []) => vec![100_000, 1_000_000],
            (false, sizes) => sizes.to_vec(),
        };
        sizes.extend(self.large.then_some(10_000_000));
        sizes
    }

    fn sheet(&self, choice: &Choice, rows: &mut Vec<Row>) -> Result<(), Failure> {
        let want = if self.small { SMALL_SHEET } else { SHEET };
        let step = crumpled_sheet(want.n, SEED);
        let ([x0, x1], mesh) = (step.rounded(), step.mesh);
        let scene = format!("crumpled sheet, {} vertices", output::thousands(mesh.n_vertices()));
        let options = self.method.set(Options::default().with_threads(self.backend.threads()))?;
        let mut session = Session::new(choice, mesh, options)?;
        let pairs = |n: PerKind| {
            format!(
                "{} vf, {} ee",
                output::thousands(n.vf as usize),
                output::thousands(n.ee as usize)
            )
        };

        let same = |what, found: PerKind, want: PerKind| match found == want {
            true => Ok(pairs(found)),
            false => {
                Err(Failure(format!("{scene}: {} {what}, right are {}", pairs(found), pairs(want))))
            }
        };
        let timed = self.time(&mut session, None, |s| {
            let found = s.candidates(&x0, &x1)?;
            let found = PerKind::new(found.vf.len() as u64, found.ee.len() as u64);
            same("candidates", found, want.candidates)
        })?;
        self.put(rows, &scene, "candidates", timed);
        let timed = self.time(&mut session, None, |s| {
            same("contacts", s.step(&x0, &x1)?.n_contacts(), want.contacts)
        })?;
        self.put(rows, &scene, "all contacts", timed);
        let timed = self.time(&mut session, None, |s| match s.earliest_toi(&x0, &x1)? {
            Some(found) if found <= want.toi && found >= want.toi - TOI_TOLERANCE => {
                Ok(format!("t = {}", toi::short(found, 7)))
            }
            found => Err(Failure(format!("{scene}: earliest {found:?}, right is {:?}", want.toi))),
        })?;
        self.put(rows, &scene, "earliest", timed);
        Ok(())
    }

    fn boxes(&self, choice: &Choice, n: usize, rows: &mut Vec<Row>) -> Result<(), Failure> {
        let boxes = uniform_boxes(n);
        let want = match PAIRS.iter().find(|known| known.0 == n) {
            Some(known) => known.1,
            // Not known beforehand: another method says.
            None => ccd::BroadPhase::new(self.backend.threads(), BroadPhaseMethod::TREE)?
                .self_pairs(&boxes)?
                .len(),
        };
        let scene = format!("uniform boxes, {}", output::thousands(n));
        let (chosen, scheduling) = (self.method.chosen()?, self.method.scheduling()?);
        for method in chosen.map_or(DEFAULT.to_vec(), |method| vec![method]) {
            let what = method.row().name;
            let mut broad =
                BroadPhase::scheduled(choice, self.backend.threads(), method, scheduling)?;
            if method == BroadPhaseMethod::Blocks && broad.gpu().is_some() {
                let megabytes = size_of_val(&boxes[..]) as f64 / 1e6;
                let timed = self.by_clock(&mut broad, |broad| {
                    let sent = broad.gpu().map_or(Ok(()), |on| on.send_boxes(&boxes));
                    sent.map_err(|e| Failure(e.to_string()))?;
                    Ok(format!("{megabytes:.1} MB"))
                })?;
                self.put(rows, &scene, "check and send", timed);
            }
            let timed =
                self.time(&mut broad, Some(want), |broad| match broad.self_pairs(&boxes)?.len() {
                    found if found == want => Ok(format!("{} pairs", output::thousands(found))),
                    found => {
                        Err(Failure(format!("{scene}: {found} pairs by {what}, right are {want}")))
                    }
                })?;
            self.put(rows, &scene, what, timed);
        }
        Ok(())
    }

    /// Time of the warm-up.
    fn warm_up(&self) -> Duration {
        if self.small { Duration::ZERO } else { WARM_UP }
    }

    /// Warms up and runs `runs` times by the clock.
    fn by_clock<S>(
        &self,
        subject: &mut S,
        mut work: impl FnMut(&mut S) -> Result<String, Failure>,
    ) -> Result<Timed, Failure> {
        let answer = work(subject)?;
        let start = Instant::now();
        while start.elapsed() < self.warm_up() {
            work(subject)?;
        }
        let mut times = Vec::new();
        for _ in 0..self.runs {
            let start = Instant::now();
            work(subject)?;
            times.push(start.elapsed().as_secs_f64() * 1e3);
        }
        let (median_ms, min_ms) = median_and_least(times).unwrap_or_default();
        Ok(Timed { answer, median_ms, min_ms, device_ms: None })
    }

    /// Warms up and runs `runs` times by the clock, then likewise by the device's timestamps.
    /// `pairs`: how many a broad phase finds.
    fn time<S: OnDevice>(
        &self,
        subject: &mut S,
        pairs: Option<usize>,
        mut work: impl FnMut(&mut S) -> Result<String, Failure>,
    ) -> Result<Timed, Failure> {
        let timed = self.by_clock(subject, &mut work)?;
        subject.set_timing(Timing::Whole)?;
        // The device idled while boxes were checked and sent: it is warmed once more.
        let start = Instant::now();
        let mut device = Vec::new();
        while device.len() < self.runs as usize {
            match subject.again()? {
                Some(n) if Some(n) == pairs => {}
                Some(n) => {
                    return Err(Failure(format!("{n} pairs the second time, right are {pairs:?}")));
                }
                None => _ = work(subject)?,
            }
            match subject.stages() {
                [(_, ms)] if start.elapsed() >= self.warm_up() => device.push(*ms),
                [_] => {}
                _ => break,
            }
        }
        subject.set_timing(Timing::Off)?;
        Ok(Timed { device_ms: median_and_least(device).map(|m| m.0), ..timed })
    }

    fn put(&self, rows: &mut Vec<Row>, scene: &str, what: &'static str, timed: Timed) {
        let Timed { answer, median_ms, min_ms, device_ms } = timed;
        if !self.json {
            let ms = output::milliseconds;
            output::say!(
                "{scene:<34} {what:<15} {answer:>30} {:>9} {:>9}",
                ms(median_ms),
                device_ms.map_or("-".into(), ms)
            );
        }
        rows.push(Row { scene: scene.into(), what, answer, median_ms, min_ms, device_ms });
    }
}

struct Timed {
    answer: String,
    median_ms: f64,
    min_ms: f64,
    device_ms: Option<f64>,
}

/// The median and the least.
fn median_and_least(mut times: Vec<f64>) -> Option<(f64, f64)> {
    times.sort_unstable_by(f64::total_cmp);
    Some((output::median(&times)?, *times.first()?))
}

/// A session or broad phase that a device can time.
trait OnDevice {
    /// Sets what is timed, if there is a device.
    fn set_timing(&mut self, timing: Timing) -> Result<(), Error>;
    /// Stages of the last call with their times.
    fn stages(&mut self) -> &[(&'static str, f64)];
    /// Finds pairs of boxes once more without sending anything, and says how many; `None` if that
    /// cannot be.
    fn again(&mut self) -> Result<Option<usize>, Error>;
}

impl OnDevice for Session {
    fn set_timing(&mut self, timing: Timing) -> Result<(), Error> {
        self.gpu().map_or(Ok(()), |on| on.set_timing(timing))
    }

    fn stages(&mut self) -> &[(&'static str, f64)] {
        self.gpu().map_or(&[], |on| on.stages())
    }

    fn again(&mut self) -> Result<Option<usize>, Error> {
        Ok(None)
    }
}

impl OnDevice for BroadPhase {
    fn set_timing(&mut self, timing: Timing) -> Result<(), Error> {
        self.gpu().map_or(Ok(()), |on| on.set_timing(timing))
    }

    fn stages(&mut self) -> &[(&'static str, f64)] {
        self.gpu().map_or(&[], |on| on.stages())
    }

    fn again(&mut self) -> Result<Option<usize>, Error> {
        let again = self.gpu().map(|on| on.again()).transpose()?;
        Ok(again.map(|n| n as usize))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_small_scenes_answers_are_those_of_brute_force() {
        let pairs = ccd_testkit::brute::self_pairs(&uniform_boxes(PAIRS[0].0));
        assert_eq!(pairs.len(), PAIRS[0].1);
        let step = crumpled_sheet(SMALL_SHEET.n, SEED);
        let ([x0, x1], mesh) = (step.rounded(), step.mesh);
        let [vf, ee] = ccd_testkit::brute::candidates(&mesh, &x0, &x1);
        assert_eq!(PerKind::new(vf.len() as u64, ee.len() as u64), SMALL_SHEET.candidates);
    }
}
