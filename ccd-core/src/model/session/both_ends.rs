//! Positions of all vertices at both ends of a step, of which bodies that move are told.

use crate::model::error::Error;
use crate::model::positions::{Pose, check_pose, moved};
use crate::model::precision::Coordinate;
use alloc::vec::Vec;
use core::ops::Range;

/// A body that moves rigidly, and its poses at both ends of a step.
#[derive(Clone, Copy, Debug)]
pub struct Rigid<T> {
    /// Its number in [`Bodies`](crate::model::bodies::Bodies).
    pub number: u32,
    /// The same where it does not move in this step.
    pub poses: [Pose<T>; 2],
    /// Where a call that fails leaves it; `None`: not rigid.
    before: Option<Pose<T>>,
}

/// The bodies whose vertices are where poses put them.
#[derive(Clone, Copy, Debug)]
pub struct Rigids<'a, T> {
    /// Each once, in no order.
    pub all: &'a [Rigid<T>],
    /// Positions of all vertices before any pose.
    pub rest: &'a [[T; 3]],
    /// Another one than in a call before if these are other bodies, in another order, or `rest` is
    /// another.
    pub version: u64,
    /// Another one than in a call before if `rest` is another.
    pub placed: u64,
}

/// Positions at both ends; what does not move is equal in both.
#[derive(Debug, Default)]
pub struct BothEnds<T> {
    rest: Vec<[T; 3]>,
    ends: [Vec<[T; 3]>; 2],
    /// Positions before this call of what moves in it, in the order in which it was written.
    before: Vec<[T; 3]>,
    rigids: Vec<Rigid<T>>,
    /// By the number of a body: its place in `rigids`, plus 1.
    places: Vec<u32>,
}

/// Where a body goes in a step.
pub enum Way<'a, T> {
    Ends([&'a [[T; 3]]; 2]),
    Poses([Pose<T>; 2]),
}

impl<T: Coordinate> BothEnds<T> {
    pub(super) fn at(x: &[[T; 3]]) -> Self {
        let [rest, x0, x1] = [x; 3].map(<[_]>::to_vec);
        Self { rest, ends: [x0, x1], before: Vec::new(), rigids: Vec::new(), places: Vec::new() }
    }

    pub(super) fn ends(&self) -> [&[[T; 3]]; 2] {
        self.ends.each_ref().map(Vec::as_slice)
    }

    pub(super) fn rigids(&self, [version, placed]: [u64; 2]) -> Rigids<'_, T> {
        Rigids { all: &self.rigids, rest: &self.rest, version, placed }
    }

    /// What moved in the last call stands where it went.
    pub(super) fn arrive(&mut self, runs: &[Range<u32>]) {
        let [x0, x1] = &mut self.ends;
        for run in runs {
            let run = run.start as usize..run.end as usize;
            x0[run.clone()].copy_from_slice(&x1[run]);
        }
        for Rigid { poses, before, .. } in &mut self.rigids {
            (poses[0], *before) = (poses[1], Some(poses[1]));
        }
    }

    /// Keeps where a body is.
    pub(super) fn stay(&mut self, runs: &[Range<u32>]) {
        let [x0, _] = &self.ends;
        self.before.extend(runs.iter().flat_map(|run| &x0[run.start as usize..run.end as usize]));
    }

    /// Has a body move.
    pub(super) fn go<U: Coordinate>(
        &mut self,
        (body, number, runs): (u32, usize, &[Range<u32>]),
        way: Way<U>,
        exact: impl Fn(U) -> T,
        version: &mut u64,
    ) -> Result<(), Error> {
        self.stay(runs);
        let to = match way {
            Way::Poses(poses) => {
                let poses = poses.map(|pose| pose.map(|column| column.map(&exact)));
                return self.turn((body, number, runs), poses, version);
            }
            Way::Ends(to) => to,
        };
        if let Some(&place) = self.places.get(number).filter(|&&place| place > 0) {
            self.forget_rigid(place as usize - 1, version);
        }
        let expected = runs.iter().map(|run| run.len()).sum();
        for (time, (x, to)) in self.ends.iter_mut().zip(to).enumerate() {
            if to.len() != expected {
                let (time, found) = (time as u8, to.len());
                return Err(Error::BodyPositions { body, time, expected, found });
            }
            let mut to = to.iter();
            for run in runs {
                let slots = &mut x[run.start as usize..run.end as usize];
                slots.iter_mut().zip(&mut to).for_each(|(slot, p)| *slot = p.map(&exact));
            }
        }
        Ok(())
    }

    /// Has a body move from pose to pose.
    fn turn(
        &mut self,
        (body, number, runs): (u32, usize, &[Range<u32>]),
        poses: [Pose<T>; 2],
        version: &mut u64,
    ) -> Result<(), Error> {
        for (time, pose) in poses.iter().enumerate() {
            check_pose(time as u8, body as usize, pose)?;
        }
        if self.places.len() <= number {
            self.places.resize(number + 1, 0);
        }
        if self.places[number] == 0 {
            self.rigids.push(Rigid { number: number as u32, poses, before: None });
            self.places[number] = self.rigids.len() as u32;
            *version += 1;
        }
        self.rigids[self.places[number] as usize - 1].poses = poses;
        let Self { ends, rest, .. } = self;
        for run in runs.iter().map(|run| run.start as usize..run.end as usize) {
            for (x, pose) in ends.iter_mut().zip(&poses) {
                let slots = x[run.clone()].iter_mut();
                slots.zip(&rest[run.clone()]).for_each(|(slot, p)| *slot = moved(pose, p));
            }
        }
        Ok(())
    }

    /// The body at this place does not move rigidly any more.
    fn forget_rigid(&mut self, place: usize, version: &mut u64) {
        let Self { rigids, places, .. } = self;
        places[rigids.swap_remove(place).number as usize] = 0;
        if let Some(last) = rigids.get(place) {
            places[last.number as usize] = place as u32 + 1;
        }
        *version += 1;
    }

    pub(super) fn forget_rigids(&mut self) {
        self.rigids.clear();
        self.places.clear();
    }

    pub(super) fn end(&mut self, runs: &[Range<u32>], failed: bool, version: &mut u64) {
        if failed {
            let mut rest = &self.before[..];
            for run in runs {
                let (positions, others) = rest.split_at(run.len());
                let run = run.start as usize..run.end as usize;
                self.ends.iter_mut().for_each(|x| x[run.clone()].copy_from_slice(positions));
                rest = others;
            }
            for place in (0..self.rigids.len()).rev() {
                let Rigid { poses, before, .. } = &mut self.rigids[place];
                match *before {
                    Some(before) => *poses = [before; 2],
                    None => self.forget_rigid(place, version),
                }
            }
        }
        self.before.clear();
    }
}
