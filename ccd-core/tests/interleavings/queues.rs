//! Models: workers at one queue that all share. Each does what its script says, then takes until it
//! finds nothing, and retires; then every item has been taken, and once.

use super::models::{EXECUTIONS, check, item, tell};
use super::words::{self, Traced};
use ccd_core::backend::scheduling::deque::Item;
use ccd_core::backend::scheduling::queue::Queue;
use std::sync::atomic::Ordering;

/// One execution. `scripts`: of each worker, what it pushes before it takes once: so many items.
/// `weak`: nothing is acquired, which is wrong.
pub fn queue(capacity: u32, scripts: &'static [&'static [u32]], weak: bool) {
    EXECUTIONS.fetch_add(1, Ordering::Relaxed);
    words::begin();
    let queue = Queue { base: 0, capacity };
    let words = Traced::new(Queue::words(capacity), |_| "", weak).gated();
    queue.clear(&words);
    let mut first = 0;
    let mut workers = Vec::new();
    for (script, who) in scripts.iter().zip(["owner", "thief", "thief 2"]) {
        let (words, from) = (words.of(who), first);
        workers.push(move || work(queue, &words, script, from));
        first += script.iter().sum::<u32>();
    }
    let here = workers.remove(0);
    let others: Vec<_> = workers.into_iter().map(loom::thread::spawn).collect();
    let mut taken = here();
    others.into_iter().for_each(|other| taken.extend(other.join().unwrap_or_default()));
    check(&taken, first);
}

/// What a worker took, and items for which there was no capacity, which stay with it.
fn work(queue: Queue, words: &Traced, script: &[u32], mut next: u32) -> Vec<Item> {
    let mut taken = Vec::new();
    let pop = || queue.pop(words).inspect(|&item| tell(words, &[item]));
    for &n in script {
        for item in (next..next + n).map(item) {
            if queue.push(words, item).is_err() {
                words.say("full");
                taken.push(item);
            }
        }
        next += n;
        taken.extend(pop());
    }
    taken.extend(std::iter::from_fn(pop));
    taken
}
