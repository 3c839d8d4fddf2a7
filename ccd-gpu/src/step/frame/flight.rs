//! A frame in flight: submitted, read when its results arrive, and submitted again if a list was
//! too short. Dropped at any time, it leaves what an error leaves.

use super::attempt::Attempt;
use super::{Found, Frames};
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::{HEADER_BYTES, Header, List, Runs, read_header, read_header_of_parts};
use crate::readback::{Mapping, Part, Plan, word};
use crate::recorder::submit;
use crate::step::cpu_fallback::{Summary, take_touches};
use crate::step::triangle_pairs::read_counts;
use crate::step::{Goal, SAMPLE};
use ccd_core::backend::layout::PackedTouch;
use ccd_core::model::cancel::CancelToken;
use ccd_core::model::contact::{Contact, PerKind};
use ccd_core::model::options::Options;
use std::convert::identity;
use std::task::{Context, Poll, ready};

/// A frame whose results are not here yet.
pub struct Flight {
    goal: Goal,
    window: [f64; 2],
    runs: Runs,
    stage: Stage,
}

/// What is awaited.
enum Stage {
    /// The frame's own reading.
    Results(Attempt),
    /// All contacts: they were more than expected.
    Rest(Found, Rest),
}

/// All contacts of a frame.
struct Rest {
    mapping: Mapping,
    n: u32,
    contacts: Part,
}

/// What became of a frame.
enum End {
    Found(Found),
    Rest(Found, Rest),
    /// A list was too short and has been replaced.
    Incomplete,
}

impl Frames {
    /// Submits a frame over a window of the step; [`Frames::poll`] then gets its results.
    pub fn begin(
        &mut self,
        device: &Device,
        options: &Options,
        (goal, window): (Goal, [f64; 2]),
    ) -> Result<(), Error> {
        self.flight = None;
        let mut runs = Runs::default();
        let stage = self.submit(device, options, (goal, window), &mut runs)?;
        self.flight = Some(Flight { goal, window, runs, stage });
        Ok(())
    }

    /// Forgets the frame that is in flight, if there is one.
    pub fn abandon(&mut self) {
        self.flight = None;
    }

    /// What the frame in flight has found, when it is here; until then the same is submitted again
    /// for as long as a list was too short. Contacts of the device go to `contacts`.
    pub fn poll(
        &mut self,
        device: &Device,
        options: &Options,
        contacts: &mut Vec<Contact>,
        context: &mut Context,
    ) -> Poll<Result<Found, Error>> {
        loop {
            let Some(flight) = &self.flight else { return Poll::Ready(Err(Error::NotSubmitted)) };
            let here = match &flight.stage {
                Stage::Results(attempt) => match attempt.mapping.poll(context) {
                    Poll::Ready(Ok(())) => attempt.times.poll(context),
                    other => other,
                },
                Stage::Rest(_, rest) => rest.mapping.poll(context),
            };
            let here = ready!(here);
            // An error ends the flight.
            let Some(mut flight) = self.flight.take() else { continue };
            here?;
            let found = match flight.stage {
                Stage::Results(attempt) => {
                    match self.take(device, attempt, flight.goal, contacts)? {
                        End::Found(found) => found,
                        End::Rest(found, rest) => {
                            flight.stage = Stage::Rest(found, rest);
                            self.flight = Some(flight);
                            continue;
                        }
                        End::Incomplete => {
                            self.grown += 1;
                            let asked = (flight.goal, flight.window);
                            flight.stage = self.submit(device, options, asked, &mut flight.runs)?;
                            self.flight = Some(flight);
                            continue;
                        }
                    }
                }
                Stage::Rest(mut found, rest) => {
                    (*contacts, found.summary) = rest.take(&mut self.spare)?;
                    found
                }
            };
            let n_open = found.summary.undecided.len() as u32;
            let decides_twice = self.buffers.decides_twice;
            self.left[flight.goal as usize] = if decides_twice { found.left } else { n_open };
            if !decides_twice {
                self.grow_left(device, n_open)?;
            }
            self.geometry.listed = flight.goal == Goal::Contacts;
            return Poll::Ready(Ok(found));
        }
    }

    /// Makes room in the list that only two decisions use for the pairs that one has left open: a
    /// recorded frame always decides twice. A step does not fail for lack of that memory.
    fn grow_left(&mut self, device: &Device, n_open: u32) -> Result<(), Error> {
        match self.buffers.left.grow(device, n_open) {
            Ok(false) => Ok(()),
            Err(e) if !e.is_of_memory() => Err(e),
            _ => {
                self.bench.forget();
                Ok(())
            }
        }
    }

    fn submit(
        &mut self,
        device: &Device,
        options: &Options,
        asked: (Goal, [f64; 2]),
        runs: &mut Runs,
    ) -> Result<Stage, Error> {
        runs.another()?;
        if self.cancel.as_ref().is_some_and(CancelToken::is_cancelled) {
            // What was uploaded is in no order yet.
            self.order.forget();
            return Err(ccd_core::Error::Cancelled.into());
        }
        self.attempt(device, options, asked).map(Stage::Results)
    }

