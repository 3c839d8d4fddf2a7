//! A mesh stepped frame by frame.

use crate::bodies::{self, CcdBodies};
use crate::memory::{lock, shared, write};
use crate::mesh::{CcdMesh, CcdPositions, Ends, ends, with_ends};
use crate::options::{self, CcdOptions};
use crate::results::{CcdCandidates, CcdGeometry, CcdHit, CcdPairs, CcdReport, Results};
use crate::status::{CcdStatus, Failure, guard, guard_value};
use ccd::CancelToken;
use ccd::any::Session;
use ccd::positions::AsPositions;
use std::ffi::{CString, c_char};
use std::ptr::{null, null_mut};
use std::sync::{Mutex, PoisonError};

/// Continuous collision detection of one mesh over many steps: keep it from frame to frame.
pub struct CcdSession {
    inner: Mutex<Inner>,
    /// The token of the session, for threads that do not have the session.
    cancel: Mutex<CancelToken>,
}

pub(crate) struct Inner {
    pub session: Session,
    pub results: Results,
    place: CString,
}

/// A session is used by one thread after another.
const _: fn() = || {
    fn can_be_sent<T: Send>() {}
    can_be_sent::<Session>();
};

/// Makes a session for a mesh. `bodies`: NULL if all pairs of features are looked at. `options`:
/// NULL for the defaults.
///
/// Fails with CCD_STATUS_NO_GPU for CCD_BACKEND_GPU where there is none, and for an `adapter` that
/// is not there; with CCD_STATUS_INVALID_INPUT for options and bodies that do not fit.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_create(
    mesh: *const CcdMesh,
    bodies: *const CcdBodies,
    options: *const CcdOptions,
    session: *mut *mut CcdSession,
) -> CcdStatus {
    guard(|| {
        // SAFETY: the caller's pointers, by the header's first comment.
        unsafe {
            write(session, "session", null_mut())?;
            let mesh = &shared(mesh, "mesh")?.mesh;
            let (options, choice) = options::read(options, mesh.edges().len())?;
            let options = options.with_bodies(bodies::copy(bodies)?);
            let mut new = Session::new(&choice, mesh.clone(), options)?;
            let cancel = CancelToken::new();
            new.set_cancel_token(cancel.clone());
            let inner = Inner { session: new, results: Results::new(), place: CString::default() };
            let new = CcdSession { inner: Mutex::new(inner), cancel: Mutex::new(cancel) };
            write(session, "session", Box::into_raw(Box::new(new)))
        }
    })
}

/// Destroys a session; NULL is ignored.
#[unsafe(no_mangle)]
pub extern "C" fn ccd_session_destroy(session: Option<Box<CcdSession>>) {
    guard_value((), || drop(session));
}

/// Every contact while vertices move on straight lines from `x0` to `x1`. `report` belongs to the
/// session, until its next call; NULL if it is not wanted.
///
/// Fails with CCD_STATUS_INVALID_INPUT for another number of positions than the mesh has vertices,
/// for a coordinate that is NaN, infinite or above 1e100, and for a fixed body that moves. The
/// session stays usable after every failure but CCD_STATUS_PANICKED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_step(
    session: *mut CcdSession,
    x0: CcdPositions,
    x1: CcdPositions,
    report: *mut *const CcdReport,
) -> CcdStatus {
    // SAFETY: the caller's pointers, by the header's first comment.
    unsafe { ccd_session_step_window(session, x0, x1, 0.0, 1.0, report) }
}

/// Every contact that exists at some time from `t0` to `t1`, with `0 <= t0 <= t1 <= 1`; times of
/// impact are parts of the whole step. All else as ccd_session_step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_step_window(
    session: *mut CcdSession,
    x0: CcdPositions,
    x1: CcdPositions,
    t0: f64,
    t1: f64,
    report: *mut *const CcdReport,
) -> CcdStatus {
    // SAFETY: the caller's pointers, by the header's first comment.
    unsafe {
        optional(report, |report| {
            asked_of_step(session, [x0, x1], (report, "report", null()), |of, x| {
                with_ends!(x, |x0, x1| of.session.step_window(&x0, &x1, [t0, t1])?);
                Ok(of.results.report(of.session.report()))
            })
        })
    }
}

/// The earliest time of impact of the step, without the list of contacts: cheaper than
/// ccd_session_step. INFINITY if the whole step is free. Not later than the earliest contact.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_earliest_toi(
    session: *mut CcdSession,
    x0: CcdPositions,
    x1: CcdPositions,
    toi: *mut f64,
) -> CcdStatus {
    // SAFETY: the caller's pointers, by the header's first comment.
    unsafe {
        asked_of_step(session, [x0, x1], (toi, "toi", 0.0), |of, x| {
            let toi = with_ends!(x, |x0, x1| of.session.earliest_toi(&x0, &x1)?);
            Ok(toi.unwrap_or(f64::INFINITY))
        })
    }
}

