//! Map: the keys by which contacts are sorted into their canonical order, in two sorts: by `b`,
//! then, stable, by kind and `a`.

use crate::kernel::memory::at;
use crate::layout::{ContactSort, LIST_HEADER, Params, TOUCH_WORDS};

/// The key of contact `i` of a list in one of two sorts. Past the end of the list: the greatest, so
/// such entries stay last.
///
/// Vertices come before edges, so kind and `a` are one number below the number of both.
#[inline(always)]
pub fn key(i: u32, contacts: &[u32], params: &Params<ContactSort>) -> u32 {
    if i >= at(contacts, 0).min(params.dispatch.capacity_in) {
        return u32::MAX;
    }
    let first = LIST_HEADER + TOUCH_WORDS * i as usize;
    if params.args.pass == 0 {
        at(contacts, first + 3)
    } else {
        at(contacts, first) * params.frame.count[0] + at(contacts, first + 2)
    }
}
