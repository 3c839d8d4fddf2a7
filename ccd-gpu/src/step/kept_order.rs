//! For how long steps keep the order of boxes: sorting takes a quarter of a small step, and boxes
//! that were near one another mostly stay so.
//!
//! A step that keeps the order only fits boxes to the tree of the last sort. The number of block
//! pairs on the last level, which is read back with the results anyway, says how good that tree
//! still is: pairs beyond those after the last sort are work that another sort would have saved.
//! Once this work has cost as much as a sort, the next step sorts. Where the work grows evenly
//! there is no better time; however it grows, the cost is at most twice the best.

/// Pairs of blocks that take as long as a sort: so many, and one for so many boxes. On an NVIDIA
/// H200 a pair takes 2.4 ns (rod-twist) to 2.9 ns (cloth-ball) from its descent to its filters,
/// codes, a sort and halves 107 us (100 thousand boxes) to 175 us (277 thousand).
const SORT_PAIRS: u64 = 1 << 15;
const BOXES_A_PAIR: u64 = 8;

/// Steps after which the next one sorts in any case: pairs may have become fewer for other reasons
/// than a good order, small meshes have as many in any order, and some methods do not count them.
/// It costs a few hundredths of what keeping the order saves.
const MOST_STEPS: u32 = 32;

/// The order of boxes on the device.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct KeptOrder {
    sorted: Option<Sorted>,
}

/// A sort, and the steps since then.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Sorted {
    /// Pairs of blocks in the step that sorted.
    pairs: u64,
    /// Steps since then, and how many more pairs they had, all together.
    steps: u32,
    more: u64,
}

impl KeptOrder {
    /// Whether the next step over so many boxes keeps the order.
    pub fn holds(&self, n_boxes: u32) -> bool {
        let most = SORT_PAIRS + n_boxes as u64 / BOXES_A_PAIR;
        self.sorted.is_some_and(|sorted| sorted.steps < MOST_STEPS && sorted.more < most)
    }

    /// Makes the next step sort.
    pub fn forget(&mut self) {
        self.sorted = None;
    }

    /// A step has come to its end, with the order `kept` or new. `pairs`: of nodes, on its last
    /// level; `None` if its source has no order that outlasts motion.
    pub fn took(&mut self, kept: bool, pairs: Option<u64>) {
        self.sorted = match (pairs, self.sorted.filter(|_| kept)) {
            (None, _) => None,
            (Some(pairs), None) => Some(Sorted { pairs, steps: 0, more: 0 }),
            (Some(now), Some(Sorted { pairs, steps, more })) => {
                Some(Sorted { pairs, steps: steps + 1, more: more + now.saturating_sub(pairs) })
            }
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Which of the steps with so many pairs keep the order of so many boxes.
    fn kept(n_boxes: u32, pairs: &[Option<u64>]) -> Vec<bool> {
        let mut order = KeptOrder::default();
        let mut step = |&pairs| {
            let kept = order.holds(n_boxes);
            order.took(kept, pairs);
            kept
        };
        pairs.iter().map(&mut step).collect()
    }

    #[test]
    fn an_order_is_kept_until_its_pairs_have_cost_a_sort() {
        let kept_of =
            |n, pairs: &[u64]| kept(n, &pairs.iter().map(|&p| Some(p)).collect::<Vec<_>>());
        let (half, all) = (SORT_PAIRS / 2, SORT_PAIRS);
        let pairs = [7, 7 + half, 3, 7 + half - 1, 8, 9, 9 + all, 9];
        assert_eq!(kept_of(0, &pairs), [false, true, true, true, true, false, true, false]);
        assert_eq!(
            kept_of(BOXES_A_PAIR as u32, &pairs),
            [false, true, true, true, true, true, false, true]
        );
    }

    #[test]
    fn it_is_never_kept_for_long() {
        let steps = kept(9, &[Some(7); 100]);
        let sorts: Vec<usize> = (0..100).filter(|&i| !steps[i]).collect();
        assert_eq!(sorts, [0, 33, 66, 99]);
    }

    #[test]
    fn what_has_no_order_keeps_none() {
        let pairs = [None, None, Some(1), None, Some(1), Some(1)];
        assert_eq!(kept(9, &pairs), [false, false, false, true, false, true]);
        let mut order = KeptOrder::default();
        order.took(false, Some(5));
        assert!(order.holds(9));
        order.forget();
        assert!(!order.holds(9));
    }
}