/// How much of the step is certainly free of contact: 1 if all of it is, else the earliest time of
/// impact, which may be 0. At that time itself there may be contact.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_collision_free_stepsize(
    session: *mut CcdSession,
    x0: CcdPositions,
    x1: CcdPositions,
    stepsize: *mut f64,
) -> CcdStatus {
    // SAFETY: the caller's pointers, by the header's first comment.
    unsafe {
        asked_of_step(session, [x0, x1], (stepsize, "stepsize", 0.0), |of, x| {
            Ok(with_ends!(x, |x0, x1| of.session.collision_free_step_size(&x0, &x1)?))
        })
    }
}

/// The first contact of the step with point, normal and weights; NULL if the whole step is free.
/// `hit` belongs to the session, until its next call. Of contacts with the same time it is the
/// first by kind and ids. Its `approach` is CCD_APPROACH_UNKNOWN.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_first_contact(
    session: *mut CcdSession,
    x0: CcdPositions,
    x1: CcdPositions,
    hit: *mut *const CcdHit,
) -> CcdStatus {
    // SAFETY: the caller's pointers, by the header's first comment.
    unsafe {
        asked_of_step(session, [x0, x1], (hit, "hit", null()), |of, x| {
            let first = with_ends!(x, |x0, x1| of.session.first_contact(&x0, &x1)?);
            Ok(of.results.hit(first))
        })
    }
}

/// Point, normal and weights of every contact of the session's last report, in its order: those of
/// a step. After ccd_session_earliest_toi there are none; after ccd_session_first_contact none on a
/// CPU, those that it looked at on a GPU. `x0`, `x1`: the positions of that step, which are not
/// checked again. Does not end the life of the report.
///
/// `geometry` belongs to the session, until its next call; `count`: number of contacts.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_contact_geometry(
    session: *mut CcdSession,
    x0: CcdPositions,
    x1: CcdPositions,
    geometry: *mut *const CcdGeometry,
    count: *mut usize,
) -> CcdStatus {
    // SAFETY: the caller's pointers, by the header's first comment.
    unsafe {
        let outputs = guard(|| {
            write(geometry, "geometry", null())?;
            write(count, "count", 0)
        });
        if outputs != CcdStatus::Ok {
            return outputs;
        }
        let mut found = 0;
        let done = asked_of_step(session, [x0, x1], (geometry, "geometry", null()), |of, x| {
            let Inner { session, results, .. } = of;
            let report = session.report();
            // A report of nothing, as after a failure, has no mesh.
            let is_empty = report.contacts.is_empty();
            let mesh = if is_empty { session.mesh() } else { report.mesh() };
            let (data, n) = with_ends!(x, |x0, x1| {
                for (time, x) in [(0, &x0), (1, &x1)] {
                    let (expected, found) = (mesh.n_vertices(), x.as_positions().len());
                    if expected != found {
                        return Err(ccd::Error::VertexCount { time, expected, found }.into());
                    }
                }
                let contacts = report.contacts.iter();
                results.geometry(contacts.map(|contact| contact.geometry(mesh, &x0, &x1)))
            });
            found = n;
            Ok(data)
        });
        if done == CcdStatus::Ok { guard(|| write(count, "count", found)) } else { done }
    }
}

/// All candidates of the step. `candidates` belongs to the session, until its next call. A step
/// does not need this.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_candidates(
    session: *mut CcdSession,
    x0: CcdPositions,
    x1: CcdPositions,
    candidates: *mut *const CcdCandidates,
) -> CcdStatus {
    // SAFETY: the caller's pointers, by the header's first comment.
    unsafe {
        asked_of_step(session, [x0, x1], (candidates, "candidates", null()), |of, x| {
            let Inner { session, results, .. } = of;
            let found = with_ends!(x, |x0, x1| session.candidates(&x0, &x1)?);
            Ok(results.candidates(found))
        })
    }
}

/// Edges (a) and triangles (b) that have a point in common at positions `x`, but no vertex: where
/// the mesh goes through itself. Exact, on the CPU, where coordinates are zero or from 2^-200 to
/// 2^200; beyond, all that are not certainly apart. `pairs` belong to the session, until its next
/// call.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_intersections(
    session: *mut CcdSession,
    x: CcdPositions,
    pairs: *mut CcdPairs,
) -> CcdStatus {
    // SAFETY: the caller's pointers, by the header's first comment.
    unsafe {
        asked_of_step(session, [x, x], (pairs, "pairs", CcdPairs::EMPTY), |of, x| {
            let found = with_ends!(x, |x, _x1| of.session.intersections(&x)?);
            Ok(of.results.pairs(found.iter().map(|at| [at.edge, at.face])))
        })
    }
}

