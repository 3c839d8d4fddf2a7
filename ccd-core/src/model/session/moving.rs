//! Positions that a session keeps, so that a step is told only those of bodies that move.

use crate::model::bodies::Bodies;
use crate::model::error::Error;
use crate::model::mesh::Mesh;
use crate::model::positions::{AsPositions, Ends, Gathered, ends};
use crate::model::precision::{Coordinate, Given, Precision};
use alloc::vec::Vec;
use core::ops::Range;

/// How one body moves in a step: the positions of its vertices at both ends, in the order of their
/// ids.
///
/// ```
/// use ccd::{BodyMotion, Posed};
///
/// let crate_at_rest = [[0.0f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// let before = [0, 1, 2, 3].map(|k| [0, 1, 2, 3].map(|i| (i == k) as u8 as f32));
/// let mut after = before;
/// after[3][1] = -0.5;
/// let x0 = Posed::one(&crate_at_rest, &before);
/// let x1 = Posed::one(&crate_at_rest, &after);
/// let motion = BodyMotion::new(3, &x0, &x1);
/// assert_eq!(motion.body, 3);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct BodyMotion<'a> {
    /// The body, by its name in [`Bodies`].
    pub body: u32,
    ends: Ends<'a>,
}

impl<'a> BodyMotion<'a> {
    /// The body `body` moves from `x0` to `x1`: whatever positions a step takes, one for each
    /// vertex of the body.
    pub fn new<A, B>(body: u32, x0: &'a A, x1: &'a B) -> Self
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        Self { body, ends: ends(x0, x1) }
    }
}

/// What is known of a step's positions from the call before it.
#[derive(Clone, Copy, Debug)]
pub struct Moved<'a> {
    /// Vertices with other positions, at either end, than in the call before; all others are the
    /// same, and do not move.
    pub runs: &'a [Range<u32>],
    /// The number of this call. The one before it has the number before.
    pub call: u64,
}

impl Moved<'_> {
    /// Whether it holds for an engine that completed call `last` as its last one: that before this
    /// call, or another part of this one.
    pub fn follows(&self, last: Option<u64>) -> bool {
        last.is_some_and(|last| last == self.call || last + 1 == self.call)
    }
}

/// Where all vertices are, and where those of moving bodies go.
#[derive(Debug, Default)]
pub struct Kept {
    /// `None`: nobody has said where vertices are.
    x: Option<Precision<Both<f32>, Both<f64>>>,
    gathered: Gathered,
    /// By the number of a body: its vertices in runs. Made when they are needed.
    runs: Option<Runs>,
    /// Names of the bodies that move in this call, sorted.
    names: Vec<u32>,
    /// What moved in the last call.
    last: Vec<Range<u32>>,
    /// What the next call finds in other places than the last one did.
    changed: Vec<Range<u32>>,
    calls: u64,
}

/// Positions at both ends; what does not move is equal in both.
#[derive(Debug, Default)]
struct Both<T> {
    ends: [Vec<[T; 3]>; 2],
    /// Positions before this call of what moves in it, in the order in which it was written.
    before: Vec<[T; 3]>,
}

/// Vertices of bodies.
#[derive(Debug)]
struct Runs {
    /// Where the runs of a body begin.
    first: Vec<u32>,
    runs: Vec<Range<u32>>,
}

impl Runs {
    fn new(bodies: &Bodies) -> Self {
        let numbers = bodies.numbers();
        let mut of_vertices: Vec<(u32, Range<u32>)> = Vec::new();
        for (v, &number) in numbers.iter().enumerate() {
            let v = v as u32;
            match of_vertices.last_mut() {
                Some((last, run)) if *last == number => run.end = v + 1,
                _ => of_vertices.push((number, v..v + 1)),
            }
        }
        // Stable: the runs of a body stay in the order of their vertices.
        of_vertices.sort_by_key(|run| run.0);
        let begins =
            |body: usize| of_vertices.partition_point(|run| (run.0 as usize) < body) as u32;
        let first = (0..=bodies.all().len()).map(begins).collect();
        Self { first, runs: of_vertices.into_iter().map(|run| run.1).collect() }
    }

    fn of(&self, number: usize) -> &[Range<u32>] {
        &self.runs[self.first[number] as usize..self.first[number + 1] as usize]
    }
}

impl Kept {
    /// Has all vertices stand at `x`.
    ///
    /// # Errors
    /// Those of [`Session::set_positions`](super::Session::set_positions).
    pub fn set(&mut self, mesh: &Mesh, x: Ends) -> Result<(), Error> {
        let given = super::given(mesh, &mut self.gathered, x)?;
        self.x = Some(match given {
            Precision::F32([x, _]) => Precision::F32(Both::at(x)),
            Precision::F64([x, _]) => Precision::F64(Both::at(x)),
        });
        self.last.clear();
        // No engine has seen the call before the next one.
        self.calls += 2;
        Ok(())
    }

