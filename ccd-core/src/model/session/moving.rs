//! Positions that a session keeps, so that a step is told only those of bodies that move.

use super::both_ends::{BothEnds, Rigids, Way};
use super::runs::RunsOfBodies;
use crate::model::bodies::Bodies;
use crate::model::error::Error;
use crate::model::mesh::Mesh;
use crate::model::positions::{AsPositions, Ends, Gathered, Matrix, Pose, ends};
use crate::model::precision::{Coordinate, Erased, Given, Precision};
use alloc::vec::Vec;
use core::ops::Range;

/// How one body moves in a step: by the positions of its vertices at both ends, in the order of
/// their ids, or by its poses.
///
/// ```
/// use ccd::{BodyMotion, Posed};
///
/// let crate_at_rest = [[0.0f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// let before = [0, 1, 2, 3].map(|k| [0, 1, 2, 3].map(|i| (i == k) as u8 as f32));
/// let mut after = before;
/// after[3][1] = -0.5;
/// // If the session was told by `set_positions` that the body is `crate_at_rest`:
/// let motion = BodyMotion::posed(3, &before, &after);
/// // The same positions, whatever it was told.
/// let x0 = Posed::one(&crate_at_rest, &before);
/// let x1 = Posed::one(&crate_at_rest, &after);
/// assert_eq!(BodyMotion::new(3, &x0, &x1).body, motion.body);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct BodyMotion<'a> {
    /// The body, by its name in [`Bodies`].
    pub body: u32,
    to: To<'a>,
}

#[derive(Clone, Copy, Debug)]
#[allow(clippy::large_enum_variant, reason = "one a body and call; a `Box` would allocate")]
enum To<'a> {
    Ends(Ends<'a>),
    Poses(Poses),
}

/// The poses of a body at both ends of a step.
type Poses = Precision<[Pose<f32>; 2], [Pose<f64>; 2]>;

impl Erased for Poses {
    type Of<T: 'static> = [Pose<T>; 2];
}

impl<'a> BodyMotion<'a> {
    /// The body `body` moves from `x0` to `x1`: whatever positions a step takes, one for each
    /// vertex of the body.
    pub fn new<A, B>(body: u32, x0: &'a A, x1: &'a B) -> Self
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        Self { body, to: To::Ends(ends(x0, x1)) }
    }

    /// The body `body` moves rigidly: its vertices go from `pose0` to `pose1` times their positions
    /// of [`Session::set_positions`](super::Session::set_positions), as
    /// [`Posed`](crate::model::positions::Posed) says. Poses in `f32` fit positions in `f64` too,
    /// which are computed in `f64` then.
    ///
    /// A CPU keeps the trees of such a body and moves their boxes, see
    /// [`Session::step_bodies`](super::Session::step_bodies).
    pub fn posed<M: Matrix>(body: u32, pose0: &M, pose1: &M) -> Self {
        let poses = [pose0, pose1].map(|pose| M::cast(core::slice::from_ref(pose))[0]);
        Self { body, to: To::Poses(M::Scalar::erase::<Poses>(poses)) }
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
    /// What moves rigidly, in the precision of the step's positions.
    pub rigids: Precision<Rigids<'a, f32>, Rigids<'a, f64>>,
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
    x: Option<Precision<BothEnds<f32>, BothEnds<f64>>>,
    gathered: Gathered,
    /// By the number of a body: its vertices in runs. Made when they are needed.
    runs: Option<RunsOfBodies>,
    /// Names of the bodies that move in this call, sorted.
    names: Vec<u32>,
    /// What moved in the last call.
    last: Vec<Range<u32>>,
    /// What the next call finds in other places than the last one did.
    changed: Vec<Range<u32>>,
    calls: u64,
    version: u64,
    placed: u64,
}

