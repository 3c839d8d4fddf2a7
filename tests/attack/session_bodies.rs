//! Bodies that are moved by themselves, by positions and by poses, beside steps of a new session
//! that is told all positions.

use super::Counts;
use super::session_check::{an_error, of_new};
use super::session_steps::State;
use ccd::{AsPositions, BodyMotion, Coordinate, Options, Posed};
use ccd_testkit::grazing::random::Random;

/// Where bodies are; in `f32` if `narrow`.
pub struct Stands {
    narrow: bool,
    /// What poses are of.
    rest: Vec<[f64; 3]>,
    now: Vec<[f64; 3]>,
}

type Pose<T> = [[T; 4]; 4];

/// How a body moves, and where its vertices are at both ends.
struct Motion<T> {
    body: u32,
    ends: [Vec<[T; 3]>; 2],
    poses: Option<Poses<T>>,
}

/// Poses as wide as positions, or in `f32`.
enum Poses<T> {
    Same([Pose<T>; 2]),
    Narrow([Pose<f32>; 2]),
}

impl State<'_> {
    /// Steps in which some bodies move, if there are any.
    pub fn check_bodies(&mut self, random: &mut Random, counts: &mut Counts) -> Result<(), String> {
        if random.below(2) == 0 || self.session.options().bodies.is_none() {
            return Ok(());
        }
        let options = match self.place.backend() {
            "gpu" => self.plain_options(),
            _ => self.session.options().clone(),
        };
        for _ in 0..1 + random.below(6) {
            let stands = self.stands.take().filter(|_| random.below(6) > 0);
            let mut stands = stands.map_or_else(|| self.set_positions(random), Ok)?;
            counts.add("steps of bodies", 1);
            let n = if stands.narrow {
                self.move_bodies::<f32>(&mut stands, &options, random)?
            } else {
                self.move_bodies::<f64>(&mut stands, &options, random)?
            };
            counts.add("contacts of bodies", n as u64);
            self.stands = Some(stands);
        }
        Ok(())
    }

    /// Has all bodies stand where the next step begins, in `f32` or in `f64`.
    fn set_positions(&mut self, random: &mut Random) -> Result<Stands, String> {
        let narrow = random.below(3) == 0;
        let [x, _] = self.ends();
        let rounded = |p: &[f64; 3]| p.map(|c| if narrow { f64::from(c as f32) } else { c });
        let rest: Vec<_> = x.iter().map(rounded).collect();
        let done = if narrow {
            self.session.set_positions(&cast::<f32>(&rest))
        } else {
            self.session.set_positions(&rest)
        };
        done.map_err(|e| format!("positions: {e}"))?;
        Ok(Stands { narrow, now: rest.clone(), rest })
    }

    /// A step of bodies; the number of its contacts.
    fn move_bodies<T: Coordinate>(
        &mut self,
        stands: &mut Stands,
        options: &Options,
        random: &mut Random,
    ) -> Result<usize, String> {
        let motions = self.motions::<T>(stands, random);
        let mut ends = [cast::<T>(&stands.now), cast::<T>(&stands.now)];
        for motion in &motions {
            for (x, to) in ends.iter_mut().zip(&motion.ends) {
                let slots = x.iter_mut().zip(&self.body_of).filter(|(_, of)| **of == motion.body);
                slots.zip(to).for_each(|((slot, _), p)| *slot = *p);
            }
        }
        let told: Vec<BodyMotion> = motions.iter().map(Motion::told).collect();
        let [x0, x1] = &ends;
        let mut fresh = self.new_session(options.clone())?;
        let want = fresh.step(x0, x1).map_err(of_new)?.clone();
        match random.below(6) {
            0 => {
                let found = self.session.earliest_toi_of_bodies(&told).map_err(an_error)?;
                self.check_earliest(&want, found)?;
            }
            1 => {
                let found = self.session.first_contact_of_bodies(&told).map_err(an_error)?;
                self.check_earliest(&want, found.map(|hit| hit.toi))?;
            }
            kind => {
                if kind == 2 {
                    let twice = [&told[..], &told[..1.min(told.len())]].concat();
                    if self.session.step_bodies(&twice).is_ok() != told.is_empty() {
                        return Err("a body that moves twice".into());
                    }
                }
                if kind == 3 {
                    let want = fresh.intersections(x0).map_err(of_new)?;
                    let found = self.session.intersections(x0);
                    if found.map_err(|e| format!("an error: {e}"))? != want {
                        return Err("other intersections".into());
                    }
                }
                let found = self.session.step_bodies(&told).map_err(an_error)?.clone();
                let same = self.same(&found, &want, [x0, x1], [0.0, 1.0]);
                same.map_err(|why| format!("moving bodies: {why}"))?;
            }
        }
        let now = |p: &[T; 3]| p.map(T::to_f64);
        stands.now = x1.iter().map(now).collect();
        Ok(want.contacts.len())
    }

    /// Some of the bodies that may move, none, one or all of them.
    fn motions<T: Coordinate>(&self, stands: &Stands, random: &mut Random) -> Vec<Motion<T>> {
        let bodies = self.session.options().bodies.as_ref().expect("bodies");
        let [from, to] = self.ends();
        let chance = [0, 1, 2, 4][random.below(4)];
        let used = self.used_bodies();
        let one = (random.below(2) == 0).then(|| used[random.below(used.len())]);
        let mut all = Vec::new();
        for body in used {
            let stays = one.map_or(random.below(4) >= chance, |one| one != body);
            let is_posed = random.below(4) > 0;
            let of = || (0..self.body_of.len()).filter(|&v| self.body_of[v] == body);
            let is_still = of().any(|v| bodies.is_fixed(v as u32)) && !bodies.fixed_may_move();
            if stays || is_still {
                continue;
            }
            if !is_posed {
                let begin = if random.below(2) == 0 { &stands.now } else { &from };
                let ends = [begin, &to].map(|x| of().map(|v| x[v].map(T::from_f64)).collect());
                all.push(Motion { body, ends, poses: None });
                continue;
            }
            let rest: Vec<[T; 3]> = of().map(|v| stands.rest[v].map(T::from_f64)).collect();
            let centre = rest[rest.len() / 2].map(T::to_f64);
            let poses = [(); 2].map(|()| pose(random, centre, self.unit));
            let (poses, same) = if random.below(2) == 0 {
                let narrow = poses.map(|pose| pose.map(|column| column.map(|c| c as f32)));
                let same =
                    narrow.map(|pose| pose.map(|column| column.map(|c| T::from_f64(c.into()))));
                (Poses::Narrow(narrow), same)
            } else {
                let same = poses.map(|pose| pose.map(|column| column.map(T::from_f64)));
                (Poses::Same(same), same)
            };
            let ends = same.each_ref().map(|pose| {
                let x = Posed::one(&rest, pose);
                let view = x.as_positions();
                (0..rest.len()).map(|v| view.at(v)).collect()
            });
            all.push(Motion { body, ends, poses: Some(poses) });
        }
        all
    }
}

