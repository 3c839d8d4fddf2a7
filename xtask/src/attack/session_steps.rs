//! A session, a change of it, and the step that is compared with that of a new session; every call
//! is written down as Rust while it is made.

use super::session_check::filter_text;
use super::session_faults::break_device;
use super::{Counts, Place};
use ccd::any::{Error, Session};
use ccd::scenes::{Step, crumpled_sheet, particles_and_rods, triangle_soup};
use ccd::{
    Bodies, BroadPhaseMethod, Catalogued, Groups, Kind, Options, Pipeline, Scheduler, Scheduling,
    TriangleOptions, gpu,
};
use ccd_testkit::grazing::random::Random;
use std::panic::{AssertUnwindSafe, catch_unwind};

const N_BODIES: u32 = 9;

pub struct State<'a> {
    pub place: &'a Place,
    pub step: Step,
    /// Coordinates are multiplied by this.
    pub unit: f64,
    /// Where connected elements are of one body.
    body_of: Vec<u32>,
    pub session: Session,
    /// Pairs are left out whose ids add up to a multiple of this; 0: none.
    pub filter: u32,
    /// Which part of the motion the next step is.
    part: usize,
}

/// Parts of a motion.
const PARTS: [[f64; 2]; 4] = [[0.0, 1.0], [1.0, 0.0], [0.25, 0.5], [0.0, 0.0]];

pub type Ends = [Vec<[f64; 3]>; 2];

fn scene(random: &mut Random, text: &mut String) -> (Step, f64) {
    let seed = random.below(1 << 20) as u32;
    let n = [2, 6, 12, 24][random.below(4)];
    let size = [0.4, 0.15][random.below(2)];
    let (step, code) = match random.below(3) {
        0 => (particles_and_rods(n, seed), format!("particles_and_rods({n}, {seed})")),
        1 => {
            (triangle_soup(2 * n, size, seed), format!("triangle_soup({}, {size}, {seed})", 2 * n))
        }
        _ => (crumpled_sheet(n, seed), format!("crumpled_sheet({n}, {seed})")),
    };
    let unit = 2f64.powi([0, 0, 0, -120, 100, 20][random.below(6)]);
    *text += &format!("let (scene, unit) = (ccd::scenes::{code}, {unit:e}f64);\n");
    (step, unit)
}

fn find(root: &[u32], mut v: u32) -> u32 {
    while root[v as usize] != v {
        v = root[v as usize];
    }
    v
}

fn body_of(step: &Step) -> Vec<u32> {
    let mut root: Vec<u32> = (0..step.mesh.n_vertices() as u32).collect();
    for &[a, b] in step.mesh.edges() {
        let (a, b) = (find(&root, a), find(&root, b));
        root[a.max(b) as usize] = a.min(b);
    }
    (0..root.len() as u32).map(|v| find(&root, v) * 7 % N_BODIES).collect()
}

impl<'a> State<'a> {
    pub fn new(place: &'a Place, first: u64, text: &mut String) -> Result<Self, String> {
        let random = &mut Random::new(first);
        let (step, unit) = scene(random, text);
        let options = options(place, random, &Options::default(), text);
        let made = Session::new(&place.choice, step.mesh.clone(), options);
        *text += "let mut session = ccd::any::Session::new(&choice, scene.mesh.clone(), options)\
                  .unwrap();\n";
        let session = made.map_err(|e| format!("an error: {e}"))?;
        Ok(Self { place, body_of: body_of(&step), step, unit, session, filter: 0, part: 0 })
    }

