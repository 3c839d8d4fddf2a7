//! Cooperative: contacts into their canonical order by counting. A bucket is a kind and `a`; most
//! have few contacts, which rank each other by `b`.
//!
//! `count_contacts` counts each bucket, which gives a contact its rank there in no order,
//! `scan_rows` turns counts into places, `place_contacts` packs contacts into the buckets, one
//! behind the other, `order_contacts` ranks what is in each. Counts are [`ROWS`] rows, as
//! `scan_rows` reads them.

use super::sort::DIGITS;
use crate::kernel::memory::at;
use crate::layout::{Frame, LIST_HEADER, PackedTouch, TOUCH_WORDS};

/// Rows of the table of counts. Behind them are their sums, and [`unordered`].
pub const ROWS: u32 = DIGITS;

/// Others of its bucket that a contact looks at; in a bucket with more of them, contacts stay in no
/// order.
pub const LONGEST: u32 = 4096;

/// Counts of a row.
#[inline(always)]
pub fn row(frame: &Frame) -> u32 {
    (frame.count[0] + frame.count[1]).div_ceil(ROWS)
}

/// The word of the table that says whether some bucket is in no order.
#[inline(always)]
pub fn unordered(frame: &Frame) -> u32 {
    ROWS * row(frame) + ROWS
}

/// The bucket of contact `i` of a list. Vertices come before edges.
#[inline(always)]
pub fn bucket(i: u32, contacts: &[u32], frame: &Frame) -> u32 {
    let first = LIST_HEADER + TOUCH_WORDS * i as usize;
    at(contacts, first) * frame.count[0] + at(contacts, first + 2)
}

/// The place of the contact in slot `slot` of `n`, and whether its bucket is in order. Otherwise
/// all of its bucket keep their slots. `ids`: the first two words of the packed contact in a slot.
#[inline(always)]
pub fn place(slot: u32, n: u32, ids: impl Fn(u32) -> [u32; 2]) -> (u32, bool) {
    // Kind and `a` in one word are the bucket.
    let pair = |slot: u32| {
        let [a, b] = ids(slot);
        [a, b & PackedTouch::ID]
    };
    let [own, own_b] = pair(slot);
    let (mut first, mut less) = (slot, 0);
    // One more than may be looked at, so that all of a bucket see that it is too long.
    for _ in 0..LONGEST + 1 {
        if first == 0 {
            break;
        }
        let [other, b] = pair(first - 1);
        if other != own {
            break;
        }
        first -= 1;
        less += (b <= own_b) as u32;
    }
    let mut last = slot;
    for _ in 0..LONGEST + 1 {
        if last + 1 >= n {
            break;
        }
        let [other, b] = pair(last + 1);
        if other != own {
            break;
        }
        last += 1;
        less += (b < own_b) as u32;
    }
    if last - first > LONGEST { (slot, false) } else { (first + less, true) }
}
