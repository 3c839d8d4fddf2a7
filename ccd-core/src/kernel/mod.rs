//! Kernel bodies: one pure function per stage, called once per thread, the same on a CPU and on a GPU.
//!
//! Three shapes: *map* (thread `i` returns what it owns), *meet* (threads share words, through [`Words`]) and *emit* (an unknown number
//! of results, into a [`Sink`]). [`TABLE`] lists them.

pub mod blocks;
pub mod bounds;
pub mod build;
pub mod decide;
pub mod filter;
pub mod narrow;
pub mod probe;
pub mod refit;
pub mod sort;
pub mod sweep;
pub mod traverse;

/// Shared 32-bit words, as a kernel sees them: atomics on a CPU, a storage buffer on a GPU.
pub trait Words {
    /// Relaxed load of word `i`.
    fn load(&self, i: usize) -> u32;
    /// Relaxed store to word `i`.
    fn store(&self, i: usize, value: u32);
    /// Raises word `i` to `value` if it is less; relaxed.
    fn max(&self, i: usize, value: u32);
    /// Adds and returns the old value; acquires what others released by this call on the same word, releases what this thread
    /// stored before.
    fn add_acquire_release(&self, i: usize, value: u32) -> u32;
}

/// Takes results of which a kernel does not know the number in advance.
///
/// An implementation counts every call, also those for which it has no room: nothing is dropped silently.
pub trait Sink<T> {
    /// Takes one result.
    fn push(&mut self, item: T);
}

/// How results of two backends must compare.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parity {
    /// Equal bytes: integers, minima, maxima, comparisons.
    Exact,
    /// The same set, in any order.
    ExactSet,
    /// Every true contact is reported, with a time of impact that is not later than the exact one.
    NotLater,
}

/// A row of the kernel table.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    /// Name of the body and of every entry point made from it.
    pub name: &'static str,
    /// Threads of a workgroup on a GPU.
    pub workgroup: u32,
    /// How backends compare.
    pub parity: Parity,
}

/// Every kernel, in the order in which a step runs them.
pub const TABLE: [Kernel; 9] = [
    Kernel { name: "sweep_vertices", workgroup: 64, parity: Parity::Exact },
    Kernel { name: "sweep_edges", workgroup: 64, parity: Parity::Exact },
    Kernel { name: "sweep_faces", workgroup: 64, parity: Parity::Exact },
    Kernel { name: "scene_bounds", workgroup: 64, parity: Parity::Exact },
    Kernel { name: "morton", workgroup: 64, parity: Parity::Exact },
    Kernel { name: "build", workgroup: 64, parity: Parity::Exact },
    Kernel { name: "refit", workgroup: 64, parity: Parity::Exact },
    Kernel { name: "traverse", workgroup: 64, parity: Parity::ExactSet },
    Kernel { name: "narrow", workgroup: 64, parity: Parity::NotLater },
];