    /// Changes something, and steps.
    pub fn change(
        &mut self,
        random: &mut Random,
        counts: &mut Counts,
        text: &mut String,
    ) -> Result<(), String> {
        let kind = random.below(12);
        let body = random.below(N_BODIES as usize) as u32;
        let flag = random.below(2) == 0;
        let done = match kind {
            0 => {
                (self.step, self.unit) = scene(random, text);
                self.body_of = body_of(&self.step);
                let bodies = self.bodies(random, text);
                *text += "session.set_mesh_and_bodies(scene.mesh.clone(), bodies).unwrap();\n";
                // A distance of another unit is another scene.
                self.session
                    .set_mesh_and_bodies(self.step.mesh.clone(), bodies)
                    .and_then(|()| self.distance(0.0, text))
            }
            1 => {
                let bodies = self.bodies(random, text);
                *text += "session.set_bodies(bodies).unwrap();\n";
                self.session.set_bodies(bodies)
            }
            2 => {
                *text += &format!("let _ = session.set_fixed({body}, {flag});\n");
                // Refused where there is no such body.
                let _ = self.session.set_fixed(body, flag);
                Ok(())
            }
            3 => {
                *text += &format!("let _ = session.set_sleeping({body}, {flag});\n");
                // Refused where there is no such body.
                let _ = self.session.set_sleeping(body, flag);
                Ok(())
            }
            4 => {
                *text += &format!("session.set_fixed_motion({flag}).unwrap();\n");
                self.session.set_fixed_motion(flag)
            }
            5 => self.distance([0.0, 0.01, 1e-9, 0.05][random.below(4)], text),
            6 | 7 => {
                let before = self.session.options().clone();
                let options = options(self.place, random, &before, text);
                *text += "session.set_options(options).unwrap();\n";
                self.session.set_options(options)
            }
            8 if self.place.backend() == "cpu" => {
                self.filter = random.below(4) as u32;
                self.set_filter(text)
            }
            8 | 9 => self.fail(random, counts, text),
            _ => {
                self.part += random.below(9);
                Ok(())
            }
        };
        done.map_err(|e| format!("an error: {e}"))?;
        counts.add("steps", 1);
        self.check(random, counts, text)
    }

    fn distance(&mut self, distance: f64, text: &mut String) -> Result<(), Error> {
        *text += &format!("session.set_min_distance({:e}).unwrap();\n", distance * self.unit);
        self.session.set_min_distance(distance * self.unit)
    }

    fn set_filter(&mut self, text: &mut String) -> Result<(), Error> {
        let n = self.filter;
        *text += &format!("session.set_filter(|_, a, b| {}).unwrap();\n", filter_text(n));
        self.session.set_filter(move |_, a, b| n == 0 || (a + b) % n != 0)
    }

