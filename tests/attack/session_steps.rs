//! A session and a change of it, made of a number.

use super::session_bodies::Stands;
use super::session_faults::break_device;
use super::session_scenes::{N_BODIES, Scene, body_of, scene};
use super::{Counts, Place};
use ccd::any::{Error, Session};
use ccd::method::{BroadPhaseMethod, Catalogued, Pipeline, TriangleOptions};
use ccd::scenes::Step;
use ccd::{Bodies, CancelToken, Groups, Kind, Mesh, Mode, Options};
use ccd_testkit::grazing::random::Random;
use std::panic::{AssertUnwindSafe, catch_unwind};

pub struct State<'a> {
    pub place: &'a Place,
    pub step: Step,
    /// Coordinates were multiplied by this.
    pub unit: f64,
    /// Whether the scene is far from the origin for its size.
    pub is_far: bool,
    /// Body of each vertex.
    pub body_of: Vec<u32>,
    pub session: Session,
    /// Pairs are left out whose ids add up to a multiple of this; 0: none.
    pub filter: u32,
    /// Part of the motion in the next step, an index.
    part: usize,
    /// Where bodies are that are moved by themselves; `None`: nobody has said.
    pub stands: Option<Stands>,
}

/// Parts of a motion.
const PARTS: [[f64; 2]; 4] = [[0.0, 1.0], [1.0, 0.0], [0.25, 0.5], [0.0, 0.0]];

pub type Ends = [Vec<[f64; 3]>; 2];

impl<'a> State<'a> {
    pub fn new(place: &'a Place, first: u64) -> Result<Self, Error> {
        let random = &mut Random::new(first);
        let Scene { step, unit, is_far } = scene(random);
        let options = options(place, random, &Options::default());
        let session = Session::new(&place.choice, step.mesh.clone(), options)?;
        Ok(Self {
            place,
            body_of: body_of(&step),
            step,
            unit,
            is_far,
            session,
            filter: 0,
            part: 0,
            stands: None,
        })
    }

    pub fn change(&mut self, random: &mut Random, counts: &mut Counts) -> Result<(), Error> {
        let kind = random.below(12);
        let body = random.below(N_BODIES as usize) as u32;
        let flag = random.below(2) == 0;
        match kind {
            0 => {
                Scene { step: self.step, unit: self.unit, is_far: self.is_far } = scene(random);
                self.body_of = body_of(&self.step);
                self.stands = None;
                let bodies = self.bodies(random);
                // A distance of another unit is another scene.
                self.session
                    .set_mesh_and_bodies(self.step.mesh.clone(), bodies)
                    .and_then(|()| self.session.set_min_distance(0.0))
            }
            1 => self.session.set_bodies(self.bodies(random)),
            2 => unless_nobody(body, self.session.set_fixed(body, flag)),
            3 => unless_nobody(body, self.session.set_sleeping(body, flag)),
            4 => self.session.set_fixed_motion(flag),
            5 => {
                // Decisions without rounding take none.
                let is_exact = self.session.options().mode == Mode::Exact;
                let distance = [0.0, 0.01, 1e-9, 0.05][random.below(4)];
                let distance = if is_exact { 0.0 } else { distance * self.unit };
                self.session.set_min_distance(distance)
            }
            6 | 7 => {
                let options = options(self.place, random, self.session.options());
                self.session.set_options(options.clone())?;
                let mode = options.mode;
                let is_on_cpu = self.place.backend() == "cpu";
                let options = options.with_mode(if is_on_cpu { mode } else { mode.on_device() });
                ensure(*self.session.options() == options, "other options")
            }
            8 if self.place.backend() == "cpu" => {
                self.filter = random.below(4) as u32;
                self.set_filter()
            }
            8 | 9 => self.fail(random, counts),
            _ => {
                self.part += random.below(9);
                Ok(())
            }
        }
    }

    fn set_filter(&mut self) -> Result<(), Error> {
        let n = self.filter;
        self.session.set_filter(move |_, a, b| keeps(n, a, b))
    }

    /// Names of bodies that have vertices.
    pub fn used_bodies(&self) -> Vec<u32> {
        (0..N_BODIES).filter(|b| self.body_of.contains(b)).collect()
    }

