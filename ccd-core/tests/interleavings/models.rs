//! Models: an owner and thieves at one deque, and workers with deques of their own. Every item is
//! taken exactly once, and none is lost.

use super::words::{self, Traced};
use ccd_core::backend::scheduling::deque::{Deque, Item, Steal};
use ccd_core::backend::scheduling::stealing::{Taken, Workers};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Executions of the present model so far.
pub static EXECUTIONS: AtomicUsize = AtomicUsize::new(0);

/// A deque, as an owner and thieves use it; what they take are items that they have read.
pub trait Scheme: Copy + Send + Sync + 'static {
    fn words(self) -> usize;
    /// Whether additions neither acquire nor release.
    fn is_weak(self) -> bool {
        false
    }
    /// Name of a word in a trace.
    fn name(i: usize) -> &'static str;
    /// Whether the deque had capacity for a batch.
    fn push(self, words: &Traced, items: &[Item]) -> bool;
    /// Nothing if it is empty.
    fn pop(self, words: &Traced) -> Vec<Item>;
    /// At most so many batches; nothing if it is empty or another came first.
    fn steal(self, words: &Traced, most: u32) -> Vec<Item>;
}

/// The deque of `ccd-core`, or the same with a defect.
#[derive(Clone, Copy)]
pub struct Ring {
    pub deque: Deque,
    /// Thieves give a range back before they have read it.
    pub early: bool,
    /// Additions neither acquire nor release.
    pub weak: bool,
}

impl Ring {
    /// A deque of so many batches of so many items.
    pub fn of(batches: u32, batch: u32) -> Self {
        Self { deque: Deque { base: 0, batches, batch }, early: false, weak: false }
    }
}

pub fn read(deque: Deque, words: &Traced, slot: u32) -> Vec<Item> {
    (0..deque.items(words, slot)).map(|i| deque.read(words, slot, i)).collect()
}

impl Scheme for Ring {
    fn words(self) -> usize {
        Deque::words(self.deque.batches, self.deque.batch)
    }

    fn is_weak(self) -> bool {
        self.weak
    }

    fn name(i: usize) -> &'static str {
        match i {
            0 => "ends",
            16 => "returned",
            32 => "reclaimed",
            _ => "",
        }
    }

    fn push(self, words: &Traced, items: &[Item]) -> bool {
        self.deque.push(words, items).is_ok()
    }

    fn pop(self, words: &Traced) -> Vec<Item> {
        self.deque.pop(words).map_or(Vec::new(), |slot| read(self.deque, words, slot))
    }

    fn steal(self, words: &Traced, most: u32) -> Vec<Item> {
        let deque = self.deque;
        let Steal::Stolen(range) = deque.steal(words, most) else { return Vec::new() };
        let give_back = |now: bool| now.then(|| deque.give_back(words, range.n));
        give_back(self.early);
        let slots = (0..range.n).map(|i| deque.slot_of(range, i));
        let items = slots.flat_map(|slot| read(deque, words, slot)).collect();
        give_back(!self.early);
        items
    }
}

/// Item `i`: its words say so, and belong together.
pub fn item(i: u32) -> Item {
    [i + 1, !i]
}

fn number(item: Item) -> usize {
    assert!(item[0] != 0 && item[1] == !(item[0] - 1), "half of an item was taken: {item:?}");
    item[0] as usize - 1
}

