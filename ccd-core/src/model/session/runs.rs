//! Ids by body, in runs.

use alloc::vec::Vec;
use core::ops::Range;

/// What each body has, by its number: vertices, or what else has ids, in ranges of consecutive
/// ids that ascend.
#[derive(Debug)]
pub struct RunsOfBodies {
    /// Where the runs of a body begin.
    first: Vec<u32>,
    runs: Vec<Range<u32>>,
}

impl RunsOfBodies {
    /// From pairs of a body and what it has, which ascends.
    pub fn new(all: impl Iterator<Item = (u32, u32)>) -> Self {
        let mut runs: Vec<(u32, Range<u32>)> = Vec::new();
        for (body, i) in all {
            match runs.last_mut() {
                Some((last, run)) if *last == body && run.end == i => run.end = i + 1,
                _ => runs.push((body, i..i + 1)),
            }
        }
        // Stable: the runs of a body stay in their order.
        runs.sort_by_key(|run| run.0);
        runs.dedup_by(|(next, one), (body, run)| {
            let joins = next == body && run.end == one.start;
            if joins {
                run.end = one.end;
            }
            joins
        });
        let n_bodies = runs.last().map_or(0, |run| run.0 + 1);
        let begins = |body: u32| runs.partition_point(|run| run.0 < body) as u32;
        let first = (0..=n_bodies).map(begins).collect();
        Self { first, runs: runs.into_iter().map(|run| run.1).collect() }
    }

    /// What a body has.
    pub fn of(&self, body: usize) -> &[Range<u32>] {
        match self.first.get(body..) {
            Some([first, last, ..]) => &self.runs[*first as usize..*last as usize],
            _ => &[],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_have_their_runs() {
        let of = [(3, 0), (3, 1), (0, 1), (3, 2), (0, 4), (1, 5), (3, 6)];
        let all = RunsOfBodies::new(of.into_iter());
        let found = |body: usize| -> Vec<[u32; 2]> {
            all.of(body).iter().map(|run| [run.start, run.end]).collect()
        };
        assert_eq!(found(3), [[0, 3], [6, 7]]);
        assert_eq!(found(0), [[1, 2], [4, 5]]);
        assert_eq!(found(1), [[5, 6]]);
        assert!(found(2).is_empty() && found(4).is_empty() && found(9).is_empty());
    }
}