/// Sets the mesh of the next steps, with these bodies, or none (NULL): ids of features are new.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_set_mesh(
    session: *mut CcdSession,
    mesh: *const CcdMesh,
    bodies: *const CcdBodies,
) -> CcdStatus {
    // SAFETY: the caller's pointers, by the header's first comment.
    unsafe {
        asked(session, |of| {
            let (mesh, bodies) = (shared(mesh, "mesh")?, bodies::copy(bodies)?);
            Ok(of.session.set_mesh_and_bodies(mesh.mesh.clone(), bodies)?)
        })
    }
}

/// Sets the bodies of the next steps, or none (NULL).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_set_bodies(
    session: *mut CcdSession,
    bodies: *const CcdBodies,
) -> CcdStatus {
    // SAFETY: the caller's pointers, by the header's first comment.
    unsafe { asked(session, |of| Ok(of.session.set_bodies(bodies::copy(bodies)?)?)) }
}

/// Sets the minimum distance of the next steps.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_set_min_distance(
    session: *mut CcdSession,
    min_distance: f64,
) -> CcdStatus {
    // SAFETY: the caller's pointer, by the header's first comment.
    unsafe { asked(session, |of| Ok(of.session.set_min_distance(min_distance)?)) }
}

/// Where steps run: "2 threads", or the name of the GPU. `place` belongs to the session, until its
/// next call.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_place(
    session: *mut CcdSession,
    place: *mut *const c_char,
) -> CcdStatus {
    // SAFETY: the caller's pointers, by the header's first comment.
    unsafe {
        asked_for(session, (place, "place", null()), |of| {
            of.place = CString::new(of.session.place().to_string()).unwrap_or_default();
            Ok(of.place.as_ptr())
        })
    }
}

/// Ends the step, search or list that runs, and all later ones, with CCD_STATUS_CANCELLED, until
/// ccd_session_resume. For any thread, at any time before the session is destroyed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_cancel(session: *mut CcdSession) -> CcdStatus {
    guard(|| {
        // SAFETY: the caller's pointer, by the header's first comment.
        let of = unsafe { shared(session, "session")? };
        of.cancel.lock().unwrap_or_else(PoisonError::into_inner).cancel();
        Ok(())
    })
}

/// Undoes ccd_session_cancel: later calls run to their ends.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_session_resume(session: *mut CcdSession) -> CcdStatus {
    guard(|| {
        // SAFETY: the caller's pointer, by the header's first comment.
        let of = unsafe { shared(session, "session")? };
        let mut inner = lock(&of.inner, "session")?;
        let token = CancelToken::new();
        *of.cancel.lock().unwrap_or_else(PoisonError::into_inner) = token.clone();
        inner.session.set_cancel_token(token);
        Ok(())
    })
}

/// Asks something of a session that nobody else uses.
///
/// # Safety
/// NULL, or a session that lives for the call.
pub(crate) unsafe fn asked(
    session: *mut CcdSession,
    ask: impl FnOnce(&mut Inner) -> Result<(), Failure>,
) -> CcdStatus {
    guard(|| {
        // SAFETY: the caller's duty.
        let of = unsafe { shared(session, "session")? };
        ask(&mut *lock(&of.inner, "session")?)
    })
}

/// Asks something of a step, and writes the answer to an output, with its name; before, nothing.
///
/// # Safety
/// The caller's pointers, by the header's first comment.
unsafe fn asked_of_step<T>(
    session: *mut CcdSession,
    [x0, x1]: [CcdPositions; 2],
    (output, name, nothing): (*mut T, &str, T),
    ask: impl FnOnce(&mut Inner, Ends) -> Result<T, Failure>,
) -> CcdStatus {
    // SAFETY: the caller's duty.
    unsafe { asked_for(session, (output, name, nothing), |of| ask(of, ends(&x0, &x1)?)) }
}

/// Asks something, and writes the answer to an output, with its name; before anything can fail,
/// nothing.
///
/// # Safety
/// The caller's pointers, by the header's first comment.
pub(crate) unsafe fn asked_for<T>(
    session: *mut CcdSession,
    (output, name, nothing): (*mut T, &str, T),
    ask: impl FnOnce(&mut Inner) -> Result<T, Failure>,
) -> CcdStatus {
    guard(|| {
        // SAFETY: the caller's duty.
        unsafe {
            write(output, name, nothing)?;
            let of = shared(session, "session")?;
            let answer = ask(&mut *lock(&of.inner, "session")?)?;
            write(output, name, answer)
        }
    })
}

/// A call whose output may be NULL.
///
/// # Safety
/// NULL, or valid for a write.
unsafe fn optional<T>(
    output: *mut *const T,
    call: impl FnOnce(*mut *const T) -> CcdStatus,
) -> CcdStatus {
    let mut unwanted = null();
    call(if output.is_null() { &mut unwanted } else { output })
}