/// One execution. `owner`: what it does before it empties its deque, which is to push a batch of so
/// many items or, 0, to pop one; `thieves`: how often each tries to take at most how many batches.
pub fn deque<S: Scheme>(scheme: S, owner: &[u32], thieves: &[(u32, u32)]) {
    EXECUTIONS.fetch_add(1, Ordering::Relaxed);
    words::begin();
    let shared = Traced::new(scheme.words(), S::name, scheme.is_weak());
    let spawn = |(&(attempts, most), who): (&(u32, u32), &'static str)| {
        let words = shared.of(who);
        loom::thread::spawn(move || {
            let taken = (0..attempts).flat_map(|_| {
                let taken = scheme.steal(&words, most);
                tell(&words, &taken);
                taken
            });
            taken.collect::<Vec<Item>>()
        })
    };
    let thieves: Vec<_> = thieves.iter().zip(["thief", "thief 2"]).map(spawn).collect();
    let words = shared;
    let (mut taken, mut pushed) = (Vec::new(), 0);
    for &n in owner {
        if n == 0 {
            let popped = scheme.pop(&words);
            tell(&words, &popped);
            taken.extend(popped);
            continue;
        }
        let items: Vec<Item> = (pushed..pushed + n).map(item).collect();
        pushed += n;
        if !scheme.push(&words, &items) {
            words.say("full");
            taken.extend(items);
        }
    }
    loop {
        let popped = scheme.pop(&words);
        tell(&words, &popped);
        if popped.is_empty() {
            break;
        }
        taken.extend(popped);
    }
    thieves.into_iter().for_each(|thief| taken.extend(thief.join().unwrap_or_default()));
    check(&taken, pushed);
}

pub fn tell(words: &Traced, taken: &[Item]) {
    if !taken.is_empty() {
        let items: Vec<String> = taken.iter().map(|&i| number(i).to_string()).collect();
        words.say(&format!("HAS ITEM {}", items.join(", ")));
    }
}

/// Every item once.
pub fn check(taken: &[Item], n: u32) {
    let mut times = vec![0; n as usize];
    taken.iter().for_each(|&item| times[number(item)] += 1);
    for (i, times) in times.into_iter().enumerate() {
        assert!(times <= 1, "item {i} was taken {times} times");
        assert!(times == 1, "item {i} was lost");
    }
}

/// Stealing of workers.
#[derive(Clone, Copy, Debug)]
pub enum Steals {
    /// One batch at a time.
    Task,
    /// This number of batches of every other deque.
    Lazily(u32),
}

/// One execution of workers, until all have retired: the first has a batch of `first`, of which
/// every item above `depth` 0 makes two below it.
pub fn workers(shape: Workers, steals: Steals, depth: u32) {
    EXECUTIONS.fetch_add(1, Ordering::Relaxed);
    words::begin();
    let words = Traced::new(shape.words(), |_| "", false);
    for worker in 0..shape.n {
        shape.deque(worker).clear(&words);
    }
    assert!(shape.deque(0).push(&words, &[[depth, 1]]).is_ok());
    let others: Vec<_> = (1..shape.n)
        .map(|me| {
            let words = words.of(["owner", "thief", "thief 2"][me as usize]);
            loom::thread::spawn(move || work(shape, &words, me, steals))
        })
        .collect();
    let mut leaves = work(shape, &words, 0, steals);
    others.into_iter().for_each(|other| leaves.extend(other.join().unwrap_or_default()));
    leaves.sort_unstable();
    let want: Vec<u32> = (1 << depth..2 << depth).collect();
    assert_eq!(leaves, want, "leaves were taken twice or lost");
}

/// A worker that retires when it has found nothing once; the leaves that it met.
fn work(shape: Workers, words: &Traced, me: u32, steals: Steals) -> Vec<u32> {
    let (mut stack, mut leaves) = (Vec::<Item>::new(), Vec::new());
    loop {
        while let Some([depth, number]) = stack.pop() {
            if depth == 0 {
                leaves.push(number);
                continue;
            }
            stack.extend([[depth - 1, 2 * number], [depth - 1, 2 * number + 1]]);
            // All above one item go to the deque, if it has capacity.
            if shape.deque(me).push(words, &stack[..1]).is_ok() {
                stack.remove(0);
            }
        }
        let taken: Option<Taken> = match steals {
            Steals::Task => shape.take_task(words, me, me + 1),
            Steals::Lazily(most) => shape.take_lazily(words, me, most),
        };
        let Some(taken) = taken else { return leaves };
        stack.extend(read(shape.deque(taken.owner), words, taken.slot));
        shape.done(words, taken);
    }
}