    fn bodies(&self, random: &mut Random, text: &mut String) -> Option<Bodies> {
        if random.below(6) == 0 {
            *text += "let bodies: Option<ccd::Bodies> = None;\n";
            return None;
        }
        let n = N_BODIES as usize;
        let fixed: Vec<bool> = (0..n).map(|_| random.below(4) == 0).collect();
        let (own, moves) = (random.below(2) == 0, random.below(4) == 0);
        let mut all = Bodies::new(&self.body_of, &fixed, own).with_fixed_motion(moves);
        let mut code = format!(
            "ccd::Bodies::new(&{:?}, &{fixed:?}, {own}).with_fixed_motion({moves})",
            self.body_of
        );
        let there: Vec<u32> = (0..N_BODIES).filter(|b| self.body_of.contains(b)).collect();
        for &b in &there {
            let (other, number) = (there[random.below(there.len())], random.below(4) as u32);
            match random.below(10) {
                0 => {
                    all = all.with_sleeping(b, true);
                    code += &format!(".with_sleeping({b}, true)");
                }
                1 => {
                    all = all.with_self_contact(b, true);
                    code += &format!(".with_self_contact({b}, true)");
                }
                2 => {
                    all = all.with_groups(b, Groups { memberships: number, filter: 3 });
                    code += &format!(
                        ".with_groups({b}, ccd::Groups {{ memberships: {number}, filter: 3 }})"
                    );
                }
                3 => {
                    all = all.with_world(b, number);
                    code += &format!(".with_world({b}, {number})");
                }
                4 => {
                    all = all.with_excluded_bodies(&[[b, other]]);
                    code += &format!(".with_excluded_bodies(&[[{b}, {other}]])");
                }
                _ => {}
            }
        }
        let mesh = &self.step.mesh;
        let [v, e, f] = [mesh.n_vertices(), mesh.edges().len(), mesh.faces().len()];
        for (kind, p, q) in [(Kind::VertexFace, v, f), (Kind::EdgeEdge, e, e)] {
            if random.below(3) == 0 && p > 0 && q > 0 {
                let pairs: Vec<[u32; 2]> =
                    (0..8).map(|_| [random.below(p) as u32, random.below(q) as u32]).collect();
                code += &format!(".with_excluded_features(ccd::Kind::{kind:?}, &{pairs:?})");
                all = all.with_excluded_features(kind, &pairs);
            }
        }
        *text += &format!("let bodies = Some({code});\n");
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
                std::array::from_fn(|i| (x0[v][i] + (x1[v][i] - x0[v][i]) * t) * self.unit)
            };
            (0..x0.len()).map(at).collect()
        })
    }

    pub fn ends_text(&self) -> String {
        let still = (self.part / 8 % 3) as f64 * 0.25;
        format!(
            "let bodies = session.options().bodies.clone();\n\
             let still = |v| bodies.as_ref().is_some_and(|b| b.is_fixed(v) && \
             !b.fixed_may_move());\n\
             let [x0, x1] = {:?}.map(|t| -> Vec<[f64; 3]> {{\n\
             let ends = scene.x0.iter().zip(&scene.x1).enumerate();\n\
             ends.map(|(v, (p, q))| {{\nlet t = if still(v as u32) {{ {still:?} }} else {{ t }};\n\
             std::array::from_fn(|i| (p[i] + (q[i] - p[i]) * t) * unit)\n}}).collect()\n}});\n",
            PARTS[self.part % 4]
        )
    }

    /// A call that is refused, or breaks off in the middle.
    fn fail(
        &mut self,
        random: &mut Random,
        counts: &mut Counts,
        text: &mut String,
    ) -> Result<(), Error> {
        let [x0, mut x1] = self.ends();
        let n = x1.len();
        *text += &self.ends_text();
        let (name, refused) = match random.below(7) {
            0 => {
                let (v, value) = (random.below(n), [f64::NAN, f64::INFINITY][random.below(2)]);
                x1[v][1] = value;
                *text += &format!("let mut bad = x1.clone();\nbad[{v}][1] = f64::");
                *text += if value.is_nan() { "NAN" } else { "INFINITY" };
                *text += ";\nassert!(session.step(&x0, &bad).is_err());\n";
                ("no number", self.session.step(&x0, &x1).is_err())
            }
            1 => {
                *text += "assert!(session.step(&x0, &x1[1..]).is_err());\n";
                ("wrong count", self.session.step(&x0[..], &x1[1..]).is_err())
            }
            2 => {
                *text += "assert!(session.step_window(&x0, &x1, [0.75, 0.5]).is_err());\n";
                ("wrong window", self.session.step_window(&x0, &x1, [0.75, 0.5]).is_err())
            }
            3 => {
                let bad = self.session.options().clone().with_tolerance(0.0);
                *text += "let bad = session.options().clone().with_tolerance(0.0);\n\
                          assert!(session.set_options(bad).is_err());\n\
                          assert!(session.set_min_distance(-1.0).is_err());\n";
                let refused = [
                    self.session.set_options(bad).is_err(),
                    self.session.set_min_distance(-1.0).is_err(),
                ];
                ("bad options", refused == [true; 2])
            }
            4 => {
                let bodies = Bodies::new(&vec![0; n + 1], &[], true);
                *text += "let bad = ccd::Bodies::new(&vec![0; scene.x0.len() + 1], &[], true);\n\
                          assert!(session.set_bodies(bad).is_err());\n";
                ("bad bodies", self.session.set_bodies(bodies).is_err())
            }
            _ => match self.session.gpu() {
                Some(on) => {
                    let broken = break_device(self.place, on, random, [&x0, &x1], text)?;
                    counts.add("short rounds", broken.short_rounds as u64);
                    (broken.what, broken.as_it_should)
                }
                None => self.panic_in_filter(random, [&x0, &x1], text)?,
            },
        };
        counts.add(&format!("failures: {name}"), 1);
        if refused { Ok(()) } else { Err(Error::Refused { why: format!("{name}: accepted") }) }
    }

    /// A filter that panics now and then, which the caller catches.
    fn panic_in_filter(
        &mut self,
        random: &mut Random,
        [x0, x1]: [&[[f64; 3]]; 2],
        text: &mut String,
    ) -> Result<(&'static str, bool), Error> {
        let n = 1 + random.below(40) as u32;
        *text += &format!(
            "session.set_filter(|_, a, b| (a + 3 * b) % {n} != 0 || panic!(\"provoked\"))\
             .unwrap();\n\
             let step = std::panic::AssertUnwindSafe(|| _ = session.step(&x0, &x1));\n\
             let _ = std::panic::catch_unwind(step);\n"
        );
        let provoked =
            move |_, a: u32, b: u32| !(a + 3 * b).is_multiple_of(n) || panic!("provoked");
        self.session.set_filter(provoked)?;
        let step = AssertUnwindSafe(|| self.session.step(x0, x1).map(|_| ()));
        let ended = catch_unwind(step);
        self.set_filter(text)?;
        match ended {
            Ok(done) => done.map(|()| ("filters that were not asked", true)),
            Err(_) => Ok(("panics of a filter", true)),
        }
    }
}

