//! Workgroups that steal from each other: every item is taken as often as it has lives, none is
//! lost, with room for few batches and work that is left for another dispatch. On the native path
//! alone; through WGSL the kernel is refused.
//!
//! `CCD_STEAL_TAKES` says how many batches are taken from deques at least, for a device with many
//! workgroups.

use crate::support::{bytes, not_run, read, run};
use ccd::gpu::bind::StealStress;
use ccd::gpu::{Device, Error, harness};
use ccd_core::backend::kernel::{FencedWords, Id, Words};
use ccd_core::backend::layout::{Params, Stealing};
use ccd_core::backend::scheduling::deque::Full;
use ccd_core::backend::scheduling::stealing::Workers;
use std::sync::atomic::AtomicU32;
use std::time::Instant;
use words::Atomics;

#[path = "../../ccd-core/src/backend/kernel/test_words.rs"]
mod words;

pub const TESTS: crate::Tests = &[
    ("steals_refused", check_refused),
    ("steals", check_steals),
    ("many_steals", check_many),
    ("indices_past_the_end", check_indices),
];

/// Items of a worker's stack.
const STACK: usize = 2 * Id::StealStress.threads() as usize;
/// Words of a worker's stack between dispatches.
const SAVED: usize = 1 + 2 * STACK;
/// Dispatches until all work must be done.
const MOST_DISPATCHES: u32 = 10_000;

/// Work for a number of workers: `n_items` items of so many lives, which stand in the deques of as
/// few workers as they fit into, those for which there is no room on stacks.
#[derive(Clone, Copy, Debug)]
struct Work {
    args: Stealing,
    n_items: u32,
    lives: u32,
}

/// What all dispatches came to: items taken from anywhere; batches popped and stolen, pushes
/// without room, takes from stacks; dispatches.
#[derive(Debug, Default)]
struct Found {
    items: u64,
    popped: u64,
    stolen: u64,
    full: u64,
    from_stacks: u64,
    dispatches: u32,
}

impl Work {
    fn workers(&self) -> Workers {
        let Stealing { workers, batches, batch, .. } = self.args;
        Workers { n: workers, batches, batch }
    }

    fn kernel(&self) -> StealStress<Vec<u8>> {
        let workers = self.workers();
        let words = Atomics::new(workers.words(), 0);
        workers.clear(&words);
        let items: Vec<[u32; 2]> = (0..self.n_items).map(|tag| [tag, self.lives - 1]).collect();
        let (mut owner, mut rest) = (0, &items[..]);
        while !rest.is_empty() && owner < workers.n {
            let (batch, others) = rest.split_at(rest.len().min(workers.batch as usize));
            match workers.deque(owner).push(&words, batch) {
                Ok(()) => rest = others,
                Err(Full) => owner += 1,
            }
        }
        let mut stacks = vec![0; SAVED * workers.n as usize];
        for (stack, items) in stacks.chunks_mut(SAVED).zip(rest.chunks(STACK)) {
            stack[0] = items.len() as u32;
            stack[1..][..2 * items.len()].copy_from_slice(items.as_flattened());
        }
        assert!(rest.len() <= STACK * workers.n as usize, "{self:?}");
        StealStress {
            words: bytes(&words.0.into_iter().map(AtomicU32::into_inner).collect::<Vec<_>>()),
            stacks: bytes(&stacks),
            counts: vec![0; 4 * self.n_items as usize],
            status: vec![0; 4 * 64],
        }
    }

    fn params(&self) -> Params<Stealing> {
        Params { args: self.args, ..Params::default() }
    }

    /// Dispatches until nothing is left.
    fn run(&self, device: &Device) -> (Found, Vec<u32>) {
        let mut kernel = self.kernel();
        let mut found = Found::default();
        loop {
            kernel.status.fill(0);
            kernel = run(device, kernel, &self.params(), self.args.workers);
            let status: Vec<u32> = read(&kernel.status);
            found.popped += status[0] as u64;
            found.stolen += status[1] as u64;
            found.full += status[2] as u64;
            found.from_stacks += status[3] as u64;
            found.dispatches += 1;
            if status[4] == 0 {
                let counts: Vec<u32> = read(&kernel.counts);
                found.items = counts.iter().map(|&times| times as u64).sum();
                return (found, counts);
            }
            assert!(found.dispatches < MOST_DISPATCHES, "{self:?} does not end: {found:?}");
        }
    }

    /// Every item was taken as often as it has lives.
    fn check(&self, counts: &[u32]) -> Result<(), String> {
        match counts.iter().position(|&times| times != self.lives) {
            Some(tag) => Err(format!("item {tag}: {} times, {self:?}", counts[tag])),
            None => Ok(()),
        }
    }
}

/// Whether the device steals; if not, why is what the test says.
fn steals(device: &Device) -> bool {
    let Err(why) = device.check_native() else { return true };
    not_run(why.to_string());
    false
}

