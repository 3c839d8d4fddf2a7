//! When a front is kept, and when it is given up: the same numbers and the same rule on every
//! backend.
//!
//! A front is a list of fixed capacity that a search writes while it reads the one before. What is
//! done with it when the search is over depends on how many pairs it has now, had when it last
//! began at the roots, and had some searches ago; see [`FrontOptions`].

use crate::model::scheduling::FrontOptions;

/// What is known of the front of one pair of sets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FrontState {
    /// Pairs of the front that the next search begins with; 0: it begins at the roots.
    kept: u64,
    /// Pairs with which this one began.
    begun: u64,
    /// Whether it has been too large for its memory since its trees were built.
    is_too_large: bool,
    /// Pairs of the last front that began at the roots.
    at_roots: u64,
    /// Pairs of the front with which the next one is compared, and how many searches ago it was.
    reference: u64,
    age: u32,
}

/// What is done with the list that a search wrote.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// It is the front of the next search.
    Kept,
    /// The next search begins at the roots.
    Dropped,
    /// The same, and both lists have this capacity from then on: it was too small.
    Grows(u64),
}

impl FrontState {
    /// A search begins. `same_trees`: they are those of the search before, and that was complete.
    pub fn begin(&mut self, same_trees: bool) {
        if !same_trees {
            (self.kept, self.is_too_large) = (0, false);
        }
        self.begun = self.kept;
    }

    /// Pairs with which the search begins; 0: at the roots.
    pub fn begun(&self) -> u64 {
        self.begun
    }

    /// Whether it writes a front: not if that would be too large.
    pub fn is_written(&self) -> bool {
        !self.is_too_large
    }

    /// Pairs of the front that is kept; 0: the next search begins at the roots.
    pub fn kept(&self) -> u64 {
        self.kept
    }

    /// There is no memory for its list.
    pub fn give_up(&mut self) {
        self.is_too_large = true;
    }

    /// A search is over that wrote `n` pairs, and wanted as many entries of a list that has
    /// `capacity`; it may have at most `most`.
    pub fn end(
        &mut self,
        options: &FrontOptions,
        n: u64,
        wanted: u64,
        capacity: u64,
        most: u64,
    ) -> Fate {
        self.kept = 0;
        if self.is_too_large {
            return Fate::Dropped;
        }
        if wanted > capacity {
            self.is_too_large = wanted > most;
            if self.is_too_large {
                return Fate::Dropped;
            }
            return Fate::Grows((wanted + wanted / 4).min(most));
        }
        if self.begun == 0 {
            (self.at_roots, self.reference, self.age) = (n, n, 0);
        } else {
            self.age += 1;
            let percent = |n: u64, p: u32| n as u128 * p as u128;
            let whole = n as u128 * 100;
            let too_deep = whole > percent(self.at_roots, options.growth);
            let compared = self.age.is_multiple_of(options.period);
            let unchanged = compared && whole < percent(self.reference, options.threshold);
            if compared {
                self.reference = n;
            }
            if too_deep || unchanged {
                return Fate::Dropped;
            }
        }
        self.kept = n;
        Fate::Kept
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What becomes of fronts of these lengths, one after the other, in lists with room for 1000.
    fn fates<const N: usize>(options: FrontOptions, of: [u64; N]) -> [bool; N] {
        let mut state = FrontState::default();
        of.map(|n| {
            state.begin(true);
            let fate = state.end(&options, n, n, 1000, 1000);
            assert_eq!(fate == Fate::Kept, state.kept() == n && n > 0);
            fate == Fate::Kept
        })
    }

    #[test]
    fn a_front_that_became_too_deep_is_given_up() {
        let options = FrontOptions::default().growth(150);
        let of = fates(options, [100, 150, 120, 151, 200, 300, 301]);
        assert_eq!(of, [true, true, true, false, true, true, false]);
    }

    #[test]
    fn a_front_that_did_not_change_is_given_up_after_the_period() {
        let options = FrontOptions::default().rebuild(2, 110);
        let of = fates(options, [100, 101, 110, 111, 119, 120]);
        assert_eq!(of, [true, true, true, true, false, true]);
        assert_eq!(fates(options.rebuild(1, 0), [100; 3]), [true; 3]);
    }

    #[test]
    fn other_trees_begin_at_the_roots() {
        let (options, mut state) = (FrontOptions::default(), FrontState::default());
        assert_eq!(state.end(&options, 5, 5, 9, 9), Fate::Kept);
        state.begin(false);
        assert_eq!((state.begun(), state.kept()), (0, 0));
        assert_eq!(state.end(&options, 50, 9, 9, 9), Fate::Kept);
        state.begin(true);
        assert_eq!((state.begun(), state.kept()), (50, 50));
    }

    #[test]
    fn a_list_grows_up_to_the_bound_and_is_then_not_written() {
        let (options, mut state) = (FrontOptions::default(), FrontState::default());
        assert_eq!(state.end(&options, 80, 80, 10, 200), Fate::Grows(100));
        assert_eq!(state.end(&options, 180, 180, 100, 200), Fate::Grows(200));
        assert_eq!((state.kept(), state.is_written()), (0, true));
        assert_eq!(state.end(&options, 201, 201, 200, 200), Fate::Dropped);
        assert!(!state.is_written());
        state.begin(true);
        assert!(!state.is_written());
        assert_eq!(state.end(&options, 0, 0, 200, 200), Fate::Dropped);
        state.begin(false);
        assert!(state.is_written());
    }
}
