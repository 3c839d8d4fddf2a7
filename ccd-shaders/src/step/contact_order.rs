//! Contacts into their canonical order; see `ccd_core::backend::kernel::contact_order`.

use crate::entry::kernel;
use crate::scan::scan;
use crate::workgroup::{add, barrier, get, length, or, set};
use ccd_core::backend::kernel::contact_order::{ROWS, bucket, place, row, unordered};
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::layout::{LIST_HEADER, PackedTouch, TOUCH_WORDS};
use spirv_std::glam::UVec4;

kernel! {
    /// Thread `i` counts contact `i` in its bucket; those that were counted before it are its rank.
    count_contacts[256](t; params: Plain;; contacts: [u32], mut table: [u32], mut ranks: [u32]) {
        let i = t.i;
        if i < params.dispatch.n.min(length(contacts, params.dispatch.capacity_in)) {
            let bucket = bucket(i, contacts, &params.frame);
            put(ranks, i as usize, add(table, bucket as usize, 1));
        }
    }
}

kernel! {
    /// Thread `i` packs contact `i` behind the buckets before its own, and those of less rank.
    place_contacts[256](t; params: Plain; sums: [u32; 512], starts: [u32; 256]; contacts: [u32],
        table: [u32], ranks: [u32], mut slots: [UVec4]) {
        let row = row(&params.frame);
        let sum = at(table, (ROWS * row + t.lane) as usize);
        let up_to = scan(t.lane, 8, 256, sum, sums);
        set(starts, t.lane, up_to - sum);
        barrier();
        let i = t.i;
        if i < params.dispatch.n.min(length(contacts, params.dispatch.capacity_in)) {
            let bucket = bucket(i, contacts, &params.frame);
            let start = get(starts, bucket / row) + at(table, bucket as usize);
            let from = LIST_HEADER + TOUCH_WORDS * i as usize;
            let word = |k: usize| at(contacts, from + k);
            let touch = [word(0), word(1), word(2), word(3), word(4), word(5), word(6)];
            let [a, b, low, high] = PackedTouch::new(touch).words;
            let slot = start + at(ranks, i as usize);
            put(slots, slot as usize, UVec4::new(a, b, low, high));
        }
    }
}

kernel! {
    /// Thread `i` puts the contact in slot `i` into its place; `ordered` has no header.
    order_contacts[256](t; params: Plain;; contacts: [u32], slots: [UVec4], mut ordered: [UVec4],
        mut table: [u32]) {
        let i = t.i;
        let n = params.dispatch.n.min(length(contacts, params.dispatch.capacity_in));
        if i < n {
            let (to, is_in_order) = place(i, n, |slot| {
                let words = at(slots, slot as usize);
                [words.x, words.y]
            });
            if !is_in_order {
                or(table, unordered(&params.frame) as usize, 1);
            }
            put(ordered, to as usize, at(slots, i as usize));
        }
    }
}