fn check_refused(device: &Device) {
    if device.check_native().is_ok() {
        return not_run("the native path steals");
    }
    let args = Stealing { workers: 1, batches: 2, batch: 1, most: 0, rounds: 1, patience: 1 };
    let work = Work { args, n_items: 1, lives: 1 };
    let result = harness::run(device, &mut work.kernel(), &work.params(), 1, 65_535);
    let Err(Error::NoStealing { adapter }) = result else { panic!("{result:?}") };
    assert_eq!(adapter, device.info().adapter.name);
}

/// A device that checks indices counts those past the end of a buffer and of workgroup memory.
fn check_indices(device: &Device) {
    if harness::failures(device).unwrap().is_none() {
        return not_run("kernels check their indices with CCD_CHECKED_SHADERS and SPIR-V alone");
    }
    let args = Stealing { workers: 1, batches: 2, batch: 1, most: 0, rounds: 1, patience: 1 };
    let work = Work { args, n_items: 4, lives: 1 };
    // Nothing; a tag that is counted nowhere; 129 items on a stack of 128, each of two words.
    for (word, value, want) in [(0, 2, None), (1, 1000, Some(1)), (0, STACK as u32 + 1, Some(2))] {
        let mut kernel = work.kernel();
        kernel.stacks[4 * word..][..4].copy_from_slice(&u32::to_le_bytes(value));
        run(device, kernel, &work.params(), 1);
        let failures = harness::failures(device).unwrap().unwrap();
        assert_eq!(failures, Vec::from_iter(want.map(|n| ("steal_stress", n))), "{value}");
    }
}

fn check_steals(device: &Device) {
    if !steals(device) {
        return;
    }
    // Who comes first is up to the device: repeated until all that is to be seen was there.
    let mut seen = [0; 3];
    for _ in 0..20 {
        steal(device, &mut seen);
        if seen.iter().all(|&n| n > 0) {
            break;
        }
    }
    assert!(seen.iter().all(|&n| n > 0), "stolen, full, more dispatches: {seen:?}");
}

/// Shapes of work, every item of which is taken as often as it lives; adds what was stolen, found a
/// deque full, and took more than a dispatch.
fn steal(device: &Device, seen: &mut [u64; 3]) {
    let args = Stealing { workers: 8, batches: 8, batch: 4, most: 0, rounds: 40, patience: 10 };
    for (args, n_items) in [
        (Stealing { workers: 1, ..args }, 30),
        (args, 200),
        (Stealing { most: 2, ..args }, 200),
        (Stealing { workers: 32, batches: 2, batch: 1, ..args }, 70),
        (Stealing { workers: 32, batches: 2, batch: 1, most: 2, ..args }, 70),
        (Stealing { workers: 4, batch: 64, most: 8, ..args }, 2000),
        (Stealing { workers: 4, batches: 2, batch: 1, ..args }, 300),
        (Stealing { workers: 4, batches: 2, batch: 1, most: 1, ..args }, 300),
    ] {
        let work = Work { args, n_items, lives: 20 };
        let (found, mut counts) = work.run(device);
        work.check(&counts).unwrap();
        let seen_now = [found.stolen, found.full, found.dispatches as u64 - 1];
        *seen = std::array::from_fn(|i| seen[i] + seen_now[i]);
        // What the check must notice: an item that was taken once more, and one that was lost.
        for wrong in [21, 19] {
            counts[7] = wrong;
            assert!(work.check(&counts).unwrap_err().starts_with(&format!("item 7: {wrong}")));
        }
    }
}

fn check_many(device: &Device) {
    if !steals(device) {
        return;
    }
    let wanted = std::env::var("CCD_STEAL_TAKES").map(|n| n.parse::<u64>().unwrap());
    let wanted = wanted.unwrap_or(20_000);
    // Small work is for software, which runs few workgroups at once.
    let (workers, lives) = if wanted > 1_000_000 { (2048, 250) } else { (16, 10) };
    let args = Stealing { workers, batches: 64, batch: 4, most: 0, rounds: 2000, patience: 100 };
    // The last: few items for many workers, in rings that they go around all the time.
    let few = Stealing { batches: 2, batch: 1, ..args };
    let shapes = [(args, 128), (Stealing { most: 4, ..args }, 128), (few, 1)];
    let start = Instant::now();
    let mut all = Found::default();
    for (args, items) in shapes.into_iter().cycle() {
        let work = Work { args, n_items: workers * items, lives };
        let (found, counts) = work.run(device);
        work.check(&counts).unwrap();
        all.items += found.items;
        all.popped += found.popped;
        all.stolen += found.stolen;
        all.full += found.full;
        all.from_stacks += found.from_stacks;
        all.dispatches += found.dispatches;
        if all.popped + all.stolen >= wanted {
            break;
        }
    }
    let takes = all.popped + all.stolen;
    println!("{workers} workgroups, {takes} takes in {:?}: {all:?}", start.elapsed());
}