    fn bodies(&self, random: &mut Random) -> Option<Bodies> {
        if random.below(6) == 0 {
            return None;
        }
        let fixed: Vec<bool> = (0..N_BODIES).map(|_| random.below(4) == 0).collect();
        let (self_contact, moves) = (random.below(2) == 0, random.below(4) == 0);
        let mut all = Bodies::new(&self.body_of)
            .with_fixed_mask(&fixed)
            .with_self_contacts(self_contact)
            .with_fixed_motion(moves);
        let used = self.used_bodies();
        for &b in &used {
            let (other, number) = (used[random.below(used.len())], random.below(4) as u32);
            all = match random.below(10) {
                0 => all.with_sleeping(b, true),
                1 => all.with_self_contact(b, true),
                2 => all.with_groups(b, Groups { memberships: number, filter: 3 }),
                3 => all.with_world(b, number),
                4 => all.with_excluded_bodies(&[[b, other]]),
                _ => all,
            };
        }
        let mesh = &self.step.mesh;
        let [v, e, f] = [mesh.n_vertices(), mesh.edges().len(), mesh.faces().len()];
        for kind in Kind::ALL {
            let [p, q] = match kind {
                Kind::VertexFace => [v, f],
                Kind::EdgeEdge => [e, e],
                Kind::VertexEdge => [v, e],
                Kind::VertexVertex => [v, v],
            };
            if random.below(3) == 0 && p > 0 && q > 0 {
                let mut pair = || [random.below(p) as u32, random.below(q) as u32];
                let pairs: Vec<[u32; 2]> = (0..8).map(|_| pair()).collect();
                all = all.with_excluded_features(kind, &pairs);
            }
        }
        Some(all)
    }

    /// Positions of the next step, at which what stands still does.
    pub fn ends(&self) -> Ends {
        let Step { x0, x1, .. } = &self.step;
        let bodies = self.session.options().bodies.as_ref();
        PARTS[self.part % 4].map(|t| {
            let at = |v: usize| -> [f64; 3] {
                let still = bodies.is_some_and(|b| b.is_fixed(v as u32) && !b.fixed_may_move());
                let t = if still { (self.part / 8 % 3) as f64 * 0.25 } else { t };
                std::array::from_fn(|i| x0[v][i] + (x1[v][i] - x0[v][i]) * t)
            };
            (0..x0.len()).map(at).collect()
        })
    }

    /// A call that is refused, or breaks off in the middle.
    fn fail(&mut self, random: &mut Random, counts: &mut Counts) -> Result<(), Error> {
        let [x0, mut x1] = self.ends();
        let n = x1.len();
        let session = &mut self.session;
        let (name, refused) = match random.below(12) {
            0 => {
                let (v, value) = (random.below(n), [f64::NAN, f64::INFINITY][random.below(2)]);
                x1[v][1] = value;
                ("no number", session.step(&x0, &x1).is_err())
            }
            1 => ("wrong count", session.step(&x0[..], &x1[1..]).is_err()),
            2 => ("wrong window", session.step_window(&x0, &x1, [0.75, 0.5]).is_err()),
            3 => {
                let options = session.options().clone();
                let many = options.clone().with_threads(Options::MAX_THREADS + 1);
                let mut refused = session.set_options(options.with_tolerance(0.0)).is_err();
                if self.place.backend() == "cpu" {
                    let done = session.set_options(many);
                    refused &= matches!(done, Err(Error::Input(ccd::Error::Threads { .. })));
                }
                refused &= [-1.0, f64::NAN].iter().all(|&d| session.set_min_distance(d).is_err());
                ("bad options", refused)
            }
            4 => {
                let bodies = Bodies::new(&vec![0; n + 1]);
                ("bad bodies", session.set_bodies(bodies).is_err())
            }
            5 => {
                let bodies = session.options().bodies.as_ref();
                let still = bodies.filter(|bodies| !bodies.fixed_may_move());
                match still.and_then(|bodies| (0..n).find(|&v| bodies.is_fixed(v as u32))) {
                    None => ("nothing that is fixed", true),
                    Some(v) => {
                        x1[v][0] += self.unit;
                        ("fixed bodies that move", session.step(&x0, &x1).is_err())
                    }
                }
            }
            // Bodies of this mesh do not fit another; neither is changed.
            6 if session.options().bodies.is_some() => {
                let other = Mesh::new(n + 1, &[])?;
                let done = session.set_mesh(other);
                let refused = matches!(done, Err(Error::Input(ccd::Error::BodyCount { .. })));
                ("bad mesh", refused)
            }
            7 => {
                let token = CancelToken::new();
                token.cancel();
                session.set_cancel_token(token);
                let done = session.step(&x0, &x1);
                let refused = matches!(done, Err(Error::Input(ccd::Error::Cancelled)));
                session.set_cancel_token(None);
                ("cancelled", refused)
            }
            8 => {
                let options = session.options().clone();
                let limited = options.clone().with_max_memory(1 << (10 + random.below(14)));
                let done = session.set_options(limited);
                match done.and_then(|()| session.step(&x0, &x1).map(|_| ())) {
                    Ok(()) | Err(Error::Input(ccd::Error::Memory { .. })) => {}
                    other => return other,
                }
                session.set_options(options)?;
                ("limits of memory", true)
            }
            _ => match session.gpu() {
                Some(on) => break_device(self.place, on, random, [&x0, &x1], counts)?,
                None => self.panic_in_filter(random, [&x0, &x1])?,
            },
        };
        counts.add(&format!("failures: {name}"), 1);
        ensure(refused, &format!("{name}: accepted"))
    }

