//! The kernels that look at listed pairs, each by itself: what they keep is what those for pairs of
//! blocks keep.

use crate::pairs::{candidates, filtered};
use crate::scenes::check_pairs;
use crate::support::{bytes, capacity, entries, list, paths, read, run, twin};
use crate::twin::Twin;
use ccd::Pair;
use ccd::gpu::Device;
use ccd::gpu::bind::{FilterListed, ListListed};
use ccd_core::backend::layout::{Decision, Dispatch, LIST_HEADER, Params};
use ccd_testkit::{brute, compare, generate};

pub const TESTS: crate::Tests = &[("listed_pairs", check_listed)];

/// All pairs of boxes that overlap, as a source lists them.
fn overlaps(twin: &Twin, kind: u32) -> Vec<Pair> {
    let set = |set: usize| {
        let [from, to] = [set, set + 1].map(|set| twin.frame.start[set] as usize);
        &twin.boxes[from..to]
    };
    if kind == 0 { brute::pairs(set(0), set(2)) } else { brute::self_pairs(set(1)) }
}

/// The list that a kernel makes of a part of the listed pairs.
fn looked_at(
    device: &Device,
    twin: &Twin,
    step: &generate::Step,
    (kind, filters): (u32, bool),
    pairs: &[Pair],
    dispatch: Dispatch,
) -> Vec<u8> {
    let (boxes, bodies, keys) = (bytes(&twin.boxes), vec![0; 16], vec![0; 48]);
    let elements = if kind == 0 { bytes(step.mesh.faces()) } else { bytes(step.mesh.edges()) };
    let paths = bytes(&paths(step, false));
    let (input, output) = (list(pairs), capacity(dispatch.capacity_out));
    let dispatch = Dispatch { capacity_in: pairs.len() as u32, ..dispatch };
    let p = Params { frame: twin.frame, dispatch, args: Decision { kind, capacity_open: 0 } };
    if filters {
        let k = FilterListed { boxes, elements, bodies, keys, paths, input, output };
        run(device, k, &p, 3).output
    } else {
        let k = ListListed { boxes, elements, bodies, keys, input, output };
        run(device, k, &p, 3).output
    }
}

fn check_listed(device: &Device) {
    let (twin, step) = twin(40, 5);
    let capacity_out = 100_000;
    for kind in [0, 1] {
        let (pairs, want) = (overlaps(&twin, kind), candidates(&twin, &step, kind));
        assert!(pairs.len() > want.len() + 1000, "few neighbours show nothing");
        let blocks = twin.node_pairs(1, kind);
        let of_blocks = filtered(device, &twin, &paths(&step, false), kind, &blocks, 9);
        for (filters, want) in [(false, want.clone()), (true, entries(&of_blocks))] {
            // In two parts, as a dispatch of many pairs is.
            let n = pairs.len() as u32;
            let (mut found, mut counted) = (Vec::new(), 0);
            for (first, n) in [(0, n / 3), (n / 3, n)] {
                let dispatch = Dispatch { n, first, capacity_in: 0, capacity_out };
                let part = looked_at(device, &twin, &step, (kind, filters), &pairs, dispatch);
                counted += read::<u32>(&part)[1];
                found.extend(entries(&part));
            }
            assert_eq!(counted, read::<u32>(&of_blocks)[1], "candidates that were counted");
            let fails = compare::fails(|| {
                check_pairs("control", want[1..].to_vec(), found.clone());
            });
            check_pairs("listed pairs", want.clone(), found);
            assert!(fails, "a pair too many passes");
            // A list that is too short counts everything and writes nothing beyond its end.
            let dispatch = Dispatch { n, first: 0, capacity_in: 0, capacity_out: 20 };
            let short = looked_at(device, &twin, &step, (kind, filters), &pairs, dispatch);
            assert_eq!(read::<u32>(&short)[0] as usize, want.len());
            let dispatch = Dispatch { capacity_out: 0, ..dispatch };
            let none = looked_at(device, &twin, &step, (kind, filters), &pairs, dispatch);
            assert_eq!(none.len(), 4 * LIST_HEADER);
            assert_eq!(read::<u32>(&none)[0] as usize, want.len());
        }
    }
}