impl<T: Coordinate> Motion<T> {
    fn told(&self) -> BodyMotion<'_> {
        match &self.poses {
            None => BodyMotion::new(self.body, &self.ends[0], &self.ends[1]),
            Some(Poses::Same([a, b])) => BodyMotion::posed(self.body, a, b),
            Some(Poses::Narrow([a, b])) => BodyMotion::posed(self.body, a, b),
        }
    }
}

fn cast<T: Coordinate>(x: &[[f64; 3]]) -> Vec<[T; 3]> {
    x.iter().map(|p| p.map(T::from_f64)).collect()
}

/// None, a shift, a turn about `centre` and a shift, or some affine map.
fn pose(random: &mut Random, centre: [f64; 3], unit: f64) -> Pose<f64> {
    let kind = random.below(4);
    let mut part = || if kind == 2 { random.between(-1.0, 1.0) } else { 0.0 };
    let [w, x, y, z] = [part(), part(), part(), part()];
    // Of a quaternion that is mostly real; each column is of length 1 to rounding.
    let (w, n) = (w + 2.0, (w + 2.0) * (w + 2.0) + x * x + y * y + z * z);
    let mut axes = [
        [w * w + x * x - y * y - z * z, 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)],
        [2.0 * (x * y - w * z), w * w - x * x + y * y - z * z, 2.0 * (y * z + w * x)],
        [2.0 * (x * z + w * y), 2.0 * (y * z - w * x), w * w - x * x - y * y + z * z],
    ]
    .map(|axis| axis.map(|c| c / n));
    if kind == 3 {
        axes = axes.map(|axis| axis.map(|c| c + random.between(-0.4, 0.4)));
    }
    let shift = random.vector().map(|c| if kind == 0 { 0.0 } else { 0.3 * unit * c });
    let place = |k: usize| {
        let turned = (0..3).map(|j| axes[j][k] * centre[j]).sum::<f64>();
        if kind < 2 { shift[k] } else { centre[k] - turned + shift[k] }
    };
    let [x, y, z] = axes.map(|[a, b, c]| [a, b, c, 0.0]);
    [x, y, z, [place(0), place(1), place(2), 1.0]]
}