    /// Takes the results of a frame, which are here.
    fn take(
        &mut self,
        device: &Device,
        attempt: Attempt,
        goal: Goal,
        contacts: &mut Vec<Contact>,
    ) -> Result<End, Error> {
        let Attempt { guess, mut order, kept, parts, mapping, times } = attempt;
        let Self { buffers, bench, spare, left, .. } = self;
        let mut found = Found { sorted: !kept, ..Found::default() };
        let mut sampled_of = 0;
        let (mut headers, counted) = mapping.read(|bytes| {
            if goal.is_earliest() {
                found.earliest = word(parts.earliest.of(bytes), 0);
            }
            if goal == Goal::Earliest {
                let at = |i| word(parts.sample.of(bytes), i) as u64;
                (found.sampled, sampled_of) = (at(0) + at(1), at(2) + at(3));
            }
            let mut lists = parts.lists;
            let of_candidates = match goal {
                Goal::Candidates => None,
                _ => Some(std::mem::take(&mut lists.candidates)),
            };
            let mut headers = lists.try_map(|part| match part.bytes {
                0 => Ok(Header::default()),
                _ => read_header(part.of(bytes)),
            })?;
            if let Some([vf, ee]) = of_candidates.map(|of| of.map(|part| part.of(bytes))) {
                headers.candidates = [read_header_of_parts(vf)?, read_header_of_parts(ee)?];
            }
            let n = headers.contacts.wanted.min(guess) as usize;
            let touches = parts.contacts.of(bytes);
            (*contacts, found.summary) = match parts.order.bytes {
                0 => take_touches(touches, n, identity, spare),
                _ => take_touches(touches, n, |packed: PackedTouch| packed.touch(), spare),
            };
            found.in_order = parts.order.bytes > 0 && word(parts.order.of(bytes), 0) == 0;
            let triangles = buffers.source.triangles();
            found.triangles = triangles.map(|_| read_counts(parts.counts.of(bytes)));
            let words = |part: &Part| bytemuck::pod_collect_to_vec(part.of(bytes));
            let counted: Vec<Vec<u32>> = parts.counters.iter().map(words).collect();
            Ok::<_, Error>((headers, counted))
        })??;
        self.stages = times.take()?;
        let of_candidates = match goal {
            Goal::Candidates => Ok(false),
            _ => buffers.grow_candidates(device, goal, &mut headers.candidates),
        };
        let lists = buffers.lists_mut().zip(headers.clone()).into_vec();
        let lists = lists.into_iter().map(|(list, header)| (list, header.wanted));
        let grown = List::grow_all(device, lists);
        let grown = of_candidates.and_then(|longer| Ok(longer | grown?));
        let complete = matches!(grown, Ok(false));
        // Also where a list cannot grow: the source learns that the search was not complete.
        let settled = buffers.source.finder_mut().settle(device, &counted, complete);
        if !complete || !matches!(settled, Ok(false)) {
            bench.forget();
        }
        if !complete {
            contacts.clear();
        }
        let left = &mut left[goal as usize];
        let is_short = headers.contacts.wanted > buffers.contacts.capacity();
        let grown = match grown {
            // Most of them may be pairs that the first of two decisions leaves open. The second one
            // rejects some, from a list that takes less memory.
            Err(e) if e.is_of_memory() && is_short && !buffers.decides_twice && *left < ALWAYS => {
                *left = ALWAYS;
                true
            }
            grown => grown?,
        };
        settled?;
        if grown {
            return Ok(End::Incomplete);
        }
        let of_lists = buffers.source.finder().work(&headers.source);
        order.took(
            kept,
            if goal == Goal::Earliest { of_lists.and(Some(sampled_of)) } else { of_lists },
        );
        self.order = order;
        let (all, of_edges) = (headers.survivors.wanted, headers.survivors.second);
        found.filtered = PerKind::new((all - of_edges) as u64, of_edges as u64);
        let [vf, ee] = &headers.candidates;
        found.candidates = PerKind::new(vf.second as u64, ee.second as u64);
        if goal == Goal::Earliest && found.candidates.total() > found.sampled * SAMPLE as u64 / 4 {
            self.at_once = AT_ONCE;
        }
        found.left = headers.left.wanted;
        let n = headers.contacts.wanted;
        self.contacts[goal as usize].found(n);
        if n > guess {
            found.in_order = false;
            self.spare = std::mem::take(contacts);
            let rest = self.begin_rest(device, n)?;
            return Ok(End::Rest(found, rest));
        }
        Ok(End::Found(found))
    }

    /// Asks for all contacts, where they are more than the frame's own reading had room for.
    fn begin_rest(&mut self, device: &Device, n: u32) -> Result<Rest, Error> {
        let Self { buffers, bench, readback, .. } = self;
        let list = &buffers.contacts;
        let mut plan = Plan::default();
        let contacts = plan.part(list.bytes(n));
        let reading = readback.prepare(device, plan)?;
        submit(device, bench, |recorder| recorder.read(&reading, contacts, list.buffer(), 0))?;
        Ok(Rest { mapping: reading.begin(device)?, n, contacts })
    }
}

impl Rest {
    /// Takes the contacts.
    fn take(self, spare: &mut Vec<Contact>) -> Result<(Vec<Contact>, Summary), Error> {
        let Self { mapping, n, contacts } = self;
        mapping.read(|bytes| {
            let touches = &contacts.of(bytes)[HEADER_BYTES as usize..];
            take_touches(touches, n as usize, identity, spare)
        })
    }
}

/// Stands for the number of pairs left where contacts had no memory: more than any number for
/// which one decision is enough.
const ALWAYS: u32 = u32::MAX;

/// If more than a quarter of the candidates is left after paths were cut, so many of the next calls
/// do without: what is cut takes less time than the sample, the cut and the second fit only where
/// most candidates go.
const AT_ONCE: u32 = 63;