/// Another method, scheduling, pipeline, tolerance, number of threads.
fn options(place: &Place, random: &mut Random, before: &Options, text: &mut String) -> Options {
    let backend = place.backend();
    let native = place.choice.device().is_none_or(|d| d.info().path == gpu::Path::Passthrough);
    let methods: Vec<BroadPhaseMethod> = ccd::every(backend)
        .filter(|m| {
            ccd_testkit::methods::is_near_default(*m) && *m != BroadPhaseMethod::UniformGrid
        })
        .collect();
    let method = methods[random.below(methods.len())];
    let steals =
        |s: &Scheduling| matches!(s.scheduler, Some(Scheduler::Stealing | Scheduler::LazyStealing));
    let mut all = vec![Scheduling::default()];
    all.extend(
        Scheduling::every(backend).filter(|s| s.check(method).is_ok() && (native || !steals(s))),
    );
    let scheduling = all[random.below(all.len())];
    let rows: Vec<Pipeline> = Pipeline::ROWS
        .iter()
        .filter(|row| row.backends.contains(&backend))
        .map(|row| row.value)
        .chain([Pipeline::Triangles(TriangleOptions::default().cones(true))])
        .collect();
    let pipeline = rows[random.below(rows.len())];
    let (threads, leaves) = (1 + random.below(2), random.below(3) == 0);
    let tolerance = [1e-6, 1e-6, 1e-3, 1e-12][random.below(4)];
    let start = if text.contains("let mut session") {
        "session.options().clone()"
    } else {
        "ccd::Options::default()"
    };
    let scheduling_text = if scheduling == Scheduling::default() {
        "ccd::Scheduling::default()".into()
    } else {
        format!(
            "ccd::Scheduling::every({backend:?}).find(|s| s.to_string() == \
             \"{scheduling}\").unwrap()"
        )
    };
    let pipeline_text = match pipeline {
        Pipeline::Triangles(t) => format!(
            "ccd::Pipeline::Triangles(ccd::TriangleOptions::default().orphans({}).cones({}))",
            t.orphans, t.cones
        ),
        _ => "ccd::Pipeline::Features".into(),
    };
    *text += &format!(
        "let options = {start}.with_threads({threads}).with_leave_contact({leaves})\n\
         .with_broad_phase(ccd::every({backend:?}).find(|m| m.to_string() == \
         \"{method}\").unwrap())\n\
         .with_scheduling({scheduling_text})\n.with_pipeline({pipeline_text})\
         .with_tolerance({tolerance:?});\n"
    );
    before
        .clone()
        .with_threads(threads)
        .with_leave_contact(leaves)
        .with_broad_phase(method)
        .with_scheduling(scheduling)
        .with_pipeline(pipeline)
        .with_tolerance(tolerance)
}
