//! Workgroups that steal from each other, so often that rare orders of their accesses come up; and
//! devices that refuse to, or that check indices. On the native path alone; through WGSL the
//! kernels are refused.
//!
//! `CCD_STEAL_TAKES` says how many batches are taken from deques at least, for a device with many
//! workgroups.

use crate::search::{Descends, Search, rules};
use crate::search_trees::SearchTrees;
use crate::support::{bytes, not_run, run, zeros};
use crate::workers::check_workers;
use ccd::Aabb;
use ccd::gpu::bind::{StealPairs, SweepElements};
use ccd::gpu::{Device, Error, harness};
use ccd_core::backend::broad_phase::pair_workers::{LEFT, STACK};
use ccd_core::backend::layout::{Frame, Node, NodeDescent, Params};
use ccd_testkit::generate::uniform_boxes;
use std::time::Instant;

pub const TESTS: crate::Tests = &[
    ("steals_refused", check_refused),
    ("many_steals", check_many),
    ("indices_past_the_end", check_indices),
];

fn check_refused(device: &Device) {
    if device.check_native().is_ok() {
        return not_run("the native path steals");
    }
    let list = || zeros::<u32>(4);
    let mut kernel = StealPairs {
        a_nodes: zeros::<Node>(1),
        b_nodes: zeros::<Node>(1),
        control: zeros::<u32>(LEFT),
        nodes: list(),
        pairs: list(),
        front: list(),
    };
    let result = harness::run(device, &mut kernel, &Params::default(), 1, 65_535);
    let Err(Error::NoStealing { adapter }) = result else { panic!("{result:?}") };
    assert_eq!(adapter, device.info().adapter.name);
}

/// Rules of stealing, for `2^workers` workers: those of all tests of workers, deques that are long,
/// and a pair a batch, in rings that are gone around all the time.
fn of_thieves(device: &Device, width: u32, workers: u32) -> Vec<(&'static str, NodeDescent)> {
    let mut all = rules(device, width);
    all.retain(|(_, args)| args.batches > 0);
    let (_, usual) = all[0];
    let long = NodeDescent { batches: 64, batch: 4, push: 8, ..usual };
    let single = NodeDescent { batches: 2, batch: 1, push: 2, ..usual };
    all.extend([
        ("stealing, long deques", long),
        ("lazy stealing, long deques", NodeDescent { most: 4, ..long }),
        ("stealing, a pair a batch", single),
        ("lazy stealing, a pair a batch", NodeDescent { most: 2, ..single }),
    ]);
    all.iter_mut().for_each(|(_, args)| args.workers = workers);
    all
}

fn check_many(device: &Device) {
    if let Err(why) = device.check_native() {
        return not_run(why.to_string());
    }
    let wanted = std::env::var("CCD_STEAL_TAKES").map(|n| n.parse::<u64>().unwrap());
    let wanted = wanted.unwrap_or(2000);
    // Few workers are for software, which runs few workgroups at once.
    let workers = if wanted > 1_000_000 { 11 } else { 4 };
    let boxes: Vec<Aabb> = uniform_boxes(350).iter().map(|b| b.inflated(0.04)).collect();
    let trees = SearchTrees::new(device, 1, [&[], &boxes, &[]], false);
    let rules = of_thieves(device, trees.width(), workers);
    let (start, mut batches, mut takes) = (Instant::now(), [0; 3], 0);
    while takes < wanted {
        check_workers(device, &trees, &rules, &mut batches);
        let before = std::mem::replace(&mut takes, batches[0] + batches[1]);
        assert!(takes > before, "nobody takes a batch: {batches:?}");
    }
    let elapsed = start.elapsed();
    println!("2^{workers} workers, popped, stolen and no room: {batches:?} in {elapsed:?}");
}

/// A device that checks indices counts those past the end of a buffer and of workgroup memory.
fn check_indices(device: &Device) {
    if harness::failures(device).unwrap().is_none() {
        return not_run("kernels check their indices with CCD_CHECKED_SHADERS and SPIR-V alone");
    }
    let check = |kernel: &str, fails: bool| {
        let failures = harness::failures(device).unwrap().unwrap();
        let names: Vec<&str> = failures.iter().map(|(name, _)| *name).collect();
        assert_eq!(names, if fails { vec![kernel] } else { vec![] }, "{failures:?}");
    };
    // An edge of two vertices, the second of which is not there.
    for (vertex, fails) in [(1, false), (1000, true)] {
        let frame = Frame { count: [2, 1, 0], start: [0, 2, 3, 3], ..Frame::default() };
        let kernel = SweepElements { elements: bytes(&[0u32, vertex]), boxes: zeros::<Aabb>(3) };
        run(device, kernel, &Params { frame, ..Params::default() }, 1);
        check("sweep_elements", fails);
    }
    // One worker with more pairs than its stack has room for, if a record says that it has.
    let crowd = vec![Aabb { min: [0.0; 3], max: [1.0; 3] }; 400];
    let trees = SearchTrees::new(device, 1, [&[], &crowd, &[]], false);
    let (_, of_one) = rules(device, trees.width())[0];
    let of_one = NodeDescent { workers: 0, nodes: 1, turns: 40, ..of_one };
    for (stack, fails) in [(STACK, false), (4 * STACK, true)] {
        let args = NodeDescent { stack, ..of_one };
        Search::new(device, &trees, args).round(args, 0);
        check("pair_workers", fails);
    }
}
