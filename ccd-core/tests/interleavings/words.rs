//! Words as loom's atomics, and a trace of what every thread did to them.

use ccd_core::backend::kernel::Words;
use loom::sync::Arc;
use loom::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Mutex, PoisonError};

/// Accesses of the present execution, in order.
static STORY: Mutex<Vec<String>> = Mutex::new(Vec::new());

/// Forgets the last execution.
pub fn begin() {
    STORY.lock().unwrap_or_else(PoisonError::into_inner).clear();
}

/// Accesses since [`begin`].
pub fn story() -> String {
    STORY.lock().unwrap_or_else(PoisonError::into_inner).join("\n")
}

/// Words that threads of a model share, and who uses them.
#[derive(Clone)]
pub struct Traced {
    words: Arc<Vec<AtomicU32>>,
    /// A word beside each, if every access is to be one that all others of that word depend on.
    gates: Arc<Vec<AtomicU32>>,
    name: fn(usize) -> &'static str,
    weak: bool,
    who: &'static str,
}

impl Traced {
    /// `n` words, all 0; `name`: of a word, empty if it is not traced.
    /// `weak`: additions and loads that acquire are relaxed, which is wrong.
    pub fn new(n: usize, name: fn(usize) -> &'static str, weak: bool) -> Self {
        let zeros = |n| Arc::new((0..n).map(|_| AtomicU32::new(0)).collect());
        Self { words: zeros(n), gates: zeros(0), name, weak, who: "owner" }
    }

    /// The same, and an access is tried before and after every other one of its word by another
    /// thread. Without it loom 0.7 compares a store with the last access alone, and does not see
    /// that a load of another thread could have come later if a second load stands between them.
    /// The additions of 0 beside a word are relaxed, so that they order nothing.
    pub fn gated(self) -> Self {
        let gates = Arc::new(self.words.iter().map(|_| AtomicU32::new(0)).collect());
        Self { gates, ..self }
    }

    fn word(&self, i: usize) -> &AtomicU32 {
        if let Some(gate) = self.gates.get(i) {
            gate.fetch_add(0, Ordering::Relaxed);
        }
        &self.words[i]
    }

    /// The same words as another worker uses them.
    pub fn of(&self, who: &'static str) -> Self {
        Self { who, ..self.clone() }
    }

    /// Adds to the story.
    pub fn say(&self, what: &str) {
        let mut story = STORY.lock().unwrap_or_else(PoisonError::into_inner);
        story.push(format!("{:8} {what}", self.who));
    }

    fn tell(&self, i: usize, what: impl FnOnce(&str) -> String) {
        let name = (self.name)(i);
        if !name.is_empty() {
            self.say(&what(name));
        }
    }

    /// Store that others acquire.
    pub fn store_release(&self, i: usize, value: u32) {
        self.word(i).store(value, Ordering::Release);
        self.tell(i, |name| format!("{name} := {value}"));
    }

    /// Addition without an order, as of counters.
    pub fn add(&self, i: usize, value: u32) {
        self.word(i).fetch_add(value, Ordering::Relaxed);
    }

    /// A fence of sequential consistency: what loom has to say that all threads see one order.
    pub fn fence(&self) {
        loom::sync::atomic::fence(Ordering::SeqCst);
    }
}

impl Words for Traced {
    fn load(&self, i: usize) -> u32 {
        let value = self.word(i).load(Ordering::Relaxed);
        self.tell(i, |name| format!("{name} is {value:#x}"));
        value
    }
    fn store(&self, i: usize, value: u32) {
        self.word(i).store(value, Ordering::Relaxed);
        self.tell(i, |name| format!("{name} := {value:#x}"));
    }
    fn add_acquire_release(&self, i: usize, value: u32) -> u32 {
        let order = if self.weak { Ordering::Relaxed } else { Ordering::AcqRel };
        let old = self.word(i).fetch_add(value, order);
        self.tell(i, |name| format!("{name} {old:#x} + {value:#x}"));
        old
    }
    fn load_acquire(&self, i: usize) -> u32 {
        let order = if self.weak { Ordering::Relaxed } else { Ordering::Acquire };
        let value = self.word(i).load(order);
        self.tell(i, |name| format!("{name} is {value:#x}"));
        value
    }
    fn compare_exchange(&self, i: usize, old: u32, new: u32) -> u32 {
        let (taken, lost) = (Ordering::AcqRel, Ordering::Relaxed);
        let seen = self.word(i).compare_exchange(old, new, taken, lost).unwrap_or_else(|seen| seen);
        self.tell(i, |name| {
            let result = if seen == old { "exchanged" } else { "lost" };
            format!("{name} {seen:#x}, {old:#x} -> {new:#x}: {result}")
        });
        seen
    }
}