    /// Forgets the vertices of bodies, and with `positions` where vertices are.
    pub fn forget(&mut self, positions: bool) {
        self.runs = None;
        if positions {
            self.x = None;
        }
        self.calls += 2;
    }

    /// Positions of a step in which these bodies move, and what is in other places than before.
    /// [`Kept::end`] must follow.
    ///
    /// # Errors
    /// What [`Session::step_bodies`](super::Session::step_bodies) says of bodies.
    pub fn begin(
        &mut self,
        bodies: Option<&Bodies>,
        motions: &[BodyMotion],
    ) -> Result<(Given<'_>, Moved<'_>), Error> {
        let Self { x, gathered, runs, names, last, changed, calls } = self;
        let x = x.as_mut().ok_or(Error::NoPositions)?;
        changed.clear();
        changed.append(last);
        match x {
            Precision::F32(x) => x.arrive(changed),
            Precision::F64(x) => x.arrive(changed),
        }
        *calls += 1;
        names.clear();
        names.extend(motions.iter().map(|motion| motion.body));
        names.sort_unstable();
        if let Some(twice) = names.windows(2).find(|two| two[0] == two[1]) {
            return Err(Error::RepeatedBody { body: twice[0] });
        }
        for motion in motions {
            let body = motion.body;
            let bodies = bodies.ok_or(Error::NoBody { body })?;
            let number = bodies.number(body).ok_or(Error::NoBody { body })?;
            let runs = runs.get_or_insert_with(|| Runs::new(bodies)).of(number);
            let to = gathered.slices(motion.ends)?;
            last.extend_from_slice(runs);
            match (&mut *x, to) {
                (Precision::F32(x), Precision::F32(to)) => x.go(body, runs, to, |p| p)?,
                (Precision::F64(x), Precision::F64(to)) => x.go(body, runs, to, |p| p)?,
                (Precision::F64(x), Precision::F32(to)) => {
                    x.go(body, runs, to, |p| p.map(f64::from))?
                }
                (Precision::F32(x), Precision::F64(_)) => {
                    x.stay(runs);
                    return Err(Error::MixedPrecision { body });
                }
            }
        }
        changed.extend_from_slice(last);
        let given = match x {
            Precision::F32(x) => Precision::F32(x.ends.each_ref().map(Vec::as_slice)),
            Precision::F64(x) => Precision::F64(x.ends.each_ref().map(Vec::as_slice)),
        };
        Ok((given, Moved { runs: changed, call: *calls }))
    }

    /// After a call: bodies have moved or, if it failed, have not.
    pub fn end(&mut self, failed: bool) {
        match &mut self.x {
            Some(Precision::F32(x)) => x.end(&self.last, failed),
            Some(Precision::F64(x)) => x.end(&self.last, failed),
            None => {}
        }
        if failed {
            // The next call begins with engines that have seen none.
            self.last.clear();
            self.calls += 2;
        }
    }
}

impl<T: Coordinate> Both<T> {
    fn at(x: &[[T; 3]]) -> Self {
        Self { ends: [x.to_vec(), x.to_vec()], before: Vec::new() }
    }

    /// What moved in the last call stands where it went.
    fn arrive(&mut self, runs: &[Range<u32>]) {
        let [x0, x1] = &mut self.ends;
        for run in runs {
            let run = run.start as usize..run.end as usize;
            x0[run.clone()].copy_from_slice(&x1[run]);
        }
    }

    /// Keeps where a body is.
    fn stay(&mut self, runs: &[Range<u32>]) {
        let [x0, _] = &self.ends;
        self.before.extend(runs.iter().flat_map(|run| &x0[run.start as usize..run.end as usize]));
    }

    /// Has a body move.
    fn go<U: Copy>(
        &mut self,
        body: u32,
        runs: &[Range<u32>],
        to: [&[[U; 3]]; 2],
        exact: impl Fn([U; 3]) -> [T; 3],
    ) -> Result<(), Error> {
        self.stay(runs);
        let expected = runs.iter().map(|run| run.len()).sum();
        for (time, (x, to)) in self.ends.iter_mut().zip(to).enumerate() {
            if to.len() != expected {
                let (time, found) = (time as u8, to.len());
                return Err(Error::BodyPositions { body, time, expected, found });
            }
            let mut to = to.iter();
            for run in runs {
                let slots = &mut x[run.start as usize..run.end as usize];
                slots.iter_mut().zip(&mut to).for_each(|(slot, &p)| *slot = exact(p));
            }
        }
        Ok(())
    }

    fn end(&mut self, runs: &[Range<u32>], failed: bool) {
        if failed {
            let mut rest = &self.before[..];
            for run in runs {
                let (positions, others) = rest.split_at(run.len());
                let run = run.start as usize..run.end as usize;
                self.ends.iter_mut().for_each(|x| x[run.clone()].copy_from_slice(positions));
                rest = others;
            }
        }
        self.before.clear();
    }
}