    /// A filter that panics now and then, which the caller catches.
    fn panic_in_filter(
        &mut self,
        random: &mut Random,
        [x0, x1]: [&[[f64; 3]]; 2],
    ) -> Result<(&'static str, bool), Error> {
        let n = 1 + random.below(40) as u32;
        let provoked =
            move |_, a: u32, b: u32| !(a + 3 * b).is_multiple_of(n) || panic!("provoked");
        self.session.set_filter(provoked)?;
        let step = AssertUnwindSafe(|| self.session.step(x0, x1).map(|_| ()));
        let ended = catch_unwind(step);
        self.set_filter()?;
        match ended {
            Ok(done) => done.map(|()| ("filters that were not asked", true)),
            Err(_) => Ok(("panics of a filter", true)),
        }
    }
}

/// Whether a filter keeps a pair, `n` being [`State::filter`].
pub fn keeps(n: u32, a: u32, b: u32) -> bool {
    n == 0 || !(a + b).is_multiple_of(n)
}

/// An error that says what is wrong, if something is.
fn ensure(right: bool, what: &str) -> Result<(), Error> {
    if right { Ok(()) } else { Err(Error::Refused { why: what.into() }) }
}

/// A change of a body is refused where there is no such body, and for nothing else.
fn unless_nobody(body: u32, done: Result<(), Error>) -> Result<(), Error> {
    match done {
        Err(Error::Input(why)) if why == (ccd::Error::NoBody { body }) => Ok(()),
        _ => done,
    }
}

/// Another method, scheduling, pipeline, tolerance, number of threads; what steps are made by
/// without a choice as often as all else.
fn options(place: &Place, random: &mut Random, before: &Options) -> Options {
    let backend = place.backend();
    let [is_default, all] = [2, 6].map(|n| random.below(n) == 0);
    let is_wanted = |m: &BroadPhaseMethod| {
        let is_left_out = backend == "gpu" && *m == BroadPhaseMethod::UniformGrid;
        (all || ccd_testkit::methods::is_near_default(*m)) && !is_left_out
    };
    let methods: Vec<BroadPhaseMethod> = ccd::method::every(backend).filter(is_wanted).collect();
    let method = methods[random.below(methods.len())];
    let schedulings = place.schedulings(method);
    let scheduling = schedulings[random.below(schedulings.len())];
    let rows = Pipeline::ROWS.iter().filter(|row| row.backends.contains(&backend));
    let free_regions = Pipeline::Triangles(TriangleOptions::default().free_regions(true));
    let pipelines: Vec<Pipeline> = rows.map(|row| row.value).chain([free_regions]).collect();
    let pipeline = pipelines[random.below(pipelines.len())];
    let (threads, leaves) = (1 + random.below(2), random.below(3) == 0);
    let tolerance = [1e-6, 1e-6, 1e-3, 1e-12][random.below(4)];
    let options = before.clone().with_threads(threads).with_leave_contact(leaves);
    let mode = Mode::ALL[random.below(Mode::ALL.len())];
    let mode = if before.min_distance > 0.0 { Mode::Auto } else { mode };
    let options = options.with_tolerance(tolerance).with_mode(mode);
    if is_default {
        let plain = Options::default();
        return options
            .with_broad_phase(plain.broad_phase)
            .with_scheduling(plain.scheduling)
            .with_pipeline(plain.pipeline);
    }
    options.with_broad_phase(method).with_scheduling(scheduling).with_pipeline(pipeline)
}