impl Kept {
    /// Has all vertices stand at `x`.
    ///
    /// # Errors
    /// Those of [`Session::set_positions`](super::Session::set_positions).
    pub fn set(&mut self, mesh: &Mesh, x: Ends) -> Result<(), Error> {
        let given = given(mesh, &mut self.gathered, x)?;
        self.x = Some(match given {
            Precision::F32([x, _]) => Precision::F32(BothEnds::at(x)),
            Precision::F64([x, _]) => Precision::F64(BothEnds::at(x)),
        });
        self.version += 1;
        self.placed = self.version;
        self.last.clear();
        // No engine has seen the call before the next one.
        self.calls += 2;
        Ok(())
    }

    /// Forgets the vertices of bodies, and with `positions` where vertices are.
    pub fn forget(&mut self, positions: bool) {
        self.runs = None;
        match &mut self.x {
            Some(Precision::F32(x)) => x.forget_rigids(),
            Some(Precision::F64(x)) => x.forget_rigids(),
            None => {}
        }
        if positions {
            self.x = None;
        }
        self.calls += 2;
        self.version += 1;
        self.placed = self.version;
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
        let Self { x, gathered, runs, names, last, changed, calls, version, placed } = self;
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
            let runs = runs.get_or_insert_with(|| vertices_of(bodies)).of(number);
            let way = match motion.to {
                To::Poses(Precision::F32(poses)) => Precision::F32(Way::Poses(poses)),
                To::Poses(Precision::F64(poses)) => Precision::F64(Way::Poses(poses)),
                To::Ends(ends) => match gathered.slices(ends)? {
                    Precision::F32(x) => Precision::F32(Way::Ends(x)),
                    Precision::F64(x) => Precision::F64(Way::Ends(x)),
                },
            };
            last.extend_from_slice(runs);
            let of = (body, number, runs);
            match (&mut *x, way) {
                (Precision::F32(x), Precision::F32(way)) => x.go(of, way, |c| c, version)?,
                (Precision::F64(x), Precision::F64(way)) => x.go(of, way, |c| c, version)?,
                (Precision::F64(x), Precision::F32(way)) => x.go(of, way, f64::from, version)?,
                (Precision::F32(x), Precision::F64(_)) => {
                    x.stay(runs);
                    return Err(Error::MixedPrecision { body });
                }
            }
        }
        changed.extend_from_slice(last);
        let version = [*version, *placed];
        let (given, rigids) = match x {
            Precision::F32(x) => (Precision::F32(x.ends()), Precision::F32(x.rigids(version))),
            Precision::F64(x) => (Precision::F64(x.ends()), Precision::F64(x.rigids(version))),
        };
        Ok((given, Moved { runs: changed, call: *calls, rigids }))
    }

    /// After a call: bodies have moved or, if it failed, have not.
    pub fn end(&mut self, failed: bool) {
        match &mut self.x {
            Some(Precision::F32(x)) => x.end(&self.last, failed, &mut self.version),
            Some(Precision::F64(x)) => x.end(&self.last, failed, &mut self.version),
            None => {}
        }
        if failed {
            // The next call begins with engines that have seen none.
            self.last.clear();
            self.calls += 2;
        }
    }
}

fn vertices_of(bodies: &Bodies) -> RunsOfBodies {
    RunsOfBodies::new((0..).zip(bodies.numbers()).map(|(v, &number)| (number, v)))
}

/// Positions as slices, one position for every vertex at both ends of a step.
///
/// # Errors
/// What [`Gathered::slices`] and [`Mesh::check_positions`] say.
#[inline(never)]
pub fn given<'a>(
    mesh: &Mesh,
    gathered: &'a mut Gathered,
    ends: Ends<'a>,
) -> Result<Given<'a>, Error> {
    let given = gathered.slices(ends)?;
    match given {
        Precision::F32([x0, x1]) => mesh.check_positions(x0, x1)?,
        Precision::F64([x0, x1]) => mesh.check_positions(x0, x1)?,
    }
    Ok(given)
}
