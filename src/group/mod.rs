//! One mesh on several devices of one host: a session that shares a step out.
//!
//! Each member has an engine and a part of the mesh (`parts.rs`). Parts hold as long as vertices
//! stay near where they were; then all members look for contacts at once, and what they find is put
//! in order. A contact that two members found counts once.

mod elements;
mod member;
mod merge;
mod parts;
mod step;
mod threads;

use crate::positions::Precision;
use crate::{CancelToken, Contact, Error, Kind, Mesh, Mode, Options, Pair};
use ccd_core::model::precision::Given;
use ccd_core::model::session::{self, Ask, Candidates, Change, Filter, Kept, Moved, State};
use elements::Elements;
pub use member::Member;
use member::{Asked, InGroup};
use merge::merge;
use parts::{Part, Parts};
use std::sync::Arc;
use std::time::{Duration, Instant};
use step::add;
use threads::Threads;

/// Continuous collision detection of one mesh over many steps, on several GPUs of one host: for
/// scenes of millions of faces, which one GPU takes tens of milliseconds for. All calls are [those
/// of every backend](session::Session), and find the contacts that one device finds, in the same
/// order. Times are the same, too, except on devices without `f64` and with a minimum distance:
/// there a time may be another one within [`Options::tolerance`] before the contact. If two devices
/// find one contact, the lesser time counts.
///
/// The mesh is in as many parts as there are devices, each with what touches it from outside. The
/// first step makes them, and another one where vertices have left the places that parts were made
/// for: by about a hundredth of the scene, more if they move fast; a motion that all have in common
/// does not count. That takes as long as a hundred steps. A mesh of less than a million triangles
/// stays whole, on the first device ([`Engine::set_least_share`]).
///
/// Of a report, counts of [`candidates`](crate::Report::candidates), of pairs that
/// [filters leave](crate::Report::filtered) and of a method are sums over all devices: pairs at the
/// borders of parts count for each device that looks at them.
/// [`Options::max_memory`] is that of each device.
///
/// ```no_run
/// use ccd::gpu::{Device, DeviceOptions, Group};
/// use ccd::{Mesh, Options};
///
/// let devices = Device::open_all(&DeviceOptions::default())?;
/// let mut group = Group::new(&devices, Mesh::new(4, &[[0, 1, 2]])?, Options::default())?;
/// let report = group.step(&[[0.0f32; 3]; 4], &[[1.0; 3]; 4])?;
/// println!("{} contacts by {} devices", report.contacts.len(), devices.len());
/// # Ok::<(), ccd::gpu::Error>(())
/// ```
#[cfg(feature = "gpu")]
pub type Group = session::Session<Engine<ccd_gpu::Engine>, session::On<Vec<ccd_gpu::Device>>>;

/// What a [`Group`] has.
pub struct Engine<E> {
    state: State,
    members: Vec<InGroup<E>>,
    threads: Threads,
    division: Division,
    least_share: usize,
    /// The contacts of the last report, as memory for those of the next one.
    joined: Vec<Contact>,
    filter: Option<Arc<Filter>>,
    cancel: Option<CancelToken>,
    n_partitions: u32,
}

/// What members have meshes of.
enum Division {
    /// Of nothing yet.
    None,
    /// The first of the whole mesh, which is too small to be divided.
    Whole,
    /// As many members as there are parts of a part each.
    Parts(Parts),
}

impl<E: Member> session::Engine for Engine<E> {
    type On = Vec<E::On>;
    type Error = E::Error;
    type Candidates<'a>
        = Candidates<Vec<Pair>>
    where
        E: 'a;

    fn new(on: &Vec<E::On>, mut state: State) -> Result<Self, E::Error> {
        if on.is_empty() {
            let (name, greatest) = ("devices of a group", u64::MAX);
            return Err(Error::Setting { name, value: 0, least: 1, greatest }.into());
        }
        let member = |on| {
            let state = State::new(Arc::new(Mesh::default()), without_bodies(&state.options));
            E::new(on, state).map(InGroup::new)
        };
        let members = on.iter().map(member).collect::<Result<Vec<_>, E::Error>>()?;
        state.options.mode = mode_of(&members);
        Ok(Self {
            state,
            members,
            threads: Threads::new(),
            division: Division::None,
            least_share: LEAST_SHARE,
            joined: Vec::new(),
            filter: None,
            cancel: None,
            n_partitions: 0,
        })
    }

    fn state(&self) -> &State {
        match self.division {
            Division::Whole => self.members[0].engine.state(),
            _ => &self.state,
        }
    }

    fn kept(&mut self) -> &mut Kept {
        &mut self.state.kept
    }

