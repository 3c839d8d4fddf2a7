//! Who does which part of a traversal whose work appears while it runs: queues and deques
//! from which workers take, written once for threads, for workgroups and for a model checker.
//!
//! | module | idea |
//! |---|---|
//! | [`deque`] | one deque: its owner pushes and pops at the bottom, thieves take from the top |
//! | [`abp_deque`] | the same as it is printed, in two words, with fences |
//! | [`front`] | when the pairs at which a descent ended begin the next one, and when not |
//! | [`queue`] | one queue that all workers share |
//! | [`stealing`] | the deques of all workers; ranges stolen at once and transferred lazily |
//!
//! docs/SCHEDULING.md draws them, says what is model-checked, and why no item is lost.

pub mod abp_deque;
pub mod deque;
pub mod front;
pub mod queue;
pub mod stealing;
