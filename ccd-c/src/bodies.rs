//! Which pairs of bodies a session looks at.

use crate::memory::{list, lock, shared, write};
use crate::results::{CcdKind, CcdPair};
use crate::status::{CcdStatus, Failure, guard, guard_value};
use ccd::{Bodies, Groups, Kind};
use std::ptr::null_mut;
use std::sync::Mutex;

/// The body of each vertex, and rules of which pairs of bodies are looked at. A session copies
/// them.
pub struct CcdBodies {
    bodies: Mutex<Bodies>,
}

/// Makes bodies: `body_of_vertex` has the body of each vertex, by any number. They move, and touch
/// themselves and each other. A session refuses another number of vertices than its mesh has, a
/// triangle or an edge that joins two bodies, and a rule for a body without a vertex, with
/// CCD_STATUS_INVALID_INPUT.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_bodies_create(
    body_of_vertex: *const u32,
    vertex_count: usize,
    bodies: *mut *mut CcdBodies,
) -> CcdStatus {
    guard(|| {
        // SAFETY: the caller's pointers, by the header's first comment.
        unsafe {
            write(bodies, "bodies", null_mut())?;
            let of_vertex = list(body_of_vertex, vertex_count, "body_of_vertex")?;
            let new = CcdBodies { bodies: Mutex::new(Bodies::new(of_vertex)) };
            write(bodies, "bodies", Box::into_raw(Box::new(new)))
        }
    })
}

/// Destroys bodies; NULL is ignored. Sessions that were given them go on.
#[unsafe(no_mangle)]
pub extern "C" fn ccd_bodies_destroy(bodies: Option<Box<CcdBodies>>) {
    guard_value((), || drop(bodies));
}

/// Sets whether a body is fixed: 1 or 0. Two bodies that stand still are no pair, and a step in
/// which a fixed one moves is refused.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_bodies_set_fixed(
    bodies: *mut CcdBodies,
    body: u32,
    fixed: u32,
) -> CcdStatus {
    // SAFETY: the caller's pointer, by the header's first comment.
    unsafe { change(bodies, |of| of.with_fixed(body, fixed != 0)) }
}

/// Sets whether a body sleeps: 1 or 0. While it sleeps it is as one that is fixed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_bodies_set_sleeping(
    bodies: *mut CcdBodies,
    body: u32,
    sleeping: u32,
) -> CcdStatus {
    // SAFETY: the caller's pointer, by the header's first comment.
    unsafe { change(bodies, |of| of.with_sleeping(body, sleeping != 0)) }
}

/// Sets whether a step in which a fixed or sleeping body moves is accepted: 1 or 0, at first 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_bodies_set_fixed_motion(
    bodies: *mut CcdBodies,
    may_move: u32,
) -> CcdStatus {
    // SAFETY: the caller's pointer, by the header's first comment.
    unsafe { change(bodies, |of| of.with_fixed_motion(may_move != 0)) }
}

/// Sets whether pairs of features within a body are looked at, for all bodies: 1 or 0, at first 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_bodies_set_self_contacts(
    bodies: *mut CcdBodies,
    self_contact: u32,
) -> CcdStatus {
    // SAFETY: the caller's pointer, by the header's first comment.
    unsafe { change(bodies, |of| of.with_self_contacts(self_contact != 0)) }
}

/// Sets whether pairs of features within one body are looked at: 1 or 0, at first 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_bodies_set_self_contact(
    bodies: *mut CcdBodies,
    body: u32,
    self_contact: u32,
) -> CcdStatus {
    // SAFETY: the caller's pointer, by the header's first comment.
    unsafe { change(bodies, |of| of.with_self_contact(body, self_contact != 0)) }
}

/// Sets the groups of a body, a bit a group: those that it belongs to, and those whose members it
/// may touch. Two bodies are looked at if each belongs to a group that the other may touch. At
/// first all bits are set.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_bodies_set_groups(
    bodies: *mut CcdBodies,
    body: u32,
    memberships: u32,
    filter: u32,
) -> CcdStatus {
    // SAFETY: the caller's pointer, by the header's first comment.
    unsafe { change(bodies, |of| of.with_groups(body, Groups { memberships, filter })) }
}

/// Sets the world of a body, below 65536, at first 0: bodies of two worlds are never looked at.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_bodies_set_world(
    bodies: *mut CcdBodies,
    body: u32,
    world: u32,
) -> CcdStatus {
    // SAFETY: the caller's pointer, by the header's first comment.
    unsafe { change(bodies, |of| of.with_world(body, world)) }
}

/// Excludes pairs of bodies, besides those before; a body with itself: its self-contact.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_bodies_exclude_bodies(
    bodies: *mut CcdBodies,
    pairs: *const CcdPair,
    count: usize,
) -> CcdStatus {
    // SAFETY: the caller's pointers, by the header's first comment.
    unsafe { exclude(bodies, pairs, count, |of, pairs| Ok(of.with_excluded_bodies(pairs))) }
}

/// Excludes pairs of features by their ids in the mesh, besides those before. `kind`: a CcdKind.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_bodies_exclude_features(
    bodies: *mut CcdBodies,
    kind: u32,
    pairs: *const CcdPair,
    count: usize,
) -> CcdStatus {
    let change = |of: Bodies, pairs: &[[u32; 2]]| {
        let named = Kind::ALL.into_iter().find(|&of| CcdKind::from(of) as u32 == kind);
        let why = || Failure::argument(format!("kind is {kind}; it must be a CcdKind"));
        Ok(of.with_excluded_features(named.ok_or_else(why)?, pairs))
    };
    // SAFETY: the caller's pointers, by the header's first comment.
    unsafe { exclude(bodies, pairs, count, change) }
}

/// A copy for a session; `None` of NULL.
///
/// # Safety
/// NULL, or bodies that live for the call.
pub(crate) unsafe fn copy(bodies: *const CcdBodies) -> Result<Option<Bodies>, Failure> {
    if bodies.is_null() {
        return Ok(None);
    }
    // SAFETY: the caller's duty.
    let of = unsafe { shared(bodies, "bodies")? };
    Ok(Some(lock(&of.bodies, "bodies")?.clone()))
}

/// # Safety
/// NULL, or bodies that live for the call.
unsafe fn change(bodies: *mut CcdBodies, change: impl FnOnce(Bodies) -> Bodies) -> CcdStatus {
    guard(|| {
        // SAFETY: the caller's duty.
        let of = unsafe { shared(bodies, "bodies")? };
        let mut of = lock(&of.bodies, "bodies")?;
        let old = std::mem::replace(&mut *of, Bodies::new(&[]));
        *of = change(old);
        Ok(())
    })
}

/// # Safety
/// NULL, or bodies that live for the call; `count` pairs.
unsafe fn exclude(
    bodies: *mut CcdBodies,
    pairs: *const CcdPair,
    count: usize,
    change: impl FnOnce(Bodies, &[[u32; 2]]) -> Result<Bodies, Failure>,
) -> CcdStatus {
    guard(|| {
        // SAFETY: the caller's duty.
        let (of, pairs) = unsafe { (shared(bodies, "bodies")?, list(pairs, count, "pairs")?) };
        let pairs: Vec<[u32; 2]> = pairs.iter().map(|pair| [pair.a, pair.b]).collect();
        let mut of = lock(&of.bodies, "bodies")?;
        let changed = change(of.clone(), &pairs)?;
        *of = changed;
        Ok(())
    })
}