    fn clear(&mut self) {
        if !self.state.report.contacts.is_empty() {
            // As it is: what stands in it is overwritten.
            self.joined = std::mem::take(&mut self.state.report.contacts);
        }
        self.state.report.clear();
        if let Division::Whole = self.division {
            self.members[0].engine.clear();
        }
    }

    fn find(&mut self, given: Given, moved: Option<Moved>, ask: Ask) -> Result<(), E::Error> {
        self.clear();
        let start = Instant::now();
        self.check_still(given)?;
        let (asked, mut placed) = (Asked::Step(ask), Duration::ZERO);
        if !self.find_by_guess(given, asked)? {
            self.place(given)?;
            if let Division::Whole = self.division {
                return self.members[0].engine.find(given, moved, ask);
            }
            placed = start.elapsed();
            self.find_each(given, asked)?;
        }
        let Self { state: State { mesh, report, .. }, members, threads, division, .. } = self;
        let Division::Parts(Parts { all: parts, .. }) = division else { return Ok(()) };
        report.set_mesh(mesh);
        let reports = members[..parts.len()].iter().map(|member| &member.engine.state().report);
        reports.clone().for_each(|of| add(report, of));
        let lists: Vec<_> = reports.map(|of| &of.contacts[..]).collect();
        let ids = |of: usize, c: &Contact| parts[of].ids(c.kind, [c.a, c.b]);
        report.contacts = std::mem::take(&mut self.joined);
        report.undecided = merge(threads, &lists, ids, &mut report.contacts);
        report.times.boxes += placed.as_secs_f64() * 1e3;
        report.times.total = start.elapsed().as_secs_f64() * 1e3;
        Ok(())
    }

    fn candidates(&mut self, given: Given) -> Result<Candidates<Vec<Pair>>, E::Error> {
        self.clear();
        self.check_still(given)?;
        self.place(given)?;
        if let Division::Whole = self.division {
            return self.members[0].engine.list(given);
        }
        self.find_each(given, Asked::Candidates)?;
        let n_parts = self.n_used();
        let lists = [0, 1, 2, 3].map(|kind| {
            let of = self.members[..n_parts].iter_mut().map(|member| &mut member.lists[kind]);
            let mut all: Vec<Pair> = of.flat_map(std::mem::take).collect();
            all.sort_unstable_by_key(|pair| (pair.a, pair.b));
            all.dedup();
            all
        });
        let State { mesh, report, .. } = &mut self.state;
        report.set_mesh(mesh);
        for (kind, list) in Kind::ALL.into_iter().zip(&lists) {
            *report.candidates.of(kind) = list.len() as u64;
        }
        let [vf, ee, ve, vv] = lists;
        Ok(Candidates::new([vf, ee], [ve, vv]))
    }

    fn change(&mut self, change: Change) -> Result<(), E::Error> {
        self.keep_report();
        // Where a member refuses, others may have changed: all have their meshes sent again.
        let division = std::mem::replace(&mut self.division, Division::None);
        match change {
            Change::Mesh(mesh, options) => {
                let none = Change::Mesh(Arc::new(Mesh::default()), without_bodies(&options));
                self.change_each(|_| none.clone())?;
                (self.state.mesh, self.state.options) = (mesh, options);
                self.state.options.mode = mode_of(&self.members);
            }
            Change::Bodies(bodies) => {
                match &division {
                    Division::None => (),
                    Division::Whole => {
                        self.members[0].engine.change(Change::Bodies(bodies.clone()))?;
                    }
                    Division::Parts(Parts { all, .. }) => {
                        let of = |part: &Part| bodies.as_ref().map(|bodies| part.bodies(bodies));
                        self.change_each(|i| Change::Bodies(all.get(i).and_then(|part| of(part))))?;
                    }
                }
                self.division = division;
                self.state.options.bodies = bodies;
            }
            Change::MinDistance(distance) => {
                self.change_each(|_| Change::MinDistance(distance))?;
                self.division = match division {
                    Division::Parts(parts) if distance > parts.min_distance => Division::None,
                    other => other,
                };
                self.state.options.min_distance = distance;
            }
            Change::Filter(filter) => {
                // Whether it is taken at all; the next step gives each its own.
                if let Err(refused) = self.members[0].engine.change(Change::Filter(filter.clone()))
                {
                    self.division = division;
                    return Err(refused);
                }
                self.filter = filter;
            }
        }
        Ok(())
    }

    fn set_cancel_token(&mut self, token: Option<CancelToken>) {
        for member in &mut self.members {
            member.engine.set_cancel_token(token.clone());
        }
        self.cancel = token;
    }

