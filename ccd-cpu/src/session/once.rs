//! One step with no session to keep, and what a session lists of one.

use super::Session;
use crate::broad_phase::pair_list::Pairs;
use ccd_core::Error;
use ccd_core::layout::Pair;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use ccd_core::model::positions::AsPositions;
use ccd_core::model::report::Report;

/// Candidates of a step; see [`Session::candidates`].
///
/// ```
/// use ccd_core::model::{mesh::Mesh, options::Options};
/// use ccd_cpu::Session;
///
/// let mut session = Session::new(Mesh::new(4, &[[0, 1, 2]])?, Options::default())?;
/// let x = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.2, 0.0, 0.2]];
/// let candidates = session.candidates(&x, &x)?;
/// assert_eq!((candidates.vf.len(), candidates.ee.len()), (1, 0));
/// # Ok::<(), ccd_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Candidates<'a> {
    /// Vertex, face.
    pub vf: Pairs<'a>,
    /// Two edges, the lesser id first.
    pub ee: Pairs<'a>,
    /// A vertex of no edge, an edge of no face.
    pub ve: &'a [Pair],
    /// Two vertices of no edge, the lesser id first.
    pub vv: &'a [Pair],
}

/// Every contact of one step, with no session to keep: see [`Session::step`].
///
/// ```
/// use ccd_core::model::{mesh::Mesh, options::Options};
///
/// let mesh = Mesh::new(4, &[[0, 1, 2]])?;
/// let before = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.2, 1.0, 0.2]];
/// let mut after = before;
/// after[3][1] = -1.0;
/// let report = ccd_cpu::step(&mesh, &before, &after, &Options::default())?;
/// assert_eq!(report.contacts.len(), 1);
/// assert_eq!(report.toi, ccd_cpu::earliest_toi(&mesh, &before, &after, &Options::default())?);
/// # Ok::<(), ccd_core::Error>(())
/// ```
///
/// # Errors
/// Those of [`Session::new`] and of [`Session::step`].
pub fn step<A, B>(mesh: &Mesh, x0: &A, x1: &B, options: &Options) -> Result<Report, Error>
where
    A: AsPositions + ?Sized,
    B: AsPositions<Scalar = A::Scalar> + ?Sized,
{
    let mut session = Session::new(mesh, options.clone())?;
    session.step(x0, x1)?;
    Ok(session.into_report())
}

/// The earliest time of impact of one step: see [`Session::earliest_toi`].
///
/// # Errors
/// Those of [`Session::new`] and of [`Session::step`].
pub fn earliest_toi<A, B>(
    mesh: &Mesh,
    x0: &A,
    x1: &B,
    options: &Options,
) -> Result<Option<f64>, Error>
where
    A: AsPositions + ?Sized,
    B: AsPositions<Scalar = A::Scalar> + ?Sized,
{
    Session::new(mesh, options.clone())?.earliest_toi(x0, x1)
}
