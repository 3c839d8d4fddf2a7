//! Steps in which bodies move while all others stand where they stood.

use crate::memory::list;
use crate::mesh::{CcdPositions, Ends, ends};
use crate::results::{CcdHit, CcdReport};
use crate::session::{CcdSession, Inner, asked, asked_for};
use crate::status::{CcdStatus, Failure};
use ccd::BodyMotion;
use ccd::positions::Precision;
use std::ptr::null;

/// How one body moves in a step: positions of its vertices, in the order of their ids.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct CcdBodyMotion {
    /// The body.
    pub body: u32,
    /// Positions at the start of the step.
    pub x0: CcdPositions,
    /// Positions at its end.
    pub x1: CcdPositions,
}

/// From now on all vertices stand at `x`, until the calls below move bodies. Positions are copied.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_set_positions(
    session: *mut CcdSession,
    x: CcdPositions,
) -> CcdStatus {
    // SAFETY: the caller's pointers, by the header's first comment.
    unsafe {
        asked(session, |of| {
            match ends(&x, &x)? {
                Precision::F32([x, _]) => of.session.set_positions(&x)?,
                Precision::F64([x, _]) => of.session.set_positions(&x)?,
            }
            Ok(())
        })
    }
}

/// Every contact of a step in which these bodies move and all others stand where the last such call
/// left them, or ccd_session_set_positions: what ccd_session_step finds for the same positions. On
/// a CPU it costs what the bodies cost that are not fixed and do not sleep. `report`: as there.
///
/// Fails with CCD_STATUS_INVALID_INPUT before ccd_session_set_positions, for a body without a
/// vertex or with two motions, and for another number of positions than the body has vertices; then
/// all stand where they stood.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_step_bodies(
    session: *mut CcdSession,
    motions: *const CcdBodyMotion,
    motion_count: usize,
    report: *mut *const CcdReport,
) -> CcdStatus {
    let mut unwanted = null();
    let report = if report.is_null() { &mut unwanted } else { report };
    let output = (report, "report", null());
    // SAFETY: the caller's pointers, by the header's first comment.
    unsafe {
        asked_of_bodies(session, motions, motion_count, output, |of, motions| {
            of.session.step_bodies(motions)?;
            Ok(of.results.report(of.session.report()))
        })
    }
}

/// The earliest time of impact of a step in which these bodies move: what ccd_session_earliest_toi
/// is to ccd_session_step. The bodies stand at their `x1` afterwards.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_earliest_toi_of_bodies(
    session: *mut CcdSession,
    motions: *const CcdBodyMotion,
    motion_count: usize,
    toi: *mut f64,
) -> CcdStatus {
    // SAFETY: the caller's pointers, by the header's first comment.
    unsafe {
        asked_of_bodies(session, motions, motion_count, (toi, "toi", 0.0), |of, motions| {
            Ok(of.session.earliest_toi_of_bodies(motions)?.unwrap_or(f64::INFINITY))
        })
    }
}

/// The first contact of a step in which these bodies move; NULL if the whole step is free. All else
/// as ccd_session_first_contact and ccd_session_step_bodies.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_first_contact_of_bodies(
    session: *mut CcdSession,
    motions: *const CcdBodyMotion,
    motion_count: usize,
    hit: *mut *const CcdHit,
) -> CcdStatus {
    // SAFETY: the caller's pointers, by the header's first comment.
    unsafe {
        asked_of_bodies(session, motions, motion_count, (hit, "hit", null()), |of, motions| {
            let first = of.session.first_contact_of_bodies(motions)?;
            Ok(of.results.hit(first))
        })
    }
}

/// Sets whether a body is fixed from now on: 1 or 0. The session must have bodies.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_set_fixed(
    session: *mut CcdSession,
    body: u32,
    fixed: u32,
) -> CcdStatus {
    // SAFETY: the caller's pointer, by the header's first comment.
    unsafe { asked(session, |of| Ok(of.session.set_fixed(body, fixed != 0)?)) }
}

/// Sets whether a body sleeps from now on: 1 or 0. The session must have bodies.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_set_sleeping(
    session: *mut CcdSession,
    body: u32,
    sleeping: u32,
) -> CcdStatus {
    // SAFETY: the caller's pointer, by the header's first comment.
    unsafe { asked(session, |of| Ok(of.session.set_sleeping(body, sleeping != 0)?)) }
}

/// Asks something of a step in which bodies move; before, the output is nothing.
///
/// # Safety
/// The caller's pointers, by the header's first comment.
unsafe fn asked_of_bodies<T>(
    session: *mut CcdSession,
    motions: *const CcdBodyMotion,
    motion_count: usize,
    (output, name, nothing): (*mut T, &str, T),
    ask: impl FnOnce(&mut Inner, &[BodyMotion]) -> Result<T, Failure>,
) -> CcdStatus {
    // SAFETY: the caller's duty.
    unsafe {
        asked_for(session, (output, name, nothing), |of| {
            let motions = list(motions, motion_count, "motions")?;
            let x: Vec<Ends> =
                motions.iter().map(|of| ends(&of.x0, &of.x1)).collect::<Result<_, _>>()?;
            let motions = motions.iter().zip(&x).map(|(of, x)| match x {
                Precision::F32([x0, x1]) => BodyMotion::new(of.body, x0, x1),
                Precision::F64([x0, x1]) => BodyMotion::new(of.body, x0, x1),
            });
            let motions: Vec<BodyMotion> = motions.collect();
            ask(of, &motions)
        })
    }
}