    fn cancel_token(&self) -> Option<&CancelToken> {
        self.cancel.as_ref()
    }
}

impl<E: Member> Engine<E> {
    /// How often the mesh was divided since the session began.
    pub fn n_partitions(&self) -> u32 {
        self.n_partitions
    }

    /// The engine of each member, as after its last call.
    pub fn members(&self) -> impl ExactSizeIterator<Item = &E> {
        self.members.iter().map(|member| &member.engine)
    }

    /// From now on a device gets at least so many elements: faces, edges of no face, vertices of no
    /// edge. Smaller meshes are stepped by fewer devices, down to the first alone.
    pub fn set_least_share(&mut self, elements: usize) {
        self.keep_report();
        self.least_share = elements.max(1);
        self.division = Division::None;
    }

    /// How many members step the mesh. 0 where the next step divides it: before the first step,
    /// after another mesh or filter, a distance greater than what parts have room for,
    /// [`Engine::set_least_share`], and a call that failed on the way to a division.
    pub fn n_used(&self) -> usize {
        match &self.division {
            Division::None => 0,
            Division::Whole => 1,
            Division::Parts(parts) => parts.all.len(),
        }
    }

    /// The report of a whole mesh is that of its engine: it stays when the division goes.
    fn keep_report(&mut self) {
        if let Division::Whole = self.division {
            self.state.report = self.members[0].engine.state().report.clone();
        }
    }

    fn change_each(&mut self, change: impl Fn(usize) -> Change) -> Result<(), E::Error> {
        let mut members = self.members.iter_mut().enumerate();
        members.try_for_each(|(i, member)| member.engine.change(change(i)))
    }

    /// Checks that what is fixed does not move, in parts: of a whole mesh its engine does.
    fn check_still(&self, given: Given) -> Result<(), Error> {
        if !matches!(self.division, Division::Whole)
            && let Some(bodies) = &self.state.options.bodies
            && let Some(vertex) = match given {
                Precision::F32(x) => moving_still(bodies, x),
                Precision::F64(x) => moving_still(bodies, x),
            }
        {
            return Err(Error::FixedMoves { vertex });
        }
        Ok(())
    }

    /// Makes parts anew where they do not hold for these positions.
    fn place(&mut self, given: Given) -> Result<(), E::Error> {
        let holds = match &mut self.division {
            Division::None => false,
            Division::Whole => true,
            Division::Parts(parts) => parts.look(&self.threads, given),
        };
        if holds {
            return Ok(());
        }
        self.division = Division::None;
        let State { mesh, options, .. } = &self.state;
        let elements = Elements::new(mesh);
        let n_parts = (elements.len() / self.least_share).clamp(1, self.members.len());
        self.n_partitions += 1;
        if n_parts == 1 {
            let engine = &mut self.members[0].engine;
            engine.change(Change::Mesh(mesh.clone(), options.clone()))?;
            engine.change(Change::Filter(self.filter.clone()))?;
            self.division = Division::Whole;
            return Ok(());
        }
        let mut parts = Parts::new(&elements, given, n_parts, options.min_distance)?;
        for (member, part) in self.members.iter_mut().zip(&parts.all) {
            let bodies = options.bodies.as_ref().map(|bodies| part.bodies(bodies));
            let options = options.clone().with_bodies(bodies);
            member.engine.change(Change::Mesh(part.mesh.clone(), options))?;
            let filter = self.filter.clone().map(|filter| {
                let part = part.clone();
                Arc::new(move |kind: Kind, a: u32, b: u32| {
                    let [a, b] = part.ids(kind, [a, b]);
                    filter(kind, a, b)
                }) as Arc<Filter>
            });
            member.engine.change(Change::Filter(filter))?;
        }
        // They have room for these positions, or for where boxes in `f32` have them.
        parts.look(&self.threads, given);
        self.division = Division::Parts(parts);
        Ok(())
    }
}

/// Elements from which on another device pays: below, it is idle for most of a step.
const LEAST_SHARE: usize = 500_000;

/// What the default is on the devices of a group.
fn mode_of<E: Member>(members: &[InGroup<E>]) -> Mode {
    members.first().map_or_else(Mode::default, |first| first.engine.state().options.mode)
}

fn without_bodies(options: &Options) -> Options {
    options.clone().with_bodies(None)
}

/// The first vertex that moves and may not.
fn moving_still<T: PartialEq>(bodies: &crate::Bodies, [x0, x1]: [&[T]; 2]) -> Option<usize> {
    let may_move = bodies.fixed_may_move();
    (0..x0.len()).find(|&v| !may_move && x0[v] != x1[v] && bodies.is_fixed(v as u32))
}
