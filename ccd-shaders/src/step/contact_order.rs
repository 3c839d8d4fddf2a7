//! Contacts into their canonical order; the sorts between are those of `sort.rs`.

use crate::entry::kernel;
use crate::workgroup::length;
use ccd_core::backend::kernel::contact_order;
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::layout::{LIST_HEADER, TOUCH_WORDS};

kernel! {
    /// Thread `i` writes the key of the contact that is `i`-th so far; in the first of two sorts
    /// that is the one of number `i`.
    contact_keys[256](t; params: ContactSort;; contacts: [u32], mut keys: [u32], mut order: [u32]) {
        let i = t.i;
        if i < params.dispatch.n {
            let mut contact = i;
            if params.args.pass == 0 {
                put(order, i as usize, i);
            } else {
                contact = at(order, i as usize);
            }
            put(keys, i as usize, contact_order::key(contact, contacts, params));
        }
    }
}

kernel! {
    /// Thread `i` copies the contact that is `i`-th in order; `ordered` has no header.
    order_contacts[256](t; params: Plain;; contacts: [u32], order: [u32], mut ordered: [u32]) {
        let i = t.i;
        if i < params.dispatch.n.min(length(contacts, params.dispatch.capacity_in)) {
            let from = LIST_HEADER + TOUCH_WORDS * at(order, i as usize) as usize;
            for k in 0..TOUCH_WORDS {
                put(ordered, TOUCH_WORDS * i as usize + k, at(contacts, from + k));
            }
        }
    }
}
