//! One step with no session to keep.

use super::Session;
use ccd_core::Error;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use ccd_core::model::positions::AsPositions;
use ccd_core::model::report::Report;

/// Every contact of one step, with no session to keep: see [`Session::step`].
///
/// ```
/// use ccd::{Mesh, Options};
///
/// let mesh = Mesh::new(4, &[[0, 1, 2]])?;
/// let before = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.2, 1.0, 0.2]];
/// let mut after = before;
/// after[3][1] = -1.0;
/// let report = ccd::step(&mesh, &before, &after, &Options::default())?;
/// assert_eq!(report.contacts.len(), 1);
/// assert_eq!(report.toi, ccd::earliest_toi(&mesh, &before, &after, &Options::default())?);
/// # Ok::<(), ccd::Error>(())
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
    Ok(std::mem::take(&mut session.state.report))
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
