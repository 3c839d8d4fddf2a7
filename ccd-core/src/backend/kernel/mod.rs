//! Kernel bodies: one pure function per stage, called once per thread, the same on a CPU and on a
//! GPU.
//!
//! Four shapes: *map* (thread `i` returns what it owns), *meet* (threads share words, through
//! [`Words`]), *emit* (an unknown number of results: the body says which there are, its caller
//! appends them to a list, which also counts those beyond its capacity) and *cooperative* (a
//! workgroup works together between barriers).
//!
//! The table, [`kernels!`](crate::kernels), has a row for each. A new kernel takes a body here, an
//! entry point in ccd-shaders and a row; its id, its module, its pipeline, the names of its buffers
//! and what tests check follow from the row.

pub mod contact_order;
pub mod memory;
pub mod prefix;
pub mod probe;
pub mod sort;
pub mod stack;
mod table;
#[cfg(test)]
pub(crate) mod test_words;
mod threads;
mod word_access;

pub use table::{Id, TABLE};
pub use word_access::{FencedWords, ReadWords, Words};

/// What a kernel does with a buffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// Reads.
    Read,
    /// Reads and writes, or adds to it atomically.
    Write,
}

/// A row of the kernel table.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    /// Name of the entry point, and of the files with its module.
    pub name: &'static str,
    /// Threads of a workgroup on a GPU.
    pub threads: u32,
    /// Barriers as written in its entry point.
    pub barriers: u32,
    /// Whether it needs `f64` and 64-bit integers.
    pub wide: bool,
    /// Whether it runs on the native path alone; see [`Id::native`].
    pub native: bool,
    /// Whether it runs where subgroups have 32 threads; see [`Id::by_subgroups`].
    pub by_subgroups: bool,
    /// If binding 0 is a [`Params`](crate::layout::Params): the name of its record.
    pub params: Option<&'static str>,
    /// Buffers in the order of their bindings, after the parameters.
    pub buffers: &'static [(&'static str, Access)],
}

impl Kernel {
    /// What is done with each binding, from 0.
    pub fn bindings(&self) -> impl Iterator<Item = Access> {
        self.params.map(|_| Access::Read).into_iter().chain(self.buffers.iter().map(|b| b.1))
    }
}

impl Id {
    /// The kernel's row.
    pub const fn row(self) -> &'static Kernel {
        &TABLE[self as usize]
    }

    /// Threads of a workgroup.
    pub const fn threads(self) -> u32 {
        self.row().threads
    }

    /// The kernel that does the same over trees of oriented boxes, which it has as one more buffer,
    /// or whose workers steal; itself where there is none.
    pub const fn variant(self, oriented: bool, steals: bool) -> Self {
        match (self, oriented, steals) {
            (Id::TraverseHalf, true, _) => Id::TraverseHalfOriented,
            (Id::TraverseFull, true, _) => Id::TraverseFullOriented,
            (Id::TraverseRecursive, true, _) => Id::TraverseRecursiveOriented,
            (Id::CutPairs, true, _) => Id::CutPairsOriented,
            (Id::ExpandPairs, true, _) => Id::ExpandPairsOriented,
            (Id::DescendStacks, true, _) => Id::DescendStacksOriented,
            (Id::ResumeFront, true, _) => Id::ResumeFrontOriented,
            (Id::PairWorkers, true, false) => Id::PairWorkersOriented,
            (Id::PairWorkers, true, true) => Id::StealPairsOriented,
            (Id::PairWorkers, false, true) => Id::StealPairs,
            (Id::BlockWorkers, _, true) => Id::StealBlockPairs,
            _ => self,
        }
    }

    /// The kernel that does the same with the same buffers and workgroups by subgroups of 32
    /// threads; itself where there is none.
    pub const fn of_subgroups(self) -> Self {
        match self {
            Id::ListOverlaps => Id::ListOverlapsBySubgroups,
            _ => self,
        }
    }

    /// Whether it runs on the native path alone: workgroups pass data to each other inside a
    /// dispatch, by acquire and release at the scope of the device, which WGSL does not have, or it
    /// is one [by subgroups](Self::by_subgroups).
    pub const fn native(self) -> bool {
        let steals = matches!(self, Id::StealPairs | Id::StealPairsOriented | Id::StealBlockPairs);
        steals || self.by_subgroups()
    }

    /// Whether it runs where subgroups have 32 threads and no others: by ballots.
    pub const fn by_subgroups(self) -> bool {
        matches!(self, Id::SortScatterBySubgroups | Id::ListOverlapsBySubgroups)
    }
}
