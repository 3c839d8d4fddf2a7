//! The kernel that looks at listed pairs by itself: what it keeps is what brute force keeps.

use crate::pairs::candidates;
use crate::scenes::check_pairs;
use crate::support::{bytes, capacity, entries, list, read, run, twin};
use crate::twin::Twin;
use ccd::Pair;
use ccd::gpu::Device;
use ccd::gpu::bind::ListListed;
use ccd_core::backend::layout::{Dispatch, Frame, LIST_HEADER, Listing, Params};
use ccd_testkit::{brute, compare};

pub const TESTS: crate::Tests = &[("listed_pairs", check_listed)];

/// All pairs of boxes that overlap, as a source lists them.
fn overlaps(twin: &Twin, kind: u32) -> Vec<Pair> {
    let set = |set: usize| {
        let [from, to] = [set, set + 1].map(|set| twin.frame.start[set] as usize);
        &twin.boxes[from..to]
    };
    if kind == 0 { brute::pairs(set(0), set(2)) } else { brute::self_pairs(set(1)) }
}

/// The list that the kernel makes of a part of the listed pairs.
fn looked_at(
    device: &Device,
    twin: &Twin,
    (kind, flags): (u32, u32),
    pairs: &[Pair],
    dispatch: Dispatch,
) -> Vec<u8> {
    let (boxes, bodies, keys) = (bytes(&twin.boxes), vec![0; 16], vec![0; 48]);
    let elements = bytes(&twin.elements());
    let (input, output) = (list(pairs), capacity(dispatch.capacity_out));
    let dispatch = Dispatch { capacity_in: pairs.len() as u32, ..dispatch };
    let frame = Frame { flags: twin.frame.flags | flags, ..twin.frame };
    let p = Params { frame, dispatch, args: Listing { kind } };
    let kernel = ListListed { boxes, elements, bodies, keys, input, output };
    run(device, kernel, &p, 3).output
}

fn check_listed(device: &Device) {
    let (twin, step) = twin(40, 5);
    let capacity_out = 100_000;
    for kind in [0, 1] {
        let (pairs, want) = (overlaps(&twin, kind), candidates(&twin, &step, kind));
        assert!(pairs.len() > want.len() + 1000, "few neighbours show nothing");
        // In two parts, as a dispatch of many pairs is.
        let n = pairs.len() as u32;
        let (mut found, mut counted) = (Vec::new(), 0);
        for (first, n) in [(0, n / 3), (n / 3, n)] {
            let dispatch = Dispatch { n, first, capacity_in: 0, capacity_out };
            let part = looked_at(device, &twin, (kind, 0), &pairs, dispatch);
            counted += read::<u32>(&part)[1];
            found.extend(entries(&part));
        }
        assert_eq!(counted as usize, want.len(), "candidates that were counted");
        let fails = compare::fails(|| {
            check_pairs("control", want[1..].to_vec(), found.clone());
        });
        check_pairs("listed pairs", want.clone(), found);
        assert!(fails, "a pair too many passes");
        // A list that is too short counts everything and writes nothing beyond its end; that of a
        // part says how many it should have had.
        let dispatch = Dispatch { n, first: 0, capacity_in: 0, capacity_out: 20 };
        let in_parts = Frame::FLAG_IN_PARTS;
        for (flags, most) in [(0, 0), (in_parts, want.len() as u32)] {
            let short = read::<u32>(&looked_at(device, &twin, (kind, flags), &pairs, dispatch));
            assert_eq!(short[..4], [counted, counted, most, 0]);
            let none = Dispatch { capacity_out: 0, ..dispatch };
            let none = looked_at(device, &twin, (kind, flags), &pairs, none);
            assert_eq!(none.len(), 4 * LIST_HEADER);
            assert_eq!(read::<u32>(&none), [counted, counted, most, 0]);
        }
        let enough = Dispatch { capacity_out, ..dispatch };
        let all = looked_at(device, &twin, (kind, in_parts), &pairs, enough);
        assert_eq!(read::<u32>(&all)[..4], [counted, counted, 0, 0]);
    }
}
